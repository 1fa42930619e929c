#!/usr/bin/env bash
# Makes the Python environment of python/check.sh in the folder of cargo's target, if it is missing or has other packages.
#   bash python/environment.sh
set -euo pipefail
cd "$(dirname "$0")/.."
venv="${CARGO_TARGET_DIR:-$PWD/target}/venv"
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
if ! cmp -s python/requirements.txt "$venv/requirements.txt"; then
    # Modules are compiled when they are imported, which only few of them are.
    "$venv/bin/pip" install --quiet --no-compile --disable-pip-version-check -r python/requirements.txt
    cp python/requirements.txt "$venv"
fi
