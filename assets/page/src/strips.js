// Heat strips: one row per mode over time, with the smallest margin in each cell.

import { axis, chart, marker, timeAxis } from "./axes.js";
import { marginAt } from "./charts.js";
import { byId, content, element, percent, seconds } from "./content.js";
import { CLASSES, classOf } from "./palette.js";
import { on, run, setSet, setTime, state } from "./state.js";

const ROW = 20;
let drawn = [];

/** Fills a legend: swatches with their meaning. */
export function legend(place, entries) {
  place.replaceChildren(
    ...entries.map(({ name, color, className }) => {
      const swatch = element("span", { class: `swatch ${className ?? ""}`, "aria-hidden": "true" });
      swatch.style.backgroundColor = color;
      return element("span", { class: "entry" }, swatch, name);
    }),
  );
}

export const classLegend = () =>
  [...CLASSES].reverse().map((c) => ({ ...c, className: c.name === "outside" ? "hatched" : "" }));

function cells(u, strips, end) {
  const { ctx } = u;
  ctx.save();
  strips.forEach((strip, row) => {
    const top = u.valToPos(row + 0.06, "y", true);
    const height = u.valToPos(row + 0.94, "y", true) - top;
    const width = end / strip.margins.length;
    strip.margins.forEach((m, k) => {
      const left = Math.floor(u.valToPos(k * width, "x", true));
      const right = Math.ceil(u.valToPos((k + 1) * width, "x", true));
      const kind = classOf(m ?? Infinity);
      ctx.fillStyle = kind.color;
      ctx.fillRect(left, top, right - left, height);
    });
    hatch(u, strip, top, height, width);
  });
  ctx.restore();
}

/** Hatches violations, so that they are visible without colour. */
function hatch(u, strip, top, height, width) {
  const { ctx } = u;
  const step = 5 * devicePixelRatio;
  ctx.save();
  ctx.beginPath();
  strip.margins.forEach((m, k) => {
    if (classOf(m ?? Infinity).name !== "outside") return;
    const left = u.valToPos(k * width, "x", true);
    ctx.rect(left, top, Math.max(u.valToPos((k + 1) * width, "x", true) - left, 2 * devicePixelRatio), height);
  });
  ctx.clip();
  ctx.strokeStyle = "rgba(255, 255, 255, 0.85)";
  ctx.lineWidth = devicePixelRatio;
  ctx.beginPath();
  for (let x = u.bbox.left - height; x < u.bbox.left + u.bbox.width; x += step) {
    ctx.moveTo(x, top + height);
    ctx.lineTo(x + height, top);
  }
  ctx.stroke();
  ctx.restore();
}

function draw(shownRun, place) {
  const { strips } = shownRun;
  const end = shownRun.columns.t.at(-1);
  const names = strips.map((s) => content.sets[s.set].name);
  const widest = Math.max(...names.map((n) => n.length));
  const readout = element("p", { class: "readout" });
  // A cell shows the smallest margin of its span of time.
  const cellAt = (t, row) => {
    const count = strips[row].margins.length;
    return Math.min(Math.max(Math.floor((t / end) * count), 0), count - 1);
  };
  const cell = (t, row) => `${names[row]} ${percent(strips[row].margins[cellAt(t, row)])}`;
  const span = (t, row) => {
    const [k, count] = [cellAt(t, row), strips[row].margins.length];
    return `Smallest margin from ${seconds((k / count) * end)} to ${seconds(((k + 1) / count) * end)}`;
  };
  const options = {
    legend: { show: false },
    cursor: { sync: { key: "time" }, drag: { x: false, y: false }, points: { show: false } },
    scales: { x: { time: false, range: () => [0, end] }, y: { dir: -1, range: () => [0, strips.length] } },
    axes: [
      timeAxis({ grid: { show: false } }),
      axis(null, {
        label: undefined,
        size: Math.min(12 + 7.2 * widest, 110),
        grid: { show: false },
        ticks: { show: false },
        splits: () => strips.map((_, i) => i + 0.5),
        values: (_, splits) => splits.map((s) => names[Math.floor(s)]),
      }),
    ],
    series: [{}, { points: { show: false }, paths: () => null }],
    hooks: {
      draw: [(u) => cells(u, strips, end)],
      setCursor: [
        (u) => {
          if (!(u.cursor.left >= 0) || !(u.cursor.top >= 0)) return;
          const row = Math.min(Math.max(Math.floor(u.posToVal(u.cursor.top, "y")), 0), strips.length - 1);
          const t = u.posToVal(u.cursor.left, "x");
          readout.textContent = `${span(t, row)}: ${cell(t, row)} of the healthy set's width`;
        },
      ],
    },
  };
  const plot = element("div", { class: "plot" });
  place.append(plot, readout);
  const name = `Smallest margin to each mode's set over time, ${shownRun.label}`;
  const made = chart(plot, name, () => ROW * strips.length + 62, options, [[0, end], [0, strips.length]]);
  made.over.addEventListener("click", () => {
    setTime(made.posToVal(made.cursor.left, "x"));
    const row = Math.floor(made.posToVal(made.cursor.top, "y"));
    if (strips[row]) setSet(strips[row].set);
  });
  const mark = marker(made);
  const show = () => {
    mark(Math.min(state.time, end));
    const now = Math.min(state.time, end);
    const all = strips.map(({ set }, row) => `${names[row]} ${percent(marginAt(shownRun.columns, set, now))}`);
    readout.textContent = `At ${seconds(now)}: ${all.slice(0, 4).join("; ")}${all.length > 4 ? "; …" : ""}`;
  };
  made.hooks.setSize = [...(made.hooks.setSize ?? []), () => requestAnimationFrame(show)];
  return { made, show };
}

function build() {
  // A flight has no strips of its own, so those of the plans are shown.
  const measured = content.runs.filter((r) => r.strips.length > 0);
  const first = run().strips.length > 0 ? run() : measured[0];
  const margin = first.charts.find((c) => c.id === "margin");
  // Among several runs, the headline names the one that the margin belongs to.
  const headline = content.runs.length > 1 ? `${first.label}: ${margin.headline.replace(/^T/, "t")}` : margin.headline;
  byId("strips-headline").textContent = headline.replace(/^t/, "T");
  const place = byId("strips");
  for (const d of drawn) d.made.remove();
  place.replaceChildren();
  drawn = measured.map((r) => {
    const figure = element("figure", { class: r === run() ? "shown" : "" });
    if (content.runs.length > 1) figure.append(element("figcaption", {}, element("h3", {}, r.label)));
    place.append(figure);
    return draw(r, figure);
  });
  drawn.forEach((d) => d.show());
}

export function strips() {
  if (!byId("strips") || !content.runs.some((r) => r.strips.length > 0)) return;
  legend(byId("strips-legend"), classLegend());
  build();
  on("run", build);
  on("time", () => drawn.forEach((d) => d.show()));
  on("theme", () => drawn.forEach((d) => d.made.redraw(false)));
}
