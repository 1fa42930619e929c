"""From wrenches to rotor speeds, written from docs/flight.md, section 3, by other algorithms than mavc's: the least squares by a primal
active set over the rotors (mavc solves the dual by Newton steps), the middle of the torques from the vertices of their polygon (mavc
searches with the facets of the projected zonotope). Wrenches are [T, tau_x, tau_y, tau_z], N and N m; n rotors.
"""

from itertools import combinations, product

import numpy as np

# On the missing part of T, tau_x, tau_y, tau_z.
WEIGHTS = np.array([1e8, 1e10, 1e10, 1e4])


class Allocator:
    """Bounded allocation for the vehicle of a model record, with believed capacities."""

    def __init__(self, vehicle):
        if vehicle["allocation"] != "bounded":
            raise ValueError("only bounded allocation is written here")
        self.max_speed = np.array([rotor["max_speed_rad_per_s"] for rotor in vehicle["rotors"]])
        self.least = np.array([(rotor["min_speed_rad_per_s"] / rotor["max_speed_rad_per_s"]) ** 2 for rotor in vehicle["rotors"]])
        self.full = np.array([wrench_at_full_thrust(rotor) for rotor in vehicle["rotors"]]).T
        self.extent = np.abs(self.full).sum(axis=1)
        self.believe(np.ones(len(self.least)))

    def believe(self, capacity):
        self.capacity = capacity
        self.columns = self.full / self.extent[:, None] * capacity
        self.shares = self.least.copy()

    def speeds(self, wrench):
        """Commanded speeds (rad/s) for a wrench; its yaw torque is at most that of all rotors."""
        wanted = wrench / self.extent
        wanted[3] = min(1.0, max(-1.0, wanted[3]))
        self.shares = bounded(self.columns, wanted, WEIGHTS, self.least, self.shares)
        return self.max_speed * np.sqrt(self.shares)

    def missing(self, wrench):
        """The norm of the part of a wrench that the rotors cannot give, each component as a share of its largest value."""
        wanted = wrench / self.extent
        return np.linalg.norm(wanted - self.columns @ bounded(self.columns, wanted, np.full(4, 1e6), self.least, self.least))

    def keeps_all_axes(self, hover):
        """Whether each torque can change by 1 % of its largest value in both directions about a wrench."""
        changes = [sign * 0.01 * self.extent[axis] * np.eye(4)[axis] for axis in (1, 2, 3) for sign in (1.0, -1.0)]
        return all(self.missing(hover + change) <= 1e-3 for change in changes)

    def middle(self, thrust):
        """The middle of the roll and pitch torques (N m) that are possible at a thrust (N), or 0 if the largest disc about 0 is at least
        half as large as that about the middle, or if the torques lie on a line."""
        polygon = hull(slice_at(self.full[:3] * self.capacity, self.least, thrust))
        if len(polygon) < 3:
            return np.zeros(2)
        centre, radius = largest_disc(polygon)
        return np.zeros(2) if distance_inside(polygon, np.zeros(2)) >= 0.5 * radius else centre


def wrench_at_full_thrust(rotor):
    """A column of A times the full squared speed: F (1, y, -x, -+d/b)."""
    x, y, _ = rotor["position_m"]
    squared = rotor["max_speed_rad_per_s"] ** 2
    thrust, torque = rotor["thrust_coefficient_n_s2_per_rad2"] * squared, rotor["drag_coefficient_n_m_s2_per_rad2"] * squared
    return [thrust, y * thrust, -x * thrust, -torque if rotor["spin"] == "P" else torque]


