// What gives a flight in space its scale: the grid on the ground with its axes, the north, and a scale of heights.

import { BufferGeometry, ConeGeometry, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, Vector3 } from "three";
import { number } from "./content.js";
import { css, round } from "./palette.js";

/** Cells of the grid along its longer side, about. */
const CELLS = 8;
/** Fewest cells along the shorter side. */
const FEWEST = 3;

/** The ground below a cloud of points: round limits [low, high] of x and y, the heights of floor and top, the step of the grid. */
export function extent(points) {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  for (const p of points) {
    low.min(p);
    high.max(p);
  }
  const size = Math.max(high.distanceTo(low), 0.5);
  const step = round(size / CELLS);
  const [x, y] = ["x", "y"].map((axis) => {
    const [first, last] = [Math.floor(low[axis] / step), Math.ceil(high[axis] / step)];
    const lacking = Math.max(FEWEST - (last - first), 0);
    return [first - Math.ceil(lacking / 2), last + Math.floor(lacking / 2)].map((cell) => cell * step);
  });
  // From the plane of z = 0 where that is not far below.
  const floor = low.z >= 0 && low.z < 0.35 * size ? 0 : Math.floor(low.z / step) * step;
  const top = Math.max(Math.ceil((high.z - 1e-6 * size) / step) * step, floor + step);
  return { x, y, floor, top, step, size };
}

/** Its corners, and the top of the scale of heights. */
export const corners = ({ x, y, floor, top }) => [...x.flatMap((a) => y.map((b) => new Vector3(a, b, floor))), new Vector3(x[0], y[1], top)];

/** Draws the ground and its scales into a world; returns a function that colours them. */
export function ground(world, label, { x, y, floor, top, step, size }, stops) {
  const grid = new LineBasicMaterial();
  const scale = new LineBasicMaterial();
  const drop = new LineBasicMaterial({ transparent: true, opacity: 0.6 });
  const arrow = new MeshBasicMaterial();
  const add = (ends, material) => world.add(new LineSegments(new BufferGeometry().setFromPoints(ends), material));
  const cells = ([low, high]) => Array.from({ length: Math.round((high - low) / step) + 1 }, (_, k) => low + k * step);
  add(cells(x).flatMap((a) => y.map((b) => new Vector3(a, b, floor))), grid);
  add(cells(y).flatMap((b) => x.map((a) => new Vector3(a, b, floor))), grid);

  // Numbers at the edges: x in front, y at the left, heights at the corner beyond it.
  const tick = 0.012 * size;
  const heights = cells([floor, top]);
  add([
    new Vector3(x[0], y[0], floor), new Vector3(x[1], y[0], floor),
    new Vector3(x[0], y[0], floor), new Vector3(x[0], y[1], floor),
    new Vector3(x[0], y[1], floor), new Vector3(x[0], y[1], top),
    ...heights.flatMap((z) => [new Vector3(x[0], y[1], z), new Vector3(x[0] - tick, y[1], z)]),
  ], scale);
  const every = (values) => values.filter((_, k) => k % Math.ceil(values.length / 5) === 0);
  const metres = (v) => number(v, 4);
  for (const a of every(cells(x)).slice(1)) label(metres(a), new Vector3(a, y[0] - tick, floor), 8, "tick");
  for (const b of every(cells(y)).slice(1)) label(metres(b), new Vector3(x[0] - tick, b, floor), 8, "tick");
  for (const z of every(heights).slice(1)) label(`${metres(z)} m`, new Vector3(x[0] - tick, y[1], z), 6, "tick");
  label("x east", new Vector3(x[1], y[0], floor), 5, "tick");
  label("height z", new Vector3(x[0], y[1], top), 5, "tick");

  // The north, at the far end of the left edge.
  const north = new Group();
  const head = new Mesh(new ConeGeometry(0.014 * size, 0.05 * size, 16), arrow);
  head.position.set(x[0], y[1] + 0.03 * size, floor);
  north.add(head);
  world.add(north);
  label("N, y", new Vector3(x[0], y[1] + 0.05 * size, floor), 2, "tick");

  // Where waypoints stand over the ground.
  add(stops.flatMap((p) => [p, new Vector3(p.x, p.y, floor)]), drop);
  return () => {
    grid.color.set(css("--ground"));
    for (const material of [scale, arrow, drop]) material.color.set(css("--soft"));
  };
}
