"""How long work runs: threads, progress, cancelling."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Optional

from . import _mavc


@dataclass(frozen=True)
class Progress:
    """A report of a run."""

    text: str
    """A line for people."""
    planner: str | None = None
    time: float | None = None
    """The mission time that the planner tries, s."""
    done: int | None = None
    """Flights that are flown, of `total`."""
    total: int | None = None


class Cancel:
    """Cancels runs from another thread: they raise `mavc.Cancelled`."""

    def __init__(self) -> None:
        self._handle = _mavc.new_cancel()

    def cancel(self) -> None:
        """Cancels every run that was given this, and those that will be. Returns at once."""
        _mavc.cancel(self._handle)


Callback = Optional[Callable[[Progress], Any]]


Job = tuple[int, Any, Any]
"""Threads, callback and handle, as the native part takes them."""


def job(threads: int | None, progress: Callback, cancel: Cancel | None) -> Job:
    """The arguments of a run. Without a `Cancel` it has its own: an interrupted run is cancelled too."""
    if threads is not None and threads < 1:
        raise ValueError("a run needs at least one thread")
    report = None if progress is None else lambda *values: progress(Progress(*values))
    return threads or 0, report, (cancel or Cancel())._handle
