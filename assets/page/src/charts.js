// Charts over time: curves, limits, and the range of a wrench component in the selected mode's set.

import { axis, chart, marker, timeAxis } from "./axes.js";
import { byId, content, element, indexAt, number, valueAt } from "./content.js";
import { css, dash, line, sample } from "./palette.js";
import { chord, margin } from "./polytope.js";
import { on, run, set, setTime, state } from "./state.js";

const AXES = ["thrust", "tau_x", "tau_y", "tau_z"];
let drawn = [];

/** The wrench at instant k of a run. */
export const wrenchAt = (columns, k) => AXES.map((name) => columns[name][k]);

/** The wrench at any instant of a run. */
export const wrenchAtTime = (columns, t) => AXES.map((name) => valueAt(columns.t, columns[name], t));

/** A run's margin to a set at any instant, in percent: every view shows this number. Of a core it depends on more than the wrench. */
export const marginAt = (columns, index, t) =>
  measuredByCore(columns, index)
    ? valueAt(columns.t, columns[`margin_${index}`], t)
    : margin(content.sets[index], wrenchAtTime(columns, t));

/** Whether a run is measured by the core of a mode without yaw instead of its whole set. */
export const measuredByCore = (columns, index) => "core" in content.sets[index] && `margin_${index}` in columns;

function bands(spec, columns) {
  if (spec.axis === null || content.sets.length === 0) return null;
  const low = [];
  const high = [];
  for (let k = 0; k < columns.t.length; k++) {
    const room = chord(set(), wrenchAt(columns, k), spec.axis);
    low.push(room ? room[0] : null);
    high.push(room ? room[1] : null);
  }
  return { low, high };
}

/** Curves that stay within this share of the healthy vehicle's range are drawn as flat as they are. */
const FLAT = 1e-3;

/** The vertical range that shows the curves, and limits and ranges that are not far from them. */
function range(spec, columns, room) {
  let low = Infinity;
  let high = -Infinity;
  const take = (v) => {
    if (v === null || !Number.isFinite(v)) return;
    low = Math.min(low, v);
    high = Math.max(high, v);
  };
  for (const l of spec.lines) columns[l.column].forEach(take);
  const whole = spec.axis === null ? 0 : content.extents[spec.axis][1] - content.extents[spec.axis][0];
  const span = Math.max(high - low, FLAT * whole, 1e-9);
  const [least, most] = [(low + high - span) / 2, (low + high + span) / 2];
  [low, high] = [least, most];
  // A range far beyond the curve is cut off: it would flatten the curve.
  if (room) [...room.low, ...room.high].forEach((v) => v !== null && take(Math.min(Math.max(v, least - 0.6 * span), most + 0.6 * span)));
  for (const b of spec.bounds) if (b.value > low - 1.5 * span && b.value < high + 1.5 * span) take(b.value);
  const margin = 0.06 * Math.max(high - low, 1e-9);
  return [low - margin, high + margin];
}

/** How many pieces of curves pass through a box [left, right, top, bottom] in pixels of the canvas. */
function hidden(u, [left, right, top, bottom]) {
  const [times, ...curves] = u.data;
  const near = (x, by) => Math.min(Math.max(u.valToIdx(u.posToVal(x, "x", true)) + by, 0), times.length - 1);
  const [first, last] = [near(left, -1), near(right, 1)];
  let count = 0;
  for (const values of curves) {
    for (let k = first; k < last; k++) {
      if (values[k] === null || values[k + 1] === null) continue;
      const [a, b] = [u.valToPos(values[k], "y", true), u.valToPos(values[k + 1], "y", true)];
      if (Math.max(a, b) >= top && Math.min(a, b) <= bottom) count += 1;
    }
  }
  return count;
}

const meet = (a, b) => a[0] < b[1] && b[0] < a[1] && a[2] < b[3] && b[2] < a[3];

/** The box for a text along the level at `y` that hides the least: above rather than below, and as far right as possible. */
function boxAlong(u, y, width, height, taken) {
  const { bbox } = u;
  const STEPS = 8;
  let best = null;
  for (const top of [y - height, y]) {
    if (top < bbox.top || top + height > bbox.top + bbox.height) continue;
    for (let k = STEPS; k >= 0; k--) {
      const left = bbox.left + (k / STEPS) * (bbox.width - width);
      const box = [left, left + width, top, top + height];
      const cost = taken.some((other) => meet(box, other)) ? Infinity : hidden(u, box);
      if (!best || cost < best.cost) best = { box, cost };
      if (cost === 0) return box;
    }
  }
  return best?.box ?? [bbox.left, bbox.left + width, y, y + height];
}

