//! The core of a mode: the roll and pitch torques that it produces in every direction, whatever the heading of the
//! body.

use crate::geometry::polytope::Polytope;
use nalgebra::{Vector2, Vector3};

/// The radius rho (N m) of the largest disc of torques about `torque` (tau_x, tau_y, N m) at a thrust (N) that lies in
/// the projection of a mode's set on (T, tau_x, tau_y), with facets `a T + b.tau <= e`:
///
/// ```text
/// (95)  a T + b.torque + |b| rho <= e   for every facet
/// ```
///
/// 0 for a flat projection, which has no disc; `None` if the middle of the disc is outside by more than `tolerance` (N,
/// N m).
pub fn disc(projection: &Polytope<3, ()>, thrust: f64, torque: [f64; 2], tolerance: f64) -> Option<f64> {
    let middle = Vector3::new(thrust, torque[0], torque[1]);
    if !projection.contains(&middle, tolerance) {
        return None;
    }
    if !projection.equalities.is_empty() {
        return Some(0.0);
    }
    let radii = projection.facets.iter().filter_map(|facet| {
        let across = facet.normal.fixed_rows::<2>(1).norm();
        (across > FLAT).then(|| facet.slack(&middle) / across)
    });
    let rho = radii.fold(f64::INFINITY, f64::min);
    Some(if rho <= tolerance { 0.0 } else { rho })
}

/// A facet whose unit normal has a smaller component across T bounds the thrust alone.
const FLAT: f64 = 1e-9;

/// Directions in which torques (tau_x, tau_y) can be produced about a point of the boundary, as `normal.u <= 0`, and
/// `normal.u = 0` for the equalities of a flat set.
#[derive(Debug, Clone, PartialEq)]
pub struct Directions {
    pub below: Vec<Vector2<f64>>,
    pub equal: Vec<Vector2<f64>>,
}

/// The directions about a point (T, tau_x, tau_y) of the projection, from the facets that pass within `tolerance` (N, N
/// m), with the thrust held.
pub fn directions(projection: &Polytope<3, ()>, at: &Vector3<f64>, tolerance: f64) -> Directions {
    let across = |normal: &Vector3<f64>| {
        let across = normal.fixed_rows::<2>(1).into_owned();
        (across.norm() > FLAT).then(|| across.normalize())
    };
    let active = projection.facets.iter().filter(|facet| facet.slack(at) <= tolerance);
    Directions {
        below: active.filter_map(|facet| across(&facet.normal)).collect(),
        equal: projection.equalities.iter().filter_map(|equality| across(&equality.normal)).collect(),
    }
}
