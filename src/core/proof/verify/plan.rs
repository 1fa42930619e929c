//! Decides whether a motion is a plan of the spec. The conditions are derived from the spec; from the certificate only
//! the motion is used, and for RSP the motions from which it selects facets.

mod along;
mod cores;
mod estimate;
mod selection;
mod waypoints;

use super::core::{Core, WithoutYaw};
use super::cost::{Budget, WorkLeft};
use super::most_thrust::most_thrust;
use super::motion::Motion;
use super::premise::{Premise, Premises};
use super::proof::Family;
use super::recovery::{Covered, Recovering};
use super::sets::{HEALTHY, Plane, Sets};
use super::wrench::{Dynamics, Held};
use super::{Refusal, Rejection, Shown, joints, lag, required, required_whole, schedule};
use crate::certificate::{DynamicModel, MotionRecord, PlanClaim, RecoveryClaim};
use crate::model::{Mission, Model, PlannerKind, Problem};
use crate::number::significant;
use crate::source::Span;
use std::sync::{Arc, OnceLock};

pub use crate::tolerance::{LEAST_PRODUCT, MOST_MISS, MOST_OUTSIDE, MOST_PAST_LIMIT, UPRIGHT};
use selection::Selecting;

pub(super) use along::upright;
pub use along::{POINTS_OF_A_GRID, wrench_family};

/// A motion that passed all checks at the nodes, with the rows to check between them.
struct Checked<'m> {
    motion: Motion,
    /// Whole sets, and under RSP the selected facets.
    groups: Vec<Group>,
    /// The modes without yaw, and the rows of their cores that are imposed.
    cores: Vec<ImposedCore>,
    /// Sets that the checker cannot compute, and why.
    undecided: Vec<String>,
    /// Remarks on the selection.
    selection: Vec<String>,
    coarser_legs: usize,
    /// For RSP which planes and which rows of cores the motion violates, if that was needed.
    violates: OnceLock<Vec<bool>>,
    of_cores: OnceLock<Vec<Vec<bool>>>,
    setting: &'m Setting<'m>,
}

/// Planes that belong to one statement.
#[derive(Debug, Clone)]
struct Group {
    /// `healthy`, or a mode.
    mode: String,
    /// Whether these are all planes of the set; otherwise selected facets.
    whole: bool,
    span: Option<Span>,
    planes: Arc<[Plane]>,
}

/// A core with the members of its family that are imposed: all, or under RSP those that it selects.
struct ImposedCore {
    core: Core,
    members: Vec<usize>,
    whole: bool,
}

/// The spec, equations and premises of a decision.
pub struct Setting<'a> {
    pub(super) problem: Problem<'a>,
    dynamics: Dynamics<'a>,
    /// The commanded wrench, if rotors lag.
    commands: Option<Held>,
    pub(super) premises: Premises,
    pub(super) sets: Sets<'a>,
}

/// The role of a plan, which determines its rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Role {
    /// The plan of the spec's planner.
    Claimed,
    /// A plan from which RSP selects facets; it stays in the healthy set.
    SelectedBy,
}

impl<'a> Setting<'a> {
    /// The setting for a spec and the equations of a certificate.
    pub fn new(problem: Problem<'a>, kind: DynamicModel, premises: Premises) -> Self {
        let (model, mission) = (problem.model(), problem.mission());
        let first = mission.waypoints.first().map_or(0.0, |w| w.yaw);
        // The language defines that with one yaw throughout the model is linearised there.
        let one_yaw = mission.waypoints.iter().all(|w| (w.yaw - first).abs() < 1e-12).then_some(first);
        let dynamics = Dynamics { vehicle: &model.vehicle, environment: model.environment(), model: kind, one_yaw };
        let commands = lag::constant(model).map(|tau| Held::Commands { tau });
        Setting { problem, dynamics, commands, premises, sets: Sets::new(model) }
    }

