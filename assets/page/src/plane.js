// A plane with equal or free scales, drawn by hand over uPlot's axes.

import { axis, chart } from "./axes.js";
import { css } from "./palette.js";

/** Px of a chart taken by axes, their labels and padding: see `axis` and the options below. */
const AROUND = { true: { x: 4, y: 4 }, false: { x: 48 + 18 + 12, y: 30 + 18 + 8 } };

/**
 * @param place the element to draw into
 * @param options name, labels [x, y], box() -> [x0, x1, y0, y1], equal, height() in px, draw(pen), plain (without axes), move(x, y)
 */
export function plane(place, options) {
  const { name, labels, box, equal = false, height, draw, plain = false, move } = options;
  const range = (axisIndex) => () => {
    const [x0, x1, y0, y1] = box();
    if (!equal) return axisIndex === 0 ? [x0, x1] : [y0, y1];
    // The same scale in both directions.
    const wide = Math.max(place.clientWidth - AROUND[plain].x, 1);
    const high = Math.max(height() - AROUND[plain].y, 1);
    const per = Math.max((x1 - x0) / wide, (y1 - y0) / high);
    const [middle, size] = axisIndex === 0 ? [(x0 + x1) / 2, wide] : [(y0 + y1) / 2, high];
    return [middle - (per * size) / 2, middle + (per * size) / 2];
  };
  const hidden = { show: false };
  const made = chart(place, name, height, {
    legend: { show: false },
    padding: plain ? [2, 2, 2, 2] : [8, 12, 0, 0],
    cursor: { show: Boolean(move), drag: { x: false, y: false }, points: { show: false } },
    scales: { x: { time: false, range: range(0) }, y: { range: range(1) } },
    axes: plain ? [hidden, hidden] : [axis(labels[0], { size: 30 }), axis(labels[1])],
    series: [{}, { points: { show: false }, paths: () => null }],
    hooks: {
      draw: [(u) => draw(pen(u))],
      setCursor: move ? [(u) => u.cursor.left >= 0 && move(u.posToVal(u.cursor.left, "x"), u.posToVal(u.cursor.top, "y"))] : [],
    },
  }, [[0, 1], [null, null]]);
  const again = () => {
    made.setScale("x", {});
    made.setScale("y", {});
    made.redraw(false, true);
  };
  return { made, again: () => made.batch(again), remove: made.remove };
}

