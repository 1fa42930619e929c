// Where the server is.
'use strict';

const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');

/**
 * The file that `mavc.path` means, or null where there is none that can be run.
 *
 * A bare name is looked for on the PATH. A path may begin with `~` or `${workspaceFolder}`; a relative one counts from
 * the workspace.
 *
 * @param {string} wanted the setting
 * @param {string | undefined} workspace the first folder of the workspace
 * @param {NodeJS.ProcessEnv} env
 * @returns {string | null}
 */
function findServer(wanted, workspace, env = process.env) {
  const endings = process.platform === 'win32' ? (env.PATHEXT ?? '.EXE').split(';') : [''];
  const complete = (file) => ['', ...endings].map((ending) => file + ending).find(isProgram) ?? null;

  if (!/[\\/]/.test(wanted)) {
    const folders = (env.PATH ?? env.Path ?? '').split(path.delimiter).filter(Boolean);
    return folders.map((folder) => complete(path.join(folder, wanted))).find(Boolean) ?? null;
  }
  const base = workspace ?? process.cwd();
  const file = wanted.replace(/^~(?=[\\/])/, os.homedir()).replace('${workspaceFolder}', base);
  return complete(path.resolve(base, file));
}

function isProgram(file) {
  try {
    fs.accessSync(file, fs.constants.X_OK);
    return fs.statSync(file).isFile();
  } catch {
    return false;
  }
}

module.exports = { findServer };
