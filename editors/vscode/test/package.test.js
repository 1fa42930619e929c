'use strict';

const assert = require('node:assert/strict');
const path = require('node:path');
const test = require('node:test');
const yauzl = require('yauzl');

/** The files in the package, by name. */
async function unpacked() {
  const zip = await yauzl.openPromise(path.join(__dirname, '../dist/mav.vsix'), { lazyEntries: true, autoClose: false });
  const contents = new Map();
  for await (const entry of zip.eachEntry()) {
    const parts = [];
    for await (const part of await zip.openReadStreamPromise(entry)) parts.push(part);
    contents.set(entry.fileName, Buffer.concat(parts).toString());
  }
  zip.close();
  return contents;
}

test('the package holds what it declares, its licences, and nothing else', async () => {
  const files = await unpacked();
  const { main, contributes } = JSON.parse(files.get('extension/package.json'));
  const declared = [
    main, ...contributes.languages.map((language) => language.configuration),
    ...[...contributes.grammars, ...contributes.snippets].map((part) => part.path),
  ];
  const expected = [
    ...declared.map((file) => path.posix.join('extension', file)),
    ...['package.json', 'readme.md', 'LICENSE.txt', 'THIRD-PARTY-NOTICES.txt'].map((file) => `extension/${file}`),
    'extension.vsixmanifest', '[Content_Types].xml',
  ];
  assert.deepEqual([...files.keys()].sort(), expected.sort());
  assert.match(files.get('extension/LICENSE.txt'), /Permission is hereby granted[^]*Apache License/);
  assert.match(files.get('extension/THIRD-PARTY-NOTICES.txt'), /^vscode-languageclient \d/m);
  for (const file of declared.filter((file) => file.endsWith('.json'))) {
    assert.doesNotThrow(() => JSON.parse(files.get(path.posix.join('extension', file))), file);
  }
});

test('the bundle needs nothing but the editor and Node', async () => {
  const bundle = (await unpacked()).get('extension/dist/extension.js');
  const { builtinModules } = require('node:module');
  const needed = new Set([...bundle.matchAll(/\brequire\("([^"]+)"\)/g)].map(([, name]) => name.replace(/^node:/, '')));
  assert.deepEqual([...needed].filter((name) => name !== 'vscode' && !builtinModules.includes(name)), []);
});
