"""Layouts of rings: the orders in which rotors turn one way or the other."""

from __future__ import annotations

from itertools import combinations
from typing import Iterable, Iterator

# Every symmetry keeps the verdict, the place of hover, the control authority index and the masses of each mode, the modes of single
# rotors in another order:
# - a rotation turns the vehicle about its vertical axis, which turns the torques about the horizontal ones;
# - a swap of P and N mirrors the set of wrenches in the yaw torque, whose value in hover is zero;
# - a reflection of the order is a swap and the vehicle in a mirror.
# What is relative to an axis of the body (headroom) or to a mission (its time) is not kept: see docs/python.md.
SYMMETRIES = ("rotation", "reflection", "swap")

_SWAP = str.maketrans("PN", "NP")


def rings(n: int, *, balanced: bool = True, symmetries: Iterable[str] = SYMMETRIES) -> list[str]:
    """The layouts of a ring of n rotors, one of each class of layouts that the symmetries carry into each other: the last in the
    alphabet, in descending order. `balanced` rings have as many rotors of one sense as of the other, as they must to hover with
    equal thrusts.

    >>> rings(4)
    ['PPNN', 'PNPN']
    """
    symmetries = tuple(symmetries)
    unknown = [name for name in symmetries if name not in SYMMETRIES]
    if unknown:
        raise ValueError(f"there is no symmetry {unknown[0]!r}: choose from {', '.join(SYMMETRIES)}")
    if n < 1 or balanced and n % 2:
        raise ValueError("a balanced ring has an even number of rotors" if n > 0 else "a ring has rotors")
    kept = (layout for layout in _all(n, balanced) if layout == max(images(layout, symmetries)))
    return sorted(kept, reverse=True)


def _all(n: int, balanced: bool) -> Iterator[str]:
    for size in [n // 2] if balanced else range(n + 1):
        for positive in map(set, combinations(range(n), size)):
            yield "".join("P" if k in positive else "N" for k in range(n))


def images(layout: str, symmetries: Iterable[str] = SYMMETRIES) -> set[str]:
    """The layouts that the symmetries make of a layout, itself included."""
    symmetries = tuple(symmetries)
    found = {layout}
    if "rotation" in symmetries:
        found |= {layout[k:] + layout[:k] for k in range(len(layout))}
    if "reflection" in symmetries:
        found |= {other[::-1] for other in found}
    if "swap" in symmetries:
        found |= {other.translate(_SWAP) for other in found}
    return found
