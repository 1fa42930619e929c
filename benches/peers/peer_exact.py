#!/usr/bin/env python3
"""Plans in the exact model by mavc and by the same algorithm in CVXPY with Clarabel, at fixed mission times.

The same independent code judges both plans: it computes cost (48) and the wrench from the derivatives at the nodes, on a
grid of --parts instants for each interval, and compares the wrench with the facets of scipy's convex hull. Exit code 1 if
mavc's plan differs from its table (wrench or objective), or if either plan violates a facet by more than 1e-4 of its width.
"""

import argparse
import csv
import json
import re
import tempfile
import time
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

import flatness
from case import PeerError, load, main_with_errors
from exact_motion import taylor
from peer_compare import planning_sets
from run import HERE, run
from successive import BETWEEN, GRAVITY, UPRIGHT, Steps, Successive, rows_in_widths

# Columns of mavc's table by axis and order; yaw has two derivatives.
COLUMNS = [["x", "vx", "ax", "jx", "sx"], ["y", "vy", "ay", "jy", "sy"], ["z", "vz", "az", "jz", "sz"]]
YAW = ["yaw", "yaw_rate", "yaw_acc"]
SAME = 1e-6  # relative


@dataclass
class Result:
    """A plan, (nodes, 5, 4) at times, and its effort."""

    who: str
    nodes: np.ndarray
    times: np.ndarray
    solves: int
    iterations: int
    solver_seconds: float
    user_seconds: float
    seconds: float
    compiling: float = 0.0
    compilations: int = 0


