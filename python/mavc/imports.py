"""Specs from the files of other tools (docs/px4.md, docs/ardupilot.md, docs/missions.md)."""

from __future__ import annotations

import os
import warnings as issued
from pathlib import Path
from typing import Iterable

from . import _mavc
from .errors import Diagnostics, SpecError, SpecWarning, diagnostics
from .spec import source_of

# A text in one of the formats has at least one of these; the name of a file seldom does.
_MARKS = "\n<{"


class Imported(str):
    """The text of a spec from the file of another tool: `mavc.compile(text, set={"vehicle.mass": 1.5})` compiles it."""

    left_out: tuple[str, ...]
    """What a spec has no word for, in the words of the file."""
    unknown: tuple[str, ...]
    """The fields for which the text has `?`, as `set` of `mavc.compile` takes them. A `?` of a single rotor is not among them: it has
    to be replaced in the text."""
    warnings: Diagnostics

    def __new__(
        cls,
        text: str,
        left_out: Iterable[str] = (),
        unknown: Iterable[str] = (),
        warnings: Diagnostics = Diagnostics(),
    ) -> Imported:
        self = super().__new__(cls, text)
        self.left_out, self.unknown, self.warnings = tuple(left_out), tuple(unknown), warnings
        return self


def import_vehicle(source: str | os.PathLike[str], *, name: str | None = None, warn: bool = True) -> Imported:
    """The spec of a vehicle, from parameters of PX4 or ArduPilot, from URDF, SDF or MJCF: what `mavc import vehicle` writes.

    A `str` with a line break, `<` or `{` is a text, any other one the name of a file. The vehicle is called after `name`, by default
    the file's. Figures that the file does not give are `?`; `Imported.unknown` lists them. Warnings are issued as `SpecWarning`
    unless `warn` is false.

    Raises SpecError, with places in the file, if no vehicle can be made of it, and OSError if it cannot be read.
    """
    name, data = source_of(source, name, _MARKS, "<imported>")
    return _imported(_mavc.import_vehicle(name, data), warn)


def import_mission(
    source: str | os.PathLike[str],
    *,
    vehicle: str | os.PathLike[str] | None = None,
    folder: str | os.PathLike[str] = ".",
    name: str | None = None,
    warn: bool = True,
) -> Imported:
    """The spec of a ground station's mission: what `mavc import mission` writes.

    With `vehicle`, the name of a spec, the text begins with `use` of it, as seen from `folder`, in which the text is to be saved or
    compiled. The other arguments and the errors are those of `import_vehicle`.
    """
    name, data = source_of(source, name, _MARKS, "<imported>")
    used = None
    if vehicle is not None:
        path = Path(vehicle).resolve(strict=True)
        used = (_seen(path, Path(folder).resolve(strict=True)), str(path))
    return _imported(_mavc.import_mission(name, data, used), warn)


def _seen(path: Path, folder: Path) -> str:
    """A path relative to a folder."""
    try:
        return Path(os.path.relpath(path, folder)).as_posix()
    except ValueError:
        # Another drive, of which only the whole path tells.
        return path.as_posix()


def _imported(found: tuple[str | None, list[str], list[str], _mavc.Shown], warn: bool) -> Imported:
    text, left_out, unknown, shown = found
    known = diagnostics(shown)
    if text is None:
        raise SpecError(known)
    if warn and known:
        issued.warn(f"\n{known}", SpecWarning, stacklevel=3)
    return Imported(text, left_out, unknown, known)
