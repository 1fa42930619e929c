//! Decides families of ways out after faults: from every state in which a fault may become known, a motion inside the
//! fault mode's set and within the limits after a fault, to a place to land or back to the plan.
//!
//! Each family is covered by cells of its two dimensions, the instant of the fault and the delay until it is known. For
//! a cell and a part of time, all its motions are enclosed at once (`tube`); what does not fit is bisected.
//! docs/certificates.md states what is shown as a theorem.

mod cover;
mod response;
mod start;
mod tube;
mod way;

use super::cost::WorkLeft;
use super::interval::exceeds;
use super::motion::Motion;
use super::plan::{Setting, upright, wrench_family};
use super::premise::Premise;
use super::proof::{Family, throughout};
use super::sets::Plane;
use super::wrench::Held;
use super::{Rejection, joints, limits};
use crate::certificate::{DynamicModel, FamilyRecord, MAX_BRANCH_NODES, RecoveryClaim, StateTolerance};
use crate::model::{HeldLimit, LimitKind};
use crate::number::number;
use crate::tolerance::{MOST_MISS, MOST_OUTSIDE, MOST_PAST_LIMIT};
use cover::{Cover, FamilyRow};
use start::StartAbout;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;
use tube::Tube;
use way::Way;

pub use cover::Missed;

/// What families are decided against: a spec, and the plan from which they branch.
pub struct Recovering<'s, 'a> {
    setting: &'s Setting<'a>,
    plan: &'s Motion,
    limits: Vec<HeldLimit>,
    modes: BTreeMap<String, OfMode>,
}

/// The part of a decision that the families of a mode share.
struct OfMode {
    /// An index into the model's modes.
    mode: usize,
    planes: Arc<[Plane]>,
    /// From when on the plan is inside the mode's set, s.
    inside_from: f64,
    /// Until when the families so far decide about faults, s.
    until: f64,
    /// The instants for which only delays up to some are decided, and these, s.
    open: Option<([f64; 2], f64)>,
    /// What the families so far show.
    covered: Covered,
}

/// What the families of a mode show.
#[derive(Debug, Clone, PartialEq)]
pub struct Covered {
    pub mode: String,
    /// From and to which instant a fault has a way out after every delay, from every state within the tolerances, s
    /// since the start of the plan; in the order of time.
    pub instants: Vec<[f64; 2]>,
    /// For how long that is, s.
    pub seconds: f64,
    /// The largest tolerances.
    pub tolerance: StateTolerance,
}

impl OfMode {
    /// Takes a family as the next one.
    ///
    /// # Errors
    /// It does not continue the ones before it.
    fn goes_on(&mut self, record: &FamilyRecord, setting: &Setting, plan: &Motion) -> Result<(), String> {
        let FamilyRecord { from_s, to_s, delays_s: [least, most], .. } = *record;
        let [first, last] = setting.model().plan.recovery.detection;
        let follows = match self.open {
            Some((instants, reached)) => instants == [from_s, to_s] && reached == least,
            None => self.until <= from_s && least == first,
        };
        let ordered = from_s < to_s && (least < most || first == last && least == most);
        let inside = 0.0 <= from_s && to_s <= plan.times[plan.pieces()] && most <= last;
        if setting.premises.has(Premise::WayFollows) && !(follows && ordered && inside) {
            return Err(
                "its instants or delays do not follow those of the family before it, or are not the spec's".into()
            );
        }
        self.open = (most < last).then_some(([from_s, to_s], most));
        self.covered.tolerance = self.covered.tolerance.largest(&record.tolerance);
        if self.open.is_none() {
            self.covered.instants.push([from_s, to_s]);
            self.covered.seconds += to_s - from_s;
            self.until = to_s;
        }
        Ok(())
    }
}

impl<'s, 'a> Recovering<'s, 'a> {
    /// Families that branch from `plan`, a plan of the spec.
    pub fn new(setting: &'s Setting<'a>, plan: &'s Motion) -> Self {
        let limits = setting.mission().limits_after_fault();
        Recovering { setting, plan, limits, modes: BTreeMap::new() }
    }

    /// The branches of a claim.
    ///
    /// # Errors
    /// One is malformed, or its pieces do not join.
    pub fn branches(&self, claim: &RecoveryClaim) -> Result<Vec<Motion>, Rejection> {
        let each = claim.branches.iter().enumerate().map(|(index, record)| {
            let name = format!("branch {index}");
            let named = |why: String| Rejection::new(name.clone(), why);
            if record.nodes() > MAX_BRANCH_NODES {
                return Err(named(format!("{} nodes are more than {MAX_BRANCH_NODES}", record.nodes())));
            }
            let motion = self.setting.motion(record).map_err(|why| named(why.detail))?;
            if self.setting.premises.has(Premise::Joints) {
                joints::check(&motion).map_err(|why| named(why.detail))?;
            }
            Ok(motion)
        });
        each.collect()
    }

