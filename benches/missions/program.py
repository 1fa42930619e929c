"""The shortest mission as a nonlinear program for IPOPT, by CasADi.

Variables are the states at the nodes of each leg (position, velocity, acceleration, jerk, yaw and its rate), the snap and the yaw
acceleration there, which are linear in between, and the duration of every piece. Legs share states at their waypoints. The wrench at each
instant is a variable of its own, equal to that of the exact model; then facets are linear. A keep_out is one separating plane for each
piece near it.
"""

import math

import casadi as ca
import numpy as np
import sets
import shapes
from dense import Motion, convex_bodies, facets_of

SHARES = [0.0, 1 / 3, 2 / 3]  # instants of a piece at which everything but the ends of legs is required
SCALE_A, SCALE_J, SCALE_S = 5.0, 20.0, 200.0
SMOOTH = 1e-9  # weight of the squared snap, which makes the minimum unique


def cross(a, b):
    return ca.cross(a, b)


def rotation_model(record):
    """A function of (v, a, j, s, yaw, rate, acceleration, wind): thrust over mass and torques over inertia scale."""
    vehicle = record["vehicle"]
    k = np.array(vehicle["drag"]) * record["air"]["density"] / sets.SEA_LEVEL / vehicle["mass"]
    v, a, j, s, wind = (ca.SX.sym(n, 3) for n in ("v", "a", "j", "s", "w"))
    psi = ca.SX.sym("psi", 3)
    c = ca.SX.sym("c", 9)
    c0, c1, c2 = c[:3], c[3:6], c[6:]
    b3 = c0 / ca.norm_2(c0)
    left = ca.vertcat(-ca.sin(psi[0]), ca.cos(psi[0]), 0)
    b1 = cross(left, b3)
    b1 = b1 / ca.norm_2(b1)
    b2 = cross(b3, b1)
    r = ca.horzcat(b1, b2, b3)
    # Derivatives in time by the chain rule of the program itself.
    dot = ca.reshape(ca.jtimes(ca.vec(r), ca.vertcat(c0, psi[0]), ca.vertcat(c1, psi[1])), 3, 3)
    spin = r.T @ dot
    omega = ca.vertcat(spin[2, 1], spin[0, 2], spin[1, 0])
    alpha = ca.jtimes(omega, ca.vertcat(c0, c1, psi[0], psi[1]), ca.vertcat(c1, c2, psi[1], psi[2]))
    inertia = ca.DM(vehicle["inertia"])
    torque = inertia * alpha + cross(omega, inertia * omega)
    extra = (k[2] - k[0]) * ca.dot(b3, v - wind)
    of_c = ca.Function("of_c", [c, psi, v, wind], [ca.vertcat(ca.norm_2(c0) + extra, torque)])
    in_air = ca.vertcat(a + ca.DM([0, 0, sets.GRAVITY]) + k[0] * (v - wind), j + k[0] * a, s + k[0] * j)
    return ca.Function("wrench", [v, a, j, s, psi, wind], [of_c(in_air, psi, v, wind)]), k[0]


def inside_piece():
    """The state at a share of a piece, from the state at its beginning, the snap and yaw acceleration at both ends, and its duration."""
    share = ca.SX.sym("share")
    x, s0, s1, y, h = ca.SX.sym("x", 12), ca.SX.sym("s0", 3), ca.SX.sym("s1", 3), ca.SX.sym("y", 4), ca.SX.sym("h")
    t = share * h
    slope = share * (s1 - s0)  # times t
    p, v, a, j = x[:3], x[3:6], x[6:9], x[9:]
    place = ca.vertcat(
        p + t * v + t**2 / 2 * a + t**3 / 6 * j + t**4 * (s0 / 24 + slope / 120),
        v + t * a + t**2 / 2 * j + t**3 * (s0 / 6 + slope / 24),
        a + t * j + t**2 * (s0 / 2 + slope / 6),
        j + t * (s0 + slope / 2),
        s0 + slope,
    )
    grow = share * (y[3] - y[2])
    yaw = ca.vertcat(y[0] + t * y[1] + t**2 * (y[2] / 2 + grow / 6), y[1] + t * (y[2] + grow / 2), y[2] + grow)
    return ca.Function("inside", [x, s0, s1, y, h, share], [place, yaw])


