//! The admissible set of a mode with yaw given up: roll, pitch and thrust, while the body turns about the thrust as it
//! may. See `docs/method/without-yaw.md`.

mod controllability;
pub mod core;
pub mod early;
pub mod planned;
pub mod relaxed_hover;

use super::edge::{self, HoverPlace};
use super::verdict::lift;
use super::{AdmissibleSet, hover};
use crate::actuation::Wrench;
use crate::geometry::polytope::Polytope;
use crate::model::{Model, YawDrag};
use nalgebra::Vector3;
use relaxed_hover::RelaxedHover;
use serde::Serialize;

/// How a mode hovers with yaw given up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub enum YawFree {
    /// Hover lies inside the projection of the set on (T, tau_x, tau_y): torques remain about every horizontal axis.
    #[serde(rename = "interior")]
    Interior,
    /// Hover lies on the boundary of the projection: in some direction no disturbance can be countered, or not as far
    /// as is known without `yaw_drag`.
    #[serde(rename = "on the edge")]
    OnEdge,
    /// Hover lies on the boundary, but the body spins, and the direction of the thrust is controllable because of it.
    #[serde(rename = "spinning")]
    Spinning,
    /// Hover lies outside.
    #[serde(rename = "none")]
    None,
}

impl YawFree {
    /// The word that reports print.
    pub const fn word(self) -> &'static str {
        match self {
            YawFree::Interior => "interior",
            YawFree::OnEdge => HoverPlace::OnEdge.word(),
            YawFree::Spinning => "spinning",
            YawFree::None => "none",
        }
    }
}

/// What a mode can do about hover with yaw given up. All but `relaxed_hover` is for a spin axis along z of the body.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct WithoutYaw {
    /// Radius of the largest disc of roll and pitch torques about hover that the mode produces, N m; 0 on the edge.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub disc_n_m: f64,
    /// The disc as angular acceleration about the horizontal axis with the larger moment of inertia, rad/s^2.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub disc_rad_s2: f64,
    /// The largest thrust without roll and pitch torques, N.
    pub level_thrust_n: f64,
    /// The yaw torques that are possible in hover, N m, [lowest, highest].
    pub yaw_torque_n_m: [f64; 2],
    /// The rates at which the drag balances these torques, for all values of `yaw_drag`, rad/s, counter-clockwise
    /// seen from above; null if the spec gives no `yaw_drag`.
    pub spin_rad_s: Option<[f64; 2]>,
    /// Equilibria: the slowest spin about z, and where its disc vanishes the one with the largest disc, whose axis is
    /// tilted in the body. Empty if the spec gives no `yaw_drag`, and for an interval of it at its middle.
    pub relaxed_hover: Vec<RelaxedHover>,
}

/// The word, and whether hover is on the edge and some spin that its yaw torques may keep up makes the direction of the
/// thrust controllable.
pub(super) fn word(
    model: &Model,
    set: &AdmissibleSet,
    yaw_free: &Polytope<3, ()>,
    place: HoverPlace,
) -> (YawFree, bool) {
    match HoverWithoutYaw::of(model, set, yaw_free) {
        Some(slice) if place != HoverPlace::Outside => {
            (slice.word(place), place == HoverPlace::OnEdge && slice.is_controlled(slice.torques))
        }
        _ => (YawFree::None, false),
    }
}

/// The figures; `None` where the word is `none`.
pub(super) fn figures(
    model: &Model,
    set: &AdmissibleSet,
    yaw_free: &Polytope<3, ()>,
    place: HoverPlace,
) -> Option<WithoutYaw> {
    let slice = HoverWithoutYaw::of(model, set, yaw_free).filter(|_| place != HoverPlace::Outside)?;
    Some(slice.figures(place))
}

/// The wrenches of hover with yaw given up.
struct HoverWithoutYaw<'a> {
    model: &'a Model,
    set: &'a AdmissibleSet,
    yaw_free: &'a Polytope<3, ()>,
    /// The yaw torques that are possible in hover, N m.
    torques: [f64; 2],
}

impl<'a> HoverWithoutYaw<'a> {
    /// `None` where hover is outside by more than the width of the edge.
    fn of(model: &'a Model, set: &'a AdmissibleSet, yaw_free: &'a Polytope<3, ()>) -> Option<Self> {
        let hover = hover(model);
        let width = edge::width(&hover);
        let yaw = Wrench::new(0.0, 0.0, 0.0, 1.0);
        let (low, high) = set.polytope.chord(&hover, &yaw, width)?;
        let dust = |torque: f64| if torque.abs() <= width { 0.0 } else { torque };
        Some(HoverWithoutYaw { model, set, yaw_free, torques: [dust(low), dust(high)] })
    }

    /// The torque of the slowest spin, N m.
    fn least_torque(&self) -> f64 {
        let [low, high] = self.torques;
        0.0_f64.clamp(low.min(high), high.max(low))
    }

    /// The rates of spin for all values of the drag, rad/s.
    fn spins(&self) -> Option<[f64; 2]> {
        let rates = |drag: YawDrag| self.torques.map(|torque| drag.spin(torque));
        let [fast, slow] = self.model.vehicle.yaw_drag?.ends().map(rates);
        Some([fast[0].min(slow[0]), fast[1].max(slow[1])])
    }

    fn word(&self, place: HoverPlace) -> YawFree {
        match place {
            HoverPlace::Inside => YawFree::Interior,
            HoverPlace::Outside => YawFree::None,
            HoverPlace::OnEdge => match self.spins() {
                Some(spins) if self.is_controlled(spins) => YawFree::Spinning,
                _ => YawFree::OnEdge,
            },
        }
    }

    /// Whether the direction of the thrust is controllable at one of two rates about z, of which only the sign matters.
    fn is_controlled(&self, rates: [f64; 2]) -> bool {
        let hover = hover(self.model);
        let rows = core::directions(self.yaw_free, &hover.fixed_rows::<3>(0).into_owned(), edge::width(&hover));
        let inertia = self.model.vehicle.inertia;
        rates.into_iter().any(|rate| controllability::is_controllable(inertia, rate, &rows))
    }

    fn figures(&self, place: HoverPlace) -> WithoutYaw {
        let HoverWithoutYaw { model, set, yaw_free, torques } = *self;
        let hover = hover(model);
        let disc = core::disc(yaw_free, hover[0], [0.0; 2], edge::width(&hover)).unwrap_or(0.0);
        let [jx, jy, _] = model.vehicle.inertia;
        let size = set.zonotope.scale()[0];
        WithoutYaw {
            disc_n_m: disc,
            disc_rad_s2: disc / jx.max(jy),
            level_thrust_n: lift(yaw_free, size).map_or(0.0, |(_, high)| high),
            yaw_torque_n_m: torques,
            spin_rad_s: self.spins(),
            relaxed_hover: self.equilibria(place),
        }
    }

    fn equilibria(&self, place: HoverPlace) -> Vec<RelaxedHover> {
        let HoverWithoutYaw { model, set, yaw_free, .. } = *self;
        let Some(drag) = model.vehicle.yaw_drag else { return Vec::new() };
        let system = relaxed_hover::System::new(model, set, yaw_free, drag);
        let about_z = Vector3::new(0.0, 0.0, drag.spin(self.least_torque()));
        let level = system.at(&about_z);
        let tilted = if place == HoverPlace::OnEdge { system.widest() } else { None };
        level.into_iter().chain(tilted).collect()
    }
}
