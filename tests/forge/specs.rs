//! The specs that forgeries are about, each with a plan in closed form, and what else a forger has at hand: plans of
//! easier specs, multipliers of harder ones.

mod foreign;
mod list;
mod particular;

use super::motion::{Timetable, Wish, add_spline, certificate};
use super::numbers::Numbers;
use super::truth::{Falsehood, Outline, Truth};
use mavc::certificate::{Certificate, Claim, FamilyRecord, RecoveryClaim};
use mavc::model::{
    Allocation, Environment, Limit, LimitKind, MissionTime, Model, PlanRotors, PlannerKind, Problem, RotorSpread,
    Spread, Volume,
};
use mavc::motion::checks::{peak, violation};
use mavc::motion::{Trajectory, X, Y, YAW, Z};
use mavc::recovery::recovery;
use rayon::prelude::*;

pub use foreign::WEAKER;
use list::drafts;
pub use list::flat_inverse;
pub use particular::falling;

/// A spec before its plan is made.
pub struct Draft {
    pub name: &'static str,
    pub model: Model,
    /// The time of the honest plan, s.
    pub total: f64,
    /// Limits that are set from the honest plan: what it reaches, times this share.
    pub limits: Vec<(LimitKind, f64)>,
    /// Whether multipliers of harder specs are made.
    pub harder: bool,
    /// The honest motion, where it is not that of least snap.
    pub motion: Option<Trajectory>,
    /// What the honest certificate gives as the capture height, m.
    pub capture_height: Option<f64>,
    /// Those of the spec's volumes, where all of them are polygons.
    pub outlines: Vec<Outline>,
    /// Whether the honest certificate has ways out.
    pub ways: bool,
    /// Until when the honest plan is inside the set of every mode, s, where it leaves it later.
    pub calm_until: Option<f64>,
}

impl Draft {
    pub fn new(name: &'static str, total: f64, model: Model, limits: &[(LimitKind, f64)]) -> Self {
        let (limits, outlines) = (limits.to_vec(), Vec::new());
        Draft {
            name,
            model,
            total,
            limits,
            harder: false,
            motion: None,
            capture_height: None,
            outlines,
            ways: false,
            calm_until: None,
        }
    }
}

/// In what a spec is easier than the one that a plan is given for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Easier {
    RipInsteadOfRcp,
    Lighter,
    NoReserve,
    OtherMode,
    Nominal,
    Instant,
    Bounded,
    StoppingRotors,
    NoDrag,
    OtherWind,
    OneWind,
}

/// In what a spec without a plan is harder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Harder {
    Shorter,
    StricterLimits,
    OtherPlanner,
    WeakerVehicle,
    /// Rotors that do not reverse.
    OneWay,
    /// Both sides of limits on the yaw as narrow as the narrower one.
    NarrowSides,
}

/// A spec with its plan, and a forger's material.
pub struct Spec {
    pub name: &'static str,
    pub truth: Truth,
    pub honest: Trajectory,
    pub selected_by: Vec<Trajectory>,
    pub easier: Vec<(Easier, Truth)>,
    /// Certificates that harder specs have no plan.
    pub harder: Vec<(Harder, Certificate)>,
    /// m above the ground
    pub capture_height: Option<f64>,
    /// The ways out after faults, which only kinds about them claim.
    pub ways: Option<RecoveryClaim>,
    /// Ways back to a part of the honest plan that is inside the modes' sets, after which it leaves them.
    pub too_early: Option<RecoveryClaim>,
    /// No certificate of this spec proves anything: its reserve is taken about a hover outside a set.
    pub is_void: bool,
}

impl Spec {
    pub fn model(&self) -> &Model {
        &self.truth.model
    }

    pub fn is_rsp(&self) -> bool {
        self.model().plan.planner == PlannerKind::Rsp
    }

    /// Whether the honest plan is where a bound says that no motion is as soon, by more than a thousandth.
    pub fn is_sooner_than(&self, certificate: &Certificate) -> bool {
        let (bound, reached) = match &certificate.claim {
            Claim::Plan(claim) => (claim.least_time_s, Some(self.total())),
            Claim::TooEarly(claim) => {
                let node = claim.waypoint.checked_sub(1).and_then(|i| self.honest.waypoint_nodes.get(i));
                (Some(claim.soonest_s), node.map(|&n| self.honest.times[n]))
            }
            Claim::Infeasible(_) => return false,
        };
        bound.zip(reached).is_some_and(|(bound, reached)| bound > 1.001 * reached)
    }

    /// Whether RCP keeps to a set of fewer than four dimensions.
    pub fn is_flat(&self) -> bool {
        self.truth.has_equalities()
    }

    /// s
    pub fn total(&self) -> f64 {
        self.honest.times[self.honest.times.len() - 1]
    }

    pub fn certificate(&self) -> Certificate {
        self.claiming(&self.honest)
    }

