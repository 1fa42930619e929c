"""A program that uses every part of the package, checked by `mypy --strict` and also run: its types are those that users get."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import mavc
import numpy as np

QUICK = {"planner": "rip", "model": "hover", "samples": 40}


def imported(parameters: str) -> mavc.Spec:
    text: str = mavc.import_vehicle(parameters, name="quad.params", warn=False)
    given: mavc.Imported = mavc.import_vehicle(parameters, warn=False)
    figures: dict[str, str] = dict.fromkeys(given.unknown, "1")
    figures |= {"vehicle.mass": "1 kg", "vehicle.inertia": "[0.01, 0.01, 0.02] kg*m^2"}
    figures |= {"vehicle.rotor.max_thrust": "6 N", "vehicle.rotor.max_speed": "900 rad/s"}
    return mavc.compile(text, set=figures, warn=False)


def mistakes() -> list[tuple[str, int]]:
    try:
        mavc.compile("vehicle {", set=["vehicle.mass = 1 kg"])
    except mavc.SpecError as error:
        return [(found.code, found.place.line) for found in error.diagnostics]
    return []


def margins(spec: mavc.Spec) -> np.ndarray:
    analysis: mavc.Analysis = spec.analyze(threads=1)
    names: list[str] = [mode.name for mode in analysis.modes if mode.survives]
    assert names
    return analysis.margins


def planned(spec: mavc.Spec, folder: Path) -> float:
    reports: list[str] = []
    plan: mavc.Plan = spec.plan(progress=lambda report: reports.append(report.text), cancel=mavc.Cancel())
    if plan.trajectory is None:
        raise ValueError(plan.explanation)
    exported: mavc.Exported = plan.export("px4-offboard", folder / "plan.py", rate=20.0)
    length: int = len(exported.data) + len(exported.text)
    verified: mavc.Verification = spec.verify(plan.certificate())
    assert length > 0 and verified.headline and reports
    positions: np.ndarray = plan.at(50.0).position
    return float(np.linalg.norm(positions[-1] - positions[0])) + plan.time


def flown(spec: mavc.Spec, folder: Path) -> str | None:
    flight: mavc.Simulation = spec.simulate(rate=50.0)
    flight.export("mcap", folder / "flight.mcap", layout=folder / "flight.json")
    rows: mavc.Rows = spec.campaign(times=1, seeds=1).rows
    outcomes: list[str] = rows["outcome"].tolist()
    return flight.outcome if outcomes else None


def swept(spec: mavc.Spec) -> float:
    def heaviest(spec: mavc.Spec) -> dict[str, float]:
        return {"heaviest_kg": float(min(mode.critical_mass for mode in spec.analyze().modes[:1]))}

    with ThreadPoolExecutor(1) as pool:
        found: mavc.Sweep = mavc.sweep(spec, grid={"vehicle.mass": [1.6, 1.8]}, run=heaviest, client=pool)
    return float(found["heaviest_kg"].max())


def built() -> mavc.Spec:
    rotor = mavc.Rotor(max_thrust=6.53, torque_per_thrust=0.016, max_speed=874)
    vehicle = mavc.Vehicle(layout=mavc.rings(8)[0], arm=0.211, mass=1.8, inertia=[0.0429, 0.0429, 0.0748], rotor=rotor)
    mission = mavc.Mission([(0, 0, 2), mavc.Waypoint((10, 0, 5), yaw=1.0)], limits={"speed": 6.0, "altitude": (1.0, None)})
    return mavc.build(vehicle, [mavc.FaultMode("M1", lost=1)], mission, plan=QUICK, set={"plan.time": 20.0})


def crashed(log: Path, spec: mavc.Spec) -> list[int]:
    try:
        found: mavc.Diagnosis = mavc.diagnose(log, spec, baseline=[log], hide=[1], threads=1)
    except mavc.SpecError:
        return []
    losses: mavc.Table = found.frames["losses"]
    identified: mavc.Identified = mavc.identify(log, "1.5 kg", warn=False)
    known: list[float] = [figure.value for figure in identified.figures if figure.value is not None]
    assert known and found.headline
    return list(found.motors) if losses.rows else []


def test_a_typed_program(tmp_path: Path) -> None:
    spec = built()
    assert mistakes() and swept(spec) > 1.8
    assert margins(spec).shape == (1,)
    assert planned(spec, tmp_path) > 20.0
    assert flown(spec, tmp_path) == "flown"
    (tmp_path / "no_log.bin").write_bytes(b"no log")
    assert crashed(tmp_path / "no_log.bin", spec) == []
    rotors = [(0.2, 0.2, 1), (-0.2, -0.2, 1), (0.2, -0.2, -1), (-0.2, 0.2, -1)]
    lines = ["CA_ROTOR_COUNT,4"]
    for i, (x, y, sign) in enumerate(rotors):
        lines += [f"CA_ROTOR{i}_PX,{x}", f"CA_ROTOR{i}_PY,{y}", f"CA_ROTOR{i}_KM,{0.02 * sign}"]
    assert imported("\n".join(lines) + "\n").model["vehicle"]["mass_kg"] == 1.0
