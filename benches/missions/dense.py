"""A motion at many instants, with numpy: its wrench in the exact model and every violation of its mission.

The attitude follows from yaw and from the direction of the thrust; body rates and accelerations are differences of rotation matrices,
and torques follow from Euler's equation. Nothing here is shared with the program of `program.py`, except the record of the mission, the
facets of `sets` and the motion itself.
"""

import math

import numpy as np
import sets
import shapes

STEP = 1e-4  # of the differences, s
# Violations that a checked motion may have, wrench in shares of the healthy set's width; `else` is for m, m/s and m/s^2.
ALLOWED = {"wrench": 1e-3, "tilt": 0.02, "yaw": 0.02, "rest": 1e-3, "joins": 1e-3, "joins of yaw": 1e-3, "yaw_rate": 0.05, "yaw_acceleration": 1.0, "jerk": 0.1, "else": 2e-3}
MOST_PEAKS = 3  # instants of a piece
RULE_SPEED = 0.3  # m/s, below which `yaw along path` pauses


class Motion:
    """Pieces with a linear snap and a linear yaw acceleration.

    `x` (pieces, 4, 3) has position, velocity, acceleration and jerk at the beginning of each piece, `s` (pieces, 2, 3) the snap at both
    ends, `y` (pieces, 4) yaw, its rate and its acceleration at both ends, `h` (pieces,) the durations, `leg` (pieces,) the leg, counted
    from 0, or -1 in a hold.
    """

    def __init__(self, x, s, y, h, leg):
        self.x, self.s, self.y, self.h, self.leg = (np.asarray(a, dtype=float) for a in (x, s, y, h, leg))
        self.leg = self.leg.astype(int)

    def time(self):
        return float(self.h.sum())

    def at(self, piece, t):
        """Derivatives 0 to 4 of the position (5, n, 3) and 0 to 2 of yaw (3, n) at times within pieces."""
        x, s, y, h = self.x[piece], self.s[piece], self.y[piece], self.h[piece]
        slope, t = (s[:, 1] - s[:, 0]) / h[:, None], np.asarray(t)[:, None]
        highest = [x[:, 0], x[:, 1], x[:, 2], x[:, 3], s[:, 0], slope]
        place = [sum(highest[j] * t ** (j - i) / math.factorial(j - i) for j in range(i, 6)) for i in range(5)]
        own = [y[:, 0], y[:, 1], y[:, 2], (y[:, 3] - y[:, 2]) / h]
        yaw = [sum(own[j] * t[:, 0] ** (j - i) / math.factorial(j - i) for j in range(i, 4)) for i in range(3)]
        return np.array(place), np.array(yaw)

    def instants(self, step):
        """The pieces and times of instants that are at most `step` apart, both ends of each piece among them."""
        counts = np.maximum(2, np.ceil(self.h / step).astype(int) + 1)
        piece = np.repeat(np.arange(len(self.h)), counts)
        t = np.concatenate([np.linspace(0, h, n) for h, n in zip(self.h, counts)])
        return piece, t


def attitude(place, yaw, drag_per_mass, wind):
    """Thrust over mass (n,) and rotation matrices (n, 3, 3)."""
    across, along = drag_per_mass[0], drag_per_mass[2]
    air = place[1] - wind
    c = place[2] + [0, 0, sets.GRAVITY] + across * air
    length = np.linalg.norm(c, axis=1)
    b3 = c / length[:, None]
    left = np.stack([-np.sin(yaw[0]), np.cos(yaw[0]), 0 * yaw[0]], axis=1)
    b1 = np.cross(left, b3)
    b1 /= np.linalg.norm(b1, axis=1)[:, None]
    return length + (along - across) * (b3 * air).sum(axis=1), np.stack([b1, np.cross(b3, b1), b3], axis=2)


def wrenches(motion, record, piece, t, wind):
    """Thrust over mass and torques (n, 4), and the tilt in degrees, at instants."""
    vehicle = record["vehicle"]
    k = np.array(vehicle["drag"]) * record["air"]["density"] / sets.SEA_LEVEL / vehicle["mass"]
    inertia = np.array(vehicle["inertia"])
    now, early, late = (attitude(*motion.at(piece, t + d), k, wind) for d in (0.0, -STEP, STEP))
    odd = lambda r: np.stack([r[:, 2, 1] - r[:, 1, 2], r[:, 0, 2] - r[:, 2, 0], r[:, 1, 0] - r[:, 0, 1]], axis=1) / 2
    back = now[1].transpose(0, 2, 1)
    rate = odd(back @ (late[1] - early[1])) / (2 * STEP)
    acceleration = odd(back @ (late[1] - 2 * now[1] + early[1])) / STEP**2
    torque = inertia * acceleration + np.cross(rate, inertia * rate)
    return np.column_stack([now[0], torque]), np.degrees(np.arccos(np.clip(now[1][:, 2, 2], -1, 1)))


