// Bundles script and style of the report page into dist/, which the compiler embeds.
//   npm ci && npm run build     after a change
//   npm run check               whether dist/ is what the sources give
import { build } from "esbuild";
import { readFile, writeFile } from "node:fs/promises";

const checks = process.argv.includes("--check");
const licences = await Promise.all(
  ["uplot", "three"].map(async (name) => {
    const read = (file) => readFile(new URL(`node_modules/${name}/${file}`, import.meta.url), "utf8");
    const { version } = JSON.parse(await read("package.json"));
    return `${name} ${version}\n\n${(await read("LICENSE")).trim()}\n`;
  }),
);
const thirdParty = licences.join(`\n${"-".repeat(78)}\n\n`);

const { outputFiles } = await build({
  absWorkingDir: new URL(".", import.meta.url).pathname,
  entryPoints: { page: "src/main.js" },
  outdir: "dist",
  write: false,
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "utf8",
  legalComments: "none",
  banner: { js: `/*!\n${thirdParty}*/` },
});

let stale = false;
const results = outputFiles.map(({ path, text }) => [path, text]);
results.push([new URL("THIRD-PARTY.txt", import.meta.url).pathname, thirdParty]);
for (const [path, text] of results) {
  if (checks) {
    const there = await readFile(path, "utf8").catch(() => "");
    if (there !== text) {
      console.error(`${path} is not what its sources give: npm run build`);
      stale = true;
    }
  } else {
    await writeFile(path, text);
    console.log(`${path}: ${text.length} characters`);
  }
}
process.exitCode = stale ? 1 : 0;
