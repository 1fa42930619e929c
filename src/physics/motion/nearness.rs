//! How near the planned wrench comes to the boundary of a set over the course of a trajectory.

use super::Trajectory;
use super::felt::Flown;
use super::outside::PARTS;
use crate::admissible::row::SetRow;
use crate::model::{Environment, Vehicle};

/// The smallest margin in each of `columns` equal parts of the trajectory's duration, in widths of the healthy set;
/// negative outside, in the worst of the possible winds. The wrench is evaluated at the nodes, at [`PARTS`] points an
/// interval, and at the ends of the parts.
pub fn nearness(
    trajectory: &Trajectory,
    vehicle: &Vehicle,
    environment: &Environment,
    rows: &[SetRow],
    columns: usize,
) -> Vec<f64> {
    let flown = Flown::new(trajectory, vehicle, environment, rows);
    let step = trajectory.duration() / columns as f64;
    let mut smallest = vec![f64::INFINITY; columns];
    let margin = |k: usize, t: f64| {
        let felt = flown.at(&trajectory.within(k, t));
        rows.iter().map(|row| -felt.worst(row)).fold(f64::INFINITY, f64::min)
    };
    let mut note = |column: usize, m: f64| {
        if let Some(s) = smallest.get_mut(column) {
            *s = s.min(m);
        }
    };
    for k in 0..trajectory.intervals() {
        let (begin, end) = (trajectory.times[k], trajectory.times[k + 1]);
        for p in 0..=PARTS {
            let t = (end - begin) * p as f64 / PARTS as f64;
            // The end of the trajectory belongs to the last part.
            note((((begin + t) / step) as usize).min(columns - 1), margin(k, t));
        }
    }
    for edge in 1..columns {
        let t = step * edge as f64;
        let k = trajectory.interval_at(t);
        let m = margin(k, t - trajectory.times[k]);
        note(edge - 1, m);
        note(edge, m);
    }
    smallest
}
