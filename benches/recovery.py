#!/usr/bin/env python3
"""Ways out after random faults, evaluated densely: `recovery.py MAVC SPEC... [--count N] [--seed N] [--kept FOLDER] [--between]`.

For each spec `mavc plan --recovery --branches` is run once. Then `count` triples of an instant, a mode and a delay are drawn evenly. Each
triple is one of these:

    proved    inside a family of the certificate (with --between): its own blend of branches is evaluated
    claimed   the way out at the examined instant nearest to it, after the longest delay, is evaluated; nothing is claimed in between
    open      no way out was found, or none was sought

A way out is lost if its evaluation finds a wrench outside the fault's set, a keep_out or a limit on speeds or the altitude that is not kept, a beginning that no motion of the delay explains, an end that is not at rest on the ground within the site
(away from areas to keep off) or not on the plan, or a plan that is outside the set after the return. Nothing of mavc's search is used:
sets are sums of segments (`missions/sets.py`), wrenches come from differences of rotation matrices (`missions/dense.py`); in the hover
model they are those of the linear model, because that is what is claimed. Places, limits and cylinders are read from the text of the spec
by patterns, which fit the shipped missions: in still air, with the nominal mass. Where yaw is given up, the spin is integrated along the
branch and the rest of the plan, with every end of the interval of `yaw_drag` (`spinning.py`).
What takes from the reserve, which ways out are to keep too, is counted by itself, with the largest share of the healthy set's width.

Measured with seed 1 and 20,000 triples each on tower_hexa, inspection_octo, parcel_quad, ridge_hexa and parcel_x8: of 77,652 that were
claimed none was lost, and 22,348 were open; ways out of 482 triples took up to 0.74 % from the reserve, between the instants at which
mavc looks.

Prints one line for each spec. Exit code 1 if anything that was claimed is lost. Needs numpy.
"""

import argparse
import collections
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent / "missions"))
import sets
import spinning

GRAVITY = sets.GRAVITY
STEP = 0.02  # between instants that are evaluated, s
OUTSIDE = 1e-3  # of the healthy set's width
PAST = 2e-3  # limits, as a share of them or in m
TOUCHDOWN = 0.05  # m
AXES = ("x", "y", "z", "yaw")
NAMES = (("x", "vx", "ax", "jx", "sx"), ("y", "vy", "ay", "jy", "sy"), ("z", "vz", "az", "jz", "sz"), ("yaw", "yaw_rate", "yaw_acc"))


class Motion:
    """Node times and derivatives at the nodes: `nodes[axis]` (n, order + 1). The last derivative is linear between nodes."""

    def __init__(self, times, nodes):
        self.times, self.nodes = np.asarray(times, float), [np.asarray(n, float) for n in nodes]

    @property
    def duration(self):
        return float(self.times[-1])

    def at(self, t):
        """Derivatives 0 to 4 of x, y, z and 0 to 2 of yaw at times (m,): list of (m, 5) and (m, 3). At rest after the end."""
        t = np.asarray(t, float)
        k = np.clip(np.searchsorted(self.times, t, "right") - 1, 0, len(self.times) - 2)
        late = t > self.times[-1] + 1e-9
        dt, h = np.minimum(t, self.times[-1]) - self.times[k], self.times[k + 1] - self.times[k]
        found = []
        for axis, nodes in enumerate(self.nodes):
            r = nodes.shape[1] - 1
            slope = (nodes[k + 1, r] - nodes[k, r]) / h
            own = [nodes[k, i] for i in range(r + 1)] + [slope]
            width = 3 if axis == 3 else 5
            values = np.zeros((len(t), width))
            for i in range(min(width, r + 2)):
                values[:, i] = sum(own[j] * dt ** (j - i) / math.factorial(j - i) for j in range(i, r + 2))
            values[late, 1:] = 0.0
            found.append(values)
        return found

    def instants(self):
        count = max(2, math.ceil(self.duration / STEP) + 1)
        return np.unique(np.concatenate([np.linspace(0.0, self.duration, count), self.times]))


def of_record(record):
    return Motion(record["times_s"], [record[axis] for axis in AXES])


