#!/usr/bin/env python3
"""Campaigns over quadcopters, hexacopters and octocopters: what predicts losses, and whether better plans suffer less.

    python3 benches/campaigns.py target/release/mavc [TIMES SEEDS]

flies the plans of RIP, RSP and RCP of every case below with faults that are known after 100 and after 200 ms, in wind with gusts,
on one thread, and prints the tables of docs/campaigns.md. Needs Python alone. Seeds are fixed: the same mavc gives the same tables.
"""

import json
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


def flights(record):
    """One row for each planner: struck flights lost, of modes with hover inside their sets and of the others; and the path."""
    for planner in record["planners"]:
        if not planner["modes"]:
            yield [planner["name"].upper(), planner["verdict"]] + ["-"] * 8
            continue
        healthy = planner["healthy"]
        cells = [planner["name"].upper(), f"{healthy['lost']} of {healthy['flights']}"]
        groups = [[m for m in planner["modes"] if m["hover_inside"] == inside] for inside in (True, False)]
        for modes in groups:
            struck = sum(c["struck"] for m in modes for c in m["times"])
            lost = sum(c["lost"] for m in modes for c in m["times"])
            cells.append(f"{lost} of {struck}")
        inside = groups[0]
        cells.append(number(sum(m["violation_duration_s"] for m in inside) / max(len(inside), 1)))
        paths = [m["flights"]["path"] for m in inside]
        judged = sum(p["flights"] for p in paths)
        mean = sum(p["deviation_m"]["mean"] * p["flights"] for p in paths if p["deviation_m"])
        cells.append(number(mean / judged) if judged else "-")
        due = sum(p["waypoints_due"] for p in paths)
        share = lambda count, of: f"{100 * count / of:.0f} %" if of else "-"
        cells.append(share(sum(p["waypoints_missed"] for p in paths), due))
        cells.append(share(healthy["path"]["waypoints_missed"], healthy["path"]["waypoints_due"]))
        cells.append(share(sum(p["limits_broken"] for p in paths), judged))
        cells.append(share(sum(p["heading_broken"] for p in paths), judged))
        yield cells


def table(headings, rows):
    print("| " + " | ".join(headings) + " |")
    print("|" + "---|" * len(headings))
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


def main():
    mavc = str(Path(sys.argv[1]).resolve())
    times, seeds = sys.argv[2:4] if len(sys.argv) > 3 else ("12", "2")
    lost, predicted, harm = [], [], []
    total = 0.0
    with tempfile.TemporaryDirectory() as name:
        for case in CASES:
            for delay in DELAYS:
                record, seconds = fly(mavc, Path(name), case, delay, times, seeds)
                total += seconds
                print(f"{case[0]}, {delay}: {seconds:.0f} s", file=sys.stderr)
                if record is None:
                    continue
                title = f"{case[0]}; {delay.replace('ms', ' ms')}"
                t = f"{record['mission_time_s']:.1f} s"
                lost += [[title, t] + cells for cells in flights(record)]
                for p in record["predictors"]:
                    counts = [str(p[k]) for k in ("hits", "misses", "false_alarms", "correct_negatives")]
                    scores = [number(p[k], 3) for k in ("brier", "brier_by_class", "brier_base")]
                    predicted.append([title, p["predictor"].replace("_", " ")] + counts + [number(p["phi"])] + scores)
                inside = record["agreement"][1]
                for c in inside["harm"]:
                    if c["rank_correlation"] is None and c["within_modes"] is None:
                        continue
                    interval = c["interval"]
                    span = f"{number(interval['low'])} .. {number(interval['high'])}" if interval else "-"
                    cells = [c["quality"].replace("_", " "), c["harm"].replace("_", " "), str(c["pairs"])]
                    harm.append([title] + cells + [number(c["rank_correlation"]), span, number(c["within_modes"]), str(c["modes"])])
    table(
        ["campaign", "T_d", "planner", "lost healthy", "lost, hover inside", "lost, other modes", "violated", "deviation", "missed", "missed healthy", "limits", "heading"],
        lost,
    )
    table(["campaign", "predictor", "hits", "misses", "false alarms", "correct negatives", "phi", "Brier", "by class", "base"], predicted)
    table(["campaign", "quality", "harm", "pairs", "rank correlation", "95 % interval", "within modes", "modes"], harm)
    print(f"{total:.0f} s", file=sys.stderr)


main()
