"""Plans in the exact model by sequential convex programming, with the steps of docs/method/exact-planner.md.

One compiled problem serves all steps and times of a grid. Rows and squares of curvature are parameters in slots; each interval
has a number of slots, whose rows may couple its coefficients. If an interval has too few slots, the problem is compiled again
with more.
"""

import math
import time
import warnings

import cvxpy as cp
import numpy as np
import scipy.sparse as sp
from scipy.ndimage import maximum_filter1d

import flatness
from case import GRAVITY, PeerError
from exact_motion import PARTS, WINDOW, Grid, Motion
from peer_compare import Effort
from peer_sets import wrench_scale

BACK_OFF = 1e-4  # shares of the healthy set's width
NEAR = 0.1
NEGLIGIBLE = 1e-7
UPRIGHT = 0.1  # share of the weight that the thrust's vertical part keeps
LEAST_ACCELERATION = 0.05  # share of gravity
BETWEEN, FINER, BENT, MOST_BENDS = 1e-4, 4, 1.5, 5
RESTORING, MOST_RESTORING, PATIENCE, HOPELESS = 0.1, 8, 2, 1e-2
SETTLING, PENALTY, LEAST_SHARE = 0.03, 2.0, 0.05
MOST_PROXIMITY, LEAST_PROXIMITY = 1e5, 1e-6
ROUGHLY, CLOSELY = (2, 0.03), (12, 2e-3)  # most steps, relative gain that ends them
SLOWER = [1.0, 1.01, 1.03, 1.06, 1.1, 1.15, 1.25, 1.4, 1.7, 2.5]
COARSE, FINE = (0.1, 0.02), (0.04, 0.0025)  # first and least relative step of time
SHRINK, GROW = 0.3, 1.5
TIME_GRID = 0.01  # s


class Steps(Effort):
    """Effort, with the compilations that row generation needs."""

    def __init__(self):
        super().__init__()
        self.compilations = 0
        self.compiling = 0.0


class StepProgram:
    """The convex program of one step, with the given numbers of slots for rows and for squares on each interval."""

    def __init__(self, grid, rows, squares):
        self.grid, self.capacity = grid, (rows, squares)
        case, n = grid.case, grid.samples
        c, sigma = cp.Variable(grid.variables), cp.Variable(nonneg=True)
        self.c, self.sigma = c, sigma

        def slots(counts):
            windows = grid.windows[windows_of(counts)]
            shape, at = (len(windows), grid.variables), np.repeat(np.arange(len(windows)), WINDOW)
            factors = cp.Parameter(shape, sparsity=(at, windows.ravel()))
            factors.value_sparse = sp.coo_array((np.zeros(windows.size), (at, windows.ravel())), shape)
            return factors, factors @ c

        self.rows, value = slots(rows)
        self.free = cp.Parameter(len(windows_of(rows)), value=np.ones(rows.sum()))
        self.slots = value <= self.free + sigma
        constraints = [self.slots, *meet(grid, c)]
        self.squares, bent = slots(squares)
        self.bent_from = cp.Parameter(squares.sum(), value=np.zeros(squares.sum()))
        self.near = cp.Parameter(n + 1, nonneg=True, value=np.ones(n + 1))
        self.near_from = cp.Parameter((3, n + 1), value=np.zeros((3, n + 1)))
        self.turn = cp.Parameter(n + 1, nonneg=True, value=np.ones(n + 1))
        self.turn_from = cp.Parameter(n + 1, value=np.zeros(n + 1))
        objective = 0.5 * cp.sum_squares(bent - self.bent_from)
        for axis in range(3):
            objective += 0.5 * cp.sum_squares(
                cp.multiply(self.near, grid.at_nodes(axis, 2) @ c) - self.near_from[axis]
            )
        objective += 0.5 * cp.sum_squares(cp.multiply(self.turn, grid.at_nodes(3, 0) @ c) - self.turn_from)
        self.weights = [cp.Parameter(nonneg=True, value=1.0) for _ in range(3)]
        self.penalty = cp.Parameter(nonneg=True, value=1.0)
        objective += self.penalty * sigma + cost(grid, c, self.weights)
        self.problem = cp.Problem(cp.Minimize(objective), constraints)


def windows_of(counts):
    """The interval of each slot."""
    return np.repeat(np.arange(len(counts)), counts)


