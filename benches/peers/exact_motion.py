"""Trajectories of the exact model on an even grid: splines whose coefficients are the variables of a step, and their cost.

x, y and z are quintic and yaw cubic on each interval, with simple knots at the nodes. Time is counted in steps h, so
the mission time enters as powers of h only.
"""

import math
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from numpy.lib.stride_tricks import sliding_window_view
from scipy.interpolate import BSpline

import flatness

PARTS = 16  # instants an interval
DEGREES = [5, 5, 5, 3]
WINDOW = sum(degree + 1 for degree in DEGREES)  # coefficients that an interval depends on


def local(degree, order, shares):
    """(S, degree + 1): derivatives, per step^order, of the B-splines that are nonzero on an interval, at shares of it."""
    basis = BSpline.basis_element(np.arange(degree + 2), extrapolate=False)
    # At share 1 the left piece is used; all derivatives in use are continuous there.
    inside = np.minimum(np.asarray(shares, dtype=float), 1 - 1e-13)[:, None]
    return np.nan_to_num(basis.derivative(order)(inside + np.arange(degree, -1, -1)))


@dataclass(frozen=True)
class Motion:
    """Spline coefficients of x, y, z and yaw, one after the other, and the mission time in s."""

    coefficients: np.ndarray
    total: float


class Grid:
    """`samples` even intervals; waypoints lie on nodes."""

    def __init__(self, case, samples):
        legs = len(case.waypoints_m) - 1
        self.case, self.samples, self.stride = case, samples, samples // legs
        self.first = np.cumsum([0] + [samples + degree for degree in DEGREES])
        self.variables = self.first[-1]
        # windows[k]: the coefficients that interval k depends on.
        parts = [self.first[axis] + np.arange(degree + 1) for axis, degree in enumerate(DEGREES)]
        self.windows = np.concatenate(parts) + np.arange(samples)[:, None]
        shares = np.r_[np.arange(PARTS) / PARTS, 1.0]
        self.inputs = np.zeros((PARTS + 1, flatness.INPUTS, WINDOW))  # flat inputs of a window's coefficients
        for i, (axis, order) in enumerate(flatness.FLAT):
            at = 6 * axis
            self.inputs[:, i, at : at + DEGREES[axis] + 1] = local(DEGREES[axis], order, shares)
        self._cost()

    def instants(self):
        return self.samples * PARTS + 1

    def place(self, instant):
        """The interval and the part of each instant; the last instant is the end of the last interval."""
        interval = np.minimum(instant // PARTS, self.samples - 1)
        return interval, instant - interval * PARTS

    def at(self, axis, order, share, intervals=None):
        """Sparse rows over all coefficients: a derivative at a share of the way through intervals."""
        intervals = np.arange(self.samples) if intervals is None else np.asarray(intervals)
        degree = DEGREES[axis]
        values = np.tile(local(degree, order, [share])[0], len(intervals))
        columns = self.first[axis] + intervals[:, None] + np.arange(degree + 1)
        rows = np.repeat(np.arange(len(intervals)), degree + 1)
        return sp.csr_matrix((values, (rows, columns.ravel())), shape=(len(intervals), self.variables))

    def at_nodes(self, axis, order):
        return sp.vstack([self.at(axis, order, 0.0), self.at(axis, order, 1.0, [self.samples - 1])], format="csr")

    def derivatives(self, motion, order, shares):
        """(intervals, S, 4) in SI units; derivatives of yaw above its input are zero."""
        h = motion.total / self.samples
        found = np.zeros((self.samples, len(shares), 4))
        for axis, degree in enumerate(DEGREES):
            if order < degree:
                windows = sliding_window_view(motion.coefficients[self.first[axis] : self.first[axis + 1]], degree + 1)
                found[:, :, axis] = windows @ local(degree, order, shares).T
        return found / h**order

    def flat(self, motion, parts=PARTS):
        """(intervals * parts + 1, 12): the flat inputs at every instant."""
        shares = np.r_[np.arange(parts) / parts, 1.0]
        orders = [self.derivatives(motion, order, shares) for order in range(5)]
        found = np.stack([orders[order][:, :, axis] for axis, order in flatness.FLAT], axis=2)
        return np.vstack([found[:, :-1].reshape(-1, flatness.INPUTS), found[-1:, -1]])

    def flat_of_windows(self, instants, h):
        """(N, 12, WINDOW): the flat inputs at instants as linear functions of their windows, in SI units."""
        return self.inputs[self.place(instants)[1]] * h ** -flatness.ORDERS[:, None].astype(float)

    def _cost(self):
        """Matrices of (48): integrals over steps by four points of Gauss, exact for these degrees."""
        points, weights = np.polynomial.legendre.leggauss(4)
        shares, weights = (points + 1) / 2, weights / 2

        def integral(axes_and_orders):
            rows = [
                math.sqrt(w) * self.at(axis, order, share)
                for axis, order in axes_and_orders
                for share, w in zip(shares, weights)
            ]
            root = sp.vstack(rows)
            return (root.T @ root).tocsc()

        self.snap = integral([(0, 4), (1, 4), (2, 4)])
        self.acceleration = integral([(2, 2), (3, 2)])
        at = np.arange(0, self.samples + 1, self.stride)
        self.meet = sp.vstack([self.at_nodes(axis, 0)[at] for axis in range(4)], format="csr")
        yaw = np.full(len(at), self.case.yaw_rad)
        self.targets = np.r_[self.case.waypoints_m.T.ravel(), yaw]

    def weights(self, total):
        """The weights of the integrals of squared snap and acceleration and of squared distances, at one mission time."""
        h, w = total / self.samples, self.case.weights
        return w["snap"] * h / h**8, w["acceleration"] * h / h**4, w["waypoint"]

    def cost(self, motion):
        c = motion.coefficients
        snap, acceleration, waypoint = self.weights(motion.total)
        miss = self.meet @ c - self.targets
        return snap * (c @ (self.snap @ c)) + acceleration * (c @ (self.acceleration @ c)) + waypoint * (miss @ miss)

    def nodes(self, motion):
        """(nodes, 5, 4): derivatives of order 0 to 4 at the nodes."""
        both = np.stack([self.derivatives(motion, order, [0.0, 1.0]) for order in range(5)], axis=2)
        return np.vstack([both[:, 0], both[-1:, 1]])

    def finer(self, motion, fine):
        """The same motion on a grid whose nodes include this one's."""
        shares = (np.arange(7) + 0.5) / 7
        parts = []
        repeat = fine.samples // self.samples
        for axis, degree in enumerate(DEGREES):
            mine = slice(self.first[axis], self.first[axis + 1])
            # Both trajectories at the same instants: share s of part p of a coarse interval.
            theirs = sp.vstack([fine.at(axis, 0, s) for s in shares])
            theirs = theirs[:, fine.first[axis] : fine.first[axis + 1]]
            values = []
            for s in shares:
                rows = [self.at(axis, 0, (p + s) / repeat)[:, mine] for p in range(repeat)]
                values.append(np.stack([r @ motion.coefficients[mine] for r in rows]).T.ravel())
            parts.append(np.linalg.lstsq(theirs.toarray(), np.concatenate(values), rcond=None)[0])
        return Motion(np.concatenate(parts), motion.total)


def taylor(nodes, times, shares):
    """(intervals, S, 12): flat inputs at shares of each interval, of a trajectory given at its nodes (nodes, 5, 4). The
    slope of the input is constant between nodes. This function does not use splines, so it works for any plan."""
    steps = np.diff(times)[:, None]
    t = steps * shares
    highest = [4, 4, 4, 2]
    found = np.empty((len(steps), len(shares), flatness.INPUTS))
    for i, (axis, order) in enumerate(flatness.FLAT):
        r = highest[axis]
        slope = (nodes[1:, r, axis] - nodes[:-1, r, axis])[:, None] / steps
        value = slope * t ** (r + 1 - order) / math.factorial(r + 1 - order)
        for j in range(order, r + 1):
            value = value + nodes[:-1, j, axis][:, None] * t ** (j - order) / math.factorial(j - order)
        found[:, :, i] = value
    return found
