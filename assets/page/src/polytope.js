// Sections and chords of sets { w : n . w <= e, m . w = d }, rows [n_T, n_x, n_y, n_z, e] in widths of the healthy set.

const dot = (row, w) => row[0] * w[0] + row[1] * w[1] + row[2] * w[2] + row[3] * w[3];

/** The whole set, before it was shrunk about hover by the reserve. */
export function whole(set, hover, reserve) {
  const grown = ([a, b, c, d, e]) => {
    const at = dot([a, b, c, d], hover);
    return [a, b, c, d, at + (e - at) / (1 - reserve)];
  };
  return { ...set, rows: set.rows.map(grown) };
}

/** Sides of the polygons that stand for discs of torque. */
const SIDES = 48;

/** The core of a mode without yaw as a set: each row a T + b |(tau_x, tau_y)| <= e as the half-spaces around its discs; tau_z is free. */
export function coreOf(set) {
  const around = ([a, b, e]) =>
    b === 0
      ? [[a, 0, 0, 0, e]]
      : Array.from({ length: SIDES }, (_, k) => {
          const angle = (2 * Math.PI * k) / SIDES;
          return [a, b * Math.cos(angle), b * Math.sin(angle), 0, e];
        });
  return { ...set, rows: set.core.flatMap(around), equalities: [] };
}

/** The smallest margin of `w` in percent of the healthy set's width; negative outside. */
export function margin(set, w) {
  let least = Infinity;
  for (const row of set.rows) least = Math.min(least, row[4] - dot(row, w));
  for (const row of set.equalities) least = Math.min(least, -Math.abs(row[4] - dot(row, w)));
  return 100 * least;
}

/** The range [smallest, largest] of `axis`, the others as in `w`; null if no value of it is in the set. */
export function chord(set, w, axis) {
  let low = -Infinity;
  let high = Infinity;
  for (const row of set.rows) {
    const slack = row[4] - dot(row, w);
    if (row[axis] > 1e-12) high = Math.min(high, slack / row[axis]);
    else if (row[axis] < -1e-12) low = Math.max(low, slack / row[axis]);
    else if (slack < -1e-6) return null;
  }
  for (const row of set.equalities) {
    const gap = row[4] - dot(row, w);
    if (Math.abs(row[axis]) > 1e-12) {
      low = Math.max(low, gap / row[axis]);
      high = Math.min(high, gap / row[axis]);
    } else if (Math.abs(gap) > 1e-6) return null;
  }
  // Where planes meet in one point they do so up to rounding.
  if (low > high) return low - high < 1e-3 * Math.abs(w[axis]) + 1e-4 ? [w[axis] + (low + high) / 2, w[axis] + (low + high) / 2] : null;
  return [w[axis] + low, w[axis] + high];
}

/** The section through `w` along axes `i` and `j`: a polygon [[x, y], ...] inside `box` [x0, x1, y0, y1]; empty if there is none. */
export function section(set, w, i, j, box) {
  const [x0, x1, y0, y1] = box;
  let polygon = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
  const rest = (row) => row[4] - dot(row, w) + row[i] * w[i] + row[j] * w[j];
  const planes = set.rows.map((row) => [row[i], row[j], rest(row)]);
  for (const row of set.equalities) {
    planes.push([row[i], row[j], rest(row) + 1e-6], [-row[i], -row[j], -rest(row) + 1e-6]);
  }
  for (const [a, b, e] of planes) {
    polygon = clip(polygon, a, b, e);
    if (polygon.length === 0) break;
  }
  return polygon;
}

/** Clips a polygon to a x + b y <= e (Sutherland and Hodgman). */
function clip(polygon, a, b, e) {
  const kept = [];
  for (let k = 0; k < polygon.length; k++) {
    const p = polygon[k];
    const q = polygon[(k + 1) % polygon.length];
    const over = a * p[0] + b * p[1] - e;
    const next = a * q[0] + b * q[1] - e;
    if (over <= 0) kept.push(p);
    if ((over < 0 && next > 0) || (over > 0 && next < 0)) {
      const t = over / (over - next);
      kept.push([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]);
    }
  }
  return kept;
}
