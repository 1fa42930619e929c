//! When things happen, from the spec alone: the nodes that a proof of no plan is about, and what a plan's node times have
//! to agree with.

use super::Rejection;
use super::interval::exceeds;
use super::motion::Motion;
use super::premise::{Premise, Premises};
use crate::model::grid::{fewest_pieces, is_coarser, leg_durations, pieces};
use crate::model::{Mission, MissionTime, Model};
use crate::number::number;
use crate::source::Span;

/// Two instants are one, as a share of the mission's time.
const SAME_TIME: f64 = 1e-9;

/// A piece counts as no longer than another up to this share.
const SAME_DURATION: f64 = 1e-6;

fn apart(a: f64, b: f64, total: f64) -> bool {
    exceeds((a - b).abs(), SAME_TIME * total.max(1.0))
}

/// Whether two instants of a mission of `total` s are one.
pub(super) fn is_one_time(a: f64, b: f64, total: f64) -> bool {
    !apart(a, b, total)
}

fn wrong<T>(why: String, span: Option<Span>) -> Result<T, Rejection> {
    Err(Rejection { span, ..Rejection::new("the times", why) })
}

/// The mission time that the spec fixes, s.
pub(super) fn fixed_total(model: &Model, mission: &Mission) -> Option<f64> {
    let end = mission.waypoints.last()?;
    match (end.time, model.plan.time) {
        (Some(arrival), _) => Some(arrival + end.hold),
        (None, MissionTime::Fixed(total)) => Some(total),
        (None, MissionTime::Minimum) => None,
    }
}

/// Nodes without holds, in which nothing changes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Grid {
    /// The mission's time, holds included, s.
    pub total: f64,
    /// s
    pub times: Vec<f64>,
    pub waypoint_nodes: Vec<usize>,
}

/// The nodes that the spec's times and samples ask for.
///
/// # Errors
/// The spec leaves times open, or leaves some leg no time.
pub(super) fn grid(model: &Model, mission: &Mission) -> Result<Grid, Rejection> {
    let span = Some(model.plan.time_span);
    if model.plan.chooses_times {
        return wrong(
            "multipliers are about waypoint times that the spec lays down, and here they are free".into(),
            span,
        );
    }
    let Some(total) = fixed_total(model, mission) else { return wrong("the spec leaves the time open".into(), span) };
    let Some(durations) = leg_durations(mission, total) else { return wrong("some leg is left no time".into(), span) };
    let (mut times, mut waypoint_nodes) = (vec![0.0], vec![0]);
    let mut begin = 0.0;
    for (&duration, count) in durations.iter().zip(pieces(mission, &durations, model.plan.samples)) {
        times.extend((1..=count).map(|i| begin + mission.spacing.start_of(duration, i, count)));
        begin += duration;
        waypoint_nodes.push(times.len() - 1);
    }
    match times.windows(2).all(|w| w[0] < w[1]) {
        true => Ok(Grid { total, times, waypoint_nodes }),
        false => wrong("some leg is left too little time for its pieces".into(), span),
    }
}

/// What a plan's times leave to be said: how far the motion has fewer pieces than the spec asks for.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Coarser {
    /// Legs with longer pieces than the spec's ([`is_coarser`]).
    pub legs: usize,
}

/// Holds a motion's node times against the spec, and asks for looks within pieces that are longer than the spec's samples
/// make them.
///
/// # Errors
/// The times are not those of the spec.
pub(super) fn check(
    model: &Model,
    mission: &Mission,
    motion: &mut Motion,
    premises: Premises,
) -> Result<Coarser, Rejection> {
    let points = &mission.waypoints;
    let last = motion.times.len() - 1;
    let nodes = motion.waypoint_nodes.clone();
    // Without this nothing below has a meaning, so it cannot be switched off.
    let in_order = nodes.iter().all(|&n| n <= last) && nodes.windows(2).all(|w| w[0] < w[1]);
    if nodes.len() != points.len() || !in_order || nodes.first() != Some(&0) {
        let why = "each waypoint needs a node of its own, in flight order, the first at the start";
        return wrong(why.into(), None);
    }
    if premises.has(Premise::Times) {
        agrees(model, mission, motion)?;
    }
    match premises.has(Premise::Density) {
        true => Ok(dense(model, mission, motion)),
        false => Ok(Coarser::default()),
    }
}

