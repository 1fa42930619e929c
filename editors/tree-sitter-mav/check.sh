#!/usr/bin/env bash
# The checked-in parser, compiled by the C compiler and run from Python: specs, corpus, queries (see check.py). The
# binding comes from PyPI, pinned in requirements.txt, into a virtual environment below target/.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../.."
venv=target/tree-sitter
if ! cmp -s "$here/requirements.txt" "$venv/requirements.txt"; then
    rm -rf "$venv"
    python3 -m venv "$venv"
    "$venv/bin/pip" install --quiet --requirement "$here/requirements.txt"
    cp "$here/requirements.txt" "$venv/requirements.txt"
fi
"${CC:-cc}" -std=c11 -O1 -fPIC -shared -Wall -Wextra -I "$here/src" "$here"/src/{parser,scanner}.c -o "$venv/mav.so"
exec "$venv/bin/python" -B "$here/check.py" "$venv/mav.so"
