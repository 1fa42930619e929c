"""A vehicle without yaw that follows a motion: its spin is integrated, with the yaw torque inside the fault's set that slows it most.

Thrust and the rates at which its direction turns are those of the motion; the heading and the spin about the thrust are the vehicle's. At
each step Euler's equations give the roll and pitch torques that the motion needs at this heading and spin. Where the set has no wrench
with this thrust and these torques, whatever the yaw torque, the vehicle is lost. Nothing of mavc's rows without yaw is used.
"""

import numpy as np

STEP = 2e-3  # s


def demands(vehicle, motion, t, exact):
    """Thrust, p, q, r and the derivatives of p and q (m, 6) of a motion whose heading is its own yaw."""
    if exact:
        return vehicle.turning(motion, t)
    x, y, z, yaw = motion.at(t)
    g = vehicle.gravity
    return np.column_stack([vehicle.mass * (z[:, 2] + g), -y[:, 3] / g, x[:, 3] / g, yaw[:, 1], -y[:, 4] / g, x[:, 4] / g])


def follow(vehicle, mode, branches, plan, exact, drags):
    """How far outside the set of a mode, and outside the set less the reserve, branches and the plan after them are: two arrays (n,).

    In shares of the healthy widths. `branches` has the motion of each, and the time of the plan at which it begins, s. `drags` are linear
    and quadratic drags of yaw; the worst of them counts.
    """
    jx, jy, jz = vehicle.inertia
    normals, limits, widths, whole = vehicle.rows[mode]
    along, across = normals[:, :3], normals[:, 3]
    steps = [max(1, round((plan.duration - begins) / STEP)) for _, begins in branches]
    most = max([*steps, *(int(np.ceil(motion.duration / STEP)) for motion, _ in branches)])
    need = np.zeros((most, len(branches), 6))
    first = np.zeros(len(branches), int)
    for k, (motion, begins) in enumerate(branches):
        own = max(steps[k], int(np.ceil(motion.duration / STEP)))
        t = STEP * np.arange(own)
        here = t < motion.duration
        need[most - own :, k] = np.vstack([demands(vehicle, motion, t[here], exact), demands(vehicle, plan, begins + t[~here], exact)])
        first[k] = most - own
    over, into_reserve = np.full((2, len(branches)), -np.inf)
    for linear, quadratic in drags:
        spin, turned = need[first, np.arange(len(branches)), 3], np.zeros(len(branches))
        for step in range(most):
            flying = step >= first
            thrust, p, q, r, dp, dq = need[step].T
            # In a body that is turned further than the motion's own heading, and spins at another rate.
            away = np.exp(-1j * turned)
            rate = (p + 1j * q) * away
            change = (dp + 1j * dq) * away - 1j * (spin - r) * rate
            p, q = rate.real, rate.imag
            roll = jx * change.real + (jz - jy) * q * spin
            pitch = jy * change.imag + (jx - jz) * p * spin
            slows = (linear + quadratic * np.abs(spin) - jz / STEP) * spin - (jx - jy) * p * q
            used = np.column_stack([thrust, roll, pitch]) @ along.T
            low, high = yaw_torques(limits - used, across)
            # Into the reserve only where nothing else is left.
            yaw = np.where(low > high, np.clip(0.5 * (low + high), *yaw_torques(whole - used, across)), np.clip(slows, low, high))
            used += yaw[:, None] * across
            over, into_reserve = (
                np.where(flying, np.maximum(most_yet, ((used - offsets) / widths).max(axis=1)), most_yet)
                for most_yet, offsets in ((over, whole), (into_reserve, limits))
            )
            drag = (linear + quadratic * np.abs(spin)) * spin
            turned = np.where(flying, turned + STEP * (spin - r), turned)
            spin = np.where(flying, spin + STEP / jz * (yaw - drag + (jx - jy) * p * q), spin)
    return over, into_reserve


def yaw_torques(room, across):
    """The least and the largest yaw torque (n,) for which no row is violated; the least is larger where there is none."""
    bound = room / np.where(np.abs(across) > 1e-9, across, np.nan)
    return np.fmax.reduce(np.where(across < 0, bound, -np.inf), axis=1), np.fmin.reduce(np.where(across > 0, bound, np.inf), axis=1)
