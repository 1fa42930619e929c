//! A wrench path can be flown by commands within the rotors' bounds if and only if its commanded wrench w + tau w'
//! stays admissible: (81) of `docs/method/rotor-lag.md`.

use super::lagging;
use crate::vehicles::octocopter;
use mavc::actuation::{Actuation, Wrench};
use mavc::admissible::AdmissibleSet;
use mavc::admissible::allocation::Allocator;
use mavc::flatness::{self, COMMAND_INPUTS, CommandFlatState};
use mavc::model::Model;
use mavc::motion::hover_map::{WrenchMap, YawState};
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{X, Y, YAW, Z};
use proptest::prelude::*;

/// Each thrust, in shares of its range, at the corners of a path of commands.
fn corners() -> impl Strategy<Value = Vec<Vec<f64>>> {
    let share = prop_oneof![2 => 0.0..1.0f64, 1 => Just(0.0), 1 => Just(1.0)];
    prop::collection::vec(prop::collection::vec(share, 8), 2..6)
}

fn vehicle(idle: f64) -> Model {
    let mut model = octocopter("PPNNPPNN");
    model.vehicle.rotors.iter_mut().for_each(|r| r.min_speed = idle);
    model
}

/// Thrusts (N) at shares of each rotor's range, and their wrench.
fn given(model: &Model, shares: &[f64]) -> Wrench {
    let actuation = Actuation::of(&model.vehicle);
    shares.iter().enumerate().map(|(k, s)| actuation.idle(k) * (1.0 - s) + actuation.full(k) * *s).sum()
}

fn wrench_of(model: &Model, thrusts: &[f64]) -> Wrench {
    let actuation = Actuation::of(&model.vehicle);
    let rotors = model.vehicle.rotors.iter().zip(thrusts).enumerate();
    rotors.map(|(k, (r, f))| actuation.full(k) * (f / r.max_thrust())).sum()
}

/// One step of tau y' + y = u for u linear from `from` to `to`, in closed form.
fn follow(y: f64, from: f64, to: f64, h: f64, tau: f64) -> f64 {
    let slope = (to - from) / h;
    let settled = |t: f64| from + slope * (t - tau);
    settled(h) + (y - settled(0.0)) * (-h / tau).exp()
}

/// Steps of one path between two corners, each this long, s.
const STEPS: usize = 50;
const STEP: f64 = 2e-3;

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    /// The commanded wrench moves on straight lines between admissible points, so it is admissible. It is allocated at
    /// each instant, and each rotor filters its own command.
    #[test]
    fn paths_with_admissible_commanded_wrenches_can_be_flown(
        start in prop::collection::vec(0.0..1.0f64, 8),
        corners in corners(),
        idle in prop_oneof![Just(0.0), Just(300.0)],
        tau in 0.01..0.2f64,
    ) {
        let model = vehicle(idle);
        let allocator = Allocator::new(&model.vehicle);
        let scale = Wrench::new(20.0, 2.0, 2.0, 0.3);
        let mut w = given(&model, &start);
        let mut thrusts = allocator.thrusts(&w);
        for ends in corners.windows(2) {
            let [from, to] = [given(&model, &ends[0]), given(&model, &ends[1])];
            let commanded = |step: usize| from + (to - from) * (step as f64 / STEPS as f64);
            for step in 0..STEPS {
                let [before, after] = [commanded(step), commanded(step + 1)];
                w = Wrench::from_fn(|i, _| follow(w[i], before[i], after[i], STEP, tau));
                let commands = [allocator.thrusts(&before), allocator.thrusts(&after)];
                for (k, f) in thrusts.iter_mut().enumerate() {
                    *f = follow(*f, commands[0][k], commands[1][k], STEP, tau);
                    let rotor = &model.vehicle.rotors[k];
                    prop_assert!(*f >= rotor.idle_thrust() - 1e-9 && *f <= rotor.max_thrust() + 1e-9, "rotor {k}: {f}");
                }
                let missed = (wrench_of(&model, &thrusts) - w).component_div(&scale).amax();
                prop_assert!(missed < 1e-6, "the rotors give {:?} for {w:?}", wrench_of(&model, &thrusts));
            }
        }
    }

    /// Rotors with different time constants: if f and f + tau f' are within bounds for the largest tau, every rotor has
    /// a command within its bounds.
    #[test]
    fn the_largest_constant_is_enough(f in 0.0..1.0f64, command in 0.0..1.0f64, tau in 0.01..0.2f64, part in 0.05..1.0f64) {
        let rate = (command - f) / tau;
        let own = f + part * tau * rate;
        prop_assert!((-1e-12..=1.0 + 1e-12).contains(&own), "{own}");
    }

    /// Whatever the commands, w + tau w' of the thrusts that follow them is admissible.
    #[test]
    fn paths_that_are_flown_have_admissible_commanded_wrenches(
        start in prop::collection::vec(0.0..1.0f64, 8),
        corners in corners(),
        idle in prop_oneof![Just(0.0), Just(300.0)],
        tau in 0.01..0.2f64,
    ) {
        let model = vehicle(idle);
        let set = AdmissibleSet::healthy(&model);
        let mut shares = start;
        for wanted in corners {
            // Rates of the shares under a constant command.
            let before = shares.clone();
            shares = shares.iter().zip(&wanted).map(|(y, u)| follow(*y, *u, *u, STEP, tau)).collect();
            let rates: Vec<f64> = shares.iter().zip(&before).map(|(a, b)| (a - b) / STEP).collect();
            let w = given(&model, &shares);
            let ahead: Vec<f64> = shares.iter().zip(&rates).map(|(y, r)| y + tau * r).collect();
            let commanded = given(&model, &ahead);
            for facet in &set.zonotope.facets().facets {
                let width = set.zonotope.width(&facet.normal);
                prop_assert!(facet.normal.dot(&w) <= facet.offset + 1e-9 * width);
                // Secants lag behind tangents by half a step.
                prop_assert!(facet.normal.dot(&commanded) <= facet.offset + STEP / tau * width);
            }
        }
    }
}

