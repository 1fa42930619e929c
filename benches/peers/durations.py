"""Does a derivative-free search over the durations of legs find shorter missions than mavc's own search?

Random rest-to-rest missions (RIP, 60 samples) are planned with `time = minimum`. Then a pattern search over the durations of
the legs lets mavc plan with the time of every waypoint fixed. It starts from the durations of `timing = proportional`,
shortens one leg or all of them by a step, keeps durations with a plan, and halves the step down to 0.5 % of a leg. Usage, from
the root of the project: python3 benches/peers/durations.py target/release/mavc COUNT SEED
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

FIRST, LAST, SHRINK = 0.2, 0.005, 0.5
MOST_PROBES = 400


def mission(r):
    """Two to four legs of 3 to 25 m with some limits: lines of waypoints without times, and limits."""
    points, lines = [[0.0, 0.0, 5.0]], []
    for _ in range(r.randint(2, 4)):
        x, y, z = points[-1]
        length, heading = r.uniform(3, 25), r.uniform(0, math.tau)
        points.append([x + length * math.cos(heading), y + length * math.sin(heading), max(2.0, z + r.uniform(-0.4, 0.4) * length)])
    for i, (x, y, z) in enumerate(points):
        lines.append(f"{'waypoint' if i else 'start'} at [{x:.2f}, {y:.2f}, {z:.2f}] m  within 20 cm")
    limits = [f"speed <= {r.choice([3, 5, 8])} m/s", f"tilt <= {r.choice([15, 25, 35])} deg"]
    if r.random() < 0.5:
        limits.append(f"descent <= {r.choice([1, 2])} m/s")
    return r.choice(["octo_ppnnppnn", "coaxial_x8", "hexa_ppnnpn", "quad_x"]), lines, limits


def spec(vehicle, lines, limits, time, timing, ends=None):
    use = Path("specs/vehicles", vehicle + ".mav").resolve()
    timed = [line if not ends or i == 0 else f"{line} time {ends[i - 1]:.6f} s" for i, line in enumerate(lines)]
    body = "\n".join(timed) + "\nlimits {\n" + "\n".join(limits) + "\n}"
    plan = f"planner = rip\ntime = {time}\nsamples = 60\ntiming = {timing}"
    if ends:
        plan = "planner = rip\nsamples = 60\ntiming = proportional"
    return f'use "{use}"\nmission m {{\n{body}\n}}\nplan {{\n{plan}\n}}\n'


def plan(text):
    """The report of the plan, or None."""
    environment = {**os.environ, "RAYON_NUM_THREADS": "1"}
    ran = subprocess.run([sys.argv[1], "plan", "-", "--quiet", "--report", "-"], input=text, capture_output=True, text=True, env=environment)
    if ran.returncode not in (0, 3, 4):
        raise SystemExit(f"exit code {ran.returncode}\n{text}\n{ran.stderr}")
    planner = json.loads(ran.stdout)["planners"][-1] if ran.stdout else {}
    return planner if planner.get("time_s") else None


def ends_of(durations):
    ends, at = [], 0.0
    for duration in durations:
        at += duration
        ends.append(at)
    return ends


def search(vehicle, lines, limits):
    """The shortest mission of the pattern search, s, and the number of plans that it tried."""
    begun = plan(spec(vehicle, lines, limits, "minimum", "proportional"))
    if not begun:
        return None, 0
    ends = [w["at_s"] for w in begun["waypoints"][1:]]
    durations = [b - a for a, b in zip([0.0] + ends, ends)]
    probes, step = 0, FIRST
    while step >= LAST and probes < MOST_PROBES:
        shorter = False
        for leg in [None, *range(len(durations))]:
            changed = [d * (1 - step) if leg in (None, i) else d for i, d in enumerate(durations)]
            probes += 1
            if plan(spec(vehicle, lines, limits, "", "", ends_of(changed))):
                durations, shorter = changed, True
        if not shorter:
            step *= SHRINK
    return sum(durations), probes


def one(seed):
    vehicle, lines, limits = mission(random.Random(seed))
    own = plan(spec(vehicle, lines, limits, "minimum", "optimal"))
    found, probes = search(vehicle, lines, limits)
    own_time, bound = (own["time_s"], own["time_lower_bound_s"]) if own else (None, None)
    print(f"{seed:6} {vehicle:14} {len(lines) - 1} legs  mavc {own_time}  pattern search {found and round(found, 3)} ({probes} plans)  bound {bound and round(bound, 3)}", flush=True)
    return own_time, found


def main():
    count, seed = int(sys.argv[2]), int(sys.argv[3])
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        pairs = list(pool.map(one, range(1000 * seed, 1000 * seed + count)))
    both = [own / found - 1 for own, found in pairs if own and found]
    worst = max(both, default=math.inf)
    missed = sum(1 for own, found in pairs if found and not own)
    print(f"{len(both)} missions: mavc at most {100 * worst:.2f} % longer, on average {100 * sum(both) / max(len(both), 1):.2f} %; {missed} not found by mavc alone")
    sys.exit(0 if worst <= 0.02 and not missed else 1)


if __name__ == "__main__":
    main()
