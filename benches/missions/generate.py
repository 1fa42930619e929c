#!/usr/bin/env python3
"""Random missions that have a plan: `python3 benches/missions/generate.py SEED` prints a spec. The same seed gives the same spec.

    generate.py SEED             print the spec
    generate.py SEED --json      print the same mission as a record, in SI units and degrees, for programs that read no specs
    generate.py --all FOLDER     write both for the 300 pinned seeds, and count what they contain
    generate.py --digest         print the digest of the 300 specs, and exit with 1 if it is not the pinned one

Vehicles have 4 to 16 rotors, missions 3 to 40 waypoints: slaloms, surveys, pick and place, windows in walls, rings around towers,
dashes at the edge of thrust, inspections and random walks, with volumes, corridors, straight and vertical legs, holds, stops, rules
for yaw, wind and limits. Each has a plan for every planner, however long it takes, because it satisfies a premise:

  - The mission is at rest at both ends. No waypoint has a time or a direction of arrival, and no limit requires motion.
  - The straight lines through the waypoints are free. A sphere of the vehicle's size keeps 0.3 m more than each volume requires, and
    the centre of gravity keeps 0.3 m from limits on its place.
  - Rest in every stated wind, with every stated mass, lies inside the sets of the healthy vehicle and of each mode of `against` by
    2 % of the healthy set's width, after the reserve. Its tilt is a degree below each limit on tilt.
  - Five of the 200 samples remain for each leg, and ten for a leg that the spec requires to begin and end at rest.

A vehicle that flies each leg slowly from rest to rest is then always near rest, and satisfies every constraint.

`premise.py` checks this from the record of the mission, not from the way it was made. A mission that fails is made anew from the next
numbers of its seed; what is printed has passed. The standard library is enough.
"""

import hashlib
import json
import random
import sys
from collections import Counter
from pathlib import Path

import families
import premise
import vehicles

SEEDS = range(300)
DIGEST = "ee5b933b571b1e81226d63bd0ae6551b8ded504eb5a3d2deb60d8cfc2d61902c"  # of the 300 specs, in order
ATTEMPTS = 400
RESERVES = [0.1, 0.1, 0.1, 0.1, 0.05, 0.15]
MOST_WAYPOINTS = [6, 8, 10, 12, 12, 12, 12, 20, 30, 40]
MARGIN, MARGIN_AT_EDGE = 0.03, 0.022  # of rest: more than the 2 % of the premise


def air_of(r, vehicle, family):
    """Drag of the vehicle, wind and density; whether the spec has an `air` block."""
    air = {"wind": [0.0, 0.0, 0.0], "spread": [0.0, 0.0, 0.0], "density": 1.225}
    indoors = family == "windows"
    if r.random() < (0.25 if indoors else 0.65):
        across = float(f"{r.uniform(0.08, 0.18) * vehicle['mass'] ** (2 / 3):.2g}")
        vehicle["drag"] = [across, across, across if r.random() < 0.8 else float(f"{0.6 * across:.2g}")]
        if not indoors and r.random() < 0.8:
            top = r.choice([2, 4, 6, 8])
            air["wind"] = [float(round(r.uniform(-top, top), 1)), float(round(r.uniform(-top, top), 1)), r.choice([0.0, 0.0, 0.0, 0.5, -0.5])]
            if vehicle["drag"][0] == vehicle["drag"][2] and r.random() < 0.25:
                air["spread"] = [1.0, 1.0, 0.0]
    elif r.random() < 0.15:
        vehicle["mass_spread"] = r.choice([0.02, 0.03])
    if r.random() < 0.12:
        air["density"] = r.choice([1.1, 1.15, 1.0])
    return air, any(air["wind"]) or air["density"] != 1.225


def limits_of(r, mission):
    """Limits of the whole mission, beside those that its family gives."""
    limits = mission.limits
    if r.random() < 0.85:
        limits[r.choice(["speed", "speed", "speed_horizontal"])] = [None, float(r.choice([3, 5, 6, 8, 10, 12, 14]))]
    if r.random() < 0.8:
        limits["tilt"] = [None, float(r.choice([20, 25, 30, 35, 40]))]
    for name, chance, values in (
        ("climb", 0.15, [2, 3, 5]), ("descent", 0.2, [1.5, 2, 3]), ("acceleration", 0.12, [3, 5, 7]),
        ("acceleration_horizontal", 0.08, [2, 4, 6]), ("jerk", 0.06, [15, 30]), ("yaw_rate", 0.3, [30, 45, 60, 90]),
        ("yaw_acceleration", 0.06, [60, 120]),
    ):  # fmt: skip
        if r.random() < chance and name not in limits:
            limits[name] = [None, float(r.choice(values))]
    if r.random() < 0.1:
        for axis, name in enumerate("xy"):
            places = [point["at"][axis] for point in mission.points]
            limits[name] = [round(min(places) - r.uniform(1, 5), 1), round(max(places) + r.uniform(1, 5), 1)]
    mission.limits = {name: limits[name] for name in sorted(limits)}


