//! What a fault mode leaves of the vehicle, on one scale that all commands, documents and the editor use.
//!
//! The first line that applies decides. "Edge" is the tolerance of [`edge::width`]; "the set without yaw" is the
//! projection of the mode's set on (T, tau_x, tau_y).
//!
//! 1. [`FullControl`](Outcome::FullControl): hover is inside the mode's set.
//! 2. [`FliesOn`](Outcome::FliesOn): hover is inside the set without yaw.
//! 3. [`Caught`](Outcome::Caught): hover is on the edge of the set without yaw, and the spin that the yaw torques of
//!    hover keep up makes the direction of the thrust controllable.
//! 4. [`NoMargin`](Outcome::NoMargin): hover is on the edge of the mode's set.
//! 5. [`Undecided`](Outcome::Undecided): hover is on the edge of the set without yaw, a spin could make the direction
//!    of the thrust controllable, and the spec gives no `yaw_drag`, so the spin is unknown.
//! 6. [`Lost`](Outcome::Lost): everything else.
//!
//! Two additions. With intervals in the spec this must be the answer for every vehicle of the intervals, or else the
//! outcome is undecided. And where a flight settles in a spin beyond the range of the gyroscope, the outcomes 2 and 3
//! become 6 (`crate::flight::equilibrium::outcome`).

use super::AdmissibleSet;
use super::edge::{self, HoverPlace};
use super::interval::{Certainty, Middle, Robust};
use super::verdict::{HoverVerdict, without_yaw};
use super::without_yaw::YawFree;
use crate::actuation::Wrench;
use crate::model::{Model, Rotor};
use serde::Serialize;

/// What a fault mode leaves of the vehicle in hover, from best to worst. The word of the paper stands beside each.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub enum Outcome {
    /// Hover is inside the set, with a margin about every axis (the paper: controllable).
    #[serde(rename = "full control")]
    FullControl,
    /// With yaw given up hover is inside the set of thrust, roll and pitch, without a spin or in one that the
    /// gyroscope measures (the paper: stabilizable, or controllable with residual 0).
    #[serde(rename = "flies on, heading not held")]
    FliesOn,
    /// The vehicle loses height until its spin makes it controllable, as a quadcopter without a rotor does (the paper:
    /// stabilizable). `mavc analyze --capture` simulates the height.
    #[serde(rename = "caught by spinning")]
    Caught,
    /// Hover is on the edge of the set, and giving up yaw does not help: thrust and torques balance, and in some
    /// direction no disturbance can be countered (the paper: controllable with residual 0; elsewhere in the
    /// literature, for example by the ACAI: uncontrollable).
    #[serde(rename = "no margin")]
    NoMargin,
    /// No hover that a controller could hold (the paper: unstable, or stabilizable).
    #[serde(rename = "lost")]
    Lost,
    /// What the spec gives does not decide: the vehicles of its intervals differ, or `yaw_drag` is missing.
    #[serde(rename = "undecided")]
    Undecided,
}

impl Outcome {
    /// From best to worst, then undecided.
    pub const ALL: [Outcome; 6] =
        [Outcome::FullControl, Outcome::FliesOn, Outcome::Caught, Outcome::NoMargin, Outcome::Lost, Outcome::Undecided];

    /// The words of all outputs.
    pub const fn word(self) -> &'static str {
        match self {
            Outcome::FullControl => "full control",
            Outcome::NoMargin => "no margin",
            Outcome::FliesOn => "flies on, heading not held",
            Outcome::Caught => "caught by spinning",
            Outcome::Lost => "lost",
            Outcome::Undecided => "undecided",
        }
    }

    /// The words after a number of modes: `2 of 6 fly on, heading not held`.
    pub const fn words_of(self, count: usize) -> &'static str {
        match self {
            Outcome::FliesOn if count != 1 => "fly on, heading not held",
            _ => self.word(),
        }
    }

    /// The outcome in a mode, before sensors are considered.
    pub(super) fn of(model: &Model, set: &AdmissibleSet, found: &Verdicts) -> Self {
        let middle = found.middle(model.vehicle.yaw_drag.is_some());
        let Some(robust) = found.robust else { return middle };
        let width = edge::width(&set.hover);
        let with_margin = |bound: Option<f64>| bound.is_some_and(|margin| margin > width);
        let everywhere = |place: HoverPlace| is_everywhere(model, set, place);
        let agrees = match middle {
            Outcome::FullControl => robust.hover == Certainty::Yes && with_margin(robust.acai_worst),
            // Some vehicle of the intervals may have full control.
            _ if with_margin(robust.acai_best) => false,
            Outcome::NoMargin => robust.hover == Certainty::Yes && everywhere(HoverPlace::OnEdge),
            Outcome::FliesOn => everywhere(HoverPlace::Inside),
            Outcome::Caught => everywhere(HoverPlace::OnEdge),
            Outcome::Lost if found.yaw_free == YawFree::None => everywhere(HoverPlace::Outside),
            Outcome::Lost => everywhere(HoverPlace::OnEdge),
            Outcome::Undecided => true,
        };
        if agrees { middle } else { Outcome::Undecided }
    }
}

