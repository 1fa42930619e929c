#!/usr/bin/env bash
# Tests the Python package against the command, with the library that `cargo test` builds.
#   bash python/check.sh [arguments of pytest]
set -euo pipefail
cd "$(dirname "$0")/.."
target="${CARGO_TARGET_DIR:-$PWD/target}"
# An example is among what is built so that features are unified as for tests: the library is not compiled a second time.
cargo build --quiet -p mavc -p mavc-python --lib --bins --example plan_without_text
cp "$target/debug/libmavc_python.so" python/mavc/_mavc.abi3.so
venv="$target/venv"
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
"$venv/bin/pip" install --quiet numpy pytest pint pyarrow pandas polars
MAVC="$target/debug/mavc" PYTHONPATH="$PWD/python" "$venv/bin/python" -m pytest "$@" python/tests