def facets_of(record, planner):
    """Rows (n, offset, width, mass) over thrust and torques: n.w <= offset in every set of the planner, shrunk by the reserve.

    Sets share normals; of each the smallest offset is kept. `mass` is the one of the interval for which the row is hardest.
    """
    vehicle, air = record["vehicle"], record["air"]
    density, drag = air["density"], [d * air["density"] / sets.SEA_LEVEL for d in vehicle["drag"]]
    whole = np.array(sets.columns(vehicle, density))
    hover, _ = sets.thrust_at_rest(vehicle["mass"], drag, air["wind"])
    modes = [m for m in record["modes"] if m["name"] in record["against"]] if planner == "rcp" else []
    found = {}
    for mode in [None, *modes]:
        for n, offset in sets.set_of_mode(vehicle, mode, density):
            n = np.array(n)
            length = np.linalg.norm(n * sets.scale_of(whole))
            n, offset = n / length, offset / length
            limit = n[0] * hover + (1 - record["reserve"]) * (offset - n[0] * hover)
            key = tuple(np.round(n * sets.scale_of(whole), 6) + 0.0)
            mass = vehicle["mass"] * (1 + math.copysign(vehicle["mass_spread"], n[0]))
            if key not in found or limit < found[key][1]:
                found[key] = (n, limit, np.abs(whole @ n).sum(), mass)
    rows = list(found.values())
    return np.array([r[0] for r in rows]), *(np.array([r[i] for r in rows]) for i in (1, 2, 3))


