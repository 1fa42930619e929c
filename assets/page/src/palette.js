// Colours. Lines: Okabe and Ito's set; margins: ColorBrewer's RdYlBu. Colour-blind people can distinguish both; violations
// are hatched as well.

import { number } from "./content.js";

/** Classes of margins by their upper ends, in percent of the healthy set's width; the same as in the terminal. */
export const CLASSES = [
  { below: -0.01, name: "outside", color: "#c8281f" },
  { below: 2, name: "0 to 2 %", color: "#f48849" },
  { below: 5, name: "2 to 5 %", color: "#fbd57f" },
  { below: 10, name: "5 to 10 %", color: "#9cc7e0" },
  { below: Infinity, name: "10 % or more", color: "#4a78b5" },
];

/** Classes of distances, smallest first: the same colours without that of violations. */
const DISTANCES = CLASSES.slice(1).reverse();

/** The largest of 1, 2 and 5 times a power of ten that is at most `x`. */
export function round(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return [5, 2, 1].map((f) => f * power).find((v) => v <= x) ?? power;
}

/** Classes of distances up to `most` m, with round limits: `below` m, name and colour of each. */
export function distanceClasses(most) {
  const steps = [round(0.7 * most)];
  while (steps.length < DISTANCES.length - 1) steps.unshift(round(0.6 * steps[0]));
  const text = (m) => (m < 1 ? `${number(100 * m)} cm` : `${number(m)} m`);
  return DISTANCES.map(({ color }, i) => ({
    below: steps[i] ?? Infinity,
    color,
    name: i === 0 ? `below ${text(steps[0])}` : i < steps.length ? `${text(steps[i - 1])} to ${text(steps[i])}` : `${text(steps[i - 1])} or more`,
  }));
}

export const classOf = (margin) => CLASSES.find((c) => margin < c.below) ?? CLASSES.at(-1);

const LIGHT = ["#0072b2", "#d55e00", "#007a5a", "#a8468a", "#8a6d00", "#3b6fd1", "#9c3d10", "#4d4d4d"];
const DARK = ["#5ab4ee", "#ff9a4d", "#3fd0a4", "#e79bcd", "#e6c84a", "#9ab8ff", "#ff8f66", "#c4c4c4"];
const DASHES = [[], [7, 3], [2, 3], [9, 3, 2, 3]];

export const isDark = () => getComputedStyle(document.documentElement).getPropertyValue("--is-dark").trim() === "1";

/** The colour of the i-th line. */
export const line = (i) => (isDark() ? DARK : LIGHT)[i % LIGHT.length];

/** Its dashes: lines differ by more than colour, and lines of the same colour have different dashes. */
export const dash = (i) => DASHES[(i + Math.floor(i / LIGHT.length)) % DASHES.length];

/** A sample of a line as a background. */
export function sample(color, dashes) {
  let at = 0;
  const stops = dashes.map((length, k) => `${k % 2 === 0 ? color : "transparent"} ${at}px ${(at += length)}px`);
  return stops.length === 0 ? color : `repeating-linear-gradient(90deg, ${stops.join(", ")})`;
}

/** A colour of the style sheet, such as `--ink`. */
export const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