def fill(parameter, factors):
    """Sets a sparse parameter, with one row of factors for each slot."""
    where = parameter.value_sparse.coords
    parameter.value_sparse = sp.coo_array((factors.ravel(), where), parameter.shape)


def meet(grid, c):
    """Waypoints within their tolerance, rest at both ends."""
    case = grid.case
    points = len(case.waypoints_m)
    miss = cp.reshape(grid.meet @ c - grid.targets, (4, points), order="C")
    ends = [0, grid.samples]
    rest = [grid.at_nodes(axis, order)[ends] for axis in range(4) for order in range(1, 4 if axis < 3 else 3)]
    return [
        cp.SOC(case.within_m * np.ones(points), miss[:3], axis=0),
        cp.abs(miss[3]) <= case.yaw_within_rad,
        *[row @ c == 0 for row in rest],
    ]


def cost(grid, c, weights):
    """Cost (48) up to a constant."""
    snap, acceleration, waypoint = weights
    distance = cp.quad_form(c, (grid.meet.T @ grid.meet).tocsc(), assume_PSD=True)
    distance -= 2 * (grid.meet.T @ grid.targets) @ c
    squares = snap * cp.quad_form(c, grid.snap, assume_PSD=True)
    return squares + acceleration * cp.quad_form(c, grid.acceleration, assume_PSD=True) + waypoint * distance


