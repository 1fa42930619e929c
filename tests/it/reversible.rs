//! Rotors that may reverse: the shifted set, allocation with signed speeds, verdicts, certificates and refusals.

use crate::vehicles::{hexacopter, lost, octocopter};
use mavc::actuation::{Actuation, Wrench, signed_root, signed_square};
use mavc::admissible::allocation;
use mavc::admissible::verdict::{Verdict, analyze};
use mavc::admissible::{AdmissibleSet, faults_only_take, hover};
use mavc::flight::allocate::{Allocator, Belief};
use mavc::model::{Allocation, Model};

/// The vehicle with a lowest thrust of `share` of full thrust.
fn reversible(mut model: Model, share: f64) -> Model {
    for rotor in &mut model.vehicle.rotors {
        rotor.min_speed = rotor.max_speed * signed_root(share);
    }
    model
}

/// Without reversal hover after a loss is on the edge of the set (the table in docs/method.md, section 3).
#[test]
fn reversible_rotors_give_pnpnpn_its_yaw_back() {
    for k in 1..=6 {
        let of = |model: &Model| {
            let mut model = model.clone();
            model.modes = vec![lost(6, &[k])];
            analyze(&model, &AdmissibleSet::of_mode(&model, 0))
        };
        let plain = of(&hexacopter("PNPNPN"));
        let back = of(&reversible(hexacopter("PNPNPN"), -0.4));
        println!("{k}: {:?} {:?} -> {:?} {:?}", plain.acai, plain.critical_mass_kg, back.acai, back.critical_mass_kg);
        assert!(plain.acai.unwrap().abs() < 1e-6);
        assert_eq!(back.verdict, Verdict::Controllable);
        assert!(back.acai.unwrap() > 0.01, "{:?}", back.acai);
    }
}

#[test]
fn the_set_of_equal_reversible_rotors_is_scaled_and_shifted() {
    let (plain, back) = (octocopter("PNPNPNPN"), reversible(octocopter("PNPNPNPN"), -0.4));
    assert!(faults_only_take(&back));
    let ((none, g), (shift, h)) = (Actuation::of(&plain.vehicle).healthy(), Actuation::of(&back.vehicle).healthy());
    assert_eq!(none, Wrench::zeros());
    let full: Wrench = g.iter().sum();
    assert!((shift + full * 0.4).norm() < 1e-12 * full.norm());
    g.iter().zip(&h).for_each(|(g, h)| assert!((h - g * 1.4).norm() < 1e-12 * g.norm()));
}

#[test]
fn allocations_use_negative_speeds_and_give_the_wrench() {
    let model = reversible(hexacopter("PNPNPN"), -0.4);
    let actuation = Actuation::of(&model.vehicle);
    let mut belief = Belief::healthy(6);
    belief.capacity[0] = 0.0;
    let mut flying = Allocator::new(&model, Allocation::Bounded);
    flying.believe(&belief);
    let mut reversed = 0;
    for sign in [-1.0, 1.0] {
        let wrench = hover(&model) + Wrench::new(0.0, 0.0, 0.0, 0.02 * sign);
        let mut speeds = vec![0.0; 6];
        flying.speeds(&wrench, &mut speeds);
        speeds[0] = 0.0;
        let given: Wrench =
            speeds.iter().enumerate().map(|(k, w)| actuation.effectiveness.column(k) * signed_square(*w)).sum();
        assert!((given - wrench).norm() < 1e-3, "{given} {wrench}");
        reversed += speeds.iter().filter(|w| **w < -1.0).count();
        let healthy =
            allocation::Allocator::new(&model.vehicle).speeds(&(wrench * 0.0 + Wrench::new(0.0, 0.8, 0.0, 0.0)));
        let given: Wrench =
            healthy.iter().enumerate().map(|(k, w)| actuation.effectiveness.column(k) * signed_square(*w)).sum();
        assert!((given - Wrench::new(0.0, 0.8, 0.0, 0.0)).norm() < 1e-6 && healthy.iter().any(|w| *w < -1.0));
    }
    assert_eq!(reversed, 1, "rotor 4 reverses for one of the two directions");
}
