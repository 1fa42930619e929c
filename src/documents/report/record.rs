//! The machine-readable report (`--report`), schema in `docs/schema/report.schema.json`.

use super::battery::{self, BatteryRecord};
use super::binding::{self, BindingRecord};
use super::capture_height::{self, CaptureRecord, ExposedRecord};
use super::caveats::{Caveat, caveats};
use super::conflict_record::ConflictRecord;
use super::headings::{self, HeadingRecord};
use super::least_time;
use super::plan_screen::{CoverageRecord, PriceRecord};
use super::recoverable::RecoverableRecord;
use super::recovery::RecoveryRecord;
use super::shape::{self, DetourRecord, ShapeRecord};
use super::verdict_text::{headline, statement};
use super::volumes::{self, VolumeRecord};
use super::waypoints::yaw_error;
use super::waypoints::{WaypointRecord, waypoints};
use super::without_yaw::{self, WithoutYawRecord};
use crate::admissible::outcome::Outcome;
use crate::certify::between::Between;
use crate::explain::detour::Detour;
use crate::flight::equilibrium::outcome_of;
use crate::model::{Mission, Model, Problem};
use crate::motion::outside::Outside;
use crate::motion::risk::rated_risk;
use crate::motion::wrench_model::WrenchModel;
use crate::planner::studies::protect::{Addition, Protection};
use crate::planner::studies::{Comparison, MissionPlan, NotFound, PlanOutcome, PlannerRun, Proof, Run, Verification};
use crate::verdict::Verdict;
use serde::Serialize;

/// Version of this record; raised when a field or the meaning of its values changes.
const SCHEMA: u32 = 6;

/// Why nothing was planned.
const REFUSED: &str = "hover does not lie inside every set that the plan must stay in";

/// Plans and their violations of each fault mode's admissible set. Equation numbers are those of Osmic, Tahirovic and
/// Petrovic (2020).
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Record {
    /// Version of this format.
    #[cfg_attr(test, schemars(extend("const" = SCHEMA)))]
    pub schema: u32,
    /// SHA-256 over all files of the spec.
    #[cfg_attr(test, schemars(regex(pattern = "^[0-9a-f]{64}$")))]
    pub spec_sha256: String,
    /// Model of the wrench along a trajectory: linear about hover, or exact.
    #[cfg_attr(test, schemars(extend("enum" = crate::language::table::plan::MODEL.words())))]
    pub model: &'static str,
    /// Share of each set reserved for feedback.
    #[cfg_attr(test, schemars(range(min = 0), extend("exclusiveMaximum" = 1)))]
    pub reserve: f64,
    /// With `rotors = lagging`: the time constant with which thrusts follow their commands, the largest over the
    /// rotors, s; null if they follow at once.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub thrust_time_constant_s: Option<f64>,
    /// One entry per planner and run.
    #[cfg_attr(test, schemars(length(min = 1)))]
    pub planners: Vec<PlannerRecord>,
    /// Mission times, s, ascending, at which `mavc plan` found a plan after it found none at the spec's time: the
    /// nearest of those tried on either side. Empty if none was searched for or found.
    #[cfg_attr(test, schemars(length(max = 2)))]
    pub found_at_s: Vec<f64>,
    /// Why there is no plan; null if there is one, if no statement could be blamed, and in `mavc compare`.
    pub conflict: Option<ConflictRecord>,
    /// The height that a fault without control of yaw costs, by simulation; omitted without a `ground`, without a
    /// plan, and if no mode is concerned.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub capture_height: Option<CaptureRecord>,
    /// What can be done after each fault, in `mavc plan --recovery` and with `require uncovered`; omitted otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub recovery: Option<RecoveryRecord>,
    /// In `mavc compare` with `require uncovered`: the plan with ways out after faults, and their price; omitted
    /// otherwise, because it was not attempted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub recoverable: Option<RecoverableRecord>,
    /// With `require risk`, in `mavc plan`: the plan without protection, then after each addition of the greedy
    /// choice; null otherwise.
    #[cfg_attr(test, schemars(length(min = 1)))]
    pub trade_off: Option<Vec<AdditionRecord>>,
}

