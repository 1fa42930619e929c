#!/usr/bin/env python3
"""One quadcopter flight in RotorPy and in mavc: a circle of 1 m at 5 s for each round, 20 s, geometric controller.

RotorPy: its Hummingbird with SE3Control, scipy's RK45 inside each step, at 100 and 500 steps per second; the start of Python
and imports are excluded. mavc: `simulate` of circle.mav, Runge-Kutta steps of fourth order at 1 kHz, controller at 500 Hz,
gyroscope and position noise, estimated capacities. Its times are those of the flight alone as `--timings` prints it, of the
flight with a log of 500 rows per second as text, and of the whole process with planning and log. RotorPy keeps its states in
arrays. The models differ in detail (RotorPy has blade drag, mavc an estimator). The comparison is of the time that such a flight
takes, and of whether both track the circle.
"""

import argparse
import contextlib
import io
import json
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
SECONDS = 20.0
ASKED = 500


def rotorpy_flight(rate):
    """Wall seconds and largest distance from the circle (m) after the first second."""
    from rotorpy.controllers.quadrotor_control import SE3Control
    from rotorpy.environments import Environment
    from rotorpy.trajectories.circular_traj import ThreeDCircularTraj
    from rotorpy.vehicles.hummingbird_params import quad_params
    from rotorpy.vehicles.multirotor import Multirotor

    circle = ThreeDCircularTraj(center=np.array([0, 0, 2.0]), radius=np.array([1.0, 1.0, 0.0]), freq=np.array([0.2, 0.2, 0.0]))
    start = circle.update(0.0)
    hover = np.sqrt(quad_params["mass"] * 9.81 / (4 * quad_params["k_eta"]))
    initial = {
        "x": start["x"], "v": start["x_dot"], "q": np.array([0, 0, 0, 1.0]), "w": np.zeros(3),
        "wind": np.zeros(3), "rotor_speeds": np.full(4, hover),
    }
    world = Environment(
        vehicle=Multirotor(quad_params, initial_state=initial), controller=SE3Control(quad_params),
        trajectory=circle, sim_rate=rate,
    )
    world.vehicle.initial_state = initial
    begin = time.perf_counter()
    with contextlib.redirect_stdout(io.StringIO()):
        result = world.run(t_final=SECONDS, use_mocap=False, terminate=False, plot=False, animate_bool=False, verbose=False)
    seconds = time.perf_counter() - begin
    late = result["time"] > 1.0
    error = np.linalg.norm(result["state"]["x"] - result["flat"]["x"], axis=1)[late].max()
    return seconds, float(error)


def mavc_flight(binary, repeat):
    """Least wall seconds of the flight, of the flight with its log, and of the whole process; the largest error (m)."""
    bare, logged, wholes = [], [], []
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "sim.json"
        command = [binary, "simulate", HERE / "circle.mav", "--timings", "--quiet", "--report", report]
        log = ["--rate", "500Hz", "-o", Path(folder) / "log.csv"]
        for _ in range(repeat):
            for arguments, flights in ((command, bare), (command + log, logged)):
                begin = time.perf_counter()
                done = subprocess.run(arguments, capture_output=True, text=True, check=False)
                seconds = time.perf_counter() - begin
                if done.returncode != 0:
                    sys.exit(f"mavc ended with {done.returncode}:\n{done.stderr}")
                flights.append(float(re.search(r"^flight\s+([0-9.]+) ms", done.stderr, re.MULTILINE)[1]) / 1e3)
            wholes.append(seconds)
        error = json.loads(report.read_text())["max_error_m"]
    return min(bare), min(logged), min(wholes), error


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mavc", help="the binary, built with --release")
    parser.add_argument("--repeat", type=int, default=5, help="runs of mavc, of which the least counts")
    args = parser.parse_args()
    flight, logged, whole, error = mavc_flight(args.mavc, args.repeat)
    print(f"{'a circle of 20 s':42} {'seconds':>9} {'ratio':>7}  largest error")
    print(f"{'mavc, the flight at 1 kHz':42} {flight:9.4f} {'':7}  {100 * error:.1f} cm")
    print(f"{'mavc, the same with its log':42} {logged:9.4f}")
    print(f"{'mavc, the whole process with planning':42} {whole:9.4f}")
    for rate in (100, 500):
        seconds, peer_error = rotorpy_flight(rate)
        verdict = "met" if seconds / flight >= ASKED else "MISSED"
        print(f"{f'RotorPy at {rate} Hz':42} {seconds:9.3f} {seconds / flight:7.0f}  {100 * peer_error:.1f} cm   asked >= {ASKED}: {verdict}")


if __name__ == "__main__":
    main()
