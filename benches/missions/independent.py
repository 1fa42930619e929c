#!/usr/bin/env python3
"""An independent optimiser of missions: `python3 benches/missions/independent.py SPEC [PLAN.csv] --mavc MAVC`.

It looks for the shortest mission with CasADi and IPOPT (`requirements.txt`), in the exact model with the durations of all pieces free, and
compares it with a plan of mavc. SPEC is a record of `generate.py SEED --json`, or a spec of literals (`specs.py` says which). PLAN.csv is
the table of `mavc plan -o`; without it the search starts only from its own guess.

    --planner NAME     rip or rcp (rip)
    --start WHICH      mavc, own or both (both)
    --pieces N         pieces of all legs together; unless given as many as the plan has, at most 120
    --seconds N        processor time of each solution by IPOPT (400)
    --rounds N         solutions after the first, with the facets and volumes added that were violated, and
                       with the instants in between at which something was (5)
    --verbose          the log of IPOPT

The guess of its own flies the lines through the waypoints slowly from rest to rest. Each motion is checked at instants 5 ms apart by
`dense.py`, which shares no formula with the program: facets of all sets, limits, volumes, corridors, waypoints, yaw and rest. Printed are
the mission times and the largest violation of each kind, also for mavc's own plan. A time counts if no facet is violated by more than
0.1 % of the healthy set's width and nothing else by more than 1 mm, 1 mm/s, 0.01 degrees and so on; the last line says by how much mavc
is longer than the shortest that counts. The search is local: it shows what is possible, not what is impossible.
"""

import argparse
import csv
import json
import math
import sys

import numpy as np
import specs
from dense import ALLOWED, Motion, facets_of, violations, wrenches
from program import Program, motion_of


def plan_of(path, record):
    """The motion of a table of mavc, and its nodes for each leg."""
    with open(path) as file:
        rows = [{key: float(value) for key, value in row.items() if value != ""} for row in csv.DictReader(file)]
    state = lambda row: np.array([[row[prefix + axis] for axis in "xyz"] for prefix in ("", "v", "a", "j")])
    snap = lambda row: np.array([row["s" + axis] for axis in "xyz"])
    x, s, y, h, leg = [], [], [], [], []
    legs, waypoint = [], 0
    nodes = []
    for before, after in zip(rows, rows[1:]):
        if before["waypoint"]:
            held = int(before["waypoint"]) - 1 == waypoint and waypoint > 0
            waypoint = int(before["waypoint"]) - 1
            hold = record["points"][waypoint]["hold"] > 0 and not held
            nodes = []
            if not hold:
                legs.append(nodes)
        elif not nodes and waypoint >= 0 and record["points"][waypoint]["hold"] and leg and leg[-1] < 0:
            hold = False
            legs.append(nodes)
        step = after["t"] - before["t"]
        # The row after has the values to its right; those to its left follow from jerk and yaw rate.
        end = 2 * (state(after)[3] - state(before)[3]) / step - snap(before)
        turn = 2 * (after["yaw_rate"] - before["yaw_rate"]) / step - before["yaw_acc"]
        x.append(state(before))
        s.append([snap(before), end])
        y.append([before["yaw"], before["yaw_rate"], before["yaw_acc"], turn])
        h.append(step)
        leg.append(-1 if hold else waypoint)
        nodes.append((before, after, end, turn))
        if hold:
            nodes = []
    return Motion(x, s, y, h, leg), legs


def thinned(legs, pieces):
    """A guess of fewer pieces from the nodes of the plan."""
    whole, guess = sum(len(nodes) for nodes in legs), []
    for nodes in legs:
        n = min(len(nodes), max(6, round(len(nodes) * pieces / whole)))
        kept = np.unique(np.round(np.linspace(0, len(nodes), n + 1)).astype(int))
        rows = [nodes[i][0] for i in kept[:-1]]
        last, end, turn = nodes[-1][1:]
        times = [row["t"] for row in rows] + [last["t"]]
        x = [[[row[prefix + axis] for axis in "xyz"] for prefix in ("", "v", "a", "j")] for row in [*rows, last]]
        s = [[row["s" + axis] for axis in "xyz"] for row in rows] + [list(end)]
        y = [[row["yaw"], row["yaw_rate"], row["yaw_acc"]] for row in rows] + [[last["yaw"], last["yaw_rate"], turn]]
        guess.append({"x": np.array(x), "s": np.array(s), "y": np.array(y), "h": np.diff(times)})
    return guess


