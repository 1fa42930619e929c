//! Reserves about a hover that lies outside a set: a share of the way to a boundary which is behind.

use super::{Kind, Known};
use crate::motion::Timetable;
use crate::numbers::Numbers;
use crate::specs::{Spec, falling};
use mavc::certificate::{Certificate, Claim, SpinRecord};
use mavc::model::GiveUpYaw;
use mavc::motion::Z;
use mavc::verify::Premise;

pub const KINDS: &[Kind] = &[
    Kind {
        name: "a reserve about hover outside a set",
        known: Known::Void,
        premises: &[Premise::Reserve],
        make: within,
    },
    Kind {
        name: "a reserve about hover outside a core",
        known: Known::Void,
        premises: &[Premise::Reserve],
        make: of_core,
    },
    // The planes behind which hover lies are not moved outward either, so that no premise alone lets it pass.
    Kind { name: "a motion in what a reserve enlarges", known: Known::Void, premises: &[], make: beyond },
];

/// Thrust at which the spec's motion falls, over the most that the set has.
fn thrusts(spec: &Spec) -> [f64; 2] {
    let (vehicle, g) = (&spec.model().vehicle, spec.model().gravity);
    let mode = &spec.model().modes[spec.model().plan.against[0]];
    let most: f64 =
        vehicle.rotors.iter().zip(&mode.rotors).map(|(rotor, left)| rotor.max_thrust() * left.capacity()).sum();
    [(spec.honest.nodes[0][Z][2] + g) * vehicle.mass / most, most]
}

/// A fall with another thrust, as a share of the most that the set has.
fn fallen(spec: &Spec, share: f64) -> Option<Certificate> {
    let acceleration = share * thrusts(spec)[1] / spec.model().vehicle.mass - spec.model().gravity;
    let table = Timetable::asked(spec.model(), spec.total())?;
    Some(spec.claiming(&falling(spec.truth.mission(), &table, acceleration, spec.truth.equations)))
}

fn within(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    fallen(spec, thrusts(spec)[0] * numbers.between(0.9, 1.05))
}

/// The weak mode given up in yaw, where the spec allows it.
fn of_core(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mode = &spec.model().modes[spec.model().plan.against[0]];
    if mode.without_yaw != Some(GiveUpYaw::Always) {
        return None;
    }
    let mut forged = within(spec, numbers)?;
    let Claim::Plan(claim) = &mut forged.claim else { return None };
    let spin_rad_s = [-numbers.between(0.5, 3.0), numbers.between(0.5, 10.0)];
    claim.without_yaw = vec![SpinRecord { mode: mode.name.clone(), spin_rad_s, turning_rad_s: None }];
    Some(forged)
}

/// Outside the set, by less than the way that the reserve would shift its boundary towards hover.
fn beyond(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let hover = spec.model().vehicle.mass * spec.model().gravity / thrusts(spec)[1];
    let most = 1.0 + spec.model().plan.reserve * (hover - 1.0);
    (most > 1.01).then(|| fallen(spec, numbers.between(1.005, most)))?
}
