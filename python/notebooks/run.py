"""Runs a notebook, and compares what its cells print and show with what it has stored.

    python python/notebooks/run.py NOTEBOOK [--write]

Fails where a cell raises, where words differ, or where a number differs by more than 1 %. Of pictures only the presence and the size are
checked. With `--write` the new outputs are stored. The cells run in a copy of the notebook's folder.
"""

from __future__ import annotations

import argparse
import copy
import math
import os
import re
import shutil
import sys
import tempfile
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError
from nbformat import NotebookNode

LARGEST_PICTURE = 60_000
"""Bytes, as base64."""
TOLERANCE = 0.01
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w.])")


def executed(notebook: NotebookNode, folder: Path) -> NotebookNode:
    """The notebook with the outputs of its cells, run in a copy of a folder.

    Raises CellExecutionError where a cell raises.
    """
    result = copy.deepcopy(notebook)
    with tempfile.TemporaryDirectory() as scratch:
        place = shutil.copytree(folder, Path(scratch) / "notebooks")
        # The kernel keeps its history there, and does not warn that it listens to this machine.
        os.environ["IPYTHONDIR"] = scratch
        options = {"resources": {"metadata": {"path": str(place)}}, "extra_arguments": ["--log-level=ERROR"]}
        NotebookClient(result, kernel_name="python3", record_timing=False, **options).execute()
    return result


def texts(cell: NotebookNode) -> list[tuple[str, str]]:
    """The kinds and texts of a cell's outputs; of pictures only the kind."""
    found = []
    for output in cell.get("outputs", []):
        for kind, value in sorted(output.get("data", {output.get("name"): output.get("text")}).items()):
            found.append((kind, "" if kind == "image/png" else value))
    return found


def same(stored: str, found: str) -> bool:
    """Whether words are equal, and numbers nearly so."""
    pairs = zip(NUMBER.findall(stored), NUMBER.findall(found))
    near = all(math.isclose(float(a), float(b), rel_tol=TOLERANCE, abs_tol=1e-9) for a, b in pairs)
    return near and NUMBER.sub("0", stored).split() == NUMBER.sub("0", found).split()


def differences(stored: NotebookNode, found: NotebookNode) -> list[str]:
    """What is wrong with the new outputs of a cell."""
    before, now = texts(stored), texts(found)
    wrong = []
    if [kind for kind, _ in before] != [kind for kind, _ in now]:
        wrong.append(f"cell {stored.id} shows {[kind for kind, _ in now]}, not {[kind for kind, _ in before]}")
    for (kind, old), (_, new) in zip(before, now):
        if not same(old, new):
            wrong.append(f"cell {stored.id}, {kind}, stored:\n{old}\nnow:\n{new}")
    pictures = [output.data.get("image/png", "") for output in found.get("outputs", []) if "data" in output]
    wrong += [f"cell {stored.id} has a picture of {len(p)} bytes" for p in pictures if len(p) > LARGEST_PICTURE]
    return wrong


def main() -> None:
    arguments = argparse.ArgumentParser()
    arguments.add_argument("notebook", type=Path)
    arguments.add_argument("--write", action="store_true", help="store the new outputs")
    options = arguments.parse_args()
    stored = nbformat.read(options.notebook, 4)
    try:
        found = executed(stored, options.notebook.resolve().parent)
    except CellExecutionError as error:
        sys.exit(str(error))
    if options.write:
        found.metadata = stored.metadata
        nbformat.write(found, options.notebook)
        print(f"{options.notebook.name}: every cell ran, and its outputs are stored")
        return
    wrong = [line for pair in zip(stored.cells, found.cells) for line in differences(*pair)]
    if wrong:
        sys.exit("\n".join(wrong) + "\nafter an intended change run this with --write, and look at the difference")
    print(f"{options.notebook.name}: every cell ran, with the stored outputs")


if __name__ == "__main__":
    main()
