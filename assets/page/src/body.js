// The admissible set as a solid over thrust and the torques about x and y, at zero torque about z: the paper's Figure 6.

import { BufferGeometry, EdgesGeometry, Group, Line, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, MeshLambertMaterial, SphereGeometry, Vector3 } from "three";
import { ConvexGeometry } from "three/examples/jsm/geometries/ConvexGeometry.js";
import { ConvexHull } from "three/examples/jsm/math/ConvexHull.js";
import { content } from "./content.js";
import { css } from "./palette.js";
import { stage } from "./stage.js";

/** Torques are horizontal, thrust is vertical. */
const AXES = [1, 2, 0];
const TEXTS = ["τx", "τy", "T"];

/**
 * The corners of the section { n . w <= e, tau_z = 0 } in shares of the extents, by polarity about hover: a facet becomes
 * the point n / (e - n . hover), and a face of their hull a corner (Ziegler, Lectures on Polytopes, section 2.3).
 * Null if hover is not inside.
 */
function corners(set, spans) {
  if (set.equalities.length > 0) return null;
  const duals = [];
  for (const row of set.rows) {
    const slack = row[4] - row.slice(0, 4).reduce((sum, n, i) => sum + n * content.hover[i], 0);
    if (slack < 1e-6) return null;
    duals.push(new Vector3(...AXES.map((axis, i) => (row[axis] * spans[i]) / slack)));
  }
  const { faces } = new ConvexHull().setFromPoints(duals);
  const found = faces.filter((f) => f.constant > 1e-9).map((f) => f.normal.clone().divideScalar(f.constant));
  // Where many facets meet, several faces give the same corner.
  const distinct = new Map(found.map((p) => [p.toArray().map((v) => Math.round(1e5 * v)).join(), p]));
  return [...distinct.values()];
}

/** A view of it in `place`; throws without WebGL. */
export function body(place, extents) {
  const spans = AXES.map((axis) => (extents[axis][1] - extents[axis][0]) / 2);
  const to = (w) => new Vector3(...AXES.map((axis, i) => (w[axis] - content.hover[axis]) / spans[i]));
  const center = new Vector3(0, 0, (extents[0][0] + extents[0][1]) / 2 - content.hover[0]).multiplyScalar(1 / spans[2]);
  let gone = false;
  const cube = [-1, 1].flatMap((a) => [-1, 1].flatMap((b) => [-1, 1].map((c) => new Vector3(a, b, c).add(center))));
  const { world, label, render, remove } = stage(place, cube, 2.7, () => (gone = true));
  const bodies = new Group();
  world.add(bodies);
  const dot = new Mesh(new SphereGeometry(0.045, 20, 14), new MeshBasicMaterial({ depthTest: false, transparent: true }));
  dot.renderOrder = 1;
  const axes = new LineBasicMaterial();
  const origin = to([0, 0, 0, 0]);
  TEXTS.forEach((text, i) => {
    const [begin, end] = [i === 2 ? 0 : -1, i === 2 ? 2 : 1].map((by) => origin.clone().setComponent(i, origin.getComponent(i) + by));
    world.add(new Line(new BufferGeometry().setFromPoints([begin, end]), axes));
    label(text, end);
  });
  world.add(dot);

  function solid(set, color, opacity) {
    const points = corners(set, spans);
    if (!points || points.length < 4) return false;
    const geometry = new ConvexGeometry(points);
    const skin = new MeshLambertMaterial({ color, transparent: true, opacity, depthWrite: false });
    bodies.add(new Mesh(geometry, skin), new LineSegments(new EdgesGeometry(geometry, 2), new LineBasicMaterial({ color })));
    return true;
  }

  return {
    remove,
    /** Draws the healthy set and this one; returns whether a solid is visible. */
    show(set) {
      bodies.clear();
      axes.color.set(css("--soft"));
      solid(content.sets[0], css("--healthy-edge"), 0.12);
      const there = set === content.sets[0] || solid(set, css("--accent"), 0.4);
      render();
      return there && !gone;
    },
    move(w, color) {
      dot.position.copy(to(w));
      dot.material.color.set(color);
      render();
    },
  };
}
