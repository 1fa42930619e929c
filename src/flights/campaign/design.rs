//! The design of a campaign: plans at one mission time, and the violations of every declared mode's set by each plan.

use super::cases::{Case, Cases, fault_time};
use crate::admissible::edge::HoverPlace;
use crate::admissible::row::{SetRow, row};
use crate::admissible::without_yaw::YawFree;
use crate::admissible::without_yaw::planned::Provision;
use crate::admissible::{self, AdmissibleSet, verdict::analyze};
use crate::flight::capture::{self, CaptureHeight};
use crate::model::{Detection, FaultMode, GiveUpYaw, Model, PlannerKind};
use crate::motion::Trajectory;
use crate::motion::outside::{Outside, outside};
use crate::planner::studies::{Comparison, PlanOutcome};
use crate::verdict::Verdict;
use rayon::prelude::*;
use sha2::{Digest, Sha256};
use std::fmt;
use std::str::FromStr;

/// One planner's plan.
#[derive(Debug, Clone)]
pub struct CampaignPlan {
    pub planner: PlannerKind,
    /// Names of the modes it plans against.
    pub against: Vec<String>,
    pub trajectory: Trajectory,
    /// Violations of every declared mode's set, in their order, with the spec's reserve.
    pub outside: Vec<Outside>,
}

/// What is known of a mode without a flight.
#[derive(Debug, Clone, PartialEq)]
pub struct Standing {
    /// The paper's verdict.
    pub verdict: admissible::verdict::HoverVerdict,
    /// Where hover lies relative to the set of the verdict, as `mavc analyze` reports it.
    pub hover: HoverPlace,
    /// Where it lies relative to the set of full wrenches. A plan can keep a reserve only against modes with hover
    /// inside.
    pub hover_all_axes: HoverPlace,
    /// How the mode hovers in the words of all reports, such as `on the edge, yaw free`.
    pub words: String,
    /// How the mode hovers with yaw given up.
    pub yaw_free: YawFree,
    /// Whether yaw may be given up after this fault, once it is known.
    pub gives_up_yaw: bool,
    /// Whether plans are measured by its core.
    pub has_core: bool,
    /// The height that the fault costs ([`capture::heights()`]); empty if yaw is not given up after it.
    pub capture: Vec<CaptureHeight>,
}

impl Standing {
    /// Whether hover lies inside the set of full wrenches.
    pub fn is_inside(&self) -> bool {
        self.hover_all_axes == HoverPlace::Inside
    }

    /// Whether a plan can keep a reserve against the mode: hover lies inside its set, or inside the core by which it is
    /// measured.
    pub fn can_keep_reserve(&self) -> bool {
        self.is_inside() || self.has_core
    }
}

/// A planner without a plan to fly.
#[derive(Debug, Clone)]
pub struct Missing {
    pub planner: PlannerKind,
    /// `None` if it was not run: RCP without a mode to tolerate, or any planner without a common time.
    pub outcome: Option<PlanOutcome>,
}

impl Missing {
    /// The verdict about its plan at the common time.
    pub fn verdict(&self) -> Verdict {
        self.outcome.as_ref().map_or(Verdict::NotAttempted, PlanOutcome::verdict)
    }
}

/// A campaign to fly.
#[derive(Debug, Clone)]
pub struct Design<'a> {
    pub model: &'a Model,
    /// In the order of the spec's planners; never empty.
    pub plans: Vec<CampaignPlan>,
    pub missing: Vec<Missing>,
    /// For each declared mode what is known of it without a flight.
    pub modes: Vec<Standing>,
    /// T_d, s.
    pub time: f64,
    pub cases: Cases,
    pub id: CampaignId,
}

/// A hash that identifies a campaign.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct CampaignId(pub u64);

impl fmt::Display for CampaignId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

impl FromStr for CampaignId {
    type Err = ();

    /// Sixteen lower-case hexadecimal digits.
    fn from_str(text: &str) -> Result<Self, ()> {
        let id = u64::from_str_radix(text, 16).map(CampaignId).map_err(|_| ())?;
        if id.to_string() == text { Ok(id) } else { Err(()) }
    }
}

