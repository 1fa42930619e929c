// Shared by all views in space: renderer, camera, light, labels, rotation by pointer and keys.

import { AmbientLight, DirectionalLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { whenFitting } from "./axes.js";
import { element } from "./content.js";

const FIELD = 38;
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

/** A view of a ball of diameter `size` about `middle`; throws without WebGL. `lost` is called when the context is lost. */
export function stage(place, middle, size, lost) {
  const canvas = element("canvas");
  const wanted = { antialias: true, alpha: true, preserveDrawingBuffer: true };
  const context = canvas.getContext("webgl2", wanted);
  if (!context) throw new Error("no WebGL");
  const renderer = new WebGLRenderer({ canvas, context, ...wanted });
  canvas.setAttribute("aria-hidden", "true");
  canvas.addEventListener("webglcontextlost", lost, { once: true });
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
  const label = (name, at) => {
    const text = element("span", {}, name);
    labels.append(text);
    const entry = { text, at };
    texts.push(entry);
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
    const [width, height] = [place.clientWidth, place.clientHeight];
    renderer.render(world, camera);
    for (const { text, at } of texts) {
      const p = project(at);
      text.hidden = p.z > 1 || p.x < 0 || p.y < 0 || p.x > width;
      // In shares of the place, so that labels stay in position if the picture is stretched.
      text.style.left = `${(100 * p.x) / width}%`;
      text.style.top = `${(100 * p.y) / height}%`;
      const beyond = p.x + 8 + text.offsetWidth > width;
      text.style.transform = `translate(${beyond ? "calc(-100% - 8px)" : "8px"}, ${p.y < 24 ? "4px" : "-22px"})`;
    }
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
  function fit() {
    const [width, height] = [place.clientWidth, place.clientHeight];
    if (width === 0) return;
    renderer.setPixelRatio(devicePixelRatio);
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    fits.forEach((f) => f(width, height));
    render();
  }
  const watch = new ResizeObserver(fit);
  watch.observe(place);
  // Printing does not wait for the next frame.
  let copy = null;
  const forget = whenFitting(() => {
    fit();
    draw();
    copy?.remove();
    copy = null;
    if (!document.documentElement.classList.contains("printing")) return;
    // Browsers print the last WebGL frame at its size on the screen, so a copy is printed instead.
    canvas.classList.add("screen");
    copy = element("canvas", { "aria-hidden": "true" });
    [copy.width, copy.height] = [canvas.width, canvas.height];
    copy.getContext("2d").drawImage(canvas, 0, 0);
    place.prepend(copy);
  });

  function look(name) {
    const away = new Vector3(...DIRECTIONS[name]).normalize();
    const narrow = Math.min(place.clientWidth / Math.max(place.clientHeight, 1), 1);
    const distance = (0.5 * size) / Math.sin((FIELD / 2) * (Math.PI / 180)) / Math.max(narrow, 0.4);
    camera.position.copy(middle).addScaledVector(away, distance);
    controls.target.copy(middle);
    controls.update();
    render();
  }

  function turn(dx, dy, factor) {
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
  // Zooming needs a key, as on maps: otherwise the view would block scrolling.
  const zoom = (event) => {
    if (!event.ctrlKey) return;
    event.preventDefault();
    turn(0, 0, Math.exp(0.002 * event.deltaY));
  };
  place.addEventListener("wheel", zoom, { passive: false });

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
  return { world, canvas, label, project, render, look, onFit, remove };
}
