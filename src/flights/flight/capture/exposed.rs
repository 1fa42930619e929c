//! When a plan flies lower than its captures ask for.

use super::Capture;
use super::heights::CaptureHeights;
use crate::motion::{NodeState, Trajectory, X, Y, Z};
use crate::tolerance::MOST_PAST_LIMIT;

/// Each interval between nodes is divided into this many parts, within each of which the plan passes the height at most
/// once.
const PARTS: usize = 16;
/// Bisections of a part in which it does.
const BISECTIONS: usize = 40;

/// When a plan is lower than one mode asks for.
#[derive(Debug, Clone, PartialEq)]
pub struct Exposed {
    pub mode: String,
    /// Total duration, s.
    pub seconds: f64,
    /// First and last instant, s.
    pub from: f64,
    pub to: f64,
    /// The largest height that is missing, m, and when, s; infinite where no height is known to be enough.
    pub short: f64,
    pub short_at: f64,
    /// The intervals themselves, s, ascending.
    pub intervals: Vec<[f64; 2]>,
}

/// The exposure to every mode to which there is one, in their order. `ground` is z of the ground, m.
pub fn exposed(heights: &CaptureHeights, trajectory: &Trajectory, ground: f64) -> Vec<Exposed> {
    heights.modes().filter_map(|of_mode| of(heights, of_mode, trajectory, ground)).collect()
}

fn of(heights: &CaptureHeights, of_mode: &[Capture], trajectory: &Trajectory, ground: f64) -> Option<Exposed> {
    let short = |state: &NodeState| heights.height(of_mode, state[X][1].hypot(state[Y][1])) - (state[Z][0] - ground);
    let mut found = Exposed {
        mode: of_mode[0].mode.clone(),
        seconds: 0.0,
        from: f64::INFINITY,
        to: 0.0,
        short: 0.0,
        short_at: 0.0,
        intervals: Vec::new(),
    };
    for k in 0..trajectory.intervals() {
        let (begin, length) = (trajectory.times[k], trajectory.times[k + 1] - trajectory.times[k]);
        let at = |t: f64| short(&trajectory.within(k, t));
        let mut left = (0.0, at(0.0));
        for part in 1..=PARTS {
            let t = length * part as f64 / PARTS as f64;
            let right = (t, at(t));
            for (t, value) in [left, right] {
                if value > found.short {
                    (found.short, found.short_at) = (value, begin + t);
                }
            }
            if let Some([from, to]) = low(left, right, &at) {
                found.add(begin + from, begin + to);
            }
            left = right;
        }
    }
    (found.seconds > 0.0).then_some(found)
}

/// The times between two instants during which `short` exceeds the tolerance of the check of plans.
fn low(left: (f64, f64), right: (f64, f64), short: &dyn Fn(f64) -> f64) -> Option<[f64; 2]> {
    let is_low = |value: f64| value > MOST_PAST_LIMIT;
    match (is_low(left.1), is_low(right.1)) {
        (false, false) => None,
        (true, true) => Some([left.0, right.0]),
        (low_first, _) => {
            let (mut a, mut b) = (left.0, right.0);
            for _ in 0..BISECTIONS {
                let middle = 0.5 * (a + b);
                if is_low(short(middle)) == low_first { a = middle } else { b = middle }
            }
            Some(if low_first { [left.0, a] } else { [b, right.0] })
        }
    }
}

impl Exposed {
    fn add(&mut self, from: f64, to: f64) {
        self.seconds += to - from;
        (self.from, self.to) = (self.from.min(from), to);
        match self.intervals.last_mut() {
            Some(last) if from - last[1] < 1e-9 => last[1] = to,
            _ => self.intervals.push([from, to]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::wrench_model::WrenchModel;

    /// A climb at 1 m/s from the ground: 7 m are reached after 7 s, and a dive from there takes as long.
    #[test]
    fn a_climb_is_exposed_until_it_reaches_the_height() {
        let node = |z: f64, v: f64| {
            let mut node = NodeState::default();
            (node[Z][0], node[Z][1]) = (z, v);
            node
        };
        let trajectory = Trajectory {
            times: vec![0.0, 10.0],
            nodes: vec![node(2.0, 1.0), node(12.0, 1.0)],
            waypoint_nodes: vec![0, 1],
            model: WrenchModel::HoverFollowing,
        };
        let case = Capture {
            mode: "L".into(),
            lag_s: 0.02,
            speed_m_per_s: 0.0,
            delay_s: 0.1,
            flights: 1,
            regained: 1,
            settled_rate_rad_s: Some(20.0),
            height_m: Some([7.0; 3]),
            drift_m: Some(0.0),
        };
        let cases = vec![case.clone(), Capture { speed_m_per_s: 5.0, ..case }];
        let heights = CaptureHeights { delay: 0.1, speeds: vec![0.0, 5.0], cases, left_out: 0 };
        let found = exposed(&heights, &trajectory, 2.0);
        let [one] = &found[..] else { panic!("{found:?}") };
        // To within the tolerance of 0.1 mm.
        assert!((one.seconds - 7.0).abs() < 2e-4 && one.from == 0.0 && (one.to - 7.0).abs() < 2e-4, "{one:?}");
        assert_eq!((one.short, one.short_at, one.intervals.len()), (7.0, 0.0, 1));
        assert!(exposed(&heights, &trajectory, -6.0).is_empty());
    }
}
