// The flight in space by three.js: path, waypoints with tolerances, the vehicle at the instant shown.

import {
  AmbientLight,
  BufferGeometry,
  Color,
  DirectionalLight,
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
  PerspectiveCamera,
  Points,
  PointsMaterial,
  Scene,
  SphereGeometry,
  TorusGeometry,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { LineGeometry } from "three/examples/jsm/lines/LineGeometry.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { element, indexAt, number } from "./content.js";
import { css } from "./palette.js";

/** Named waypoints get a label, as long as there are few. */
const MOST_LABELS = 16;

const NEAR_PX = 14;

export function scene({ place, run, state, setTime, content, note }, lost) {
  const renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
  const canvas = renderer.domElement;
  canvas.setAttribute("aria-hidden", "true");
  place.append(canvas);
  canvas.addEventListener("webglcontextlost", lost, { once: true });
  const labels = element("div", { class: "labels", "aria-hidden": "true" });
  place.append(labels);

  const world = new Scene();
  const camera = new PerspectiveCamera(38, 1, 0.01, 1e5);
  camera.up.set(0, 0, 1);
  world.add(new AmbientLight(0xffffff, 2));
  const sun = new DirectionalLight(0xffffff, 1.5);
  sun.position.set(1, -2, 4);
  world.add(sun);
  const controls = new OrbitControls(camera, canvas);
  // The page scrolls; only what is asked for turns the view.
  controls.enableZoom = false;
  controls.addEventListener("change", render);

  const points = () => {
    const { x, y, z } = run().columns;
    return x.map((v, k) => new Vector3(v, y[k], z[k]));
  };
  const { middle, size, floor } = extent([...points(), ...content.waypoints.map((w) => new Vector3(...w.at))]);

  const step = nice(size / 8);
  const cells = 2 * Math.ceil(size / step);
  const grid = new GridHelper(cells * step * 0.75, Math.round(cells * 0.75));
  grid.rotation.x = Math.PI / 2;
  grid.position.set(Math.round(middle.x / step) * step, Math.round(middle.y / step) * step, floor);
  world.add(grid);

  const tolerance = new MeshLambertMaterial({ transparent: true, opacity: 0.35, depthWrite: false });
  const spheres = new InstancedMesh(new SphereGeometry(1, 24, 16), tolerance, Math.max(content.waypoints.length, 1));
  spheres.count = content.waypoints.length;
  content.waypoints.forEach((w, i) => {
    const at = new Matrix4().makeScale(w.within, w.within, w.within);
    spheres.setMatrixAt(i, at.setPosition(...w.at));
  });
  world.add(spheres);
  const dots = new Points(
    new BufferGeometry().setAttribute("position", new Float32BufferAttribute(content.waypoints.flatMap((w) => w.at), 3)),
    new PointsMaterial({ size: 6, sizeAttenuation: false }),
  );
  world.add(dots);

  const material = new LineMaterial({ vertexColors: true, linewidth: 4 });
  let path = null;
  const shadow = new Line(new BufferGeometry(), new LineBasicMaterial({ transparent: true, opacity: 0.5 }));
  const others = new Group();
  world.add(shadow, others);

  const vehicle = new Group();
  const body = new Mesh(new TorusGeometry(0.02 * size, 0.0045 * size, 10, 32), new MeshBasicMaterial());
  const mast = new Line(
    new BufferGeometry().setFromPoints([new Vector3(), new Vector3(0, 0, 0.075 * size)]),
    new LineBasicMaterial(),
  );
  vehicle.add(body, mast);
  vehicle.rotation.order = "ZYX";
  world.add(vehicle);

  const named = content.waypoints.map((w, i) => ({ ...w, i }));
  const told = named.length <= MOST_LABELS ? named : [named[0], named.at(-1)];
  const texts = told.map((w) => {
    const text = element("span", {}, w.i === 0 ? `start` : w.i === named.length - 1 ? "end" : w.name);
    labels.append(text);
    return { text, at: new Vector3(...w.at) };
  });
  note(`One square of the ground is ${number(step)} m wide, at z = ${number(floor)} m. Spheres are tolerances; the ring is the vehicle, its mast points along the thrust. Drag to turn, click the path to go to an instant.`);

  function project(v) {
    const p = v.clone().project(camera);
    return { x: ((p.x + 1) / 2) * place.clientWidth, y: ((1 - p.y) / 2) * place.clientHeight, z: p.z };
  }

  function render() {
    renderer.render(world, camera);
    for (const { text, at } of texts) {
      const p = project(at);
      text.style.transform = `translate(${Math.round(p.x) + 7}px, ${Math.round(p.y) - 20}px)`;
      text.hidden = p.z > 1 || p.x < 0 || p.x > place.clientWidth - 30;
    }
  }

  function fit() {
    const [width, height] = [place.clientWidth, place.clientHeight];
    if (width === 0) return;
    renderer.setPixelRatio(devicePixelRatio);
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    material.resolution.set(width, height);
    render();
  }

  const directions = { free: [-0.62, -0.95, 0.6], top: [0, -0.001, 1], front: [0, -1, 0.02], side: [1, 0, 0.02] };
  function look(name) {
    const away = new Vector3(...directions[name]).normalize();
    const aspect = Math.min(place.clientWidth / Math.max(place.clientHeight, 1), 1);
    camera.position.copy(middle).addScaledVector(away, (0.8 * size) / Math.tan((38 / 2) * (Math.PI / 180)) / Math.max(aspect, 0.5));
    controls.target.copy(middle);
    controls.update();
    render();
  }

  function turn(dx, dy, factor) {
    const away = camera.position.clone().sub(controls.target);
    const polar = Math.acos(away.z / away.length());
    const azimuth = Math.atan2(away.y, away.x) + dx;
    const next = Math.min(Math.max(polar + dy, 0.02), Math.PI - 0.02);
    const length = away.length() * factor;
    away.set(Math.sin(next) * Math.cos(azimuth), Math.sin(next) * Math.sin(azimuth), Math.cos(next)).multiplyScalar(length);
    camera.position.copy(controls.target).add(away);
    controls.update();
    render();
  }

  const keys = { ArrowLeft: [-0.12, 0, 1], ArrowRight: [0.12, 0, 1], ArrowUp: [0, -0.08, 1], ArrowDown: [0, 0.08, 1], "+": [0, 0, 0.87], "=": [0, 0, 0.87], "-": [0, 0, 1.15] };
  place.addEventListener("keydown", (event) => {
    const how = keys[event.key];
    if (!how || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    turn(...how);
  });
  // Zoom needs a modifier, as on maps: otherwise the page could not be scrolled past.
  place.addEventListener("wheel", (event) => {
    if (!event.ctrlKey) return;
    event.preventDefault();
    turn(0, 0, Math.exp(0.002 * event.deltaY));
  }, { passive: false });

  /** The instant whose place lies under the pointer; null where none is near. */
  function under(event) {
    const box = canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    let best = { distance: NEAR_PX, k: null };
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
    canvas.style.cursor = k === null ? "grab" : "pointer";
    place.title = k === null ? "" : `${run().columns.t[k].toFixed(2)} s: ${["x", "y", "z"].map((n) => number(run().columns[n][k])).join(", ")} m, ${number(run().columns.speed[k])} m/s`;
  });

  function theme() {
    const ink = new Color(css("--ink"));
    grid.material.vertexColors = false;
    grid.material.color = new Color(css("--ground"));
    grid.material.needsUpdate = true;
    tolerance.color = new Color(css("--accent"));
    dots.material.color = ink;
    body.material.color = ink;
    mast.material.color = ink;
    shadow.material.color = new Color(css("--soft"));
  }

  function drawPath(colors) {
    const { x, y, z } = run().columns;
    if (path) {
      world.remove(path);
      path.geometry.dispose();
    }
    const geometry = new LineGeometry();
    geometry.setPositions(x.flatMap((v, k) => [v, y[k], z[k]]));
    const color = new Color();
    geometry.setColors(colors.flatMap((c) => color.set(c).toArray()));
    path = new Line2(geometry, material);
    world.add(path);
    shadow.geometry.setFromPoints(points().map((p) => p.setZ(floor)));
    others.clear();
    for (const other of content.runs) {
      if (other === run()) continue;
      const c = other.columns;
      const line = c.x.map((v, k) => new Vector3(v, c.y[k], c.z[k]));
      others.add(new Line(new BufferGeometry().setFromPoints(line), new LineBasicMaterial({ color: new Color(css("--soft")), transparent: true, opacity: 0.55 })));
    }
    time();
  }

  function time() {
    const c = run().columns;
    const k = indexAt(c.t, state.time);
    const degrees = Math.PI / 180;
    vehicle.position.set(c.x[k], c.y[k], c.z[k]);
    vehicle.rotation.set(c.roll[k] * degrees, c.pitch[k] * degrees, c.yaw[k] * degrees);
    render();
  }

  theme();
  const watch = new ResizeObserver(fit);
  watch.observe(place);
  fit();
  look("free");
  return { path: drawPath, time, theme, look, remove: () => watch.disconnect() };
}

/** The middle and the size of a cloud of points, and the ground below it. */
function extent(points) {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  for (const p of points) {
    low.min(p);
    high.max(p);
  }
  const size = Math.max(high.distanceTo(low), 0.5);
  const step = nice(size / 8);
  return { middle: low.clone().add(high).multiplyScalar(0.5), size, floor: Math.floor(low.z / step) * step };
}

/** 1, 2 or 5 times a power of ten, near `x`. */
function nice(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return [5, 2, 1].map((f) => f * power).find((v) => v <= x) ?? power;
}
