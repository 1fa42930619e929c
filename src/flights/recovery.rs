//! What can be done after a fault, at each of many instants of a plan and for each fault mode: fly on, land at a site,
//! land at once, or nothing that was found.
//!
//! The vehicle is carried through the delay until the fault is known ([`carry`]); from there a branch is sought inside
//! the mode's set and within the limits that hold after a fault ([`crate::planner::branch`]). What is found holds at
//! the instants that were looked at; between them nothing is claimed.

pub mod carry;
mod caught;
pub mod flown;
pub mod replanning;
mod search;

use crate::admissible::AdmissibleSet;
use crate::admissible::without_yaw::planned::Provision;
use crate::cancel;
use crate::certificate::{FamilyRecord, MotionRecord, RecoveryClaim};
use crate::flight::WayOut;
use crate::model::{Model, Problem};
use crate::motion::Trajectory;
use crate::planner::selection::PlanningSet;
use crate::planner::selection::sets::of_one_mode;
use crate::solve::Effort;
use rayon::prelude::*;
use replanning::{Change, Longer};
use search::{Found, Search, SoughtMode};
use std::collections::BTreeMap;

/// A way out after a fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// Back to the plan, and along it to its end.
    Continue,
    /// Back to the plan and along it to its end, with yaw given up.
    ContinueSpinning,
    /// Down at a landing site, an index into the mission's sites.
    LandAt(usize),
    /// Down near the place of the fault.
    LandHere,
    /// Caught by its spin and down where that leads, in simulated flights: no branch.
    Caught,
}

/// A branch that was found.
#[derive(Debug, Clone)]
pub struct FoundBranch {
    /// The mode, an index into the model's.
    pub mode: usize,
    pub way: Way,
    /// When the fault strikes, s since the start of the plan.
    pub fault_at: f64,
    /// When the branch begins, s after the fault.
    pub delay: f64,
    /// From the state at the end of the delay, at 0 s, to its end: at rest on the ground, or where it joins the plan.
    pub motion: Trajectory,
    /// The largest distance from the plan during the delay, m.
    pub deviation: f64,
}

/// A time during which a fault has the same outcome at each instant that was looked at.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// s since the start of the plan.
    pub from: f64,
    pub to: f64,
    /// `None` where no way out was found.
    pub way: Option<Way>,
    /// The branches at the instants of the piece, for the longest delay, as indices into [`Recovery::branches`].
    pub branches: Vec<usize>,
    /// Of a gap: a landing site that is reached from its middle in more time than is allowed.
    pub near_miss: Option<NearMiss>,
}

/// A landing that takes too long.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearMiss {
    /// An index into the mission's landing sites.
    pub site: usize,
    /// When the fault strikes, s since the start of the plan.
    pub at: f64,
    /// The time from the fault's detection to the touchdown in which a landing was found, s.
    pub takes: f64,
}

/// The outcomes of the faults of one mode.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeRecovery {
    /// An index into the model's modes.
    pub mode: usize,
    /// Why no way out was sought, if none was.
    pub not_attempted: Option<NotAttempted>,
    /// In the order of time; each begins where the one before ends.
    pub pieces: Vec<Piece>,
    /// The number of instants that were looked at.
    pub instants: usize,
    /// What is shown between these instants, if that was sought.
    pub families: Option<Families>,
}

/// Families of branches of one mode.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Families {
    /// Those that the checker of certificates accepts, in the order of time.
    pub proved: Vec<FamilyRecord>,
    /// The branches that they refer to.
    pub branches: Vec<MotionRecord>,
    /// The longest time between two instants with a way out for which no family was found, with the reason.
    pub not_proved: Option<NotProved>,
}

/// A time for which no family was found.
#[derive(Debug, Clone, PartialEq)]
pub struct NotProved {
    /// s since the start of the plan.
    pub from: f64,
    pub to: f64,
    pub why: String,
}

impl Families {
    /// For how long every fault has a way out that is shown, s.
    pub fn proved_s(&self) -> f64 {
        // Those of the same instants, for several delays, count once.
        let mut instants: Vec<[f64; 2]> = self.proved.iter().map(|family| [family.from_s, family.to_s]).collect();
        instants.dedup();
        instants.iter().map(|[from, to]| to - from).sum()
    }
}

