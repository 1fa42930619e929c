#!/usr/bin/env python3
"""Plans without yaw against linear programs over the thrusts: `without_yaw.py SPEC CERTIFICATE [INSTANTS]`.

At random instants of the certified motion (2000 unless given) and for each mode in `without_yaw` the body has a random heading and a
random rate of the mode's range. Its rotation follows from the thrust's direction; body rates and accelerations are
differences of rotation matrices, the rate about the thrust being held, and roll and pitch torques follow from Euler's equation, for
unequal moments of inertia too. SciPy's `linprog` then seeks thrusts of the rotors that are left which give the
thrust and these torques, and a yaw torque between the drags at the ends of the range, all shrunk about hover by the reserve. The
least violation is in units of the largest thrust and of the largest roll torque. SPEC is a file with literals that uses a ring
vehicle of equal rotors; every mode loses rotors. Nothing of mavc is used. Exits with 1 where a violation exceeds 1e-4.
"""

import json
import re
import sys
from math import factorial, pi
from pathlib import Path

import numpy as np
from scipy.optimize import linprog

GRAVITY = 9.81
H = 1e-4  # step of the differences of rotations, s


def number(text, name, default=None):
    found = re.search(rf"\b{name}\s*=\s*(\[[^\]]*\]|\"[^\"]*\"|[-\d.eE]+)\s*([A-Za-z%]*)", text)
    if not found:
        return default
    value = eval(found[1], {"__builtins__": {}})  # a literal of the spec
    return value if isinstance(value, str) else np.array(value) * {"mm": 1e-3, "cm": 1e-2, "%": 1e-2}.get(found[2], 1.0)


class Vehicle:
    def __init__(self, text):
        layout = number(text, "layout")
        n = len(layout)
        angles = pi / 2 - 2 * pi * np.arange(n) / n  # the first rotor to the left, then clockwise; x forward, y left
        x, y = float(number(text, "arm")) * np.cos(angles), float(number(text, "arm")) * np.sin(angles)
        if number(text, "max_thrust") is not None:
            full, ratio = float(number(text, "max_thrust")), float(number(text, "torque_per_thrust"))
        else:
            b, d, speed = (float(number(text, key)) for key in ("thrust_coefficient", "drag_coefficient", "max_speed"))
            full, ratio = b * speed**2, d / b
        kappa = np.array([-ratio if turn == "P" else ratio for turn in layout])
        self.matrix = np.stack([np.ones(n), y, -x, kappa])
        self.full = np.full(n, full)
        self.mass, self.inertia = float(number(text, "mass")), np.array(number(text, "inertia"), float)
        spread = re.search(r"\byaw_drag\s*=[^\n+]*\+-\s*([\d.]+)\s*%", text)
        # The smallest drag of an interval holds the body to the range, so that larger ones do.
        self.drag = float(number(text, "yaw_drag")) * (1.0 - float(spread[1]) / 100.0 if spread else 1.0)
        self.reserve = float(number(text, "reserve", 0.0))
        self.lost = {name: [int(k) - 1 for k in re.findall(r"\d+", rotors)] for name, rotors in MODE.findall(text)}
        for name in re.findall(r"every 1 rotor lost as (\w+)", text):
            self.lost |= {f"{name}{k + 1}": [k] for k in range(n)}


MODE = re.compile(r"mode\s+(\w+)[^{\n]*\{\s*rotors?\s+(\[[^\]]*\]|\d+)\s+lost")


class Motion:
    """The pieces of a certificate: inputs are linear between nodes, and a piece starts from the derivatives at its left node."""

    def __init__(self, record):
        self.times = np.array(record["times_s"])
        self.axes = {axis: np.array(record[axis]) for axis in "xyz"}

    def derivative(self, axis, order, t):
        k = min(max(np.searchsorted(self.times, t, side="right") - 1, 0), len(self.times) - 2)
        nodes, t0, h = self.axes[axis], self.times[k], self.times[k + 1] - self.times[k]
        top, s = nodes.shape[1] - 1, t - self.times[k]
        slope = (nodes[k + 1][top] - nodes[k][top]) / h
        known = sum(nodes[k][n] * s ** (n - order) / factorial(n - order) for n in range(order, top + 1))
        return known + slope * s ** (top + 1 - order) / factorial(top + 1 - order)

    def thrust(self, t):
        """Thrust over mass, in axes that do not turn."""
        return np.array([self.derivative(axis, 2, t) for axis in "xyz"]) + [0, 0, GRAVITY]


