"""A simulated flight as a DataFlash log of ArduPilot: pulses in whole microseconds, rates and forces with noise."""

import csv
import math
import struct

EXPO, SPIN_MIN, SPIN_MAX = 0.65, 0.15, 0.95
SIZES = {"Q": 8, "H": 2, "B": 1, "f": 4, "N": 16}
CODES = {"Q": "Q", "H": "H", "B": "B", "f": "f", "N": "16s"}
# What a log has before the flight, s.
BEFORE = 10
FULL_SPEED = 7500 * math.tau / 60


class Log:
    """The messages of a log."""

    def __init__(self):
        self.bytes = bytearray()
        self.kinds = {}

    def define(self, number, name, kinds, labels):
        length = 3 + sum(SIZES[kind] for kind in kinds)
        self.bytes += struct.pack("<BBBBB4s16s64s", 0xA3, 0x95, 128, number, length, name.encode(), kinds.encode(),
                                  labels.encode())
        self.kinds[name] = (number, struct.Struct("<BBB" + "".join(CODES[kind] for kind in kinds)))

    def add(self, name, *values):
        number, layout = self.kinds[name]
        self.bytes += layout.pack(0xA3, 0x95, number, *values)


def pulse(share):
    """The pulse of a share of full thrust, us."""
    share = min(max(share, 0.0), 1.0)
    x = (-(1 - EXPO) + math.sqrt((1 - EXPO) ** 2 + 4 * EXPO * share)) / (2 * EXPO)
    return round(1000 + 1000 * (SPIN_MIN + (SPIN_MAX - SPIN_MIN) * x))


def write(flight, table, rates_hz, rng, path):
    """Writes a flight whose table (csv) has a row for each act of the controller; the duration of the table, s."""
    with open(table) as lines:
        rows = [{k: float(v) for k, v in row.items() if v not in ("", "NaN")} for row in csv.DictReader(lines)]
    n = len(flight.motors)
    log = Log()
    log.define(1, "PARM", "QNf", "TimeUS,Name,Value")
    log.define(2, "RCOU", "Q" + "H" * n, "TimeUS," + ",".join(f"C{k + 1}" for k in range(n)))
    log.define(3, "IMU", "QBffffff", "TimeUS,I,GyrX,GyrY,GyrZ,AccX,AccY,AccZ")
    log.define(4, "ATT", "Qffffff", "TimeUS,DesRoll,Roll,DesPitch,Pitch,DesYaw,Yaw")
    parameters = {"MOT_PWM_MIN": 1000, "MOT_PWM_MAX": 2000, "MOT_THST_EXPO": EXPO, "MOT_SPIN_MIN": SPIN_MIN,
                  "MOT_SPIN_MAX": SPIN_MAX} | {f"SERVO{k + 1}_FUNCTION": 33 + k for k in range(n)}
    if flight.frame is not None:
        parameters |= {"FRAME_CLASS": flight.frame, "FRAME_TYPE": 1}
    for name, value in parameters.items():
        log.add("PARM", 1, name.encode(), value)
    degrees = math.degrees
    due_outputs = due_rates = 0.0
    for before, row in zip([rows[0]] + rows, rows):
        t = row["t"]
        now = int((BEFORE + t) * 1e6)
        if t >= due_rates - 1e-9:
            due_rates += 1 / rates_hz
            gyro = [row[k] + rng.gauss(0, flight.noise) for k in "pqr"]
            force = row["thrust"] / flight.mass + rng.gauss(0, 0.3)
            log.add("IMU", now, 0, gyro[0], -gyro[1], -gyro[2], rng.gauss(0, 0.3), rng.gauss(0, 0.3), -force)
        if t >= due_outputs - 1e-9:
            due_outputs += 1 / flight.rate
            step = max(t - before["t"], 1e-9)
            commands = [row[f"omega_{k + 1}"] + flight.lag * (row[f"omega_{k + 1}"] - before[f"omega_{k + 1}"]) / step
                        for k in range(n)]
            log.add("RCOU", now, *[pulse((max(w, 0) / FULL_SPEED) ** 2) for w in commands])
            log.add("ATT", now, 0, degrees(row["roll"]), 0, -degrees(row["pitch"]), 0, -degrees(row["yaw"]))
    path.write_bytes(log.bytes)
    return rows[-1]["t"]
