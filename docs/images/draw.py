"""Draws the pictures of the documents from what mavc prints.

    python3 docs/images/draw.py target/release/mavc            # writes docs/images/*.svg; needs numpy
    python3 docs/images/draw.py target/debug/mavc --check      # fails if a picture is not what mavc prints now
"""

import csv
import io
import itertools
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
from svg import BLUE, GREEN, GREY, INK, ORANGE, PALE, RED, Axes, Picture, differ

HERE = Path(__file__).resolve().parent
ROOF = HERE.parents[1] / "examples" / "roof_octo.mav"
SURVEY = HERE.parents[1] / "examples" / "survey_hexa.mav"
BOARDS = ["board1", "board2", "board3", "board4"]
THRUST, ROLL, PITCH, YAW = range(4)
# Violations up to this share of the healthy width are the tolerance of plans (0.01 %) and rounding.
TOLERANCE = 2e-4


class Mavc:
    """The command, which prints to standard output."""

    def __init__(self, program):
        self.program = str(Path(program).resolve())

    def printed(self, *arguments, may_be_lost=False):
        ran = subprocess.run([self.program, *arguments, "--quiet"], capture_output=True, text=True)
        if ran.returncode not in ((0, 6) if may_be_lost else (0,)):
            sys.exit(f"mavc {' '.join(map(str, arguments))}: exit code {ran.returncode}\n{ran.stderr}")
        return ran.stdout

    def table(self, *arguments, **how):
        """The columns of the table that a command writes with `-o -`, by name."""
        rows = list(csv.DictReader(io.StringIO(self.printed(*arguments, "-o", "-", **how))))
        return {name: np.array([float(row[name] or "nan") for row in rows]) for name in rows[0]}

    def sets(self, spec):
        """{mode: (N, e)} with the facets N w <= e of each mode's admissible set; w = [T, tau_x, tau_y, tau_z]."""
        sets, mode = {}, None
        for line in self.printed("emit", "sets", spec).splitlines():
            if line and not line.startswith(" "):
                mode = line.split(":")[0]
                sets[mode] = ([], [])
            elif "<=" in line:
                left, right = line.split("<=")
                sets[mode][0].append([float(v) for v in left.split()])
                sets[mode][1].append(float(right.split()[0]))
        return {mode: (np.array(n), np.array(e)) for mode, (n, e) in sets.items()}

    def healthy_width(self, spec, normal):
        """The width of the healthy vehicle's set along `normal`: each rotor adds what it can vary."""
        rows = [line.split() for line in self.printed("emit", "actuation", spec).splitlines()]
        numbers = {row[0]: np.array([float(v) for v in row[1:]]) for row in rows}
        full = np.stack([numbers[name] for name in ("T", "tau_x", "tau_y", "tau_z")]) * numbers["w_max"] ** 2
        return np.abs(normal @ full).sum()

    def weight(self, spec):
        model = json.loads(self.printed("emit", "model", spec, "--format", "json"))
        return model["vehicle"]["mass_kg"] * model["gravity_m_per_s2"]


def section(facets, fixed):
    """The facets of a set where the axes of `fixed` have its values: {axis: value}."""
    normals, offsets = facets
    free = [axis for axis in range(4) if axis not in fixed]
    return normals[:, free], offsets - sum(normals[:, axis] * value for axis, value in fixed.items())


def vertices(facets):
    """The vertices of a bounded set of inequalities in two or three dimensions, each once."""
    normals, offsets = facets
    found = []
    for chosen in itertools.combinations(range(len(normals)), normals.shape[1]):
        a = normals[list(chosen)]
        if abs(np.linalg.det(a)) > 1e-9:
            point = np.linalg.solve(a, offsets[list(chosen)])
            # `emit sets` prints offsets to 1e-6.
            if (normals @ point <= offsets + 2e-5).all():
                found.append(np.round(point, 4))
    return np.unique(np.array(found), axis=0) if found else np.zeros((0, normals.shape[1]))


def turn(a, b):
    """Twice the area that two vectors of the plane span, positive if b is to the left of a."""
    return a[0] * b[1] - a[1] * b[0]


