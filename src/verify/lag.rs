//! How quickly thrusts may be taken to follow their commands, where the plan minds that they lag (docs/method.md, (87)).

use super::interval::Interval;
use crate::model::{Model, PlanRotors, Rotor};

/// tau of f + tau f', that of the slowest rotor, s; `None` where rotors follow at once.
pub fn constant(model: &Model) -> Option<Interval> {
    match model.plan.rotors {
        PlanRotors::Instant => None,
        PlanRotors::Lagging => model.vehicle.rotors.iter().map(of_rotor).reduce(larger),
    }
}

/// `tau_m (1 + s)/(2 s)`: s is the idle share of full speed, or a third where that is more. Thrusts known to within
/// intervals count at the ends that make s small.
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
