#!/usr/bin/env python3
"""Wrenches of a plan in its air against the sets of its vehicle, with numpy alone: `air.py SPEC TRAJECTORY.csv [FINER]`.

The motion is rebuilt from the derivatives at the nodes (the snap is linear between them) on a grid FINER times finer, 50
unless given. The attitude R follows from the yaw and from the equation of motion, a + g e_z + R K R^T (v - wind) = c b3, whose
matrix K = diag(drag)/m is along the axes of the body: R is iterated until R and the force of the drag agree. Body rates and
accelerations are differences of rotation matrices, and torques follow from Euler's equation. The healthy set is the box of
thrusts of a ring of equal rotors, described by the hyperplanes along every three rotors; with `planner = rcp` the sets with one
rotor lost are checked too. All are shrunk by the spec's reserve. The spec must have a ring, literals and `samples`, and nothing
of mavc is used. The winds are the corners of the spec's interval and 20 random ones inside. Prints the largest tilt and the
largest violation of each set, as a share of the healthy set's width, and exits with 1 where a wind violates a set by more
than 1e-4, or the limit on tilt by more than 0.1 degrees.
"""

import csv
import itertools
import re
import sys
from math import factorial

import numpy as np

GRAVITY = 9.81
H = 1e-4  # step of the differences of rotations, s


def field(text, name, default=None):
    found = re.search(rf"\b{name}\s*=\s*(\[[^\]]*\]|\"[^\"]*\"|[-\d.eE]+)\s*([A-Za-z%]*)", text)
    if not found:
        return default
    value = eval(found[1], {"__builtins__": {}})  # a literal of the spec
    scale = {"mm": 1e-3, "cm": 1e-2, "%": 1e-2, "g": 1e-3}.get(found[2], 1.0)
    return value if isinstance(value, str) else np.array(value) * scale


def pieces(path):
    """For each piece its duration and the derivatives 0 to 4 of x, y, z and 0 to 2 of yaw at both ends."""
    rows = [{key: float(value) for key, value in row.items() if value} for row in csv.DictReader(open(path))]
    prefixes = ("", "v", "a", "j", "s")
    keys = {"yaw": ("yaw", "yaw_rate", "yaw_acc")} | {axis: tuple(prefix + axis for prefix in prefixes) for axis in "xyz"}
    for before, after in zip(rows, rows[1:]):
        ends = [{axis: [row[k] for k in own] for axis, own in keys.items()} for row in (before, after)]
        yield after["t"] - before["t"], *ends


def derivative(h, before, after, t, order):
    """A derivative within a piece whose highest derivative is linear."""
    highest = len(before) - 1
    slope = (after[highest] - before[highest]) / h
    known = sum(d * t ** (n - order) / factorial(n - order) for n, d in enumerate(before) if n >= order)
    return known + slope * t ** (highest + 1 - order) / factorial(highest + 1 - order)


def rotations(h, before, after, t, k, wind):
    """Thrust over mass and rotation matrices at times within a piece."""
    of = lambda order: np.stack([derivative(h, before[a], after[a], t, order) for a in "xyz"], axis=1)
    yaw = derivative(h, before["yaw"], after["yaw"], t, 0)
    left = np.stack([-np.sin(yaw), np.cos(yaw), 0 * yaw], axis=1)
    air = of(1) - wind
    c = of(2) + [0, 0, GRAVITY] + k[0] * air
    # With equal drags the first attitude is right; otherwise the map is a contraction, by about |k| |air| / g times their difference.
    for _ in range(1 if np.ptp(k) == 0 else 200):
        b3 = c / np.linalg.norm(c, axis=1)[:, None]
        b1 = np.cross(left, b3)
        b1 /= np.linalg.norm(b1, axis=1)[:, None]
        r = np.stack([b1, np.cross(b3, b1), b3], axis=2)
        before_it, c = c, of(2) + [0, 0, GRAVITY] + np.einsum("nij,j,nkj,nk->ni", r, k, r, air)
        if np.abs(c - before_it).max() < 1e-13:
            break
    else:
        assert np.ptp(k) == 0, "the attitude does not converge"
    return c, r


