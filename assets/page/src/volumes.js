// Volumes: what the vehicle stays inside or outside, in the views of the path. Keep-outs are filled, keep-ins outlined; dashed
// lines are the boundaries that the centre of gravity keeps, and marks show where a plan comes nearest.

import {
  BufferGeometry,
  DoubleSide,
  ExtrudeGeometry,
  Group,
  Line,
  LineBasicMaterial,
  LineDashedMaterial,
  LineLoop,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  OctahedronGeometry,
  PlaneGeometry,
  Shape,
  SphereGeometry,
  Vector3,
} from "three";
import { content } from "./content.js";
import { css } from "./palette.js";

export const volumes = content.volumes ?? [];

const color = (volume) => css(volume.keeps_in ? "--good" : "--limit");

/** What the note below the headline says of them. */
export const NOTE = volumes.length === 0 ? "" : " Keep-outs are filled, keep-ins outlined. Dashed lines are the boundaries that the centre of gravity keeps, with the vehicle's size and the clearance; diamonds show where a plan comes nearest to them.";

/** The corners of the finite bodies, for the extent of a view: no farther from the path than a quarter of its extent. */
export function reach(points) {
  if (volumes.length === 0) return [];
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  for (const p of points) {
    low.min(p);
    high.max(p);
  }
  const room = Math.max(high.distanceTo(low), 0.5);
  const [least, most] = [low.clone().subScalar(0.25 * room), high.clone().addScalar(0.25 * room)];
  const corners = [];
  for (const solid of volumes.flatMap((v) => v.solids)) {
    const ends = solid.corners
      ? solid.corners.flatMap(([x, y]) => solid.heights.map((z) => new Vector3(x, y, z)))
      : solid.centre
        ? [-1, 1].map((s) => new Vector3(...solid.centre).addScalar(s * solid.radius))
        : [];
    corners.push(...ends.map((p) => p.clamp(least, most)));
  }
  return corners;
}

/** Draws one flat view with a pen: `view` is `above` or `side`, `axes` the coordinates that it shows. */
export function flat(pen, view, axes, run) {
  for (const v of volumes) {
    const { areas, edge, kept } = v[view];
    if (!v.keeps_in) {
      for (const area of areas) pen.polygon(area, { fill: css("--keep-out") });
    }
    // A dash pattern over the far ends of a half space is more than browsers draw.
    const part = (line) => (line.length === 2 ? pen.visible(line) : line);
    for (const line of edge) pen.line(part(line), { stroke: color(v), width: 1.5 });
    for (const line of kept) pen.line(part(line), { stroke: color(v), width: 1, dash: [5, 4] });
  }
  for (const v of volumes) {
    const tops = (v.keeps_in ? v[view].edge : v[view].kept).map(pen.top).filter((p) => p !== null);
    if (tops.length > 0) pen.text(tops.reduce((best, p) => (p[1] > best[1] ? p : best)), v.name, { fill: color(v) });
  }
  for (const { at, bad } of run.nearest ?? []) pen.diamond([at[axes[0]], at[axes[1]]], { fill: css(bad ? "--bad" : "--paper"), stroke: css("--ink") });
}

