"""Flights of MuJoCo's plant under the controller of flight_controller.py: the closed loop of mujoco_flights.py.

Nothing of mavc runs in the loop. The order of events in a period is that of docs/flight.md: the state is looked at, the fault becomes
known, the stop begins, the controller acts, the plant steps.
"""

import copy
from typing import NamedTuple

import numpy as np
from flight_controller import Controller
from flight_reference import DESCENT, LANDING_MARGIN, Line, Stop
from mujoco_plant import Body, Plant

# Of `mavc analyze --capture` (docs/flight.md, "Capture").
STRIKES, ENDS, HIGH = 1.0, 20.0, 1e4
SETTLED, SLOW = 2.0, 1.5


class Flown(NamedTuple):
    """A flight: `flown`, `landed` or the cause of the loss, and the state at each act of the controller and at the end."""

    outcome: str
    times: np.ndarray  # (k), s
    positions: np.ndarray  # (k, 3), m
    velocities: np.ndarray  # (k, 3), m/s
    rates: np.ndarray  # (k, 3), body rates, rad/s


class Watch:
    """When a flight ends (docs/flight.md, section 5), without the heading: the controller gives up yaw, or keeps it."""

    def __init__(self, simulate):
        self.simulate, self.period = simulate, 1.0 / simulate["control_rate_hz"]
        self.may_land, self.upside_down_for = False, 0.0

    def look(self, body, reference):
        tilt = body.tilt()
        if body.position[2] <= self.simulate["ground_m"]:
            soft = self.may_land and np.linalg.norm(body.velocity) <= 2.0 and tilt <= 0.5
            return "landed" if soft else "ground"
        if np.linalg.norm(body.position - reference.position) > self.simulate["lost_beyond_m"]:
            return "position"
        self.upside_down_for = self.upside_down_for + self.period if tilt > np.pi / 2 else 0.0
        return "upside_down" if self.upside_down_for > self.simulate["upside_down_s"] else None


def quaternion(matrix):
    """Of a rotation matrix, as (w, x, y, z); less than half a turn."""
    w = np.sqrt(max(0.0, 1.0 + np.trace(matrix))) / 2
    m = matrix
    return np.array([w, (m[2, 1] - m[1, 2]) / (4 * w), (m[0, 2] - m[2, 0]) / (4 * w), (m[1, 0] - m[0, 1]) / (4 * w)])


def fly(record, xml, course, duration, mode=None, at=np.inf):
    """Flies a model record along a course for `duration` s; a fault mode of the record strikes at `at` s."""
    simulate, vehicle = record["simulate"], record["vehicle"]
    drag_rate, wind = vehicle["drag_n_s_per_m"][0] / vehicle["mass_kg"], np.array(simulate["wind_m_per_s"])
    plant, controller, watch = Plant(record, xml), Controller(record), Watch(simulate)
    reference = course.at(0.0)
    rotation, rates = controller.start(reference.in_air(drag_rate, wind))
    body = Body(reference.position, reference.velocity, quaternion(rotation), rates)
    known_at, step, half = at + (simulate["detection_s"] or np.inf), 0, 0.5 / simulate["rate_hz"]
    steps_a_period = round(simulate["rate_hz"] / simulate["control_rate_hz"])
    times, states, is_known, outcome = [], [], False, None
    while True:
        t = step / simulate["rate_hz"]
        reference = course.at(t)
        times.append(t)
        states.append((body.position, body.velocity, body.rates))
        outcome = watch.look(body, reference) or ("flown" if t >= duration - half else None)
        if outcome:
            break
        if not is_known and t + 1e-9 >= known_at:
            controller.learn(mode)
            is_known = True
            if simulate["after_fault"] != "continue":
                course, duration = stopped(course, reference, t, duration, simulate)
                watch.may_land = simulate["after_fault"] == "land"
                reference = course.at(t)
        command = controller.act(body, reference.in_air(drag_rate, wind), plant.momentum())
        if step == 0:
            plant.start(body, command)
        for _ in range(steps_a_period):
            if mode and step / simulate["rate_hz"] + half >= at:
                plant.capacity = np.array(mode["capacity"])
            plant.step(command)
            step += 1
        body = plant.body()
    positions, velocities, rates = (np.array(each) for each in zip(*states))
    return Flown(outcome, np.array(times), positions, velocities, rates)


def stopped(course, reference, t, duration, simulate):
    """The stop after a fault that became known at `t` s, and how long the flight then lasts, s."""
    stop = Stop(reference, t, simulate["after_fault"] == "land", simulate["ground_m"])
    if simulate["after_fault"] == "land":
        height = stop.at(stop.rests).position[2] - simulate["ground_m"]
        return stop, stop.rests + height / DESCENT + LANDING_MARGIN
    return stop, max(duration, simulate["duration_s"] or 0.0, stop.rests + 5.0)


def captured(record, xml, mode, speed, delay, lag):
    """The height (m) lost from a fault until level flight is regained, as `mavc analyze --capture` defines it; None if it is not.
    `lag` is a multiple of the rotors' time constants."""
    changed = copy.deepcopy(record)
    changed["simulate"] |= {"detection_s": delay, "after_fault": "hold", "ground_m": 0.0, "lost_beyond_m": HIGH, "upside_down_s": ENDS}
    for rotor in changed["vehicle"]["rotors"]:
        rotor["time_constant_s"] *= lag
    flown = fly(changed, xml, Line([0.0, 0.0, HIGH], [speed, 0.0, 0.0]), ENDS, mode, STRIKES)
    heights = flown.positions[:, 2]
    is_settled = flown.times[np.argmin(heights)] < flown.times[-1] - SETTLED and np.linalg.norm(flown.velocities[-1]) < SLOW
    return HIGH - heights.min() if flown.outcome == "flown" and is_settled else None
