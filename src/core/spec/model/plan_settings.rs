//! How the mission is planned: the settings of the `plan` block.

use super::{AfterFault, GiveUpYaw, RecoverySettings};
use crate::language::table::plan as table;
use crate::source::Span;

/// The most rounds of facet selection.
pub const MAX_ROUNDS: usize = table::ROUNDS.whole().1 as usize;

/// The most intervals of one plan, so that planning takes less than 500 MB (docs/performance.md has the figures).
pub const MAX_SAMPLES: usize = table::SAMPLES.whole().1 as usize;

/// The most intervals where many plans are computed, to search for times or to compare planners, so that this takes
/// minutes: a search that plans a hundred times with 3,000 intervals had not finished after 500 s.
pub const MAX_SAMPLES_OF_A_SEARCH: usize = 1_000;

/// The most waypoints that one mission may have.
pub const MAX_WAYPOINTS: usize = crate::language::table::curve_head::POINTS.whole().1 as usize;

/// Which sets the plan must stay in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlannerKind {
    /// Risk-insensitive: the set of the healthy vehicle.
    Rip,
    /// Risk-conservative: the intersection of the sets of all modes.
    Rcp,
    /// Risk-sensitive: the healthy set and those facets of the modes' sets that the RIP plan violates.
    Rsp,
}

impl PlannerKind {
    /// The word of the language.
    pub fn name(self) -> &'static str {
        match self {
            PlannerKind::Rip => "rip",
            PlannerKind::Rcp => "rcp",
            PlannerKind::Rsp => "rsp",
        }
    }

    /// What the first two letters of the name stand for, as in the paper.
    pub fn in_full(self) -> &'static str {
        match self {
            PlannerKind::Rip => "risk-insensitive",
            PlannerKind::Rcp => "risk-conservative",
            PlannerKind::Rsp => "risk-sensitive",
        }
    }
}

/// How a plan computes the wrench that a motion requires.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlanModel {
    /// The paper's model, linearised about hover.
    Hover,
    /// Exactly, by differential flatness.
    Exact,
}

impl PlanModel {
    /// The word of the language.
    pub fn name(self) -> &'static str {
        match self {
            PlanModel::Hover => "hover",
            PlanModel::Exact => "exact",
        }
    }
}

/// How the rotors follow their commands in a plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlanRotors {
    /// At once: any admissible wrench can follow any other.
    Instant,
    /// With the first-order lag [`super::Model::thrust_lag`].
    Lagging,
}

impl PlanRotors {
    /// The word of the language.
    pub fn name(self) -> &'static str {
        match self {
            PlanRotors::Instant => "instant",
            PlanRotors::Lagging => "lagging",
        }
    }
}

/// How much work a search for a plan in the exact model may take.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SearchEffort {
    Quick,
    Normal,
    Thorough,
}

impl SearchEffort {
    /// The word of the language.
    pub const fn name(self) -> &'static str {
        match self {
            SearchEffort::Quick => "quick",
            SearchEffort::Normal => "normal",
            SearchEffort::Thorough => "thorough",
        }
    }
}

/// The time of the whole mission, including holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MissionTime {
    /// The shortest that the planner finds.
    Minimum,
    /// Fixed, s.
    Fixed(f64),
}

/// `require capture_height`: a height above the mission's ground that a plan keeps outside a radius about start and
/// end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CaptureHeight {
    /// Horizontal distance from start and end within which the height is not required, m; positive.
    pub radius: f64,
    /// Delay after which a fault is known, s.
    pub delay: f64,
    /// The height that the limits of the mission keep, m above the ground; `None` before it is simulated
    /// ([`super::Model::keeping`]).
    pub height: Option<f64>,
    /// The place of the statement, without its braces.
    pub span: Span,
}

/// The `plan` block, or its defaults.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanSettings {
    pub planner: PlannerKind,
    pub model: PlanModel,
    pub rotors: PlanRotors,
    /// Whether the planner chooses the times of waypoints, except fixed ones.
    pub chooses_times: bool,
    /// The modes to tolerate, as indices into [`super::Model::modes`], in the order written, without repetitions.
    pub against: Vec<usize>,
    pub time: MissionTime,
    pub effort: SearchEffort,
    /// Number of intervals of the whole mission.
    pub samples: usize,
    /// Share of each set kept for feedback, 0 <= reserve < 1.
    pub reserve: f64,
    /// Weight of the integral of x''''^2 + y''''^2, s^7/m^2.
    pub snap_weight: f64,
    /// Weight of the integral of z''^2 (s^3/m^2) + psi''^2 (s^3/rad^2).
    pub acceleration_weight: f64,
    /// The place of the `plan` block, or of the mission where there is none; other places fall back to it.
    pub span: Span,
    pub against_span: Span,
    pub time_span: Span,
    pub samples_span: Span,
    pub reserve_span: Span,
    pub rotors_span: Span,
    /// How often RSP selects facets, at one mission time (step (e)): 0 is RIP, 1 the paper's RSP.
    pub rounds: usize,
    /// The largest risk that the plan may have, a probability; the planner then chooses what to protect.
    pub require_risk: Option<f64>,
    pub require_capture: Option<CaptureHeight>,
    /// How ways out after a fault are sought.
    pub recovery: RecoverySettings,
    /// The reaction to a fault that the risk assumes: [`AfterFault::Continue`] or [`AfterFault::Hold`]. A mode may have
    /// its own: see [`super::Model::after_fault`].
    pub after_fault: AfterFault,
    /// Whether flights give up yaw once a fault is known. A mode may have its own: see [`super::Model::gives_up_yaw`].
    pub without_yaw: GiveUpYaw,
    /// The place of the `require` statement, or of the plan where there is none.
    pub require_span: Span,
}
