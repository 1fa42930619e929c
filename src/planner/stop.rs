//! Whether the vehicle can still come to rest when a fault strikes: motions from a plan's state to rest, inside what the
//! fault leaves and within the mission's limits.
//!
//! A fault leaves position, velocity, attitude, body rates, yaw and its rate as they are; thrust and torques may jump. A
//! stop ends level, without velocity and body rates, wherever it likes: from there the vehicle hovers. How long it takes is
//! free, so some durations are tried; a stop that is found is one, checked by plain evaluation, while one that is not found
//! may exist.

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

/// A stop is cut into parts of these shares, each with so many intervals: rates are caught at its beginning and the
/// vehicle is levelled at its end, which takes shorter steps than to brake in between.
const SHARES: [f64; 5] = [1.0, 2.0, 3.0, 2.0, 1.0];
const INTERVALS: usize = 5;

/// Durations tried: the shortest, s, or what 2 g take to brake if that is longer; by what factor each is longer than the one
/// before; how many; and which is the first where no stop is known yet.
const SHORTEST: f64 = 0.4;
const LONGER: f64 = 1.6;
const TRIES: i32 = 9;
const MIDDLE: i32 = 3;

/// Limits may be passed by this share of themselves, places by this much (m or rad): plans hold them to tolerances, and
/// may be struck at a limit.
const LEEWAY: f64 = 1e-4;

/// Looks for stops along one plan, after one fault.
pub struct Stops<'a> {
    model: &'a Model,
    /// Its limits hold for stops too.
    mission: &'a Mission,
    healthy: &'a AdmissibleSet,
    /// What the fault leaves.
    set: &'a PlanningSet,
    /// Of the plan, and of stops.
    wrench: WrenchModel,
    /// The last stop found: the next is sought about it first.
    last: Option<Iterate>,
    pub effort: Effort,
}

impl<'a> Stops<'a> {
    pub fn new(
        model: &'a Model,
        mission: &'a Mission,
        healthy: &'a AdmissibleSet,
        set: &'a PlanningSet,
        wrench: WrenchModel,
    ) -> Self {
        Stops { model, mission, healthy, set, wrench, last: None, effort: Effort::default() }
    }

    /// A stop from the state of a plan in which the fault strikes; `None` where none of the durations tried has one, or where
    /// the steps of the exact model find none.
    pub fn find(&mut self, struck: &NodeState) -> Option<Iterate> {
        let mission = stop_mission(self.mission, struck);
        let mut engine = HoverPlanner::new(self.model, &mission, self.healthy);
        engine.struck = Some(*struck);
        let mut steps = ScpPlanner::new(&mut engine, self.wrench, self.set);
        let near = self.last.as_ref().map(|last| last.grid.total);
        let about = self.last.as_ref().and_then(|last| steps.stop_about(last.clone()));
        let found = about.or_else(|| {
            let mut tried = durations(struck, self.model.gravity, near).into_iter();
            tried.find_map(|duration| steps.stop(&grid(&mission, duration)))
        });
        self.effort += engine.effort;
        self.last = found.clone();
        found
    }
}

/// Nearest to `near` first, in ratio.
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

/// A stop as a mission: its waypoints only part it, and bind nothing.
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
