//! The short output of `mavc plan`: the answer, what is covered and what is not, and what a reader must not overlook.

mod coverage;
mod price;

pub use coverage::{CoverageRecord, Covers};
pub(super) use coverage::{instant, spare, unsafe_until, warn_of_not_covered};
pub use price::PriceRecord;

use super::battery;
use super::binding;
use super::capture_height;
use super::capture_height::{CaptureRecord, ExposedRecord};
use super::caveats::caveats;
use super::mode_names::within;
use super::record::rates;
use super::screen::{Counted, Keep, Screen, Tone};
use super::shape;
use super::terminal::vehicle_line;
use super::verdict_text;
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
use std::cmp::Reverse;

/// Digits of every figure.
const DIGITS: usize = 3;
/// Smaller distances from a volume are not told apart, m.
const NEAREST: f64 = 0.01;
/// Most columns of the names of modes whose risk is not counted.
const NAMES: usize = 32;

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
    /// The output; of no more than one planner's run, the last. `further` writes what follows; it has its own table of
    /// modes, in place of that of the plan.
    pub fn screen(&self, further: Option<impl FnOnce(&mut Screen)>) -> Screen {
        let (model, mission) = (self.problem.model(), self.problem.mission());
        let mut screen = Screen::default();
        screen.paragraph(Tone::Plain, 0, 2, &format!("{} with {}", mission.name, vehicle_line(model)));
        screen.gap();
        let Some(run) = self.comparison.runs.last() else { return screen };
        match &run.outcome {
            PlanOutcome::Planned(solved) => self.found(&mut screen, run, solved, further.is_none()),
            outcome => self.missing(&mut screen, run, outcome),
        }
        if let Some(further) = further {
            further(&mut screen);
        }
        screen.close();
        screen
    }

    /// Which modes the plan covers, in sentences; empty without a plan.
    pub fn coverage(&self) -> Vec<CoverageRecord> {
        let run = self.comparison.runs.last();
        let found = run.and_then(|run| Some(coverage::sentences(self, run, run.outcome.plan()?)));
        found.unwrap_or_default()
    }

    /// What covering the modes costs; `None` without a plan and if none is planned against.
    pub fn price(&self) -> Option<PriceRecord> {
        let run = self.comparison.runs.last()?;
        PriceRecord::of_plan(self, run, run.outcome.plan()?)
    }

    /// No plan: what was shown, and about which modes.
    fn missing(&self, screen: &mut Screen, run: &PlannerRun, outcome: &PlanOutcome) {
        let model = self.problem.model();
        let mut text = verdict_text::headline(self.problem, self.comparison, run);
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

    /// A plan.
    fn found(&self, screen: &mut Screen, run: &PlannerRun, solved: &MissionPlan, has_table: bool) {
        let model = self.problem.model();
        let text = verdict_text::headline(self.problem, self.comparison, run);
        let is_doubtful = caveats(model, solved).iter().any(|caveat| caveat.kind.is_outside_the_model());
        let tone = if is_doubtful || coverage::is_partial(self, solved) { Tone::Warning } else { Tone::Good };
        screen.paragraph(tone, 2, 2, &text);
        coverage::say(self, screen, run, solved);
        if has_table {
            coverage::tabulate(self, screen, solved);
        }
        screen.gap();
        let labelled = |screen: &mut Screen, label: &str, text: &str| {
            screen.paragraph(Tone::Plain, 2, 11, &format!("{label:<10} {text}"));
        };
        // Never left out: what safety costs is what the planners differ in.
        if let Some(price) = PriceRecord::of_plan(self, run, solved) {
            labelled(screen, "price", &price.sentence);
        }
        // Landing sites alone are no way out.
        if has_table && !self.problem.mission().after_fault.sites.is_empty() {
            labelled(screen, "ways out", "after faults: not sought, `--recovery` looks for them");
        }
        for (keep, label, text) in self.figures(solved) {
            screen.part(keep, Some((Counted::Figure, 1)), |screen| labelled(screen, label, &text));
        }
        self.remarks(model, solved).iter().for_each(|(keep, text)| screen.remark(*keep, text));
    }

    /// Labelled lines of figures.
    fn figures(&self, solved: &MissionPlan) -> Vec<(Keep, &'static str, String)> {
        let (model, mission) = (self.problem.model(), self.problem.mission());
        let mut lines = Vec::new();
        let reached = waypoints::waypoints(mission, solved);
        lines.push((Keep::Figure, "waypoints", waypoints::headline(&reached)));
        lines.push((Keep::Figure, "path", path(self.problem, solved)));
        lines.extend(wind(model).map(|text| (Keep::Figure, "wind", text)));
        let captures = self.heights.and_then(|heights| CaptureRecord::new(model, heights));
        let capture = captures.and_then(|record| capture_height::figure(&record, self.exposed));
        lines.extend(capture.map(|text| (Keep::Figure, "capture", text)));
        if let Some(record) = battery::record(model, &solved.trajectory) {
            let left = if record.left < 0.0 { "none".to_string() } else { percent(record.left) };
            lines.push((
                Keep::Figure,
                "battery",
                format!("{}, {left} left ({} to keep)", record.used(), percent(record.keep)),
            ));
        }
        let nearest = volumes::records(self.problem, solved);
        let spare = |record: &volumes::VolumeRecord| record.distance_m - record.required_m;
        if let Some(record) = nearest.iter().min_by(|a, b| spare(a).total_cmp(&spare(b))) {
            let distance = match record.distance_m < NEAREST {
                true => "under 1 cm".to_string(),
                false => format!("{} m", significant(record.distance_m, DIGITS)),
            };
            let required = match record.required_m > 0.0 {
                true => format!("{} m required", significant(record.required_m, DIGITS)),
                false => "without a `clearance` for the flight's errors".to_string(),
            };
            let at = fixed(record.at_s, 2);
            let of = if nearest.len() > 1 { format!(", the tightest of {}", nearest.len()) } else { String::new() };
            let text = format!("{distance} from `{}` at {at} s, {required}{of}", record.name);
            lines.push((Keep::Figure, "volumes", text));
        }
        if let Some(risk) = rated_risk(&rates(model), &solved.committed) {
            let text = match risk > 0.0 {
                true => format!("probability {} of a fault while the plan is unsafe", significant(risk, DIGITS)),
                false => "none from the modes planned against: their rotors suffice; delays not counted".into(),
            };
            // A plan that exceeds it is not found.
            let allowed = model.plan.require_risk.map(|most| format!(" ({} allowed)", significant(most, DIGITS)));
            lines.push((Keep::Figure, "risk", text + &allowed.unwrap_or_default() + &not_counted(model)));
        }
        let limits = binding::records(self.problem, solved);
        let most = limits.iter().flat_map(|leg| leg.statements.iter().map(move |of_leg| (leg, of_leg)));
        if let Some((leg, of_leg)) = most.max_by(|a, b| a.1.time_saved_s.total_cmp(&b.1.time_saved_s)) {
            lines.push((Keep::Reason, "time", format!("most limited on {} by {}", leg.to(), of_leg.saved())));
        }
        lines
    }

    /// The remarks, those first that a reader must not overlook: what may lose the vehicle, then what the model or the
    /// limits do not hold for, then detours.
    fn remarks(&self, model: &Model, solved: &MissionPlan) -> Vec<(Keep, String)> {
        let height = self.heights.and_then(|heights| CaptureRecord::new(model, heights));
        let height = height.and_then(|record| capture_height::caveat(&record, self.exposed));
        let caveats = height.into_iter().chain(caveats(model, solved));
        let detours = shape::remark(self.problem, solved, self.detours).map(|text| (Keep::Finding, text));
        let mut all: Vec<(Keep, String)> =
            caveats.map(|caveat| (caveat.kind.keep(), caveat.message)).chain(detours).collect();
        all.sort_by_key(|(keep, _)| Reverse(*keep));
        all
    }
}