def around(points):
    """The corners of the convex hull of points of the plane, counter-clockwise (Andrew's chain)."""
    points = sorted(map(tuple, points))

    def half(points):
        chain = []
        for p in points:
            while len(chain) > 1 and turn(np.subtract(chain[-1], chain[-2]), np.subtract(p, chain[-1])) <= 1e-9:
                chain.pop()
            chain.append(p)
        return chain[:-1]

    return half(points) + half(points[::-1])


def wrenches(table):
    """(N, 4): thrust and torques of the rows of a trajectory."""
    return np.stack([table[name] for name in ("thrust", "tau_x", "tau_y", "tau_z")], axis=1)


def spare(mavc, spec, facets, wrench, reserve=0.1):
    """(N, facets): how far each wrench is inside each facet, after the reserve, as a share of the healthy width."""
    normals, offsets = facets
    hover = normals @ np.array([mavc.weight(spec), 0, 0, 0])
    widths = np.array([mavc.healthy_width(spec, normal) for normal in normals])
    return (hover + (1 - reserve) * (offsets - hover) - wrench @ normals.T) / widths


def intervals(t, is_true):
    """The times between which rows of a table are all true."""
    found, start = [], None
    for k, (time, value) in enumerate(zip(t, is_true)):
        if value and start is None:
            start = time
        if start is not None and (not value or k + 1 == len(t)):
            found.append((start, time))
            start = None
    return found


def oblique(x, y, z):
    """A point of space as it is seen: east to the right, north into the picture, up."""
    return 0.92 * x + 0.42 * y, z - 0.16 * x + 0.3 * y


def roof(mavc):
    """RIP and RSP on one mission: flights with a failed board, and when each plan is outside each board's set."""
    picture = Picture(940, 430, "One mission, two plans: with a failed power board one flight is lost")
    flights = {p: mavc.table("simulate", ROOF, "--set", f"plan.planner={p}", may_be_lost=True) for p in ("rip", "rsp")}
    plans = {p: mavc.table("plan", ROOF, "--set", f"plan.planner={p}", "--rate", "20Hz") for p in ("rip", "rsp")}
    sets = mavc.sets(ROOF)
    lost = flights["rip"]["t"][-1]

    path = Axes(picture, (20, 70, 470, 330), (-1.5, 13.5), (-1.6, 13.8))
    picture.label(24, 30, "Board 1 fails 0.5 s after take-off", size=16, weight="bold")
    plan = plans["rsp"]
    for x, y, z in [(0, 0, 2), (10, 0, 12), (10, 8, 12), (0, 8, 12)]:
        path.line([oblique(x, y, 0), oblique(x, y, z)], colour=PALE, width=1)
    path.area([oblique(x, y, 0) for x, y in [(0, 0), (10, 0), (10, 8), (0, 8)]], fill="#f2f2f2", stroke=PALE)
    path.line([oblique(*p) for p in zip(plan["x"], plan["y"], plan["z"])], colour=GREY, width=1.2, dash="5 4")
    for planner, colour, width in (("rsp", GREEN, 2.6), ("rip", RED, 3.4)):
        flight = flights[planner]
        shown = range(0, len(flight["t"]), 5)
        path.line([oblique(*(flight[a][k] for a in "xyz")) for k in shown], colour=colour, width=width)
    end = path.at(*oblique(*(flights["rip"][a][-1] for a in "xyz")))
    picture.cross(*end)
    picture.label(end[0] + 16, end[1] + 16, f"RIP: lost at {lost:.1f} s", colour=RED, weight="bold", size=14)
    picture.label(*path.at(*oblique(0.7, 8, 12.3)), "RSP: flies to the end", colour=GREEN, weight="bold", size=14)
    start = path.at(*oblique(0, 0, 2))
    picture.dot(*start, fill=INK)
    picture.label(start[0] - 6, start[1] + 20, "start", size=12, colour=GREY, anchor="middle")

    picture.label(530, 30, "When would a failed board break the plan?", size=16, weight="bold")
    for row, planner in enumerate(("rip", "rsp")):
        strips = Axes(picture, (600, 78 + 168 * row, 310, 108), (0, 20), (0, 4))
        colour = RED if planner == "rip" else GREEN
        what = "RIP, which ignores faults" if planner == "rip" else "RSP, in the same 20 s"
        picture.label(600, 68 + 168 * row, what, colour=colour, weight="bold")
        for k, board in enumerate(BOARDS):
            low = 3.14 - k
            strips.area([(0, low), (20, low), (20, low + 0.72), (0, low + 0.72)], fill=GREEN, opacity=0.35)
            slack = spare(mavc, ROOF, sets[board], wrenches(plans[planner])).min(axis=1)
            for begin, end in intervals(plans[planner]["t"], slack < -TOLERANCE):
                strips.area([(begin, low), (end, low), (end, low + 0.72), (begin, low + 0.72)], fill=RED)
            picture.label(592, strips.at(0, low + 0.2)[1], f"board {k + 1}", size=12, anchor="end")
        for t in (0, 5, 10, 15, 20):
            picture.label(strips.at(t, 0)[0], 78 + 168 * row + 124, f"{t} s", size=12, colour=GREY, anchor="middle")
    red = "Red: the rotors left cannot give the plan and its reserve."
    picture.label(530, 416, red, size=12, colour=GREY)
    return picture


