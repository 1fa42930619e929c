// What the page does when it is used: the slider, the choices, the keys, and that its numbers are the compiler's.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { open, shots, text } from "./browser.mjs";

test("a page opens at the worst instant and mode, and plays from the start", async () => {
  await open("plan", {}, async (page) => {
    const [at] = (await text(page, "#clock")).match(/[\d.]+/g).map(Number);
    assert.ok(Math.abs(at - 15.12) < 0.05, `opens at ${at} s`);
    const worst = (await text(page, "#strips-headline")).match(/smallest spare is \u2212([\d.]+)\s%/)[1];
    assert.match(await text(page, "#sets-headline"), /the planned wrench is outside the set of M1, by 1\d/);
    assert.ok((await text(page, "#sets-headline")).includes(`by ${worst} %`), worst);
    assert.ok((await text(page, "#room caption")).includes("M1"));
    // From the start: an instant before that at which the page opened.
    await page.locator("#play").press("Enter");
    await page.waitForFunction((before) => {
      const now = parseFloat(document.getElementById("clock").textContent);
      return now > 0.05 && now < before;
    }, at);
    await page.locator("#play").press("Enter");
  });
  // A flight: its largest position error, and the fault in force then.
  await open("flight", {}, async (page) => {
    const [at] = (await text(page, "#clock")).match(/[\d.]+/g).map(Number);
    const { columns } = await page.evaluate(() => JSON.parse(document.getElementById("content").textContent).runs[0]);
    const worst = columns.t[columns.error.indexOf(Math.max(...columns.error))];
    assert.ok(Math.abs(at - worst) < 0.006, `${at} s, worst ${worst} s`);
  });
});

test("the slider moves the wrench through the set, by keys", () =>
  open("plan", {}, async (page) => {
    const headline = await text(page, "#sets-headline");
    const room = await text(page, "#room");
    const picture = () => page.locator("#sections canvas").first().evaluate((c) => c.toDataURL());
    const drawn = await picture();
    const space = () => page.locator("#space canvas").evaluate((c) => c.toDataURL());
    const flight = await space();
    await page.locator("#time").focus();
    await page.keyboard.press("Home");
    for (let i = 0; i < 9; i++) await page.keyboard.press("PageUp");
    await page.waitForTimeout(200);
    assert.match(await text(page, "#clock"), /^7\.20 \/ 16\.00 s$/);
    assert.match(await text(page, "#sets-headline"), /^At 7\.20 s the planned wrench is inside the set of M1/);
    assert.notEqual(await text(page, "#sets-headline"), headline);
    assert.notEqual(await text(page, "#room"), room);
    assert.notEqual(await picture(), drawn);
    assert.notEqual(await space(), flight);
    assert.match(await text(page, "#space-readout"), /^At 7\.20 s: x /);
    await page.keyboard.press("End");
    assert.match(await text(page, "#clock"), /^16\.00/);
    // At 15.12 s the plan is farthest outside.
    await page.locator("#time").evaluate((s) => {
      s.value = "15.12";
      s.dispatchEvent(new Event("input"));
    });
    assert.match(await text(page, "#sets-headline"), /outside the set of M1, by 1\d(\.\d)? % of the healthy width/);
  }));

test("what the page says of an instant is what the compiler says", () =>
  open("plan", {}, async (page) => {
    // The margin that the script takes from the rows, against the column that the compiler wrote.
    const { columns } = await page.evaluate(() => JSON.parse(document.getElementById("content").textContent).runs[0]);
    for (const k of [0, 57, 200, columns.t.length - 1]) {
      await page.locator("#time").evaluate((s, t) => {
        s.value = String(t);
        s.dispatchEvent(new Event("input"));
      }, columns.t[k]);
      const said = (await text(page, "#room caption")).match(/spare ([+\u2212]?[\d.]+) %/)[1].replace("\u2212", "-");
      assert.ok(Math.abs(Number(said) - columns.margin_1[k]) < 0.06, `${said} ${columns.margin_1[k]}`);
    }
  }));

