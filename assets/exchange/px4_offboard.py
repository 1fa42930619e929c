#!/usr/bin/env python3
"""A PLAN

Flies the plan in PX4's offboard mode by set_position_velocity_acceleration_ned. Needs: pip install "mavsdk>=4"

    python3 plan.py udpin://0.0.0.0:14540 --here

The vehicle has to hover, armed, near the start of the plan; the script neither arms nor takes off. Positions are relative to the
origin of PX4's local frame; --here moves the plan so that it begins where the vehicle is. At the end, and after Ctrl-C, the vehicle
holds its place.
"""
import argparse
import math
import sys
import time

# t (s); position (m), velocity (m/s), acceleration (m/s^2) in north, east, down; yaw (rad, clockwise from north), its rate (rad/s).
SETPOINTS = []  # the plan

# The vehicle has to be as near to the start of the plan, m.
NEAR = 1.0


def messages(setpoint, offset=(0.0, 0.0, 0.0)):
    """The arguments of set_position_velocity_acceleration_ned for one setpoint, its position moved by an offset (m)."""
    from mavsdk.plugins.offboard import AccelerationNed, PositionNedYaw, VelocityNedYaw

    place = [setpoint[1 + i] + offset[i] for i in range(3)]
    yaw = math.degrees(setpoint[10])
    return PositionNedYaw(*place, yaw), VelocityNedYaw(*setpoint[4:7], yaw), AccelerationNed(*setpoint[7:10])


def start_of(here, place, near=NEAR):
    """How far the plan is moved (m) for a vehicle at a place; refuses a vehicle too far from the start."""
    away = [place[i] - SETPOINTS[0][1 + i] for i in range(3)]
    if here:
        return away
    if math.dist(away, (0, 0, 0)) > near:
        sys.exit(f"the vehicle is {math.dist(away, (0, 0, 0)):.1f} m from the start of the plan: fly there, or use --here")
    return (0.0, 0.0, 0.0)


def play(send, offset, clock=time.monotonic, sleep=time.sleep):
    """Sends every setpoint at its time."""
    begin = clock()
    for setpoint in SETPOINTS:
        wait = begin + setpoint[0] - clock()
        if wait > 0:
            sleep(wait)
        send(*messages(setpoint, offset))


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("address", help="connection of MAVSDK, such as udpin://0.0.0.0:14540")
    arguments.add_argument("--here", action="store_true", help="move the plan so that it begins where the vehicle is")
    options = arguments.parse_args()

    from mavsdk import ComponentType, Configuration, Mavsdk
    from mavsdk.plugins.offboard import Offboard
    from mavsdk.plugins.telemetry import Telemetry

    with Mavsdk(Configuration.create_with_component_type(ComponentType.GROUND_STATION)) as mavsdk:
        mavsdk.add_any_connection(options.address)
        system = mavsdk.first_autopilot(30.0)
        if system is None:
            sys.exit(f"no autopilot within 30 s at {options.address}")
        telemetry, offboard = Telemetry(system), Offboard(system)
        until = time.monotonic() + 30.0
        while not (telemetry.armed() and math.isfinite(telemetry.position_velocity_ned().position.north_m)):
            if time.monotonic() > until:
                sys.exit("the vehicle is not armed, or has no position: take off first")
            time.sleep(0.1)
        at = telemetry.position_velocity_ned().position
        offset = start_of(options.here, (at.north_m, at.east_m, at.down_m))
        send = offboard.set_position_velocity_acceleration_ned
        # PX4 takes the offboard mode only while setpoints come in.
        send(*messages(SETPOINTS[0], offset))
        offboard.start()
        print(f"{SETPOINTS[-1][0]:.1f} s to fly, moved by {offset[0]:.1f} m north, {offset[1]:.1f} m east, {offset[2]:.1f} m down", flush=True)
        try:
            play(send, offset)
        except KeyboardInterrupt:
            sys.exit("stopped: the vehicle holds its place")
        finally:
            # PX4's mode hold.
            offboard.stop()
        print("the plan has ended: the vehicle holds its place")


if __name__ == "__main__":
    main()
