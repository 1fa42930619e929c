"""The trajectory of a plan, evaluated from the nodes of mavc's table with a formula of its own."""

import csv
import math

import numpy as np

AXES = ("x", "y", "z", "yaw")
# Columns of the derivatives of each axis, in ascending order.
COLUMNS = {axis: (axis, f"v{axis}", f"a{axis}", f"j{axis}", f"s{axis}") for axis in "xyz"}
COLUMNS["yaw"] = ("yaw", "yaw_rate", "yaw_acc")


def columns(path):
    """A table as arrays by the names of its columns; empty cells are NaN."""
    with open(path) as file:
        rows = list(csv.DictReader(file))
    return {name: np.array([float(row[name]) if row[name] else math.nan for row in rows]) for name in rows[0]}


class Exact:
    """The derivative of order r of each axis is linear between nodes: r = 4 in the exact model, in the hover model 2 for z; 2 for
    yaw."""

    def __init__(self, table, is_hover):
        nodes = columns(table)
        self.times = nodes["t"]
        self.nodes = {axis: np.stack([nodes[name] for name in COLUMNS[axis]]) for axis in AXES}
        self.order = {"x": 4, "y": 4, "z": 2 if is_hover else 4, "yaw": 2}

    def at(self, times, order):
        """Derivatives of an order: array [time][x, y, z, yaw]."""
        times = np.clip(np.asarray(times, dtype=float), self.times[0], self.times[-1])
        k = np.clip(np.searchsorted(self.times, times, side="right") - 1, 0, len(self.times) - 2)
        s, h = times - self.times[k], self.times[k + 1] - self.times[k]
        found = []
        for axis in AXES:
            r, d = self.order[axis], self.nodes[axis]
            terms = [d[j][k] * s ** (j - order) / math.factorial(j - order) for j in range(order, r + 1)]
            slope = (d[r][k + 1] - d[r][k]) / h
            if order <= r + 1:
                terms.append(slope * s ** (r + 1 - order) / math.factorial(r + 1 - order))
            found.append(sum(terms, np.zeros(len(times))))
        return np.stack(found, axis=1)

    def attitude(self, times, gravity):
        """Attitudes from body to world without air, array [time][3][3]: z along the thrust, x in the vertical plane of the yaw, which
        is what ZYX angles say."""
        thrust = self.at(times, 2)[:, :3] + [0, 0, gravity]
        z = thrust / np.linalg.norm(thrust, axis=1)[:, None]
        yaw = self.at(times, 0)[:, 3]
        left = np.stack([-np.sin(yaw), np.cos(yaw), np.zeros(len(yaw))], axis=1)
        x = np.cross(left, z)
        x /= np.linalg.norm(x, axis=1)[:, None]
        return np.stack([x, np.cross(z, x), z], axis=2)

    def rates(self, times, gravity, step=1e-5):
        """Body rates by central differences of the attitude; meaningless within a step of a node whose jerk jumps."""
        before, after = (self.attitude(np.asarray(times) + side * step, gravity) for side in (-1, 1))
        skew = np.einsum("tji,tjk->tik", self.attitude(times, gravity), (after - before) / (2 * step))
        return np.stack([skew[:, 2, 1], skew[:, 0, 2], skew[:, 1, 0]], axis=1)


def rotation(quaternions):
    """Rotation matrices of unit quaternions w, x, y, z, by the sandwich product."""
    w, v = quaternions[:, 0], quaternions[:, 1:]
    out = []
    for unit in np.eye(3):
        cross = 2 * np.cross(v, unit)
        out.append(unit + w[:, None] * cross + np.cross(v, cross))
    return np.stack(out, axis=2)


# From east, north, up to north, east, down, and from forward, left, up to forward, right, down.
NED = np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, -1]])
FRD = np.diag([1.0, -1, -1])


def turned(angle):
    """An angle between -pi and pi."""
    return np.arctan2(np.sin(angle), np.cos(angle))
