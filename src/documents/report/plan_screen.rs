//! The short output of `mavc plan`: the answer, what is covered and what is not, and what a reader must not overlook.

mod coverage;

pub(super) use coverage::{not_covered, unsafe_until};

use super::battery;
use super::binding;
use super::capture_height;
use super::capture_height::{CaptureRecord, ExposedRecord};
use super::caveats::{Caveat, CaveatKind, caveats};
use super::record::rates;
use super::screen::{EVERY_TABLE, Screen, Tone};
use super::shape;
use super::terminal::{not_looked_at, vehicle_line};
use super::verdict_text::{self, statement};
use super::volumes;
use super::waypoints;
use super::without_yaw;
use crate::certify::between::Between;
use crate::explain::detour::Detour;
use crate::flight::capture::heights::CaptureHeights;
use crate::model::{LimitKind, Model, Problem};
use crate::motion::checks::{peak_of, violation};
use crate::motion::risk::rated_risk;
use crate::number::{fixed, percent, significant};
use crate::planner::studies::{Comparison, MissionPlan, PlanOutcome, PlannerRun};
use crate::verdict::Verdict;

/// Digits of every figure.
const DIGITS: usize = 3;
/// Most lines up to the remarks: the rest is in the tables of `-v`.
const MOST_LINES: usize = 22;

/// What the output is about.
pub struct Answer<'a> {
    pub problem: Problem<'a>,
    pub comparison: &'a Comparison,
    /// The heights that faults cost, if they were simulated.
    pub heights: Option<&'a CaptureHeights>,
    /// When the plan is lower than these ask for.
    pub exposed: &'a [ExposedRecord],
    pub detours: &'a [Detour],
    /// Other times at which plans were found, s.
    pub found_at: &'a [f64],
    /// What holds between nodes.
    pub between: Option<&'a [Between]>,
}

