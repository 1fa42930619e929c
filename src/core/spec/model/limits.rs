//! Limits: the kinds, and of each kind what it bounds, its names, its unit, and how it follows from a motion. Planner,
//! measurements of motions and reports take it from here. CONTRIBUTING ("A new kind of limit or of fault") lists what a
//! kind needs.

use super::{Boundary, Obstacle, Target};
use crate::source::Span;
use std::f64::consts::PI;
use std::sync::Arc;

/// Upper end of the usual range of a speed limit, and of the speed of a plan without such a limit, m/s
/// (docs/diagnostics/sense.md).
pub const USUAL_SPEED: f64 = 60.0;

/// The quantity that a limit bounds, with what it is measured from.
#[derive(Debug, Clone, PartialEq)]
pub enum LimitKind {
    X,
    Y,
    /// `z` and `altitude`.
    Z,
    Yaw,
    Speed,
    SpeedHorizontal,
    Climb,
    Descent,
    Acceleration,
    AccelerationHorizontal,
    Jerk,
    YawRate,
    YawAcceleration,
    Tilt,
    /// The position along a unit vector: the normal of a face of a `keep_in`, or the axis of a corridor, m.
    Face([f64; 3]),
    /// The distance from the centre of a spherical `keep_in`, or from the axis of a cylindrical one or of a corridor,
    /// m.
    Distance(DistanceFrom),
    /// The distance from a body of a `keep_out`, m: a lower bound, and the only limit that is not convex.
    Clearance(Arc<Obstacle>),
    /// The angle between the velocity and this unit vector at the end of the leg, rad; without velocity there is none.
    Arrival([f64; 3]),
    /// The angle between the yaw and the direction of the target, rad, at nodes; where there is no such direction,
    /// nothing is bounded.
    Heading(Target),
}

/// What a distance is measured from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DistanceFrom {
    /// A point.
    Point([f64; 3]),
    /// The vertical line through (x, y).
    Axis([f64; 2]),
    /// The line through `point` along the unit vector `along`.
    Line { point: [f64; 3], along: [f64; 3] },
}

/// Where on its leg a limit holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// From the one waypoint to the other.
    Whole,
    /// At the first waypoint.
    Start,
    /// At the second waypoint.
    End,
}

/// The leg to which a limit is restricted.
#[derive(Debug, Clone, PartialEq)]
pub struct OnLeg {
    /// Index into [`super::Mission::legs`].
    pub leg: usize,
    pub part: Part,
    /// The limit as messages name it: `speed on the leg to waypoint 3`.
    pub name: String,
}

/// One limit, in SI units. `Speed`, `Acceleration`, `Jerk`, `Tilt` and the horizontal kinds bound a norm and have only
/// an `upper` bound. So do `Climb` and `Descent`, which bound the upward and the downward speed by a value that is not
/// negative. A single `<=` on `YawRate` or `YawAcceleration` bounds both directions (lower = -upper).
#[derive(Debug, Clone, PartialEq)]
pub struct Limit {
    pub kind: LimitKind,
    pub lower: Option<f64>,
    pub upper: Option<f64>,
    pub span: Span,
    /// The volume or corridor that imposes this limit; `None` for a limit that is written as one.
    pub volume: Option<Arc<Boundary>>,
    /// The leg on which the limit holds; `None` if it holds on all.
    pub leg: Option<Arc<OnLeg>>,
}

impl Limit {
    /// The scale of a violation, in the SI unit of the limit: the larger bound in magnitude, but at least 1; 1 m for a
    /// volume, whose distance from the origin says nothing about how well it is kept.
    pub fn size(&self) -> f64 {
        if self.volume.is_some() {
            return 1.0;
        }
        self.lower.into_iter().chain(self.upper).map(f64::abs).fold(1.0, f64::max)
    }

    /// Whether the limit holds on all legs.
    pub fn is_general(&self) -> bool {
        self.leg.is_none()
    }

    /// Whether the limit holds somewhere on a leg.
    pub fn concerns(&self, leg: usize) -> bool {
        self.leg.as_ref().is_none_or(|on| on.leg == leg)
    }
}

/// The quantity that a kind of limit bounds, as a function of the axes x, y, z and yaw (0 to 3).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity<'l> {
    /// `sign` times a derivative of an axis.
    Axis { axis: usize, order: usize, sign: f64 },
    /// The length of a vector of derivatives of axes.
    Norm { axes: &'static [usize], order: usize },
    /// The angle between the thrust and the vertical.
    Tilt,
    /// The position along a unit vector.
    Along([f64; 3]),
    /// The distance from a point or a line.
    Distance(DistanceFrom),
    /// The distance from a body.
    Clearance(&'l Obstacle),
    /// The angle between the velocity and a unit vector.
    Arrival([f64; 3]),
    /// The angle between the yaw and the direction of a target.
    Heading(Target),
}

impl Quantity<'_> {
    /// Whether it is a coordinate: x, y, z or yaw.
    pub fn is_coordinate(&self) -> bool {
        matches!(self, Quantity::Axis { order: 0, .. })
    }

    /// Whether it follows from position and yaw alone, and so does not depend on time.
    pub fn is_of_place(&self) -> bool {
        match self {
            Quantity::Axis { order, .. } | Quantity::Norm { order, .. } => *order == 0,
            Quantity::Along(_) | Quantity::Distance(_) | Quantity::Clearance(_) => true,
            Quantity::Tilt | Quantity::Arrival(_) | Quantity::Heading(_) => false,
        }
    }

    /// Whether it depends on the yaw.
    pub fn is_of_yaw(&self) -> bool {
        match self {
            Quantity::Axis { axis, .. } => *axis == 3,
            Quantity::Norm { axes, .. } => axes.contains(&3),
            Quantity::Heading(_) => true,
            Quantity::Tilt | Quantity::Along(_) | Quantity::Distance(_) => false,
            Quantity::Clearance(_) | Quantity::Arrival(_) => false,
        }
    }
}

