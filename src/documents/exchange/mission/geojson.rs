//! GeoJSON (RFC 7946): the path and its ground projection as lines, waypoints as points, volumes as polygons with
//! heights.

use super::{Placed, outline};
use crate::geodesy::heading_of_yaw;
use serde_json::{Value, json};

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
    serde_json::to_string_pretty(&json!({ "type": "FeatureCollection", "features": features })).unwrap_or_default()
        + "\n"
}

fn feature(kind: &str, coordinates: Value, properties: Value) -> Value {
    json!({ "type": "Feature", "geometry": { "type": kind, "coordinates": coordinates }, "properties": properties })
}
