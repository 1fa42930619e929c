//! The largest steady airspeed in level flight. See `docs/method/air.md`, "Airspeed".

use super::edge;
use super::interval::guaranteed;
use super::verdict::lift;
use super::{AdmissibleSet, FacetOf};
use crate::actuation::Wrench;
use crate::flatness::rotor_drag;
use crate::geometry::polytope::Polytope;
use crate::model::{Environment, LimitKind, Model};
use serde::Serialize;
use std::f64::consts::FRAC_PI_2;

/// The largest steady airspeed of a mode in level flight.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Airspeed {
    /// The airspeed, m/s; null if the mode cannot hover.
    pub largest_m_per_s: Option<f64>,
    /// What prevents a larger one; null if the mode cannot hover.
    pub limited_by: Option<LimitedBy>,
    /// Whether the mode flies at it with yaw given up only.
    pub without_yaw: bool,
}

/// The largest airspeed at which a drag that grows in proportion to it is plausible, m/s. Such a drag is that of the
/// rotors, measured at a few metres a second; that of the body grows with the square. Fast multirotors fly at 30 to
/// 40 m/s.
pub const PLAUSIBLE: f64 = 40.0;

/// What limits the airspeed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum LimitedBy {
    /// The thrust that leaves the reserve.
    Thrust,
    /// The mission's limit on tilt.
    Tilt,
}

impl Airspeed {
    /// The airspeed of a mode with the plan's reserve; `None` for a vehicle without drag.
    ///
    /// At a constant horizontal velocity u through the air, without a vertical one, the thrust is
    /// `sqrt((m g)^2 + (drag u)^2)` and the torques vanish. This wrench must lie in the mode's set, shrunk by the
    /// reserve about hover in still air; in still air this is the set of [`AdmissibleSet::with_reserve`]. Where the
    /// vehicle has intervals, the airspeed is possible for every value of them.
    ///
    /// With a drag for each axis of the body it is the largest one up to which the thrust (90c) is in the set whatever
    /// the angle between nose and motion, by `in_the_worst_heading`. Drag along z alone does not act in level flight:
    /// `None`.
    ///
    /// # Panics
    /// If the set is not of this model.
    pub fn of(model: &Model, set: &AdmissibleSet) -> Option<Self> {
        let [drag, across, _] = model.vehicle.drag;
        if drag <= 0.0 && across <= 0.0 {
            return None;
        }
        let rows =
            if model.vehicle.has_uncertain_rotors() { guaranteed(model, set) } else { Some(set.polytope.clone()) };
        let size = set.zonotope.scale()[0];
        let with_yaw = Self::between(model, rows.as_ref().and_then(|rows| lift(rows, size)));
        if with_yaw.largest_m_per_s.is_some() {
            return Some(with_yaw);
        }
        let without_yaw = rows.and_then(|rows| lift_without_yaw(model, &rows, size));
        let found = Self::between(model, without_yaw);
        Some(Airspeed { without_yaw: found.largest_m_per_s.is_some(), ..found })
    }

    /// The airspeed with thrusts without torques between two, N.
    fn between(model: &Model, full: Option<(f64, f64)>) -> Self {
        let [drag, ..] = model.vehicle.drag;
        // In still air only the products of drag and airspeed matter: of an interval the largest drag gives the least.
        let slower = model.vehicle.drag_spread.high;
        let is_isotropic = model.environment().is_isotropic();
        // Thrust decides by a concave function of the mass, tilt by a monotone one: the least is at an end of the
        // interval.
        let spread = model.vehicle.mass_spread;
        let ends = [spread.low, spread.high].map(|share| {
            let weight = share * model.vehicle.mass * model.gravity;
            let (low, high) = full?;
            let (least, most) = thrusts(weight, low, high, model.plan.reserve)?;
            let by_thrust = match is_isotropic {
                // The largest horizontal component of a thrust whose vertical one holds the weight.
                true => (most * most - weight * weight).sqrt() / drag,
                false => in_the_worst_heading(model, least, most),
            };
            let by_tilt = least_tilt(model).map_or(f64::INFINITY, |tilt| weight * tilt.tan() / drag);
            Some(match by_tilt < by_thrust {
                true => (by_tilt / slower, LimitedBy::Tilt),
                false => (by_thrust / slower, LimitedBy::Thrust),
            })
        });
        let least = match ends {
            [Some(light), Some(heavy)] => Some(if light.0 < heavy.0 { light } else { heavy }),
            _ => None,
        };
        Airspeed { largest_m_per_s: least.map(|l| l.0), limited_by: least.map(|l| l.1), without_yaw: false }
    }
}

