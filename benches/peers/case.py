"""A planning case for the peers: one vehicle, its fault modes, one mission with evenly timed waypoints."""

import json
import sys
from dataclasses import dataclass

import numpy as np

GRAVITY = 9.81  # m/s^2


class PeerError(Exception):
    """A mistake that the user can fix; shown without a traceback."""


@dataclass(frozen=True)
class Vehicle:
    """A ring of rotors: the first on +y, the rest clockwise seen from above; P spins counter-clockwise."""

    layout: str
    arm_m: float
    mass_kg: float
    inertia_kg_m2: list
    thrust_coefficient: float
    drag_coefficient: float
    max_speed_rad_s: float

    def __post_init__(self):
        if len(self.layout) < 4 or set(self.layout) - set("PN"):
            raise PeerError(f"layout {self.layout!r}: at least four letters, each P or N")
        if len(self.inertia_kg_m2) != 3:
            raise PeerError("inertia_kg_m2: three moments")

    def generators(self):
        """(4, n): the wrench [T, tau_x, tau_y, tau_z] of each rotor at full speed, N and N m."""
        angle = 2 * np.pi * np.arange(len(self.layout)) / len(self.layout)
        spin = np.where(np.array(list(self.layout)) == "P", -1.0, 1.0)
        b, d, arm = self.thrust_coefficient, self.drag_coefficient, self.arm_m
        unit = np.array([np.full_like(angle, b), b * arm * np.cos(angle), -b * arm * np.sin(angle), d * spin])
        return unit * self.max_speed_rad_s**2

    def hover(self):
        """(4,): the wrench that carries the weight."""
        return np.array([self.mass_kg * GRAVITY, 0.0, 0.0, 0.0])


@dataclass(frozen=True)
class Case:
    """The input of steps (a) to (f); names include units."""

    vehicle: Vehicle
    modes: dict  # name -> lost rotors, counted from 1
    waypoints_m: np.ndarray  # (W, 3)
    within_m: float
    yaw_rad: float
    yaw_within_rad: float
    samples: int
    reserve: float
    tilt_deg: float | None
    weights: dict

    def __post_init__(self):
        if self.waypoints_m.ndim != 2 or self.waypoints_m.shape[1] != 3 or len(self.waypoints_m) < 2:
            raise PeerError("waypoints_m: at least two points of three coordinates")
        if set(self.weights) != {"snap", "acceleration", "waypoint"}:
            raise PeerError("weights: snap, acceleration and waypoint")
        legs = len(self.waypoints_m) - 1
        if self.samples < legs or self.samples % legs:
            raise PeerError(f"samples = {self.samples} is no multiple of the {legs} legs")
        if not self.modes:
            raise PeerError("modes: at least one fault mode")
        for name, lost in self.modes.items():
            if not lost or any(not 1 <= k <= len(self.vehicle.layout) for k in lost):
                raise PeerError(f"mode {name}: rotors count from 1 to {len(self.vehicle.layout)}")


def load(path):
    """Reads a case from a JSON file; the README describes its fields."""
    try:
        with open(path, encoding="utf-8") as file:
            fields = json.load(file)
        fields["vehicle"] = Vehicle(**fields["vehicle"])
        fields["waypoints_m"] = np.array(fields["waypoints_m"], dtype=float)
        return Case(**fields)
    except OSError as error:
        raise PeerError(f"cannot read {path}: {error.strerror}") from error
    except PeerError as error:
        raise PeerError(f"{path}: {error}") from error
    except (ValueError, TypeError, KeyError) as error:
        raise PeerError(f"{path} is no planning case: {error!r}") from error


def main_with_errors(main):
    """Runs a script's main; a PeerError becomes one line and exit code 2."""
    try:
        raise SystemExit(main())
    except PeerError as error:
        print(f"error: {error}", file=sys.stderr)
        raise SystemExit(2) from None
