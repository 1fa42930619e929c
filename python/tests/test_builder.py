"""Specs from values are those of their texts."""

import mavc
import numpy as np
import pint
import pytest

TEXT = """
vehicle craft {
    layout  = "PPNNPPNN"
    arm     = 0.211 m
    mass    = 1.8 kg
    inertia = [0.0429, 0.0429, 0.0748] kg*m^2
    size    = 0.6 m
    rotor { max_thrust = 6.53 N; torque_per_thrust = 0.016 m; max_speed = 874 rad/s }
    battery { capacity = 18000 A*s; voltage = 14.8 V; hover_power = 300 W }
}
faults {
    mode M1 { rotors [1] lost; rate = 1e-5 1/s }
    mode worn { rotors [3] reduced to 0.6; rotors [4] stuck at 0.5 }
}
mission flight {
    start at [0, 0, 2] m
    waypoint at [10, 0, 5] m yaw 1 rad within 0.3 m
    hold 2 s
    waypoint at [10, 8, 5] m
    keep_out mast { shape = cylinder; centre = [5, 6, 0] m; radius = 0.4 m; height = 30 m; clearance = 1 m }
    limits { speed <= 6 m/s; altitude in 1 m .. 20 m }
}
plan { planner = rip; samples = 40; against = [M1]; time = 20 s }
simulate { drag = 0.2 N*s/m; fault M1 at 5 s }
campaign { times = 1; seeds = 2 }
"""

ROTOR = {"max_thrust": 6.53, "torque_per_thrust": 0.016, "max_speed": 874}
BATTERY = {"capacity": 18000, "voltage": 14.8, "hover_power": 300}


def octo(**fields):
    known = {"layout": "PPNNPPNN", "arm": 0.211, "mass": 1.8, "inertia": [0.0429, 0.0429, 0.0748], "rotor": ROTOR}
    return mavc.Vehicle(**{**known, **fields})


def test_values_and_text_are_one_spec():
    mast = mavc.Volume("mast", "cylinder", keep="out", centre=(5, 6, 0), radius=0.4, height=30, clearance=1)
    mission = mavc.Mission(
        [(0, 0, 2), mavc.Waypoint((10, 0, 5), yaw=1.0, within=0.3, hold=2), np.array([10, 8, 5])],
        limits={"speed": 6, "altitude": (1, 20)},
        volumes=[mast],
    )
    built = mavc.build(
        octo(size=0.6, battery=BATTERY),
        [mavc.FaultMode("M1", lost=1, rate=1e-5), mavc.FaultMode("worn", reduced={3: 0.6}, stuck={4: 0.5})],
        mission,
        plan={"planner": "rip", "samples": 40, "against": ["M1"], "time": 20},
        simulate={"drag": 0.2},
        strikes=[("M1", 5)],
        campaign={"times": 1, "seeds": 2},
    )
    written = mavc.compile(TEXT)
    assert built.model == written.model
    assert built.analyze().json == written.analyze().json
    assert built.plan().csv == written.plan().csv
    assert built.simulate().csv == written.simulate().csv
    assert mavc.compile(built.text).sha256 == built.sha256
    assert mavc.format(built.text) == built.text


def test_what_follows_a_fault():
    built = mavc.build(
        octo(size=0.5),
        [mavc.FaultMode("M1", lost=1, recovery=["continue", "pad"])],
        mavc.Mission(
            [(0, 0, 2), (10, 0, 5)],
            fields={"ground": 0.0, "buffer": 3.0},
            landing_sites=[mavc.LandingSite("pad", (4, -8, 0), 2.0)],
            keep_off=[mavc.KeepOff("street", "polygon", corners=[[0, 5], [40, 5], [40, 11]], clearance=1.0)],
            after_fault_limits={"descent": 4.0},
        ),
        recovery={"order": ["continue", "land_at_sites"], "within": 20.0},
    )
    for line in [
        "recovery = [continue, pad]",
        "landing_site pad {",
        "keep_off street {",
        "descent <= 4 m/s",
        "order  = [continue, land_at_sites]",
    ]:
        assert line in built.text, built.text
    assert mavc.compile(built.text).sha256 == built.sha256


def test_placed_rotors():
    places = [(0.2, 0.2, 0), (0.2, -0.2, 0), (-0.2, -0.2, 0), (-0.2, 0.2, 0)]
    rotors = [mavc.Rotor(at, spin) for at, spin in zip(places, "PNPN")]
    rotors[3] = mavc.Rotor(places[3], "N", max_thrust=7.0)
    known = {"mass": 1.0, "inertia": (0.01, 0.01, 0.02), "rotor": mavc.Rotor(**ROTOR)}
    built = mavc.build(mavc.Vehicle(rotors=rotors, **known))
    model = built.model["vehicle"]["rotors"]
    assert [rotor["position_m"] for rotor in model] == [list(place) for place in places]
    thrusts = [rotor["thrust_coefficient_n_s2_per_rad2"] * rotor["max_speed_rad_per_s"] ** 2 for rotor in model]
    assert np.allclose(thrusts, [6.53, 6.53, 6.53, 7.0], rtol=1e-14)


