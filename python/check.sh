#!/usr/bin/env bash
# Tests the Python package against the command, with the library that `cargo test` builds: types, tests, and the notebook.
#   bash python/check.sh [quick] [arguments of pytest]
# `quick` leaves out the tests that take several seconds.
set -euo pipefail
cd "$(dirname "$0")/.."
target="${CARGO_TARGET_DIR:-$PWD/target}"
chosen=()
if [ "${1:-}" = quick ]; then
    chosen=(-m "not long")
    shift
fi
bash python/environment.sh
# An example is among what is built so that features are unified as for tests: the library is not compiled a second time. As in
# the package that pip builds, the native part is not linked to one version of Python, so that its headers are not needed.
PYO3_BUILD_EXTENSION_MODULE=1 cargo build --quiet -p mavc -p mavc-python --lib --bins --example plan_without_text
cp "$target/debug/libmavc_python.so" python/mavc/_mavc.abi3.so
export MAVC="$target/debug/mavc" PYTHONPATH="$PWD/python"
python="$target/venv/bin/python"
"$python" -m mypy --cache-dir "$target/mypy" python/mavc python/tests/test_typed.py
"$python" -m pytest "${chosen[@]}" "$@" python/tests
"$python" python/notebooks/run.py python/notebooks/tutorial.ipynb
