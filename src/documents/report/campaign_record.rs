//! The machine-readable report of a campaign, schema in `docs/schema/campaign.schema.json`.

mod agreement;
mod path;

pub use agreement::{AgreementRecord, PredictorRecord, TableRecord};
pub use path::{LimitRecord, PathRecord};

use crate::admissible;
use crate::admissible::edge::Place;
use crate::admissible::without_yaw::YawFree;
use crate::campaign::agreement::Agreement;
use crate::campaign::cases::Shard;
use crate::campaign::design::{Design, Missing};
use crate::campaign::statistics::{Share, Summary, wilson};
use crate::campaign::tally::{Cell, Group, Tally};
use crate::flight::capture::CaptureHeight;
use crate::model::{Detection, Model};
use crate::verdict::Verdict;
use serde::Serialize;

/// Version of this record; raised when a field or the meaning of its values changes.
const SCHEMA: u32 = 4;

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CampaignRecord {
    pub schema: u32,
    pub spec_sha256: String,
    /// Identity, as in the rows; `None` if nothing was flown.
    pub campaign: Option<String>,
    /// 1-based; `None` for the whole campaign.
    pub shard: Option<ShardRecord>,
    /// T_d; `None` if nothing was flown.
    pub mission_time_s: Option<f64>,
    pub times: usize,
    pub seeds: usize,
    pub seed: u64,
    /// Flights of the whole campaign.
    pub cases: usize,
    /// Flights in this report.
    pub flights: usize,
    pub controller: &'static str,
    pub allocation: &'static str,
    /// `never`, `after` or `estimator`.
    pub detection: &'static str,
    pub detection_delay_s: Option<f64>,
    pub after_fault: &'static str,
    pub planners: Vec<PlannerRecord>,
    /// Over all modes, then over the modes with hover inside their sets; empty if nothing was flown.
    pub agreement: Vec<AgreementRecord>,
    /// Everything that predicts losses, over all modes; empty if nothing was flown.
    pub predictors: Vec<PredictorRecord>,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ShardRecord {
    pub index: usize,
    pub of: usize,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlannerRecord {
    pub name: &'static str,
    /// About its plan at the common time.
    pub verdict: Verdict,
    pub against: Vec<String>,
    /// Flights without a fault; errors are those of the whole flight.
    pub healthy: Option<GroupRecord>,
    pub modes: Vec<ModeRecord>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ModeRecord {
    pub name: String,
    /// Verdict, place of hover and the word for yaw given up, as `mavc analyze` reports them.
    pub verdict: admissible::verdict::Verdict,
    pub hover: Place,
    /// The place of hover in the words of tables.
    #[serde(skip)]
    pub hover_words: String,
    pub yaw_free: YawFree,
    /// Whether hover lies inside the mode's set of full wrenches.
    pub hover_inside: bool,
    /// Whether yaw may be given up after this fault, once it is known.
    pub gives_up_yaw: bool,
    /// The height that the fault costs if yaw is given up after it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub capture: Vec<CaptureHeight>,
    /// How long the plan violates the mode's set.
    pub violation_duration_s: f64,
    /// The last instant at which it does; `None` if there is none.
    pub last_violation_s: Option<f64>,
    /// The largest violation, in widths of the healthy set; negative inside, where it is the margin.
    pub worst_violation: f64,
    pub flights: GroupRecord,
    pub times: Vec<CellRecord>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroupRecord {
    pub flights: usize,
    pub flown: usize,
    pub landed: usize,
    pub lost: usize,
    pub lost_by_position: usize,
    pub lost_upside_down: usize,
    pub lost_to_ground: usize,
    pub lost_by_heading: usize,
    /// Flights whose simulation diverged; they count neither as lost nor as survived.
    pub diverged: usize,
    pub lost_before_fault: usize,
    /// With Wilson's 95 % interval; `None` without flights.
    pub survival: Option<Share>,
    /// Since the fault, over the flights that survived.
    pub rms_error_m: Option<Summary>,
    pub max_error_m: Option<Summary>,
    /// Largest position error since the fault, over the flights that survived.
    pub max_error_after_m: Option<Summary>,
    /// Largest heading error since the fault, over the flights that survived.
    pub max_heading_error_rad: Option<Summary>,
    pub detected_after_s: Option<Summary>,
    pub isolated_after_s: Option<Summary>,
    pub false_alarms: usize,
    pub refused_reconfigurations: usize,
    pub path: PathRecord,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CellRecord {
    pub fault_time_s: f64,
    pub flights: usize,
    /// Flights still flying when the fault struck.
    pub struck: usize,
    /// Struck flights that were lost.
    pub lost: usize,
    /// Flights whose simulation diverged.
    pub diverged: usize,
    /// Mean over the struck flights, lost ones included, of the largest distance from the reference since the fault; `None`
    /// without struck flights.
    pub mean_deviation_m: Option<f64>,
    /// Of the struck flights together.
    pub waypoints_due: usize,
    pub waypoints_missed: usize,
    /// Struck flights that broke a limit, or the heading.
    pub limits_broken: usize,
    pub heading_broken: usize,
}

impl CellRecord {
    fn new(fault_time_s: f64, cell: &Cell) -> Self {
        CellRecord {
            fault_time_s,
            flights: cell.flights,
            struck: cell.struck,
            lost: cell.lost,
            diverged: cell.diverged,
            mean_deviation_m: (cell.struck > 0).then(|| cell.path.deviation / cell.struck as f64),
            waypoints_due: cell.path.due,
            waypoints_missed: cell.path.missed,
            limits_broken: cell.path.limits,
            heading_broken: cell.path.heading,
        }
    }
}

impl CampaignRecord {
    /// The record of the flights in `tally`, which are those of `shard`.
    pub fn new(design: &Design, shard: Shard, tally: &Tally, spec_sha256: String) -> Self {
        let planners = design.plans.iter().enumerate().map(|(p, plan)| PlannerRecord {
            name: plan.planner.name(),
            verdict: Verdict::Found,
            against: plan.against.clone(),
            healthy: Some(GroupRecord::new(tally.healthy(p))),
            modes: (0..design.model.modes.len()).map(|m| mode(design, tally, p, m)).collect(),
        });
        let Agreement { all, inside, forecasts } = Agreement::new(design, tally);
        CampaignRecord {
            campaign: Some(design.id.to_string()),
            shard: (shard != Shard::WHOLE).then_some(ShardRecord { index: shard.index + 1, of: shard.of }),
            mission_time_s: Some(design.time),
            cases: design.cases.count(),
            flights: tally.flights(),
            planners: planners.chain(design.missing.iter().map(missing)).collect(),
            agreement: vec![AgreementRecord::new("all", &all), AgreementRecord::new("inside", &inside)],
            predictors: forecasts.into_iter().map(PredictorRecord::new).collect(),
            ..CampaignRecord::without_flights(design.model, &[], spec_sha256)
        }
    }

    /// The record where no planner has a plan, or none was run.
    pub fn without_flights(model: &Model, left_out: &[Missing], spec_sha256: String) -> Self {
        let simulation = &model.simulation;
        let (detection, detection_delay_s) = match simulation.detection {
            Detection::Never => ("never", None),
            Detection::After(delay) => ("after", Some(delay)),
            Detection::Estimator => ("estimator", None),
        };
        CampaignRecord {
            schema: SCHEMA,
            spec_sha256,
            campaign: None,
            shard: None,
            mission_time_s: None,
            times: model.campaign.times,
            seeds: model.campaign.seeds,
            seed: model.campaign.seed,
            cases: 0,
            flights: 0,
            controller: simulation.controller.name(),
            allocation: model.vehicle.allocation.name(),
            detection,
            detection_delay_s,
            after_fault: simulation.after_fault.name(),
            planners: left_out.iter().map(missing).collect(),
            agreement: Vec::new(),
            predictors: Vec::new(),
        }
    }
}

fn missing(missing: &Missing) -> PlannerRecord {
    PlannerRecord {
        name: missing.planner.name(),
        verdict: missing.verdict(),
        against: Vec::new(),
        healthy: None,
        modes: Vec::new(),
    }
}

fn mode(design: &Design, tally: &Tally, planner: usize, mode: usize) -> ModeRecord {
    let outside = &design.plans[planner].outside[mode];
    let standing = &design.modes[mode];
    let cells = tally.cells(planner, mode).iter().enumerate();
    ModeRecord {
        name: design.model.modes[mode].name.clone(),
        verdict: standing.verdict,
        hover: standing.hover,
        hover_words: standing.words.clone(),
        yaw_free: standing.yaw_free,
        hover_inside: standing.is_inside(),
        gives_up_yaw: standing.gives_up_yaw,
        capture: standing.capture.clone(),
        violation_duration_s: outside.seconds,
        last_violation_s: outside.last,
        worst_violation: outside.max_violation,
        flights: GroupRecord::new(tally.mode(planner, mode)),
        times: cells.map(|(k, cell)| CellRecord::new(design.fault_time(k), cell)).collect(),
    }
}

impl GroupRecord {
    fn new(group: &Group) -> Self {
        let [lost_by_position, lost_upside_down, lost_to_ground, lost_by_heading] = group.lost;
        GroupRecord {
            flights: group.flights,
            flown: group.flown,
            landed: group.landed,
            lost: group.all_lost(),
            lost_by_position,
            lost_upside_down,
            lost_to_ground,
            lost_by_heading,
            diverged: group.diverged,
            lost_before_fault: group.lost_before,
            survival: wilson(group.survived(), group.flights),
            rms_error_m: group.rms_error.summary(),
            max_error_m: group.max_error.summary(),
            max_error_after_m: group.max_error_after.summary(),
            max_heading_error_rad: group.max_heading_error.summary(),
            detected_after_s: group.detected_after.summary(),
            isolated_after_s: group.isolated_after.summary(),
            false_alarms: group.false_alarms,
            refused_reconfigurations: group.refused,
            path: PathRecord::new(&group.path),
        }
    }
}
