"""Whether a mission satisfies the premise of the generator: what `violated` returns is empty then.

It reads the record of the mission alone. Distances come from `shapes`, sets from `sets`; nothing of mavc is used.
"""

import math

import sets
import shapes

MARGIN_OF_LINES = 0.3  # m
MARGIN_OF_REST = 0.02  # of the healthy set's width
MARGIN_OF_TILT = 1.0  # deg
SHORTEST_LEG = 0.4  # m
MOST_SAMPLES = 196  # that legs and holds may need of the 200
PLACES = {"x": 0, "y": 1, "altitude": 2, "z": 2}
UPPER_ONLY = {
    "speed", "speed_horizontal", "climb", "descent", "acceleration", "acceleration_horizontal", "jerk", "yaw_rate",
    "yaw_acceleration", "tilt",
}  # fmt: skip


def at_rest(points):
    """Whether the vehicle rests at each waypoint."""
    last = len(points) - 1
    return [i in (0, last) or p["stop"] or p["hold"] > 0 for i, p in enumerate(points)]


def samples_needed(points):
    """The intervals on which each leg can be flown along its line.

    The speed from rest to rest can be a B-spline of degree 4, which has five intervals. The grid has ten where the spec requires rest at
    both ends.
    """
    rest = at_rest(points)
    legs = sum(10 if a and b else 5 for a, b in zip(rest, rest[1:]))
    return legs + sum(p["hold"] > 0 for p in points)


def violated_by_lines(record):
    size, volumes = record["vehicle"]["size"], record["volumes"]
    for number, (before, point) in enumerate(zip(record["points"], record["points"][1:]), 2):
        a, b = before["at"], point["at"]
        if math.dist(a, b) < SHORTEST_LEG:
            yield f"waypoint {number} is at the place of the one before"
        if point["line"] == "vertical" and (a[0] != b[0] or a[1] != b[1]):
            yield f"waypoint {number} is not above or below the one before"
        if point["corridor"] is not None and point["corridor"] <= 0:
            yield f"the corridor to waypoint {number} is empty"
        for volume in volumes:
            if not shapes.line_keeps(volume, a, b, size, MARGIN_OF_LINES):
                yield f"the line to waypoint {number} violates a {volume['side']} of shape {volume['shape']}"
        rule = point["yaw"]
        if rule["rule"] == "towards" and before["yaw"] == rule:
            target, way = rule["point"][:2], [v - u for u, v in zip(a[:2], b[:2])]
            square = sum(x * x for x in way)
            share = sum((t - u) * x for t, u, x in zip(target, a, way)) / square if square else 0.0
            share = min(1.0, max(0.0, share))
            nearest = math.hypot(*(u + share * x - t for u, x, t in zip(a, way, target)))
            if nearest < size + MARGIN_OF_LINES:
                yield f"the line to waypoint {number} passes over the point that its yaw points to"


def violated_by_limits(record):
    points = record["points"]
    of_legs = [(point["limits"], [before, point]) for before, point in zip(points, points[1:])]
    for limits, own in [(record["limits"], points), *of_legs]:
        for name, (low, high) in limits.items():
            if name in PLACES:
                places = [point["at"][PLACES[name]] for point in own]
                if low is not None and min(places) < low + MARGIN_OF_LINES:
                    yield f"a waypoint is below the limit on {name}"
                if high is not None and max(places) > high - MARGIN_OF_LINES:
                    yield f"a waypoint is above the limit on {name}"
            elif name in UPPER_ONLY:
                if low is not None or high <= 0:
                    yield f"the limit on {name} requires motion"
            else:
                yield f"unknown limit {name}"


def violated_at_rest(record):
    vehicle = record["vehicle"]
    modes = [mode for mode in record["modes"] if mode["name"] in record["against"]]
    if len(modes) != len(record["against"]) or not modes:
        yield "a mode of `against` is not declared"
    margin, name, tilt = sets.rest_margin(vehicle, record["air"], modes, record["reserve"])
    if margin < MARGIN_OF_REST:
        yield f"rest has a margin of {100 * margin:.2f} % in the set {name}"
    allowed = [own["tilt"][1] for own in [record["limits"], *(p["limits"] for p in record["points"])] if "tilt" in own]
    if allowed and math.degrees(tilt) > min(allowed) - MARGIN_OF_TILT:
        yield f"rest tilts by {math.degrees(tilt):.1f} degrees"


def violated(record):
    """The statements of the premise that the mission violates."""
    points = record["points"]
    found = []
    if not 3 <= len(points) <= 40:
        found.append(f"{len(points)} waypoints")
    if samples_needed(points) > MOST_SAMPLES:
        found.append("too many legs for the samples")
    if any(key in point for point in points for key in ("time", "arrive")):
        found.append("a waypoint has a time or a direction of arrival")
    found += violated_by_limits(record)
    found += violated_by_lines(record)
    return found or list(violated_at_rest(record))
