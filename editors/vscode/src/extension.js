// Starts `mavc lsp` and says so plainly where that cannot be done.
'use strict';

const vscode = require('vscode');
const { LanguageClient } = require('vscode-languageclient/node');
const { findServer } = require('./find');

/** @type {LanguageClient | undefined} */
let client;

async function activate(context) {
  context.subscriptions.push(
    vscode.commands.registerCommand('mavc.restart', restart),
    vscode.workspace.onDidChangeConfiguration((change) => {
      if (change.affectsConfiguration('mavc.path')) return restart();
    }),
  );
  await start();
}

async function start() {
  const wanted = vscode.workspace.getConfiguration('mavc').get('path') || 'mavc';
  const command = findServer(wanted, vscode.workspace.workspaceFolders?.[0]?.uri.fsPath);
  if (!command) {
    const place = /[\\/]/.test(wanted) ? 'there is no program at' : 'the PATH has no program called';
    complain(`mavc was not found: ${place} "${wanted}". Set "mavc.path" to where it is.`);
    return;
  }
  client = new LanguageClient(
    'mavc',
    'mavc',
    { command, args: ['lsp'] },
    { documentSelector: [{ language: 'mav' }] },
  );
  try {
    await client.start();
  } catch (error) {
    client = undefined;
    complain(`"${command} lsp" did not start: ${error.message}. Is this mavc too old for it?`);
  }
}

/** Shows an error. Nobody waits for it: the answer may never come. */
async function complain(message) {
  const settings = 'Open settings';
  if ((await vscode.window.showErrorMessage(message, settings)) === settings) {
    await vscode.commands.executeCommand('workbench.action.openSettings', 'mavc.path');
  }
}

async function stop() {
  const running = client;
  client = undefined;
  await running?.stop();
}

async function restart() {
  await stop();
  await start();
}

module.exports = { activate, deactivate: stop };
