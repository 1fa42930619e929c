"""Simulated flights with known losses, written as DataFlash logs, diagnosed and judged.

    python3 benches/diagnosis/run.py target/release/mavc [--flights 200] [--seed 1] [--keep FOLDER]

Each flight: a quad X, hexa X or octa X of random mass, size and time constant; a mission with waypoints and holds; gusts
and gyroscope noise; no fault, one rotor lost, or one reduced to 5 to 90 %; the controller does not learn of it. The log
has pulses in whole microseconds, the commands before the rotors' lag, and rates and forces with noise, at 10 to 400 Hz.
"""

import argparse
import csv
import json
import math
import pathlib
import random
import statistics
import struct
import subprocess
import tempfile

FRAMES = {  # ArduPilot's class, angles clockwise from the nose and spins (P counter-clockwise), in the order of motors
    1: [(45, "P"), (-135, "P"), (-45, "N"), (135, "N")],
    2: [(90, "N"), (-90, "P"), (-30, "N"), (150, "P"), (30, "P"), (-150, "N")],
    3: [(22.5, "N"), (-157.5, "N"), (67.5, "P"), (157.5, "P"), (-22.5, "P"), (-112.5, "P"), (-67.5, "N"), (112.5, "N")],
}
EXPO, SPIN_MIN, SPIN_MAX = 0.65, 0.15, 0.95
SIZES = {"Q": 8, "H": 2, "B": 1, "f": 4, "c": 2, "C": 2, "n": 4, "N": 16, "Z": 64}


class Log:
    """A DataFlash log."""

    def __init__(self):
        self.bytes = bytearray()
        self.kinds = {}

    def define(self, number, name, kinds, labels):
        length = 3 + sum(SIZES[kind] for kind in kinds)
        self.bytes += struct.pack("<BBBBB4s16s64s", 0xA3, 0x95, 128, number, length, name.encode(), kinds.encode(),
                                  labels.encode())
        codes = {"Q": "Q", "H": "H", "B": "B", "f": "f", "N": "16s"}
        self.kinds[name] = (number, struct.Struct("<BBB" + "".join(codes[kind] for kind in kinds)))

    def add(self, name, *values):
        number, layout = self.kinds[name]
        self.bytes += layout.pack(0xA3, 0x95, number, *values)


def spec(rng, frame, fault):
    arm, mass = rng.uniform(0.15, 0.45), rng.uniform(1.0, 5.0)
    n = len(FRAMES[frame])
    full = mass * 9.81 / n / rng.uniform(0.3, 0.5)
    inertia = mass * arm**2 * rng.uniform(0.15, 0.35)
    rotors = "\n".join(
        f"        rotor at [{arm * math.cos(math.radians(a)):.6f} m, {-arm * math.sin(math.radians(a)):.6f} m, 0 m] "
        f"spin {spin}" for a, spin in FRAMES[frame])
    time, total = rng.uniform(9, 20), 30
    x, y = rng.uniform(2, 8), rng.uniform(2, 8)
    yaw = rng.uniform(-90, 90)
    strike = f"; fault F at {time:.3f} s" if fault else ""
    state = "lost" if fault and fault[1] == 0 else f"reduced to {100 * fault[1]:.1f} %" if fault else "lost"
    rotor = fault[0] + 1 if fault else 1
    text = f"""vehicle v {{
    rotors {{
{rotors}
    }}
    mass    = {mass:.4f} kg
    inertia = [{inertia:.6f}, {inertia * rng.uniform(0.8, 1.3):.6f}, {1.8 * inertia:.6f}] kg*m^2
    rotor {{
        max_thrust        = {full:.4f} N
        torque_per_thrust = {rng.uniform(12, 20):.2f} mm
        max_speed         = 7500 rpm
        time_constant     = {rng.uniform(20, 80):.1f} ms
    }}
}}
faults {{ mode F {{ rotor {rotor} {state} }} }}
mission m {{
    start at [0, 0, 60] m  yaw 0 deg
    waypoint at [{x:.2f}, 0, 62] m
    hold 4 s
    waypoint at [{x:.2f}, {y:.2f}, 61] m  yaw {yaw:.0f} deg
    waypoint at [0, {y:.2f}, 60] m  yaw 0 deg
    hold 5 s
    limits {{ speed <= {rng.uniform(2, 6):.1f} m/s; tilt <= 25 deg }}
}}
plan {{ planner = rip; against = []; time = {total} s; samples = 80 }}
simulate {{
    seed = {rng.randrange(1000)}; gusts = {rng.uniform(0, 1.5):.2f} m/s; drag = 0.3 N*s/m
    gyroscope_noise = {rng.uniform(0.002, 0.01):.4f} rad/s
    detection = never; lost_beyond = 40 m{strike}
}}
"""
    lag = float(text.split("time_constant     = ")[1].split(" ms")[0]) / 1000
    return text, mass, full, lag, time if fault else None


