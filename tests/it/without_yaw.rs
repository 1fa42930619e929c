//! Hover with yaw given up: the core of each mode, spins and equilibria, against figures computed by other code,
//! published ones and brute force.

mod plans;

use crate::vehicles::{lost, ring_model};
use mavc::admissible::verdict::{ModeAnalysis, analyze};
use mavc::admissible::without_yaw::relaxed_hover::{RelaxedHover, System};
use mavc::admissible::without_yaw::{WithoutYaw, YawFree, core};
use mavc::admissible::{AdmissibleSet, verdict};
use mavc::model::{Model, Spread, YawDrag};
use nalgebra::{Vector3, Vector4};

/// The drag of Mueller and D'Andrea's vehicle.
const DRAG: YawDrag = YawDrag { linear: 2.75e-3, spread: Spread::NONE, quadratic: 0.0 };

/// The paper's vehicles with a drag about z and a mode without some rotors.
fn without(kind: &str, layout: &str, rotors: &[usize]) -> Model {
    let mut model = match kind {
        "quad" => ring_model(layout, 1.32, [0.0128, 0.0128, 0.0239], 9.9865e-6, 1.5978e-7, 840.0),
        "hexa" => ring_model(layout, 1.54, [0.0168, 0.0168, 0.0308], 8.5485e-6, 1.3678e-7, 874.0),
        _ => ring_model(layout, 1.8, [0.0429, 0.0429, 0.0748], 8.5485e-6, 1.3678e-7, 874.0),
    };
    model.vehicle.yaw_drag = Some(DRAG);
    if !rotors.is_empty() {
        model.modes.push(lost(&model, rotors));
    }
    model
}

fn set(model: &Model) -> AdmissibleSet {
    if model.modes.is_empty() { AdmissibleSet::healthy(model) } else { AdmissibleSet::of_mode(model, 0) }
}

fn analysis(model: &Model) -> ModeAnalysis {
    analyze(model, &set(model))
}

#[track_caller]
fn near(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value} instead of {expected}");
}

