//! KML 2.2 (OGC 07-147r2): the path and its ground projection as lines, waypoints as points, volumes as their top,
//! bottom and sides.

use super::{Placed, outline};
use crate::geodesy::heading_of_yaw;
use crate::number::{fixed, number};
use std::fmt::Write;

pub fn text(placed: &Placed, line: &[[f64; 3]]) -> String {
    let mission = placed.mission;
    let mut out = String::from(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<kml xmlns=\"http://www.opengis.net/kml/2.2\">\n<Document>\n",
    );
    let _ = writeln!(out, "<name>{}</name>", escaped(&mission.name));
    for (id, colour, width, fill) in STYLES {
        let _ = writeln!(
            out,
            "<Style id=\"{id}\"><LineStyle><color>{colour}</color><width>{width}</width></LineStyle>\
             <PolyStyle><color>{fill}</color></PolyStyle></Style>"
        );
    }
    let said = format!("{} s; heights above mean sea level", number(placed.trajectory.duration()));
    lines(&mut out, "path", &said, "absolute", &coordinates(placed, line, true));
    lines(
        &mut out,
        "footprint",
        "the ground projection of the path",
        "clampToGround",
        &coordinates(placed, line, false),
    );
    out.push_str("<Folder><name>waypoints</name>\n");
    for (k, waypoint) in mission.waypoints.iter().enumerate() {
        let Some(time) = placed.trajectory.waypoint_nodes.get(k).map(|node| placed.trajectory.times[*node]) else {
            continue;
        };
        let _ = writeln!(
            out,
            "<Placemark><name>{}</name><description>{} s, heading {} deg, hold {} s</description><Point>\
             <altitudeMode>absolute</altitudeMode><coordinates>{}</coordinates></Point></Placemark>",
            escaped(&outline::name(mission, k)),
            number(time),
            number(heading_of_yaw(waypoint.yaw)),
            number(waypoint.hold),
            coordinates(placed, &[waypoint.position], true),
        );
    }
    out.push_str("</Folder>\n");
    volumes(&mut out, placed);
    out.push_str("</Document>\n</kml>\n");
    out
}

/// Name, colour (aabbggrr), width in pixels and colour of areas.
const STYLES: [(&str, &str, u8, &str); 4] = [
    ("path", "ffd47f00", 3, "00000000"),
    ("footprint", "99666666", 2, "00000000"),
    ("keep_in", "ff3c9632", 2, "203c9632"),
    ("keep_out", "ff2828c8", 2, "402828c8"),
];

fn lines(out: &mut String, name: &str, description: &str, mode: &str, coordinates: &str) {
    let _ = writeln!(
        out,
        "<Placemark><name>{name}</name><description>{description}</description><styleUrl>#{name}</styleUrl><LineString>\
         <tessellate>1</tessellate><altitudeMode>{mode}</altitudeMode><coordinates>{coordinates}</coordinates>\
         </LineString></Placemark>"
    );
}

fn volumes(out: &mut String, placed: &Placed) {
    out.push_str("<Folder><name>volumes</name>\n");
    for volume in &placed.mission.volumes {
        let bodies: Vec<_> = volume.bodies.iter().filter_map(outline::of).collect();
        if bodies.len() < volume.bodies.len() {
            continue;
        }
        let keyword = outline::keyword(volume);
        let _ = write!(
            out,
            "<Placemark><name>{keyword} {}</name><styleUrl>#{keyword}</styleUrl><MultiGeometry>",
            escaped(&volume.name)
        );
        for body in bodies {
            let level = |height: f64| body.corners.iter().map(|[x, y]| [*x, *y, height]).collect::<Vec<_>>();
            face(out, placed, &level(body.top));
            face(out, placed, &level(body.bottom));
            let n = body.corners.len();
            for k in 0..n {
                let [[ax, ay], [bx, by]] = [body.corners[k], body.corners[(k + 1) % n]];
                let side = [[ax, ay, body.bottom], [bx, by, body.bottom], [bx, by, body.top], [ax, ay, body.top]];
                face(out, placed, &side);
            }
        }
        out.push_str("</MultiGeometry></Placemark>\n");
    }
    out.push_str("</Folder>\n");
}

/// A polygon, whose first corner KML repeats at the end.
fn face(out: &mut String, placed: &Placed, corners: &[[f64; 3]]) {
    let closed: Vec<[f64; 3]> = corners.iter().chain(corners.first()).copied().collect();
    let _ = write!(
        out,
        "<Polygon><altitudeMode>absolute</altitudeMode><outerBoundaryIs><LinearRing><coordinates>{}</coordinates>\
         </LinearRing></outerBoundaryIs></Polygon>",
        coordinates(placed, &closed, true)
    );
}

/// `longitude,latitude[,height]` for each point.
fn coordinates(placed: &Placed, points: &[[f64; 3]], with_height: bool) -> String {
    let one = |p: &[f64; 3]| {
        let spot = placed.spot(*p);
        let place = format!("{},{}", fixed(spot.longitude, 9), fixed(spot.latitude, 9));
        if with_height { format!("{place},{}", fixed(spot.height, 3)) } else { place }
    };
    points.iter().map(one).collect::<Vec<_>>().join(" ")
}

/// Names are letters, digits and `_` in a spec; those of a table may be anything.
fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    text.chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect()
}
