#!/usr/bin/env python3
"""The legs of a plan against its spec, with numpy alone: `legs.py SPEC TRAJECTORY.csv [FINER [SIZE_M]]`.

The motion is rebuilt from the derivatives at the nodes (the snap is linear between them) on a grid FINER times finer, 50
unless given. SIZE_M is the radius of the vehicle, within which a point gives no yaw. Shapes (`straight`, `vertical`, `corridor`), limits in braces, the mission's own limits, `stop`,
`arrive from` and `yaw towards`, `yaw along path` (at the nodes) are read from the spec, whose values must be literals and whose mission must consist of `start`, `waypoint` and
`hold` statements; nothing of mavc is used. Prints the largest value of each and exits with 1 where one violates the spec by
more than the tolerances of `mavc verify`: 1e-4 of a limit or of 1 in its unit, 0.1 mm for shapes.
"""

import csv
import re
import sys
from math import factorial

import numpy as np

GRAVITY = 9.81
UNITS = {
    "m": 1.0, "cm": 0.01, "mm": 0.001, "m/s": 1.0, "km/h": 1 / 3.6, "m/s^2": 1.0, "m/s^3": 1.0, "s": 1.0,
    "deg": np.pi / 180, "rad": 1.0, "deg/s": np.pi / 180, "deg/s^2": np.pi / 180, "": 1.0,
}
ARRIVAL = np.radians(5.0)
QUANTITY = r"(\[[^\]]*\]|-?[\d.]+(?:e-?\d+)?)\s*((?:m/s\^3|m/s\^2|m/s|km/h|deg/s\^2|deg/s|deg|rad|cm|mm|m|s)\b)?"


def value(text):
    """A literal with its unit, SI."""
    numbers, unit = re.fullmatch(QUANTITY, text.strip()).groups()
    return np.array(eval(numbers, {"__builtins__": {}})) * UNITS[unit or ""]  # literals of the spec


def clause(text, word):
    found = re.search(rf"\b{word}\s+{QUANTITY}", text)
    return value(found.group(0)[len(word) :]) if found else None


def limits(text):
    """Name, lower and upper bound of each limit."""
    for name, relation, bound in re.findall(r"(\w+)\s*(<=|>=|\bin\b)\s*([^;\n}]+)", text):
        if relation == "in":
            low, high = bound.split("..")
            unit = re.fullmatch(QUANTITY, high.strip()).group(2) or ""
            low = low if re.fullmatch(QUANTITY, low.strip()).group(2) else f"{low} {unit}"
            yield name, value(low), value(high)
        else:
            yield name, *((None, value(bound)) if relation == "<=" else (value(bound), None))


def yaw(head):
    """A point, `path`, `free`, the name of a waypoint, or an angle; `None` if nothing is written."""
    towards = re.search(rf"\byaw\s+towards\s+(?:{QUANTITY}|(\w+))", head)
    if towards:
        return towards.group(3) or value(towards.group(0).split("towards")[1])
    if re.search(r"\byaw\s+along\s+path\b", head):
        return "path"
    return "free" if re.search(r"\byaw\s+free\b", head) else None if clause(head, "yaw") is None else "given"


def block(text, head):
    """What the braces after `head` hold."""
    found = re.search(head + r"\s*\{", text)
    if not found:
        return ""
    depth, start = 1, found.end()
    for at in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        if depth == 0:
            return text[start:at]
    return ""


