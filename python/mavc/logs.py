"""Flight logs of ArduPilot, PX4 and mavc (docs/diagnose.md, docs/identify.md)."""

from __future__ import annotations

import os
import warnings as issued
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Iterable, Union

from . import _mavc
from .errors import Diagnostics, SpecError, SpecWarning, diagnostics
from .quantity import written
from .results import Record, loaded
from .runs import Callback, Cancel, job
from .spec import Spec
from .table import Records, Table

Source = Union[str, "os.PathLike[str]", bytes]
"""The name of a log, or its bytes."""

# The columns of the frames and their types, under the names of docs/schema/diagnose.schema.json. An interval has two columns.
_LOSSES = {
    "motor": int,
    "time_s": float,
    "interval_s_low": float,
    "interval_s_high": float,
    "capacity": float,
    "capacity_interval_low": float,
    "capacity_interval_high": float,
    "kind": str,
    "evidence": str,
    "alternatives": str,
    "outcome": str,
}
_CAPACITIES = {
    "motor": int,
    "capacity": float,
    "interval_low": float,
    "interval_high": float,
    "change": float,
    "is_significant": bool,
}
_FLIGHTS = {
    "from_s": float,
    "to_s": float,
    "end": str,
    "searched_from_s": float,
    "impact_s": float,
    "impact_m_per_s": float,
    "impact_interval_m_per_s_low": float,
    "impact_interval_m_per_s_high": float,
    "tilt_deg": float,
    "yaw_rate_deg_per_s": float,
}
_FIGURES = {"field": str, "value": float, "low": float, "high": float, "remark": str}


@dataclass(frozen=True)
class Diagnosis:
    """Which motors lost thrust in a flight. Motors have the autopilot's numbers, from 1."""

    answer: str
    """`loss`, `weaker` if a motor gives less thrust than in the baseline, `none`, or `unknown` if the log does not show it."""
    losses: tuple[Record, ...] = field(repr=False)
    """Motors that lost thrust, in the order of time, under the names of docs/schema/diagnose.schema.json."""
    capacities: tuple[Record, ...] = field(repr=False)
    """The capacity of each motor relative to the strongest before the first loss; empty if no part of the flight is quiet."""
    flights: tuple[Record, ...] = field(repr=False)
    unknown: tuple[str, ...] = field(repr=False)
    """What the log does not show, each with the parameter to set."""
    json: str = field(repr=False)
    """What `mavc diagnose --format json` prints."""
    text: str = field(repr=False)
    """What `mavc diagnose` prints."""
    diagnostics: Diagnostics = field(repr=False)
    """Warnings about the log."""

    def __repr__(self) -> str:
        return f"<Diagnosis: {self.headline}>"

    def __str__(self) -> str:
        return self.text

    @property
    def headline(self) -> str:
        """The first line of the text, without the breaks of a terminal."""
        lines = self.text.splitlines()
        rest = []
        for line in lines[1:]:
            if not line.startswith("  ") or line.lstrip().startswith("!"):
                break
            rest.append(line.strip())
        return " ".join([lines[0], *rest])

    @property
    def motors(self) -> tuple[int, ...]:
        """The motors that lost thrust, in the order of time."""
        return tuple(loss["motor"] for loss in self.losses)

    @cached_property
    def record(self) -> Record:
        return loaded(self.json)

    @cached_property
    def frames(self) -> dict[str, Table]:
        """`losses`, `capacities` and `flights` as tables: `frames["losses"].to_pandas()`, or `to_polars()`, `to_arrow()`. An
        interval has the columns `..._low` and `..._high`; other motors that explain a loss as well are a text, such as `2 5`."""
        return {
            "losses": Records(_LOSSES, map(_flat, self.losses)),
            "capacities": Records(_CAPACITIES, map(_flat, self.capacities)),
            "flights": Records(_FLIGHTS, map(_flat, self.flights)),
        }


def _flat(record: Record) -> Record:
    """A record whose values are numbers, texts and truth values."""
    flat: Record = {}
    for name, value in record.items():
        if name == "alternatives":
            flat[name] = " ".join(map(str, value)) or None
        elif isinstance(value, list):  # an interval; without one both columns are empty
            flat[f"{name}_low"], flat[f"{name}_high"] = value
        else:
            flat[name] = value
    return flat


