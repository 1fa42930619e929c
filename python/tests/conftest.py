"""The command, whose outputs the package must give bit for bit. `MAVC` names it."""

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@dataclass
class Output:
    code: int
    out: str
    err: str


class Command:
    """Runs the command in a folder of its own."""

    def __init__(self, path: Path, folder: Path) -> None:
        self.path, self.folder = path, folder

    def __call__(self, *arguments: object) -> Output:
        environment = {key: value for key, value in os.environ.items() if key != "COLUMNS"}
        done = subprocess.run(
            [self.path, *map(str, arguments)],
            cwd=self.folder,
            env=environment,
            capture_output=True,
        )
        return Output(done.returncode, done.stdout.decode(), done.stderr.decode())

    def read(self, name: str) -> str:
        return (self.folder / name).read_bytes().decode()


@pytest.fixture
def command(tmp_path: Path) -> Command:
    path = Path(os.environ.get("MAVC", ROOT / "target" / "debug" / "mavc"))
    assert path.is_file(), f"{path} is missing: name the command by MAVC"
    return Command(path.resolve(), tmp_path)


@pytest.fixture
def write(tmp_path: Path):
    """Writes a spec into the folder of the command, and goes there."""
    before = Path.cwd()

    def write(name: str, text: str) -> str:
        (tmp_path / name).write_text(text)
        os.chdir(tmp_path)
        return name

    yield write
    os.chdir(before)


@pytest.fixture
def small() -> str:
    """A spec with one fault mode, which is planned and flown in a fraction of a second."""
    return """
vehicle octo {
    layout = "PPNNPPNN"; arm = 0.211 m; mass = 1.8 kg; inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor { max_thrust = 6.53 N; torque_per_thrust = 0.016 m; max_speed = 874 rad/s }
}
faults { mode M1 { rotors [1] lost } }
mission short { start at [0, 0, 2] m; waypoint at [4, 0, 3] m; limits { speed <= 6 m/s } }
plan { planner = rsp; model = hover; samples = 30; time = 6 s }
simulate { fault M1 at 3 s }
"""


@pytest.fixture
def example():
    """The text of a spec of the repository."""
    return lambda name: (ROOT / name).read_text()
