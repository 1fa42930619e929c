"""Plans that mavc writes for the readers."""

import subprocess
import sys
from pathlib import Path

from exact import Exact

ROOT = Path(__file__).resolve().parents[2]

# A short mission with a turn; the exact model, without air.
HOP = """
vehicle quad {
    layout  = "PNPN"
    arm     = 0.17 m
    mass    = 0.5 kg
    inertia = [2.5e-3, 2.5e-3, 4.2e-3] kg*m^2
    rotor { thrust_coefficient = 5.57e-6 N*s^2/rad^2; drag_coefficient = 1.36e-7 N*m*s^2/rad^2; max_speed = 1500 rad/s }
}
mission hop {
    start at [0, 0, 2] m  yaw 0 deg
    waypoint at [2, 1, 3] m  yaw 60 deg
    waypoint at [3, 3, 2] m  yaw 200 deg
    limits { tilt <= 25 deg }
}
plan { planner = rip; time = 6 s; samples = 60 }
faults { mode weak { rotor 1 reduced to 80 % } }
simulate { fault weak at 3 s; detection = estimator }
"""
# The same motion in the linear model, whose jerk along z jumps at nodes.
HOVER = ("plan.model=hover",)


class Plan:
    def __init__(self, binary, folder, spec, overrides=()):
        self.binary, self.folder, self.overrides = Path(binary).resolve(), Path(folder), overrides
        self.spec = self.folder / "spec.mav" if "\n" in str(spec) else ROOT / spec
        if "\n" in str(spec):
            self.spec.write_text(spec)
        self.exact = Exact(self.write("nodes.csv"), "plan.model=hover" in overrides)

    def run(self, *arguments):
        settings = [part for override in self.overrides for part in ("--set", override)]
        ran = subprocess.run([self.binary, *map(str, arguments), *settings], capture_output=True, text=True, cwd=ROOT)
        if ran.returncode != 0:
            sys.exit(f"mavc {arguments}: exit code {ran.returncode}\n{ran.stdout}{ran.stderr}")
        return ran

    def write(self, name, *options):
        """The plan as a file; what mavc said on standard error is kept beside it."""
        path = self.folder / name
        self.said = self.run("plan", self.spec, "-o", path, *options).stderr
        return path

    def fly(self, name, *options):
        path = self.folder / name
        self.run("simulate", self.spec, "-o", path, *options)
        return path
