#!/usr/bin/env python3
"""Fault trees of `mavc safety` against Debian's scram: python3 benches/safety/run.py MAVC SPEC... (needs `scram`).

A SPEC may be a folder that `mavc safety` wrote. For each, scram must find the same minimal cut sets, and the probability
that quantities.json states, to the digits that scram prints; the file is valid for scram, so for its schema too.
"""
import json
import os
import subprocess
import sys
import tempfile
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


def compare(folder):
    """A line of the result; raises if scram disagrees."""
    quantities, sets, probability = judged(folder)
    stated = quantities["loss_of_control"]["per_mission"]
    own = {frozenset(cut["events"]) for cut in quantities["cut_sets"]}
    if own != sets:
        raise SystemExit(f"{folder}: {len(own)} cut sets, scram finds {len(sets)}")
    if stated is None:
        return f"{len(sets)} cut sets as scram, no rates"
    if float(f"{stated:.{PRINTED - 1}e}") != probability:
        raise SystemExit(f"{folder}: {stated}, scram finds {probability}")
    return f"{len(own)} cut sets as scram; {stated!r}, scram {probability!r}"


def main():
    mavc, specs = sys.argv[1], sys.argv[2:]
    if not specs:
        raise SystemExit(__doc__)
    for spec in specs:
        with tempfile.TemporaryDirectory() as folder:
            if not os.path.isdir(spec):
                done = subprocess.run([mavc, "safety", spec, "-o", folder], capture_output=True, text=True)
                # 4: above the target of the spec; 7: a certificate weaker than the spec requires.
                if done.returncode not in (0, 4, 7):
                    raise SystemExit(f"{spec}: exit code {done.returncode}: {done.stderr}")
            print(f"{spec}: {compare(spec if os.path.isdir(spec) else folder)}", flush=True)


if __name__ == "__main__":
    main()
