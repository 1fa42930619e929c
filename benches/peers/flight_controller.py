"""The controllers of docs/flight.md, section 2, in numpy: geometric tracking on SE(3), and control without yaw after a fault.

Written from the document, to fly MuJoCo's plant instead of mavc's. Sensors are ideal but for the range of the gyroscope, and a fault is
known exactly after its delay. Vectors are arrays of three in SI units, R goes from body to world, primes are time derivatives.
"""

import numpy as np
from flight_allocation import Allocator

SLOWER_ONE_SIDED = 0.45
MOST_FEEDBACK = 0.5  # of g
MOST_TILT = 0.45  # tangent of the angle between the primary axis and z
LEAST_SHARE = 0.3  # of the gyroscopic terms without the momentum of the rotors
SLOW = 0.5  # rad/s: below this rate of spin the primary axis is z


def cross(a, b):
    """a x b; numpy's own is slow for single vectors."""
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def norm(a):
    return float(np.sqrt(a @ a))


def direction(v, v1, v2):
    """v/|v| with two derivatives, from v and two derivatives."""
    n = norm(v)
    u = v / n
    n1 = u @ v1
    u1 = (v1 - n1 * u) / n
    n2 = u1 @ v1 + u @ v2
    return u, u1, (v2 - n2 * u - 2 * n1 * u1) / n


def products(a, b):
    """a x b with two derivatives."""
    return cross(a[0], b[0]), cross(a[1], b[0]) + cross(a[0], b[1]), cross(a[2], b[0]) + 2 * cross(a[1], b[1]) + cross(a[0], b[2])


def desired_frame(b3, yaw):
    """R_d with the third column b3 and the nose along the yaw seen from above, its rates w_d and w_d', from two derivatives of both."""
    psi, psi1, psi2 = yaw
    heading, left = np.array([np.cos(psi), np.sin(psi), 0.0]), np.array([-np.sin(psi), np.cos(psi), 0.0])
    ahead = products((left, -psi1 * heading, -psi2 * heading - psi1**2 * left), b3)
    # Where the thrust points to the left or right of the yaw, any nose across it will do.
    b1 = direction(*ahead) if norm(ahead[0]) > 1e-6 else (heading, np.zeros(3), np.zeros(3))
    b2 = products(b3, b1)
    r, r1, r2 = (np.column_stack([b1[k], b2[k], b3[k]]) for k in range(3))
    rates = vee(r.T @ r1)
    # R'' = R (w'^ + w^ w^), and w^ w^ is symmetric.
    return r, rates, vee(r.T @ r2)


def vee(m):
    """The vector of the skew part of a matrix."""
    return np.array([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]]) / 2