/// Sums of two oscillations on each axis, smooth to every order.
fn waving(t: f64) -> [[f64; 6]; 4] {
    let waves = [
        [(1.1, 1.7, 0.3), (0.4, 2.9, 1.0)],
        [(0.9, 1.9, 2.0), (0.5, 2.3, 0.1)],
        [(0.5, 1.5, 0.7), (0.2, 3.1, 4.0)],
        [(0.8, 0.9, 0.2), (0.3, 1.6, 3.0)],
    ];
    waves.map(|axis| {
        std::array::from_fn(|order| {
            let turn = std::f64::consts::FRAC_PI_2 * order as f64;
            axis.iter().map(|(a, w, phase)| a * f64::powi(*w, order as i32) * (w * t + phase + turn).sin()).sum()
        })
    })
}

fn lower(state: &[[f64; 6]; 4]) -> [[f64; 5]; 4] {
    state.map(|axis| std::array::from_fn(|order| axis[order]))
}

const TAU: f64 = 0.08;

/// w + tau w' with w' by a difference of fourth order, of the wrench alone.
fn lead_by_difference(model: &Model, wrench: WrenchModel, t: f64) -> Wrench {
    let w = |t: f64| wrench.wrench(&model.vehicle, &model.environment(), &lower(&waving(t)));
    let h = 1e-3;
    let rate = ((w(t + h) - w(t - h)) * 8.0 - (w(t + 2.0 * h) - w(t - 2.0 * h))) / (12.0 * h);
    w(t) + rate * TAU
}

/// In units that make the parts of a wrench alike.
fn apart(a: &Wrench, b: &Wrench) -> f64 {
    (a - b).component_div(&Wrench::new(20.0, 0.5, 0.5, 0.3)).amax()
}

#[test]
fn commanded_wrenches_agree_with_finite_differences() {
    let mut model = octocopter("PPNNPPNN");
    model.vehicle.inertia = [0.0429, 0.0512, 0.0748];
    for wrench in [WrenchModel::Exact, WrenchModel::HoverFollowing] {
        for t in [0.0, 0.4, 1.3, 2.2, 5.9] {
            let found = wrench.commanded(&model.vehicle, &model.environment(), TAU, &waving(t));
            let wanted = lead_by_difference(&model, wrench, t);
            assert!(apart(&found, &wanted) < 1e-7, "{wrench:?} at {t}: {found:?}, by differences {wanted:?}");
            // The linearisation at a state gives the commanded wrench of this state.
            let map = wrench.commanded_linearised(&model.vehicle, &model.environment(), TAU, &waving(t));
            assert!(apart(&map.at(&waving(t)), &wanted) < 1e-7);
        }
    }
}

