#!/usr/bin/env python3
"""A rigid body under a constant body wrench for two seconds, by scipy's DOP853 on a rotation matrix.

Prints the end state with which tests/it/flights/body.rs compares the simulator. Needs any numpy and scipy.
"""

import numpy as np
from scipy.integrate import solve_ivp

MASS = 1.3
INERTIA = np.array([0.021, 0.034, 0.052])
GRAVITY = 9.81
DRAG = 0.25
AIR = np.array([1.5, -0.7, 0.3])
THRUST = 14.0
TORQUE = np.array([0.012, -0.02, 0.009])
POSITION = np.array([0.5, -1.0, 2.0])
VELOCITY = np.array([1.0, 2.0, -0.5])
# Roll, pitch and yaw of (4): R = Rz Ry Rx.
ANGLES = (0.3, -0.2, 0.7)
RATES = np.array([1.2, -0.8, 2.1])
DURATION = 2.0


def rotation(roll, pitch, yaw):
    (cr, cp, cy), (sr, sp, sy) = np.cos([roll, pitch, yaw]), np.sin([roll, pitch, yaw])
    rx = np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    ry = np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
    rz = np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
    return rz @ ry @ rx


def slope(_, state):
    velocity, attitude, rates = state[3:6], state[6:15].reshape(3, 3), state[15:]
    force = attitude @ [0, 0, THRUST] - DRAG * (velocity - AIR) - [0, 0, MASS * GRAVITY]
    p, q, r = rates
    cross = np.array([[0, -r, q], [r, 0, -p], [-q, p, 0]])
    turn = np.linalg.solve(np.diag(INERTIA), TORQUE - cross @ (INERTIA * rates))
    return np.concatenate([velocity, force / MASS, (attitude @ cross).ravel(), turn])


start = np.concatenate([POSITION, VELOCITY, rotation(*ANGLES).ravel(), RATES])
end = solve_ivp(slope, (0, DURATION), start, method="DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
for name, part in [("position", end[:3]), ("velocity", end[3:6]), ("rates", end[15:])]:
    print(name, ", ".join(f"{v:.12f}" for v in part))
for row in end[6:15].reshape(3, 3):
    print("rotation", ", ".join(f"{v:.12f}" for v in row))
