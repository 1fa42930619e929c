//! The nearest point of a half-space description, by duality (Lawson and Hanson, *Solving Least Squares Problems*,
//! section 23.4: least distance programming).

use super::Polytope;
use crate::geometry::cone::{Ray, beyond_cone};
use nalgebra::SVector;

/// A polytope holds a point where what is left beyond the cone is longer than this (of 1): `last` is then its square.
const EMPTY: f64 = 1e-12;

impl<const D: usize, O: Clone> Polytope<D, O> {
    /// The point nearest to `w` in the plain Euclidean norm; `None` for an empty set.
    ///
    /// With `x = p - w` the task is to minimise |x| subject to `n_i.x <= s_i`, s_i the slacks at w. Let r be
    /// `(0, 1)` less its nearest point in the cone of the rays `(-n_i, -s_i)`. Then `x = -r_head / r_last`, and r is
    /// zero exactly where there is no x.
    pub fn nearest(&self, w: &SVector<f64, D>) -> Option<SVector<f64, D>> {
        // Where w is inside there is nothing to do; slacks are counted in lengths of the largest.
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
        let rest = beyond_cone(&Ray::new(SVector::zeros(), 1.0), &rays, 0.0);
        (rest.last > EMPTY).then(|| w - rest.head * (passed / rest.last))
    }
}
