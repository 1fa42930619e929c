// Shared by all uPlot charts: axes in the page's colours, fitting widths, the legend's numbers.

import uPlot from "uplot";
import { number } from "./content.js";
import { css } from "./palette.js";

const FONT = '12px system-ui, "Segoe UI", Roboto, Helvetica, Arial, sans-serif';

/** @type {Set<() => void>} */
const fits = new Set();

/** Fits everything that is drawn to the width of its place. */
export const fitAll = () => fits.forEach((fit) => fit());

/** Calls `fit` whenever everything is fitted; returns a function that stops this. */
export function whenFitting(fit) {
  fits.add(fit);
  return () => fits.delete(fit);
}

export const axis = (label, more = {}) => ({
  stroke: () => css("--soft"),
  grid: { stroke: () => css("--grid"), width: 1 },
  ticks: { stroke: () => css("--grid"), width: 1, size: 4 },
  font: FONT,
  labelFont: FONT,
  size: 48,
  gap: 4,
  labelSize: 18,
  label,
  values: (_, splits) => splits.map((v) => (v === null ? "" : number(v, 6))),
  ...more,
});

export const timeAxis = (more = {}) => axis("time [s]", { size: 30, ...more });

/** Draws a chart named `name` into `place` and keeps it as wide as that. Returns the chart with a method `remove`. */
export function chart(place, name, height, options, values) {
  const size = () => ({ width: Math.max(Math.floor(place.clientWidth), 120), height: height() });
  const made = new uPlot({ ...size(), ...options }, values, place);
  const wrap = made.root.querySelector(".u-wrap");
  wrap.setAttribute("role", "img");
  wrap.setAttribute("aria-label", name);
  const fit = () => {
    const now = size();
    if (now.width !== made.width || now.height !== made.height) made.setSize(now);
  };
  const forget = whenFitting(fit);
  const watch = new ResizeObserver(fit);
  watch.observe(place);
  const remove = () => {
    forget();
    watch.disconnect();
    made.destroy();
  };
  return Object.assign(made, { remove });
}

/** Adds a line over the chart that marks an instant; returns a function that moves it. */
export function marker(made) {
  const mark = document.createElement("div");
  mark.className = "now";
  made.over.append(mark);
  return (t) => {
    mark.style.left = `${made.valToPos(t, "x")}px`;
  };
}
