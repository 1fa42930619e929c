"""Signed distances from the shapes of volumes, and the clearance of straight lines from them.

A volume is a dictionary as in the record of a mission: `side` (keep_in or keep_out), `shape`, the fields of the shape in metres
and degrees, and `clearance`. Only the standard library is used, and nothing of mavc.
"""

import math


def _from_polygon(x, y, corners):
    """Signed distance of a point from a simple polygon, negative inside."""
    nearest, inside = math.inf, False
    for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1]):
        ex, ey = bx - ax, by - ay
        share = min(1.0, max(0.0, ((x - ax) * ex + (y - ay) * ey) / (ex * ex + ey * ey)))
        nearest = min(nearest, math.hypot(x - ax - share * ex, y - ay - share * ey))
        if (ay > y) != (by > y) and x < ax + (y - ay) / ey * ex:
            inside = not inside
    return -nearest if inside else nearest


def _upright(across, z, bottom, top):
    """Signed distance from a body with vertical walls, given the distance from its outline."""
    vertical = max(bottom - z, z - top)
    if across > 0 or vertical > 0:
        return math.hypot(max(across, 0.0), max(vertical, 0.0))
    return max(across, vertical)


def corners_of_box(volume):
    """The outline of a box from above, with its turn."""
    low, high, angle = volume["from"], volume["to"], math.radians(volume.get("turn", 0.0))
    middle = [(low[i] + high[i]) / 2 for i in (0, 1)]
    half = [(high[i] - low[i]) / 2 for i in (0, 1)]
    c, s = math.cos(angle), math.sin(angle)
    signs = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    return [(middle[0] + c * i * half[0] - s * j * half[1], middle[1] + s * i * half[0] + c * j * half[1]) for i, j in signs]


def distance(volume, p):
    """Signed distance of a point from the boundary of a volume, negative inside."""
    shape, (x, y, z) = volume["shape"], p
    if shape == "sphere":
        return math.dist(p, volume["centre"]) - volume["radius"]
    if shape == "half_space":
        length = math.hypot(*volume["normal"])
        return sum(n * (a - b) for n, a, b in zip(volume["normal"], p, volume["point"])) / length
    if shape == "cylinder":
        cx, cy, bottom = volume["centre"]
        return _upright(math.hypot(x - cx, y - cy) - volume["radius"], z, bottom, bottom + volume["height"])
    if shape == "polygon":
        return _upright(_from_polygon(x, y, volume["corners"]), z, volume["bottom"], volume["top"])
    if shape == "box":
        return _upright(_from_polygon(x, y, corners_of_box(volume)), z, volume["from"][2], volume["to"][2])
    raise ValueError(f"unknown shape {shape}")


def room(volume, p, size):
    """How much room a vehicle of this size at the point has beyond what the volume requires; negative where it violates it."""
    out = distance(volume, p)
    return (out if volume["side"] == "keep_out" else -out) - size - volume.get("clearance", 0.0)


def line_keeps(volume, a, b, size, margin, step=0.004):
    """Whether a vehicle on the line from a to b keeps `margin` beyond what the volume requires.

    A distance changes by at most the way, so a point with much room to spare covers the line around it.
    """
    length, at = math.dist(a, b), 0.0
    while True:
        share = at / length if length > 0 else 0.0
        spare = room(volume, [u + share * (v - u) for u, v in zip(a, b)], size) - margin
        if spare < 0:
            return False
        if at >= length:
            return True
        at = min(length, at + max(spare, step))