/// What an outcome follows from.
pub(super) struct Verdicts {
    pub verdict: HoverVerdict,
    /// Where hover lies relative to the set that the verdict is about.
    pub place: HoverPlace,
    pub yaw_free: YawFree,
    /// Whether a spin that the yaw torques of hover may keep up makes the direction of the thrust controllable.
    pub could_spin: bool,
    pub robust: Option<Robust>,
}

impl Verdicts {
    /// The outcome in the middle of the intervals.
    fn middle(&self, has_yaw_drag: bool) -> Outcome {
        match (self.verdict, self.place, self.yaw_free) {
            (HoverVerdict::Controllable, HoverPlace::Inside, _) => Outcome::FullControl,
            (_, _, YawFree::Interior) => Outcome::FliesOn,
            (_, _, YawFree::Spinning) => Outcome::Caught,
            (HoverVerdict::Controllable, ..) => Outcome::NoMargin,
            (_, _, YawFree::OnEdge) if self.could_spin && !has_yaw_drag => Outcome::Undecided,
            _ => Outcome::Lost,
        }
    }
}

/// The most stuck rotors with an interval of thrust whose corners are all looked at.
const MOST_STUCK: usize = 6;

/// Whether hover is `place` relative to the set without yaw for every vehicle of the intervals. That set does not
/// depend on the drag torques, and grows with the range of every thrust, so the narrowest and the widest decide, at the
/// ends and in the middle of the mass and of the thrust of stuck rotors. With more than [`MOST_STUCK`] of these the
/// answer is no.
fn is_everywhere(model: &Model, set: &AdmissibleSet, place: HoverPlace) -> bool {
    let narrow = |r: &Rotor| [r.idle_thrust() * r.spread.idle_thrust.high, r.max_thrust() * r.spread.full_thrust.low];
    let wide = |r: &Rotor| [r.idle_thrust() * r.spread.idle_thrust.low, r.max_thrust() * r.spread.full_thrust.high];
    let in_narrow = || Middle::of(model, set, narrow).is_some_and(|narrow| has_place(model, set, &narrow, place));
    let in_wide = || Middle::of(model, set, wide).is_some_and(|wide| has_place(model, set, &wide, place));
    match place {
        HoverPlace::Inside => in_narrow(),
        HoverPlace::Outside => in_wide(),
        HoverPlace::OnEdge => in_narrow() && in_wide(),
    }
}

/// Whether hover is `place` relative to the projection of these wrenches, whatever the mass and the stuck rotors.
fn has_place(model: &Model, set: &AdmissibleSet, wrenches: &Middle, place: HoverPlace) -> bool {
    let moved: Vec<&Wrench> = wrenches.deviations.iter().filter(|moved| moved.norm() > 0.0).collect();
    if moved.len() > MOST_STUCK {
        return false;
    }
    let spread = model.vehicle.mass_spread;
    let shadow = without_yaw(&wrenches.zonotope);
    let rows = shadow.facets().without_origins();
    (0..3_usize.pow(moved.len() as u32)).all(|corner| {
        // A stuck rotor that gives more moves hover the other way.
        let shift = moved.iter().enumerate().fold(Wrench::zeros(), |sum, (k, moved)| {
            sum - *moved * ((corner / 3_usize.pow(k as u32) % 3) as f64 - 1.0)
        });
        [spread.low, 1.0, spread.high].iter().all(|share| {
            let hover = set.hover * *share;
            let at = (hover + shift).fixed_rows::<3>(0).into_owned();
            let margin = rows.equalities.is_empty().then(|| rows.margin(&at));
            HoverPlace::new(margin, (shadow.nearest(&at) - at).norm(), edge::width(&hover)) == place
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn json_and_text_have_the_same_words() {
        for outcome in Outcome::ALL {
            assert_eq!(serde_json::to_value(outcome).unwrap(), outcome.word());
        }
        assert!(Outcome::ALL.is_sorted());
        assert_eq!(
            [1, 2].map(|n| Outcome::FliesOn.words_of(n)),
            ["flies on, heading not held", "fly on, heading not held"]
        );
    }
}
