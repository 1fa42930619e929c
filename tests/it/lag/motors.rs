//! The simulator's motors, whose speeds lag, under the commands that a plan with lagging thrusts implies.

use super::{compared, lagging, planning, shuttle, solved};
use crate::vehicles::octocopter;
use mavc::actuation::Wrench;
use mavc::admissible::allocation::Allocator;
use mavc::flight::rotors::Rotors;
use mavc::model::{MissionTime, Model, PlanModel};
use mavc::motion::{Trajectory, with_slopes};
use proptest::prelude::*;

/// Commands are given this often, s.
const STEP: f64 = 2e-4;

/// The largest lag of a motor behind a thrust that follows with twice its constant, as a share of full thrust, (83):
/// that of a rotor that is told to go from standstill to full speed, the largest of (1 - y) - (1 - y^2)^2.
fn most_behind() -> f64 {
    (0..=100_000).map(|i| f64::from(i) * 1e-5).map(|y| 1.0 - y - (1.0 - y * y).powi(2)).fold(0.0, f64::max)
}

/// What the motors make of thrusts that are wanted at the end of each step: they are told what gets them there, as far
/// as they can turn.
struct Motors {
    rotors: Rotors,
    fades: Vec<f64>,
    coefficient: Vec<f64>,
}

impl Motors {
    fn at(model: &Model, thrusts: &[f64]) -> Self {
        let coefficient: Vec<f64> = model.vehicle.rotors.iter().map(|r| r.thrust_coefficient).collect();
        let fades = model.vehicle.rotors.iter().map(|r| (-STEP / r.lag()).exp()).collect();
        let mut rotors = Rotors::new(&model.vehicle, 2.0 * STEP);
        rotors.command = thrusts.iter().zip(&coefficient).map(|(f, b)| (f / b).sqrt()).collect();
        rotors.settle();
        Motors { rotors, fades, coefficient }
    }

    /// Thrusts after a step, N, and whether some command was beyond what the rotor can turn.
    fn step(&mut self, wanted: &[f64]) -> (Vec<f64>, bool) {
        let mut clipped = false;
        for (k, f) in wanted.iter().enumerate() {
            let there = (f.max(0.0) / self.coefficient[k]).sqrt();
            let command = (there - self.rotors.speed[k] * self.fades[k]) / (1.0 - self.fades[k]);
            let most = self.rotors.max_speed[k];
            clipped |= !(-1e-9 * most..=(1.0 + 1e-9) * most).contains(&command);
            self.rotors.command[k] = command.clamp(0.0, most);
        }
        self.rotors.half_step();
        (self.rotors.speed.iter().zip(&self.coefficient).map(|(w, b)| b * w * w).collect(), clipped)
    }
}

/// How a plan's thrusts and the motors go together, in shares of full thrust and of full speed.
#[derive(Debug)]
struct Followed {
    /// How far the motors' thrusts are from the wanted ones at most.
    behind: f64,
    /// How far the wrench of the wanted thrusts is from the planned one at most, in shares of what hover and full
    /// thrust give.
    missed: f64,
    slowest: f64,
    clipped: bool,
}

/// Flies the thrusts of a plan: the commanded wrench is allocated and each command filtered with tau; without a lag the
/// wrench itself is allocated.
fn followed(model: &Model, plan: &Trajectory) -> Followed {
    let vehicle = &model.vehicle;
    let allocator = Allocator::new(vehicle);
    let tau = model.thrust_lag();
    let most: Vec<f64> = vehicle.rotors.iter().map(mavc::model::Rotor::max_thrust).collect();
    let mut f = allocator.thrusts(&plan.wrench(vehicle, &model.environment(), &plan.nodes[0]));
    let mut motors = Motors::at(model, &f);
    let mut out = Followed { behind: 0.0, missed: 0.0, slowest: f64::INFINITY, clipped: false };
    for k in 0..plan.intervals() {
        let length = plan.times[k + 1] - plan.times[k];
        let steps = (length / STEP).round().max(1.0);
        let ends = [&plan.nodes[k], &plan.nodes[k + 1]];
        let at = |i: f64| plan.within(k, length * i / steps);
        for i in 0..steps as usize {
            let wanted = plan.wrench(vehicle, &model.environment(), &at(i as f64 + 1.0));
            match tau {
                Some(tau) => {
                    let middle = with_slopes(&at(i as f64 + 0.5), ends, length, plan.model.orders());
                    let commands =
                        allocator.thrusts(&plan.model.commanded(vehicle, &model.environment(), tau, &middle));
                    let fade = (-length / steps / tau).exp();
                    f.iter_mut().zip(commands).for_each(|(f, command)| *f = command + (*f - command) * fade);
                }
                None => f = allocator.thrusts(&wanted),
            }
            let (given, clipped) = motors.step(&f);
            out.clipped |= clipped;
            for k in 0..f.len() {
                out.behind = out.behind.max((given[k] - f[k]).abs() / most[k]);
                out.slowest = out.slowest.min((f[k] / most[k]).sqrt());
            }
            let sum = f.iter().zip(&vehicle.rotors).map(|(f, r)| {
                let drag = r.drag_coefficient / r.thrust_coefficient;
                let spin = if r.spin == mavc::model::Spin::P { -drag } else { drag };
                Wrench::new(1.0, r.position[1], -r.position[0], spin) * *f
            });
            let miss = sum.sum::<Wrench>() - wanted;
            out.missed = out.missed.max(miss.component_div(&Wrench::new(50.0, 3.0, 3.0, 0.4)).amax());
        }
    }
    out
}

