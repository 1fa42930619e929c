"""Reads every format that mavc writes with its readers: check.py MAVC. Prints the largest difference from the exact trajectory for
each quantity, and exits with 1 if one is beyond its tolerance."""

import sys
import tempfile
from pathlib import Path

import logs
import missions
import pages
import players
import simulators
import tables
from plans import HOP, HOVER, Plan

PLANS = [("exact", HOP, ()), ("hover", HOP, HOVER), ("survey_hexa", "examples/survey_hexa.mav", ())]


def failures(title, found):
    """Prints what a check found; how many differences are beyond their tolerance."""
    failed = 0
    for reader, quantity, difference, tolerance in found:
        good = difference <= tolerance
        failed += not good
        mark = "" if good else "   BEYOND"
        print(f"{title:12} {reader:34} {quantity:30} {difference:9.2e} of {tolerance:7.0e}{mark}", flush=True)
    return failed


def main():
    failed = 0
    for title, spec, overrides in PLANS:
        with tempfile.TemporaryDirectory() as folder:
            plan = Plan(sys.argv[1], Path(folder), spec, overrides)
            checks = tables.CHECKS + simulators.CHECKS + logs.CHECKS + missions.CHECKS
            if title == "exact":
                checks = checks + players.CHECKS + logs.OF_FLIGHTS
            failed += sum(failures(title, check(plan)) for check in checks)
    failed += sum(failures("pages", check(sys.argv[1])) for check in pages.CHECKS)
    print("all within tolerance" if not failed else f"{failed} beyond tolerance")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
