#!/usr/bin/env python3
"""Height that a quadcopter loses without a rotor, by thrust-to-weight ratio and delay: `quad_survival.py MAVC`.

The paper's quadcopter (docs/reproduction.md) with its thrust scaled, rotor 1 lost in hover: `mavc analyze --capture` of each, for
rotors with a lag of 20 ms and of 40 ms. Prints one table for docs/flight.md, Markdown: the median of five flights, m, and `lost` where
none of them regains level flight, or how many do.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

RATIOS = [1.85, 2.0, 2.18, 2.47, 2.93, 3.5]
LAGS = [20, 40]
WEIGHT = 1.32 * 9.81
SPEC = """vehicle quad {{
    layout   = "PNPN"
    arm      = 0.211 m
    mass     = 1.32 kg
    inertia  = [0.0128, 0.0128, 0.0239] kg*m^2
    yaw_drag = 2.75e-3 N*m*s/rad
    rotor {{ max_thrust = {thrust} N; torque_per_thrust = 16 mm; max_speed = 840 rad/s; time_constant = {lag} ms }}
}}
faults {{ mode out {{ rotor 1 lost }} }}
"""


def captures(mavc, folder, ratio, lag):
    """The captures from rest with the rotors' own lag, by delay in ms."""
    path = Path(folder, "quad.mav")
    path.write_text(SPEC.format(thrust=ratio * WEIGHT / 4.0, lag=lag))
    ran = subprocess.run([mavc, "analyze", path, "--capture", "--format", "json"], capture_output=True, text=True, check=True)
    found = json.loads(ran.stdout)["captures"]
    return {round(1e3 * c["delay_s"]): c for c in found if c["speed_m_per_s"] == 0.0 and abs(c["lag_s"] - 1e-3 * lag) < 1e-9}


def cell(capture):
    if capture["regained"] == 0:
        return "lost"
    height = f"{capture['height_m'][1]:.1f}"
    return height if capture["regained"] == capture["flights"] else f"{height} ({capture['regained']} of {capture['flights']})"


def main():
    with tempfile.TemporaryDirectory() as folder:
        table = {(ratio, lag): captures(sys.argv[1], folder, ratio, lag) for lag in LAGS for ratio in RATIOS}
    delays = sorted(next(found for found in table.values() if found))
    print("| thrust over weight, lag | " + " | ".join(f"{delay} ms" for delay in delays) + " |")
    print("|---" * (len(delays) + 1) + "|")
    for (ratio, lag), found in table.items():
        cells = [cell(found[delay]) if delay in found else "lost" for delay in delays]
        print(f"| {ratio:.2f}, {lag} ms | " + " | ".join(cells) + " |")


main()
