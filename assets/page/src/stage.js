// Shared by all views in space: renderer, camera, light, labels, rotation by pointer and keys.

import { AmbientLight, DirectionalLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { whenFitting } from "./axes.js";
import { element } from "./content.js";
import { arrange } from "./labels.js";

const FIELD = 38;
/** The share of the picture that what is framed may take: labels have the rest. */
const FILLED = 0.88;
const DIRECTIONS = { free: [-0.62, -0.95, 0.6], top: [0, -0.001, 1], front: [0, -1, 0.02], side: [1, 0, 0.02] };
const KEYS = {
  ArrowLeft: [-0.12, 0, 1],
  ArrowRight: [0.12, 0, 1],
  ArrowUp: [0, -0.08, 1],
  ArrowDown: [0, 0.08, 1],
  "+": [0, 0, 0.87],
  "=": [0, 0, 0.87],
  "-": [0, 0, 1.15],
};

/**
 * A view of `points` of a scene of the given size; throws without WebGL. `lost` is called when the context is lost.
 *
 * The scene is drawn in a canvas of its own, and each picture is copied to the one that is shown: browsers that compose
 * pages without a GPU lose what WebGL drew when the page scrolls, and all print it at its size on the screen.
 */
export function stage(place, points, size, lost) {
  const drawn = element("canvas");
  const wanted = { antialias: true, alpha: true };
  const context = drawn.getContext("webgl2", wanted);
  if (!context) throw new Error("no WebGL");
  const renderer = new WebGLRenderer({ canvas: drawn, context, ...wanted });
  drawn.addEventListener("webglcontextlost", lost, { once: true });
  const canvas = element("canvas", { "aria-hidden": "true" });
  const pen = canvas.getContext("2d");
  const labels = element("div", { class: "labels", "aria-hidden": "true" });
  place.append(canvas, labels);

  const world = new Scene();
  const camera = new PerspectiveCamera(FIELD, 1, 0.01 * size, 100 * size);
  camera.up.set(0, 0, 1);
  world.add(new AmbientLight(0xffffff, 2));
  const sun = new DirectionalLight(0xffffff, 1.5);
  sun.position.set(1, -2, 4);
  world.add(sun);
  const controls = new OrbitControls(camera, canvas);
  // The wheel scrolls the page.
  controls.enableZoom = false;
  controls.enablePan = false;
  canvas.style.touchAction = "pan-y";

  let texts = [];
  /** A text at a place; where there is no room for all, those of a lower `rank` are kept. */
  const label = (name, at, rank = 1, kind = "") => {
    const text = element("span", kind ? { class: kind } : {}, name);
    labels.append(text);
    const entry = { text, at, rank };
    texts = [...texts, entry].sort((a, b) => a.rank - b.rank);
    const remove = () => {
      text.remove();
      texts = texts.filter((other) => other !== entry);
    };
    return { remove };
  };

  /** Pixels from the upper left corner, and depth. */
  function project(v) {
    const p = v.clone().project(camera);
    return { x: ((p.x + 1) / 2) * place.clientWidth, y: ((1 - p.y) / 2) * place.clientHeight, z: p.z };
  }

  function draw() {
    renderer.render(world, camera);
    pen.clearRect(0, 0, canvas.width, canvas.height);
    pen.drawImage(drawn, 0, 0);
    arrange(texts, project, place);
  }
  let asked = false;
  function render() {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      draw();
    });
  }
  controls.addEventListener("change", render);

  const fits = [];
  // The view chosen, until the reader turns it.
  let chosen = "free";
  controls.addEventListener("start", () => (chosen = null));
  function fit() {
    const [width, height] = [place.clientWidth, place.clientHeight];
    if (width === 0) return;
    renderer.setPixelRatio(devicePixelRatio);
    renderer.setSize(width, height, false);
    [canvas.width, canvas.height] = [drawn.width, drawn.height];
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    fits.forEach((f) => f(width, height));
    if (chosen) look(chosen);
    render();
  }
  const watch = new ResizeObserver(fit);
  watch.observe(place);
  // Printing does not wait for the next frame.
  const forget = whenFitting(() => {
    fit();
    draw();
  });

  /** Looks from a direction, as near as all points are in the picture. */
  function look(name) {
    chosen = name;
    const away = new Vector3(...DIRECTIONS[name]).normalize();
    const right = new Vector3().crossVectors(camera.up, away).normalize();
    const up = new Vector3().crossVectors(away, right);
    const [high, wide] = [1, camera.aspect].map((by) => FILLED * by * Math.tan((FIELD / 2) * (Math.PI / 180)));
    // In the axes of the picture: to the right, up, towards the camera.
    const seen = points.map((p) => [p.dot(right), p.dot(up), p.dot(away)]);
    const middle = [0, 1, 2].map((i) => (Math.min(...seen.map((p) => p[i])) + Math.max(...seen.map((p) => p[i]))) / 2);
    let distance = 0;
    // What is near looks larger, so the middle of the picture is not that of the points: a few steps settle it.
    for (let step = 0; step < 6; step++) {
      distance = Math.max(...seen.map(([x, y, z]) => z - middle[2] + Math.max(Math.abs(x - middle[0]) / wide, Math.abs(y - middle[1]) / high)));
      for (const i of [0, 1]) {
        const shares = seen.map((p) => (p[i] - middle[i]) / (distance - p[2] + middle[2]));
        middle[i] += (distance * (Math.min(...shares) + Math.max(...shares))) / 2;
      }
    }
    controls.target.set(0, 0, 0).addScaledVector(right, middle[0]).addScaledVector(up, middle[1]).addScaledVector(away, middle[2]);
    camera.position.copy(controls.target).addScaledVector(away, Math.max(distance, 0.1 * size));
    controls.update();
    render();
  }

  function turn(dx, dy, factor) {
    chosen = null;
    const away = camera.position.clone().sub(controls.target);
    const polar = Math.min(Math.max(Math.acos(away.z / away.length()) + dy, 0.02), Math.PI - 0.02);
    const azimuth = Math.atan2(away.y, away.x) + dx;
    const length = away.length() * factor;
    away.set(Math.sin(polar) * Math.cos(azimuth), Math.sin(polar) * Math.sin(azimuth), Math.cos(polar));
    camera.position.copy(controls.target).addScaledVector(away, length);
    controls.update();
    render();
  }
  place.addEventListener("keydown", (event) => {
    const how = KEYS[event.key];
    if (!how || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    turn(...how);
  });
  // Only with Ctrl, since otherwise the view would block scrolling.
  const zoom = (event) => {
    if (!event.ctrlKey) return;
    event.preventDefault();
    turn(0, 0, Math.exp(0.002 * event.deltaY));
  };
  place.addEventListener("wheel", zoom, { passive: false });

  /** Where the camera is, to return to it: the name of a view, or two places. */
  const stand = () => chosen ?? { at: camera.position.toArray(), target: controls.target.toArray() };
  function returnTo(place) {
    if (typeof place === "string") return look(place in DIRECTIONS ? place : "free");
    chosen = null;
    camera.position.fromArray(place.at);
    controls.target.fromArray(place.target);
    controls.update();
    render();
  }

  fit();
  look("free");
  const remove = () => {
    watch.disconnect();
    forget();
    controls.dispose();
    renderer.dispose();
  };
  const onFit = (f) => {
    fits.push(f);
    f(place.clientWidth, place.clientHeight);
  };
  return { world, canvas, label, project, render, look, stand, returnTo, onFit, remove };
}
