"""Random vehicles as SDF and MJCF: what `mavc import vehicle` makes of them, against libsdformat and MuJoCo.

    python benches/readers/robots.py MAVC [COUNT]

Masses, centres of gravity, moments about the centre and places of rotors must agree. MuJoCo comes from PyPI; libsdformat is compiled from
inertia.cpp, if g++ and `libsdformat-dev` of Debian are there. Exits with 1 if a figure is beyond its tolerance.
"""

import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

import mujoco
import numpy as np

# Specs have twelve digits, and neither products of inertia nor moments that these digits round.
TOLERANCE = 1e-9
PLACES = [(0.2, 0.2, "ccw"), (-0.2, -0.2, "ccw"), (0.2, -0.2, "cw"), (-0.2, 0.2, "cw")]


def imported(mavc, path):
    """Mass, moments and places of motors from the centre of gravity, by motor."""
    run = subprocess.run([mavc, "import", "vehicle", str(path)], capture_output=True, text=True)
    if run.returncode != 0:
        raise SystemExit(f"{path.read_text()}\n{run.stderr}")
    text = run.stdout
    numbers = lambda words: np.array([float(x) for x in re.findall(r"-?[\d.]+(?:e-?\d+)?", words)])
    mass = numbers(re.search(r"mass\s+= (.+) kg\n", text).group(1))[0]
    moments = numbers(re.search(r"inertia\s*= (.+) kg\*m\^2", text).group(1))
    rotors = {int(m): numbers(p) for p, m in re.findall(r"rotor at (\[.+?\]) m .*motor (\d+)", text)}
    thrusts = re.search(r"max_thrust\s*= (.+) N", text)
    return mass, moments, [rotors[k] for k in sorted(rotors)], float(thrusts.group(1)) if thrusts else None


def whole(parts):
    """Mass, centre and inertia about it of parts (mass, centre, inertia about the part's own centre)."""
    mass = sum(part[0] for part in parts)
    centre = sum(part[0] * part[1] for part in parts) / mass
    inertia = np.zeros((3, 3))
    for m, c, own in parts:
        r = c - centre
        inertia += own + m * (r @ r * np.eye(3) - np.outer(r, r))
    return mass, centre, inertia


def compare(worst, ours, due):
    mass, moments, rotors, _ = ours
    due_mass, centre, inertia, places = due
    off = [
        ("mass, share", abs(mass / due_mass - 1)),
        ("moments, share", np.abs(moments / np.diag(inertia) - 1).max()),
        ("rotors, m", max(np.abs(r - (p - centre)).max() for r, p in zip(rotors, places, strict=True))),
    ]
    for name, value in off:
        worst[name] = max(worst.get(name, 0.0), value)


def pose(chance, flat=False):
    """A pose of SDF in one of its forms; without tilt if `flat`."""
    x, y, z = (chance.uniform(-0.3, 0.3) for _ in range(3))
    tilt = [0, 0] if flat else [chance.uniform(-1, 1) for _ in range(2)]
    angles = [*tilt, chance.uniform(-3, 3)]
    return f"{x} {y} {z}", angles


def written(chance, place, angles, to):
    to = f" relative_to='{to}'" if to else ""
    if chance.random() < 0.3:
        return f"<pose degrees='true'{to}>{place} {' '.join(str(np.degrees(a)) for a in angles)}</pose>"
    if chance.random() < 0.3:
        # Fixed axes: first about x, then y, then z.
        half = np.array(angles) / 2
        (sr, sp, sy), (cr, cp, cy) = np.sin(half), np.cos(half)
        x, y = sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy
        z, w = cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy
        return f"<pose rotation_format='quat_xyzw'{to}>{place} {x} {y} {z} {w}</pose>"
    return f"<pose{to}>{place} {' '.join(map(str, angles))}</pose>"


def inertial(chance, own_pose=True):
    mass = chance.uniform(0.05, 2)
    a, b, c = (mass * chance.uniform(0.01, 0.02) for _ in range(3))
    where = written(chance, *pose(chance), None) if own_pose and chance.random() < 0.5 else ""
    return f"<inertial>{where}<mass>{mass}</mass><inertia><ixx>{a}</ixx><iyy>{b}</iyy><izz>{c}</izz></inertia></inertial>"