def mavc_plan(options, case, total):
    """mavc's plan, its wrench at the nodes (nodes, 4) and the objective that it reports."""
    with tempfile.TemporaryDirectory() as folder:
        table, report = Path(folder) / "plan.csv", Path(folder) / "report.json"
        settings = ["plan.model=exact", f"plan.planner={options.planner}", f"plan.samples={case.samples}"]
        settings += ["plan.time=minimum" if total is None else f"plan.time={total}s"]
        command = [options.mavc, "plan", str(options.spec), "--timings", "-o", str(table), "--report", str(report)]
        done = run(command + [word for s in settings for word in ("--set", s)], options.repeat)
        with open(table, encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        objective = json.loads(report.read_text())["planners"][-1]["objective"]
    number = lambda name: np.array([float(row[name]) for row in rows])
    nodes = np.zeros((len(rows), 5, 4))
    for axis, names in enumerate([*COLUMNS, YAW]):
        for order, name in enumerate(names):
            nodes[:, order, axis] = number(name)
    wrench = np.stack([number(name) for name in ("thrust", "tau_x", "tau_y", "tau_z")], axis=1)
    effort = re.search(r"in (\d+) solves, (\d+) iterations", done.complaints)
    if effort is None:
        raise PeerError("mavc's --timings say nothing of solves and iterations")
    solves, iterations = map(int, effort.groups())
    solver = done.timings["solver"]
    found = Result("mavc", nodes, number("t"), solves, iterations, solver, done.user_seconds, done.seconds)
    return found, wrench, objective


def peer_plan(case, facets, total):
    """The peer's plan, or None if it finds none."""
    effort, begin, user = Steps(), time.perf_counter(), time.process_time()
    planner = Successive(case, facets, case.samples, effort)
    motion = planner.shortest() if total is None else planner.plan(total)
    seconds, user = time.perf_counter() - begin, time.process_time() - user
    if motion is None:
        return None, effort
    times = np.linspace(0.0, motion.total, case.samples + 1)
    nodes = planner.grid.nodes(motion)
    work = (effort.solves, effort.iterations, effort.seconds, user, seconds, effort.compiling, effort.compilations)
    return Result("peer", nodes, times, *work), effort


@dataclass
class Judged:
    """Cost (48), the largest violation of a facet (widths) and of (68) (g), the largest distance to a waypoint (m)."""

    cost: float
    excess: float
    upright: float
    miss: float


def judge(case, facets, plan, parts):
    flat = taylor(plan.nodes, plan.times, np.arange(parts + 1) / parts).reshape(-1, flatness.INPUTS)
    normals, offsets = rows_in_widths(case, facets)
    excess = (flatness.wrench(case.vehicle, flat) @ normals.T - offsets).max()
    upright = UPRIGHT - 1 - flat[:, 2].min() / GRAVITY
    at = np.linspace(0, len(plan.times) - 1, len(case.waypoints_m)).astype(int)
    miss = plan.nodes[at, 0, :3] - case.waypoints_m
    turn = plan.nodes[at, 0, 3] - case.yaw_rad
    # Squares of snap (linear) and of acceleration (cubic) over each interval: four points of Gauss are exact.
    points, weights = np.polynomial.legendre.leggauss(4)
    squares = taylor(plan.nodes, plan.times, (points + 1) / 2) ** 2
    over_time = np.einsum("ksi,s,k->i", squares, weights / 2, np.diff(plan.times))
    cost = case.weights["snap"] * over_time[[6, 7, 8]].sum() + case.weights["acceleration"] * over_time[[2, 11]].sum()
    cost += case.weights["waypoint"] * ((miss**2).sum() + (turn**2).sum())
    return Judged(float(cost), float(excess), float(upright), float(np.linalg.norm(miss, axis=1).max()))


def rows(case, facets, total, options):
    """Prints the results of both at one time; returns what is wrong, in words."""
    plan, wrench, objective = mavc_plan(options, case, total)
    words = []
    at_nodes = taylor(plan.nodes, plan.times, np.array([0.0, 1.0]))
    at_nodes = np.vstack([at_nodes[:, 0], at_nodes[-1:, 1]])
    apart = np.abs(flatness.wrench(case.vehicle, at_nodes) - wrench).max(axis=0) / np.abs(wrench).max(axis=0)
    if apart.max() > SAME:
        words.append(f"mavc's wrench differs from the peer's of the same motion by {apart.max():.2g}")
    cost = judge(case, facets, plan, options.parts).cost
    if abs(cost - objective) > SAME * cost:
        words.append(f"mavc's objective {objective:.8g} is {cost:.8g} by the peer's integrals")
    peer, effort = peer_plan(case, facets, total)
    if peer is None:
        print(f"peer: no plan found after {effort.solves} solves, {effort.seconds:.1f} solver seconds")
    for result in filter(None, (plan, peer)):
        judged = judge(case, facets, result, options.parts)
        per_iteration = 1e3 * result.solver_seconds / result.iterations
        print(
            f"{result.times[-1]:6.2f} s  {result.who:4}  {judged.cost:9.5f}  {judged.excess:10.1e}"
            f"  {100 * judged.miss:8.3f}"
            f"  {result.solves:6}  {result.iterations:10}  {result.solver_seconds:8.2f}  {per_iteration:12.2f}"
            f"  {result.user_seconds:6.2f}  {result.seconds:6.2f}  {result.compilations:3} in {result.compiling:.1f} s"
        )
        if judged.excess > BETWEEN or judged.upright > BETWEEN or judged.miss > case.within_m + 1e-5:
            words.append(f"{result.who}'s plan at {result.times[-1]:g} s leaves the set or misses a waypoint: {judged}")
    return words


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mavc", help="the release binary, such as target/release/mavc")
    parser.add_argument("--case", type=Path, default=HERE / "cases" / "case1.json", help="(default case1)")
    parser.add_argument(
        "--spec", type=Path, default=HERE.parents[1] / "specs" / "paper" / "case1.mav", help="the same for mavc"
    )
    parser.add_argument("--times", default="24,20", help="mission times, s; `minimum` is one (default %(default)s)")
    parser.add_argument("--samples", type=int, help="intervals of both (default the case's)")
    parser.add_argument("--planner", choices=["rip", "rcp"], default="rip", help="(default %(default)s)")
    parser.add_argument("--parts", type=int, default=100, help="instants an interval to judge at (default %(default)s)")
    parser.add_argument("--repeat", type=int, default=3, help="runs of mavc, the fastest counts (default 3)")
    options = parser.parse_args()
    if min(options.parts, options.repeat) < 1:
        raise PeerError("--parts and --repeat: at least 1")
    case = load(options.case)
    if options.samples is not None:
        case = replace(case, samples=options.samples)
    healthy, _, joint = planning_sets(case)
    print(
        "    time  who        cost   passed by   miss cm  solves  iterations  solver s  ms/iteration  user s  wall s"
        "  compiled"
    )
    words = []
    for total in options.times.split(","):
        try:
            seconds = None if total == "minimum" else float(total)
        except ValueError as error:
            raise PeerError(f"--times: {total!r} is no number of seconds") from error
        words += rows(case, healthy if options.planner == "rip" else joint, seconds, options)
    for line in words:
        print(f"DIFFERS  {line}")
    return 1 if words else 0


if __name__ == "__main__":
    main_with_errors(main)
