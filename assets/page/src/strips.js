// Heat strips: one row per mode over time, with the smallest margin in each cell.

import { axis, chart, marker, timeAxis } from "./axes.js";
import { marginAt } from "./charts.js";
import { byId, content, element, percent, seconds } from "./content.js";
import { CLASSES, classOf, css } from "./palette.js";
import { on, run, setSet, setTime, state } from "./state.js";

/** Rows of a chart before it asks for all, and their heights in px: few are drawn higher than many. */
const MOST_ROWS = 8;
const ROW = { few: 19, many: 14 };
/** Px beside the rows, for the instants until which a fault meets a violation. */
const BESIDE = 112;
let drawn = [];
/** Whether all rows are shown. */
let whole = false;

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

/** The rows shown: all, or those of the modes with the smallest margins, in their order. */
function rowsOf({ strips }) {
  if (whole || strips.length <= MOST_ROWS) return strips;
  const least = (strip) => Math.min(...strip.margins.map((m) => m ?? Infinity));
  const kept = [...strips].sort((a, b) => least(a) - least(b)).slice(0, MOST_ROWS);
  return strips.filter((strip) => kept.includes(strip));
}

/** What stands beside a row. */
const beside = ({ until }) => (until === null ? "never" : `before ${seconds(until)}`);

/** Writes beside each row until when a fault of its mode meets a violation, and draws a line over that time. */
function sides(u, strips) {
  const { ctx } = u;
  const px = devicePixelRatio;
  ctx.save();
  ctx.font = `${11 * px}px system-ui, sans-serif`;
  ctx.textAlign = "left";
  ctx.textBaseline = "middle";
  const right = u.bbox.left + u.bbox.width;
  strips.forEach((strip, row) => {
    ctx.fillStyle = css(strip.until === null ? "--soft" : "--bad");
    ctx.fillText(beside(strip), right + 8 * px, u.valToPos(row + 0.5, "y", true));
    if (strip.until === null) return;
    const bottom = u.valToPos(row + 0.94, "y", true);
    ctx.fillStyle = css("--ink");
    ctx.fillRect(u.bbox.left, bottom - 2.5 * px, u.valToPos(strip.until, "x", true) - u.bbox.left, 2.5 * px);
  });
  ctx.restore();
}

function draw(shownRun, place, isLast) {
  const strips = rowsOf(shownRun);
  const height = strips.length > 6 || content.runs.length > 2 ? ROW.many : ROW.few;
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
    return `Smallest spare from ${seconds((k / count) * end)} to ${seconds(((k + 1) / count) * end)}`;
  };
  const options = {
    legend: { show: false },
    padding: [2, () => (place.clientWidth < 420 ? 92 : BESIDE), 0, 0],
    cursor: { sync: { key: "time" }, drag: { x: false, y: false }, points: { show: false } },
    scales: { x: { time: false, range: () => [0, end] }, y: { dir: -1, range: () => [0, strips.length] } },
    axes: [
      timeAxis({ grid: { show: false }, show: isLast }),
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
      draw: [(u) => cells(u, strips, end), (u) => sides(u, strips)],
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
  place.append(plot);
  // Of several plans the numbers of the one shown are enough.
  if (content.runs.length <= 2 || shownRun === run()) place.append(readout);
  const name = `Smallest spare in each mode's set over time, ${shownRun.label}`;
  const made = chart(plot, name, () => height * strips.length + (isLast ? 52 : 6), options, [[0, end], [0, strips.length]]);
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
    readout.textContent = `At ${seconds(now)}: ${all.slice(0, 6).join("; ")}${all.length > 6 ? "; …" : ""}`;
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
  const others = element("details", {}, element("summary", {}, "The other plans"));
  others.open = place.querySelector("details")?.open ?? false;
  place.replaceChildren();
  const lead = measured.filter((r) => r.leads);
  const rest = measured.filter((r) => !r.leads);
  const add = (into, runs) =>
    runs.map((r, k) => {
      const figure = element("figure", { class: r === run() ? "shown" : "" });
      if (content.runs.length > 1) figure.append(element("figcaption", {}, element("h3", {}, r.label)));
      into.append(figure);
      return draw(r, figure, k === runs.length - 1);
    });
  drawn = add(place, lead);
  const most = Math.max(...measured.map((r) => r.strips.length));
  if (most > MOST_ROWS) {
    const button = element("button", { type: "button", class: "more" }, whole ? "Only the smallest spares" : `All ${most} modes`);
    button.addEventListener("click", () => {
      whole = !whole;
      build();
    });
    place.append(button);
  }
  if (rest.length > 0) {
    place.append(others);
    drawn.push(...add(others, rest));
  }
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