def of_table(path, exact):
    """A table of `mavc plan`, whose rows are nodes; in the hover model z has derivatives up to the second."""
    with open(path) as file:
        rows = list(csv.DictReader(file))
    nodes = []
    for axis, names in enumerate(NAMES):
        kept = names if exact or axis != 2 else names[:3]
        nodes.append([[float(row[name]) for name in kept] for row in rows])
    return Motion([float(row["t"]) for row in rows], nodes)


def blend(motions, weights):
    """The weighted sum of motions with the same node times."""
    return Motion(motions[0].times, [sum(w * m.nodes[axis] for w, m in zip(weights, motions)) for axis in range(4)])


class Vehicle:
    """What the record of `mavc emit model --format json` says of a vehicle and its modes."""

    def __init__(self, model, reserve):
        vehicle = model["vehicle"]
        self.mass, self.inertia, self.gravity = vehicle["mass_kg"], np.array(vehicle["inertia_kg_m2"]), GRAVITY
        self.drag = np.array(vehicle["drag_n_s_per_m"])
        full = [r["thrust_coefficient_n_s2_per_rad2"] * r["max_speed_rad_per_s"] ** 2 for r in vehicle["rotors"]]
        ratio = [r["drag_coefficient_n_m_s2_per_rad2"] / r["thrust_coefficient_n_s2_per_rad2"] for r in vehicle["rotors"]]
        rotors = [{"max_thrust": f, "at": r["position_m"], "spin": r["spin"], "torque_per_thrust": q} for f, q, r in zip(full, ratio, vehicle["rotors"])]
        own = {"rotors": rotors}
        whole = np.array(sets.columns(own))
        self.full = float(sum(full))
        if any(r["min_speed_rad_per_s"] for r in vehicle["rotors"]):
            sys.exit("rotors that never stand still are not evaluated")
        self.rows = {}
        hover = self.mass * GRAVITY
        for mode in model["modes"]:
            normals, limits, widths, whole_offsets = [], [], [], []
            for n, offset in sets.set_of_mode(own, mode):
                n = np.array(n)
                normals.append(n)
                limits.append(n[0] * hover + (1 - reserve) * (offset - n[0] * hover))
                widths.append(np.abs(whole @ n).sum())
                whole_offsets.append(offset)
            self.rows[mode["name"]] = tuple(np.array(a) for a in (normals, limits, widths, whole_offsets))

    def wrenches(self, motion, t, exact):
        """Thrust and torques (m, 4) at times."""
        if not exact:
            x, y, z, yaw = motion.at(t)
            thrust = self.mass * (z[:, 2] + GRAVITY)
            torques = self.inertia * np.column_stack([-y[:, 4] / GRAVITY, x[:, 4] / GRAVITY, yaw[:, 2]])
            return np.column_stack([thrust, torques])
        thrust, rate, acceleration = self._rates(motion, t)
        torques = self.inertia * acceleration + np.cross(rate, self.inertia * rate)
        return np.column_stack([thrust, torques])

    def turning(self, motion, t):
        """Thrust, p, q, r and the derivatives of p and q (m, 6) in the exact model."""
        thrust, rate, acceleration = self._rates(motion, t)
        return np.column_stack([thrust, rate, acceleration[:, :2]])

    def _rates(self, motion, t):
        """Thrust (m,), angular rates and accelerations (m, 3) in the body."""
        step = 1e-4
        inside = np.clip(t, step, max(motion.duration - step, step))
        now, early, late = (self._attitude(motion, inside + d) for d in (0.0, -step, step))
        odd = lambda r: np.stack([r[:, 2, 1] - r[:, 1, 2], r[:, 0, 2] - r[:, 2, 0], r[:, 1, 0] - r[:, 0, 1]], axis=1) / 2
        back = now[1].transpose(0, 2, 1)
        rate = odd(back @ (late[1] - early[1])) / (2 * step)
        acceleration = odd(back @ (late[1] - 2 * now[1] + early[1])) / step**2
        return self.mass * now[0], rate, acceleration

    def _attitude(self, motion, t):
        import dense

        x, y, z, yaw = motion.at(t)
        place = np.stack([np.column_stack([x[:, i], y[:, i], z[:, i]]) for i in range(5)])
        return dense.attitude(place, yaw.T, self.drag / self.mass, np.zeros(3))

    def outside(self, mode, motion, t, exact):
        """By how much wrenches are outside a mode's set at most, and outside the set less the reserve, in shares of the healthy width."""
        normals, limits, widths, whole = self.rows[mode]
        along = self.wrenches(motion, t, exact) @ normals.T
        return [float(((along - bound) / widths).max()) for bound in (whole, limits)]


