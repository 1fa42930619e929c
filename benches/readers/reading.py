"""Random missions of ArduCopter in MAVLink's plain text: what `mavc import mission` makes of them, against a second reading.

    python benches/readers/reading.py MAVC [COUNT]

The second reading takes the items from pymavlink's own loader, follows them as ArduCopter 4.5 does (`mode_auto.cpp`: `loc_from_cmd`,
`do_land`, `do_yaw`, `do_nav_wp`, `set_roi`), and places them by pymap3d. Exits with 1 if a place or a yaw is another.
"""

import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile

os.environ["MAVLINK20"] = "1"

import numpy as np  # noqa: E402
import pymap3d  # noqa: E402
from pymavlink import mavwp  # noqa: E402

HOME = (47.4, 8.54, 500.0)
PLACE = {16, 19, 82}
SLOW = 10.0
# The spec has millimetres; "to above the landing" it keeps z, and the Earth curves down by 5 mm in 250 m.
TOLERANCE = 1e-2


def mission(chance):
    """Lines of a mission: a take-off, places, turns, regions and an end."""
    def place():
        return 47.4 + chance.uniform(-0.002, 0.002), 8.54 + chance.uniform(-0.002, 0.002)

    rows = [(3, 22, [0, 0, 0, 0], (0, 0), chance.choice([5, 12.5, 30]))]
    for _ in range(chance.randrange(2, 9)):
        kind = chance.random()
        if kind < 0.5:
            frame = chance.choice([0, 3])
            height = chance.choice([0, 0, chance.uniform(2, 60)])
            where = place() if chance.random() < 0.8 else (0, 0)
            hold = chance.choice([0, 0, 3])
            command = chance.choice([16, 16, 82, 19])
            rows.append((frame, command, [hold, 0, 0, chance.choice([0, 77])], where, height + (500 if frame == 0 and height else 0)))
        elif kind < 0.7:
            rows.append((0, 115, [chance.uniform(0, 360), 0, 0, 0], (0, 0), 0))
        elif kind < 0.85:
            rows.append((3, 201, [0, 0, 0, 0], place(), chance.uniform(0, 30)))
        else:
            rows.append((0, 197, [0] * 4, (0, 0), 0))
    if chance.random() < 0.6:
        rows.append((3, 21, [0] * 4, place() if chance.random() < 0.5 else (0, 0), chance.choice([0, 20, 3.5])))
    elif chance.random() < 0.5:
        rows.append((0, 20, [0] * 4, (0, 0), 0))
    else:
        rows.append((3, 16, [0] * 4, place(), 10))
    lines = ["QGC WPL 110", "0\t1\t0\t16\t0\t0\t0\t0\t47.4\t8.54\t500\t1"]
    for k, (frame, command, params, (x, y), z) in enumerate(rows):
        lines.append("\t".join(map(str, [k + 1, 0, frame, command, *params, x, y, z, 1])))
    return "\n".join(lines) + "\n"


def local(latitude, longitude, height):
    return np.array(pymap3d.geodetic2enu(latitude, longitude, height, *HOME))


def flown(path):
    """Places (m from home) and yaws of the flight: a number (deg from east), a point to look at, or None."""
    loader = mavwp.MAVWPLoader()
    loader.load(str(path))
    at = [*HOME[:2], HOME[2]]
    found = [(local(*at), None)]
    turn, region = None, None

    def yaw():
        nonlocal turn, region
        if turn is not None:
            value, turn, region = turn, None, None
            return value
        return region

    def to(latitude, longitude, height, pointing):
        at[:] = latitude, longitude, height
        found.append((local(*at), pointing))

    def down(latitude, longitude, pointing):
        here = local(*at)
        there = local(latitude, longitude, at[2])
        if np.hypot(*(here - there)[:2]) > 0.5:
            to(latitude, longitude, at[2], pointing)
        else:
            latitude, longitude = at[:2]
        if at[2] - HOME[2] > SLOW + 0.5:
            to(latitude, longitude, HOME[2] + SLOW, pointing)
        to(latitude, longitude, HOME[2], pointing)

    for item in (loader.wp(k) for k in range(1, loader.count())):
        command = int(item.command)
        named = item.x != 0 or item.y != 0
        if command == 115:
            turn = 90 - item.param1
        elif command == 201:
            region, turn = local(item.x, item.y, HOME[2])[:2], None
        elif command == 197:
            region = None
        elif command == 22:
            to(at[0], at[1], HOME[2] + item.z, yaw())
        elif command in PLACE:
            centimetres = int(item.z * 100)
            height = at[2] if centimetres == 0 else item.z + (HOME[2] if item.frame == 3 else 0)
            to(*((item.x, item.y) if named else at[:2]), height, yaw())
        elif command == 21:
            down(*((item.x, item.y) if named else at[:2]), yaw())
        elif command == 20:
            down(*HOME[:2], None)
    return found


def imported(mavc, path):
    run = subprocess.run([mavc, "import", "mission", str(path)], capture_output=True, text=True)
    if run.returncode != 0:
        raise SystemExit(f"{path.read_text()}\n{run.stderr}")
    found, yaw = [], None
    for line in run.stdout.splitlines():
        place = re.match(r"\s+(?:start|waypoint) at \[(.+?)\] m", line)
        if not place:
            continue
        if "yaw free" in line:
            yaw = None
        elif towards := re.search(r"yaw towards \[(.+?), (.+?), 0\]", line):
            yaw = np.array([float(x) for x in towards.groups()])
        elif given := re.search(r"yaw (\S+) deg", line):
            yaw = float(given.group(1))
        found.append((np.array([float(x) for x in place.group(1).split(",")]), yaw))
    return found


def main():
    mavc, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 200
    worst, failed, places = 0.0, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "m.waypoints"
        for seed in range(count):
            path.write_text(mission(random.Random(seed)))
            ours, due = imported(mavc, path), flown(path)
            good = len(ours) == len(due)
            for (place, yaw), (other, other_yaw) in zip(ours, due):
                off = np.abs(place - other).max()
                worst = max(worst, off)
                if isinstance(yaw, np.ndarray) and isinstance(other_yaw, np.ndarray):
                    same = np.abs(yaw - other_yaw).max() < TOLERANCE
                elif isinstance(yaw, float) and isinstance(other_yaw, float):
                    same = abs((yaw - other_yaw + 180) % 360 - 180) < 2e-3
                else:
                    same = yaw is None and other_yaw is None
                good &= same and off < TOLERANCE
                places += 1
            if not good:
                failed += 1
                if failed == 1:
                    print(path.read_text(), *ours, "", *due, sep="\n")
    print(f"{count} missions, {places} places: {failed} read otherwise; places within {1e3 * worst:.2f} mm")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
