// Makes the picture of a page's first screen for the documents, and beside it a file with its words.
//   npm run picture                 writes docs/images/page.png and page.txt; npm run picture -- FILE.png writes FILE.*
// Letters look different on every computer, so CI compares the words and not the pixels.

import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const root = fileURLToPath(new URL("../..", import.meta.url));
const mavc = process.env.MAVC ?? join(root, "target/debug/mavc");
const picture = process.argv[2] ?? join(root, "docs/images/page.png");
const folder = mkdtempSync(join(tmpdir(), "mavc-picture-"));
const made = join(folder, "page.html");
execFileSync(mavc, ["-q", "plan", "examples/survey_hexa.mav", "--html", made], { cwd: root, stdio: ["ignore", "ignore", "inherit"] });
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const page = await browser.newPage({ viewport: { width: 1400, height: 900 }, colorScheme: "light" });
await page.goto(pathToFileURL(made).href);
await page.waitForFunction(() => document.documentElement.classList.contains("scripted"));
await page.waitForTimeout(500);
await page.screenshot({ path: picture });
const words = await page.evaluate(() => `${document.querySelector("header.top").innerText}\n${document.getElementById("found").innerText}`);
writeFileSync(picture.replace(/\.png$/, ".txt"), `${words.replaceAll("\u00a0", " ").trim()}\n`);
await browser.close();
rmSync(folder, { recursive: true });
console.log(`written to ${picture}`);
