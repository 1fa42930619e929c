"""Specs without text: vehicles, fault modes and missions from values.

Numbers are in SI units; quantities of `pint` are converted, and their dimension is checked. Fields have the names of the language
(docs/language.md); one that is not given has its default. The values become a text that is compiled as a written one, so it is
checked in the same way, can be saved (`Spec.text`), and certificates refer to it.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Iterable, Mapping, Sequence, Union

from . import _mavc
from .errors import BuildError, Problem
from .quantity import Overrides, checked, is_quantity
from .spec import Spec, compile

Call = tuple[str, list[Any]]
Bounds = Union[float, tuple[Any, Any]]


class _Fields:
    """Fields of one block."""

    _block: str

    def __init__(self, **fields: Any) -> None:
        self.fields = fields

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in self.fields.items())})"


class Rotor(_Fields):
    """A rotor. `at` (m from the frame's origin) and `spin` (`P` turns counter-clockwise seen from above, `N` clockwise) place it;
    without them its fields are those of all rotors."""

    def __init__(self, at: Sequence[float] | None = None, spin: str | None = None, **fields: Any) -> None:
        super().__init__(**fields)
        self.at = at
        self.spin = spin

    def _placed(self) -> Call:
        clauses = [(name, checked("placed_rotor", name, value)) for name, value in self.fields.items()]
        return "placed_rotor", [_vector("placed_rotor", "at", self.at), self.spin, clauses]


class Vehicle(_Fields):
    """A vehicle: `Vehicle(layout="PPNNPPNN", arm=0.211, mass=1.8, inertia=[...], rotor=Rotor(max_thrust=6.53, ...))`, or with
    `rotors`, a list of placed ones, instead of a layout. `battery` has the fields of its block. `parts` has a mapping for each part,
    and the masses that all motors and arms share: `parts={"motor_mass": 0.1, "battery": {"mass": 1.1, "at": (0, 0, -0.03)}}`."""

    def __init__(
        self,
        *,
        rotor: Rotor | Mapping[str, Any] | None = None,
        rotors: Iterable[Rotor] = (),
        battery: Mapping[str, Any] | None = None,
        parts: Mapping[str, Any] | None = None,
        **fields: Any,
    ) -> None:
        super().__init__(**fields)
        self.rotor = rotor if isinstance(rotor, Rotor) else Rotor(**(rotor or {}))
        self.rotors = list(rotors)
        self.battery = dict(battery or {})
        self.parts = dict(parts or {})

    def _calls(self) -> list[Call]:
        calls = _set("vehicle", self.fields) + _set("rotor", self.rotor.fields) + _set("battery", self.battery)
        shared = {name: value for name, value in self.parts.items() if not isinstance(value, Mapping)}
        calls += _set("parts", shared)
        calls += [_part(name, value) for name, value in self.parts.items() if isinstance(value, Mapping)]
        return calls + [rotor._placed() for rotor in self.rotors]


def _part(name: str, fields: Mapping[str, Any]) -> Call:
    unknown = set(fields) - {"mass", "at", "size"}
    if unknown or not {"mass", "at"} <= set(fields):
        raise ValueError(f"part {name!r} takes mass, at and size, not {sorted(fields)}")
    size = None if fields.get("size") is None else _vector("part", "size", fields["size"])
    return "part", [name, checked("part", "mass", fields["mass"]), _vector("part", "at", fields["at"]), size]


class FaultMode(_Fields):
    """A fault mode: the numbers of rotors, from 1, that are lost, give only a share of their thrust (`reduced={3: 0.6}`), or are
    stuck at one. `rate` is in 1/s; a rate with an interval (`1e-5 1/h +- 50 %`) is for the text of a spec."""

    def __init__(
        self,
        name: str,
        lost: int | Iterable[int] = (),
        reduced: Mapping[int, float] | None = None,
        stuck: Mapping[int, float] | None = None,
        **fields: Any,
    ) -> None:
        super().__init__(**fields)
        self.name = name
        self.lost = [lost] if isinstance(lost, int) else list(lost)
        self.reduced = dict(reduced or {})
        self.stuck = dict(stuck or {})

    def _calls(self) -> list[Call]:
        calls: list[Call] = [("lost", [self.name, self.lost])] if self.lost else []
        calls += [("reduced", [self.name, [rotor], share]) for rotor, share in self.reduced.items()]
        calls += [("stuck", [self.name, [rotor], share]) for rotor, share in self.stuck.items()]
        return calls + [("mode", [self.name, *call[1]]) for call in _set("mode", self.fields)]


class Waypoint(_Fields):
    """A waypoint (m; x to the east, y to the north, z up) with clauses such as `yaw` (rad) and `within` (m), and the time (s) for
    which the vehicle holds there."""

    def __init__(self, at: Sequence[float], *, hold: float | None = None, **clauses: Any) -> None:
        super().__init__(**clauses)
        self.at = at
        self.hold = hold

    def _calls(self) -> list[Call]:
        clauses = [(name, checked("waypoint", name, value)) for name, value in self.fields.items()]
        calls: list[Call] = [("waypoint", [_vector("waypoint", "at", self.at), clauses])]
        return calls + ([("hold", [_plain("s", self.hold)])] if self.hold is not None else [])


class Volume(_Fields):
    """A volume in which the vehicle stays (`keep="in"`), or which it does not enter (`keep="out"`)."""

    def __init__(self, name: str, shape: str, *, keep: str, **fields: Any) -> None:
        if keep not in ("in", "out"):
            raise ValueError(f'keep is "in" or "out", not {keep!r}')
        super().__init__(**fields)
        self.name, self.shape, self.keep = name, shape, keep

    def _calls(self) -> list[Call]:
        fields = [("volume", [self.name, *call[1]]) for call in _set("volume", self.fields)]
        return [(f"keep_{self.keep}", [self.name, self.shape]), *fields]


class LandingSite:
    """A place where a damaged vehicle may touch down within `radius` (m) of `at` (m)."""

    def __init__(self, name: str, at: Sequence[float], radius: float) -> None:
        self.name, self.at, self.radius = name, at, radius

    def _calls(self) -> list[Call]:
        return [("landing_site", [self.name, _vector("landing_site", "at", self.at), checked("landing_site", "radius", self.radius)])]


class KeepOff(_Fields):
    """An area where no damaged vehicle lands, a `box`, `cylinder` or `polygon` seen from above; it may fly over it."""

    def __init__(self, name: str, shape: str, **fields: Any) -> None:
        super().__init__(**fields)
        self.name, self.shape = name, shape

    def _calls(self) -> list[Call]:
        fields = [("area", [self.name, *call[1]]) for call in _set("area", self.fields)]
        return [("keep_off", [self.name, self.shape]), *fields]


@dataclass
class Mission:
    """Waypoints, the first of which is the start, limits and volumes. A limit is a bound from above, or a pair of bounds, either of
    which may be `None`: `limits={"speed": 6.0, "altitude": (1.0, None)}`. `fields` are those of the block, such as `ground` (m); the
    last three concern the time after a fault, and limits there are bounds from above."""

    waypoints: Sequence[Waypoint | Sequence[float]]
    limits: Mapping[str, Bounds] = field(default_factory=dict)
    volumes: Sequence[Volume] = ()
    start_moving: bool = False
    end_moving: bool = False
    fields: Mapping[str, Any] = field(default_factory=dict)
    landing_sites: Sequence[LandingSite] = ()
    keep_off: Sequence[KeepOff] = ()
    after_fault_limits: Mapping[str, float] = field(default_factory=dict)

    def _calls(self) -> list[Call]:
        calls = _set("mission", self.fields)
        calls += [("start_moving", [])] if self.start_moving else []
        for waypoint in self.waypoints:
            calls += (waypoint if isinstance(waypoint, Waypoint) else Waypoint(waypoint))._calls()
        calls += [("end_moving", [])] if self.end_moving else []
        calls += [_limit(name, bounds) for name, bounds in self.limits.items()]
        blocks: list[Volume | LandingSite | KeepOff] = [*self.volumes, *self.landing_sites, *self.keep_off]
        calls += [call for block in blocks for call in block._calls()]
        after_fault = self.after_fault_limits.items()
        return calls + [("after_fault_at_most", [name, checked("after_fault_limits", name, bound)]) for name, bound in after_fault]


def build(
    vehicle: Vehicle,
    faults: Iterable[FaultMode] = (),
    mission: Mission | None = None,
    *,
    plan: Mapping[str, Any] | None = None,
    recovery: Mapping[str, Any] | None = None,
    simulate: Mapping[str, Any] | None = None,
    strikes: Iterable[tuple[str, float]] = (),
    campaign: Mapping[str, Any] | None = None,
    top: Mapping[str, Any] | None = None,
    set: Overrides = (),
) -> Spec:
    """Builds a spec. `recovery` are the fields of that block in `plan`. `strikes` are pairs of a fault mode and the time (s) at which it strikes in simulations; `top` are the fields
    outside all blocks, such as `gravity`; `set` has overrides, for what has no value here, such as an interval.

    Raises BuildError with every mistake in the values, and SpecError if an override has one.
    """
    calls = _set("top", top or {}) + vehicle._calls()
    calls += [call for mode in faults for call in mode._calls()]
    calls += mission._calls() if mission is not None else []
    calls += _set("plan", plan or {}) + _set("recovery", recovery or {}) + _set("simulate", simulate or {})
    calls += [("strike", [mode, _plain("s", at)]) for mode, at in strikes]
    text, problems = _mavc.build(calls + _set("campaign", campaign or {}))
    if problems:
        raise BuildError(tuple(Problem(*problem) for problem in problems), text)
    return compile(text, name="<builder>", set=set)


def _set(block: str, fields: Mapping[str, Any]) -> list[Call]:
    return [(block, [name, checked(block, name, _listed(value))]) for name, value in fields.items()]


def _listed(value: Any) -> Any:
    return list(value) if isinstance(value, tuple) else value


def _vector(block: str, field: str, value: Any) -> Any:
    if is_quantity(value):
        return checked(block, field, value)
    return [checked(block, field, part) for part in value]


def _plain(unit: str, value: Any) -> Any:
    return value.to(unit).magnitude if is_quantity(value) else value


def _limit(name: str, bounds: Bounds) -> Call:
    low, high = bounds if isinstance(bounds, (tuple, list)) else (None, bounds)
    low, high = (None if bound is None else checked("limits", name, bound) for bound in (low, high))
    if low is None and high is None:
        raise ValueError(f"the limit on {name} has no bound")
    if low is None:
        return "at_most", [name, high]
    return ("at_least", [name, low]) if high is None else ("between", [name, low, high])
