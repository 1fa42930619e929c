//! Vehicles and sensors that differ from what the controller assumes.

use super::{quiet, seen, sortie, staying};
use crate::intervals::uncertain;
use crate::vehicles::octocopter;
use mavc::flight::air::TorqueGusts;
use mavc::flight::{Sortie, fly};
use mavc::model::{FlownVehicle, Model};
use nalgebra::Vector3;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::SeedableRng;

/// Hover without noise for `duration` s; the last position.
fn hover(model: &Model, seed: u64, duration: f64) -> Vector3<f64> {
    let trajectory = staying([0.0, 0.0, 10.0], 0.0, duration);
    let (_, places) = seen(&Sortie { seed, ..sortie(model, &trajectory, &[]) }, |s| s.body.position);
    places[places.len() - 1]
}

/// Without a term that integrates, a torque m g d tilts the thrust by m g d/(J k_R) against the attitude that the
/// controller believes to hold, and the place gives way by g/k_x times this angle.
#[test]
fn a_centre_of_gravity_that_is_off_moves_the_vehicle() {
    let mut model = quiet(octocopter("PPNNPPNN"));
    let most = 1e-3;
    model.simulation.centre_offset = most;
    let [jx, ..] = model.vehicle.inertia;
    let per_metre = model.gravity / model.simulation.gains.position
        * (model.vehicle.mass * model.gravity / (jx * model.simulation.gains.attitude));
    let moved: Vec<Vector3<f64>> = (0..20).map(|seed| hover(&model, seed, 12.0)).collect();
    // Every offset is within the square, and the largest of forty coordinates is near its edge.
    let largest = moved.iter().map(|p| p.xy().amax()).fold(0.0, f64::max) / per_metre;
    assert!(largest < 1.02 * most && largest > 0.85 * most, "{largest} {moved:?}");
    let mean = moved.iter().map(Vector3::xy).sum::<nalgebra::Vector2<f64>>() / (20.0 * per_metre);
    assert!(mean.amax() < 0.4 * most, "{mean}");
}

/// A vehicle that is drawn from its intervals flies otherwise for every seed, and the same for the same; one without
/// intervals, or with the middles, does not depend on the seed.
#[test]
fn parameters_are_drawn_by_the_seed() {
    let mut model = quiet(uncertain(octocopter("PPNNPPNN"), 0.0, 0.05, 0.0));
    let heights = |model: &Model| [1, 2, 1].map(|seed| hover(model, seed, 3.0).z);
    let [a, b, again] = heights(&model);
    assert!(a == b && a == again, "{a} {b}");
    model.simulation.spread = FlownVehicle::Drawn;
    let [a, b, again] = heights(&model);
    assert!((a - b).abs() > 1e-4 && a == again, "{a} {b}");
    // Thrusts within 5 % give way by at most g/k_z times as much, plus what the mass does.
    assert!(
        [a, b].iter().all(|z| (z - 10.0).abs() < 0.11 * model.gravity / model.simulation.gains.altitude),
        "{a} {b}"
    );
}

/// Torques of gusts: standard deviation and correlation of the process, and none without.
#[test]
fn torque_gusts_have_their_deviation_and_bandwidth() {
    let (sigma, span, speed, h) = (0.2, 0.5, 5.0, 0.002);
    let mut random = Pcg64Mcg::seed_from_u64(7);
    let mut gusts = TorqueGusts::new(sigma, span, speed, h, &mut random);
    let all: Vec<Vector3<f64>> = (0..400_000).map(|_| gusts.next(&mut random)).collect();
    let rate = std::f64::consts::PI * speed / (4.0 * span);
    let lag = (1.0 / (rate * h)).round() as usize;
    for axis in 0..3 {
        let n = (all.len() - lag) as f64;
        let product = |shift: usize| all.iter().zip(&all[shift..]).map(|(a, b)| a[axis] * b[axis]).sum::<f64>() / n;
        let (variance, later) = (product(0), product(lag));
        assert!((variance.sqrt() / sigma - 1.0).abs() < 0.05, "{variance}");
        assert!((later / variance - (-1.0_f64).exp()).abs() < 0.06, "{later} {variance}");
    }
    let mut none = TorqueGusts::new(0.0, span, speed, h, &mut random);
    let before = random.clone();
    assert_eq!((none.next(&mut random), random), (Vector3::zeros(), before));
}

/// An attitude that is estimated is the true one where nothing saturates and nothing is noisy; with a gyroscope that
/// ends below the rates it is not, and the vehicle leaves its place.
#[test]
fn an_estimated_attitude_is_off_beyond_the_range_of_the_gyroscope() {
    let text =
        include_str!("../../specs/flown/fast_spin.mav").replace("after_fault", "attitude = estimated; after_fault");
    let spec = mavc::compile(&text).into_result().unwrap();
    let mut model = spec.model().clone();
    (model.simulation.gyroscope_noise, model.simulation.position_noise) = (0.0, 0.0);
    model.simulation.lost_beyond = 1e3;
    let trajectory = staying([0.0, 0.0, 500.0], 0.0, 60.0);
    let strikes = [super::strike(0, 1.0)];
    let end = |model: &Model| fly(&sortie(model, &trajectory, &strikes), None).rms_error_after;
    let limited = end(&model);
    model.simulation.gyroscope_range = 200.0;
    let (wide, exact) = (end(&model), {
        model.simulation.attitude = mavc::model::Attitude::Exact;
        end(&model)
    });
    assert!((wide - exact).abs() < 0.05 * exact, "{wide} {exact}");
    assert!(limited > 1.2 * exact, "{limited} {exact}");
}
