//! Volumes: what a `keep_in` or `keep_out` is, the limits that it imposes, and the ways around it.

pub mod corridor;
pub mod passage;
pub mod reach;
pub mod split;

use super::{DistanceFrom, Limit, LimitKind, Quantity, Rotor, Vehicle, Waypoint};
use crate::body::{Body, Obstacle};
use crate::source::Span;
use std::sync::Arc;

/// Whether the vehicle stays inside or outside.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    KeepIn,
    KeepOut,
}

impl Side {
    /// The keyword of its block.
    pub fn keyword(self) -> &'static str {
        match self {
            Side::KeepIn => "keep_in",
            Side::KeepOut => "keep_out",
        }
    }
}

/// A volume in which the vehicle stays, or which it does not enter.
#[derive(Debug, Clone, PartialEq)]
pub struct Volume {
    pub name: String,
    pub side: Side,
    /// Convex bodies whose union is the volume; a `keep_in` has one.
    pub bodies: Vec<Body>,
    /// Distance from the boundary that is kept in addition to the vehicle's size, m.
    pub clearance: f64,
    pub span: Span,
}

/// The volume or corridor to which a limit belongs.
#[derive(Debug, Clone, PartialEq)]
pub struct Boundary {
    /// The name in messages: `keep_in field`, `corridor to waypoint 3`.
    pub name: String,
    /// Half the width of a corridor, m; `None` for a volume, which has none.
    pub half_width: Option<f64>,
}

/// A normal whose other components are below this is that of an axis.
const ALONG_AN_AXIS: f64 = 1e-15;

impl Volume {
    /// The limits on the centre of gravity of a vehicle of this size (m): bodies of a `keep_in` shrunk, and those of a
    /// `keep_out` grown, by the size and the clearance.
    pub fn limits(&self, size: f64) -> Vec<Limit> {
        let margin = size + self.clearance;
        match self.side {
            Side::KeepIn => self.bodies.iter().flat_map(|body| self.inside(body, margin)).collect(),
            Side::KeepOut => {
                let beyond = |body: &Body| {
                    self.limit(LimitKind::Clearance(Arc::new(Obstacle::of(body.clone()))), Some(margin), None)
                };
                self.bodies.iter().map(beyond).collect()
            }
        }
    }

    /// The name in messages: `keep_in field`.
    pub fn full_name(&self) -> String {
        format!("{} {}", self.side.keyword(), self.name)
    }

    fn limit(&self, kind: LimitKind, lower: Option<f64>, upper: Option<f64>) -> Limit {
        let name = self.full_name();
        Limit {
            kind,
            lower,
            upper,
            span: self.span,
            volume: Some(Arc::new(Boundary { name, half_width: None })),
            leg: None,
        }
    }

    fn inside(&self, body: &Body, margin: f64) -> Vec<Limit> {
        match body {
            Body::Prism { corners, bottom, top } => {
                let sides = corners.iter().enumerate().map(|(i, a)| {
                    let b = corners[(i + 1) % corners.len()];
                    let (x, y) = (b[1] - a[1], a[0] - b[0]);
                    let length = x.hypot(y);
                    let normal = [x / length, y / length, 0.0];
                    self.face(normal, normal[0] * a[0] + normal[1] * a[1] - margin)
                });
                sides.chain([self.layer(*bottom, *top, margin)]).collect()
            }
            Body::Cylinder { centre, radius, bottom, top } => {
                let round = LimitKind::Distance(DistanceFrom::Axis(*centre));
                vec![self.limit(round, None, Some(radius - margin)), self.layer(*bottom, *top, margin)]
            }
            Body::Ball { centre, radius } => {
                vec![self.limit(LimitKind::Distance(DistanceFrom::Point(*centre)), None, Some(radius - margin))]
            }
            Body::HalfSpace { normal, offset } => vec![self.face(*normal, offset - margin)],
        }
    }

    /// The limits on height.
    fn layer(&self, bottom: f64, top: f64, margin: f64) -> Limit {
        self.limit(LimitKind::Z, Some(bottom + margin), Some(top - margin))
    }

