//! Volumes: the `keep_in` and `keep_out` blocks of a mission, and the limits that they impose.

mod corridor;
mod impose;
pub mod passage;
mod reach;
mod read;
mod split;

pub(super) use impose::{impose, only_in_the_exact_model, which};
pub(super) use read::{is_one, read};

use super::{Limit, LimitKind, Rotor, Vehicle};
use crate::geometry::body::{Body, BoundingBox};
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

/// What a limit that belongs to a volume or a corridor bounds.
#[derive(Debug, Clone, PartialEq)]
pub struct Boundary {
    /// As messages name it: `keep_in field`, `corridor to waypoint 3`.
    pub name: String,
    pub quantity: Bounded,
    /// Half the width of a corridor, m; infinite for a volume.
    pub half_width: f64,
    /// Of a quantity that is the distance from a body: the box about the body.
    pub around: Option<BoundingBox>,
}

/// A quantity of the position p.
#[derive(Debug, Clone, PartialEq)]
pub enum Bounded {
    /// A coordinate: the limit has the kind `X`, `Y` or `Z`.
    Coordinate,
    /// `normal . p`, for a unit normal.
    Along([f64; 3]),
    /// The distance of p from a point.
    From([f64; 3]),
    /// The distance of (x, y) from a point.
    FromAxis([f64; 2]),
    /// The distance of p from the line through `point` along the unit vector `along`.
    FromLine { point: [f64; 3], along: [f64; 3] },
    /// The distance of p from a body.
    FromBody(Body),
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
                    self.limit(LimitKind::Clearance, (Some(margin), None), Bounded::FromBody(body.clone()))
                };
                self.bodies.iter().map(beyond).collect()
            }
        }
    }

    fn limit(&self, kind: LimitKind, (lower, upper): (Option<f64>, Option<f64>), quantity: Bounded) -> Limit {
        let name = format!("{} {}", self.side.keyword(), self.name);
        let around = match &quantity {
            Bounded::FromBody(body) => Some(BoundingBox::of(body)),
            _ => None,
        };
        Limit {
            kind,
            lower,
            upper,
            span: self.span,
            volume: Some(Arc::new(Boundary { name, quantity, half_width: f64::INFINITY, around })),
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
                sides.chain([self.between(*bottom, *top, margin)]).collect()
            }
            Body::Cylinder { centre, radius, bottom, top } => {
                let round = Bounded::FromAxis(*centre);
                vec![
                    self.limit(LimitKind::Distance, (None, Some(radius - margin)), round),
                    self.between(*bottom, *top, margin),
                ]
            }
            Body::Ball { centre, radius } => {
                vec![self.limit(LimitKind::Distance, (None, Some(radius - margin)), Bounded::From(*centre))]
            }
            Body::HalfSpace { normal, offset } => vec![self.face(*normal, offset - margin)],
        }
    }

    fn between(&self, bottom: f64, top: f64, margin: f64) -> Limit {
        self.limit(LimitKind::Z, (Some(bottom + margin), Some(top - margin)), Bounded::Coordinate)
    }

    /// `normal . p <= offset`; a bound on one coordinate where the normal is that of an axis.
    fn face(&self, normal: [f64; 3], offset: f64) -> Limit {
        let kinds = [LimitKind::X, LimitKind::Y, LimitKind::Z];
        let along = |axis: usize| (0..3).all(|other| other == axis || normal[other].abs() < ALONG_AN_AXIS);
        match (0..3).find(|&axis| along(axis)) {
            Some(axis) if normal[axis] > 0.0 => self.limit(kinds[axis], (None, Some(offset)), Bounded::Coordinate),
            Some(axis) => self.limit(kinds[axis], (Some(-offset), None), Bounded::Coordinate),
            None => self.limit(LimitKind::Face, (None, Some(offset)), Bounded::Along(normal)),
        }
    }
}

impl Limit {
    /// The value of the bounded quantity at the position `p` (m), for a limit on positions; `None` for any other limit.
    pub fn value_at(&self, p: [f64; 3]) -> Option<f64> {
        Some(match (self.kind, self.volume.as_deref().map(|v| &v.quantity)) {
            (LimitKind::X, _) => p[0],
            (LimitKind::Y, _) => p[1],
            (LimitKind::Z, _) => p[2],
            (_, Some(Bounded::Along(normal))) => (0..3).map(|i| normal[i] * p[i]).sum(),
            (_, Some(Bounded::From(centre))) => (0..3).map(|i| (p[i] - centre[i]).powi(2)).sum::<f64>().sqrt(),
            (_, Some(Bounded::FromAxis(centre))) => (p[0] - centre[0]).hypot(p[1] - centre[1]),
            (_, Some(Bounded::FromLine { point, along })) => {
                let from: [f64; 3] = std::array::from_fn(|i| p[i] - point[i]);
                let ahead: f64 = (0..3).map(|i| from[i] * along[i]).sum();
                (0..3).map(|i| (from[i] - ahead * along[i]).powi(2)).sum::<f64>().sqrt()
            }
            (_, Some(Bounded::FromBody(body))) => body.separation(p).distance,
            _ => return None,
        })
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
        let around = self.volume.as_deref().and_then(|volume| volume.around);
        around.zip(self.lower).is_some_and(|(around, lower)| around.is_further(p, lower - violation))
    }

    /// As messages name it: the volume or corridor, or the limited quantity, and its leg if it holds on one.
    pub fn name(&self) -> &str {
        match (&self.volume, &self.leg) {
            (Some(volume), _) => &volume.name,
            (None, Some(on)) => &on.name,
            (None, None) => self.kind.name_and_unit().0,
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
