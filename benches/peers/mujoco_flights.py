"""Simulated flights of mavc against MuJoCo, with the same thrusts and with a controller of its own in the loop.

    python3 -m venv VENV && VENV/bin/pip install mujoco numpy
    VENV/bin/python benches/peers/mujoco_flights.py target/release/mavc
    VENV/bin/python benches/peers/mujoco_flights.py target/release/mavc --only open --only height

open      for every shipped vehicle, healthy and with rotor 1 lost: the speeds of the rotors in mavc's log drive the model of
          `mavc emit mjcf`. Are the motions the same?
capture   the height lost from a fault until level flight is regained, by `mavc analyze --capture` and by flights of MuJoCo with a
          second implementation of the controller (flight_controller.py)
height    examples/parcel_quad.mav loses a rotor above and below the height that mavc names for it: does it survive?
path      every vehicle flies a plan with drag, healthy and with rotor 1 lost, with each controller in the loop of its own plant: where
          does it fly?
mission   parcel_quad loses a rotor at one instant of its mission after the other and lands: is it lost, and where does it fly?

Sensors have no noise, and the delay until a fault is known is given. Prints a table for each part; exits with 1 where a bound is broken.
"""

import argparse
import re
import sys
import tempfile
from multiprocessing import Pool
from pathlib import Path

import mujoco
import numpy as np
from flight_reference import Line, Plan
from mavc_runs import ROOT, Mavc
from mujoco_closed import STRIKES, captured, fly
from mujoco_plant import Body, Plant

# Bounds on the differences. Open loop: position (m), attitude (rad), rates (rad/s). Heights of capture (m). Flights along a plan:
# position (m). They are far above rounding, because a vehicle that tumbles enlarges small differences.
OPEN = (1e-8, 1e-8, 1e-8)
HEIGHT = 1e-5
PATH = 1e-5