/// The winds that the plan is for: `planned for [6, 3, 0] m/s +- [1, 1, 0] m/s`; `None` without drag and in still air.
fn wind(model: &Model) -> Option<String> {
    let air = &model.mission.as_ref()?.air;
    let is_still = air.wind == [0.0; 3] && air.wind_spread == [0.0; 3] && air.gusts == 0.0;
    if is_still || !model.environment().has_drag() {
        return None;
    }
    let vector = |v: [f64; 3]| format!("[{}]", v.map(|x| significant(x, DIGITS)).join(", "));
    let spread = match air.wind_spread {
        [0.0, 0.0, 0.0] => String::new(),
        spread => format!(" +- {} m/s", vector(spread)),
    };
    let gusts = if air.gusts > 0.0 { "; its gusts are left to `mavc simulate`" } else { "" };
    Some(format!("planned for {} m/s{spread}{gusts}", vector(air.wind)))
}

/// The modes that the risk leaves out: those with a rate because the plan is not against them, the others of these for
/// want of one.
fn not_counted(model: &Model) -> String {
    let all: Vec<String> = model.modes.iter().map(|mode| mode.name.clone()).collect();
    let left = |wanted: &dyn Fn(Option<f64>) -> bool| -> Option<String> {
        let is_left_out = |m: &usize| !model.plan.against.contains(m) && wanted(model.modes[*m].rate);
        let left: Vec<usize> = (0..all.len()).filter(is_left_out).collect();
        (!left.is_empty()).then(|| within(&all, &left, NAMES))
    };
    let not_counted = left(&|rate| rate.is_some_and(|rate| rate > 0.0)).map(|names| format!("; not counted: {names}"));
    let no_rate = left(&|rate| rate.is_none()).map(|names| format!("; without a rate: {names}"));
    [not_counted, no_rate].into_iter().flatten().collect()
}

/// `height up to 25.4 m, 0.4 m above the highest waypoint; 0.4 m off the straight legs; speed 9.47 of 10 m/s`
fn path(problem: Problem, solved: &MissionPlan) -> String {
    let record = shape::record(problem, solved);
    let mut parts = vec![
        format!("height up to {}, {}", record.height.value(), record.height.relation()),
        format!("{} off the straight legs", record.deviation.value()),
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
