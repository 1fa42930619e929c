//! An upper bound on the thrust of wrenches inside planes, by multipliers.
//!
//! If `sum lambda_i n_i = e_T` with `lambda_i >= 0`, then every wrench with `n_i.w <= e_i` has a thrust of at most
//! `sum lambda_i e_i` (weak duality of linear programs; Boyd and Vandenberghe, *Convex Optimization*, 2004, section
//! 5.2). The search for multipliers is not trusted: what they show is computed in interval arithmetic.

use super::interval::Interval;
use super::sets::{Plane, along};
use crate::tolerance::MOST_OUTSIDE;
use nalgebra::{Matrix4, Vector4};

/// Most steps of the search.
const STEPS: usize = 200;
/// A plane violated by less, in its own unit and in that of the wrenches' extents, is not violated.
const SATISFIED: f64 = 1e-12;
/// A smaller pivot is none.
const PIVOT: f64 = 1e-9;

/// Multipliers of the planes `n.w <= e` that bound the thrust best, by index; those of the bounds `|w_k| <= extents[k]`
/// (N, N m), which are used too, are left out. The simplex method on the dual, which adds the plane that the furthest
/// wrench violates most.
pub fn multipliers(planes: &[([f64; 4], f64)], extents: [f64; 4]) -> Vec<(usize, f64)> {
    // In units of the extents. A basis begins with the bounds, of which the one on the thrust has the weight 1.
    let column = |i: usize| (Vector4::from_fn(|k, _| planes[i].0[k] * extents[k]), planes[i].1);
    let mut basis: [Option<usize>; 4] = [None; 4];
    let mut weights = Vector4::x();
    for _ in 0..STEPS {
        let columns: [Vector4<f64>; 4] =
            std::array::from_fn(|i| basis[i].map_or(Vector4::ith(i, 1.0), |plane| column(plane).0));
        let Some(inverse) = Matrix4::from_columns(&columns).try_inverse() else { break };
        weights = inverse.column(0).map(|weight| weight.max(0.0));
        let offsets = Vector4::from_fn(|i, _| basis[i].map_or(1.0, |plane| column(plane).1));
        let furthest = inverse.tr_mul(&offsets);
        let violation = |i: usize| column(i).0.dot(&furthest) - column(i).1;
        let violations = (0..planes.len()).map(|i| (i, violation(i)));
        let Some((entering, most)) = violations.max_by(|a, b| a.1.total_cmp(&b.1)) else { break };
        if most.is_nan() || most <= SATISFIED {
            break;
        }
        let direction = inverse * column(entering).0;
        let least = (0..4).filter(|&i| direction[i] > PIVOT).map(|i| weights[i] / direction[i]).reduce(f64::min);
        // Of equal ratios the largest pivot.
        let is_least =
            |i: &usize| direction[*i] > PIVOT && least.is_some_and(|r| weights[*i] <= (r + PIVOT) * direction[*i]);
        let Some(leaving) = (0..4).filter(is_least).max_by(|&a, &b| direction[a].total_cmp(&direction[b])) else {
            break;
        };
        basis[leaving] = Some(entering);
    }
    basis.into_iter().zip(weights.iter()).filter_map(|(i, weight)| Some((i?, weight * extents[0]))).collect()
}

/// An upper bound on the thrust of wrenches that violate no plane by more than the tolerance, N, if `|w_k| <= sizes[k]`
/// (N, N m).
pub(super) fn most_thrust(planes: &[&Plane], sizes: [f64; 4]) -> f64 {
    let rows: Vec<([f64; 4], f64)> =
        planes.iter().map(|plane| (plane.normal.map(Interval::middle), plane.offset.middle() + MOST_OUTSIDE)).collect();
    let weighted = multipliers(&rows, sizes).into_iter().map(|(i, weight)| (weight, planes[i]));
    shown(weighted, MOST_OUTSIDE, &sizes.map(Interval::around_zero)).high
}

/// The thrust that nonnegative multiples of planes leave, N, if none is violated by more than `tolerance`. What the
/// multiples do not add up to is bounded by `reach`, which encloses every wrench.
pub(super) fn shown<'p>(
    weighted: impl Iterator<Item = (f64, &'p Plane)>,
    tolerance: f64,
    reach: &[Interval; 4],
) -> Interval {
    let mut rest = [Interval::ONE, Interval::ZERO, Interval::ZERO, Interval::ZERO];
    let mut most = Interval::ZERO;
    for (weight, plane) in weighted {
        let weight = Interval::point(weight);
        most = most + weight * (plane.offset + Interval::point(tolerance));
        rest = std::array::from_fn(|k| rest[k] - weight * plane.normal[k]);
    }
    most + along(&rest, reach)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `T <= 5`, and `T +- tau_x <= 1`, which add up to `T <= 1`.
    #[test]
    fn planes_add_up() {
        let planes = [([1.0, 0.0, 0.0, 0.0], 5.0), ([1.0, 1.0, 0.0, 0.0], 1.0), ([1.0, -1.0, 0.0, 0.0], 1.0)];
        let found = multipliers(&planes, [10.0, 3.0, 1.0, 1.0]);
        let mut weights = [0.0; 3];
        found.into_iter().for_each(|(i, weight)| weights[i] = weight);
        assert!(weights.into_iter().zip([0.0, 0.5, 0.5]).all(|(a, b)| (a - b).abs() < 1e-12), "{weights:?}");
        // Planes that bound nothing, or are not numbers, leave the extents.
        assert!(multipliers(&[([-1.0, 0.0, 0.0, 0.0], 0.0)], [1.0; 4]).is_empty());
        assert!(multipliers(&[([f64::NAN; 4], 0.0)], [1.0; 4]).is_empty() && multipliers(&[], [1.0; 4]).is_empty());
    }
}
