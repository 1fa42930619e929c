//! The machine-readable report of a campaign, schema in `docs/schema/campaign.schema.json`.

mod agreement;
mod path;

pub use agreement::{AgreementRecord, TableRecord};
pub use path::{LimitRecord, PathRecord};

use crate::admissible;
use crate::admissible::edge::HoverPlace;
use crate::admissible::without_yaw::YawFree;
use crate::campaign::agreement::Agreement;
use crate::campaign::cases::Shard;
use crate::campaign::design::{Design, Missing};
use crate::campaign::statistics::{QUANTILES, Share, Summary, wilson};
use crate::campaign::tally::{Cell, Group, Tally};
use crate::flight::capture::CaptureHeight;
use crate::model::Model;
use crate::verdict::Verdict;
use serde::Serialize;

/// Version of this record; raised when a field or the meaning of its values changes.
const SCHEMA: u32 = 5;

/// Simulated flights with faults along the plans of several planners: survival, tracking errors, and whether the
/// plans predict which flights are lost. SI units.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct CampaignRecord {
    /// Version of this format.
    #[cfg_attr(test, schemars(extend("const" = SCHEMA)))]
    pub schema: u32,
    /// SHA-256 over all files of the spec and all overrides.
    #[cfg_attr(test, schemars(regex(pattern = "^[0-9a-f]{64}$")))]
    pub spec_sha256: String,
    /// Identity of the campaign, as in its rows; null if nothing was flown.
    #[cfg_attr(test, schemars(regex(pattern = "^[0-9a-f]{16}$")))]
    pub campaign: Option<String>,
    /// The part that was flown, counted from 1; null for the whole campaign.
    pub shard: Option<ShardRecord>,
    /// Mission time of all plans, s; null if nothing was flown.
    pub mission_time_s: Option<f64>,
    /// Number of instants of the fault.
    pub times: usize,
    /// Number of seeds.
    pub seeds: usize,
    /// The campaign's seed.
    pub seed: u64,
    /// Flights of the whole campaign.
    pub cases: usize,
    /// Flights in this report.
    pub flights: usize,
    /// The controller.
    #[cfg_attr(test, schemars(extend("enum" = crate::language::table::simulate::CONTROLLER.words())))]
    pub controller: &'static str,
    /// How a wrench becomes rotor speeds.
    #[cfg_attr(test, schemars(extend("enum" = crate::language::table::vehicle::ALLOCATION.words())))]
    pub allocation: &'static str,
    /// How the controller learns of faults.
    #[cfg_attr(test, schemars(extend("enum" = ["never", "after", "estimator"])))]
    pub detection: &'static str,
    /// Delay after which faults are known, s; null unless `detection` is `after`.
    pub detection_delay_s: Option<f64>,
    /// The reaction to a detected fault.
    #[cfg_attr(test, schemars(extend("enum" = crate::language::table::simulate::AFTER_FAULT.words())))]
    pub after_fault: &'static str,
    /// The planners, with the flights of their plans.
    pub planners: Vec<PlannerRecord>,
    /// Whether the plans predict which flights are lost: over all modes, then over the modes with hover inside their
    /// sets; empty if nothing was flown.
    pub agreement: Vec<AgreementRecord>,
}

/// A part of a campaign.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ShardRecord {
    /// Its number, from 1.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub index: usize,
    /// Number of parts.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub of: usize,
}

/// A planner and the flights of its plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PlannerRecord {
    /// Its name.
    #[cfg_attr(test, schemars(extend("enum" = crate::language::table::plan::PLANNER.words())))]
    pub name: &'static str,
    /// Whether there is a plan at the common time; plans that are found are flown. not attempted: there is no mode to
    /// plan against, no common time, or no RIP plan to select facets from.
    #[cfg_attr(test, schemars(with = "String", extend("enum" = Verdict::ALL.map(Verdict::word))))]
    pub verdict: Verdict,
    /// The modes it plans against; empty for rip.
    pub against: Vec<String>,
    /// Flights without a fault, with the errors of the whole flight; null if no plan is flown.
    pub healthy: Option<GroupRecord>,
    /// The flights with each mode; empty if no plan is flown.
    pub modes: Vec<ModeRecord>,
}

/// The flights of one plan with one fault mode.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ModeRecord {
    /// The mode's name.
    pub name: String,
    /// The paper's verdict, as `mavc analyze` reports it.
    pub verdict: admissible::verdict::HoverVerdict,
    /// Where hover lies relative to the set of the verdict, as `mavc analyze` reports it: without yaw for a
    /// stabilizable mode.
    pub hover: HoverPlace,
    /// The place of hover in the words of tables.
    #[serde(skip)]
    pub hover_words: String,
    /// How the mode hovers with yaw given up, as `mavc analyze` reports it.
    pub yaw_free: YawFree,
    /// Whether hover lies inside the mode's set of full wrenches, and not on its edge.
    pub hover_inside: bool,
    /// Whether yaw may be given up after this fault, once it is known.
    pub gives_up_yaw: bool,
    /// The height that the fault costs at two horizontal speeds, with the spec's detection; omitted if yaw is not
    /// given up after it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub capture: Vec<CaptureHeight>,
    /// How long the plan violates the mode's set, with the spec's reserve, s.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub violation_duration_s: f64,
    /// The last instant at which it does, s; null if there is none.
    pub last_violation_s: Option<f64>,
    /// The largest violation, in widths of the healthy set; negative inside, where it is the margin.
    pub worst_violation: f64,
    /// All flights with this mode.
    pub flights: GroupRecord,
    /// One entry per instant of the fault.
    pub times: Vec<CellRecord>,
}

