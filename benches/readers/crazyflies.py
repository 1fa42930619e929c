"""A Crazyflie that only records, at the other end of cflib's own UDP link, and one that flies what was recorded: the identified model of
drone-models, with the port of the firmware's Mellinger controller of drone-controllers."""

import os
import socket
import struct
import threading
import time

os.environ["SCIPY_ARRAY_API"] = "1"

import numpy as np  # noqa: E402
from drone_controllers import parametrize as with_gains  # noqa: E402
from drone_controllers.mellinger import attitude2force_torque, force_torque2rotor_vel, state2attitude  # noqa: E402
from drone_models import parametrize  # noqa: E402
from drone_models.first_principles import dynamics  # noqa: E402
from scipy.spatial.transform import Rotation  # noqa: E402

# Ports and channels of CRTP.
PARAM, MEM, LOG, HIGH_LEVEL, SUPERVISOR, PLATFORM, LINK = 2, 4, 5, 8, 9, 13, 15
PROTOCOL = 12
# What the tables of contents list: type, group, name.
VARIABLES = [(7, "kalman", "varPX"), (7, "kalman", "varPY"), (7, "kalman", "varPZ")]
PARAMETERS = [(8, "kalman", "resetEstimation")]
TRAJECTORY_MEMORY, MEMORY_SIZE = 0x12, 4096
TAKEOFF, LAND, STOP, GO_TO, DEFINE, START = 7, 8, 3, 12, 6, 13


class Recorder(threading.Thread):
    """Answers the connection, takes what is written into the memory of trajectories, and records the commands to the high-level
    commander with the times of their arrival."""

    def __init__(self, port):
        super().__init__(daemon=True)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", port))
        self.socket.settimeout(0.05)
        self.memory, self.commands, self.ends = bytearray(MEMORY_SIZE), [], False
        self.written, self.armed, self.logging = 0, False, {}
        self.start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.ends = True
        self.join()
        self.socket.close()

    def run(self):
        other = None
        while not self.ends:
            now = time.monotonic()
            for block, (period, due) in list(self.logging.items()):
                if now >= due:
                    self.logging[block] = (period, now + period)
                    # A position that is known.
                    self.answer(other, LOG, 2, struct.pack("<BBBB3f", block, 0, 0, 0, 1e-5, 1e-5, 1e-5))
            try:
                packet, other = self.socket.recvfrom(64)
            except TimeoutError:
                continue
            port, channel, data = packet[0] >> 4, packet[0] & 3, packet[1:]
            for reply in self.replies(port, channel, data):
                self.answer(other, port, channel, reply)

    def answer(self, other, port, channel, data):
        self.socket.sendto(bytes([port << 4 | 3 << 2 | channel]) + data, other)

    def replies(self, port, channel, data):
        if port == LINK:
            yield b"Bitcraze Crazyflie" if channel == 1 else data
        elif port == PLATFORM and channel == 1:
            yield bytes([data[0], PROTOCOL])
        elif port in (LOG, PARAM) and channel == 0:
            yield contents(VARIABLES if port == LOG else PARAMETERS, data)
        elif port == LOG and channel == 1:
            yield self.log_setting(data)
        elif port == PARAM and channel == 1:
            yield data[:2] + b"\0\0"
        elif port == PARAM and channel == 2:
            yield data
        elif port == MEM:
            yield self.memories(channel, data)
        elif port == SUPERVISOR and channel == 1:
            self.armed = bool(data[1])
            yield bytes([0x80 | data[0], 1, self.armed])
        elif port == HIGH_LEVEL:
            self.commands.append((time.monotonic(), data[0], bytes(data[1:])))

    def log_setting(self, data):
        """Commands of logging: 3 starts a block, 4 and 2 stop and delete it, 5 stops all."""
        block = data[1] if len(data) > 1 else 0
        if data[0] == 3:
            period = 0.01 * data[2]
            self.logging[block] = (period, time.monotonic() + period)
        elif data[0] in (2, 4):
            self.logging.pop(block, None)
        return bytes([data[0], block, 0])

    def memories(self, channel, data):
        if channel == 0:
            return b"\x01\x01" if data[0] == 1 else struct.pack("<BBBI8x", 2, 0, TRAJECTORY_MEMORY, MEMORY_SIZE)
        (address,), content = struct.unpack("<I", data[1:5]), data[5:]
        fits = address + len(content) <= MEMORY_SIZE
        if fits:
            self.memory[address : address + len(content)] = content
            self.written = max(self.written, address + len(content))
        return data[:5] + bytes([0 if fits else 1])

    def trajectory(self, offset, count):
        """Durations (s) and coefficients [axis][power] of the pieces in the memory."""
        pieces = [struct.unpack_from("<33f", self.memory, offset + 132 * k) for k in range(count)]
        return [(piece[32], np.array(piece[:32]).reshape(4, 8)) for piece in pieces]


