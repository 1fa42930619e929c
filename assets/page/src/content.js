// The data that the compiler wrote into the page; see src/report/page/content.rs.

export const content = JSON.parse(document.getElementById("content").textContent);

/** @returns {HTMLElement | null} */
export const byId = (id) => document.getElementById(id);

/** An element with attributes and children. */
export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/** Up to `digits` significant digits, with a true minus sign, and without an exponent for usual sizes. */
export function number(x, digits = 3) {
  if (x === null || x === undefined || !Number.isFinite(x)) return "–";
  if (x === 0) return "0";
  // As the compiler writes numbers: an exponent only for very small or large ones, and no trailing zeros.
  const [mantissa, exponent] = x.toExponential(digits - 1).split("e");
  const text = exponent >= -4 && exponent < 6 ? Number(x.toPrecision(digits)).toFixed(Math.max(digits - 1 - exponent, 0)) : mantissa;
  const short = text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  return (exponent >= -4 && exponent < 6 ? short : `${short}e${Number(exponent)}`).replaceAll("-", "\u2212");
}

/** A margin in percent, with its sign; below a hundredth of a percent it counts as zero. */
export function percent(x) {
  const near = Math.abs(x) < 0.01 ? 0 : x;
  return `${near > 0 ? "+" : ""}${number(near)} %`;
}

/** Seconds with two decimals. */
export const seconds = (t) => `${t.toFixed(2)} s`;

/** Index of the last instant at or before `t`. */
export function indexAt(times, t) {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** A column's value at `t`, linear between instants. */
export function valueAt(times, values, t) {
  const k = indexAt(times, t);
  if (k + 1 >= times.length) return values[k];
  const share = (t - times[k]) / (times[k + 1] - times[k]);
  return values[k] + (values[k + 1] - values[k]) * Math.min(Math.max(share, 0), 1);
}
