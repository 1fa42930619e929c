'use strict';

const assert = require('node:assert/strict');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const test = require('node:test');
const { findServer } = require('../src/find');

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'mav-'));
test.after(() => fs.rmSync(folder, { recursive: true }));
const program = path.join(folder, 'bin', 'mavc');
fs.mkdirSync(path.dirname(program));
fs.writeFileSync(program, '#!/bin/sh\n', { mode: 0o755 });
fs.writeFileSync(path.join(folder, 'bin', 'text'), 'no program', { mode: 0o644 });

test('a name is looked for on the PATH, in its order', () => {
  const env = { PATH: [path.join(folder, 'nowhere'), path.dirname(program), '/bin'].join(path.delimiter) };
  assert.equal(findServer('mavc', folder, env), program);
  assert.equal(findServer('text', folder, env), null, 'what cannot be run is no program');
  assert.equal(findServer('mavc', folder, { PATH: folder }), null);
  assert.equal(findServer('mavc', folder, {}), null);
});

test('a name is not looked for in the workspace', () => {
  assert.equal(findServer('mavc', path.dirname(program), { PATH: '' }), null);
});

test('a path counts from the workspace', () => {
  assert.equal(findServer('./bin/mavc', folder, {}), program);
  assert.equal(findServer('${workspaceFolder}/bin/mavc', folder, {}), program);
  assert.equal(findServer(program, '/', {}), program);
  assert.equal(findServer('./bin', folder, {}), null, 'a folder is no program');
});

test('~ is the home folder', () => {
  const file = path.join('~', path.relative(os.homedir(), program));
  assert.equal(findServer(file, '/', {}), program);
});
