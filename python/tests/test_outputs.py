"""Every output of the package is that of the command, bit for bit."""

import json
import re

import mavc
import numpy as np
import pytest

# A quadcopter whose faults are flown without yaw, one that plans at once, and the template.
SPECS = {"template.mav": None, "survey.mav": "examples/survey_hexa.mav", "parcel.mav": "examples/parcel_quad.mav"}

# The file that a command writes to standard error with its diagnostics only.
QUIET_PROGRESS = re.compile(r"^mavc: .*\n", re.MULTILINE)


LONG = [pytest.param(name, marks=pytest.mark.long) for name in ("survey.mav", "parcel.mav")]


@pytest.fixture(params=["template.mav", *LONG])
def name(request, write, example):
    source = SPECS[request.param]
    return write(request.param, mavc.new() if source is None else example(source))


def compiled(name, **options):
    return mavc.compile(name, warn=False, **options)


def test_analysis(name, command):
    spec = compiled(name)
    assert spec.analyze().json == command("analyze", name, "--format", "json").out
    assert spec.analyze().text == command("analyze", name).out


def test_sweep_of_an_analysis(command, write):
    name = write("template.mav", mavc.new())
    found = compiled(name).analyze(sweep="mass=1.5..2.5kg")
    assert found.json == command("analyze", name, "--sweep", "mass=1.5..2.5kg", "--format", "json").out
    assert found.text == command("analyze", name, "--sweep", "mass=1.5..2.5kg").out
    with pytest.raises(ValueError, match="write a field and a range"):
        compiled(name).analyze(sweep="mass")


def test_plan(name, command):
    ran = command("plan", name, "-o", "t.csv", "--report", "r.json", "--certificate", "c.json", "--html", "p.html")
    assert ran.code == 0
    plan = compiled(name).plan()
    assert plan.verdict == "found" and plan
    assert plan.json == command.read("r.json")
    assert plan.csv == command.read("t.csv")
    assert plan.certificate() == command.read("c.json")
    assert plan.html() == command.read("p.html")
    assert ran.out == plan.text + "Trajectory written to t.csv\nPage written to p.html\n"
    assert ran.err == plan.diagnostics.text
    assert plan.price == plan.planner["price"] and plan.price["sentence"] and plan.price["still_unsafe"] is False
    accepted = compiled(name).verify(plan.certificate())
    # Its name decides where lines are broken.
    assert accepted.text.replace("<certificate>", "c.json").split() == command("verify", "c.json", name).out.split()


def test_ways_out(command, write, small):
    name = write("small.mav", small)
    ran = command("plan", name, "--recovery", "-o", "t.csv", "--report", "r.json", "--branches", "ways", "--html", "p.html")
    assert ran.code == 0
    plan = compiled(name).plan(recovery=True)
    assert plan.json == command.read("r.json") and plan.html() == command.read("p.html")
    assert ran.out.startswith(plan.text) and "AFTER A FAULT" in plan.text
    branches = plan.branches()
    files = {path.name for path in (command.folder / "ways").iterdir()}
    assert branches and files == {"index.csv", *branches}
    assert all(branch.csv == command.read(f"ways/{name}") for name, branch in branches.items())
    ways = plan.ways_out
    assert ways["from_s"][0] == 0.0 and ways["to_s"][-1] == plan.time and set(ways["mode"]) == {"M1"}
    found = [name for name in ways["branch"] if name is not None]
    assert found and set(found) <= set(branches)
    assert plan.recovery == plan.record["recovery"] and 0.0 <= plan.recovery["uncovered"] <= 1.0


def test_ways_out_are_sought_where_the_spec_requires_them(small, write):
    required = small.replace("time = 6 s }", "time = 6 s; require uncovered <= 100 % }")
    assert compiled(write("required.mav", required)).plan().ways_out.rows > 0
    plan = compiled(write("small.mav", small)).plan()
    assert plan.recovery is None and plan.ways_out.rows == 0
    with pytest.raises(ValueError, match=r"plan\(recovery=True\)"):
        plan.branches()


def test_arrays_of_a_trajectory(command, write, small):
    name = write("small.mav", small)
    plan = compiled(name).plan()
    trajectory = plan.trajectory
    rows = [line.split(",") for line in plan.csv.splitlines()]
    for k, column in enumerate(rows[0]):
        assert trajectory[column].tolist() == [float(row[k]) for row in rows[1:]]
    assert trajectory.position.shape == trajectory.acceleration.shape == (trajectory.rows, 3)
    assert trajectory.rotor_speed.shape == (trajectory.rows, 8)
    assert trajectory.waypoint.max() == 2
    # The arrays belong together: by the trapezoidal rule, to a twelfth of step^2 times the largest jerk.
    step = np.diff(trajectory.time)[:, None]
    mean = 0.5 * (trajectory.velocity[1:] + trajectory.velocity[:-1])
    error = np.abs(np.diff(trajectory.position, axis=0) / step - mean)
    assert (error <= 0.1 * step**2 * np.abs(trajectory.jerk).max() + 1e-9).all() and error.max() > 0
    command("plan", name, "-o", "fast.csv", "--rate", "50Hz")
    assert plan.at(50).csv == command.read("fast.csv")


