//! The time constant of the rotors' lag, if the plan accounts for it (docs/method/rotor-lag.md, (87)).

use super::interval::Interval;
use crate::model::{Model, PlanRotors, Rotor};

/// The time constant tau in f + tau f', that of the slowest rotor, s; `None` if rotors follow their commands at once.
pub fn constant(model: &Model) -> Option<Interval> {
    match model.plan.rotors {
        PlanRotors::Instant => None,
        PlanRotors::Lagging => model.vehicle.rotors.iter().map(of_rotor).reduce(larger),
    }
}

/// `tau_m (1 + s)/(2 s)`, where s is the ratio of idle to full speed, but at least a third. Thrusts that are known to
/// within intervals are taken at the ends that make s small.
fn of_rotor(rotor: &Rotor) -> Interval {
    let [idle, full, low, high] =
        [rotor.min_speed, rotor.max_speed, rotor.spread.idle_thrust.low, rotor.spread.full_thrust.high]
            .map(Interval::point);
    let share = larger(idle / full * (low / high).sqrt(), Interval::ONE / Interval::point(3.0));
    Interval::point(rotor.lag()) * (Interval::ONE + share) / (Interval::point(2.0) * share)
}

fn larger(a: Interval, b: Interval) -> Interval {
    Interval::new(a.low.max(b.low), a.high.max(b.high))
}