    /// Decides all families of a claim, as far as `purse` allows: what each mode's show.
    ///
    /// # Errors
    /// Something that is not shown.
    pub fn decide_all(mut self, claim: &RecoveryClaim, purse: &mut WorkLeft) -> Result<Vec<Covered>, Rejection> {
        let branches = self.branches(claim)?;
        for record in &claim.families {
            match self.decide(record, &branches, purse) {
                Err(_) if purse.0 == 0 => break,
                decided => decided?,
            }
        }
        if purse.0 > 0 && self.setting.premises.has(Premise::WayFollows) {
            self.ends()?;
        }
        let each = self.modes.into_values().map(|of_mode| of_mode.covered);
        Ok(each.filter(|covered| covered.seconds > 0.0).collect())
    }

    /// Decides a family, which has to begin where the one before it in the same mode ended, or later.
    ///
    /// # Errors
    /// Something that is not shown.
    pub fn decide(
        &mut self,
        record: &FamilyRecord,
        branches: &[Motion],
        purse: &mut WorkLeft,
    ) -> Result<(), Rejection> {
        let named = |why: String| Rejection::new(name_of(record), why);
        let corners = record.corners.map(|index| branches.get(index));
        let [Some(a), Some(b), Some(c), Some(d)] = corners else {
            return Err(named(format!("it names a branch that is not among the {}", branches.len())));
        };
        self.family(record, [a, b, c, d], purse)?.map_err(|missed| {
            let Missed { row, at, value } = missed;
            let [at, low, high] = [at, value.low, value.high].map(number);
            named(format!("{row}: {at} s after the fault is known, the violation is only bounded by {low} and {high}"))
        })?;
        match self.modes.get_mut(&record.mode) {
            Some(of_mode) => of_mode.goes_on(record, self.setting, self.plan).map_err(named),
            None => Ok(()),
        }
    }

    /// Checks that all delays are decided, after the last family.
    ///
    /// # Errors
    /// A delay is missing.
    pub fn ends(&self) -> Result<(), Rejection> {
        match self.modes.iter().find_map(|(name, of_mode)| Some((name, of_mode.open?))) {
            Some((name, ([from, to], delay))) => {
                let [from, to, delay] = [from, to, delay].map(number);
                let why = format!("between {from} and {to} s no delay above {delay} s is decided");
                Err(Rejection::new(format!("the ways out after {name}"), why))
            }
            None => Ok(()),
        }
    }

    /// Whether all motions of a family with these branches hold what it claims.
    ///
    /// # Errors
    /// Something that does not hold whatever the size of the family.
    pub fn family(
        &mut self,
        record: &FamilyRecord,
        corners: [&Motion; 4],
        purse: &mut WorkLeft,
    ) -> Result<Result<(), Missed>, Rejection> {
        if !self.modes.contains_key(&record.mode) {
            let of_mode = self.of_mode(&record.mode, purse)?;
            self.modes.insert(record.mode.clone(), of_mode);
        }
        self.holds(record, corners, purse)
    }

    /// The planes of a mode's set, and from when on the plan is inside of it.
    fn of_mode(&self, name: &str, purse: &mut WorkLeft) -> Result<OfMode, Rejection> {
        let model = self.setting.model();
        let Some(mode) = model.modes.iter().position(|mode| mode.name == name) else {
            return Err(Rejection::new("the ways out", format!("the spec has no fault mode {name}")));
        };
        let planes = match self.setting.planes_of(name)? {
            Ok(planes) => planes,
            Err(why) => return Err(Rejection::new(format!("the ways out after {name}"), why)),
        };
        let pieces = self.plan.pieces();
        let is_inside = |piece: &usize| {
            self.setting.held().into_iter().all(|held| {
                let all = wrench_family(self.setting.dynamics(), held, planes.iter().collect());
                let family = Family { within: Some((*piece, *piece + 1)), ..all };
                throughout(&family, self.plan, MOST_OUTSIDE, purse).is_proved()
            })
        };
        let inside = (0..pieces).rev().take_while(is_inside).count();
        let inside_from = if inside > 0 { self.plan.times[pieces - inside] } else { f64::INFINITY };
        let covered =
            Covered { mode: name.into(), instants: Vec::new(), seconds: 0.0, tolerance: StateTolerance::default() };
        Ok(OfMode { mode, inside_from, planes, until: 0.0, open: None, covered })
    }

