// What a reader has set on a live page, which a new page of the same spec takes over: instant, mode, plan, camera, colours, theme,
// place in the text.

import { byId, content } from "./content.js";
import { setRun, setSet, setTime, state } from "./state.js";

const KEY = "mavc view";

/** Parts of the page with a state of their own: each has `now()` and `restore(state)`. */
const parts = {};

/** Keeps the state of a part of the page under a name. */
export function keep(name, part) {
  parts[name] = part;
}

/** Whether the reader has selected an instant: otherwise a page opens at its own. */
let chosen = false;
export const choose = () => (chosen = true);

/** Writes down the state, for the page that follows in this window. */
export function store() {
  const kept = {
    time: chosen ? state.time : undefined,
    set: content.sets[state.set]?.name,
    run: content.runs.length > 1 ? content.runs[state.run].label : undefined,
    theme: document.documentElement.dataset.theme,
    top: byId("main").getBoundingClientRect().top,
    open: [...document.querySelectorAll("details")].map((d) => d.open),
    colour: byId("colour")?.selectedOptions[0]?.textContent,
    parts: Object.fromEntries(Object.entries(parts).map(([name, part]) => [name, part.now()])),
  };
  try {
    sessionStorage.setItem(KEY, JSON.stringify(kept));
  } catch {
    // Without storage the new page opens as any other.
  }
}

/** Takes over the state of the page before, if there was one; returns what puts the text where it was, for when it moves. */
export function restore() {
  let kept;
  try {
    kept = JSON.parse(sessionStorage.getItem(KEY));
    sessionStorage.removeItem(KEY);
  } catch {
    kept = null;
  }
  if (!kept) return () => {};
  if (kept.theme && document.documentElement.dataset.theme !== kept.theme) byId("theme").click();
  const run = content.runs.findIndex((r) => r.label === kept.run);
  if (run >= 0) setRun(run);
  const set = content.sets.findIndex((s) => s.name === kept.set);
  if (kept.time !== undefined && set >= 0) setSet(set);
  if (kept.time !== undefined && content.runs.length > 0) {
    choose();
    setTime(kept.time);
  }
  const colour = byId("colour");
  const option = [...(colour?.options ?? [])].find((o) => o.textContent === kept.colour);
  if (option) {
    colour.value = option.value;
    colour.dispatchEvent(new Event("change"));
  }
  const details = [...document.querySelectorAll("details")];
  if (details.length === kept.open.length) details.forEach((d, i) => (d.open = kept.open[i]));
  for (const [name, was] of Object.entries(kept.parts)) if (was !== undefined && was !== null) parts[name]?.restore(was);
  // What is above the report may be higher or lower than before.
  const place = () => scrollBy(0, byId("main").getBoundingClientRect().top - kept.top);
  place();
  return place;
}