@dataclass(frozen=True)
class Figure:
    """A figure of a vehicle that flew, in SI units."""

    field: str
    """As `set` of `mavc.compile` takes it: `vehicle.rotor.max_thrust`."""
    value: float | None
    """`None` for one written as `?`."""
    interval: tuple[float, float] | None
    """The ends of the 95 % interval, if the flight gives one."""
    remark: str
    """Where the value is from, or which flight or measurement would show it."""


class Identified(str):
    """The text of the spec of a vehicle that flew: `mavc.compile(text, set={"arm": "30 cm", ...})` compiles it."""

    figures: tuple[Figure, ...]
    """The figures that were identified or are missing, in the order of the text."""
    warnings: Diagnostics

    def __new__(
        cls, text: str, figures: Iterable[Figure] = (), warnings: Diagnostics = Diagnostics()
    ) -> Identified:
        self = super().__new__(cls, text)
        self.figures, self.warnings = tuple(figures), warnings
        return self

    @property
    def unknown(self) -> tuple[str, ...]:
        """The fields for which the text has `?`, as `set` of `mavc.compile` takes them."""
        return tuple(figure.field for figure in self.figures if figure.value is None)

    @property
    def frames(self) -> dict[str, Table]:
        """The figures as a table, `frames["figures"].to_pandas()`: field, value, low, high, remark."""
        rows = []
        for figure in self.figures:
            low, high = figure.interval or (None, None)
            rows.append(dict(zip(_FIGURES, (figure.field, figure.value, low, high, figure.remark))))
        return {"figures": Records(_FIGURES, rows)}


def diagnose(
    log: Source,
    spec: Spec | None = None,
    baseline: Iterable[Source] = (),
    *,
    hide: Iterable[int] = (),
    warn: bool = True,
    threads: int | None = None,
    progress: Callback = None,
    cancel: Cancel | None = None,
) -> Diagnosis:
    """Which motors lost thrust in the flight of a log, when, and what that left of the vehicle: what `mavc diagnose` reports.

    `log` is the name of a DataFlash log of ArduPilot or a ULog, or its bytes. `spec` is the vehicle's; without it the frame comes
    from the log's parameters. `baseline` are logs of good flights with the same load. The outputs of the motors `hide` are not
    looked at. Warnings are issued as `SpecWarning` unless `warn` is false.

    Raises SpecError if the file is no log or nothing says where the motors are, and OSError if it cannot be read.
    """
    handle = None if spec is None else spec._handle
    good = [_given(one) for one in ([baseline] if isinstance(baseline, (str, bytes, os.PathLike)) else baseline)]
    found = _mavc.diagnose(_given(log), *job(threads, progress, cancel), handle, list(hide), good)
    text, screen, shown = found
    known = _checked(text is None, shown, warn)
    record = loaded(text or "{}")
    losses, capacities = tuple(record["losses"]), tuple(record["capacities"])
    flights, unknown = tuple(record["flights"]), tuple(record["unknown"])
    return Diagnosis(record["answer"], losses, capacities, flights, unknown, text or "", screen, known)


def identify(
    log: Source,
    mass: Any,
    *,
    warn: bool = True,
    threads: int | None = None,
    progress: Callback = None,
    cancel: Cancel | None = None,
) -> Identified:
    """The spec of the vehicle that flew: what `mavc identify` writes. `mass` is in kg, `"1.5 kg"`, or a quantity of `pint`.

    Figures that the flight does not show are `?`. The other arguments and the errors are those of `diagnose`; a log without
    a flight is a SpecError too, and a mass that is none a ValueError.
    """
    found = _mavc.identify(_given(log), *job(threads, progress, cancel), written("vehicle.mass", mass))
    text, figures, shown = found
    known = _checked(text is None, shown, warn)
    return Identified(text or "", (Figure(*figure) for figure in figures), known)


def _given(log: Source) -> tuple[str, bytes | None]:
    if isinstance(log, bytes):
        return "<log>", log
    name = os.fspath(log)
    # Here, because the error has the name.
    with open(name, "rb"):
        return name, None


def _checked(is_refused: bool, shown: _mavc.Shown, warn: bool) -> Diagnostics:
    """The diagnostics, as an exception or as warnings."""
    known = diagnostics(shown)
    if is_refused:
        raise SpecError(known)
    if warn and known:
        issued.warn(f"\n{known}", SpecWarning, stacklevel=3)
    return known