class Claims:
    """What one run of mavc says."""

    def __init__(self, mavc, spec, folder, between):
        self.spec = spec
        folder.mkdir(parents=True, exist_ok=True)
        files = {name: folder / name for name in ("plan.csv", "report.json", "branches", "certificate.json")}
        if not (folder / "done").exists():
            command = [mavc, "plan", spec, "--recovery", "-q", "-o", files["plan.csv"], "--report", files["report.json"], "--branches", files["branches"]]
            command += ["--certificate", files["certificate.json"]] if between else []
            ran = subprocess.run(command, capture_output=True, text=True)
            if ran.returncode not in (0, 4):
                sys.exit(f"{spec}: mavc plan ended with {ran.returncode}\n{ran.stderr}")
            (folder / "done").touch()
        model = subprocess.run([mavc, "emit", "model", spec, "--format", "json", "-q"], capture_output=True, text=True, check=True)
        self.model = json.loads(model.stdout)
        self.report = json.loads(files["report.json"].read_text())
        self.exact = self.report["model"] == "exact"
        self.recovery = self.report["recovery"]
        self.plan = of_table(files["plan.csv"], self.exact)
        with open(files["branches"] / "index.csv") as file:
            self.index = {row["file"]: row for row in csv.DictReader(file)}
        self.folder = files["branches"]
        self.families = collections.defaultdict(list)
        self.motions = []
        if between and files["certificate.json"].exists():
            claim = json.loads(files["certificate.json"].read_text())["claim"].get("plan", {}).get("recovery")
            if claim:
                self.motions = [of_record(record) for record in claim["branches"]]
                for family in claim["families"]:
                    self.families[family["mode"]].append(family)

    def family(self, mode, at, delay):
        for family in self.families[mode]:
            if family["from_s"] <= at <= family["to_s"] and family["delays_s"][0] <= delay <= family["delays_s"][1]:
                return family
        return None

    def member(self, family, at, delay):
        a, b = family["from_s"], family["to_s"]
        c, d = family["delays_s"]
        s, r = (at - a) / (b - a), (delay - c) / (d - c) if d > c else 0.0
        weights = [(1 - r) * (1 - s), (1 - r) * s, r * (1 - s), r * s]
        way = family["way"]
        name = way if isinstance(way, str) else "land at site"
        site = None if isinstance(way, str) else way["land_at"]
        return blend([self.motions[i] for i in family["corners"]], weights), name.replace("_", " "), site

    def nearest(self, mode, at):
        """The row of the branch of the examined instant nearest to `at`, or None in a gap."""
        record = next(m for m in self.recovery["modes"] if m["name"] == mode)
        if "not_attempted" in record:
            return None
        piece = next((p for p in record["pieces"] if p["from_s"] <= at <= p["to_s"]), record["pieces"][-1])
        rows = [self.index[name] for name in piece["branches"]]
        return min(rows, key=lambda row: abs(float(row["fault_s"]) - at), default=None)


