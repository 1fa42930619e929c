//! Legs on which a plan climbs or strays although no volume is in the way, with a statement that forbids it, and what
//! that statement costs: the time of a plan with it, found by one quick search.

use crate::cancel;
use crate::certify;
use crate::model::legs::distance;
use crate::model::volume::{corridor, passage};
use crate::model::{Limit, LimitKind, Mission, MissionTime, OnLeg, Part, PlanModel, Problem, SearchEffort};
use crate::motion::shape::Shape;
use crate::planner::studies::{self, Comparison, MissionPlan, PlanOutcome, PlannerRun, hardly_shorter};
use crate::solve::Effort;
use std::sync::Arc;

/// A plan may climb this far above the higher waypoint of a leg, and stray this far from its straight line, m. Chosen
/// by hand.
const USUAL: f64 = 1.0;
/// A plan may stray from the line by this share of the leg's length, if that is more. Chosen by hand.
const SHARE: f64 = 0.1;
/// A plan may climb and stray by this much more, m, so that one at the bound of a statement that forbids more is not
/// remarked on.
const SLACK: f64 = 1e-3;
/// A limit on height for all legs leaves at least this much above the highest waypoint, m. Chosen by hand.
const HEADROOM: f64 = 0.5;
/// Values of statements are rounded down to multiples of one over this, 1/m.
const TENTHS: f64 = 10.0;
/// Waypoints nearer to each other than this have no line between them, m.
const SAME_PLACE: f64 = 1e-6;

/// The largest missions for which a statement is tried: in these, a quick search takes seconds. Chosen by hand.
const MOST_WAYPOINTS: usize = 12;
const MOST_ROTORS: usize = 8;

/// How a plan leaves its legs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DetourKind {
    /// It climbs above the higher waypoint of a leg.
    Climb,
    /// It strays from the straight line of a leg.
    Deviation,
}

/// A statement that forbids a detour, with its value, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Forbids {
    /// A limit on height for the whole mission.
    Altitude(f64),
    /// A limit on height for one leg.
    AltitudeOfLeg(f64),
    /// The radius of a corridor for one leg.
    Corridor(f64),
}

/// The detours of one kind.
#[derive(Debug, Clone, PartialEq)]
pub struct Detour {
    pub kind: DetourKind,
    /// The leg with the largest one, an index into [`Mission::legs`].
    pub leg: usize,
    /// All legs that have one, ascending.
    pub legs: Vec<usize>,
    /// How far the plan climbs above the waypoints of that leg, or strays from its line, m.
    pub by: f64,
    /// When, s.
    pub at: f64,
    /// What forbids it on that leg.
    pub forbids: Forbids,
    /// The mission time of a plan that keeps the statements against all detours, s; `None` if none was found or
    /// searched for.
    pub tried: Option<f64>,
    /// Whether that plan leaves a mode's set in which the plan with the detours stays.
    pub covers_less: bool,
}

/// How far a plan may climb above the higher waypoint of a leg, m.
fn usual_climb(mission: &Mission, leg: usize) -> f64 {
    mission.waypoints[leg..=leg + 1].iter().map(|w| w.within).fold(USUAL, f64::max)
}

/// How far a plan may stray from the straight line of a leg, m.
fn usual_deviation(mission: &Mission, leg: usize) -> f64 {
    let [from, to] = [leg, leg + 1].map(|waypoint| mission.waypoints[waypoint].position);
    usual_climb(mission, leg).max(SHARE * distance(from, to))
}

fn rounded_down(value: f64) -> f64 {
    (TENTHS * value + 1e-9).floor() / TENTHS
}

/// The greatest height that forbids a climb on a leg, m.
fn height_of(mission: &Mission, leg: usize) -> f64 {
    let highest = mission.waypoints[leg..=leg + 1].iter().map(|w| w.position[2]).fold(f64::NEG_INFINITY, f64::max);
    rounded_down(highest + usual_climb(mission, leg)).max(highest)
}

fn radius_of(mission: &Mission, leg: usize) -> f64 {
    rounded_down(usual_deviation(mission, leg))
}

