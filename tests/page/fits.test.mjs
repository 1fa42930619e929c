// Nothing wrong on the console, nothing loaded, everything within reach of keyboard and screen reader: in both themes, on a
// phone, on paper, without scripts and without WebGL.
//   npm ci && npm test              with MAVC=path/to/mavc, CHROMIUM=/usr/bin/chromium, SHOTS=folder for pictures

import assert from "node:assert/strict";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { browsers, file, open, pages, text, violations } from "./browser.mjs";

for (const name of Object.keys(pages)) {
  for (const theme of ["light", "dark"]) {
    test(`${name} has no trouble and nothing out of reach, ${theme}`, () =>
      open(name, { theme }, async (page) => {
        const dark = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
        assert.equal(dark, theme === "dark" ? "rgb(20, 23, 27)" : "rgb(255, 255, 255)");
        assert.deepEqual(await violations(page), []);
      }));
  }
  test(`${name} fits a phone, without WebGL too`, () =>
    open(name, { browser: "flat", width: 375, theme: "dark" }, async (page) => {
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= 375, `${wide} px wide`);
      assert.deepEqual(await violations(page), []);
    }));
}

// A reader comes to the end of a page.
for (const [name, width, most] of [["campaign", 1400, 6000], ["instants", 1400, 6000], ["volumes", 390, 9000], ["coaxial", 390, 9000]]) {
  test(`${name} is not too long, ${width} px`, () =>
    open(name, { width }, async (page) => {
      const height = await page.evaluate(() => document.documentElement.scrollHeight);
      assert.ok(height < most, `${height} px`);
    }));
}

test("what is cut off shows at its edge that there is more, until it is scrolled to", () =>
  open("compare", { width: 390 }, async (page) => {
    for (const theme of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme: theme });
      for (const selector of ["#planners .scroll", "nav.contents ul"]) {
        const place = page.locator(selector).first();
        assert.ok(await place.evaluate((e) => e.scrollWidth > e.clientWidth + 5), selector);
        const edges = async () => {
          const shot = (await place.screenshot()).toString("base64");
          // Brightness of the upper row of pixels at both ends, against the paper's.
          return page.evaluate(async (data) => {
            const image = new Image();
            image.src = `data:image/png;base64,${data}`;
            await image.decode();
            const canvas = new OffscreenCanvas(image.width, image.height);
            const pen = canvas.getContext("2d", { willReadFrequently: true });
            pen.drawImage(image, 0, 0);
            const at = (x) => pen.getImageData(x, 1, 1, 1).data.slice(0, 3).reduce((sum, v) => sum + v, 0) / 3;
            const paper = getComputedStyle(document.body).backgroundColor.match(/\d+/g).slice(0, 3).reduce((sum, v) => sum + Number(v), 0) / 3;
            return [at(1), at(image.width - 2)].map((v) => Math.abs(v - paper) > 20);
          }, shot);
        };
        const to = (end) => place.evaluate((e, x) => (e.scrollLeft = x === 1 ? e.scrollWidth : 0), end);
        assert.deepEqual(await edges(), [false, true], `${selector}, ${theme}, at its start`);
        await to(1);
        assert.deepEqual(await edges(), [true, false], `${selector}, ${theme}, at its end`);
        await to(0);
      }
    }
  }));

for (const width of [1280, 1920]) {
  test(`maps of survival show all their instants, ${width} px`, () =>
    open("instants", { width }, async (page) => {
      await page.evaluate(() => document.querySelectorAll("#map details").forEach((d) => (d.open = true)));
      const maps = await page.evaluate(() =>
        [...document.querySelectorAll("#map .maps .scroll")].map((e) => ({ instants: e.querySelectorAll("thead th").length - 1, cut: e.scrollWidth - e.clientWidth })),
      );
      assert.deepEqual(maps, Array(3).fill({ instants: 12, cut: 0 }));
      // As many as a map has columns for, all with their widest words.
      const wide = await page.evaluate(() => {
        for (const row of document.querySelectorAll("#map .maps tr")) {
          const last = row.lastElementChild;
          if (last.matches("td")) last.textContent = "12/12";
          while (row.children.length < 25) row.append(last.cloneNode(true));
        }
        return [...document.querySelectorAll("#map .maps .scroll")].map((e) => e.scrollWidth - e.clientWidth);
      });
      assert.deepEqual(wide, [0, 0, 0]);
    }));
}