test("plans, modes and sections can be chosen, and the strip leads to an instant", () =>
  open("compare", {}, async (page) => {
    const before = await text(page, "#charts");
    await page.selectOption("#run", { index: 0 });
    assert.notEqual(await text(page, "#charts"), before);
    // The three planners at one time lead; the other plans are folded.
    const titles = (selector) => page.locator(`#strips ${selector} h3`).allTextContents();
    assert.deepEqual(await titles("> figure"), ["RIP, common time 16 s", "RCP M1, common time 16 s", "RSP, common time 16 s"]);
    assert.deepEqual(await titles("details figure"), ["RIP, own time 15.55 s", "RCP M1, own time 16 s", "RSP, own time 16 s"]);
    await page.selectOption("#run", { label: "RIP, common time 16 s" });
    await page.selectOption("#set", "3");
    assert.match(await text(page, "#sets-headline"), /M3/);
    assert.equal(await page.locator(".multiple[aria-pressed=true] .name").textContent(), "M3");
    await page.selectOption("#plane", "hover");
    assert.match(await text(page, "#sets-note"), /T = m g/);
    const strip = page.locator("#strips .u-over").first();
    await strip.scrollIntoViewIfNeeded();
    const box = await strip.boundingBox();
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    const [now, end] = (await text(page, "#clock")).match(/[\d.]+/g).map(Number);
    assert.ok(Math.abs(now - end / 2) < 0.2, `${now} of ${end}`);
  }));

test("a flight is shown beside its plan", () =>
  open("flight", {}, async (page) => {
    assert.match(await text(page, "#found"), /Simulated to its end/);
    assert.match(await text(page, "#chart-estimates"), /M3 is isolated after/);
    assert.match(await text(page, "#chart-yaw"), /^Heading \[deg\]The heading error is .*\sdeg root mean square; largest .*heading planned/s);
    const flown = await text(page, "#chart-position");
    await page.selectOption("#run", { index: 1 });
    assert.notEqual(await text(page, "#chart-position"), flown);
  }));

test("a flight's path is coloured by its faults, and by how far off it is", () =>
  open("flight", {}, async (page) => {
    const entries = () => page.locator("#space-legend .entry").allTextContents();
    const picture = () => page.locator("#space canvas").evaluate((c) => c.toDataURL());
    assert.deepEqual(await entries(), ["no fault", "M3 undetected", "M3 detected"]);
    const faults = await picture();
    await page.selectOption("#colour", { label: "position error" });
    await page.waitForTimeout(200);
    assert.deepEqual(await entries(), ["below 2 cm", "2 cm to 5 cm", "5 cm to 10 cm", "10 cm or more"]);
    assert.notEqual(await picture(), faults);
    // In words too, for whom colours say nothing.
    await page.locator("#time").evaluate((s) => {
      s.value = "12";
      s.dispatchEvent(new Event("input"));
    });
    assert.match(await text(page, "#space-readout"), /position error .*\scm; shown without rotor 3; M3 detected$/);
    assert.match(await text(page, "#strips-headline"), /^The plan \(RIP, 30 s\): the smallest spare is/);
  }));

test("hovering a chart reads its curves", () =>
  open("plan", {}, async (page) => {
    const over = page.locator("#chart-speed .u-over");
    await over.scrollIntoViewIfNeeded();
    const value = () => text(page, "#chart-speed .ends span:first-child b");
    const before = await value();
    await over.hover({ position: { x: 150, y: 60 } });
    await page.waitForTimeout(100);
    assert.notEqual(await value(), before);
  }));

test("the theme can be turned over, and paper is light", () =>
  open("plan", { theme: "dark" }, async (page) => {
    const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    await page.locator("#theme").press("Enter");
    assert.equal(await paper(), "rgb(255, 255, 255)");
    await page.locator("#theme").press("Enter");
    assert.equal(await paper(), "rgb(20, 23, 27)");
    await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
    assert.equal(await paper(), "rgb(255, 255, 255)");
    await page.evaluate(() => dispatchEvent(new Event("afterprint")));
    assert.equal(await paper(), "rgb(20, 23, 27)");
    const pdf = await page.pdf({ format: "A4" });
    assert.ok(pdf.length > 50_000);
    if (shots) writeFileSync(join(shots, "plan.pdf"), pdf);
  }));

