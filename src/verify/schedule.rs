//! The nodes of a claim that there is no plan: those that the spec asks for, holds left out.

use super::Rejection;
use super::interval::exceeds;
use crate::model::{Mission, MissionTime, Model};
use crate::report::number::number;

/// Two instants are one, as a share of the mission's time.
const SAME_TIME: f64 = 1e-9;

/// Waypoints at the spec's times, evenly divided legs, as many pieces as the spec has samples. The mission's time, s.
pub(super) fn check(model: &Model, mission: &Mission, times: &[f64], nodes: &[usize]) -> Result<f64, Rejection> {
    let wrong = |why: String| Err(Rejection { span: Some(model.plan.time_span), ..Rejection::new("the times", why) });
    let points = &mission.waypoints;
    let Some(end) = points.last() else { return wrong("the mission has no waypoints".into()) };
    let total = match (end.time, model.plan.time) {
        (Some(arrival), _) => arrival + end.hold,
        (None, MissionTime::Fixed(total)) => total,
        (None, MissionTime::Minimum) => return wrong("the spec leaves the time open".into()),
    };
    let in_order = nodes.windows(2).all(|w| w[0] < w[1]) && nodes.iter().all(|&n| n < times.len());
    if times.len() < 2
        || nodes.len() != points.len()
        || !in_order
        || nodes[0] != 0
        || nodes[nodes.len() - 1] + 1 != times.len()
    {
        return wrong(
            "each waypoint needs a node of its own, in flight order, the first and the last at the ends".into(),
        );
    }
    let holds = points.iter().filter(|w| w.hold > 0.0).count();
    let pieces = model.plan.samples.saturating_sub(holds).max(points.len() - 1);
    if times.len() != pieces + 1 {
        return wrong(format!("the spec's samples make {pieces} pieces in flight, and there are {}", times.len() - 1));
    }
    let Some(arrivals) = arrivals(mission, total) else { return wrong("some leg is left no time".into()) };
    let apart = |a: f64, b: f64| exceeds((a - b).abs(), SAME_TIME * total.max(1.0));
    for (leg, (ends, at)) in nodes.windows(2).zip(arrivals.windows(2)).enumerate() {
        let intervals = (ends[1] - ends[0]) as f64;
        for (node, &time) in times.iter().enumerate().take(ends[1] + 1).skip(ends[0]) {
            let due = at[0] + (at[1] - at[0]) * (node - ends[0]) as f64 / intervals;
            if apart(due, time) {
                return wrong(format!(
                    "node {node} on leg {} is due at {} s in flight and stands at {} s",
                    leg + 1,
                    number(due),
                    number(time)
                ));
            }
        }
    }
    if !times.windows(2).all(|w| w[0] < w[1]) {
        return wrong("they do not rise".into());
    }
    Ok(total)
}

/// When each waypoint is reached, time in holds not counted: between fixed arrivals legs share what holds leave.
fn arrivals(mission: &Mission, total: f64) -> Option<Vec<f64>> {
    let points = &mission.waypoints;
    let last = points.len() - 1;
    let mut flown = vec![0.0];
    let (mut from, mut left_at) = (0, 0.0);
    for to in 1..=last {
        let due = match points[to].time {
            Some(time) => time,
            None if to == last => total - points[to].hold,
            None => continue,
        };
        let held: f64 = points[from..to].iter().map(|w| w.hold).sum();
        let free = due - left_at - held;
        let shares: f64 = mission.legs[from..to].iter().map(|l| l.share).sum();
        let free = Some(free).filter(|f| *f > 0.0)?;
        for leg in &mission.legs[from..to] {
            flown.push(flown[flown.len() - 1] + free * leg.share / shares);
        }
        (from, left_at) = (to, due);
    }
    Some(flown)
}
