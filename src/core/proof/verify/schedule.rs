//! Times that follow from the spec alone: the nodes of a proof that there is no plan, and the conditions on a plan's
//! node times.

use super::Rejection;
use super::interval::exceeds;
use super::motion::Motion;
use super::premise::{Premise, Premises};
use crate::model::grid::{fewest_pieces, is_coarser, leg_durations, pieces};
use crate::model::{Mission, MissionTime, Problem};
use crate::number::number;
use crate::source::Span;

/// Instants that differ by less than this share of the mission time count as equal.
const SAME_TIME: f64 = 1e-9;

/// A piece counts as longer than another only if it is longer by more than this share.
const SAME_DURATION: f64 = 1e-6;

fn apart(a: f64, b: f64, total: f64) -> bool {
    exceeds((a - b).abs(), SAME_TIME * total.max(1.0))
}

/// Whether two instants of a mission of `total` s count as equal.
pub(super) fn is_one_time(a: f64, b: f64, total: f64) -> bool {
    !apart(a, b, total)
}

fn wrong<T>(why: String, span: Option<Span>) -> Result<T, Rejection> {
    Err(Rejection { span, ..Rejection::new("the times", why) })
}

/// The mission time that the spec fixes, s.
pub(super) fn fixed_total(problem: Problem) -> Option<f64> {
    let (model, mission) = (problem.model(), problem.mission());
    let end = mission.waypoints.last()?;
    match (end.time, model.plan.time) {
        (Some(arrival), _) => Some(arrival + end.hold),
        (None, MissionTime::Fixed(total)) => Some(total),
        (None, MissionTime::Minimum) => None,
    }
}

/// Nodes of the flight; holds are omitted, because nothing changes in them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Grid {
    /// The mission's time, holds included, s.
    pub total: f64,
    /// s
    pub times: Vec<f64>,
    pub waypoint_nodes: Vec<usize>,
}

/// The nodes given by the spec's times and samples.
///
/// # Errors
/// The spec leaves times free, or leaves no time for some leg.
pub(super) fn grid(problem: Problem) -> Result<Grid, Rejection> {
    let (model, mission) = (problem.model(), problem.mission());
    let span = Some(model.plan.time_span);
    if model.plan.chooses_times {
        return wrong(
            "multipliers require waypoint times that are fixed by the spec, but here they are free".into(),
            span,
        );
    }
    let Some(total) = fixed_total(problem) else { return wrong("the spec leaves the time free".into(), span) };
    let Some(durations) = leg_durations(mission, total) else {
        return wrong("no time is left for some leg".into(), span);
    };
    let (mut times, mut waypoint_nodes) = (vec![0.0], vec![0]);
    let mut begin = 0.0;
    for (&duration, count) in durations.iter().zip(pieces(mission, &durations, model.plan.samples)) {
        times.extend((1..=count).map(|i| begin + mission.spacing.start_of(duration, i, count)));
        begin += duration;
        waypoint_nodes.push(times.len() - 1);
    }
    match times.windows(2).all(|w| w[0] < w[1]) {
        true => Ok(Grid { total, times, waypoint_nodes }),
        false => wrong("too little time is left for the pieces of some leg".into(), span),
    }
}

/// How much coarser a motion's grid is than the spec's.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Coarser {
    /// Legs with longer pieces than the spec's ([`is_coarser`]).
    pub legs: usize,
}

/// Compares a motion's node times with the spec, and adds points to check within pieces that are longer than the spec's
/// samples give.
///
/// # Errors
/// The times are not those of the spec.
pub(super) fn check(problem: Problem, motion: &mut Motion, premises: Premises) -> Result<Coarser, Rejection> {
    let mission = problem.mission();
    let points = &mission.waypoints;
    let last = motion.times.len() - 1;
    let nodes = motion.waypoint_nodes.clone();
    // Everything below relies on this, so it is not a premise that can be disabled.
    let in_order = nodes.iter().all(|&n| n <= last) && nodes.windows(2).all(|w| w[0] < w[1]);
    if nodes.len() != points.len() || !in_order || nodes.first() != Some(&0) {
        let why = "each waypoint needs a node of its own, in flight order, the first at the start";
        return wrong(why.into(), None);
    }
    if premises.has(Premise::Times) {
        agrees(problem, motion)?;
    }
    match premises.has(Premise::Density) {
        true => Ok(dense(problem, motion)),
        false => Ok(Coarser::default()),
    }
}

