//! Kinds of forgery, each a way to make a false certificate on purpose.

mod air;
mod capture_height;
mod cores;
mod first;
mod headings;
mod infeasible;
mod joints;
mod least_time;
mod legs;
mod outlines;
mod pieces;
mod reserve;
mod rest;
mod reversing;
mod rows;
mod selection;
mod shape;
mod sides;
mod times;
mod ways;
mod witness;

use super::motion::{Timetable, Wish, add_spline};
use super::numbers::Numbers;
use super::specs::Spec;
use super::truth::Falsehood;
use mavc::certificate::{Certificate, Claim};
use mavc::motion::{Trajectory, X, Y, YAW, Z};
use mavc::verify::Premise;

/// A way to forge; `None` where a try, or the spec, gives none.
pub type Make = fn(&Spec, &mut Numbers) -> Option<Certificate>;

/// How it is known that what a kind makes is false.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Known {
    /// By evaluation, which has to find it false; where it does not, nothing was made.
    Evaluated,
    /// It says that there is no plan, and the spec has one, which keeps every row without a tolerance and lies on the
    /// spec's grid.
    PlanExists,
    /// It says that it was written for another spec.
    OtherHash,
    /// It says that no motion is as soon somewhere as the honest plan, which keeps every row without a tolerance, is.
    SoonerPlan,
    /// It says that nothing can be planned on one grid where the spec leaves times open.
    NoSuchGrid,
    /// It says that there is a plan of a spec that requires a reserve about hover, outside a set that it shrinks.
    Void,
    /// It shows less than the spec requires: it may be accepted with these words among the reasons, and is false
    /// without them.
    Weaker(&'static str),
}

/// A kind of forgery.
pub struct Kind {
    pub name: &'static str,
    pub known: Known,
    /// The premises that stand in its way; each is switched off to see whether the kind passes.
    pub premises: &'static [Premise],
    pub make: Make,
}

const fn evaluated(name: &'static str, premises: &'static [Premise], make: Make) -> Kind {
    Kind { name, known: Known::Evaluated, premises, make }
}

const fn sooner(name: &'static str, make: Make) -> Kind {
    Kind { name, known: Known::SoonerPlan, premises: &[Premise::LeastTime], make }
}

const fn unfounded(name: &'static str, premises: &'static [Premise], make: Make) -> Kind {
    Kind { name, known: Known::PlanExists, premises, make }
}

/// Every kind.
pub fn all() -> Vec<Kind> {
    let families: [&[Kind]; 20] = [
        joints::KINDS,
        pieces::KINDS,
        times::KINDS,
        rest::KINDS,
        rows::KINDS,
        legs::KINDS,
        air::KINDS,
        selection::KINDS,
        shape::KINDS,
        infeasible::KINDS,
        least_time::KINDS,
        reserve::KINDS,
        reversing::KINDS,
        headings::KINDS,
        sides::KINDS,
        first::KINDS,
        capture_height::KINDS,
        cores::KINDS,
        outlines::KINDS,
        ways::KINDS,
    ];
    families.into_iter().flatten().map(|k| Kind { ..*k }).collect()
}

impl Kind {
    /// A forgery that is known to be false, if this try gives one.
    pub fn forge(&self, spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
        if spec.is_void != (self.known == Known::Void) {
            return None;
        }
        let certificate = (self.make)(spec, numbers)?;
        let is_false = match self.known {
            Known::Evaluated => spec.truth.falsehood(&certificate).is_some(),
            Known::PlanExists => spec.has_one_grid() && matches!(certificate.claim, Claim::Infeasible(_)),
            Known::SoonerPlan => spec.is_sooner_than(&certificate),
            Known::OtherHash => certificate.spec_sha256 != super::SHA,
            Known::Void => spec.truth.falsehood(&certificate).is_some(),
            Known::Weaker(_) => spec.truth.falsehood(&certificate).is_none(),
            Known::NoSuchGrid => !spec.has_one_grid() && matches!(certificate.claim, Claim::Infeasible(_)),
        };
        is_false.then_some(certificate)
    }
}

/// The honest motion of another wish.
fn laid(spec: &Spec, wish: &Wish) -> Option<Certificate> {
    Some(spec.claiming(&moved(spec, wish)?))
}

fn moved(spec: &Spec, wish: &Wish) -> Option<Trajectory> {
    wish.motion(&Timetable::asked(spec.model(), spec.total())?, spec.truth.equations)
}

/// An axis at random; those whose spline is shorter as often as the others.
fn axis(numbers: &mut Numbers) -> usize {
    [X, Y, Z, YAW][numbers.below(4)]
}

/// The honest motion with a spline that grows until `reached`; `None` where it never is, or something else is false
/// first.
fn grown(
    spec: &Spec,
    numbers: &mut Numbers,
    (axis, derivative): (usize, usize),
    reached: impl Fn(&Trajectory, Option<Falsehood>) -> bool,
) -> Option<Trajectory> {
    let order = spec.honest.model.orders()[axis];
    let room = spec.honest.nodes.len().checked_sub(order + 2)?;
    let first = numbers.below(room);
    let sign = numbers.sign();
    // Not always just beyond.
    let factor = [1.3, 2.0, 10.0][numbers.below(3)];
    let mut size = numbers.magnitude(3e-4, 3e-2);
    while size < 3e3 {
        let mut motion = spec.honest.clone();
        add_spline(&mut motion, axis, first, derivative, sign * size)?;
        let found = spec.truth.of_plan(&motion);
        if reached(&motion, found) {
            return Some(motion);
        }
        if found.is_some() {
            return None;
        }
        size *= factor;
    }
    None
}
