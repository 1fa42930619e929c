"""What analyses, plans, flights and campaigns give. All numbers are in SI units."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from . import _mavc, display
from .errors import Diagnostics
from .exports import Exported, exported
from .runs import Callback, Cancel, job
from .table import Records, Rows, Table, numbers


Record = dict[str, Any]
"""An object of JSON, under the names of the schemas in docs/schema."""


def loaded(text: str) -> Record:
    """The object of a text."""
    record: Record = json.loads(text)
    return record


def _array(values: Any) -> np.ndarray:
    return np.array([np.nan if value is None else value for value in values], dtype=float)


def _number(value: float | None) -> float:
    return np.nan if value is None else value


@dataclass(frozen=True)
class Mode:
    """What a vehicle can do in one fault mode; `mavc analyze` reports the same."""

    name: str
    lost: tuple[int, ...]
    """Numbers of the lost rotors, from 1."""
    capacity: np.ndarray
    """For each rotor the share of its thrust that is left."""
    outcome: str
    """`full control`, `flies on, heading not held`, `caught by spinning`, `no margin`, `lost` or `undecided`."""
    verdict: str
    """The paper's word: `controllable`, `stabilizable` or `unstable`."""
    hover: str
    """Where hover lies relative to the set: `inside`, `on the edge` or `outside`."""
    interior: bool
    acai: float
    """The available control authority index, N m; its sign decides. NaN where the set has no interior."""
    acai_yaw_free: float
    critical_mass: float
    """The largest mass that hovers, kg; NaN if none does."""
    least_mass: float
    headroom: dict[str, tuple[float, float]] | None
    """How far thrust (N) and torques (N m) reach below and above hover."""
    record: Record = field(repr=False)
    """Every figure, under the names of the JSON."""

    @property
    def survives(self) -> bool:
        """Whether the vehicle stays in the air: with full control, without its heading, or caught by spinning."""
        return self.outcome in ("full control", "flies on, heading not held", "caught by spinning")


def _mode(record: Record) -> Mode:
    headroom = record["headroom"]
    return Mode(
        record["name"],
        tuple(record["lost"]),
        _array(record["capacity"]),
        record["outcome"],
        record["verdict"],
        record["hover"],
        record["interior"],
        _number(record["acai"]),
        _number(record["acai_yaw_free"]),
        _number(record["critical_mass_kg"]),
        _number(record["least_mass_kg"]),
        headroom and {axis: tuple(reach) for axis, reach in headroom.items()},
        record,
    )


@dataclass(frozen=True)
class Analysis:
    """The healthy vehicle, then every declared fault mode."""

    vehicle: str
    modes: tuple[Mode, ...] = field(repr=False)
    json: str = field(repr=False)
    """What `mavc analyze --format json` prints."""
    text: str = field(repr=False)
    """What `mavc analyze` prints."""
    headline: str = field(repr=False)
    """What the fault modes leave of the vehicle, in one line."""
    diagnostics: Diagnostics = field(repr=False)

    def __repr__(self) -> str:
        return f"<Analysis: {self.headline}>"

    def __getitem__(self, mode: str) -> Mode:
        for found in self.modes:
            if found.name == mode:
                return found
        raise KeyError(mode)

    def __str__(self) -> str:
        return self.text

    @property
    def faults(self) -> tuple[Mode, ...]:
        return self.modes[1:]

    @property
    def survived(self) -> int:
        """The number of fault modes after which the vehicle stays in the air; `headline` counts them by outcome."""
        return sum(mode.survives for mode in self.faults)

    @property
    def margins(self) -> np.ndarray:
        """The control authority index of each fault mode, N m."""
        return np.array([mode.acai for mode in self.faults])

    @cached_property
    def record(self) -> Record:
        return loaded(self.json)

    def _repr_html_(self) -> str:
        return display.analysis(self)


def analysis(texts: tuple[str, str, str], diagnostics: Diagnostics) -> Analysis:
    record = loaded(texts[0])
    return Analysis(record["vehicle"], tuple(map(_mode, record["modes"])), *texts, diagnostics)