def wrenches(path, finer, mass, inertia, k, wind):
    """Wrenches and tilts on the fine grid."""
    found, tilts = [], []
    for h, before, after in pieces(path):
        t = np.linspace(0.0, h, finer, endpoint=False)
        c, now = rotations(h, before, after, t, k, wind)
        [(_, late), (_, early)] = [rotations(h, before, after, t + s, k, wind) for s in (H, -H)]
        turn = lambda r: np.stack([r[:, 2, 1] - r[:, 1, 2], r[:, 0, 2] - r[:, 2, 0], r[:, 1, 0] - r[:, 0, 1]], axis=1) / 2
        back = now.transpose(0, 2, 1)
        rate = turn(back @ (late - early)) / (2 * H)
        # R' R'' = w^ w^ + w'^, whose antisymmetric part is w'^.
        acceleration = turn(back @ (late - 2 * now + early)) / H**2
        torque = inertia * acceleration + np.cross(rate, inertia * rate)
        found.append(np.column_stack([mass * np.linalg.norm(c, axis=1), torque]))
        tilts.append(np.degrees(np.arctan2(np.hypot(c[:, 0], c[:, 1]), c[:, 2])))
    return np.concatenate(found), np.concatenate(tilts).max()


def planes(generators, hover, reserve):
    """Normals and offsets of the set of all `generators @ u`, 0 <= u <= 1, shrunk about hover."""
    rows = []
    for triple in itertools.combinations(range(generators.shape[1]), 3):
        *_, singular, v = np.linalg.svd(generators[:, triple].T)
        if singular[-1] < 1e-9 * singular[0]:
            continue
        for n in (v[3], -v[3]):
            offset = np.maximum(n @ generators, 0.0).sum()
            rows.append((n, n @ hover + (1 - reserve) * (offset - n @ hover)))
    return rows


def main(spec, path, finer="50"):
    text = re.sub(r"//[^\n]*", "", open(spec).read())
    layout, arm, mass = field(text, "layout"), field(text, "arm"), float(field(text, "mass"))
    inertia, drag = field(text, "inertia"), np.ones(3) * field(text, "drag")
    full, ratio = float(field(text, "max_thrust")), float(field(text, "torque_per_thrust"))
    reserve = float(field(text, "reserve", 0.1))
    angles = np.pi / 2 - 2 * np.pi * np.arange(len(layout)) / len(layout)
    # The first rotor is on +y of the world, which is on the left of a body whose x points ahead.
    x, y = arm * np.cos(angles), arm * np.sin(angles)
    spin = np.array([-1.0 if s == "P" else 1.0 for s in layout])
    generators = full * np.stack([np.ones(len(layout)), y, -x, ratio * spin])
    wind = np.array(field(text, "wind", [0.0, 0.0, 0.0]), dtype=float)
    spread = re.search(r"\bwind\s*=\s*\[[^\]]*\]\s*m/s\s*\+-\s*(\[[^\]]*\]|[\d.]+)", text)
    spread = np.zeros(3) + (eval(spread[1], {"__builtins__": {}}) if spread else 0.0)
    limit = re.search(r"\btilt\s*<=\s*([\d.]+)\s*deg", text)
    # At rest at the yaw of the start.
    turned = re.search(r"\bstart\s+at\s*\[[^\]]*\]\s*m\s+yaw\s+([-\d.]+)\s*deg", text)
    rest = {axis: [0.0] * 5 for axis in "xyz"} | {"yaw": [np.radians(float(turned[1])) if turned else 0.0, 0.0, 0.0]}
    at_rest, _ = rotations(1.0, rest, rest, np.zeros(1), drag / mass, wind)
    hover = np.array([mass * np.linalg.norm(at_rest), 0, 0, 0])
    sets = {"healthy": generators}
    if re.search(r"planner\s*=\s*rcp", text):
        sets |= {f"M{i + 1}": np.delete(generators, i, axis=1) for i in range(len(layout))}
    corners = [wind + spread * signs for signs in itertools.product(*[(-1, 1) if s > 0 else (0,) for s in spread])]
    inside = [wind + spread * np.random.default_rng(k).uniform(-1, 1, 3) for k in range(20 if spread.any() else 0)]
    failed = False
    for kind, winds in (("corners of the winds", corners), ("random winds inside", inside)):
        largest, tilt = {name: -np.inf for name in sets}, 0.0
        for each in winds:
            found, tilted = wrenches(path, int(finer), mass, inertia, drag / mass, each)
            tilt = max(tilt, tilted)
            for name, own in sets.items():
                for n, offset in planes(own, hover, reserve):
                    width = np.abs(n @ generators).sum()
                    largest[name] = max(largest[name], ((found @ n) - offset).max() / width)
        if not winds:
            continue
        print(f"{kind}: {len(winds)} winds, {len(found)} instants each; largest tilt {tilt:.4f} degrees")
        for name, violation in largest.items():
            print(f"  {name}: largest violation {100 * violation:.5f} % of the healthy set's width")
        failed |= max(largest.values()) > 1e-4 or (limit is not None and tilt > float(limit[1]) + 0.1)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
