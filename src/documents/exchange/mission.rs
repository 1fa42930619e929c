//! Plans as missions of ground stations (`qgc-plan`, `wpl`) and on maps (`kml`, `geojson`): one module for each format.

mod geojson;
mod items;
mod kml;
mod outline;
mod polyline;
mod qgc_plan;
mod wpl;

use super::Written;
use crate::geodesy::{Geodetic, TangentPlane};
use crate::model::{Mission, Model, Origin};
use crate::motion::{Trajectory, X, Y, Z};
use crate::number::significant;
use items::Items;

/// The largest distance (m) of the plan from the straight lines between items, unless it is given.
pub const ITEMS_WITHIN: f64 = 0.5;
/// The largest distance (m) of the plan from lines on maps, unless it is given.
pub const LINES_WITHIN: f64 = 0.1;

/// A plan and its place on the Earth.
struct Placed<'a> {
    trajectory: &'a Trajectory,
    mission: &'a Mission,
    plane: TangentPlane,
    /// Largest distance of the plan from straight lines, m.
    tolerance: f64,
}

/// The mission and its place on the Earth.
///
/// # Errors
/// The mission does not say where it is.
pub fn origin<'a>(model: &'a Model, format: &str) -> Result<(&'a Mission, Origin), String> {
    let mission = model.mission.as_ref().ok_or("the spec has no mission")?;
    mission.origin.map(|origin| (mission, origin)).ok_or_else(|| {
        format!(
            "--format {format} has places on the Earth, and mission `{}` does not say where it is: give its \
             `origin_latitude`, `origin_longitude` and `origin_altitude`",
            mission.name
        )
    })
}

/// A place as it is written: degrees, and m above mean sea level.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Spot {
    latitude: f64,
    longitude: f64,
    height: f64,
}

/// Degrees are written to 1e-9, 0.1 mm, heights to 1 mm.
fn rounded(x: f64, per_unit: f64) -> f64 {
    let rounded = (x * per_unit).round() / per_unit;
    // Without a negative zero.
    rounded + 0.0
}

fn spot(plane: &TangentPlane, p: [f64; 3]) -> Spot {
    let Geodetic { latitude, longitude, height } = plane.place(p);
    let [latitude, longitude] = [latitude, longitude].map(|angle| rounded(angle.to_degrees(), 1e9));
    Spot { latitude, longitude, height: rounded(height, 1e3) }
}

fn plane_of(origin: Origin) -> TangentPlane {
    TangentPlane::at(Geodetic { latitude: origin.latitude, longitude: origin.longitude, height: origin.altitude })
}

/// A way out on a map.
pub struct Footprint<'b> {
    /// The file with its table.
    pub file: String,
    pub mode: &'b str,
    pub outcome: &'b str,
    /// The instant of the fault, s since the start of the plan.
    pub fault_s: f64,
    pub motion: &'b Trajectory,
}

/// The ground projections of ways out as GeoJSON; `None` if the mission does not say where it is.
pub fn footprints(mission: &Mission, branches: &[Footprint]) -> Option<String> {
    Some(geojson::footprints(&plane_of(mission.origin?), branches))
}

impl<'a> Placed<'a> {
    fn new(trajectory: &'a Trajectory, model: &'a Model, tolerance: f64, format: &str) -> Result<Self, String> {
        let (mission, origin) = origin(model, format)?;
        Ok(Placed { trajectory, mission, plane: plane_of(origin), tolerance })
    }

    fn spot(&self, p: [f64; 3]) -> Spot {
        spot(&self.plane, p)
    }

    fn local(&self, spot: Spot) -> [f64; 3] {
        self.plane.local(&Geodetic::degrees(spot.latitude, spot.longitude, spot.height))
    }

    /// The origin of the spec.
    fn home(&self) -> Spot {
        self.spot([0.0; 3])
    }

    fn position(&self, t: f64) -> [f64; 3] {
        let state = self.trajectory.at(t);
        [X, Y, Z].map(|axis| state[axis][0])
    }
}

/// A plan of QGroundControl.
///
/// # Errors
/// The mission does not say where it is, or needs too many items.
pub fn qgc_plan(trajectory: &Trajectory, model: &Model, tolerance: Option<f64>) -> Result<Written, String> {
    let placed = Placed::new(trajectory, model, tolerance.unwrap_or(ITEMS_WITHIN), "qgc-plan")?;
    let items = Items::of(&placed)?;
    let (text, fences) = qgc_plan::text(&placed, &items);
    Ok(said(text, items.all.len(), &items, fences))
}

/// A mission of MAVLink in plain text, `QGC WPL 110`.
///
/// # Errors
/// The mission does not say where it is, or needs too many items.
pub fn wpl(trajectory: &Trajectory, model: &Model, tolerance: Option<f64>) -> Result<Written, String> {
    let placed = Placed::new(trajectory, model, tolerance.unwrap_or(ITEMS_WITHIN), "wpl")?;
    let items = Items::of(&placed)?;
    let volumes = placed.mission.volumes.len();
    let fences = if volumes > 0 { "; volumes are lost, since the format has no fences" } else { "" };
    let (text, count) = wpl::text(&placed, &items);
    Ok(said(text, count, &items, fences.into()))
}

fn said(text: String, count: usize, items: &Items, fences: String) -> Written {
    let remark = format!(
        "{} items; straight lines between them are within {} m of the plan; the times of the plan are lost: the \
         autopilot chooses its own{}{fences}",
        count,
        significant(items.deviation, 3),
        if items.takes_off { "" } else { "; no take-off, since the plan does not begin with a climb above its origin" },
    );
    Written { bytes: text.into_bytes(), remark: Some(remark) }
}

/// A file of KML 2.2.
///
/// # Errors
/// The mission does not say where it is, or its path has too many corners.
pub fn kml(trajectory: &Trajectory, model: &Model, tolerance: Option<f64>) -> Result<Written, String> {
    on_a_map(trajectory, model, tolerance, "kml", kml::text)
}

/// A file of GeoJSON (RFC 7946).
///
/// # Errors
/// The mission does not say where it is, or its path has too many corners.
pub fn geojson(trajectory: &Trajectory, model: &Model, tolerance: Option<f64>) -> Result<Written, String> {
    on_a_map(trajectory, model, tolerance, "geojson", geojson::text)
}

fn on_a_map(
    trajectory: &Trajectory,
    model: &Model,
    tolerance: Option<f64>,
    format: &str,
    text: fn(&Placed, &[[f64; 3]]) -> String,
) -> Result<Written, String> {
    let placed = Placed::new(trajectory, model, tolerance.unwrap_or(LINES_WITHIN), format)?;
    let line = polyline::through(&placed)?;
    let points: Vec<[f64; 3]> = line.corners.iter().map(|corner| corner.position).collect();
    let unbounded: Vec<&str> = outline::unbounded(placed.mission);
    let left_out = match unbounded[..] {
        [] => String::new(),
        _ => format!("; half spaces have no outline and are left out: {}", unbounded.join(", ")),
    };
    let remark = format!("the line is within {} m of the plan{left_out}", significant(line.deviation, 3));
    Ok(Written { bytes: text(&placed, &points).into_bytes(), remark: Some(remark) })
}
