"""Processor time and memory of the commands at the limits of the language and of the formats that are read: docs/performance.md,
"At the bounds".

    python3 benches/limits.py target/release/mavc [WORD]

With a word only the rows that contain it are run. A command is stopped after SECONDS of the processor.
"""

import math
import os
import resource
import signal
import subprocess
import sys
import tempfile

SECONDS = 60
# Memory that each command keeps.
KEPT_MB = 500


def vehicle(rotors, mass=1.5, fields="", thrust="6 N"):
    return f"""vehicle v {{
layout = "{"PN" * (rotors // 2)}"
arm = {max(0.3, 0.02 * rotors)} m
mass = {mass} kg
inertia = [0.02, 0.02, 0.04] kg*m^2
size = 0.5 m
{fields}
rotor {{ max_thrust = {thrust}; torque_per_thrust = 15 mm; max_speed = 900 rad/s }}
}}
"""


def mission(points, more="", of_leg=""):
    lines = [f"waypoint at [{x:g}, {y:g}, {z:g}] m {of_leg}" for x, y, z in points[1:]]
    start = "start at [{:g}, {:g}, {:g}] m".format(*points[0])
    return "\n".join(["mission m {", start, *lines, "limits { speed <= 8 m/s; tilt <= 30 deg }", more, "}\n"])


