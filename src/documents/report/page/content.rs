//! The data for the page's script as JSON: path, sets, charts and instants, rounded to what a screen shows.

use super::chart::{Chart, Columns, rounded};
use super::opening::{Opening, opening};
use super::sets::{SetContent, ShownSet};
use super::volumes::{self, NearestContent, VolumeContent};
use super::ways::ModeWays;
use super::{Subject, motion, shown_first};
use crate::admissible::verdict::ModeAnalysis;
use crate::admissible::{AdmissibleSet, hover};
use crate::model::Model;
use crate::motion::nearness::nearness;
use crate::number::number;
use crate::planner::studies::{Comparison, MissionPlan, PlanOutcome, PlannerRun, Run};
use crate::report::comparison_text::name_of;
use crate::report::plan_screen::unsafe_until;
use serde::Serialize;

/// Cells of a heat strip.
const CELLS: usize = 240;

/// Numbers in the columns of all runs together, and instants of one run at most: a page stays small.
const MOST_NUMBERS: usize = 130_000;
const MOST_INSTANTS: usize = 1_000;

/// Fewest instants of a run; if there is no room for them, its curves are omitted.
const FEWEST_INSTANTS: usize = 80;

/// Largest JSON report that the page includes, bytes.
const MOST_RECORD: usize = 300_000;

/// Most waypoints that are drawn.
const MOST_WAYPOINTS: usize = 400;

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Content {
    pub waypoints: Vec<WaypointContent>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub volumes: Vec<VolumeContent>,
    /// Places of the rotors from the centre of gravity, m, in the body's frame: x forward, y left, z up.
    pub rotors: Vec<[f64; 3]>,
    /// `[m g, 0, 0, 0]`, N and N m.
    pub hover: [f64; 4],
    /// `[least, most]` of each component over the whole healthy set.
    pub extents: [[f64; 2]; 4],
    /// The share of each set that is reserved for feedback: rows are shrunk by it about hover.
    pub reserve: f64,
    /// Healthy first.
    pub sets: Vec<SetContent>,
    pub runs: Vec<RunContent>,
    /// Of a plan along which ways out were sought: those of every mode.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub ways: Vec<ModeWays>,
    /// Index into `runs` of the one shown first.
    pub first: usize,
    /// The instant and the set shown first.
    pub opens: Opening,
    /// The JSON report; `None` if it is large.
    pub record: Option<serde_json::Value>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WaypointContent {
    pub name: String,
    pub at: [f64; 3],
    /// m
    pub within: f64,
}

/// One plan or flight.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RunContent {
    pub label: String,
    /// Whether it is among those that a comparison shows first: RIP, RSP and RCP for all modes together, at one time.
    pub leads: bool,
    /// End of its figures' names (`--svg`); `None` if it has no figures.
    #[serde(skip)]
    pub figures: Option<String>,
    /// Name of its wrench.
    pub wrench: &'static str,
    pub columns: Columns,
    pub charts: Vec<Chart>,
    /// When each waypoint is passed, s.
    pub passed: Vec<f64>,
    /// For every set that plans are measured against: its index in `sets`, and the smallest margin in each cell of the
    /// flight, in percent of the healthy set's width.
    pub strips: Vec<Strip>,
    /// Events.
    pub marks: Vec<Mark>,
    /// For a flight: the faults in force, in order of time, the first from 0 s.
    pub phases: Vec<Phase>,
    /// For a plan: where it comes nearest to each volume.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub nearest: Vec<NearestContent>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Phase {
    /// s
    pub from: f64,
    pub label: String,
}

