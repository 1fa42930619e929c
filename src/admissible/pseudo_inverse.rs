//! What the pseudo-inverse (42) gives without clipping.

use crate::actuation::{Actuation, Wrench};
use crate::geometry::polytope::{Equality, Facet, Polytope, intersect};
use crate::geometry::zonotope::{Spanning, Zonotope};
use crate::model::FaultMode;
use nalgebra::Matrix4;

/// Directions of the wrench that the rotors give more weakly than this, against the strongest, are given up by (42).
const WEAK: f64 = 1e-5;

/// `rows[k]` becomes row k of B^+ = B^T (B B^T)^-1 of (42): its product with a wrench is rotor k's share of full
/// thrust. `columns[k]` is what the rotor gives at full thrust, in scaled coordinates; (42) minimises squared speeds
/// squared, and `fullest[k]` is rotor k's largest one over the largest of all. Where rotors are gone that gave a
/// direction alone, the inverse is without that direction.
pub fn inverse(columns: &[Wrench], fullest: &[f64], rows: &mut [Wrench]) {
    let weight = |k: usize| fullest[k].powi(-2);
    let square: Matrix4<f64> = columns.iter().enumerate().map(|(k, b)| b * b.transpose() * weight(k)).sum();
    let eigen = square.symmetric_eigen();
    let least = WEAK * WEAK * eigen.eigenvalues.max();
    let inverse = eigen.eigenvalues.map(|e| if e > least { 1.0 / e } else { 0.0 });
    let inverse = eigen.eigenvectors * Matrix4::from_diagonal(&inverse) * eigen.eigenvectors.transpose();
    for (k, row) in rows.iter_mut().enumerate() {
        *row = inverse * columns[k] * weight(k);
    }
}

/// Rotor by rotor, its largest squared speed over the largest of all.
pub fn fullest(actuation: &Actuation) -> Vec<f64> {
    let fastest = actuation.max_square.iter().copied().fold(0.0, f64::max);
    actuation.max_square.iter().map(|square| square / fastest).collect()
}

/// The facets of the wrenches w for which no squared speed of `A_theta^+ w` leaves its bounds, within the equalities of
/// the mode's zonotope: two rows for each working rotor, redundant ones out. Each is spanned by all rotors but those
/// that stand at a bound on it.
pub(super) fn facets(
    actuation: &Actuation,
    fault: Option<&FaultMode>,
    zonotope: &Zonotope<4>,
    equalities: &[Equality<4>],
) -> Vec<Facet<4, Spanning>> {
    let n = actuation.rotors();
    let stuck = |k: usize| fault.and_then(|f| f.stuck[k]);
    let scale = zonotope.scale();
    let columns: Vec<Wrench> = (0..n)
        .map(|k| match stuck(k) {
            Some(_) => Wrench::zeros(),
            None => actuation.full(k).component_div(&scale) * fault.map_or(1.0, |f| f.capacity[k]),
        })
        .collect();
    let mut rows = vec![Wrench::zeros(); n];
    inverse(&columns, &fullest(actuation), &mut rows);
    let shift: Wrench = (0..n).filter_map(|k| stuck(k).map(|share| actuation.full(k) * share)).sum();
    let all = (1u64 << n) - 1;
    let mut facets = Vec::new();
    for k in (0..n).filter(|&k| columns[k].norm() > 0.0) {
        let normal = rows[k].component_div(&scale);
        let (length, at_shift) = (normal.norm(), normal.dot(&shift));
        let least = actuation.min_square[k] / actuation.max_square[k];
        for (normal, offset) in [(normal, 1.0 + at_shift), (-normal, -least - at_shift)] {
            let origin = Spanning(all & !(1 << k));
            facets.push(Facet { normal: normal / length, offset: offset / length, origin });
        }
    }
    let whole = Polytope { equalities: equalities.to_vec(), facets };
    // Where idling rotors leave no wrench at all, the rows contradict each other: none is redundant.
    let middle = zonotope.center + 0.5 * zonotope.generators.iter().sum::<Wrench>();
    let Some(inside) = whole.nearest(&middle) else { return whole.facets };
    let merged = |f: Facet<4, Vec<Spanning>>| Facet {
        normal: f.normal,
        offset: f.offset,
        origin: Spanning(f.origin.iter().fold(all, |common, s| common & s.0)),
    };
    intersect(&[&whole], &inside, &scale).facets.into_iter().map(merged).collect()
}