impl Answer<'_> {
    /// The output; of no more than one planner's run, the last.
    pub fn screen(&self) -> Screen {
        let (model, mission) = (self.problem.model(), self.problem.mission());
        let mut screen = Screen::default();
        screen.paragraph(Tone::Plain, 0, 2, &format!("{} with {}", mission.name, vehicle_line(model)));
        screen.gap();
        let Some(run) = self.comparison.runs.last() else { return screen };
        match &run.outcome {
            PlanOutcome::Planned(solved) => self.found(&mut screen, run, solved),
            outcome => self.missing(&mut screen, run, outcome),
        }
        screen.line(Tone::Plain, EVERY_TABLE);
        screen
    }

    /// No plan: what was shown, and about which modes.
    fn missing(&self, screen: &mut Screen, run: &PlannerRun, outcome: &PlanOutcome) {
        let model = self.problem.model();
        let mut text = format!("{}; planner {}", shouted(self.problem, self.comparison, run), name(run));
        if let PlanOutcome::Infeasible(proof) = outcome
            && !run.against.is_empty()
            && let Some(note) = without_yaw::of_proof(self.problem, self.comparison, proof)
        {
            text.push_str(&format!(". {note}"));
        }
        screen.paragraph(Tone::Bad, 2, 2, &text);
        if let Some(text) = verdict_text::elsewhere(model, self.found_at) {
            screen.paragraph(Tone::Warning, 2, 2, &text);
        }
        coverage::demanded(self, screen);
        let detail = match outcome.verdict() {
            Verdict::ProvedInfeasible => "the proof is checked; `--certificate` writes it",
            Verdict::NotFound => "not a proof that there is none; `--effort thorough` searches longer",
            _ => return,
        };
        screen.paragraph(Tone::Plain, 2, 2, detail);
    }

    fn found(&self, screen: &mut Screen, run: &PlannerRun, solved: &MissionPlan) {
        let model = self.problem.model();
        let text = format!(
            "PLAN {}; planner {}{}",
            shouted(self.problem, self.comparison, run),
            name(run),
            without_yaw::beside_the_verdict(self.comparison)
        );
        let tone = if coverage::is_partial(self, solved) { Tone::Warning } else { Tone::Good };
        screen.paragraph(tone, 2, 2, &text);
        coverage::write(self, screen, run, solved);
        screen.gap();
        self.figures(solved).iter().for_each(|(label, text)| {
            screen.paragraph(Tone::Plain, 2, 11, &format!("{label:<10} {text}"));
        });
        screen.remarks(&self.remarks(model, solved), MOST_LINES);
    }

    /// Labelled lines of figures.
    fn figures(&self, solved: &MissionPlan) -> Vec<(&'static str, String)> {
        let (model, mission) = (self.problem.model(), self.problem.mission());
        let mut lines = Vec::new();
        let reached = waypoints::waypoints(mission, solved);
        lines.push(("waypoints", waypoints::headline(&reached)));
        lines.push(("path", path(self.problem, solved)));
        if let Some(record) = battery::record(model, &solved.trajectory) {
            let left = if record.left < 0.0 { "none".to_string() } else { percent(record.left) };
            lines.push(("battery", format!("{}, {left} left ({} to keep)", record.used(), percent(record.keep))));
        }
        let nearest = volumes::records(self.problem, solved);
        let spare = |record: &volumes::VolumeRecord| record.distance_m - record.required_m;
        if let Some(record) = nearest.iter().min_by(|a, b| spare(a).total_cmp(&spare(b))) {
            let [distance, required] = [record.distance_m, record.required_m].map(|m| significant(m, DIGITS));
            let at = fixed(record.at_s, 2);
            let of = if nearest.len() > 1 { format!(", the tightest of {}", nearest.len()) } else { String::new() };
            lines.push(("volumes", format!("{distance} m from {} at {at} s, {required} m required{of}", record.name)));
        }
        if let Some(risk) = rated_risk(&rates(model), &solved.committed) {
            let text = format!("{} that a fault strikes while it is unsafe.", significant(risk, DIGITS));
            lines.push(("risk", text + &not_looked_at(model)));
        }
        let limits = binding::records(self.problem, solved);
        let most = limits.iter().flat_map(|leg| leg.statements.iter().map(move |of_leg| (leg, of_leg)));
        if let Some((leg, of_leg)) = most.max_by(|a, b| a.1.time_saved_s.total_cmp(&b.1.time_saved_s)) {
            lines.push(("time", format!("most limited on leg {} by {}", leg.label(), of_leg.saved())));
        }
        lines
    }

    /// What a reader must not overlook.
    fn remarks(&self, model: &Model, solved: &MissionPlan) -> Vec<String> {
        let mut all: Vec<Caveat> = caveats(model, solved);
        all.extend(shape::caveats(self.problem, solved, self.detours));
        if let Some(record) = self.heights.and_then(|heights| CaptureRecord::new(model, heights)) {
            all.extend(capture_height::caveat(&record, self.exposed));
        }
        // Detours first: a reader would not expect them.
        let rank = |caveat: &Caveat| !matches!(caveat.kind, CaveatKind::Climb | CaveatKind::Deviation);
        all.sort_by_key(rank);
        all.into_iter().map(|caveat| caveat.message).collect()
    }
}

/// `FOUND, 35 s`: the statement on a run with its verdict in capitals.
fn shouted(problem: Problem, comparison: &Comparison, run: &PlannerRun) -> String {
    let (statement, word) = (statement(problem, comparison, run), run.outcome.verdict().word());
    statement.strip_prefix(word).map_or(statement.clone(), |rest| format!("{}{rest}", word.to_uppercase()))
}

fn name(run: &PlannerRun) -> String {
    run.planner.name().to_uppercase()
}

/// `height up to 25.4 m, 0.4 m above the highest waypoint; up to 0.4 m off the straight legs; speed 9.47 of 10 m/s`
fn path(problem: Problem, solved: &MissionPlan) -> String {
    let record = shape::record(problem, solved);
    let mut parts = vec![
        format!("height up to {}, {}", record.height.value(), record.height.relation()),
        format!("up to {} off the straight legs", record.deviation.value()),
    ];
    let (mission, environment) = (problem.mission(), problem.model().environment());
    for kind in [LimitKind::Speed, LimitKind::Tilt] {
        let general = mission.limits.iter().filter(|limit| limit.kind == kind && limit.is_general());
        let Some((limit, upper)) =
            general.filter_map(|limit| Some((limit, limit.upper?))).min_by(|a, b| a.1.total_cmp(&b.1))
        else {
            continue;
        };
        let description = kind.describe();
        let most = upper + peak_of(limit, mission, &solved.trajectory, |s| violation(limit, s, &environment)).value;
        let [most, upper] = [most, upper].map(|value| significant(value * description.factor(), DIGITS));
        let unit = if description.unit == "degrees" { "deg" } else { description.unit };
        parts.push(format!("{} {most} of {upper} {unit}", description.name));
    }
    parts.join("; ")
}
