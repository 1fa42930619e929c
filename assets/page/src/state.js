// What is shown: which plan, which mode's set, which instant. All views listen to changes.

import { content } from "./content.js";

const listeners = { run: [], time: [], set: [], way: [], theme: [] };

export const state = {
  run: content.first ?? 0,
  // The worst instant and set: see src/report/page/opening.rs.
  time: content.opens.t,
  set: content.opens.set,
  // The fault mode whose way out is drawn, an index into content.ways; null for none.
  way: null,
};

export const run = () => content.runs[state.run];
export const set = () => content.sets[state.set];

/** The way out after a fault of the chosen mode at the instant shown; undefined if there is none. */
export const way = () => content.ways?.[state.way]?.ways.find((w) => w.from <= state.time && state.time <= w.to);

export const duration = () => run().columns.t.at(-1);

/** Calls `listener` whenever `what` changes. */
export function on(what, listener) {
  listeners[what].push(listener);
}

export function tell(what) {
  for (const listener of listeners[what]) listener();
}

export function setTime(t) {
  state.time = Math.min(Math.max(t, 0), duration());
  tell("time");
}

export function setRun(index) {
  state.run = index;
  state.time = Math.min(state.time, duration());
  tell("run");
  tell("time");
}

export function setSet(index) {
  state.set = index;
  tell("set");
}

export function setWay(index) {
  state.way = index;
  tell("way");
}
