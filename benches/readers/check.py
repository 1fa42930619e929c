"""Reads every format that mavc writes with its readers: check.py MAVC. Prints the largest difference from the exact trajectory for
each quantity, and exits with 1 if one is beyond its tolerance."""

import sys
import tempfile
from pathlib import Path

import logs
import missions
import players
import simulators
import tables
from plans import HOP, HOVER, Plan

PLANS = [("exact", HOP, ()), ("hover", HOP, HOVER), ("survey_hexa", "examples/survey_hexa.mav", ())]


def main():
    failed = 0
    for title, spec, overrides in PLANS:
        with tempfile.TemporaryDirectory() as folder:
            plan = Plan(sys.argv[1], Path(folder), spec, overrides)
            checks = tables.CHECKS + simulators.CHECKS + logs.CHECKS + missions.CHECKS
            if title == "exact":
                checks = checks + players.CHECKS + logs.OF_FLIGHTS
            for check in checks:
                for reader, quantity, difference, tolerance in check(plan):
                    good = difference <= tolerance
                    failed += not good
                    mark = "" if good else "   BEYOND"
                    print(f"{title:12} {reader:34} {quantity:24} {difference:9.2e} of {tolerance:7.0e}{mark}", flush=True)
    print("all within tolerance" if not failed else f"{failed} beyond tolerance")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
