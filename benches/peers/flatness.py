"""The exact wrench of a motion and its derivatives, many instants at once.

It starts from the attitude: columns of the rotation as vectors with their time derivatives, body rates from
w_x = z_b . y_b' and so on. There are no angles, and derivatives with respect to the inputs are computed in forward mode, so
this code shares nothing with src/physics/flatness.rs except (3) to (9).
"""

import numpy as np

from case import GRAVITY

INPUTS = 12
# Axis (x, y, z, yaw) and order of each input.
FLAT = [(0, 2), (1, 2), (2, 2), (0, 3), (1, 3), (2, 3), (0, 4), (1, 4), (2, 4), (3, 0), (3, 1), (3, 2)]
ORDERS = np.array([order for _, order in FLAT])


class Dual:
    """A value (N,) for each instant, its gradient (N, 12) and, unless None, its Hessian (N, 12, 12) in the inputs."""

    __array_ufunc__ = None  # so that numpy leaves products with arrays to this class

    def __init__(self, value, slope, bend=None):
        self.value, self.slope, self.bend = value, slope, bend

    def through(self, f, f1, f2):
        """f(self), given f and its first two derivatives at the value."""
        bend = None
        if self.bend is not None:
            square = self.slope[:, :, None] * self.slope[:, None, :]
            bend = f1[:, None, None] * self.bend + f2[:, None, None] * square
        return Dual(f, f1[:, None] * self.slope, bend)

    def __add__(self, other):
        if not isinstance(other, Dual):
            return Dual(self.value + other, self.slope, self.bend)
        bend = None if self.bend is None else self.bend + other.bend
        return Dual(self.value + other.value, self.slope + other.slope, bend)

    def __mul__(self, other):
        if not isinstance(other, Dual):
            return Dual(other * self.value, other * self.slope, None if self.bend is None else other * self.bend)
        a, b = self.value[:, None], other.value[:, None]
        bend = None
        if self.bend is not None:
            cross = self.slope[:, :, None] * other.slope[:, None, :]
            bend = a[:, None] * other.bend + b[:, None] * self.bend + cross + cross.transpose(0, 2, 1)
        return Dual(self.value * other.value, a * other.slope + b * self.slope, bend)

    def __neg__(self):
        return self * -1.0

    def __sub__(self, other):
        return self + -other

    __radd__, __rmul__ = __add__, __mul__


def duals(flat, second):
    """The inputs (N, 12) as variables."""
    n = len(flat)
    zero = np.zeros((n, INPUTS, INPUTS)) if second else None
    return [Dual(flat[:, i], np.tile(np.eye(INPUTS)[i], (n, 1)), zero) for i in range(INPUTS)]


def power(u, p):
    if isinstance(u, Dual):
        v = u.value
        return u.through(v**p, p * v ** (p - 1), p * (p - 1) * v ** (p - 2))
    return u**p


def sin_cos(u):
    if isinstance(u, Dual):
        s, c = np.sin(u.value), np.cos(u.value)
        return u.through(s, c, -s), u.through(c, -s, -c)
    return np.sin(u), np.cos(u)


# A jet is a function of time as [u, u', u''].


def times(u, v):
    return [u[0] * v[0], u[1] * v[0] + u[0] * v[1], u[2] * v[0] + 2.0 * (u[1] * v[1]) + u[0] * v[2]]


def plus(u, v):
    return [a + b for a, b in zip(u, v)]


def minus(u, v):
    return [a - b for a, b in zip(u, v)]


def unit(vector):
    """A vector of jets divided by its length."""
    square = plus(plus(times(vector[0], vector[0]), times(vector[1], vector[1])), times(vector[2], vector[2]))
    u, u1, u2 = square
    f, f1, f2 = power(u, -0.5), -0.5 * power(u, -1.5), 0.75 * power(u, -2.5)
    per_length = [f, f1 * u1, f1 * u2 + f2 * (u1 * u1)]
    return [times(part, per_length) for part in vector]


def cross(u, v):
    return [minus(times(u[i], v[j]), times(u[j], v[i])) for i, j in ((1, 2), (2, 0), (0, 1))]


def along_change(u, v):
    """u . v' and its time derivative, for vectors of jets."""
    rate = u[0][0] * v[0][1] + u[1][0] * v[1][1] + u[2][0] * v[2][1]
    change = sum((u[i][1] * v[i][1] + u[i][0] * v[i][2] for i in (1, 2)), u[0][1] * v[0][1] + u[0][0] * v[0][2])
    return rate, change


def of(vehicle, inputs):
    """[T, tau_x, tau_y, tau_z] in N and N m for twelve inputs, each an array (N,) or a Dual."""
    x2, y2, z2, x3, y3, z3, x4, y4, z4, psi, psi1, psi2 = inputs
    a = [[x2, x3, x4], [y2, y3, y4], [z2 + GRAVITY, z3, z4]]
    s, c = sin_cos(psi)
    sine = [s, c * psi1, c * psi2 - s * (psi1 * psi1)]
    cosine = [c, -(s * psi1), -(s * psi2) - c * (psi1 * psi1)]
    # Body axes: z along the thrust, x across the horizontal left of the heading, y the third.
    z_b = unit(a)
    forward = plus(times(cosine, a[0]), times(sine, a[1]))
    x_b = unit([times(cosine, a[2]), times(sine, a[2]), [-f for f in forward]])
    y_b = cross(z_b, x_b)
    (p, p1), (q, q1), (r, r1) = along_change(z_b, y_b), along_change(x_b, z_b), along_change(y_b, x_b)
    thrust = a[0][0] * z_b[0][0] + a[1][0] * z_b[1][0] + a[2][0] * z_b[2][0]
    ixx, iyy, izz = vehicle.inertia_kg_m2
    return [
        vehicle.mass_kg * thrust,
        ixx * p1 + (izz - iyy) * (q * r),
        iyy * q1 + (ixx - izz) * (r * p),
        izz * r1 + (iyy - ixx) * (p * q),
    ]


def wrench(vehicle, flat):
    """The wrench (N, 4) for inputs (N, 12)."""
    return np.stack(of(vehicle, list(flat.T)), axis=1)


def wrench_and_slope(vehicle, flat):
    """The wrench (N, 4) and its derivatives (N, 4, 12)."""
    w = of(vehicle, duals(flat, second=False))
    return np.stack([part.value for part in w], axis=1), np.stack([part.slope for part in w], axis=1)


def curvature(vehicle, flat, along):
    """(N, 12, 12): second derivatives of along.w, with one `along` (N, 4) for each instant."""
    w = of(vehicle, duals(flat, second=True))
    return sum(along[:, i, None, None] * part.bend for i, part in enumerate(w))