class Judge:
    """Decides by evaluation whether a way out is lost."""

    def __init__(self, claims, places):
        self.claims, self.places = claims, places
        self.vehicle = Vehicle(claims.model, claims.report["reserve"])
        self.within = claims.recovery["within_s"]
        self.inside_from, self.spun = {}, {}
        # The deepest that any way out goes into the reserve, and whether the last one does.
        self.into_reserve, self.takes_reserve = 0.0, False

    def why_lost(self, mode, motion, outcome, site, at, delay):
        """The first thing that fails; None if the way out is one."""
        claims, vehicle = self.claims, self.vehicle
        t = motion.instants()
        if motion.duration > self.within + 1e-6:
            return "it takes too long"
        x, y, z, yaw = motion.at(t)
        # Neither thrust exceeds that of all rotors, so the difference of accelerations is at most twice that.
        there = claims.plan.at([at + delay])
        apart = math.dist([x[0, 0], y[0, 0], z[0, 0]], [a[0, 0] for a in there[:3]])
        if apart > 1.01 * vehicle.full / vehicle.mass * delay**2 + 1e-3:
            return f"it begins {apart:.3f} m from the plan"
        spins = outcome == "continue spinning"
        over, into_reserve = self.while_spinning(mode, at, delay) if spins else vehicle.outside(mode, motion, t, claims.exact)
        self.into_reserve = max(self.into_reserve, into_reserve)
        self.takes_reserve = into_reserve > OUTSIDE
        if over > OUTSIDE:
            return f"it is outside the set by {over:.2e}"
        broken = self.places.broken(x, y, z, lands=not outcome.startswith("continue"))
        if broken:
            return broken
        joined = at + delay + motion.duration
        if outcome.startswith("continue"):
            ends = [abs(a[-1, k] - b[0, k]) for a, b in zip(motion.at([motion.duration]), claims.plan.at([joined])) for k in range(2)]
            if max(ends) > PAST:
                return f"it ends {max(ends):.3f} beside the plan"
            if not spins and joined < claims.plan.duration and joined < self.inside(mode) - 0.02:
                return "the plan is outside the set after the return"
        else:
            moving = max(abs(a[-1, 1]) for a in (x, y, z))
            if moving > PAST or z[-1, 0] > self.places.ground(site) + TOUCHDOWN + PAST:
                return f"it does not end at rest on the ground: {moving:.3f} m/s, {z[-1, 0]:.3f} m"
            if site and math.dist([x[-1, 0], y[-1, 0]], self.places.sites[site]["at"][:2]) > self.places.sites[site]["radius"] + PAST:
                return "it ends outside the site"
            if not site and self.places.off_limits([x[-1, 0], y[-1, 0]]):
                return "it ends in an area to keep off"
        return None

    def while_spinning(self, mode, at, delay):
        """By how much a way out without yaw leaves the set of its mode, and the set less the reserve, to the end of the plan."""
        if mode not in self.spun:
            claims = self.claims
            rows = [row for row in claims.index.values() if row["mode"] == mode and row["outcome"] == "continue spinning"]
            of_row = lambda row: (float(row["fault_s"]), float(row["delay_s"]))
            branches = [(of_table(claims.folder / row["file"], claims.exact), sum(of_row(row))) for row in rows]
            found = spinning.follow(self.vehicle, mode, branches, claims.plan, claims.exact, self.places.yaw_drags)
            self.spun[mode] = {of_row(row): each for row, each in zip(rows, zip(*found))}
        return self.spun[mode][at, delay]

    def inside(self, mode):
        """From when on the plan is inside a mode's set, s."""
        if mode not in self.inside_from:
            t = np.unique(np.concatenate([np.arange(0.0, self.claims.plan.duration, STEP), self.claims.plan.times]))
            normals, _, widths, limits = self.vehicle.rows[mode]
            over = ((self.vehicle.wrenches(self.claims.plan, t, self.claims.exact) @ normals.T - limits) / widths).max(axis=1)
            bad = t[over > OUTSIDE]
            self.inside_from[mode] = float(bad[-1]) if len(bad) else 0.0
        return self.inside_from[mode]


