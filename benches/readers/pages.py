"""The walks of docs/px4.md, ardupilot.md, ros2.md and crazyflie.md, as a reader follows them: files are written as the pages show them,
commands of mavc and Python are run in their order, with vehicles that only record at the addresses of the pages, outputs are compared
with those quoted, and what arrived in the other tool with the plan."""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import crazyflies
import numpy as np
import pymap3d
from exact import Exact
from missions import MAVLINK
from players import Vehicle, of_guided, of_offboard
from plans import ROOT
from pymavlink import mavwp
from tables import MAX

# First words of commands that are for machines with the tool itself.
ELSEWHERE = ("pip", "ros2", "make", "sim_vehicle.py")
HERE = ("mavc", "python3", "printf")
# Where the recording vehicles are, from the start of the plans: north, east, down, m.
AWAY = (3.0, -2.0, 0.5)
PLAY = "python3 octo.py"


class Walk:
    """One page in a folder of its own."""

    def __init__(self, mavc, page, spec, folder):
        self.page, self.spec, self.folder = page, spec, Path(folder)
        (self.folder / "bin").mkdir()
        (self.folder / "bin" / "mavc").symlink_to(Path(mavc).resolve())
        path = os.pathsep.join([str(self.folder / "bin"), str(Path(sys.executable).parent), os.environ["PATH"]])
        self.environment = os.environ | {"PATH": path, "NO_COLOR": "1", "CFLIB_URI": "udp://127.0.0.1:19850"}

    def follow(self, vehicles):
        """Runs the page; `vehicles` has for beginnings of commands the vehicle that they need. How many outputs were compared."""
        text, compared, printed = (ROOT / self.page).read_text(), 0, None
        for language, name, block in re.findall(r"^```(\w+) ?(\S*)\n(.*?)^```$", text, re.M | re.S):
            if language == "sh":
                lines = [line for line in block.splitlines() if line.split()[0] not in ELSEWHERE]
                printed = "".join(self.run(line, vehicles) for line in lines) if lines else None
            elif language == "diff":
                self.edit(name or self.spec, block)
            elif language == "python":
                (self.folder / name).write_text(block)
            elif language == "text" and printed is not None:
                compared += 1
                if not is_quote(block.splitlines(), [line.rstrip() for line in printed.strip("\n").splitlines()]):
                    sys.exit(f"{self.page} shows\n{block}\nand what is printed is\n{printed}")
        return compared

    def run(self, line, vehicles):
        if line.split()[0] not in HERE:
            sys.exit(f"{self.page}: {line}: say in pages.py whether this is run")
        make = next((make for beginning, make in vehicles.items() if line.startswith(beginning)), None)
        vehicle = make() if make else None
        try:
            command = ["sh", "-c", f"exec 2>&1\n{line}"]
            ran = subprocess.run(command, cwd=self.folder, env=self.environment, capture_output=True, timeout=300)
        finally:
            if vehicle:
                vehicle.__exit__()
        # As a terminal shows it: after a carriage return a line is written anew.
        shown = "".join(f"{line.rsplit(chr(13), 1)[-1]}\n" for line in ran.stdout.decode().split("\n")[:-1])
        if ran.returncode != 0:
            sys.exit(f"{self.page}: {line}: exit code {ran.returncode}\n{shown}")
        return shown

    def edit(self, name, block):
        """The lines with ` ` and `-` are replaced by those with ` ` and `+`."""
        spec = self.folder / name
        old, new = ("".join(f"{line[1:]}\n" for line in block.splitlines() if line[:1] != left) for left in "+-")
        text = spec.read_text()
        assert text.count(old) == 1, f"{self.page}: {old} is not in {name} once"
        spec.write_text(text.replace(old, new))

    def exact(self):
        """The page's plan by mavc's table."""
        self.run(f"mavc plan {self.spec} -o nodes.csv", {})
        return Exact(self.folder / "nodes.csv", False)


def is_quote(quoted, printed):
    """Whether quoted lines stand for printed ones; `...` stands for any lines, and at the end of a line for any rest of it."""
    if not quoted:
        return not printed
    first, rest = quoted[0], quoted[1:]
    if first.strip() == "...":
        return any(is_quote(rest, printed[k:]) for k in range(len(printed) + 1))
    if not printed:
        return False
    alike = printed[0].startswith(first[:-4]) if first.endswith(" ...") else printed[0] == first
    return alike and is_quote(rest, printed[1:])


def place(exact):
    """Where a vehicle is that is AWAY from the start of a plan."""
    east, north, up = exact.at([0], 0)[0, :3]
    return [north + AWAY[0], east + AWAY[1], -up + AWAY[2]]


def keeps(made, make):
    """Makes a vehicle and keeps it for the comparison."""

    def start():
        made.append(make())
        return made[-1]

    return start


