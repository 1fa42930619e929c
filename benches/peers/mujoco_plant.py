"""A multirotor in MuJoCo: the plant of mujoco_flights.py.

The rigid body is the model of `mavc emit mjcf`. What that model leaves out is applied here, at every stage of MuJoCo's Runge-Kutta
steps: rotors that follow their commands with a lag, faults, drag and yaw drag, and the momentum of the rotors. The numbers come from
`mavc emit model --format json`. World: x east, y north, z up; body: x forward, y left, z up; SI units.
"""

import mujoco
import numpy as np


class Body:
    """Position (m) and velocity (m/s) in the world, attitude as a quaternion (w, x, y, z), rates (rad/s) in the body; all arrays."""

    def __init__(self, position, velocity, attitude, rates):
        self.position, self.velocity, self.attitude, self.rates = (np.array(x, float) for x in (position, velocity, attitude, rates))

    def rotation(self):
        """The matrix from body to world (3, 3)."""
        w, x, y, z = self.attitude
        return np.array([
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ])

    def tilt(self):
        """Angle between the body's z and the vertical, rad."""
        x, y, z = self.rotation()[:, 2]
        return np.arctan2(np.hypot(x, y), z)


class Plant:
    """The vehicle of a model record with n rotors, flown in steps of the record's `simulate.rate_hz`."""

    def __init__(self, record, xml):
        vehicle, rotors = record["vehicle"], record["vehicle"]["rotors"]
        of_rotors = lambda key: np.array([rotor[key] for rotor in rotors])
        self.thrust_coefficient = of_rotors("thrust_coefficient_n_s2_per_rad2")
        self.lag = of_rotors("time_constant_s")
        self.inertia = of_rotors("inertia_kg_m2") * [1 if rotor["spin"] == "P" else -1 for rotor in rotors]
        self.drag = np.array(record["simulate"]["drag_n_s_per_m"])
        self.wind = np.array(record["simulate"]["wind_m_per_s"])
        yaw_drag = vehicle.get("yaw_drag", {"linear_n_m_s_per_rad": 0.0, "quadratic_n_m_s2_per_rad2": 0.0})
        self.yaw_drag = yaw_drag["linear_n_m_s_per_rad"], yaw_drag["quadratic_n_m_s2_per_rad2"]
        self.capacity = np.ones(len(rotors))
        self.speeds = np.zeros(len(rotors))
        # MuJoCo calls back while it loads a model, too.
        mujoco.set_mjcb_control(None)
        self.model = mujoco.MjModel.from_xml_string(xml)
        self.data = mujoco.MjData(self.model)
        self.step_s = self.model.opt.timestep
        self.stages = []

    def start(self, body, speeds):
        """Puts the vehicle into a state. MuJoCo has one callback, so only the plant that started last may be stepped."""
        self.data.qpos[:] = np.concatenate([body.position, body.attitude])
        self.data.qvel[:] = np.concatenate([body.velocity, body.rates])
        self.speeds = np.array(speeds, float)
        mujoco.set_mjcb_control(self.apply)

    def body(self):
        place, velocity = self.data.qpos, self.data.qvel
        return Body(place[:3], velocity[:3], place[3:7], velocity[3:6])

    def momentum(self):
        """That of the rotors about z, N m s; a lost rotor stands still."""
        return float(np.sum(self.inertia[self.capacity > 0.0] * self.speeds[self.capacity > 0.0]))

    def step(self, command):
        """One step with commanded speeds (rad/s): w' = (command - w)/lag in closed form, thrusts theta b w^2."""
        decay = np.exp(-0.5 * self.step_s / self.lag)
        middle = command + (self.speeds - command) * decay
        end = command + (middle - command) * decay
        works = self.capacity > 0.0
        self.stages = []
        for speeds in (self.speeds, middle, end):
            reaction = -np.sum((self.inertia * (command - speeds) / self.lag)[works])
            momentum = np.sum((self.inertia * speeds)[works])
            self.stages.append((self.capacity * self.thrust_coefficient * speeds**2, momentum, reaction))
        self.begin = self.data.time
        mujoco.mj_step(self.model, self.data)
        self.speeds = end

    def apply(self, _, data):
        """MuJoCo calls this at each stage of a step. The applied forces of a free joint are a force in the world and a torque in the
        body."""
        thrusts, momentum, reaction = self.stages[round(2.0 * (data.time - self.begin) / self.step_s)]
        data.ctrl[:] = thrusts
        through = data.qvel[:3] - self.wind
        if np.all(self.drag == self.drag[0]):
            data.qfrc_applied[:3] = -self.drag[0] * through
        else:
            rotation = data.xmat[1].reshape(3, 3)
            data.qfrc_applied[:3] = -rotation @ (self.drag * (rotation.T @ through))
        p, q, r = data.qvel[3:6]
        linear, quadratic = self.yaw_drag
        data.qfrc_applied[3:6] = [-q * momentum, p * momentum, reaction - linear * r - quadratic * r * abs(r)]
