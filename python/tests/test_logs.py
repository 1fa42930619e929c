"""Flight logs, as the command reads them. The logs are of simulated flights, with the losses known."""

import importlib
import itertools
import json
import os
import random
import re
import subprocess
import sys

import mavc
import numpy as np
import pint
import pytest
from conftest import ROOT

# The scripts that make flights, and write them as DataFlash logs.
sys.path.insert(0, str(ROOT / "benches" / "diagnosis"))
dataflash, flights = (importlib.import_module(name) for name in ("dataflash", "flights"))

LOST = 4


def hexacopter():
    """The first random flight of a hexacopter along lanes that loses motor 4."""
    for seed in itertools.count():
        flight = flights.Flight(random.Random(seed))
        if (flight.layout, flight.mission, flight.motor, flight.capacity) == ("hexa PNPNPN", "lanes", LOST, 0.0):
            return flight


class Flown:
    """Logs of one hexacopter: `good` flights, and one in which motor 4 is `lost`."""

    def __init__(self, folder, path):
        self.folder, self.path = folder, path
        flight = hexacopter()
        self.mass, self.time = flight.mass, flight.time
        self.full = float(re.search(r"max_thrust *= ([0-9.]+) N", flight.spec)[1])
        self.spec = mavc.compile(flight.spec, warn=False)
        good = flight.spec.replace(f"\n    fault F at {flight.time} s", "")
        assert good != flight.spec
        # Another flight: in other gusts.
        other = re.sub(r"seed = \d+", "seed = 1001", good)
        flight.noise = 0.004
        for name, text, rate, seed in [("lost", flight.spec, 50, 1), ("good", good, 50, 2), ("other", other, 50, 3), ("slow", good, 1, 4)]:
            table = folder / "flight.csv"
            table.write_text(mavc.compile(text, warn=False).simulate(rate=400).log.csv)
            flight.rate = rate
            dataflash.write(flight, table, 2 * rate, random.Random(seed), folder / f"{name}.bin")

    def __call__(self, name):
        return str(self.folder / f"{name}.bin")

    def run(self, *arguments):
        return subprocess.run([self.path, *arguments], cwd=self.folder, capture_output=True, text=True)


@pytest.fixture(scope="module")
def flown(tmp_path_factory):
    return Flown(tmp_path_factory.mktemp("logs"), os.environ.get("MAVC", ROOT / "target" / "debug" / "mavc"))


def test_a_lost_motor_is_that_of_the_command(flown):
    found = mavc.diagnose(flown("lost"))
    assert (found.answer, found.motors[0]) == ("loss", LOST)
    assert abs(found.losses[0]["time_s"] - 10 - flown.time) < 0.2
    low, high = found.losses[0]["interval_s"]
    assert low <= found.losses[0]["time_s"] <= high
    ran = flown.run("diagnose", flown("lost"))
    assert (ran.returncode, ran.stdout) == (10, str(found))
    assert flown.run("diagnose", flown("lost"), "--format", "json").stdout == found.json
    assert found.record == json.loads(found.json) and list(found.losses) == found.record["losses"]
    assert found.headline.startswith("motor 4 lost at") and repr(found) == f"<Diagnosis: {found.headline}>"
    assert not found.diagnostics


def test_bytes_a_spec_and_hidden_outputs(flown):
    data = (flown.folder / "lost.bin").read_bytes()
    (flown.folder / "v.mav").write_text(flown.spec.text)
    ran = flown.run("diagnose", flown("lost"), "v.mav", "--format", "json")
    with_spec = mavc.diagnose(data, flown.spec)
    assert with_spec.json == ran.stdout and with_spec.motors[0] == LOST
    hidden = mavc.diagnose(data, hide=[LOST])
    assert hidden.json == flown.run("diagnose", flown("lost"), "--hide", str(LOST), "--format", "json").stdout
    with pytest.raises(mavc.SpecError, match="no motor 9"):
        mavc.diagnose(data, hide=[9])


def test_a_baseline(flown):
    good = [flown("good"), flown("other")]
    found = mavc.diagnose(flown("lost"), None, good)
    ran = flown.run("diagnose", flown("lost"), "--format", "json", "--baseline", *good)
    assert found.json == ran.stdout and all("change" in one for one in found.capacities)
    assert found.frames["capacities"].to_pandas()["is_significant"].tolist() == [one["is_significant"] for one in found.capacities]
    alone = mavc.diagnose(flown("good"), baseline=flown("other"))
    assert alone.answer == "none" and "one baseline flight" in alone.unknown[-1]


