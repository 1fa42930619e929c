"""Missions and maps: what pymavlink, MAVSDK, fastkml and geojson read, placed on the Earth by pymap3d, against the exact trajectory."""

import os
import threading
import time

os.environ["MAVLINK20"] = "1"

import fastkml  # noqa: E402
import geojson  # noqa: E402
import numpy as np  # noqa: E402
import pymap3d  # noqa: E402
from pymavlink import mavutil, mavwp  # noqa: E402

MAVLINK = mavutil.mavlink
ORIGIN = (47.397742, 8.545594, 488.0)
PLACED = [
    part
    for name, value in zip(("latitude", "longitude", "altitude"), ("47.397742deg", "8.545594deg", "488m"))
    for part in ("--set", f"mission.origin_{name}={value}")
]
PORT = 14671
# Commands without a place of their own.
CHANGE_SPEED = 178
CONDITION_YAW = 115
NO_PLACE = (CHANGE_SPEED, CONDITION_YAW)


def local(places):
    """x east, y north, z up of rows of latitude, longitude (deg) and height above sea (m)."""
    latitude, longitude, height = np.asarray(places, float).T
    return np.stack(pymap3d.geodetic2enu(latitude, longitude, height, *ORIGIN), axis=-1)


def deviation(plan, corners):
    """The largest distance of the plan from the line through the corners, m."""
    times = np.linspace(0, plan.exact.times[-1], 4001)
    positions = plan.exact.at(times, 0)[:, :3]
    best = np.full(len(times), np.inf)
    for a, b in zip(corners[:-1], corners[1:]):
        along, length = b - a, max((b - a) @ (b - a), 1e-12)
        share = np.clip((positions - a) @ along / length, 0, 1)
        best = np.minimum(best, np.linalg.norm(positions - a - share[:, None] * along, axis=1))
    return best.max()


def wpl_items(plan):
    path = plan.write("plan.waypoints", "--format", "wpl", *PLACED)
    loader = mavwp.MAVWPLoader()
    loader.load(str(path))
    return [loader.wp(k) for k in range(loader.count())]


def wpl(plan):
    reader = "wpl, pymavlink"
    home, *items = wpl_items(plan)
    yield reader, "home, deg", max(abs(home.x - ORIGIN[0]), abs(home.y - ORIGIN[1])), 1e-9
    places = [(item.x, item.y, ORIGIN[2] + item.z) for item in items if item.command not in NO_PLACE]
    corners = local(places)
    start = plan.exact.at([0.0], 0)[:, :3]
    yield reader, "plan from the lines, m", deviation(plan, np.vstack([start, corners])), 0.51
    yield reader, "indices in order", sum(item.seq != k + 1 for k, item in enumerate(items)), 0
    flown, headings = as_copter_flies(items)
    yield reader, "places as ArduCopter flies, m", np.abs(local(flown) - corners).max(), 0.02
    yield reader, "turns as ArduCopter flies, deg", headings_off(plan, local(flown), headings), 3.0


def as_copter_flies(items):
    """Places (latitude, longitude, height above sea) and headings of a mission by ArduCopter 4.5: heights in whole centimetres, of which 0 is
    the present height (`mode_auto.cpp`, `loc_from_cmd`), and headings by CONDITION_YAW alone, for the next place (`do_nav_wp`)."""
    places, headings, height, turn = [], [], 0.0, None
    for item in items:
        if item.command == CONDITION_YAW:
            turn = item.param1
        if item.command in NO_PLACE:
            continue
        centimetres = int(item.z * 100)
        if item.command == MAVLINK.MAV_CMD_NAV_LAND:
            height = item.z
        elif centimetres != 0:
            height = centimetres / 100
        places.append((item.x, item.y, ORIGIN[2] + height))
        headings.append(None if item.command == MAVLINK.MAV_CMD_NAV_TAKEOFF else turn)
        turn = None
    return places, headings


def headings_off(plan, places, headings):
    """The largest difference of headings from the plan where it is nearest to their place, deg."""
    times = np.linspace(0, plan.exact.times[-1], 4001)
    states = plan.exact.at(times, 0)
    worst = 0.0
    for place, heading in zip(places, headings):
        if heading is None:
            continue
        # A plan may be twice at one place.
        off = np.linalg.norm(states[:, :3] - place, axis=1)
        near = states[off < off.min() + 0.05, 3]
        worst = max(worst, np.abs((90 - np.degrees(near) - heading + 180) % 360 - 180).min())
    return worst


