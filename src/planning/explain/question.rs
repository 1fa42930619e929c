//! Queries to the oracle: variants of one spec, the mission time of each query, and their largest number.

use super::oracle::{Answer, Oracle};
use super::statement::Statement;
use crate::model::{LimitKind, Mission, MissionTime, Model, PlanModel, PlannerKind, Problem, SearchEffort};
use crate::motion::time_grid::{determined, earliest};
use crate::planner::scp::ScpSettings;
use std::collections::{BTreeMap, BTreeSet};

/// A time is long for a mission if the legs after the last fixed time have this many times the time given by
/// [`unhurried`]. (Not many more: otherwise few samples would remain for the other legs.) Chosen by hand.
const LONG: f64 = 4.0;

/// A long time is at least this many times the time that the spec gives these legs. Chosen by hand.
const LONGER: f64 = 1.5;

/// The most of the solver's work for a conflict, and for changes: half as much as a search with `effort = normal`.
/// Chosen by hand.
const MOST_WORK: u64 = ScpSettings::DEFAULT.budget.normal as u64 / 2;

/// The longest mission time of a query, s. Chosen by hand.
const LONGEST: f64 = 100_000.0;

pub(super) struct Questions<'a> {
    pub problem: Problem<'a>,
    oracle: &'a mut dyn Oracle,
    /// Answers by the statements left out.
    answers: BTreeMap<BTreeSet<Statement>, Answer>,
    asked: usize,
    most: usize,
    /// No query begins beyond this much of the solver's work.
    most_work: u64,
}

impl<'a> Questions<'a> {
    pub fn new(problem: Problem<'a>, oracle: &'a mut dyn Oracle, most: usize) -> Self {
        let most_work = oracle.work() + MOST_WORK;
        Questions { problem, oracle, answers: BTreeMap::new(), asked: 0, most, most_work }
    }

    pub fn asked(&self) -> usize {
        self.asked
    }

    /// Allows this many more queries from here on.
    pub fn allow(&mut self, more: usize) {
        self.most = self.asked + more;
        self.most_work = self.oracle.work() + MOST_WORK;
    }

    /// A mission time that is long for a variant of the mission, s. It depends on the variant's fixed times and holds
    /// and on all limits of the spec, so that variants with the same times and holds are queried at the same mission
    /// time.
    fn long_for(&self, variant: &Mission) -> f64 {
        let fixed = match self.problem.model().plan.time {
            MissionTime::Fixed(time) => time,
            MissionTime::Minimum => 0.0,
        };
        let earliest = earliest(variant);
        let last_fixed = variant.waypoints.iter().rposition(|w| w.time.is_some()).unwrap_or(0);
        let unhurried = unhurried(self.problem.mission(), last_fixed, self.problem.model().gravity);
        (earliest + (LONG * unhurried).max(LONGER * (fixed - earliest))).ceil().min(LONGEST)
    }

    /// A mission time that is long for the mission with and without its fixed times, s.
    pub fn long(&self) -> f64 {
        let mut free = self.problem.mission().clone();
        free.waypoints.iter_mut().for_each(|w| w.time = None);
        self.long_for(&free).max(self.long_for(self.problem.mission()))
    }

    /// The mission time of the query for a variant, s, and whether the variant leaves it free.
    pub fn time_of(&self, problem: Problem) -> (f64, bool) {
        let (model, mission) = (problem.model(), problem.mission());
        match (determined(mission), model.plan.time) {
            (Some(time), _) | (None, MissionTime::Fixed(time)) => (time, false),
            (None, MissionTime::Minimum) => (self.long_for(mission), true),
        }
    }

    /// The spec with some statements left out, for quick searches.
    pub fn variant(&self, left_out: &BTreeSet<Statement>) -> Model {
        let mut model = self.problem.model().clone();
        model.plan.effort = SearchEffort::Quick;
        left_out.iter().for_each(|s| s.leave_out(&mut model));
        model
    }

    /// The oracle's answer for the spec with some statements left out; `None` if there were too many queries.
    pub fn without(&mut self, left_out: &BTreeSet<Statement>) -> Option<Answer> {
        if let Some(answer) = self.answers.get(left_out) {
            return Some(answer.clone());
        }
        let answer = match self.implied(left_out) {
            Some(answer) => answer,
            None => {
                let model = self.variant(left_out);
                self.ask(Problem::of(&model)?)?
            }
        };
        self.answers.insert(left_out.clone(), answer.clone());
        Some(answer)
    }