def eased(ends, nodes, order):
    """A function from 0 to 1 whose derivative of this order is linear between the nodes and zero at both ends: its derivatives at the
    nodes, for steps of 1. `ends` are values of that derivative at the ends of five equal parts of the way, up to a factor."""
    n = nodes - 1
    top = np.interp(np.arange(nodes), np.linspace(0, n, 6), ends)
    found = np.zeros((order + 1, nodes))
    found[order] = top
    for i in range(n):
        for j in range(order):
            own = sum(found[k, i] / math.factorial(k - j) for k in range(j, order + 1))
            found[j, i + 1] = own + (top[i + 1] - top[i]) / math.factorial(order + 1 - j)
    return found / found[0, -1]


def way_along(nodes):
    """The speed is the B-spline of degree 4 on five parts, so that the motion is a spline of the program."""
    return eased([0, 1, -3, 3, -1, 0], nodes, 4)


def way_of_turn(nodes):
    return eased([0, 1, 1, -1, -1, 0], nodes, 2)


def yaw_of_leg(before, point, first, last, places, h):
    """Yaw, its rate and its acceleration at the nodes of a leg of the own guess."""
    turn, rule, nodes = last - first, point["yaw"], len(places)
    if rule != before["yaw"] or rule["rule"] not in ("path", "towards"):
        way = way_of_turn(nodes)
        return np.stack([first + turn * way[0], turn * way[1] / h, turn * way[2] / h**2], axis=1)
    if rule["rule"] == "path":  # turns in the last fifth of the leg, where it is slow
        at = 4 * (nodes - 1) // 5
        way = np.hstack([np.zeros((3, at)), way_of_turn(nodes - at)]) if nodes - at > 5 else way_of_turn(nodes)
        return np.stack([first + turn * way[0], turn * way[1] / h, turn * way[2] / h**2], axis=1)
    ahead = np.array(rule["point"][:2]) - places[:, :2]
    wanted = np.unwrap(np.concatenate([[first], np.arctan2(ahead[:, 1], ahead[:, 0])]))[1:]
    # Yaw and rate are linear in the accelerations at the nodes. Those of the ends are zero; the others fit the angles, and end in rest.
    n = nodes - 1
    yaw, rate = np.zeros((nodes, nodes)), np.zeros((nodes, nodes))
    for i in range(n):
        yaw[i + 1] = yaw[i] + rate[i]
        rate[i + 1] = rate[i]
        yaw[i + 1, i : i + 2] += [1 / 3, 1 / 6]
        rate[i + 1, i : i + 2] += 0.5
    inner = slice(1, n)
    ends = np.array([rate[n, inner], yaw[n, inner]])
    system = np.block([[yaw[:, inner].T @ yaw[:, inner], ends.T], [ends, np.zeros((2, 2))]])
    right = np.concatenate([yaw[:, inner].T @ (wanted - first), [0.0, wanted[-1] - first]])
    top = np.concatenate([[0.0], np.linalg.lstsq(system, right, rcond=None)[0][: n - 1], [0.0]])
    return np.stack([first + yaw @ top, rate @ top / h, top / h**2], axis=1)


def own_guess(record, pieces, slower=1.0, least=1):
    """The lines through the waypoints, slowly from rest to rest: a plan, except for rules of yaw, if it is slow enough."""
    points, limits = record["points"], record["limits"]
    yaws = []
    for number, point in enumerate(points):
        rule, last = point["yaw"], yaws[-1] if yaws else 0.0
        ahead = None
        if rule["rule"] == "angle":
            angle = math.radians(rule["deg"])
        elif rule["rule"] == "towards":
            angle = math.atan2(rule["point"][1] - point["at"][1], rule["point"][0] - point["at"][0])
        else:
            ahead = points[min(number + 1, len(points) - 1)]["at"], points[min(number, len(points) - 2)]["at"]
            level = math.dist(ahead[0][:2], ahead[1][:2]) > 0.1 and rule["rule"] == "path"
            angle = math.atan2(ahead[0][1] - ahead[1][1], ahead[0][0] - ahead[1][0]) if level else last
        yaws.append(last + (angle - last + math.pi) % (2 * math.pi) - math.pi if yaws else angle)
    durations = []
    for number, (before, point) in enumerate(zip(points, points[1:])):
        own = limits | point["limits"]
        speed = min([own[k][1] for k in ("speed", "speed_horizontal", "climb", "descent") if k in own] + [8.0])
        length, turn = math.dist(before["at"], point["at"]), abs(yaws[number + 1] - yaws[number])
        rate = math.radians(own["yaw_rate"][1]) if "yaw_rate" in own else 1.0
        # The largest speed is three times the mean, the largest acceleration 17 lengths per squared duration.
        durations.append(max(3.1 * length / speed, math.sqrt(17 * length / 1.5), 3 * turn / rate, 2.0))
    shares = np.log1p(durations)
    guess = []
    for number, (before, point) in enumerate(zip(points, points[1:])):
        n = 5 * max(least, round(pieces * shares[number] / shares.sum() / 5))
        h = slower * durations[number] / n
        a, b = np.array(before["at"]), np.array(point["at"])
        way = way_along(n + 1)
        x = np.stack([(a * (i == 0) + np.outer(w, b - a)) / h**i for i, w in enumerate(way[:4])], axis=1)
        s = np.outer(way[4], b - a) / h**4
        y = yaw_of_leg(before, point, yaws[number], yaws[number + 1], x[:, 0], h)
        guess.append({"x": x, "s": s, "y": y, "h": np.full(n, h)})
    return guess


