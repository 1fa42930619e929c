#!/usr/bin/env python3
"""Fault trees of `mavc safety` against Debian's scram: python3 benches/safety/run.py MAVC SPEC... (needs `scram`).

A SPEC may be a folder that `mavc safety` wrote. For each, scram must find the same minimal cut sets, and the probability
that quantities.json states, to the digits that scram prints; the file is valid for scram, so for its schema too. Where
rates are intervals, the quantiles that scram draws lie in the interval that quantities.json states. The rows of the table
that is printed are those of docs/how-to/safety.md.
"""
import json
import os
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as xml

# scram prints six significant digits.
PRINTED = 6


def judged(folder):
    """The cut sets and the probability of scram for the fault tree in a folder; None without rates."""
    quantities = json.load(open(os.path.join(folder, "quantities.json")))
    is_rated = quantities["loss_of_control"]["per_mission"] is not None
    command = ["scram", os.path.join(folder, "faulttree.xml")] + (["--probability", "1"] if is_rated else [])
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{folder}: scram ends with {done.returncode}: {done.stderr}")
    found = xml.fromstring(done.stdout).find("results/sum-of-products")
    sets = {frozenset(event.get("name") for event in product) for product in found.findall("product")}
    probability = float(found.get("probability")) if is_rated else None
    return quantities, sets, probability


def drawn(folder, interval):
    """Compares quantiles of scram's draws of the rates with the stated interval."""
    command = ["scram", os.path.join(folder, "faulttree.xml"), "--uncertainty", "1", "--num-trials", "2000", "--seed", "1"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    measure = xml.fromstring(done.stdout).find("results/measure")
    # The lower bound of the first one is always 0.
    bounds = [float(one.get("upper-bound")) for one in measure.iter("quantile")]
    # scram prints six digits of its bounds.
    if not (interval[0] * (1 - 1e-5) <= min(bounds) < max(bounds) <= interval[1] * (1 + 1e-5)):
        raise SystemExit(f"{folder}: scram draws {min(bounds)} to {max(bounds)}, outside of {interval}")


def compare(folder):
    """Cut sets, probability for a mission and for an hour, and scram's probability, as cells; raises if scram disagrees."""
    quantities, sets, probability = judged(folder)
    stated = quantities["loss_of_control"]
    own = {frozenset(cut["events"]) for cut in quantities["cut_sets"]}
    if own != sets:
        raise SystemExit(f"{folder}: {len(own)} cut sets, scram finds {len(sets)}")
    if probability is None:
        return f"{len(sets)} | no rates | | "
    mission = stated["per_mission"]
    if float(f"{mission:.{PRINTED - 1}e}") != probability:
        raise SystemExit(f"{folder}: {mission}, scram finds {probability}")
    if stated["per_mission_over_rate_intervals"]:
        drawn(folder, stated["per_mission_over_rate_intervals"])
    return f"{len(own)} | {mission:.8e} | {stated['per_flight_hour']:.3e} | {probability}"


def written(mavc, spec, folder):
    """Lets mavc write the folder: wall and processor time, s, as cells."""
    begun, before = time.monotonic(), os.times()
    done = subprocess.run([mavc, "safety", spec, "-o", folder], capture_output=True, text=True)
    # 4: above the target of the spec; 7: a certificate weaker than the spec requires.
    if done.returncode not in (0, 4, 7):
        raise SystemExit(f"{spec}: exit code {done.returncode}: {done.stderr}")
    after = os.times()
    used = after.children_user + after.children_system - before.children_user - before.children_system
    return f"{time.monotonic() - begun:.0f} | {used:.0f}"


def main():
    mavc, specs = sys.argv[1], sys.argv[2:]
    if not specs:
        raise SystemExit(__doc__)
    print("| spec | cut sets | a mission | a flight hour | scram, a mission | wall, s | processor, s |")
    print("|---|---|---|---|---|---|---|")
    for spec in specs:
        with tempfile.TemporaryDirectory() as folder:
            times = " | " if os.path.isdir(spec) else written(mavc, spec, folder)
            print(f"| `{spec}` | {compare(spec if os.path.isdir(spec) else folder)} | {times} |", flush=True)


if __name__ == "__main__":
    main()
