//! Stops after a fault: motions from a plan's state to rest, inside the admissible set of the fault mode and within the mission's
//! limits.
//!
//! When a fault strikes, position, velocity, attitude, body rates, yaw and its rate do not change; thrust and torques may jump.
//! A stop ends level, without velocity and body rates, at any place: from there the vehicle hovers. Its duration is free, so
//! several are tried. A stop that is found is checked by plain evaluation; if none is found, one may still exist.

mod ends;

use crate::admissible::AdmissibleSet;
use crate::model::grid::Spacing;
use crate::model::{Leg, Limit, Mission, Model, Waypoint};
use crate::motion::time_grid::{LegGrid, TimeGrid};
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, X, Y, YAW, Z};
use crate::planner::hover::HoverPlanner;
use crate::planner::limits::place;
use crate::planner::scp::{Iterate, ScpPlanner};
use crate::planner::selection::PlanningSet;
use crate::planner::transcription::UNBOUNDED;
use crate::solve::Effort;

/// A stop is divided into parts of these shares of its duration, each with this many intervals. Body rates are stopped at its
/// beginning and the vehicle is levelled at its end, which needs shorter steps than braking in between.
const SHARES: [f64; 5] = [1.0, 2.0, 3.0, 2.0, 1.0];
const INTERVALS: usize = 5;

/// The shortest duration tried, s, unless braking with 2 g takes longer.
const SHORTEST: f64 = 0.4;
/// Ratio of consecutive durations tried.
const LONGER: f64 = 1.6;
/// How many durations are tried.
const TRIES: i32 = 9;
/// The index of the duration tried first, while no stop is known.
const MIDDLE: i32 = 3;

/// Limits are widened by this share of themselves, places by this much (m or rad): a plan holds them to tolerances only, and a fault
/// may strike at a limit.
const LEEWAY: f64 = 1e-4;

/// Looks for stops along one plan, after one fault.
pub struct Stops<'a> {
    model: &'a Model,
    /// The plan's mission, whose limits hold for stops too.
    mission: &'a Mission,
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
    pub fn new(
        model: &'a Model,
        mission: &'a Mission,
        healthy: &'a AdmissibleSet,
        set: &'a PlanningSet,
        wrench: WrenchModel,
    ) -> Self {
        Stops { model, mission, healthy, set, wrench, last: None, effort: Effort::default() }
    }

    /// A stop from the state of a plan in which the fault strikes; `None` if none is found at any of the durations tried.
    pub fn find(&mut self, struck: &NodeState) -> Option<Iterate> {
        let mission = stop_mission(self.mission, struck);
        let mut hover = HoverPlanner::new(self.model, &mission, self.healthy);
        hover.struck = Some(*struck);
        let mut steps = ScpPlanner::new(&mut hover, self.wrench, self.set);
        let near = self.last.as_ref().map(|last| last.grid.total);
        let about = self.last.as_ref().and_then(|last| steps.stop_about(last.clone()));
        let found = about.or_else(|| {
            let mut tried = durations(struck, self.model.gravity, near).into_iter();
            tried.find_map(|duration| steps.stop(&grid(&mission, duration)))
        });
        self.effort += hover.effort;
        self.last = found.clone();
        found
    }
}

/// The durations to try, s, those with the ratio to `near` closest to 1 first.
fn durations(struck: &NodeState, gravity: f64, near: Option<f64>) -> Vec<f64> {
    let speed = [X, Y, Z].map(|axis| struck[axis][1].powi(2)).iter().sum::<f64>().sqrt();
    let shortest = SHORTEST.max(0.5 * speed / gravity);
    let near = near.unwrap_or(shortest * LONGER.powi(MIDDLE));
    let mut all: Vec<f64> = (0..TRIES).map(|i| shortest * LONGER.powi(i)).collect();
    all.sort_by(|a, b| (a / near).ln().abs().total_cmp(&(b / near).ln().abs()));
    all
}

fn grid(mission: &Mission, duration: f64) -> TimeGrid {
    let all: f64 = SHARES.iter().sum();
    let legs = SHARES.map(|share| LegGrid::new(duration * share / all, INTERVALS));
    TimeGrid::with_legs(mission, &legs, duration)
}

/// A stop as a mission, whose waypoints only divide its duration and constrain nothing.
fn stop_mission(flown: &Mission, struck: &NodeState) -> Mission {
    let waypoint = Waypoint {
        name: None,
        position: [struck[X][0], struck[Y][0], struck[Z][0]],
        yaw: struck[YAW][0],
        within: UNBOUNDED,
        yaw_within: UNBOUNDED,
        weight: 0.0,
        time: None,
        hold: 0.0,
        span: flown.span,
        time_span: None,
        hold_span: None,
    };
    Mission {
        waypoints: vec![waypoint; SHARES.len() + 1],
        legs: SHARES.map(|share| Leg { share }).to_vec(),
        spacing: Spacing::Even,
        start_at_rest: false,
        end_at_rest: false,
        limits: flown.limits.iter().map(with_leeway).collect(),
        ..flown.clone()
    }
}

fn with_leeway(limit: &Limit) -> Limit {
    let by = |bound: f64| if place(limit.kind) { LEEWAY } else { LEEWAY * bound.abs() };
    Limit { lower: limit.lower.map(|b| b - by(b)), upper: limit.upper.map(|b| b + by(b)), ..*limit }
}
