"""Mistakes are exceptions with everything that the terminal prints."""

import copy
import os
import pickle
import warnings

import mavc
import pytest

WRONG = """vehicle octo {
    layout  = "PPNNPPNN"
    arm     = 0.211 m
    mass    = 1.8 s
    inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    rotor { max_thrust = 6.53 N; torque_per_thrust = 16 mm; max_spede = 874 rad/s }
}
"""


def test_an_error_prints_what_the_terminal_prints(command, write):
    name = write("wrong.mav", WRONG)
    with pytest.raises(mavc.SpecError) as caught:
        mavc.compile(name)
    printed = command("plan", name).err
    assert str(caught.value) == printed.rstrip("\n") and "max_spede" in printed
    codes = [d.code for d in caught.value.diagnostics]
    assert codes == ["mavc::unit::mismatch", "mavc::name::unknown_field"]
    mass, speed = caught.value.diagnostics
    assert (mass.place.file, mass.place.line, mass.place.column, mass.place.end_column) == ("wrong.mav", 4, 15, 20)
    assert mass.severity == "error" and "kg" in mass.help
    assert speed.fixes[0].text == "max_speed"
    assert str(mass) in command("check", name, "--format", "short").out


def test_a_text_and_its_name():
    with pytest.raises(mavc.SpecError) as caught:
        mavc.compile(WRONG, name="some/where.mav")
    assert caught.value.diagnostics[0].place.file == "some/where.mav"
    assert isinstance(caught.value, ValueError)


def test_errors_of_overrides():
    spec = mavc.compile(mavc.new())
    with pytest.raises(mavc.SpecError, match="mass"):
        spec.set("vehicle.mass", "2 m")
    with pytest.raises(mavc.SpecError, match="did you mean"):
        spec.set("vehicle.mas", "2 kg")
    assert spec.set("vehicle.mass", "2 kg").sha256 == spec.set("vehicle.mass = 2 kg").sha256 != spec.sha256


def test_values_of_overrides_are_in_si_units():
    spec = mavc.compile(mavc.new(), set={"plan.planner": "rsp", "plan.model": "hover"}, warn=False)
    assert spec.set("vehicle.mass", 2).model["vehicle"]["mass_kg"] == 2.0
    assert spec.set("vehicle.layout", "PNPNPNPN").analyze().margins.min() > spec.analyze().margins.min()
    assert spec.set("plan.samples", 60).plan().trajectory.rows == 61
    assert spec.set("plan.against", ["M1", "M2"]).plan().planner["against"] == ["M1", "M2"]
    assert spec.set("vehicle.inertia", [0.05, 0.05, 0.08]).overrides[2:] == (
        "vehicle.inertia = [0.05, 0.05, 0.08] kg*m^2",
    )


def test_files_that_cannot_be_read(tmp_path):
    with pytest.raises(FileNotFoundError):
        mavc.compile(tmp_path / "missing.mav")
    with pytest.raises(IsADirectoryError):
        mavc.compile(tmp_path)
    with pytest.raises(FileNotFoundError):
        mavc.compile("missing.mav")


def test_files_that_a_spec_names(command, write):
    name = write("route.mav", mavc.new().replace("waypoint at [10, 8, height]", 'waypoints from "none.csv"\n    waypoint at [10, 8, height]'))
    with pytest.raises(mavc.SpecError, match="none.csv") as caught:
        mavc.compile(name)
    assert str(caught.value) == command("plan", name).err.rstrip("\n")


def test_bytes_that_are_no_text(tmp_path, command, write):
    name = write("binary.mav", "")
    with open(name, "wb") as file:
        file.write(b"vehicle \xff\xfe {")
    with pytest.raises(mavc.SpecError) as caught:
        mavc.compile(name)
    assert str(caught.value) == command("check", name).out.rstrip("\n") or command("plan", name).err.rstrip("\n") == str(
        caught.value
    )


def test_warnings_are_issued_and_kept(command, write, small):
    name = write("odd.mav", "let spare = 3 m\n" + small)
    with pytest.warns(mavc.SpecWarning) as caught:
        spec = mavc.compile(name)
    assert str(caught[0].message).strip() == spec.warnings.text.strip()
    assert spec.warnings and all(d.severity in ("warning", "advice") for d in spec.warnings)
    printed = command("plan", name).err
    assert spec.warnings.text in printed and spec.plan().diagnostics.text == printed
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        mavc.compile(name, warn=False)