/// Whether clauses can be written about a leg: the waypoints of a curve share their place in the text, and those of a
/// table are in another file.
fn takes_clauses(mission: &Mission, leg: usize) -> bool {
    let to = &mission.waypoints[leg + 1];
    let shared = mission.waypoints.iter().filter(|w| w.span == to.span).count();
    shared == 1 && to.span.file == mission.span.file
}

/// Whether a leg has a limit of this kind of its own.
fn has_own(mission: &Mission, leg: usize, is_of_kind: impl Fn(&Limit) -> bool) -> bool {
    let is_of_leg = |limit: &Limit| limit.leg.as_ref().is_some_and(|on| on.leg == leg);
    mission.limits.iter().any(|limit| is_of_leg(limit) && is_of_kind(limit))
}

/// The detours of a plan, none of which is tried. Left out are legs that a volume obstructs, that have a corridor or a
/// direction of arrival, or whose height the spec bounds for the leg alone. A leg that strays only because it climbs is
/// not among those that stray.
pub fn detours(problem: Problem, solved: &MissionPlan) -> Vec<Detour> {
    let mission = problem.mission();
    let shape = Shape::of(&solved.trajectory, mission);
    let is_shaped = |limit: &Limit| limit.volume.is_some() || limit.kind.is_arrival();
    let is_free = |&leg: &usize| {
        shape.legs[leg].length > SAME_PLACE
            && !has_own(mission, leg, is_shaped)
            && passage::is_open(&mission.limits, &mission.waypoints[leg..=leg + 1])
    };
    let free: Vec<usize> = (0..shape.legs.len()).filter(is_free).collect();
    let climb = |leg: usize| shape.legs[leg].climb.value;
    let bounds_height = |limit: &Limit| limit.kind == LimitKind::Z && limit.upper.is_some();
    let climbs = |leg: usize| climb(leg) > usual_climb(mission, leg) + SLACK && !has_own(mission, leg, bounds_height);
    let mut climbing: Vec<usize> = free.iter().copied().filter(|&leg| climbs(leg)).collect();
    let highest = mission.waypoints.iter().map(|w| w.position[2]).fold(f64::NEG_INFINITY, f64::max);
    let height = climbing.iter().map(|&leg| height_of(mission, leg)).fold(f64::INFINITY, f64::min);
    let is_general = height >= highest + HEADROOM;
    if !is_general {
        climbing.retain(|&leg| takes_clauses(mission, leg));
    }
    let strays = |leg: usize| {
        let of_leg = &shape.legs[leg];
        let apart = if climbing.contains(&leg) { of_leg.aside } else { of_leg.deviation };
        apart.value > usual_deviation(mission, leg) + SLACK && takes_clauses(mission, leg)
    };
    let straying: Vec<usize> = free.iter().copied().filter(|&leg| strays(leg)).collect();
    let worst =
        |legs: &[usize], by: &dyn Fn(usize) -> f64| legs.iter().rev().copied().max_by(|&a, &b| by(a).total_cmp(&by(b)));
    let climbing = worst(&climbing, &climb).map(|leg| Detour {
        kind: DetourKind::Climb,
        leg,
        by: climb(leg),
        at: shape.legs[leg].climb.at,
        forbids: if is_general { Forbids::Altitude(height) } else { Forbids::AltitudeOfLeg(height_of(mission, leg)) },
        legs: climbing,
        tried: None,
        covers_less: false,
    });
    let straying = worst(&straying, &|leg| shape.legs[leg].deviation.value).map(|leg| Detour {
        kind: DetourKind::Deviation,
        leg,
        by: shape.legs[leg].deviation.value,
        at: shape.legs[leg].deviation.at,
        forbids: Forbids::Corridor(radius_of(mission, leg)),
        legs: straying,
        tried: None,
        covers_less: false,
    });
    climbing.into_iter().chain(straying).collect()
}

