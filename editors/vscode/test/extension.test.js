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

// Writes down its arguments and the methods asked of it, and gives the least of answers.
const SERVER = `#!/usr/bin/env node
const fs = require('node:fs');
const tell = (line) => fs.appendFileSync(__filename + '.told', line + '\\n');
tell(process.argv.slice(2).join(' '));
let input = '';
process.stdin.setEncoding('utf8').on('data', (part) => {
  input += part;
  for (let head; (head = input.match(/^Content-Length: (\\d+)\\r\\n\\r\\n/)); ) {
    const end = head[0].length + Number(head[1]);
    if (input.length < end) return;
    const { id, method } = JSON.parse(input.slice(head[0].length, end));
    input = input.slice(end);
    tell(method);
    if (method === 'exit') process.exit();
    if (id === undefined) continue;
    const answer = JSON.stringify({ jsonrpc: '2.0', id, result: method === 'initialize' ? { capabilities: {} } : null });
    process.stdout.write('Content-Length: ' + answer.length + '\\r\\n\\r\\n' + answer);
  }
});
`;

test('the server is started as `mavc lsp`, and stopped', async () => {
  const server = path.join(folder, 'mavc');
  fs.writeFileSync(server, SERVER, { mode: 0o755 });
  const { extension, errors } = loadWithEditor(BUNDLE, server);
  await extension.activate({ subscriptions: [] });
  await extension.deactivate();
  assert.deepEqual(errors, []);
  const told = fs.readFileSync(`${server}.told`, 'utf8').trim().split('\n');
  // That it is also told to exit, it may write down later.
  assert.deepEqual(told.slice(0, 4), ['lsp', 'initialize', 'initialized', 'shutdown']);
});

test('a mavc without a language server is said to be so', async () => {
  const server = path.join(folder, 'old');
  fs.writeFileSync(server, '#!/bin/sh\nexit 2\n', { mode: 0o755 });
  const { extension, errors } = loadWithEditor(BUNDLE, server);
  await extension.activate({ subscriptions: [] });
  assert.ok(errors.some((error) => error.startsWith(`"${server} lsp" did not start`)), errors.join('\n'));
});