def test_parts():
    units = pint.UnitRegistry()
    rotor = mavc.Rotor(max_thrust=14, torque_per_thrust=0.016, max_speed=900)
    parts = {
        "motor_mass": 0.095,
        "arm_mass": 60 * units.gram,
        "battery": {"mass": 1.1, "at": (0, 0, -0.04), "size": [15, 7, 5] * units.centimeter},
        "camera": {"mass": 410 * units.gram, "at": (0.09, 0, -0.06)},
    }
    built = mavc.build(mavc.Vehicle(layout="PNPN", arm=0.25, first=np.pi / 4, rotor=rotor, parts=parts))
    vehicle = built.model["vehicle"]
    assert np.isclose(vehicle["mass_kg"], 4 * (0.095 + 0.06) + 1.1 + 0.41)
    assert np.isclose(vehicle["centre_of_gravity_m"][0], 0.41 * 0.09 / 2.13)
    assert built.set("vehicle.parts.motor_mass", 120 * units.gram).model["vehicle"]["mass_kg"] > vehicle["mass_kg"]
    with pytest.raises(ValueError, match="part 'battery' takes mass, at and size"):
        mavc.build(mavc.Vehicle(layout="PNPN", arm=0.25, rotor=rotor, parts={"battery": {"mass": 1.1}}))
    with pytest.raises(mavc.BuildError) as caught:
        mavc.build(mavc.Vehicle(layout="PNPN", arm=0.25, rotor=rotor, parts={"battery": {"mass": -1.1, "at": (0, 0, 0)}}))
    assert [problem.field for problem in caught.value.problems] == ["vehicle.parts.battery.mass"]


def test_every_mistake_is_reported_with_its_call():
    with pytest.raises(mavc.BuildError) as caught:
        mavc.build(octo(mas=2.0), mission=mavc.Mission([(0, 0, 2), (1, 0, 2)]), plan={"planner": "best"})
    fields = [problem.field for problem in caught.value.problems]
    assert fields == ["vehicle.mas", "plan.planner"]
    assert caught.value.problems[0].help == "did you mean `mass`?"
    assert str(caught.value).count("\n") == 1 and "arm" in caught.value.text
    assert isinstance(caught.value, ValueError)
    with pytest.raises(mavc.SpecError, match="mass"):
        mavc.build(octo(), set=["vehicle.mass = 2 m"])
    with pytest.raises(ValueError, match="has no bound"):
        mavc.build(octo(), mission=mavc.Mission([(0, 0, 2)], limits={"speed": (None, None)}))


def test_what_has_no_value_is_an_override():
    spec = mavc.build(octo(), set=["vehicle.mass = 1.8 kg +- 0.1 kg"])
    assert spec.analyze().modes[0].record["robust"] is not None


def test_quantities_of_pint():
    units = pint.UnitRegistry()
    rotor = {
        "max_thrust": 6.53 * units.newton,
        "torque_per_thrust": 16 * units.millimeter,
        "max_speed": 874 * units.radian / units.second,
    }
    inertia = np.array([0.0429, 0.0429, 0.0748]) * units.kilogram * units.meter**2
    vehicle = octo(mass=1800 * units.gram, arm=21.1 * units.centimeter, rotor=rotor, inertia=inertia)
    mission = mavc.Mission(
        [[0, 0, 2] * units.meter, mavc.Waypoint([10, 0, 5], yaw=90 * units.degree, hold=0.05 * units.minute)],
        limits={"speed": 21.6 * units.kilometer / units.hour, "tilt": 20 * units.degree},
    )
    spec = mavc.build(vehicle, mission=mission, plan={"time": 0.5 * units.minute})
    plain = mavc.build(
        octo(),
        mission=mavc.Mission(
            [(0, 0, 2), mavc.Waypoint((10, 0, 5), yaw=np.pi / 2, hold=3.0)], limits={"speed": 6.0, "tilt": np.pi / 9}
        ),
        plan={"time": 30.0},
    )
    numbers = lambda spec: np.array([float(part) for part in _words(spec.text)])
    assert np.allclose(numbers(spec), numbers(plain), rtol=1e-14)
    assert spec.set("vehicle.mass", 2000 * units.gram).model["vehicle"]["mass_kg"] == 2.0
    with pytest.raises(ValueError, match="vehicle.mass is in kg, not in m: 2 meter"):
        octo_in_metres = octo(mass=2 * units.meter)
        mavc.build(octo_in_metres)
    with pytest.raises(ValueError, match="kelvin"):
        spec.set("vehicle.mass", 2 * units.kelvin)
    with pytest.raises(ValueError, match="plan.time is in s"):
        spec.set("plan.time", 2 * units.kilogram)


def _words(text):
    import re

    return re.findall(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e-?\d+)?", text)
