// Two flat views of the path, for browsers without WebGL.

import { Vector3 } from "three";
import { element } from "./content.js";
import { css } from "./palette.js";
import { plane } from "./plane.js";
import { flat as drawVolumes, reach } from "./volumes.js";

export function flat({ place, run, state, content, reached, wayShown }) {
  let colors = [];
  const view = (i, j, name, outline) => {
    const plot = element("div", { class: "plot" });
    place.append(element("figure", {}, element("figcaption", {}, element("h3", {}, name)), plot));
    const columns = () => [run().columns[i], run().columns[j]];
    const axes = { x: 0, y: 1, z: 2 };
    const near = () => {
      const { x, y, z } = run().columns;
      return reach([...x.map((v, k) => new Vector3(v, y[k], z[k])), ...content.waypoints.map((w) => new Vector3(...w.at))]);
    };
    return plane(plot, {
      name: `Path, ${name}`,
      labels: [`${i} [m]`, `${j} [m]`],
      equal: true,
      height: () => 340,
      box: () => {
        const ends = columns().map((values, k) => {
          const along = axes[k === 0 ? i : j];
          const all = [...values, ...content.waypoints.map((w) => w.at[along]), ...near().map((p) => p.getComponent(along)), ...reached().map((p) => p[along])];
          const [low, high] = [Math.min(...all), Math.max(...all)];
          const room = 0.06 * (high - low) + 0.2;
          return [low - room, high + room];
        });
        return [...ends[0], ...ends[1]];
      },
      draw: (pen) => {
        const [xs, ys] = columns();
        drawVolumes(pen, outline, [axes[i], axes[j]], run());
        for (const w of content.waypoints) {
          pen.circle([w.at[axes[i]], w.at[axes[j]]], w.within, { fill: css("--band"), stroke: css("--ink") });
        }
        for (let k = 0; k + 1 < xs.length; k++) {
          pen.line([[xs[k], ys[k]], [xs[k + 1], ys[k + 1]]], { stroke: colors[k], width: 3 });
        }
        const shown = wayShown();
        if (shown) pen.line(shown.points.map((p) => [p[axes[i]], p[axes[j]]]), { stroke: shown.color, width: 3, dash: [8, 4] });
        const k = Math.max(0, run().columns.t.findLastIndex((t) => t <= state.time));
        pen.dot([xs[k], ys[k]], { fill: css("--ink"), stroke: css("--paper"), radius: 6 });
      },
    });
  };
  const views = [view("x", "y", "from above", "above"), view("x", "z", "from the side", "side")];
  const again = () => views.forEach((v) => v.again());
  return {
    path: (given) => {
      colors = given;
      again();
    },
    time: again,
    theme: again,
    look: () => {},
    remove: () => views.forEach((v) => v.remove()),
  };
}
