//! Whether the direction of the thrust of a spinning vehicle is controllable with torques that point one way only.

use super::core::Directions;
use nalgebra::{Matrix4, Matrix4xX, Vector2, Vector4};

/// Directions shorter than this share of a unit vector count as none.
const SMALL: f64 = 1e-9;

/// Whether the states (p, q, n_x, n_y) of a body that turns at `rate` (rad/s) about its z axis can be brought to zero
/// with torques in the given directions; n is the vertical in body axes, and the thrust is held. Linearised about the
/// spin,
///
/// ```text
/// (97)  p' = (Jy - Jz) r q / Jx + tau_x / Jx      n_x' = -q + r n_y
///       q' = (Jz - Jx) r p / Jy + tau_y / Jy      n_y' =  p - r n_x
/// ```
///
/// Torques from a cone suffice exactly if the pair of matrices is controllable and no real eigenvector of the
/// transposed first one has a product of one sign with all of them (R. F. Brammer, *Controllability in linear
/// autonomous systems with positive controllers*, SIAM J. Control 10:2 (1972)). `inertia` is in kg m^2.
pub fn is_controllable(inertia: [f64; 3], rate: f64, directions: &Directions) -> bool {
    let [jx, jy, jz] = inertia;
    if rate.abs() < SMALL {
        return false;
    }
    // Time in units of 1/|r|, so that all entries are near 1.
    let (a, b, r) = ((jy - jz) / jx * rate.signum(), (jz - jx) / jy * rate.signum(), rate.signum());
    #[rustfmt::skip]
    let system = Matrix4::new(
        0.0,  a,   0.0, 0.0,
        b,    0.0, 0.0, 0.0,
        0.0, -1.0, 0.0, r,
        1.0,  0.0, -r,  0.0,
    );
    let rays = rays(directions);
    let inputs: Vec<Vector2<f64>> = rays.iter().map(|u| Vector2::new(u.x / jx, u.y / jy) * jx.max(jy)).collect();
    if inputs.is_empty() || reach(&system, &inputs) < 4 {
        return false;
    }
    // The eigenvalues are +-i r and the square roots of a b. A real eigenvector has no part in n_x and n_y.
    let real: Vec<Vector2<f64>> = match a * b {
        square if square < -SMALL => Vec::new(),
        square => {
            let root = square.max(0.0).sqrt();
            let left = |lambda: f64| if b.abs() > SMALL { Vector2::new(b, lambda) } else { Vector2::new(lambda, a) };
            vec![left(root), left(-root)]
        }
    };
    let both_signs = |v: &Vector2<f64>| {
        let products = || inputs.iter().map(|u| v.dot(u));
        products().any(|p| p > SMALL) && products().any(|p| p < -SMALL)
    };
    real.iter().all(both_signs)
}

/// Vectors whose cone is that of the directions.
fn rays(directions: &Directions) -> Vec<Vector2<f64>> {
    let turned = |v: &Vector2<f64>| [Vector2::new(-v.y, v.x), Vector2::new(v.y, -v.x)];
    let walls = directions.below.iter().chain(&directions.equal);
    let candidates = walls.flat_map(turned).chain(directions.below.iter().map(|v| -v)).chain([
        Vector2::x(),
        -Vector2::x(),
        Vector2::y(),
        -Vector2::y(),
    ]);
    let is_allowed = |u: &Vector2<f64>| {
        directions.below.iter().all(|v| v.dot(u) <= SMALL) && directions.equal.iter().all(|v| v.dot(u).abs() <= SMALL)
    };
    candidates.filter(is_allowed).collect()
}

/// The dimension of the states that inputs reach: the rank of (B, A B, A^2 B, A^3 B).
fn reach(system: &Matrix4<f64>, inputs: &[Vector2<f64>]) -> usize {
    let mut columns = Vec::new();
    for u in inputs {
        let mut column = Vector4::new(u.x, u.y, 0.0, 0.0);
        for _ in 0..4 {
            columns.push(column);
            column = system * column;
        }
    }
    Matrix4xX::from_columns(&columns).rank(1e-7)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FLAT_BODY: [f64; 3] = [0.0128, 0.0128, 0.0239];

    fn cone(below: &[[f64; 2]], equal: &[[f64; 2]]) -> Directions {
        let unit = |v: &[f64; 2]| Vector2::from(*v).normalize();
        Directions { below: below.iter().map(unit).collect(), equal: equal.iter().map(unit).collect() }
    }

    #[test]
    fn one_sided_torques_suffice_while_the_body_spins() {
        let half_plane = cone(&[[0.0, 1.0]], &[]);
        assert!(is_controllable(FLAT_BODY, 75.0, &half_plane));
        assert!(is_controllable(FLAT_BODY, -75.0, &half_plane));
        // Without a spin the other half plane is out of reach.
        assert!(!is_controllable(FLAT_BODY, 0.0, &half_plane));
        // Two opposite rotors: torques about one axis, both ways.
        let line = cone(&[], &[[1.0, 0.0]]);
        assert!(is_controllable(FLAT_BODY, 30.0, &line));
        // A single ray, of one rotor that may only add thrust: enough, because each turn brings it everywhere.
        let ray = cone(&[[0.0, 1.0]], &[[1.0, 0.0]]);
        assert!(is_controllable(FLAT_BODY, 30.0, &ray));
        let nothing = cone(&[[0.0, 1.0], [0.0, -1.0]], &[[1.0, 0.0]]);
        assert!(!is_controllable(FLAT_BODY, 30.0, &nothing));
    }

    /// About its middle axis of inertia a body does not spin stably: there are real eigenvalues, along whose
    /// eigenvectors a single ray pushes one way. A half plane contains both directions of a line, which is enough.
    #[test]
    fn about_the_middle_axis_a_ray_is_not_enough() {
        let body = [0.01, 0.03, 0.02];
        assert!(!is_controllable(body, 30.0, &cone(&[[0.0, 1.0]], &[[1.0, 0.0]])));
        assert!(is_controllable(body, 30.0, &cone(&[[0.0, 1.0]], &[])));
        assert!(is_controllable(body, 30.0, &cone(&[], &[[1.0, 0.0]])));
    }
}
