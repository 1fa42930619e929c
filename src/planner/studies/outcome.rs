//! What comes of planners side by side.

use crate::admissible::row::SetRow;
use crate::model::{Mission, Model, PlanModel, PlannerKind};
use crate::motion::Trajectory;
use crate::motion::outside::Outside;
use crate::planner::hover::Planned;
use crate::planner::scp::sensitivity::LegBinding;
use crate::planner::selection::PlanningSet;
use crate::planner::studies::protect::Addition;
use crate::solve::Effort;
use crate::verdict::Verdict;

/// Each planner at its own shortest time, or all at one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Run {
    Own,
    Common,
}

/// What a planner's run ended in.
#[derive(Debug, Clone)]
pub enum RunOutcome {
    Solved(Box<Solved>),
    /// Proved, at each of these mission times by itself; nothing is claimed of others.
    Infeasible {
        /// The longest, s.
        at: f64,
        /// All of them, s, ascending.
        proved: Vec<f64>,
    },
    /// No plan was found, and at some time tried none was proved infeasible.
    Inconclusive {
        at: f64,
        status: String,
    },
    /// A motion was found that fails the check of finished plans ([`crate::certify::check`]).
    Failed {
        at: f64,
        why: String,
    },
    /// No plan was searched for: what the search begins with is missing.
    NotAttempted {
        /// Where it would have been searched for, s.
        at: f64,
        /// A clause for people.
        why: String,
    },
}

impl RunOutcome {
    pub fn verdict(&self) -> Verdict {
        match self {
            RunOutcome::Solved(_) => Verdict::Found,
            RunOutcome::Infeasible { .. } => Verdict::ProvedInfeasible,
            RunOutcome::Inconclusive { .. } | RunOutcome::Failed { .. } => Verdict::NotFound,
            RunOutcome::NotAttempted { .. } => Verdict::NotAttempted,
        }
    }

    /// The plan, where there is one.
    pub fn solved(&self) -> Option<&Solved> {
        match self {
            RunOutcome::Solved(solved) => Some(solved),
            _ => None,
        }
    }

    /// A proof that is not about all that the spec leaves open is none, unless there is one for its longest time by itself.
    pub(super) fn weaken(&mut self, about: &'static str, is_hopeless: impl Fn(f64) -> bool) {
        if let RunOutcome::Solved(solved) = self
            && about == THESE_TIMES
        {
            solved.infeasible_at = solved.infeasible_at.filter(|&at| is_hopeless(at));
            solved.infeasible_above.retain(|&at| is_hopeless(at));
        }
        if let RunOutcome::Infeasible { at, .. } = *self
            && !is_hopeless(at)
        {
            *self = RunOutcome::Inconclusive { at, status: about.into() };
        }
    }

    /// `times` in s, in any order; proved for each of them.
    pub(super) fn proved_infeasible(times: &[f64]) -> Self {
        let mut proved = times.to_vec();
        proved.sort_by(f64::total_cmp);
        proved.dedup();
        RunOutcome::Infeasible { at: proved.last().copied().unwrap_or(0.0), proved }
    }
}

/// What a proof is about where it is not about the spec: times of waypoints that were chosen, or a yaw that was planned before
/// the rest.
pub const THESE_TIMES: &str = "with the waypoint times that were tried";
pub const THIS_YAW: &str = "with the yaw that is planned first";

/// The part of the spec's freedom that a proof of no plan is confined to, if there is one.
pub fn proofs_are_about(model: &Model, mission: &Mission) -> Option<&'static str> {
    match model.plan.model {
        PlanModel::Hover if model.plan.chooses_times && mission.legs.len() > 1 => Some(THESE_TIMES),
        PlanModel::Hover if !mission.has_one_yaw() => Some(THIS_YAW),
        _ => None,
    }
}

/// A plan with what is reported of it.
#[derive(Debug, Clone)]
pub struct Solved {
    pub time: f64,
    pub trajectory: Trajectory,
    /// Value of (48).
    pub objective: f64,
    /// Rows in the last program (facets and limits, each at one node).
    pub rows: usize,
    /// Against every mode of the comparison, in their order.
    pub outside: Vec<Outside>,
    /// How long the mission is committed to each of them, s, by what it does after a fault
    /// ([`crate::model::Model::after_fault`]). Empty under [`Scope::Common`] and for rounds, which weigh no risk.
    pub committed: Vec<f64>,
    /// What the check of plans said of it ([`crate::certify::check`]).
    pub verification: Verification,
    /// What limits the time of each leg, in the order of flight: of `mavc plan` with a time that is searched for.
    pub binding: Vec<LegBinding>,
    /// For an own shortest time: the shorter time shown infeasible.
    pub infeasible_at: Option<f64>,
    /// Longer times that were tried and found infeasible.
    pub infeasible_above: Vec<f64>,
}

/// What the check of a finished plan found. One that fails is not kept as a plan.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum Verification {
    /// Not made: plans within a search.
    #[default]
    None,
    /// Every row of the spec holds at the nodes.
    Passed,
    /// Something could not be decided, and why.
    Undecided(String),
}

impl Solved {
    /// The smallest margin to any mode's set, in widths of the healthy set; `None` without modes.
    pub fn smallest_margin(&self) -> Option<f64> {
        self.outside.iter().map(|o| -o.max_violation).min_by(f64::total_cmp)
    }
}

#[derive(Debug, Clone)]
pub struct PlannerRun {
    pub planner: PlannerKind,
    /// Mode names; empty for RIP.
    pub against: Vec<String>,
    pub run: Run,
    pub ending: RunOutcome,
    /// What is imposed on the wrench at each node.
    pub set: PlanningSet,
}

/// All runs of one spec.
#[derive(Debug, Clone)]
pub struct Comparison {
    /// Names of the modes the plan must stand, in the order of `against`.
    pub modes: Vec<String>,
    pub runs: Vec<PlannerRun>,
    /// T_d, s: the spec's time, else the joint RCP's shortest, else the largest single-mode one.
    pub common_time: Option<f64>,
    /// Each mode's set alone, in the order of `modes`.
    pub sets: Vec<PlanningSet>,
    /// Facets (of `against` modes) that RSP selects at T_d, as rows: those the RIP plan violates, and with more rounds those
    /// that the plans of the rounds before violate.
    pub selected: Vec<SetRow>,
    /// The plans at T_d that RSP selects them by: the RIP plan, then one for each further round.
    pub selected_by: Vec<Trajectory>,
    /// Where the spec requires a risk: the plan without protection, then what each addition gives.
    pub trade_off: Vec<Addition>,
    /// The plans of RIP and of the tightest RCP at their own shortest times, where they were sought: what further plans can
    /// be begun from.
    pub known: Vec<Planned>,
    pub effort: Effort,
}

/// Which runs are wanted.
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
