"""Specs: from texts, files and other specs."""

from __future__ import annotations

import hashlib
import json
import os
import warnings
from functools import cache, cached_property
from pathlib import Path
from typing import Any, Iterable, Literal

from . import _mavc
from .errors import Diagnostics, Rejected, SpecError, SpecWarning, diagnostics
from .quantity import Overrides, overrides
from .results import Analysis, Campaign, Log, Plan, Record, Simulation, Trajectory, analysis, loaded
from .runs import Callback, Cancel, Job, job
from .table import Rows

Effort = Literal["quick", "normal", "thorough"]
"""How much of the solver's work a search for a plan may take."""


class Spec:
    """A spec without errors. It never changes; `set` makes another one."""

    def __init__(self, name: str, source: bytes, overrides: tuple[str, ...]) -> None:
        self.name = name
        """Its name in messages: that of the file, or `<spec>`."""
        self.overrides = overrides
        """The overrides, as `--set` takes them."""
        self._source = source
        self._handle, shown = _mavc.compile(name, source, list(overrides), True)
        self._unfit: Diagnostics | None = None
        if self._handle is None:
            # Mistakes in the blocks of flights matter only to flights, as with `mavc plan`.
            self._unfit = diagnostics(shown)
            self._handle, shown = _mavc.compile(name, source, list(overrides), False)
        self.warnings = diagnostics(shown)
        """Warnings and advice that it was compiled with; `check` finds more."""
        if self._handle is None:
            raise SpecError(self.warnings)

    def __repr__(self) -> str:
        set = "".join(f", {override}" for override in self.overrides)
        return f"<mavc.Spec {self.name}{set}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return Spec, (self.name, self._source, self.overrides)

    @property
    def text(self) -> str:
        """Its text, without the overrides."""
        return _mavc.facts(self._handle, "text")

    @cached_property
    def sha256(self) -> str:
        """The hash of all texts that were read, including the overrides: that of reports and certificates."""
        return _mavc.facts(self._handle, "sha256")

    @cached_property
    def modes(self) -> tuple[str, ...]:
        """The names of the declared fault modes."""
        return tuple(json.loads(_mavc.facts(self._handle, "modes")))

    @property
    def model(self) -> Record:
        """The vehicle and its fault modes: `mavc emit model --format json`."""
        return loaded(_mavc.facts(self._handle, "model"))

    @property
    def defaults(self) -> str:
        """The defaults that apply: `mavc check --explain-defaults`."""
        return _mavc.facts(self._handle, "defaults")

    def set(self, field: str, value: Any = None) -> Spec:
        """The same spec with one more field overridden, as by `--set`: `set("vehicle.mass", "2 kg")`, `set("vehicle.mass", 2.0)`
        in SI units, or `set("vehicle.mass = 2 kg")`. Quantities of `pint` keep their dimension, which is checked.

        Raises SpecError if the override has an error, or the spec with it.
        """
        given = [field] if value is None else {field: value}
        return Spec(self.name, self._source, (*self.overrides, *overrides(given)))

    def check(
        self, *, threads: int | None = None, progress: Callback = None, cancel: Cancel | None = None
    ) -> Diagnostics:
        """Everything that `mavc check` reports, errors about fault modes that the plan cannot tolerate included."""
        if self._unfit is not None:
            return self._unfit
        return diagnostics(_mavc.check(self._handle, *job(threads, progress, cancel)))

    def analyze(
        self,
        *,
        capture: bool = False,
        sweep: str | None = None,
        threads: int | None = None,
        progress: Callback = None,
        cancel: Cancel | None = None,
    ) -> Analysis:
        """What the vehicle can still do in each fault mode. `capture` and `sweep` are those of `mavc analyze`."""
        found = _mavc.analyze(self._handle, *job(threads, progress, cancel), capture, sweep)
        if isinstance(found, str):
            raise ValueError(found)
        return analysis(found, self.warnings)

    def plan(
        self,
        *,
        effort: Effort | None = None,
        recovery: bool = False,
        threads: int | None = None,
        progress: Callback = None,
        cancel: Cancel | None = None,
    ) -> Plan:
        """Plans the mission. That there is no plan is a verdict, not an exception. `effort` overrides `plan.effort`, as
        `--effort` does. With `recovery`, and if the spec requires it, a way out after every fault is sought: `Plan.ways_out`.

        Raises SpecError if nothing can be planned: there is no mission, or the spec is too large.
        """
        return self._with(effort)._plan(False, job(threads, progress, cancel), recovery)

    def _with(self, effort: Effort | None) -> Spec:
        return self if effort is None else self.set("plan.effort", effort)

    def _plan(self, flies: bool, job: Job, recovery: bool = False) -> Plan:
        found = _mavc.plan(self._handle, *job, flies, recovery)
        if found[0] is None:
            raise SpecError(diagnostics(found[1]))
        handle, verdict, report, text, csv, shown = found
        return Plan(verdict, None if csv is None else Trajectory(csv), report, text, diagnostics(shown), handle)

    def compare(
        self,
        *,
        effort: Effort | None = None,
        threads: int | None = None,
        progress: Callback = None,
        cancel: Cancel | None = None,
    ) -> Record:
        """Plans with every planner; the record of `mavc compare --report`. `effort` is that of `plan`.

        Raises SpecError if the planners cannot be compared.
        """
        report, shown = _mavc.compare(self._with(effort)._handle, *job(threads, progress, cancel))
        if report is None:
            raise SpecError(diagnostics(shown))
        return loaded(report)

    def simulate(
        self,
        *,
        rate: float | None = None,
        threads: int | None = None,
        progress: Callback = None,
        cancel: Cancel | None = None,
    ) -> Simulation:
        """Plans, then simulates a flight with the faults of the `simulate` block. `rate` is that of the log, Hz.

        Raises SpecError if nothing can be planned, or the block has mistakes or does not fit the plan.
        """
        self._must_fly()
        run = job(threads, progress, cancel)
        plan = self._plan(True, run)
        if not plan:
            return Simulation(plan, plan.verdict, None, None, plan.json, plan.text, plan.diagnostics)
        found = _mavc.simulate(plan._handle, *run, rate, False)
        if found[0] is None:
            raise SpecError(diagnostics(found[1]))
        outcome, report, text, csv, remark, _, shown = found
        known = plan.diagnostics + diagnostics(shown)
        return Simulation(plan, "simulated", outcome, Log(csv), report, text, known, remark)

    def campaign(
        self,
        *,
        times: int | None = None,
        seeds: int | None = None,
        threads: int | None = None,
        progress: Callback = None,
        cancel: Cancel | None = None,
    ) -> Campaign:
        """Flies every planner's plan with every fault mode, at `times` instants and with `seeds` noise seeds each. These two
        override the `campaign` block.

        Raises SpecError if nothing can be planned, or the `simulate` block has mistakes or does not fit the plans.
        """
        sizes = {"campaign.times": times, "campaign.seeds": seeds}
        spec = self
        for field, size in sizes.items():
            spec = spec if size is None else spec.set(field, size)
        spec._must_fly()
        found = _mavc.campaign(spec._handle, *job(threads, progress, cancel), program())
        if found[0] is None:
            raise SpecError(diagnostics(found[1]))
        verdict, report, text, rows, page, shown = found
        return Campaign(verdict, Rows(rows), report, text, diagnostics(shown), page)

    def _must_fly(self) -> None:
        if self._unfit is not None:
            raise SpecError(self._unfit)

    def verify(
        self, certificate: str | bytes, *, threads: int | None = None, cancel: Cancel | None = None
    ) -> Verification:
        """Decides whether a certificate holds for this spec, without the planner.

        Raises Rejected if it does not, or the check would exceed its budget.
        """
        data = certificate.encode() if isinstance(certificate, str) else certificate
        accepted, shown = _mavc.verify(self._handle, *job(threads, None, cancel), data)
        if accepted is None:
            raise Rejected(diagnostics(shown))
        return Verification(*accepted)