class Heartbeat(threading.Thread):
    """What MAVSDK takes for a vehicle."""

    def __init__(self):
        super().__init__(daemon=True)
        self.link = mavutil.mavlink_connection(f"udpout:127.0.0.1:{PORT}", source_system=1, source_component=1)
        self.ends = False

    def run(self):
        while not self.ends:
            self.link.mav.heartbeat_send(MAVLINK.MAV_TYPE_QUADROTOR, MAVLINK.MAV_AUTOPILOT_PX4, 0, 0, MAVLINK.MAV_STATE_STANDBY)
            time.sleep(0.1)


def imported(plan_text, wpl_text):
    """The items that MAVSDK reads from both formats."""
    from mavsdk import ComponentType, Configuration, Mavsdk
    from mavsdk.plugins.mission_raw import MissionRaw

    heart = Heartbeat()
    heart.start()
    try:
        with Mavsdk(Configuration.create_with_component_type(ComponentType.GROUND_STATION)) as sdk:
            sdk.add_any_connection(f"udpin://127.0.0.1:{PORT}")
            system = sdk.first_autopilot(30.0)
            if system is None:
                raise SystemExit("MAVSDK sees no heartbeat")
            missions = MissionRaw(system)
            first = missions.import_qgroundcontrol_mission_from_string(plan_text)
            second = missions.import_mission_planner_mission_from_string(wpl_text)
            return first.mission_items, second.mission_items
    finally:
        heart.ends = True


def by_mavsdk(plan):
    text = plan.write("plan.plan", "--format", "qgc-plan", *PLACED).read_text()
    same = wpl_items(plan)
    # A heading of the plan is a turn before its place in the plain text.
    without_turns = [item for item in same[1:] if item.command != CONDITION_YAW]
    items, others = imported(text, (plan.folder / "plan.waypoints").read_text())
    # Of the plain text MAVSDK keeps the home that comes first.
    for reader, read, due in (("qgc-plan, MAVSDK", items, without_turns), ("wpl, MAVSDK", others, same)):
        yield reader, "items that are missing", abs(len(due) - len(read)), 0
        yield reader, "commands unlike pymavlink", sum(a.command != b.command for a, b in zip(read, due)), 0
        pairs = [(a, b) for a, b in zip(read, due) if b.command not in NO_PLACE]
        # MAVSDK keeps whole 1e-7 degrees and heights of 32 bits.
        yield reader, "places, deg", max(max(abs(a.x * 1e-7 - b.x), abs(a.y * 1e-7 - b.y)) for a, b in pairs), 1.01e-7
        yield reader, "heights, m", max(abs(a.z - b.z) for a, b in pairs), 1e-4
    turns = dict(zip((item.seq + 1 for item in same if item.command == CONDITION_YAW), (i.param1 for i in same if i.command == CONDITION_YAW)))
    pairs = [(a.param4, turns[b.seq]) for a, b in zip(items, without_turns) if b.seq in turns]
    yield "qgc-plan, MAVSDK", "headings, deg", max(abs((a - b + 180) % 360 - 180) for a, b in pairs), 1e-3


def line_of_kml(features):
    for feature in features:
        if getattr(feature, "name", None) == "path":
            return list(feature.geometry.coords)
        found = line_of_kml(getattr(feature, "features", []))
        if found:
            return found
    return None


def kml(plan):
    path = plan.write("plan.kml", "--format", "kml", *PLACED)
    read = fastkml.KML.parse(path, strict=True)
    line = np.array(line_of_kml(read.features))
    yield "kml, fastkml", "plan from the line, m", deviation(plan, local(line[:, [1, 0, 2]])), 0.101


def geo(plan):
    path = plan.write("plan.geojson", "--format", "geojson", *PLACED)
    # By default the package rounds to six digits, 11 cm.
    geojson.geometry.DEFAULT_PRECISION = 9
    read = geojson.loads(path.read_text())
    yield "geojson, geojson", "errors", len(read.errors()), 0
    line = np.array(read["features"][0]["geometry"]["coordinates"])
    yield "geojson, geojson", "plan from the line, m", deviation(plan, local(line[:, [1, 0, 2]])), 0.101


CHECKS = [wpl, by_mavsdk, kml, geo]
