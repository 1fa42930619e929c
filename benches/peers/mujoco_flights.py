"""Simulated flights of mavc against MuJoCo, with the same thrusts and with a controller of its own in the loop.

    python3 -m venv VENV && VENV/bin/pip install mujoco numpy
    VENV/bin/python benches/peers/mujoco_flights.py target/release/mavc            # all, about ten minutes on two cores
    VENV/bin/python benches/peers/mujoco_flights.py target/release/mavc --only open

open      for every shipped vehicle, healthy and with rotor 1 lost: the speeds of the rotors in mavc's log drive the model of
          `mavc emit mjcf`. Are the motions the same?
capture   the height lost from a fault until level flight is regained, by `mavc analyze --capture` and by flights in MuJoCo with a
          second implementation of the controller (flight_controller.py), without noise
height    examples/parcel_quad.mav loses a rotor above and below the height that mavc names for it: does it survive?
path      every vehicle flies a plan with drag in both closed loops, healthy and with rotor 1 lost: where does it fly?
mission   parcel_quad loses a rotor during its mission, at one instant after the other, and lands: is it lost or not, and where
          does it fly?

Nothing is noisy, and the delay until a fault is known is given. Prints tables; exits with 1 where a bound below is broken.
"""

import argparse
import csv
import json
import re
import subprocess
import sys
import tempfile
from multiprocessing import Pool
from pathlib import Path

import mujoco
import numpy as np
from flight_reference import Line, Plan
from mujoco_closed import STRIKES, captured, fly
from mujoco_plant import Body, Plant

ROOT = Path(__file__).resolve().parents[2]
MAVC = ""  # the binary, as given

# Bounds on the differences. Open loop: position (m), attitude (rad), rates (rad/s). Heights: m, or a share. Along a plan: position (m).
OPEN = (1e-8, 1e-8, 1e-8)
HEIGHT = (0.05, 0.05)
PATH = 0.05

PARCEL = ROOT / "examples" / "parcel_quad.mav"
QUIET = ["simulate.gyroscope_noise=0rad/s", "simulate.position_noise=0m"]
SECONDS = 3.0

DASH = """use "{vehicle}"
faults {{ mode out {{ rotor 1 lost }} }}
mission dash {{
    start at [0, 0, 30] m  yaw 20 deg
    waypoint at [6, 3, 31] m  yaw 70 deg
    hold 2 s
}}
plan {{ planner = rip; against = []; time = 6 s; samples = 40 }}
simulate {{
    rate = 1000 Hz; control_rate = 1000 Hz; estimator_rate = 100 Hz
    detection = 50 ms; after_fault = continue; lost_beyond = 100 m; drag = 0.3 N*s/m
    {fault}
}}
"""

# Vehicle, modes that lose rotors.
CAPTURES = [
    ("quad_pnpn", [(1,)]),
    ("hexa_pnpnpn", [(1,), (1, 4), (1, 3)]),
]
YAW_DRAG = "vehicle.yaw_drag=2.75e-3N*m*s/rad"

# In the place of the mission of parcel_quad.mav.
HOVER = """
mission hover {
    start at [0, 0, 0] m
    hold 15 s
    waypoint at [0, 0, 0] m
}
plan { planner = rip; against = []; time = 16 s; samples = 40 }
simulate { duration = 16 s; after_fault = hold; lost_beyond = 60 m; fault L1 at 1 s }
"""
FAULT = "L1"
MISSION_TIMES, MISSION_DELAY = range(1, 17), 0.1


def run(*arguments, codes=(0,)):
    """What mavc prints."""
    ran = subprocess.run([MAVC, *map(str, arguments)], capture_output=True, text=True, cwd=ROOT)
    if ran.returncode not in codes:
        sys.exit(f"mavc {' '.join(map(str, arguments))}: exit code {ran.returncode}\n{ran.stdout}{ran.stderr}")
    return ran.stdout


def settings(*overrides):
    return [part for override in overrides for part in ("--set", override)]


def read(spec, *overrides):
    """The model record of a spec, and its model of MuJoCo."""
    record = json.loads(run("emit", "model", spec, "--format", "json", "--quiet", *settings(*overrides)))
    return record, run("emit", "mjcf", spec, "--quiet", *settings(*overrides))


