//! Straight lines that stay near a plan.

use super::Placed;
use crate::motion::{X, Y};

/// Samples of each interval between nodes from which corners are taken, and by which the result is measured.
const TAKEN: usize = 8;
pub const MEASURED: usize = 32;
/// A mission or line with more corners is refused.
pub const MOST_CORNERS: usize = 10_000;
/// Corners are chosen for this share of the tolerance first, and for less where the measurement shows it.
const FIRST_SHARE: f64 = 0.95;
const ROUNDS: usize = 6;

/// A corner of the line.
#[derive(Debug, Clone, Copy)]
pub struct Corner {
    /// s
    pub time: f64,
    pub position: [f64; 3],
    /// The waypoint of the mission that is reached here.
    pub waypoint: Option<usize>,
}

pub struct Line {
    pub corners: Vec<Corner>,
    /// The largest distance of the plan from the line, m, as measured with the corners as they are written.
    pub deviation: f64,
}

/// The line through the waypoints of the mission, with corners between them so that the plan is within the tolerance of
/// it (Ramer 1972, Douglas and Peucker 1973).
pub fn through(placed: &Placed) -> Result<Line, String> {
    let mut share = FIRST_SHARE;
    for _ in 0..ROUNDS {
        let corners = corners(placed, share * placed.tolerance);
        if corners.len() > MOST_CORNERS {
            return Err(format!("the plan needs more than {MOST_CORNERS} corners: give a larger --tolerance"));
        }
        let deviation = deviation(placed, &corners);
        if deviation <= placed.tolerance {
            return Ok(Line { corners, deviation });
        }
        share *= 0.5;
    }
    Err("the plan cannot be followed by straight lines as near as this: give a larger --tolerance".into())
}

/// Instants of the plan, s: `each` for every interval between nodes, and the end.
pub fn instants(placed: &Placed, each: usize) -> Vec<f64> {
    let times = &placed.trajectory.times;
    let between = times.windows(2).flat_map(|pair| {
        let [from, to] = [pair[0], pair[1]];
        (0..each).map(move |k| from + (to - from) * k as f64 / each as f64)
    });
    between.chain(times.last().copied()).collect()
}

fn corners(placed: &Placed, tolerance: f64) -> Vec<Corner> {
    let times = instants(placed, TAKEN);
    let positions: Vec<[f64; 3]> = times.iter().map(|t| placed.position(*t)).collect();
    // Waypoints are reached at nodes. A waypoint that holds is reached when the hold begins.
    let fixed: Vec<(usize, Option<usize>)> =
        placed.trajectory.waypoint_nodes.iter().enumerate().map(|(k, node)| (node * TAKEN, Some(k))).collect();
    let mut kept = vec![(0, None)];
    for (index, waypoint) in fixed.into_iter().chain([(times.len() - 1, None)]) {
        let from = kept[kept.len() - 1].0;
        if index > from {
            split(&positions, from, index, tolerance, &mut kept);
            kept.push((index, waypoint));
        } else if waypoint.is_some() {
            let last = kept.len() - 1;
            kept[last].1 = waypoint;
        }
    }
    let corner = |(index, waypoint): (usize, Option<usize>)| Corner {
        time: times[index],
        // What a reader of the file gets.
        position: placed.local(placed.spot(positions[index])),
        waypoint,
    };
    kept.into_iter().map(corner).collect()
}

/// Keeps the sample between two that is farthest from the segment through them, if it is too far, and so on on both
/// sides; in the order of time, without recursion.
fn split(positions: &[[f64; 3]], from: usize, to: usize, tolerance: f64, kept: &mut Vec<(usize, Option<usize>)>) {
    let mut open = vec![(from, to)];
    while let Some((from, to)) = open.pop() {
        let far = (from + 1..to).map(|i| (i, distance(positions[i], positions[from], positions[to])));
        match far.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, far)| *far > tolerance) {
            Some((at, _)) => open.extend([(at, to), (from, at)]),
            None if from > kept[kept.len() - 1].0 => kept.push((from, None)),
            None => {}
        }
    }
}

/// The distance of p from the segment from a to b, m.
pub fn distance(p: [f64; 3], a: [f64; 3], b: [f64; 3]) -> f64 {
    let [along, from]: [[f64; 3]; 2] = [[b, a], [p, a]].map(|[to, from]| std::array::from_fn(|i| to[i] - from[i]));
    let dot = |u: [f64; 3], v: [f64; 3]| (0..3).map(|i| u[i] * v[i]).sum::<f64>();
    let length = dot(along, along);
    let share = if length > 0.0 { (dot(from, along) / length).clamp(0.0, 1.0) } else { 0.0 };
    let off: [f64; 3] = std::array::from_fn(|i| from[i] - share * along[i]);
    dot(off, off).sqrt()
}

/// The largest distance of the plan from the segment of its time, m.
pub fn deviation(placed: &Placed, corners: &[Corner]) -> f64 {
    let mut segment = 0;
    let mut largest = 0.0_f64;
    for t in instants(placed, MEASURED) {
        while segment + 2 < corners.len() && t > corners[segment + 1].time {
            segment += 1;
        }
        let [a, b] = [segment, (segment + 1).min(corners.len() - 1)].map(|i| corners[i].position);
        largest = largest.max(distance(placed.position(t), a, b));
    }
    largest
}

/// The largest horizontal speed of the plan between two times, m/s.
pub fn fastest(placed: &Placed, from: f64, to: f64) -> f64 {
    const SAMPLES: usize = 40;
    let speed = |k: usize| {
        let state = placed.trajectory.at(from + (to - from) * k as f64 / SAMPLES as f64);
        state[X][1].hypot(state[Y][1])
    };
    (0..=SAMPLES).map(speed).fold(0.0, f64::max)
}
