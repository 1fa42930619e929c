//! The largest steady airspeed in level flight. See `docs/method.md`, section 15, "Airspeed".

use super::AdmissibleSet;
use super::edge;
use super::interval::guaranteed;
use super::verdict::lift;
use crate::actuation::Wrench;
use crate::model::{LimitKind, Model};
use serde::Serialize;
use std::f64::consts::FRAC_PI_2;

/// The largest steady airspeed of a mode in level flight.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Airspeed {
    /// The airspeed, m/s; `None` if the mode cannot hover.
    pub largest_m_per_s: Option<f64>,
    /// What prevents a larger one; `None` if the mode cannot hover.
    pub limited_by: Option<LimitedBy>,
}

/// What limits the airspeed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
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
    /// `sqrt((m g)^2 + (drag u)^2)` and the torques vanish. This wrench must lie in the mode's set, shrunk by the reserve about
    /// hover in still air; in still air this is the set of [`AdmissibleSet::with_reserve`]. Where the vehicle has intervals, the
    /// airspeed is possible for every value of them.
    ///
    /// # Panics
    /// If the set is not of this model.
    pub fn of(model: &Model, set: &AdmissibleSet) -> Option<Self> {
        let drag = model.vehicle.drag;
        if drag <= 0.0 {
            return None;
        }
        let full = match model.vehicle.has_uncertain_rotors() {
            true => guaranteed(model, set).and_then(|rows| lift(&rows, set.zonotope.scale()[0])),
            false => lift(&set.polytope, set.zonotope.scale()[0]),
        };
        // Thrust decides by a concave function of the mass, tilt by a monotone one: the least is at an end of the interval.
        let spread = model.vehicle.mass_spread;
        let ends = [spread.low, spread.high].map(|share| {
            let weight = share * model.vehicle.mass * model.gravity;
            let by_thrust = thrust_across(weight, full?, model.plan.reserve)? / drag;
            let by_tilt = least_tilt(model).map_or(f64::INFINITY, |tilt| weight * tilt.tan() / drag);
            Some(match by_tilt < by_thrust {
                true => (by_tilt, LimitedBy::Tilt),
                false => (by_thrust, LimitedBy::Thrust),
            })
        });
        let least = match ends {
            [Some(light), Some(heavy)] => Some(if light.0 < heavy.0 { light } else { heavy }),
            _ => None,
        };
        Some(Airspeed { largest_m_per_s: least.map(|l| l.0), limited_by: least.map(|l| l.1) })
    }
}

/// The largest horizontal component (N) of a thrust whose vertical one holds a weight (N) and whose length, between the
/// `[low, high]` of the set (N), leaves the reserve; `None` if the weight is not between these.
fn thrust_across(weight: f64, (low, high): (f64, f64), reserve: f64) -> Option<f64> {
    let edge = edge::width(&Wrench::new(weight, 0.0, 0.0, 0.0));
    if weight < low - edge || weight > high + edge {
        return None;
    }
    let most = weight + (1.0 - reserve) * (high - weight).max(0.0);
    Some((most * most - weight * weight).sqrt())
}

/// The smallest upper limit on tilt of the whole mission, rad; `None` if there is none below a right angle.
fn least_tilt(model: &Model) -> Option<f64> {
    let limits = model.mission.iter().flat_map(|mission| &mission.limits);
    let general = limits.filter(|limit| limit.kind == LimitKind::Tilt && limit.is_general());
    let upper = general.filter_map(|limit| limit.upper);
    upper.filter(|tilt| *tilt < FRAC_PI_2).min_by(f64::total_cmp)
}
