// The report page in a real browser: nothing wrong on the console, nothing loaded, everything within reach of keyboard and
// screen reader, in both themes and on a phone.
//   npm ci && npm test              with MAVC=path/to/mavc, CHROMIUM=/usr/bin/chromium, SHOTS=folder for pictures

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const root = fileURLToPath(new URL("../..", import.meta.url));
const mavc = process.env.MAVC ?? join(root, "target/debug/mavc");
const axe = readFileSync(fileURLToPath(import.meta.resolve("axe-core/axe.min.js")), "utf8");
const shots = process.env.SHOTS;
const folder = mkdtempSync(join(tmpdir(), "mavc-page-"));
const QUIET = ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
const WEBGL = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
const NO_WEBGL = ["--disable-gpu", "--disable-3d-apis"];

/** A spec whose names try to become markup. */
const HOSTILE = `
vehicle quad {
    layout = "PNPNPNPN"; arm = 0.211 m; mass = 1.8 kg; inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor { thrust_coefficient = 8.5485e-6 N*s^2/rad^2; drag_coefficient = 1.3678e-7 N*m*s^2/rad^2; max_speed = 874 rad/s }
}
// </script><script>document.title = "taken"</script><img src=x onerror="document.title='taken'">
faults { mode bad "</option><script>document.title='taken'</script><img src=x onerror=document.title='taken'>" { rotor 1 lost } }
/// </p><script>document.title = "taken"</script>
mission hop { start at [0, 0, 2] m
    waypoint at [3, 1, 4] m }
plan { planner = rip; against = [bad]; time = 6 s; samples = 40 }
`.replace(/layout.*\n/, (line) => line.replaceAll("; ", "\n    "));

const pages = {
  plan: ["plan", "specs/paper/case1.mav"],
  compare: ["compare", "specs/paper/case1.mav"],
  reserve: ["plan", "specs/missions/inspection.mav"],
  conflict: ["plan", "specs/paper/case1.mav", "--set", "plan.time=5s"],
  hostile: ["plan", join(folder, "hostile.mav")],
  flight: ["simulate", "specs/paper/figure12.mav"],
  campaign: ["campaign", join(folder, "hostile.mav"), "--times", "3", "--seeds", "1"],
};
const files = {};
const browsers = {};

before(async () => {
  writeFileSync(join(folder, "hostile.mav"), HOSTILE);
  if (shots) mkdirSync(shots, { recursive: true });
  for (const [name, args] of Object.entries(pages)) {
    files[name] = join(folder, `${name}.html`);
    try {
      execFileSync(mavc, [...args, "--html", files[name]], { cwd: root, stdio: "pipe" });
    } catch (error) {
      // No plan is an answer, and so is a lost vehicle.
      if (![3, 6].includes(error.status)) throw new Error(`${name}: ${error.stderr}`);
    }
  }
  const launch = (args) =>
    chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", headless: true, args: [...QUIET, ...args] });
  browsers.webgl = await launch(WEBGL);
  browsers.flat = await launch(NO_WEBGL);
});

after(async () => {
  for (const browser of Object.values(browsers)) await browser.close();
  rmSync(folder, { recursive: true });
});

/** Opens a page, lets `work` use it, and fails on anything on the console and any request beyond the file. */
async function open(name, { browser = "webgl", width = 1280, theme = "light" }, work) {
  const context = await browsers[browser].newContext({ viewport: { width, height: 900 }, colorScheme: theme });
  const page = await context.newPage();
  const troubles = [];
  page.on("console", (m) => ["error", "warning"].includes(m.type()) && !/GPU stall|swiftshader/i.test(m.text()) && troubles.push(m.text()));
  page.on("pageerror", (e) => troubles.push(e.message));
  page.on("request", (r) => r.url() !== pathToFileURL(files[name]).href && !r.url().startsWith("data:") && troubles.push(`request ${r.url()}`));
  await page.goto(pathToFileURL(files[name]).href);
  await page.waitForFunction(() => document.documentElement.classList.contains("scripted"));
  await page.waitForTimeout(300);
  try {
    await work(page);
    if (shots) await page.screenshot({ path: join(shots, `${name}-${browser}-${theme}-${width}.png`), fullPage: true });
    assert.deepEqual(troubles, []);
  } finally {
    await context.close();
  }
}

/** What axe finds wrong, in short. */
async function violations(page) {
  await page.evaluate(axe);
  const { violations: found } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  return found.map((v) => `${v.id}: ${v.nodes.slice(0, 3).map((n) => n.html.slice(0, 120)).join(" | ")}`);
}

