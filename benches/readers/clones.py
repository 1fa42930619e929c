"""Readers that are in no registry, built from clones of their sources."""

import subprocess
from pathlib import Path

import numpy as np
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

HERE = Path(__file__).parent


def built(program, command):
    """A program, compiled unless it is there."""
    if not program.exists():
        subprocess.run([*command, "-o", program], check=True)
    return program


def segments(clone, folder, path):
    """What mav_trajectory_generation's own reader of files finds: the time (ns) and the coefficients of each segment."""
    here, library = HERE / "mav_trajectory_generation", Path(clone, "mav_trajectory_generation")
    names = ("io", "segment", "polynomial", "trajectory", "vertex", "motion_defines", "rpoly/rpoly_ak1")
    sources = [here / "read.cpp", *(library / "src" / f"{name}.cpp" for name in names)]
    command = ["g++", "-O1", "-w", "-I", here, "-I", library / "include", "-I", "/usr/include/eigen3", *sources]
    reader = built(Path(folder, "read_yaml"), [*command, "-lyaml-cpp", "-lglog"])
    lines = subprocess.run([reader, path], check=True, capture_output=True, text=True).stdout.split("\n")
    numbers = [np.array(line.split(), dtype=float) for line in lines if line]
    return [(line[0], line[1:].reshape(4, -1)) for line in numbers]


def flown_by_firmware(clone, folder, pieces, times):
    """Position, velocity and yaw at each time, by the firmware of a Crazyflie from the bytes in its memory."""
    modules = Path(clone, "src/modules")
    command = ["gcc", "-O1", "-w", "-I", modules / "interface", HERE / "crazyflie.c", modules / "src/pptraj.c", "-lm"]
    reader = built(Path(folder, "read_pieces"), command)
    memory = Path(folder, "pieces.bin")
    memory.write_bytes(pieces)
    given = "\n".join(repr(float(t)) for t in times)
    printed = subprocess.run([reader, memory], input=given, check=True, capture_output=True, text=True).stdout
    return np.array([line.split() for line in printed.split("\n") if line], dtype=float)


def through_message(clone, table):
    """How many numbers of PX4's table change when each row becomes the message TrajectorySetpoint of px4_msgs, in its bytes and back.
    Every column has to be a field of the message and the other way round."""
    store, name = get_typestore(Stores.ROS2_HUMBLE), "px4_msgs/msg/TrajectorySetpoint"
    store.register(get_types_from_msg(Path(clone, "msg/TrajectorySetpoint.msg").read_text(), name))
    kind = store.types[name]
    vectors = ("position", "velocity", "acceleration", "jerk")
    assert set(table) == {"timestamp", "yaw", "yawspeed", *(f"{vector}[{i}]" for vector in vectors for i in range(3))}
    single = {column: values.astype(np.float32) for column, values in table.items()}
    changed = 0
    for i, time in enumerate(table["timestamp"]):
        of = {v: np.array([single[f"{v}[{k}]"][i] for k in range(3)]) for v in vectors}
        sent = kind(timestamp=int(time), yaw=single["yaw"][i], yawspeed=single["yawspeed"][i], **of)
        got = store.deserialize_cdr(store.serialize_cdr(sent, name), name)
        changed += got.timestamp != time or any(np.any(getattr(got, v) != of[v]) for v in vectors)
        changed += got.yaw != single["yaw"][i] or got.yawspeed != single["yawspeed"][i]
    return int(changed)
