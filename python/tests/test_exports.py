"""Plans and logs for other tools are those of the command, byte for byte."""

import mavc
import numpy as np
import pytest

# Every format, with the arguments of Python and of the command.
PLANS = {
    "csv": [({}, []), ({"rate": 20, "frame": "ned-frd"}, ["--rate", "20Hz", "--frame", "ned-frd"])],
    "rows": [({"frame": "ned-frd"}, ["--frame", "ned-frd"]), ({"rate": 0.5}, ["--rate", "0.5Hz"])],
    "px4": [({}, [])],
    "px4-offboard": [({}, []), ({"rate": 20}, ["--rate", "20Hz"])],
    "ardupilot-guided": [({}, [])],
    "crazyflie": [({}, []), ({"tolerance": 0.02}, ["--tolerance", "2cm"])],
    "rotorpy": [({}, [])],
    "gym-pybullet-drones": [({}, [])],
    "qgc-plan": [({}, []), ({"tolerance": 0.2}, ["--tolerance", "20cm"])],
    "wpl": [({}, [])],
    "kml": [({}, [])],
    "geojson": [({"tolerance": 1.0}, ["--tolerance", "1m"])],
}
QUICK = ["plan.planner=rip", "plan.model=hover", "plan.samples=40", "plan.time=30 s"]
SET = [part for override in QUICK for part in ("--set", override)]
ORIGIN = "    origin_latitude = 45 deg\n    origin_longitude = 9 deg\n    origin_altitude = 100 m\n"


@pytest.fixture
def name(write):
    return write("template.mav", mavc.new().replace("    start at", ORIGIN + "    start at", 1))


@pytest.fixture
def plan(name):
    return mavc.compile(name, set=QUICK, warn=False).plan()


@pytest.mark.parametrize("format, given, arguments", [(f, *pair) for f, pairs in PLANS.items() for pair in pairs])
def test_plans(command, name, plan, format, given, arguments):
    ran = command("plan", name, *SET, "-o", "theirs", "--format", format, *arguments)
    assert ran.code == 0, ran.err
    found = plan.export(format, "ours", **given)
    assert found.data == (command.folder / "theirs").read_bytes() == (command.folder / "ours").read_bytes()
    assert found.remark is None or f"mavc: {found.remark}\n" in ran.err
    assert (found.remark is not None) == ("mavc: " in ran.err.replace("mavc: no certificate", ""))
    assert found.text.encode() == found.data


def test_bags(command, name, plan):
    command("plan", name, *SET, "-o", "theirs.mcap", "--format", "rosbag2")
    found = plan.export("rosbag2", "ours.mcap")
    assert found.data == (command.folder / "theirs.mcap").read_bytes() == (command.folder / "ours.mcap").read_bytes()
    command("plan", name, *SET, "-o", "deep/bag of mine", "--format", "rosbag2")
    found.write(command.folder / "other" / "bag of mine")
    theirs, ours = ({p.name: p.read_bytes() for p in (command.folder / f / "bag of mine").iterdir()} for f in ("deep", "other"))
    assert theirs == ours and set(ours) == {"bag_bagofmine_0.mcap", "metadata.yaml"}


def test_a_script_for_px4_flies_the_plan(plan):
    script = plan.export("px4-offboard").text
    compile(script, "plan.py", "exec")
    known: dict = {"__name__": "plan"}
    exec(script, known)
    rows, there = np.array(known["SETPOINTS"]), plan.at(50)
    # PX4 has north, east, down, and the numbers are of single precision.
    ned = lambda vectors: vectors[:, [1, 0, 2]] * [1, 1, -1]
    for columns, vectors in [(slice(1, 4), there.position), (slice(4, 7), there.velocity), (slice(7, 10), there.acceleration)]:
        assert np.allclose(rows[:, columns], ned(vectors), atol=1e-6, rtol=1e-6)
    assert np.allclose(np.cos(rows[:, 10]), np.sin(there.yaw), atol=1e-6) and np.array_equal(rows[:, 0], there.time)


def test_logs(command, write, name):
    sets = [*QUICK, "simulate.duration=14 s"]
    spec = mavc.compile(name, set=sets, warn=False)
    flight = spec.simulate()
    arguments = [part for override in sets for part in ("--set", override)]
    for format, given in [("csv", {}), ("mcap", {"rate": 20}), ("ulog", {"rate": 30})]:
        rate = ["--rate", f"{given['rate']}Hz"] if given else []
        layout = [] if format == "csv" else ["--layout", "theirs.layout"]
        ran = command("simulate", name, *arguments, "-o", "theirs", "--format", format, *rate, *layout)
        found = flight.export(format, "ours", layout="ours.layout" if layout else None, **given)
        assert found.data == (command.folder / "theirs").read_bytes() == (command.folder / "ours").read_bytes()
        assert ("mavc: the log has rows" in ran.err) == (found.remark is not None)
        assert not layout or command.read("ours.layout") == command.read("theirs.layout")
    assert flight.export("csv").text == flight.csv
    with pytest.raises(ValueError, match="has no layout"):
        flight.export("csv", "none.csv", layout="none.layout")
    assert not (command.folder / "none.csv").exists()


def test_what_cannot_be_exported(command, name, plan, small):
    for format, given, why in [
        ("pdf", {}, "there is no format of plans"),
        ("px4", {"frame": "ned-frd"}, "fixes its frames"),
        ("rows", {"frame": "up"}, "there is no frame"),
        ("rotorpy", {"rate": 10}, "polynomials instead of rows"),
        ("px4", {"tolerance": 0.1}, "no effect with --format px4"),
        ("crazyflie", {"tolerance": 0}, "a tolerance lies"),
        ("px4", {"rate": float("nan")}, "a rate lies"),
        ("px4", {"rate": 1e5}, "at most"),
    ]:
        with pytest.raises(ValueError, match=why):
            plan.export(format, "none", **given)
    for rate in (0, -1, float("inf")):
        with pytest.raises(ValueError, match="a rate lies"):
            plan.at(rate)
        with pytest.raises(ValueError, match="a rate lies"):
            mavc.compile(small).simulate(rate=rate)
    assert not (command.folder / "none").exists()
    with pytest.raises(ValueError, match="origin"):
        mavc.compile(mavc.new(), set=QUICK, warn=False).plan().export("kml")


def test_without_a_plan_the_verdict_is_named(small):
    short = mavc.compile(small.replace("time = 6 s", "time = 1 s").replace("at 3 s", "at 0.5 s"))
    plan, flight = short.plan(), short.simulate()
    assert plan.verdict == "proved infeasible"
    for export in (lambda: plan.export("px4"), lambda: plan.at(50)):
        with pytest.raises(ValueError, match="there is no plan: proved infeasible"):
            export()
    with pytest.raises(ValueError, match="there is no plan to fly: proved infeasible"):
        flight.export("mcap")
