//! Rotors that reverse: bounds as if nothing fell faster than a stone.

use super::infeasible::widen;
use super::least_time::{due_too_early, with_least_time};
use super::{Kind, sooner, unfounded};
use crate::kinds::witness::{claiming, of_harder};
use crate::numbers::Numbers;
use crate::specs::{Harder, Spec};
use mavc::certificate::Certificate;
use mavc::model::Rotor;
use mavc::verify::Premise;

pub const KINDS: &[Kind] = &[
    sooner("a least time as if nothing fell faster than g", least),
    sooner("no time as if nothing fell faster than g", too_early),
    unfounded("multipliers of rotors that do not reverse", &[Premise::Facets], multipliers),
];

/// Between the time of the honest plan at a waypoint, and that of a fall with at most g or with what stops it,
/// whichever is more.
fn bound(spec: &Spec, numbers: &mut Numbers, waypoint: usize) -> Option<f64> {
    let (vehicle, g) = (&spec.model().vehicle, spec.model().gravity);
    if !vehicle.rotors.iter().any(Rotor::is_reversible) {
        return None;
    }
    let points = &spec.truth.mission().waypoints;
    let fall = points[0].position[2] - points[waypoint].position[2];
    let up = vehicle.rotors.iter().map(Rotor::max_thrust).sum::<f64>() / vehicle.mass - g;
    let is_last = waypoint + 1 == points.len();
    let claimed = if is_last { 2.0 * (fall / up.max(g)).sqrt() } else { (2.0 * fall / g).sqrt() };
    let reached = 1.002 * spec.honest.times[spec.honest.waypoint_nodes[waypoint]];
    (claimed > reached).then(|| numbers.between(reached, claimed))
}

fn least(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let bound = bound(spec, numbers, spec.honest.waypoint_nodes.len() - 1)?;
    with_least_time(spec, bound)
}

fn too_early(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let waypoint = 1 + numbers.below(spec.honest.waypoint_nodes.len() - 1);
    let soonest_s = bound(spec, numbers, waypoint)?;
    Some(due_too_early(spec, waypoint, soonest_s))
}

/// Rotors that reverse with all of their thrust make the healthy set twice as wide.
fn multipliers(spec: &Spec, _: &mut Numbers) -> Option<Certificate> {
    let mut claim = of_harder(spec, Harder::OneWay)?;
    widen(&mut claim, 2.0);
    Some(claiming(spec, claim))
}
