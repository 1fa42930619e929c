#!/usr/bin/env python3
"""A PLAN

Flies the plan in ArduPilot's GUIDED mode by SET_POSITION_TARGET_LOCAL_NED. Needs: pip install pymavlink

    python3 plan.py udpin:0.0.0.0:14550 --here

The vehicle has to hover, armed, near the start of the plan; the script neither arms nor takes off. Positions are relative to the
origin of the EKF; --here moves the plan so that it begins where the vehicle is. At the end the vehicle stays in GUIDED mode, at the
end of the plan; Ctrl-C puts it into BRAKE mode.
"""
import argparse
import math
import sys
import time

# t (s); position (m), velocity (m/s), acceleration (m/s^2) in north, east, down; yaw (rad, clockwise from north), its rate (rad/s).
SETPOINTS = []  # the plan

# Nothing is ignored: position, velocity, acceleration (bit 9 clear: no force), yaw and yaw rate.
TYPE_MASK = 0
# MAV_FRAME_LOCAL_NED
LOCAL_NED = 1
# The vehicle has to be as near to the start of the plan, m.
NEAR = 1.0


def fields(setpoint, offset=(0.0, 0.0, 0.0)):
    """The fields of SET_POSITION_TARGET_LOCAL_NED from x to yaw_rate for one setpoint, its position moved by an offset (m)."""
    return [setpoint[1 + i] + offset[i] for i in range(3)] + list(setpoint[4:12])


def start_of(here, place, near=NEAR):
    """How far the plan is moved (m) for a vehicle at a place; refuses a vehicle too far from the start."""
    away = [place[i] - SETPOINTS[0][1 + i] for i in range(3)]
    if here:
        return away
    if math.dist(away, (0, 0, 0)) > near:
        sys.exit(f"the vehicle is {math.dist(away, (0, 0, 0)):.1f} m from the start of the plan: fly there, or use --here")
    return (0.0, 0.0, 0.0)


def play(link, offset, clock=time.monotonic, sleep=time.sleep):
    """Sends every setpoint at its time."""
    begin = clock()
    for setpoint in SETPOINTS:
        wait = begin + setpoint[0] - clock()
        if wait > 0:
            sleep(wait)
        link.mav.set_position_target_local_ned_send(
            round(1000 * setpoint[0]), link.target_system, link.target_component, LOCAL_NED, TYPE_MASK, *fields(setpoint, offset)
        )


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("address", help="connection of pymavlink, such as udpin:0.0.0.0:14550")
    arguments.add_argument("--here", action="store_true", help="move the plan so that it begins where the vehicle is")
    options = arguments.parse_args()

    from pymavlink import mavutil

    link = mavutil.mavlink_connection(options.address)
    if link.wait_heartbeat(timeout=30) is None:
        sys.exit(f"no heartbeat within 30 s at {options.address}")
    if not link.motors_armed():
        sys.exit("the vehicle is not armed: take off first")
    at = link.recv_match(type="LOCAL_POSITION_NED", blocking=True, timeout=30)
    if at is None:
        sys.exit("no LOCAL_POSITION_NED within 30 s: ask for it with MAV_CMD_SET_MESSAGE_INTERVAL or SR parameters")
    offset = start_of(options.here, (at.x, at.y, at.z))
    link.set_mode("GUIDED")
    until = time.monotonic() + 5.0
    while link.flightmode != "GUIDED":
        link.recv_match(type="HEARTBEAT", blocking=True, timeout=1)
        if time.monotonic() > until:
            sys.exit("the vehicle does not take GUIDED mode")
    print(f"{SETPOINTS[-1][0]:.1f} s to fly, moved by {offset[0]:.1f} m north, {offset[1]:.1f} m east, {offset[2]:.1f} m down", flush=True)
    try:
        play(link, offset)
    except KeyboardInterrupt:
        link.set_mode("BRAKE")
        sys.exit("stopped: the vehicle was put into BRAKE mode")
    print("the plan has ended: the vehicle stays in GUIDED mode")


if __name__ == "__main__":
    main()
