"""Reads vehicles of autopilots with `mavc import vehicle`, and compares them with what their makers publish.

    python benches/readers/vehicles.py MAVC [FOLDER]

Needs `ardupilot-methodic-configurator` from PyPI, which ships ArduPilot's own list of motors (AP_Motors_test.json) and templates of copters.
FOLDER may have airframe scripts of PX4. Exits with 1 where a motor is elsewhere, a file ends mavc otherwise than with a vehicle or an
error, or a reason is missing.
"""

import importlib.util
import json
import math
import pathlib
import re
import subprocess
import sys

ARM = 0.25
FIGURES = {
    "mass": "2 kg",
    "let mass": "2 kg",
    "inertia": "[0.02, 0.02, 0.04] kg*m^2",
    "max_thrust": "9 N",
    "torque_per_thrust": "15 mm",
    "max_speed": "900 rad/s",
    "let arm": f"{ARM} m",
}
# Angles in the list are those of its factors, which are stretched to squares: only frames whose motors lie on such places agree by direction.
TOLERANCE = 1e-3


def ran(mavc, arguments, text=None):
    return subprocess.run([mavc, *arguments], input=text, capture_output=True, text=True)


def imported(mavc, text):
    """The spec, or the first line of the error."""
    run = ran(mavc, ["import", "vehicle", "-"], text)
    if run.returncode == 0:
        return run.stdout, None
    found = re.search(r"[×x] (.+)", run.stderr)
    if run.returncode != 1 or not found:
        raise SystemExit(f"mavc ended with {run.returncode}: {run.stderr}")
    return None, found.group(1)


def rotors(mavc, spec):
    """Forward and left (m) and spin of every rotor, by `mavc emit model --format json`."""
    lines = []
    for line in spec.splitlines():
        for name, figure in FIGURES.items():
            if line.strip().startswith(name + " "):
                line = line.replace("?", figure, 1)
        lines.append(line)
    run = ran(mavc, ["emit", "model", "--format", "json", "-"], "\n".join(lines) + "\n")
    if run.returncode != 0:
        raise SystemExit(run.stderr)
    model = json.loads(run.stdout)
    return [(r["position_m"], r["spin"]) for r in model["vehicle"]["rotors"]]


def stretched(places):
    """ArduPilot's factors: each axis scaled so that its largest is 0.5."""
    most = [max(abs(p[i]) for p in places) for i in (0, 1)]
    return [[0.5 * p[i] / most[i] if most[i] > 0 else 0.0 for i in (0, 1)] for p in places]


def frames(mavc, folder):
    layouts = json.loads((folder / "plugins" / "AP_Motors_test.json").read_text())["layouts"]
    worst, agreed, reasons = 0.0, 0, {}
    for layout in layouts:
        text = f"FRAME_CLASS,{layout['Class']}\nFRAME_TYPE,{layout['Type']}\n"
        spec, reason = imported(mavc, text)
        if reason:
            reasons.setdefault(reason, 0)
            reasons[reason] += 1
            continue
        found = rotors(mavc, spec)
        motors = sorted(layout["motors"], key=lambda m: m["Number"])
        places = stretched([p for p, _ in found])
        if len(found) != len(motors):
            raise SystemExit(f"{layout['ClassName']} {layout['TypeName']}: {len(found)} and not {len(motors)} motors")
        for (forward, left), (_, spin), motor in zip(places, found, motors):
            off = math.hypot(forward - motor["Pitch"], left - motor["Roll"])
            worst = max(worst, off)
            if off > TOLERANCE or spin != {"CCW": "P", "CW": "N"}[motor["Rotation"]]:
                raise SystemExit(f"{layout['ClassName']} {layout['TypeName']} motor {motor['Number']}: {off} {spin}")
        agreed += 1
    print(f"ArduPilot's motors: {agreed} of {len(layouts)} frames agree, largest difference {worst:.1e} of a frame's width")
    for reason, count in sorted(reasons.items()):
        print(f"  refused {count}: {reason}")


def templates(mavc, folder):
    copters = sorted(p for p in (folder / "vehicle_templates" / "ArduCopter").iterdir() if p.is_dir())
    vehicles = 0
    print(f"Templates of copters: {len(copters)}")
    for copter in copters:
        files = sorted(copter.rglob("11_servo_outputs.param")) or sorted(copter.rglob("*servo_outputs.param"))
        spec, reason = imported(mavc, files[-1].read_text())
        vehicles += spec is not None
        print(f"  {copter.name}: {'a vehicle with %d rotors' % spec.count('rotor at') if spec else reason}")
    print(f"  {vehicles} vehicles")


def allocated(script):
    """Forward and left (m) and spin of every rotor of a script of PX4, with its defaults: places 0, torque per thrust 0.05."""
    found = dict(re.findall(r"^\s*param set(?:-default)?\s+(CA_\w+)\s+(\S+)", script, re.MULTILINE))
    value = lambda i, key, default=0.0: float(found.get(f"CA_ROTOR{i}_{key}", default))
    count = int(found["CA_ROTOR_COUNT"])
    return [((value(i, "PX"), -value(i, "PY"), -value(i, "PZ")), "P" if value(i, "KM", 0.05) > 0 else "N") for i in range(count)]


def airframes(mavc, folder):
    vehicles, scripts = 0, sorted(p for p in folder.rglob("*") if p.is_file())
    for script in scripts:
        text = script.read_text(errors="replace")
        spec, reason = imported(mavc, text)
        print(f"  {script.name}: {'a vehicle with %d rotors' % spec.count('rotor at') if spec else reason}")
        if spec:
            vehicles += 1
            found = [(tuple(place), spin) for place, spin in rotors(mavc, spec)]
            expected = allocated(text)
            if len(found) != len(expected) or any(
                spin != as_spin or max(abs(x - y) for x, y in zip(place, as_place)) > 1e-6
                for (place, spin), (as_place, as_spin) in zip(found, expected)
            ):
                raise SystemExit(f"{script}: {found} and not {expected}")
    print(f"  {vehicles} of {len(scripts)} are vehicles, every rotor as the script has it")


def main():
    mavc = sys.argv[1]
    package = importlib.util.find_spec("ardupilot_methodic_configurator")
    folder = pathlib.Path(package.submodule_search_locations[0])
    frames(mavc, folder)
    templates(mavc, folder)
    if len(sys.argv) > 2:
        print("Airframes of PX4")
        airframes(mavc, pathlib.Path(sys.argv[2]))


main()
