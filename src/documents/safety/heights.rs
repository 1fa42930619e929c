//! The lowest and the highest height of a plan in a part of its time: the extremes of its polynomials.

use crate::certificate::MotionRecord;

/// The extremes of z between two times (s) within a motion, m. Between nodes z is a polynomial whose highest derivative
/// in the record is linear.
pub fn of(motion: &MotionRecord, from: f64, to: f64) -> [f64; 2] {
    let mut extremes = [f64::INFINITY, f64::NEG_INFINITY];
    for (times, nodes) in motion.times_s.windows(2).zip(motion.z.windows(2)) {
        let [begin, end] = [from.max(times[0]), to.min(times[1])].map(|t| t - times[0]);
        if begin > end {
            continue;
        }
        let height = polynomial(nodes[0].derivatives(), nodes[1].derivatives(), times[1] - times[0]);
        let inside = roots(&derivative(&height), begin, end);
        for z in [begin, end].into_iter().chain(inside).map(|t| value(&height, t)) {
            extremes = [extremes[0].min(z), extremes[1].max(z)];
        }
    }
    extremes
}

/// The coefficients of a piece of `h` s, the constant first, from the derivatives at its nodes.
fn polynomial(first: &[f64], last: &[f64], h: f64) -> Vec<f64> {
    let order = first.len() - 1;
    let slope = (last[order] - first[order]) / h;
    let mut factorial = 1.0;
    let each = first.iter().chain([&slope]).enumerate();
    each.map(|(i, d)| {
        factorial *= i.max(1) as f64;
        d / factorial
    })
    .collect()
}

fn derivative(of: &[f64]) -> Vec<f64> {
    of.iter().enumerate().skip(1).map(|(i, c)| i as f64 * c).collect()
}

fn value(of: &[f64], t: f64) -> f64 {
    of.iter().rev().fold(0.0, |sum, c| sum * t + c)
}

/// Halvings of an interval until its ends are neighbours in `f64`, or nearly so.
const HALVINGS: usize = 60;

/// Where a polynomial changes its sign between two times; between the roots of its derivative it is monotone.
fn roots(of: &[f64], from: f64, to: f64) -> Vec<f64> {
    if of.len() < 2 {
        return Vec::new();
    }
    let inner = roots(&derivative(of), from, to);
    let ends: Vec<f64> = [from].into_iter().chain(inner).chain([to]).collect();
    let root = |ends: &[f64]| {
        let [mut low, mut high] = [ends[0], ends[1]];
        let sign = value(of, low).signum();
        if value(of, low) * value(of, high) > 0.0 {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if value(of, middle).signum() == sign { low = middle } else { high = middle }
        }
        Some(0.5 * (low + high))
    };
    ends.windows(2).filter_map(root).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certificate::Vertical;

    /// A piece whose z is a polynomial of degree 5 with known extremes.
    #[test]
    fn extremes_are_those_of_the_polynomial() {
        // z' = (t - 1/4)(t - 1/2)(t - 3/4)(t + 1): extremes inside at 1/4, 1/2 and 3/4.
        let slope = [-3.0 / 32.0, 19.0 / 32.0, -13.0 / 16.0, -0.5, 1.0];
        let height: Vec<f64> = [2.0].into_iter().chain(slope.iter().zip(1..).map(|(c, i)| c / f64::from(i))).collect();
        let at = |t: f64| {
            let mut of = height.clone();
            let mut derivatives = [0.0; 5];
            for slot in &mut derivatives {
                *slot = value(&of, t);
                of = derivative(&of);
            }
            Vertical::Exact(derivatives)
        };
        let motion = MotionRecord {
            times_s: vec![0.0, 0.4, 1.0],
            x: vec![[0.0; 5]; 3],
            y: vec![[0.0; 5]; 3],
            z: [0.0, 0.4, 1.0].map(at).to_vec(),
            yaw: vec![[0.0; 3]; 3],
            waypoint_nodes: vec![0, 2],
        };
        let near = |found: [f64; 2], expected: [f64; 2]| {
            assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?} {expected:?}");
        };
        let z = |t: f64| value(&height, t);
        // Over both nodes, within one piece, and over one node: z falls to 1/4, rises to 1/2 and falls to 3/4.
        near(of(&motion, 0.0, 1.0), [z(0.25).min(z(0.75)), z(0.0).max(z(0.5)).max(z(1.0))]);
        near(of(&motion, 0.45, 0.55), [z(0.45).min(z(0.55)), z(0.5)]);
        near(of(&motion, 0.2, 0.45), [z(0.25), z(0.2).max(z(0.45))]);
    }
}
