//! Jumps of derivatives at waypoints, which splines alone cannot have: (72), where legs change their durations by
//! different shares.

use super::NodeSpline;

/// A motion of one axis that is zero except on the steps next to a node, where it jumps by given derivatives: what is
/// missing in splines where derivatives jump.
///
/// It lies on the `order + 1` steps after the node if there are so many, else on those before it.
#[derive(Debug, Clone, PartialEq)]
pub struct JumpAt {
    /// The first node with derivatives that are not zero; at the jump's own node those of the earlier side.
    first: usize,
    /// By node from there on, the derivatives up to the input's.
    derivatives: Vec<Vec<f64>>,
}

impl JumpAt {
    /// The motion on ascending `times` (s) that jumps at a node by `jump`, later side minus earlier side, of every
    /// derivative up to the input's. `None` if the node has too few steps on both sides.
    pub fn new(times: &[f64], node: usize, jump: &[f64]) -> Option<JumpAt> {
        let steps = jump.len();
        if node + steps < times.len() {
            let derivatives = ending(&times[node..=node + steps], jump);
            return Some(JumpAt { first: node + 1, derivatives: derivatives[1..steps].to_vec() });
        }
        // Before the node, in reversed time: derivatives of odd order change sign.
        let from = node.checked_sub(steps)?;
        let mirrored: Vec<f64> = times[from..=node].iter().rev().map(|t| -t).collect();
        let sign = |order: usize| if order.is_multiple_of(2) { 1.0 } else { -1.0 };
        let earlier: Vec<f64> = jump.iter().enumerate().map(|(order, d)| -sign(order) * d).collect();
        let mut derivatives = ending(&mirrored, &earlier)[..steps].to_vec();
        derivatives.reverse();
        let flipped = |(order, d): (usize, f64)| sign(order) * d;
        let derivatives = derivatives.into_iter().map(|state| state.into_iter().enumerate().map(flipped).collect());
        Some(JumpAt { first: from + 1, derivatives: derivatives.collect() })
    }

    /// The derivative of the given order at a node; at the jump's own node that of the earlier side.
    pub fn at(&self, node: usize, order: usize) -> f64 {
        node.checked_sub(self.first).and_then(|k| self.derivatives.get(k)).map_or(0.0, |state| state[order])
    }
}

/// At each of `times` the derivatives up to the input's of a motion that begins with `derivatives` and has ended in 0
/// at the last of them.
fn ending(times: &[f64], derivatives: &[f64]) -> Vec<Vec<f64>> {
    let spline = NodeSpline::new(times, derivatives.len() - 1);
    let first = spline.beginning_with(derivatives);
    let value = |node: usize, order: usize| -> f64 {
        spline.at(node, order).iter().map(|&(i, w)| w * first.get(i).copied().unwrap_or_default()).sum()
    };
    (0..times.len()).map(|node| (0..derivatives.len()).map(|order| value(node, order)).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Between all nodes the motion of a jump is joined by exact steps, from the later side of the jump on.
    #[test]
    fn jumps_are_joined() {
        let times = [0.0, 0.5, 0.7, 1.5, 2.0, 2.9, 3.0, 4.5, 5.0, 5.5, 6.5];
        let size = [0.0, 1.2, -0.7, 0.3, 2.0];
        for order in [2, 4] {
            for at in 0..times.len() {
                let jump = &size[..=order];
                let motion = JumpAt::new(&times, at, jump).unwrap();
                for k in 0..times.len() - 1 {
                    let h = times[k + 1] - times[k];
                    let begin = |m: usize| motion.at(k, m) + if k == at { jump[m] } else { 0.0 };
                    for i in 0..order {
                        let (mut expected, mut power) = (0.0, 1.0);
                        for j in i..=order {
                            expected += begin(j) * power;
                            power *= h / (j - i + 1) as f64;
                        }
                        expected += (motion.at(k + 1, order) - begin(order)) / h * power;
                        let found = motion.at(k + 1, i);
                        assert!((found - expected).abs() < 1e-9, "{order} {at} {k} {i}: {found} {expected}");
                    }
                }
                assert!((0..=order).all(|m| motion.at(times.len() - 1, m) == 0.0 || at > 5));
            }
            assert_eq!(JumpAt::new(&times[..order + 1], 1, &size[..=order]), None);
        }
    }
}
