"""Admissible sets of thrust and torques, and how far rest lies inside them; the standard library alone.

The set of a vehicle is the sum of one segment for each rotor (a zonotope): its facets are the hyperplanes along every three
segments. A vehicle is the dictionary of the record of a mission; nothing of mavc is used.
"""

import itertools
import math

GRAVITY = 9.81  # m/s^2
SEA_LEVEL = 1.225  # kg/m^3


def columns(vehicle, density=SEA_LEVEL):
    """The wrench [T, tau_x, tau_y, tau_z] of each rotor at full speed, N and N m."""
    found = []
    for rotor in vehicle["rotors"]:
        full, (x, y, _) = rotor["max_thrust"] * density / SEA_LEVEL, rotor["at"]
        turn = -1.0 if rotor["spin"] == "P" else 1.0
        found.append((full, full * y, -full * x, turn * full * rotor["torque_per_thrust"]))
    return found


def _normal(a, b, c):
    """The vector orthogonal to three vectors of four numbers, by minors."""
    rows = (a, b, c)

    def minor(skip):
        (p, q, r), (s, t, u), (v, w, x) = [[row[i] for i in range(4) if i != skip] for row in rows]
        return p * (t * x - u * w) - q * (s * x - u * v) + r * (s * w - t * v)

    return [(-1) ** skip * minor(skip) for skip in range(4)]


def facets(generators, fixed=(0.0, 0.0, 0.0, 0.0), scale=(1.0, 1.0, 1.0, 1.0)):
    """Normals n and offsets b of the set: n.w <= b for every wrench w = fixed + sum of u_i generators_i, 0 <= u_i <= 1.

    Normals are unit vectors in coordinates that are divided by `scale`.
    """
    own = [[g / s for g, s in zip(each, scale)] for each in generators]
    own = [g for g in own if math.hypot(*g) > 1e-12]
    found = {}
    for a, b, c in itertools.combinations(own, 3):
        n = _normal(a, b, c)
        length = math.hypot(*n)
        if length < 1e-7 * math.hypot(*a) * math.hypot(*b) * math.hypot(*c):
            continue
        for sign in (1.0, -1.0):
            unit = [sign * x / length for x in n]
            key = tuple(round(x, 7) + 0.0 for x in unit)
            if key not in found:
                products = [sum(x * y for x, y in zip(unit, g)) for g in own]
                offset = sum(p for p in products if p > 0)
                normal = [x / s for x, s in zip(unit, scale)]
                found[key] = (normal, offset + sum(x * y for x, y in zip(normal, fixed)))
    return list(found.values())


def scale_of(generators):
    """Sizes of the four coordinates."""
    return [max(abs(g[i]) for g in generators) for i in range(4)]


def set_of_mode(vehicle, mode, density=SEA_LEVEL):
    """Facets of the set of a mode; `mode` is None for the healthy vehicle."""
    whole = columns(vehicle, density)
    scale = scale_of(whole)
    if mode is None:
        return facets(whole, scale=scale)
    fixed = [0.0] * 4
    generators = []
    for column, capacity, stuck in zip(whole, mode["capacity"], mode["stuck"]):
        if stuck is None:
            generators.append([capacity * x for x in column])
        else:
            fixed = [f + stuck * x for f, x in zip(fixed, column)]
    return facets(generators, fixed, scale)


def thrust_at_rest(mass, drag, wind):
    """Thrust at rest and the tilt against the vertical, N and rad. The drag is [d, d, dz] along the axes of the body."""
    across, along = drag[0], drag[2]
    # m g e_z - d w + (d - dz) (b3.w) b3 is along b3; the last term does not turn it.
    force = [-across * wind[0], -across * wind[1], mass * GRAVITY - across * wind[2]]
    length = math.hypot(*force)
    up = [f / length for f in force]
    thrust = length + (across - along) * sum(u * w for u, w in zip(up, wind))
    return thrust, math.atan2(math.hypot(force[0], force[1]), force[2])


def winds(air):
    """The middle of the winds, and the corners of their interval."""
    middle, spread = air["wind"], air["spread"]
    signs = [(-1, 1) if s > 0 else (0,) for s in spread]
    return middle, [[m + k * s for m, k, s in zip(middle, corner, spread)] for corner in itertools.product(*signs)]


def rest_margin(vehicle, air, modes, reserve):
    """The smallest margin of rest over the sets of the healthy vehicle and of `modes`, every stated wind and mass.

    It is counted in shares of the healthy set's width along each facet, from the sets that the reserve has shrunk about
    hover. Returns the margin, the name of its set and the largest tilt at rest in rad.
    """
    density = air["density"]
    drag = [d * density / SEA_LEVEL for d in vehicle["drag"]]
    whole = columns(vehicle, density)
    middle, corners = winds(air)
    masses = [vehicle["mass"] * (1 + k * vehicle["mass_spread"]) for k in ((-1, 0, 1) if vehicle["mass_spread"] else (0,))]
    hover, _ = thrust_at_rest(vehicle["mass"], drag, middle)
    rests = [thrust_at_rest(mass, drag, wind) for mass in masses for wind in [middle, *corners]]
    worst = (math.inf, "")
    for mode in [None, *modes]:
        for n, offset in set_of_mode(vehicle, mode, density):
            width = sum(abs(sum(x * y for x, y in zip(n, g))) for g in whole)
            limit = n[0] * hover + (1 - reserve) * (offset - n[0] * hover)
            for thrust, _ in rests:
                worst = min(worst, ((limit - n[0] * thrust) / width, mode["name"] if mode else "healthy"))
    return *worst, max(tilt for _, tilt in rests)