    /// The model of the spec.
    pub(super) fn model(&self) -> &'a Model {
        self.problem.model()
    }

    /// The mission of the spec.
    pub fn mission(&self) -> &'a Mission {
        self.problem.mission()
    }

    /// The equations that give the wrench of a motion.
    pub fn dynamics(&self) -> &Dynamics<'a> {
        &self.dynamics
    }

    /// The commanded wrench, if rotors lag.
    pub fn commands(&self) -> Option<Held> {
        self.commands
    }

    /// The motion of a record.
    ///
    /// # Errors
    /// The record is malformed.
    pub fn motion(&self, record: &MotionRecord) -> Result<Motion, Rejection> {
        let strict = self.premises.has(Premise::Shape);
        Motion::new(record, self.dynamics.model, strict).map_err(|why| Rejection::new("the motion", why))
    }

    /// Decides whether the motion is a plan: all conditions at the nodes and, as far as `budget` allows, between them.
    pub(super) fn decide(&self, claim: &PlanClaim, budget: Budget, between: bool) -> Result<Found, Refusal> {
        let mut estimate = self.estimate(claim)?;
        if !estimate.fits(budget) {
            return Err(Refusal::Budget { estimate, budget });
        }
        let without_yaw = WithoutYaw::of(&self.sets, &claim.without_yaw, self.premises)?;
        let of_cores = self.estimate_of_cores(claim, &without_yaw)?;
        estimate.add(of_cores.units, of_cores.bytes);
        if !estimate.fits(budget) {
            return Err(Refusal::Budget { estimate, budget });
        }
        let selected_by = match self.premises.has(Premise::SelectedBy) {
            true => self.selections(claim, &without_yaw)?,
            false => self.unchecked(&claim.selected_by)?,
        };
        let checked = self.at_nodes(&claim.motion, &selected_by, Role::Claimed, &without_yaw)?;
        let mut purse = WorkLeft(budget.units().saturating_sub(estimate.units));
        let mut found = checked.found();
        match between {
            true => checked.check_between(&mut purse, &mut found),
            false => checked.nodes_only(&mut found),
        }
        if let Some(recovery) = &claim.recovery
            && between
        {
            self.recovery(&checked.motion, recovery, &mut purse, &mut found)?;
        }
        Ok(found)
    }

    /// Decides the ways out of a claim.
    fn recovery(
        &self,
        plan: &Motion,
        claim: &RecoveryClaim,
        purse: &mut WorkLeft,
        found: &mut Found,
    ) -> Result<(), Rejection> {
        let (recovering, before) = (Recovering::new(self, plan), purse.0);
        for covered in recovering.decide_all(claim, purse)? {
            let Covered { mode, seconds, tolerance, .. } = &covered;
            let [seconds, total] = [*seconds, found.total].map(|s| significant(s, 4));
            let of = [tolerance.position_m, tolerance.velocity_m_s].map(|t| significant(t, 2));
            let turned = [tolerance.tilt_rad, tolerance.turning_rad_s].map(|t| significant(t.to_degrees(), 2));
            let statement = format!(
                "after {mode}, for {seconds} of {total} s: a way out from every state within {} m, {} m/s, {} deg and \
                 {} deg/s of the expected one",
                of[0], of[1], turned[0], turned[1]
            );
            found.shown.push(Shown { statement, reach: None });
            found.ways_out.push(covered);
        }
        if purse.0 == 0 && before > 0 {
            found
                .weaker
                .push("the budget ended before every way out was decided; a larger `--budget` may show more".into());
        }
        Ok(())
    }

    /// Checks all conditions at the nodes of one motion.
    fn at_nodes(
        &self,
        record: &MotionRecord,
        selected_by: &[Selecting],
        role: Role,
        without_yaw: &WithoutYaw,
    ) -> Result<Checked<'_>, Rejection> {
        let mut motion = self.motion(record)?;
        let coarser = schedule::check(self.problem, &mut motion, self.premises)?;
        if self.premises.has(Premise::Joints) {
            joints::check(&motion)?;
        }
        if self.premises.has(Premise::Rest) {
            self.rest(&motion)?;
        }
        if self.premises.has(Premise::Waypoints) {
            self.waypoints(&motion)?;
        }
        self.limits_at_nodes(&motion)?;
        if self.premises.has(Premise::Upright) {
            self.upright_at_nodes(&motion)?;
        }
        let (mut groups, undecided) = self.sets(role, without_yaw)?;
        self.inside_at_nodes(&motion, &groups)?;
        let mut remarks = Vec::new();
        let selecting = Selecting::from(motion);
        if self.premises.has(Premise::Selection) {
            let selected = self.select(&selecting, selected_by, without_yaw)?;
            groups.extend(selected.groups);
            remarks = selected.remarks;
        }
        let Selecting { motion, violates, of_cores } = selecting;
        // A plan to select from keeps the rows that the plans before it select.
        let cores = self.imposed_cores(&motion, selected_by, without_yaw)?;
        if role == Role::Claimed && !without_yaw.caught.is_empty() {
            let modes = without_yaw.caught.join(", ");
            remarks.push(format!(
                "no row provides for {modes}: the vehicle is caught by its spin and landed, which no certificate shows"
            ));
        }
        let coarser_legs = coarser.legs;
        let selection = remarks;
        Ok(Checked { motion, groups, cores, undecided, selection, coarser_legs, violates, of_cores, setting: self })
    }

    /// The sets that the planner imposes whole, and those that cannot be computed.
    fn sets(&self, role: Role, without_yaw: &WithoutYaw) -> Result<(Vec<Group>, Vec<String>), Rejection> {
        let (mut groups, mut undecided) = (Vec::new(), Vec::new());
        let mut modes = match role {
            Role::Claimed => required(self.model()),
            Role::SelectedBy => vec![HEALTHY.into()],
        };
        // Cores leave the yaw torque free, which until the fault is that of the healthy vehicle.
        if modes.iter().any(|mode| without_yaw.frees(mode)) {
            modes.retain(|mode| mode != HEALTHY && !without_yaw.frees(mode));
            modes.insert(0, HEALTHY.into());
        }
        for mode in modes {
            let span = self.span_of(&mode);
            match self.planes_of(&mode)? {
                Ok(planes) => groups.push(Group { mode, whole: true, span, planes }),
                Err(why) => undecided.push(format!("the set of {mode}: {why}")),
            }
        }
        // In place of a set that cannot be computed at least the healthy one, in which the vehicle is until the fault.
        let has_healthy = groups.iter().any(|group| group.mode == HEALTHY);
        if !undecided.is_empty()
            && !has_healthy
            && let Ok(planes) = self.planes_of(HEALTHY)?
        {
            groups.push(Group { mode: HEALTHY.into(), whole: true, span: None, planes });
        }
        Ok((groups, undecided))
    }

    /// Every plane that bounds a mode's set, shrunk by the reserve; or why they are not known.
    ///
    /// # Errors
    /// The spec has no such mode, or requires a reserve of a set that does not contain hover.
    pub(super) fn planes_of(&self, mode: &str) -> Result<Result<Arc<[Plane]>, String>, Rejection> {
        let planes = self.sets.planes(mode)?;
        let outside = |planes: &Arc<[Plane]>| planes.iter().any(Plane::excludes_hover);
        match self.reserves() && planes.as_ref().is_ok_and(outside) {
            true => Err(self.reserve_about_nothing(mode)),
            false => Ok(planes),
        }
    }

    /// Whether the spec requires a reserve.
    fn reserves(&self) -> bool {
        self.premises.has(Premise::Reserve) && self.model().plan.reserve > 0.0
    }

    /// The rejection where hover, about which a reserve is taken, lies outside a mode's set.
    fn reserve_about_nothing(&self, mode: &str) -> Rejection {
        let why = format!(
            "it is a share of the way from hover to the boundary of the set of {mode}, but hover lies outside that set"
        );
        Rejection { span: Some(self.model().plan.reserve_span), ..Rejection::new("the reserve", why) }
    }

    /// Checks that hover lies in every set that a reserve shrinks.
    ///
    /// # Errors
    /// It lies outside of one.
    pub(super) fn reserve_has_hover(&self) -> Result<(), Rejection> {
        let modes = if self.reserves() { required_whole(&self.sets) } else { Vec::new() };
        modes.iter().try_for_each(|mode| self.planes_of(mode).map(drop))
    }

    fn span_of(&self, mode: &str) -> Option<Span> {
        self.sets.mode(mode).map(|m| m.span)
    }
}

