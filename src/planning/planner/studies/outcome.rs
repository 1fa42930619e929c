//! The outcomes of planners, alone or side by side.

use crate::admissible::row::SetRow;
use crate::admissible::without_yaw::planned::Provision;
use crate::model::{MissionTime, Model, PlanModel, PlannerKind, Problem};
use crate::motion::Trajectory;
use crate::motion::outside::Outside;
use crate::motion::time_grid::determined;
use crate::number::number;
use crate::planner::Planned;
use crate::planner::scp::sensitivity::LegBinding;
use crate::planner::selection::PlanningSet;
use crate::planner::studies::protect::Addition;
use crate::solve::Effort;
use crate::verdict::Verdict;
use std::fmt;

/// Each planner at its own shortest time, or all at one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Run {
    Own,
    Common,
}

/// The outcome of one planner's search for a plan.
#[derive(Debug, Clone)]
pub enum PlanOutcome {
    /// A plan was found. Before [`crate::certify::check`] it is a trajectory that the planner accepts; then it has
    /// passed the check of finished plans, or the check could not decide ([`Verification`]).
    Planned(Box<MissionPlan>),
    /// Proved: no plan exists at certain mission times.
    Infeasible(Proof),
    /// No plan was found, and nothing was proved.
    NotFound(NotFound),
    /// No plan was searched for, because a plan that the search starts from was not found.
    NotAttempted {
        /// The mission time of the search that was not made, s.
        at: f64,
        /// A clause for people.
        why: String,
    },
}

/// The mission times at which no plan exists, each proved by itself; nothing is claimed about other times.
#[derive(Debug, Clone, PartialEq)]
pub struct Proof {
    /// The longest of them, s.
    pub at: f64,
    /// All of them, s, ascending.
    pub proved: Vec<f64>,
}

/// Why no plan was found, where none was proved infeasible.
#[derive(Debug, Clone, PartialEq)]
pub enum NotFound {
    /// The search ended without a plan, at a mission time of `at` s.
    Search { at: f64, status: String },
    /// The trajectory found at a mission time of `at` s fails the check of finished plans ([`crate::certify::check`]).
    Check { at: f64, why: String },
}

impl fmt::Display for NotFound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotFound::Search { at, status } => write!(f, "search at a mission time of {} s: {status}", number(*at)),
            NotFound::Check { at, why } => {
                write!(f, "the trajectory planned for {} s fails the check of plans: {why}", number(*at))
            }
        }
    }
}

impl PlanOutcome {
    /// The verdict in the words that reports use.
    pub fn verdict(&self) -> Verdict {
        match self {
            PlanOutcome::Planned(_) => Verdict::Found,
            PlanOutcome::Infeasible(Proof { .. }) => Verdict::ProvedInfeasible,
            PlanOutcome::NotFound(NotFound::Search { .. }) | PlanOutcome::NotFound(NotFound::Check { .. }) => {
                Verdict::NotFound
            }
            PlanOutcome::NotAttempted { .. } => Verdict::NotAttempted,
        }
    }

    /// The plan, where there is one.
    pub fn plan(&self) -> Option<&MissionPlan> {
        match self {
            PlanOutcome::Planned(solved) => Some(solved),
            _ => None,
        }
    }

    /// Withdraws a proof that is confined to a part of the spec's freedom, unless its longest time is hopeless in any
    /// case.
    pub(super) fn weaken(&mut self, about: &'static str, is_hopeless: impl Fn(f64) -> bool) {
        if let PlanOutcome::Planned(solved) = self
            && about == THESE_TIMES
        {
            solved.infeasible_at = solved.infeasible_at.filter(|&at| is_hopeless(at));
            solved.infeasible_above.retain(|&at| is_hopeless(at));
        }
        if let PlanOutcome::Infeasible(Proof { at, .. }) = *self
            && !is_hopeless(at)
        {
            *self = PlanOutcome::NotFound(NotFound::Search { at, status: about.into() });
        }
    }