impl<'a> Design<'a> {
    /// The design with the plans at the common time ([`crate::planner::studies::Scope::Common`]). `origin` identifies
    /// all files and overrides, and the program, by their hashes.
    ///
    /// # Errors
    /// No planner has a plan.
    pub fn new(model: &'a Model, comparison: &Comparison, origin: &str) -> Result<Self, Vec<Missing>> {
        let mut plans = Vec::new();
        let mut missing = Vec::new();
        for &planner in &model.campaign.planners {
            let run = comparison.runs.iter().find(|r| r.planner == planner);
            match run.map(|r| (&r.outcome, &r.against)) {
                Some((PlanOutcome::Planned(solved), against)) => {
                    plans.push(CampaignPlan {
                        planner,
                        against: against.clone(),
                        outside: Vec::new(),
                        trajectory: solved.trajectory.clone(),
                    });
                }
                other => missing.push(Missing { planner, outcome: other.map(|(outcome, _)| outcome.clone()) }),
            }
        }
        let Some(time) = comparison.common_time.filter(|_| !plans.is_empty()) else { return Err(missing) };
        let campaign = &model.campaign;
        let cases =
            Cases { planners: plans.len(), modes: model.modes.len(), times: campaign.times, seeds: campaign.seeds };
        let modes = judge(model, &mut plans);
        let mut design = Design { model, plans, missing, modes, time, cases, id: CampaignId(0) };
        design.id = design.identity(origin);
        Ok(design)
    }

    /// Hash of the spec, the program, the mission time, the planners and the dimensions of the campaign.
    fn identity(&self, origin: &str) -> CampaignId {
        let Cases { planners, modes, times, seeds } = self.cases;
        let mut hash = Sha256::new();
        hash.update(origin.as_bytes());
        hash.update(env!("CARGO_PKG_VERSION").as_bytes());
        for count in [planners, modes, times, seeds, self.cases.count()] {
            hash.update((count as u64).to_le_bytes());
        }
        hash.update(self.time.to_le_bytes());
        self.plans.iter().for_each(|plan| hash.update(plan.planner.name().as_bytes()));
        let bytes = hash.finalize();
        CampaignId(bytes.iter().take(8).fold(0, |id, byte| id << 8 | u64::from(*byte)))
    }

    /// Whether a plan before this one is the same motion: it counts once where plans are compared.
    pub fn is_repeated(&self, plan: usize) -> bool {
        let trajectory = &self.plans[plan].trajectory;
        self.plans[..plan].iter().any(|earlier| earlier.trajectory.is_same_motion(trajectory))
    }

    /// The plan that a case flies.
    pub fn plan(&self, case: &Case) -> &CampaignPlan {
        &self.plans[case.planner]
    }

    /// The fault of a case and its instant, s.
    pub fn strike(&self, case: &Case) -> Option<(&'a FaultMode, f64)> {
        case.strike.map(|s| (&self.model.modes[s.mode], self.fault_time(s.time)))
    }

    /// The instant with this index, s.
    pub fn fault_time(&self, index: usize) -> f64 {
        fault_time(self.time, self.cases.times, index)
    }
}

/// The standing of each declared mode ([`crate::admissible::edge`]), and the violations of each plan. Sets with hover
/// inside are shrunk by the reserve; the others cannot be shrunk about hover. Only one set is in memory at a time:
/// those of all modes may not fit.
fn judge(model: &Model, plans: &mut [CampaignPlan]) -> Vec<Standing> {
    let healthy = AdmissibleSet::healthy(model);
    let mut modes = Vec::new();
    for mode in 0..model.modes.len() {
        let (rows, standing) = mode_rows(model, mode, &healthy);
        for plan in plans.iter_mut() {
            plan.outside.push(outside(&plan.trajectory, &model.vehicle, &model.environment(), &rows));
        }
        modes.push(standing);
    }
    modes.par_iter_mut().enumerate().filter(|(_, standing)| standing.gives_up_yaw).for_each(|(mode, standing)| {
        standing.capture = capture::heights(model, mode);
    });
    modes
}

/// A declared mode's set as rows, or its core where plans provide for the mode without yaw; and its standing.
fn mode_rows(model: &Model, mode: usize, healthy: &AdmissibleSet) -> (Vec<SetRow>, Standing) {
    let mut set = AdmissibleSet::of_mode(model, mode);
    let analysis = analyze(model, &set);
    let is_known = model.simulation.detection != Detection::Never;
    let gives_up_yaw = is_known && model.gives_up_yaw(mode) != GiveUpYaw::Never;
    let mut standing = Standing {
        verdict: analysis.verdict,
        hover: analysis.hover,
        hover_all_axes: analysis.hover_all_axes(),
        words: analysis.hover_words(),
        yaw_free: analysis.yaw_free,
        gives_up_yaw,
        has_core: false,
        capture: Vec::new(),
    };
    if gives_up_yaw && let Provision::WithoutYaw(core) = Provision::of(model, &set, healthy) {
        standing.has_core = true;
        return (core.rows, standing);
    }
    if standing.is_inside() {
        set = set.with_reserve(model.plan.reserve);
    }
    let equalities = set.polytope.equalities.iter().map(|e| {
        let width = healthy.zonotope.width(&e.normal);
        SetRow { normal: e.normal / width, offset: e.offset / width, equality: true, origin: Vec::new(), core: None }
    });
    let facets = set.polytope.facets.iter().map(|f| row(f, healthy, Vec::new()));
    (equalities.chain(facets).collect(), standing)
}