/// Where no rotor turns slower than a third, motors give the planned thrusts to what the steps leave.
#[test]
fn motors_follow_a_plan_that_keeps_rotors_turning() {
    for (model, time) in [(PlanModel::Hover, 5.6), (PlanModel::Exact, 6.5)] {
        let mut model = lagging(planning(shuttle(), model, MissionTime::Fixed(time)), 0.1);
        model.plan.reserve = 0.1;
        let comparison = compared(&model);
        let followed = followed(&model, &solved(&comparison).trajectory);
        assert!(followed.slowest >= 1.0 / 3.0, "{followed:?}");
        assert!(!followed.clipped && followed.behind < 1e-9 && followed.missed < 1e-4, "{followed:?}");
    }
}

/// At the shortest time and without a reserve rotors stop; then motors lag by no more than (88), and much more where
/// the plan takes them to follow at once.
#[test]
fn motors_stay_near_the_quickest_plan() {
    let instant = planning(shuttle(), PlanModel::Hover, MissionTime::Minimum);
    let model = lagging(instant.clone(), 0.1);
    let comparison = compared(&model);
    let lag = followed(&model, &solved(&comparison).trajectory);
    assert!(lag.slowest < 1.0 / 3.0 && lag.missed < 2e-3, "{lag:?}");
    assert!(lag.behind <= most_behind() + 1e-3, "{lag:?}, and {} is allowed", most_behind());

    let mut at_once = instant;
    at_once.vehicle = model.vehicle.clone();
    let comparison = compared(&at_once);
    let none = followed(&at_once, &solved(&comparison).trajectory);
    assert!(none.clipped && none.behind > 2.0 * lag.behind.max(most_behind()), "{none:?} and {lag:?}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, failure_persistence: None, ..ProptestConfig::default() })]

    /// (87) and (88) for commands of any kind: where thrusts stay above a ninth motors give them, elsewhere they lag by
    /// little.
    #[test]
    fn motors_follow_lagging_thrusts(
        commands in prop::collection::vec((prop_oneof![Just(0.0), Just(1.0), 0.0..1.0f64], 1usize..400), 1..12),
        start in 0.0..1.0f64,
        floor in prop_oneof![Just(0.0), Just(1.0 / 9.0), 0.0..0.5f64],
        tau in 0.02..0.1f64,
    ) {
        let model = lagging(octocopter("PPNNPPNN"), tau);
        let full = model.vehicle.rotors[0].max_thrust();
        let n = model.vehicle.rotors.len();
        let fade = (-STEP / tau).exp();
        let above = |share: f64| floor + (1.0 - floor) * share;
        let mut f = above(start) * full;
        let mut motors = Motors::at(&model, &vec![f; n]);
        for (command, steps) in commands {
            for _ in 0..steps {
                f = above(command) * full + (f - above(command) * full) * fade;
                let (given, clipped) = motors.step(&vec![f; n]);
                let behind = (f - given[0]) / full;
                // Whoever stands still is on the way a step later.
                prop_assert!(behind.abs() <= most_behind() + STEP / tau, "{behind}");
                if floor >= 1.0 / 9.0 {
                    prop_assert!(!clipped && behind.abs() < 1e-9, "{behind} above {floor}");
                }
            }
        }
    }
}

#[test]
fn a_rotor_from_standstill_lags_as_the_closed_form_says() {
    let model = lagging(octocopter("PPNNPPNN"), 0.08);
    let full = model.vehicle.rotors[0].max_thrust();
    let mut motors = Motors::at(&model, &[0.0; 8]);
    let (mut f, mut worst): (f64, f64) = (0.0, 0.0);
    for _ in 0..4000 {
        f = full + (f - full) * (-STEP / 0.08f64).exp();
        let (given, _) = motors.step(&[f; 8]);
        worst = worst.max((f - given[0]) / full);
    }
    assert!((worst - most_behind()).abs() < 1e-3 && (worst - 0.0733).abs() < 1e-3, "{worst}");
}
