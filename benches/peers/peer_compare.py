#!/usr/bin/env python3
"""Steps (a) to (f) of the paper's section 5.3 in CVXPY with Clarabel: every facet at every node, bisection on T.

One compiled problem serves all times of a set: with derivatives measured in steps of h = T / samples, the dynamics do not
depend on T, which appears as powers of 1/h only (CVXPY parameters under the DPP rules).
"""

import argparse
import json
import math
import time

import cvxpy as cp
import numpy as np
import scipy.sparse as sp

from case import GRAVITY, PeerError, load, main_with_errors
from peer_sets import admissible_set, intersection, wrench_scale

RESOLUTION = 0.05  # s, between a time shown feasible and one shown infeasible
FEASIBLE = 1e-6  # m, the largest waypoint overshoot of a feasible mission
VIOLATED = 1e-4  # share of the healthy set's width
LONGEST = 1000.0  # s
SNAP, ACCELERATION = 4, 2  # the derivative that is the input: x, y and z, yaw


def hold_step(order):
    """(order, order + 1), (order, 1): state' = A [state; u_0] + b u_1 over a unit step with u linear in between."""
    factorial = [math.factorial(k) for k in range(order + 2)]
    a = np.zeros((order, order + 1))
    b = np.zeros((order, 1))
    for row in range(order):
        for column in range(row, order):
            a[row, column] = 1 / factorial[column - row]
        p = order - row  # the input is integrated p times
        b[row, 0] = 1 / factorial[p + 1]
        a[row, order] = 1 / factorial[p] - b[row, 0]
    return a, b


def hold_root(samples):
    """Sparse R with |R u|^2 = integral of u^2 over unit steps, u linear between the nodes."""
    k = np.arange(samples)
    ends = sp.csc_matrix((np.ones(2 * samples), (np.r_[k, k], np.r_[k, k + 1])), shape=(samples, samples + 1))
    # (u0^2 + u0 u1 + u1^2)/3 = (u0 + u1)^2/6 + (u0^2 + u1^2)/6, and every inner node belongs to two steps
    steps = np.full(samples + 1, 2.0)
    steps[[0, -1]] = 1.0
    return sp.vstack([ends / math.sqrt(6), sp.diags(np.sqrt(steps / 6))], format="csc")


class Effort:
    """Effort summed over solves: their number, iterations, and the seconds that the solver reports."""

    def __init__(self):
        self.solves = self.iterations = 0
        self.seconds = 0.0

    def add(self, stats, elapsed):
        self.solves += 1
        self.iterations += stats.num_iters
        # A solver that is updated in place includes its first setup in every later time; this clock does not.
        self.seconds += min(stats.solve_time, elapsed)


class Plan:
    """A mission at one time: `wrench` (nodes, 4) scaled, `position` (nodes, 3) m, `yaw` (nodes,) rad."""

    def __init__(self, total, objective, wrench, position, yaw, solver_seconds):
        self.total, self.objective, self.wrench = total, objective, wrench
        self.position, self.yaw, self.solver_seconds = position, yaw, solver_seconds