class Successive:
    """One mission against one set (normals, offsets) in scaled wrenches, on one grid."""

    def __init__(self, case, facets, samples, effort):
        if case.tilt_deg is not None:
            raise PeerError("the exact peer knows no limit on tilt")
        self.case, self.facets, self.effort, self.grid = case, facets, effort, Grid(case, samples)
        self.normals, self.offsets = rows_in_widths(case, facets)
        self.back_off = np.clip(-0.5 * (self.normals @ case.vehicle.hover() - self.offsets), 0.0, BACK_OFF)
        self.bends = np.zeros(len(self.offsets))
        self.multipliers = {}
        self.program = None
        self.first_program = None

    # Violations of a trajectory.

    def excesses(self, motion, parts=PARTS):
        """The violations (instants, facets + 1); the last column is that of (68)."""
        flat = self.grid.flat(motion, parts)
        with np.errstate(all="ignore"):
            beyond = flatness.wrench(self.case.vehicle, flat) @ self.normals.T - self.offsets + self.bends
        upright = UPRIGHT - 1.0 - flat[:, 2:3] / GRAVITY
        found = np.hstack([beyond, upright])
        return np.where(np.isnan(found), np.inf, found)

    def excess_by(self, motion, pool):
        """The largest violation at the nodes and in the working set; if there is none, at all instants."""
        excesses = self.excesses(motion)
        known = pool.any(axis=1)
        known[::PARTS] = True
        at_known = excesses[known].max()
        return at_known if at_known > 0 else excesses.max()

    def no_rows(self):
        return np.zeros((self.grid.instants(), len(self.offsets) + 1), dtype=bool)

    def rows_between(self, motion):
        """Each row that is violated inside an interval, at the instant of its largest violation."""
        inner = self.excesses(motion)[:-1].reshape(self.grid.samples, PARTS, -1)[:, 1:]
        worst = inner.argmax(axis=1)
        interval, row = np.nonzero(inner.max(axis=1) > 0)
        found = self.no_rows()
        found[interval * PARTS + 1 + worst[interval, row], row] = True
        return found

    # One program.

    def smooth(self, total):
        """The minimum-snap initial guess: the cheapest trajectory through the waypoints without any set."""
        if self.first_program is None:
            c = cp.Variable(self.grid.variables)
            weights = [cp.Parameter(nonneg=True) for _ in range(3)]
            problem = cp.Problem(cp.Minimize(cost(self.grid, c, weights)), meet(self.grid, c))
            self.first_program = problem, c, weights
        problem, c, weights = self.first_program
        for parameter, value in zip(weights, self.grid.weights(total)):
            parameter.value = value
        return Motion(c.value.copy(), total) if self.solve(problem) else None

    def solve(self, problem):
        begin, before = time.perf_counter(), problem.compilation_time
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # an inaccurate solution is checked like any other
                problem.solve(solver=cp.CLARABEL, max_threads=1, canon_backend=cp.COO_CANON_BACKEND)
        except cp.SolverError:
            return False
        self.effort.add(problem.solver_stats, time.perf_counter() - begin)
        if before is None:
            self.effort.compilations += 1
            self.effort.compiling += problem.compilation_time
        return problem.status == cp.OPTIMAL

    def step(self, motion, pool, *, proximity, penalty, smoothing):
        """Solves the program linearised about an iterate: its coefficients and sigma, or None without a verdict. Rows at nodes
        that the iterate is near to join the working set."""
        grid, h = self.grid, motion.total / self.grid.samples
        excesses = self.excesses(motion)
        pool[::PARTS] |= excesses[::PARTS] > -NEAR
        flat = grid.flat(motion)
        instants, rows = np.nonzero(pool)
        used, where = np.unique(instants, return_inverse=True)
        w, slope = flatness.wrench_and_slope(self.case.vehicle, flat[used])
        # n.(w + slope (d' - d)) <= e - b + sigma, and (68) over 0.9 g.
        facet = rows < len(self.offsets)
        kept = np.append(self.offsets - self.back_off - self.bends, 1 - BACK_OFF)
        normals = np.vstack([self.normals, np.zeros(4)])
        gradient = np.einsum("rj,rji->ri", normals[rows], slope[where])
        gradient[~facet, 2] = -1 / ((1 - UPRIGHT) * GRAVITY)
        constant = np.where(facet, np.einsum("rj,rj->r", normals[rows], w[where]), 0.0)
        constant -= np.where(facet, np.einsum("ri,ri->r", gradient, flat[instants]), 0.0)
        factors = np.einsum("ri,riw->rw", gradient, grid.flat_of_windows(instants, h))
        bent_at, bent_factors, bent_from = self.curvature(flat, h)

        need = [np.bincount(grid.place(at)[0], minlength=grid.samples) for at in (instants, bent_at)]
        program = self.with_slots(need)
        slot = put(grid.place(instants)[0], program.capacity[0])
        fill(program.rows, scattered(factors, slot, program.capacity[0]))
        program.free.value = scattered(kept[rows] - constant, slot, program.capacity[0], 1.0)
        at = put(grid.place(bent_at)[0], program.capacity[1])
        fill(program.squares, scattered(bent_factors, at, program.capacity[1]))
        program.bent_from.value = scattered(bent_from, at, program.capacity[1])
        self.stay_near(program, flat[::PARTS], h, proximity)
        relative = smoothing / max(grid.cost(motion), np.finfo(float).tiny)
        for parameter, weight in zip(program.weights, grid.weights(motion.total)):
            parameter.value = relative * weight
        program.penalty.value = penalty
        if not self.solve(program.problem):
            return None
        found = np.maximum(program.slots.dual_value[slot], 0.0)
        counts = facet & (found > NEGLIGIBLE)
        self.multipliers = {}
        for instant, row, y in zip(instants[counts], rows[counts], found[counts]):
            self.multipliers[instant] = self.multipliers.get(instant, 0.0) + y * self.normals[row]
        return program.c.value.copy(), max(float(program.sigma.value), 0.0)

    def with_slots(self, need):
        """The compiled problem if it has enough slots, else a new one with some to spare."""
        if self.program is None or any((n > c).any() for n, c in zip(need, self.program.capacity)):
            before = self.program.capacity if self.program else [np.full(self.grid.samples, 2)] * 2
            # Binding rows also enter the neighbouring intervals.
            wider = [np.maximum(c, 2 * maximum_filter1d(n, 7) + 2) for n, c in zip(need, before)]
            self.program = StepProgram(self.grid, *wider)
        return self.program

    def stay_near(self, program, flat, h, proximity):
        x2, y2, z2, psi = flat[:, 0], flat[:, 1], flat[:, 2], flat[:, 9]
        forward = np.cos(psi) * x2 + np.sin(psi) * y2
        length = np.maximum(np.hypot(forward, z2 + GRAVITY), LEAST_ACCELERATION * GRAVITY)
        share = np.full(len(flat), 1 / self.grid.samples)
        share[[0, -1]] *= 0.5
        root = np.sqrt(proximity * share)
        program.near.value = root / length / h**2
        program.near_from.value = root / length * flat[:, :3].T
        program.turn.value = root
        program.turn_from.value = root * psi

    def curvature(self, flat, h):
        """Squares |factor . (d' - d)|^2 / 2 of the convex part of the Lagrangian: instants, factors by window, constants."""
        at = np.array(sorted(self.multipliers), dtype=int)
        if not len(at):
            return at, np.zeros((0, WINDOW)), np.zeros(0)
        along = np.stack([self.multipliers[i] for i in at])
        tau = 4 * h
        scale = np.array([GRAVITY * tau ** (2 - o) if axis < 3 else tau**-o for axis, o in flatness.FLAT])
        bent = flatness.curvature(self.case.vehicle, flat[at], along) * scale[:, None] * scale
        values, vectors = np.linalg.eigh(bent)
        upward = values > 1e-3 * np.abs(values).max(axis=1, keepdims=True)
        place, which = np.nonzero(upward)
        factors = vectors[place, :, which] * np.sqrt(values[place, which])[:, None] / scale
        instants = at[place]
        by_window = np.einsum("ri,riw->rw", factors, self.grid.flat_of_windows(instants, h))
        return instants, by_window, np.einsum("ri,ri->r", factors, flat[instants])

    # Sequences of steps at one time.

    def restore(self, motion, pool):
        """The feasibility phase: steps that reduce the violation; a trajectory without violation at all instants, or None."""
        proximity, history = RESTORING, []
        self.multipliers = {}
        excess = self.excess_by(motion, pool)
        while excess > 0:
            history.append(excess)
            stuck = len(history) > PATIENCE and excess > 0.5 * history[-1 - PATIENCE]
            if len(history) > MOST_RESTORING or stuck or proximity > MOST_PROXIMITY:
                return None
            pool |= self.rows_between(motion)
            excess = self.excess_by(motion, pool)
            stepped = self.step(motion, pool, proximity=proximity, penalty=1.0, smoothing=0.0)
            if stepped is None or stepped[1] > HOPELESS:
                return None
            coefficients, sigma = stepped
            share = 1.0
            while True:
                reached = towards(motion, coefficients, share)
                now = self.excess_by(reached, pool)
                if now <= excess - 0.2 * share * (excess - sigma) or share < 2 * LEAST_SHARE:
                    break
                share *= 0.5
            if share < 0.5:
                proximity *= 4
            if now < excess:
                motion, excess = reached, now
        pool &= self.excesses(motion) > -NEAR
        return motion

    def settle(self, motion, care, pool):
        """The cost phase: steps that reduce the cost; the cheapest trajectory without violation that was met."""
        proximity, penalty = SETTLING, PENALTY
        best, cheapest = motion, self.grid.cost(motion)
        at, excess = motion, 0.0
        for _ in range(care[0]):
            here = self.grid.cost(at)
            stepped = self.step(at, pool, proximity=proximity, penalty=penalty, smoothing=1.0)
            if stepped is None:
                break
            coefficients, sigma = stepped[0], stepped[1] - BACK_OFF
            if sigma > 0:
                penalty *= 4

            def merit(value, beyond):
                return value / here + penalty * max(beyond, 0.0)

            was = merit(here, excess)
            expected = was - merit(self.grid.cost(Motion(coefficients, at.total)), sigma)
            if expected <= 0 and sigma <= 0:
                break
            share = 1.0
            while True:
                reached = towards(at, coefficients, share)
                value, now = self.grid.cost(reached), self.excess_by(reached, pool)
                if was - merit(value, now) >= 0.3 * share * expected or share <= LEAST_SHARE:
                    break
                share *= 0.5
            gained = was - merit(value, now)
            if now <= 0 and value < cheapest:
                best, cheapest = reached, value
            pool |= self.rows_between(reached)
            if expected <= 0 or gained < 0.3 * expected:
                proximity *= 4
            elif gained > 0.7 * expected:
                proximity = max(0.25 * proximity, LEAST_PROXIMITY)
            if gained > 0:
                at, excess = reached, self.excess_by(reached, pool)
            if (expected < care[1] and excess <= 0) or proximity > MOST_PROXIMITY:
                break
        return best

    def kept(self, motion, care, pool):
        """The cost phase, with tightened rows for those violated between the instants; None if this does not converge."""
        motion = self.settle(motion, care, pool)
        for _ in range(MOST_BENDS):
            over = self.excesses(motion, PARTS * FINER)[:, :-1].max(axis=0) - self.bends
            if over.max() <= BETWEEN:
                return motion
            self.bends += BENT * np.maximum(over, 0.0)
            restored = self.restore(motion, pool)
            if restored is None:
                return None
            motion = self.settle(restored, care, pool)
        return None

    # Times.

    def timed(self, motion):
        """The trajectory at about the shortest time without violation at the nodes."""

        def inside(factor):
            return self.excesses(slower(motion, factor), 1).max() <= 0

        low, high = 0.0, 1.0
        while not inside(high):
            low, high = high, 1.5 * high
            if high > 1e4:
                return None
        while low == 0.0 or high - low > 1e-4 * high:
            middle = 0.7 * high if low == 0.0 else (low + high) / 2
            low, high = (low, middle) if inside(middle) else (middle, high)
        return slower(motion, high)

    def restore_slower(self, motion, pool):
        for factor in SLOWER:
            known = pool.copy()
            restored = self.restore(slower(motion, factor), known)
            if restored is not None:
                pool[:] = known
                return self.settle(restored, ROUGHLY, pool)
        return None

    def descend(self, motion, steps, target, pool):
        step, least = steps
        while step >= least and motion.total > target * (1 + 1e-12):
            known = pool.copy()
            restored = self.restore(slower(motion, max(1 - step, target / motion.total)), known)
            if restored is None:
                step *= SHRINK
                continue
            pool[:] = known
            motion = self.settle(restored, ROUGHLY, pool)
            step = min(GROW * step, steps[0])
        return motion

    def first(self, near):
        """A first trajectory inside the set, about as fast as `near`, found on a coarse grid."""
        legs = len(self.case.waypoints_m) - 1
        coarse = max(5 * legs, 60)
        if self.grid.samples % coarse:
            raise PeerError(f"{self.grid.samples} samples are no multiple of the coarse grid's {coarse}")
        finder = Successive(self.case, self.facets, coarse, self.effort)
        motion = finder.smooth(max(guess(self.case), near))
        motion = motion and finder.timed(motion)
        if motion is None:
            return None
        pool = finder.no_rows()
        motion = finder.restore_slower(slower(motion, max(1.0, near / motion.total)), pool)
        if motion is None:
            return None
        motion = finder.descend(motion, COARSE, near, pool)
        self.multipliers = {}
        return self.restore_slower(finder.grid.finer(motion, self.grid), self.no_rows())

    def plan(self, total):
        """A plan at one mission time, or None."""
        pool = self.no_rows()
        smooth = self.smooth(total)
        inside = smooth and self.restore(smooth, pool)
        found = inside and self.kept(inside, CLOSELY, pool)
        if found is not None:
            return found
        motion = self.first(total)
        if motion is None:
            return None
        if motion.total <= total:
            motion = self.restore(slower(motion, total / motion.total), pool)
        else:
            motion = self.descend(motion, FINE, total, pool)
        if motion is None or abs(motion.total - total) > 1e-9 * total:
            return None
        return self.kept(motion, CLOSELY, pool)

    def shortest(self):
        """The shortest time found and the plan there."""
        pool = self.no_rows()
        motion = self.first(0.0)
        if motion is None:
            return None
        motion = self.descend(motion, FINE, 0.0, pool)
        ticks = math.ceil(motion.total / TIME_GRID - 1e-6)
        for late in (0, 1, 2, 4, 8, 16):
            inside = self.restore(slower(motion, (ticks + late) * TIME_GRID / motion.total), pool)
            found = inside and self.kept(inside, CLOSELY, pool)
            if found is not None:
                return found
        return None




def put(intervals, capacity):
    """The slot of each entry; entries are in the order of their intervals."""
    begin = np.cumsum(capacity) - capacity
    first = np.searchsorted(intervals, intervals)
    return begin[intervals] + np.arange(len(intervals)) - first


def scattered(values, slots, capacity, empty=0.0):
    found = np.full((capacity.sum(), *values.shape[1:]), empty)
    found[slots] = values
    return found


def slower(motion, factor):
    return Motion(motion.coefficients, factor * motion.total)


def towards(motion, coefficients, share):
    return Motion(motion.coefficients + share * (coefficients - motion.coefficients), motion.total)


def guess(case):
    """An initial guess of the time: each leg accelerates at half of gravity for one half and brakes for the other."""
    lengths = np.linalg.norm(np.diff(case.waypoints_m, axis=0), axis=1)
    return max((2 * np.sqrt(lengths / (0.5 * GRAVITY))).sum(), 1.0)


def rows_in_widths(case, facets):
    """Normals (N, 4) for wrenches in N and N m, and offsets, over the healthy set's widths."""
    normals, offsets = facets
    plain = normals / wrench_scale(case.vehicle)
    width = np.abs(plain @ case.vehicle.generators()).sum(axis=1)
    return plain / width[:, None], offsets / width