def rows_of_points(count, y0=0):
    """A field flown row by row, 3 m from point to point."""
    return [(3 * (i // 100), y0 + 3 * (i % 100 if i // 100 % 2 == 0 else 99 - i % 100), 10) for i in range(count)]


def polygon(side, k, centre, radius, corners, notch=1.0):
    def corner(i):
        r, angle = radius * (notch if i % 2 else 1.0), 2 * math.pi * i / corners + 0.001 * k
        return f"[{centre[0] + r * math.cos(angle):.5f}, {centre[1] + r * math.sin(angle):.5f}]"

    listed = ", ".join(corner(i) for i in range(corners))
    return f"{side} p{k} {{ shape = polygon; corners = [{listed}] m; bottom = 0 m; top = 30 m }}"


def fences(count, notch=1.0):
    places = [(20 + 10 * (k % 10), 10 * (k // 10) - 45) for k in range(count)]
    return "\n".join(polygon("keep_out", k, place, 4, 200, notch) for k, place in enumerate(places))


def specs():
    """Each row of the table: what is at its limit, and the spec."""
    hop = [(0, 0, 10), (6, 0, 10), (6, 6, 11)]
    plain = "plan { time = 12 s; samples = 50 }\n"
    exact = "plan { model = exact; time = 12 s; samples = 50 }\n"
    yield "32 rotors", vehicle(32, 9) + mission(hop) + plain
    yield "32 rotors with intervals", vehicle(32, 9, thrust="6 N +- 1 %") + mission(hop) + plain
    singles = "faults { every 1 rotor lost as M { without_yaw = always } }\n"
    free = "plan { planner = rcp; against = [M]; time = 12 s; samples = 20 }\n"
    yaw = "yaw_drag = 2.75e-3 N*m*s/rad"
    yield "32 rotors, each loss without yaw", vehicle(32, 9, yaw) + singles + mission(hop) + free
    unsure = vehicle(32, 9, yaw, thrust="6 N +- 1 %")
    yield "32 rotors with intervals, each loss without yaw", unsure + singles + mission(hop) + free
    all_unsure = unsure.replace("15 mm", "15 mm +- 5 %").replace("mass = 9 kg", "mass = 9 kg +- 3 %")
    yield "32 rotors, intervals of all, each loss without yaw", all_unsure + singles + mission(hop) + free
    triples = "faults { every 3 rotors lost as T\nevery 3 rotors reduced to 50 % as R }\n"
    rip = plain.replace("plan {", "plan { planner = rip; against = [];")
    yield "9,920 modes", vehicle(32, 9) + triples + mission(hop) + rip
    shares = "\n".join(f"every 3 rotors reduced to {share} % as R{share}" for share in range(50, 64))
    against = ", ".join(f"R{share}" for share in range(50, 64))
    many_sets = f"plan {{ planner = rcp; against = [{against}]; time = 12 s; samples = 20 }}\n"
    yield "784 sets of 8 rotors", vehicle(8) + f"faults {{ {shares} }}\n" + mission(hop) + many_sets
    many_samples = "timing = proportional; samples = 3000"
    yield "3,000 samples", vehicle(8) + mission(hop) + plain.replace("samples = 50", many_samples)
    yield "3,000 samples, exact model", vehicle(8) + mission(hop) + exact.replace("samples = 50", many_samples)
    long = mission(rows_of_points(9_900)) + "plan { time = 30000 s }\n"
    yield "9,900 waypoints, more than any plan has samples", vehicle(8) + long
    legs = mission(rows_of_points(3_000), of_leg="{ speed <= 5 m/s; acceleration <= 4 m/s^2 }")
    yield "3,000 legs with limits of their own", vehicle(8) + legs + f"plan {{ time = 9000 s; {many_samples} }}\n"
    yield "100 keep_out of 200 corners", vehicle(8) + mission(hop, fences(100)) + exact
    yield "100 keep_out of 200 corners that turn inwards", vehicle(8) + mission(hop, fences(100, 0.6)) + exact
    inside = "\n".join(polygon("keep_in", k, (0, 0), 40, 200) for k in range(100))
    yield "100 keep_in of 200 corners", vehicle(8) + mission(hop, inside) + plain
    straight = mission(rows_of_points(3_000, 60), fences(60), of_leg="straight")
    yield "60 keep_out and 3,000 straight legs", (
        vehicle(8) + straight + f"plan {{ model = exact; time = 9000 s; {many_samples} }}\n"
    )
    wind = "air { wind = [3, 1, 0] m/s +- [3, 3, 1] m/s }"
    rsp = "plan { model = exact; planner = rsp; against = [M]; time = 8 s; samples = 100 }\n"
    single = "faults { every 1 rotor lost as M }\n"
    yield "an interval of winds", vehicle(8, 1.5, "drag = 0.25 N*s/m") + single + mission(hop, wind) + rsp


def files():
    """Each row of imports: what is at its limit, the name of the file, and its text."""
    joint = "<joint><parent link='l{}'/><child link='l{}'/><origin xyz='0.001 0 0'/></joint>"
    chain = "".join(f"<link name='l{i}'/>" + joint.format(i - 1, i) for i in range(1, 90_000))
    yield "URDF, a chain of 90,000 links", "chain.urdf", f"<robot><link name='l0'/>{chain}</robot>"
    link = "<link name='l{}'><pose relative_to='l{}'>0 0 0 0 0 0</pose></link>"
    links = "".join(link.format(i, i - 1) for i in range(1, 150_000))
    yield "SDF, a chain of 150,000 links", "links.sdf", f"<sdf><model name='m'><link name='l0'/>{links}</model></sdf>"
    classes = "".join(f"<default class='c{i}'><motor gear='0 0 1 0 0 1'/></default>" for i in range(80_000))
    sites = "".join(f"<site name='s{i}'/>" for i in range(80_000))
    motors = "".join(f"<motor class='c{i}' site='s{i}'/>" for i in range(80_000))
    world = f"<worldbody><body>{sites}</body></worldbody><actuator>{motors}</actuator>"
    yield "MJCF, 80,000 motors of as many classes", "m.xml", f"<mujoco><default>{classes}</default>{world}</mujoco>"
    yield "parameters, 16 MB", "many.param", "".join(f"MOT_{i},1\n" for i in range(1_200_000))


def limited():
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))


def run(mavc, *arguments):
    """How a command went, as a cell of the table."""
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    process = subprocess.Popen([mavc, *arguments], preexec_fn=limited, **quiet)
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    megabytes = used.ru_maxrss / 1000
    ended = {0: "", -signal.SIGXCPU: ", stopped"}.get(process.returncode, f", exit code {process.returncode}")
    too_much = " **too much**" if megabytes > KEPT_MB else ""
    return f"{used.ru_utime + used.ru_stime:.2f} s, {megabytes:.0f} MB{too_much}{ended}"


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit("usage: python3 benches/limits.py MAVC [WORD]")
    mavc = os.path.abspath(sys.argv[1])
    if not os.access(mavc, os.X_OK):
        sys.exit(f"cannot run {sys.argv[1]}: build it with `cargo build --release`")
    word = sys.argv[2] if len(sys.argv) > 2 else ""
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        print("| at the limit | `check` | `plan` | `verify` |\n|---|---|---|---|")
        for number, (name, text) in enumerate(specs()):
            if word not in name:
                continue
            spec, proof = f"{number}.mav", f"{number}.json"
            write(spec, text)
            cells = [run(mavc, "check", spec), run(mavc, "plan", spec, "--certificate", proof)]
            cells.append(run(mavc, "verify", proof, spec) if os.path.exists(proof) else "no certificate")
            print(f"| {name} | {' | '.join(cells)} |", flush=True)
        print("\n| a file at the limit | `import vehicle` |\n|---|---|")
        for name, path, text in files():
            if word not in name:
                continue
            write(path, text)
            print(f"| {name} | {run(mavc, 'import', 'vehicle', path)} |", flush=True)


if __name__ == "__main__":
    main()
