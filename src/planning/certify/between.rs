//! To what extent a plan's rows hold between its nodes: proved at every instant by the checker's intervals, or checked
//! on a grid.

use super::witness::{model_of, motion};
use crate::admissible::row::{SetRow, largest};
use crate::model::{Limit, Model, Part, Problem};
use crate::motion::checks::{leg_intervals, peak_of, violation_as_checked};
use crate::motion::winds::OverWinds;
use crate::motion::{NodeState, Trajectory};
use crate::planner::studies::{MissionPlan, PlannerRun};
use crate::verify::Premises;
use crate::verify::core::{self, Member};
use crate::verify::cost::{OF_EXACT_WRENCH, WorkLeft};
use crate::verify::interval::Interval;
use crate::verify::motion::Motion;
use crate::verify::plan::{MOST_OUTSIDE, MOST_PAST_LIMIT, POINTS_OF_A_GRID, Setting, wrench_family};
use crate::verify::proof::{Family, throughout};
use crate::verify::sets::Plane;
use crate::verify::wrench::{Dynamics, Held};
use serde::Serialize;

/// Points per interval, including one of its ends, that are checked where nothing is proved: those that the cost phase
/// of the exact model uses.
pub const GRID: usize = POINTS_OF_A_GRID + 1;

/// Most work for one proof, in the checker's units: a small part of the planning time. Chosen by hand.
const WORK: u64 = 3_000_000;

/// Most work for each row and piece, if that is more. Chosen by hand.
const WORK_EACH: u64 = 20;

/// Bounds on the violation of a limit that are tried in turn, as shares of the limit's size. Up to the last one the
/// limit counts as satisfied.
const PAST: [f64; 3] = [1e-6, 1e-5, MOST_PAST_LIMIT];

/// The rows of one kind, and to what extent they are shown to hold between nodes.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Between {
    /// `wrench`: the facets imposed on the wrench; `cores`: the rows of modes without yaw; `commands`: the same on
    /// the commanded wrench of lagging rotors; otherwise the limited quantity, in words.
    pub rows: String,
    /// To what extent they are shown to hold.
    pub shown: Shown,
    /// Points of the grid per interval, if one was checked; null if all rows are proved.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub points: Option<usize>,
    /// Number of rows: for the wrench and commands the planes imposed (facets in the same plane count once); 1 for a
    /// limit.
    pub imposed: usize,
    /// Number of rows that are proved at every instant.
    pub proved: usize,
    /// Bound on the violation of every row: a share of the healthy set's width for the wrench and commands, SI for
    /// limits, tilt as in certificates.
    pub violation: f64,
}

/// To what extent rows are shown to hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Shown {
    /// All rows at every instant.
    Proved,
    /// On a grid, because not all rows are proved.
    Checked,
}

/// The name of the rows on the wrench.
pub const WRENCH: &str = "wrench";

/// The name of the rows of cores.
pub const CORES: &str = "cores";

/// The name of the rows on the commanded wrench of lagging rotors.
pub const COMMANDS: &str = "commands";

/// Results for the wrench, then cores if there are any, then each limit in the spec's order, then the commands of
/// lagging rotors. Rows that are linear over each piece (hover model with one yaw) are decided at the nodes; all others
/// are proved in interval arithmetic or checked on a grid. The tolerances are those of `mavc verify`, so that both
/// report the same.
pub fn between(problem: Problem, run: &PlannerRun, solved: &MissionPlan) -> Vec<Between> {
    let (model, mission) = (problem.model(), problem.mission());
    let trajectory = &solved.trajectory;
    let kind = model_of(trajectory);
    let setting = Setting::new(problem, kind, Premises::default());
    let Ok(motion) = setting.motion(&motion(trajectory)) else { return Vec::new() };
    // Cores are not linear in the wrench.
    let rows: Vec<SetRow> = run.set.rows.iter().filter(|row| row.core.is_none()).cloned().collect();
    let plane = |side: f64, row: &SetRow| Plane {
        normal: std::array::from_fn(|i| Interval::point(side * row.normal[i])),
        offset: Interval::point(side * row.offset),
        room: Interval::WHOLE,
        rotors: Vec::new(),
        is_facet: true,
    };
    let other_sides = rows.iter().filter(|r| r.equality).map(|r| plane(-1.0, r));
    let planes: Vec<Plane> = rows.iter().map(|r| plane(1.0, r)).chain(other_sides).collect();
    let environment = model.environment();
    let of_wrench = |wrench: &OverWinds| largest(rows.iter().map(|row| wrench.worst(row)));
    let mut found = vec![kept_facets(setting.dynamics(), &motion, Held::Wrench, &planes, trajectory, |_, state| {
        of_wrench(&trajectory.in_every_wind(&model.vehicle, &environment, state))
    })];
    let cores: Vec<&SetRow> = run.set.rows.iter().filter(|row| row.core.is_some()).collect();
    if !cores.is_empty() {
        found.push(kept_cores(setting.dynamics(), &motion, &cores, trajectory, model));
    }
    found.extend(mission.limits.iter().map(|limit| kept_limit(&setting, &motion, limit, trajectory)));
    if let Some((held, tau)) = setting.commands().zip(model.thrust_lag()) {
        // If the wrench stays in a plane, so does its rate, and so do the commands.
        let planes: Vec<Plane> = rows.iter().filter(|r| !r.equality).map(|r| plane(1.0, r)).collect();
        let of_commands = |commanded: &OverWinds| {
            let rows = rows.iter().filter(|r| !r.equality);
            largest(rows.map(|row| commanded.worst(row)))
        };
        found.push(kept_facets(setting.dynamics(), &motion, held, &planes, trajectory, |k, state| {
            of_commands(&trajectory.commanded_in_every_wind(&model.vehicle, &environment, tau, k, state))
        }));
    }
    found
}