def solid(axes, facets, seen, **how):
    """A body in a panel, as the hull of its seen vertices, and its edges."""
    corners = vertices(facets)
    axes.area(around([seen(*c) for c in corners]), **how)
    normals, offsets = facets
    on = [set(np.flatnonzero(np.abs(normals @ c - offsets) < 3e-3)) for c in corners]
    for a, b in itertools.combinations(range(len(corners)), 2):
        if len(on[a] & on[b]) > 1:
            axes.line([seen(*corners[a]), seen(*corners[b])], colour=how["stroke"], width=0.8)


def admissible(mavc):
    """The set of the healthy vehicle, and after board 1 fails: thrust, roll and yaw torque at no pitch torque."""
    picture = Picture(760, 420, "The admissible set of an octocopter, healthy and without two rotors")
    sets, weight = mavc.sets(ROOF), mavc.weight(ROOF)

    def seen(thrust, roll, yaw):
        return roll / 3.2 + 0.5 * yaw / 0.45, thrust / 52 + 0.22 * yaw / 0.45

    axes = Axes(picture, (40, 62, 520, 350), (-1.5, 1.5), (-0.12, 1.12))
    for mode, fill, stroke, opacity in (("healthy", BLUE, BLUE, 0.13), ("board1", ORANGE, ORANGE, 0.35)):
        solid(axes, section(sets[mode], {PITCH: 0.0}), seen, fill=fill, stroke=stroke, opacity=opacity)
    hover = axes.at(*seen(weight, 0, 0))
    picture.dot(*hover, radius=5)
    picture.label(hover[0] + 10, hover[1] + 4, "hover", weight="bold")
    ends = [((52, 0, 0), "thrust", "middle"), ((0, 3.2, 0), "roll", "start"), ((0, 0, 0.45), "yaw", "start")]
    for end, text, anchor in ends:
        axes.line([seen(0, 0, 0), seen(*(1.12 * np.array(end)))], colour=INK, width=1)
        at = axes.at(*seen(*(1.17 * np.array(end))))
        picture.label(at[0], at[1] + 4, text, size=12, anchor=anchor)
    picture.label(575, 90, "all rotors", colour=BLUE, weight="bold", size=14)
    picture.label(575, 110, "up to 52 N of thrust", size=12, colour=GREY)
    picture.label(575, 150, "without rotors 2 and 3", colour=ORANGE, weight="bold", size=14)
    left = max(c[0] for c in vertices(section(sets["board1"], {ROLL: 0.0, PITCH: 0.0})) if abs(c[1]) < 1e-3)
    picture.label(575, 170, f"hovering, up to {left:.3g} N;", size=12, colour=GREY)
    picture.label(575, 187, f"the weight is {weight:.3g} N", size=12, colour=GREY)
    picture.label(40, 26, "Thrust and torques that the rotors can give (pitch torque 0)", size=16, weight="bold")
    return picture


