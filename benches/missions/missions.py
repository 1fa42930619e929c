"""The parts of a mission: waypoints with their clauses, volumes, limits and air, as a record and as the lines of a spec."""

import math

LIMITS = {  # name: unit in the spec, its value in SI units or degrees
    "speed": "m/s", "speed_horizontal": "m/s", "climb": "m/s", "descent": "m/s", "acceleration": "m/s^2",
    "acceleration_horizontal": "m/s^2", "jerk": "m/s^3", "yaw_rate": "deg/s", "yaw_acceleration": "deg/s^2", "tilt": "deg",
    "altitude": "m", "x": "m", "y": "m",
}  # fmt: skip


def vector(v):
    return "[" + ", ".join(f"{x + 0.0:g}" for x in v) + "]"


class Mission:
    """Grows in the order of flight. All numbers are rounded before they are stored, so that the spec has the same ones."""

    def __init__(self, kind):
        self.kind, self.points, self.volumes, self.limits = kind, [], [], {}
        self.statements = []  # lines in the order of flight
        self.yaw = {"rule": "angle", "deg": 0.0}

    def _point(self, at, within, yaw_within):
        point = {
            "at": [float(x) for x in at], "yaw": dict(self.yaw), "within": within, "yaw_within": yaw_within,
            "corridor": None, "line": None, "stop": False, "hold": 0.0, "limits": {},
        }  # fmt: skip
        self.points.append(point)
        return point

    def fly(self, at, yaw=None, within=None, yaw_within=None, line=None, corridor=None, stop=False, limits=None, name=""):
        """A waypoint. `yaw` is degrees, ("towards", point), "path" or "free"; `line` is straight or vertical; within in m."""
        at = [round(x, 2) + 0.0 for x in at]
        clauses = []
        if yaw is not None:
            if isinstance(yaw, tuple):
                target = [round(x, 2) + 0.0 for x in yaw[1]]
                self.yaw = {"rule": "towards", "point": target}
                clauses.append(f"yaw towards {vector(target)} m")
            elif isinstance(yaw, str):
                self.yaw = {"rule": yaw}
                clauses.append("yaw along path" if yaw == "path" else "yaw free")
            else:
                self.yaw = {"rule": "angle", "deg": float(round(yaw))}
                clauses.append(f"yaw {round(yaw)} deg")
        point = self._point(at, within, yaw_within)
        if yaw_within is not None:
            clauses.append(f"yaw_within {yaw_within:g} deg")
        if within is not None:
            clauses.append(f"within {100 * within:g} cm")
        if line:
            point["line"] = line
            clauses.append(line)
        if corridor:
            point["corridor"] = round(corridor, 2)
            clauses.append(f"corridor {point['corridor']:g} m")
        if stop:
            point["stop"] = True
            clauses.append("stop")
        if limits:
            point["limits"] = {key: [None, value] for key, value in limits.items()}
            clauses.append("{ " + "; ".join(f"{key} <= {value:g} {LIMITS[key]}" for key, value in limits.items()) + " }")
        head = "start" if len(self.points) == 1 else f"waypoint {name}".strip()
        self.statements.append(f"{head} at {vector(at)} m  " + "  ".join(clauses))

    def hold(self, seconds):
        self.points[-1]["hold"] = round(seconds, 1)
        self.statements.append(f"hold {round(seconds, 1):g} s")

    def spiral(self, centre, radius, start, turns, points, low, high, yaw=None):
        """A curve about an upright axis. `yaw` is None for the rule in force, else an angle in degrees that is added to the way round."""
        cx, cy, radius, low, high = (round(x, 2) for x in (*centre, radius, low, high))
        start, end = round(start, 3), round(start + 2 * math.pi * turns, 3)
        climb = round((high - low) / (end - start), 4)
        body = [
            f"    x = {cx:g} m + {radius:g} m*cos(s)",
            f"    y = {cy:g} m + {radius:g} m*sin(s)",
            f"    z = {low:g} m + {climb:g} m*(s - {start:g})",
        ]
        if yaw is not None:
            body.append(f"    yaw = s*1 rad + {yaw:g} deg")
        self.statements += [f"curve s in {start:g} .. {end:g}, points = {points} {{", *body, "}"]
        for i in range(points):
            s = start + (end - start) * i / (points - 1)
            if yaw is not None:
                self.yaw = {"rule": "angle", "deg": math.degrees(s) + yaw}
            self._point([cx + radius * math.cos(s), cy + radius * math.sin(s), low + climb * (s - start)], None, None)

    def volume(self, side, shape, clearance=0.0, **fields):
        rounded = {}
        for key, value in fields.items():
            if isinstance(value, (int, float)):
                rounded[key] = round(value, 2) + 0.0
            elif isinstance(value[0], (int, float)):
                rounded[key] = [round(x, 2) + 0.0 for x in value]
            else:
                rounded[key] = [[round(x, 2) + 0.0 for x in corner] for corner in value]
        volume = {"side": side, "shape": shape, **rounded, "clearance": round(clearance, 2)}
        self.volumes.append(volume)
        return volume

    def record(self, within, yaw_within):
        """The points with the tolerances of `plan` where they have no own."""
        points = []
        for point in self.points:
            own = dict(point)
            own["within"] = within if own["within"] is None else own["within"]
            own["yaw_within"] = yaw_within if own["yaw_within"] is None else own["yaw_within"]
            points.append(own)
        for before, point in zip(points, points[1:]):
            if point["line"]:
                point["corridor"] = max(before["within"], point["within"])
        return points

    def lines(self, air, with_air):
        found = [f"mission {self.kind} {{"] + [f"    {line}".rstrip() for line in self.statements]
        for number, volume in enumerate(self.volumes, 1):
            name = f"{'room' if volume['side'] == 'keep_in' else 'body'}{number}"
            fields = [f"shape = {volume['shape']}"]
            for key, value in volume.items():
                if key in ("side", "shape") or (key == "clearance" and not value):
                    continue
                unit = {"turn": " deg", "normal": ""}.get(key, " m")
                text = f"{value:g}" if isinstance(value, float) else None
                if key == "corners":
                    text = "[" + ", ".join(vector(corner) for corner in value) + "]"
                fields.append(f"{key} = {text or vector(value)}{unit}")
            found.append(f"    {volume['side']} {name} {{ " + "; ".join(fields) + " }")
        if with_air:
            fields = []
            if any(air["wind"]) or any(air["spread"]):
                spread = f" +- {vector(air['spread'])} m/s" if any(air["spread"]) else ""
                fields.append(f"wind = {vector(air['wind'])} m/s{spread}")
            if air["density"] != 1.225:
                fields.append(f"density = {air['density']:g} kg/m^3")
            found.append("    air { " + "; ".join(fields) + " }")
        if self.limits:
            found.append("    limits {")
            for key, (low, high) in self.limits.items():
                unit = LIMITS[key]
                if low is not None and high is not None:
                    found.append(f"        {key} in {low:g} {unit} .. {high:g} {unit}")
                else:
                    found.append(f"        {key} {'<=' if low is None else '>='} {(high if low is None else low):g} {unit}")
            found.append("    }")
        return [*found, "}"]
