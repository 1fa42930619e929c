// The flight in space by three.js: path, waypoints with tolerances, the vehicle at the instant shown.

import {
  BufferGeometry,
  CanvasTexture,
  Color,
  Float32BufferAttribute,
  Group,
  InstancedMesh,
  Line,
  LineBasicMaterial,
  Matrix4,
  MeshLambertMaterial,
  Points,
  PointsMaterial,
  SphereGeometry,
  Vector3,
} from "three";
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { LineGeometry } from "three/examples/jsm/lines/LineGeometry.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { indexAt, number } from "./content.js";
import { corners, extent, ground } from "./ground.js";
import { css } from "./palette.js";
import { stage } from "./stage.js";
import { vehicle as vehicleOf } from "./vehicle.js";
import { NOTE, reach, solids } from "./volumes.js";

/** Most waypoints with a label. */
const MOST_LABELS = 16;

/** Distance in px within which the pointer counts as on the path. */
const NEAR = 14;

export function scene({ place, run, state, setTime, struck, content, note, reached, wayShown }, lost) {
  const points = () => {
    const { x, y, z } = run().columns;
    return x.map((v, k) => new Vector3(v, y[k], z[k]));
  };
  const stops = content.waypoints.map((w) => new Vector3(...w.at));
  const seen = [...points(), ...stops, ...reached().map((p) => new Vector3(...p))];
  seen.push(...reach(seen));
  const land = extent(seen);
  const { size, step, floor } = land;
  const { world, canvas, label, project, render, look, stand, returnTo, onFit, remove } = stage(place, [...seen, ...corners(land)], size, lost);
  const middle = new Vector3((land.x[0] + land.x[1]) / 2, (land.y[0] + land.y[1]) / 2, (floor + land.top) / 2);
  const places = atPlaces(content.waypoints);
  const lay = ground(world, label, land, [...places.values()].map(({ at }) => new Vector3(...at)));

  const tolerance = new MeshLambertMaterial({ transparent: true, opacity: 0.35, depthWrite: false });
  const spheres = new InstancedMesh(new SphereGeometry(1, 24, 16), tolerance, Math.max(stops.length, 1));
  spheres.count = stops.length;
  content.waypoints.forEach(({ within, at }, i) => {
    spheres.setMatrixAt(i, new Matrix4().makeScale(within, within, within).setPosition(...at));
  });
  const marked = new Float32BufferAttribute(content.waypoints.flatMap((w) => w.at), 3);
  const dots = new Points(
    new BufferGeometry().setAttribute("position", marked),
    new PointsMaterial({ size: 8, sizeAttenuation: false, map: disc(), alphaTest: 0.5 }),
  );
  world.add(spheres, dots);
  for (const { at, text, rank } of places.values()) if (text) label(text, new Vector3(...at), rank);
  const bodies = solids(world, label, { middle, size });

  const material = new LineMaterial({ vertexColors: true, linewidth: 4.5 });
  onFit((width, height) => material.resolution.set(width, height));
  let path = null;
  const branching = new LineMaterial({ linewidth: 4.5, dashed: true, dashSize: 0.012 * size, gapSize: 0.006 * size });
  onFit((width, height) => branching.resolution.set(width, height));
  let branch = null;
  const shadow = new Line(new BufferGeometry(), new LineBasicMaterial({ transparent: true, opacity: 0.45 }));
  const others = new Group();
  world.add(shadow, others);

  const flyer = vehicleOf(size);
  const vehicle = flyer.made;
  world.add(vehicle);

  const larger = flyer.scale > 1.05 ? `, drawn ${number(flyer.scale, 2)} times larger than it is` : "";
  note(
    `x is east, y north, z up. Grid squares are ${number(step)} m wide, at z = ${number(floor)} m; upright lines lead from waypoints to the ground, and the thin line on it is the projection of the path. Spheres are tolerances. The vehicle is shown with its motors${larger}; its mast points along the thrust, its tip forward. Motors that the selected mode, or the fault of a flight, takes are crossed out in red; those that it weakens are ringed in another colour.${NOTE}`,
    " Drag or use the arrow keys to rotate; click the path to select an instant.",
  );

  /** Index of the instant under the pointer; null if none is near. */
  function under(event) {
    const box = canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    let best = { distance: NEAR, k: null };
    points().forEach((p, k) => {
      const at = project(p);
      const distance = Math.hypot(at.x - x, at.y - y);
      if (distance < best.distance) best = { distance, k };
    });
    return best.k;
  }
  let pressed = null;
  canvas.addEventListener("pointerdown", (event) => (pressed = [event.clientX, event.clientY]));
  canvas.addEventListener("click", (event) => {
    if (pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
    const k = under(event);
    if (k !== null) setTime(run().columns.t[k]);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (event.buttons) return;
    const k = under(event);
    const c = run().columns;
    canvas.style.cursor = k === null ? "grab" : "pointer";
    const at = () => ["x", "y", "z"].map((n) => number(c[n][k])).join(", ");
    place.title = k === null ? "" : `${c.t[k].toFixed(2)} s: ${at()} m, ${number(c.speed[k])} m/s`;
  });

  function theme() {
    lay();
    flyer.theme();
    tolerance.color.set(css("--accent"));
    dots.material.color.set(css("--ink"));
    shadow.material.color.set(css("--soft"));
    bodies.theme();
  }

  function drawPath(colors) {
    const { x, y, z } = run().columns;
    if (path) {
      world.remove(path);
      path.geometry.dispose();
    }
    const color = new Color();
    const geometry = new LineGeometry();
    geometry.setPositions(x.flatMap((v, k) => [v, y[k], z[k]]));
    geometry.setColors(colors.flatMap((c) => color.set(c).toArray()));
    path = new Line2(geometry, material);
    world.add(path);
    shadow.geometry.dispose();
    shadow.geometry = new BufferGeometry().setFromPoints(points().map((p) => p.setZ(floor)));
    others.clear();
    bodies.mark(run());
    const faint = new LineBasicMaterial({ color: css("--soft"), transparent: true, opacity: 0.55 });
    for (const { columns: c } of content.runs.filter((r) => r !== run())) {
      others.add(new Line(new BufferGeometry().setFromPoints(c.x.map((v, k) => new Vector3(v, c.y[k], c.z[k]))), faint));
    }
    time();
  }

  /** The way out at the instant shown: dashed, so that it differs from the path by more than its colour. */
  function drawBranch() {
    if (branch) {
      world.remove(branch);
      branch.geometry.dispose();
      branch = null;
    }
    const shown = wayShown();
    if (!shown) return;
    branching.color.set(shown.color);
    const geometry = new LineGeometry();
    geometry.setPositions(shown.points.flat());
    branch = new Line2(geometry, branching);
    branch.computeLineDistances();
    world.add(branch);
  }

  function time() {
    drawBranch();
    const c = run().columns;
    const k = indexAt(c.t, state.time);
    const [roll, pitch, yaw] = ["roll", "pitch", "yaw"].map((n) => (c[n][k] * Math.PI) / 180);
    vehicle.position.set(c.x[k], c.y[k], c.z[k]);
    vehicle.rotation.set(roll, pitch, yaw);
    flyer.mark(struck());
    render();
  }

  theme();
  return { path: drawPath, time, theme, look, stand, returnTo, remove };
}

/** A round point. */
function disc() {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext("2d");
  pen.arc(32, 32, 30, 0, 2 * Math.PI);
  pen.fillStyle = "white";
  pen.fill();
  return new CanvasTexture(canvas);
}

/** The places of waypoints, each once, with the words beside it: for start and end, and for the others if they are few. */
function atPlaces(waypoints) {
  const last = waypoints.length - 1;
  const called = (w, i) => (i === 0 ? "start" : i === last ? "end" : last < MOST_LABELS ? w.name : "");
  const found = new Map();
  waypoints.forEach((w, i) => {
    const key = w.at.map((v) => Math.round(1e3 * v)).join();
    const before = found.get(key);
    const rank = Math.min(before?.rank ?? 3, i === 0 || i === last ? 1 : 3);
    found.set(key, { at: w.at, rank, text: [before?.text, called(w, i)].filter(Boolean).join(", ") });
  });
  return found;
}