/// How people name a kind of limit, and what it measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Description<'l> {
    /// The word of the language, or how `mavc emit model` names a kind without one.
    pub word: &'static str,
    /// In running text.
    pub name: &'static str,
    /// The unit in which reports show it.
    pub unit: &'static str,
    /// That unit in SI.
    pub unit_in_si: f64,
    pub quantity: Quantity<'l>,
}

impl Description<'_> {
    /// The factor from SI to the unit.
    pub fn factor(&self) -> f64 {
        if self.unit_in_si == 1.0 { 1.0 } else { 180.0 / PI }
    }
}

impl LimitKind {
    /// The one description of the kind.
    pub fn describe(&self) -> Description<'_> {
        const DEGREE: f64 = PI / 180.0;
        const SPACE: &[usize] = &[0, 1, 2];
        const PLANE: &[usize] = &[0, 1];
        let of = |word, name, unit, unit_in_si, quantity| Description { word, name, unit, unit_in_si, quantity };
        let axis = |axis, order, sign| Quantity::Axis { axis, order, sign };
        let norm = |axes, order| Quantity::Norm { axes, order };
        match self {
            LimitKind::X => of("x", "x", "m", 1.0, axis(0, 0, 1.0)),
            LimitKind::Y => of("y", "y", "m", 1.0, axis(1, 0, 1.0)),
            LimitKind::Z => of("z", "altitude", "m", 1.0, axis(2, 0, 1.0)),
            LimitKind::Yaw => of("yaw", "yaw", "deg", DEGREE, axis(3, 0, 1.0)),
            LimitKind::Speed => of("speed", "speed", "m/s", 1.0, norm(SPACE, 1)),
            LimitKind::SpeedHorizontal => of("speed_horizontal", "horizontal speed", "m/s", 1.0, norm(PLANE, 1)),
            LimitKind::Climb => of("climb", "climb", "m/s", 1.0, axis(2, 1, 1.0)),
            LimitKind::Descent => of("descent", "descent", "m/s", 1.0, axis(2, 1, -1.0)),
            LimitKind::Acceleration => of("acceleration", "acceleration", "m/s^2", 1.0, norm(SPACE, 2)),
            LimitKind::AccelerationHorizontal => {
                of("acceleration_horizontal", "horizontal acceleration", "m/s^2", 1.0, norm(PLANE, 2))
            }
            LimitKind::Jerk => of("jerk", "jerk", "m/s^3", 1.0, norm(SPACE, 3)),
            LimitKind::YawRate => of("yaw_rate", "yaw rate", "deg/s", DEGREE, axis(3, 1, 1.0)),
            LimitKind::YawAcceleration => {
                of("yaw_acceleration", "yaw acceleration", "deg/s^2", DEGREE, axis(3, 2, 1.0))
            }
            LimitKind::Tilt => of("tilt", "tilt", "deg", DEGREE, Quantity::Tilt),
            LimitKind::Face(normal) => {
                of("along the normal", "position across a face", "m", 1.0, Quantity::Along(*normal))
            }
            LimitKind::Distance(from) => {
                of("distance from the centre", "distance from the centre", "m", 1.0, Quantity::Distance(*from))
            }
            LimitKind::Clearance(obstacle) => {
                of("distance from the body", "distance from a body", "m", 1.0, Quantity::Clearance(obstacle))
            }
            LimitKind::Arrival(direction) => of(
                "angle to the direction of arrival",
                "direction of arrival",
                "deg",
                DEGREE,
                Quantity::Arrival(*direction),
            ),
            LimitKind::Heading(target) => {
                of("angle to the direction of the yaw", "yaw", "deg", DEGREE, Quantity::Heading(*target))
            }
        }
    }

    /// [`Quantity::is_of_place`]
    pub fn is_of_place(&self) -> bool {
        self.describe().quantity.is_of_place()
    }

    /// [`Quantity::is_of_yaw`]
    pub fn is_of_yaw(&self) -> bool {
        self.describe().quantity.is_of_yaw()
    }

    /// Whether it bounds the velocity of the vehicle.
    pub fn is_speed(&self) -> bool {
        matches!(self, LimitKind::Speed | LimitKind::SpeedHorizontal | LimitKind::Climb | LimitKind::Descent)
    }

    /// Whether it is the distance from a body to keep out of.
    pub fn is_clearance(&self) -> bool {
        matches!(self, LimitKind::Clearance(_))
    }

    /// Whether it is a yaw that follows from the motion.
    pub fn is_heading(&self) -> bool {
        matches!(self, LimitKind::Heading(_))
    }

    /// Whether it is a direction of arrival.
    pub fn is_arrival(&self) -> bool {
        matches!(self, LimitKind::Arrival(_))
    }
}