def simulated(folder, spec, *overrides, rate=500):
    """The outcome of a flight in mavc, and its log as columns."""
    log, report = Path(folder, "flight.csv"), Path(folder, "flight.json")
    run("simulate", spec, *settings(*overrides), "-o", log, "--report", report, "--rate", f"{rate}Hz", "--quiet", codes=range(16))
    with open(log) as file:
        rows = list(csv.DictReader(file))
    columns = {key: np.array([float(row[key]) for row in rows]) for key in rows[0] if rows[0][key] != ""}
    return json.loads(report.read_text()), columns


# Open loop


def euler_quaternion(roll, pitch, yaw):
    (sr, cr), (sp, cp), (sy, cy) = [(np.sin(a / 2), np.cos(a / 2)) for a in (roll, pitch, yaw)]
    return np.array([cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy])


def row_of(log, k):
    of = lambda *names: np.array([log[name][k] for name in names])
    return Body(of("x", "y", "z"), of("vx", "vy", "vz"), euler_quaternion(*of("roll", "pitch", "yaw")), of("p", "q", "r"))


def open_loop(record, xml, log, lost_at):
    """The largest differences of position (m), attitude (rad) and rates (rad/s). Between two rows the commands are those that lead the
    speeds of the one to the speeds of the other; rotor 1 gives nothing from `lost_at` s on."""
    plant = Plant(record, xml)
    speeds = np.array([log[f"omega_{k + 1}"] for k in range(len(plant.speeds))]).T
    decay = np.exp(-plant.step_s / plant.lag)
    plant.start(row_of(log, 0), speeds[0])
    worst = np.zeros(3)
    for k in range(round(SECONDS / plant.step_s)):
        plant.capacity[0] = 0.0 if log["t"][k] >= lost_at - 0.5 * plant.step_s else 1.0
        plant.speeds = speeds[k]
        plant.step((speeds[k + 1] - speeds[k] * decay) / (1.0 - decay))
        there, here = row_of(log, k + 1), plant.body()
        # |q - q'| is half the angle between them, up to the sign of q.
        turn = 2.0 * min(np.linalg.norm(here.attitude - there.attitude), np.linalg.norm(here.attitude + there.attitude))
        found = [np.linalg.norm(here.position - there.position), turn, np.linalg.norm(here.rates - there.rates)]
        worst = np.maximum(worst, found)
    return worst


def compare_open_loop(folder, _):
    print(f"\nopen loop: {SECONDS:g} s, largest differences\n{'vehicle':30} {'fault':13} {'position, m':>12} {'attitude, rad':>14} {'rates, rad/s':>13}")
    broken = 0
    for path in sorted((ROOT / "specs" / "vehicles").glob("*.mav")):
        for name, fault, lost_at in [("none", "", np.inf), ("rotor 1 lost", "fault out at 500 ms", 0.5)]:
            spec = Path(folder, "dash.mav")
            spec.write_text(DASH.format(vehicle=path, fault=fault))
            _, log = simulated(folder, spec, YAW_DRAG, rate=1000)
            found = open_loop(*read(spec, YAW_DRAG), log, lost_at)
            broken += int(np.any(found > OPEN))
            print(f"{path.stem:30} {name:13} {found[0]:12.1e} {found[1]:14.1e} {found[2]:13.1e}", flush=True)
    return broken


# Heights of capture


def capture_specs(folder):
    """Specs with the modes whose captures are compared: (name, file, overrides)."""
    for vehicle, modes in CAPTURES:
        path = Path(folder, f"{vehicle}.mav")
        lost = [f"mode out_{'_'.join(map(str, rotors))} {{ {'; '.join(f'rotor {k} lost' for k in rotors)} }}" for rotors in modes]
        path.write_text(f'use "{ROOT}/specs/vehicles/{vehicle}.mav"\nfaults {{ {"; ".join(lost)} }}\nsimulate {{}}\n')
        yield vehicle, path, [YAW_DRAG, *QUIET]
    yield PARCEL.stem, PARCEL, QUIET


def is_one_of_its_kind(mode):
    """The rotors of parcel_quad are alike up to symmetry; rotor 1 stands for them, like rotor 1 of the others."""
    return mode["capacity"][0] == 0.0


