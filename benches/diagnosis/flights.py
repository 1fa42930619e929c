"""Random flights: vehicles of several layouts, missions, air and sensors, with or without a fault of one rotor."""

import math

# Angles clockwise from the nose, spins (P counter-clockwise) and ArduPilot's class of the X frame, in the order of motors.
# A rotor whose place is taken is below the one that has it.
LAYOUTS = {
    "quad": (1, [(45, "P"), (-135, "P"), (-45, "N"), (135, "N")]),
    "hexa PNPNPN": (2, [(90, "N"), (-90, "P"), (-30, "N"), (150, "P"), (30, "P"), (-150, "N")]),
    "hexa PPNNPN": (None, [(-30, "P"), (-90, "P"), (-150, "N"), (150, "N"), (90, "P"), (30, "N")]),
    "octa": (3, [(22.5, "N"), (-157.5, "N"), (67.5, "P"), (157.5, "P"), (-22.5, "P"), (-112.5, "P"), (-67.5, "N"),
                 (112.5, "N")]),
    "X8": (4, [(45, "P"), (-45, "N"), (-135, "P"), (135, "N"), (-45, "P"), (45, "N"), (135, "P"), (-135, "N")]),
}
MISSIONS = ["hover", "climb", "lanes", "turns"]
RATES = [10, 25, 50, 100, 400]
# A flight with a fault, and one without, s: the healthy ones are long, because false alarms are counted by the hour.
SHORT, LONG = 30, 120


class Flight:
    """A flight as a spec, and what is true of it."""

    def __init__(self, rng):
        self.layout = rng.choice(list(LAYOUTS))
        self.mission = rng.choice(MISSIONS)
        self.frame, self.motors = LAYOUTS[self.layout]
        kind = rng.random()
        # The motor (from 1) and the share of thrust that it keeps; when, s.
        self.motor = rng.randrange(len(self.motors)) + 1
        self.capacity = 1.0 if kind < 0.25 else 0.0 if kind < 0.6 else round(rng.uniform(0.05, 0.9), 3)
        self.time = round(rng.uniform(9, 20), 3) if self.capacity < 1 else None
        self.rate = rng.choice(RATES)
        self.noise = round(rng.uniform(0.002, 0.01), 4)
        self.mass = round(rng.uniform(1.0, 5.0), 4)
        self.lag = round(rng.uniform(0.02, 0.08), 4)
        self.seconds = LONG if self.time is None else SHORT
        self.spec = self._spec(rng)

    def _spec(self, rng):
        arm = rng.uniform(0.15, 0.45)
        full = self.mass * 9.81 / len(self.motors) / rng.uniform(0.3, 0.5)
        inertia = self.mass * arm**2 * rng.uniform(0.15, 0.35)
        taken, rotors = set(), []
        for angle, spin in self.motors:
            x, y = arm * math.cos(math.radians(angle)), -arm * math.sin(math.radians(angle))
            rotors.append(f"        rotor at [{x:.6f}, {y:.6f}, {-0.06 if angle in taken else 0}] m  spin {spin}")
            taken.add(angle)
        state = "lost" if self.capacity == 0 else f"reduced to {100 * min(self.capacity, 0.9):.1f} %"
        strike = "" if self.time is None else f"\n    fault F at {self.time} s"
        return f"""vehicle v {{
    rotors {{
{chr(10).join(rotors)}
    }}
    mass    = {self.mass} kg
    inertia = [{inertia:.6f}, {inertia * rng.uniform(0.8, 1.3):.6f}, {1.8 * inertia:.6f}] kg*m^2
    rotor {{
        max_thrust        = {full:.4f} N
        torque_per_thrust = {rng.uniform(12, 20):.2f} mm
        max_speed         = 7500 rpm
        time_constant     = {self.lag} s
    }}
}}
faults {{ mode F {{ rotor {self.motor} {state} }} }}
mission m {{
    start at [0, 0, 60] m  yaw 0 deg
{self._statements(rng)}
    limits {{ speed <= {rng.uniform(2, 6):.1f} m/s; tilt <= 25 deg }}
}}
plan {{ planner = rip; against = []; time = {self.seconds} s; samples = {8 * self.seconds // 3} }}
simulate {{
    seed = {rng.randrange(1000)}; rate = 1200 Hz; control_rate = 400 Hz
    gusts = {rng.uniform(0, 1.5):.2f} m/s; drag = 0.3 N*s/m; torque_gusts = {rng.uniform(0, 1) * inertia:.6f} N*m
    gyroscope_noise = {self.noise} rad/s; centre_offset = {rng.uniform(0, 0.02) * arm:.5f} m
    detection = never; lost_beyond = 40 m; lost_yaw = off; upside_down = 3 s{strike}
}}
"""

    def _statements(self, rng):
        size = rng.uniform(2, 6)
        legs = 1 if self.seconds == SHORT else 4
        lines = []
        if self.mission == "hover":
            lines = ["waypoint at [0, 0, 60.5] m", f"hold {self.seconds - 8} s"]
        elif self.mission == "climb":
            for _ in range(legs):
                lines += [f"waypoint at [0, 0, {60 + 2 * size:.2f}] m", "hold 2 s", "waypoint at [0, 0, 60] m", "hold 2 s"]
        elif self.mission == "lanes":
            for lane in range(2 * legs):
                x = 2 * size if lane % 2 == 0 else 0
                lines += [f"waypoint at [{x:.2f}, {2 * lane}, 60] m", f"waypoint at [{x:.2f}, {2 * lane + 2}, 60] m"]
        else:
            for _ in range(legs):
                yaw = rng.uniform(-90, 90)
                lines += [f"waypoint at [{size:.2f}, 0, 62] m", "hold 3 s",
                          f"waypoint at [{size:.2f}, {size:.2f}, 61] m  yaw {yaw:.0f} deg",
                          f"waypoint at [0, {size:.2f}, 60] m  yaw 0 deg", "hold 3 s", "waypoint at [0, 0, 60] m"]
        return "\n".join(f"    {line}" for line in lines)
