"""The players, each against a vehicle that only records: a thread that speaks MAVLink with pymavlink on loopback, says that it is armed
and where it is, accepts every command, parameter and mission, and keeps what it is sent."""

import os
import signal
import struct
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
BRAKE, HOLD = 17, 4 << 16 | 3 << 24


class Vehicle(threading.Thread):
    """Records SET_POSITION_TARGET_LOCAL_NED with the time of its arrival, parameters by name, and the items of a mission."""

    def __init__(self, port, autopilot, place):
        super().__init__(daemon=True)
        self.link = mavutil.mavlink_connection(f"udpout:127.0.0.1:{port}", source_system=1, source_component=1, dialect="ardupilotmega")
        self.autopilot, self.place, self.mode, self.ends = autopilot, place, 0, False
        self.received, self.parameters, self.mission, self.due = [], {}, [], 0
        self.start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.ends = True
        self.join()
        self.link.close()

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
            if message is not None:
                getattr(self, message.get_type().lower(), lambda _: None)(message)

    def set_position_target_local_ned(self, message):
        self.received.append((time.monotonic(), message))

    def set_mode(self, message):
        self.mode = message.custom_mode

    def command_long(self, message):
        if message.command == MAVLINK.MAV_CMD_DO_SET_MODE:
            mode = int(message.param2)
            self.mode = mode if self.autopilot == MAVLINK.MAV_AUTOPILOT_ARDUPILOTMEGA else mode << 16 | int(message.param3) << 24
        self.link.mav.command_ack_send(message.command, MAVLINK.MAV_RESULT_ACCEPTED)

    command_int = command_long

    def param_set(self, message):
        """PX4 has the bits of an integer in the field of the float; pymavlink reads that field as a float."""
        is_integer = message.param_type == MAVLINK.MAV_PARAM_TYPE_INT32
        value = struct.unpack("<i" if is_integer else "<f", struct.pack("<f", message.param_value))[0]
        self.parameters[message.param_id] = value
        answer = message.param_id.encode(), message.param_value, message.param_type, len(self.parameters), 0
        self.link.mav.param_value_send(*answer)

    def mission_count(self, message):
        self.mission, self.due = [], message.count
        self.ask_for_item()

    def ask_for_item(self):
        self.link.mav.mission_request_int_send(255, 0, len(self.mission))

    def mission_item_int(self, message):
        if message.seq == len(self.mission):
            self.mission.append(message)
        if len(self.mission) < self.due:
            self.ask_for_item()
        else:
            self.link.mav.mission_ack_send(255, 0, MAVLINK.MAV_MISSION_ACCEPTED)


def played(plan, script, port, autopilot, address):
    """What arrives while the script plays the plan."""
    start = (plan.exact.at([0], 0)[0, :3] @ NED.T).tolist()
    with Vehicle(port, autopilot, start) as vehicle:
        ran = subprocess.run([sys.executable, script, address], capture_output=True, text=True, timeout=90)
    if ran.returncode != 0:
        sys.exit(f"{script}: exit code {ran.returncode}\n{ran.stdout}{ran.stderr}")
    return vehicle.received


def fields(message):
    return [[message.x, message.y, message.z], [message.vx, message.vy, message.vz], [message.afx, message.afy, message.afz]]


def ardupilot_guided(plan):
    script = plan.write("guided.py", "--format", "ardupilot-guided")
    received = played(plan, script, 14661, MAVLINK.MAV_AUTOPILOT_ARDUPILOTMEGA, "udpin:127.0.0.1:14661")
    yield from of_guided("ardupilot-guided, pymavlink", plan.exact, received)