    /// `normal . p <= offset`; a bound on one coordinate where the normal is that of an axis.
    fn face(&self, normal: [f64; 3], offset: f64) -> Limit {
        let kinds = [LimitKind::X, LimitKind::Y, LimitKind::Z];
        let along = |axis: usize| (0..3).all(|other| other == axis || normal[other].abs() < ALONG_AN_AXIS);
        match (0..3).find(|&axis| along(axis)) {
            Some(axis) if normal[axis] > 0.0 => self.limit(kinds[axis].clone(), None, Some(offset)),
            Some(axis) => self.limit(kinds[axis].clone(), Some(-offset), None),
            None => self.limit(LimitKind::Face(normal), None, Some(offset)),
        }
    }
}

impl DistanceFrom {
    /// The distance of the position `p`, m.
    pub fn distance(&self, p: [f64; 3]) -> f64 {
        match *self {
            DistanceFrom::Point(centre) => (0..3).map(|i| (p[i] - centre[i]).powi(2)).sum::<f64>().sqrt(),
            DistanceFrom::Axis(centre) => (p[0] - centre[0]).hypot(p[1] - centre[1]),
            DistanceFrom::Line { point, along } => {
                let from: [f64; 3] = std::array::from_fn(|i| p[i] - point[i]);
                let ahead: f64 = (0..3).map(|i| from[i] * along[i]).sum();
                (0..3).map(|i| (from[i] - ahead * along[i]).powi(2)).sum::<f64>().sqrt()
            }
        }
    }

    /// The point of the first coordinates from which the distance is measured; `None` for a line in space.
    pub fn centre(&self) -> Option<&[f64]> {
        match self {
            DistanceFrom::Point(centre) => Some(centre),
            DistanceFrom::Axis(centre) => Some(centre),
            DistanceFrom::Line { .. } => None,
        }
    }
}

impl Limit {
    /// The value of the bounded quantity at the position `p` (m), for a limit on positions; `None` for any other limit.
    pub fn value_at(&self, p: [f64; 3]) -> Option<f64> {
        match self.kind.describe().quantity {
            Quantity::Axis { axis, order: 0, sign } => p.get(axis).map(|value| sign * value),
            Quantity::Along(normal) => Some((0..3).map(|i| normal[i] * p[i]).sum()),
            Quantity::Distance(from) => Some(from.distance(p)),
            Quantity::Clearance(obstacle) => Some(obstacle.body.separation(p).distance),
            Quantity::Axis { .. } | Quantity::Norm { .. } | Quantity::Tilt => None,
            Quantity::Arrival(_) | Quantity::Heading(_) => None,
        }
    }

    /// By how much the position `p` (m) violates a limit on positions, m; negative inside. `None` for any other limit.
    pub fn violation_at(&self, p: [f64; 3]) -> Option<f64> {
        let value = self.value_at(p)?;
        let over = self.upper.map_or(f64::NEG_INFINITY, |upper| value - upper);
        Some(over.max(self.lower.map_or(f64::NEG_INFINITY, |lower| lower - value)))
    }

    /// Whether the position `p` (m) is so far from the body that the limit keeps away from that [`Self::violation_at`]
    /// is surely below `violation` (m), by a quick test that need not find it out.
    pub fn is_violated_by_less(&self, p: [f64; 3], violation: f64) -> bool {
        match (&self.kind, self.lower) {
            (LimitKind::Clearance(obstacle), Some(lower)) => obstacle.around.is_further(p, lower - violation),
            _ => false,
        }
    }

    /// The name in messages: the volume or corridor, or the limited quantity, with its leg if it holds on one.
    pub fn name(&self) -> &str {
        match (&self.volume, &self.leg) {
            (Some(volume), _) => &volume.name,
            (None, Some(on)) => &on.name,
            (None, None) => self.kind.describe().name,
        }
    }
}

impl Vehicle {
    /// The radius about the centre of gravity within which the vehicle stays, m: `size`, or the largest arm plus the
    /// propeller's radius as far as these are known.
    pub fn radius(&self) -> f64 {
        let arm = |rotor: &Rotor| rotor.position.iter().map(|x| x * x).sum::<f64>().sqrt();
        let longest = || self.rotors.iter().map(arm).fold(0.0, f64::max);
        self.size.unwrap_or_else(|| longest() + self.propeller_radius.unwrap_or(0.0))
    }
}

/// The name of a waypoint in messages: its own, `the start` for index 0, otherwise its number from 1.
pub fn which(index: usize, waypoint: &Waypoint) -> String {
    match &waypoint.name {
        Some(name) => format!("waypoint `{name}`"),
        None if index == 0 => "the start".to_string(),
        None => format!("waypoint {}", index + 1),
    }
}