def px4(mavc):
    with tempfile.TemporaryDirectory() as folder:
        walk, setters, fliers = Walk(mavc, "docs/px4.md", "octo.mav", folder), [], []
        vehicle = lambda: Vehicle(14540, MAVLINK.MAV_AUTOPILOT_PX4, place(walk.exact()))
        compared = walk.follow({"python3 params.py": keeps(setters, vehicle), PLAY: keeps(fliers, vehicle)})
        yield "docs/px4.md", "outputs that are not compared", max(0, 4 - compared), 0
        rows = [line.split("\t") for line in (walk.folder / "rotors.params").read_text().splitlines() if line[0] != "#"]
        due = {row[2]: float(row[3]) if row[4] == "9" else int(row[3]) for row in rows}
        got = setters[0].parameters
        yield "docs/px4.md, params.py", "parameters missing", len(set(due) ^ set(got)), 0
        yield "docs/px4.md, params.py", "unlike in float32", sum(np.float32(got.get(name)) != np.float32(due[name]) for name in due), 0
        yield from of_offboard("docs/px4.md, octo.py", walk.exact(), fliers[0].received, AWAY)


def ardupilot(mavc):
    with tempfile.TemporaryDirectory() as folder:
        walk, takers, fliers = Walk(mavc, "docs/ardupilot.md", "octo.mav", folder), [], []
        vehicle = lambda: Vehicle(14550, MAVLINK.MAV_AUTOPILOT_ARDUPILOTMEGA, place(walk.exact()))
        compared = walk.follow({"python3 upload.py": keeps(takers, vehicle), PLAY: keeps(fliers, vehicle)})
        yield "docs/ardupilot.md", "outputs that are not compared", max(0, 3 - compared), 0
        yield from of_guided("docs/ardupilot.md, octo.py", walk.exact(), fliers[0].received, AWAY)
        loader = mavwp.MAVWPLoader()
        loader.load(str(walk.folder / "octo.waypoints"))
        got = takers[0].mission
        yield "docs/ardupilot.md, upload.py", "items missing", abs(len(got) - loader.count()), 0
        pairs = [(item, loader.wp(k)) for k, item in enumerate(got)]
        unlike = sum((a.command, a.frame, a.param1) != (b.command, b.frame, np.float32(b.param1)) for a, b in pairs)
        yield "docs/ardupilot.md, upload.py", "items that differ", unlike, 0
        yield "docs/ardupilot.md, upload.py", "places, deg", max(max(abs(a.x * 1e-7 - b.x), abs(a.y * 1e-7 - b.y)) for a, b in pairs), 0.51e-7
        yield "docs/ardupilot.md, upload.py", "heights, m", max(abs(a.z - b.z) for a, b in pairs), 1e-4
        # The mission ends where the plan does, by another geodesy.
        home, last = got[0], got[-1]
        away = pymap3d.geodetic2enu(last.x * 1e-7, last.y * 1e-7, home.z + last.z, home.x * 1e-7, home.y * 1e-7, home.z)
        yield "docs/ardupilot.md, upload.py", "end, m", MAX(np.array(away) - walk.exact().at([1e9], 0)[0, :3]), 0.02


def ros2(mavc):
    with tempfile.TemporaryDirectory() as folder:
        walk = Walk(mavc, "docs/ros2.md", "octo.mav", folder)
        yield "docs/ros2.md", "outputs that are not compared", max(0, 2 - walk.follow({})), 0
        rows = np.loadtxt(walk.folder / "points.csv", delimiter=",", skiprows=1)
        exact = walk.exact()
        yield "docs/ros2.md, points.py", "points missing", abs(len(rows) - round(100 * exact.times[-1]) - 1), 0
        for order, what in enumerate(("position", "velocity", "acceleration")):
            part = rows[:, 1 + 3 * order : 4 + 3 * order]
            yield "docs/ros2.md, points.py", what, MAX(part - exact.at(rows[:, 0], order)[:, :3]), 1e-9


def crazyflie(mavc):
    with tempfile.TemporaryDirectory() as folder:
        walk, made = Walk(mavc, "docs/crazyflie.md", "room.mav", folder), []
        compared = walk.follow({"python3 fly.py": keeps(made, lambda: crazyflies.Recorder(19850))})
        reader, exact, recorder = "docs/crazyflie.md, fly.py", walk.exact(), made[0]
        yield "docs/crazyflie.md", "outputs that are not compared", max(0, 3 - compared), 0
        names = [name for _, name, _ in recorder.commands]
        due = [getattr(crazyflies, name) for name in ("DEFINE", "TAKEOFF", "GO_TO", "START", "LAND", "STOP")]
        yield reader, "commands unlike those due", int(names != due) + (not recorder.armed), 0
        (_, _, defined), (begun, _, _), (landed, _, _) = (recorder.commands[k] for k in (0, 3, 4))
        offset, count = int.from_bytes(defined[3:7], "little"), defined[7]
        yield reader, "bytes of 4096", recorder.written, crazyflies.MEMORY_SIZE
        pieces = recorder.trajectory(offset, count)
        times = np.linspace(0, exact.times[-1], 2001)
        for order, (what, most) in enumerate((("position, m", 0.01), ("velocity, m/s", 0.05))):
            got = np.array([crazyflies.at(pieces, time, order) for time in times]) - exact.at(times, order)
            yield reader, what, float(np.max(np.linalg.norm(got[:, :3], axis=1))), most
        yield reader, "landed before its end, s", max(0.0, exact.times[-1] - (landed - begun)), 0.05
        yield reader, "flown: position, m", crazyflies.flown(pieces), 0.04
        # The fault of the spec's `simulate`: rotor 2 at 80 % from 4 s.
        yield reader, "flown with W2: position, m", crazyflies.flown(pieces, weak=(1, 0.8, 4.0)), 0.08


CHECKS = [px4, ardupilot, ros2, crazyflie]
