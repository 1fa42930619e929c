"""Ten captures flown for 300 s in MuJoCo: does the vehicle stay where it is long after its spin has settled?

    VENV/bin/python benches/peers/long_captures.py target/release/mavc [SECONDS]

Each vehicle loses rotor 1 in hover, and the controller of flight_controller.py stops it on the spot. `mavc analyze` gives the spin in
which it settles, and `mavc analyze --capture` whether the flight counts as regained. Prints a table for docs/flight.md; exits with 1 where
a vehicle that mavc captures is off its place in the last 10 s, or settles at another spin (by 5 %: a rotor at its limit moves it).
"""

import copy
import json
import sys
import tempfile
from multiprocessing import Pool
from pathlib import Path

import numpy as np
from flight_reference import Line
from mavc_runs import ROOT, Mavc
from mujoco_closed import HIGH, STRIKES, fly

FLOWN = ROOT / "tests" / "specs" / "flown"
HUMMINGBIRD, PARCEL, FAST = FLOWN / "hummingbird.mav", ROOT / "examples" / "parcel_quad.mav", FLOWN / "fast_spin.mav"
TILTED = FLOWN / "tilted_spin.mav"
QUIET = ["simulate.gyroscope_noise=0rad/s", "simulate.position_noise=0m"]
# Name, spec, mode, delay in s, overrides.
CASES = [
    ("0.7 kg, no rotor inertia", HUMMINGBIRD, "L1", 0.1, []),
    ("0.7 kg, 2.5e-5 kg m^2", HUMMINGBIRD, "L1", 0.1, ["vehicle.rotor.rotor_inertia=2.5e-5kg*m^2"]),
    ("0.7 kg, 4.2e-5 kg m^2", HUMMINGBIRD, "L1", 0.1, ["vehicle.rotor.rotor_inertia=4.2e-5kg*m^2"]),
    ("0.7 kg, 4.2e-5 kg m^2", HUMMINGBIRD, "L1", 0.2, ["vehicle.rotor.rotor_inertia=4.2e-5kg*m^2"]),
    ("1.9 kg, 4e-3 N m s/rad", PARCEL, "L1", 0.1, ["vehicle.yaw_drag=4e-3N*m*s/rad"]),
    ("1.9 kg, 6e-3 N m s/rad", PARCEL, "L1", 0.1, ["vehicle.yaw_drag=6e-3N*m*s/rad"]),
    ("1.9 kg, 5e-3 N m s/rad", PARCEL, "L2", 0.2, ["vehicle.yaw_drag=5e-3N*m*s/rad"]),
    ("hexacopter, 6 kg", TILTED, "L5", 0.1, ["vehicle.drag=0N*s/m", "simulate.drag=0N*s/m"]),
    ("1.9 kg, 2.2e-3 N m s/rad", FAST, "L1", 0.1, ["vehicle.yaw_drag=2.2e-3N*m*s/rad"]),
    ("the same, 20000 deg/s", FAST, "L1", 0.1, ["vehicle.yaw_drag=2.2e-3N*m*s/rad", "simulate.gyroscope_range=20000deg/s"]),
]


def flown(case):
    record, xml, mode, delay, seconds = case
    changed = copy.deepcopy(record)
    lasting = {"upside_down_s": seconds, "lost_beyond_m": HIGH, "ground_m": 0.0}
    changed["simulate"] |= {"detection_s": delay, "after_fault": "hold", "duration_s": seconds} | lasting
    flight = fly(changed, xml, Line([0.0, 0.0, HIGH], [0.0, 0.0, 0.0]), seconds, mode, STRIKES)
    last = flight.times > flight.times[-1] - 10.0
    away = np.linalg.norm(flight.positions[last] - [0.0, 0.0, HIGH], axis=1).max()
    return flight.outcome, flight.times[-1], HIGH - flight.positions[:, 2].min(), away, flight.rates[-1]


def main():
    mavc, seconds = Mavc(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else 300.0
    cases, known = [], []
    with tempfile.TemporaryDirectory() as folder:
        for name, path, mode, delay, overrides in CASES:
            text = path.read_text()
            spec = Path(folder, path.name)
            spec.write_text(text if "simulate {" in text else text + "\nsimulate { }\n")
            record, xml = mavc.model(spec, [*overrides, *QUIET])
            found = json.loads(mavc.run("analyze", spec, "--capture", "--format", "json", overrides=[*overrides, *QUIET]))
            spin = next(spin for spin in found["settled_spins"] if spin["mode"] == mode)
            of_mode = [capture for capture in found["captures"] if capture["mode"] == mode and capture["speed_m_per_s"] == 0.0]
            own = min(capture["lag_s"] for capture in of_mode)
            capture = next(each for each in of_mode if each["lag_s"] == own and abs(each["delay_s"] - delay) < 1e-9)
            cases.append((record, xml, next(each for each in record["modes"] if each["name"] == mode), delay, seconds))
            known.append((name, delay, capture["regained"] == capture["flights"], spin["spin_rad_s"]))
    print(f"| vehicle, known after | mavc: captured, spin | MuJoCo: height lost | flown until | away in the last 10 s | spin |")
    print("|---|---|---|---|---|---|")
    broken = 0
    with Pool(2) as pool:
        for (name, delay, is_captured, spin), (outcome, end, lost, away, rates) in zip(known, pool.imap(flown, cases)):
            rate = np.copysign(np.linalg.norm(rates), rates[2])
            is_kept = outcome == "flown" and away < 1.0
            is_wrong = is_captured and not (is_kept and abs(rate / spin - 1.0) < 0.05)
            broken += is_wrong
            verdict = f"{'yes' if is_captured else 'no'}, {spin:.1f} rad/s"
            print(f"| {name}, {1e3 * delay:g} ms | {verdict} | {lost:.1f} m | {end:.0f} s ({outcome}) | {away:.2f} m | {rate:.1f} rad/s |"
                  + ("  wrong" if is_wrong else ""), flush=True)
    sys.exit(1 if broken else 0)


if __name__ == "__main__":
    main()
