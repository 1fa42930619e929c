//! The statements of a spec that a plan must satisfy.

use super::oracle::Part;
use crate::model::capture_height;
use crate::model::{Limit, LimitKind, MissionTime, Model, PlannerKind, Problem};
use crate::number::{number, part_of_all};
use crate::planner::transcription::UNBOUNDED;
use crate::source::Span;

/// One statement, or the default in its place. Indices are those in [`crate::model::Mission`] and [`Model`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Statement {
    /// The waypoints of one statement: more than one on a curve.
    Waypoints {
        first: usize,
        last: usize,
    },
    /// A waypoint's own `time`.
    Arrival(usize),
    /// The `hold` after a waypoint.
    Hold(usize),
    /// The `stop` of a waypoint.
    Stop(usize),
    RestAtStart,
    RestAtEnd,
    Limit(usize),
    /// `Model::modes[i]` must be tolerated.
    Mode(usize),
    Reserve,
    /// `time` in `plan`.
    Time,
}

/// Every statement that a plan of this planner must satisfy, in the order of flight.
pub fn statements(problem: Problem) -> Vec<Statement> {
    let (model, mission) = (problem.model(), problem.mission());
    let plan = &model.plan;
    let mut all = Vec::new();
    let mut first = 0;
    for group in mission.waypoints.chunk_by(|a, b| a.span == b.span) {
        all.push(Statement::Waypoints { first, last: first + group.len() - 1 });
        first += group.len();
    }
    for (i, waypoint) in mission.waypoints.iter().enumerate() {
        // The first waypoint is reached at time zero, whether stated or not.
        all.extend((i > 0 && waypoint.time.is_some()).then_some(Statement::Arrival(i)));
        all.extend((waypoint.hold > 0.0).then_some(Statement::Hold(i)));
        all.extend(waypoint.stop.then_some(Statement::Stop(i)));
    }
    all.extend(mission.start_at_rest.then_some(Statement::RestAtStart));
    all.extend(mission.end_at_rest.then_some(Statement::RestAtEnd));
    // The limits of a corridor are one statement.
    let is_first = |i: usize| {
        let is_corridor = |limit: &Limit| limit.leg.is_some() && limit.volume.is_some();
        !(i > 0 && is_corridor(&mission.limits[i]) && mission.limits[i - 1].span == mission.limits[i].span)
    };
    all.extend((0..mission.limits.len()).filter(|&i| is_first(i)).map(Statement::Limit));
    if plan.planner != PlannerKind::Rip {
        all.extend(plan.against.iter().map(|&mode| Statement::Mode(mode)));
    }
    all.extend((plan.reserve > 0.0).then_some(Statement::Reserve));
    all.extend(matches!(plan.time, MissionTime::Fixed(_)).then_some(Statement::Time));
    all
}

impl Statement {
    /// Whether it has rows, and so multipliers: times, holds and the reserve have none of their own.
    pub fn has_rows(self) -> bool {
        !self.parts().is_empty()
    }

    /// The parts of a program that come from it.
    pub fn parts(self) -> Vec<Part> {
        match self {
            Statement::Waypoints { first, last } => (first..=last).map(Part::Waypoint).collect(),
            Statement::RestAtStart => vec![Part::RestAtStart],
            Statement::RestAtEnd => vec![Part::RestAtEnd],
            Statement::Limit(i) => vec![Part::Limit(i)],
            Statement::Mode(i) => vec![Part::Mode(i)],
            Statement::Arrival(_) | Statement::Hold(_) | Statement::Stop(_) | Statement::Reserve | Statement::Time => {
                Vec::new()
            }
        }
    }

    /// Leaves it out of a spec. The waypoint times of the other statements do not change, except those that it fixed.
    pub fn leave_out(self, model: &mut Model) {
        let Model { mission: Some(mission), plan, .. } = model else { return };
        match self {
            Statement::Waypoints { first, last } => {
                for waypoint in &mut mission.waypoints[first..=last] {
                    (waypoint.within, waypoint.yaw_within, waypoint.weight) = (UNBOUNDED, UNBOUNDED, 0.0);
                }
            }
            Statement::Arrival(i) => mission.waypoints[i].time = None,
            Statement::Hold(i) => mission.waypoints[i].hold = 0.0,
            Statement::Stop(i) => mission.waypoints[i].stop = false,
            Statement::RestAtStart => mission.start_at_rest = false,
            Statement::RestAtEnd => mission.end_at_rest = false,
            Statement::Limit(i) => {
                let (span, of_leg) = (mission.limits[i].span, mission.limits[i].leg.is_some());
                // The limits that one statement gives a leg follow one another.
                let same = |limit: &&mut Limit| of_leg && limit.span == span;
                let (before, from) = mission.limits.split_at_mut(i);
                let (this, after) = from.split_at_mut(1);
                let others = before.iter_mut().rev().take_while(same).chain(after.iter_mut().take_while(same));
                this.iter_mut().chain(others).for_each(|limit| (limit.lower, limit.upper) = (None, None));
            }
            Statement::Mode(mode) => plan.against.retain(|&other| other != mode),
            Statement::Reserve => plan.reserve = 0.0,
            Statement::Time => plan.time = MissionTime::Minimum,
        }
    }

