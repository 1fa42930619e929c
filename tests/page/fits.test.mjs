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
    assert.match(await text(page, `#${described}`), /Last outside/);
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
        [...document.querySelectorAll("tbody th[scope=row]")].filter((e) => /^[a-z0-9]{1,9}$/i.test(e.firstChild.data ?? "") && e.childNodes.length === 1 && e.getBoundingClientRect().height > 2.6 * parseFloat(getComputedStyle(e).lineHeight)).map((e) => e.textContent),
      );
      assert.deepEqual(split, []);
    }));
}

test("without scripts the page says so, and shows no empty places", async () => {
  const context = await browsers.webgl.newContext({ javaScriptEnabled: false });
  const page = await context.newPage();
  await page.goto(pathToFileURL(file("plan")).href);
  assert.match(await page.locator("body").innerText(), /runs no scripts/);
  for (const id of ["flight", "heat", "sets", "motion"]) assert.equal(await page.locator(`#${id}`).isVisible(), false, id);
  for (const id of ["found", "modes", "spec"]) assert.equal(await page.locator(`#${id}`).isVisible(), true, id);
  await context.close();
});

test("without WebGL the path is flat, and the page says so", () =>
  open("plan", { browser: "flat" }, async (page) => {
    assert.match(await text(page, "#space-note"), /no WebGL/);
    assert.equal(await page.locator("#space canvas").count(), 2);
    assert.equal(await page.locator("#solid").isHidden(), true);
  }));

test("nothing in a spec runs", () =>
  open("hostile", {}, async (page) => {
    assert.notEqual(await page.title(), "taken");
    assert.match(await text(page, "#set option:nth-child(2)"), /<script>/);
  }));