class Planner:
    """The mission against one set (normals, offsets) in scaled wrenches, at any total time."""

    def __init__(self, case, facets, effort):
        self.case, self.effort, self.plans = case, effort, {}
        k, vehicle = case.samples, case.vehicle
        stride = k // (len(case.waypoints_m) - 1)
        self.x, self.y = cp.Variable((SNAP + 1, k + 1)), cp.Variable((SNAP + 1, k + 1))
        self.z, self.yaw = cp.Variable((ACCELERATION + 1, k + 1)), cp.Variable((ACCELERATION + 1, k + 1))
        overshoot = cp.Variable()
        # Powers of 1/h and the weights of the objective: everything that depends on the total time.
        self.per_h2, self.per_h4 = cp.Parameter(nonneg=True), cp.Parameter(nonneg=True)
        self.snap_weight, self.acceleration_weight = cp.Parameter(nonneg=True), cp.Parameter(nonneg=True)

        rows = []
        for states in (self.x, self.y, self.z, self.yaw):
            a, b = hold_step(states.shape[0] - 1)
            rows.append(states[:-1, 1:] == a @ states[:, :-1] + b @ states[-1:, 1:])
        for states, highest in ((self.x, 3), (self.y, 3), (self.z, 2), (self.yaw, 2)):
            rows.append(states[1 : highest + 1, [0, k]] == 0)

        ixx, iyy, izz = vehicle.inertia_kg_m2
        c, s = math.cos(case.yaw_rad), math.sin(case.yaw_rad)
        scale = wrench_scale(vehicle)
        wrench = cp.vstack(
            [
                vehicle.mass_kg / scale[0] * (GRAVITY + self.per_h2 * self.z[2]),
                ixx / GRAVITY / scale[1] * self.per_h4 * (s * self.x[4] - c * self.y[4]),
                iyy / GRAVITY / scale[2] * self.per_h4 * (c * self.x[4] + s * self.y[4]),
                izz / scale[3] * self.per_h2 * self.yaw[2],
            ]
        )
        self.wrench = wrench
        normals, offsets = facets
        rows.append(normals @ wrench <= offsets[:, None])

        at = slice(0, k + 1, stride)
        self.position = cp.vstack([self.x[0], self.y[0], self.z[0]])
        miss = self.position[:, at] - case.waypoints_m.T
        points = len(case.waypoints_m)
        rows.append(cp.abs(self.yaw[0, at] - case.yaw_rad) <= case.yaw_within_rad)
        if case.tilt_deg is not None:
            slope = math.tan(math.radians(case.tilt_deg))
            horizontal = self.per_h2 * cp.vstack([self.x[2], self.y[2]])
            rows.append(cp.SOC(slope * (GRAVITY + self.per_h2 * self.z[2]), horizontal, axis=0))

        soft = [cp.SOC((case.within_m + overshoot) * np.ones(points), miss, axis=0), overshoot >= -case.within_m]
        self.feasibility = cp.Problem(cp.Minimize(overshoot), rows + soft)
        root = hold_root(k)
        objective = self.snap_weight * cp.sum_squares(root @ cp.vstack([self.x[4], self.y[4]]).T)
        objective += self.acceleration_weight * cp.sum_squares(root @ cp.vstack([self.z[2], self.yaw[2]]).T)
        objective += case.weights["waypoint"] * (cp.sum_squares(miss) + cp.sum_squares(self.yaw[0, at] - case.yaw_rad))
        hard = [cp.SOC(case.within_m * np.ones(points), miss, axis=0)]
        self.optimum = cp.Problem(cp.Minimize(objective), rows + hard)

    def _solve(self, problem, total):
        h = total / self.case.samples
        self.per_h2.value, self.per_h4.value = h**-2, h**-4
        self.snap_weight.value = self.case.weights["snap"] * h / h**8
        self.acceleration_weight.value = self.case.weights["acceleration"] * h / h**4
        begin = time.perf_counter()
        try:
            value = problem.solve(solver=cp.CLARABEL, max_threads=1)
        except cp.SolverError as error:
            raise PeerError(f"no verdict at T = {total:.3f} s: {error}") from error
        self.effort.add(problem.solver_stats, time.perf_counter() - begin)
        if problem.status not in (cp.OPTIMAL, cp.INFEASIBLE):
            raise PeerError(f"no verdict at T = {total:.3f} s: {problem.status}")
        return value

    def feasible(self, total):
        """Whether all waypoints can be met within their tolerance."""
        return self._solve(self.feasibility, total) <= FEASIBLE

    def shortest(self, low, high):
        """A feasible total time, at most RESOLUTION above an infeasible one; `low` is known to be infeasible."""
        while not self.feasible(high):
            low, high = high, 1.5 * high
            if high > LONGEST:
                raise PeerError(f"no feasible time up to {LONGEST:g} s")
        while high - low > RESOLUTION:
            middle = (low + high) / 2
            low, high = (low, middle) if self.feasible(middle) else (middle, high)
        return low, high

    def plan(self, total):
        """The best plan at one total time, or None if there is none; each time is solved once."""
        if total not in self.plans:
            self.plans[total] = None
            value = self._solve(self.optimum, total)
            if math.isfinite(value):
                seconds = self.optimum.solver_stats.solve_time
                found = (self.wrench.value.T, self.position.value.T, self.yaw.value[0], seconds)
                self.plans[total] = Plan(total, value, *found)
        return self.plans[total]


def excess(plan, facets, healthy):
    """(nodes, N): the violation of each facet at each node, as a share of the healthy set's width."""
    normals, offsets = facets
    width = np.abs(normals @ healthy).sum(axis=1)
    return (plan.wrench @ normals.T - offsets) / width