def bounded(columns, wanted, weights, least, start):
    """The shares x (n) that minimise |x|^2/2 + sum weights (wanted - columns x)^2/2 over least <= x <= 1.

    A primal active set (Stark and Parker, *Bounded-variable least squares*, 1995) from a feasible start: minimise over the free shares;
    stop at the first bound on the way; where none is met, free the share whose gradient points inside most steeply.
    """
    n = columns.shape[1]
    root = np.sqrt(weights)
    matrix = np.vstack([root[:, None] * columns, np.eye(n)])
    right = np.concatenate([root * wanted, np.zeros(n)])
    x = start.copy()
    free = (x > least) & (x < 1.0)
    for _ in range(20 * n):
        if free.any():
            best = x.copy()
            best[free] = np.linalg.lstsq(matrix[:, free], right - matrix[:, ~free] @ x[~free], rcond=None)[0]
            low, high = free & (best < least), free & (best > 1.0)
            if (low | high).any():
                bound = np.where(low, least, 1.0)
                passed = np.flatnonzero(low | high)
                lengths = (bound[passed] - x[passed]) / (best[passed] - x[passed])
                nearest = passed[np.argmin(lengths)]
                x += lengths.min() * (best - x)
                x[nearest], free[nearest] = bound[nearest], False
                continue
            x = best
        gradient = matrix.T @ (matrix @ x - right)
        inward = np.where(free, 0.0, np.where(x <= least, -gradient, gradient))
        steepest = np.argmax(inward)
        if inward[steepest] <= 1e-9 + 1e-12 * np.abs(gradient).max():
            return x
        free[steepest] = True
    raise ArithmeticError("the active set did not settle")


def slice_at(columns, least, thrust):
    """The vertices (k, 2) of the torques at a thrust: all rotors but one at a bound. `columns` (3, n): T, tau_x, tau_y at full thrust."""
    works = [k for k in range(columns.shape[1]) if columns[0, k] > 0.0]
    rest = sum((columns[:, k] * least[k] for k in range(columns.shape[1]) if k not in works), np.zeros(3))
    found = []
    for free in works:
        others = [k for k in works if k != free]
        for at_full in product((False, True), repeat=len(others)):
            wrench = rest + sum((columns[:, k] * (1.0 if full else least[k]) for k, full in zip(others, at_full)), np.zeros(3))
            share = (thrust - wrench[0]) / columns[0, free]
            if least[free] <= share <= 1.0:
                found.append((wrench + share * columns[:, free])[1:])
    return np.array(found)


def hull(points):
    """The corners of the convex hull, counter-clockwise (Andrew's monotone chain); fewer than three if the points lie on a line."""
    if len(points) == 0:
        return points
    size = np.abs(points).max()
    ordered = sorted(set(map(tuple, np.round(points / size, 12))))
    turns = lambda a, b, c: (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    corners = []
    for way in (ordered, ordered[::-1]):
        chain = []
        for point in way:
            while len(chain) > 1 and turns(chain[-2], chain[-1], point) <= 1e-10:
                chain.pop()
            chain.append(point)
        corners += chain[:-1]
    return np.array(corners) * size


def edges(polygon):
    """Normals (k, 2), of length one and outward, and offsets (k) of the edges: normal . x <= offset inside."""
    along = np.roll(polygon, -1, axis=0) - polygon
    normals = np.stack([along[:, 1], -along[:, 0]], axis=1) / np.linalg.norm(along, axis=1)[:, None]
    return normals, np.sum(normals * polygon, axis=1)


def distance_inside(polygon, point):
    """The distance of a point from the nearest edge; negative outside."""
    normals, offsets = edges(polygon)
    return np.min(offsets - normals @ point)


def largest_disc(polygon):
    """Centre and radius of the largest disc inside. Where the centres of the largest discs fill a segment, as between two parallel edges,
    it is the middle of that segment. A disc at an end of the segment, or the only one, touches three edges."""
    normals, offsets = edges(polygon)
    found = []
    for three in combinations(range(len(offsets)), 3):
        matrix = np.column_stack([normals[list(three)], np.ones(3)])
        if abs(np.linalg.det(matrix)) > 1e-9:
            centre = np.linalg.solve(matrix, offsets[list(three)])[:2]
            found.append((distance_inside(polygon, centre), centre))
    radius = max(each[0] for each in found)
    ends = [centre for size, centre in found if size >= radius - 1e-9 * np.abs(polygon).max()]
    apart = max(((a, b) for a in ends for b in ends), key=lambda pair: np.linalg.norm(pair[0] - pair[1]))
    return (apart[0] + apart[1]) / 2, radius
