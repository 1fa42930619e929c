//! Stops after a fault: motions from a plan's state to rest, inside the admissible set of the fault mode and within the
//! mission's limits.
//!
//! When a fault strikes, position, velocity, attitude, body rates, yaw and its rate do not change; thrust and torques
//! may jump. A stop ends level, without velocity and body rates, at any place: from there the vehicle hovers. Its
//! duration is free, so several are tried. A stop that is found is checked by plain evaluation; if none is found, one
//! may still exist.

mod ends;

use crate::admissible::AdmissibleSet;
use crate::model::grid::Spacing;
use crate::model::{Heading, Leg, Limit, Mission, Problem, Waypoint};
use crate::motion::time_grid::{LegGrid, TimeGrid};
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, X, Y, YAW, Z};
use crate::planner::hover::HoverPlanner;
use crate::planner::limits::place;
use crate::planner::scp::settings::StopSettings;
use crate::planner::scp::{Iterate, ScpPlanner, ScpSettings};
use crate::planner::selection::PlanningSet;
use crate::planner::transcription::UNBOUNDED;
use crate::solve::Effort;

/// Ratio of consecutive durations tried. With [`TRIES`] and [`MIDDLE`] a constant, whose powers the compiler may
/// compute: those of a setting can differ from them in the last bit. Chosen by hand.
const LONGER: f64 = 1.6;
/// How many durations are tried. Chosen by hand.
const TRIES: i32 = 9;
/// The index of the duration tried first, while no stop is known. Chosen by hand.
const MIDDLE: i32 = 3;

/// Limits are widened by this share of themselves, places by this much (m or rad): a plan holds them to tolerances
/// only, and a fault may strike at a limit. Chosen by hand.
const LEEWAY: f64 = 1e-4;

/// Looks for stops along one plan, after one fault.
pub struct Stops<'a> {
    /// The problem of the plan, the limits of whose mission hold for stops too.
    problem: Problem<'a>,
    healthy: &'a AdmissibleSet,
    /// The admissible set of the fault mode.
    set: &'a PlanningSet,
    /// The wrench model of the plan, and of stops.
    wrench: WrenchModel,
    /// The last stop found, the first initial guess for the next.
    last: Option<Iterate>,
    pub effort: Effort,
}

impl<'a> Stops<'a> {
    /// `set` is the admissible set of the fault mode, `wrench` the model that the plan was made with.
    pub fn new(problem: Problem<'a>, healthy: &'a AdmissibleSet, set: &'a PlanningSet, wrench: WrenchModel) -> Self {
        Stops { problem, healthy, set, wrench, last: None, effort: Effort::default() }
    }

    /// A stop from the state of a plan in which the fault strikes; `None` if none is found at any of the durations
    /// tried.
    pub fn find(&mut self, struck: &NodeState) -> Option<Iterate> {
        let settings = ScpSettings::DEFAULT;
        let model = self.problem.with_mission(stop_mission(self.problem.mission(), struck, &settings.stops));
        let problem = Problem::of(&model)?;
        let mut hover = HoverPlanner::new(problem, self.healthy);
        hover.struck = Some(*struck);
        let mut steps = ScpPlanner::with_settings(&mut hover, self.wrench, self.set, settings);
        let near = self.last.as_ref().map(|last| last.grid.total);
        let about = self.last.as_ref().and_then(|last| steps.stop_about(last.clone()));
        let found = about.or_else(|| {
            let mut tried = durations(struck, model.gravity, near, &settings.stops).into_iter();
            tried.find_map(|duration| steps.stop(&grid(problem.mission(), duration, &settings.stops)))
        });
        self.effort += hover.effort;
        self.last = found.clone();
        found
    }
}

/// The durations to try, s, those with the ratio to `near` closest to 1 first.
fn durations(struck: &NodeState, gravity: f64, near: Option<f64>, settings: &StopSettings) -> Vec<f64> {
    let speed = [X, Y, Z].map(|axis| struck[axis][1].powi(2)).iter().sum::<f64>().sqrt();
    let shortest = settings.min_duration.max(0.5 * speed / gravity);
    let near = near.unwrap_or(shortest * LONGER.powi(MIDDLE));
    let mut all: Vec<f64> = (0..TRIES).map(|i| shortest * LONGER.powi(i)).collect();
    all.sort_by(|a, b| (a / near).ln().abs().total_cmp(&(b / near).ln().abs()));
    all
}

fn grid(mission: &Mission, duration: f64, settings: &StopSettings) -> TimeGrid {
    let all: f64 = settings.shares.iter().sum();
    let legs = settings.shares.map(|share| LegGrid::new(duration * share / all, settings.intervals_per_part));
    TimeGrid::with_legs(mission, &legs, duration)
}

/// A stop as a mission, whose waypoints only divide its duration and constrain nothing. The limits of single legs do
/// not hold for it, because a stop may leave its leg.
fn stop_mission(flown: &Mission, struck: &NodeState, settings: &StopSettings) -> Mission {
    let waypoint = Waypoint {
        name: None,
        position: [struck[X][0], struck[Y][0], struck[Z][0]],
        yaw: struck[YAW][0],
        within: UNBOUNDED,
        yaw_within: UNBOUNDED,
        weight: 0.0,
        time: None,
        hold: 0.0,
        stop: false,
        heading: Heading::Given,
        span: flown.span,
        time_span: None,
        hold_span: None,
    };
    Mission {
        waypoints: vec![waypoint; settings.shares.len() + 1],
        legs: settings.shares.map(|share| Leg { share }).to_vec(),
        spacing: Spacing::Even,
        start_at_rest: false,
        end_at_rest: false,
        limits: flown.limits.iter().filter(|limit| limit.is_general()).map(with_leeway).collect(),
        ..flown.clone()
    }
}

fn with_leeway(limit: &Limit) -> Limit {
    let by = |bound: f64| if place(&limit.kind) { LEEWAY } else { LEEWAY * bound.abs() };
    Limit { lower: limit.lower.map(|b| b - by(b)), upper: limit.upper.map(|b| b + by(b)), ..limit.clone() }
}