/// One step of the greedy choice.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct AdditionRecord {
    /// What is protected in addition: facets that the plan violated (all, or the one violated last), a mode's whole
    /// set, or every mode's set.
    #[cfg_attr(test, schemars(extend("enum" = ["nothing", "facets", "mode", "all"])))]
    pub added: &'static str,
    /// The mode whose facets or set are protected; null for `nothing` and `all`.
    pub mode: Option<String>,
    /// How many facets; null if none were added.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub facets: Option<usize>,
    /// Mission time with all protection so far, s.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub time_s: f64,
    /// Risk of that plan; modes are treated as independent.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub risk: f64,
}

impl AdditionRecord {
    fn new(step: &Addition) -> Self {
        let (added, mode, facets) = match &step.added {
            Protection::Nothing => ("nothing", None, None),
            Protection::Facets { mode, facets } => ("facets", Some(mode.clone()), Some(*facets)),
            Protection::Mode { mode } => ("mode", Some(mode.clone()), None),
            Protection::All => ("all", None, None),
        };
        AdditionRecord { added, mode, facets, time_s: step.time, risk: step.risk }
    }
}

/// The failure rates of the modes that the plan must tolerate, 1/s, in the order of `against`.
pub fn rates(model: &Model) -> Vec<Option<f64>> {
    model.plan.against.iter().map(|&mode| model.modes[mode].rate).collect()
}

/// One run of a planner.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PlannerRecord {
    /// risk-insensitive, risk-conservative, risk-sensitive
    #[cfg_attr(test, schemars(extend("enum" = crate::language::table::plan::PLANNER.words())))]
    pub name: &'static str,
    /// The modes it plans against; empty for rip.
    pub against: Vec<String>,
    /// own: at the planner's shortest time. common: at T_d, the time at which planners are compared, or at the spec's
    /// time.
    #[cfg_attr(test, schemars(extend("enum" = ["own", "common"])))]
    pub run: &'static str,
    /// Mission time, s; null without a plan.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub time_s: Option<f64>,
    /// Lower bound on the mission time, s: no motion that satisfies the limits at every instant is faster. If the
    /// plan exceeds limits between its nodes, the bound allows all motions to exceed them as far. null if nothing was
    /// planned.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub time_lower_bound_s: Option<f64>,
    /// Whether there is a plan. proved infeasible: with these samples there is none at any of the times in
    /// `proved_infeasible_s`. not found: none was found, and infeasibility was not proved. not attempted: none was
    /// searched for.
    #[cfg_attr(test, schemars(with = "String", extend("enum" = Verdict::ALL.map(Verdict::word))))]
    pub verdict: Verdict,
    /// The verdict as in the terminal, with exactly what was shown.
    pub statement: String,
    /// The verdict and the planner, as the first sentence of the terminal and of the page.
    pub headline: String,
    /// In `mavc plan`: which fault modes the plan covers and which not, as the sentences below the headline; empty in
    /// `mavc compare` and without a plan.
    pub coverage: Vec<CoverageRecord>,
    /// In `mavc plan`: what covering the fault modes costs against a plan that ignores them; null in `mavc compare`,
    /// without a plan, and if no mode is planned against.
    pub price: Option<PriceRecord>,
    /// Mission times, s, for each of which it was proved separately that there is no plan; nothing is claimed about
    /// other times.
    #[cfg_attr(test, schemars(inner(range(min = 0))))]
    pub proved_infeasible_s: Vec<f64>,
    /// Value of (48).
    pub objective: Option<f64>,
    /// (49): sum of the distances to the waypoints, m.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub position_error_m: Option<f64>,
    /// (50): sum of the yaw errors at the waypoints, rad.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub yaw_error_rad: Option<f64>,
    /// Largest distance to a waypoint, m.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub max_waypoint_error_m: Option<f64>,
    /// The largest error of a waypoint as a share of its tolerance, in position or yaw; above 1 if a waypoint is
    /// missed. null without a plan.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub max_waypoint_share: Option<f64>,
    /// Every waypoint in the order of flight; empty without a plan.
    pub waypoints: Vec<WaypointRecord>,
    /// Inequalities imposed on the wrench: rows of the planning set times nodes.
    pub rows: usize,
    /// Results for each mode that the plan must tolerate; empty without a plan.
    pub modes: Vec<ModeRecord>,
    /// 1 - exp(-sum of rate x committed_s) over the modes that have a rate, treated as independent; null if none has
    /// one, or without a plan.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub risk: Option<f64>,
    /// How high the plan rises, how far it strays from the straight legs, and how far it turns; null without a plan.
    pub shape: Option<ShapeRecord>,
    /// In `mavc plan`: legs on which the plan climbs or strays by more than usual although no volume is in the way,
    /// with statements that forbid it; empty if there are none.
    #[cfg_attr(test, schemars(length(max = 2)))]
    pub detours: Vec<DetourRecord>,
    /// Caveats of the plan; empty without a plan.
    pub warnings: Vec<Caveat>,
    /// Result of the check that every trajectory must pass to be called a plan; null without a plan.
    pub check: Option<CheckRecord>,
    /// Constraints that limit the time of each leg, in the order of flight, if `mavc plan` searched for the time;
    /// empty otherwise.
    pub limited_by: Vec<BindingRecord>,
    /// How near the plan comes to the boundary of each volume; omitted without volumes.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub volumes: Vec<VolumeRecord>,
    /// The energy that the plan takes from the battery; omitted without a battery or a plan.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub battery: Option<BatteryRecord>,
    /// How far the yaw is off the directions that it follows; omitted where it follows none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub headings: Vec<HeadingRecord>,
    /// When the plan is lower than `capture_height` asks for; omitted where it never is.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, schemars(length(min = 1)))]
    pub exposed: Vec<ExposedRecord>,
    /// To what extent the plan's rows are shown to hold between nodes: rows on the wrench, then each limit, then rows
    /// on the commanded wrench of lagging rotors; null in `mavc compare` and without a plan.
    pub between_nodes: Option<Vec<Between>>,
}

