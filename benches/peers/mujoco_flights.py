"""Simulated flights of mavc against MuJoCo: the same thrusts, the same motion?

For every shipped vehicle a short flight is simulated with `mavc simulate`, healthy and with a fault. The thrusts of its rotors, from the
speeds in the log, then drive the model of `mavc emit mjcf` in MuJoCo, with the yaw drag and the drag as applied forces. Prints the
largest differences of position, attitude and body rates over the flight.

    python3 -m venv VENV && VENV/bin/pip install mujoco numpy
    VENV/bin/python benches/peers/mujoco_flights.py target/release/mavc

The integrators differ: MuJoCo holds controls and applied forces over a step, mavc has the wrench at its start, middle and end. So each
step gets Simpson's mean of the thrusts, which follow the motors' lag in closed form between two rows of the log.
"""

import csv
import subprocess
import sys
import tempfile
from pathlib import Path

import mujoco
import numpy as np

RATE = 1000.0
LAG = 0.02
SECONDS = 3.0
VEHICLES = ["quad_pnpn", "quad_x", "hexa_pnpnpn", "hexa_ppnnpn", "octo_pnpnpnpn", "octo_ppnnppnn", "coaxial_x8", "ring12"]
YAW_DRAG = 2.75e-3
DRAG = 0.3

SPEC = """use "{vehicle}"
faults {{ mode out {{ rotor 1 lost }} }}
mission dash {{
    start at [0, 0, 30] m  yaw 20 deg
    waypoint at [6, 3, 31] m  yaw 70 deg
    hold 2 s
}}
plan {{ planner = rip; against = []; time = 6 s; samples = 40 }}
simulate {{
    rate = 1000 Hz; control_rate = 1000 Hz; estimator_rate = 100 Hz
    detection = 50 ms; lost_beyond = 100 m; drag = {drag} N*s/m
    {fault}
}}
"""


def flown(mavc, folder, vehicle, fault):
    path = Path(folder, "flight.mav")
    path.write_text(SPEC.format(vehicle=Path("specs/vehicles", vehicle + ".mav").resolve(), fault=fault, drag=DRAG))
    settings = ["--set", f"vehicle.yaw_drag={YAW_DRAG}N*m*s/rad"]
    log = Path(folder, "flight.csv")
    ran = subprocess.run([mavc, "simulate", path, *settings, "-o", log, "--rate", "1000Hz"], capture_output=True, text=True)
    if not log.exists():
        sys.exit(f"{vehicle}: exit code {ran.returncode}\n{ran.stdout}{ran.stderr}")
    xml = subprocess.run([mavc, "emit", "mjcf", path, *settings], capture_output=True, text=True, check=True).stdout
    rows = list(csv.DictReader(open(log)))
    return xml, {key: np.array([float(row[key]) for row in rows]) for key in rows[0] if rows[0][key] != ""}


def quaternion(roll, pitch, yaw):
    (sr, cr), (sp, cp), (sy, cy) = [(np.sin(a / 2), np.cos(a / 2)) for a in (roll, pitch, yaw)]
    return np.array([cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy])


def thrusts(log, coefficients, k, lost_at):
    """Simpson's mean over the step after row k, with the commands that lead to row k + 1 by the lag. Rotor 1 gives nothing from
    `lost_at` s on; the capacities in the log are those that the controller assumes."""
    n = len(coefficients)
    begin = np.array([log[f"omega_{i + 1}"][k] for i in range(n)])
    end = np.array([log[f"omega_{i + 1}"][k + 1] for i in range(n)])
    theta = np.ones(n)
    theta[0] = 0.0 if log["t"][k] >= lost_at - 0.5 / RATE else 1.0
    decay = np.exp(-1.0 / RATE / LAG)
    command = (end - begin * decay) / (1.0 - decay)
    middle = command + (begin - command) * np.sqrt(decay)
    return theta * coefficients * (begin**2 + 4.0 * middle**2 + end**2) / 6.0


def compare(xml, log, coefficients, lost_at):
    model = mujoco.MjModel.from_xml_string(xml)
    data = mujoco.MjData(model)
    data.qpos[:3] = [log["x"][0], log["y"][0], log["z"][0]]
    data.qpos[3:7] = quaternion(log["roll"][0], log["pitch"][0], log["yaw"][0])
    data.qvel[:3] = [log["vx"][0], log["vy"][0], log["vz"][0]]
    data.qvel[3:6] = [log["p"][0], log["q"][0], log["r"][0]]
    worst = np.zeros(3)
    steps = min(len(log["t"]) - 1, int(SECONDS * RATE))
    for k in range(steps):
        data.ctrl[:] = thrusts(log, coefficients, k, lost_at)
        # Drag in the world frame and yaw drag in the body frame are generalised forces of the free joint.
        data.qfrc_applied[:3] = -DRAG * data.qvel[:3]
        data.qfrc_applied[3:6] = [0.0, 0.0, -YAW_DRAG * data.qvel[5]]
        mujoco.mj_step(model, data)
        place = np.array([log["x"][k + 1], log["y"][k + 1], log["z"][k + 1]])
        attitude = quaternion(log["roll"][k + 1], log["pitch"][k + 1], log["yaw"][k + 1])
        turn = 2.0 * np.arccos(min(1.0, abs(float(np.dot(attitude, data.qpos[3:7])))))
        rates = np.array([log["p"][k + 1], log["q"][k + 1], log["r"][k + 1]])
        here = [np.linalg.norm(data.qpos[:3] - place), turn, np.linalg.norm(data.qvel[3:6] - rates)]
        worst = np.maximum(worst, here)
    return worst, log["t"][steps]


def coefficients_of(mavc, vehicle):
    """b of each rotor (N s^2), as `mavc emit model` prints it."""
    text = subprocess.run([mavc, "emit", "model", f"specs/vehicles/{vehicle}.mav"], capture_output=True, text=True, check=True).stdout
    lines = [line for line in text.splitlines() if line.strip().startswith("rotor ") and ", b " in line]
    return np.array([float(line.split(", b ")[1].split(" ")[0]) for line in lines])


def main():
    mavc = sys.argv[1]
    print(f"MuJoCo {mujoco.__version__}; {SECONDS:g} s at {RATE:g} Hz")
    print(f"{'vehicle':16} {'fault':12} {'position [m]':>14} {'attitude [rad]':>15} {'rates [rad/s]':>14}")
    worst = np.zeros(3)
    with tempfile.TemporaryDirectory() as folder:
        for vehicle in VEHICLES:
            coefficients = coefficients_of(mavc, vehicle)
            for name, fault, lost_at in [("none", "", np.inf), ("rotor 1 lost", "fault out at 500 ms", 0.5)]:
                found, _ = compare(*flown(mavc, folder, vehicle, fault), coefficients, lost_at)
                print(f"{vehicle:16} {name:12} {found[0]:14.2e} {found[1]:15.2e} {found[2]:14.2e}")
                worst = np.maximum(worst, found)
    print("largest          {:12} {:14.2e} {:15.2e} {:14.2e}".format("", *worst))


main()