def core(mavc):
    """A hexacopter that cannot hold its yaw without rotor 5: its set, and what remains with yaw given up."""
    picture = Picture(860, 420, "Without rotor 5: hover outside the set, and inside what remains with yaw given up")
    facets, weight = mavc.sets(SURVEY)["M5"], mavc.weight(SURVEY)
    level = section(facets, {THRUST: weight})
    picture.label(40, 26, "Heading held: hover is outside", size=16, weight="bold")
    axes = Axes(picture, (80, 50, 320, 300), (-0.5, 0.7), (-5, 8))
    axes.ticks([-0.4, -0.2, 0, 0.2, 0.4, 0.6], [-4, -2, 0, 2, 4, 6, 8], "yaw torque, N m", "roll torque, N m")
    corners = around([(c[1], c[0]) for c in vertices(section(facets, {THRUST: weight, PITCH: 0.0}))])
    axes.area(corners, fill=ORANGE, stroke=ORANGE, opacity=0.35)
    picture.dot(*axes.at(0, 0), radius=5)
    picture.label(*np.add(axes.at(0, 0), (-10, -8)), "hover", weight="bold", anchor="end")
    picture.label(470, 26, "Heading given up: hover is inside", size=16, weight="bold")
    axes = Axes(picture, (510, 50, 320, 300), (-8, 6), (-5.5, 7.625))
    axes.ticks([-8, -6, -4, -2, 0, 2, 4, 6], [-4, -2, 0, 2, 4, 6], "pitch torque, N m", "roll torque, N m")
    shadow = around([(c[1], c[0]) for c in vertices(level)])
    axes.area(shadow, fill=ORANGE, stroke=ORANGE, opacity=0.25)
    edges = zip(shadow, shadow[1:] + shadow[:1])
    disc = min(abs(turn(a, b)) / np.hypot(*np.subtract(a, b)) for a, b in edges)
    axes.circle(0, 0, disc, fill=GREEN, stroke=GREEN, opacity=0.3)
    picture.dot(*axes.at(0, 0), radius=5)
    picture.label(*np.add(axes.at(0, 0), (10, -8)), "hover", weight="bold")
    down = axes.at(0, -disc)
    picture.label(down[0], down[1] - 14, f"{disc:.3g} N m", size=12, anchor="middle")
    picture.label(down[0], down[1] - 29, "in every direction:", size=12, anchor="middle")
    return picture


def guard(mavc):
    """The facet of board 1's set that RIP violates most: how far both plans stay from it."""
    picture = Picture(760, 360, "A facet that the fault-ignorant plan violates, and the risk-sensitive plan touches")
    plans = {p: mavc.table("plan", ROOF, "--set", f"plan.planner={p}", "--rate", "50Hz") for p in ("rip", "rsp")}
    facets = mavc.sets(ROOF)["board1"]
    shares = {p: 100 * spare(mavc, ROOF, facets, wrenches(plan)) for p, plan in plans.items()}
    worst = np.argmin(shares["rip"].min(axis=0))
    low = shares["rip"].min()
    axes = Axes(picture, (80, 50, 640, 250), (0, 20), (-10, 22))
    axes.ticks([0, 5, 10, 15, 20], [-10, -5, 0, 5, 10, 15, 20], "time, s", "spare, % of the healthy width")
    picture.label(40, 26, "One constraint of the set without board 1", size=16, weight="bold")
    axes.area([(0, -10), (20, -10), (20, 0), (0, 0)], fill=RED, opacity=0.08)
    axes.line([(0, 0), (20, 0)], colour=INK, width=1)
    for planner, colour in (("rsp", GREEN), ("rip", RED)):
        axes.line(list(zip(plans[planner]["t"], shares[planner][:, worst])), colour=colour, width=2)
    picture.label(*axes.at(2.6, -7.4), f"RIP violates it, by up to {-low:.2g} %", colour=RED, weight="bold")
    picture.label(*axes.at(6.2, 18.4), "RSP touches it, and stays inside", colour=GREEN, weight="bold")
    return picture


def main(program, *options):
    mavc = Mavc(program)
    stale = False
    for draw in (roof, admissible, core, guard):
        file, new = HERE / f"{draw.__name__}.svg", draw(mavc).text()
        difference = differ(file.read_text() if file.exists() else "", new)
        if "--check" not in options:
            if difference:
                file.write_text(new)
            print(file.name, "drawn" if difference else "as it was")
        elif difference:
            stale = True
            print(f"{file.name} is not what mavc prints now:\n{difference}")
    if stale:
        sys.exit("draw the pictures anew: python3 docs/images/draw.py target/release/mavc")


if __name__ == "__main__":
    main(*sys.argv[1:])
