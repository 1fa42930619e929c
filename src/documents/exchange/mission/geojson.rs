//! GeoJSON (RFC 7946): the path and its ground projection as lines, waypoints as points, volumes, landing sites and
//! areas to keep off as polygons; and the ground projections of ways out.

use super::{Footprint, Placed, outline};
use crate::geodesy::{TangentPlane, heading_of_yaw};
use crate::model::LandingSite;
use crate::motion::{X, Y, Z};
use serde_json::{Value, json};

/// The time between two corners of the ground projection of a way out, s.
const FOOTPRINT_STEP: f64 = 0.25;

pub fn text(placed: &Placed, line: &[[f64; 3]]) -> String {
    let mission = placed.mission;
    let at = |p: &[f64; 3]| {
        let spot = placed.spot(*p);
        json!([spot.longitude, spot.latitude, spot.height])
    };
    let below = |[x, y]: [f64; 2], z: f64| {
        let spot = placed.spot([x, y, z]);
        json!([spot.longitude, spot.latitude])
    };
    let path: Vec<Value> = line.iter().map(at).collect();
    let footprint: Vec<Value> = line.iter().map(|[x, y, z]| below([*x, *y], *z)).collect();
    let mut features = vec![
        feature(
            "LineString",
            json!(path),
            json!({ "name": "path", "mission": mission.name, "duration_s": placed.trajectory.duration(),
                    "heights": "m above mean sea level" }),
        ),
        feature("LineString", json!(footprint), json!({ "name": "footprint", "mission": mission.name })),
    ];
    for (k, waypoint) in mission.waypoints.iter().enumerate() {
        let Some(node) = placed.trajectory.waypoint_nodes.get(k) else { continue };
        let properties = json!({
            "waypoint": outline::name(mission, k),
            "time_s": placed.trajectory.times[*node],
            "heading_deg": super::rounded(heading_of_yaw(waypoint.yaw), 1e3),
            "hold_s": waypoint.hold,
        });
        features.push(feature("Point", at(&waypoint.position), properties));
    }
    for volume in &mission.volumes {
        let bodies: Vec<_> = volume.bodies.iter().filter_map(outline::of).collect();
        if bodies.len() < volume.bodies.len() {
            continue;
        }
        for body in bodies {
            let ring: Vec<Value> =
                body.corners.iter().chain(body.corners.first()).map(|corner| below(*corner, body.top)).collect();
            let height = |z: f64| super::rounded(placed.plane.origin().height + z, 1e3);
            let properties = json!({
                "name": volume.name, "kind": outline::keyword(volume),
                "bottom_m": height(body.bottom), "top_m": height(body.top), "clearance_m": volume.clearance,
            });
            features.push(feature("Polygon", json!([ring]), properties));
        }
    }
    let ring = |corners: &[[f64; 2]], z: f64| -> Vec<Value> {
        corners.iter().chain(corners.first()).map(|corner| below(*corner, z)).collect()
    };
    for LandingSite { name, at, radius, .. } in &mission.after_fault.sites {
        let properties = json!({ "name": name, "kind": "landing_site", "radius_m": radius });
        features.push(feature("Polygon", json!([ring(&outline::circle([at[0], at[1]], *radius), at[2])]), properties));
    }
    for area in &mission.after_fault.keep_off {
        for body in area.bodies.iter().filter_map(outline::of) {
            let properties = json!({ "name": area.name, "kind": "keep_off", "clearance_m": area.clearance });
            features.push(feature("Polygon", json!([ring(&body.corners, mission.ground.unwrap_or(0.0))]), properties));
        }
    }
    collection(&features)
}

/// The ground projections of ways out, one line each.
pub fn footprints(plane: &TangentPlane, branches: &[Footprint]) -> String {
    let line = |branch: &Footprint| {
        let steps = (branch.motion.duration() / FOOTPRINT_STEP).ceil().max(1.0);
        let corner = |k: usize| {
            let state = branch.motion.at(branch.motion.duration() * k as f64 / steps);
            let spot = super::spot(plane, [X, Y, Z].map(|axis| state[axis][0]));
            json!([spot.longitude, spot.latitude])
        };
        let corners: Vec<Value> = (0..=steps as usize).map(corner).collect();
        let properties = json!({
            "file": branch.file, "mode": branch.mode, "outcome": branch.outcome, "fault_s": branch.fault_s,
        });
        feature("LineString", json!(corners), properties)
    };
    collection(&branches.iter().map(line).collect::<Vec<_>>())
}

fn collection(features: &[Value]) -> String {
    serde_json::to_string_pretty(&json!({ "type": "FeatureCollection", "features": features })).unwrap_or_default()
        + "\n"
}

fn feature(kind: &str, coordinates: Value, properties: Value) -> Value {
    json!({ "type": "Feature", "geometry": { "type": kind, "coordinates": coordinates }, "properties": properties })
}
