//! Other readings of (31), to find the one that the paper's numbers match.

use mavc::actuation::{Actuation, Wrench};
use mavc::admissible::verdict::analyze;
use mavc::admissible::{AdmissibleSet, hover};
use mavc::geometry::zonotope::Zonotope;
use mavc::model::Model;
use nalgebra::{DMatrix, DVector};

/// e_p if the thrusts are those of the pseudo-inverse, clipped to the range of each rotor, as (42) would allocate
/// hover.
pub fn clipped_pseudo_inverse(model: &Model, lost: &[usize]) -> Wrench {
    let actuation = Actuation::of(&model.vehicle);
    let left: Vec<Wrench> =
        (0..actuation.rotors()).filter(|k| !lost.contains(&(k + 1))).map(|k| actuation.full(k)).collect();
    let a = DMatrix::from_fn(4, left.len(), |i, k| left[k][i]);
    let u = hover(model);
    let inverse = a.clone().pseudo_inverse(1e-12).expect("a tolerance that is not negative");
    let shares = (inverse * DVector::from_column_slice(u.as_slice())).map(|share| share.clamp(0.0, 1.0));
    Wrench::from_column_slice((a * shares).as_slice()) - u
}

/// Length (N m) of the least torque residual where the thrust is held at m g.
pub fn torque_with_thrust_held(model: &Model, set: &AdmissibleSet) -> f64 {
    // With this weight a newton is not traded for any torque of these vehicles.
    const HEAVY: f64 = 1e4;
    let weigh = |w: &Wrench| Wrench::new(HEAVY * w[0], w[1], w[2], w[3]);
    let zonotope = Zonotope {
        offset: weigh(&set.zonotope.offset),
        generators: set.zonotope.generators.iter().map(weigh).collect(),
    };
    let u = weigh(&hover(model));
    (zonotope.nearest(&u) - u).fixed_rows::<3>(1).norm()
}

/// The PPNNPN hexacopter with the third row of (12) as printed: the sines of rotors 3 and 6 have the opposite sign,
/// which puts rotor 6 on rotor 2 and rotor 3 on rotor 5.
pub fn with_printed_twelve(model: &Model) -> Model {
    let mut printed = model.clone();
    for rotor in [3, 6] {
        printed.vehicle.rotors[rotor - 1].position[0] *= -1.0;
    }
    printed
}

/// The mass (kg, from the model's to thrice it) at which the least residual of a loss has a given length, and that
/// residual.
pub fn mass_that_leaves(model: &Model, lost: &[usize], length: f64) -> Option<(f64, [f64; 4])> {
    let mode = model.modes.iter().position(|m| m.lost() == lost)?;
    let residual = |mass: f64| {
        let mut heavier = model.clone();
        heavier.vehicle.mass = mass;
        let e = analyze(&heavier, &AdmissibleSet::of_mode(&heavier, mode)).residual4;
        (e.iter().map(|v| v * v).sum::<f64>().sqrt(), e)
    };
    let (mut low, mut high) = (model.vehicle.mass, 3.0 * model.vehicle.mass);
    if residual(low).0 > length || residual(high).0 < length {
        return None;
    }
    // The residual grows with the mass: 20 halvings leave less than a gram.
    for _ in 0..20 {
        let middle = 0.5 * (low + high);
        if residual(middle).0 < length { low = middle } else { high = middle }
    }
    Some((high, residual(high).1))
}
