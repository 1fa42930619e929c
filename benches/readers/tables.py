"""Tables: csv, rows and px4 (numpy), and crazyflie (numpy as Crazyswarm reads it, cflib)."""

import os
import struct

import clones
import numpy as np
from cflib.crazyflie.mem.trajectory_memory import Poly4D
from exact import FRD, NED, columns, rotation, turned

MAX = lambda difference: float(np.max(np.abs(difference)))
VECTORS = {"position": ("x", "y", "z"), "velocity": ("vx", "vy", "vz"), "acceleration": ("ax", "ay", "az"), "jerk": ("jx", "jy", "jz")}
GRAVITY = 9.81


def stack(table, names):
    return np.stack([table[name] for name in names], axis=1)


def csv(plan):
    """Both frames at a rate, against the nodes evaluated."""
    enu = columns(plan.write("enu.csv", "--rate", "40Hz", "--frame", "enu-flu"))
    ned = columns(plan.write("ned.csv", "--rate", "40Hz", "--frame", "ned-frd"))
    times = enu["t"]
    for order, (what, names) in enumerate(VECTORS.items()):
        exact = plan.exact.at(times, order)[:, :3]
        yield "csv enu-flu, numpy", what, MAX(stack(enu, names) - exact), 1e-9
        yield "csv ned-frd, numpy", what, MAX(stack(ned, names) - exact @ NED.T), 1e-9
    yield "csv ned-frd, numpy", "yaw", MAX(ned["yaw"] - (np.pi / 2 - plan.exact.at(times, 0)[:, 3])), 1e-9
    # The ZYX angles make the attitude M R B.
    world = plan.exact.attitude(times, GRAVITY)
    yield "csv ned-frd, numpy", "attitude of the angles", MAX(zyx(ned) - NED @ world @ FRD), 1e-8
    yield "csv enu-flu, numpy", "attitude of the angles", MAX(zyx(enu) - world), 1e-8


def zyx(table):
    """Rotation matrices of roll, pitch, yaw."""
    one, zero = np.ones(len(table["t"])), np.zeros(len(table["t"]))
    (cr, sr), (cp, sp), (cy, sy) = ((np.cos(table[name]), np.sin(table[name])) for name in ("roll", "pitch", "yaw"))
    about = lambda rows: np.stack([np.stack(row, axis=1) for row in rows], axis=1)
    x = about([[one, zero, zero], [zero, cr, -sr], [zero, sr, cr]])
    y = about([[cp, zero, sp], [zero, one, zero], [-sp, zero, cp]])
    z = about([[cy, -sy, zero], [sy, cy, zero], [zero, zero, one]])
    return z @ y @ x


def rows(plan):
    """Attitude and rates by another formula, and by differences. Between nodes: at them the jerk may jump."""
    for frame, world, body in (("enu-flu", np.eye(3), np.eye(3)), ("ned-frd", NED, FRD)):
        table = columns(plan.write("rows.csv", "--format", "rows", "--rate", "37Hz", "--frame", frame))
        reader, times = f"rows {frame}, numpy", table["t"]
        for order, (what, names) in enumerate(VECTORS.items()):
            yield reader, what, MAX(stack(table, names) - plan.exact.at(times, order)[:, :3] @ world.T), 1e-9
        attitude = world @ plan.exact.attitude(times, GRAVITY) @ body
        yield reader, "attitude", MAX(rotation(stack(table, ("qw", "qx", "qy", "qz"))) - attitude), 1e-9
        inside = np.min(np.abs(times[:, None] - plan.exact.times[None, :]), axis=1) > 1e-4
        rates = plan.exact.rates(times, GRAVITY) @ body.T
        yield reader, "body rates", MAX((stack(table, ("p", "q", "r")) - rates)[inside]), 1e-6
        marked = table["waypoint"][~np.isnan(table["waypoint"])]
        yield reader, "marks in order", MAX(np.diff(marked) - 1), 0


