//! What reports say of a plan between its nodes: proved for every instant by the checker's intervals, or checked on a grid.

use super::plan::{model_of, motion};
use crate::actuation::Wrench;
use crate::admissible::row::SetRow;
use crate::model::{Limit, Mission, Model};
use crate::motion::checks::past_as_checked;
use crate::motion::{NodeState, Trajectory};
use crate::planner::studies::{MissionPlan, PlannerRun};
use crate::verify::Premises;
use crate::verify::cost::Purse;
use crate::verify::interval::Interval;
use crate::verify::limits;
use crate::verify::motion::Motion;
use crate::verify::plan::{MOST_OUTSIDE, MOST_PAST_LIMIT, OF_A_GRID, Setting, wrench_family};
use crate::verify::proof::throughout;
use crate::verify::sets::Plane;
use crate::verify::wrench::{Dynamics, Held};
use serde::Serialize;

/// Points of each interval, one of its ends included, where nothing is proved: those on which plans of the exact model are
/// settled.
pub const GRID: usize = OF_A_GRID + 1;

/// Work that one proof may take, in the checker's units: a small part of what planning takes.
const WORK: u64 = 3_000_000;

/// The same for each row and piece, where that is more.
const WORK_EACH: u64 = 20;

/// By how much a limit may be passed, in shares of itself or in its SI unit if that is more: tried in turn. Up to the
/// last it counts as kept.
const PAST: [f64; 3] = [1e-6, 1e-5, MOST_PAST_LIMIT];

/// The rows of one kind, and how far they are shown to hold.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Between {
    /// `wrench`: everything imposed on it; `commands`: the same on what lagging rotors are commanded; else what is limited, in
    /// words.
    pub rows: &'static str,
    pub shown: Shown,
    /// Points of each interval, where a grid was looked at.
    pub points: Option<usize>,
    /// Of so many rows, for the wrench and commands the planes imposed, one where facets of several sets lie in one; 1 for a
    /// limit.
    pub imposed: usize,
    /// So many are proved.
    pub proved: usize,
    /// No row is passed by more: a share of the healthy set's width for the wrench and commands, the limit's SI unit for limits.
    pub excess: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Shown {
    /// All of them for every instant.
    Proved,
    /// On a grid, where not all are proved.
    Checked,
}

/// The name of the rows on the wrench.
pub const WRENCH: &str = "wrench";

/// The name of the rows on what lagging rotors are commanded.
pub const COMMANDS: &str = "commands";

/// The wrench first, then each limit in the spec's order, then the commands of lagging rotors. With rows linear over each
/// piece (the hover model with one yaw) the nodes decide; all else is proved in intervals or looked at on a grid. The rows
/// count as kept within what `mavc verify` accepts, so that both say the same.
pub fn between(model: &Model, mission: &Mission, run: &PlannerRun, solved: &MissionPlan) -> Vec<Between> {
    let trajectory = &solved.trajectory;
    let kind = model_of(trajectory);
    let setting = Setting::new(model, mission, kind, Premises::default());
    let Ok(motion) = setting.motion(&motion(trajectory)) else { return Vec::new() };
    let rows = &run.set.rows;
    let plane = |side: f64, row: &SetRow| Plane {
        normal: std::array::from_fn(|i| Interval::point(side * row.normal[i])),
        offset: Interval::point(side * row.offset),
        rotors: Vec::new(),
        is_facet: true,
    };
    let other_sides = rows.iter().filter(|r| r.equality).map(|r| plane(-1.0, r));
    let planes: Vec<Plane> = rows.iter().map(|r| plane(1.0, r)).chain(other_sides).collect();
    let largest = |wrench: &Wrench| rows.iter().map(|row| row.violation(wrench)).fold(f64::NEG_INFINITY, f64::max);
    let mut found = vec![kept_facets((setting.dynamics(), &motion), Held::Wrench, &planes, trajectory, |_, state| {
        largest(&trajectory.wrench(&model.vehicle, model.gravity, state))
    })];
    found.extend(mission.limits.iter().map(|limit| kept_limit(&motion, limit, trajectory, model.gravity)));
    if let Some((held, tau)) = setting.commands().zip(model.thrust_lag()) {
        // Where the wrench stays in a plane its rate does, and so do the commands.
        let planes: Vec<Plane> = rows.iter().filter(|r| !r.equality).map(|r| plane(1.0, r)).collect();
        let largest = |lead: &Wrench| {
            let rows = rows.iter().filter(|r| !r.equality);
            rows.map(|row| row.violation(lead)).fold(f64::NEG_INFINITY, f64::max)
        };
        found.push(kept_facets((setting.dynamics(), &motion), held, &planes, trajectory, |k, state| {
            largest(&trajectory.commanded(&model.vehicle, model.gravity, tau, k, state))
        }));
    }
    found
}

/// Of the facets imposed those that are proved, else what a grid shows; `excess` is the largest at a state of an interval.
fn kept_facets(
    (dynamics, motion): (&Dynamics, &Motion),
    held: Held,
    planes: &[Plane],
    trajectory: &Trajectory,
    excess: impl Fn(usize, &NodeState) -> f64,
) -> Between {
    let rows = if held == Held::Wrench { WRENCH } else { COMMANDS };
    let family = wrench_family(dynamics, held, planes);
    let mut purse = Purse(WORK.max(WORK_EACH * (planes.len() * trajectory.intervals()) as u64));
    let proved = throughout(&family, motion, MOST_OUTSIDE, &mut purse).into_iter().filter(|&proved| proved).count();
    let (shown, points, excess) = match proved == planes.len() {
        true => (Shown::Proved, None, MOST_OUTSIDE),
        false => (Shown::Checked, Some(GRID), seen(trajectory, excess)),
    };
    Between { rows, shown, points, imposed: planes.len(), proved, excess }
}

/// Of the bounds that may be claimed the first that is proved, else what a grid shows.
fn kept_limit(motion: &Motion, limit: &Limit, trajectory: &Trajectory, gravity: f64) -> Between {
    let rows = limit.kind.name_and_unit().0;
    let family = limits::family(limit, gravity);
    let seen = seen(trajectory, |_, state| past_as_checked(limit, state, gravity));
    // What is seen to be false is not tried.
    let proved = PAST
        .map(|share| share * limit.size())
        .into_iter()
        .filter(|bound| seen <= *bound)
        .find(|&excess| throughout(&family, motion, excess, &mut Purse(WORK)).iter().all(|&kept| kept));
    match proved {
        Some(excess) => Between { rows, shown: Shown::Proved, points: None, imposed: 1, proved: 1, excess },
        None => Between { rows, shown: Shown::Checked, points: Some(GRID), imposed: 1, proved: 0, excess: seen },
    }
}

/// The largest value on the grid, both ends of each interval included.
fn seen(trajectory: &Trajectory, excess: impl Fn(usize, &NodeState) -> f64) -> f64 {
    let at = |k: usize, i: usize| {
        let h = trajectory.times[k + 1] - trajectory.times[k];
        excess(k, &trajectory.within(k, h * i as f64 / GRID as f64))
    };
    let looks = (0..trajectory.intervals()).flat_map(|k| (0..=GRID).map(move |i| (k, i)));
    looks.map(|(k, i)| at(k, i)).fold(f64::NEG_INFINITY, f64::max)
}