def attempt(seed, number):
    """One mission as a record and as the text of its spec; None where the random numbers do not fit."""
    whole = random.Random(seed)  # what every attempt keeps, so that the difficult ones are not the rare ones
    most, thrust_to_weight = whole.choice(MOST_WAYPOINTS), whole.uniform(1.9, 3.0)
    r = random.Random(1000 * seed + number)
    family = families.FAMILIES[seed % len(families.FAMILIES)]
    at_edge = family is families.dash and r.random() < 0.7
    kinds = list(vehicles.LAYOUTS)
    kind = kinds[(seed // len(families.FAMILIES) + 5 * seed) % len(kinds)]
    if family is families.slalom and whole.random() < 0.5:
        kind = whole.choice(["quad", "quad", "hexa_ppnnpn"])
    # A vehicle that tolerates none of its modes is given more thrust.
    vehicle = vehicles.make(r, kind, thrust_to_weight * min(1.5, 1.02**number))
    air, with_air = air_of(r, vehicle, family.__name__)
    reserve = r.choice(RESERVES)
    faults = vehicles.tolerated(r, vehicle, air, reserve, MARGIN_AT_EDGE if at_edge else MARGIN, at_edge)
    if faults is None:
        return None
    statements, against = faults
    mission = family(r, vehicle["size"], most)
    limits_of(r, mission)
    within, yaw_within = r.choice([0.05, 0.05, 0.1]), r.choice([2.0, 2.0, 5.0])
    record = {
        "seed": seed, "family": mission.kind, "vehicle": vehicle, "modes": [m for _, modes, _ in statements for m in modes],
        "against": [m["name"] for m in against], "reserve": reserve, "samples": 200, "points": mission.record(within, yaw_within),
        "volumes": mission.volumes, "limits": mission.limits, "air": air,
    }  # fmt: skip
    if premise.violated(record):
        return None
    plan = []
    if all(len(modes) == len(kept) for _, modes, kept in statements):
        plan.append("against = all")
    else:
        plan.append(f"against = [{', '.join(record['against'])}]")
    plan.append("time = minimum")
    for name, text, usual in (
        ("reserve", f"{100 * reserve:g} %", reserve == 0.1), ("within", f"{100 * within:g} cm", within == 0.05),
        ("yaw_within", f"{yaw_within:g} deg", yaw_within == 2.0),
    ):  # fmt: skip
        if not usual:
            plan.append(f"{name} = {text}")
    lines = [f"// Mission {seed} of benches/missions/generate.py: {mission.kind}, {len(vehicle['rotors'])} rotors, {len(mission.points)} waypoints."]
    lines += vehicles.lines(vehicle)
    lines += ["faults {", *(f"    {statement}" for statement, _, _ in statements), "}"]
    lines += mission.lines(air, with_air)
    lines.append("plan { " + "; ".join(plan) + " }")
    return record, "\n".join(lines) + "\n"


def mission(seed):
    """The record and the spec of a seed, whose premise holds."""
    for number in range(ATTEMPTS):
        made = attempt(seed, number)
        if made:
            assert not premise.violated(made[0]), f"seed {seed}"
            return made
    raise SystemExit(f"seed {seed}: no mission with the premise in {ATTEMPTS} attempts")


def counts(records):
    """What the missions contain, as lines of text."""
    found = Counter()
    for record in records:
        points, volumes = record["points"], record["volumes"]
        found["family " + record["family"]] += 1
        found[f"{len(record['vehicle']['rotors']):2} rotors"] += 1
        found["vehicle " + record["vehicle"]["kind"]] += 1
        for has, name in (
            (any(v["side"] == "keep_in" for v in volumes), "keep_in"), (any(v["side"] == "keep_out" for v in volumes), "keep_out"),
            (any(p["line"] == "vertical" for p in points), "vertical legs"), (any(p["line"] == "straight" for p in points), "straight legs"),
            (any(p["corridor"] and not p["line"] for p in points), "corridors"), (any(p["hold"] for p in points), "holds"),
            (any(p["stop"] for p in points), "stops"), (any(record["air"]["wind"]), "wind"), (any(record["air"]["spread"]), "wind with an interval"),
            (record["vehicle"]["mass_spread"], "mass with an interval"), (any(p["limits"] for p in points), "limits of a leg"),
        ):  # fmt: skip
            found[name] += bool(has)
        for shape in {v["shape"] for v in volumes}:
            found["shape " + shape] += 1
        for rule in {p["yaw"]["rule"] for p in points}:
            found["yaw " + rule] += 1
        for name in record["limits"]:
            found["limit " + name] += 1
        for kind in {name.rstrip("0123456789") for name in record["against"]}:
            found["against " + kind] += 1
        found["up to 12 waypoints"] += len(points) <= 12
        found["above 20 waypoints"] += len(points) > 20
    return [f"{count:4}  {name}" for name, count in sorted(found.items())]


def main():
    arguments = sys.argv[1:]
    if arguments[:1] == ["--all"] and len(arguments) == 2:
        folder = Path(arguments[1])
        folder.mkdir(parents=True, exist_ok=True)
        records = []
        for seed in SEEDS:
            record, text = mission(seed)
            records.append(record)
            Path(folder, f"{seed:03}.mav").write_text(text)
            Path(folder, f"{seed:03}.json").write_text(json.dumps(record) + "\n")
        print("\n".join(counts(records)))
    elif arguments == ["--digest"]:
        digest = hashlib.sha256("".join(mission(seed)[1] for seed in SEEDS).encode()).hexdigest()
        print(digest)
        sys.exit(0 if digest == DIGEST else 1)
    elif len(arguments) in (1, 2) and arguments[0].isdigit() and arguments[1:] in ([], ["--json"]):
        record, text = mission(int(arguments[0]))
        print(json.dumps(record, indent=1) if arguments[1:] else text, end="\n" if arguments[1:] else "")
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
