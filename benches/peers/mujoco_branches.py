"""Ways out after faults, flown in MuJoCo by a controller of its own: `mujoco_branches.py MAVC SPEC... [--count 25] [--seed 1]`.

    python3 -m venv VENV && VENV/bin/pip install mujoco numpy
    VENV/bin/python benches/peers/mujoco_branches.py target/release/mavc examples/roof_octo.mav examples/parcel_quad.mav

For each spec `mavc plan --recovery --branches` is run once, and `count` of its ways out are drawn evenly. Each is flown from the fault
on: MuJoCo's plant begins on the plan and follows it with all rotors believed sound, until the delay has passed; then the controller of
flight_controller.py knows the fault and follows the branch, and where that ends the rest of the plan, or it sinks to the ground. Sensors
have no noise, and the air is still but for the mean wind of the spec.

A landing survives if the vehicle is at most 1 m from the end of its branch then, and slower than 2 m/s; a return if it is at most 1 m from
the end of the plan. Both are lost where the position error exceeds `lost_beyond` or the
vehicle is upside down. Modes with stuck rotors are left out. Prints a line for each spec, with the 95 % interval of the share (Wilson).
Exit code 1 if a flight is lost that mavc's own flight survived.

Measured with seed 1, MuJoCo 4.0.0, and 25 each of roof_octo, parcel_quad, tower_hexa, inspection_octo and ridge_hexa, whose hexacopter
spins: 125 of 125 survive.
"""

import argparse
import copy
import csv
import json
import math
import random
import sys
import tempfile
from multiprocessing import Pool
from pathlib import Path

import numpy as np
from flight_reference import Reference
from mavc_runs import ROOT, Mavc
from mujoco_closed import fly

sys.path.insert(0, str(ROOT / "benches"))
from recovery import of_table

NEAR, SOFT = 1.0, 2.0  # m, m/s
SINK, AFTERWARDS = 0.2, 1.0  # m/s, s: mavc's own flights


class Course:
    """The plan from a fault on, then a branch, then the rest of the plan or a descent at SINK."""

    def __init__(self, plan, branch, fault, delay, returns):
        self.plan, self.branch, self.fault, self.delay, self.returns = plan, branch, fault, delay, returns
        self.ends = delay + branch.duration
        self.duration = max(plan.duration - fault, self.ends) if returns else self.ends + AFTERWARDS

    def at(self, t):
        if t < self.delay or (self.returns and t >= self.ends):
            return reference(self.plan, self.fault + t)
        found = reference(self.branch, t - self.delay)
        sunk = SINK * max(0.0, t - self.ends)
        return found._replace(position=found.position - [0.0, 0.0, sunk])


def reference(motion, t):
    *space, yaw = [axis[0] for axis in motion.at([t])]
    orders = np.array(space).T
    return Reference(*orders, tuple(yaw))


def flown(case):
    """What becomes of one way out: None if it survives."""
    record, xml, mode, plan, branch, row = case
    changed = copy.deepcopy(record)
    changed["simulate"] |= {"detection_s": float(row["delay_s"]), "after_fault": "continue", "ground_m": -1e9}
    returns = row["outcome"].startswith("continue")
    course = Course(plan, branch, float(row["fault_s"]), float(row["delay_s"]), returns)
    flight = fly(changed, xml, course, course.duration, mode, 0.0)
    if flight.outcome != "flown":
        return flight.outcome
    last = np.searchsorted(flight.times, course.duration if returns else course.ends) - 1
    away = np.linalg.norm(flight.positions[last] - course.at(flight.times[last]).position)
    if away > NEAR:
        return f"{away:.1f} m away"
    speed = np.linalg.norm(flight.velocities[last])
    return None if returns or speed <= SOFT else f"{speed:.1f} m/s"


def interval(survived, count):
    z, p = 1.96, survived / count
    middle, half = p + z * z / (2 * count), z * math.sqrt(p * (1 - p) / count + z * z / (4 * count**2))
    return [(middle - half) / (1 + z * z / count), min(1.0, (middle + half) / (1 + z * z / count))]


def cases(mavc, spec, folder, count, seed):
    table, report, branches = folder / "plan.csv", folder / "report.json", folder / "branches"
    mavc.run("plan", spec, "-o", table, "--recovery", "--branches", branches, "--report", report)
    exact = json.loads(report.read_text())["model"] == "exact"
    record, xml = mavc.model(spec)
    with open(branches / "index.csv") as file:
        rows = list(csv.DictReader(file))
    modes = {mode["name"]: mode for mode in record["modes"] if all(share is None for share in mode["stuck"])}
    rows = [row for row in rows if row["mode"] in modes]
    drawn = random.Random(seed).sample(rows, min(count, len(rows)))
    plan = of_table(table, exact)
    return [(record, xml, modes[row["mode"]], plan, of_table(branches / row["file"], exact), row) for row in drawn]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mavc")
    parser.add_argument("specs", nargs="+")
    parser.add_argument("--count", type=int, default=25)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    mavc, everything, against = Mavc(options.mavc), [], 0
    with Pool(2) as pool:
        for spec in options.specs:
            with tempfile.TemporaryDirectory() as folder:
                drawn = cases(mavc, Path(spec).resolve(), Path(folder), options.count, options.seed)
                found = pool.map(flown, drawn, chunksize=1)
            for case, lost in zip(drawn, found):
                row = case[-1]
                if lost:
                    against += row["flight"] == "as planned"
                    print(f"  {Path(spec).stem}: {row['file']} ({row['outcome']}; mavc: {row['flight']}): {lost}")
            everything += found
            print(f"{Path(spec).stem}: {found.count(None)} of {len(found)} survive", flush=True)
    survived = everything.count(None)
    low, high = interval(survived, len(everything))
    print(f"all: {survived} of {len(everything)} survive, {100 * low:.1f} to {100 * high:.1f} %; {against} lost that mavc's own flight survived")
    sys.exit(1 if against else 0)


if __name__ == "__main__":
    main()
