// Light and dark theme: the system's until the button is pressed; always light in print.

import { fitAll } from "./axes.js";
import { byId } from "./content.js";
import { isDark } from "./palette.js";
import { tell } from "./state.js";

export function theme() {
  const root = document.documentElement;
  const button = byId("theme");
  const show = () => {
    button.textContent = isDark() ? "Light theme" : "Dark theme";
    tell("theme");
  };
  button.hidden = false;
  button.addEventListener("click", () => {
    root.dataset.theme = isDark() ? "light" : "dark";
    show();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", show);
  let chosen;
  let folded = [];
  addEventListener("beforeprint", () => {
    // Paper cannot be unfolded.
    folded = [...document.querySelectorAll("details:not([open])")];
    folded.forEach((part) => (part.open = true));
    chosen = root.dataset.theme;
    root.dataset.theme = "light";
    root.classList.add("printing");
    show();
    fitAll();
  });
  addEventListener("afterprint", () => {
    if (chosen === undefined) delete root.dataset.theme;
    else root.dataset.theme = chosen;
    root.classList.remove("printing");
    folded.forEach((part) => (part.open = false));
    show();
    fitAll();
  });
  button.textContent = isDark() ? "Light theme" : "Dark theme";
}