def px4(plan):
    """float32 as PX4 has them."""
    table = columns(plan.write("px4.csv", "--format", "px4"))
    times = table["timestamp"] / 1e6
    for order, what in enumerate(VECTORS):
        values = np.stack([table[f"{what}[{i}]"] for i in range(3)], axis=1)
        # The text is the shortest of a float32.
        yield "px4, numpy", f"{what} beyond float32", sum(float(str(np.float32(v))) != v for v in values.flat), 0
        exact = plan.exact.at(times, order)[:, :3] @ NED.T
        # What PX4 gets.
        yield "px4, numpy", what, MAX(values.astype(np.float32) - exact), 1e-7 * max(1, np.max(np.abs(exact)))
    yaw = np.pi / 2 - plan.exact.at(times, 0)[:, 3]
    yield "px4, numpy", "yaw", MAX(turned(table["yaw"] - yaw)), 1e-6
    yield "px4, numpy", "yaw within pi", max(0.0, MAX(table["yaw"]) - np.pi), 1e-6
    yield "px4, numpy", "yawspeed", MAX(table["yawspeed"] + plan.exact.at(times, 1)[:, 3]), 1e-6
    clone = os.environ.get("PX4_MSGS")
    if clone:
        yield "px4, px4_msgs by rosbags", "through the message", clones.through_message(clone, table), 0


def crazyflie(plan):
    """As Crazyswarm's uav_trajectory.py reads it, packed by cflib, with the numbers of the Crazyflie's float32."""
    path = plan.write("crazyflie.csv", "--format", "crazyflie")
    with open(path) as file:
        data = np.loadtxt(file, delimiter=",", skiprows=1, usecols=range(33))
    assert len(data) >= 2 and path.read_text().startswith("duration,x^0,")
    pieces = []
    for row in data:
        packed = Poly4D(row[0], *(Poly4D.Poly(list(row[1 + 8 * i : 9 + 8 * i])) for i in range(4))).pack()
        values = np.array(struct.unpack("<33f", packed))
        pieces.append((values[32], values[:32].reshape(4, 8)))
    yield "crazyflie, cflib", "bytes", 132.0 * len(pieces), 4096
    begin, errors, velocities, yaws, joins = 0.0, [], [], [], []
    for k, (duration, coefficients) in enumerate(pieces):
        s = np.linspace(0, duration, 200)
        value = lambda order: np.stack([np.polyval(np.polyder(c[::-1], order), s) if order else np.polyval(c[::-1], s) for c in coefficients], axis=1)
        exact = [plan.exact.at(begin + s, order) for order in (0, 1)]
        errors.append(np.max(np.linalg.norm((value(0) - exact[0])[:, :3], axis=1)))
        velocities.append(np.max(np.linalg.norm((value(1) - exact[1])[:, :3], axis=1)))
        yaws.append(MAX((value(0) - exact[0])[:, 3]))
        if k:
            joins.append([MAX(value(order)[0] - last[order]) for order in range(3)])
        last = [value(order)[-1] for order in range(3)]
        begin += duration
    yield "crazyflie, cflib", "position, m", max(errors), 0.01
    yield "crazyflie, cflib", "velocity, m/s", max(velocities), 0.05
    yield "crazyflie, cflib", "yaw, rad", max(yaws), 0.01
    # mavc states the largest position error, in mm; it is found at other instants than here.
    stated = float(plan.said.split("position within ")[1].split(" mm")[0])
    yield "crazyflie, cflib", "beyond what mavc states", max(errors) - 1e-3 * stated, 2e-6
    for order, what in enumerate(("position", "velocity", "acceleration")):
        yield "crazyflie, cflib", f"jump of {what}", max(join[order] for join in joins), 1e-4
    yield "crazyflie, cflib", "duration", abs(begin - plan.exact.times[-1]), 1e-5


CHECKS = [csv, rows, px4, crazyflie]