def counts(found):
    """The kinds of violations that are too large."""
    return [kind for kind, (value, _) in found.items() if value > ALLOWED.get(kind, ALLOWED["else"])]


def told(name, time, found):
    wrong = counts(found)
    worst = ", ".join(f"{kind} {100 * value:.3f} %" if kind == "wrench" else f"{kind} {value:.2g}" for kind, (value, _) in sorted(found.items()) if value > 1e-5)
    print(f"{name}: {time:.3f} s; {'violates ' + ', '.join(wrong) if wrong else 'counts'}; largest violations: {worst or 'none'}", flush=True)


def search(record, planner, guess, options, name):
    """The shortest time that counts, or None."""
    best, chosen, pairs, extra = None, set(), {}, set()
    for number in range(options.rounds + 1):
        program = Program(record, planner, guess, quickest=0.3 if number else 0.02)
        program.chosen |= chosen
        program.extra = extra
        program.near(2.0)
        program.pairs |= {key: first for key, first in pairs.items() if key not in program.pairs}
        legs, stats = program.solve(seconds=options.seconds, verbose=options.verbose, warm=number > 0)
        motion = motion_of(record, legs)
        if not np.isfinite(motion.time()) or motion.time() > 1e5:
            print(f"{name}, round {number}: {stats['return_status']}", flush=True)
            break
        found, instants = violations(motion, record, planner)
        told(f"{name}, round {number} ({stats['return_status']}, {stats['iter_count']} iterations)", motion.time(), found)
        if not counts(found):
            best = min(motion.time(), best or math.inf)
            break
        # The next round requires everything at the worst instants of this one, too, and the facets that it violates.
        rows, offsets, widths, masses = facets_of(record, planner)
        w, _ = wrenches(motion, record, *motion.instants(0.005), np.array(record["air"]["wind"]))
        over = np.array([((m * n[0] * w[:, 0] + w[:, 1:] @ n[1:] - o) / d).max() for n, o, d, m in zip(rows, offsets, widths, masses)])
        chosen, pairs = program.chosen | set(np.flatnonzero(over > 1e-4).tolist()), program.pairs
        first = np.cumsum([0] + [len(leg["h"]) + (point["hold"] > 0) for leg, point in zip(legs, record["points"][1:])])
        for piece, share in instants:
            leg = int(motion.leg[piece])
            if leg >= 0 and 0.02 < share < 0.98:
                extra.add((leg, piece - int(first[leg]), round(share, 2)))
        guess = legs
    return best


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("spec")
    parser.add_argument("plan", nargs="?")
    parser.add_argument("--mavc", default="target/release/mavc")
    parser.add_argument("--planner", choices=["rip", "rcp"], default="rip")
    parser.add_argument("--start", choices=["mavc", "own", "both"], default="both")
    parser.add_argument("--pieces", type=int)
    parser.add_argument("--seconds", type=float, default=400)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    if options.spec.endswith(".json"):
        with open(options.spec) as file:
            record = json.load(file)
    else:
        record = specs.read(options.spec, options.mavc)
    own_time, starts = None, []
    pieces = options.pieces or 100
    if options.plan:
        motion, legs = plan_of(options.plan, record)
        own_time = motion.time()
        told("mavc", own_time, violations(motion, record, options.planner)[0])
        pieces = options.pieces or min(120, sum(len(nodes) for nodes in legs))
        if options.start != "own":
            starts.append(("from mavc's plan", thinned(legs, pieces)))
    if options.start != "mavc":
        starts.append(("from its own guess", own_guess(record, pieces)))
    times = [search(record, options.planner, guess, options, name) for name, guess in starts]
    times = [time for time in times if time]
    if times and own_time:
        print(f"shortest that counts {min(times):.3f} s; mavc's {own_time:.3f} s is {100 * (own_time / min(times) - 1):+.2f} % longer")
    elif times:
        print(f"shortest that counts {min(times):.3f} s")
    sys.exit(0 if times else 1)


if __name__ == "__main__":
    main()
