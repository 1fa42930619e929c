"""Bags and logs: rosbags and mcap-ros2-support read the bag; pyulog and mcap read flights, against the same flight's csv."""

import json
import xml.etree.ElementTree as ElementTree

import numpy as np
from exact import FRD, NED, columns, rotation, turned
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from pyulog import ULog
from rosbags.highlevel import AnyReader
from rosbags.rosbag2 import Reader
from rosbags.typesys import Stores, get_typestore
from tables import GRAVITY, MAX, VECTORS, stack


def rosbag2(plan):
    folder = plan.write("bag", "--format", "rosbag2")
    with AnyReader([folder], default_typestore=get_typestore(Stores.ROS2_HUMBLE)) as reader:
        (message,) = [reader.deserialize(raw, connection.msgtype) for connection, _, raw in reader.messages()]
    yield from of_message(plan, message, "rosbag2 folder, rosbags")
    with Reader(folder) as reader:
        yield "rosbag2 folder, rosbags", "messages of metadata", reader.message_count - 1, 0
    path = plan.write("plan.mcap", "--format", "rosbag2")
    # rosbags has definitions of its own; this decoder uses the one in the file.
    with open(path, "rb") as file:
        (found,) = make_reader(file, validate_crcs=True, decoder_factories=[DecoderFactory()]).iter_decoded_messages()
    yield from of_message(plan, found.decoded_message, "rosbag2 file, mcap-ros2-support")


def of_message(plan, message, reader):
    assert message.header.frame_id == "world" and list(message.joint_names) == ["vehicle"]
    array = lambda get, names: np.array([[getattr(get(point), name) for name in names] for point in message.points])
    times = np.array([p.time_from_start.sec + 1e-9 * p.time_from_start.nanosec for p in message.points])
    xyz = ("x", "y", "z")
    linear = [lambda p: p.transforms[0].translation, lambda p: p.velocities[0].linear, lambda p: p.accelerations[0].linear]
    for order, (get, what) in enumerate(zip(linear, VECTORS)):
        yield reader, what, MAX(array(get, xyz) - plan.exact.at(times, order)[:, :3]), 1e-7
    world = plan.exact.attitude(times, GRAVITY)
    yield reader, "attitude", MAX(rotation(array(lambda p: p.transforms[0].rotation, ("w", *xyz))) - world), 1e-7
    inside = np.min(np.abs(times[:, None] - plan.exact.times[None, :]), axis=1) > 1e-3
    rates = np.einsum("tij,tj->ti", world, plan.exact.rates(times, GRAVITY))
    yield reader, "angular velocity", MAX((array(lambda p: p.velocities[0].angular, xyz) - rates)[inside]), 1e-6
    h = 1e-4
    later, sooner = (np.einsum("tij,tj->ti", plan.exact.attitude(times + s, GRAVITY), plan.exact.rates(times + s, GRAVITY)) for s in (h, -h))
    turning = (later - sooner) / (2 * h)
    yield reader, "angular acceleration", MAX((array(lambda p: p.accelerations[0].angular, xyz) - turning)[inside]), 1e-3