def test_frames(flown):
    found = mavc.diagnose(flown("lost"))
    losses = found.frames["losses"]
    assert losses["motor"].tolist() == list(found.motors)
    polars, pandas = losses.to_polars(), losses.to_pandas()
    assert polars["interval_s_low"].to_list() == pandas["interval_s_low"].tolist() == [one["interval_s"][0] for one in found.losses]
    assert found.frames["capacities"].rows == 6 and found.frames["flights"].rows == len(found.flights)
    assert losses.csv.splitlines()[0] == ",".join(losses) and len(losses.csv.splitlines()) == 1 + losses.rows
    # Columns keep their types without rows, so that frames of many logs can be joined.
    empty = mavc.diagnose(flown("good")).frames["losses"]
    assert empty.rows == 0 and empty.to_arrow().schema == losses.to_arrow().schema
    flights = found.frames["flights"]
    assert np.isnan(flights["impact_s"]).tolist() == [one["impact_s"] is None for one in found.flights]


def test_a_log_that_is_too_slow(flown):
    found = mavc.diagnose(flown("slow"))
    assert found.answer == "unknown" and not found.losses and "LOG_BITMASK" in found.unknown[0]
    assert str(found) == flown.run("diagnose", flown("slow")).stdout
    with pytest.raises(mavc.SpecError, match="too slow: at least 4 Hz"):
        mavc.identify(flown("slow"), 2.0)


def test_a_spec_is_identified(flown):
    name = flown("good")
    found = mavc.identify(name, f"{flown.mass} kg")
    assert found == flown.run("identify", name, "--mass", f"{flown.mass} kg").stdout
    figures = {figure.field: figure for figure in found.figures}
    assert figures["vehicle.mass"].value == flown.mass and figures["vehicle.mass"].interval is None
    thrust = figures["vehicle.rotor.max_thrust"]
    assert thrust.interval[0] < flown.full < thrust.interval[1] and thrust.remark
    assert found.unknown == ("arm", "vehicle.inertia", "vehicle.rotor.torque_per_thrust", "vehicle.rotor.max_speed")
    values = ["0.3 m", [0.04, 0.04, 0.07], "15 mm", "7500 rpm"]
    given = dict(zip(found.unknown, values, strict=True))
    compiled = mavc.compile(found, set=given, warn=False)
    rotor = compiled.model["vehicle"]["rotors"][0]
    assert abs(rotor["thrust_coefficient_n_s2_per_rad2"] * rotor["max_speed_rad_per_s"] ** 2 / thrust.value - 1) < 0.01
    frame = found.frames["figures"].to_pandas()
    assert frame["field"].tolist() == [figure.field for figure in found.figures]
    assert frame["value"].isna().tolist() == [figure.value is None for figure in found.figures]
    units = pint.UnitRegistry()
    assert mavc.identify(name, 2).figures[1:] == mavc.identify(name, 2000 * units.gram).figures[1:]


def test_files_that_are_no_logs(flown):
    (flown.folder / "text.bin").write_bytes(b"no log")
    for call in (mavc.diagnose, lambda name: mavc.identify(name, 1.5)):
        with pytest.raises(mavc.SpecError, match="no log that mavc knows") as caught:
            call(str(flown.folder / "text.bin"))
        assert [found.code for found in caught.value.diagnostics] == ["mavc::log::format"]
        assert caught.value.diagnostics[0].place.file == str(flown.folder / "text.bin")
        with pytest.raises(FileNotFoundError, match="missing.bin"):
            call(str(flown.folder / "missing.bin"))
    ran = flown.run("diagnose", str(flown.folder / "text.bin"))
    assert str(caught.value) == ran.stderr.rstrip("\n")
    with pytest.raises(ValueError, match="not a length"):
        mavc.identify(flown("good"), "2 m")
    with pytest.raises(mavc.SpecError, match="no log that mavc knows"):
        mavc.diagnose(flown("good"), baseline=[b"no log"])


def test_a_log_that_ends_early_warns(flown):
    data = (flown.folder / "lost.bin").read_bytes()
    with pytest.warns(mavc.SpecWarning, match="ends within a message") as caught:
        found = mavc.diagnose(data[: len(data) - 5])
    assert caught[0].filename == __file__ and found.diagnostics[0].code == "mavc::log::damaged"
    assert found.motors[0] == LOST


def test_runs_can_be_cancelled(flown):
    cancel = mavc.Cancel()
    cancel.cancel()
    with pytest.raises(mavc.Cancelled):
        mavc.diagnose(flown("good"), cancel=cancel)