    /// Its place; for a default, the block to which it belongs.
    pub fn span(self, problem: Problem) -> Span {
        let (model, mission) = (problem.model(), problem.mission());
        let waypoint = |i: usize| &mission.waypoints[i];
        match self {
            Statement::Waypoints { first, .. } => waypoint(first).span,
            Statement::Arrival(i) => waypoint(i).time_span.unwrap_or(waypoint(i).span),
            Statement::Hold(i) => waypoint(i).hold_span.unwrap_or(waypoint(i).span),
            Statement::Stop(i) => waypoint(i).span,
            Statement::RestAtStart => waypoint(0).span,
            Statement::RestAtEnd => waypoint(mission.waypoints.len() - 1).span,
            Statement::Limit(i) => mission.limits[i].span,
            Statement::Mode(mode) => model.modes[mode].span,
            Statement::Reserve => model.plan.reserve_span,
            Statement::Time => model.plan.time_span,
        }
    }

    /// The kind as a word for JSON.
    pub fn kind(self) -> &'static str {
        match self {
            Statement::Waypoints { .. } => "waypoint",
            Statement::Arrival(_) => "arrival",
            Statement::Hold(_) => "hold",
            Statement::Stop(_) => "stop",
            Statement::RestAtStart => "rest_at_start",
            Statement::RestAtEnd => "rest_at_end",
            Statement::Limit(_) => "limit",
            Statement::Mode(_) => "mode",
            Statement::Reserve => "reserve",
            Statement::Time => "time",
        }
    }

    /// Its requirement, as a label at its place.
    pub fn label(self, problem: Problem) -> String {
        let (model, mission) = (problem.model(), problem.mission());
        match self {
            Statement::Waypoints { first, last } => {
                let points = &mission.waypoints[first..=last];
                let mut within = length(points[0].within);
                if !mission.has_one_yaw() {
                    within = format!("{within} and {} deg", number(points[0].yaw_within.to_degrees()));
                }
                match points.len() {
                    1 => format!("met within {within}"),
                    n if points.iter().all(|p| p.within == points[0].within) => {
                        format!("{n} points, each met within {within}")
                    }
                    n => format!("{n} points met"),
                }
            }
            Statement::Arrival(i) => match mission.waypoints[i].time {
                Some(time) => format!("at {} s", number(time)),
                None => "at any time".into(),
            },
            Statement::Hold(i) => format!("holding for {} s", number(mission.waypoints[i].hold)),
            Statement::Stop(_) => "coming to rest".into(),
            Statement::RestAtStart => "starting at rest".into(),
            Statement::RestAtEnd => "ending at rest".into(),
            Statement::Limit(i) => match clause(&mission.limits[i]) {
                Some(clause) => format!("keeping `{clause}`"),
                None => format!("keeping `{}`", written(&mission.limits[i])),
            },
            Statement::Mode(mode) => format!("{} tolerated", model.modes[mode].name),
            Statement::Reserve => {
                let default = model.defaults.iter().any(|d| d.field == "plan.reserve");
                let of = if default { " (the default)" } else { "" };
                format!("a reserve of {} %{of}", part_of_all(model.plan.reserve))
            }
            Statement::Time => match model.plan.time {
                MissionTime::Fixed(time) => format!("in {} s", number(time)),
                MissionTime::Minimum => "in the shortest time".into(),
            },
        }
    }
}

/// The clause of a waypoint that imposes a limit, if one does.
pub(super) fn clause(limit: &Limit) -> Option<&'static str> {
    let on = limit.leg.as_ref()?;
    if limit.volume.is_some() && on.name == capture_height::NAME {
        return Some("require capture_height");
    }
    let is_shape = |word: &&str| limit.volume.is_some() && on.name.starts_with(word);
    match limit.kind {
        LimitKind::Arrival(_) => Some("arrive from"),
        LimitKind::Heading(_) => Some("yaw"),
        _ => ["straight", "vertical", "corridor"].into_iter().find(is_shape),
    }
}

/// A limit as an author writes it: a rate that is bounded equally in both directions has only `<=`.
pub(super) fn written(limit: &Limit) -> String {
    let both_ways = limit.lower.is_some() && limit.lower == limit.upper.map(|upper| -upper);
    let lower = limit.lower.filter(|_| !both_ways);
    Limit { lower, ..limit.clone() }.to_string()
}

/// A tolerance as an author writes it: in centimetres below a metre.
pub(super) fn length(metres: f64) -> String {
    if metres < 1.0 { format!("{} cm", number(100.0 * metres)) } else { format!("{} m", number(metres)) }
}
