// The flight in space: three.js with WebGL, two flat views without.

import { byId, content, element, indexAt, number, percent, seconds } from "./content.js";
import { marginAt } from "./charts.js";
import { classOf, css, distanceClasses, line } from "./palette.js";
import { classLegend, legend } from "./strips.js";
import { keep } from "./kept.js";
import { on, run, set, setTime, state } from "./state.js";
import { flat } from "./flat.js";
import { reached, wayShown } from "./ways.js";
import { scene } from "./scene.js";
import { NOTE } from "./volumes.js";

/** Most modes with a colour of their own. */
const MOST_COLORS = 7;

/** Margin columns of a run with their names. */
export const margins = () =>
  run().strips.map(({ set }) => ({ name: content.sets[set].name, values: run().columns[`margin_${set}`] }));

function smallest(k) {
  let found = { margin: Infinity, mode: null };
  for (const { name, values } of margins()) {
    if (values[k] !== null && values[k] < found.margin) found = { margin: values[k], mode: name };
  }
  return found;
}

/** The mode with the smallest margin at the instant shown; the first of several equal ones. */
function nearest() {
  const all = run().strips.map(({ set }) => ({ margin: marginAt(run().columns, set, state.time), mode: content.sets[set].name }));
  const least = Math.min(...all.map((m) => m.margin));
  // Differences of thousandths of a percent do not count.
  return all.find((m) => m.margin < least + 1e-3) ?? { margin: Infinity, mode: null };
}

/** Ways to colour the path: each has the colour of every instant and a legend. */
function colorings() {
  const { columns } = run();
  const modes = margins();
  const byMargin = (values) => ({ colors: values.map((m) => classOf(m ?? Infinity).color), legend: classLegend(), hasClasses: true });
  const found = [];
  if (modes.length > 0) {
    const least = columns.t.map((_, k) => smallest(k));
    found.push({ name: modes.length > 1 ? "smallest spare" : `spare in ${modes[0].name}`, ...byMargin(least.map((l) => l.margin)) });
    if (modes.length > 1) {
      const seen = [...new Set(least.map((l) => l.mode))].slice(0, MOST_COLORS);
      const color = (mode) => (seen.includes(mode) ? line(seen.indexOf(mode)) : css("--soft"));
      found.push({ name: "mode with the smallest spare", colors: least.map((l) => color(l.mode)), legend: seen.map((mode) => ({ name: mode, color: color(mode) })) });
      for (const { name, values } of modes) found.push({ name: `spare in ${name}`, ...byMargin(values) });
    }
  }
  // For a flight: the faults in force, and the position error.
  if (run().phases.length > 1) {
    const color = phaseColors();
    const seen = [...new Set(run().phases.map((p) => p.label))];
    found.push({ name: "faults", colors: columns.t.map((t) => color(phaseAt(t))), legend: seen.map((label) => ({ name: label, color: color(label) })) });
  }
  if (columns.error) {
    const classes = distanceClasses(Math.max(...columns.error, 1e-6));
    const color = (error) => classes.find((c) => error < c.below).color;
    found.push({ name: "position error", colors: columns.error.map(color), legend: classes });
  }
  if (found.length === 0) found.push({ name: "one colour", colors: columns.t.map(() => css("--accent")), legend: [] });
  return found;
}

/** Colours of a flight's phases: the first phase, then those that last longest, have the colours that differ most. */
function phaseColors() {
  const { phases, columns } = run();
  const lasts = new Map();
  phases.forEach(({ from, label }, i) => {
    const end = phases[i + 1]?.from ?? columns.t.at(-1);
    lasts.set(label, (lasts.get(label) ?? 0) + end - from);
  });
  const [first, ...others] = lasts.keys();
  const order = [first, ...others.sort((a, b) => lasts.get(b) - lasts.get(a))];
  return (label) => (order.indexOf(label) < MOST_COLORS ? line(order.indexOf(label)) : css("--soft"));
}