/// The outcomes of a group of flights.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct GroupRecord {
    /// Number of flights.
    pub flights: usize,
    /// Flown to the end.
    pub flown: usize,
    /// Landed after the fault.
    pub landed: usize,
    /// Not lost, but inside a `keep_out` or outside a `keep_in`; not survived.
    pub trespassed: usize,
    /// Lost, for whatever cause.
    pub lost: usize,
    /// Too far from the planned position.
    pub lost_by_position: usize,
    /// Tilted by more than 90 degrees for too long.
    pub lost_upside_down: usize,
    /// Fallen to the ground.
    pub lost_to_ground: usize,
    /// Heading error too large for too long.
    pub lost_by_heading: usize,
    /// The integration broke down; these flights count neither as lost nor as survived.
    pub diverged: usize,
    /// Lost before the fault could strike; counted in `lost` too.
    pub lost_before_fault: usize,
    /// Share flown or landed; null without flights.
    pub survival: Option<Share>,
    /// Root mean square position error since the fault (without a fault: over the whole flight), over the flights
    /// that survived, m.
    pub rms_error_m: Option<Summary>,
    /// Largest position error over the whole flight, over the flights that survived, m.
    pub max_error_m: Option<Summary>,
    /// Largest position error since the fault (without a fault: over the whole flight), over the flights that
    /// survived, m.
    pub max_error_after_m: Option<Summary>,
    /// Largest heading error since the fault (without a fault: over the whole flight), over the flights that
    /// survived, rad.
    pub max_heading_error_rad: Option<Summary>,
    /// Seconds until the fault was detected, over the flights in which it was.
    pub detected_after_s: Option<Summary>,
    /// Seconds until the fault was isolated, over the flights in which it was.
    pub isolated_after_s: Option<Summary>,
    /// Seconds within which half, nine tenths and 99 % of the struck flights had isolated the fault, those that never
    /// did included; null where fewer had, or without struck flights.
    pub isolated_within_s: [Option<f64>; 3],
    /// Alarms of sound rotors, of all flights together.
    pub false_alarms: usize,
    /// Alarms of sound rotors in an hour of flight; null without flights.
    pub false_alarms_per_hour: Option<f64>,
    /// Reconfigurations refused because the vehicle could not hover under them.
    pub refused_reconfigurations: usize,
    /// What happened to the path.
    pub path: PathRecord,
}

/// The flights with one mode and one instant of the fault.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct CellRecord {
    /// The instant of the fault, s.
    pub fault_time_s: f64,
    /// Number of flights.
    pub flights: usize,
    /// Flights still flying when the fault struck.
    pub struck: usize,
    /// Struck flights that were not survived: lost or trespassed.
    pub lost: usize,
    /// Flights whose integration broke down; not among the struck ones.
    pub diverged: usize,
    /// Mean over the struck flights, lost ones included, of the largest distance from the reference since the fault,
    /// m; null without struck flights.
    pub mean_deviation_m: Option<f64>,
    /// Waypoints that were due, of the struck flights together.
    pub waypoints_due: usize,
    /// Those of them that were missed by more than their tolerance.
    pub waypoints_missed: usize,
    /// Struck flights that broke a limit.
    pub limits_broken: usize,
    /// Struck flights that broke the heading.
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
        let Agreement { all, inside } = Agreement::new(design, tally);
        CampaignRecord {
            campaign: Some(design.id.to_string()),
            shard: (shard != Shard::WHOLE).then_some(ShardRecord { index: shard.index + 1, of: shard.of }),
            mission_time_s: Some(design.time),
            cases: design.cases.count(),
            flights: tally.flights(),
            planners: planners.chain(design.missing.iter().map(missing)).collect(),
            agreement: vec![AgreementRecord::new("all", &all), AgreementRecord::new("inside", &inside)],
            ..CampaignRecord::without_flights(design.model, &[], spec_sha256)
        }
    }

    /// The record where no planner has a plan, or none was run.
    pub fn without_flights(model: &Model, left_out: &[Missing], spec_sha256: String) -> Self {
        let simulation = &model.simulation;
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
            detection: simulation.detection.name(),
            detection_delay_s: simulation.detection.delay(),
            after_fault: simulation.after_fault.name(),
            planners: left_out.iter().map(missing).collect(),
            agreement: Vec::new(),
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
            trespassed: group.trespassed,
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
            isolated_within_s: QUANTILES.map(|share| group.isolation.quantile(share)),
            false_alarms: group.false_alarms,
            false_alarms_per_hour: group.alarms_per_hour(),
            refused_reconfigurations: group.refused,
            path: PathRecord::new(&group.path),
        }
    }
}
