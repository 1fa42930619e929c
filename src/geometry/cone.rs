//! How far a ray lies from a cone of rays (non-negative least squares; Lawson and Hanson, *Solving Least
//! Squares Problems*, chapter 23).

use super::least_squares::least_squares;
use nalgebra::{DMatrix, DVector, SVector};

/// A vector of R^(D+1), a unit vector where it is a direction, the last coordinate apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray<const D: usize> {
    pub head: SVector<f64, D>,
    pub last: f64,
}

impl<const D: usize> Ray<D> {
    /// The direction of `(head, last)`, which must not be zero.
    pub fn new(head: SVector<f64, D>, last: f64) -> Self {
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

/// Rays taken in after which the distance reached is returned; a basis of D + 1 rays takes a few tens.
const MOST_ROUNDS: usize = 1_000;

/// The distance of `target` from the cone of `rays`, or a larger one should the search not end; it ends early
/// once at most `enough`.
pub fn distance_to_cone<const D: usize>(target: &Ray<D>, rays: &[Ray<D>], enough: f64) -> f64 {
    beyond_cone(target, rays, enough).norm()
}

/// `target` less the point of the cone of `rays` nearest to it; the search ends as for [`distance_to_cone`].
pub fn beyond_cone<const D: usize>(target: &Ray<D>, rays: &[Ray<D>], enough: f64) -> Ray<D> {
    let mut basis: Vec<usize> = Vec::new();
    let mut weights: Vec<f64> = Vec::new();
    // Rays that brought the basis no nearer, for rounding: not tried again from the same place.
    let mut useless: Vec<usize> = Vec::new();
    let mut rest = *target;
    let mut distance = rest.norm();
    for _ in 0..MOST_ROUNDS {
        if distance <= enough {
            break;
        }
        // The ray that points most along what is missing; none points along it at the nearest point.
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

/// The basis and its weights after `next` has come in: towards the least squares weights, with the ray whose
/// weight turns negative first going out.
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

/// Weights of the rays of `basis` that come nearest to `target`.
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
        // A thin cone: a ray a millionth outside of it, among rays of which most are of no use.
        let thin: Vec<_> = (0..=100).map(|k| ray(1., 1e-6 * f64::from(k) / 100.0, 1e-6)).collect();
        let d = distance_to_cone(&ray(1., -1e-6, 1e-6), &thin, 0.0);
        assert!((d - 1e-6).abs() < 1e-12, "{d}");
        let d = distance_to_cone(&ray(1., 0.5e-6, 1e-6), &thin, 0.0);
        assert!(d < 1e-10, "{d}"); // a basis of nearly parallel rays
    }
}