test("the spare of an instant is the same wherever it is told", () =>
  open("plan", {}, async (page) => {
    for (const t of ["0.3", "7.77", "15.12"]) {
      await page.locator("#time").evaluate((s, value) => {
        s.value = value;
        s.dispatchEvent(new Event("input"));
      }, t);
      const told = [
        (await text(page, "#strips .readout")).match(/M1 (.* %)/)[1],
        (await text(page, "#space-readout")).match(/spare (.* %) in M1/)[1],
        (await text(page, "#room caption")).match(/spare (.* %)/)[1],
      ];
      assert.deepEqual(new Set(told).size, 1, told.join(", "));
    }
  }));

test("space is turned by keys", () =>
  open("plan", {}, async (page) => {
    const picture = () => page.locator("#space canvas").evaluate((c) => c.toDataURL());
    const before = await picture();
    await page.locator("#space").focus();
    await page.keyboard.press("ArrowLeft");
    await page.waitForTimeout(200);
    assert.notEqual(await picture(), before);
  }));

test("playing moves time", () =>
  open("plan", {}, async (page) => {
    const clock = () => page.evaluate(() => parseFloat(document.getElementById("clock").textContent));
    await page.locator("#play").press("Enter");
    await page.waitForFunction(() => parseFloat(document.getElementById("clock").textContent) > 0.05);
    await page.locator("#play").press("Enter");
    const stopped = await clock();
    await page.waitForTimeout(300);
    assert.equal(await clock(), stopped);
  }));

test("volumes are drawn in space and in the flat views", async () => {
  for (const browser of ["webgl", "flat"]) {
    await open("volumes", { browser }, async (page) => {
      assert.match(await text(page, "#space-note"), /Keep-outs are filled, keep-ins outlined/);
      const canvas = page.locator("#space canvas").first();
      // Pixels that are rather red than grey, blue or green: the filled keep-outs.
      const red = await canvas.evaluate((c) => {
        const copy = new OffscreenCanvas(c.width, c.height);
        const pen = copy.getContext("2d", { willReadFrequently: true });
        pen.fillStyle = "white";
        pen.fillRect(0, 0, c.width, c.height);
        pen.drawImage(c, 0, 0);
        const { data } = pen.getImageData(0, 0, c.width, c.height);
        let count = 0;
        for (let i = 0; i < data.length; i += 4) count += data[i] > data[i + 1] + 15 && data[i] > data[i + 2] + 15 && data[i] > 150;
        return count;
      });
      assert.ok(red > 1000, `${browser}: ${red}`);
      if (browser === "webgl") {
        const labels = await page.locator("#space .labels span").allTextContents();
        for (const name of ["keep_in field", "keep_out mast", "keep_out shed"]) assert.ok(labels.includes(name), labels.join());
        assert.ok(labels.some((l) => /from keep_out mast$/.test(l)), labels.join());
      }
      assert.match(await text(page, "#volumes h2"), /^The vehicle keeps .* from keep_/);
    });
  }
});