def sdf(chance):
    """Links on frames on frames, upright where rotors are, and a model within the model."""
    out, frames, upright = [], ["__model__"], ["__model__"]
    for k in range(chance.randrange(4)):
        flat = chance.random() < 0.6
        attached = chance.choice(frames if not flat else upright)
        place, angles = pose(chance, flat)
        out.append(f"<frame name='f{k}' attached_to='{attached}'>{written(chance, place, angles, chance.choice([None, attached]))}</frame>")
        frames.append(f"f{k}")
        if flat:
            upright.append(f"f{k}")
    place, angles = pose(chance, True)
    out.append(f"<link name='base'>{written(chance, place, angles, chance.choice(upright))}{inertial(chance)}</link>")
    upright.append("base")
    for k in range(chance.randrange(3)):
        place, angles = pose(chance)
        parent = chance.choice(frames)
        out.append(f"<link name='l{k}'>{written(chance, place, angles, parent)}{inertial(chance)}</link>")
        joint = "" if chance.random() < 0.5 else written(chance, *pose(chance), chance.choice(frames))
        out.append(f"<joint name='j{k}' type='fixed'><parent>base</parent><child>l{k}</child>{joint}</joint>")
        frames.append(f"j{k}")
    if chance.random() < 0.5:
        place, angles = pose(chance)
        inner = f"<link name='pod'>{written(chance, *pose(chance), None)}{inertial(chance)}</link>"
        out.append(f"<model name='inner'>{written(chance, place, angles, chance.choice(frames))}{inner}</model>")
    for k, (x, y, turn) in enumerate(PLACES):
        to = chance.choice(upright)
        out.append(f"<link name='prop{k}'>{written(chance, f'{x} {y} {0.05 * k}', [0, 0, chance.uniform(-3, 3)], to)}{inertial(chance, False)}</link>")
        out.append(f"<joint name='spin{k}' type='revolute'><parent>base</parent><child>prop{k}</child><axis><xyz>0 0 1</xyz></axis></joint>")
        out.append(
            f"<plugin name='m{k}' filename='motor'><jointName>spin{k}</jointName><linkName>prop{k}</linkName><turningDirection>{turn}"
            f"</turningDirection><motorConstant>8e-6</motorConstant><momentConstant>0.016</momentConstant><maxRotVelocity>900"
            f"</maxRotVelocity><motorNumber>{k}</motorNumber></plugin>"
        )
    middle = "".join(out)
    return f"<?xml version='1.0'?><sdf version='1.9'><model name='v'>{middle}</model></sdf>"


def by_libsdformat(reader, path):
    run = subprocess.run([reader, str(path)], capture_output=True, text=True, check=True)
    parts, places = [], {}
    for line in run.stdout.splitlines():
        name, *rest = line.split()
        mass, *rest = map(float, rest)
        parts.append((mass, np.array(rest[:3]), np.array(rest[3:12]).reshape(3, 3)))
        if name.startswith("prop"):
            places[name] = np.array(rest[12:])
    return *whole(parts), [places[name] for name in sorted(places)]


GEOMS = ["sphere", "box", "cylinder", "capsule", "ellipsoid"]


def turn_of(chance, degrees):
    unit = 1.0 if degrees else np.pi / 180
    kind = chance.choice(["", "quat", "euler", "axisangle", "xyaxes", "zaxis"])
    numbers = {
        "": [],
        "quat": [chance.gauss(0, 1) for _ in range(4)],
        "euler": [chance.uniform(-180, 180) * unit for _ in range(3)],
        "axisangle": [*(chance.gauss(0, 1) for _ in range(3)), chance.uniform(-180, 180) * unit],
        "xyaxes": [chance.gauss(0, 1) for _ in range(6)],
        "zaxis": [chance.gauss(0, 1) for _ in range(3)],
    }[kind]
    return f"{kind}='{' '.join(map(str, numbers))}'" if kind else ""


def geom(chance, degrees):
    kind = chance.choice(GEOMS)
    size = [chance.uniform(0.02, 0.2) for _ in range(3)]
    where = f"pos='{' '.join(str(chance.uniform(-0.2, 0.2)) for _ in range(3))}' {turn_of(chance, degrees)}"
    if kind not in ("sphere",) and chance.random() < 0.4:
        where = f"fromto='{' '.join(str(chance.uniform(-0.2, 0.2)) for _ in range(6))}'"
    mass = chance.choice([f"mass='{chance.uniform(0.05, 1)}'", f"density='{chance.uniform(50, 500)}'", ""])
    return f"<geom type='{kind}' size='{' '.join(map(str, size))}' {where} {mass}/>"