def ulog(plan):
    log = ULog(str(plan.fly("flight.ulg", "--format", "ulog", "--layout", plan.folder / "layout.xml")))
    table = columns(plan.fly("flight.csv"))
    topics = {data.name: data.data for data in log.data_list}
    yield "ulog, pyulog", "corruption", float(log.file_corruption), 0
    local = topics["vehicle_local_position"]
    yield "ulog, pyulog", "time, s", MAX(local["timestamp"] / 1e6 - table["t"]), 1e-6
    single = lambda values, exact: MAX(values - exact) / max(1.0, MAX(exact))
    yield "ulog, pyulog", "position", single(stack(local, "xyz"), stack(table, "xyz") @ NED.T), 1e-6
    yield "ulog, pyulog", "velocity", single(stack(local, ("vx", "vy", "vz")), stack(table, VECTORS["velocity"]) @ NED.T), 1e-6
    yield "ulog, pyulog", "heading", MAX(turned(local["heading"] - np.pi / 2 + table["yaw"])), 1e-6
    q = np.stack([topics["vehicle_attitude"][f"q[{i}]"] for i in range(4)], axis=1).astype(float)
    yield "ulog, pyulog", "attitude", MAX(rotation(q) - NED @ of_angles(table) @ FRD), 1e-6
    rates = np.stack([topics["vehicle_angular_velocity"][f"xyz[{i}]"] for i in range(3)], axis=1)
    yield "ulog, pyulog", "body rates", MAX(rates - stack(table, "pqr") @ FRD), 1e-5
    setpoint = np.stack([topics["trajectory_setpoint"][f"position[{i}]"] for i in range(3)], axis=1)
    yield "ulog, pyulog", "reference", MAX(setpoint - stack(table, ("x_ref", "y_ref", "z_ref")) @ NED.T), 1e-5
    for name in ("omega", "theta", "believed"):
        columns_of = [key for key in table if key.startswith(name + "_")]
        yield "ulog, pyulog", name, max(single(topics["mavc_rotors"][key], table[key]) for key in columns_of), 1e-6
    # The layout names topics and fields that are there.
    curves = [curve.get("name").split("/") for curve in ElementTree.parse(plan.folder / "layout.xml").iter("curve")]
    yield "ulog, layout", "curves that are missing", sum(field not in topics[topic] for topic, field in curves) + (not curves), 0


def of_angles(table):
    from tables import zyx

    return zyx(table)


def mcap(plan):
    path, layout = plan.fly("flight.mcap", "--format", "mcap", "--layout", plan.folder / "layout.json"), plan.folder / "layout.json"
    table = columns(plan.fly("flight.csv"))
    with open(path, "rb") as file:
        reader = make_reader(file, validate_crcs=True)
        summary = reader.get_summary()
        messages = [(channel.topic, schema.name, json.loads(message.data)) for schema, channel, message in reader.iter_messages()]
    flight = [data for topic, _, data in messages if topic == "/flight"]
    of = lambda group, names: np.array([[row[group][name] for name in names] for row in flight])
    yield "mcap, mcap", "count of the statistics", summary.statistics.message_count - len(messages), 0
    yield "mcap, mcap", "position", MAX(of("position", "xyz") - stack(table, "xyz")), 0
    yield "mcap, mcap", "velocity", MAX(of("velocity", "xyz") - stack(table, VECTORS["velocity"])), 0
    yield "mcap, mcap", "angles", MAX(of("angles", ("roll", "pitch", "yaw")) - stack(table, ("roll", "pitch", "yaw"))), 0
    omega = np.array([[rotor["omega"] for rotor in row["rotors"]] for row in flight])
    yield "mcap, mcap", "omega", MAX(omega - stack(table, [key for key in table if key.startswith("omega_")])), 0
    vehicle = [data for _, name, data in messages if name == "foxglove.FrameTransform" and data["child_frame_id"] == "vehicle"]
    q = np.array([[row["rotation"][name] for name in "wxyz"] for row in vehicle])
    yield "mcap, mcap", "attitude of /tf", MAX(rotation(q) - of_angles(table)), 1e-9
    # The layout's paths lead to numbers.
    paths = [p["value"] for panel in json.loads(layout.read_text())["configById"].values() for p in panel.get("paths", [])]
    yield "mcap, layout", "paths that are missing", sum(not leads(path, flight[0]) for path in paths) + (not paths), 0


def leads(path, row):
    """Whether a path such as /flight.rotors[0].omega leads to a number."""
    for step in path.removeprefix("/flight.").replace("[", ".").replace("]", "").split("."):
        row = row[int(step)] if step.isdigit() else row[step]
    return isinstance(row, (int, float))


CHECKS = [rosbag2]
OF_FLIGHTS = [ulog, mcap]
