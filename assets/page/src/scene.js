// The flight in space by three.js: path, waypoints with tolerances, the vehicle at the instant shown.

import {
  BufferGeometry,
  CanvasTexture,
  Color,
  Float32BufferAttribute,
  GridHelper,
  Group,
  InstancedMesh,
  Line,
  LineBasicMaterial,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Points,
  PointsMaterial,
  SphereGeometry,
  TorusGeometry,
  Vector3,
} from "three";
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { LineGeometry } from "three/examples/jsm/lines/LineGeometry.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { indexAt, number } from "./content.js";
import { css, round } from "./palette.js";
import { stage } from "./stage.js";
import { NOTE, reach, solids } from "./volumes.js";

/** Most waypoints with a label. */
const MOST_LABELS = 16;

/** Distance in px within which the pointer counts as on the path. */
const NEAR = 14;

export function scene({ place, run, state, setTime, content, note }, lost) {
  const points = () => {
    const { x, y, z } = run().columns;
    return x.map((v, k) => new Vector3(v, y[k], z[k]));
  };
  const stops = content.waypoints.map((w) => new Vector3(...w.at));
  const seen = [...points(), ...stops];
  const { middle, size, step, floor } = extent([...seen, ...reach(seen)]);
  const { world, canvas, label, project, render, look, onFit, remove } = stage(place, middle, size, lost);

  const cells = Math.ceil(size / step);
  const grid = new GridHelper(cells * step, cells);
  grid.rotation.x = Math.PI / 2;
  grid.position.set(Math.round(middle.x / step) * step, Math.round(middle.y / step) * step, floor);
  grid.material.vertexColors = false;
  world.add(grid);

  const tolerance = new MeshLambertMaterial({ transparent: true, opacity: 0.35, depthWrite: false });
  const spheres = new InstancedMesh(new SphereGeometry(1, 24, 16), tolerance, Math.max(stops.length, 1));
  spheres.count = stops.length;
  content.waypoints.forEach(({ within, at }, i) => {
    spheres.setMatrixAt(i, new Matrix4().makeScale(within, within, within).setPosition(...at));
  });
  const places = new Float32BufferAttribute(content.waypoints.flatMap((w) => w.at), 3);
  const dots = new Points(
    new BufferGeometry().setAttribute("position", places),
    new PointsMaterial({ size: 8, sizeAttenuation: false, map: disc(), alphaTest: 0.5 }),
  );
  world.add(spheres, dots);
  name(content.waypoints, label);
  const bodies = solids(world, label, { middle, size });

  const material = new LineMaterial({ vertexColors: true, linewidth: 4.5 });
  onFit((width, height) => material.resolution.set(width, height));
  let path = null;
  const shadow = new Line(new BufferGeometry(), new LineBasicMaterial({ transparent: true, opacity: 0.45 }));
  const others = new Group();
  world.add(shadow, others);

  const vehicle = new Group();
  const body = new Mesh(new TorusGeometry(0.022 * size, 0.0045 * size, 10, 32), new MeshBasicMaterial());
  const up = [new Vector3(), new Vector3(0, 0, 0.075 * size)];
  const mast = new Line(new BufferGeometry().setFromPoints(up), new LineBasicMaterial());
  vehicle.add(body, mast);
  vehicle.rotation.order = "ZYX";
  world.add(vehicle);

  note(
    `Grid squares are ${number(step)} m wide, at z = ${number(floor)} m; the thin line is the projection of the path. Spheres are tolerances. The ring is the vehicle; its mast points along the thrust.${NOTE}`,
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
    grid.material.color.set(css("--ground"));
    grid.material.needsUpdate = true;
    tolerance.color.set(css("--accent"));
    for (const m of [dots.material, body.material, mast.material]) m.color.set(css("--ink"));
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

  function time() {
    const c = run().columns;
    const k = indexAt(c.t, state.time);
    const [roll, pitch, yaw] = ["roll", "pitch", "yaw"].map((n) => (c[n][k] * Math.PI) / 180);
    vehicle.position.set(c.x[k], c.y[k], c.z[k]);
    vehicle.rotation.set(roll, pitch, yaw);
    render();
  }

  theme();
  return { path: drawPath, time, theme, look, remove };
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

/** Labels the start, the end and, if there are few, the other waypoints; one label per place. */
function name(waypoints, label) {
  const last = waypoints.length - 1;
  const called = (w, i) => (i === 0 ? "start" : i === last ? "end" : w.name);
  const kept = waypoints.map((w, i) => ({ at: w.at, text: called(w, i), i })).filter(({ i }) => last < MOST_LABELS || i === 0 || i === last);
  const places = new Map();
  for (const { at, text } of kept) {
    const key = at.map((v) => Math.round(1e3 * v)).join();
    places.set(key, { at, text: places.has(key) ? `${places.get(key).text}, ${text}` : text });
  }
  for (const { at, text } of places.values()) label(text, new Vector3(...at));
}

/** The middle and size of a cloud of points, a round step for the grid, and the height of the grid below them. */
function extent(points) {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  for (const p of points) {
    low.min(p);
    high.max(p);
  }
  const size = Math.max(high.distanceTo(low), 0.5);
  const step = round(size / 8);
  return { middle: low.clone().add(high).multiplyScalar(0.5), size, step, floor: Math.floor(low.z / step) * step };
}
