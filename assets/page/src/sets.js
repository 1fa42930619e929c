// Sections of the admissible sets, like the paper's Figures 7 to 9 for every mode, with the wrench moving through them.

import { marginAt, measuredByCore, wrenchAt, wrenchAtTime } from "./charts.js";
import { body as bodyOf } from "./body.js";
import { byId, content, element, indexAt, number, percent, seconds } from "./content.js";
import { css } from "./palette.js";
import { plane } from "./plane.js";
import { chord, coreOf, margin, section, whole } from "./polytope.js";
import { on, run, set, setSet, state } from "./state.js";

const LABELS = ["T [N]", "τx [N m]", "τy [N m]", "τz [N m]"];
const COLUMNS = ["thrust", "tau_x", "tau_y", "tau_z"];
/** Horizontal and vertical component of each section. */
const PANELS = [
  { axes: [1, 2], title: "Torques about x and y" },
  { axes: [1, 0], title: "Thrust and torque about x" },
  { axes: [2, 0], title: "Thrust and torque about y" },
  { axes: [3, 0], title: "Thrust and torque about z" },
];
const TRAIL = 160;

const moves = content.runs.length > 0;
const planeChoice = byId("plane");
let panels = [];
let multiples = [];
let solid = null;

/** The wrench at the instant shown; hover if nothing was planned. */
export function wrenchNow() {
  if (!moves) return content.hover;
  return wrenchAtTime(run().columns, state.time);
}

/** The margin shown for a set: of the run at this instant; of hover if nothing was planned. */
const marginNow = (index) => (moves ? marginAt(run().columns, index, state.time) : margin(content.sets[index], content.hover));

/** Whether the margin shown is to the core of a mode without yaw. */
const isByCore = (index) => moves && measuredByCore(run().columns, index);

/** The wrench through which sections are taken. */
const through = () => (planeChoice?.value === "hover" || !moves ? content.hover : wrenchNow());

/** The extent of the healthy set and the wrench along each axis, with padding. */
const extents = (() => {
  return () => {
    const found = content.extents.map(([a, b]) => [a, b]);
    if (moves) {
      COLUMNS.forEach((name, i) => {
        for (const v of run().columns[name]) {
          found[i][0] = Math.min(found[i][0], v);
          found[i][1] = Math.max(found[i][1], v);
        }
      });
    }
    return found.map(([a, b]) => [a - 0.08 * (b - a) - 1e-6, b + 0.08 * (b - a) + 1e-6]);
  };
})();

/** Sections may extend beyond the box, so they are clipped to a much larger one. */
function sectionOf(body, w, [i, j], box) {
  const [x0, x1, y0, y1] = box;
  const [dx, dy] = [4 * (x1 - x0), 4 * (y1 - y0)];
  return section(body, w, i, j, [x0 - dx, x1 + dx, y0 - dy, y1 + dy]);
}

const stateColor = (m) => (m < -0.01 ? css("--bad") : css("--accent"));

function drawSection(pen, axes, index, box, trails) {
  const body = content.sets[index];
  const w = through();
  const [i, j] = axes;
  const put = (v) => [v[i], v[j]];
  pen.polygon(sectionOf(content.sets[0], w, axes, box), { fill: css("--healthy"), stroke: css("--healthy-edge"), width: 1 });
  if (content.reserve > 0) {
    const full = whole(body, content.hover, content.reserve);
    pen.polygon(sectionOf(full, w, axes, box), { stroke: css("--accent"), width: 1, dash: [4, 3] });
  }
  pen.polygon(sectionOf(body, w, axes, box), { fill: css("--band"), stroke: css("--accent"), width: 1.75 });
  // The core says nothing of the torque about z.
  if (body.core && !axes.includes(3)) {
    pen.polygon(sectionOf(coreOf(body), w, axes, box), { fill: css("--core"), stroke: css("--core-edge"), width: 1.75 });
  }
  pen.cross(put(content.hover), css("--soft"));
  if (!moves) return;
  if (trails) {
    const { columns } = run();
    const now = indexAt(columns.t, state.time);
    const first = Math.max(0, now - TRAIL);
    const points = [];
    for (let k = first; k <= now; k++) points.push(put(wrenchAt(columns, k)));
    if (points.length > 1) pen.line(points, { stroke: css("--soft"), width: 1 });
  }
  const here = wrenchNow();
  pen.dot(put(here), { fill: stateColor(marginNow(index)), stroke: css("--paper"), radius: trails ? 6 : 4 });
}

function boxOf([i, j]) {
  const found = extents();
  return [...found[i], ...found[j]];
}

function buildPanels() {
  const place = byId("sections");
  panels.forEach((p) => p.remove());
  place.replaceChildren();
  panels = PANELS.map(({ axes, title }) => {
    const [i, j] = axes;
    const plot = element("div", { class: "plot" });
    place.append(element("figure", {}, element("figcaption", {}, element("h3", {}, title)), plot));
    return plane(plot, {
      name: `Section of the admissible set: ${title}`,
      labels: [LABELS[i], LABELS[j]],
      box: () => boxOf(axes),
      equal: i > 0 && j > 0 && j !== 3,
      height: () => (place.clientWidth < 420 ? 200 : 270),
      draw: (pen) => drawSection(pen, axes, state.set, boxOf(axes), true),
    });
  });
}

/** The set as a solid, if there is WebGL. */
function buildSolid() {
  const figure = byId("solid");
  const place = figure.querySelector(".canvas");
  try {
    solid = bodyOf(place, extents());
  } catch {
    figure.hidden = true;
  }
}

function showSolid() {
  if (!solid) return;
  byId("solid").querySelector(".none").hidden = solid.show(set());
}

