"""Random vehicles of 4 to 16 rotors, and fault modes in which they hover."""

import math

import sets

# name, rotors, range of arms in m, range of masses in kg
LAYOUTS = {
    "quad": (4, (0.12, 0.3), (0.6, 2.6)),
    "hexa_pnpnpn": (6, (0.25, 0.5), (2.0, 6.0)),
    "hexa_ppnnpn": (6, (0.28, 0.5), (2.5, 6.0)),
    "y6": (6, (0.25, 0.5), (2.0, 7.0)),
    "octo_pnpnpnpn": (8, (0.3, 0.6), (3.5, 10.0)),
    "octo_ppnnppnn": (8, (0.3, 0.6), (3.5, 10.0)),
    "x8": (8, (0.4, 0.75), (6.0, 18.0)),
    "nine": (9, (0.4, 0.7), (5.0, 12.0)),
    "twelve": (12, (0.5, 0.9), (8.0, 20.0)),
    "coaxial_twelve": (12, (0.5, 0.8), (9.0, 20.0)),
    "sixteen": (16, (0.7, 1.1), (12.0, 30.0)),
    "coaxial_sixteen": (16, (0.6, 1.0), (12.0, 30.0)),
}
RINGS = {
    "quad": "PNPN",
    "hexa_pnpnpn": "PNPNPN",
    "hexa_ppnnpn": "PPNNPN",
    "octo_pnpnpnpn": "PNPNPNPN",
    "octo_ppnnppnn": "PPNNPPNN",
    "twelve": "PPNNPPNNPPNN",
    "sixteen": "PPNNPPNNPPNNPPNN",
}
COAXIAL = {"y6": 3, "x8": 4, "coaxial_twelve": 6, "coaxial_sixteen": 8}
LOWER_SHARE = 0.8  # of the upper rotor's thrust, which the lower one of a coaxial pair gives in its wake


def _ring(layout, first_deg, arm):
    """Places of a ring: the first rotor at `first` from +y, the others clockwise."""
    angles = [math.radians(first_deg) + 2 * math.pi * i / len(layout) for i in range(len(layout))]
    return [([arm * math.sin(a), arm * math.cos(a), 0.0], spin) for a, spin in zip(angles, layout)]