/// Vehicle, layout, lost rotors, word; disc (N m), largest level thrust (N), yaw torques (N m), spins (rad/s): computed
/// twice by independent code, given to the digits shown.
type Row = (&'static str, &'static str, &'static [usize], YawFree, f64, f64, [f64; 2], [f64; 2]);
const TABLE: [Row; 10] = [
    ("quad", "PNPN", &[], YawFree::Interior, 1.487, 28.19, [-0.2072, 0.2072], [-75.3, 75.3]),
    ("quad", "PNPN", &[1], YawFree::Spinning, 0.0, 14.09, [0.2072, 0.2072], [75.3, 75.3]),
    ("hexa", "PNPNPN", &[], YawFree::Interior, 2.283, 39.18, [-0.2417, 0.2417], [-87.9, 87.9]),
    ("hexa", "PNPNPN", &[1], YawFree::Interior, 1.1618, 26.12, [0.0, 0.2417], [0.0, 87.9]),
    ("hexa", "PNPNPN", &[1, 4], YawFree::Interior, 1.1618, 26.12, [0.0, 0.0], [0.0, 0.0]),
    ("hexa", "PNPNPN", &[1, 3], YawFree::Interior, 0.4729, 19.59, [0.0983, 0.2417], [35.7, 87.9]),
    ("hexa", "PPNNPN", &[5], YawFree::Interior, 1.1618, 26.12, [0.03276, 0.2090], [11.9, 76.0]),
    ("hexa", "PPNNPN", &[6], YawFree::Interior, 1.1618, 26.12, [-0.2090, -0.03276], [-76.0, -11.9]),
    ("octo", "PPNNPPNN", &[1, 2], YawFree::Interior, 0.6833, 26.12, [0.1170, 0.2825], [42.6, 102.7]),
    ("octo", "PPNNPPNN", &[3, 4], YawFree::Interior, 0.6833, 26.12, [-0.2825, -0.1170], [-102.7, -42.6]),
];

#[test]
fn the_figures_are_those_of_other_code() {
    for (kind, layout, rotors, word, disc, level, torque, spin) in TABLE {
        let found = analysis(&without(kind, layout, rotors));
        assert_eq!(found.yaw_free, word, "{layout} {rotors:?}");
        let WithoutYaw { disc_n_m, level_thrust_n, yaw_torque_n_m, spin_rad_s, .. } = found.without_yaw.unwrap();
        near(disc_n_m, disc, 6e-4);
        near(level_thrust_n, level, 6e-3);
        for end in 0..2 {
            near(yaw_torque_n_m[end], torque[end], 6e-5);
            near(spin_rad_s.unwrap()[end], spin[end], 0.06);
        }
    }
    let neighbours = analysis(&without("hexa", "PNPNPN", &[1, 2]));
    assert_eq!((neighbours.yaw_free, neighbours.without_yaw), (YawFree::None, None));
    near(neighbours.critical_mass_yaw_free_kg.unwrap() * 9.81, 13.06, 6e-3);
}

/// The equilibrium with the largest disc of a quadcopter that lost a rotor: 0.71 N m, axis tilted by 3.7 degrees, 32.8
/// rad/s.
#[test]
fn a_quadcopter_keeps_the_largest_disc_with_a_tilted_axis() {
    let found = analysis(&without("quad", "PNPN", &[1])).without_yaw.unwrap();
    let [level, tilted] = &found.relaxed_hover[..] else { panic!("{found:?}") };
    assert_eq!((level.axis_tilt_deg, level.circle_radius_m, level.disc_n_m), (0.0, 0.0, 0.0));
    near(level.body_rates_rad_s[2], 75.34, 0.01);
    near(tilted.disc_n_m, 0.71, 0.006);
    near(tilted.axis_tilt_deg, 3.7, 0.06);
    near(Vector3::from(tilted.body_rates_rad_s).norm(), 32.8, 0.15);
    for (thrust, expected) in tilted.thrusts_n.iter().zip([0.0, 4.65, 3.67, 4.65]) {
        near(*thrust, expected, 0.01);
    }
    near(tilted.circle_radius_m, 9.81 * tilted.axis_tilt_deg.to_radians().tan() / 32.86_f64.powi(2), 1e-5);
    is_an_equilibrium(&without("quad", "PNPN", &[1]), tilted);
    // Power goes with the thrusts to 1.5; hover takes 3.237 N of each of four rotors.
    let power = |thrusts: &[f64]| thrusts.iter().map(|f| f.powf(1.5)).sum::<f64>();
    near(tilted.power_ratio, power(&tilted.thrusts_n) / power(&[1.32 * 9.81 / 4.0; 4]), 1e-9);
}

/// A vehicle that is turned by 45 degrees about z has the same disc, and thrusts that mirror each other beside the lost
/// rotor.
#[test]
fn the_largest_disc_does_not_depend_on_the_axes() {
    let mut model = without("quad", "PNPN", &[1]);
    let straight = analysis(&model).without_yaw.unwrap().relaxed_hover[1].clone();
    let half = std::f64::consts::FRAC_1_SQRT_2;
    for rotor in &mut model.vehicle.rotors {
        let [x, y, z] = rotor.position;
        rotor.position = [half * (x - y), half * (x + y), z];
    }
    let turned = analysis(&model).without_yaw.unwrap().relaxed_hover[1].clone();
    near(turned.disc_n_m, straight.disc_n_m, 1e-4);
    near(turned.thrusts_n[1], turned.thrusts_n[3], 0.02);
}

/// Newton and Euler, from the thrusts alone.
fn is_an_equilibrium(model: &Model, found: &RelaxedHover) {
    let vehicle = &model.vehicle;
    let w = Vector3::from(found.body_rates_rad_s);
    let (mut wrench, mut momentum) = (Vector4::zeros(), 0.0);
    for (rotor, thrust) in vehicle.rotors.iter().zip(&found.thrusts_n) {
        let way = if rotor.spin == mavc::model::Spin::P { 1.0 } else { -1.0 };
        let [x, y, _] = rotor.position;
        let torque = -way * rotor.drag_coefficient / rotor.thrust_coefficient;
        wrench += Vector4::new(1.0, y, -x, torque) * *thrust;
        momentum += way * rotor.inertia * (thrust / rotor.thrust_coefficient).sqrt();
    }
    let angular = Vector3::from(vehicle.inertia).component_mul(&w) + Vector3::z() * momentum;
    let drag = vehicle.yaw_drag.unwrap().torque(w.z);
    let rest = w.cross(&angular) - Vector3::new(wrench[1], wrench[2], wrench[3] - drag);
    assert!(rest.amax() < 1e-6, "{rest} {found:?}");
    near(wrench[0] * (w.z / w.norm()).abs(), vehicle.mass * model.gravity, 1e-6);
}

/// M. W. Mueller, R. D'Andrea, *Stability and control of a quadrocopter despite the complete loss of one, two, or three
/// propellers*, ICRA 2014, doi 10.1109/ICRA.2014.6906588.
fn published(rotors: &[usize]) -> Model {
    let (kf, arm) = (6.41e-6, 0.17);
    let mut model = ring_model("PNPN", 0.5, [3.2e-3, 3.2e-3, 5.5e-3], kf, 1.69e-2 * kf, (3.8_f64 / kf).sqrt());
    for rotor in &mut model.vehicle.rotors {
        rotor.position = rotor.position.map(|x| x * arm / 0.211);
        rotor.inertia = 1.5e-5;
    }
    model.vehicle.yaw_drag = Some(DRAG);
    model.modes.push(lost(&model, rotors));
    model
}

#[test]
fn published_equilibria_are_found() {
    // One rotor lost, with half the thrust on the rotor opposite.
    let model = published(&[4]);
    let set = set(&model);
    let projection = verdict::without_yaw(&set.zonotope).facets().without_origins();
    let system = System::new(&model, &set, &projection, DRAG);
    let lost_at = Vector3::from(model.vehicle.rotors[3].position).normalize();
    let ratio = |found: &RelaxedHover| found.thrusts_n[1] / found.thrusts_n[0];
    let about = |tilt: f64| {
        let turned = |side: f64| Vector3::z() * tilt.cos() + lost_at.cross(&Vector3::z()) * (side * tilt.sin());
        let along = |side: f64| Vector3::z() * tilt.cos() + lost_at * (side * tilt.sin());
        let axes = [turned(1.0), turned(-1.0), along(1.0), along(-1.0)];
        let all =
            axes.iter().flat_map(|axis| system.about(axis)).filter(|f| (f.thrusts_n[0] - f.thrusts_n[2]).abs() < 1e-6);
        all.min_by(|a, b| (ratio(a) - 0.5).abs().total_cmp(&(ratio(b) - 0.5).abs())).unwrap()
    };
    let tilts = (0..80).map(|k| 0.25 + 0.001 * f64::from(k));
    let found = tilts.map(about).min_by(|a, b| (ratio(a) - 0.5).abs().total_cmp(&(ratio(b) - 0.5).abs())).unwrap();
    near(ratio(&found), 0.5, 5e-3);
    is_an_equilibrium(&model, &found);
    let [across, along] = [Vector3::from(found.body_rates_rad_s).xy().norm(), found.body_rates_rad_s[2].abs()];
    near(across, 5.69, 0.06 * 5.69);
    near(along, 18.89, 0.005 * 18.89);
    near(found.thrusts_n[0], 2.05, 0.005 * 2.05);
    near(found.thrusts_n[1], 1.02, 0.005 * 1.02 + 0.005);

    // Two opposite rotors lost: a spin about z.
    let model = published(&[2, 4]);
    let found = analysis(&model);
    assert_eq!(found.yaw_free, YawFree::Spinning);
    let spin = found.without_yaw.unwrap().spin_rad_s.unwrap();
    near(spin[0].abs(), 30.14, 0.01);
    near(spin[0], spin[1], 1e-9);
}

/// The disc against wrenches: on its rim every heading of the body produces the torque, and a little outside one does
/// not.
#[test]
fn the_core_is_what_every_heading_leaves() {
    for (kind, layout, rotors) in
        [("hexa", "PNPNPN", &[1, 3][..]), ("octo", "PPNNPPNN", &[1, 2]), ("octo", "PNPNPNPN", &[1])]
    {
        let model = without(kind, layout, rotors);
        let shadow = verdict::without_yaw(&set(&model).zonotope);
        let weight = model.vehicle.mass * model.gravity;
        for thrust in [0.6 * weight, weight, 1.2 * weight] {
            let projection = shadow.facets().without_origins();
            let Some(rho) = core::disc(&projection, thrust, [0.0; 2], 1e-6) else { continue };
            let missing = |radius: f64| {
                let headings = (0..720).map(|k| f64::from(k).to_radians() / 2.0);
                let at = |heading: f64| Vector3::new(thrust, radius * heading.cos(), radius * heading.sin());
                headings.map(|heading| (shadow.nearest(&at(heading)) - at(heading)).norm()).fold(0.0, f64::max)
            };
            assert!(missing(0.999 * rho) < 1e-7, "{layout} {rotors:?} {thrust}");
            assert!(missing(1.001 * rho + 1e-4) > 1e-5, "{layout} {rotors:?} {thrust}");
        }
    }
}

#[test]
fn an_interval_of_the_drag_is_one_of_the_spin() {
    let mut model = without("hexa", "PNPNPN", &[1, 3]);
    model.vehicle.yaw_drag = Some(YawDrag { spread: Spread { low: 0.8, high: 1.25 }, ..DRAG });
    let spin = analysis(&model).without_yaw.unwrap().spin_rad_s.unwrap();
    near(spin[0], 35.74 / 1.25, 0.01);
    near(spin[1], 87.90 / 0.8, 0.02);
}

#[test]
fn without_the_drag_a_spin_is_not_known() {
    let mut model = without("quad", "PNPN", &[1]);
    model.vehicle.yaw_drag = None;
    let found = analysis(&model);
    assert_eq!(found.yaw_free, YawFree::OnEdge);
    let figures = found.without_yaw.unwrap();
    assert_eq!((figures.spin_rad_s, figures.relaxed_hover), (None, Vec::new()));
}