class Controller:
    """The controller of a model record. `act` is called once a period, with the state and the reference in the vehicle's air."""

    def __init__(self, record):
        vehicle, simulate = record["vehicle"], record["simulate"]
        self.mass, self.inertia = vehicle["mass_kg"], np.array(vehicle["inertia_kg_m2"])
        self.gravity = record["gravity_m_per_s2"]
        self.gains = simulate["gains"]
        self.range = simulate["gyroscope_range_rad_per_s"]
        yaw_drag = vehicle.get("yaw_drag")
        self.yaw_drag = yaw_drag and (yaw_drag["linear_n_m_s_per_rad"], yaw_drag["quadratic_n_m_s2_per_rad2"])
        self.turns = np.array([1.0 if rotor["spin"] == "P" else -1.0 for rotor in vehicle["rotors"]])
        self.rotor_inertia = np.array([rotor["inertia_kg_m2"] for rotor in vehicle["rotors"]])
        self.drag_coefficient = np.array([rotor["drag_coefficient_n_m_s2_per_rad2"] for rotor in vehicle["rotors"]])
        self.lag = np.array([rotor["time_constant_s"] for rotor in vehicle["rotors"]])
        self.coefficient = np.array([rotor["thrust_coefficient_n_s2_per_rad2"] for rotor in vehicle["rotors"]])
        self.decay = np.exp(-1.0 / simulate["control_rate_hz"] / self.lag)
        self.allocator = Allocator(vehicle)
        self.modelled = self.command = None
        self.gives_up_yaw = False
        self.bias, self.signs = np.zeros(2), np.ones(2)

    def learn(self, mode):
        """A fault mode becomes known."""
        if any(share is not None for share in mode["stuck"]):
            raise ValueError("stuck rotors are not written here")
        self.allocator.believe(np.array(mode["capacity"]))
        hover = np.array([self.mass * self.gravity, 0.0, 0.0, 0.0])
        needed = mode["without_yaw"] == "where_needed" and not self.allocator.keeps_all_axes(hover)
        self.gives_up_yaw = needed or mode["without_yaw"] == "always"
        self.bias = self.allocator.middle(hover[0]) if self.gives_up_yaw else np.zeros(2)
        if self.gives_up_yaw:
            self.signs = self.settled_signs(hover[0])

    def settled_signs(self, thrust):
        """The signs of the gyroscopic terms at the spin in which the yaw drag balances the rotors that give the bias."""
        speeds = self.allocator.speeds(np.array([thrust, *self.bias, 0.0]))
        working = self.allocator.capacity > 0.0
        torque = -float(np.sum((self.turns * self.allocator.capacity * self.drag_coefficient * speeds**2)[working]))
        momentum = float(np.sum((self.turns * self.rotor_inertia * speeds)[working]))
        if self.yaw_drag is None:
            terms = np.array([self.inertia[0] - self.inertia[2], self.inertia[2] - self.inertia[1]])
        else:
            linear, quadratic = self.yaw_drag
            size = 2.0 * abs(torque) / (linear + np.sqrt(linear**2 + 4.0 * quadratic * abs(torque)))
            terms = self.gyroscopic_terms(np.copysign(size, torque), momentum)
        return np.where(terms < 0.0, -1.0, 1.0)

    def gyroscopic_terms(self, r, momentum):
        """The torques about y and x for each unit of tangent by which the axis of the spin is tilted towards x and y."""
        jx, jy, jz = self.inertia
        return np.array([((jx - jz) * r - momentum) * r, ((jz - jy) * r + momentum) * r])

    def start(self, reference):
        """Attitude R and rates of a body that follows a reference exactly."""
        up = np.array([0.0, 0.0, self.gravity])
        r, rates, _ = desired_frame(direction(reference.acceleration + up, reference.jerk, reference.snap), reference.yaw)
        return r, rates

    def act(self, body, reference, momentum):
        """The commanded speeds (rad/s); `momentum` is that of the rotors about z, N m s."""
        rotation, rates = body.rotation(), np.clip(body.rates, -self.range, self.range)
        if self.modelled is None:
            force = norm(reference.acceleration + np.array([0.0, 0.0, self.gravity]))
        else:
            self.modelled = self.command + (self.modelled - self.command) * self.decay
            force = float(np.sum(self.allocator.capacity * self.coefficient * self.modelled**2)) / self.mass
        demanded = self.demanded(body, rotation, rates, force, reference)
        if self.gives_up_yaw:
            wrench = self.without_yaw(rotation, rates, demanded, momentum)
        else:
            wrench = self.geometric(rotation, rates, demanded, reference.yaw)
        self.command = self.allocator.speeds(wrench)
        if self.modelled is None:
            self.modelled = self.command
        return self.command

    def demanded(self, body, rotation, rates, force, reference):
        """F, the force over mass that is demanded, with two derivatives, from the present thrust over mass `force`."""
        # Without yaw and with torques to one side of hover, feedback on the place is slower.
        slower = SLOWER_ONE_SIDED if self.gives_up_yaw and np.any(self.bias != 0.0) else 1.0
        k_x = np.array([slower**2 * self.gains["position_per_s2"]] * 2 + [self.gains["altitude_per_s2"]])
        k_v = np.array([slower * self.gains["velocity_per_s"]] * 2 + [self.gains["climb_per_s"]])
        up, gravity = rotation[:, 2], np.array([0.0, 0.0, self.gravity])
        e, e1 = reference.position - body.position, reference.velocity - body.velocity
        e2 = reference.acceleration - (force * up - gravity)
        back, back1 = k_x * e + k_v * e1, k_x * e1 + k_v * e2
        most = MOST_FEEDBACK * min(norm(reference.acceleration + gravity), self.gravity)
        is_far = norm(back) > most
        if is_far:
            back, back1 = back * (most / norm(back)), np.zeros(3)
        f, f1 = reference.acceleration + back + gravity, reference.jerk + back1
        # The present jerk: the thrust m F . R e_3 turns with the body and changes.
        turning = rotation @ np.array([rates[1], -rates[0], 0.0])
        e3 = reference.jerk - (force * turning + (f1 @ up + f @ turning) * up)
        return f, f1, reference.snap + (np.zeros(3) if is_far else k_x * e2 + k_v * e3)

    def geometric(self, rotation, rates, demanded, yaw):
        """Lee, Leok, McClamroch (2010), (12), (15) and (16), with z up."""
        up, zero = rotation[:, 2], np.zeros(3)
        b3 = (up, zero, zero) if norm(demanded[0]) < 0.05 * self.gravity else direction(*demanded)
        desired, w_d, w_d1 = desired_frame(b3, yaw)
        turn = rotation.T @ desired
        e_r, e_w = vee(turn.T), rates - turn @ w_d
        k_r = np.array([self.gains["attitude_per_s2"]] * 2 + [self.gains["yaw_per_s2"]])
        k_w = np.array([self.gains["attitude_rate_per_s"]] * 2 + [self.gains["yaw_rate_per_s"]])
        ahead = turn @ w_d1 - cross(rates, turn @ w_d)
        torque = self.inertia * (ahead - k_r * e_r - k_w * e_w) + cross(rates, self.inertia * rates)
        return np.array([self.mass * (demanded[0] @ up), *torque])

    def spin_axis(self, r, momentum):
        """w0 of an equilibrium at the rate r that takes the bias, its angle from z limited; the gyroscopic terms keep the sign that
        they have once the spin is settled."""
        jx, jy, jz = self.inertia
        least = LEAST_SHARE * r**2 * np.abs([jx - jz, jz - jy])
        terms = self.signs * np.maximum(self.signs * self.gyroscopic_terms(r, momentum), least)
        torques = self.bias[::-1]
        across = np.array([torque / term if torque != 0.0 and term != 0.0 else 0.0 for torque, term in zip(torques, terms)])
        size = np.hypot(*across)
        if size > MOST_TILT:
            across = across * (MOST_TILT / size)
        return np.array([across[0] * r, across[1] * r, r])

    def gyroscopic(self, w, momentum):
        """w x (J w + h e_z), the torque of a steady w."""
        return cross(w, self.inertia * w + np.array([0.0, 0.0, momentum]))

    def without_yaw(self, rotation, w, demanded, momentum):
        """The direction of the thrust alone, about the primary axis n of the body (docs/flight.md, "Without yaw")."""
        r, zero = w[2], np.zeros(3)
        w0 = self.spin_axis(r, momentum)
        n = np.array([0.0, 0.0, 1.0]) if abs(r) < SLOW else w0 / norm(w0) * np.sign(r)
        s = rotation @ n
        d, d1, d2 = (s, zero, zero) if norm(demanded[0]) < 0.05 * self.gravity else direction(*demanded)
        across = w - (w @ n) * n
        axis = cross(s, d)
        angle = np.arctan2(norm(axis), s @ d)
        towards = axis * (angle / norm(axis)) if norm(axis) > 1e-9 else angle * rotation[:, 0]
        k_r, k_w = self.gains["attitude_per_s2"], self.gains["attitude_rate_per_s"]
        alpha = cross(d, d2) + k_r * towards + k_w * (cross(d, d1) - rotation @ across)
        w1 = rotation.T @ alpha - (w @ n) * cross(n, across)
        w1 = w1 - n * (w1[2] / n[2])
        tau = self.inertia * w1 + self.gyroscopic(w, momentum)
        u = tau - self.gyroscopic(w0, momentum)
        t = float(np.mean(self.lag[self.allocator.capacity > 0.0]))
        thrust = self.mass * (demanded[0] @ s) / n[2]
        slowing = -self.gains["yaw_rate_per_s"] * self.inertia[2] * r
        return np.array([thrust, tau[0] + t * r * u[1], tau[1] - t * r * u[0], slowing])
