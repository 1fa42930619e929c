#!/usr/bin/env python3
"""Clearances of a plan from the volumes of its spec, with numpy alone: `clearances.py SPEC TRAJECTORY.csv SIZE_M [FINER]`.

The motion is rebuilt from the derivatives at the nodes (the snap is linear between them) on a grid FINER times finer, 50
unless given. Distances are those of points from segments, discs and boxes; nothing of mavc is used. SIZE_M is the radius of
the vehicle. Prints the smallest clearance of each volume and exits with 1 where one is below what the spec requires by more
than 0.1 mm, the tolerance of `mavc verify`.
"""

import csv
import re
import sys
from math import factorial

import numpy as np

UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001, "deg": np.pi / 180.0, "rad": 1.0, "": 1.0}


def volumes(text):
    """The `keep_in` and `keep_out` blocks: side, name, fields as arrays in SI."""
    text = re.sub(r"//[^\n]*", "", text)
    for side, name, body in re.findall(r"\b(keep_in|keep_out)\s+(\w+)\s*\{([^}]*)\}", text):
        fields = {}
        for field, value in re.findall(r"(\w+)\s*=\s*([^;\n]+)", body):
            if field == "shape":
                fields[field] = value.strip()
                continue
            numbers, unit = re.fullmatch(r"(.*?)\s*([a-z]*)\s*", value).groups()
            fields[field] = np.array(eval(numbers, {"__builtins__": {}})) * UNITS[unit]  # literals of the spec
        yield side, name, fields


def motion(path, finer):
    """Positions on the fine grid."""
    rows = [{key: float(value) for key, value in row.items() if value} for row in csv.DictReader(open(path))]
    points = []
    for before, after in zip(rows, rows[1:]):
        h = after["t"] - before["t"]
        t = np.linspace(0.0, h, finer, endpoint=False)
        axes = []
        for axis in "xyz":
            known = [before[prefix + axis] for prefix in ("", "v", "a", "j", "s")]
            value = sum(d * t**n / factorial(n) for n, d in enumerate(known))
            axes.append(value + (after["s" + axis] - known[4]) / h * t**5 / factorial(5))
        points.append(np.stack(axes, axis=1))
    points.append(np.array([[rows[-1][axis] for axis in "xyz"]]))
    return np.concatenate(points)


def from_polygon(p, corners):
    """Signed distance of the points (x, y) from a simple polygon, negative inside."""
    nearest, crossings = np.full(len(p), np.inf), np.zeros(len(p), dtype=int)
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        edge = b - a
        share = np.clip((p - a) @ edge / (edge @ edge), 0.0, 1.0)
        nearest = np.minimum(nearest, np.linalg.norm(p - a - share[:, None] * edge, axis=1))
        spans = (a[1] > p[:, 1]) != (b[1] > p[:, 1])
        with np.errstate(divide="ignore", invalid="ignore"):
            left = p[:, 0] < a[0] + (p[:, 1] - a[1]) / edge[1] * edge[0]
        crossings += spans & left
    return np.where(crossings % 2 == 1, -nearest, nearest)


def upright(across, z, bottom, top):
    """Signed distance from a body with vertical walls, given that from its outline."""
    vertical = np.maximum(bottom - z, z - top)
    outside = np.hypot(np.maximum(across, 0.0), np.maximum(vertical, 0.0))
    return np.where((across > 0) | (vertical > 0), outside, np.maximum(across, vertical))


def distance(p, f):
    """Signed distance of points from the volume with these fields."""
    if f["shape"] == "sphere":
        return np.linalg.norm(p - f["centre"], axis=1) - f["radius"]
    if f["shape"] == "half_space":
        normal = f["normal"] / np.linalg.norm(f["normal"])
        return (p - f["point"]) @ normal
    if f["shape"] == "cylinder":
        across = np.hypot(*(p[:, :2] - f["centre"][:2]).T) - f["radius"]
        return upright(across, p[:, 2], f["centre"][2], f["centre"][2] + f["height"])
    if f["shape"] == "polygon":
        return upright(from_polygon(p[:, :2], f["corners"]), p[:, 2], f["bottom"], f["top"])
    (low, high), angle = (f["from"], f["to"]), f.get("turn", 0.0)
    middle, half = 0.5 * (low + high)[:2], 0.5 * (high - low)[:2]
    c, s = np.cos(angle), np.sin(angle)
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * half @ np.array([[c, s], [-s, c]]) + middle
    return upright(from_polygon(p[:, :2], corners), p[:, 2], low[2], high[2])


def main():
    spec, trajectory, size = sys.argv[1], sys.argv[2], float(sys.argv[3])
    points = motion(trajectory, int(sys.argv[4]) if len(sys.argv) > 4 else 50)
    wrong = 0
    for side, name, fields in volumes(open(spec).read()):
        out = distance(points, fields) * (1.0 if side == "keep_out" else -1.0) - size
        required = float(fields.get("clearance", 0.0))
        at = int(np.argmin(out))
        kept = out[at] >= required - 1e-4
        wrong += not kept
        place = ", ".join(f"{x:.2f}" for x in points[at])
        print(f"{side} {name}: {out[at]:.5f} m of {required:g} m at [{place}] m{'' if kept else '  VIOLATED'}")
    print(f"{len(points)} points")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