def triangles(corners):
    """A simple polygon as triangles, by cutting ears; a convex one stays whole."""
    area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, corners[1:] + corners[:1]))
    left = list(corners) if area > 0 else list(corners)[::-1]
    cross = lambda a, b, c: (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    turns = [cross(left[i - 1], left[i], left[(i + 1) % len(left)]) for i in range(len(left))]
    if min(turns) >= 0:
        return [left]
    found = []
    while len(left) > 3:
        for i in range(len(left)):
            a, b, c = left[i - 1], left[i], left[(i + 1) % len(left)]
            others = [p for p in left if p not in (a, b, c)]
            inside = any(cross(a, b, p) >= 0 and cross(b, c, p) >= 0 and cross(c, a, p) >= 0 for p in others)
            if cross(a, b, c) > 0 and not inside:
                found.append([a, b, c])
                del left[i]
                break
    return [*found, left]


def convex_bodies(record):
    """The keep_outs as convex volumes."""
    found = []
    for volume in record["volumes"]:
        if volume["side"] == "keep_out":
            parts = triangles(volume["corners"]) if volume["shape"] == "polygon" else [None]
            found += [volume if part is None else volume | {"corners": part} for part in parts]
    return found


def rates(place, yaw):
    """The limited quantities at instants, by name."""
    horizontal = np.hypot(place[1][:, 0], place[1][:, 1])
    return {
        "x": place[0][:, 0], "y": place[0][:, 1], "altitude": place[0][:, 2], "z": place[0][:, 2],
        "speed": np.linalg.norm(place[1], axis=1), "speed_horizontal": horizontal, "climb": place[1][:, 2], "descent": -place[1][:, 2],
        "acceleration": np.linalg.norm(place[2], axis=1), "acceleration_horizontal": np.hypot(place[2][:, 0], place[2][:, 1]),
        "jerk": np.linalg.norm(place[3], axis=1), "yaw_rate": np.abs(np.degrees(yaw[1])), "yaw_acceleration": np.abs(np.degrees(yaw[2])),
    }  # fmt: skip


def violations(motion, record, planner, step=0.005):
    """The largest violation of each kind, (value, where), and the worst instants of each piece that violates something, (piece, share).

    Wrenches are in shares of widths, others in m, m/s, degrees and so on.
    """
    points, size = record["points"], record["vehicle"]["size"]
    piece, t = motion.instants(step)
    leg, clock = motion.leg[piece], (np.cumsum(motion.h) - motion.h)[piece] + t
    place, yaw = motion.at(piece, t)
    found, worst = {}, np.zeros(len(t))

    def note(kind, values, mask=None):
        values = values if mask is None else np.where(mask, values, -np.inf)
        np.maximum(worst, values / ALLOWED.get(kind, ALLOWED["else"]), out=worst)
        at = int(np.argmax(values))
        if values[at] > found.get(kind, (-np.inf,))[0]:
            found[kind] = (float(values[at]), f"{clock[at]:.3f} s")

    rows, offsets, widths, masses = facets_of(record, planner)
    middle, corners = sets.winds(record["air"])
    for wind in corners:
        w, tilts = wrenches(motion, record, piece, t, np.array(wind))
        for n, offset, width, mass in zip(rows, offsets, widths, masses):
            note("wrench", (mass * n[0] * w[:, 0] + w[:, 1:] @ n[1:] - offset) / width)
        for number, own in [(None, record["limits"]), *((i, p["limits"]) for i, p in enumerate(points[1:]))]:
            if "tilt" in own:
                note("tilt", tilts - own["tilt"][1], None if number is None else leg == number)
    note("upright", 0.1 * sets.GRAVITY - place[2][:, 2] - sets.GRAVITY)
    quantities = rates(place, yaw)
    for number, own in [(None, record["limits"]), *((i, p["limits"]) for i, p in enumerate(points[1:]))]:
        mask = None if number is None else leg == number
        for name, (low, high) in own.items():
            if name == "tilt":
                continue
            if high is not None:
                note(name, quantities[name] - high, mask)
            if low is not None:
                note(name, low - quantities[name], mask)
    for volume in record["volumes"]:
        note(volume["side"], np.array([-shapes.room(volume, p, size) for p in place[0]]))
    for number, (before, point) in enumerate(zip(points, points[1:])):
        if point["corridor"] is not None:
            a, b = np.array(before["at"]), np.array(point["at"])
            d = (b - a) / np.linalg.norm(b - a)
            way = (place[0] - a) @ d
            across = np.linalg.norm(place[0] - a - way[:, None] * d, axis=1)
            note("corridor", np.maximum(across, np.maximum(-way, way - np.linalg.norm(b - a))) - point["corridor"], leg == number)
    ends = _ends(motion)
    for number, point in enumerate(points):
        for x, y, at in ends[number]:
            values = {"waypoint": np.linalg.norm(x[0] - point["at"]) - point["within"]}
            if number in (0, len(points) - 1) or point["stop"] or point["hold"]:
                values["rest"] = max(np.abs(x[1]).max(), np.abs(x[2]).max(), np.abs(x[3][:2]).max(), abs(y[1]), abs(y[2]))
            for kind, value in values.items():
                if value > found.get(kind, (-np.inf,))[0]:
                    found[kind] = (float(value), at)
    errors = yaw_errors(motion, record)
    if errors:
        found["yaw"] = max(errors)
    turned = np.array([motion.at([i], [motion.h[i]])[1][:2, 0] - motion.y[i + 1, :2] for i in range(len(motion.h) - 1)])
    found["joins of yaw"] = (float(np.abs(turned).max()), f"piece {int(np.abs(turned).max(axis=1).argmax())}")
    joins = [np.abs(motion.at([i], [motion.h[i]])[0][:4, 0] - motion.x[i + 1]).max() for i in range(len(motion.h) - 1)]
    found["joins"] = (float(max(joins)), f"piece {int(np.argmax(joins))}")
    instants = []
    for i in np.unique(piece[worst > 0.2]):
        own = np.flatnonzero(piece == i)
        high = np.concatenate([[-np.inf], worst[own], [-np.inf]])
        peaks = own[(high[1:-1] >= high[:-2]) & (high[1:-1] > high[2:]) & (high[1:-1] > 0.2)]
        for at in peaks[np.argsort(-worst[peaks])][:MOST_PEAKS]:
            instants.append((int(i), float(t[at] / motion.h[i])))
    return found, instants


def _ends(motion):
    """For each waypoint the states of the legs that end and begin there: position derivatives, yaw derivatives, name."""
    legs = motion.leg.max() + 1
    found = [[] for _ in range(legs + 1)]
    for i, leg in enumerate(motion.leg):
        if leg < 0:
            continue
        for end, first in ((leg, i == 0 or motion.leg[i - 1] != leg), (leg + 1, i == len(motion.leg) - 1 or motion.leg[i + 1] != leg)):
            if first:
                place, yaw = motion.at([i], [0.0 if end == leg else motion.h[i]])
                found[end].append((place[:, 0], yaw[:, 0], f"waypoint {end + 1}"))
    return found


def yaw_errors(motion, record):
    """Errors of yaw beyond the tolerance in degrees, at waypoints with an angle and at the nodes of legs with a rule."""
    points, found = record["points"], []
    wrapped = lambda e: abs((e + 180) % 360 - 180)

    def error(rule, place, psi):
        if rule["rule"] == "angle":
            return wrapped(math.degrees(psi) - rule["deg"])
        if rule["rule"] == "free":
            return 0.0
        ahead = place[1][:2] if rule["rule"] == "path" else np.array(rule["point"][:2]) - place[0][:2]
        if np.linalg.norm(ahead) < (RULE_SPEED if rule["rule"] == "path" else record["vehicle"]["size"]):
            return 0.0
        return wrapped(math.degrees(psi - math.atan2(ahead[1], ahead[0])))

    for number, ends in enumerate(_ends(motion)):
        for place, yaw, at in ends:
            found.append((error(points[number]["yaw"], place, yaw[0]) - points[number]["yaw_within"], at))
    for i, leg in enumerate(motion.leg):
        if leg >= 0 and points[leg]["yaw"] == points[leg + 1]["yaw"] and points[leg + 1]["yaw"]["rule"] in ("path", "towards"):
            place, yaw = motion.at([i], [0.0])
            found.append((error(points[leg]["yaw"], place[:, 0], yaw[0, 0]) - points[leg + 1]["yaw_within"], f"piece {i}"))
    return found
