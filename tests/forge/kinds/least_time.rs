//! Bounds that the honest plan, which keeps every row without a tolerance, stays below.

use super::Kind;
use super::Known::SoonerPlan;
use crate::numbers::Numbers;
use crate::specs::Spec;
use mavc::certificate::{Certificate, Claim, TooEarlyClaim};
use mavc::verify::Premise;

pub const KINDS: &[Kind] = &[
    Kind {
        name: "a least time above a plan's",
        known: SoonerPlan,
        premises: &[Premise::LeastTime],
        make: above_a_plan,
    },
    Kind { name: "no time where there is", known: SoonerPlan, premises: &[Premise::LeastTime], make: too_early },
];

fn above_a_plan(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mut forged = spec.certificate();
    if let Claim::Plan(claim) = &mut forged.claim {
        claim.least_time_s = Some(spec.total() * (1.0 + numbers.magnitude(1e-3, 10.0)));
    }
    Some(forged)
}

fn too_early(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let nodes = &spec.honest.waypoint_nodes;
    let waypoint = 1 + numbers.below(nodes.len());
    let reached = spec.honest.times[nodes[waypoint - 1]];
    let soonest_s = (reached + numbers.magnitude(1e-6, 1.0)) * (1.0 + numbers.magnitude(1e-3, 10.0));
    let honest = spec.certificate();
    Some(Certificate { claim: Claim::TooEarly(TooEarlyClaim { waypoint, soonest_s, weights: Vec::new() }), ..honest })
}

/// The honest motion with a bound on its time, s.
pub(super) fn with_least_time(spec: &Spec, bound: f64) -> Option<Certificate> {
    let mut forged = spec.certificate();
    let Claim::Plan(claim) = &mut forged.claim else { return None };
    claim.least_time_s = Some(bound);
    Some(forged)
}

/// A claim that a waypoint, from 0, is due before it can be reached at `soonest_s`.
pub(super) fn due_too_early(spec: &Spec, waypoint: usize, soonest_s: f64) -> Certificate {
    let claim = TooEarlyClaim { waypoint: waypoint + 1, soonest_s, weights: Vec::new() };
    Certificate { claim: Claim::TooEarly(claim), ..spec.certificate() }
}