def make(r, kind, thrust_to_weight):
    """A vehicle without wind or modes: the record, with the lines of its spec."""
    count, arms, masses = LAYOUTS[kind]
    arm = round(r.uniform(*arms), 2)
    mass = round(r.uniform(*masses) * 0.5 + 0.5 * (masses[0] + (masses[1] - masses[0]) * (arm - arms[0]) / (arms[1] - arms[0])), 2)
    k = r.uniform(0.12, 0.24) * mass * arm**2
    inertia = [float(f"{x:.3g}") for x in (k, k * r.uniform(0.9, 1.15), k * r.uniform(1.6, 1.85))]
    torque = round(r.uniform(12, 24) * 1e-3, 4)
    full = float(f"{thrust_to_weight * mass * sets.GRAVITY / count:.3g}")
    speed = 100 * round(30 + 60 / math.sqrt(arm / 0.15) * r.uniform(0.8, 1.2))
    propeller = round(min(0.9 * arm * math.sin(math.pi / max(count if kind in RINGS else count // 2, 4)), 0.3), 2)
    vehicle = {
        "kind": kind, "mass": mass, "mass_spread": 0.0, "inertia": inertia, "drag": [0.0, 0.0, 0.0], "size": 0.0, "rotors": [],
        "torque": torque, "full": full, "max_speed": speed, "own_size": None, "propeller": propeller, "arm": arm, "first": 0,
    }  # fmt: skip
    if kind in RINGS:
        vehicle["first"] = 45 if kind == "quad" else r.choice([0, 0, 30]) if count == 6 else 0
        for at, spin in _ring(RINGS[kind], vehicle["first"], arm):
            vehicle["rotors"].append({"at": at, "spin": spin, "max_thrust": full, "torque_per_thrust": torque})
    elif kind in COAXIAL:
        arms_of_frame = COAXIAL[kind]
        upper = float(f"{2 * full / (1 + LOWER_SHARE):.3g}")
        lower = float(f"{LOWER_SHARE * upper:.3g}")
        vehicle["full"] = upper
        for i in range(arms_of_frame):
            angle = math.pi * (2 * i + 1) / arms_of_frame
            x, y = round(arm * math.cos(angle), 3), round(arm * math.sin(angle), 3)
            spins = "PN" if i % 2 == 0 or arms_of_frame % 2 else "NP"
            for z, spin, thrust in ((0.05, spins[0], upper), (-0.05, spins[1], lower)):
                vehicle["rotors"].append({"at": [x, y, z], "spin": spin, "max_thrust": thrust, "torque_per_thrust": torque})
    else:  # nine: a ring of eight and one in the middle
        for at, spin in _ring("PPNNPPNN", 0, arm):
            vehicle["rotors"].append({"at": [round(x, 3) for x in at], "spin": spin, "max_thrust": full, "torque_per_thrust": torque})
        vehicle["rotors"].append({"at": [0.0, 0.0, 0.08], "spin": "P", "max_thrust": full, "torque_per_thrust": torque})
    if kind in RINGS and r.random() < 0.6:
        vehicle["size"] = arm + propeller
    else:
        vehicle["own_size"] = round(arm + propeller + r.uniform(0, 0.15), 2)
        vehicle["size"] = vehicle["own_size"]
    return vehicle


def lines(vehicle):
    """The block of the spec."""
    kind = vehicle["kind"]
    spread = f" +- {100 * vehicle['mass_spread']:g} %" if vehicle["mass_spread"] else ""
    found = [f"vehicle {kind} {{"]
    if kind in RINGS:
        found.append(f'    layout  = "{RINGS[kind]}"')
        if vehicle["first"]:
            found.append(f"    first   = {vehicle['first']} deg")
        found.append(f"    arm     = {vehicle['arm']:g} m")
    found.append(f"    mass    = {vehicle['mass']:g} kg{spread}")
    found.append("    inertia = [{:g}, {:g}, {:g}] kg*m^2".format(*vehicle["inertia"]))
    if vehicle["own_size"] is None:
        found.append(f"    propeller_radius = {100 * vehicle['propeller']:g} cm")
    else:
        found.append(f"    size    = {vehicle['own_size']:g} m")
    drag = vehicle["drag"]
    if any(drag):
        same = drag[0] == drag[2]
        found.append(f"    drag    = {drag[0]:g} N*s/m" if same else "    drag    = [{:g}, {:g}, {:g}] N*s/m".format(*drag))
    found.append(
        f"    rotor {{ max_thrust = {vehicle['full']:g} N; torque_per_thrust = {1000 * vehicle['torque']:g} mm; "
        f"max_speed = {vehicle['max_speed']} rpm }}"
    )
    if kind not in RINGS:
        found.append("    rotors {")
        for rotor in vehicle["rotors"]:
            own = "" if rotor["max_thrust"] == vehicle["full"] else f"  max_thrust {rotor['max_thrust']:g} N"
            found.append("        rotor at [{:g}, {:g}, {:g}] m  spin {}{}".format(*rotor["at"], rotor["spin"], own))
        found.append("    }")
    return [*found, "}"]


def mode(name, count, capacity=None, stuck=None):
    """A fault mode: capacities other than 1 and shares of stuck rotors, by rotor counted from 1."""
    capacity, stuck = capacity or {}, stuck or {}
    return {
        "name": name,
        "capacity": [capacity.get(i + 1, 1.0) for i in range(count)],
        "stuck": [stuck.get(i + 1) for i in range(count)],
    }


def groups_of_modes(r, count):
    """Groups of modes that fit this number of rotors: each a statement of `faults` and its modes."""
    each = range(1, count + 1)
    weak = r.choice([70, 75, 80, 85] if count == 4 else [50, 60, 70, 80])
    reduced = (
        f"every 1 rotor reduced to {weak} % as W",
        [mode(f"W{i}", count, {i: weak / 100}) for i in each],
    )
    if count == 4:
        return [reduced]
    all_weak = r.choice([80, 85, 90])
    stuck = r.choice([30, 40, 50, 60])
    opposite = count // 2
    a = r.randint(1, opposite)
    found = [
        reduced,
        ("every 1 rotor lost as M", [mode(f"M{i}", count, {i: 0.0}) for i in each]),
        (f"every 1 rotor stuck at {stuck} % as J", [mode(f"J{i}", count, stuck={i: stuck / 100}) for i in each]),
        (
            f'mode ice "ice on all blades" {{ rotors [{", ".join(map(str, each))}] reduced to {all_weak} % }}',
            [mode("ice", count, {i: all_weak / 100 for i in each})],
        ),
    ]
    if count >= 8:
        pair = (a, a + opposite)
        found.append((f"mode pair {{ rotors [{pair[0]}, {pair[1]}] lost }}", [mode("pair", count, {i: 0.0 for i in pair})]))
        found.append(
            (
                f"mode worn {{ rotor {a} lost; rotor {a + 1} reduced to 70 % }}",
                [mode("worn", count, {a: 0.0, a + 1: 0.7})],
            )
        )
    return found


def tolerated(r, vehicle, air, reserve, margin, edge):
    """The statements of `faults` and the modes for `against`, whose sets hold rest by the margin; None if there are none.

    With `edge`, the mass is raised until rest is just inside.
    """

    def inside(each):
        return sets.rest_margin(vehicle, air, each, reserve)[0] >= margin

    if not inside([]):
        return None
    count = len(vehicle["rotors"])
    offered = groups_of_modes(r, count)
    # A lost rotor is what missions are planned against most; the rest comes in any order.
    r.shuffle(offered)
    if r.random() < 0.7:
        offered.sort(key=lambda group: group[1][0]["name"] != "M1")
    wanted, statements, against = r.choice([1, 1, 2, 3]), [], []
    for statement, modes in offered:
        if len(statements) == wanted:
            break
        # Modes of one statement for rings of equal rotors are the same by symmetry where the first two are.
        kept = [m for m in modes if inside([m])]
        if kept and (len(kept) >= len(modes) / 2 or r.random() < 0.5):
            statements.append((statement, modes, kept))
            against += kept
    if not against:
        return None
    if edge:
        low = vehicle["mass"]
        for _ in range(40):
            vehicle["mass"] = round(vehicle["mass"] * 1.03, 2)
            if not inside(against):
                vehicle["mass"] = low
                break
            low = vehicle["mass"]
    return statements, against