    /// `times` in s, in any order; proved for each of them. Without any nothing is proved.
    pub(super) fn proved_infeasible(times: &[f64]) -> Self {
        let mut proved = times.to_vec();
        proved.sort_by(f64::total_cmp);
        proved.dedup();
        match proved.last() {
            Some(&at) => PlanOutcome::Infeasible(Proof { at, proved }),
            None => PlanOutcome::NotFound(NotFound::Search { at: 0.0, status: "no mission time was tried".into() }),
        }
    }
}

/// A proof that is confined to the waypoint times chosen.
pub const THESE_TIMES: &str = "with the waypoint times that were tried";
/// A proof that is confined to the yaw planned first.
pub const THIS_YAW: &str = "with the yaw that is planned first";

/// The part of the spec's freedom that a proof of no plan is confined to, if there is one.
pub fn proofs_are_about(problem: Problem) -> Option<&'static str> {
    let (model, mission) = (problem.model(), problem.mission());
    match model.plan.model {
        PlanModel::Hover if model.plan.chooses_times && mission.legs.len() > 1 => Some(THESE_TIMES),
        PlanModel::Hover if !mission.has_one_yaw() => Some(THIS_YAW),
        _ => None,
    }
}

/// A plan with what is reported of it.
#[derive(Debug, Clone)]
pub struct MissionPlan {
    pub time: f64,
    pub trajectory: Trajectory,
    /// Value of (48).
    pub objective: f64,
    /// That of the plan before its second pass, which planners are compared by.
    pub least_objective: f64,
    /// Rows in the last program (facets and limits, each at one node).
    pub rows: usize,
    /// Against every mode of the comparison, in their order.
    pub outside: Vec<Outside>,
    /// For a vehicle with an interval of `drag`, for whose middle the plan is made: the largest violation at its lower
    /// and at its upper end, in widths of the healthy set, of the healthy vehicle's set and of the modes' sets that
    /// hold in the middle.
    pub at_ends_of_drag: Option<[f64; 2]>,
    /// How long the mission is committed to each of them, s, by what it does after a fault
    /// ([`crate::model::Model::after_fault`]). Empty under [`Scope::Common`] and for rounds, which compute no risk.
    pub committed: Vec<f64>,
    /// The result of the check of plans ([`crate::certify::check`]).
    pub verification: Verification,
    /// What limits the time of each leg, in the order of flight: only of `mavc plan` with a time that is searched for.
    pub binding: Vec<LegBinding>,
    /// For an own shortest time: the shorter time proved infeasible, s.
    pub infeasible_at: Option<f64>,
    /// Longer times that were tried and proved infeasible, s.
    pub infeasible_above: Vec<f64>,
    /// The planner's own form of the plan, from which a second pass starts.
    pub(super) planned: Option<Box<Planned>>,
}

/// The result of the check of a finished plan. A trajectory that fails it is not kept as a plan.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum Verification {
    /// Not checked: plans within a search.
    #[default]
    None,
    /// Every row of the spec holds at the nodes.
    Passed,
    /// Something could not be decided, and why.
    Undecided(String),
}

impl MissionPlan {
    /// The smallest margin to any mode's set or core, in widths of the healthy set; `None` without modes that have one.
    pub fn smallest_margin(&self) -> Option<f64> {
        self.outside.iter().map(|o| -o.max_violation).filter(|margin| margin.is_finite()).min_by(f64::total_cmp)
    }
}

/// One planner's run: at its own shortest time or at T_d.
#[derive(Debug, Clone)]
pub struct PlannerRun {
    pub planner: PlannerKind,
    /// Mode names; empty for RIP.
    pub against: Vec<String>,
    pub run: Run,
    pub outcome: PlanOutcome,
    /// The set imposed on the wrench at each node.
    pub set: PlanningSet,
    /// The plan before its second pass, until plans are checked.
    pub plainer: Option<Box<MissionPlan>>,
}

