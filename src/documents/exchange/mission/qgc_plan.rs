//! Plans of QGroundControl, version 1 with a mission of version 2.

use super::items::{CHANGE_SPEED, Item, Items, WAYPOINT};
use super::polyline::{MEASURED, instants};
use super::{Placed, Spot};
use crate::model::{Body, LandingSite, VolumeSide};
use serde_json::{Value, json};

/// `MAV_AUTOPILOT_PX4`, `MAV_TYPE_QUADROTOR` (of which QGroundControl means any multirotor),
/// `MAV_FRAME_GLOBAL_RELATIVE_ALT` and `MAV_FRAME_MISSION`; QGroundControl's altitude mode for heights relative to
/// home.
const PX4: u8 = 12;
const MULTIROTOR: u8 = 2;
pub const RELATIVE: u8 = 3;
pub const NO_PLACE: u8 = 2;
const RELATIVE_MODE: u8 = 1;

/// The text, and what became of the volumes, as the rest of a sentence.
pub fn text(placed: &Placed, items: &Items) -> (String, String) {
    let home = placed.home();
    let list: Vec<Value> = items.all.iter().enumerate().map(|(k, item)| one(item, k + 1, home)).collect();
    let speeds = items.all.iter().filter_map(|item| if let Item::Speed(speed) = item { Some(*speed) } else { None });
    let (polygons, circles, left_out) = fences(placed);
    let hover_speed = speeds.fold(0.0_f64, f64::max);
    let mut mission = json!({
        "version": 2,
        "firmwareType": PX4,
        "vehicleType": MULTIROTOR,
        "cruiseSpeed": hover_speed,
        "hoverSpeed": hover_speed,
        "globalPlanAltitudeMode": RELATIVE_MODE,
        "plannedHomePosition": [home.latitude, home.longitude, home.height],
        "items": list,
    });
    if hover_speed == 0.0 {
        // A plan without horizontal motion: QGroundControl's own defaults.
        mission["cruiseSpeed"] = json!(15);
        mission["hoverSpeed"] = json!(5);
    }
    let plan = json!({
        "fileType": "Plan",
        "version": 1,
        "groundStation": "QGroundControl",
        "mission": mission,
        "geoFence": { "version": 2, "circles": circles, "polygons": polygons },
        "rallyPoints": { "version": 2, "points": rally_points(placed) },
    });
    let text = serde_json::to_string_pretty(&plan).unwrap_or_default() + "\n";
    let said = match left_out[..] {
        [] => String::new(),
        _ => format!("; not a fence, since fences have no heights: {}", left_out.join(", ")),
    };
    (text, said)
}

/// Landing sites as places to return to: latitude, longitude, and the height above home at which the vehicle arrives,
/// that of the highest waypoint.
fn rally_points(placed: &Placed) -> Vec<Value> {
    let mission = placed.mission;
    let highest = mission.waypoints.iter().map(|waypoint| waypoint.position[2]).fold(f64::NEG_INFINITY, f64::max);
    let point = |site: &LandingSite| {
        let Spot { latitude, longitude, .. } = placed.spot(site.at);
        json!([latitude, longitude, super::rounded(highest, 1e3)])
    };
    mission.after_fault.sites.iter().map(point).collect()
}

fn one(item: &Item, number: usize, home: Spot) -> Value {
    match item {
        Item::Speed(speed) => json!({
            "type": "SimpleItem", "command": CHANGE_SPEED, "doJumpId": number, "frame": NO_PLACE, "autoContinue": true,
            "params": [1, speed, -1, 0, 0, 0, 0],
        }),
        Item::Place { command, spot, hold, heading } => {
            let height = super::rounded(spot.height - home.height, 1e3);
            let seconds = if *command == WAYPOINT { *hold } else { 0.0 };
            json!({
                "type": "SimpleItem", "command": command, "doJumpId": number, "frame": RELATIVE, "autoContinue": true,
                "Altitude": height, "AltitudeMode": RELATIVE_MODE, "AMSLAltAboveTerrain": null,
                "params": [seconds, 0, 0, heading, spot.latitude, spot.longitude, height],
            })
        }
    }
}

/// Polygons and circles of the geofence, and the names of volumes that would be another thing without their heights:
/// those over or under which the plan flies, spheres to stay in, half spaces, and more than one volume to stay in, of
/// which PX4 takes any.
fn fences<'a>(placed: &Placed<'a>) -> (Vec<Value>, Vec<Value>, Vec<&'a str>) {
    let (mut polygons, mut circles, mut left_out) = (Vec::new(), Vec::new(), Vec::new());
    let inclusions = placed.mission.volumes.iter().filter(|v| v.side == VolumeSide::KeepIn).count();
    for volume in &placed.mission.volumes {
        let is_inside = volume.side == VolumeSide::KeepIn;
        let is_flat = |body: &Body| match body {
            Body::HalfSpace { .. } => false,
            Body::Ball { .. } => !is_inside,
            _ => true,
        };
        let is_clear = is_inside || volume.bodies.iter().all(|body| is_passed_at_the_side(placed, body));
        if !volume.bodies.iter().all(is_flat) || !is_clear || is_inside && inclusions > 1 {
            left_out.push(volume.name.as_str());
            continue;
        }
        for body in &volume.bodies {
            let level = |[x, y]: [f64; 2]| {
                let Spot { latitude, longitude, .. } = placed.spot([x, y, 0.0]);
                json!([latitude, longitude])
            };
            match body {
                Body::Prism { corners, .. } => {
                    let corners: Vec<Value> = corners.iter().map(|corner| level(*corner)).collect();
                    polygons.push(json!({ "inclusion": is_inside, "polygon": corners, "version": 1 }));
                }
                Body::Cylinder { centre, radius, .. } => circles.push(circle(level(*centre), *radius, is_inside)),
                Body::Ball { centre: [x, y, _], radius } => circles.push(circle(level([*x, *y]), *radius, is_inside)),
                Body::HalfSpace { .. } => {}
            }
        }
    }
    (polygons, circles, left_out)
}

fn circle(centre: Value, radius: f64, is_inside: bool) -> Value {
    let circle = json!({ "center": centre, "radius": super::rounded(radius, 1e3) });
    json!({ "circle": circle, "inclusion": is_inside, "version": 1 })
}

/// Whether the plan stays beside a body, neither over nor under it.
fn is_passed_at_the_side(placed: &Placed, body: &Body) -> bool {
    // Without ends that a multirotor could pass.
    const HIGH: f64 = 1e9;
    let column = match body.clone() {
        Body::Prism { corners, .. } => Body::Prism { corners, bottom: -HIGH, top: HIGH },
        Body::Cylinder { centre, radius, .. } => Body::Cylinder { centre, radius, bottom: -HIGH, top: HIGH },
        Body::Ball { centre: [x, y, _], radius } => Body::Cylinder { centre: [x, y], radius, bottom: -HIGH, top: HIGH },
        Body::HalfSpace { .. } => return false,
    };
    instants(placed, MEASURED).into_iter().all(|t| column.separation(placed.position(t)).distance > 0.0)
}