/// Why no way out was sought.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NotAttempted {
    /// Hover is outside the mode's set, or inside without a margin.
    NoHover,
    /// It has to be caught, and the spec has no ground or no landing among the ways out.
    Caught,
}

impl NotAttempted {
    /// The word in reports.
    pub fn word(self) -> &'static str {
        match self {
            NotAttempted::NoHover => "no hover",
            NotAttempted::Caught => "caught",
        }
    }
}

/// What can be done after each fault.
#[derive(Debug, Clone)]
pub struct Recovery {
    /// Of every declared mode, in their order.
    pub modes: Vec<ModeRecovery>,
    pub branches: Vec<FoundBranch>,
    /// The delays after which faults are known, s: one, or the shortest and the longest.
    pub delays: Vec<f64>,
    /// The longest time of a branch, s.
    pub within: f64,
    /// The duration of the plan, s.
    pub duration: f64,
    /// The branches that do not end as planned in simulated flights, one each; indices into `branches`, ascending.
    pub failed: Vec<usize>,
    pub effort: Effort,
    /// If the plan was planned again for ways out, how.
    pub change: Option<Change>,
    /// If the spec fixes the time and requires more than was found, a longer time that was tried.
    pub longer: Option<Longer>,
}

/// Instants are at most this far apart, s, in plans up to [`FINE`] instants long. Chosen by hand.
const APART: f64 = 0.5;

/// The number of instants that are looked at first in long plans. Chosen by hand.
const FINE: f64 = 160.0;

/// How many steps the instants that are looked at first divide a plan of this duration (s) into.
pub fn steps(duration: f64) -> f64 {
    (duration / APART).ceil().clamp(1.0, FINE)
}

/// How far these instants are apart, s.
pub fn apart(duration: f64) -> f64 {
    duration / steps(duration)
}

/// The times at which gaps begin and end are bisected to this, s.
pub const RESOLUTION: f64 = 0.05;

/// Looks for ways out after every declared fault, along a plan: at instants, and with `between` for families of them.
pub fn recovery(problem: Problem, plan: &Trajectory, between: bool) -> Recovery {
    let model = problem.model();
    let settings = &model.plan.recovery;
    let healthy = AdmissibleSet::healthy(model);
    let [least, most] = settings.detection;
    let delays = if least < most { vec![least, most] } else { vec![most] };
    let modes = 0..model.modes.len();
    let sets: Vec<_> = modes.clone().into_par_iter().map(|mode| of_one_mode(model, mode, &healthy)).collect();
    let none = |mode: usize, not_attempted: Option<NotAttempted>| {
        let piece = Piece { from: 0.0, to: plan.duration(), way: None, branches: Vec::new(), near_miss: None };
        let families = between.then(Families::default);
        ModeRecovery { mode, not_attempted, pieces: vec![piece], instants: 0, families }
    };
    let why_none = |mode: usize| why_none(model, mode, &sets[mode].0, &sets[mode].1);
    let why: Vec<Option<NotAttempted>> = modes.clone().map(why_none).collect();
    let look = |mode: usize| {
        cancel::checkpoint();
        let (set, provision) = &sets[mode];
        if why[mode].is_some() || *provision == Provision::Capture {
            return (None, Vec::new());
        }
        let mut search = Search::new(problem, plan, SoughtMode { mode, set, provision }, &healthy, &delays, between);
        let found = search.all();
        (Some(search), found)
    };
    let (searches, outcomes): (Vec<_>, Vec<_>) = modes.clone().into_par_iter().map(look).unzip();
    // Gaps are looked at again when all modes are known: they lend each other their branches.
    let again: Vec<_> = searches
        .into_par_iter()
        .enumerate()
        .map(|(mode, search)| {
            let mut search = search?;
            let others: Vec<&[Found]> = modes.clone().filter(|m| *m != mode).map(|m| &outcomes[m][..]).collect();
            let fresh = search.again(&outcomes[mode], &others);
            Some((search, fresh))
        })
        .collect();
    let each: Vec<_> = again
        .into_par_iter()
        .zip(outcomes)
        .enumerate()
        .map(|(mode, (search, found))| match (search, why[mode]) {
            (Some((search, fresh)), _) => search.result(found, fresh),
            (None, Some(why)) => (none(mode, Some(why)), Vec::new(), Effort::default()),
            (None, None) => {
                let caught = caught::caught(problem, plan, mode, &delays);
                (ModeRecovery { families: between.then(Families::default), ..caught }, Vec::new(), Effort::default())
            }
        })
        .collect();
    let mut found = Recovery {
        modes: Vec::new(),
        branches: Vec::new(),
        within: settings.within,
        duration: plan.duration(),
        failed: Vec::new(),
        effort: Effort::default(),
        delays: delays.clone(),
        change: None,
        longer: None,
    };
    for (mut mode, branches, effort) in each {
        let before = found.branches.len();
        mode.pieces.iter_mut().flat_map(|piece| &mut piece.branches).for_each(|branch| *branch += before);
        found.branches.extend(branches);
        found.modes.push(mode);
        found.effort += effort;
    }
    found.failed = flown::failures(model, plan, &found);
    found
}

