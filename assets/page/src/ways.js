// The way out after a fault: of the mode that a list or a strip chooses, at the instant shown.

import { byId, content, element, seconds } from "./content.js";
import { css } from "./palette.js";
import { duration, on, setTime, setWay, state, way } from "./state.js";

/** Colours of outcomes, those of the strips; see page.css. */
const COLORS = ["--good", "--good", "--accent", "--accent"];

/** The way out that is drawn: its colour and its points; null if none is. */
export function wayShown() {
  const shown = way();
  return shown ? { color: css(COLORS[shown.order]), points: shown.x.map((x, k) => [x, shown.y[k], shown.z[k]]) } : null;
}

/** All points of all ways out: views leave room for them. */
export const reached = () => (content.ways ?? []).flatMap(({ ways }) => ways.flatMap(({ x, y, z }) => x.map((v, k) => [v, y[k], z[k]])));

const SVG = "http://www.w3.org/2000/svg";

/** Marks the instant shown on every strip. */
function marks(strips) {
  const lines = strips.map((strip) => {
    const line = document.createElementNS(SVG, "line");
    line.setAttribute("class", "now");
    line.setAttribute("y2", "100%");
    strip.append(line);
    return [line, strip.viewBox.baseVal.width];
  });
  return () => lines.forEach(([line, width]) => ["x1", "x2"].forEach((end) => line.setAttribute(end, String((width * state.time) / duration()))));
}

function words() {
  if (state.way === null) return "Choose a fault, or click a strip: its way out is drawn in the picture of the path.";
  const shown = way();
  const of = `Fault ${content.ways[state.way].name} at ${seconds(state.time)}`;
  if (!shown) return `${of}: no way out was found.`;
  return `${of}: ${shown.words}; drawn from ${seconds(shown.begins)} to ${seconds(shown.ends)}, for a fault at ${seconds(shown.fault)}.`;
}

export function ways() {
  const section = byId("after-fault");
  const strips = [...document.querySelectorAll("svg.ways")];
  if (!section || !content.ways || strips.length === 0) return;
  const choice = element("select", { id: "way" }, element("option", { value: "" }, "none"));
  content.ways.forEach(({ name, ways: found }, i) => {
    if (found.length > 0) choice.append(element("option", { value: String(i) }, name));
  });
  const readout = element("p", { class: "readout", id: "way-readout", "aria-live": "polite" });
  section.querySelector(".legend").after(element("p", {}, element("label", { for: "way" }, "Way out after "), choice), readout);
  const mark = marks(strips);
  const show = () => {
    choice.value = state.way === null ? "" : String(state.way);
    readout.textContent = words();
    mark();
  };
  choice.addEventListener("change", () => setWay(choice.value === "" ? null : Number(choice.value)));
  for (const strip of strips) {
    strip.addEventListener("click", (event) => {
      const box = strip.getBoundingClientRect();
      const mode = Number(strip.dataset.mode);
      setWay(content.ways[mode].ways.length > 0 ? mode : null);
      setTime((duration() * (event.clientX - box.left)) / box.width);
    });
  }
  for (const what of ["way", "time", "run"]) on(what, show);
  show();
}
