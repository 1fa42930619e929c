import "uplot/dist/uPlot.min.css";
import "./page.css";
import { charts } from "./charts.js";
import { content } from "./content.js";
import { live } from "./live.js";
import { player } from "./player.js";
import { sets } from "./sets.js";
import { space } from "./space.js";
import { strips } from "./strips.js";
import { theme } from "./theme.js";
import { ways } from "./ways.js";

document.documentElement.classList.add("scripted");
theme();
if (content.runs.length > 0) {
  player();
  space();
  ways();
  strips();
  charts();
}
sets();
live();