test("the words of a limit lie beside the curves", () =>
  open("reserve", {}, async (page) => {
    const { crossed, placed } = await page.evaluate(async () => {
      const said = [];
      const pen = CanvasRenderingContext2D.prototype;
      const { fillText } = pen;
      pen.fillText = function (words, x, y) {
        if (this.canvas.closest("#chart-position")) said.push({ words, x, y, width: this.measureText(words).width });
        fillText.call(this, words, x, y);
      };
      // Charts are drawn anew in the other theme.
      document.getElementById("theme").click();
      await new Promise((done) => setTimeout(done, 300));
      pen.fillText = fillText;
      const over = document.querySelector("#chart-position .u-over");
      const ratio = devicePixelRatio;
      const left = over.offsetLeft * ratio;
      const ticks = said.filter((s) => s.x < left && /^\d+$/.test(s.words)).sort((a, b) => a.words - b.words);
      const [low, high] = [ticks[0], ticks.at(-1)];
      const { columns } = JSON.parse(document.getElementById("content").textContent).runs[0];
      const across = (t) => left + (t / columns.t.at(-1)) * over.clientWidth * ratio;
      const up = (v) => low.y + ((v - low.words) / (high.words - low.words)) * (high.y - low.y);
      const words = said.filter((s) => s.words.startsWith("altitude at least"));
      const crossed = words.flatMap((s) =>
        ["x", "y", "z"].filter((name) =>
          columns[name].some((v, k) => across(columns.t[k]) > s.x && across(columns.t[k]) < s.x + s.width && Math.abs(up(v) - s.y) < 6 * ratio),
        ),
      );
      return { crossed, placed: words.length };
    });
    assert.ok(placed > 0);
    assert.deepEqual(crossed, []);
  }));

test("what scrolls is in reach of the keyboard, and has a name", () =>
  open("reserve", { width: 390 }, async (page) => {
    const unreachable = await page.evaluate(() =>
      [...document.querySelectorAll("main *")]
        .filter((e) => e.scrollWidth > e.clientWidth + 1 && ["auto", "scroll"].includes(getComputedStyle(e).overflowX))
        .filter((e) => e.tabIndex !== 0 || !e.getAttribute("aria-label"))
        .map((e) => e.outerHTML.slice(0, 80)),
    );
    assert.deepEqual(unreachable, []);
    // The table of modes is described by what its columns mean.
    const described = await page.locator("#modes table").getAttribute("aria-describedby");
    assert.match(await text(page, `#${described}`), /Last violation/);
  }));

for (const name of Object.keys(pages)) {
  test(`${name} fits paper`, () =>
    open(name, { width: 703 }, async (page) => {
      await page.emulateMedia({ media: "print" });
      await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
      const beyond = await page.evaluate(() => {
        const right = document.body.getBoundingClientRect().right + 0.5;
        return [...document.querySelectorAll("main :is(th, td, canvas, h2, pre, .line)")].filter((e) => e.getBoundingClientRect().right > right).map((e) => e.outerHTML.slice(0, 80));
      });
      assert.deepEqual(beyond, []);
      // No heading ends a page.
      const alone = await page.evaluate(() =>
        [...document.querySelectorAll("main :is(h2, h3, figcaption, h2 + .note)")].filter((e) => getComputedStyle(e).breakAfter !== "avoid").map((e) => e.outerHTML.slice(0, 80)),
      );
      assert.deepEqual(alone, []);
      // The words of names stay whole.
      const split = await page.evaluate(() =>
        [...document.querySelectorAll("tbody th[scope=row]")].filter((e) => {
          const words = document.createRange();
          words.selectNodeContents(e.firstChild);
          return /^[a-z0-9]{1,9}$/i.test(e.firstChild.data ?? "") && words.getClientRects().length > 1;
        }).map((e) => e.textContent),
      );
      assert.deepEqual(split, []);
    }));
}

test("without scripts the page says so, and shows no empty places", async () => {
  const context = await browsers.webgl.newContext({ javaScriptEnabled: false });
  const page = await context.newPage();
  await page.goto(pathToFileURL(file("plan")).href);
  assert.match(await page.locator("body").innerText(), /does not run scripts/);
  for (const id of ["flight", "heat", "sets", "motion"]) assert.equal(await page.locator(`#${id}`).isVisible(), false, id);
  for (const id of ["found", "modes", "spec"]) assert.equal(await page.locator(`#${id}`).isVisible(), true, id);
  await context.close();
});

test("without WebGL the path is flat, and the page says so", () =>
  open("plan", { browser: "flat" }, async (page) => {
    assert.match(await text(page, "#space-note"), /does not support WebGL/);
    assert.equal(await page.locator("#space canvas").count(), 2);
    assert.equal(await page.locator("#solid").isHidden(), true);
  }));

test("nothing in a spec runs", () =>
  open("hostile", {}, async (page) => {
    assert.notEqual(await page.title(), "taken");
    assert.match(await text(page, "#set option:nth-child(2)"), /<script>/);
  }));