def frame(motion, t, angle=0.0):
    """A rotation matrix whose third column is the direction of the thrust, turned by an angle about it."""
    b3 = motion.thrust(t)
    b3 = b3 / np.linalg.norm(b3)
    b2 = np.cross(b3, [1.0, 0.0, 0.0])
    b2 /= np.linalg.norm(b2)
    b1, (c, s) = np.cross(b2, b3), (np.cos(angle), np.sin(angle))
    return np.stack([c * b1 + s * b2, c * b2 - s * b1, b3], axis=1)


def rates(motion, t, angle=lambda t: 0.0):
    """Body rates by differences of rotation matrices; `angle` is a function of time."""
    change = (frame(motion, t + H, angle(t + H)) - frame(motion, t - H, angle(t - H))) / (2 * H)
    skew = frame(motion, t, angle(t)).T @ change
    return np.array([skew[2, 1], skew[0, 2], skew[1, 0]])


def torques(vehicle, motion, t, heading, spin):
    """Roll and pitch torque of a body that turns at the rate `spin` about its thrust, and this rate as differences show it."""
    before, now, after = (rates(motion, s)[2] for s in (t - H, t, t + H))
    # With the frame's own rate taken off, the rate about the thrust is held to first order.
    angle = lambda s: heading + (spin - now) * (s - t) - (after - before) / (2 * H) * (s - t) ** 2 / 2
    w = rates(motion, t, angle)
    acceleration = (rates(motion, t + 5 * H, angle) - rates(motion, t - 5 * H, angle)) / (10 * H)
    return (vehicle.inertia * acceleration + np.cross(w, vehicle.inertia * w))[:2], w[2]


def least_violation(vehicle, lost, wrench, yaw):
    """The smallest violation with which thrusts give the wrench (T, tau_x, tau_y) and a yaw torque in a range."""
    n = len(vehicle.full)
    scale = np.array([vehicle.full.sum(), *(0.5 * np.abs(vehicle.matrix[1:3]) @ vehicle.full)])
    rows, bounds = [], []
    for row, value, unit in zip(vehicle.matrix[:3], wrench, scale):
        rows += [[*(row / unit), -1.0], [*(-row / unit), -1.0]]
        bounds += [value / unit, -value / unit]
    rows += [[*vehicle.matrix[3], -scale[1]], [*(-vehicle.matrix[3]), -scale[1]]]
    bounds += [yaw[1], -yaw[0]]
    limits = [(0.0, 0.0 if k in lost else full) for k, full in enumerate(vehicle.full)] + [(0.0, None)]
    found = linprog([0.0] * n + [1.0], A_ub=rows, b_ub=bounds, bounds=limits, method="highs")
    return found.fun


def main():
    text = Path(sys.argv[1]).read_text()
    for used in re.findall(r'^use\s+"([^"]+)"', text, re.M):
        text += (Path(sys.argv[1]).parent / used).read_text()
    vehicle = Vehicle(text)
    claim = json.loads(Path(sys.argv[2]).read_text())["claim"]["plan"]
    motion, count = Motion(claim["motion"]), int(sys.argv[3]) if len(sys.argv) > 3 else 2000
    random = np.random.default_rng(7)
    hover = np.array([vehicle.mass * GRAVITY, 0.0, 0.0])
    worst, off = {}, 0.0
    for record in claim["without_yaw"]:
        low, high = record["spin_rad_s"]
        for _ in range(count):
            t = random.uniform(motion.times[0] + 0.01, motion.times[-1] - 0.01)
            heading, spin = random.uniform(0, 2 * pi), random.choice([low, high, random.uniform(low, high)])
            torque, turned = torques(vehicle, motion, t, heading, spin)
            off = max(off, abs(turned - spin))
            wrench = np.array([vehicle.mass * np.linalg.norm(motion.thrust(t)), *torque])
            kept = hover + (wrench - hover) / (1.0 - vehicle.reserve)
            found = least_violation(vehicle, vehicle.lost[record["mode"]], kept, (vehicle.drag * low, vehicle.drag * high))
            worst[record["mode"]] = max(worst.get(record["mode"], -1.0), found)
    for mode, violation in worst.items():
        print(f"{mode}: largest violation {violation:.2e} at {count} instants")
    print(f"rates of the spin met to {off:.1e} rad/s")
    sys.exit(int(max(worst.values()) > 1e-4))


main()
