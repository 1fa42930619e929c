// Bundles the extension into dist/extension.js, and puts the licences together: the project's own, and those of the
// packages that went into the bundle.
import { build } from 'esbuild';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';

process.chdir(import.meta.dirname);

const { metafile } = await build({
  entryPoints: ['src/extension.js'],
  outfile: 'dist/extension.js',
  bundle: true,
  minify: true,
  metafile: true,
  platform: 'node',
  target: 'node20',
  format: 'cjs',
  external: ['vscode'],
});

const licences = ['LICENSE-MIT', 'LICENSE-APACHE'].map((file) => readFileSync(`../../${file}`, 'utf8').trim());
writeFileSync('LICENSE.txt', `Either of these two licences, as you choose.\n\n${licences.join(`\n\n${'-'.repeat(80)}\n\n`)}\n`);

const folders = new Set(Object.keys(metafile.inputs).flatMap((file) => file.match(/^.*node_modules\/(?:@[^/]+\/)?[^/]+/) ?? []));
const notices = [...folders].sort().map((folder) => {
  const { name, version } = JSON.parse(readFileSync(`${folder}/package.json`, 'utf8'));
  const licence = readdirSync(folder).find((file) => /^licen[cs]e/i.test(file));
  if (!licence) throw new Error(`${name} is in the bundle and has no licence file`);
  return `${name} ${version}\n\n${readFileSync(`${folder}/${licence}`, 'utf8').trim()}\n`;
});
writeFileSync('THIRD-PARTY-NOTICES.txt', notices.join(`\n${'-'.repeat(80)}\n\n`));