/// Whether one quick search is cheap: in the exact model, for a mission and a vehicle that are not large.
pub fn is_cheap(problem: Problem) -> bool {
    let (model, mission) = (problem.model(), problem.mission());
    model.plan.model == PlanModel::Exact
        && model.plan.require_risk.is_none()
        && mission.waypoints.len() <= MOST_WAYPOINTS
        && model.vehicle.rotors.len() <= MOST_ROTORS
}

/// Plans with the statements that forbid all detours, once, by a quick search from the plan of a comparison's run
/// whatever the spec's effort, and records the time of the plan if there is one. A plan that keeps more statements is
/// one of the mission too: if it is shorter, and the mission's time is searched for, it is returned, checked for the
/// mission as it is written. It is not if it is hardly shorter and leaves a mode's set in which the run's plan stays.
pub fn try_statements(
    problem: Problem,
    comparison: &Comparison,
    run: &PlannerRun,
    detours: &mut [Detour],
) -> (Option<Comparison>, Effort) {
    let Some(solved) = run.outcome.plan() else { return (None, Effort::default()) };
    let mut other = problem.model().clone();
    other.plan.effort = SearchEffort::Quick;
    if let Some(mission) = &mut other.mission {
        let limits: Vec<Limit> = detours.iter().flat_map(|detour| limits(problem.mission(), detour)).collect();
        mission.limits.extend(limits);
    }
    let Some(other) = Problem::of(&other) else { return (None, Effort::default()) };
    let mut found = studies::again(other, comparison, run);
    certify::check(other, &mut found);
    // A search that was ended early says little about the price.
    let plan = found.runs.last().and_then(|run| run.outcome.plan()).filter(|_| !cancel::is_enough());
    let time = plan.map(|plan| plan.time);

    let is_searched = problem.model().plan.time == MissionTime::Minimum;
    let leaves = |plan: &MissionPlan| {
        let mut pairs = plan.outside.iter().zip(&solved.outside);
        pairs.any(|(new, old)| new.last.is_some() && old.last.is_none())
    };
    let covers_less = plan.is_some_and(leaves);
    let least_gain = if covers_less { hardly_shorter(solved.time) } else { 0.0 };
    detours.iter_mut().for_each(|detour| (detour.tried, detour.covers_less) = (time, covers_less));
    let is_shorter = is_searched && time.is_some_and(|time| time < solved.time - least_gain);
    if is_shorter {
        studies::pass_again(other, &mut found);
    }
    let effort = found.effort;
    if let (true, Some(PlanOutcome::Planned(plan))) = (is_shorter, found.runs.last_mut().map(|run| &mut run.outcome)) {
        // What was proved of the mission with the statements is not proved of the mission without them.
        plan.infeasible_at = solved.infeasible_at.filter(|&below| below < plan.time);
        plan.infeasible_above = Vec::new();
        // It counts limits of the mission with the statements.
        plan.binding = Vec::new();
        certify::check(problem, &mut found);
        return (Some(found).filter(|found| found.runs.iter().all(|run| run.outcome.plan().is_some())), effort);
    }
    (None, effort)
}

/// The limits that the statements against a detour impose, one statement for each leg or one for all.
fn limits(mission: &Mission, detour: &Detour) -> Vec<Limit> {
    let below = |upper: f64, leg: Option<usize>| Limit {
        kind: LimitKind::Z,
        lower: None,
        upper: Some(upper),
        span: mission.span,
        volume: None,
        leg: leg.map(|leg| Arc::new(OnLeg { leg, part: Part::Whole, name: "z".into() })),
    };
    let legs = detour.legs.iter().copied();
    match detour.forbids {
        Forbids::Altitude(height) => vec![below(height, None)],
        Forbids::AltitudeOfLeg(_) => legs.map(|leg| below(height_of(mission, leg), Some(leg))).collect(),
        Forbids::Corridor(_) => {
            let corridor = |leg: usize| {
                let ends = [&mission.waypoints[leg], &mission.waypoints[leg + 1]];
                corridor::limits(ends, leg, radius_of(mission, leg), "corridor", mission.waypoints[leg + 1].span)
            };
            legs.flat_map(corridor).collect()
        }
    }
}