class Program:
    """`guess` is a list of one dictionary for each leg: x (n+1, 4, 3), s (n+1, 3), y (n+1, 3) and h (n,)."""

    def __init__(self, record, planner, guess, facets=60, slowest=4.0, quickest=0.02):
        self.record, self.planner, self.guess = record, planner, guess
        self.variables, self.start, self.low, self.high = [], [], [], []
        self.rows, self.row_low, self.row_high = [], [], []
        self.wrench, self.k = rotation_model(record)
        self.facets = facets_of(record, planner)
        self.inside = inside_piece()
        self.extra = set()  # (leg, piece, share): instants beside those of SHARES
        vehicle = record["vehicle"]
        hover = vehicle["mass"] * sets.GRAVITY
        slack = (self.facets[1] - self.facets[0][:, 0] * hover) / self.facets[2]
        self.chosen = set(np.argsort(slack)[:facets].tolist())
        self.pairs = {}
        self.slowest, self.quickest = slowest, quickest

    def variable(self, shape, start, scale=1.0, low=-np.inf, high=np.inf):
        size = shape[0] * shape[1]
        symbol = ca.MX.sym(f"u{len(self.variables)}", *shape)
        self.variables.append(ca.vec(symbol))
        flat = lambda a: (np.broadcast_to(np.asarray(a, dtype=float), shape) / scale).ravel(order="F")
        self.start.append(flat(start))
        self.low.append(flat(low))
        self.high.append(flat(high))
        assert len(self.start[-1]) == size
        return symbol * ca.DM(np.broadcast_to(np.asarray(scale, dtype=float), shape))

    def require(self, row, low=-np.inf, high=0.0):
        row = ca.vec(row)
        self.rows.append(row)
        self.row_low.append(np.full(row.shape[0], low))
        self.row_high.append(np.full(row.shape[0], high))

    def _leg(self, number):
        guess = self.guess[number]
        n = len(guess["h"])
        scale = np.repeat([1.0, 1.0, SCALE_A, SCALE_J], 3)[:, None] * np.ones((1, n + 1))
        x = self.variable((12, n + 1), guess["x"].reshape(n + 1, 12).T, scale)
        s = self.variable((3, n + 1), guess["s"].T, SCALE_S)
        y = self.variable((3, n + 1), guess["y"].T, np.array([[1.0], [1.0], [5.0]]) * np.ones((1, n + 1)))
        h0 = guess["h"][None, :]
        h = self.variable((1, n), h0, h0, self.quickest * h0, self.slowest * h0)
        if n > 1:
            self.require(h[0, 1:] - 2 * h[0, :-1])
            self.require(h[0, :-1] - 2 * h[0, 1:])
        return {"x": x, "s": s, "y": y, "h": h, "n": n}

    def _limits(self, own, place, yaw, wind_free):
        """Rows of limits at instants (columns): place is 15 rows, yaw three."""
        v, a, j = place[3:6, :], place[6:9, :], place[9:12, :]
        squares = lambda q: ca.sum1(q * q)
        for name, (low, high) in own.items():
            if name in ("x", "y", "altitude", "z"):
                row = place[{"x": 0, "y": 1}.get(name, 2), :]
                self.require(row, -np.inf if low is None else low, np.inf if high is None else high)
            elif name == "tilt":
                tangent = math.tan(math.radians(high))
                for wind in wind_free:
                    c = a + ca.repmat(ca.DM([0, 0, sets.GRAVITY]), 1, a.shape[1]) + self.k * (v - ca.repmat(ca.DM(wind), 1, a.shape[1]))
                    self.require((squares(c[:2, :]) - tangent**2 * c[2, :] ** 2) / 100)
            elif name in ("climb", "descent"):
                self.require((1 if name == "climb" else -1) * v[2, :] - high)
            elif name in ("yaw_rate", "yaw_acceleration"):
                self.require(yaw[1 if name == "yaw_rate" else 2, :], -math.radians(high), math.radians(high))
            else:
                q = {"speed": v, "speed_horizontal": v[:2, :], "acceleration": a, "acceleration_horizontal": a[:2, :], "jerk": j}[name]
                self.require(squares(q) / high**2 - 1)

    def _volumes(self, p):
        """Rows of keep_ins and of balls at instants."""
        size = self.record["vehicle"]["size"]
        for volume in self.record["volumes"]:
            m, shape = size + volume["clearance"], volume["shape"]
            if volume["side"] == "keep_out":
                if shape == "sphere":
                    away = p - ca.repmat(ca.DM(volume["centre"]), 1, p.shape[1])
                    self.require(1 - ca.sum1(away * away) / (volume["radius"] + m) ** 2)
                continue
            if shape in ("cylinder", "sphere"):
                axes = 2 if shape == "cylinder" else 3
                away = p[:axes, :] - ca.repmat(ca.DM(volume["centre"][:axes]), 1, p.shape[1])
                self.require(ca.sum1(away * away) / (volume["radius"] - m) ** 2 - 1)
                if shape == "cylinder":
                    self.require(p[2, :], volume["centre"][2] + m, volume["centre"][2] + volume["height"] - m)
            elif shape == "half_space":
                n = np.array(volume["normal"]) / np.linalg.norm(volume["normal"])
                self.require(ca.DM(n[None, :]) @ p - float(n @ volume["point"]) + m)
            else:
                corners = volume["corners"] if shape == "polygon" else shapes.corners_of_box(volume)
                area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, corners[1:] + corners[:1]))
                for a, b in zip(corners, corners[1:] + corners[:1]):
                    out = np.array([b[1] - a[1], a[0] - b[0]]) * math.copysign(1, area)
                    out /= np.linalg.norm(out)
                    self.require(ca.DM(out[None, :]) @ p[:2, :] - float(out @ a[:2]) + m)
                low, high = (volume["bottom"], volume["top"]) if shape == "polygon" else (volume["from"][2], volume["to"][2])
                self.require(p[2, :], low + m, high - m)

    def _instants(self, number, n):
        """The pieces and shares of the instants of a leg, without its end."""
        own = [(i, share) for share in SHARES for i in range(n)] + sorted((i, share) for leg, i, share in self.extra if leg == number)
        return [i for i, _ in own], [share for _, share in own]

    def _plane(self, body, first, points):
        """One plane between a body and the instants of a piece."""
        m = self.record["vehicle"]["size"] + body["clearance"]
        n = self.variable((3, 1), first[:, None])
        if body["shape"] == "cylinder":
            bottom, top = body["centre"][2], body["centre"][2] + body["height"]
            outline = [n[0] * body["centre"][0] + n[1] * body["centre"][1] + body["radius"] * ca.sqrt(n[0] ** 2 + n[1] ** 2 + 1e-10)]
        else:
            box = body["shape"] == "box"
            corners = shapes.corners_of_box(body) if box else body["corners"]
            bottom, top = (body["from"][2], body["to"][2]) if box else (body["bottom"], body["top"])
            outline = [n[0] * x + n[1] * y for x, y in corners]
        value = lambda q: float(ca.Function("q", [ca.vertcat(*self.variables[-1:])], [q])(self.start[-1]))
        offset = self.variable((1, 1), max(value(o) for o in outline) + max(value(n[2] * z) for z in (bottom, top)))
        for z in (bottom, top):
            self.require(ca.vertcat(*outline) + n[2] * z - offset)
        self.require(ca.dot(n, n) - 1)
        self.require(offset + m - n.T @ points)

    def near(self, reach):
        """Pairs of pieces and bodies that come within `reach` of each other in the guess, with the direction between them."""
        size = self.record["vehicle"]["size"]
        for number, guess in enumerate(self.guess):
            for i in range(len(guess["h"])):
                p = guess["x"][i : i + 2, 0].mean(axis=0)
                length = np.linalg.norm(guess["x"][i + 1, 0] - guess["x"][i, 0])
                for b, body in enumerate(convex_bodies(self.record)):
                    if body["shape"] == "sphere" or shapes.room(body, p, size) > reach + length:
                        continue
                    d = lambda q: shapes.distance(body, q)
                    gradient = np.array([d(p + e) - d(p - e) for e in 1e-4 * np.eye(3)]) / 2e-4
                    self.pairs[number, i, b] = gradient / max(np.linalg.norm(gradient), 1e-6)

    def solve(self, iterations=400, seconds=600, verbose=False, warm=False):
        record, points = self.record, self.record["points"]
        bodies = convex_bodies(record)
        _, winds = sets.winds(record["air"])
        rows, offsets, widths, masses = (array[sorted(self.chosen)] for array in self.facets)
        facet_rows = ca.DM(np.column_stack([rows[:, 0] * masses, rows[:, 1:]]) / widths[:, None])
        facet_limits = ca.DM(offsets / widths)
        legs = [self._leg(number) for number in range(len(points) - 1)]
        total, smooth = sum(p["hold"] for p in points), 0
        torque_scale = np.maximum(np.abs(sets.columns(record["vehicle"])).max(axis=0)[1:], 1e-3)
        wrench_scale = np.concatenate([[sets.GRAVITY], torque_scale])
        for number, leg in enumerate(legs):
            x, s, y, h, n = (leg[key] for key in "xsyhn")
            before, point = points[number], points[number + 1]
            total += ca.sum2(h)
            smooth += ca.sum1(ca.sum2(s * s)) / n
            pieces = (x[:, :-1], s[:, :-1], s[:, 1:], ca.vertcat(y[:, :-1], y[2, 1:]), h)
            place, yaw = self.inside.map(n)(*pieces, ca.DM.ones(1, n))
            scales = ca.DM(np.repeat([1.0, 1.0, SCALE_A, SCALE_J], 3))
            self.require((place[:12, :] - x[:, 1:]) / ca.repmat(scales, 1, n), 0.0)
            self.require(yaw[:2, :] - y[:2, 1:], 0.0)
            at, instants = self._instants(number, n)
            place, yaw = self.inside.map(len(at))(*(part[:, at] for part in pieces), ca.DM(instants).T)
            place = ca.horzcat(place, ca.vertcat(x[:, n], s[:, n]))
            yaw = ca.horzcat(yaw, y[:, n])
            columns = place.shape[1]
            for wind in winds:
                start = self._wrench_guess(number, wind, columns)
                w = self.variable((4, columns), start, wrench_scale[:, None] * np.ones((1, columns)))
                repeated = ca.repmat(ca.DM(wind), 1, columns)
                found = self.wrench.map(columns)(place[3:6, :], place[6:9, :], place[9:12, :], place[12:, :], yaw, repeated)
                self.require((found - w) / ca.repmat(ca.DM(wrench_scale), 1, columns), 0.0)
                self.require(facet_rows @ w - ca.repmat(facet_limits, 1, columns))
            self.require(0.1 * sets.GRAVITY - place[8, :] - sets.GRAVITY)
            self._limits(record["limits"], place, yaw, winds)
            self._limits(point["limits"], place, yaw, winds)
            self._volumes(place[:3, :])
            if point["corridor"] is not None:
                a, b = np.array(before["at"]), np.array(point["at"])
                length = np.linalg.norm(b - a)
                d = (b - a) / length
                away = place[:3, :] - ca.repmat(ca.DM(a), 1, columns)
                way = ca.DM(d[None, :]) @ away
                across = away - ca.DM(d[:, None]) @ way
                self.require(ca.sum1(across * across) / point["corridor"] ** 2 - 1)
                self.require(way, -point["corridor"], length + point["corridor"])
            for (leg_of, i, b), first in self.pairs.items():
                if leg_of == number:
                    own = [column for column, piece in enumerate(at) if piece == i]
                    self._plane(bodies[b], first, ca.horzcat(place[:3, own], x[:3, i + 1]))
            if before["yaw"] == point["yaw"] and point["yaw"]["rule"] in ("path", "towards"):
                self._rule(point["yaw"], x, y, math.radians(point["yaw_within"]))
        self._waypoints(legs)
        u = ca.vertcat(*self.variables)
        problem = {"x": u, "f": total + SMOOTH * smooth, "g": ca.vertcat(*self.rows)}
        options = {
            "print_time": False, "ipopt.print_level": 5 if verbose else 0, "ipopt.sb": "yes", "ipopt.max_iter": iterations, "ipopt.tol": 1e-6,
            "ipopt.constr_viol_tol": 1e-6, "ipopt.acceptable_tol": 1e-4, "ipopt.acceptable_constr_viol_tol": 1e-5, "ipopt.acceptable_iter": 8,
            "ipopt.mu_strategy": "adaptive", "ipopt.max_cpu_time": float(seconds), "ipopt.acceptable_obj_change_tol": 1e-5,
        }  # fmt: skip
        if warm:
            options |= {"ipopt.mu_strategy": "monotone", "ipopt.mu_init": 1e-5, "ipopt.bound_push": 1e-5, "ipopt.bound_frac": 1e-5}
            options |= {"ipopt.slack_bound_push": 1e-5, "ipopt.slack_bound_frac": 1e-5}
        solver = ca.nlpsol("shortest", "ipopt", problem, options)
        join = np.concatenate
        result = solver(x0=join(self.start), lbx=join(self.low), ubx=join(self.high), lbg=join(self.row_low), ubg=join(self.row_high))
        read = ca.Function("read", [u], [leg[key] for leg in legs for key in "xsyh"])
        values = [np.array(v) for v in read(result["x"])]
        found = []
        for i in range(len(legs)):
            x, s, y, h = values[4 * i : 4 * i + 4]
            found.append({"x": x.T.reshape(-1, 4, 3), "s": s.T, "y": y.T, "h": h[0]})
        return found, solver.stats()

    def _wrench_guess(self, number, wind, columns):
        guess = self.guess[number]
        n = len(guess["h"])
        pieces = (guess["x"][:-1].reshape(n, 12).T, guess["s"][:-1].T, guess["s"][1:].T, np.vstack([guess["y"][:-1].T, guess["y"][1:, 2]]), guess["h"][None, :])
        at, instants = self._instants(number, n)
        place, yaw = self.inside.map(len(at))(*(part[:, at] for part in pieces), ca.DM(instants).T)
        place = np.hstack([np.array(place), np.concatenate([guess["x"][n].ravel(), guess["s"][n]])[:, None]])
        yaw = np.hstack([np.array(yaw), guess["y"][n][:, None]])
        repeated = np.repeat(np.array(wind)[:, None], columns, axis=1)
        return np.array(self.wrench.map(columns)(place[3:6], place[6:9], place[9:12], place[12:], yaw, repeated))

    def _rule(self, rule, x, y, within):
        """Yaw along the path or towards a point at the nodes of a leg; at rest along the path nothing is required."""
        c, s = ca.cos(y[0, :]), ca.sin(y[0, :])
        ahead = x[3:5, :] if rule["rule"] == "path" else ca.repmat(ca.DM(rule["point"][:2]), 1, x.shape[1]) - x[:2, :]
        across, along = c * ahead[1, :] - s * ahead[0, :], c * ahead[0, :] + s * ahead[1, :]
        spare = 0.02 * within if rule["rule"] == "path" else 0.0
        for sign in (1, -1):
            self.require(sign * across - math.tan(min(within, 1.2)) * along - spare)

    def _waypoints(self, legs):
        points, last = self.record["points"], len(self.record["points"]) - 1
        for number, point in enumerate(points):
            ends = []
            if number > 0:
                ends.append({key: legs[number - 1][key][:, -1] for key in "xsy"})
            if number < last:
                ends.append({key: legs[number][key][:, 0] for key in "xsy"})
            own = ends[0]
            away = own["x"][:3] - ca.DM(point["at"])
            self.require(ca.dot(away, away) / point["within"] ** 2 - 1)
            rest = number in (0, last) or point["stop"] or point["hold"] > 0
            if point["yaw"]["rule"] == "angle":
                near = self.guess[number]["y"][0, 0] if number < last else self.guess[-1]["y"][-1, 0]
                target = math.radians(point["yaw"]["deg"])
                target += 2 * math.pi * round((near - target) / (2 * math.pi))
                within = math.radians(point["yaw_within"])
                self.require(own["y"][0], target - within, target + within)
            elif point["yaw"]["rule"] == "towards":
                self._rule(point["yaw"], own["x"], own["y"], math.radians(point["yaw_within"]))
            elif point["yaw"]["rule"] == "path" and not rest:
                self._rule(point["yaw"], own["x"], own["y"], math.radians(point["yaw_within"]))
            for end in ends if point["hold"] else ends[:1]:
                if rest:
                    self.require(ca.vertcat(end["x"][3:9], end["x"][9:11] / SCALE_J, end["y"][1:3]), 0.0)
                if point["hold"]:
                    self.require(end["x"][11] / SCALE_J, 0.0)
            if len(ends) == 2:
                one, two = ends
                scales = ca.DM(np.repeat([1.0, 1.0, SCALE_A, SCALE_J], 3))
                joined = 3 if point["hold"] else 12
                self.require(((one["x"] - two["x"]) / scales)[:joined], 0.0)
                self.require((one["y"] - two["y"])[: 1 if point["hold"] else 3], 0.0)
                if not rest:
                    self.require((one["s"] - two["s"]) / SCALE_S, 0.0)


def motion_of(record, legs):
    """The legs and holds as one motion."""
    x, s, y, h, leg = [], [], [], [], []
    for number, own in enumerate(legs):
        n = len(own["h"])
        x += list(own["x"][:n])
        s += [own["s"][i : i + 2] for i in range(n)]
        y += [[*own["y"][i], own["y"][i + 1][2]] for i in range(n)]
        h += list(own["h"])
        leg += [number] * n
        hold = record["points"][number + 1]["hold"]
        if hold:
            rest = np.zeros((4, 3))
            rest[0] = own["x"][n][0]
            x.append(rest)
            s.append(np.zeros((2, 3)))
            y.append([own["y"][n][0], 0, 0, 0])
            h.append(hold)
            leg.append(-1)
    return Motion(x, s, y, h, leg)