class Trajectory(Table):
    """A trajectory: one row for each node, or at a rate. With n rows and k rotors."""

    def __init__(self, csv: str) -> None:
        super().__init__(numbers(csv), csv)

    def _stacked(self, *names: str) -> np.ndarray:
        return np.column_stack([self[name] for name in names])

    @property
    def time(self) -> np.ndarray:
        """s since the start, (n,)"""
        return self["t"]

    @property
    def position(self) -> np.ndarray:
        """m; x to the east, y to the north, z up; (n, 3)"""
        return self._stacked("x", "y", "z")

    @property
    def velocity(self) -> np.ndarray:
        """m/s, (n, 3)"""
        return self._stacked("vx", "vy", "vz")

    @property
    def acceleration(self) -> np.ndarray:
        """m/s^2, (n, 3)"""
        return self._stacked("ax", "ay", "az")

    @property
    def jerk(self) -> np.ndarray:
        """m/s^3, (n, 3)"""
        return self._stacked("jx", "jy", "jz")

    @property
    def snap(self) -> np.ndarray:
        """m/s^4, (n, 3)"""
        return self._stacked("sx", "sy", "sz")

    @property
    def yaw(self) -> np.ndarray:
        """rad, (n,)"""
        return self["yaw"]

    @property
    def yaw_rate(self) -> np.ndarray:
        """rad/s, (n,)"""
        return self["yaw_rate"]

    @property
    def thrust(self) -> np.ndarray:
        """N, (n,)"""
        return self["thrust"]

    @property
    def torque(self) -> np.ndarray:
        """N m about the body's axes, (n, 3)"""
        return self._stacked("tau_x", "tau_y", "tau_z")

    @property
    def rotor_speed(self) -> np.ndarray:
        """rad/s, (n, k)"""
        return self._stacked(*(name for name in self if name.startswith("omega_")))

    @property
    def waypoint(self) -> np.ndarray:
        """The number of the waypoint that a row marks, from 1; 0 for none; (n,)"""
        return self["waypoint"].astype(np.int64)


class Log(Table):
    """The log of a flight (docs/flight.md describes the columns)."""

    def __init__(self, csv: str) -> None:
        super().__init__(numbers(csv), csv)

    time = property(lambda self: self["t"], doc="s, (n,)")
    position = property(lambda self: np.column_stack([self[name] for name in "xyz"]), doc="m, (n, 3)")
    velocity = property(lambda self: np.column_stack([self["v" + name] for name in "xyz"]), doc="m/s, (n, 3)")
    error = property(lambda self: self["error"], doc="Distance from the reference, m, (n,)")


# The columns of `Plan.ways_out`.
_WAYS_OUT = {"mode": str, "from_s": float, "to_s": float, "outcome": str, "site": str, "branch": str}


@dataclass(frozen=True)
class Plan:
    """The outcome of planning: a plan, a proof that there is none, or neither."""

    verdict: str
    """`found`, `proved infeasible`, `not found` or `not attempted`."""
    trajectory: Trajectory | None = field(repr=False)
    """One row for each node; `None` if no plan was found."""
    json: str = field(repr=False)
    """What `mavc plan --report` writes."""
    text: str = field(repr=False)
    """What `mavc plan` prints."""
    diagnostics: Diagnostics = field(repr=False)
    """Warnings, and why there is no plan, as `mavc plan` prints them to standard error."""
    _handle: Any = field(repr=False)

    def __repr__(self) -> str:
        return f"<Plan: {self.headline}>"

    def __str__(self) -> str:
        return self.text

    @property
    def headline(self) -> str:
        """Whether there is a plan, in one line, as in the terminal."""
        headline: str = self.planner["headline"]
        return headline

    @property
    def price(self) -> Record | None:
        """What covering the fault modes costs against a plan that ignores them: `sentence` as in the terminal, `more_time_s`
        (s), `more_energy_j` (J) and `still_unsafe`, among others (docs/schema); `None` without a plan, and if no mode is
        planned against."""
        price: Record | None = self.planner["price"]
        return price

    @property
    def recovery(self) -> Record | None:
        """What can be done after each fault: `uncovered`, the share of the time without a way out, and `modes`, among others
        (docs/schema); `None` if it was not sought."""
        recovery: Record | None = self.record.get("recovery")
        return recovery

    @property
    def ways_out(self) -> Records:
        """One row for each time during which the faults of a mode have one outcome, in s since the start: the mode, `from_s`,
        `to_s`, `outcome` (`none` where no way out was found), `site`, and `branch`, a key of `branches`. No rows if none was sought."""
        modes: list[Record] = (self.recovery or {}).get("modes", [])
        return Records(_WAYS_OUT, ({"mode": mode["name"], **piece} for mode in modes for piece in mode["pieces"]))

    def branches(self, *, threads: int | None = None) -> dict[str, Trajectory]:
        """The ways out as trajectories from the detection of the fault on, by the file names of `mavc plan --branches`.

        Raises ValueError if no ways out were sought.
        """
        found = _mavc.branches(self._handle, *job(threads, None, None))
        return {name: Trajectory(data.decode()) for name, data in found if name != "index.csv"}

    def __bool__(self) -> bool:
        """Whether there is a plan."""
        return self.trajectory is not None

    @property
    def csv(self) -> str | None:
        """What `mavc plan -o` writes; `None` without a plan."""
        return self.trajectory.csv if self.trajectory is not None else None

    @cached_property
    def record(self) -> Record:
        return loaded(self.json)

    @property
    def planner(self) -> Record:
        """The record of the planner whose plan this is."""
        planners: list[Record] = self.record["planners"]
        return planners[-1]

    @property
    def time(self) -> float:
        """The mission time, s; NaN without a plan."""
        return _number(self.planner["time_s"]) if self else np.nan

    @property
    def explanation(self) -> str:
        """The verdict in words, and why there is no plan."""
        why = [d.message for d in self.diagnostics if not self and d.severity == "error"]
        return "; ".join([self.planner["statement"], *why])

    def at(self, rate: float, *, threads: int | None = None) -> Trajectory:
        """The trajectory with rows at a rate, Hz: what `mavc plan -o --rate` writes."""
        return Trajectory(_mavc.table(self._handle, *job(threads, None, None), rate))

    def export(
        self,
        format: str,
        path: str | os.PathLike[str] | None = None,
        *,
        rate: float | None = None,
        tolerance: float | None = None,
        frame: str | None = None,
        threads: int | None = None,
    ) -> Exported:
        """The plan for another tool: what `mavc plan -o --format` writes, `"px4-offboard"` for instance (docs/exchange.md lists the
        formats). `rate` is in Hz, `tolerance` in m, and `frame` is `"enu-flu"` or `"ned-frd"`. With `path` it is written there too.

        Raises ValueError if there is no plan, the format cannot carry it, or the arguments do not go together.
        """
        found = _mavc.export(self._handle, *job(threads, None, None), format, rate, frame, tolerance)
        return exported(format, found, path)

    def certificate(
        self, *, threads: int | None = None, progress: Callback = None, cancel: Cancel | None = None
    ) -> str:
        """The certificate of the plan or of the proof that there is none: what `mavc plan --certificate` writes."""
        return _mavc.certificate(self._handle, *job(threads, progress, cancel))

    def html(self, *, threads: int | None = None) -> str:
        """The report as one page: what `mavc plan --html` writes."""
        return _mavc.page(self._handle, *job(threads, None, None))

    def _repr_html_(self) -> str:
        return display.page(self.html())


