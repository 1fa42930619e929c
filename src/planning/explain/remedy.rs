//! Single changes to a spec that give it a plan, each found by planning.

use super::Conflict;
use super::grid::between;
use super::oracle::Answer;
use super::question::Questions;
use super::statement::Statement;
use crate::admissible::diagnose::diagnose;
use crate::diagnostic::Severity;
use crate::model::{Limit, LimitKind, MissionTime, Model, Problem};
use std::collections::BTreeSet;

/// A change to a spec. Numbers are SI and have two significant digits in the unit of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Change {
    /// A different `samples`.
    Samples(usize),
    /// A different `time` of the plan.
    Time(f64),
    /// A different `time` of a waypoint; if it is the last one and the plan fixes its time too, both.
    Arrival { waypoint: usize, time: f64 },
    /// A different `within` of the waypoints of one statement.
    Within { first: usize, last: usize, within: f64 },
    /// A wider bound.
    Bound { limit: usize, upper: f64 },
    /// A different `reserve`.
    Reserve(f64),
    /// A limit is removed.
    NoLimit(usize),
    /// A hold is removed.
    NoHold(usize),
    /// A stop is removed.
    NoStop(usize),
    /// A mode is removed from `against`.
    NoMode(usize),
    /// A lighter vehicle.
    Mass(f64),
}

/// A change that was tried and gives a plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fix {
    pub change: Change,
    /// The mission time of that plan, s.
    pub time: f64,
}

/// Tolerances are widened up to this share of the distance to the nearest adjacent waypoint. Chosen by hand.
const WIDEST: f64 = 0.25;
/// Tolerances are widened up to this factor: beyond that it would be a different mission. Chosen by hand.
const WIDER_WITHIN: f64 = 10.0;
/// Bounds are widened up to this factor. Chosen by hand.
const WIDER: f64 = 10.0;
/// The lightest vehicle that is tried, as a share of the spec's. Chosen by hand.
const LIGHTEST: f64 = 0.5;
/// Largest tilt limit that is tried, degrees. Chosen by hand.
const MOST_TILT: f64 = 89.0;

/// Changes that give the whole spec a plan, cheapest first: changes that cost time, then accuracy, then limits and
/// reserve, then removed statements, then a different vehicle.
pub(super) fn fixes(questions: &mut Questions, conflict: &Conflict) -> Vec<Fix> {
    let model = questions.problem.model();
    let mut found = Vec::new();
    let needed = questions.problem.mission().samples_needed();
    if model.plan.samples < needed {
        found.extend(attempt(questions, Change::Samples(needed)));
    }
    let of = |wanted: fn(&Statement) -> bool| -> Vec<Statement> {
        conflict.statements.iter().copied().filter(wanted).collect()
    };
    for statement in of(|s| matches!(s, Statement::Time)) {
        found.extend(longer(questions, statement));
    }
    for statement in of(|s| matches!(s, Statement::Arrival(_))) {
        found.extend(longer(questions, statement));
    }
    for statement in of(|s| matches!(s, Statement::Waypoints { .. })) {
        found.extend(wider(questions, statement));
    }
    for statement in of(|s| matches!(s, Statement::Limit(_) | Statement::Reserve)) {
        found.extend(looser(questions, statement));
    }
    for statement in
        of(|s| matches!(s, Statement::Limit(_) | Statement::Hold(_) | Statement::Stop(_) | Statement::Mode(_)))
    {
        // A limit that can be widened need not be removed.
        if found.iter().all(|fix: &Fix| fix.change.of() != Some(statement)) {
            found.extend(less(statement).and_then(|change| attempt(questions, change)));
        }
    }
    let mass = model.vehicle.mass;
    found.extend(seek(questions, &between(mass, LIGHTEST * mass), Change::Mass));
    found
}

/// A later time, of the plan or of a waypoint.
fn longer(questions: &mut Questions, statement: Statement) -> Option<Fix> {
    let (model, mission) = (questions.problem.model(), questions.problem.mission());
    match (statement, model.plan.time) {
        (Statement::Time, MissionTime::Fixed(time)) => seek(questions, &between(time, questions.long()), Change::Time),
        (Statement::Arrival(waypoint), _) => {
            let time = mission.waypoints[waypoint].time?;
            let last = waypoint + 1 == mission.waypoints.len();
            let next = mission.waypoints[waypoint + 1..].iter().find_map(|w| w.time);
            let end = match model.plan.time {
                MissionTime::Fixed(total) if !last => Some(total),
                _ => None,
            };
            let latest = next.or(end).unwrap_or(questions.long());
            seek(questions, &between(time, latest), |time| Change::Arrival { waypoint, time })
        }
        _ => None,
    }
}