def capture_cases(folder, all_lags):
    """(vehicle, record, xml, mode, mavc's capture) of every flight that is compared."""
    for vehicle, path, overrides in capture_specs(folder):
        record, xml = read(path, *overrides)
        modes = {mode["name"]: mode for mode in record["modes"] if is_one_of_its_kind(mode)}
        captures = json.loads(run("analyze", path, "--capture", "--format", "json", "--quiet", *settings(*overrides)))["captures"]
        own = min(capture["lag_s"] for capture in captures)
        for capture in captures:
            lag = round(capture["lag_s"] / own)
            if capture["mode"] in modes and (all_lags or lag == 1):
                yield vehicle, record, xml, modes[capture["mode"]], capture, lag


def captured_in_mujoco(case):
    _, record, xml, mode, capture, lag = case
    return captured(record, xml, mode, capture["speed_m_per_s"], capture["delay_s"], lag)


def compare_captures(folder, pool, all_lags=True):
    print(f"\ncapture: height lost, m\n{'vehicle':12} {'mode':9} {'lag, ms':>7} {'speed, m/s':>10} {'known after, ms':>15} {'mavc':>8} {'MuJoCo':>8}")
    broken, cases = 0, list(capture_cases(folder, all_lags))
    shown = lambda height: "-" if height is None else f"{height:.3f}"
    for case, there in zip(cases, pool.imap(captured_in_mujoco, cases)):
        vehicle, _, _, mode, capture, _ = case
        here = capture["height_m"] and capture["height_m"][1]
        is_same = here == there if None in (here, there) else abs(here - there) <= max(HEIGHT[0], HEIGHT[1] * here)
        broken += not is_same
        numbers = f"{1e3 * capture['lag_s']:7g} {capture['speed_m_per_s']:10g} {1e3 * capture['delay_s']:15g} {shown(here):>8} {shown(there):>8}"
        print(f"{vehicle:12} {mode['name']:9} {numbers}{'' if is_same else '  differ'}", flush=True)
    return broken


# Survival


def outcome_of(report):
    """`flown`, `landed` or the cause of the loss, of a report of `mavc simulate`."""
    outcome = report["outcome"]
    return outcome.get("cause", outcome["status"])


def parcel(folder, pattern, by, *overrides):
    """A copy of parcel_quad.mav with what matches a pattern replaced, and its record and model of MuJoCo."""
    text, count = re.subn(pattern, by, PARCEL.read_text(), flags=re.DOTALL)
    if count != 1:
        sys.exit(f"{PARCEL}: {count} places match `{pattern}`")
    path = Path(folder, "parcel.mav")
    path.write_text(text)
    return path, *read(path, *overrides)


def named_heights():
    """The least and the largest height (m) that mavc names for rotor 1 of parcel_quad at rest with its own lag, by delay (s). These are
    flights with noise."""
    captures = json.loads(run("analyze", PARCEL, "--capture", "--format", "json", "--quiet"))["captures"]
    own = min(capture["lag_s"] for capture in captures)
    chosen = [c for c in captures if c["mode"] == FAULT and c["lag_s"] == own and c["speed_m_per_s"] == 0.0 and c["height_m"]]
    return {capture["delay_s"]: (capture["height_m"][0], capture["height_m"][2]) for capture in chosen}


def compare_heights(folder, _):
    """Hover above a ground that is out of reach of the capture, or not: 10 cm and 2 % more than the largest height named, or less than
    the least."""
    print(f"\nheight: parcel_quad loses rotor 1 in hover\n{'known after, ms':>15} {'named, m':>14} {'above ground, m':>15} {'mavc':>9} {'MuJoCo':>9}")
    broken = 0
    for delay, (least, largest) in named_heights().items():
        for height, survives in [(1.02 * largest + 0.1, True), (0.98 * least - 0.1, False)]:
            if height <= 0.0:
                continue
            overrides = [*QUIET, f"simulate.detection={delay}s", f"simulate.ground={-height}m"]
            spec, record, xml = parcel(folder, r"/// [^\n]*\nmission .*", HOVER, *overrides)
            here = outcome_of(simulated(folder, spec, *overrides)[0])
            fault = next(mode for mode in record["modes"] if mode["name"] == FAULT)
            there = fly(record, xml, Line([0.0, 0.0, 0.0], [0.0, 0.0, 0.0]), record["simulate"]["duration_s"], fault, STRIKES).outcome
            is_right = here == there == ("flown" if survives else "ground")
            broken += not is_right
            print(f"{1e3 * delay:15g} {least:6.2f} ..{largest:6.2f} {height:15.2f} {here:>9} {there:>9}{'' if is_right else '  wrong'}", flush=True)
    return broken