const text = (page, selector) => page.locator(selector).textContent();

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

test("the slider moves the wrench through the set, by keys", () =>
  open("plan", {}, async (page) => {
    const headline = await text(page, "#sets-headline");
    const room = await text(page, "#room");
    const picture = () => page.locator("#sections canvas").first().evaluate((c) => c.toDataURL());
    const drawn = await picture();
    const space = () => page.locator("#space canvas").evaluate((c) => c.toDataURL());
    const flight = await space();
    await page.locator("#time").focus();
    for (let i = 0; i < 9; i++) await page.keyboard.press("PageUp");
    await page.waitForTimeout(200);
    assert.match(await text(page, "#clock"), /^7\.20 \/ 16\.00 s$/);
    assert.match(await text(page, "#sets-headline"), /^At 7\.20 s the planned wrench is inside what M1 leaves/);
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
    assert.match(await text(page, "#sets-headline"), /outside what M1 leaves, by 1\d(\.\d)? % of the healthy width/);
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
      const said = (await text(page, "#room caption")).match(/margin ([+\u2212]?[\d.]+) %/)[1].replace("\u2212", "-");
      assert.ok(Math.abs(Number(said) - columns.margin_1[k]) < 0.06, `${said} ${columns.margin_1[k]}`);
    }
  }));

test("plans, modes and sections can be chosen, and the strip leads to an instant", () =>
  open("compare", {}, async (page) => {
    const before = await text(page, "#charts");
    await page.selectOption("#run", { index: 0 });
    assert.notEqual(await text(page, "#charts"), before);
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
    assert.match(await text(page, "#found"), /Flown to its end/);
    assert.match(await text(page, "#chart-estimates"), /M3 is isolated after/);
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
    await page.selectOption("#colour", { label: "distance from its place" });
    await page.waitForTimeout(200);
    assert.deepEqual(await entries(), ["below 2 cm", "2 cm to 5 cm", "5 cm to 10 cm", "10 cm or more"]);
    assert.notEqual(await picture(), faults);
    // In words too, for whom colours say nothing.
    await page.locator("#time").evaluate((s) => {
      s.value = "12";
      s.dispatchEvent(new Event("input"));
    });
    assert.match(await text(page, "#space-readout"), /cm from its place; M3 detected$/);
    assert.match(await text(page, "#strips-headline"), /^The plan \(RIP, 30 s\): the smallest margin is/);
  }));

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

test("hovering a chart reads its curves", () =>
  open("plan", {}, async (page) => {
    const over = page.locator("#chart-speed .u-over");
    await over.scrollIntoViewIfNeeded();
    const value = () => text(page, "#chart-speed .u-legend .u-series:nth-child(2) .u-value");
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
  await page.goto(pathToFileURL(files.plan).href);
  assert.match(await page.locator("body").innerText(), /runs no scripts/);
  for (const id of ["flight", "heat", "sets", "motion"]) assert.equal(await page.locator(`#${id}`).isVisible(), false, id);
  for (const id of ["found", "modes", "spec"]) assert.equal(await page.locator(`#${id}`).isVisible(), true, id);
  await context.close();
});

test("the margin of an instant is the same wherever it is told", () =>
  open("plan", {}, async (page) => {
    for (const t of ["0.3", "7.77", "15.12"]) {
      await page.locator("#time").evaluate((s, value) => {
        s.value = value;
        s.dispatchEvent(new Event("input"));
      }, t);
      const told = [
        (await text(page, "#strips .readout")).match(/M1 (.* %)/)[1],
        (await text(page, "#space-readout")).match(/margin (.* %) to M1/)[1],
        (await text(page, "#room caption")).match(/margin (.* %)/)[1],
      ];
      assert.deepEqual(new Set(told).size, 1, told.join(", "));
    }
  }));

test("without WebGL the path is flat, and the page says so", () =>
  open("plan", { browser: "flat" }, async (page) => {
    assert.match(await text(page, "#space-note"), /no WebGL/);
    assert.equal(await page.locator("#space canvas").count(), 2);
    assert.equal(await page.locator("#solid").isHidden(), true);
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
    await page.locator("#play").press("Enter");
    await page.waitForTimeout(600);
    await page.locator("#play").press("Enter");
    const [now] = (await text(page, "#clock")).match(/[\d.]+/g).map(Number);
    assert.ok(now > 0.05, String(now));
  }));

test("nothing in a spec runs", () =>
  open("hostile", {}, async (page) => {
    assert.notEqual(await page.title(), "taken");
    assert.match(await text(page, "#set option:nth-child(2)"), /<script>/);
  }));