/// Wider tolerances of the waypoints of one statement, except the start, where the vehicle is given.
fn wider(questions: &mut Questions, statement: Statement) -> Option<Fix> {
    let Statement::Waypoints { first, last } = statement else { return None };
    if last == 0 {
        return None;
    }
    let points = &questions.problem.mission().waypoints;
    let apart =
        |i: usize| (0..3).map(|k| (points[i].position[k] - points[i + 1].position[k]).powi(2)).sum::<f64>().sqrt();
    let beside = first.saturating_sub(1)..(last + 1).min(points.len() - 1);
    let nearest = beside.map(apart).fold(f64::INFINITY, f64::min);
    let within = points[first..=last].iter().map(|w| w.within).fold(0.0, f64::max);
    // Two digits in centimetres are two digits in metres.
    let centimetres = between(100.0 * within, 100.0 * (WIDEST * nearest).min(WIDER_WITHIN * within));
    seek(questions, &centimetres, |cm| Change::Within { first, last, within: cm / 100.0 })
}

/// A wider bound of a limit, or a smaller reserve.
fn looser(questions: &mut Questions, statement: Statement) -> Option<Fix> {
    match statement {
        Statement::Limit(limit) => {
            let Limit { kind, lower, upper, volume, .. } = &questions.problem.mission().limits[limit];
            let (lower, upper) = (*lower, *upper);
            if volume.is_some() || kind.is_arrival() || kind.is_heading() {
                return None;
            }
            let upper = upper.filter(|u| *u > 0.0 && (lower.is_none() || lower == Some(-u)))?;
            if kind.describe().quantity.is_coordinate() {
                return None;
            }
            let scale = kind.describe().unit_in_si;
            let most = if *kind == LimitKind::Tilt { MOST_TILT } else { f64::INFINITY };
            let values = between(upper / scale, (WIDER * upper / scale).min(most));
            seek(questions, &values, |value| Change::Bound { limit, upper: value * scale })
        }
        Statement::Reserve => {
            let shares: Vec<f64> =
                (0..(100.0 * questions.problem.model().plan.reserve).ceil() as i32).rev().map(f64::from).collect();
            seek(questions, &shares, |share| Change::Reserve(share / 100.0))
        }
        _ => None,
    }
}

/// The first of the ascending changes `values` that gives a plan: in steps of growing length, then by bisection. If
/// feasibility is not monotone in the change, the result still gives a plan but need not be the first.
fn seek(questions: &mut Questions, values: &[f64], change: impl Fn(f64) -> Change) -> Option<Fix> {
    let end = values.len().checked_sub(1)?;
    // If the largest change does not help, none does; except for a waypoint's time, which must leave time for the legs
    // after it.
    let is_arrival = matches!(change(values[0]), Change::Arrival { .. });
    let furthest = attempt(questions, change(values[end]));
    if furthest.is_none() && !is_arrival {
        return None;
    }
    let mut best = (end, furthest);
    let (mut low, mut step) = (None::<usize>, 1);
    let mut next = 0;
    while next < best.0 {
        match attempt(questions, change(values[next])) {
            Some(fix) => best = (next, Some(fix)),
            None => low = Some(next),
        }
        next += step;
        step *= 2;
    }
    best.1?;
    let mut low = low.map_or(0, |l| l + 1);
    while low < best.0 {
        let middle = low + (best.0 - low) / 2;
        match attempt(questions, change(values[middle])) {
            Some(fix) => best = (middle, Some(fix)),
            None => low = middle + 1,
        }
    }
    best.1
}

/// The change that removes a statement, if an author might do so.
fn less(statement: Statement) -> Option<Change> {
    match statement {
        Statement::Limit(limit) => Some(Change::NoLimit(limit)),
        Statement::Hold(waypoint) => Some(Change::NoHold(waypoint)),
        Statement::Stop(waypoint) => Some(Change::NoStop(waypoint)),
        Statement::Mode(mode) => Some(Change::NoMode(mode)),
        _ => None,
    }
}