/// How a plan keeps to the set of one fault mode.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ModeRecord {
    /// The mode's name.
    pub name: String,
    /// What the mode leaves of the vehicle in hover, as in `mavc analyze`.
    pub outcome: Outcome,
    /// Facets of the mode's set that are violated at some node (in the exact model: at some instant) by more than
    /// 1e-4, see `max_violation`.
    pub violated_facets: usize,
    /// Pairs of facet and node violated.
    pub violated_rows: usize,
    /// Nodes with a violated facet.
    pub violated_nodes: usize,
    /// Largest (n.w - e) over facets and instants, divided by the healthy set's width along n; negative if the plan
    /// stays inside. If yaw changes, it can be positive only between nodes. For a mode without yaw the largest
    /// violation of its core; null if the mode adds no rows.
    #[cfg_attr(test, schemars(with = "Option<f64>"))]
    pub max_violation: f64,
    /// How long the plan violates the mode's set, s, including between nodes.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub violation_duration_s: f64,
    /// The last instant at which the plan violates the mode's set, s since the start; null if there is none.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub last_violation_s: Option<f64>,
    /// What the mission does after this fault, as assumed for its risk.
    #[cfg_attr(test, schemars(extend("enum" = crate::language::table::plan::AFTER_FAULT.words())))]
    pub after_fault: &'static str,
    /// Until when the mission is committed, s: if `after_fault` is `continue`, until the last violation, because an
    /// earlier fault meets that violation; if it is `hold`, until the last instant from which no stop inside the
    /// mode's set was found. 0 if there is none.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub committed_s: f64,
    /// How the plan provides for the mode if it gives up yaw; omitted if it does not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub without_yaw: Option<WithoutYawRecord>,
}

