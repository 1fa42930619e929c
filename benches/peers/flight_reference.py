"""What a flight follows, written from docs/flight.md, section 5: a plan, a straight line, or a stop with a descent after it.

A reference is a `Reference`; courses have a method `at(t)`, t in s since the start.
"""

import csv
from typing import NamedTuple

import numpy as np

BRAKING = 3.0  # m/s^2
SHORTEST = 1.5  # s
DESCENT = 1.0  # m/s
EASING = 2.0  # s, from rest to the speed of a descent
LANDING_MARGIN = 20.0  # s, for a landing in addition to its descent


class Reference(NamedTuple):
    """Position and its derivatives up to snap in the world (m, s), each an array of three; yaw and two derivatives (rad, s)."""

    position: np.ndarray
    velocity: np.ndarray
    acceleration: np.ndarray
    jerk: np.ndarray
    snap: np.ndarray
    yaw: tuple

    def in_air(self, rate, wind):
        """With the accelerations, jerks and snaps of the thrust over mass, less gravity, for a drag over mass `rate` (1/s) that is the
        same along all axes: c = a + g e_z + rate (v - wind)."""
        if rate == 0.0:
            return self
        acceleration = self.acceleration + rate * (self.velocity - wind)
        jerk = self.jerk + rate * self.acceleration
        return self._replace(acceleration=acceleration, jerk=jerk, snap=self.snap + rate * self.jerk)


class Line:
    """From a position (m) at a constant velocity (m/s), without a turn."""

    def __init__(self, position, velocity):
        self.position, self.velocity = np.array(position, float), np.array(velocity, float)

    def at(self, t):
        zero = np.zeros(3)
        return Reference(self.position + self.velocity * t, self.velocity, zero, zero, zero, (0.0, 0.0, 0.0))


class Plan:
    """The table of `mavc plan -o FILE --rate RATE`, read at its own instants alone; after its end its last position, at rest."""

    def __init__(self, path, rate):
        with open(path) as file:
            self.rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        self.rate = rate
        self.duration = self.rows[-1]["t"]

    def at(self, t):
        k = round(t * self.rate)
        row = self.rows[min(k, len(self.rows) - 1)]
        of = lambda prefix: np.array([row[prefix + axis] for axis in "xyz"])
        if k >= len(self.rows):
            zero = np.zeros(3)
            return Reference(of(""), zero, zero, zero, zero, (row["yaw"], 0.0, 0.0))
        return Reference(of(""), of("v"), of("a"), of("j"), of("s"), (row["yaw"], row["yaw_rate"], row["yaw_acc"]))


class Stop:
    """A stop that continues a reference from `begin` (s) on, above a ground (m), then hover, or a descent if `descends`."""

    def __init__(self, reference, begin, descends, ground):
        self.begin, self.descends = begin, descends
        state = np.array([reference.velocity, reference.acceleration, reference.jerk]).T
        fastest, hardest = np.linalg.norm(reference.velocity), np.linalg.norm(reference.acceleration)
        longest = max(SHORTEST, 1.875 * fastest / BRAKING, hardest / BRAKING)
        gentle = 1.1 * max(BRAKING, hardest)
        peak, axes = gentlest(reference.position, state, longest, gentle)
        if peak > gentle:
            stepped = gentlest(reference.position, state * [1.0, 1.0, 0.0], longest, gentle)
            if stepped[0] < peak:
                axes = stepped[1]
        psi, rate, acceleration = reference.yaw
        self.axes = [axes[0], axes[1], above(axes[2], ground), Fade(psi, [rate, acceleration, 0.0], SHORTEST)]
        self.rests = begin + max(axis.duration for axis in self.axes)

    def at(self, t):
        x, y, z, yaw = (axis.at(t - self.begin) for axis in self.axes)
        position, velocity, acceleration, jerk, snap = (np.array(order) for order in zip(x, y, z))
        down = t - self.rests
        if self.descends and down > 0.0:
            # The speed of the descent is DESCENT (3 u^2 - 2 u^3) with u = t/EASING up to u = 1.
            u = min(1.0, down / EASING)
            position[2] -= DESCENT * (EASING * (u**3 - u**4 / 2) + max(0.0, down - EASING))
            velocity[2] -= DESCENT * (3 * u**2 - 2 * u**3)
            acceleration[2] -= DESCENT * (6 * u - 6 * u**2) / EASING
            if u < 1.0:
                jerk[2] -= DESCENT * (6 - 12 * u) / EASING**2
                snap[2] += DESCENT * 12 / EASING**3
        return Reference(position, velocity, acceleration, jerk, snap, tuple(yaw[:3]))


class Fade:
    """One coordinate whose velocity fades to zero within `duration` s, along the polynomial of degree five that has the given velocity,
    acceleration and jerk at the start and is zero with two derivatives at the end."""

    def __init__(self, start, begins, duration):
        self.start, self.begins, self.duration = start, begins, duration
        velocity, acceleration, jerk = begins
        # In s = t/duration the quintic v with v, v', v'' at 0 and nothing at 1 is a sum of three Hermite polynomials.
        s = np.polynomial.Polynomial([0.0, 1.0])
        rising = velocity * (1 + 3 * s + 6 * s**2) + acceleration * duration * s * (1 + 3 * s) + jerk * duration**2 * s**2 / 2
        shape = (1 - s) ** 3 * rising
        self.orders = [start + duration * shape.integ()]
        self.orders += [shape.deriv(k) / duration**k if k else shape for k in range(4)]
        self.coefficients = [order.coef for order in self.orders]

    def at(self, t):
        """The coordinate and its first four derivatives; at rest after the end."""
        if t > self.duration:
            return [evaluated(self.coefficients[0], 1.0), 0.0, 0.0, 0.0, 0.0]
        return [evaluated(coefficients, max(0.0, t) / self.duration) for coefficients in self.coefficients]

    def samples(self, order):
        """One derivative at 201 instants."""
        return self.orders[order](np.linspace(0.0, 1.0, 201))


def evaluated(coefficients, s):
    value = 0.0
    for coefficient in coefficients[::-1]:
        value = value * s + float(coefficient)
    return value


def durations(longest, least):
    while longest >= least:
        yield longest
        longest *= 0.95


def gentlest(position, state, longest, gentle):
    """The longest stop whose largest acceleration is at most `gentle` (m/s^2), or that with the smallest; with its largest one."""
    best = (np.inf, None)
    for duration in durations(longest, SHORTEST):
        axes = [Fade(position[k], state[k], duration) for k in range(3)]
        peak = np.sqrt(sum(axis.samples(2) ** 2 for axis in axes)).max()
        if peak < best[0]:
            best = (peak, axes)
        if peak <= gentle:
            break
    return best


def above(fade, ground):
    """The fade, or the longest shorter one that uses at most three quarters of the height above the ground, if there is one."""
    floor = ground + 0.25 * (fade.start - ground)
    if fade.start <= ground or fade.samples(0).min() >= floor:
        return fade
    shorter = (Fade(fade.start, fade.begins, duration) for duration in durations(fade.duration, 0.1))
    return next((one for one in shorter if one.samples(0).min() >= floor), fade)