def pulse(share):
    """The pulse of a share of full thrust, us."""
    share = min(max(share, 0.0), 1.0)
    x = (-(1 - EXPO) + math.sqrt((1 - EXPO) ** 2 + 4 * EXPO * share)) / (2 * EXPO)
    return round(1000 + 1000 * (SPIN_MIN + (SPIN_MAX - SPIN_MIN) * x))


def write(rows, frame, mass, lag, outputs_hz, rates_hz, noise, rng, path):
    n = len(FRAMES[frame])
    log = Log()
    log.define(1, "PARM", "QNf", "TimeUS,Name,Value")
    log.define(2, "RCOU", "Q" + "H" * n, "TimeUS," + ",".join(f"C{k + 1}" for k in range(n)))
    log.define(3, "IMU", "QBffffff", "TimeUS,I,GyrX,GyrY,GyrZ,AccX,AccY,AccZ")
    log.define(4, "ATT", "Qffffff", "TimeUS,DesRoll,Roll,DesPitch,Pitch,DesYaw,Yaw")
    parameters = {"FRAME_CLASS": frame, "FRAME_TYPE": 1, "MOT_PWM_MIN": 1000, "MOT_PWM_MAX": 2000, "MOT_THST_EXPO": EXPO,
                  "MOT_SPIN_MIN": SPIN_MIN, "MOT_SPIN_MAX": SPIN_MAX} | {f"SERVO{k + 1}_FUNCTION": 33 + k for k in range(n)}
    for name, value in parameters.items():
        log.add("PARM", 1, name.encode(), value)
    most = 7500 * math.tau / 60
    degrees = math.degrees
    due_outputs = due_rates = 0.0
    for before, row in zip([rows[0]] + rows, rows):
        t = row["t"]
        now = int((10 + t) * 1e6)
        if t >= due_rates - 1e-9:
            due_rates += 1 / rates_hz
            gyro = [row[k] + rng.gauss(0, noise) for k in "pqr"]
            force = row["thrust"] / mass + rng.gauss(0, 0.3)
            log.add("IMU", now, 0, gyro[0], -gyro[1], -gyro[2], rng.gauss(0, 0.3), rng.gauss(0, 0.3), -force)
        if t >= due_outputs - 1e-9:
            due_outputs += 1 / outputs_hz
            step = max(t - before["t"], 1e-9)
            commands = [row[f"omega_{k + 1}"] + lag * (row[f"omega_{k + 1}"] - before[f"omega_{k + 1}"]) / step
                        for k in range(n)]
            log.add("RCOU", now, *[pulse((max(w, 0) / most) ** 2) for w in commands])
            log.add("ATT", now, 0, degrees(row["roll"]), 0, -degrees(row["pitch"]), 0, -degrees(row["yaw"]))
    path.write_bytes(log.bytes)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("mavc")
    parser.add_argument("--flights", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep")
    parser.add_argument("--diagnose", help="another program for the diagnosis, for experiments")
    args = parser.parse_args()
    rng = random.Random(args.seed)
    folder = pathlib.Path(args.keep or tempfile.mkdtemp())
    folder.mkdir(parents=True, exist_ok=True)
    flown, found, errors, inside, false, hours, wrong, total_wrong = 0, 0, [], [], 0, 0.0, [], 0
    for number in range(args.flights):
        frame = rng.choice([1, 2, 3])
        kind = rng.random()
        motor = rng.randrange(len(FRAMES[frame]))
        fault = None if kind < 0.2 else (motor, 0.0) if kind < 0.55 else (motor, rng.uniform(0.05, 0.9))
        text, mass, _full, lag, time = spec(rng, frame, fault)
        outputs_hz = rng.choice([10, 25, 50, 100, 400])
        rates_hz = max(outputs_hz, rng.choice([25, 50, 100, 400]))
        stem = folder / f"{number:03}"
        stem.with_suffix(".mav").write_text(text)
        flight = stem.with_suffix(".csv")
        run = subprocess.run([args.mavc, "simulate", stem.with_suffix(".mav"), "-o", flight, "--rate", "500Hz", "-q"],
                             capture_output=True, text=True)
        if not flight.exists():
            print(number, "not flown:", run.stderr.strip().splitlines()[:2])
            continue
        with flight.open() as lines:
            rows = [{k: float(v) for k, v in row.items() if v not in ("", "NaN")} for row in csv.DictReader(lines)]
        flight.unlink()
        # What a lost vehicle does long after its fault is not what is asked.
        rows = [row for row in rows if row["z"] > 1]
        log = stem.with_suffix(".bin")
        write(rows, frame, mass, lag, outputs_hz, rates_hz, rng.uniform(0.002, 0.01), rng, log)
        run = subprocess.run([args.mavc, "diagnose", log, "--format", "json", "-q"], capture_output=True, text=True)
        answer = json.loads(run.stdout) if run.stdout else {"losses": [], "answer": run.stderr}
        if not args.keep:
            log.unlink()
        flown += 1
        strike = None if time is None else 10 + time
        healthy = (rows[-1]["t"] if time is None else min(time, rows[-1]["t"])) / 3600
        hours += healthy
        early = [loss for loss in answer["losses"] if strike is None or loss["time_s"] < strike - 1]
        false += len(early)
        late = [loss for loss in answer["losses"] if loss not in early]
        verdict = "-"
        if fault and fault[1] <= 0.7:
            hit = next((loss for loss in late if motor + 1 in [loss["motor"], *loss["alternatives"]]), None)
            total_wrong += 1
            if hit and hit is late[0]:
                found += 1
                errors.append(abs(hit["time_s"] - strike))
                low, high = hit["capacity_interval"]
                inside.append(low - 1e-9 <= fault[1] <= high + 1e-9)
                verdict = f"found, {errors[-1]:.2f} s, {hit['capacity']:.2f} [{low:.2f} {high:.2f}] {hit['alternatives']}"
            else:
                verdict = "MISSED"
                wrong.append(number)
        elif fault:
            verdict = "small, " + ("seen" if late else "not seen")
        shown = "none" if fault is None else f"motor {motor + 1} to {fault[1]:.2f} at {strike:.2f}"
        print(f"{number} frame {frame} {outputs_hz}/{rates_hz} Hz: {shown}: {verdict}",
              f"EARLY {[(loss['motor'], loss['time_s'], loss['capacity']) for loss in early]}" if early else "",
              f"late {[(loss['motor'], loss['time_s'], loss['capacity']) for loss in late]}" if verdict == "MISSED" else "",
              flush=True)
    print(f"{flown} flights; losses above 30 %: {found} of {total_wrong} found")
    if errors:
        print(f"error of the time: median {statistics.median(errors):.3f} s, 95 % {sorted(errors)[int(0.95 * len(errors))]:.3f} s")
        print(f"capacity inside its 95 % interval: {sum(inside)} of {len(inside)}")
    print(f"false alarms: {false} in {60 * hours:.0f} min of healthy flight")


if __name__ == "__main__":
    main()