/// Checks the start, fixed times, holds, the end and the shares of the legs.
fn agrees(problem: Problem, motion: &Motion) -> Result<(), Rejection> {
    let (model, mission) = (problem.model(), problem.mission());
    let points = &mission.waypoints;
    let (times, nodes) = (&motion.times, &motion.waypoint_nodes);
    let end = times[times.len() - 1];
    if times[0] != 0.0 {
        return wrong(format!("the motion begins at {} s, not at 0 s", number(times[0])), None);
    }
    if let Some(total) = fixed_total(problem).filter(|&total| apart(total, end, total)) {
        let why = format!("the mission must take {} s but takes {} s", number(total), number(end));
        return wrong(why, Some(model.plan.time_span));
    }
    for (i, point) in points.iter().enumerate() {
        let arrival = times[nodes[i]];
        if let Some(fixed) = point.time.filter(|&fixed| apart(fixed, arrival, fixed)) {
            let why = format!("waypoint {} is due at {} s but reached at {} s", i + 1, number(fixed), number(arrival));
            return wrong(why, point.time_span);
        }
        let Some(leaves) = held_until(mission, motion, i) else {
            let why = format!("the motion does not stay {} s at waypoint {}", number(point.hold), i + 1);
            return wrong(why, point.hold_span);
        };
        if i + 1 == points.len() && leaves + 1 != times.len() {
            return wrong("the motion continues after the last waypoint".into(), Some(point.span));
        }
    }
    if model.plan.chooses_times {
        return Ok(());
    }
    let Some(durations) = leg_durations(mission, end) else {
        return wrong("no time is left for some leg".into(), Some(model.plan.time_span));
    };
    let mut due = 0.0;
    for (i, duration) in durations.iter().enumerate() {
        due += points[i].hold + duration;
        let arrival = times[nodes[i + 1]];
        if apart(due, arrival, end) {
            let why = format!(
                "waypoint {} is due at {} s, its share of the mission time, but reached at {} s",
                i + 2,
                number(due),
                number(arrival)
            );
            return wrong(why, Some(points[i + 1].span));
        }
    }
    Ok(())
}

/// The node at which a waypoint's hold ends; its own node without a hold; `None` if no node is at that time.
pub(super) fn held_until(mission: &Mission, motion: &Motion, waypoint: usize) -> Option<usize> {
    let node = motion.waypoint_nodes[waypoint];
    let hold = mission.waypoints[waypoint].hold;
    if hold <= 0.0 {
        return Some(node);
    }
    let ends = motion.times[node] + hold;
    let total = motion.times[motion.times.len() - 1];
    let until = motion.waypoint_nodes.get(waypoint + 1).copied().unwrap_or(motion.times.len());
    let later = motion.times.get(node + 1..until)?;
    let reached = node + 1 + later.partition_point(|&time| time < ends && apart(time, ends, total));
    (reached < until && !apart(motion.times[reached], ends, total)).then_some(reached)
}

/// Adds points to check within pieces that are longer than the spec's samples give, as densely as those samples.
fn dense(problem: Problem, motion: &mut Motion) -> Coarser {
    let (model, mission) = (problem.model(), problem.mission());
    let mut legs = Vec::new();
    for leg in 0..mission.legs.len() {
        let Some(first) = held_until(mission, motion, leg) else { continue };
        legs.push((first, motion.waypoint_nodes[leg + 1]));
    }
    let durations: Vec<f64> = legs.iter().map(|&(a, b)| motion.times[b] - motion.times[a]).collect();
    // If the spec fixes the times, its own durations count: pieces are distributed in whole numbers, and a difference
    // in the last digit can assign a piece to another leg.
    let end = motion.times[motion.times.len() - 1];
    let fixed = leg_durations(mission, end).filter(|_| !model.plan.chooses_times);
    let due = fixed.as_ref().unwrap_or(&durations);
    let (required, fewest) =
        (pieces(mission, due, model.plan.samples), fewest_pieces(mission, due, model.plan.samples));
    let mut coarser = Coarser::default();
    for (leg, (&(first, last), &duration)) in legs.iter().zip(&durations).enumerate() {
        let begin = motion.times[first];
        let share = |t: f64| mission.spacing.share(duration, (t - begin) / duration);
        coarser.legs += usize::from(is_coarser(mission, &motion.times[first..=last], fewest[leg]));
        for piece in first..last {
            let pieces = (share(motion.times[piece + 1]) - share(motion.times[piece])) * required[leg] as f64;
            if exceeds(pieces, 1.0 + SAME_DURATION) {
                // At least one point inside; a float cast saturates.
                motion.set_extra_points(piece, ((pieces - SAME_DURATION).ceil() as usize).saturating_sub(1));
            }
        }
    }
    coarser
}
