//! Distance of a vector from the cone of some rays, by non-negative least squares (Lawson and Hanson, *Solving Least
//! Squares Problems*, chapter 23).

use super::least_squares::least_squares;
use nalgebra::{DMatrix, DVector, SVector};

/// A vector of R^(D+1) whose last coordinate is stored separately. Rays made by [`Ray::new`] have length 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ray<const D: usize> {
    pub(super) head: SVector<f64, D>,
    pub(super) last: f64,
}

impl<const D: usize> Ray<D> {
    /// The unit vector along `(head, last)`, which must not be zero.
    pub(super) fn new(head: SVector<f64, D>, last: f64) -> Self {
        let length = head.norm().hypot(last);
        Ray { head: head / length, last: last / length }
    }

    fn dot(&self, other: &Self) -> f64 {
        self.head.dot(&other.head) + self.last * other.last
    }

    fn minus(self, other: &Self, times: f64) -> Self {
        Ray { head: self.head - other.head * times, last: self.last - other.last * times }
    }

    fn norm(&self) -> f64 {
        self.head.norm().hypot(self.last)
    }

    fn coordinate(&self, r: usize) -> f64 {
        if r < D { self.head[r] } else { self.last }
    }
}

/// Iterations after which the search stops. A basis of D + 1 rays is found in a few tens of iterations.
const MOST_ROUNDS: usize = 1_000;

/// The distance of `target` from the cone of `rays`.
///
/// The search stops early once the distance is at most `enough`. If it reaches its iteration limit, the result is an
/// upper bound on the distance.
pub(super) fn distance_to_cone<const D: usize>(target: &Ray<D>, rays: &[Ray<D>], enough: f64) -> f64 {
    cone_residual(target, rays, enough).norm()
}

/// `target` minus the point of the cone of `rays` that is nearest to it. The search stops as in [`distance_to_cone`].
pub(super) fn cone_residual<const D: usize>(target: &Ray<D>, rays: &[Ray<D>], enough: f64) -> Ray<D> {
    let mut basis: Vec<usize> = Vec::new();
    let mut weights: Vec<f64> = Vec::new();
    // Rays that did not reduce the distance because of rounding. They are not tried again until the basis changes.
    let mut useless: Vec<usize> = Vec::new();
    let mut rest = *target;
    let mut distance = rest.norm();
    for _ in 0..MOST_ROUNDS {
        if distance <= enough {
            break;
        }
        // The ray with the largest component along the residual. At the nearest point no ray has a positive one.
        let rate = |j: usize| rays[j].dot(&rest);
        let free = (0..rays.len()).filter(|j| !basis.contains(j) && !useless.contains(j));
        let Some(next) = free.max_by(|a, b| rate(*a).total_cmp(&rate(*b))).filter(|&j| rate(j) > 1e-13 * distance)
        else {
            break;
        };
        let (wider, new_weights) = extended(target, rays, &basis, &weights, next);
        let missing = wider.iter().zip(&new_weights).fold(*target, |sum, (&j, &w)| sum.minus(&rays[j], w));
        if missing.norm() < distance {
            (basis, weights, rest, distance) = (wider, new_weights, missing, missing.norm());
            useless.clear();
        } else {
            useless.push(next);
        }
    }
    rest
}

/// The basis and its weights after ray `next` has entered. The weights move towards the least-squares weights; a ray
/// whose weight reaches zero on the way leaves the basis.
fn extended<const D: usize>(
    target: &Ray<D>,
    rays: &[Ray<D>],
    basis: &[usize],
    weights: &[f64],
    next: usize,
) -> (Vec<usize>, Vec<f64>) {
    let (mut basis, mut weights) = (basis.to_vec(), weights.to_vec());
    basis.push(next);
    weights.push(0.0);
    while let Some(goal) = goal_of(target, rays, &basis) {
        let ends = |k: &usize| weights[*k] / (weights[*k] - goal[*k]);
        let negative = (0..basis.len()).filter(|&k| goal[k] < 0.0);
        let Some(first) = negative.min_by(|a, b| ends(a).total_cmp(&ends(b))) else {
            return (basis, goal);
        };
        let step = ends(&first);
        for (w, g) in weights.iter_mut().zip(&goal) {
            *w = (*w + step * (g - *w)).max(0.0);
        }
        basis.remove(first);
        weights.remove(first);
    }
    (basis, weights)
}

/// Least-squares weights of the rays of `basis` for `target`; `None` if the rays are linearly dependent.
fn goal_of<const D: usize>(target: &Ray<D>, rays: &[Ray<D>], basis: &[usize]) -> Option<Vec<f64>> {
    let columns = DMatrix::from_fn(D + 1, basis.len(), |r, c| rays[basis[c]].coordinate(r));
    least_squares(columns, DVector::from_fn(D + 1, |r, _| target.coordinate(r)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;

    #[test]
    fn closed_forms() {
        let ray = |x: f64, y: f64, z: f64| Ray::new(Vector2::new(x, y), z);
        let quadrant = [ray(1., 0., 0.), ray(0., 1., 0.), ray(0., 0., 1.)];
        // Inside, on a face, outside next to a face, next to an edge, and opposite.
        assert!(distance_to_cone(&ray(1., 2., 3.), &quadrant, 0.0) < 1e-15);
        assert!(distance_to_cone(&ray(1., 2., 0.), &quadrant, 0.0) < 1e-15);
        assert!((distance_to_cone(&ray(3., 0., -4.), &quadrant, 0.0) - 0.8).abs() < 1e-15);
        assert!((distance_to_cone(&ray(-2., 1., -2.), &quadrant, 0.0) - 8.0_f64.sqrt() / 3.0).abs() < 1e-15);
        assert!((distance_to_cone(&ray(-1., -1., -1.), &quadrant, 0.0) - 1.0).abs() < 1e-15);
        // A thin cone: a ray 1e-6 outside it, with many rays that do not help.
        let thin: Vec<_> = (0..=100).map(|k| ray(1., 1e-6 * f64::from(k) / 100.0, 1e-6)).collect();
        let d = distance_to_cone(&ray(1., -1e-6, 1e-6), &thin, 0.0);
        assert!((d - 1e-6).abs() < 1e-12, "{d}");
        let d = distance_to_cone(&ray(1., 0.5e-6, 1e-6), &thin, 0.0);
        assert!(d < 1e-10, "{d}"); // a basis of nearly parallel rays
    }
}