    /// The honest certificate with ways out.
    pub fn with_ways(&self, ways: RecoveryClaim) -> Certificate {
        let mut made = self.certificate();
        if let Claim::Plan(claim) = &mut made.claim {
            claim.recovery = Some(ways);
        }
        made
    }

    /// A claim that another motion is the plan.
    pub fn claiming(&self, motion: &Trajectory) -> Certificate {
        self.claim(motion, &self.selected_by)
    }

    /// The same with other motions to select by.
    pub fn claim(&self, motion: &Trajectory, selected_by: &[Trajectory]) -> Certificate {
        let mut made = certificate(motion, selected_by);
        if let Claim::Plan(claim) = &mut made.claim {
            claim.without_yaw = self.truth.records.clone();
        }
        Certificate { capture_height_m: self.capture_height, ..made }
    }

    /// Whether the spec leaves one grid of nodes only, on which multipliers may say something; the honest plan lies on
    /// it.
    pub fn has_one_grid(&self) -> bool {
        matches!(self.model().plan.time, MissionTime::Fixed(_)) && !self.model().plan.chooses_times
    }
}

/// All specs with their plans.
pub fn all() -> Vec<Spec> {
    drafts().into_par_iter().chain(particular::drafts()).map(Spec::of).collect()
}

impl Spec {
    /// # Panics
    /// Where the draft's honest plan is none: a mistake in the list.
    pub fn of(draft: Draft) -> Self {
        let Draft { name, mut model, total, limits, harder, motion, capture_height, outlines, ways, calm_until } =
            draft;
        let honest = motion.or_else(|| smooth(&model, total)).unwrap_or_else(|| panic!("{name}: no motion"));
        let air = model.environment();
        let wanted = limits.into_iter().map(|(kind, share)| reached(&honest, kind, share, &air));
        let (size, gravity) = (model.vehicle.radius(), model.gravity);
        let mission = model.mission.as_mut().expect("a mission");
        mission.volumes.iter_mut().for_each(|volume| volume.clearance = kept(&honest, volume, gravity) - size - ROOM);
        // Those of a spec in text are kept: they are of legs.
        let written = std::mem::take(&mut mission.limits);
        let of_volumes = mission.volumes.iter().flat_map(|volume| volume.limits(size));
        mission.limits = wanted.chain(of_volumes).chain(written).collect();
        let margins = mission.volumes.iter().map(|volume| volume.clearance + size).collect::<Vec<_>>();
        let mut truth = Truth::of(&model);
        truth.outlines = outlines.into_iter().zip(margins).collect();
        let is_void = truth.reserves_about_nothing();
        let false_by = truth.of_plan(&honest).filter(|why| !is_void || *why != Falsehood::Reserve);
        assert!(false_by.is_none(), "{name}: the honest plan is false by {false_by:?}");
        let tightest = truth.tightest(&honest);
        assert!(tightest <= 1e-6, "{name}: the honest plan is {tightest} tolerances beyond a row");
        let selected_by = match model.plan.planner {
            PlannerKind::Rsp if is_void => vec![honest.clone()],
            PlannerKind::Rsp => selecting(name, &truth, &honest),
            _ => Vec::new(),
        };
        let found = if harder { foreign::harder(&model, total) } else { Vec::new() };
        let easier = easier(&model).into_iter().map(|(how, model)| (how, Truth::of(&model))).collect();
        let ways = ways.then(|| {
            let problem = Problem::of(&model).expect("a mission");
            recovery(problem, &honest, true).claim().unwrap_or_else(|| panic!("{name}: no ways out"))
        });
        let too_early = calm_until.map(|until| {
            let problem = Problem::of(&model).expect("a mission");
            let claim = recovery(problem, &honest.part(0.0, until), true).claim();
            let mut claim = claim.unwrap_or_else(|| panic!("{name}: no early ways back"));
            let RecoveryClaim { branches, families } = &mut claim;
            let longest = model.plan.recovery.detection[1];
            let returns = |family: &FamilyRecord| {
                branches[family.corners[0]].times_s.last().map(|takes| family.to_s + longest + takes)
            };
            families.retain(|family| returns(family).is_some_and(|at| at < until));
            assert!(!families.is_empty(), "{name}: no early ways back");
            claim
        });
        Spec { name, truth, honest, selected_by, easier, harder: found, capture_height, ways, too_early, is_void }
    }
}

/// The motion of least snap on the spec's own grid.
fn smooth(model: &Model, total: f64) -> Option<Trajectory> {
    let table = Timetable::asked(model, total)?;
    Wish::of(model.mission.as_ref()?).motion(&table, super::motion::equations(model))
}

/// How much nearer than it is a motion may come to a volume, m.
const ROOM: f64 = 0.01;

/// The smallest distance of a motion's positions from the boundary of a volume, m.
fn kept(motion: &Trajectory, volume: &Volume, gravity: f64) -> f64 {
    let limits = Volume { clearance: 0.0, ..volume.clone() }.limits(0.0);
    -peak(motion, |s| {
        limits.iter().map(|l| violation(l, s, &Environment::vacuum(gravity))).fold(f64::NEG_INFINITY, f64::max)
    })
    .value
}