class Places:
    """Landing sites and areas to keep off, read from the text of the spec with numbers in m."""

    def __init__(self, text, model):
        import re

        numbers = r"-?\d+(?:\.\d+)?"
        strip = re.sub(r"//[^\n]*", "", text)
        self.sites, self.areas = {}, []
        for name, body in re.findall(r"landing_site\s+(\w+)\s*\{([^}]*)\}", strip):
            at = [float(v) for v in re.findall(numbers, re.search(r"at\s*=\s*\[([^\]]*)\]", body)[1])]
            self.sites[name] = {"at": at, "radius": float(re.search(rf"radius\s*=\s*({numbers})\s*m", body)[1])}
        for name, body in re.findall(r"keep_off\s+(\w+)\s*\{([^}]*)\}", strip):
            clearance = re.search(rf"clearance\s*=\s*({numbers})\s*m", body)
            shape = re.search(r"shape\s*=\s*(\w+)", body)[1]
            points = [[float(v) for v in re.findall(numbers, p)] for p in re.findall(r"\[([^\[\]]*)\]", body)]
            if shape == "box":
                (a, b), (c, d) = points
                points = [[a, b], [c, b], [c, d], [a, d]]
            self.areas.append((points, float(clearance[1]) if clearance else 0.0))
        ground = re.search(rf"ground\s*=\s*({numbers})\s*m", strip)
        self.level = float(ground[1]) if ground else 0.0
        buffer = re.search(rf"buffer\s*=\s*({numbers})\s*m", strip)
        self.buffer = float(buffer[1]) if buffer else 0.0
        self.limits = {}
        for word in ("limits", "after_fault_limits"):
            body = re.search(rf"\b{word}\s*\{{([^}}]*)\}}", strip)
            text = body[1] if body else ""
            for name in ("speed", "speed_horizontal", "climb", "descent"):
                bound = re.search(rf"\b{name}\s*<=\s*({numbers})\s*m/s", text)
                if bound:
                    self.limits[name] = float(bound[1])
            ceiling = re.search(rf"\baltitude\s*(?:in\s*{numbers}\s*m\s*\.\.|<=)\s*({numbers})\s*m", text)
            floor = re.search(rf"\baltitude\s*(?:in|>=)\s*({numbers})\s*m", text)
            if ceiling:
                self.limits["top"] = float(ceiling[1]) + self.buffer
            if floor:
                self.limits["floor"] = float(floor[1]) - self.buffer
        drag = model["vehicle"].get("yaw_drag") or {"linear_n_m_s_per_rad": 0.0, "quadratic_n_m_s2_per_rad2": 0.0}
        spread = re.search(rf"\byaw_drag\s*=[^\n]*\+-\s*({numbers})\s*%", strip)
        ends = (-1, 1) if spread else (0,)
        factors = [1 + sign * float(spread[1]) / 100 if spread else 1.0 for sign in ends]
        self.yaw_drags = [(f * drag["linear_n_m_s_per_rad"], f * drag["quadratic_n_m_s2_per_rad2"]) for f in factors]
        propeller = re.search(rf"propeller_radius\s*=\s*({numbers})\s*cm", strip)
        arms = [math.dist(r["position_m"], [0.0, 0.0, 0.0]) for r in model["vehicle"]["rotors"]]
        self.size = max(arms) + (float(propeller[1]) / 100 if propeller else 0.0)
        self.cylinders = []
        for name, body in re.findall(r"keep_out\s+(\w+)\s*\{([^}]*)\}", strip):
            if not re.search(r"shape\s*=\s*cylinder", body):
                sys.exit(f"keep_out {name}: only cylinders are evaluated")
            of = lambda field: float(re.search(rf"{field}\s*=\s*({numbers})\s*m", body)[1])
            centre = [float(v) for v in re.findall(numbers, re.search(r"centre\s*=\s*\[([^\]]*)\]", body)[1])]
            self.cylinders.append((centre, of("radius"), of("height"), of("clearance") if "clearance" in body else 0.0))

    def ground(self, site):
        return self.sites[site]["at"][2] if site else self.level

    def broken(self, x, y, z, lands):
        """The first limit or volume that a motion does not keep; each yields as far as its beginning violates it."""
        quantities = {
            "speed": np.sqrt(x[:, 1] ** 2 + y[:, 1] ** 2 + z[:, 1] ** 2), "speed_horizontal": np.hypot(x[:, 1], y[:, 1]),
            "climb": z[:, 1], "descent": -z[:, 1], "top": z[:, 0],
        }  # fmt: skip
        for name, values in quantities.items():
            if name in self.limits and values.max() > max(self.limits[name], values[0]) + PAST * max(1.0, self.limits[name]):
                return f"{name} {values.max():.3f}"
        if not lands and "floor" in self.limits and z[:, 0].min() < min(self.limits["floor"], z[0, 0]) - PAST:
            return f"altitude {z[:, 0].min():.3f}"
        for (cx, cy, cz), radius, height, clearance in self.cylinders:
            across, over = np.hypot(x[:, 0] - cx, y[:, 0] - cy) - radius, z[:, 0] - cz - height
            away = np.where((across > 0) & (over > 0), np.hypot(across, over), np.maximum(across, over)) - self.size
            if away.min() < min(clearance, max(away[0], 0.0)) - PAST:
                return f"{away.min():.3f} m from a keep_out"
        return None

    def off_limits(self, p):
        """Whether a place is inside an area or nearer than its clearance to it."""
        for points, clearance in self.areas:
            inside, near = False, math.inf
            for (a, b), (c, d) in zip(points, points[1:] + points[:1]):
                if (b > p[1]) != (d > p[1]) and p[0] < a + (p[1] - b) * (c - a) / (d - b):
                    inside = not inside
                length = (c - a) ** 2 + (d - b) ** 2
                share = min(max(((p[0] - a) * (c - a) + (p[1] - b) * (d - b)) / length, 0.0), 1.0)
                near = min(near, math.dist(p, [a + share * (c - a), b + share * (d - b)]))
            if inside or near < clearance:
                return True
        return False


