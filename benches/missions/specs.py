"""The record of a mission from a spec, for specs of literals only: what `independent.py` plans.

The vehicle and its modes come from `mavc emit model --format json`; the mission is read here, statement by statement. Specs with `let`,
curves or tables are not read: the generator writes records of its own missions.
"""

import json
import math
import re
import subprocess

UNITS = {
    "m": 1.0, "cm": 0.01, "mm": 0.001, "deg": 1.0, "rad": 180 / math.pi, "s": 1.0, "m/s": 1.0, "km/h": 1 / 3.6, "m/s^2": 1.0,
    "m/s^3": 1.0, "deg/s": 1.0, "deg/s^2": 1.0, "%": 0.01, "": 1.0, "kg/m^3": 1.0,
}  # fmt: skip
NUMBER = r"-?[\d.]+(?:e-?\d+)?"


def _value(text):
    """A number, list or list of lists with a unit, in SI units; angles in degrees."""
    numbers, unit = re.fullmatch(r"\s*(\[.*\]|" + NUMBER + r")\s*(\S*)\s*", text).groups()
    scale = UNITS[unit]
    scaled = lambda v: [scaled(x) for x in v] if isinstance(v, list) else float(v) * scale
    return scaled(json.loads(numbers))


def _limits(body):
    found = {}
    for name, relation, value in re.findall(r"(\w+)\s*(<=|>=|in)\s*([^;\n]+)", body):
        if relation == "in":
            low, high = value.split("..")
            unit = re.sub(r"[\d.\-\s]", "", high.strip(), count=0)
            found[name] = [_value(low if re.search("[a-z]", low) else low + unit), _value(high)]
        else:
            low, high = found.get(name, [None, None])
            found[name] = [low, _value(value)] if relation == "<=" else [_value(value), high]
    return found


def _block(text, head):
    """The body of the first block with this head, and the text without it."""
    found = re.search(rf"\b{head}\s*\{{", text)
    if not found:
        return "", text
    depth, at = 1, found.end()
    while depth:
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        at += 1
    return text[found.end() : at - 1], text[: found.start()] + text[at:]


def _points(text, within, yaw_within):
    points, yaw = [], {"rule": "angle", "deg": 0.0}
    for line in text.splitlines():
        line = line.strip()
        if held := re.fullmatch(r"hold\s+(.+)", line):
            points[-1]["hold"] = _value(held[1])
            continue
        found = re.match(r"(?:start|waypoint)\b.*?\bat\s+(\[[^\]]*\]\s*m)(.*)", line)
        if not found:
            continue
        rest, own = found[2], {}
        if braces := re.search(r"\{(.*)\}", rest):
            own, rest = _limits(braces[1]), rest[: braces.start()]
        if "yaw towards" in rest:
            yaw = {"rule": "towards", "point": _value(re.search(r"yaw towards\s+(\[[^\]]*\]\s*m)", rest)[1])}
        elif "yaw along path" in rest:
            yaw = {"rule": "path"}
        elif "yaw free" in rest:
            yaw = {"rule": "free"}
        elif angle := re.search(rf"\byaw\s+({NUMBER}\s*\w+)", rest):
            yaw = {"rule": "angle", "deg": _value(angle[1])}
        clause = lambda name: (m := re.search(rf"(?<!\w){name}\s+({NUMBER}\s*\w+)", rest)) and _value(m[1])
        line_of = next((word for word in ("vertical", "straight") if re.search(rf"\b{word}\b", rest)), None)
        point = {
            "at": _value(found[1]), "yaw": yaw, "within": clause("within") or within, "yaw_within": clause("yaw_within") or yaw_within,
            "corridor": clause("corridor"), "line": line_of, "stop": bool(re.search(r"\bstop\b", rest)), "hold": 0.0, "limits": own,
        }  # fmt: skip
        if line_of:
            point["corridor"] = max(point["within"], points[-1]["within"])
        points.append(point)
    return points


def _against(text, modes):
    found = re.search(r"\bagainst\s*=\s*(\[[^\]]*\]|\w+)", text)
    words = found[1] if found else "all"
    names = [mode["name"] for mode in modes]
    if words == "all":
        return names
    chosen = []
    for word in words.strip("[]").split(","):
        if ".." in word:
            first, last = (names.index(end.strip()) for end in word.split(".."))
            chosen += names[first : last + 1]
        else:
            word = word.strip()
            chosen += [name for name in names if name == word or re.fullmatch(rf"{word}[\d_]+", name)]
    return chosen


def read(path, mavc):
    """The record of a spec."""
    with open(path) as file:
        text = re.sub(r"//[^\n]*", "", file.read())
    model = json.loads(subprocess.run([mavc, "emit", "model", path, "--format", "json"], check=True, capture_output=True, text=True).stdout)
    vehicle_text, _ = _block(text, r"vehicle\s+\w+")
    plan, _ = _block(text, "plan")
    mission, _ = _block(text, r"mission\s+\w+")
    air_text, mission = _block(mission, "air")
    limits, mission = _block(mission, "limits")
    field = lambda body, name, default=None: (m := re.search(rf"\b{name}\s*=\s*([^;\n}}]+)", body)) and _value(m[1]) or default
    volumes = []
    for side, _, body in re.findall(r"\b(keep_in|keep_out)\s+(\w+)\s*\{([^}]*)\}", mission):
        volume = {"side": side, "clearance": 0.0}
        for name, value in re.findall(r"(\w+)\s*=\s*([^;\n]+)", body):
            volume[name] = value.strip() if name == "shape" else _value(value)
        volumes.append(volume)
    rotors = []
    for rotor in model["vehicle"]["rotors"]:
        assert rotor["min_speed_rad_per_s"] == 0, "rotors that cannot stop are not read"
        thrust, torque = rotor["thrust_coefficient_n_s2_per_rad2"], rotor["drag_coefficient_n_m_s2_per_rad2"]
        full = thrust * rotor["max_speed_rad_per_s"] ** 2
        rotors.append({"at": rotor["position_m"], "spin": rotor["spin"], "max_thrust": full, "torque_per_thrust": torque / thrust})
    arm = max(math.hypot(*rotor["at"]) for rotor in rotors)
    wind = re.search(r"\bwind\s*=\s*(\[[^\]]*\]\s*m/s)", air_text)
    return {
        "vehicle": {
            "mass": model["vehicle"]["mass_kg"], "mass_spread": 0.0, "inertia": model["vehicle"]["inertia_kg_m2"],
            "drag": model["vehicle"]["drag_n_s_per_m"], "size": field(vehicle_text, "size") or arm + field(vehicle_text, "propeller_radius", 0.0),
            "rotors": rotors,
        },
        "modes": model["modes"], "against": _against(plan, model["modes"]), "reserve": field(plan, "reserve", 0.1),
        "points": _points(mission, field(plan, "within", 0.05), field(plan, "yaw_within", 2.0)), "volumes": volumes, "limits": _limits(limits),
        "air": {"wind": _value(wind[1]) if wind else [0.0] * 3, "spread": [0.0] * 3, "density": field(air_text, "density", 1.225)},
    }  # fmt: skip
