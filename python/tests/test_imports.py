"""Specs from the files of other tools, as the command makes them."""

import copy
import pickle
import warnings

import mavc
import pint
import pytest

# Six arms of 30 cm, as QGroundControl saves them: a name, a value and a type in columns.
HEXA = "# Onboard parameters\n" + "".join(
    f"1\t1\t{name}\t{value}\t9\n"
    for name, value in [
        ("CA_ROTOR_COUNT", 6),
        *((f"CA_ROTOR{i}_PX", x) for i, x in enumerate([0.0, 0.0, 0.26, -0.26, 0.26, -0.26])),
        *((f"CA_ROTOR{i}_PY", y) for i, y in enumerate([0.3, -0.3, -0.15, 0.15, 0.15, -0.15])),
        *((f"CA_ROTOR{i}_KM", k) for i, k in enumerate([-0.02, 0.02, -0.02, 0.02, 0.02, -0.02])),
        ("MC_ROLL_P", 6.5),
    ]
)
COPTER = "FRAME_CLASS,3\nFRAME_TYPE,1\nMOT_SPIN_MIN,0.15\n"
MISSION = "QGC WPL 110\n" + "".join(
    "\t".join(map(str, item)) + "\n"
    for item in [
        (0, 1, 0, 16, 0, 0, 0, 0, 45.0, 9.0, 100.0, 1),
        (1, 0, 3, 22, 0, 0, 0, 0, 0, 0, 10.0, 1),
        (2, 0, 3, 16, 2, 0, 0, 0, 45.0002, 9.0, 12.0, 1),
        (3, 0, 3, 203, 0, 0, 0, 0, 0, 0, 0, 1),
        (4, 0, 3, 16, 0, 0, 0, 0, 45.0002, 9.0003, 12.0, 1),
    ]
)
FIGURES = {
    "vehicle.mass": 2.0,
    "vehicle.inertia": [0.05, 0.05, 0.09],
    "vehicle.rotor.max_thrust": "9 N",
    "vehicle.rotor.max_speed": 900,
}


@pytest.mark.parametrize("file, text", [("hexa.params", HEXA), ("copter.param", COPTER)])
def test_a_vehicle_is_that_of_the_command(command, write, file, text):
    name = write(file, text)
    ran = command("import", "vehicle", name, "-o", "out.mav")
    found = mavc.import_vehicle(name, warn=False)
    assert ran.code == 0 and found == command.read("out.mav") and isinstance(found, str)
    assert ran.err.startswith(str(found.warnings))
    rest = ran.err[len(str(found.warnings)) :]
    assert all(name in rest for name in found.left_out) and found.left_out
    assert f"{len(found.unknown)} lines have" in rest
    assert mavc.import_vehicle(text, name=file, warn=False) == found


def test_unknown_figures_are_set(command, write):
    name = write("hexa.params", HEXA)
    text = mavc.import_vehicle(name)
    assert text.unknown == tuple(FIGURES)
    with pytest.raises(mavc.SpecError, match="not known yet"):
        mavc.compile(text)
    with pytest.raises(mavc.SpecError, match="`mass` of"):
        mavc.compile(text, set={name: value for name, value in FIGURES.items() if name != "vehicle.mass"})
    write("out.mav", text)
    spec = mavc.compile("out.mav", set=FIGURES, warn=False)
    sets = [part for override in spec.overrides for part in ("--set", override)]
    assert spec.analyze().json == command("analyze", "out.mav", *sets, "--format", "json").out
    units = pint.UnitRegistry()
    masses = [2.0, "2 kg", 2000 * units.gram]
    assert {mavc.compile(text, set={**FIGURES, "vehicle.mass": mass}, warn=False).model["vehicle"]["mass_kg"] for mass in masses} == {2.0}
    # The figures belong to the vehicle; faults and a mission are added as text.
    whole = mavc.compile(text + "\nfaults { every 1 rotor lost as M }\n", set=FIGURES, warn=False)
    assert whole.modes == ("M1", "M2", "M3", "M4", "M5", "M6")


def test_lengths_that_are_let(write):
    text = mavc.import_vehicle(COPTER)
    assert text.unknown[0] == "arm" and "vehicle copter" not in text and "vehicle imported" in text
    # None of the figures is in the parameters.
    figures = {**FIGURES, "arm": "0.25 m", "vehicle.rotor.torque_per_thrust": "15 mm"}
    assert set(text.unknown) == set(figures)
    assert len(mavc.compile(text, set=figures, warn=False).model["vehicle"]["rotors"]) == 8