class Verification:
    """What an accepted certificate shows."""

    def __init__(self, text: str, headline: str, weaker: list[str], undecided: list[str]) -> None:
        self.text = text
        """What `mavc verify` prints."""
        self.headline = headline
        self.weaker = tuple(weaker)
        """Where it is weaker than the spec requires; empty if it is as strong."""
        self.undecided = tuple(undecided)

    def __str__(self) -> str:
        return self.text


def source_of(source: str | os.PathLike[str], name: str | None, marks: str, unnamed: str) -> tuple[str, bytes]:
    """The name and the bytes of a text or a file; a `str` with one of the marks is a text."""
    if isinstance(source, str) and any(mark in source for mark in marks):
        return name or unnamed, source.encode()
    return name or os.fspath(source), Path(source).read_bytes()


def compile(
    source: str | os.PathLike[str], *, name: str | None = None, set: Overrides = (), warn: bool = True
) -> Spec:
    """Compiles the text of a spec, or a file.

    A `str` with a line break or a brace is a text, any other one the name of a file. `name` is the text's name in messages; the
    files that it names are relative to the folder of this name. `set` has overrides, as `--set` (`["vehicle.mass = 2 kg"]`) or by
    field, with the values of `Spec.set` (`{"vehicle.mass": 2.0}`); a figure written as `?` in the text is known then. Warnings
    are kept in `Spec.warnings`, and unless `warn` is false they are also issued as `SpecWarning`. Mistakes in the blocks `simulate`
    and `campaign` are such warnings, as in `mavc plan`, and errors of `Spec.simulate` and `Spec.campaign`.

    Raises SpecError if the text has errors, and OSError if the file cannot be read.
    """
    name, data = source_of(source, name, "\n{}", "<spec>")
    spec = Spec(name, data, overrides(set))
    if warn and spec.warnings:
        warnings.warn(f"\n{spec.warnings}", SpecWarning, stacklevel=2)
    return spec


def new(mission: str | None = None) -> str:
    """The text of a commented spec that can be planned as it is: what `mavc new` writes, with `--mission` a whole mission."""
    templates = dict(_mavc.templates())
    if (mission or "") not in templates:
        kinds = ", ".join(sorted(kind for kind in templates if kind))
        raise ValueError(f"there is no mission {mission!r}: choose one of {kinds}")
    return templates[mission or ""]


def format(text: str) -> str:
    """The text in the layout of `mavc fmt`.

    Raises SpecError if the text has errors of syntax.
    """
    formatted, shown = _mavc.format(text)
    if formatted is None:
        raise SpecError(diagnostics(shown))
    return formatted


@cache
def program() -> str:
    """A hash of this build of mavc, because another build may give other numbers."""
    with open(_mavc.__file__, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest() if hasattr(hashlib, "file_digest") else _digest(file)


def _digest(file: Any) -> str:
    return hashlib.sha256(file.read()).hexdigest()
