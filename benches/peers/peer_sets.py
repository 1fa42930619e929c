#!/usr/bin/env python3
"""Admissible sets the usual way: the convex hull of the images of all corners of the rotor-speed box.

As a script: every single- and double-fault set of an octocopter, with the time scipy's ConvexHull takes.
"""

import argparse
import itertools
import statistics
import time

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from case import PeerError, Vehicle, main_with_errors

OCTOCOPTER = {
    "arm_m": 0.211,
    "mass_kg": 1.8,
    "inertia_kg_m2": [0.0429, 0.0429, 0.0748],
    "thrust_coefficient": 8.5485e-6,
    "drag_coefficient": 1.3678e-7,
    "max_speed_rad_s": 874.0,
}


def corners(generators):
    """(2^n, 4): the wrench of every corner of the box."""
    n = generators.shape[1]
    on = (np.arange(2**n)[:, None] >> np.arange(n)) & 1
    return on @ generators.T


def hull(generators):
    """(N, 4), (N,): the distinct facets N w <= e of the hull of the corners, unit normals, simplices merged."""
    try:
        equations = ConvexHull(corners(generators)).equations
    except QhullError as error:
        raise PeerError("the set is flat; a convex hull in four dimensions does not exist") from error
    _, first = np.unique(np.round(equations, 7) + 0.0, axis=0, return_index=True)
    return equations[first, :4], -equations[first, 4]


def wrench_scale(vehicle):
    """(4,): the sum of all rotors along each axis, so that scaled wrenches are of order one."""
    return np.abs(vehicle.generators()).sum(axis=1)


def admissible_set(vehicle, lost=(), reserve=0.0):
    """Facets (N, e) in scaled wrenches, shrunk about hover by the reserve; `lost` counts from 1."""
    scale = wrench_scale(vehicle)
    kept = np.delete(vehicle.generators(), [k - 1 for k in lost], axis=1)
    normals, offsets = hull(kept / scale[:, None])
    at_hover = normals @ (vehicle.hover() / scale)
    return normals, at_hover + (1.0 - reserve) * (offsets - at_hover)


def intersection(sets, inside):
    """The facets of the intersection of several sets: vertices of the polar dual about a point `inside` of all."""
    normals = np.vstack([n for n, _ in sets])
    offsets = np.concatenate([e for _, e in sets])
    _, group = np.unique(np.round(normals, 6) + 0.0, axis=0, return_inverse=True)
    order = np.lexsort((offsets, group))  # the smallest offset of each normal comes first
    keep = order[np.unique(group[order], return_index=True)[1]]
    normals, offsets = normals[keep], offsets[keep]
    slack = offsets - normals @ inside
    if slack.min() <= 0:
        raise PeerError("hover is not inside every set")
    keep = np.sort(ConvexHull(normals / slack[:, None]).vertices)
    return normals[keep], offsets[keep]


def fault_sets(layout, up_to=2):
    """The facets of every set with one to `up_to` rotors lost, by the tuple of lost rotors."""
    vehicle = Vehicle(layout=layout, **OCTOCOPTER)
    rotors = range(1, len(layout) + 1)
    modes = itertools.chain.from_iterable(itertools.combinations(rotors, k) for k in range(1, up_to + 1))
    return {lost: admissible_set(vehicle, lost) for lost in modes}


def hull_seconds(layout, repeat=5):
    """The median time of the bare ConvexHull calls (corners ready) over all single and double faults, s."""
    vehicle = Vehicle(layout=layout, **OCTOCOPTER)
    generators = vehicle.generators() / wrench_scale(vehicle)[:, None]
    points = [
        corners(np.delete(generators, lost, axis=1))
        for k in (1, 2)
        for lost in itertools.combinations(range(len(layout)), k)
    ]
    times = []
    for _ in range(repeat):
        begin = time.perf_counter()
        for p in points:
            ConvexHull(p)
        times.append(time.perf_counter() - begin)
    return statistics.median(times)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--layout", default="PPNNPPNN", help="eight letters, P or N (default %(default)s)")
    parser.add_argument("--repeat", type=int, default=5, help="timing runs, the median counts (default 5)")
    options = parser.parse_args()
    if len(options.layout) != 8 or options.repeat < 1:
        raise PeerError("a layout of eight rotors and at least one run, please")
    vehicle = Vehicle(layout=options.layout, **OCTOCOPTER)
    sets = fault_sets(options.layout)
    print(f"healthy   {len(admissible_set(vehicle)[1]):4} facets")
    for lost, (_, offsets) in sets.items():
        print(f"{'M' + '_'.join(map(str, lost)):9} {len(offsets):4} facets")
    singles = [s for lost, s in sets.items() if len(lost) == 1]
    joint = intersection(singles, vehicle.hover() / wrench_scale(vehicle))
    print(f"{'singles':9} {len(joint[1]):4} facets left of {sum(len(e) for _, e in singles)}")
    seconds = hull_seconds(options.layout, options.repeat)
    print(f"ConvexHull of {len(sets)} fault sets: {seconds * 1e3:.1f} ms (median of {options.repeat})")
    return 0


if __name__ == "__main__":
    main_with_errors(main)
