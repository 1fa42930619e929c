"""Definitions that are in no registry, from clones of their sources."""

from pathlib import Path

import numpy as np
from rosbags.typesys import Stores, get_types_from_msg, get_typestore


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