/// Label of the mark at which a flight was lost.
pub const LOST: &str = "lost";
/// Label of the mark at which the vehicle was first past the boundary of a volume.
pub const TRESPASSED: &str = "past a volume";
/// Label of the mark at which the integration broke down.
pub const DIVERGED: &str = "diverged";

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Mark {
    /// s
    pub t: f64,
    /// Empty if a line is enough.
    pub label: String,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Strip {
    pub set: usize,
    pub margins: Vec<f64>,
    /// A fault before this instant may meet a violation, s; `None` if it meets none.
    pub until: Option<f64>,
}

impl Content {
    /// Adds where hover lies relative to each set.
    pub fn with_places(mut self, analyses: &[ModeAnalysis]) -> Self {
        for set in &mut self.sets {
            set.hover = analyses.iter().find(|a| a.name == set.name).map(ModeAnalysis::hover_all_axes);
        }
        self
    }

    /// The data for plans: as many as fit on a page of reasonable size, always including the one shown first.
    pub fn of_plans(subject: &Subject, comparison: &Comparison, shown: &[ShownSet], record: &impl Serialize) -> Self {
        let first = shown_first(subject.problem.model(), comparison);
        let solved: Vec<(usize, &PlannerRun, &MissionPlan)> = comparison
            .runs
            .iter()
            .enumerate()
            .filter_map(|(i, run)| match &run.outcome {
                PlanOutcome::Planned(s) => Some((i, run, s.as_ref())),
                _ => None,
            })
            .collect();
        let curves = volumes::curves(subject.problem);
        let width = 24 + subject.problem.model().vehicle.rotors.len() + shown.len() + curves;
        let places = (MOST_NUMBERS / (width * FEWEST_INSTANTS)).max(1);
        let mut kept = solved;
        if kept.len() > places {
            // Plans against several modes are more informative than plans against one.
            kept.sort_by_key(|(i, run, _)| (Some(*i) != first, run.run == Run::Own, run.against.len() == 1));
            kept.truncate(places);
            kept.sort_by_key(|(i, ..)| *i);
        }
        let most = (MOST_NUMBERS / (width * kept.len().max(1))).clamp(FEWEST_INSTANTS, MOST_INSTANTS);
        let runs = kept
            .iter()
            .map(|(i, run, solved)| RunContent {
                figures: figures_of(run, &kept),
                leads: leads(run, &kept),
                ..run_content(subject, run_label(comparison, *i, solved.time), solved, shown, most)
            })
            .collect();
        let first = kept.iter().position(|(i, ..)| Some(*i) == first).unwrap_or(0);
        Content { runs, ..Content::of_sets(subject, shown, record) }.showing(first)
    }

    /// The content with run `first`, counted from 0, shown when the page opens.
    pub fn showing(self, first: usize) -> Self {
        let opens = opening(self.runs.get(first), &self.sets);
        Content { first, opens, ..self }
    }

    /// The data if nothing was planned.
    pub fn of_sets(subject: &Subject, shown: &[ShownSet], record: &impl Serialize) -> Self {
        let problem = subject.problem;
        let mission = problem.mission();
        let step = mission.waypoints.len().div_ceil(MOST_WAYPOINTS);
        let waypoint = |(i, w): (usize, &crate::model::Waypoint)| WaypointContent {
            name: w.name.clone().unwrap_or_else(|| format!("waypoint {}", i + 1)),
            at: w.position.map(rounded),
            within: rounded(w.within),
        };
        Content {
            waypoints: mission.waypoints.iter().enumerate().step_by(step.max(1)).map(waypoint).collect(),
            volumes: volumes::contents(problem),
            ..Content::of_model(problem.model(), shown, record)
        }
    }

    /// The data of a vehicle without a mission.
    pub fn of_model(model: &Model, shown: &[ShownSet], record: &impl Serialize) -> Self {
        let whole = serde_json::to_value(record).ok();
        let small = |value: &serde_json::Value| value.to_string().len() <= MOST_RECORD;
        let mode = |set: &ShownSet| model.modes.iter().find(|mode| mode.name == set.name);
        let sets: Vec<SetContent> = shown.iter().map(|set| SetContent::new(set, mode(set))).collect();
        Content {
            waypoints: Vec::new(),
            volumes: Vec::new(),
            rotors: model.vehicle.rotors.iter().map(|rotor| rotor.position.map(rounded)).collect(),
            hover: hover(model).into(),
            extents: extents(model),
            reserve: model.plan.reserve,
            opens: opening(None, &sets),
            sets,
            runs: Vec::new(),
            ways: Vec::new(),
            first: 0,
            record: whole.filter(small),
        }
    }
}

fn extents(model: &Model) -> [[f64; 2]; 4] {
    let zonotope = AdmissibleSet::healthy(model).zonotope;
    [0, 1, 2, 3].map(|axis| {
        let ends = |pick: fn(f64, f64) -> f64| zonotope.generators.iter().map(|g| pick(g[axis], 0.0)).sum::<f64>();
        [zonotope.offset[axis] + ends(f64::min), zonotope.offset[axis] + ends(f64::max)].map(rounded)
    })
}

/// `RSP, own time 16 s`, `RCP jointly, common time 16.4 s`; for a single plan `RSP, 16 s`.
pub fn run_label(comparison: &Comparison, index: usize, time: f64) -> String {
    let run = &comparison.runs[index];
    let name = name_of(run);
    match run.run {
        _ if comparison.runs.len() == 1 => format!("{name}, {} s", number(time)),
        Run::Own => format!("{name}, own time {} s", number(time)),
        Run::Common => format!("{name}, common time {} s", number(time)),
    }
}

/// The end of the names of a run's figures; `None` if it has none: of several plans only those at the common time are
/// drawn, because they can be compared, or all if there is no such time.
fn figures_of(run: &PlannerRun, among: &[(usize, &PlannerRun, &MissionPlan)]) -> Option<String> {
    let is_common = |run: &PlannerRun| run.run == Run::Common;
    match among {
        [_] => Some(String::new()),
        _ if is_common(run) || !among.iter().any(|(_, run, _)| is_common(run)) => {
            Some(format!("-{}", name_of(run).replace(' ', "-")))
        }
        _ => None,
    }
}

/// Whether a run leads: each planner against all modes, at the common time if there is one.
fn leads(run: &PlannerRun, among: &[(usize, &PlannerRun, &MissionPlan)]) -> bool {
    let has_common = among.iter().any(|(_, run, _)| run.run == Run::Common);
    let of_planner = among.iter().filter(|(_, other, _)| other.planner == run.planner);
    let most = of_planner.map(|(_, other, _)| other.against.len()).max();
    (run.run == Run::Common || !has_common) && most == Some(run.against.len())
}

fn run_content(subject: &Subject, label: String, solved: &MissionPlan, shown: &[ShownSet], most: usize) -> RunContent {
    let problem = subject.problem;
    let model = problem.model();
    let trajectory = &solved.trajectory;
    let strip = |set: usize, s: &ShownSet| Strip {
        set,
        margins: nearness(trajectory, &model.vehicle, &model.environment(), s.measure(), CELLS)
            .into_iter()
            // A cell shows no more than two decimals of a percent.
            .map(|m| (1e4 * m).round() / 100.0)
            .collect(),
        until: s.against.and_then(|mode| unsafe_until(model, solved, mode)).map(rounded),
    };
    let measured = shown.iter().enumerate().filter(|(_, s)| s.against.is_some());
    RunContent {
        label,
        leads: true,
        figures: None,
        columns: motion::columns(problem, solved, shown, most),
        charts: motion::charts(problem, solved, shown).into_iter().map(Chart::set).collect(),
        passed: trajectory.waypoint_nodes.iter().map(|&n| rounded(trajectory.times[n])).collect(),
        strips: measured.map(|(i, s)| strip(i, s)).collect(),
        wrench: "planned wrench",
        marks: Vec::new(),
        phases: Vec::new(),
        nearest: volumes::nearest(problem, solved),
    }
}
