//! Legs: how the time that is left free is shared, and how yaw goes on from waypoint to waypoint.

use std::f64::consts::PI;

use super::{Leg, Waypoint};

/// `timing = optimal | proportional | uniform | distance`
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Timing {
    /// Every leg the same.
    Uniform,
    /// Every leg by its length.
    Distance,
    /// Explicit legs by their length, those of a curve evenly: the paper's rule.
    Proportional,
    /// As the planner finds best. Shares as under [`Timing::Proportional`] stand where it does not choose.
    Optimal,
}

/// Below this length, m, a leg's turn counts too.
const SHORT: f64 = 0.1;
/// What a radian of turn counts on a short leg, m.
const METRES_A_RADIAN: f64 = 1.0;
/// No leg gets less than this part of the mean.
const LEAST: f64 = 0.01;

pub(super) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

/// Each leg's share, with sum 1. Proportionally, explicit legs count by their effort and the legs of a
/// curve share its length evenly, so that both kinds are measured in metres and may be mixed. Effort is the length; on a
/// leg shorter than 10 cm it is at least one metre a radian of its turn. No leg gets less than 1 % of the mean.
pub(super) fn shares(waypoints: &[Waypoint], curves: &[Option<usize>], timing: Timing) -> Vec<Leg> {
    let mut effort: Vec<f64> = waypoints.windows(2).map(|pair| leg_effort(&pair[0], &pair[1])).collect();
    match timing {
        Timing::Uniform => effort.fill(1.0),
        Timing::Distance => {}
        Timing::Proportional | Timing::Optimal => {
            let mut start = 0;
            for run in curves.chunk_by(|a, b| a == b) {
                let legs = start..start + run.len();
                start = legs.end;
                if run[0].is_some() && legs.end <= effort.len() {
                    let mean = effort[legs.clone()].iter().sum::<f64>() / run.len() as f64;
                    effort[legs].fill(mean);
                }
            }
        }
    }
    let count = effort.len().max(1) as f64;
    let total: f64 = effort.iter().sum();
    if total <= 0.0 || !total.is_finite() {
        return effort.iter().map(|_| Leg { share: 1.0 / count }).collect();
    }
    let least = LEAST * total / count;
    let raised: Vec<f64> = effort.iter().map(|e| e.max(least)).collect();
    if raised.iter().all(|e| *e == raised[0]) {
        return raised.iter().map(|_| Leg { share: 1.0 / count }).collect();
    }
    let total: f64 = raised.iter().sum();
    raised.iter().map(|e| Leg { share: e / total }).collect()
}

fn leg_effort(from: &Waypoint, to: &Waypoint) -> f64 {
    let length = distance(from.position, to.position);
    let turn = (to.yaw - from.yaw).abs() * METRES_A_RADIAN;
    if length < SHORT { length.max(turn) } else { length }
}

/// Settles each waypoint's yaw: one that says none keeps the last (0 at the start), and each turn goes the shorter way,
/// counter-clockwise where both are equally long.
pub(super) fn unwrap_yaw(waypoints: &mut [Waypoint], given: &[Option<f64>]) {
    let mut last: Option<f64> = None;
    for (waypoint, yaw) in waypoints.iter_mut().zip(given) {
        let next = match (last, yaw) {
            (None, yaw) => yaw.unwrap_or(0.0),
            (Some(last), None) => last,
            (Some(last), Some(yaw)) => last + shorter_way(yaw - last),
        };
        waypoint.yaw = next;
        last = Some(next);
    }
}

/// The equivalent turn in -pi..=pi, with pi in place of -pi.
fn shorter_way(turn: f64) -> f64 {
    let rest = turn - 2.0 * PI * (turn / (2.0 * PI)).round();
    if rest <= -PI + 1e-9 { rest + 2.0 * PI } else { rest }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_take_the_shorter_way() {
        let deg = |d: f64| d.to_radians();
        for (turn, expected) in
            [(10.0, 10.0), (350.0, -10.0), (-350.0, 10.0), (180.0, 180.0), (-180.0, 180.0), (720.0, 0.0)]
        {
            assert!((shorter_way(deg(turn)) - deg(expected)).abs() < 1e-12, "{turn}");
        }
    }
}
