#!/usr/bin/env python3
"""Campaigns over quadcopters, hexacopters and octocopters: flights lost, and what the path suffers.

    python3 benches/campaigns.py target/release/mavc [TIMES SEEDS]

flies the plans of RIP, RSP and RCP of every case below with faults that are known after 100 and after 200 ms, in wind with gusts,
on one thread, and prints the tables of docs/campaigns.md. Needs Python alone. Seeds are fixed: the same mavc gives the same tables.
"""

import json
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DELAYS = ["100ms", "200ms"]

VIVIANI = """use "{root}/specs/vehicles/{vehicle}.mav"
let a = 4 m
faults {{ {faults} }}
mission viviani {{
    curve s in 0 .. 4*pi, points = 21 {{ x = a*(1 + cos(s)); y = a*sin(s); z = 10 m + 2*a*sin(s/2); yaw = 0 deg }}
    limits {{ tilt <= 35 deg }}
    air {{ wind = [4, 2, 0] m/s; gusts = 1 m/s }}
}}
plan {{ planner = rsp; against = {against}; time = minimum; within = 30 cm; samples = 100 }}
"""
DRAG = "vehicle.drag=0.3N*s/m"
OCTO = "every 1 rotor lost as M\n every 2 rotors lost as M"
FEWER = "every 1 rotor lost as M\n every 1 rotor reduced to 60 % as W"
YAW_DRAG = "vehicle.yaw_drag=2.75e-3N*m*s/rad"


def viviani(vehicle, faults, against, *sets):
    return dict(vehicle=vehicle, faults=faults, against=against), [DRAG, *sets]


# Name, spec (a file, or what fills the text above), further --set.
PARCEL = ["simulate.drag=0.3N*s/m", "simulate.wind=[4,2,0]m/s", "simulate.gusts=1m/s"]
CASES = [
    ("octo PPNNPPNN, paper, calm", "specs/paper/campaign.mav", []),
    ("octo PPNNPPNN", *viviani("octo_ppnnppnn", OCTO, "[M1_3, M1_6, M1_8, M4_5, M5_7]")),
    ("octo PNPNPNPN", *viviani("octo_pnpnpnpn", OCTO, "[M1, M2, M3, M4, M5, M6, M7, M8]")),
    ("hexa PPNNPN", *viviani("hexa_ppnnpn", FEWER, "[M1, M2, M3, M4]")),
    ("hexa PNPNPN", *viviani("hexa_pnpnpn", FEWER, "[W1, W2, W3, W4, W5, W6]")),
    ("quad PNPN", *viviani("quad_pnpn", FEWER, "[W1, W2, W3, W4]")),
    ("quad PNPN, yaw_drag, 20 m", *viviani("quad_pnpn", FEWER, "[W1, W2, W3, W4]", YAW_DRAG, "simulate.lost_beyond=20m")),
    ("parcel_quad, continues", "examples/parcel_quad.mav", PARCEL + ["simulate.after_fault=continue"]),
    ("parcel_quad, lands, 20 m", "examples/parcel_quad.mav", PARCEL + ["simulate.lost_beyond=20m"]),
]


def fly(mavc, folder, case, delay, times, seeds):
    """The report of one campaign and its seconds; None if it could not be flown."""
    name, spec, sets = case
    if isinstance(spec, dict):
        path = folder / "spec.mav"
        path.write_text(VIVIANI.format(root=ROOT, **spec))
    else:
        path = ROOT / spec
    report = folder / "report.json"
    command = [mavc, "campaign", str(path), "--quiet", "--threads", "1", "--report", str(report)]
    command += ["--times", times, "--seeds", seeds]
    for one in [f"simulate.detection={delay}"] + sets:
        command += ["--set", one]
    begin = time.monotonic()
    ran = subprocess.run(command, capture_output=True, text=True, cwd=folder)
    if ran.returncode not in (0, 4, 9):
        print(f"{name}, {delay}: exit code {ran.returncode}\n{ran.stderr}", file=sys.stderr)
        return None, time.monotonic() - begin
    return json.loads(report.read_text()), time.monotonic() - begin


def number(value, digits=2):
    return "-" if value is None else f"{value:.{digits}f}"


def share(count, of):
    return f"{100 * count / of:.0f} %" if of else "-"


def losses(planner, inside):
    """Struck flights lost, of how many, over the modes with hover inside their sets or over the others."""
    cells = [c for m in planner["modes"] if m["hover_inside"] == inside for c in m["times"]]
    return sum(c["lost"] for c in cells), sum(c["struck"] for c in cells)


def lost_row(record):
    planners = [p for p in record["planners"] if p["modes"]]
    row = [f"{record['mission_time_s']:.1f} s", ", ".join(str(p["healthy"]["lost"]) for p in planners)]
    for inside in (True, False):
        found = [losses(p, inside) for p in planners]
        row += [str(found[0][1]), ", ".join(str(lost) for lost, _ in found)]
    return row


def path_row(record):
    """Over modes with hover inside their sets, RIP, RSP and RCP: deviation, waypoints missed (healthy), limits, heading."""
    rows = [[], [], [], []]
    for planner in record["planners"]:
        paths = [m["flights"]["path"] for m in planner["modes"] if m["hover_inside"]]
        flights = sum(p["flights"] for p in paths)
        if flights == 0:
            continue
        sum_of = lambda key: sum(p[key] for p in paths)
        healthy = planner["healthy"]["path"]
        rows[0].append(number(sum(p["deviation_m"]["mean"] * p["flights"] for p in paths if p["deviation_m"]) / flights))
        before = share(healthy["waypoints_missed"], healthy["waypoints_due"])
        rows[1].append(f"{share(sum_of('waypoints_missed'), sum_of('waypoints_due'))} ({before})")
        rows[2].append(share(sum_of("limits_broken"), flights))
        rows[3].append(share(sum_of("heading_broken"), flights))
    return [", ".join(cells) for cells in rows]


def table(headings, rows):
    print("| " + " | ".join(headings) + " |")
    print("|" + "---|" * len(headings))
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


def main():
    mavc = str(Path(sys.argv[1]).resolve())
    times, seeds = sys.argv[2:4] if len(sys.argv) > 3 else ("12", "2")
    lost, path = [], []
    flights = 0
    with tempfile.TemporaryDirectory() as name:
        for case in CASES:
            for delay in DELAYS:
                record, seconds = fly(mavc, Path(name), case, delay, times, seeds)
                print(f"{case[0]}, {delay}: {seconds:.0f} s", file=sys.stderr)
                if record is None:
                    continue
                flights += record["flights"]
                title = [case[0], delay.replace("ms", " ms")]
                lost.append(title + lost_row(record))
                path.append(title + path_row(record))
    each = "RIP, RSP, RCP"
    print(f"Lost ({each})\n")
    table(["campaign", "delay", "T_d", "healthy", "struck, hover inside", "lost", "struck, others", "lost"], lost)
    print(f"The path, modes with hover inside ({each})\n")
    table(["campaign", "delay", "deviation [m]", "missed (healthy)", "limits", "heading"], path)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"{flights} flights, {used.ru_utime + used.ru_stime:.0f} s of processor time", file=sys.stderr)


main()