def test_blocks_of_flights(command, write, small):
    name = write("gusts.mav", small.replace("fault M1 at 3 s", "fault M1 at 3 s; gusts = 0.5 kg"))
    with pytest.warns(mavc.SpecWarning, match="gusts"):
        spec = mavc.compile(name)
    assert [d.severity for d in spec.warnings] == ["warning"]
    assert spec.plan().diagnostics.text == command("plan", name).err
    with pytest.raises(mavc.SpecError, match="gusts") as caught:
        spec.simulate()
    assert str(caught.value) == command("simulate", name).err.rstrip("\n")
    with pytest.raises(mavc.SpecError, match="gusts"):
        spec.campaign(times=1, seeds=1)
    assert command("check", name).out.startswith(spec.check().text)


def test_a_spec_without_a_mission(command, write, example):
    name = write("vehicle.mav", example("specs/vehicles/octo_ppnnppnn.mav"))
    spec = mavc.compile(name, warn=False)
    for task in (spec.plan, spec.simulate, spec.campaign, spec.compare):
        with pytest.raises(mavc.SpecError, match="no mission to plan") as caught:
            task()
    ran = command("plan", name)
    assert ran.code == 1 and str(caught.value) == ran.err.rstrip("\n")


@pytest.mark.long
def test_a_fault_after_the_end(command, write):
    name = write("late.mav", mavc.new())
    # The time is found by a search, so only the plan shows that the fault strikes after its end.
    late = ["plan.time = minimum", "plan.planner = rip", "plan.samples = 40", "plan.model = hover"]
    spec = mavc.compile(mavc.new().replace("fault M1 at 12 s", "fault M1 at 400 s"), name=name, set=late)
    write(name, spec.text)
    ran = command("simulate", name, *(part for override in late for part in ("--set", override)))
    with pytest.raises(mavc.SpecError) as caught:
        spec.simulate()
    assert ran.code == 1 and str(caught.value) == ran.err.rstrip("\n")


def test_rejected_certificates(command, write):
    name = write("template.mav", mavc.new())
    spec = mavc.compile(name)
    certificate = spec.plan().certificate()
    other = spec.set("plan.reserve", "20 %")
    with pytest.raises(mavc.Rejected) as caught:
        other.verify(certificate)
    (command.folder / "c.json").write_text(certificate)
    printed = command("verify", "c.json", name, "--set", "plan.reserve = 20 %").err
    assert str(caught.value).replace("<certificate>", "c.json") in printed or caught.value.diagnostics[0].code in printed
    with pytest.raises(mavc.Rejected):
        spec.verify(b"{}")


def test_pickles(small):
    spec = mavc.compile(mavc.new(), set=["vehicle.mass = 1.9 kg"])
    again = pickle.loads(pickle.dumps(spec))
    assert again.sha256 == spec.sha256 and again.overrides == spec.overrides
    assert copy.copy(spec).analyze().json == spec.analyze().json
    campaign = mavc.compile(small).campaign(times=1, seeds=1)
    found = pickle.loads(pickle.dumps((again.analyze(), campaign)))
    assert found[0].json == spec.analyze().json and found[1].rows.csv == campaign.rows.csv
    with pytest.raises(mavc.SpecError) as caught:
        mavc.compile(WRONG)
    error = pickle.loads(pickle.dumps(caught.value))
    assert str(error) == str(caught.value) and error.diagnostics == caught.value.diagnostics


def test_handles_of_another_kind():
    from mavc import _mavc

    cancel = _mavc.new_cancel()
    for arguments in [(None,), (cancel,), (object(),)]:
        with pytest.raises((TypeError, ValueError)):
            _mavc.facts(*arguments, "sha256")
    with pytest.raises(ValueError, match="no such fact"):
        _mavc.facts(mavc.compile(mavc.new())._handle, "weather")
    assert os.path.basename(_mavc.__file__).startswith("_mavc")


def test_the_layout_of_texts():
    assert mavc.format("let  m=2 kg") == "let m = 2 kg\n"
    with pytest.raises(mavc.SpecError, match="expected"):
        mavc.format("let m = = 2")
