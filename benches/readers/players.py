"""The players, each against a vehicle that only records: a thread that speaks MAVLink with pymavlink on loopback, says that it is armed
and where the plan begins, accepts every command, and keeps what it is sent."""

import os
import subprocess
import sys
import threading
import time

os.environ["MAVLINK20"] = "1"

import numpy as np  # noqa: E402
from exact import NED, turned  # noqa: E402
from pymavlink import mavutil  # noqa: E402
from simulators import module  # noqa: E402
from tables import MAX, VECTORS  # noqa: E402

MAVLINK = mavutil.mavlink
GUIDED, OFFBOARD = 4, 6 << 16


class Vehicle(threading.Thread):
    """Records SET_POSITION_TARGET_LOCAL_NED with the time of its arrival."""

    def __init__(self, port, autopilot, place):
        super().__init__(daemon=True)
        self.link = mavutil.mavlink_connection(f"udpout:127.0.0.1:{port}", source_system=1, source_component=1, dialect="ardupilotmega")
        self.autopilot, self.place, self.mode, self.received, self.ends = autopilot, place, 0, [], False

    def run(self):
        beat, began = 0.0, time.monotonic()
        armed = MAVLINK.MAV_MODE_FLAG_SAFETY_ARMED | MAVLINK.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
        while not self.ends:
            now = time.monotonic()
            if now - beat > 0.1:
                beat = now
                self.link.mav.heartbeat_send(MAVLINK.MAV_TYPE_QUADROTOR, self.autopilot, armed, self.mode, MAVLINK.MAV_STATE_ACTIVE)
                self.link.mav.local_position_ned_send(int(1000 * (now - began)), *self.place, 0, 0, 0)
            message = self.link.recv_match(blocking=True, timeout=0.02)
            if message is None:
                continue
            if message.get_type() == "SET_POSITION_TARGET_LOCAL_NED":
                self.received.append((time.monotonic(), message))
            elif message.get_type() == "SET_MODE":
                self.mode = message.custom_mode
            elif message.get_type() in ("COMMAND_LONG", "COMMAND_INT"):
                if message.command == MAVLINK.MAV_CMD_DO_SET_MODE:
                    mode = int(message.param2)
                    self.mode = mode if self.autopilot == MAVLINK.MAV_AUTOPILOT_ARDUPILOTMEGA else mode << 16 | int(message.param3) << 24
                self.link.mav.command_ack_send(message.command, MAVLINK.MAV_RESULT_ACCEPTED)


def played(plan, script, port, autopilot, address):
    """What arrives while the script plays the plan."""
    start = (plan.exact.at([0], 0)[0, :3] @ NED.T).tolist()
    vehicle = Vehicle(port, autopilot, start)
    vehicle.start()
    ran = subprocess.run([sys.executable, script, address], capture_output=True, text=True, timeout=90)
    vehicle.ends = True
    vehicle.join()
    if ran.returncode != 0:
        sys.exit(f"{script}: exit code {ran.returncode}\n{ran.stdout}{ran.stderr}")
    return vehicle.received


def fields(message):
    return [[message.x, message.y, message.z], [message.vx, message.vy, message.vz], [message.afx, message.afy, message.afz]]


def ardupilot_guided(plan):
    script = plan.write("guided.py", "--format", "ardupilot-guided")
    received = played(plan, script, 14661, MAVLINK.MAV_AUTOPILOT_ARDUPILOTMEGA, "udpin:127.0.0.1:14661")
    reader = "ardupilot-guided, pymavlink"
    messages = [message for _, message in received]
    times = np.array([message.time_boot_ms for message in messages]) * 1e-3
    assert all(message.type_mask == 0 and message.coordinate_frame == MAVLINK.MAV_FRAME_LOCAL_NED for message in messages)
    # Times are whole milliseconds; setpoints are those of a grid of 20 ms.
    yield reader, "setpoints that are missing", abs(len(messages) - round(plan.exact.times[-1] * 50) - 1), 0
    for order, what in enumerate(list(VECTORS)[:3]):
        exact = plan.exact.at(times, order)[:, :3] @ NED.T
        yield reader, what, MAX(np.array([fields(m)[order] for m in messages]) - exact), 1e-5
    yield reader, "yaw", MAX(turned(np.array([m.yaw for m in messages]) - np.pi / 2 + plan.exact.at(times, 0)[:, 3])), 1e-5
    yield reader, "yaw_rate", MAX(np.array([m.yaw_rate for m in messages]) + plan.exact.at(times, 1)[:, 3]), 1e-5
    arrived = np.array([at for at, _ in received])
    yield reader, "late or early, s", MAX(arrived - arrived[0] - times), 0.1


def px4_offboard(plan):
    script = plan.write("offboard.py", "--format", "px4-offboard")
    received = played(plan, script, 14662, MAVLINK.MAV_AUTOPILOT_PX4, "udpin://127.0.0.1:14662")
    # MAVSDK sends each setpoint when it is set, and the last one again 20 times a second: every message is one of the plan's setpoints.
    grid = np.arange(0, round(plan.exact.times[-1] * 50) + 1) / 50
    exact = np.concatenate([plan.exact.at(grid, order)[:, :3] @ NED.T for order in range(3)], axis=1)
    got = np.array([sum(fields(message), []) for _, message in received])
    nearest = np.array([np.argmin(np.sum((exact - row) ** 2, axis=1)) for row in got])
    reader = "px4-offboard, mavsdk to pymavlink"
    for order, what in enumerate(list(VECTORS)[:3]):
        part = slice(3 * order, 3 * order + 3)
        yield reader, what, MAX(got[:, part] - exact[nearest, part]), 1e-5
    yaw = np.array([message.yaw for _, message in received])
    yield reader, "yaw", MAX(turned(yaw - np.pi / 2 + plan.exact.at(grid, 0)[nearest, 3])), 1e-5
    yield reader, "setpoints that are missing", len(grid) - len(set(nearest.tolist())), 0.02 * len(grid)
    yield reader, "steps back", int(np.sum(np.diff(nearest) < 0)), 0


def starts(plan):
    """A vehicle far from the start is refused, or the plan is moved to it."""
    for name in ("ardupilot-guided", "px4-offboard"):
        script = module(plan.write("player.py", "--format", name), "player")
        first = np.array(script.SETPOINTS[0][1:4])
        refused = 0
        for away, here in ((0.5, False), (3.0, False), (3.0, True)):
            try:
                offset = np.array(script.start_of(here, first + [0, away, 0]))
            except SystemExit:
                refused += 1
                continue
            yield f"{name}, {away} m off", "moved by, m", MAX(offset - [0, away if here else 0, 0]), 1e-12
        yield name, "refusals but one", abs(refused - 1), 0


CHECKS = [ardupilot_guided, px4_offboard, starts]
