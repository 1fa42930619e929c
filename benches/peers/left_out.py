"""What mavc's flights leave out, and what it costs: captures in MuJoCo with one effect at a time.

    VENV/bin/python benches/peers/left_out.py target/release/mavc

A vehicle loses rotor 1 in hover, known after 100 ms, and stops on the spot under the controller of flight_controller.py. The effects, none
of which the controller knows:

delay        position, velocity, attitude and rates reach the controller 5 or 10 ms late
spin-down    the lost rotor slows down with a time constant of 0.1 or 0.3 s instead of giving nothing at once
braking      all rotors slow down twice as slowly as they speed up
inflow       thrust falls with the speed of the air along the rotor's axis, and vanishes at the pitch speed (pitch 0.45 diameters)
windmilling  the lost rotor is a disc with a drag coefficient of 1.2 in the air that comes along its axis

Prints a table for docs/flight.md: the height lost, m, and the largest distance from the place in the last 5 of 40 s.
"""

import collections
import copy
import sys
import tempfile
from multiprocessing import Pool
from pathlib import Path

import mujoco_closed
import numpy as np
from flight_reference import Line
from mavc_runs import ROOT, Mavc
from mujoco_closed import HIGH, STRIKES, fly
from mujoco_plant import Body, Plant

DENSITY = 1.225
SECONDS, DELAY = 40.0, 0.1
QUIET = ["simulate.gyroscope_noise=0rad/s", "simulate.position_noise=0m"]
# Name, spec, overrides, radius of the propellers in m.
VEHICLES = [
    ("0.7 kg", ROOT / "tests" / "specs" / "flown" / "hummingbird.mav", ["vehicle.rotor.rotor_inertia=2.5e-5kg*m^2"], 0.1),
    ("1.9 kg", ROOT / "examples" / "parcel_quad.mav", ["vehicle.yaw_drag=5e-3N*m*s/rad"], 0.12),
]
EFFECTS = {
    "none": {},
    "delay of 5 ms": {"delay": 0.005},
    "delay of 10 ms": {"delay": 0.01},
    "spin-down of 0.1 s": {"spin_down": 0.1},
    "spin-down of 0.3 s": {"spin_down": 0.3},
    "braking": {"braking": 2.0},
    "inflow": {"inflow": True},
    "windmilling": {"windmilling": True},
}


class Disturbed(Plant):
    """A plant with one of the effects."""

    def __init__(self, record, xml, effect, radius):
        super().__init__(record, xml)
        self.effect, self.radius = effect, radius
        rotors = record["vehicle"]["rotors"]
        self.places = np.array([rotor["position_m"] for rotor in rotors])
        self.states = collections.deque(maxlen=1 + round(effect.get("delay", 0.0) * record["simulate"]["control_rate_hz"]))

    def body(self):
        """What the controller is given."""
        self.states.append(super().body())
        return self.states[0]

    def true_body(self):
        return super().body()

    def along_axis(self):
        """The speed (m/s) with which each rotor moves along its axis through still air."""
        body = super().body()
        velocity = body.rotation().T @ body.velocity
        return velocity[2] + np.cross(body.rates, self.places)[:, 2]

    def step(self, command):
        lag, capacity, thrust = self.lag, self.capacity, self.thrust_coefficient
        lost = capacity == 0.0
        if "braking" in self.effect:
            self.lag = np.where(command < self.speeds, self.effect["braking"] * lag, lag)
        if "spin_down" in self.effect and lost.any():
            # A rotor without power that slows down still gives the thrust of its speed.
            self.capacity = np.ones(len(lost))
            self.lag = np.where(lost, self.effect["spin_down"], lag)
            command = np.where(lost, 0.0, command)
        if "inflow" in self.effect:
            pitch = 0.45 * 2.0 * self.radius
            speeds = np.maximum(self.speeds, 1.0)
            share = np.clip(1.0 - self.along_axis() / (speeds * pitch / (2.0 * np.pi)), 0.0, 2.0)
            # A negative speed of the air is bounded: below it the rotor is in its own wake.
            self.thrust_coefficient = thrust * np.minimum(share, 1.3)
        self.windmill = 0.5 * DENSITY * 1.2 * np.pi * self.radius**2 * lost if "windmilling" in self.effect else None
        super().step(command)
        self.lag, self.capacity, self.thrust_coefficient = lag, capacity, thrust

    def apply(self, model, data):
        super().apply(model, data)
        if self.windmill is None or not self.windmill.any():
            return
        rotation = data.xmat[1].reshape(3, 3)
        rates, velocity = data.qvel[3:6], rotation.T @ data.qvel[:3]
        through = velocity[2] + np.cross(rates, self.places)[:, 2]
        forces = -self.windmill * through * np.abs(through)
        data.qfrc_applied[:3] += rotation @ [0.0, 0.0, forces.sum()]
        data.qfrc_applied[3:6] += [np.sum(self.places[:, 1] * forces), -np.sum(self.places[:, 0] * forces), 0.0]


def flown(case):
    record, xml, mode, effect, radius = case
    changed = copy.deepcopy(record)
    lasting = {"upside_down_s": SECONDS, "lost_beyond_m": HIGH, "ground_m": 0.0}
    changed["simulate"] |= {"detection_s": DELAY, "after_fault": "hold", "duration_s": SECONDS} | lasting
    mujoco_closed.Plant = lambda record, xml: Disturbed(record, xml, effect, radius)
    flight = fly(changed, xml, Line([0.0, 0.0, HIGH], [0.0, 0.0, 0.0]), SECONDS, mode, STRIKES)
    last = flight.times > flight.times[-1] - 5.0
    away = np.linalg.norm(flight.positions[last] - [0.0, 0.0, HIGH], axis=1).max()
    return flight.outcome, HIGH - flight.positions[:, 2].min(), away


def main():
    mavc, cases = Mavc(sys.argv[1]), []
    with tempfile.TemporaryDirectory() as folder:
        for _, path, overrides, radius in VEHICLES:
            text = path.read_text()
            spec = Path(folder, path.name)
            spec.write_text(text if "simulate {" in text else text + "\nsimulate { }\n")
            record, xml = mavc.model(spec, [*overrides, *QUIET])
            mode = next(each for each in record["modes"] if each["name"] == "L1")
            cases += [(record, xml, mode, effect, radius) for effect in EFFECTS.values()]
    with Pool(2) as pool:
        found = pool.map(flown, cases, chunksize=1)
    print("| effect | " + " | ".join(f"{name}: height lost, away" for name, *_ in VEHICLES) + " |")
    print("|---" * (len(VEHICLES) + 1) + "|")
    for k, effect in enumerate(EFFECTS):
        cells = []
        for v in range(len(VEHICLES)):
            outcome, lost, away = found[v * len(EFFECTS) + k]
            cells.append(f"{lost:.1f} m, {away:.2f} m" if outcome == "flown" and away < 100.0 else "lost")
        print(f"| {effect} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