def of_guided(reader, exact, received, offset=(0, 0, 0)):
    """Setpoints in GUIDED mode against the plan, moved by an offset (m; north, east, down)."""
    messages = [message for _, message in received]
    times = np.array([message.time_boot_ms for message in messages]) * 1e-3
    assert all(message.type_mask == 0 and message.coordinate_frame == MAVLINK.MAV_FRAME_LOCAL_NED for message in messages)
    # Times are whole milliseconds; setpoints are those of a grid of 20 ms.
    yield reader, "setpoints that are missing", abs(len(messages) - round(exact.times[-1] * 50) - 1), 0
    for order, what in enumerate(list(VECTORS)[:3]):
        due = exact.at(times, order)[:, :3] @ NED.T + (np.array(offset) if order == 0 else 0)
        yield reader, what, MAX(np.array([fields(m)[order] for m in messages]) - due), 1e-5
    yield reader, "yaw", MAX(turned(np.array([m.yaw for m in messages]) - np.pi / 2 + exact.at(times, 0)[:, 3])), 1e-5
    yield reader, "yaw_rate", MAX(np.array([m.yaw_rate for m in messages]) + exact.at(times, 1)[:, 3]), 1e-5
    arrived = np.array([at for at, _ in received])
    yield reader, "late or early, s", MAX(arrived - arrived[0] - times), 0.1


def px4_offboard(plan):
    script = plan.write("offboard.py", "--format", "px4-offboard")
    received = played(plan, script, 14662, MAVLINK.MAV_AUTOPILOT_PX4, "udpin://127.0.0.1:14662")
    yield from of_offboard("px4-offboard, mavsdk to pymavlink", plan.exact, received)


def of_offboard(reader, exact, received, offset=(0, 0, 0)):
    """Setpoints in offboard mode against the plan, moved by an offset (m; north, east, down). MAVSDK sends each setpoint when it is set,
    and the last one again 20 times a second: every message is one of the plan's setpoints."""
    grid = np.arange(0, round(exact.times[-1] * 50) + 1) / 50
    due = np.concatenate([exact.at(grid, order)[:, :3] @ NED.T + (np.array(offset) if order == 0 else 0) for order in range(3)], axis=1)
    got = np.array([sum(fields(message), []) for _, message in received])
    # In their order: each is one of the 8 s after the one before. In a hold many are alike.
    nearest, last = [], 0
    for row in got:
        last += int(np.argmin(np.sum((due[last : last + 400] - row) ** 2, axis=1)))
        nearest.append(last)
    for order, what in enumerate(list(VECTORS)[:3]):
        part = slice(3 * order, 3 * order + 3)
        yield reader, what, MAX(got[:, part] - due[nearest, part]), 1e-5
    yaw = np.array([message.yaw for _, message in received])
    yield reader, "yaw", MAX(turned(yaw - np.pi / 2 + exact.at(grid, 0)[nearest, 3])), 1e-5
    missing = sum(np.min(np.max(np.abs(got - row), axis=1)) > 1e-5 for row in due)
    yield reader, "setpoints that are missing", int(missing), 0.02 * len(grid)


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


def stopped(plan):
    """Ctrl-C in the middle of the plan: the mode that the vehicle is left in."""
    ardupilot, px4 = MAVLINK.MAV_AUTOPILOT_ARDUPILOTMEGA, MAVLINK.MAV_AUTOPILOT_PX4
    for name, autopilot, port, mode in (("ardupilot-guided", ardupilot, 14663, BRAKE), ("px4-offboard", px4, 14664, HOLD)):
        script = plan.write("player.py", "--format", name)
        address = f"{'udpin:' if autopilot == ardupilot else 'udpin://'}127.0.0.1:{port}"
        start = (plan.exact.at([0], 0)[0, :3] @ NED.T).tolist()
        with Vehicle(port, autopilot, start) as vehicle:
            player = subprocess.Popen([sys.executable, script, address], stderr=subprocess.PIPE, text=True)
            until = time.monotonic() + 30
            while len(vehicle.received) < 50 and time.monotonic() < until:
                time.sleep(0.02)
            player.send_signal(signal.SIGINT)
            said = player.communicate(timeout=30)[1]
            time.sleep(0.2)
        assert player.returncode == 1 and "stopped: the vehicle" in said, said
        yield f"{name}, Ctrl-C", "modes other than the due one", int(vehicle.mode != mode), 0


CHECKS = [ardupilot_guided, px4_offboard, starts, stopped]