/// Tries one change.
fn attempt(questions: &mut Questions, change: Change) -> Option<Fix> {
    let mut model = questions.variant(&BTreeSet::new());
    change.apply(&mut model);
    if matches!(change, Change::Mass(_)) && diagnose(&model).iter().any(|d| d.severity == Severity::Error) {
        return None;
    }
    let problem = Problem::of(&model)?;
    let (time, _) = questions.time_of(problem);
    (questions.ask(problem)? == Answer::Feasible).then_some(Fix { change, time })
}

impl Change {
    /// Applies the change to a spec; without a mission there is nothing to change.
    pub fn apply(self, model: &mut Model) {
        let Model { mission: Some(mission), plan, vehicle, .. } = model else { return };
        match self {
            Change::Samples(samples) => plan.samples = samples,
            Change::Time(time) => plan.time = MissionTime::Fixed(time),
            Change::Arrival { waypoint, time } => {
                let last = waypoint + 1 == mission.waypoints.len();
                let waypoint = &mut mission.waypoints[waypoint];
                waypoint.time = Some(time);
                if last && matches!(plan.time, MissionTime::Fixed(_)) {
                    plan.time = MissionTime::Fixed(time + waypoint.hold);
                }
            }
            Change::Within { first, last, within } => {
                mission.waypoints[first..=last].iter_mut().for_each(|w| w.within = w.within.max(within));
            }
            Change::Bound { limit, upper } => {
                let limit = &mut mission.limits[limit];
                limit.upper = Some(upper);
                limit.lower = limit.lower.map(|_| -upper);
            }
            Change::Reserve(reserve) => plan.reserve = reserve,
            Change::NoLimit(limit) => Statement::Limit(limit).leave_out(model),
            Change::NoHold(waypoint) => Statement::Hold(waypoint).leave_out(model),
            Change::NoStop(waypoint) => Statement::Stop(waypoint).leave_out(model),
            Change::NoMode(mode) => Statement::Mode(mode).leave_out(model),
            Change::Mass(mass) => vehicle.mass = mass,
        }
    }

    /// The kind as a word for JSON.
    pub fn kind(self) -> &'static str {
        match self {
            Change::Samples(_) => "samples",
            Change::Time(_) => "time",
            Change::Arrival { .. } => "arrival",
            Change::Within { .. } => "within",
            Change::Bound { .. } => "limit",
            Change::Reserve(_) => "reserve",
            Change::NoLimit(_) => "no_limit",
            Change::NoHold(_) => "no_hold",
            Change::NoStop(_) => "no_stop",
            Change::NoMode(_) => "no_mode",
            Change::Mass(_) => "mass",
        }
    }

    /// The new value, SI.
    pub fn value(self) -> Option<f64> {
        match self {
            Change::Samples(samples) => Some(samples as f64),
            Change::Time(v) | Change::Reserve(v) | Change::Mass(v) => Some(v),
            Change::Arrival { time, .. } => Some(time),
            Change::Within { within, .. } => Some(within),
            Change::Bound { upper, .. } => Some(upper),
            Change::NoLimit(_) | Change::NoHold(_) | Change::NoStop(_) | Change::NoMode(_) => None,
        }
    }

    /// The statement that it changes; `None` if it is not one of [`Statement`].
    pub fn of(self) -> Option<Statement> {
        match self {
            Change::Samples(_) | Change::Mass(_) => None,
            Change::Time(_) => Some(Statement::Time),
            Change::Arrival { waypoint, .. } => Some(Statement::Arrival(waypoint)),
            Change::Within { first, last, .. } => Some(Statement::Waypoints { first, last }),
            Change::Bound { limit, .. } | Change::NoLimit(limit) => Some(Statement::Limit(limit)),
            Change::Reserve(_) => Some(Statement::Reserve),
            Change::NoHold(waypoint) => Some(Statement::Hold(waypoint)),
            Change::NoStop(waypoint) => Some(Statement::Stop(waypoint)),
            Change::NoMode(mode) => Some(Statement::Mode(mode)),
        }
    }
}