/// A limit at a share of what a motion reaches.
fn reached(motion: &Trajectory, kind: LimitKind, share: f64, air: &Environment) -> Limit {
    let bound =
        |lower, upper| Limit { kind: kind.clone(), lower, upper, span: Default::default(), volume: None, leg: None };
    let most = peak(motion, |s| violation(&bound(None, Some(0.0)), s, air)).value;
    let least = || peak(motion, |s| violation(&bound(Some(0.0), None), s, air)).value;
    match &kind {
        // Room beside the motion, m and rad.
        LimitKind::X | LimitKind::Y | LimitKind::Z | LimitKind::Yaw => {
            bound(Some(-least() - (share - 1.0)), Some(most + (share - 1.0)))
        }
        LimitKind::YawRate | LimitKind::YawAcceleration => {
            let size = most.max(least()).max(0.1) * share;
            bound(Some(-size), Some(size))
        }
        _ => bound(None, Some(most.max(0.1) * share)),
    }
}

/// Plans that RSP selects by: the honest one with a turn or a jump within the healthy set that leaves some mode's set;
/// each further one keeps what those before it are beyond.
fn selecting(name: &str, truth: &Truth, honest: &Trajectory) -> Vec<Trajectory> {
    let mut numbers = Numbers::of(16, name.len() as u64);
    let mut found: Vec<Trajectory> = Vec::new();
    for _ in 0..4000 {
        if found.len() == truth.model.plan.rounds {
            break;
        }
        let mut motion = honest.clone();
        let axis = [X, Y, Z, YAW, YAW][numbers.below(5)];
        let first = numbers.below(motion.nodes.len());
        let size = numbers.sign() * numbers.magnitude(0.2, 40.0);
        if add_spline(&mut motion, axis, first, 2, size).is_none() {
            continue;
        }
        let beyond = truth.beyond_modes(&motion) > 3e-3 && truth.selects_by(&motion);
        // Nothing is on the edge, neither here nor for the honest plan.
        if beyond
            && truth.is_clear_of_selection(&motion, &found)
            && truth.of_selecting(&motion).is_none()
            && truth.keeps_own(&motion)
            && truth.is_clear_of_selection(honest, std::slice::from_ref(&motion))
        {
            found.push(motion);
        }
    }
    assert_eq!(found.len(), truth.model.plan.rounds, "{name}: no plans to select from");
    found
}

/// The same spec where one thing is easier.
fn easier(model: &Model) -> Vec<(Easier, Model)> {
    let changed = |how: Easier, change: &dyn Fn(&mut Model)| {
        let mut other = model.clone();
        change(&mut other);
        (how, other)
    };
    let (plan, vehicle) = (&model.plan, &model.vehicle);
    let mut found = vec![changed(Easier::Lighter, &|m| m.vehicle.mass *= 0.5)];
    if plan.planner == PlannerKind::Rcp {
        found.push(changed(Easier::RipInsteadOfRcp, &|m| m.plan.planner = PlannerKind::Rip));
        if model.modes.len() > plan.against.len() && plan.against.len() == 1 {
            found.push(changed(Easier::OtherMode, &|m| m.plan.against = vec![(m.plan.against[0] + 1) % m.modes.len()]));
        }
    }
    if plan.reserve > 0.0 {
        found.push(changed(Easier::NoReserve, &|m| m.plan.reserve = 0.0));
    }
    if vehicle.is_uncertain() {
        found.push(changed(Easier::Nominal, &|m| {
            m.vehicle.mass_spread = Spread::NONE;
            m.vehicle.rotors.iter_mut().for_each(|r| r.spread = RotorSpread::default());
        }));
    }
    if plan.rotors == PlanRotors::Lagging {
        found.push(changed(Easier::Instant, &|m| m.plan.rotors = PlanRotors::Instant));
    }
    if vehicle.allocation == Allocation::PseudoInverse {
        found.push(changed(Easier::Bounded, &|m| m.vehicle.allocation = Allocation::Bounded));
    }
    if vehicle.drag[0] > 0.0 {
        found.push(changed(Easier::NoDrag, &|m| m.vehicle.drag = [0.0; 3]));
        let turned = |m: &mut Model| {
            let air = &mut m.mission.as_mut().expect("a mission").air;
            air.wind = air.wind.map(|w| -w);
        };
        found.push(changed(Easier::OtherWind, &turned));
    }
    if model.environment().is_uncertain() {
        found.push(changed(Easier::OneWind, &|m| m.mission.as_mut().expect("a mission").air.wind_spread = [0.0; 3]));
    }
    if vehicle.rotors.iter().any(|r| r.min_speed > 0.0) {
        found.push(changed(Easier::StoppingRotors, &|m| m.vehicle.rotors.iter_mut().for_each(|r| r.min_speed = 0.0)));
    }
    found
}
