#!/usr/bin/env python3
"""False alarms and isolation times of the estimator against disturbances, by its threshold and forgetting: `estimator.py MAVC [FLIGHTS]`.

Vehicles of specs/vehicles fly a minute of hover and slow legs, healthy and with every single rotor lost in its middle. Thrusts are drawn
from +-5 %, the centre of gravity is off by up to 2 % of the arm, and gusts turn the vehicle with a standard deviation of 1 % of m g arm;
in the last columns the gyroscope is three times as noisy as the estimator assumes, too. Prints Markdown for docs/flight.md: false alarms in
an hour of healthy flight, and the share of the losses that are isolated within a second. FLIGHTS is the number of healthy flights (120); a
twentieth of it is the number of flights with each loss.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
# Vehicle, m g arm in N m, arm in m.
VEHICLES = [("octo_ppnnppnn", 1.8 * 9.81 * 0.211, 0.211), ("octo_pnpnpnpn", 1.8 * 9.81 * 0.211, 0.211), ("hexa_ppnnpn", 1.54 * 9.81 * 0.211, 0.211)]
FORGETTING = [0.9, 0.95]
THRESHOLDS = [4, 5, 6]
SPEC = """use "{root}/specs/vehicles/{vehicle}.mav"
faults {{ {faults} }}
mission legs {{
    start at [0, 0, 10] m
    waypoint at [5, 0, 10] m
    hold 20 s
    waypoint at [5, 5, 12] m
    hold 20 s
    waypoint at [0, 0, 10] m
}}
plan {{ planner = rip; against = []; time = 60 s; samples = 60 }}
simulate {{
    spread = drawn
    centre_offset = {offset} m
    torque_gusts = {gusts} N*m
    lost_yaw = off
    lost_beyond = 20 m
    {more}
}}
campaign {{ times = 1; seeds = {seeds}; planners = [rip] }}
"""


def measured(mavc, folder, vehicle, torque, arm, flights, sets, more):
    """False alarms in an hour of healthy flight, and the share of losses isolated within 1 s."""
    healthy = [row for row in rows_of(mavc, folder, vehicle, torque, arm, flights, sets, more, "mode L1 { rotor 1 lost }") if not row["fault_time_s"]]
    hours = sum(float(row["end_s"]) for row in healthy) / 3600
    struck = rows_of(mavc, folder, vehicle, torque, arm, max(1, flights // 20), sets, more, "every 1 rotor lost as L")
    struck = [row for row in struck if row["fault_time_s"]]
    isolated = sum(row["isolated_after_s"] != "" and float(row["isolated_after_s"]) <= 1.0 for row in struck)
    return sum(int(row["false_alarms"]) for row in healthy) / hours, isolated / len(struck)


def rows_of(mavc, folder, vehicle, torque, arm, seeds, sets, more, faults):
    """The rows of a campaign."""
    path = Path(folder, "spec.mav")
    path.write_text(SPEC.format(root=ROOT, vehicle=vehicle, offset=0.02 * arm, gusts=0.01 * torque, seeds=seeds, more=more, faults=faults))
    rows = Path(folder, "rows.csv")
    rows.unlink(missing_ok=True)
    overrides = [part for each in sets for part in ("--set", each)]
    command = [mavc, "campaign", path, "-q", "-o", rows, *overrides]
    ran = subprocess.run(command, capture_output=True, text=True)
    if ran.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{ran.stdout}{ran.stderr}")
    lines = rows.read_text().splitlines()
    names = lines[0].split(",")
    return [dict(zip(names, line.split(","))) for line in lines[1:]]


def main():
    mavc, flights = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 120
    only = sys.argv[3:]
    with tempfile.TemporaryDirectory() as folder:
        print("| vehicle | forgetting | threshold | false alarms/h | isolated in 1 s | gyroscope 3x: false alarms/h | isolated in 1 s |")
        print("|---|---|---|---|---|---|---|")
        for vehicle, torque, arm in VEHICLES:
            if only and vehicle not in only:
                continue
            for forgetting in FORGETTING:
                for threshold in THRESHOLDS:
                    sets = [f"simulate.forgetting={forgetting}", f"simulate.threshold={threshold}",
                            "vehicle.rotor.thrust_coefficient=8.5485e-6N*s^2/rad^2 +- 5%"]
                    noisy = "gyroscope_noise = 0.015 rad/s; assumed_gyroscope_noise = 0.005 rad/s"
                    cells = [measured(mavc, folder, vehicle, torque, arm, flights, sets, more) for more in ("", noisy)]
                    texts = [text for alarms, isolated in cells for text in (f"{alarms:.1f}", f"{100 * isolated:.0f} %")]
                    print(f"| {vehicle} | {forgetting} | {threshold} | " + " | ".join(texts) + " |", flush=True)


main()