    /// Whether a family, whose mode was looked at, has all motions that it claims.
    ///
    /// # Errors
    /// Something that does not hold whatever the size of the family.
    fn holds(
        &self,
        record: &FamilyRecord,
        corners: [&Motion; 4],
        purse: &mut WorkLeft,
    ) -> Result<Result<(), Missed>, Rejection> {
        let named = |why: String| Rejection::new(name_of(record), why);
        let setting = self.setting;
        let model = setting.model();
        let of_mode = &self.modes[&record.mode];
        if !setting.dynamics().environment.turns_alike() {
            return Err(named("families are not decided where the drag differs along x and y".into()));
        }
        let way = Way::of(record, model, setting.mission(), of_mode.mode).map_err(named)?;
        let tube = Tube::new(corners, record.delays_s[0] == record.delays_s[1]).map_err(named)?;
        let within = model.plan.recovery.within;
        if setting.premises.has(Premise::WayTime) && exceeds(tube.duration(), within + MOST_MISS) {
            let took = number(tube.duration());
            return Err(named(format!("its motions take {took} s; {} s are allowed", number(within))));
        }
        let start = StartAbout::new(record, setting).map_err(named)?;
        if setting.premises.has(Premise::WayStart) {
            start.near_the_plan(corners, self.plan).map_err(named)?;
        }
        let mut own = Vec::new();
        match &way {
            _ if !setting.premises.has(Premise::WayEnd) => {}
            Way::Back => self.joins(record, of_mode, &start, &tube).map_err(named)?,
            Way::Down(place) => {
                place.reached_by(corners).map_err(named)?;
                own = place.limits(&tube);
            }
        }
        let mut rows = self.rows(of_mode, &way, &tube, &own);
        if !setting.premises.has(Premise::WayRows) {
            rows.drain(..rows.len() - own.len());
        }
        Ok(Cover {
            tube: &tube,
            rows: &rows,
            start: &start,
            way: &way,
            plan: self.plan,
            dynamics: setting.dynamics(),
            purse,
        }
        .all())
    }

    /// Whether the motions of a family return where the plan is inside the mode's set, or at rest after its end.
    ///
    /// # Errors
    /// They return too early, or to no state of the plan.
    fn joins(&self, record: &FamilyRecord, of_mode: &OfMode, start: &StartAbout, tube: &Tube) -> Result<(), String> {
        let [first, last] = [(record.from_s, start.delays[0]), (record.to_s, start.delays[1])]
            .map(|(at, delay)| at + delay + tube.duration());
        if exceeds(of_mode.inside_from, first) {
            let (joins, inside) = (number(first), number(of_mode.inside_from));
            return Err(format!(
                "it joins the plan at {joins} s, but only from {inside} s on the plan is shown to stay inside the set \
                 of {}",
                record.mode
            ));
        }
        let end = self.plan.pieces();
        let moving =
            |axis: usize| (1..self.plan.order(axis).min(4)).any(|order| self.plan.at_node(end, axis, order) != 0.0);
        match exceeds(last, self.plan.times[end]) && (0..4).any(moving) {
            true => Err("it joins the plan after its end, where the plan is not at rest".into()),
            false => Ok(()),
        }
    }

    /// What has to hold along the motions of a family.
    fn rows<'r>(
        &'r self,
        of_mode: &'r OfMode,
        way: &Way,
        tube: &Tube,
        own: &'r [(HeldLimit, Range<usize>)],
    ) -> Vec<FamilyRow<'r>> {
        let setting = self.setting;
        let environment = &setting.dynamics().environment;
        let all = 0..tube.branch().pieces();
        let mut rows = Vec::new();
        for held in setting.held() {
            let family = wrench_family(setting.dynamics(), held, of_mode.planes.iter().collect());
            let name = if held == Held::Wrench { "the set" } else { "the set by the commands" };
            let planes = (!setting.dynamics().is_in_winds()).then_some((held, &*of_mode.planes));
            rows.push(FamilyRow {
                name: name.into(),
                family,
                planes,
                pieces: all.clone(),
                held: None,
                most: MOST_OUTSIDE,
            });
        }
        if setting.dynamics().model == DynamicModel::Exact {
            let (name, family) = ("the upright thrust".into(), upright(environment));
            rows.push(FamilyRow { name, family, pieces: all.clone(), planes: None, held: None, most: MOST_PAST_LIMIT });
        }
        for held in &self.limits {
            // A vehicle that lands may be lower than one that does not.
            let upper_only = matches!(way, Way::Down(_)) && held.limit.kind == LimitKind::Z;
            if upper_only && held.limit.upper.is_none() {
                continue;
            }
            let both = limits::family(&held.limit, environment, None);
            let family = if upper_only { both.only(&[0]) } else { both };
            let (name, most) = (held.limit.name().to_string(), MOST_PAST_LIMIT * held.limit.size());
            rows.push(FamilyRow { name, family, pieces: all.clone(), planes: None, held: Some(held), most });
        }
        for (held, pieces) in own {
            let name = format!("the landing ({})", held.limit.name());
            let family = limits::family(&held.limit, environment, None);
            let most = MOST_PAST_LIMIT * held.limit.size();
            rows.push(FamilyRow { name, family, pieces: pieces.clone(), planes: None, held: Some(held), most });
        }
        rows
    }
}

/// How messages name a family.
fn name_of(record: &FamilyRecord) -> String {
    format!("the ways out after {} between {} and {} s", record.mode, number(record.from_s), number(record.to_s))
}