/** The volumes in space, for a scene of a given size about `middle`: `theme()` colours them, `mark(run)` moves the marks. */
export function solids(world, label, { middle, size }) {
  const skins = [];
  for (const volume of volumes) {
    let tip = null;
    const skin = new MeshLambertMaterial({ transparent: true, opacity: 0.32, depthWrite: false, side: DoubleSide });
    const edge = new LineBasicMaterial({ transparent: true, opacity: 0.8 });
    const dashed = new LineDashedMaterial({ dashSize: 0.012 * size, gapSize: 0.01 * size, transparent: true, opacity: 0.9 });
    const loop = (points, z, material) => {
      const made = new LineLoop(new BufferGeometry().setFromPoints(points.map(([x, y]) => new Vector3(x, y, z))), material);
      if (material === dashed) made.computeLineDistances();
      world.add(made);
    };
    const fill = (geometry) => {
      if (volume.keeps_in) return null;
      const mesh = new Mesh(geometry, skin);
      world.add(mesh);
      return mesh;
    };
    let heights = null;
    for (const solid of volume.solids) {
      let top;
      if (solid.corners) {
        const [bottom, height] = [solid.heights[0], solid.heights[1] - solid.heights[0]];
        const geometry = new ExtrudeGeometry(new Shape(solid.corners.map(([x, y]) => new Vector3(x, y))), { depth: height, bevelEnabled: false });
        geometry.translate(0, 0, bottom);
        fill(geometry);
        heights = solid;
        const count = solid.corners.length;
        const centre = solid.corners.reduce((sum, [x, y]) => [sum[0] + x / count, sum[1] + y / count], [0, 0]);
        // A keep-in, in which all others may lie, has its name at a corner.
        top = new Vector3(...(volume.keeps_in ? solid.corners[Math.floor(count / 2)] : centre), solid.heights[1]);
      } else if (solid.centre) {
        const { centre, radius, kept } = solid;
        const mesh = fill(new SphereGeometry(radius, 40, 24));
        mesh?.position.set(...centre);
        for (const [r, material] of [[radius, edge], [kept, dashed]]) {
          if (r <= 0) continue;
          for (const [i, j] of [[0, 1], [0, 2], [1, 2]]) {
            const points = Array.from({ length: 72 }, (_, k) => {
              const p = new Vector3(...centre);
              p.setComponent(i, centre[i] + r * Math.cos((k * Math.PI) / 36));
              return p.setComponent(j, centre[j] + r * Math.sin((k * Math.PI) / 36));
            });
            const made = new LineLoop(new BufferGeometry().setFromPoints(points), material);
            if (material === dashed) made.computeLineDistances();
            world.add(made);
          }
        }
        top = new Vector3(centre[0], centre[1], centre[2] + radius);
      } else {
        // A square of the plane, as large as the scene, at the foot of its middle.
        const normal = new Vector3(...solid.normal);
        for (const [offset, material] of [[solid.offset, edge], [solid.kept, dashed]]) {
          const foot = middle.clone().addScaledVector(normal, offset - normal.dot(middle));
          const geometry = new PlaneGeometry(size, size);
          const turn = new Mesh(geometry);
          turn.position.copy(foot);
          turn.lookAt(foot.clone().add(normal));
          turn.updateMatrix();
          geometry.applyMatrix4(turn.matrix);
          const { position } = geometry.attributes;
          const corners = [0, 1, 3, 2].map((k) => new Vector3().fromBufferAttribute(position, k));
          const made = new LineLoop(new BufferGeometry().setFromPoints(corners), material);
          if (material === dashed) made.computeLineDistances();
          world.add(made);
          if (material === edge) {
            fill(geometry);
            top = corners.reduce((best, p) => (p.z > best.z ? p : best));
          }
        }
      }
      if (!tip || top.z > tip.z) tip = top;
    }
    if (heights) {
      for (const line of volume.above.edge) {
        for (const z of heights.heights) loop(line, z, edge);
      }
      // Its vertical edges, where it has few.
      const corners = volume.solids.flatMap((s) => s.corners ?? []);
      for (const [x, y] of corners.length <= 40 ? corners : []) {
        if (!volume.above.edge.some((line) => line.some(([u, v]) => u === x && v === y))) continue;
        const ends = heights.heights.map((z) => new Vector3(x, y, z));
        world.add(new Line(new BufferGeometry().setFromPoints(ends), edge));
      }
      for (const line of volume.above.kept) {
        if (heights.kept[0] < heights.kept[1]) for (const z of heights.kept) loop(line, z, dashed);
      }
    }
    skins.push({ volume, materials: [skin, edge, dashed] });
    if (tip) label(volume.name, tip, 2);
  }
  const marks = new Group();
  world.add(marks);
  const labels = [];
  return {
    theme() {
      for (const { volume, materials } of skins) for (const m of materials) m.color.set(color(volume));
      for (const m of marks.children) m.material.color.set(css(m.userData.bad ? "--bad" : "--ink"));
    },
    mark(run) {
      marks.clear();
      for (const l of labels.splice(0)) l.remove();
      for (const { at, bad, label: words } of run.nearest ?? []) {
        const mesh = new Mesh(new OctahedronGeometry(0.012 * size), new MeshBasicMaterial({ color: css(bad ? "--bad" : "--ink") }));
        mesh.position.set(...at);
        mesh.userData.bad = bad;
        marks.add(mesh);
        if (words) labels.push(label(words, mesh.position, 4));
      }
    },
  };
}