/** The faults in force in a flight; undefined for a plan. */
const phaseAt = (t) => run().phases.findLast((p) => p.from <= t + 1e-9)?.label;

/** The rotors that are affected at the instant shown: by the fault of a flight, or by the mode selected for a plan. */
function struck() {
  const phase = phaseAt(state.time);
  if (phase === undefined) return set()?.struck ?? [];
  const names = phase.split(", ").map((fault) => fault.split(" ")[0]);
  return content.sets.filter((s) => names.includes(s.name)).flatMap((s) => s.struck ?? []);
}

/** `; shown without rotor 2 (M2)` */
function strikes() {
  const lost = struck().filter(([, isLost]) => isLost).map(([k]) => k + 1);
  const name = phaseAt(state.time) === undefined ? ` (${set()?.name})` : "";
  return lost.length === 0 ? "" : `; shown without rotor${lost.length > 1 ? "s" : ""} ${lost.join(", ")}${name}`;
}

function tell() {
  const { columns } = run();
  const k = indexAt(columns.t, state.time);
  const { margin, mode } = nearest();
  const place = ["x", "y", "z"].map((name) => `${name} ${number(columns[name][k])}`).join(", ");
  const near = mode === null ? "" : `; spare ${percent(margin)} in ${mode}`;
  const off = columns.error ? `; position error ${number(100 * columns.error[k])} cm` : "";
  const phase = phaseAt(columns.t[k]);
  const under = phase ? `; ${phase}` : "";
  byId("space-readout").textContent = `At ${seconds(state.time)}: ${place} m; ${number(columns.speed[k])} m/s; tilt ${number(columns.tilt[k])} deg${near}${off}${strikes()}${under}`;
}

export function space() {
  const place = byId("space");
  if (!place) return;
  const choice = byId("colour");
  let view;
  // The hint about rotating is not printed.
  const note = (text, hint = "") => byId("space-note").replaceChildren(text, element("span", { class: "hint" }, hint));
  const views = { place, run, state, setTime, struck, content, note, reached, wayShown };
  const fill = () => {
    const kept = choice.selectedIndex;
    choice.replaceChildren(...colorings().map((c, i) => element("option", { value: String(i) }, c.name)));
    choice.selectedIndex = Math.min(Math.max(kept, 0), choice.options.length - 1);
  };
  const color = () => {
    const chosen = colorings()[choice.selectedIndex];
    legend(byId("space-legend"), chosen.legend);
    // The margins below have the same colours.
    const repeated = byId("strips-legend");
    if (repeated) repeated.hidden = Boolean(chosen.hasClasses);
    view.path(chosen.colors);
  };
  const begin = (make) => {
    view = make(views);
    color();
    view.time();
  };
  const plain = () => {
    view?.remove?.();
    place.replaceChildren();
    place.classList.add("flat");
    place.removeAttribute("tabindex");
    place.setAttribute("role", "group");
    place.setAttribute("aria-label", "Path seen from above and from the side");
    document.querySelectorAll("[data-view]").forEach((b) => (b.parentElement.hidden = true));
    begin(flat);
    byId("space-about").open = true;
    note(`This browser does not support WebGL, so the path is shown from above and from the side. Circles are waypoints with their tolerances.${NOTE}`);
  };
  fill();
  try {
    begin((v) => scene(v, plain));
  } catch (problem) {
    plain();
  }
  choice.addEventListener("change", color);
  document.querySelectorAll("[data-view]").forEach((b) => b.addEventListener("click", () => view.look(b.dataset.view)));
  on("time", () => {
    view.time();
    tell();
  });
  on("run", () => {
    fill();
    color();
  });
  on("way", () => view.time());
  on("set", () => {
    view.time();
    tell();
  });
  on("theme", () => {
    view.theme();
    color();
  });
  tell();
  keep("camera", { now: () => view.stand?.(), restore: (stand) => view.returnTo?.(stand) });
}