function drawBounds(u, spec) {
  const { ctx, bbox } = u;
  const px = devicePixelRatio;
  const taken = [];
  ctx.save();
  ctx.font = `${11 * px}px system-ui, sans-serif`;
  ctx.lineWidth = px;
  for (const b of spec.bounds) {
    const y = u.valToPos(b.value, "y", true);
    if (y < bbox.top - 1 || y > bbox.top + bbox.height + 1) continue;
    ctx.strokeStyle = ctx.fillStyle = b.is_reference ? css("--soft") : css("--limit");
    ctx.setLineDash(b.is_reference ? [2 * px, 3 * px] : [7 * px, 4 * px]);
    ctx.beginPath();
    ctx.moveTo(bbox.left, y);
    ctx.lineTo(bbox.left + bbox.width, y);
    ctx.stroke();
    const level = spec.id === "margin" ? "" : ` ${number(b.value, 4)} ${spec.unit}`;
    const words = b.label + level;
    const box = boxAlong(u, y, ctx.measureText(words).width + 8 * px, 16 * px, taken);
    taken.push(box);
    ctx.textAlign = "left";
    ctx.textBaseline = "middle";
    const text = [words, box[0] + 4 * px, (box[2] + box[3]) / 2];
    // Legible over curves if there is no place beside them.
    ctx.setLineDash([]);
    ctx.strokeStyle = css("--paper");
    ctx.lineWidth = 3 * px;
    ctx.strokeText(...text);
    ctx.lineWidth = px;
    ctx.fillText(...text);
  }
  ctx.restore();
}

/** Draws events. */
function drawMarks(u) {
  const { ctx, bbox } = u;
  const px = devicePixelRatio;
  ctx.save();
  ctx.font = `${11 * px}px system-ui, sans-serif`;
  ctx.textBaseline = "top";
  for (const { t, label } of run().marks) {
    const x = u.valToPos(t, "x", true);
    if (x < bbox.left || x > bbox.left + bbox.width) continue;
    ctx.strokeStyle = ctx.fillStyle = css("--edge");
    ctx.lineWidth = px;
    ctx.setLineDash([3 * px, 2 * px]);
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    // Beside the line, on the side with room, and legible over curves.
    const fits = x + 6 * px + ctx.measureText(label).width < bbox.left + bbox.width;
    ctx.textAlign = fits ? "left" : "right";
    const text = [label, x + (fits ? 3 : -3) * px, bbox.top + 2 * px];
    ctx.setLineDash([]);
    ctx.strokeStyle = css("--paper");
    ctx.lineWidth = 3 * px;
    ctx.strokeText(...text);
    ctx.fillText(...text);
  }
  ctx.restore();
}

/** Height of a chart, and of the time axis below the last one of a column, px. */
const HEIGHT = 112;
const TIME = 44;
/** Px beside a chart for the names of its curves, and px of one such line. */
const BESIDE = { wide: 136, narrow: 98 };
const beside = (place) => (place.clientWidth < 420 ? BESIDE.narrow : BESIDE.wide);
const LINE = 13;
/** Numbers smaller than this share of the axis are shown as zero. */
const DUST = 1e-3;

/** Names of curves beside their ends, with the values of the instant shown, which `at` gives for a curve. */
function ends(made, plot, curves, at, below) {
  const place = element("div", { class: "ends" });
  made.root.querySelector(".u-wrap").append(place);
  const all = curves.map(({ label, stroke, dashes }) => {
    const mark = element("i", { "aria-hidden": "true" });
    mark.style.background = sample(stroke(), dashes);
    const value = element("b", {});
    const text = element("span", {}, mark, element("em", {}, label), value);
    text.title = label;
    place.append(text);
    return { text, value };
  });
  const more = element("span", { class: "more" });
  place.append(more);
  if (below) place.append(below);
  // Of many curves those that reach lowest are named, and a mark says how many are not.
  const lowest = (k) => Math.min(...made.data[k + 1].map((v) => v ?? Infinity));
  const order = all.map((_, k) => k).sort((a, b) => lowest(a) - lowest(b));
  function arrange() {
    const { bbox } = made;
    const px = devicePixelRatio;
    const [top, height] = [bbox.top / px, bbox.height / px];
    place.style.setProperty("--beside", `${beside(plot) - 6}px`);
    place.style.left = `${(bbox.left + bbox.width) / px + 6}px`;
    const free = height - (below ? 2 * LINE : 0);
    const fit = Math.max(Math.floor(free / LINE), 1);
    const count = all.length <= fit ? all.length : fit - 1;
    const named = order.slice(0, count);
    const last = (k) => made.data[k + 1].findLast((v) => v !== null) ?? 0;
    const wanted = named.map((k) => ({ k, y: made.valToPos(last(k), "y") + top }));
    wanted.sort((a, b) => a.y - b.y || a.k - b.k);
    let y = top - LINE / 2;
    wanted.forEach((w) => (w.y = y = Math.max(w.y, y + LINE)));
    let limit = top + free + LINE / 2 - (count < all.length ? LINE : 0);
    for (const w of [...wanted].reverse()) w.y = limit = Math.min(w.y, limit - LINE);
    all.forEach(({ text }, k) => (text.hidden = !named.includes(k)));
    for (const { k, y: middle } of wanted) all[k].text.style.top = `${middle - LINE / 2}px`;
    more.hidden = count === all.length;
    more.style.top = `${top + free - LINE}px`;
    more.textContent = `and ${all.length - count} more`;
    if (below) below.style.top = `${top + height - 2 * LINE + 2}px`;
  }
  const tell = (k) => all.forEach(({ value }, i) => (value.textContent = at(i, k)));
  return { arrange, tell };
}