/// Waypoint errors of a plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Errors {
    /// (49) of the paper: sum of distances, m.
    pub position: f64,
    /// (50) of the paper: sum of |psi - psi_ref|, rad.
    pub yaw: f64,
    /// Largest distance, m.
    pub largest: f64,
}

/// The waypoint errors of a plan, at the node of each waypoint.
pub fn errors(mission: &Mission, solved: &MissionPlan) -> Errors {
    let mut e = Errors { position: 0.0, yaw: 0.0, largest: 0.0 };
    for (index, (w, &node)) in mission.waypoints.iter().zip(&solved.trajectory.waypoint_nodes).enumerate() {
        let state = &solved.trajectory.nodes[node];
        let distance = (0..3).map(|i| (state[i][0] - w.position[i]).powi(2)).sum::<f64>().sqrt();
        e.position += distance;
        e.largest = e.largest.max(distance);
        e.yaw += yaw_error(index, mission, state);
    }
    e
}

impl Record {
    /// The record of all runs; `spec_sha256` is the hash over all files of the spec.
    pub fn new(problem: Problem, comparison: &Comparison, spec_sha256: String) -> Self {
        let model = problem.model();
        let outcomes: Vec<Outcome> = model.plan.against.iter().map(|&mode| outcome_of(model, mode)).collect();
        let planners = comparison.runs.iter().map(|r| planner(problem, comparison, &outcomes, r)).collect();
        let steps = || comparison.trade_off.iter().map(AdditionRecord::new).collect();
        Record {
            schema: SCHEMA,
            spec_sha256,
            model: model.plan.model.name(),
            reserve: model.plan.reserve,
            thrust_time_constant_s: model.thrust_lag(),
            planners,
            found_at_s: Vec::new(),
            conflict: None,
            capture_height: None,
            recovery: None,
            recoverable: None,
            trade_off: (!comparison.trade_off.is_empty()).then(steps),
        }
    }
}

impl Record {
    /// The report if some mode that the plan must tolerate cannot hover: nothing was planned.
    pub fn refused(model: &Model, spec_sha256: String) -> Self {
        let against = model.plan.against.iter().map(|&i| model.modes[i].name.clone()).collect();
        let planner = PlannerRecord {
            name: model.plan.planner.name(),
            against,
            run: "own",
            verdict: Verdict::NotAttempted,
            statement: format!("{}: {REFUSED}", Verdict::NotAttempted),
            ..PlannerRecord::default()
        };
        Record {
            schema: SCHEMA,
            spec_sha256,
            model: model.plan.model.name(),
            reserve: model.plan.reserve,
            thrust_time_constant_s: model.thrust_lag(),
            planners: vec![planner],
            found_at_s: Vec::new(),
            conflict: None,
            capture_height: None,
            recovery: None,
            recoverable: None,
            trade_off: None,
        }
    }
}

impl Record {
    /// Adds the captures, and to each planner with a plan how long that is lower; `exposed` is in the order of the
    /// planners.
    pub fn measured(mut self, captures: Option<CaptureRecord>, exposed: Vec<Vec<ExposedRecord>>) -> Self {
        for (planner, exposed) in self.planners.iter_mut().zip(exposed) {
            planner.warnings.extend(captures.as_ref().and_then(|captures| capture_height::caveat(captures, &exposed)));
            planner.exposed = exposed;
        }
        Record { capture_height: captures, ..self }
    }
}

impl PlannerRecord {
    /// Adds the detours of the plan, and the remarks about them.
    pub fn add_detours(&mut self, problem: Problem, solved: &MissionPlan, detours: &[Detour]) {
        self.detours = shape::detour_records(problem, detours);
        self.warnings.extend(shape::caveats(problem, solved, detours));
    }
}

