//! Legs: how they share the free time, and how yaw continues from waypoint to waypoint.

use std::f64::consts::PI;

use super::{Leg, Waypoint};

/// `timing = optimal | proportional | uniform | distance`
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Timing {
    /// All legs take the same time.
    Uniform,
    /// Each leg in proportion to its length.
    Distance,
    /// Explicit legs in proportion to their length, the legs of a curve evenly: the paper's rule.
    Proportional,
    /// Chosen by the planner; as [`Timing::Proportional`] where it does not choose.
    Optimal,
}

/// Below this length, m, the turn of a leg counts as well.
const SHORT: f64 = 0.1;
/// The length that a radian of turn counts for on a short leg, m.
const METRES_A_RADIAN: f64 = 1.0;
/// The smallest share of a leg, as a fraction of the mean share.
const LEAST: f64 = 0.01;

pub fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

/// The share of each leg; the shares sum to 1. Under [`Timing::Proportional`] an explicit leg counts by its effort, and
/// the legs of a curve share the curve's length evenly, so that both kinds are measured in metres and may be mixed. The
/// effort of a leg is its length; for a leg shorter than 10 cm it is at least one metre per radian of turn. No leg gets
/// less than 1 % of the mean.
pub fn shares(waypoints: &[Waypoint], curves: &[Option<usize>], timing: Timing) -> Vec<Leg> {
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

/// Sets each waypoint's yaw, rad: a waypoint without one keeps the previous yaw (0 at the start), and each turn goes
/// the shorter way, counter-clockwise where both are equally long.
pub fn unwrap_yaw(waypoints: &mut [Waypoint], given: &[Option<f64>]) {
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
