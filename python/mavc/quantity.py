"""Quantities: numbers in SI units, and those of `pint`, which is not needed."""

from __future__ import annotations

from numbers import Real
from typing import Any, Iterable, Mapping, Union

from . import _mavc

# The base units of pint, and how the language writes them.
_BASES = {"kilogram": "kg", "meter": "m", "second": "s", "radian": "rad", "ampere": "A"}


Overrides = Union[Iterable[str], Mapping[str, Any]]
"""Overrides of a spec: as `--set` takes them, or values by field."""


def overrides(given: Overrides) -> tuple[str, ...]:
    """Overrides as `--set` takes them."""
    if isinstance(given, Mapping):
        return tuple(f"{field} = {written(field, value)}" for field, value in given.items())
    return (given,) if isinstance(given, str) else tuple(given)


def is_quantity(value: Any) -> bool:
    return hasattr(value, "to_base_units")


def split(value: Any) -> tuple[Any, str]:
    """The magnitude in SI units and the unit, `kg*m^2`, of a quantity of `pint`."""
    base = value.to_base_units()
    factors = []
    for name, exponent in base.unit_items():
        if name not in _BASES:
            raise ValueError(f"{value} has the unit {name}, which the language lacks")
        factors.append(_BASES[name] + (f"^{exponent:g}" if exponent != 1 else ""))
    magnitude = base.magnitude
    return (magnitude.tolist() if hasattr(magnitude, "tolist") else magnitude), "*".join(factors)


def checked(block: str, field: str, value: Any) -> Any:
    """The magnitude of a value for a field of a block, in SI units. Of a `pint` quantity, the dimension must be that of the field.

    Raises ValueError if it is not.
    """
    if not is_quantity(value):
        return value.tolist() if hasattr(value, "tolist") else value
    magnitude, unit = split(value)
    wanted = _mavc.unit(block, field)
    found = _mavc.dimension(unit)
    # pint takes angles for plain numbers.
    if wanted is not None and found != wanted and found != _without_angle(wanted):
        raise ValueError(f"{block}.{field} is in {wanted or 'plain numbers'}, not in {found or 'plain numbers'}: {value}")
    return magnitude


def _without_angle(unit: str) -> str | None:
    """`1/s` for `rad/s`."""
    return _mavc.dimension(f"{unit}*rad^-1") if "rad" in unit else unit


def written(path: str, value: Any) -> str:
    """A value as the right side of an override of `path`, such as `vehicle.mass`."""
    block, _, field = path.replace(" ", "").rpartition(".")
    block = block.rpartition(".")[2] or "top"
    if is_quantity(value):
        magnitude = checked(block, field, value)
        unit = _mavc.unit(block, field)
        return _number(magnitude) + (f" {split(value)[1] if unit is None else unit}").rstrip()
    if isinstance(value, str):
        is_bare = _mavc.is_text(block, field) and not value.startswith('"')
        return f'"{value}"' if is_bare else value
    if isinstance(value, bool) or value is None:
        raise TypeError(f"{path} takes a number, a text, or a list")
    if isinstance(value, Real) or hasattr(value, "tolist"):
        plain = value.tolist() if hasattr(value, "tolist") else value
        return f"{_number(plain)} {_mavc.unit(block, field) or ''}".rstrip()
    items = list(value)
    if items and all(isinstance(item, str) for item in items):
        return f"[{', '.join(items)}]"
    return f"{_number(items)} {_mavc.unit(block, field) or ''}".rstrip()


def _number(value: Any) -> str:
    """A number, or three in brackets, with all digits."""
    if isinstance(value, Real):
        return repr(value) if isinstance(value, int) else repr(float(value))
    return f"[{', '.join(map(_number, value))}]"
