// The documentation as a site in a real browser: `bash docs/site/run`, then `node --test site.mjs`.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const target = process.env.CARGO_TARGET_DIR ?? fileURLToPath(new URL("../../target", import.meta.url));
const site = join(target, "site/html");
const TYPES = { ".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".svg": "image/svg+xml", ".json": "application/json" };
let browser, server, address;

before(async () => {
  assert(existsSync(site), "build the site first: bash docs/site/run");
  server = createServer((request, response) => {
    const file = join(site, normalize(decodeURIComponent(new URL(request.url, "http://x").pathname)));
    if (!file.startsWith(site) || !existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, { "content-type": TYPES[extname(file)] ?? "application/octet-stream" }).end(readFileSync(file));
  });
  await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
  address = `http://127.0.0.1:${server.address().port}`;
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox", "--disable-gpu"] });
});

after(async () => {
  await browser?.close();
  server?.close();
});

/** A page of the site, and what went wrong on it: errors, and requests that leave the site. */
async function open(path, size, scheme) {
  const context = await browser.newContext({ viewport: size, colorScheme: scheme });
  const page = await context.newPage();
  const trouble = [];
  page.on("request", (request) => {
    if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(address)) trouble.push(request.url());
  });
  page.on("console", (message) => message.type() === "error" && trouble.push(message.text()));
  page.on("pageerror", (error) => trouble.push(String(error)));
  await page.goto(address + path, { waitUntil: "load" });
  return { page, trouble, close: () => context.close() };
}

for (const [size, scheme] of [[{ width: 1400, height: 900 }, "light"], [{ width: 1400, height: 900 }, "dark"], [{ width: 390, height: 844 }, "light"]]) {
  test(`pages fit and need no network: ${size.width}, ${scheme}`, async () => {
    for (const path of ["/index.html", "/docs/tutorial.html", "/docs/command.html", "/docs/glossary.html", "/docs/how-to/safety.html"]) {
      const { page, trouble, close } = await open(path, size, scheme);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert(wide <= 0, `${path} is ${wide} px wider than the window`);
      const broken = await page.evaluate(() => [...document.images].filter((i) => i.complete && !i.naturalWidth).map((i) => i.src));
      assert.deepEqual([...trouble, ...broken], [], path);
      await close();
    }
  });
}

for (const [query, wanted] of [["reserve", "Reserve: how large?"], ["PX4", "PX4"], ["heading not held", "What a fault leaves"]]) {
  test(`the search finds the page on ${query}`, async () => {
    const { page, trouble, close } = await open("/index.html", { width: 1400, height: 900 }, "light");
    const input = page.locator("input:visible").first();
    // The key does nothing before the site's script has loaded.
    for (let tries = 0; tries < 30 && !(await input.isVisible()); tries++) {
      await page.keyboard.press("Control+k");
      await page.waitForTimeout(1000);
    }
    await input.fill(query);
    // The search shows its results in a shadow tree, which locators look through.
    const results = page.locator("li:visible, a:visible").filter({ hasText: wanted });
    await results.first().waitFor();
    const places = await page.locator("a:visible").filter({ hasText: new RegExp(query.split(" ")[0], "i") }).allTextContents();
    assert(places.slice(0, 3).some((text) => text.includes(wanted)), `${query}: ${places.slice(0, 3).map((t) => t.slice(0, 60))}`);
    assert.deepEqual(trouble, []);
    await close();
  });
}