function draw(spec, columns, place, isLast) {
  const room = bands(spec, columns);
  const many = spec.lines.length > 4;
  // Values far below a pixel are shown as zero.
  const clean = (u, v) => (v === null ? "–" : number(Math.abs(v) < DUST * (u.scales.y.max - u.scales.y.min) ? 0 : v, 3));
  // References are dotted, over the curves that follow them.
  const paired = spec.lines.some((l) => l.aim);
  const placeOf = (i) => spec.lines.slice(0, i + 1).filter((l) => !l.aim).length - 1;
  const dashes = (i) => (paired ? (spec.lines[i].aim ? [2, 5] : dash(placeOf(i))) : dash(i));
  const stroke = (i) => (spec.lines[i].aim ? css("--ink") : line(paired ? placeOf(i) : i));
  const curves = spec.lines.map((l, i) => ({ label: l.label, stroke: () => stroke(i), dashes: dashes(i) }));
  const series = [
    {},
    ...curves.map(({ label, stroke: color, dashes: pattern }, i) => ({
      label,
      stroke: color,
      width: paired && !spec.lines[i].aim ? 3 : many ? 1.25 : 1.75,
      dash: pattern,
      points: { show: false },
    })),
  ];
  const values = [columns.t, ...spec.lines.map((l) => columns[l.column])];
  const options = {
    padding: [8, () => beside(place), isLast ? 0 : 4, 0],
    scales: { x: { time: false }, y: { range: () => range(spec, columns, room) } },
    axes: [timeAxis(isLast ? {} : { size: 0, label: undefined, values: (_, splits) => splits.map(() => ""), ticks: { show: false } }), axis(null, { label: undefined, size: 52, space: 26 })],
    cursor: { sync: { key: "time" }, focus: { prox: 24 }, drag: { x: true, y: false } },
    focus: { alpha: 0.35 },
    legend: { show: false },
    hooks: { draw: [(u) => drawBounds(u, spec), drawMarks, () => named?.arrange()], setCursor: [() => show()] },
    series,
  };
  let named = null;
  if (room) {
    const edge = (label) => ({ label, stroke: () => css("--band-edge"), width: 1, points: { show: false } });
    series.push(edge(`${set().name}, largest`), edge(`${set().name}, smallest`));
    values.push(room.high, room.low);
    options.bands = [{ series: [series.length - 2, series.length - 1], fill: () => css("--band") }];
  }
  const made = chart(place, `${spec.title} over time in ${spec.unit}. ${spec.headline}.`, () => HEIGHT + (isLast ? TIME : 0), options, values);
  const alone = room && element("span", { class: "range" });
  named = ends(made, place, curves, (i, k) => clean(made, values[i + 1][k]), alone);
  made.over.addEventListener("click", () => {
    if (made.cursor.left >= 0) setTime(made.posToVal(made.cursor.left, "x"));
  });
  const mark = marker(made);
  const show = () => {
    const under = made.cursor.left >= 0 ? made.cursor.idx : null;
    const k = under ?? indexAt(columns.t, state.time);
    mark(state.time);
    named.tell(k);
    if (alone) alone.textContent = room.low[k] === null ? `${set().name}: none alone` : `${set().name} alone: ${clean(made, room.low[k])} to ${clean(made, room.high[k])}`;
  };
  made.over.addEventListener("mouseleave", () => setTimeout(show));
  made.hooks.setSize = [...(made.hooks.setSize ?? []), () => requestAnimationFrame(show)];
  named.arrange();
  return { spec, made, show, place, isLast };
}

function build() {
  const place = byId("charts");
  for (const d of drawn) d.made.remove();
  const { columns, charts } = run();
  // Two columns of charts, each with one time axis below its last chart.
  const half = Math.ceil(charts.length / 2);
  const parts = [charts.slice(0, half), charts.slice(half)].filter((part) => part.length > 0);
  place.replaceChildren();
  drawn = parts.flatMap((part) => {
    const column = element("div", { class: "column" });
    place.append(column);
    return part.map((spec, k) => {
      const plot = element("div", { class: "plot" });
      const title = element("h3", {}, `${spec.title} `, element("span", { class: "unit" }, `[${spec.unit}]`));
      column.append(element("figure", { id: `chart-${spec.id}` }, element("figcaption", {}, title, element("p", { class: "unit" }, spec.headline)), plot));
      return draw(spec, columns, plot, k === part.length - 1);
    });
  });
  show();
}

/** Redraws only the charts that depend on the selected mode. */
function redraw() {
  const { columns } = run();
  drawn = drawn.map((d) => {
    if (d.spec.axis === null) return d;
    d.made.remove();
    d.place.replaceChildren();
    return draw(d.spec, columns, d.place, d.isLast);
  });
  show();
}

const show = () => drawn.forEach((d) => d.show());

export function charts() {
  if (!byId("charts")) return;
  build();
  on("run", build);
  on("set", redraw);
  on("time", show);
  // The legends' samples do not change colour by themselves.
  on("theme", build);
}
