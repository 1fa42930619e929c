#!/usr/bin/env python3
"""Is each generated mission flown by its premise alone? `python3 benches/missions/slow.py FIRST LAST` (numpy; `requirements.txt`).

The lines through the waypoints are flown leg by leg from rest to rest, with the sets of all modes (RCP): each leg in five pieces, or in
ten where five do not follow the yaw that the spec requires. This motion is slowed down by factors of two until `dense.py` finds no
violation at any instant. Prints the time of each such plan, and exits with 1 if a mission has none. These plans are slow: they show that
a mission has a plan, and say nothing about how short one can be.
"""

import sys

import generate
import independent
from dense import violations
from program import motion_of

SLOWER = [1, 2, 4, 8, 16, 32, 64]
INSTANTS = 4000


def slow_plan(record):
    """The time of the slow plan, or None, and the violations that remain at the slowest."""
    for fives, slower in [(1, slower) for slower in SLOWER] + [(2, slower) for slower in SLOWER]:
        motion = motion_of(record, independent.own_guess(record, 1, slower, fives))
        found, _ = violations(motion, record, "rcp", max(0.02, motion.time() / INSTANTS))
        if not independent.counts(found):
            return motion.time(), {}
    return None, {kind: found[kind] for kind in independent.counts(found)}


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    without = 0
    for seed in range(int(sys.argv[1]), int(sys.argv[2]) + 1):
        record, _ = generate.mission(seed)
        time, wrong = slow_plan(record)
        without += time is None
        print(f"{seed:4} {record['family']:10} {len(record['points']):2} waypoints: {f'{time:.1f} s' if time else wrong}", flush=True)
    print(f"{without} without a slow plan")
    sys.exit(1 if without else 0)


if __name__ == "__main__":
    main()
