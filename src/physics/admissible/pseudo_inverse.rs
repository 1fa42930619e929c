//! The pseudo-inverse allocation (42), and the polytope of wrenches that it produces without clipping
//! (`docs/method/verdicts.md`, "The set reached by the pseudo-inverse").

use crate::actuation::{Actuation, Wrench};
use crate::geometry::polytope::{Equality, Facet, Polytope, intersect};
use crate::geometry::zonotope::{Spanning, Zonotope};
use crate::model::FaultMode;
use nalgebra::Matrix4;

/// Directions of the wrench in which the rotors are weaker than this, relative to the strongest direction, are left out
/// of the inverse.
const WEAK: f64 = 1e-5;

/// Computes the rows of the pseudo-inverse `B^+ = B' (B B')^-1` of (42): the product of `rows[k]` with a wrench is the
/// share of full thrust of rotor k.
///
/// `columns[k]` is the wrench of rotor k at full thrust, in scaled coordinates. (42) minimises the sum of Omega_k^2,
/// where Omega_k is a squared speed, so shares are weighted by `fullest[k]`, the largest squared speed of rotor k over
/// the largest of all rotors. Directions that no remaining rotor produces are left out of the inverse.
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

/// The largest squared speed of each rotor over the largest of all rotors.
pub(crate) fn fullest(actuation: &Actuation) -> Vec<f64> {
    let fastest = actuation.max_square.iter().copied().fold(0.0, f64::max);
    actuation.max_square.iter().map(|square| square / fastest).collect()
}

/// The facets of the set of wrenches for which no squared speed of `A_theta^+ (w - c)` leaves its bounds, where c is
/// the wrench of stuck rotors. There are two rows for each working rotor; redundant ones are dropped. Each facet is
/// spanned by all rotors except those that are at a bound on it. `equalities` are those of the mode's zonotope.
pub(super) fn facets(
    actuation: &Actuation,
    fault: Option<&FaultMode>,
    zonotope: &Zonotope<4>,
    equalities: &[Equality<4>],
) -> Vec<Facet<4, Spanning>> {
    let n = actuation.rotors();
    let stuck = |k: usize| fault.and_then(|f| f.rotors[k].stuck_at());
    let scale = zonotope.scale();
    let columns: Vec<Wrench> = (0..n)
        .map(|k| match stuck(k) {
            Some(_) => Wrench::zeros(),
            None => actuation.full(k).component_div(&scale) * fault.map_or(1.0, |f| f.rotors[k].capacity()),
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
    // If the lowest speeds leave no wrench at all, the rows are infeasible together and none of them is redundant.
    let middle = zonotope.offset + 0.5 * zonotope.generators.iter().sum::<Wrench>();
    let Some(inside) = whole.nearest(&middle) else { return whole.facets };
    let merged = |f: Facet<4, Vec<Spanning>>| Facet {
        normal: f.normal,
        offset: f.offset,
        origin: Spanning(f.origin.iter().fold(all, |common, s| common & s.0)),
    };
    intersect(&[&whole], &inside, &scale).facets.into_iter().map(merged).collect()
}