    /// The answer implied by earlier answers: a plan remains one if statements are left out, and infeasibility remains
    /// if statements are added. This holds only between variants with the same waypoint times: leaving out a fixed time
    /// or a hold moves waypoints. Nothing is implied if other things move too: facets that follow from a plan (RSP),
    /// and yaw that is planned before the rest.
    fn implied(&self, left_out: &BTreeSet<Statement>) -> Option<Answer> {
        let moves = self.problem.model().plan.model == PlanModel::Hover && !self.problem.mission().has_one_yaw();
        if moves || self.problem.model().plan.planner == PlannerKind::Rsp {
            return None;
        }
        let same_times = |a: &BTreeSet<Statement>, b: &BTreeSet<Statement>| {
            a.symmetric_difference(b).all(|s| s.has_rows() || *s == Statement::Reserve)
        };
        let implies = |(other, answer): &(&BTreeSet<Statement>, &Answer)| {
            same_times(other, left_out)
                && match answer {
                    Answer::Feasible => other.is_subset(left_out),
                    Answer::Infeasible { .. } => other.is_superset(left_out),
                    Answer::NotFound(_) => false,
                }
        };
        self.answers.iter().find(implies).map(|(_, answer)| answer.clone())
    }

    /// The oracle's answer for any variant; `None` if there were too many queries, or too much work in them.
    pub fn ask(&mut self, problem: Problem) -> Option<Answer> {
        if self.asked >= self.most || self.oracle.work() > self.most_work {
            return None;
        }
        self.asked += 1;
        let (time, free) = self.time_of(problem);
        // RSP selects its facets at a shortest time of RCP, and if RCP has a plan, RSP has one.
        let is_rsp = problem.model().plan.planner == PlannerKind::Rsp;
        if !(free && is_rsp && self.problem.model().plan.time == MissionTime::Minimum) {
            return Some(self.oracle.ask(problem, time));
        }
        match self.ask_of(PlannerKind::Rcp, problem, time)? {
            // RCP's sets are smaller, so this proves nothing about RSP; but RIP's sets are larger, so a proof for RIP
            // is a proof for RSP.
            Answer::Infeasible { weights, .. } => {
                self.asked += 1;
                match self.ask_of(PlannerKind::Rip, problem, time)? {
                    proof @ Answer::Infeasible { .. } => Some(proof),
                    _ => Some(Answer::NotFound(weights)),
                }
            }
            answer => Some(answer),
        }
    }

    /// The oracle's answer for a variant with another planner than the spec's.
    fn ask_of(&mut self, planner: PlannerKind, problem: Problem, time: f64) -> Option<Answer> {
        let mut model = problem.model().clone();
        model.plan.planner = planner;
        Some(self.oracle.ask(Problem::of(&model)?, time))
    }
}

/// A measure of a long flight time, s: the sum, over the legs from a waypoint on, of the time from rest to rest at half
/// of g and of the times under each limit alone.
fn unhurried(mission: &Mission, from: usize, gravity: f64) -> f64 {
    let leg = |pair: &[crate::model::Waypoint]| {
        let apart: [f64; 3] = std::array::from_fn(|i| (pair[1].position[i] - pair[0].position[i]).abs());
        let length = apart.iter().map(|d| d * d).sum::<f64>().sqrt();
        let turned = pair[1].yaw - pair[0].yaw;
        let turn = turned.abs();
        let accelerated = |way: f64, most: f64| 2.0 * (way / most).sqrt();
        let limited = mission.limits.iter().filter_map(|limit| {
            let (upper, lower) = (limit.upper, limit.lower.map(|lower| -lower));
            let most = match limit.kind {
                LimitKind::YawRate if turned < 0.0 => lower,
                // A turn begins with an acceleration to one side and ends with one to the other.
                LimitKind::YawAcceleration => upper.into_iter().chain(lower).reduce(f64::min),
                _ => upper,
            };
            let most = most.filter(|most| *most > 0.0)?;
            Some(match limit.kind {
                LimitKind::X | LimitKind::Y | LimitKind::Z | LimitKind::Yaw => 0.0,
                LimitKind::Face(_) | LimitKind::Distance(_) | LimitKind::Clearance(_) => 0.0,
                LimitKind::Arrival(_) | LimitKind::Heading(_) => 0.0,
                LimitKind::Speed | LimitKind::SpeedHorizontal => length / most,
                LimitKind::Climb | LimitKind::Descent => apart[2] / most,
                LimitKind::Acceleration | LimitKind::AccelerationHorizontal => accelerated(length, most),
                LimitKind::Tilt => accelerated(length, gravity * most.tan()),
                LimitKind::Jerk => (32.0 * length / most).cbrt(),
                LimitKind::YawRate => turn / most,
                LimitKind::YawAcceleration => accelerated(turn, most),
            })
        });
        accelerated(length, 0.5 * gravity) + turn + limited.sum::<f64>()
    };
    mission.waypoints[from..].windows(2).map(leg).sum::<f64>().max(1.0)
}
