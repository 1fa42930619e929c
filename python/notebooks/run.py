"""Runs a notebook, and compares what its cells print and show with what it has stored.

    python python/notebooks/run.py NOTEBOOK [--write]

Fails where a cell raises, where words differ, or where a number differs by more than 1 %. Of pictures only the presence and the size are
checked. With `--write` the new outputs are stored. The cells run in a copy of the notebook's folder, in a shell of IPython: the packages
that run notebooks in processes of their own are many times larger.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import re
import shutil
import sys
import tempfile
from pathlib import Path
from typing import Any

from IPython.core.displayhook import DisplayHook
from IPython.core.interactiveshell import InteractiveShell
from IPython.utils.capture import capture_output
from traitlets import Type
from traitlets.config import Config

LARGEST_PICTURE = 60_000
"""Bytes, as base64."""
TOLERANCE = 0.01
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w.])")

Cell = dict[str, Any]


class Results(DisplayHook):
    """Keeps the value of a cell's last expression, in every form that it has, instead of printing it."""

    found: Cell | None = None

    def write_output_prompt(self) -> None:
        pass

    def write_format_data(self, format_dict: Cell, md_dict: Cell | None = None) -> None:
        self.found = format_dict

    def finish_displayhook(self) -> None:
        pass


class Shell(InteractiveShell):
    """A shell without windows, colours and a history on the disk."""

    displayhook_class = Type(Results)

    def __init__(self, **options: Any) -> None:
        config = Config({"HistoryManager": {"enabled": False}})
        super().__init__(config=config, colors="nocolor", **options)
        self.display_formatter.active_types = ["text/plain", "text/html", "image/png"]

    def enable_gui(self, gui: str | None = None) -> None:
        """`%matplotlib inline` calls it; pictures need no window."""


def lines(text: str) -> list[str]:
    return text.splitlines(keepends=True)


def shown(data: Cell) -> Cell:
    return {kind: value if kind == "image/png" else lines(value) for kind, value in data.items()}


def run(shell: InteractiveShell, cell: Cell, count: int) -> list[Cell]:
    """The outputs of a cell in the form of notebooks."""
    shell.displayhook.found = None
    with capture_output(stderr=False) as caught:
        result = shell.run_cell("".join(cell["source"]), store_history=True)
    if not result.success:
        sys.exit(f"{caught.stdout}\ncell {cell['id']} raised an exception")
    outputs: list[Cell] = []
    if caught.stdout:
        outputs.append({"name": "stdout", "output_type": "stream", "text": lines(caught.stdout)})
    for picture in caught.outputs:
        outputs.append({"data": shown(picture.data), "metadata": {}, "output_type": "display_data"})
    if shell.displayhook.found is not None:
        data = shown(shell.displayhook.found)
        outputs.append({"data": data, "execution_count": count, "metadata": {}, "output_type": "execute_result"})
    return outputs


def texts(outputs: list[Cell]) -> list[tuple[str, str]]:
    """The kinds and texts of outputs; of pictures only the kind."""
    found = []
    for output in outputs:
        for kind, value in output.get("data", {"stdout": output.get("text")}).items():
            found.append((kind, "" if kind == "image/png" else "".join(value)))
    return found


def same(stored: str, found: str) -> bool:
    """Whether words are equal, and numbers nearly so."""
    pairs = zip(NUMBER.findall(stored), NUMBER.findall(found))
    near = all(math.isclose(float(a), float(b), rel_tol=TOLERANCE, abs_tol=1e-9) for a, b in pairs)
    return near and NUMBER.sub("0", stored).split() == NUMBER.sub("0", found).split()


def compare(cell: Cell, outputs: list[Cell]) -> list[str]:
    """What is wrong with the new outputs of a cell."""
    stored, found = texts(cell["outputs"]), texts(outputs)
    wrong = []
    if [kind for kind, _ in stored] != [kind for kind, _ in found]:
        wrong.append(f"cell {cell['id']} shows other things: run with --write and look at the difference")
    for (kind, before), (_, now) in zip(stored, found):
        if not same(before, now):
            wrong.append(f"cell {cell['id']}, {kind}, stored:\n{before}\nnow:\n{now}")
    pictures = [output["data"].get("image/png", "") for output in outputs if "data" in output]
    wrong += [f"cell {cell['id']} has a picture of {len(p)} bytes" for p in pictures if len(p) > LARGEST_PICTURE]
    return wrong


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    arguments.add_argument("notebook", type=Path)
    arguments.add_argument("--write", action="store_true", help="store the new outputs")
    options = arguments.parse_args()
    path = options.notebook.resolve()
    notebook = json.loads(path.read_text(encoding="utf-8"))
    shell = Shell.instance()
    wrong = []
    scratch = tempfile.TemporaryDirectory()
    os.chdir(shutil.copytree(path.parent, Path(scratch.name) / "notebooks"))
    try:
        for count, cell in enumerate((cell for cell in notebook["cells"] if cell["cell_type"] == "code"), 1):
            outputs = run(shell, cell, count)
            wrong += [] if options.write else compare(cell, outputs)
            cell.update(execution_count=count, outputs=outputs)
    finally:
        os.chdir(path.parent)
        scratch.cleanup()
    if wrong:
        sys.exit("\n".join(wrong))
    if options.write:
        path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    print(f"{path.name}: every cell ran{'' if options.write else ', with the stored outputs'}")


if __name__ == "__main__":
    main()