function buildMultiples() {
  const place = byId("multiples");
  multiples.forEach((m) => m.view.remove());
  place.replaceChildren();
  multiples = content.sets.slice(1).map((body, k) => {
    const index = k + 1;
    const plot = element("div", { class: "plot" });
    const value = element("span", { class: "value" });
    const button = element("button", { type: "button", class: "multiple" }, element("span", { class: "name" }, body.name), value, plot);
    button.addEventListener("click", () => setSet(index));
    place.append(button);
    const view = plane(plot, {
      name: `${body.name}: section of torques about x and y`,
      labels: ["", ""],
      box: () => boxOf([1, 2]),
      equal: true,
      plain: true,
      height: () => (plot.clientWidth < 110 ? 90 : 130),
      draw: (pen) => drawSection(pen, [1, 2], index, boxOf([1, 2]), false),
    });
    return { view, body, value, button, index };
  });
}

function tell() {
  const body = set();
  const w = wrenchNow();
  const byCore = isByCore(state.set);
  const m = marginNow(state.set);
  const called = moves ? run().wrench : "";
  const where = byCore ? `At ${seconds(state.time)} the planned motion` : moves ? `At ${seconds(state.time)} the ${called}` : "Hover";
  const headline = byId("sets-headline");
  const what = body === content.sets[0] ? "the set of the healthy vehicle" : `the ${byCore ? "core" : "set"} of ${body.name}`;
  headline.textContent = headlineOf(where, what, m, moves ? null : body.hover);
  headline.classList.toggle("bad", m < -0.01);
  const held = planeChoice?.value === "hover" || !moves ? "at hover, T = m g without torque" : "through the wrench shown: the two components not drawn have their values at this instant";
  const kept = content.reserve > 0 ? ` Solid: the set used for planning, shrunk about hover by the reserve of ${number(100 * content.reserve)} %; dashed: the whole set.` : "";
  byId("sets-note").textContent = `Sections ${held}. Grey: the healthy vehicle. Blue: ${body.name}${body.title ? ` (${body.title})` : ""}.${kept}${body.core ? " Green: the core, the thrusts and torques about x and y at every heading once yaw is given up; plans are measured by it, and turning asks torque beside that of the wrench." : ""} Cross: hover.${moves ? ` Dot: the ${called}, with its recent path.` : ""}`;
  room(body, w, margin(body, w));
}

/** `place`: the compiler's word for hover. Margins of other wrenches are shown, and compared, to a hundredth of a percent. */
function headlineOf(where, what, m, place) {
  if (place === "on the edge") return `${where} is on the edge of ${what}`;
  if (Math.abs(m) < 0.01) return `${where} is less than 0.01 % of the healthy width from the edge of ${what}`;
  return `${where} is ${m < 0 ? "outside" : "inside"} ${what}, by ${number(Math.abs(m))} % of the healthy width`;
}

/** The table of the range of each component by itself. */
function room(body, w, m) {
  const rows = LABELS.map((name, axis) => {
    const found = chord(body, w, axis);
    // Rounding errors are shown as zero.
    const dust = 1e-5 * (content.extents[axis][1] - content.extents[axis][0]);
    const clean = (x, digits) => number(Math.abs(x) < dust ? 0 : x, digits);
    const cells = found
      ? [clean(found[0], 4), clean(found[1], 4), clean(w[axis] - found[0]), clean(found[1] - w[axis])]
      : ["–", "–", "none", "none"];
    return element("tr", {}, element("th", { scope: "row" }, name), ...[clean(w[axis], 4), ...cells].map((c) => element("td", { class: "n" }, c)));
  });
  const heads = ["Component", moves ? "Shown" : "Hover", "Smallest", "Largest", "Down", "Up"];
  const table = element(
    "table",
    {},
    element("caption", {}, element("span", {}, `Range of each component by itself in the set of ${body.name}${body.core ? ", torque about z included" : ""}; spare ${percent(m)}`)),
    element("thead", {}, element("tr", {}, ...heads.map((h, i) => element("th", i === 0 ? { scope: "col" } : { scope: "col", class: "n" }, h)))),
    element("tbody", {}, ...rows),
  );
  byId("room").replaceChildren(table);
}

function tellMultiples() {
  for (const { value, button, index } of multiples) {
    const m = marginNow(index);
    value.textContent = percent(m);
    value.classList.toggle("bad", m < -0.01);
    button.setAttribute("aria-pressed", String(index === state.set));
  }
}

function refresh() {
  panels.forEach((p) => p.again());
  const here = wrenchNow();
  solid?.move(here, stateColor(marginNow(state.set)));
  multiples.forEach((m) => m.view.again());
  tell();
  tellMultiples();
}

export function sets() {
  const choice = byId("set");
  if (!choice || content.sets.length === 0) return;
  content.sets.forEach((s, i) => {
    choice.append(element("option", { value: String(i) }, s.title ? `${s.name}: ${s.title}` : s.name));
  });
  choice.value = String(state.set);
  choice.addEventListener("change", () => setSet(Number(choice.value)));
  if (!moves) planeChoice.closest("label").hidden = true;
  planeChoice.addEventListener("change", refresh);
  buildPanels();
  buildSolid();
  buildMultiples();
  if (multiples.length === 0) byId("multiples").previousElementSibling.hidden = true;
  on("set", () => {
    choice.value = String(state.set);
    showSolid();
    refresh();
  });
  on("time", refresh);
  on("run", refresh);
  on("theme", () => {
    showSolid();
    refresh();
  });
  showSolid();
  solid?.move(wrenchNow(), stateColor(marginNow(state.set)));
  tell();
  tellMultiples();
}