test("the way out at the instant chosen is drawn, in space and in the flat views", async () => {
  for (const browser of ["webgl", "flat"]) {
    await open("ways", { browser }, async (page) => {
      // Pixels in the colour of landings at a site, over both flat views.
      const drawn = async () => {
        // Pictures are drawn in the next frame.
        await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
        return page.evaluate(() => {
          const css = getComputedStyle(document.documentElement).getPropertyValue("--accent").trim();
          const pen = new OffscreenCanvas(1, 1).getContext("2d");
          pen.fillStyle = css;
          pen.fillRect(0, 0, 1, 1);
          const want = pen.getImageData(0, 0, 1, 1).data;
          let count = 0;
          for (const c of document.querySelectorAll("#space canvas")) {
            const copy = new OffscreenCanvas(c.width, c.height).getContext("2d", { willReadFrequently: true });
            copy.drawImage(c, 0, 0);
            const { data } = copy.getImageData(0, 0, c.width, c.height);
            for (let i = 0; i < data.length; i += 4) count += data[i + 3] > 250 && [0, 1, 2].every((k) => Math.abs(data[i + k] - want[k]) < 4);
          }
          return count;
        });
      };
      const before = await drawn();
      assert.match(await text(page, "#way-readout"), /^Choose a fault/);
      await page.selectOption("#way", { label: "M1" });
      assert.match(await text(page, "#way-readout"), /^Fault M1 at .* lands at pad; drawn from /);
      assert.ok((await drawn()) > before + 100, `${browser}: ${before}, then ${await drawn()}`);
      // A click on a strip chooses its mode and the instant.
      const strip = page.locator("svg.ways").nth(1);
      await strip.scrollIntoViewIfNeeded();
      const box = await strip.boundingBox();
      await page.mouse.click(box.x + 0.1 * box.width, box.y + box.height / 2);
      const [now, end] = (await text(page, "#clock")).match(/[\d.]+/g).map(Number);
      assert.ok(Math.abs(now - 0.1 * end) < 0.2, `${now} of ${end}`);
      assert.match(await text(page, "#way-readout"), /^Fault M4 at 0\.\d+ s: lands at pad/);
      // In a gap nothing is drawn.
      const gap = await page.evaluate(() => {
        const { ways } = JSON.parse(document.getElementById("content").textContent).ways[1];
        const k = ways.findIndex((w, i) => i > 0 && w.from > ways[i - 1].to + 0.1);
        return k < 0 ? null : (ways[k].from + ways[k - 1].to) / 2;
      });
      assert.ok(gap, "the mission has no gap");
      await page.mouse.click(box.x + (gap / end) * box.width, box.y + box.height / 2);
      assert.match(await text(page, "#way-readout"), /no way out was found/);
      assert.ok((await drawn()) <= before + 20, `${browser}: ${await drawn()} in a gap`);
      await page.selectOption("#way", { label: "none" });
      assert.match(await text(page, "#way-readout"), /^Choose a fault/);
    });
  }
});

test("an analysis marks the rotors that each mode takes, without a mission too", async () => {
  await open("analysis", {}, async (page) => {
    const headline = await text(page, ".headline");
    assert.match(headline, /^survey_hexa: any single rotor lost: 4 of 6 full control/);
    assert.equal(await page.title(), headline);
    // Six modes, each with one rotor of six crossed out, in the row with its name.
    const views = await page.evaluate(() =>
      [...document.querySelectorAll("#outcomes svg")].map((view) => ({
        label: view.getAttribute("aria-label"),
        lost: [...view.querySelectorAll(".rotor")].flatMap((rotor, k) => (rotor.matches(".lost") ? [k + 1] : [])),
        row: view.closest("th").firstChild.data,
      })),
    );
    assert.equal(views.length, 6);
    for (const { label, lost, row } of views) {
      const [, mode, rotor] = label.match(/^(M\d): rotor (\d) lost$/);
      assert.deepEqual(lost, [Number(rotor)]);
      assert.equal(`M${rotor}`, mode);
      assert.ok(row.includes(mode), `${row}: ${mode}`);
    }
    // The nose is up and y to the left: rotor 1 is at the left of rotor 4.
    const at = await page.evaluate(() => [...document.querySelectorAll("#airframe .rotor")].map((rotor) => Number(rotor.getAttribute("cx"))));
    assert.ok(at.length === 6 && at[0] < at[3], at);
  });
  await open("coaxial", { width: 390 }, async (page) => {
    const marks = await page.evaluate(() => Object.fromEntries(["lost", "weak"].map((kind) => [kind, document.querySelectorAll(`#outcomes .${kind}`).length])));
    // Eight single losses and one of two; one rotor reduced and one stuck.
    assert.deepEqual(marks, { lost: 10, weak: 2 });
    // Pairs are drawn one in the other.
    const rotors = await page.evaluate(() => [...document.querySelectorAll("#airframe .rotor")].map((rotor) => [rotor.getAttribute("cx"), rotor.getAttribute("cy"), Number(rotor.getAttribute("r"))]));
    assert.equal(rotors.length, 8);
    for (let k = 0; k < 8; k += 2) assert.ok(rotors[k][0] === rotors[k + 1][0] && rotors[k][1] === rotors[k + 1][1] && rotors[k][2] > rotors[k + 1][2], k);
  });
});