/// Result of the check that every trajectory must pass to be called a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct CheckRecord {
    /// What the check shows.
    #[cfg_attr(test, schemars(extend("enum" = ["checked", "not_decided"])))]
    pub outcome: &'static str,
    /// What could not be decided; null if everything was.
    pub undecided: Option<String>,
}

impl CheckRecord {
    fn new(verification: &Verification) -> Option<Self> {
        match verification {
            Verification::None => None,
            Verification::Passed => Some(CheckRecord { outcome: "checked", undecided: None }),
            Verification::Undecided(why) => Some(CheckRecord { outcome: "not_decided", undecided: Some(why.clone()) }),
        }
    }
}

/// The number of facets of a mode that the plan violates, as RSP counts them: in the exact model at any instant,
/// otherwise at nodes.
pub(super) fn violated_facets(solved: &MissionPlan, out: &Outside) -> usize {
    if solved.trajectory.model == WrenchModel::Exact { out.violated.len() } else { out.facets.len() }
}

/// The record of one run; `outcomes` are those of the modes of the comparison.
fn planner(problem: Problem, comparison: &Comparison, outcomes: &[Outcome], run: &PlannerRun) -> PlannerRecord {
    let (model, mission) = (problem.model(), problem.mission());
    let nodes = match &run.outcome {
        PlanOutcome::Planned(solved) => solved.trajectory.times.len(),
        _ => model.plan.samples + 1,
    };
    let mut record = PlannerRecord {
        name: run.planner.name(),
        against: run.against.clone(),
        run: match run.run {
            Run::Own => "own",
            Run::Common => "common",
        },
        verdict: run.outcome.verdict(),
        statement: statement(problem, comparison, run),
        headline: headline(problem, comparison, run),
        time_lower_bound_s: Some(least_time::bound_for(problem, run).seconds),
        rows: run.set.rows.len() * nodes,
        ..PlannerRecord::default()
    };
    match &run.outcome {
        PlanOutcome::Infeasible(Proof { proved, .. }) => record.proved_infeasible_s = proved.clone(),
        PlanOutcome::NotFound(NotFound::Search { .. })
        | PlanOutcome::NotFound(NotFound::Check { .. })
        | PlanOutcome::NotAttempted { .. } => {}
        PlanOutcome::Planned(solved) => {
            let e = errors(mission, solved);
            record.proved_infeasible_s = solved.infeasible_at.iter().chain(&solved.infeasible_above).copied().collect();
            record.waypoints = waypoints(mission, solved);
            record.max_waypoint_share = record.waypoints.iter().map(WaypointRecord::share).max_by(f64::total_cmp);
            record.time_s = Some(solved.time);
            record.check = CheckRecord::new(&solved.verification);
            record.objective = Some(solved.objective);
            record.position_error_m = Some(e.position);
            record.yaw_error_rad = Some(e.yaw);
            record.max_waypoint_error_m = Some(e.largest);
            record.risk = rated_risk(&rates(model), &solved.committed);
            record.shape = Some(shape::record(problem, solved));
            record.warnings = caveats(model, solved);
            record.limited_by = binding::records(problem, solved);
            record.volumes = volumes::records(problem, solved);
            record.battery = battery::record(model, &solved.trajectory);
            record.headings = headings::records(problem, solved);
            record.modes = comparison
                .modes
                .iter()
                .zip(&solved.outside)
                .zip(model.plan.against.iter().zip(&solved.committed))
                .zip(comparison.provisions.iter().zip(outcomes))
                .map(|(((name, out), (&mode, &committed_s)), (provision, &outcome))| ModeRecord {
                    name: name.clone(),
                    outcome,
                    violated_facets: violated_facets(solved, out),
                    violated_rows: out.rows,
                    violated_nodes: out.positions,
                    max_violation: out.max_violation,
                    violation_duration_s: out.seconds,
                    last_violation_s: out.last,
                    after_fault: model.after_fault(mode).name(),
                    committed_s,
                    without_yaw: without_yaw::record(provision),
                })
                .collect();
        }
    }
    record
}
