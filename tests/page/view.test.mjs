// `mavc view`: the page renews itself while a spec is edited, keeps where the reader is, and answers nobody else.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { connect } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { test } from "node:test";
import { browsers, mavc, shots, text, violations } from "./browser.mjs";

const VEHICLE = `vehicle octo {
    layout  = "PNPNPNPN"
    arm     = 0.211 m
    mass    = 1.8 kg
    inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor {
        thrust_coefficient = 8.5485e-6 N*s^2/rad^2
        drag_coefficient   = 1.3678e-7 N*m*s^2/rad^2
        max_speed          = 874 rad/s
    }
}
`;
const SPEC = `use "octo.mav"
faults { mode M1 { rotor 1 lost } }
mission hop {
    start at [0, 0, 2] m
    waypoint at [3, 1, 4] m
}
plan { planner = rip; against = [M1]; time = 6 s; samples = 40 }
`.replace(/plan \{ (.*) \}/, (_, fields) => `plan {\n    ${fields.replaceAll("; ", "\n    ")}\n}`);

/** Starts `mavc view` for a spec of two files, lets `work` use it, and ends it. */
async function viewing(work, files = {}) {
  const folder = mkdtempSync(join(tmpdir(), "mavc-view-"));
  const save = (name, content) => writeFileSync(join(folder, name), content);
  for (const [name, content] of Object.entries({ "octo.mav": VEHICLE, "hop.mav": SPEC, ...files })) save(name, content);
  const child = spawn(mavc, ["view", join(folder, "hop.mav")], { stdio: ["ignore", "pipe", "inherit"] });
  try {
    const [address] = await once(createInterface({ input: child.stdout }), "line");
    assert.match(address, /^http:\/\/127\.0\.0\.1:\d+\/$/);
    await work({ address, port: Number(new URL(address).port), save, child });
  } finally {
    child.kill("SIGKILL");
    rmSync(folder, { recursive: true });
  }
}

/** Opens the page, and fails on anything on its console and any request to elsewhere. */
async function browsing(address, work) {
  const context = await browsers.webgl.newContext({ viewport: { width: 1400, height: 900 } });
  const page = await context.newPage();
  const troubles = [];
  page.on("console", (m) => ["error", "warning"].includes(m.type()) && !/GPU stall|swiftshader/i.test(m.text()) && troubles.push(m.text()));
  page.on("pageerror", (e) => troubles.push(e.message));
  page.on("request", (r) => r.url() !== address && r.url() !== `${address}events` && !r.url().startsWith("data:") && troubles.push(`request ${r.url()}`));
  await page.goto(address);
  try {
    await work(page);
    assert.deepEqual(troubles, []);
  } finally {
    await context.close();
  }
}

const stage = (page, wanted) => page.waitForSelector(`#live[data-stage=${wanted}]`);
/** The page of the plan with this number. */
const numbered = (page, number) => page.waitForSelector(`#live[data-page="${number}"][data-stage=current]`);

/** What the server answers to bytes. */
function raw(port, bytes) {
  return new Promise((done, failed) => {
    const socket = connect(port, "127.0.0.1", () => socket.write(bytes));
    let got = "";
    socket.on("data", (data) => (got += data));
    socket.on("close", () => done(got));
    socket.on("error", failed);
  });
}

test("a live page follows its spec: plan, error, another plan, with the slider and the camera where they were", () =>
  viewing(({ address, save }) =>
    browsing(address, async (page) => {
      await numbered(page, 1);
      assert.match(await text(page, "#found"), /6\ss/);
      assert.deepEqual(await violations(page), []);
      const canvas = () => page.locator("#space canvas").evaluate((c) => c.toDataURL());
      const opened = await canvas();
      await page.locator("#space").focus();
      for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowLeft");
      await page.locator("#time").evaluate((s) => {
        s.value = "2.5";
        s.dispatchEvent(new Event("input"));
      });
      await page.evaluate(() => scrollTo(0, 400));
      await page.waitForTimeout(300);
      const top = () => page.locator("main").evaluate((m) => Math.round(m.getBoundingClientRect().top));
      const read = await top();
      const turned = await canvas();
      assert.notEqual(turned, opened);

      // A mistake in the spec: said as on the terminal, and the plan is grey.
      save("hop.mav", SPEC.replace("4] m", "4] kg"));
      await stage(page, "error");
      const said = await text(page, "#live .diagnostics");
      for (const words of ["mavc::unit::mismatch", "hop.mav:5", "kg"]) assert.ok(said.includes(words), said);
      assert.equal(await page.locator("body.stale").count(), 1);
      const look = () => page.locator("main").evaluate((m) => getComputedStyle(m).filter);
      assert.equal(await look(), "grayscale(1)");
      assert.match(await text(page, "#found"), /6\ss/, "the last plan stays");
      if (shots) await page.screenshot({ path: join(shots, "view-error.png") });

      // Mended, with another place and another time.
      save("hop.mav", SPEC.replace("time = 6 s", "time = 7 s"));
      await numbered(page, 2);
      assert.match(await text(page, "#found"), /7\ss/);
      assert.equal(await page.locator("body.stale").count(), 0);
      assert.equal(await page.locator("#live .diagnostics").isHidden(), true);
      await page.waitForTimeout(300);
      assert.match(await text(page, "#clock"), /^2\.50 \/ 7\.00 s$/);
      assert.ok(Math.abs((await top()) - read) <= 2, `${await top()} px, was at ${read} px`);
      const [before, now] = await page.evaluate(
        async (pictures) => {
          const pixels = async (data) => {
            const image = new Image();
            image.src = data;
            await image.decode();
            const copy = new OffscreenCanvas(image.width, image.height);
            const pen = copy.getContext("2d");
            pen.drawImage(image, 0, 0);
            return pen.getImageData(0, 0, image.width, image.height).data;
          };
          const [a, b, c] = await Promise.all(pictures.map(pixels));
          const differ = (one, other) => one.reduce((sum, v, i) => sum + (Math.abs(v - other[i]) > 40), 0);
          return [differ(a, b), differ(b, c)];
        },
        [opened, turned, await canvas()],
      );
      // The ground and the scales are where the reader turned them: only path and vehicle may differ a little.
      assert.ok(now < before / 4, `${now} of ${before} values differ`);
    }),
  ));