@dataclass(frozen=True)
class Simulation:
    """A simulated flight along a plan."""

    plan: Plan
    verdict: str
    """`simulated`, or the verdict of the plan if there is none to fly."""
    outcome: str | None
    """`flown`, `landed`, `trespassed`, `lost` or `diverged`; `None` without a flight."""
    log: Log | None = field(repr=False)
    json: str = field(repr=False)
    """What `mavc simulate --report` writes."""
    text: str = field(repr=False)
    """What `mavc simulate` prints."""
    diagnostics: Diagnostics = field(repr=False)
    remark: str | None = field(default=None, repr=False)
    """A note if the rate of the log is not the requested one."""

    def __str__(self) -> str:
        return self.text

    @property
    def csv(self) -> str | None:
        """What `mavc simulate -o` writes; `None` without a flight."""
        return self.log.csv if self.log is not None else None

    @cached_property
    def record(self) -> Record:
        return loaded(self.json)

    def export(
        self,
        format: str,
        path: str | os.PathLike[str] | None = None,
        *,
        rate: float | None = None,
        layout: str | os.PathLike[str] | None = None,
        threads: int | None = None,
    ) -> Exported:
        """The log for another tool: what `mavc simulate -o --format` writes, `"mcap"` or `"ulog"` for instance, with rows at `rate`
        (Hz). With `path` it is written there too; a layout that shows it is written to `layout`. The flight is simulated again.

        Raises ValueError if there is no flight, or the format has no layout.
        """
        # Before anything is written.
        shown = None if layout is None else _mavc.layout(self.plan._handle, format)
        found = _mavc.export_log(self.plan._handle, *job(threads, None, None), format, rate)
        result = exported(format, found, path)
        if layout is not None and shown is not None:
            Path(layout).write_text(shown, encoding="utf-8", newline="\n")
        return result

    def html(self, *, threads: int | None = None) -> str:
        """The report as one page: what `mavc simulate --html` writes. The flight is simulated again."""
        if self.log is None:
            return self.plan.html(threads=threads)
        page: str = _mavc.simulate(self.plan._handle, *job(threads, None, None), None, True)[5]
        return page

    def _repr_html_(self) -> str:
        return display.page(self.html())


@dataclass(frozen=True)
class Campaign:
    """Simulated flights of every planner's plan with every fault mode."""

    verdict: str
    """`simulated`, or the verdict about the plans if there is none to fly."""
    rows: Rows
    """One row for each flight."""
    json: str = field(repr=False)
    """What `mavc campaign --report` writes."""
    text: str = field(repr=False)
    """What `mavc campaign` prints."""
    diagnostics: Diagnostics = field(repr=False)
    _page: str = field(repr=False)

    def __str__(self) -> str:
        return self.text

    @cached_property
    def record(self) -> Record:
        return loaded(self.json)

    def html(self) -> str:
        """The report as one page: what `mavc campaign --html` writes."""
        return self._page

    def _repr_html_(self) -> str:
        return display.campaign(self)
