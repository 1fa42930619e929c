//! Members of families of ways out by their definition, in plain `f64`: the blend of four branches, plus polynomials
//! that take the deviations of the initial state to zero and lead to those of the final one.

use mavc::certificate::FamilyRecord;
use mavc::motion::{NodeState, Trajectory, X, Y, YAW, Z};

/// Windows in which the deviations of position, velocity, acceleration and jerk vanish, s.
const WINDOWS: [f64; 4] = [f64::INFINITY, 6.0, 4.0, 3.0];

/// The derivatives of an axis that the initial state fixes in the hover model, in which a fault changes z'' and the
/// yaw's second derivative at once.
pub fn kept(axis: usize) -> usize {
    if axis == X || axis == Y { 4 } else { 2 }
}

/// Derivatives up to the fourth at t of the polynomial of degree 9 on [0, w] whose derivatives up to the fourth vanish
/// at both ends, except that of order i at 0, which is 1: `w^i x^i/i! (1-x)^5 sum over m <= 4-i of binom(4+m, m) x^m`.
fn response(i: usize, w: f64, t: f64) -> [f64; 5] {
    if t >= w {
        return [0.0; 5];
    }
    let mut c = [0.0; 10];
    for (j, a) in [1.0, -5.0, 10.0, -10.0, 5.0, -1.0].into_iter().enumerate() {
        for (m, b) in [1.0, 5.0, 15.0, 35.0, 70.0].into_iter().enumerate().take(5 - i) {
            c[i + j + m] += a * b / [1.0, 1.0, 2.0, 6.0][i];
        }
    }
    std::array::from_fn(|k| {
        let term = |n: usize| c[n] * (0..k).map(|l| (n - l) as f64).product::<f64>() * (t / w).powi((n - k) as i32);
        (k..10).map(term).sum::<f64>() * w.powi(i as i32 - k as i32)
    })
}

/// The branches of a family with the shares of the last instant and of the longest delay.
pub struct Blend<'b> {
    pub corners: [&'b Trajectory; 4],
    pub weights: [f64; 4],
}

impl<'b> Blend<'b> {
    /// `s` and `r` within [0, 1].
    pub fn new(corners: [&'b Trajectory; 4], s: f64, r: f64) -> Self {
        Blend { corners, weights: [(1.0 - r) * (1.0 - s), (1.0 - r) * s, r * (1.0 - s), r * s] }
    }

    /// The instant of the fault and the delay, s.
    pub fn when(family: &FamilyRecord, s: f64, r: f64) -> [f64; 2] {
        let [least, most] = family.delays_s;
        [family.from_s + s * (family.to_s - family.from_s), least + r * (most - least)]
    }

    pub fn duration(&self) -> f64 {
        self.corners[0].duration()
    }

    /// The blend at `t` s after the fault is known.
    pub fn at(&self, t: f64) -> NodeState {
        let states = self.corners.map(|corner| corner.at(t));
        std::array::from_fn(|axis| {
            std::array::from_fn(|k| states.iter().zip(self.weights).map(|(state, w)| w * state[axis][k]).sum())
        })
    }

    /// The member that begins and ends with these deviations from the blend.
    pub fn between(&self, first: &NodeState, last: &NodeState, t: f64) -> NodeState {
        let mut state = self.at(t);
        let before = (self.duration() - t).max(0.0);
        for axis in [X, Y, Z, YAW] {
            for i in 0..kept(axis) {
                let window = WINDOWS[i].min(self.duration());
                let (from, to) = (response(i, window, t), response(i, window, before));
                for (k, slot) in state[axis].iter_mut().enumerate() {
                    // Backwards, odd derivatives change their signs.
                    let sign = if (i + k) % 2 == 0 { 1.0 } else { -1.0 };
                    *slot += first[axis][i] * from[k] + sign * last[axis][i] * to[k];
                }
            }
        }
        state
    }
}
