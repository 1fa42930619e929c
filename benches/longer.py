"""If there is a plan at one time, is there also one at longer times?

Random rest-to-rest missions without lower bounds on rates: each is planned at its shortest time (RIP, 40 samples), then at 1.02, 1.05,
1.1, 1.3 and 2 times that time. Usage, from the root of the project: python3 benches/longer.py target/release/mavc COUNT SEED
"""

import json
import math
import os
import random
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

VEHICLES = ["octo_ppnnppnn", "coaxial_x8", "hexa_ppnnpn", "quad_x"]
FACTORS = [1.02, 1.05, 1.1, 1.3, 2.0]


def spec(r):
    """One to four legs of 1 to 50 m, level, up or down; every third mission has turns; some have limits."""
    vehicle, legs = r.choice(VEHICLES), r.randint(1, 4)
    points = [[0.0, 0.0, 5.0]]
    for _ in range(legs):
        x, y, z = points[-1]
        length, heading = r.choice([2, 5, 10, 30]) * r.uniform(0.6, 1.6), r.uniform(0, 6.283)
        climb = r.choice([0, 0, 1, -1]) * r.uniform(0.5, length / 2)
        points.append([x + length * math.cos(heading), y + length * math.sin(heading), max(2.0, z + climb)])
    turns, yaw, lines = r.random() < 0.3, 0, []
    for i, (x, y, z) in enumerate(points):
        yaw += r.uniform(-90, 90) if turns and i else 0
        lines.append(f"{'waypoint' if i else 'start'} at [{x:.2f}, {y:.2f}, {z:.2f}] m  yaw {yaw:.0f} deg")
    limits = []
    if r.random() < 0.6:
        limits.append(f"speed <= {r.choice([3, 6, 12])} m/s")
    if r.random() < 0.4:
        limits.append(f"tilt <= {r.choice([20, 30, 45])} deg")
    if r.random() < 0.3:
        limits.append(f"climb <= {r.choice([1, 2, 4])} m/s")
    if r.random() < 0.3:
        limits.append(f"descent <= {r.choice([1, 2, 3])} m/s")
    if r.random() < 0.3:
        limits.append("altitude in 1 m .. 200 m")
    if r.random() < 0.2:
        limits.append("yaw_rate <= 40 deg/s")
    if limits:
        lines.append("limits {\n" + "\n".join(limits) + "\n}")
    use = Path("specs/vehicles", vehicle + ".mav").resolve()
    plan = "plan {\nplanner = rip\ntime = minimum\nwithin = 10 cm\nsamples = 40\nreserve = 10 %\n}"
    return f'use "{use}"\nmission m {{\n' + "\n".join(lines) + "\n}\n" + plan + "\n"


def planned(path, time=None):
    """The time of the plan, or None, and the statement of mavc."""
    at = [] if time is None else ["--set", f"plan.time={time:.2f}s"]
    command = [sys.argv[1], "plan", path, "--quiet", "--report", "-", *at]
    ran = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "RAYON_NUM_THREADS": "1"})
    try:
        planner = json.loads(ran.stdout)["planners"][-1]
    except ValueError:
        sys.exit(f"{path}: exit code {ran.returncode}\n{ran.stderr}")
    return planner["time_s"], planner["statement"]


def mission(folder, seed):
    path = Path(folder, f"{seed}.mav")
    path.write_text(spec(random.Random(seed)))
    shortest, statement = planned(path)
    if shortest is None:
        return path, None, [statement]
    asked = [planned(path, round(shortest * factor + 0.005, 2)) for factor in FACTORS]
    return path, shortest, [statement for time, statement in asked if time is None]


def main():
    count, seed = int(sys.argv[2]), int(sys.argv[3])
    folder = tempfile.mkdtemp(prefix="longer")
    seeds = range(seed * 1000003, seed * 1000003 + count)
    asked = missed = without = 0
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for path, shortest, statements in pool.map(lambda s: mission(folder, s), seeds):
            without += shortest is None
            asked += 0 if shortest is None else len(FACTORS)
            missed += 0 if shortest is None else len(statements)
            for statement in statements:
                print(f"{path} (shortest {shortest} s): {statement}", flush=True)
    print(f"{count} missions, {without} without a plan; at {missed} of {asked} longer times no plan was found")


main()