/** Draws in the chart's units. */
function pen(u) {
  const { ctx } = u;
  const px = devicePixelRatio;
  const at = ([x, y]) => [u.valToPos(x, "x", true), u.valToPos(y, "y", true)];
  const trace = (points, closes) => {
    ctx.beginPath();
    points.forEach((p, i) => (i === 0 ? ctx.moveTo(...at(p)) : ctx.lineTo(...at(p))));
    if (closes) ctx.closePath();
  };
  /** The ends of the part of a segment within the chart (Liang and Barsky); null if there is none. */
  const shown = (p, q) => {
    const { left, top, width, height } = u.bbox;
    const frame = [[left, left + width], [top, top + height]];
    const [a, b] = [at(p), at(q)];
    let [from, to] = [0, 1];
    for (const i of [0, 1]) {
      const d = b[i] - a[i];
      const ends = frame[i].map((v) => (v - a[i]) / d);
      if (d === 0 && (a[i] < frame[i][0] || a[i] > frame[i][1])) to = -1;
      if (d !== 0) [from, to] = [Math.max(from, Math.min(...ends)), Math.min(to, Math.max(...ends))];
    }
    const point = (t) => [0, 1].map((i) => p[i] + t * (q[i] - p[i]));
    return from <= to ? { a: point(from), b: point(to) } : null;
  };
  const within = (work) => {
    ctx.save();
    ctx.beginPath();
    ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
    ctx.clip();
    work();
    ctx.restore();
  };
  return {
    polygon: (points, { fill, stroke, width = 1, dash = [] }) =>
      points.length > 2 &&
      within(() => {
        trace(points, true);
        if (fill) {
          ctx.fillStyle = fill;
          ctx.fill();
        }
        if (stroke) {
          ctx.strokeStyle = stroke;
          ctx.lineWidth = width * px;
          ctx.setLineDash(dash.map((d) => d * px));
          ctx.stroke();
        }
      }),
    line: (points, { stroke, width = 1, dash = [] }) =>
      within(() => {
        trace(points, false);
        ctx.strokeStyle = stroke;
        ctx.lineWidth = width * px;
        ctx.lineJoin = "round";
        ctx.setLineDash(dash.map((d) => d * px));
        ctx.stroke();
      }),
    dot: (point, { radius = 5, fill, stroke }) => {
      ctx.save();
      ctx.beginPath();
      ctx.arc(...at(point), radius * px, 0, 2 * Math.PI);
      ctx.fillStyle = fill;
      ctx.fill();
      ctx.strokeStyle = stroke;
      ctx.lineWidth = 1.5 * px;
      ctx.stroke();
      ctx.restore();
    },
    /** A circle of a radius in the chart's units. */
    circle: (point, radius, { fill, stroke }) => {
      const [x, y] = at(point);
      const size = Math.abs(u.valToPos(point[0] + radius, "x", true) - x);
      ctx.save();
      ctx.beginPath();
      ctx.arc(x, y, Math.max(size, 2.5 * px), 0, 2 * Math.PI);
      if (fill) {
        ctx.fillStyle = fill;
        ctx.fill();
      }
      ctx.strokeStyle = stroke;
      ctx.lineWidth = px;
      ctx.stroke();
      ctx.restore();
    },
    diamond: (point, { fill, stroke }) => {
      const [x, y] = at(point);
      const r = 5 * px;
      ctx.save();
      ctx.beginPath();
      for (const [dx, dy] of [[r, 0], [0, r], [-r, 0], [0, -r]]) ctx.lineTo(x + dx, y + dy);
      ctx.closePath();
      ctx.fillStyle = fill;
      ctx.fill();
      ctx.strokeStyle = stroke;
      ctx.lineWidth = 1.5 * px;
      ctx.stroke();
      ctx.restore();
    },
    /** Words beside a point, kept within the chart. */
    text: (point, words, { fill }) =>
      within(() => {
        const { left, top, width, height } = u.bbox;
        ctx.font = `${11 * px}px system-ui, sans-serif`;
        ctx.textAlign = "left";
        ctx.textBaseline = "bottom";
        const wide = ctx.measureText(words).width;
        const [x, y] = at(point);
        const x0 = Math.min(Math.max(x - wide / 2, left + 3 * px), left + width - wide - 3 * px);
        const y0 = Math.min(Math.max(y - 2 * px, top + 14 * px), top + height - 3 * px);
        ctx.strokeStyle = css("--paper");
        ctx.lineWidth = 3 * px;
        ctx.strokeText(words, x0, y0);
        ctx.fillStyle = fill;
        ctx.fillText(words, x0, y0);
      }),
    /** The part of a segment that the chart shows, empty if it shows none. */
    visible: (line) => {
      const ends = shown(line[0], line[1]);
      return ends ? [ends.a, ends.b] : [];
    },
    /** The highest point of a line that the chart shows; null if it shows none. */
    top: (line) => {
      let best = null;
      line.slice(1).forEach((end, k) => {
        const ends = shown(line[k], end);
        for (const p of ends ? [ends.a, ends.b] : []) if (!best || p[1] > best[1]) best = p;
      });
      return best;
    },
    cross: (point, stroke) => {
      const [x, y] = at(point);
      const r = 5 * px;
      ctx.save();
      ctx.strokeStyle = stroke;
      ctx.lineWidth = 1.25 * px;
      ctx.beginPath();
      ctx.moveTo(x - r, y);
      ctx.lineTo(x + r, y);
      ctx.moveTo(x, y - r);
      ctx.lineTo(x, y + r);
      ctx.stroke();
      ctx.restore();
    },
  };
}