/// With a constant yaw: nothing of the yaw motion enters roll and pitch.
#[test]
fn at_one_yaw_the_commanded_wrench_is_the_wrench_plus_tau_times_its_rate() {
    let model = octocopter("PPNNPPNN");
    let (vehicle, g) = (&model.vehicle, model.gravity);
    let state = waving(1.0);
    let commanded = WrenchMap::commanded_with_free_yaw(vehicle, g, 0.4, TAU).at(&state);
    // The same map applied to derivatives of one order higher gives w', except for the weight.
    let higher: [[f64; 5]; 4] = state.map(|axis| std::array::from_fn(|order| axis[order + 1]));
    let map = WrenchMap::with_free_yaw(vehicle, g, 0.4);
    let rate = map.at(&higher) - Wrench::new(vehicle.mass * g, 0.0, 0.0, 0.0);
    assert!(apart(&commanded, &(map.at(&state) + rate * TAU)) < 1e-12);
    // A yaw frozen at rest gives the same, apart from the yaw torque.
    let frozen = WrenchMap::commanded(vehicle, g, YawState { psi: 0.4, rate: 0.0, acceleration: 0.0 }, 0.0, TAU);
    let mut straight = state;
    straight[YAW] = [0.0; 6];
    assert!(
        apart(&frozen.at(&straight), &WrenchMap::commanded_with_free_yaw(vehicle, g, 0.4, TAU).at(&straight)) < 1e-12
    );
}

fn flat(state: &[[f64; 6]; 4]) -> CommandFlatState {
    let orders = [2, 3, 4].into_iter().flat_map(|m| [(X, m), (Y, m), (Z, m)]);
    let rest = [(YAW, 0), (YAW, 1), (YAW, 2), (X, 5), (Y, 5), (Z, 5), (YAW, 3)];
    CommandFlatState::from_iterator(orders.chain(rest).map(|(axis, order)| state[axis][order]))
}

#[test]
fn slopes_and_curvature_are_those_of_differences() {
    let mut model = octocopter("PPNNPPNN");
    model.vehicle.inertia = [0.0429, 0.0512, 0.0748];
    let (vehicle, g) = (&model.vehicle, model.gravity);
    let n = Wrench::new(0.05, -1.1, 0.7, 2.0);
    for t in [0.2, 1.1, 3.7] {
        let at = flat(&waving(t));
        let (commanded, slope) = flatness::commanded_and_jacobian(vehicle, g, TAU, &at);
        assert_eq!(commanded, flatness::commanded(vehicle, g, TAU, &at));
        let curvature = flatness::commanded_curvature(vehicle, g, TAU, &at, &n);
        for i in 0..COMMAND_INPUTS {
            let h = 1e-4 * (1.0 + at[i].abs());
            let moved = |by: f64| {
                let mut state = at;
                state[i] += by;
                flatness::commanded_and_jacobian(vehicle, g, TAU, &state)
            };
            let (ahead, behind) = (moved(h), moved(-h));
            let wanted = (ahead.0 - behind.0) / (2.0 * h);
            assert!(apart(&slope.column(i).into_owned(), &wanted) < 1e-5 * (1.0 + wanted.amax()), "input {i} at {t}");
            let bent = (ahead.1 - behind.1).transpose() * n / (2.0 * h);
            let size = bent.amax();
            let missed = (curvature.column(i) - bent).amax();
            assert!(missed < 1e-4 * (1.0 + size), "curvature along input {i} at {t}: {missed:e}");
        }
    }
}

/// The constant that plans keep to: twice the motor's, less where rotors never turn slowly, the largest of all.
#[test]
fn the_constant_of_thrust_follows_from_the_motors() {
    let mut model = lagging(octocopter("PPNNPPNN"), 0.04);
    assert!((model.vehicle.rotors[0].time_constant.unwrap() - 0.02).abs() < 1e-12);
    model.vehicle.rotors[3].time_constant = Some(0.03);
    assert!((model.thrust_lag().unwrap() - 0.06).abs() < 1e-12);
    // 437 rad/s is half of 874: (1 + s)/(2 s) = 1.5.
    model.vehicle.rotors.iter_mut().for_each(|r| r.min_speed = 437.0);
    assert!((model.thrust_lag().unwrap() - 0.045).abs() < 1e-12);
    // Below a third nothing changes.
    model.vehicle.rotors.iter_mut().for_each(|r| r.min_speed = 100.0);
    assert!((model.thrust_lag().unwrap() - 0.06).abs() < 1e-12);
}