# Flights along a plan


def along_a_plan(folder, spec, overrides, mode, at):
    """A flight along the plan of a spec in mavc and in MuJoCo: both outcomes, the largest distance between their positions up to the end
    of the shorter one (m), and the plan. The reference is the table of `mavc plan`."""
    record, xml = read(spec, *overrides)
    rate = record["simulate"]["control_rate_hz"]
    table = Path(folder, "plan.csv")
    run("plan", spec, "--quiet", *settings(*overrides), "-o", table, "--rate", f"{rate}Hz")
    plan = Plan(table, rate)
    report, log = simulated(folder, spec, *overrides, rate=rate)
    fault = next((each for each in record["modes"] if each["name"] == mode), None)
    flown = fly(record, xml, plan, plan.duration, fault, at)
    common = min(len(log["t"]), len(flown.times))
    places = np.array([log[axis][:common] for axis in "xyz"]).T
    difference = np.linalg.norm(places - flown.positions[:common], axis=1).max()
    return outcome_of(report), flown.outcome, difference, plan


def judged(here, there, difference):
    """Whether two flights differ, and the last columns of their row."""
    is_same = here == there and difference <= PATH
    return not is_same, f"{here:>9} {there:>9} {difference:21.1e}{'' if is_same else '  differ'}"


def compare_paths(folder, _):
    """A dash with a turn and with drag, by every vehicle with bounded allocation, healthy and with rotor 1 lost."""
    print(f"\npath: a dash with a turn\n{'vehicle':15} {'fault':13} {'mavc':>9} {'MuJoCo':>9} {'largest difference, m':>21}")
    broken = 0
    for path in sorted((ROOT / "specs" / "vehicles").glob("*.mav")):
        if "pseudo_inverse" in path.stem:
            continue
        for name, fault, at in [("none", "", np.inf), ("rotor 1 lost", "fault out at 500 ms", 0.5)]:
            spec = Path(folder, "dash.mav")
            spec.write_text(DASH.format(vehicle=path, fault=fault))
            found = along_a_plan(folder, spec, [YAW_DRAG, "vehicle.drag=0.3N*s/m", *QUIET], "out" if fault else "", at)
            is_broken, columns = judged(*found[:3])
            broken += is_broken
            print(f"{path.stem:15} {name:13} {columns}", flush=True)
    return broken


def compare_missions(folder, _):
    """The mission of parcel_quad with the fault at one instant after the other, then a landing."""
    print("\nmission: parcel_quad loses rotor 1, known after 100 ms, and lands")
    print(f"{'fault at, s':>11} {'height, m':>9} {'mavc':>9} {'MuJoCo':>9} {'largest difference, m':>21}")
    broken = 0
    for at in MISSION_TIMES:
        overrides = [*QUIET, f"simulate.detection={MISSION_DELAY}s", "simulate.lost_beyond=40m"]
        spec, *_ = parcel(folder, r"fault L1 at [\d.]+ s", f"fault L1 at {at} s", *overrides)
        *found, plan = along_a_plan(folder, spec, overrides, FAULT, at)
        is_broken, columns = judged(*found)
        broken += is_broken
        print(f"{at:11g} {plan.at(at).position[2]:9.2f} {columns}", flush=True)
    return broken


PARTS = {"open": compare_open_loop, "capture": compare_captures, "height": compare_heights, "path": compare_paths, "mission": compare_missions}


def main():
    global MAVC
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mavc")
    parser.add_argument("--only", choices=PARTS, action="append")
    arguments = parser.parse_args()
    MAVC = str(Path(arguments.mavc).resolve())
    print(f"MuJoCo {mujoco.__version__}, numpy {np.__version__}")
    with tempfile.TemporaryDirectory() as folder, Pool(2) as pool:
        broken = sum(PARTS[part](folder, pool) for part in arguments.only or PARTS)
    print(f"\n{broken} bounds broken" if broken else "\nall within the bounds")
    sys.exit(1 if broken else 0)


if __name__ == "__main__":
    main()