def test_warnings_have_places_in_the_file(command, write):
    shares = HEXA.replace("0.26", "1.0").replace("0.15", "1.0").replace("0.3", "1.0")
    name = write("shares.params", shares)
    with pytest.warns(mavc.SpecWarning, match="seem to be proportions") as caught:
        found = mavc.import_vehicle(name)
    assert str(caught[0].message).strip() == found.warnings.text.strip()
    assert caught[0].filename == __file__
    assert found.warnings[0].place.file == name and found.warnings[0].severity == "warning"
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        mavc.import_vehicle(name, warn=False)
        mavc.import_vehicle(write("hexa.params", HEXA))


def test_errors_have_places_in_the_file(command, write):
    name = write("wrong.params", HEXA.replace("\t0.3\t", "\tthree\t"))
    with pytest.raises(mavc.SpecError, match="not a finite number") as caught:
        mavc.import_vehicle(name)
    place = caught.value.diagnostics[0].place
    assert (place.file, place.line) == (name, 1 + HEXA[: HEXA.index("\t0.3\t")].count("\n"))
    ran = command("import", "vehicle", name)
    assert ran.code == 1 and ran.err.rstrip("\n") == str(caught.value)
    with pytest.raises(mavc.SpecError, match="no vehicle"):
        mavc.import_vehicle("nothing\nof note\n")
    with pytest.raises(FileNotFoundError):
        mavc.import_vehicle("missing.params")
    with pytest.raises(mavc.SpecError, match="not UTF-8"):
        (command.folder / "bytes.params").write_bytes(b"\xff\xfe\n")
        mavc.import_vehicle("bytes.params")


def test_a_mission_is_that_of_the_command(command, write):
    name = write("field.waypoints", MISSION)
    ran = command("import", "mission", name)
    found = mavc.import_mission(name, warn=False)
    assert found == ran.out and ran.err.startswith(str(found.warnings)) and found.warnings
    assert not found.unknown and "DO_SET_CAM" not in found
    assert set(found.left_out) <= set(ran.err.split())
    assert mavc.import_mission(MISSION, name=name, warn=False) == found


def test_a_mission_names_its_vehicle(command, write):
    (command.folder / "deep").mkdir()
    write("quad.mav", mavc.compile(mavc.import_vehicle(HEXA), set=FIGURES, warn=False).text.replace("?", "1 m"))
    name = write("field.waypoints", MISSION)
    for output, folder in [("field.mav", "."), ("deep/field.mav", "deep")]:
        command("import", "mission", name, "--vehicle", "quad.mav", "-o", output)
        found = mavc.import_mission(name, vehicle="quad.mav", folder=folder, warn=False)
        assert found == command.read(output) and 'quad.mav"' in found
    with pytest.raises(FileNotFoundError):
        mavc.import_mission(name, vehicle="missing.mav")


def test_a_mission_beside_another_of_its_name(command, write):
    filled = mavc.compile(mavc.import_vehicle(HEXA), set=FIGURES, warn=False).text.replace("?", "1 m")
    write("quad.mav", filled + "mission field {\n    start at [0, 0, 2] m\n    waypoint at [9, 0, 2] m\n}\n")
    name = write("field.waypoints", MISSION)
    command("import", "mission", name, "--vehicle", "quad.mav", "-o", "field.mav")
    found = mavc.import_mission(name, vehicle="quad.mav", warn=False)
    assert found == command.read("field.mav") and "mission field_2 {" in found
    with pytest.raises(mavc.SpecError, match="mavc import vehicle"):
        mavc.import_mission(name, vehicle=write("hexa.params", HEXA))


@pytest.mark.parametrize("file, text, kind", [("a.params", HEXA, "vehicle"), ("a.param", COPTER, "vehicle"), ("a.txt", MISSION, "mission")])
def test_a_file_of_another_tool_names_the_import(write, file, text, kind):
    for source in (write(file, text), text):
        with pytest.raises(mavc.SpecError, match=f"mavc import {kind}") as caught:
            mavc.compile(source)
        assert [found.code for found in caught.value.diagnostics] == ["mavc::file::foreign"]


def test_a_mission_with_its_vehicle_is_planned(write):
    write("hexa.params", HEXA)
    write("hexa.mav", mavc.import_vehicle("hexa.params"))
    text = mavc.import_mission(MISSION, vehicle="hexa.mav", warn=False)
    quick = {"plan.planner": "rip", "plan.samples": 60, "plan.time": "40 s"}
    plan = mavc.compile(text, set={**FIGURES, **quick}, warn=False).plan()
    assert plan and abs(plan.trajectory.position[-1][2] - 12.0) < 0.05


def test_copies():
    found = mavc.import_vehicle(HEXA)
    for other in (copy.copy(found), pickle.loads(pickle.dumps(found))):
        assert other == found and other.unknown == found.unknown and other.left_out == found.left_out == ("MC_ROLL_P",)
