'use strict';

const assert = require('node:assert/strict');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const test = require('node:test');
const { loadWithEditor } = require('./vscode');

const BUNDLE = path.join(__dirname, '../dist/extension.js');
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'mav-'));
test.after(() => fs.rmSync(folder, { recursive: true }));

test('a mavc that is nowhere is said to be so', async () => {
  for (const [setting, place] of [
    ['no-such-mavc', 'the PATH has no program called "no-such-mavc"'],
    ['/no/such/mavc', 'there is no program at "/no/such/mavc"'],
  ]) {
    const { extension, errors } = loadWithEditor(BUNDLE, setting);
    await extension.activate({ subscriptions: [] });
    assert.deepEqual(errors, [`mavc was not found: ${place}. Set "mavc.path" to where it is.`]);
  }
});

test('the server is started as `mavc lsp`', async () => {
  const server = path.join(folder, 'mavc');
  const told = path.join(folder, 'told');
  fs.writeFileSync(server, `#!/bin/sh\necho "$@" > ${told}\n`, { mode: 0o755 });
  const { extension, errors } = loadWithEditor(BUNDLE, server);
  await extension.activate({ subscriptions: [] });
  assert.equal(fs.readFileSync(told, 'utf8'), 'lsp\n');
  // This one ends at once, as a mavc does that knows no `lsp`.
  assert.ok(errors.some((error) => error.includes(`"${server} lsp" did not start`)), errors.join('\n'));
});