# Of the model that plans at once, for less time than the way takes.
SHORT = ["plan.time=6 s", "plan.model=hover", "plan.samples=40", "plan.against=[M1]"]
SET = [part for override in SHORT for part in ("--set", override)]


@pytest.mark.long
def test_infeasible(command, write):
    name = write("template.mav", mavc.new())
    ran = command("plan", name, *SET, "--report", "r.json", "--html", "p.html", "--certificate", "c.json")
    plan = compiled(name, set=SHORT).plan()
    assert ran.code == 3 and plan.verdict == "proved infeasible" and not plan
    assert plan.trajectory is None and plan.csv is None and np.isnan(plan.time)
    assert plan.json == command.read("r.json")
    assert plan.html() == command.read("p.html")
    assert plan.certificate() == command.read("c.json")
    assert ran.out == plan.text + "Page written to p.html\n"
    assert QUIET_PROGRESS.sub("", ran.err) == plan.diagnostics.text
    assert "proved infeasible at 6 s" in plan.explanation and "cannot hold together" in plan.explanation
    assert plan.diagnostics[-1].labels and plan.diagnostics[-1].severity == "error"


def test_a_mode_that_cannot_hover(command, write, example):
    name = write("survey.mav", example("examples/survey_hexa.mav"))
    ran = command("plan", name, "--set", "plan.against=all", "--report", "r.json", "--html", "p.html")
    plan = compiled(name, set=["plan.against=all"]).plan()
    assert ran.code == 3 and plan.verdict == "not attempted"
    assert plan.json == command.read("r.json")
    assert plan.html() == command.read("p.html")
    assert ran.err == plan.diagnostics.text
    assert "M5" in plan.explanation


def test_flight(name, command):
    ran = command("simulate", name, "-o", "l.csv", "--report", "r.json", "--html", "p.html")
    flight = compiled(name).simulate()
    assert flight.verdict == "simulated" and flight.outcome in ("flown", "landed", "lost")
    assert flight.json == command.read("r.json")
    assert flight.csv == command.read("l.csv")
    assert ran.out.startswith(flight.text) and "Flight log written" in ran.out[len(flight.text) :]
    assert ran.err == flight.diagnostics.text
    assert flight.html() == command.read("p.html")
    assert flight.log.position.shape == (flight.log.rows, 3)


@pytest.mark.long
def test_flight_without_a_plan(command, write):
    name = write("template.mav", mavc.new().replace("fault M1 at 12 s", "fault M1 at 2 s"))
    ran = command("simulate", name, *SET, "--report", "r.json", "--html", "p.html")
    flight = compiled(name, set=SHORT).simulate()
    assert ran.code == 3 and flight.verdict == "proved infeasible" and flight.outcome is None
    assert flight.json == command.read("r.json")
    assert ran.out.startswith(flight.text)
    assert flight.csv is None and flight.html() == command.read("p.html")


@pytest.mark.long
def test_campaign(command, write, example):
    name = write("survey.mav", example("examples/survey_hexa.mav"))
    sizes = ["campaign.times = 1", "campaign.seeds = 2"]
    arguments = [part for size in sizes for part in ("--set", size)]
    ran = command("campaign", name, *arguments, "-o", "r.csv", "--report", "r.json", "--html", "p.html", "--quiet")
    campaign = compiled(name).campaign(times=1, seeds=2)
    # Only the identity differs, which is a hash of the program, and the checksum of each row after it.
    named = json.loads(command.read("r.json"))["campaign"]
    assert campaign.json.replace(campaign.record["campaign"], named) == command.read("r.json")
    assert campaign.html().replace(campaign.record["campaign"], named) == command.read("p.html")
    cells = lambda text: [line.split(",")[1:-1] for line in text.splitlines()]
    assert cells(campaign.rows.csv) == cells(command.read("r.csv"))
    assert campaign.text.replace(campaign.record["campaign"], named) == ran.out
    assert campaign.rows.rows == campaign.record["flights"]


@pytest.mark.long
def test_comparison(command, write):
    overrides = ["plan.model=hover", "plan.samples=60"]
    name = write("template.mav", mavc.new())
    command("compare", name, *(part for o in overrides for part in ("--set", o)), "--report", "r.json")
    assert compiled(name, set=overrides).compare() == json.loads(command.read("r.json"))


def test_check_and_texts(name, command):
    spec = compiled(name)
    ran = command("check", name)
    assert ran.out.startswith(spec.check().text)
    lines = [json.loads(line) for line in command("check", name, "--format", "json").out.splitlines()]
    assert len([line for line in lines if "code" in line]) == len(spec.check())
    if not any(line.get("severity") == "error" for line in lines):
        assert lines[-1]["headline"] == spec.analyze().headline
    assert spec.defaults == command("check", name, "--explain-defaults").out[-len(spec.defaults) :]
    assert spec.model == json.loads(command("emit", "model", name, "--format", "json").out)
    assert mavc.format(spec.text) == command("fmt", "-", "--stdout").out or mavc.format(spec.text) == spec.text


def test_templates(command):
    assert mavc.new() == command("new", "-").out
    assert mavc.new("survey") == command("new", "--mission", "survey", "-").out
    with pytest.raises(ValueError, match="delivery, inspection, room, survey"):
        mavc.new("party")