def planning_sets(case):
    """The healthy set, each mode's set by name, and the intersection of the modes' sets."""
    hover = case.vehicle.hover() / wrench_scale(case.vehicle)
    healthy = admissible_set(case.vehicle, reserve=case.reserve)
    sets = {name: admissible_set(case.vehicle, lost, case.reserve) for name, lost in case.modes.items()}
    for name, (normals, offsets) in sets.items():
        if (normals @ hover >= offsets).any():
            raise PeerError(f"mode {name} cannot hover")
    return healthy, sets, intersection(list(sets.values()), hover)


def compare(case):
    """Steps (a) to (f): a dictionary of shortest times, objectives, violations and effort."""
    begin = time.perf_counter()
    effort = Effort()
    hover = case.vehicle.hover() / wrench_scale(case.vehicle)
    generators = case.vehicle.generators() / wrench_scale(case.vehicle)[:, None]
    healthy, sets, joint = planning_sets(case)
    planners = {"rip": Planner(case, healthy, effort)}
    planners |= {f"rcp {name}": Planner(case, facets, effort) for name, facets in sets.items()}
    strictest = f"rcp {next(iter(sets))}"
    if len(sets) > 1:
        strictest = "rcp all"
        planners[strictest] = Planner(case, joint, effort)

    # (b), (c): every fault set lies inside the healthy one, so RIP's infeasible time bounds the others.
    times = {"rip": planners["rip"].shortest(0.0, 20.0)}
    for name in list(planners)[1:]:
        times[name] = planners[name].shortest(times["rip"][0], 1.25 * times["rip"][1])
    # (d), (e): the facets that the RIP plan violates at the common time.
    common = times[strictest][1]
    plan = planners["rip"].plan(common)
    chosen = [
        (normals[beyond], offsets[beyond])
        for normals, offsets in sets.values()
        for beyond in [(excess(plan, (normals, offsets), generators) > VIOLATED).any(axis=0)]
    ]
    # (f)
    rows = [np.concatenate(parts) for parts in zip(healthy, *chosen)]
    selected = intersection([tuple(rows)], hover)
    planners["rsp"] = Planner(case, selected, effort)
    times["rsp"] = planners["rsp"].shortest(times["rip"][0], common)

    result = {"common_time_s": common, "planners": {}}
    for name, planner in planners.items():
        record = {"time_s": times[name][1], "infeasible_at_s": times[name][0]}
        for run, total in (("own", times[name][1]), ("common", common)):
            plan = planner.plan(total)
            record[run] = None if plan is None else describe(plan, case, sets, generators)
        result["planners"][name] = record
    result["effort"] = vars(effort) | {"wall_seconds": time.perf_counter() - begin}
    return result


def describe(plan, case, sets, generators):
    """The figures of Tables 8 to 13 for one plan."""
    stride = case.samples // (len(case.waypoints_m) - 1)
    miss = np.linalg.norm(plan.position[::stride] - case.waypoints_m, axis=1)
    beyond = {name: excess(plan, facets, generators) for name, facets in sets.items()}
    return {
        "objective": plan.objective,
        "position_error_m": miss.sum(),
        "yaw_error_rad": np.abs(plan.yaw[::stride] - case.yaw_rad).sum(),
        "solver_seconds": plan.solver_seconds,
        "violated_facets": {name: int((e > VIOLATED).any(axis=0).sum()) for name, e in beyond.items()},
        "max_violation": {name: max(0.0, e.max()) for name, e in beyond.items()},
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("case", help="a case as JSON, such as cases/case1.json")
    parser.add_argument("--tilt", type=float, metavar="DEG", help="limit the tilt as well")
    parser.add_argument("--json", metavar="FILE", help="write the whole record here")
    options = parser.parse_args()
    case = load(options.case)
    if options.tilt is not None:
        case = type(case)(**(vars(case) | {"tilt_deg": options.tilt}))
    result = compare(case)
    at = f"at {result['common_time_s']:.3f} s"
    print(f"{'planner':10} {'T s':>9} {'e_R m':>8} {'objective':>11} {at:>12}  facets violated there")
    for name, record in result["planners"].items():
        own, common = record["own"], record["common"]
        rest = f"{'infeasible':>12}"
        if common is not None:
            rest = f"{common['objective']:12.6f}  {sum(common['violated_facets'].values())}"
        print(f"{name:10} {record['time_s']:9.4f} {own['position_error_m']:8.4f} {own['objective']:11.6f} {rest}")
    effort = result["effort"]
    print(
        f"{effort['solves']} solves, {effort['iterations']} iterations, {effort['seconds']:.2f} solver seconds,"
        f" {effort['wall_seconds']:.2f} s in all"
    )
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump(result, file, indent=1)
    return 0


if __name__ == "__main__":
    main_with_errors(main)
