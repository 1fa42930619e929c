"""Plans and flight logs in the formats of other tools (docs/exchange.md)."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from pathlib import Path

from . import _mavc


@dataclass(frozen=True)
class Exported:
    """A plan or a flight log as another tool reads it."""

    format: str
    data: bytes = field(repr=False)
    """What the command writes, byte for byte."""
    remark: str | None = None
    """What the format lost, if it is more than rounding; the command prints it."""

    @property
    def text(self) -> str:
        """The data of a format that is a text."""
        return self.data.decode()

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes the data to a file. A ROS 2 bag whose name does not end with `.mcap` is a folder with two files, which is made
        if it is missing."""
        place = Path(path)
        if self.format == "rosbag2" and place.suffix != ".mcap":
            place.mkdir(parents=True, exist_ok=True)
            for name, data in _mavc.bag_files(place.name or "plan", self.data):
                (place / name).write_bytes(data)
        else:
            place.write_bytes(self.data)


def exported(
    format: str, found: tuple[bytes, str | None], path: str | os.PathLike[str] | None
) -> Exported:
    """What was found, also written to `path` if there is one."""
    result = Exported(format, *found)
    if path is not None:
        result.write(path)
    return result