/// The result for a plan.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Found {
    pub shown: Vec<Shown>,
    pub weaker: Vec<String>,
    /// Sets that could not be decided.
    pub undecided: Vec<String>,
    /// For each mode with ways out that are shown.
    pub ways_out: Vec<Covered>,
    /// Mission time, s.
    pub total: f64,
    /// An upper bound on the thrust of every motion inside the sets, N.
    pub most_thrust: f64,
}

impl Checked<'_> {
    /// The result of the checks at the nodes.
    fn found(&self) -> Found {
        let mission = self.setting.mission();
        let shown = vec![
            Shown::at_nodes(format!("{} pieces join", self.motion.pieces())),
            Shown::at_nodes(format!("{} waypoints met, and rest where the spec requires it", mission.waypoints.len())),
        ];
        let mut weaker = Vec::new();
        if self.coarser_legs > 0 {
            weaker.push(format!(
                "fewer pieces than the spec's {} samples give, on {} of {} legs",
                self.setting.model().plan.samples,
                self.coarser_legs,
                mission.legs.len()
            ));
        }
        weaker.extend(self.undecided.iter().map(|what| format!("not decided: {what}")));
        weaker.extend(self.selection.iter().cloned());
        if self.setting.model().plan.require_risk.is_some() && self.setting.model().plan.planner == PlannerKind::Rsp {
            weaker.push(
                "`require risk` is not checked: a certificate does not contain the protection of the plan".into(),
            );
        }
        if self.setting.model().plan.recovery.require.is_some() {
            weaker.push("`require uncovered` is not checked: a certificate need not contain every way out".into());
        }
        let total = self.motion.times[self.motion.times.len() - 1];
        let undecided = self.undecided.clone();
        Found { shown, weaker, undecided, ways_out: Vec::new(), total, most_thrust: self.most_thrust() }
    }
}

impl Checked<'_> {
    /// An upper bound on the thrust of every motion inside the sets, N.
    fn most_thrust(&self) -> f64 {
        let Ok(healthy) = self.setting.sets.generators(HEALTHY) else { return f64::INFINITY };
        // Far more than the tolerance on sets adds.
        let sizes = healthy.extent().map(|extent| 2.0 * extent.magnitude());
        most_thrust(&all_planes(&self.groups), sizes)
    }
}

/// The planes of all groups, in order.
fn all_planes(groups: &[Group]) -> Vec<&Plane> {
    groups.iter().flat_map(|group| group.planes.iter()).collect()
}

/// Whether rows on the wrench are linear over each piece.
fn is_linear(dynamics: &Dynamics) -> bool {
    dynamics.model == DynamicModel::Hover && dynamics.one_yaw.is_some()
}

/// The family of rows on `held` for planes listed by group.
fn of_groups<'a: 'f, 'f>(setting: &Setting<'a>, held: Held, planes: Vec<&'f Plane>) -> Family<'f> {
    Family { overhead: setting.overhead(), ..wrench_family(&setting.dynamics, held, planes) }
}
