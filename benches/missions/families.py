"""Kinds of missions, each with random parameters: what vehicles of this size are flown for."""

import math

from missions import Mission

GAP = 0.36  # m that the lines through the waypoints keep beyond what volumes require; the premise needs 0.3


def _obstacle(r, mission, x, y, reach, top, clearance):
    """An upright body within `reach` of (x, y): a cylinder, a turned box or a triangle."""
    shape = r.choice(["cylinder", "cylinder", "box", "polygon"])
    if shape == "cylinder":
        mission.volume("keep_out", shape, clearance, centre=[x, y, 0.0], radius=reach - 0.02, height=top)
    elif shape == "box":
        angle = r.uniform(0.5, 1.0)
        a, b = 0.97 * reach * math.cos(angle), 0.97 * reach * math.sin(angle)
        turn = {"turn": float(r.randint(-40, 40))} if r.random() < 0.5 else {}
        mission.volume("keep_out", shape, clearance, **{"from": [x - a, y - b, 0.0], "to": [x + a, y + b, top]}, **turn)
    else:
        first = r.uniform(0, 2)
        corners = [[x + 0.97 * reach * math.cos(first + k), y + 0.97 * reach * math.sin(first + k)] for k in (0, 2.0, 4.1)]
        mission.volume("keep_out", shape, clearance, corners=corners, bottom=0.0, top=top)