/// Why no way out is sought after the faults of a mode, if none is.
pub fn not_attempted(model: &Model, mode: usize) -> Option<NotAttempted> {
    let (set, provision) = of_one_mode(model, mode, &AdmissibleSet::healthy(model));
    why_none(model, mode, &set, &provision)
}

fn why_none(model: &Model, mode: usize, set: &PlanningSet, provision: &Provision) -> Option<NotAttempted> {
    match provision {
        Provision::Capture => (!caught::may_land(model, mode)).then_some(NotAttempted::Caught),
        Provision::WithYaw | Provision::WithoutYaw(_) => {
            search::cannot_hover(model, set).then_some(NotAttempted::NoHover)
        }
    }
}

/// The first way out, in the order of the spec, after the fault of one mode that strikes at `at` s of a plan and is
/// known `delay` s later; `None` if none is found.
pub fn way_out(problem: Problem, plan: &Trajectory, mode: usize, at: f64, delay: f64) -> Option<FoundBranch> {
    let model = problem.model();
    let healthy = AdmissibleSet::healthy(model);
    let (set, provision) = of_one_mode(model, mode, &healthy);
    if why_none(model, mode, &set, &provision).is_some() || provision == Provision::Capture {
        return None;
    }
    let sought = SoughtMode { mode, set: &set, provision: &provision };
    Search::new(problem, plan, sought, &healthy, &[delay], false).first(at)
}

/// The way out for a flight that takes it, with its words.
pub fn flown_way_out(problem: Problem, plan: &Trajectory, mode: usize, at: f64, known: f64) -> Option<WayOut> {
    let (model, healthy) = (problem.model(), AdmissibleSet::healthy(problem.model()));
    if of_one_mode(model, mode, &healthy).1 == Provision::Capture && caught::may_land(model, mode) {
        return Some(WayOut::Stop { words: "caught by its spin, stopping and landing".into() });
    }
    let FoundBranch { way, motion, .. } = way_out(problem, plan, mode, at, known - at)?;
    let (returns, words) = match way {
        Way::Continue | Way::ContinueSpinning => (true, "back to the plan and along it".to_string()),
        Way::LandAt(site) => (false, format!("landing at {}", problem.mission().after_fault.sites[site].name)),
        Way::LandHere | Way::Caught => (false, "landing near the place of the fault".into()),
    };
    Some(WayOut::Branch { motion, returns, words })
}

impl Recovery {
    /// The families of all modes for a certificate; `None` if none were found.
    pub fn claim(&self) -> Option<RecoveryClaim> {
        let mut claim = RecoveryClaim { branches: Vec::new(), families: Vec::new() };
        for Families { proved, branches, .. } in self.modes.iter().filter_map(|mode| mode.families.as_ref()) {
            let mut place = BTreeMap::new();
            for family in proved {
                let corners = family.corners.map(|index| {
                    *place.entry(index).or_insert_with(|| {
                        claim.branches.push(branches[index].clone());
                        claim.branches.len() - 1
                    })
                });
                claim.families.push(FamilyRecord { corners, ..family.clone() });
            }
        }
        (!claim.families.is_empty()).then_some(claim)
    }
}

impl ModeRecovery {
    /// For how long no way out was found, s.
    pub fn uncovered(&self) -> f64 {
        self.pieces.iter().filter(|piece| piece.way.is_none()).fold(0.0, |sum, piece| sum + (piece.to - piece.from))
    }
}
