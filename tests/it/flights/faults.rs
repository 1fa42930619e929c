//! Double losses struck into hover, against the verdicts on what they leave.

use super::{quiet, sortie, staying, strike};
use crate::vehicles::{hexacopter, lost, octocopter, quadcopter};
use mavc::actuation::Actuation;
use mavc::admissible::AdmissibleSet;
use mavc::admissible::verdict::{HoverVerdict, analyze};
use mavc::flight::{Sortie, fly};
use mavc::model::{Detection, LostYaw, Model, RotorState};
use nalgebra::Vector3;

/// All losses of two rotors.
fn with_pairs(mut model: Model) -> Model {
    let n = model.vehicle.rotors.len();
    let pairs = (1..=n).flat_map(|i| (i + 1..=n).map(move |j| [i, j]));
    model.modes = pairs.map(|pair| lost(&model, &pair)).collect();
    model
}

/// Verdict and margin: of the whole wrench, or without yaw where yaw is what is lost.
fn margin(model: &Model, mode: usize) -> (HoverVerdict, f64) {
    let record = analyze(model, &AdmissibleSet::of_mode(model, mode));
    let margin = match record.verdict {
        HoverVerdict::Controllable => record.acai,
        _ => record.acai_yaw_free,
    };
    (record.verdict, margin.unwrap_or(0.0))
}

/// Struck at 2 s into hover at 10 m, at rest; whether the vehicle is still there at 12 s, whatever its heading.
fn survives(model: &Model, mode: usize, seed: u64) -> bool {
    let mut model = model.clone();
    model.simulation.lost_yaw = LostYaw::Off;
    let plan = staying([0.0, 0.0, 10.0], 0.0, 12.0);
    let strikes = [strike(mode, 2.0)];
    fly(&Sortie { seed, ..sortie(&model, &plan, &strikes) }, None).outcome.is_survived()
}

/// Without noise, and with the mode known after 0.1 s.
fn told(model: Model) -> Model {
    let mut model = quiet(model);
    model.simulation.detection = Detection::After(0.1);
    model
}

/// Margins above this are enough to survive 0.1 s without knowing: N, N m.
const ENOUGH: f64 = 0.01;

#[test]
fn octocopters_with_a_margin_survive_known_double_losses() {
    for layout in ["PPNNPPNN", "PNPNPNPN"] {
        let model = told(with_pairs(octocopter(layout)));
        assert_eq!(model.modes.len(), 28);
        for mode in 0..28 {
            let (verdict, margin) = margin(&model, mode);
            assert!(verdict != HoverVerdict::Unstable && margin > ENOUGH);
            assert!(survives(&model, mode, 1), "{layout} {}: {verdict:?} {margin}", model.modes[mode].name);
        }
    }
}

#[test]
fn the_unstable_fall_and_those_with_a_margin_do_not() {
    let mut quad = quadcopter();
    quad.modes = (1..=4).map(|k| lost(&quad, &[k])).chain(with_pairs(quad.clone()).modes).collect();
    let triples = |model: Model| {
        let three = [[1, 2, 8], [2, 3, 4], [1, 3, 8]].map(|rotors| lost(&model, &rotors));
        Model { modes: three.to_vec(), ..model }
    };
    let models = [
        with_pairs(hexacopter("PNPNPN")),
        with_pairs(hexacopter("PPNNPN")),
        quad,
        triples(octocopter("PPNNPPNN")),
        triples(octocopter("PNPNPNPN")),
    ];
    let (mut fell, mut flew, mut between) = (0, 0, 0);
    for model in models {
        let model = told(model);
        for mode in 0..model.modes.len() {
            let (verdict, margin) = margin(&model, mode);
            let survives = survives(&model, mode, 1);
            let name = format!("{:?} {}: {verdict:?} {margin}", model.vehicle.layout, model.modes[mode].name);
            match verdict {
                HoverVerdict::Unstable => {
                    assert!(!survives, "{name}");
                    fell += 1;
                }
                _ if margin > ENOUGH => {
                    assert!(survives, "{name}");
                    flew += 1;
                }
                // On the boundary of what can be had; a quadcopter with three rotors hovers on two.
                _ => between += 1,
            }
        }
    }
    assert!(fell >= 18 && flew >= 15 && between >= 4, "{fell} {flew} {between}");
}

