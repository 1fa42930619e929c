//! The point of a polytope nearest to the origin (P. Wolfe, *Finding the nearest point in a polytope*, Mathematical
//! Programming 11, 1976).
//!
//! The polytope is given by a linear minimisation oracle only, so the 2^n vertices of a zonotope are never listed.

use super::least_squares::least_squares;
use nalgebra::{DMatrix, DVector, SVector};

/// Iterations after which the search returns its current point. Wolfe's method is finite; the sets of this crate need a
/// few tens of iterations.
const MOST_ITERATIONS: usize = 1_000;

/// The point nearest to the origin in the convex hull of the points that `lowest` can return.
///
/// `lowest(v)` returns a point p of the polytope that minimises v.p, and `start` is any point of the polytope. A result
/// of length at most `zero` is returned as exactly zero. The search ends where no point p has `x.p` below `|x|^2` by
/// more than `1e-13 |x| (|p| + |x|)` (`docs/method/verdicts.md`).
pub(super) fn nearest_to_origin<const D: usize>(
    start: SVector<f64, D>,
    mut lowest: impl FnMut(&SVector<f64, D>) -> SVector<f64, D>,
    zero: f64,
) -> SVector<f64, D> {
    let mut corral = vec![start];
    let mut weights = vec![1.0];
    let mut x = start;
    for _ in 0..MOST_ITERATIONS {
        let length = x.norm();
        if length <= zero {
            return SVector::zeros();
        }
        let p = lowest(&x);
        // x is the nearest point if no point of the polytope lies on the origin's side of the plane through x.
        let gap = length * length - x.dot(&p);
        if gap <= 1e-13 * length * (p.norm() + length) || corral.contains(&p) {
            return x;
        }
        corral.push(p);
        weights.push(0.0);
        // Minor cycle: move towards the affine minimiser and drop points until it lies inside their convex hull.
        loop {
            let Some(target) = affine_minimiser(&corral) else {
                // The new point depends on the others to rounding, so x cannot be improved.
                return x;
            };
            if target.iter().all(|&t| t > 1e-12) {
                weights = target;
                break;
            }
            let mut step = 1.0_f64;
            for (w, t) in weights.iter().zip(&target) {
                if *t <= 1e-12 && w - t > 0.0 {
                    step = step.min(w / (w - t));
                }
            }
            let moved: Vec<f64> = weights.iter().zip(&target).map(|(w, t)| w + step * (t - w)).collect();
            let before = corral.len();
            let keep: Vec<bool> = moved.iter().map(|&w| w > 1e-12).collect();
            let mut kept = keep.iter();
            corral.retain(|_| *kept.next().unwrap_or(&true));
            weights = moved.into_iter().filter(|&w| w > 1e-12).collect();
            if corral.len() == before || corral.is_empty() {
                return x;
            }
        }
        x = corral.iter().zip(&weights).fold(SVector::zeros(), |sum, (p, w)| sum + p * *w);
    }
    x
}

/// Weights, with sum 1, of the point of the affine hull of `points` that is nearest to the origin; `None` if the points
/// are affinely dependent.
fn affine_minimiser<const D: usize>(points: &[SVector<f64, D>]) -> Option<Vec<f64>> {
    // With q_i = p_i - p_0: minimise |p_0 + Q c| over c.
    let k = points.len() - 1;
    if k == 0 {
        return Some(vec![1.0]);
    }
    let q = DMatrix::from_fn(D, k, |r, c| points[c + 1][r] - points[0][r]);
    let c = least_squares(q, DVector::from_iterator(D, points[0].iter().map(|v| -v)))?;
    let mut weights = vec![1.0 - c.iter().sum::<f64>()];
    weights.extend(c);
    Some(weights)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    fn of_points(points: &[Vector3<f64>]) -> Vector3<f64> {
        nearest_to_origin(points[0], |v| *points.iter().min_by(|a, b| v.dot(a).total_cmp(&v.dot(b))).unwrap(), 1e-12)
    }

    #[test]
    fn closed_forms() {
        // A triangle in the plane x = 2 whose foot of the perpendicular lies inside.
        let t = [Vector3::new(2., 3., 0.), Vector3::new(2., -3., 1.), Vector3::new(2., 0., -3.)];
        assert!((of_points(&t) - Vector3::new(2., 0., 0.)).norm() < 1e-12);
        // An edge: the nearest point of the segment (1, 1)-(1, -1) shifted away.
        let e = [Vector3::new(1., 1., 5.), Vector3::new(1., -1., 5.)];
        assert!((of_points(&e) - Vector3::new(1., 0., 5.)).norm() < 1e-12);
        // The origin inside.
        let s = [
            Vector3::new(1., 1., 1.),
            Vector3::new(-1., 1., -1.),
            Vector3::new(0., -2., 1.),
            Vector3::new(0.2, 0.1, -3.),
        ];
        assert_eq!(of_points(&s), Vector3::zeros());
    }
}
