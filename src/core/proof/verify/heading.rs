//! A yaw that follows from the motion: towards a point, or along the path.
//!
//! With the direction d that the yaw psi has to follow, the error is the angle e between d and (cos psi, sin psi), and
//! with the tolerance L the violation is the distance of d/|d| from the cone of half-angle L about the yaw: `sin(e -
//! L)`, and 1 where e - L is more than a right angle. Where |d| is below its least size, nothing is required.

use super::interval::Interval;
use super::motion::{Motion, State, X, Y, YAW};
use super::series::outside_cone;
use crate::model::{SLOWEST, Target};
use std::ops::RangeInclusive;

/// Value and rate of change.
type Series = super::series::Series<2>;

/// The violation at an instant; the rate is not bounded.
pub fn violation(target: Target, state: &State, within: f64) -> Series {
    let value = violation_at(target, state, within);
    Series::of_derivatives(&[value, Interval::WHOLE])
}

fn violation_at(target: Target, state: &State, within: f64) -> Interval {
    let (d, least) = direction(target, state);
    let size = (d[0].square() + d[1].square()).sqrt();
    if size.high < least {
        return Interval::point(-1.0);
    }
    let (sine, cosine) = state[YAW][0].sin_cos();
    let cross = (cosine * d[1] - sine * d[0]).abs();
    let inner = cosine * d[0] + sine * d[1];
    let at_an_instant = |part: Interval| Series::of_derivatives(&[part, Interval::WHOLE]);
    outside_cone(at_an_instant(cross), at_an_instant(inner), within).value() / size
}

/// The vector whose direction is followed, and its least size.
fn direction(target: Target, state: &State) -> ([Interval; 2], f64) {
    match target {
        Target::Towards { point, nearest } => {
            ([Interval::point(point[0]) - state[X][0], Interval::point(point[1]) - state[Y][0]], nearest)
        }
        Target::AlongPath => ([state[X][1], state[Y][1]], SLOWEST),
    }
}

/// The largest error at some nodes of the motion and on `points` between two of them, rad, and its instant, s; `None`
/// if nothing is required there. It is evaluated at points, not bounded between them.
pub fn largest(target: Target, motion: &Motion, nodes: RangeInclusive<usize>, points: usize) -> Option<(f64, f64)> {
    let error = |state: &State| {
        let (d, least) = direction(target, state);
        let [x, y] = d.map(Interval::middle);
        let (sin, cos) = state[YAW][0].middle().sin_cos();
        (x.hypot(y) >= least).then(|| (cos * y - sin * x).atan2(cos * x + sin * y).abs())
    };
    let pieces = *nodes.start()..*nodes.end();
    let at_nodes = nodes.map(|node| (motion.node_in(node, node.saturating_sub(1)), motion.times[node]));
    let between = pieces.flat_map(|piece| {
        motion.grid(piece, points).map(move |at| (motion.over(piece, at), motion.times[piece] + at.middle()))
    });
    let found = at_nodes.chain(between).filter_map(|(state, at)| Some((error(&state)?, at)));
    found.reduce(|most, next| if next.0 > most.0 { next } else { most })
}