def contents(table, data):
    """A table of contents: its length and a checksum, or an entry."""
    if data[0] == 3:
        return struct.pack("<BHI", 3, len(table), sum(map(ord, repr(table))))
    kind, group, name = table[struct.unpack("<H", data[1:3])[0]]
    return data[:3] + bytes([kind]) + f"{group}\0{name}\0".encode()


def at(pieces, time_s, order):
    """A derivative of x, y, z and yaw."""
    for duration, coefficients in pieces[:-1]:
        if time_s < duration:
            break
        time_s -= duration
    else:
        duration, coefficients = pieces[-1]
    s = min(time_s, duration)
    return np.array([np.polyval(np.polyder(c[::-1], order) if order else c[::-1], s) for c in coefficients])


def slower(thrust, speeds, rotor, share):
    """Speeds with which one rotor gives a share of its thrust; `thrust` has the coefficients of the speed in ascending powers."""
    speeds = speeds.copy()
    given = np.polyval(thrust[::-1], speeds[rotor])
    speeds[rotor] = np.max(np.roots([*thrust[:0:-1], thrust[0] - share * given]))
    return speeds


def flown(pieces, weak=None, drone="cf2x_P250", rate=500):
    """The largest distance (m) from the pieces of a Crazyflie in still air that starts in hover, with its state known. The position loop
    runs at 100 Hz and the attitude loop at 500 Hz, as in the firmware. `weak` is a rotor, the share of its thrust that it gives, and
    from when on (s), which the controller never knows."""
    outer, inner, mix = (with_gains(part, drone) for part in (state2attitude, attitude2force_torque, force_torque2rotor_vel))
    model, h, worst = parametrize(dynamics, drone), 1 / rate, 0.0
    thrust = model.keywords["rpm2thrust"]
    start = at(pieces, 0.0, 0)
    position, velocity, rates = start[:3].copy(), np.zeros(3), np.zeros(3)
    attitude, before = Rotation.from_euler("z", start[3]), np.zeros(3)
    rotors = np.full(4, np.max(np.roots([*thrust[:0:-1], thrust[0] - model.keywords["mass"] * 9.81 / 4])))
    of_position, of_attitude = np.zeros(3), np.zeros(3)
    for k in range(round(sum(duration for duration, _ in pieces) * rate)):
        setpoint = [at(pieces, k * h, order) for order in range(3)]
        worst = max(worst, np.linalg.norm(position - setpoint[0][:3]))
        state = position, attitude.as_quat(), velocity, rates
        if k % (rate // 100) == 0:
            command = np.concatenate([*(part[:3] for part in setpoint), [setpoint[0][3]], np.zeros(3)])
            wanted, of_position = outer(*state, command, ctrl_errors=(of_position,), ctrl_freq=100)
        if k % (rate // 500) == 0:
            force, torque, of_attitude = inner(*state, wanted, prev_ang_vel=before, ctrl_errors=(of_attitude,), ctrl_freq=500)
            before, speeds = rates.copy(), mix(force, torque)
        *_, spinning = model(*state, speeds, rotor_vel=rotors)
        given = slower(thrust, rotors, *weak[:2]) if weak and k * h >= weak[2] else rotors
        _, _, acceleration, turning, _ = model(*state, speeds, rotor_vel=given)
        velocity = velocity + h * acceleration
        position = position + h * velocity
        rates = rates + h * turning
        attitude = attitude * Rotation.from_rotvec(h * rates)
        rotors = rotors + h * spinning
    return float(worst)