def read(path):
    """Waypoints with their clauses and the limits of the whole mission."""
    text = re.sub(r"//[^\n]*", "", open(path).read())
    within = re.search(r"\bwithin\s*=\s*([\d.]+\s*\w+)", block(text, r"\bplan"))
    mission = block(text, r"\bmission\s+\w+")
    points, ends_moving = [], bool(re.search(r"\bend\s+moving\b", mission))
    for statement in re.findall(r"^\s*((?:start\s+at|waypoint|hold)\b[^\n{]*(?:\{[^}]*\})?)", mission, re.M):
        if statement.startswith("hold"):
            points[-1]["hold"] += float(value(statement[4:]))
            continue
        head, _, braces = statement.partition("{")
        head, arrive = re.sub(r"arrive\s+from", "arrive", head), None
        arrive = clause(head, "arrive")
        words = set(re.findall(r"\b(?:straight|vertical|stop)\b", re.sub(r"^waypoint\s+\w+\s+at", "waypoint at", head)))
        tolerance = clause(head, "within")
        points.append({
            "name": (re.match(r"waypoint\s+(?!at\b)(\w+)", head) or [None, None])[1], "at": clause(head, "at"), "hold": 0.0, "words": words, "corridor": clause(head, "corridor"), "arrive": arrive,
            "within": tolerance if tolerance is not None else value(within.group(1)) if within else 0.05,
            "limits": list(limits(braces)), "yaw": yaw(head), "yaw_within": clause(head, "yaw_within"),
        })
    turned = re.search(r"\byaw_within\s*=\s*([\d.]+\s*\w+)", block(text, r"\bplan"))
    rule = None
    for point in points:
        rule = point["yaw"] = rule if point["yaw"] is None else point["yaw"]
        if isinstance(rule, str) and rule not in ("path", "free", "given"):
            rule = point["yaw"] = next(other["at"] for other in points if other["name"] == rule)
        if point["yaw_within"] is None:
            point["yaw_within"] = value(turned.group(1)) if turned else np.radians(2.0)
    return points, list(limits(block(mission, r"\blimits"))), ends_moving


def motion(path, finer):
    """Times, derivatives [order, axis] on the fine grid, and the times of the waypoints."""
    rows = list(csv.DictReader(open(path)))
    nodes = [{key: float(cell) for key, cell in row.items() if cell and key != "waypoint"} for row in rows]
    times, states = [], []
    for before, after in zip(nodes, nodes[1:]):
        h = after["t"] - before["t"]
        t = np.linspace(0.0, h, finer + 1)
        times.append(before["t"] + t)
        state = np.zeros((5, 3, len(t)))
        for i, axis in enumerate("xyz"):
            known = [before[prefix + axis] for prefix in ("", "v", "a", "j", "s")] + [0.0]
            known[5] = (after["s" + axis] - known[4]) / h
            for order in range(5):
                state[order, i] = sum(known[n] * t ** (n - order) / factorial(n - order) for n in range(order, 6))
        states.append(state)
    yaws = np.array([[node["t"], node["yaw"], node["x"], node["y"], node["vx"], node["vy"]] for node in nodes])
    reached = {int(row["waypoint"]): float(row["t"]) for row in rows if row["waypoint"] not in ("", "0")}
    return np.concatenate(times), np.concatenate(states, axis=2), [reached[k] for k in sorted(reached)], yaws


def quantity(name, s):
    """The limited quantity along the states and the size of a violation that counts as none."""
    norm = lambda order, axes: np.sqrt((s[order][axes] ** 2).sum(axis=0))
    return {
        "x": lambda: s[0][0], "y": lambda: s[0][1], "z": lambda: s[0][2], "altitude": lambda: s[0][2],
        "speed": lambda: norm(1, [0, 1, 2]), "speed_horizontal": lambda: norm(1, [0, 1]), "climb": lambda: s[1][2],
        "descent": lambda: -s[1][2], "acceleration": lambda: norm(2, [0, 1, 2]),
        "acceleration_horizontal": lambda: norm(2, [0, 1]), "jerk": lambda: norm(3, [0, 1, 2]),
        "tilt": lambda: np.arctan2(norm(2, [0, 1]), s[2][2] + GRAVITY),
    }[name]()


