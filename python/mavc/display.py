"""How results look in notebooks."""

from __future__ import annotations

import math
from collections import Counter
from html import escape
from typing import TYPE_CHECKING, Iterable

if TYPE_CHECKING:
    from .results import Analysis, Campaign


def _table(caption: str, names: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    head = "".join(f"<th>{escape(name)}</th>" for name in names)
    body = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in rows)
    return (
        f"<table><caption>{escape(caption)}</caption><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
    )


def _figure(value: float) -> str:
    return "-" if math.isnan(value) else f"{value:.4g}"


def analysis(found: Analysis) -> str:
    """Every mode with its outcome and figures."""
    rows = (
        (mode.name, mode.outcome, mode.verdict, mode.hover, _figure(mode.acai), _figure(mode.critical_mass))
        for mode in found.modes
    )
    names = ("mode", "outcome", "verdict", "hover", "control authority, N m", "largest mass, kg")
    return _table(found.headline, names, rows)


def page(html: str) -> str:
    """A whole page within a notebook; its script sees nothing of the notebook."""
    return (
        f'<iframe srcdoc="{escape(html)}" sandbox="allow-scripts" style="width:100%;height:700px;border:0"></iframe>'
    )


def campaign(found: Campaign) -> str:
    """The share of flights of each planner and mode that survived."""
    flights: Counter[tuple[str, str]] = Counter()
    survived: Counter[tuple[str, str]] = Counter()
    for planner, mode, outcome in zip(found.rows["planner"], found.rows["mode"], found.rows["outcome"]):
        flights[planner, mode] += 1
        survived[planner, mode] += outcome in ("flown", "landed")
    planners = list(dict.fromkeys(planner for planner, _ in flights))
    modes = list(dict.fromkeys(mode for _, mode in flights))
    rows = ([mode, *(f"{survived[p, mode]} of {flights[p, mode]}" for p in planners)] for mode in modes)
    return _table(f"{found.rows.rows} flights: {found.verdict}", ["survived", *planners], rows)
