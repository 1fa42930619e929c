//! Stops after a fault: motions from a plan's state to rest, inside the admissible set of the fault mode and within the
//! mission's limits.
//!
//! A stop ends level, without velocity and body rates, at any place: from there the vehicle hovers. Its duration is
//! free, so several are tried.

use crate::admissible::AdmissibleSet;
use crate::model::{HeldLimit, Problem};
use crate::motion::wrench_model::WrenchModel;
use crate::motion::{NodeState, X, Y, Z};
use crate::planner::branch::{Branches, Goal, Room};
use crate::planner::scp::settings::StopSettings;
use crate::planner::scp::{Iterate, ScpSettings};
use crate::planner::selection::PlanningSet;
use crate::solve::Effort;

/// Ratio of consecutive durations tried. It, [`TRIES`] and [`MIDDLE`] stay constants: the compiler may compute their
/// powers, and those of a setting could differ in the last bit. Chosen by hand.
const LONGER: f64 = 1.6;
/// How many durations are tried. Chosen by hand.
const TRIES: i32 = 9;
/// The index of the duration tried first, while no stop is known. Chosen by hand.
const MIDDLE: i32 = 3;

/// Looks for stops along one plan, after one fault.
pub struct Stops<'a> {
    branches: Branches<'a>,
    gravity: f64,
    /// The last stop found, the first initial guess for the next.
    last: Option<Iterate>,
}

impl<'a> Stops<'a> {
    /// `set` is the admissible set of the fault mode, `wrench` the model that the plan was made with. The limits of the
    /// mission hold for stops too, except those of single legs, because a stop may leave its leg.
    pub fn new(problem: Problem<'a>, healthy: &'a AdmissibleSet, set: &'a PlanningSet, wrench: WrenchModel) -> Self {
        let general = problem.mission().limits.iter().filter(|limit| limit.is_general());
        let limits = general.map(|limit| HeldLimit { limit: limit.clone(), yields: 0.0 }).collect();
        let branches = Branches::new(problem, healthy, set, Room { of_set: 0.0, ..Room::LITTLE }, wrench, limits);
        Stops { branches, gravity: problem.model().gravity, last: None }
    }

    /// The solver's effort.
    pub fn effort(&self) -> Effort {
        self.branches.effort
    }

    /// A stop from the state of a plan in which the fault strikes; `None` if none is found at any of the durations
    /// tried.
    pub fn find(&mut self, struck: &NodeState) -> Option<Iterate> {
        let near = self.last.as_ref().map(|last| last.grid.total);
        let about = self.last.as_ref().and_then(|last| self.branches.find_about(struck, &Goal::Rest, last));
        self.last = about.or_else(|| {
            let tried = durations(struck, self.gravity, near, &ScpSettings::DEFAULT.stops);
            tried.into_iter().find_map(|duration| self.branches.find(struck, &Goal::Rest, duration))
        });
        self.last.clone()
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