/// The lowest and the highest thrust without roll and pitch torques (N) of rows, with whatever yaw torque; `None` if
/// that of hover is not possible. `size` is above all thrusts.
fn lift_without_yaw(model: &Model, rows: &Polytope<4, FacetOf>, size: f64) -> Option<(f64, f64)> {
    let weight = model.vehicle.mass * model.gravity;
    let level = |thrust: f64| Wrench::new(thrust, 0.0, 0.0, 0.0);
    let edge = edge::width(&level(weight));
    let is_possible = |thrust: f64| rows.chord(&level(thrust), &Wrench::new(0.0, 0.0, 0.0, 1.0), edge).is_some();
    let end = |mut outside: f64| {
        let mut inside = weight;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (inside + outside);
            if is_possible(middle) { inside = middle } else { outside = middle }
        }
        inside
    };
    is_possible(weight).then(|| (end(0.0), end(size)))
}

/// The smallest and the largest thrust (N) between the lowest and the highest of the set (N) that leave the reserve
/// about a weight (N); `None` if the weight is not between these.
fn thrusts(weight: f64, low: f64, high: f64, reserve: f64) -> Option<(f64, f64)> {
    let edge = edge::width(&Wrench::new(weight, 0.0, 0.0, 0.0));
    if weight < low - edge || weight > high + edge {
        return None;
    }
    let kept = |room: f64| (1.0 - reserve) * room.max(0.0);
    Some((weight - kept(weight - low), weight + kept(high - weight)))
}

/// Headings relative to the motion at which the airspeed is computed, in a quarter turn: the drag is the same in all
/// four.
const HEADINGS: usize = 18;

/// The speeds at which the search begins and ends, m/s, and the ratio of one speed to the one before.
const SPEEDS: (f64, f64, f64) = (0.01, 1000.0, 1.05);

/// Halvings of the interval between two such speeds, down to rounding.
const HALVINGS: usize = 50;

/// The largest speed (m/s) of steady level flight up to which the thrust is between `least` and `most` (N) whatever the
/// angle between nose and motion, sampled at [`HEADINGS`]; the last of [`SPEEDS`] if the thrust never leaves this
/// range.
fn in_the_worst_heading(model: &Model, least: f64, most: f64) -> f64 {
    let still = Environment { wind: [0.0; 3], ..model.environment() };
    let edge = edge::width(&Wrench::new(most, 0.0, 0.0, 0.0));
    let is_possible = |speed: f64| {
        (0..=HEADINGS).all(|k| {
            let off = FRAC_PI_2 * k as f64 / HEADINGS as f64;
            let thrust = model.vehicle.mass * rotor_drag::attitude(&still, [speed, 0.0, 0.0], [0.0; 3], off).thrust;
            (least - edge..=most + edge).contains(&thrust)
        })
    };
    let (first, last, ratio) = SPEEDS;
    let (mut low, mut high) = (0.0, first);
    while is_possible(high) {
        if high >= last {
            return last;
        }
        (low, high) = (high, (ratio * high).min(last));
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if is_possible(middle) { low = middle } else { high = middle }
    }
    low
}

/// The smallest upper limit on tilt of the whole mission, rad; `None` if there is none below a right angle.
fn least_tilt(model: &Model) -> Option<f64> {
    let limits = model.mission.iter().flat_map(|mission| &mission.limits);
    let general = limits.filter(|limit| limit.kind == LimitKind::Tilt && limit.is_general());
    let upper = general.filter_map(|limit| limit.upper);
    upper.filter(|tilt| *tilt < FRAC_PI_2).min_by(f64::total_cmp)
}