/// The result for the imposed facets: how many are proved, and otherwise what a grid shows. `violation` is the largest
/// violation at a state of an interval.
fn kept_facets(
    dynamics: &Dynamics,
    motion: &Motion,
    held: Held,
    planes: &[Plane],
    trajectory: &Trajectory,
    violation: impl Fn(usize, &NodeState) -> f64,
) -> Between {
    let rows = if held == Held::Wrench { WRENCH } else { COMMANDS }.to_string();
    let family = wrench_family(dynamics, held, planes.iter().collect());
    // A state in every wind of an interval counts as many in one.
    let winds = (family.overhead / OF_EXACT_WRENCH).max(1);
    kept_family(rows, &family, planes.len(), winds, motion, trajectory, violation)
}

/// The result for the members of a family of rows, of which `imposed` are imposed: how many are proved, by `share`
/// times the usual work, and otherwise the largest `violation` on a grid.
fn kept_family(
    rows: String,
    family: &Family,
    imposed: usize,
    share: u64,
    motion: &Motion,
    trajectory: &Trajectory,
    violation: impl Fn(usize, &NodeState) -> f64,
) -> Between {
    let mut left = WorkLeft(share * WORK.max(WORK_EACH * (imposed * trajectory.intervals()) as u64));
    let proved =
        throughout(family, motion, MOST_OUTSIDE, &mut left).proved.into_iter().filter(|&proved| proved).count();
    let (shown, points, violation) = match proved == imposed {
        true => (Shown::Proved, None, MOST_OUTSIDE),
        false => (Shown::Checked, Some(GRID), seen(trajectory, violation)),
    };
    Between { rows, shown, points, imposed, proved, violation }
}

/// The result for rows of cores.
fn kept_cores(
    dynamics: &Dynamics,
    motion: &Motion,
    rows: &[&SetRow],
    trajectory: &Trajectory,
    model: &Model,
) -> Between {
    let member = |row: &&SetRow| {
        let core = row.core?;
        let [thrust, torque, offset] = [row.normal[0], core.torque, row.offset].map(Interval::point);
        let [inertia, unevenness] = [core.inertia, core.unevenness.abs()].map(Interval::point);
        let [momentum, spin] = [core.momentum, core.spin].map(Interval::point);
        Some(Member { thrust, torque, offset, inertia, unevenness, momentum, spin })
    };
    let family = core::family(dynamics, rows.iter().filter_map(member).collect(), None);
    let environment = model.environment();
    let violation = |_: usize, state: &NodeState| {
        let turning = trajectory.model.turning(&model.vehicle, &environment, state);
        let of = |row: &&SetRow| row.normal[0] * turning[0] - row.offset + row.of_core(Some(&turning));
        largest(rows.iter().map(of))
    };
    kept_family(CORES.into(), &family, rows.len(), 1, motion, trajectory, violation)
}

/// The result for a limit: the first bound of [`PAST`] that is proved, otherwise what a grid shows.
fn kept_limit(setting: &Setting, motion: &Motion, limit: &Limit, trajectory: &Trajectory) -> Between {
    let rows = limit.name().to_string();
    let (environment, mission) = (&setting.dynamics().environment, setting.mission());
    let family = setting.family_of(limit, motion);
    let seen = match limit.leg.as_deref().map(|on| (on, on.part)) {
        None => seen(trajectory, |_, state| violation_as_checked(limit, state, environment)),
        Some((_, Part::Start | Part::End)) => {
            peak_of(limit, mission, trajectory, |state| violation_as_checked(limit, state, environment)).value
        }
        Some((on, Part::Whole)) => {
            let leg = leg_intervals(trajectory, mission, on.leg);
            let within = |k: usize, state: &NodeState| match leg.contains(&k) {
                true => violation_as_checked(limit, state, environment),
                false => f64::NEG_INFINITY,
            };
            seen(trajectory, within)
        }
    };
    // A polygon costs more with each of its corners.
    let work = WORK.saturating_mul(family.of_a_member);
    // Bounds that the grid disproves are not tried, nor any on what is required at nodes only.
    let is_between = !limit.kind.is_heading();
    let proved = PAST
        .map(|share| share * limit.size())
        .into_iter()
        .filter(|bound| is_between && seen <= *bound)
        .find(|&violation| throughout(&family, motion, violation, &mut WorkLeft(work)).is_proved());
    match proved {
        Some(violation) => Between { rows, shown: Shown::Proved, points: None, imposed: 1, proved: 1, violation },
        None => Between { rows, shown: Shown::Checked, points: Some(GRID), imposed: 1, proved: 0, violation: seen },
    }
}

/// The largest value on the grid, both ends of each interval included.
fn seen(trajectory: &Trajectory, violation: impl Fn(usize, &NodeState) -> f64) -> f64 {
    let at = |k: usize, i: usize| {
        let h = trajectory.times[k + 1] - trajectory.times[k];
        violation(k, &trajectory.within(k, h * i as f64 / GRID as f64))
    };
    let looks = (0..trajectory.intervals()).flat_map(|k| (0..=GRID).map(move |i| (k, i)));
    largest(looks.map(|(k, i)| at(k, i)))
}
