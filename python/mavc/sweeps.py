"""Many specs: a grid or a list of overrides of one spec, on this machine or on others."""

from __future__ import annotations

import csv
import hashlib
import io
import json
import os
from collections.abc import Mapping
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from itertools import product
from pathlib import Path
from typing import Any, Callable, Iterable, Iterator, Sequence, Union

import numpy as np

from .errors import SpecError
from .quantity import overrides, written
from .runs import Cancel
from .spec import Spec, compile, program
from .table import Table

Sample = Mapping[str, Any]
Row = dict[str, Any]
Tasks = list[tuple[str, Sample]]
Run = Union[str, Callable[[Spec], Mapping[str, Any]]]


class Sweep(Table):
    """One row for each sample, in their order: the overrides, what was found, and `error` if the sample is not a spec."""

    def __init__(self, rows: Sequence[Row]) -> None:
        names = dict.fromkeys(name for row in rows for name in row)
        columns = {name: _column([row.get(name) for row in rows]) for name in names}
        text = io.StringIO()
        writer = csv.DictWriter(text, list(names), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
        super().__init__(columns, text.getvalue())


def _column(values: list[Any]) -> np.ndarray:
    given = [value for value in values if value is not None]
    if any(isinstance(value, str) for value in given):
        values = [value if value is None else str(value) for value in values]
    whole = all(isinstance(value, int) for value in given)
    if given and all(isinstance(value, bool) for value in given):
        return np.array(values, dtype=bool if len(given) == len(values) else object)
    if given and whole and len(given) == len(values):
        return np.array(values, dtype=np.int64)
    if given and all(isinstance(value, (int, float)) for value in given):
        return np.array([np.nan if value is None else value for value in values], dtype=float)
    return np.array([*values, None], dtype=object)[:-1]


def sweep(
    template: Spec | str | os.PathLike[str],
    *,
    grid: Mapping[str, Iterable[Any]] | None = None,
    samples: Iterable[Sample] | None = None,
    run: Run = "analyze",
    client: Any = None,
    path: str | os.PathLike[str] | None = None,
    workers: int | None = None,
    progress: Callable[[int, int], Any] | None = None,
) -> Sweep:
    """Sets fields of a spec to every combination of a `grid`, or to each of a list of `samples`, and runs each.

    `template` is a spec, a text or a file. Fields and values are those of `Spec.set`. `run` is `"analyze"`, `"plan"`, or a
    function of a spec that returns numbers and texts by name. A sample that is not a spec has a row with its `error`.

    Samples run in as many threads as there are cores, or in `workers`, each on one core. `client` runs them elsewhere: an executor of
    `concurrent.futures`, a client of Dask, or the module `ray`. With `path`, each row is appended to a file (`.jsonl`) as soon as it is
    there, and a second call runs only what is missing: rows are found again by the hashes of the spec, of mavc and of `run`. A path
    that ends in `.parquet` also gets all rows as Parquet. `progress` is called with the numbers of finished and of all samples.
    """
    spec = template if isinstance(template, Spec) else compile(template, warn=False)
    wanted = list(_samples(grid, samples))
    tasks = {_key(spec, sample, run): sample for sample in wanted}
    journal = _Journal(path)
    known = {key: row for key, row in journal.rows() if key in tasks}
    missing = [(key, sample) for key, sample in tasks.items() if key not in known]
    if progress is not None:
        progress(len(known), len(tasks))
    with journal:
        for key, row in _finished(spec, missing, run, client, workers):
            journal.add(key, row)
            known[key] = row
            if progress is not None:
                progress(len(known), len(tasks))
    found = Sweep([{**_plain(sample), **known[_key(spec, sample, run)]} for sample in wanted])
    if path is not None and Path(path).suffix == ".parquet":
        found.to_parquet(path)
    return found


def _samples(grid: Mapping[str, Iterable[Any]] | None, samples: Iterable[Sample] | None) -> Iterator[Sample]:
    if (grid is None) == (samples is None):
        raise ValueError("give either a grid or samples")
    if samples is not None:
        yield from samples
    else:
        axes = {name: list(values) for name, values in (grid or {}).items()}
        yield from (dict(zip(axes, values)) for values in product(*axes.values()))


def _plain(sample: Sample) -> Row:
    """The overrides as they are shown: numbers stay numbers."""
    is_plain = (int, float, str)
    return {name: value if isinstance(value, is_plain) else written(name, value) for name, value in sample.items()}


def _key(spec: Spec, sample: Sample, run: Run) -> str:
    """The hash of everything that a row depends on."""
    name = run if isinstance(run, str) else f"{run.__module__}.{run.__qualname__} {_code(run)}"
    parts = [spec.sha256, *overrides(sample), name, program()]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


def _code(run: Callable[..., Any]) -> str:
    code = getattr(run, "__code__", None)
    return "" if code is None else hashlib.sha256(code.co_code + repr(code.co_consts).encode()).hexdigest()


def work(spec: Spec, sample: Sample, run: Run, cancel: Cancel | None = None) -> Row:
    """The row of one sample, without its overrides. Other processes call this too."""
    try:
        made = Spec(spec.name, spec._source, (*spec.overrides, *overrides(sample)))
        if callable(run):
            return {**run(made), "error": None}
        return {**_RUNS[run](made, cancel), "error": None}
    except SpecError as error:
        return {"error": str(error)}


def _analyzed(spec: Spec, cancel: Cancel | None) -> Row:
    found = spec.analyze(threads=1, cancel=cancel)
    margins = found.margins
    masses = [mode.critical_mass for mode in found.faults]
    return {
        "faults": len(found.faults),
        "survived": found.survived,
        "smallest_margin_n_m": float(np.min(margins)) if len(margins) else None,
        "critical_mass_kg": float(np.min(masses)) if masses else None,
        "healthy_margin_n_m": found.modes[0].acai,
    }


def _planned(spec: Spec, cancel: Cancel | None) -> Row:
    plan = spec.plan(threads=1, cancel=cancel)
    record = plan.planner
    margins = [-mode["max_violation"] for mode in record["modes"]]
    return {
        "verdict": plan.verdict,
        "planner": record["name"],
        "time_s": record["time_s"],
        "time_lower_bound_s": record["time_lower_bound_s"],
        "objective": record["objective"],
        "smallest_margin": min(margins) if margins and plan else None,
        "explanation": plan.explanation,
    }


_RUNS: dict[str, Callable[[Spec, Union[Cancel, None]], Row]] = {"analyze": _analyzed, "plan": _planned}


def _finished(
    spec: Spec, tasks: Tasks, run: Run, client: Any, workers: int | None
) -> Iterator[tuple[str, Row]]:
    """Rows with their keys, as they are finished."""
    if isinstance(run, str) and run not in _RUNS:
        raise ValueError(f"there is no run {run!r}: choose from {', '.join(_RUNS)}, or give a function")
    if client is None:
        yield from _local(spec, tasks, run, workers)
    elif hasattr(client, "remote") and hasattr(client, "wait"):
        yield from _ray(spec, tasks, run, client)
    else:
        yield from _futures(spec, tasks, run, client)


def _local(spec: Spec, tasks: Tasks, run: Run, workers: int | None) -> Iterator[tuple[str, Row]]:
    cancel = Cancel()
    pool = ThreadPoolExecutor(workers or os.cpu_count())
    try:
        futures = {pool.submit(work, spec, sample, run, cancel): key for key, sample in tasks}
        yield from _as_completed(futures)
    except BaseException:
        # Ctrl-C, or an error of one sample: the others end at once.
        cancel.cancel()
        raise
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def _as_completed(futures: dict[Future[Row], str]) -> Iterator[tuple[str, Row]]:
    left = set(futures)
    while left:
        done, left = wait(left, return_when=FIRST_COMPLETED)
        for future in done:
            yield futures[future], future.result()


def _futures(spec: Spec, tasks: Tasks, run: Run, client: Any) -> Iterator[tuple[str, Row]]:
    """Executors of `concurrent.futures`, and clients of Dask, whose futures are not those of the standard library."""
    futures = {client.submit(work, spec, sample, run): key for key, sample in tasks}
    if all(isinstance(future, Future) for future in futures):
        yield from _as_completed(futures)
    else:
        # Samples are sent at once and run in parallel; only their rows are waited for in order.
        yield from ((key, future.result()) for future, key in futures.items())


def _ray(spec: Spec, tasks: Tasks, run: Run, ray: Any) -> Iterator[tuple[str, Row]]:
    remote = ray.remote(work)
    pending = {remote.remote(spec, sample, run): key for key, sample in tasks}
    while pending:
        done, _ = ray.wait(list(pending))
        for reference in done:
            yield pending.pop(reference), ray.get(reference)


class _Journal:
    """The file to which finished rows are appended, a line of JSON for each."""

    def __init__(self, path: str | os.PathLike[str] | None) -> None:
        self.path = None if path is None else Path(path).with_suffix(".jsonl")
        self.file: io.TextIOWrapper | None = None

    def rows(self) -> Iterator[tuple[str, Row]]:
        if self.path is None or not self.path.exists():
            return
        text = self.path.read_text()
        for line in text.splitlines(keepends=True):
            # A run that was killed may leave half a line.
            if line.endswith("\n"):
                record = json.loads(line)
                yield record.pop("key"), record

    def __enter__(self) -> _Journal:
        if self.path is not None:
            whole = self.path.read_bytes() if self.path.exists() else b""
            self.file = self.path.open("a")
            self.file.truncate(whole.rfind(b"\n") + 1)
        return self

    def __exit__(self, *_: object) -> None:
        if self.file is not None:
            self.file.close()

    def add(self, key: str, row: Row) -> None:
        if self.file is not None:
            self.file.write(json.dumps({"key": key, **row}) + "\n")
            self.file.flush()
