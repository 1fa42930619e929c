// Pages of the compiler in a real browser, with an eye on its console and its requests.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const root = fileURLToPath(new URL("../..", import.meta.url));
export const mavc = process.env.MAVC ?? join(root, "target/debug/mavc");
const axe = readFileSync(fileURLToPath(import.meta.resolve("axe-core/axe.min.js")), "utf8");
export const shots = process.env.SHOTS;
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

/** Rotors in pairs. */
const COAXIAL = `use "${join(root, "specs/vehicles/coaxial_x8.mav")}"
faults {
    every 1 rotor lost as M
    mode arm { rotors [1, 2] lost }
    mode worn { rotor 3 reduced to 60 % }
    mode jam { rotor 4 stuck at 30 % }
}
`;

/** Faults with ways out to a site, and one with a gap. */
const FIELD = `
vehicle octo {
    layout  = "PPNNPPNN"
    arm     = 21 cm
    mass    = 1.8 kg
    inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor { max_thrust = 6.5 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }
}
faults {
    mode M1 { rotor 1 lost }
    mode M4 { rotor 4 lost }
}
mission field {
    ground = 0 m
    start at [0, 0, 4] m
    waypoint at [30, 0, 10] m
    limits { speed <= 6 m/s; descent <= 3 m/s }
    landing_site pad { at = [10, 6, 0] m; radius = 2 m }
}
plan {
    model   = hover
    against = [M1]
    time    = 9 s
    samples = 40
    recovery { order = [land_at_sites]; detection = 100 ms; within = 12 s }
}
`;

export const pages = {
  plan: ["plan", "specs/paper/case1.mav"],
  compare: ["compare", "specs/paper/case1.mav"],
  reserve: ["plan", "specs/missions/inspection.mav"],
  conflict: ["plan", "specs/paper/case1.mav", "--set", "plan.time=5s"],
  hostile: ["plan", join(folder, "hostile.mav")],
  flight: ["simulate", "specs/paper/figure12.mav"],
  analysis: ["analyze", "examples/survey_hexa.mav"],
  // Without a mission, with rotors one over the other and faults of every kind.
  coaxial: ["analyze", join(folder, "coaxial.mav")],
  campaign: ["campaign", join(folder, "hostile.mav"), "--times", "3", "--seeds", "1"],
  volumes: ["plan", "specs/missions/mast_octo.mav", "--set", "plan.planner=rip", "--set", "plan.time=20s", "--set", "plan.samples=40"],
  ways: ["plan", join(folder, "field.mav"), "--recovery"],
  // Maps of many instants beside each other.
  instants: ["campaign", join(folder, "instants.mav"), "--times", "12", "--seeds", "1"],
};
const files = {};
export const browsers = {};

/** The file of a page, made when it is first asked for. */
export function file(name) {
  if (files[name]) return files[name];
  const made = join(folder, `${name}.html`);
  try {
    execFileSync(mavc, [...pages[name], "--html", made], { cwd: root, stdio: "pipe" });
  } catch (error) {
    // No plan is an answer, and so is a lost vehicle.
    if (![3, 6].includes(error.status)) throw new Error(`${name}: ${error.stderr}`);
  }
  return (files[name] = made);
}

before(async () => {
  writeFileSync(join(folder, "hostile.mav"), HOSTILE);
  writeFileSync(join(folder, "coaxial.mav"), COAXIAL);
  writeFileSync(join(folder, "field.mav"), FIELD);
  writeFileSync(join(folder, "instants.mav"), `${HOSTILE}campaign { planners = [rip, rcp, rsp] }\n`);
  if (shots) mkdirSync(shots, { recursive: true });
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
export async function open(name, { browser = "webgl", width = 1280, theme = "light" }, work) {
  const address = pathToFileURL(file(name)).href;
  const context = await browsers[browser].newContext({ viewport: { width, height: 900 }, colorScheme: theme });
  const page = await context.newPage();
  const troubles = [];
  page.on("console", (m) => ["error", "warning"].includes(m.type()) && !/GPU stall|swiftshader/i.test(m.text()) && troubles.push(m.text()));
  page.on("pageerror", (e) => troubles.push(e.message));
  page.on("request", (r) => r.url() !== address && !r.url().startsWith("data:") && troubles.push(`request ${r.url()}`));
  await page.goto(address);
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
export async function violations(page) {
  await page.evaluate(axe);
  const { violations: found } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  return found.map((v) => `${v.id}: ${v.nodes.slice(0, 3).map((n) => n.html.slice(0, 120)).join(" | ")}`);
}

export const text = (page, selector) => page.locator(selector).textContent();
