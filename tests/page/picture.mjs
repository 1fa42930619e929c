// Makes the picture of a page's first screen for the documents.
//   npm run picture                 writes docs/images/page.png; npm run picture -- FILE writes FILE

import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
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
await browser.close();
rmSync(folder, { recursive: true });
console.log(`written to ${picture}`);