def judged(claims, places, count, seed):
    """How many of `count` triples are of each kind, and what is lost: (kind, mode, instant, delay, why)."""
    judge = Judge(claims, places)
    random = np.random.default_rng(seed)
    names = [mode["name"] for mode in claims.recovery["modes"]]
    delays = claims.recovery["detection_s"]
    counts, lost, known = collections.Counter(), [], {}
    for _ in range(count):
        mode = names[random.integers(len(names))]
        at, delay = random.uniform(0.0, claims.plan.duration), random.uniform(delays[0], delays[-1])
        family = claims.family(mode, at, delay)
        if family:
            motion, outcome, site = claims.member(family, at, delay)
            kind, why = "proved", judge.why_lost(mode, motion, outcome, site, at, delay)
        else:
            row = claims.nearest(mode, at)
            if row is None:
                counts["open"] += 1
                continue
            name = row["file"]
            if name not in known:
                motion = of_table(claims.folder / name, claims.exact)
                why = judge.why_lost(mode, motion, row["outcome"], row["site"] or None, float(row["fault_s"]), float(row["delay_s"]))
                known[name] = why, judge.takes_reserve
            (why, judge.takes_reserve), kind, at, delay = known[name], "claimed", float(row["fault_s"]), float(row["delay_s"])
        counts[kind] += 1
        counts["takes reserve"] += judge.takes_reserve
        if why:
            lost.append((kind, mode, at, delay, why))
    return counts, lost, len(known), judge.into_reserve


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mavc")
    parser.add_argument("specs", nargs="+")
    parser.add_argument("--count", type=int, default=20_000, help="triples for each spec")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kept", help="folder in which runs of mavc are kept for the next time")
    parser.add_argument("--between", action="store_true", help="with families between instants, which take mavc much longer")
    given = parser.parse_args()
    is_lost = False
    with tempfile.TemporaryDirectory() as temporary:
        for spec in given.specs:
            folder = pathlib.Path(given.kept or temporary, pathlib.Path(spec).stem)
            claims = Claims(given.mavc, spec, folder, given.between)
            places = Places(pathlib.Path(spec).read_text(), claims.model)
            counts, lost, branches, deepest = judged(claims, places, given.count, given.seed)
            kinds = ", ".join(f"{counts[kind]} {kind}" for kind in ("proved", "claimed", "open"))
            reserve = f"{counts['takes reserve']} take from the reserve, at most {100 * deepest:.2f} %"
            name = pathlib.Path(spec).stem
            print(f"{name}: {given.count} faults: {kinds}; {branches} branches evaluated; {len(lost)} lost; {reserve}", flush=True)
            for kind, mode, at, delay, why in sorted(set(lost))[:10]:
                print(f"  {kind} {mode} at {at:.3f} s, known after {1e3 * delay:.0f} ms: {why}", flush=True)
            is_lost |= bool(lost)
    sys.exit(is_lost)


if __name__ == "__main__":
    main()