def mjcf(chance):
    degrees = chance.random() < 0.5
    sequence = "".join(chance.choice("xyzXYZ") for _ in range(3)) if chance.random() < 0.5 else "xyz"
    settings = f"angle='{'degree' if degrees else 'radian'}' eulerseq='{sequence}'"
    if chance.random() < 0.3:
        settings += f" settotalmass='{chance.uniform(0.5, 5)}'"
    own = f"<inertial pos='0.01 0.02 0.03' mass='1.5' diaginertia='0.01 0.012 0.015' {turn_of(chance, degrees)}/>"
    own = own if chance.random() < 0.4 else "".join(geom(chance, degrees) for _ in range(chance.randrange(1, 4)))
    inner = "".join(
        f"<body pos='{chance.uniform(-0.1, 0.1)} 0 0.05' {turn_of(chance, degrees)}>{geom(chance, degrees)}</body>"
        for _ in range(chance.randrange(3))
    )
    lift = chance.uniform(-0.05, 0.05)
    sites = "".join(f"<site name='s{k}' pos='{x} {y} {lift}'/>" for k, (x, y, _) in enumerate(PLACES))
    gain, gear, most = chance.uniform(1, 9), chance.uniform(0.5, 2), chance.uniform(0.5, 2)
    motors = "".join(f"<general site='s{k}' class='rotor'/>" for k in range(4))
    default = f"<default><default class='rotor'><general gear='0 0 {gear} 0 0 {0.01 * gear}' gainprm='{gain}' ctrlrange='0 {most}'/></default></default>"
    text = (
        f"<mujoco model='v'><compiler {settings}/>{default}<worldbody><body name='v' pos='1 2 3' euler='0 0 20'><freejoint/>{own}{inner}{sites}"
        f"</body></worldbody><actuator>{motors}</actuator></mujoco>"
    )
    return text, gain * gear * most


def by_mujoco(text):
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    body = model.body("v").id
    turn, origin = data.xmat[body].reshape(3, 3), data.xpos[body]
    parts = []
    for k in range(body, model.nbody):
        axes = turn.T @ data.ximat[k].reshape(3, 3)
        parts.append((model.body_mass[k], turn.T @ (data.xipos[k] - origin), axes @ np.diag(model.body_inertia[k]) @ axes.T))
    return *whole(parts), [model.site_pos[k] for k in range(4)]


def main():
    mavc, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 100
    here = pathlib.Path(__file__).parent
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        worst = {}
        for seed in range(count):
            text, thrust = mjcf(random.Random(seed))
            path = folder / "v.xml"
            path.write_text(text)
            ours = imported(mavc, path)
            compare(worst, ours, by_mujoco(text))
            worst["thrust, share"] = max(worst.get("thrust, share", 0), abs(ours[3] / thrust - 1))
        sources = {"MJCF, MuJoCo": worst}
        flags = shutil.which("pkg-config") and subprocess.run(["pkg-config", "--cflags", "--libs", "sdformat12"], capture_output=True, text=True)
        if flags and flags.returncode == 0 and shutil.which("g++"):
            reader = folder / "inertia"
            subprocess.run(["g++", "-std=c++17", here / "inertia.cpp", "-o", reader, *flags.stdout.split()], check=True)
            sources["SDF, libsdformat"] = worst = {}
            for seed in range(count):
                path = folder / "v.sdf"
                path.write_text(sdf(random.Random(seed)))
                compare(worst, imported(mavc, path), by_libsdformat(reader, path))
        else:
            print("SDF: without libsdformat-dev nothing was compared")
        for title, worst in sources.items():
            for name, value in worst.items():
                beyond = value > TOLERANCE
                failed |= beyond
                print(f"{title:18} {count} vehicles  {name:15} {value:9.2e} of {TOLERANCE:7.0e}{'   BEYOND' if beyond else ''}")
    sys.exit(int(failed))


if __name__ == "__main__":
    main()