QUIET = ["simulate.gyroscope_noise=0rad/s", "simulate.position_noise=0m"]
YAW_DRAG = "vehicle.yaw_drag=2.75e-3N*m*s/rad"
VEHICLES = sorted((ROOT / "specs" / "vehicles").glob("*.mav"))
SECONDS = 3.0  # of the open loop

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
    duration = 6 s; detection = 50 ms; after_fault = continue; lost_beyond = 100 m; drag = 0.3 N*s/m
    {fault}
}}
"""
# What shipped vehicles and their missions lack: the momentum of rotors, quadratic yaw drag, a drag for each axis, wind.
MOMENTUM = "vehicle.rotor.rotor_inertia=2e-5kg*m^2"
AIR = ["vehicle.yaw_drag_quadratic=1e-4N*m*s^2/rad^2", "simulate.drag=[0.3,0.25,0.15]N*s/m", "simulate.wind=[2,-1,0.5]m/s"]
PAPER = ROOT / "specs" / "vehicles" / "quad_pnpn.mav"
FAULTS = [("none", "", np.inf), ("rotor 1 lost", "fault out at 500 ms", 0.5)]

# Modes whose captures are compared: vehicle, rotors that are lost. Of parcel_quad the loss of rotor 1.
CAPTURES = [("quad_pnpn", [(1,)]), ("hexa_pnpnpn", [(1,), (1, 4), (1, 3)])]
PARCEL, FAULT = ROOT / "examples" / "parcel_quad.mav", "L1"
# In the middle of its interval; mavc flies the ends otherwise.
MIDDLE = "vehicle.yaw_drag=5e-3N*m*s/rad"

# In the place of the mission of parcel_quad and of what follows it.
HOVER = """mission hover {
    start at [0, 0, 0] m
    hold 15 s
    waypoint at [0, 0, 0] m
}
plan { planner = rip; against = []; time = 16 s; samples = 40 }
simulate { duration = 16 s; after_fault = hold; lost_beyond = 60 m; fault L1 at 1 s }
"""
MISSION_TIMES, MISSION_DELAY = range(1, 18), 0.1


def shown(*columns):
    """A row of a table: (value, width) or (value, width, format)."""
    texts = [f"{value:{form[0] if form else ''}}" for value, _, *form in columns]
    print(" ".join(f"{text:>{column[1]}}" for text, column in zip(texts, columns)).rstrip(), flush=True)


def row_of(log, k):
    """The state in row k of a log."""
    of = lambda *names: np.array([log[name][k] for name in names])
    (sr, cr), (sp, cp), (sy, cy) = [(np.sin(a / 2), np.cos(a / 2)) for a in of("roll", "pitch", "yaw")]
    attitude = [cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy]
    return Body(of("x", "y", "z"), of("vx", "vy", "vz"), attitude, of("p", "q", "r"))


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
        # The distance of the quaternions is half the angle between the attitudes, up to the sign of one.
        turn = 2.0 * min(np.linalg.norm(here.attitude - there.attitude), np.linalg.norm(here.attitude + there.attitude))
        found = [np.linalg.norm(here.position - there.position), turn, np.linalg.norm(here.rates - there.rates)]
        worst = np.maximum(worst, found)
    return worst


def compare_open(mavc, folder, _):
    print(f"\nopen: the same thrusts, {SECONDS:g} s, largest differences")
    shown(("vehicle", 28), ("fault", 12), ("position, m", 12), ("attitude, rad", 13), ("rates, rad/s", 12))
    broken, spec = 0, Path(folder, "dash.mav")
    cases = [(path.stem, path, [YAW_DRAG]) for path in VEHICLES]
    cases += [("quad_pnpn, rotor_inertia", PAPER, [YAW_DRAG, MOMENTUM]), ("quad_pnpn, more air", PAPER, [YAW_DRAG, *AIR])]
    for vehicle, path, overrides in cases:
        for name, fault, lost_at in FAULTS:
            spec.write_text(DASH.format(vehicle=path, fault=fault))
            _, log = mavc.simulate(spec, folder, 1000, overrides)
            found = open_loop(*mavc.model(spec, overrides), log, lost_at)
            is_broken = bool(np.any(found > OPEN))
            broken += is_broken
            columns = [(each, width, ".1e") for each, width in zip(found, (12, 13, 12))]
            shown((vehicle, 28), (name, 12), *columns, ("  differ" if is_broken else "", 0))
    return broken


def capture_specs(folder):
    """(name, file, overrides) of the specs whose captures are compared."""
    for vehicle, modes in CAPTURES:
        path = Path(folder, f"{vehicle}.mav")
        lost = [f"mode out_{'_'.join(map(str, rotors))} {{ {'; '.join(f'rotor {k} lost' for k in rotors)} }}" for rotors in modes]
        path.write_text(f'use "{ROOT}/specs/vehicles/{vehicle}.mav"\nfaults {{ {"; ".join(lost)} }}\nsimulate {{}}\n')
        yield vehicle, path, [YAW_DRAG, *QUIET]
    yield PARCEL.stem, PARCEL, [MIDDLE, *QUIET]


def capture_cases(mavc, folder):
    """(vehicle, record, xml, mode, lag as a multiple of the vehicle's, capture of mavc) of each flight."""
    for vehicle, path, overrides in capture_specs(folder):
        record, xml = mavc.model(path, overrides)
        modes = {mode["name"]: mode for mode in record["modes"] if vehicle != PARCEL.stem or mode["name"] == FAULT}
        captures = mavc.captures(path, overrides)
        own = min(capture["lag_s"] for capture in captures)
        for capture in captures:
            if capture["mode"] in modes:
                yield vehicle, record, xml, modes[capture["mode"]], round(capture["lag_s"] / own), capture


def captured_in_mujoco(case):
    _, record, xml, mode, lag, capture = case
    return captured(record, xml, mode, capture["speed_m_per_s"], capture["delay_s"], lag)


def compare_captures(mavc, folder, pool):
    print("\ncapture: height lost until level flight is regained, m")
    numbers = [("lag, ms", 7), ("speed, m/s", 10), ("known after, ms", 15), ("mavc", 8), ("MuJoCo", 8), ("difference", 10)]
    shown(("vehicle", 12), ("mode", 8), *numbers)
    broken, cases = 0, list(capture_cases(mavc, folder))
    for case, there in zip(cases, pool.imap(captured_in_mujoco, cases)):
        vehicle, capture = case[0], case[-1]
        here = capture["height_m"] and capture["height_m"][1]
        if None in (here, there):
            is_same, columns = here == there, [("-" if each is None else f"{each:.3f}", 8) for each in (here, there)] + [("", 10)]
        else:
            is_same = abs(here - there) <= HEIGHT
            columns = [(here, 8, ".3f"), (there, 8, ".3f"), (abs(here - there), 10, ".1e")]
        broken += not is_same
        settings = [(1e3 * capture["lag_s"], 7, "g"), (capture["speed_m_per_s"], 10, "g"), (1e3 * capture["delay_s"], 15, "g")]
        shown((vehicle, 12), (capture["mode"], 8), *settings, *columns, ("" if is_same else "  differ", 0))
    return broken


def parcel(folder, pattern, by):
    """A copy of parcel_quad.mav with what matches a pattern replaced."""
    text, count = re.subn(pattern, by, PARCEL.read_text(), flags=re.DOTALL)
    if count != 1:
        sys.exit(f"{PARCEL}: {count} places match `{pattern}`")
    path = Path(folder, "parcel.mav")
    path.write_text(text)
    return path


def fault_of(record, name):
    return next((mode for mode in record["modes"] if mode["name"] == name), None)


def named_heights(mavc):
    """The least and the largest height (m) that mavc names for parcel_quad at rest, with noise, by delay (s)."""
    captures = [capture for capture in mavc.captures(PARCEL, [MIDDLE]) if capture["mode"] == FAULT and capture["speed_m_per_s"] == 0.0]
    own = min(capture["lag_s"] for capture in captures)
    named = [capture for capture in captures if capture["lag_s"] == own and capture["regained"] == capture["flights"]]
    return {capture["delay_s"]: (capture["height_m"][0], capture["height_m"][2]) for capture in named}


def compare_heights(mavc, folder, _):
    """Hover 10 cm and 2 % above the largest height named, which is survived, and as much below the least, which is not."""
    print("\nheight: parcel_quad loses rotor 1 in hover above ground")
    shown(("known after, ms", 15), ("named, m", 14), ("flown at, m", 11), ("mavc", 8), ("MuJoCo", 8))
    broken, spec = 0, parcel(folder, r"/// [^\n]*\nmission .*", HOVER)
    for delay, (least, largest) in named_heights(mavc).items():
        for height, expected in [(1.02 * largest + 0.1, "flown"), (0.98 * least - 0.1, "ground")]:
            overrides = [MIDDLE, *QUIET, f"simulate.detection={delay}s", f"simulate.ground={-height}m"]
            record, xml = mavc.model(spec, overrides)
            here, _ = mavc.simulate(spec, folder, 100, overrides)
            course, duration = Line([0.0, 0.0, 0.0], [0.0, 0.0, 0.0]), record["simulate"]["duration_s"]
            there = fly(record, xml, course, duration, fault_of(record, FAULT), STRIKES).outcome
            is_right = here == there == expected
            broken += not is_right
            named = f"{least:.2f} .. {largest:.2f}"
            shown((1e3 * delay, 15, "g"), (named, 14), (height, 11, ".2f"), (here, 8), (there, 8), ("" if is_right else "  wrong", 0))
    return broken


def along_a_plan(mavc, folder, spec, overrides, mode, at):
    """A flight along the plan of a spec in mavc and in MuJoCo: the height of the plan at the fault (m), both outcomes, when the flight
    ended in MuJoCo (s), the largest distance between the positions (m), and whether a bound is broken. The reference is the table of
    `mavc plan`."""
    record, xml = mavc.model(spec, overrides)
    rate, table = record["simulate"]["control_rate_hz"], Path(folder, "plan.csv")
    mavc.plan(spec, table, rate, overrides)
    plan = Plan(table, rate)
    here, log = mavc.simulate(spec, folder, rate, overrides)
    flown = fly(record, xml, plan, plan.duration, fault_of(record, mode), at)
    common = min(len(log["t"]), len(flown.times))
    places = np.array([log[axis][:common] for axis in "xyz"]).T
    difference = np.linalg.norm(places - flown.positions[:common], axis=1).max()
    is_same = here == flown.outcome and len(log["t"]) == len(flown.times) and difference <= PATH
    columns = [(here, 8), (flown.outcome, 8), (flown.times[-1], 11, ".2f"), (difference, 21, ".1e"), ("" if is_same else "  differ", 0)]
    return plan.at(min(at, plan.duration)).position[2], columns, not is_same


PATH_HEADINGS = [("mavc", 8), ("MuJoCo", 8), ("ended at, s", 11), ("largest difference, m", 21)]


def compare_paths(mavc, folder, _):
    print("\npath: a dash with a turn and with drag; the fault at 0.5 s is known after 50 ms")
    shown(("vehicle", 24), ("fault", 12), *PATH_HEADINGS)
    broken, spec = 0, Path(folder, "dash.mav")
    # Only the bounded allocation, the default, is written a second time.
    cases = [(path.stem, path, []) for path in VEHICLES if "allocation" not in path.read_text()]
    for vehicle, path, more in [*cases, ("quad_pnpn, rotor_inertia", PAPER, [MOMENTUM])]:
        for name, fault, at in FAULTS:
            spec.write_text(DASH.format(vehicle=path, fault=fault))
            overrides = [YAW_DRAG, "vehicle.drag=0.3N*s/m", *QUIET, *more]
            _, columns, is_broken = along_a_plan(mavc, folder, spec, overrides, "out" if fault else "", at)
            broken += is_broken
            shown((vehicle, 24), (name, 12), *columns)
    return broken


def compare_missions(mavc, folder, _):
    print(f"\nmission: parcel_quad loses rotor 1, known after {1e3 * MISSION_DELAY:g} ms, and lands")
    shown(("fault at, s", 11), ("height, m", 9), *PATH_HEADINGS)
    broken = 0
    for at in MISSION_TIMES:
        overrides = [MIDDLE, *QUIET, f"simulate.detection={MISSION_DELAY}s", "simulate.lost_beyond=40m"]
        spec = parcel(folder, r"fault L1 at [\d.]+ s", f"fault L1 at {at} s")
        height, columns, is_broken = along_a_plan(mavc, folder, spec, overrides, FAULT, at)
        broken += is_broken
        shown((at, 11), (height, 9, ".2f"), *columns)
    return broken


PARTS = {
    "open": compare_open,
    "capture": compare_captures,
    "height": compare_heights,
    "path": compare_paths,
    "mission": compare_missions,
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mavc")
    parser.add_argument("--only", choices=PARTS, action="append")
    arguments = parser.parse_args()
    mavc = Mavc(arguments.mavc)
    print(f"MuJoCo {mujoco.__version__}, numpy {np.__version__}")
    with tempfile.TemporaryDirectory() as folder, Pool(2) as pool:
        broken = sum(PARTS[part](mavc, folder, pool) for part in arguments.only or PARTS)
    print(f"\n{broken} bounds broken" if broken else "\nall within the bounds")
    sys.exit(1 if broken else 0)


if __name__ == "__main__":
    main()