impl PlannerRun {
    /// An upper bound on the thrust of the run's plans that a certificate shows, N: infinite with `require risk`,
    /// because a certificate does not contain what the plan protects.
    pub fn most_thrust(&self, model: &Model) -> f64 {
        match model.plan.require_risk {
            Some(_) => f64::INFINITY,
            None => self.set.most_thrust(&model.vehicle),
        }
    }
}

/// All runs of one spec.
#[derive(Debug, Clone)]
pub struct Comparison {
    /// Names of the modes that the plan must tolerate, in the order of `against`.
    pub modes: Vec<String>,
    pub runs: Vec<PlannerRun>,
    /// T_d, s: the spec's time, else the joint RCP's shortest, else the largest single-mode one.
    pub common_time: Option<f64>,
    /// Each mode's set alone, or its core, in the order of `modes`; without rows where there is neither.
    pub sets: Vec<PlanningSet>,
    /// How plans provide for each mode, in the order of `modes`.
    pub provisions: Vec<Provision>,
    /// Facets (of `against` modes) that RSP selects at T_d, as rows: those the RIP plan violates, and with more rounds
    /// those that the plans of the rounds before violate.
    pub selected: Vec<SetRow>,
    /// The plans at T_d that RSP selects them by: the RIP plan, then one for each further round.
    pub selected_by: Vec<Trajectory>,
    /// The plans that RSP selects facets by for its own shortest time, if the spec fixes T_d elsewhere.
    pub own_selected_by: Option<Vec<Trajectory>>,
    /// RIP's run at the time that the spec gives, where `plan` planned it for RSP to select by.
    pub ignoring: Option<Box<PlannerRun>>,
    /// If the spec requires a risk: the plan without protection, then the result of each addition.
    pub trade_off: Vec<Addition>,
    /// Where `plan` sought it for RSP: the shortest time of RCP against all modes jointly, s.
    pub covering_time: Option<f64>,
    /// Whether the plan of the last run was planned again, with more room than its planner asks for.
    pub for_ways_out: bool,
    pub effort: Effort,
}

impl Comparison {
    /// The plans that select the facets of one of the runs; none but for RSP.
    pub fn selected_by(&self, planner: PlannerKind, run: Run) -> &[Trajectory] {
        match (planner, run, &self.own_selected_by) {
            (PlannerKind::Rsp, Run::Own, Some(own)) => own,
            (PlannerKind::Rsp, ..) => &self.selected_by,
            (PlannerKind::Rip | PlannerKind::Rcp, ..) => &[],
        }
    }

    /// Whether there is a plan at the spec's mission time, or at any planner's own time if the spec gives none. A run
    /// that found nothing leaves the question open, whatever the others found.
    pub fn verdict(&self, problem: Problem) -> Verdict {
        let (model, mission) = (problem.model(), problem.mission());
        let is_fixed = determined(mission).is_some() || matches!(model.plan.time, MissionTime::Fixed(_));
        let asked = |run: &&PlannerRun| !is_fixed || run.run == Run::Common;
        let any = |verdict: Verdict| self.runs.iter().filter(asked).any(|run| run.outcome.verdict() == verdict);
        match (any(Verdict::NotFound), any(Verdict::Found), any(Verdict::ProvedInfeasible)) {
            (false, true, _) => Verdict::Found,
            (false, false, true) => Verdict::ProvedInfeasible,
            _ => Verdict::NotFound,
        }
    }
}

/// Which planners are run at which times.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// Only what the spec's planner needs for its one trajectory.
    Plan,
    /// RIP, RCP jointly and RSP at T_d, without their own shortest times: what a campaign flies.
    Common,
    /// RIP, RCP per mode, RCP jointly and RSP, at their own times and at T_d.
    Everything,
}

/// `RCP M1`, `RSP`.
pub fn label(kind: PlannerKind, against: &[String]) -> String {
    let name = kind.name().to_uppercase();
    match (kind, against) {
        (PlannerKind::Rcp, [one]) => format!("{name} {one}"),
        _ => name,
    }
}
