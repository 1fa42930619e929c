// The instant shown: slider, playback, choice of the plan.

import { byId, content, element, seconds } from "./content.js";
import { choose } from "./kept.js";
import { duration, on, setRun, setTime, state } from "./state.js";

/** Playback runs in real time, but takes no longer than this, s. */
const LONGEST = 30;

export function player() {
  const bar = byId("player");
  if (!bar) return;
  const [slider, clock, play, choice] = ["time", "clock", "play", "run"].map(byId);
  let playing = null;
  // Until the reader selects an instant, playback begins at the start and not where the page opened.
  let chosen = false;
  const stop = () => {
    cancelAnimationFrame(playing);
    playing = null;
    play.textContent = "Play";
    play.setAttribute("aria-label", "Play");
  };
  const start = () => {
    const rate = Math.max(1, duration() / LONGEST);
    if (!chosen || state.time >= duration()) setTime(0);
    let last = performance.now();
    const frame = (now) => {
      setTime(state.time + (rate * (now - last)) / 1000);
      last = now;
      if (state.time >= duration()) stop();
      else playing = requestAnimationFrame(frame);
    };
    playing = requestAnimationFrame(frame);
    play.textContent = "Pause";
    play.setAttribute("aria-label", "Pause");
  };
  const show = () => {
    slider.max = String(duration());
    slider.value = String(state.time);
    slider.setAttribute("aria-valuetext", seconds(state.time));
    clock.textContent = `${state.time.toFixed(2)} / ${duration().toFixed(2)} s`;
  };
  bar.hidden = false;
  slider.addEventListener("input", () => setTime(Number(slider.value)));
  // With step "any", not every browser supports the arrow keys.
  slider.addEventListener("keydown", (event) => {
    const step = duration() / 200;
    const by = { ArrowLeft: -step, ArrowDown: -step, ArrowRight: step, ArrowUp: step, PageDown: -10 * step, PageUp: 10 * step }[event.key];
    const to = { Home: 0, End: duration() }[event.key];
    if (by === undefined && to === undefined) return;
    event.preventDefault();
    setTime(to ?? state.time + by);
  });
  play.addEventListener("click", () => (playing === null ? start() : stop()));
  content.runs.forEach((r, i) => choice.append(element("option", { value: String(i) }, r.label)));
  choice.value = String(state.run);
  choice.addEventListener("change", () => setRun(Number(choice.value)));
  if (content.runs.length < 2) byId("run-label").hidden = true;
  on("time", () => {
    chosen = true;
    choose();
    show();
  });
  on("run", show);
  show();
}
