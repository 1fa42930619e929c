// The state of the spec on a page that `mavc view` serves: what is wrong with it, what is being planned, and whether the page is of
// this text. A newer page is loaded in place of this one, and opens where the reader was.

import { byId, element } from "./content.js";
import { restore, store } from "./kept.js";

/** What the page says of each stage of the server. */
const WORDS = {
  planning: (hasPage) => (hasPage ? "Planning; below is the last plan" : "Planning"),
  error: (hasPage) => (hasPage ? "Errors; below is the last plan without errors" : "Errors"),
  current: () => "The page is of the spec as it is saved",
  gone: () => "The connection to mavc view is lost; start it again, and the page renews itself",
};

export function live() {
  const place = byId("live");
  if (!place) return;
  const number = Number(place.dataset.page);
  const words = element("b", {});
  const progress = element("span", { class: "progress" });
  const headline = element("p", { class: "verdict-line" });
  const diagnostics = element("pre", { class: "diagnostics", tabindex: "0", "aria-label": "Diagnostics" });
  const verdicts = element("pre", { tabindex: "0", "aria-label": "Table of modes" });
  const table = element("details", {}, element("summary", {}, "Table of modes"), verdicts);
  place.append(element("p", {}, words, " ", progress), headline, diagnostics, table);

  let began = 0;
  let clock = null;
  let said = "";
  const tick = () => {
    const seconds = Math.round((performance.now() - began) / 1000);
    progress.textContent = said || seconds > 0 ? `${said}${said ? ", " : ""}${seconds} s so far` : "";
  };
  function show(stage, status) {
    place.dataset.stage = stage;
    words.textContent = WORDS[stage](number > 0);
    document.body.classList.toggle("stale", stage !== "current" && number > 0);
    if (status) {
      said = status.progress;
      headline.textContent = status.headline;
      diagnostics.textContent = status.diagnostics;
      diagnostics.hidden = status.diagnostics === "";
      verdicts.textContent = status.verdicts;
      // The page of a plan has a table of its own.
      table.hidden = status.verdicts === "" || (stage === "current" && number > 0);
    }
    if (stage === "planning" && clock === null) {
      began = performance.now();
      clock = setInterval(tick, 1000);
    }
    if (stage !== "planning") {
      clearInterval(clock);
      clock = null;
      progress.textContent = "";
    } else tick();
  }

  let settle = restore();
  const source = new EventSource("/events");
  source.addEventListener("message", ({ data }) => {
    const status = JSON.parse(data);
    if (status.page !== number) {
      source.close();
      location.reload();
      return;
    }
    show(status.stage, status);
    settle();
    settle = () => {};
  });
  source.addEventListener("error", () => show("gone"));
  addEventListener("pagehide", store);
}