def main():
    spec, trajectory = sys.argv[1], sys.argv[2]
    points, general, ends_moving = read(spec)
    times, states, reached, nodes = motion(trajectory, int(sys.argv[3]) if len(sys.argv) > 3 else 50)
    size = float(sys.argv[4]) if len(sys.argv) > 4 else 0.0
    assert len(points) == len(reached), (len(points), len(reached))
    wrong = 0

    def report(what, worst, most, unit, tolerance):
        nonlocal wrong
        kept = worst <= most + tolerance
        wrong += not kept
        print(f"{what}: {worst:.6g} {unit} of {most:g}{'' if kept else '  VIOLATED'}")

    def bounded(where, name, low, high, s):
        found = quantity(name, s)
        size = max([abs(float(bound)) for bound in (low, high) if bound is not None] + [1.0])
        if high is not None:
            report(f"{where}{name} at most", float(found.max()), float(high), "SI", 1e-4 * size)
        if low is not None:
            report(f"{where}-{name} at most", float(-found.min()), float(-low), "SI", 1e-4 * size)

    for limit in general:
        bounded("", *limit, states)
    for leg in range(1, len(points)):
        start, end = points[leg - 1], points[leg]
        on = (times >= reached[leg - 1] + start["hold"] - 1e-9) & (times <= reached[leg] + 1e-9)
        s = states[:, :, on]
        where = f"leg to {leg + 1}: "
        radius = end["corridor"]
        if end["words"] & {"straight", "vertical"}:
            radius = max(start["within"], end["within"])
        if radius is not None:
            way = end["at"] - start["at"]
            length = np.linalg.norm(way)
            ahead = (s[0].T - start["at"]) @ way / length
            aside = np.linalg.norm((s[0].T - start["at"]) - ahead[:, None] * way / length, axis=1)
            past = max(float(-ahead.min()), float((ahead - length).max()))
            report(where + "distance from the line", float(aside.max()), float(radius), "m", 1e-4)
            report(where + "past its ends", past, float(radius), "m", 1e-4)
        for limit in end["limits"]:
            bounded(where, *limit, s)
        velocity = s[1][:, -1]
        if end["arrive"] is not None:
            towards = -end["arrive"] / np.linalg.norm(end["arrive"])
            ahead = float(velocity @ towards)
            aside = float(np.linalg.norm(velocity - ahead * towards))
            out = aside * np.cos(ARRIVAL) - ahead * np.sin(ARRIVAL)
            angle = np.degrees(np.arctan2(aside, ahead))
            report(where + f"arrival at {np.linalg.norm(velocity):.3g} m/s and {angle:.3g} deg, outside its cone by", out, 0.0, "m/s", 1e-4)
        if "stop" in end["words"] or end["hold"] > 0.0 or leg + 1 == len(points) and not ends_moving:
            report(where + "speed at its end", float(np.linalg.norm(velocity)), 0.0, "m/s", 1e-5)
            report(where + "acceleration at its end", float(np.linalg.norm(s[2][:, -1])), 0.0, "m/s^2", 1e-4)
    for i, point in enumerate(points):
        rule = point["yaw"]
        if rule is None or isinstance(rule, str) and rule != "path":
            continue
        same = i > 0 and np.array_equal(points[i - 1]["yaw"], rule)
        first = reached[i - 1] + points[i - 1]["hold"] if same else reached[i]
        on = nodes[(nodes[:, 0] >= first - 1e-9) & (nodes[:, 0] <= reached[i] + 1e-9)]
        way = on[:, 4:6] if isinstance(rule, str) else rule[:2] - on[:, 2:4]
        far = np.hypot(*way.T) >= (0.3 if isinstance(rule, str) else size)
        error = on[:, 1] - np.arctan2(way[:, 1], way[:, 0])
        error = np.abs((error + np.pi) % (2 * np.pi) - np.pi)[far]
        if len(error):
            what = f"yaw of {len(error)} nodes up to waypoint {i + 1}"
            report(what, float(np.degrees(error.max())), float(np.degrees(point["yaw_within"])), "deg", 0.01)
    print(f"{len(times)} points")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
