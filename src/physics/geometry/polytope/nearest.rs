//! The nearest point of a half-space description, by duality (least distance programming: Lawson and Hanson, *Solving
//! Least Squares Problems*, section 23.4).

use super::Polytope;
use crate::geometry::cone::{Ray, cone_residual};
use nalgebra::SVector;

/// The set is empty if `last` of the residual below is at most this. `last` is the squared length of the residual, and
/// the target has length 1.
const EMPTY: f64 = 1e-12;

impl<const D: usize, O: Clone> Polytope<D, O> {
    /// The point of the set nearest to `w` in the plain Euclidean norm; `None` for an empty set.
    ///
    /// With `x = p - w` the problem is to minimise |x| subject to `n_i.x <= s_i`, where s_i are the slacks at w. Let r
    /// be `(0, 1)` minus its nearest point in the cone of the rays `(-n_i, -s_i)`. Then `x = -r_head / r_last`, and r
    /// is zero if and only if no x is feasible.
    pub fn nearest(&self, w: &SVector<f64, D>) -> Option<SVector<f64, D>> {
        // Slacks are scaled by the largest violation; without a violation w itself is the nearest point.
        let mut rows: Vec<(SVector<f64, D>, f64)> = self.facets.iter().map(|f| (f.normal, f.slack(w))).collect();
        for e in &self.equalities {
            let slack = e.offset - e.normal.dot(w);
            rows.extend([(e.normal, slack), (-e.normal, -slack)]);
        }
        let passed = rows.iter().map(|r| -r.1).fold(0.0, f64::max);
        if passed == 0.0 {
            return Some(*w);
        }
        let rays: Vec<Ray<D>> = rows.iter().map(|(n, slack)| Ray::new(-n, -slack / passed)).collect();
        let rest = cone_residual(&Ray::new(SVector::zeros(), 1.0), &rays, 0.0);
        (rest.last > EMPTY).then(|| w - rest.head * (passed / rest.last))
    }
}