/// What of the torque in hover a loss takes away, in standard deviations of a torque sample: two rate samples 10 ms
/// apart. Below the estimator's 4 it cannot tell the loss from none until something else moves the vehicle.
fn felt(model: &Model, mode: usize) -> f64 {
    let a = Actuation::of(&model.vehicle).effectiveness;
    let square = 1.8 * 9.81 / (8.0 * 8.5485e-6);
    let noise = Vector3::from(model.vehicle.inertia) * (0.005 * 2f64.sqrt() / 0.01);
    let taken =
        model.modes[mode].lost().iter().fold(Vector3::zeros(), |sum, k| sum + a.column(k - 1).fixed_rows::<3>(1));
    (taken * square).component_div(&noise).amax()
}

#[test]
fn by_the_estimator_alone_double_losses_that_are_felt_are_survived() {
    let model = with_pairs(octocopter("PPNNPPNN"));
    assert_eq!(model.simulation.detection, Detection::Estimator);
    // Torques of opposite rotors cancel except for their drag, 0.07 N m, which is 1.3 standard deviations.
    let hidden: Vec<usize> = (0..28).filter(|mode| felt(&model, *mode) < 4.0).collect();
    let names: Vec<&str> = hidden.iter().map(|mode| model.modes[*mode].name.as_str()).collect();
    assert_eq!(names, ["M1_5", "M2_6", "M3_7", "M4_8"]);
    for mode in (0..28).filter(|mode| !hidden.contains(mode)) {
        let (verdict, margin) = margin(&model, mode);
        assert!(verdict != HoverVerdict::Unstable && margin > 0.1, "all have more than this");
        for seed in 1..=3 {
            assert!(survives(&model, mode, seed), "{} seed {seed}: {verdict:?} {margin}", model.modes[mode].name);
        }
    }
}

/// Beliefs and thrusts at the end of 12 s in hover, with noise: (believed, given, wanted).
fn ends(model: &Model, strikes: &[mavc::model::Strike]) -> (Vec<f64>, f64, f64) {
    let plan = staying([0.0, 0.0, 10.0], 0.0, 12.0);
    let mut last = (Vec::new(), 0.0, 0.0);
    let flight =
        fly(&sortie(model, &plan, strikes), Some(&mut |s| last = (s.believed.to_vec(), s.wrench[0], s.wanted[0])));
    assert!(!flight.outcome.is_lost(), "{flight:?}");
    last
}

/// A loss of a quarter is less than single samples of the gyroscope show, but their mean shows it.
#[test]
fn small_losses_are_isolated() {
    let mut model = octocopter("PPNNPPNN");
    model.simulation.detection = Detection::Estimator;
    for rotor in 0..8 {
        let mut weak = lost(&model, &[]);
        weak.rotors[rotor] = RotorState::Reduced(0.75);
        model.modes = vec![weak];
        let plan = staying([0.0, 0.0, 10.0], 0.0, 8.0);
        let flight = fly(&sortie(&model, &plan, &[strike(0, 4.0)]), None);
        let after = flight.found[0].isolated_after;
        assert!(after.is_some_and(|t| t < 1.0) && flight.false_alarms == 0, "rotor {rotor}: {after:?}");
    }
}

/// Lost or weakened, a rotor that works again is believed again, and no other pays for it.
#[test]
fn rotors_that_recover_are_believed_again() {
    let mut model = octocopter("PPNNPPNN");
    model.simulation.detection = Detection::Estimator;
    let mut weak = lost(&model, &[4]);
    weak.rotors[3] = RotorState::Reduced(0.6);
    model.modes = vec![lost(&model, &[3]), weak];
    for mode in 0..2 {
        let strikes = [mavc::model::Strike { until: Some(6.0), ..strike(mode, 2.0) }];
        let (believed, ..) = ends(&model, &strikes);
        assert!(believed.iter().all(|b| *b > 0.8), "{}: {believed:?}", model.modes[mode].name);
    }
}

/// The controller counts neither on a rotor that is stuck and then lost, nor on one that is lost and then stuck.
#[test]
fn a_stuck_rotor_that_is_lost_gives_nothing() {
    let mut model = told(octocopter("PPNNPPNN"));
    let mut stuck = lost(&model, &[3]);
    stuck.rotors[2] = RotorState::Stuck(0.5);
    model.modes = vec![lost(&model, &[3]), stuck];
    for order in [[0, 1], [1, 0]] {
        let (_, given, wanted) = ends(&model, &[strike(order[0], 2.0), strike(order[1], 3.0)]);
        assert!((given - wanted).abs() < 0.01 * wanted, "{given} N given, {wanted} N wanted");
    }
}