def _count(r, least, most):
    """How many gates, lanes or places: long missions are long on purpose."""
    most = max(least, most)
    return r.randint(max(least, most // 2), most)


def _within(r):
    return r.choice([None, None, 0.1, 0.2, 0.3, 0.5])


def slalom(r, size, most):
    """Gates left and right of poles, and home beside them."""
    m = Mission("slalom")
    clearance = r.choice([0.0, 0.2, 0.5])
    reach = r.uniform(0.15, 1.0)
    q = reach + size + clearance + GAP
    aside, ahead = q * r.uniform(1.6, 2.0), q * r.uniform(3.2, 6.0)
    height, top = r.uniform(1.5, 4) + size, 12.0
    gates = _count(r, 2, min(30, most - 4))
    m.fly([0, 0, height], yaw=r.choice([0, 0, 90, "path"]))
    for i in range(1, gates + 1):
        side = 1 if i % 2 else -1
        m.fly([i * ahead, side * aside, height + r.uniform(-0.5, 0.8)], within=_within(r), line=r.choice([None, None, None, "straight"]))
        _obstacle(r, m, i * ahead, 0.0, reach, top, clearance)
    far = (gates + 1) * ahead
    m.fly([far, 0, height], within=_within(r), stop=r.random() < 0.3)
    if r.random() < 0.5:
        m.hold(r.uniform(0.5, 3))
    lane = aside + q * r.uniform(1.2, 2.0)
    if r.random() < 0.7:
        m.fly([far, lane, height], within=_within(r))
        m.fly([0, lane, height], within=_within(r), corridor=r.choice([None, 1.0, 2.0]))
    reach_of_tree = r.uniform(0.3, 1.2)
    _obstacle(r, m, r.uniform(0.3, 0.7) * far, lane + reach_of_tree + size + clearance + GAP + r.uniform(0, 2), reach_of_tree, top, clearance)
    m.limits["altitude"] = [0.5, round(height + r.uniform(1.5, 4), 1)]
    return m


def survey(r, size, most):
    """Lanes up and down a field, as high as trees or above them."""
    m = Mission("survey")
    lanes = _count(r, 2, min(18, (most - 4) // 2))
    gap = r.uniform(3, 10) + 4 * size
    length = r.uniform(4, 14) * (2 + 3 * size)
    height = r.choice([4, 8, 15, 25]) + r.uniform(0, 3)
    rule = r.choice(["fixed", "fixed", "path", "lanes"])
    m.fly([0, 0, 2 + size], yaw="path" if rule == "path" else 0, yaw_within=r.choice([None, 5, 10]))
    if r.random() < 0.7:
        m.fly([0, 0, height], within=_within(r), line=r.choice([None, "vertical"]), stop=r.random() < 0.3)
        entry = [gap, 0]
    else:
        entry = [gap, gap]
    within = _within(r)
    corridor = r.choice([None, None, "straight", 0.8, 2.0])
    limits = r.choice([None, None, {"speed": 5.0}, {"tilt": 20.0}])
    for i in range(lanes):
        y = entry[1] + i * gap
        ends = [entry[0], entry[0] + length]
        for j, x in enumerate(ends if i % 2 == 0 else ends[::-1]):
            own = {}
            if j == 1:
                own = {"limits": limits}
                if corridor == "straight":
                    own["line"] = "straight"
                elif corridor:
                    own["corridor"] = corridor
            yaw = (0 if i % 2 == 0 else 180) if rule == "lanes" and j == 0 else None
            m.fly([x, y, height], yaw=yaw, within=within, **own)
    if r.random() < 0.6:
        m.fly([0, 0, height + r.uniform(0, 2)], within=_within(r))
        if r.random() < 0.6:
            m.fly([0, 0, 2 + size], line="vertical")
    trees = r.randint(0, 3)
    for _ in range(trees):
        reach = r.uniform(0.2, max(0.21, gap / 2 - size - GAP))
        lane = r.randint(0, lanes - 2)
        _obstacle(r, m, entry[0] + r.uniform(0.1, 0.9) * length, entry[1] + (lane + 0.5) * gap, reach, r.uniform(0.5, 1.5) * height, 0.0)
    edge = size + GAP + r.uniform(0, 3)
    far = [entry[0] + length, entry[1] + (lanes - 1) * gap]
    kind = r.choice(["none", "box", "polygon", "half_space"])
    if kind == "box":
        m.volume("keep_in", "box", **{"from": [-edge, -edge, 0], "to": [far[0] + edge, far[1] + edge, height + 5 + edge]})
    elif kind == "polygon":
        corners = [[-edge, -edge], [far[0] + edge, -edge], [far[0] + 2 * edge, far[1] / 2], [far[0] + edge, far[1] + edge], [-edge, far[1] + edge]]
        m.volume("keep_in", "polygon", corners=corners, bottom=0.0, top=height + 5 + edge)
    elif kind == "half_space":
        m.volume("keep_in", "half_space", 0.1, point=[far[0] + edge + 0.1, 0, 0], normal=[1, 0, 0])
    m.limits["altitude"] = [1.0, round(height + 15, 1)]
    return m


def pick(r, size, most):
    """Pick and place: legs straight up and down, stops, holds, and a crane between the places."""
    m = Mission("pick")
    cruise = r.uniform(12, 40)
    wide = r.uniform(20, 60) + 10 * size
    line = lambda: r.choice(["vertical", "vertical", None])
    m.fly([0, 0, 1 + size], yaw=0)
    m.fly([0, 0, cruise], line="vertical", stop=r.random() < 0.5, within=_within(r))
    places = _count(r, 1, min(5, (most - 4) // 4))
    x = y = 0.0
    for k in range(places):
        across = r.choice([-1, 1]) * r.uniform(0.3, 0.8) * wide
        before = (x, y)
        x, y = x + wide * r.uniform(0.7, 1.1), y + across
        bottom = r.uniform(2 + size, cruise - 4)
        turn = r.choice([None, 90, 180, -90, -135])
        # The crane on the straight way there; a waypoint around it on one side.
        if r.random() < 0.7 and len(m.points) + 5 <= most:
            reach, clearance = r.uniform(1, 4), r.choice([0.0, 0.5, 1.0])
            middle = [(a + b) / 2 for a, b in zip(before, (x, y))]
            along = math.atan2(y - before[1], x - before[0])
            off = (reach + size + clearance + GAP) * r.uniform(1.5, 2.2)
            side = r.choice([-1, 1])
            place = [middle[0] - side * off * math.sin(along), middle[1] + side * off * math.cos(along)]
            _obstacle(r, m, middle[0], middle[1], reach, cruise + r.uniform(3, 10), clearance)
            m.fly([*place, cruise], within=r.choice([0.2, 0.5, 1.0]))
        m.fly([x, y, cruise], yaw=turn, within=_within(r), stop=r.random() < 0.5)
        m.fly([x, y, bottom], within=r.choice([0.1, 0.2]), line="vertical", limits=r.choice([None, {"speed": 2.0}, {"tilt": 18.0}]))
        m.hold(r.uniform(1, 5))
        m.fly([x, y, cruise - r.uniform(0, 3)], within=r.choice([0.2, 0.5]), line=line())
    if r.random() < 0.5 and len(m.points) + 2 <= most:
        m.fly([x - 0.2 * wide, y + 0.6 * wide, cruise], within=1.0, yaw=r.choice([None, 0]))
    m.fly([x - 0.4 * wide, y + wide, 3 + size], yaw=r.choice([None, 0, 90]))
    m.limits["altitude"] = [0.6, round(cruise + 20)]
    if r.random() < 0.5:
        m.limits["descent"] = [None, float(r.choice([2, 3, 4]))]
        m.limits["climb"] = [None, float(r.choice([3, 4, 5]))]
    return m


def windows(r, size, most):
    """A hall with walls across it; each wall has a window."""
    m = Mission("windows")
    clearance = r.choice([0.0, 0.1, 0.2])
    half = size + clearance + GAP
    walls = _count(r, 1, min(12, (most - 3) // 2))
    wide, high = half * r.uniform(5, 8), half * r.uniform(4, 6)
    bay = half * r.uniform(6, 10)
    thick = r.uniform(0.1, 0.6)
    yaw = r.choice([0, 0, 90, "path"])
    m.fly([0, 0, high / 2], yaw=yaw, yaw_within=r.choice([None, 5, 10]))
    for i in range(1, walls + 1):
        x = i * bay
        open_y, open_z = half + r.uniform(0.05, 0.6), half + r.uniform(0.05, 0.6)
        y = r.uniform(-1, 1) * (wide - open_y - 0.3)
        z = r.uniform(open_z + 0.2, high - open_z - 0.2)
        near, past = x - thick / 2 - half - r.uniform(0.1, 1), x + thick / 2 + half + r.uniform(0.1, 1)
        m.fly([near, y, z], within=r.choice([None, 0.1, 0.2]), stop=r.random() < 0.2)
        clause = r.choice([{"line": "straight"}, {"corridor": 0.3}, {}])
        m.fly([past, y, z], within=r.choice([None, 0.1, 0.2]), **clause)
        beside = [([-wide, y - open_y], [0, high]), ([y + open_y, wide], [0, high])]
        below_and_above = [([y - open_y, y + open_y], [0, z - open_z]), ([y - open_y, y + open_y], [z + open_z, high])]
        for ys, zs in beside + below_and_above:
            m.volume("keep_out", "box", clearance, **{"from": [x - thick / 2, ys[0], zs[0]], "to": [x + thick / 2, ys[1], zs[1]]})
    end = (walls + 1) * bay
    m.fly([end, r.uniform(-0.5, 0.5) * wide, high / 2], within=_within(r), yaw=r.choice([None, 180]) if yaw == 0 else None)
    if r.random() < 0.5:
        m.hold(r.uniform(0.5, 2))
        m.fly([end + half, 0, high / 2])
    edge = size + GAP
    m.volume("keep_in", "box", **{"from": [-edge - 1, -wide, 0], "to": [end + half + edge + 1, wide, high]})
    return m


def ring(r, size, most):
    """Round and round a tower, often with the nose towards it."""
    m = Mission("ring")
    reach, clearance = r.uniform(0.5, 4), r.choice([0.0, 0.5, 1.0])
    turns = r.choice([0.75, 1.0, 1.0, 1.5, 2.0])
    points = _count(r, 6, min(38, most - 2))
    per_turn = max(5.0, (points - 1) / turns)
    turns = (points - 1) / per_turn
    radius = (reach + size + clearance + GAP) / math.cos(math.pi / per_turn) + r.uniform(0.2, 8)
    low = r.uniform(3, 8) + size
    high = low + r.choice([0, 0, 1]) * r.uniform(2, 20)
    m.volume("keep_out", "cylinder", clearance, centre=[0, 0, 0], radius=reach, height=high + r.uniform(1, 10))
    yaw = r.choice(["towards", "towards", "round", "path", "fixed", "free"])
    begin = r.uniform(-3, 3)
    entry = [1.6 * radius * math.cos(begin - 0.3), 1.6 * radius * math.sin(begin - 0.3), low]
    first = {"towards": ("towards", [0, 0, 0]), "path": "path", "free": "free", "fixed": 0, "round": math.degrees(begin) + 90}[yaw]
    m.fly(entry, yaw=first, yaw_within=r.choice([None, 5, 10]))
    if r.random() < 0.5:
        m.spiral([0, 0], radius, begin, turns, points, low, high, yaw=90 if yaw == "round" else None)
    else:
        for i in range(points):
            angle = begin + 2 * math.pi * turns * i / (points - 1)
            own = {"yaw": math.degrees(angle) + 90} if yaw == "round" else {}
            place = [radius * math.cos(angle), radius * math.sin(angle), low + (high - low) * i / (points - 1)]
            m.fly(place, within=r.choice([None, 0.1, 0.3]), **own)
            if r.random() < 0.08:
                m.hold(r.uniform(1, 3))
    if r.random() < 0.5:
        x, y, z = m.points[-1]["at"]
        m.fly([1.5 * x, 1.5 * y, max(1 + size, z - r.uniform(0, 3))])
    if r.random() < 0.3:
        wall = 2.5 * radius + size
        m.volume("keep_in", r.choice(["cylinder"]), centre=[0, 0, 0], radius=wall, height=high + 3 * radius)
    m.limits["altitude"] = [0.6, round(high + 10, 1)]
    return m


def dash(r, size, most):
    """Climb, dash, dive and return, at what the rotors give."""
    m = Mission("dash")
    long = r.uniform(20, 70)
    m.fly([0, 0, 1.5 + size], yaw=0)
    m.fly([0, 0, r.uniform(12, 25)], within=0.3, line=r.choice([None, "vertical"]))
    legs = _count(r, 1, min(9, most - 3))
    heading, x, y = r.uniform(-0.4, 0.4), 0.0, 0.0
    for i in range(legs):
        heading += r.uniform(-1.2, 1.2)
        x, y = x + long * r.uniform(0.5, 1.2) * math.cos(heading), y + long * r.uniform(0.5, 1.2) * math.sin(heading)
        m.fly([x, y, r.uniform(8, 40)], within=r.choice([0.3, 0.5]), yaw=r.choice([None, None, 45, -90]))
        if r.random() < 0.25:
            m.hold(r.uniform(1, 3))
    m.fly([0 if abs(x) > 8 else 30, 0, 1.5 + size], within=None)
    m.limits["altitude"] = [0.8, 60.0]
    return m


def inspection(r, size, most):
    """Along the front of a building with an inward corner: stations with holds, and legs up and down."""
    m = Mission("inspection")
    clearance = r.choice([0.3, 0.5, 1.0])
    off = size + clearance + GAP + r.uniform(0.3, 3)
    wide, deep, top = r.uniform(12, 40), r.uniform(6, 15), r.uniform(8, 25)
    corners = [[0, 0], [wide, 0], [wide, deep], [wide / 2, deep], [wide / 2, deep / 2], [0, deep / 2]]
    m.volume("keep_out", "polygon", clearance, corners=corners, bottom=0.0, top=top)
    towards = r.random() < 0.5
    m.fly([-off - 2, -off, 1 + size], yaw=90, yaw_within=r.choice([None, 5]))
    stations = _count(r, 2, min(12, (most - 3) // 2))
    up = True
    for i in range(stations):
        x = wide * (i + 0.5) / stations
        low, high = 2 + size + r.uniform(0, 1), top * r.uniform(0.5, 1.1) + 2
        first, last = (low, high) if up else (high, low)
        yaw = ("towards", [x, 3 + size, 0]) if towards else r.choice([None, 90])
        m.fly([x, -off, first], yaw=yaw, within=r.choice([None, 0.2, 0.3]), stop=r.random() < 0.15)
        if r.random() < 0.4:
            m.hold(r.uniform(1, 4))
        clause = r.choice([{"line": "vertical"}, {"line": "vertical", "limits": {"speed": 2.5}}, {}])
        m.fly([x, -off, last], within=r.choice([None, 0.1, 0.3]), **clause)
        if r.random() < 0.3:
            m.hold(r.uniform(1, 3))
        up = not up
    if r.random() < 0.5 and len(m.points) + 3 <= most:  # round the corner, and home behind the building
        m.fly([wide + off, -off, m.points[-1]["at"][2]], yaw="free" if r.random() < 0.3 else 90)
        m.fly([wide + off, deep + off, 3 + size])
    else:
        m.fly([wide + off + 2, -off, 1 + size])
    if r.random() < 0.5:
        m.volume("keep_in", "half_space", 0.2, point=[0, -off - size - GAP - 0.3 - r.uniform(0, 3), 0], normal=[0, -1, 0])
    m.limits["altitude"] = [0.6, round(top * 1.1 + 10)]
    return m


def mixed(r, size, most):
    """A random walk with every clause, and bodies beside its legs or on them: then a waypoint leads around."""
    m = Mission("mixed")
    step = r.uniform(4, 14) + 6 * size
    wanted = _count(r, 3, min(30, most - 2))
    place, heading = [0.0, 0.0, r.uniform(4, 12)], r.uniform(0, 6)
    m.fly(place, yaw=r.choice([0, 90, "path", "free"]), yaw_within=r.choice([None, 5, 15]))
    base = place[2]
    while len(m.points) < wanted:
        heading += r.uniform(-1.1, 1.1)
        length = step * r.uniform(0.6, 1.6)
        climb = r.choice([0, 0, 1]) * r.uniform(-2, 4)
        if r.random() < 0.15:
            target = [place[0], place[1], max(base - 1.5, place[2] + r.choice([-1, 1]) * r.uniform(2, 5))]
            m.fly(target, line="vertical", within=_within(r), stop=r.random() < 0.3)
        else:
            target = [place[0] + length * math.cos(heading), place[1] + length * math.sin(heading), max(base - 1, place[2] + climb)]
            clearance, reach = r.choice([0.0, 0.3]), r.uniform(0.2, 1.2)
            need = reach + size + clearance + GAP
            middle = [(a + b) / 2 for a, b in zip(place, target)]
            normal = [-math.sin(heading), math.cos(heading)]
            kind = r.random()
            side = r.choice([-1, 1])
            if kind < 0.3 and length > 3.2 * need:  # on the way
                beside = [middle[i] + side * need * r.uniform(1.45, 1.8) * normal[i] for i in (0, 1)]
                if r.random() < 0.3:
                    m.volume("keep_out", "sphere", clearance, centre=middle, radius=reach)
                else:
                    _obstacle(r, m, middle[0], middle[1], reach, base + 20, clearance)
                m.fly([*beside, middle[2]], within=_within(r))
            elif kind < 0.6:  # beside it
                away = need + r.choice([0.0, 0.3, 2.0]) + 0.02
                _obstacle(r, m, middle[0] + side * away * normal[0], middle[1] + side * away * normal[1], reach, base + 20, clearance)
            own = r.choice([{}, {}, {}, {"line": "straight"}, {"corridor": r.choice([0.5, 1.0, 3.0])}])
            limits = r.choice([None, None, None, None, {"speed": 3.0}, {"acceleration": 4.0}])
            m.fly(target, within=_within(r), stop=r.random() < 0.1, limits=limits, yaw=r.choice([None, None, None, 0, -60, 150]), **own)
        if r.random() < 0.15:
            m.hold(r.uniform(0.5, 4))
        place = target
    return m


FAMILIES = [slalom, survey, pick, windows, ring, dash, inspection, mixed]
