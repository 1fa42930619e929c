"""What can go wrong."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Iterable


@dataclass(frozen=True)
class Place:
    """A part of a file; lines and columns count from 1, columns in characters."""

    file: str
    line: int
    column: int
    end_line: int
    end_column: int


@dataclass(frozen=True)
class Label:
    """A place with what is wrong or worth knowing there."""

    message: str
    place: Place


@dataclass(frozen=True)
class Fix:
    """An edit that fixes the problem: replace the text at the place."""

    text: str
    place: Place


@dataclass(frozen=True)
class Diagnostic:
    """One finding about a spec. `mavc explain CODE` describes the code."""

    code: str
    severity: str
    """`error`, `warning` or `advice`."""
    message: str
    place: Place
    labels: tuple[Label, ...] = ()
    help: str | None = None
    fixes: tuple[Fix, ...] = ()

    def __str__(self) -> str:
        return f"{self.place.file}:{self.place.line}:{self.place.column}: {self.severity}[{self.code}]: {self.message}"


class Diagnostics(tuple[Diagnostic, ...]):
    """Diagnostics in the order of the terminal; `str` gives the text that commands print."""

    text: str

    def __new__(cls, found: Iterable[Diagnostic] = (), text: str = "") -> Diagnostics:
        self = super().__new__(cls, found)
        self.text = text
        return self

    def __str__(self) -> str:
        return self.text

    def __add__(self, other: object) -> Diagnostics:
        assert isinstance(other, Diagnostics)
        return Diagnostics(tuple(self) + tuple(other), self.text + other.text)

    def __reduce__(self) -> tuple[Any, ...]:
        return Diagnostics, (tuple(self), self.text)

    @property
    def errors(self) -> tuple[Diagnostic, ...]:
        return tuple(d for d in self if d.severity == "error")


def diagnostics(shown: tuple[str, str]) -> Diagnostics:
    """From the text of the terminal, and a line of JSON for each."""
    text, lines = shown
    return Diagnostics(map(_diagnostic, lines.splitlines()), text)


def _diagnostic(line: str) -> Diagnostic:
    record = json.loads(line)
    return Diagnostic(
        record["code"],
        record["severity"],
        record["message"],
        _place(record),
        tuple(Label(label["message"], _place(label)) for label in record["labels"]),
        record["help"],
        tuple(Fix(fix["text"], _place(fix)) for fix in record["fixes"]),
    )


def _place(of: dict[str, Any]) -> Place:
    return Place(of["file"], of["line"], of["column"], of["end_line"], of["end_column"])


class SpecError(ValueError):
    """A text is not a spec, or nothing can be planned or flown for it. `str` is what the terminal prints."""

    def __init__(self, diagnostics: Diagnostics) -> None:
        super().__init__(str(diagnostics).rstrip("\n"))
        self.diagnostics = diagnostics

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.diagnostics,)


class Rejected(SpecError):
    """A certificate does not hold for a spec."""


@dataclass(frozen=True)
class Problem:
    """One mistake in a spec that was built from values."""

    field: str
    """The call that made it, such as `plan.samples` or `mission.waypoints[2]`."""
    code: str
    message: str
    label: str | None = None
    help: str | None = None

    def __str__(self) -> str:
        label = f": {self.label}" if self.label else ""
        help = "; " + "; ".join(line.strip() for line in self.help.splitlines()) if self.help else ""
        return f"{self.field}: {self.message}{label}{help} ({self.code})"


class BuildError(ValueError):
    """Values are not those of a spec; every mistake is listed with the call that made it."""

    def __init__(self, problems: tuple[Problem, ...], text: str) -> None:
        super().__init__("\n".join(map(str, problems)))
        self.problems = problems
        self.text = text
        """The text that was built."""

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.problems, self.text)


class Cancelled(Exception):
    """A run was cancelled by its `Cancel`."""


class InternalError(RuntimeError):
    """A bug of mavc: a panic of its native part."""


class SpecWarning(UserWarning):
    """Warnings and advice about a spec that was compiled."""