test("a file that the spec uses is watched too, and what is planned is cancelled when it changes", () => {
  const long = SPEC.replace("time = 6 s", "time = minimum\n    effort = thorough").replace("samples = 40", "samples = 400").replace("planner = rip", "planner = rsp");
  return viewing(
    ({ address, save }) =>
      browsing(address, async (page) => {
        await page.waitForFunction(() => /trying/.test(document.querySelector("#live .progress")?.textContent ?? ""));
        assert.equal(await page.locator("#live").getAttribute("data-stage"), "planning");
        assert.match(await text(page, "#live .verdict-line"), /^octo: M1 \(one rotor lost\)/);
        save("octo.mav", VEHICLE.replace("1.8 kg", "1.8 m"));
        await stage(page, "error");
        assert.match(await text(page, "#live .diagnostics"), /octo\.mav:4/);
        save("octo.mav", VEHICLE);
        save("hop.mav", SPEC);
        await numbered(page, 1);
      }),
    { "hop.mav": long },
  );
});

test("a spec with an error from the start has a page that says so", () =>
  viewing(
    ({ address, save }) =>
      browsing(address, async (page) => {
        await stage(page, "error");
        assert.match(await text(page, "#live .diagnostics"), /mavc::/);
        assert.match(await text(page, "main"), /no plan yet/);
        assert.deepEqual(await violations(page), []);
        save("hop.mav", SPEC);
        await numbered(page, 1);
      }),
    { "hop.mav": "mission {" },
  ));

test("nobody else is answered, and a slow client does not block the page", () =>
  viewing(async ({ address, port }) => {
    const host = `Host: 127.0.0.1:${port}\r\n`;
    const code = async (first, fields) => Number((await raw(port, `${first}\r\n${fields}\r\n`)).match(/^HTTP\/1\.1 (\d+) /)?.[1]);
    assert.equal(await code("GET / HTTP/1.1", "Host: evil.example\r\n"), 403);
    assert.equal(await code("GET / HTTP/1.1", `Host: evil.example:${port}\r\n`), 403);
    assert.equal(await code("GET /events HTTP/1.1", `${host}Origin: http://evil.example\r\n`), 403);
    assert.equal(await code("POST / HTTP/1.1", `${host}Content-Length: 0\r\n`), 405);
    for (const path of ["/hop.mav", "/../hop.mav", "/..%2fhop.mav", "/etc/passwd", "/?x", "//"]) assert.equal(await code(`GET ${path} HTTP/1.1`, host), 404, path);
    assert.equal(await code("GET / HTTP/1.1", `${host}X: ${"x".repeat(9000)}\r\n`), 431);
    assert.equal(await code("nonsense", host), 400);
    const head = await raw(port, `HEAD / HTTP/1.1\r\n${host}\r\n`);
    assert.match(head, /^HTTP\/1\.1 200 OK\r\n/);
    assert.match(head, /\r\nContent-Security-Policy: default-src 'none'; connect-src 'self'; .*frame-ancestors 'none'\r\n/);
    assert.doesNotMatch(head, /Access-Control/i);
    assert.ok(head.endsWith("\r\n\r\n"), "a head has no body");

    // More clients than there is room for, each with half a request, and the page is there all the same.
    const slow = Array.from({ length: 60 }, () => connect(port, "127.0.0.1", function () { this.write("GET / HT"); }).on("error", () => {}));
    await Promise.all(slow.map((s) => once(s, "connect")));
    await browsing(address, (page) => numbered(page, 1));
    slow.forEach((s) => s.destroy());
    // One that says nothing is told so, after a while.
    assert.match(await raw(port, "GET / HTTP/1.1\r\n"), /^HTTP\/1\.1 408 /);
  }));

test("Ctrl-C ends it", () =>
  viewing(async ({ child }) => {
    child.kill("SIGINT");
    const [status, signal] = await once(child, "exit");
    assert.ok(signal === "SIGINT" || status === 130, `${status} ${signal}`);
  }));
