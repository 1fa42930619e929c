"""A PLAN

A trajectory for RotorPy: World x east, y north, z up; SI units.

    from plan import PlannedTrajectory
    environment = Environment(vehicle=..., controller=..., trajectory=PlannedTrajectory())
"""
import numpy as np

# Ends of the pieces (s), and for each piece the coefficients of x, y, z and yaw in ascending powers of the time since its start.
TIMES, PIECES = [], []  # the plan


class PlannedTrajectory:
    """The plan as flat outputs; before its start and after its end the vehicle rests."""

    def __init__(self):
        self.times = np.array(TIMES)
        # [piece][axis][power]
        self.pieces = np.array(PIECES)
        self.duration = self.times[-1]

    def derivatives(self, t):
        """Derivatives of orders 0 to 4 of x, y, z and yaw at t (s): array [order][axis]."""
        inside = min(max(t, self.times[0]), self.times[-1])
        k = min(int(np.searchsorted(self.times, inside, side="right")) - 1, len(self.pieces) - 1)
        s = inside - self.times[k]
        coefficients = self.pieces[k].T
        found = []
        for _ in range(5):
            value = np.zeros(4)
            for c in coefficients[::-1]:
                value = value * s + c
            found.append(value)
            coefficients = coefficients[1:] * np.arange(1, len(coefficients))[:, None]
        found = np.array(found)
        if t < self.times[0] or t > self.times[-1]:
            found[1:] = 0.0
        return found

    def update(self, t):
        """The flat outputs at t (s), which may be infinite: x, its derivatives to the fourth, yaw and its first two."""
        d = self.derivatives(t)
        return {
            "x": d[0, :3], "x_dot": d[1, :3], "x_ddot": d[2, :3], "x_dddot": d[3, :3], "x_ddddot": d[4, :3],
            "yaw": d[0, 3], "yaw_dot": d[1, 3], "yaw_ddot": d[2, 3],
        }
