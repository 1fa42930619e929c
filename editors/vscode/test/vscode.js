// As much of the editor as the extension needs to start.
'use strict';

const Module = require('node:module');

/** Anything: can be called, constructed, extended, and asked for any property but those of promises. */
function anything(own = {}) {
  return new Proxy(class {}, {
    get: (target, key) => {
      if (typeof key === 'symbol' || key === 'then') return undefined;
      if (key === 'prototype') return target.prototype;
      return (own[key] ??= anything());
    },
    apply: () => anything(),
  });
}

class EventEmitter {
  event = () => ({ dispose() {} });
  fire() {}
  dispose() {}
}

/**
 * Loads a module that asks for `vscode`.
 *
 * @param {string} file
 * @param {string} setting `mavc.path`
 * @returns {{ extension: any, errors: string[] }} the module, and the errors shown
 */
function loadWithEditor(file, setting) {
  const errors = [];
  const editor = anything({
    version: '1.91.0',
    EventEmitter,
    window: anything({ showErrorMessage: async (message) => void errors.push(message), visibleTextEditors: [] }),
    workspace: anything({
      getConfiguration: () => ({ get: (key, unless) => (key === 'path' ? setting : unless) }),
      workspaceFolders: [],
      textDocuments: [],
      notebookDocuments: [],
    }),
  });
  const load = Module._load;
  Module._load = (request, ...rest) => (request === 'vscode' ? editor : load(request, ...rest));
  try {
    delete require.cache[require.resolve(file)];
    return { extension: require(file), errors };
  } finally {
    Module._load = load;
  }
}

module.exports = { loadWithEditor };