/// Start, fixed times, holds, the end and the shares of the legs.
fn agrees(model: &Model, mission: &Mission, motion: &Motion) -> Result<(), Rejection> {
    let points = &mission.waypoints;
    let (times, nodes) = (&motion.times, &motion.waypoint_nodes);
    let end = times[times.len() - 1];
    if times[0] != 0.0 {
        return wrong(format!("the motion begins at {} s", number(times[0])), None);
    }
    if let Some(total) = fixed_total(model, mission).filter(|&total| apart(total, end, total)) {
        let why = format!("the mission is to take {} s and takes {} s", number(total), number(end));
        return wrong(why, Some(model.plan.time_span));
    }
    for (i, point) in points.iter().enumerate() {
        let arrival = times[nodes[i]];
        if let Some(fixed) = point.time.filter(|&fixed| apart(fixed, arrival, fixed)) {
            let why = format!("waypoint {} is due at {} s and reached at {} s", i + 1, number(fixed), number(arrival));
            return wrong(why, point.time_span);
        }
        let Some(leaves) = held_until(mission, motion, i) else {
            let why = format!("the motion does not stay {} s at waypoint {}", number(point.hold), i + 1);
            return wrong(why, point.hold_span);
        };
        if i + 1 == points.len() && leaves + 1 != times.len() {
            return wrong("the motion goes on after the last waypoint".into(), Some(point.span));
        }
    }
    if model.plan.chooses_times {
        return Ok(());
    }
    let Some(durations) = leg_durations(mission, end) else {
        return wrong("some leg is left no time".into(), Some(model.plan.time_span));
    };
    let mut due = 0.0;
    for (i, duration) in durations.iter().enumerate() {
        due += points[i].hold + duration;
        let arrival = times[nodes[i + 1]];
        if apart(due, arrival, end) {
            let why = format!(
                "waypoint {} is due at {} s, its share of the mission's time, and reached at {} s",
                i + 2,
                number(due),
                number(arrival)
            );
            return wrong(why, Some(points[i + 1].span));
        }
    }
    Ok(())
}

/// The node at which a waypoint's hold ends; its own where there is none.
pub(super) fn held_until(mission: &Mission, motion: &Motion, waypoint: usize) -> Option<usize> {
    let node = motion.waypoint_nodes[waypoint];
    let hold = mission.waypoints[waypoint].hold;
    if hold <= 0.0 {
        return Some(node);
    }
    let ends = motion.times[node] + hold;
    let total = motion.times[motion.times.len() - 1];
    let until = motion.waypoint_nodes.get(waypoint + 1).copied().unwrap_or(motion.times.len());
    (node + 1..until).find(|&n| !apart(motion.times[n], ends, total))
}

/// Where a leg has pieces longer than the spec's samples make them there, rows are looked at within them as often as those
/// samples would.
fn dense(model: &Model, mission: &Mission, motion: &mut Motion) -> Coarser {
    let mut legs = Vec::new();
    for leg in 0..mission.legs.len() {
        let Some(first) = held_until(mission, motion, leg) else { continue };
        legs.push((first, motion.waypoint_nodes[leg + 1]));
    }
    let durations: Vec<f64> = legs.iter().map(|&(a, b)| motion.times[b] - motion.times[a]).collect();
    // Where the spec lays times down, its own durations count: pieces are shared out in whole numbers, and a difference in
    // the last digit can give one to another leg.
    let end = motion.times[motion.times.len() - 1];
    let laid_down = leg_durations(mission, end).filter(|_| !model.plan.chooses_times);
    let due = laid_down.as_ref().unwrap_or(&durations);
    let (asked, fewest) = (pieces(mission, due, model.plan.samples), fewest_pieces(mission, due, model.plan.samples));
    let mut coarser = Coarser::default();
    for (leg, (&(first, last), &duration)) in legs.iter().zip(&durations).enumerate() {
        let begin = motion.times[first];
        let share = |t: f64| mission.spacing.share(duration, (t - begin) / duration);
        coarser.legs += usize::from(is_coarser(mission, &motion.times[first..=last], fewest[leg]));
        for piece in first..last {
            let pieces = (share(motion.times[piece + 1]) - share(motion.times[piece])) * asked[leg] as f64;
            if exceeds(pieces, 1.0 + SAME_DURATION) {
                // At least one point between; a float cast saturates.
                motion.ask(piece, ((pieces - SAME_DURATION).ceil() as usize).saturating_sub(1));
            }
        }
    }
    coarser
}
