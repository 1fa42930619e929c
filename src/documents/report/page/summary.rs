//! The top of the page: the result in one sentence and a few figures.

use super::flown::headline;
use super::motion::{nearest, signed_percent};
use super::planners::solved_runs;
use crate::admissible::verdict::ModeAnalysis;
use crate::admissible::without_yaw::planned::Provision;
use crate::certify::between::Shown;
use crate::diagnostic::{Diagnostic, Severity};
use crate::model::{Mission, Model, Problem};
use crate::number::{fixed, number, percent, short_seconds, significant};
use crate::planner::studies::{Comparison, MissionPlan, PlanOutcome, PlannerRun, Run, label};
use crate::read::OVERRIDE;
use crate::report::battery::BatteryRecord;
use crate::report::least_time;
use crate::report::plan_screen::CoverageRecord;
use crate::report::record::{PlannerRecord, Record};
use crate::report::shape::ShapeRecord;
use crate::report::simulation::{FlightRecord, OutcomeRecord, detection, length as flown_length, turned};
use crate::report::terminal::{in_planes, not_looked_at};
use crate::report::verdict_text::elsewhere;
use crate::report::waypoints::{waypoints, worst};
use crate::report::without_yaw;
use crate::tolerance::MOST_PAST_LIMIT;
use crate::verdict::Verdict;

/// The headline of the page with its figures and warnings.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Found {
    pub headline: String,
    /// Which fault modes the plan covers.
    pub coverage: Vec<CoverageRecord>,
    /// What covering them costs, in a sentence.
    pub price: Option<String>,
    pub figures: Vec<Figure>,
    /// Caveats of the plan, or why there is none.
    pub warnings: Vec<String>,
}

/// One key figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    pub name: &'static str,
    pub value: String,
    /// Its unit, reference or explanation.
    pub note: String,
    /// Whether it is outside the allowed range.
    pub is_bad: bool,
}

impl Figure {
    pub fn new(name: &'static str, value: impl Into<String>, note: impl Into<String>) -> Self {
        Figure { name, value: value.into(), note: note.into(), is_bad: false }
    }

    fn bad_if(self, is_bad: bool) -> Self {
        Figure { is_bad, ..self }
    }
}

/// For `mavc plan`: the trajectory written is that of the last run.
pub fn plan(problem: Problem, comparison: &Comparison, record: &Record) -> Found {
    let model = problem.model();
    let (Some(run), Some(planner)) = (comparison.runs.last(), record.planners.last()) else { return Found::default() };
    match &run.outcome {
        PlanOutcome::Planned(solved) => {
            let mut figures = vec![time(problem, run, solved)];
            figures.extend(margin(comparison, solved));
            figures.extend(stays(comparison, solved));
            figures.extend(waypoint_error(planner));
            figures.extend(planner.shape.iter().flat_map(|shape| shape_figures(problem.mission(), planner, shape)));
            figures.extend(planner.risk.map(|r| {
                let others = not_looked_at(model);
                let text = format!("probability that a fault strikes while the mission is committed to it.{others}");
                Figure::new("Risk", significant(r, 3), text.trim_end_matches('.'))
            }));
            figures.extend(planner.battery.as_ref().map(charge));
            figures.extend(shown_between(model, planner));
            let warnings = planner.warnings.iter().map(|c| c.message.clone()).collect();
            let price = planner
                .price
                .as_ref()
                .map(|price| format!("Price of covering the faults \u{2013} {}.", price.sentence));
            let (headline, coverage) = (planner.headline.clone(), planner.coverage.clone());
            Found { headline, coverage, price, figures, warnings }
        }
        _ => Found {
            headline: planner.headline.clone(),
            warnings: elsewhere(model, &record.found_at_s).into_iter().chain(conflict(record)).collect(),
            ..Found::default()
        },
    }
}

/// For `mavc compare`.
pub fn compare(mission: &Mission, comparison: &Comparison) -> Found {
    let solved: Vec<(&PlannerRun, &MissionPlan)> = solved_runs(comparison, Run::Own).collect();
    let times: Vec<String> = solved
        .iter()
        .filter(|(r, _)| r.against.len() != 1 || comparison.modes.len() == 1)
        .map(|(r, s)| format!("{} {} s", label(r.planner, &r.against), number(s.time)))
        .collect();
    let headline = match times.is_empty() {
        true => "No plan was found at a planner's own time".to_string(),
        false => format!("Shortest times: {}", times.join(", ")),
    };
    let common = comparison
        .common_time
        .map(|t| Figure::new("Common time T_d", format!("{} s", number(t)), "at which planners are compared"));
    let all: Vec<_> = solved.iter().flat_map(|(_, s)| waypoints(mission, s)).collect();
    let met = worst(&all).map_or("no plan meets them".to_string(), |worst| {
        let met = if all.iter().all(|w| w.met) { "met by every plan" } else { "missed by some plan" };
        format!("{met}; tightest: {}, {}", worst.quoted(), worst.largest())
    });
    let waypoints = Figure::new("Waypoints", mission.waypoints.len().to_string(), met);
    let beside = format!("in addition to the healthy set's{}", in_planes(comparison));
    let guarded = Figure::new("Facets RSP guards", comparison.selected.len().to_string(), beside);
    let figures = common.into_iter().chain([waypoints, guarded]).collect();
    Found { headline, figures, ..Found::default() }
}

/// For `mavc simulate`.
pub fn flight(model: &Model, record: &FlightRecord) -> Found {
    let lost = matches!(record.outcome, OutcomeRecord::Lost { .. } | OutcomeRecord::Diverged { .. })
        || matches!(record.outcome, OutcomeRecord::Trespassed { .. });
    let by_heading = matches!(record.outcome, OutcomeRecord::Lost { cause: "heading", .. });
    let mut figures = vec![
        Figure::new("Position error", flown_length(record.rms_error_m), "root mean square over the flight"),
        Figure::new("Largest position error", flown_length(record.max_error_m), "over the flight")
            .bad_if(lost && !by_heading),
    ];
    figures.extend(
        record
            .rms_error_after_m
            .map(|e| Figure::new("Error since the first fault", flown_length(e), "root mean square")),
    );
    let heading = format!("{} deg", fixed(record.max_heading_error_rad.to_degrees(), 1));
    let note = format!("from the planned heading{}", turned(record.turns));
    figures.push(Figure::new("Largest heading error", heading, note).bad_if(by_heading));
    let tilt = format!("{} deg", fixed(record.max_tilt_rad.to_degrees(), 1));
    figures.push(Figure::new(
        "Largest tilt",
        tilt,
        format!("along the {} plan of {} s", record.planner.to_uppercase(), number(record.plan_time_s)),
    ));
    figures.push(Figure::new(
        "False alarms",
        record.false_alarms.to_string(),
        format!("detection: {}", detection(record.detection, record.detection_delay_s)),
    ));
    let warnings = record.warnings.iter().map(|c| c.message.clone()).collect();
    Found { headline: headline(model, record), figures, warnings, ..Found::default() }
}

/// If some mode that the plan must tolerate cannot hover.
pub fn refused(model: &Model, analyses: &[ModeAnalysis], diagnostics: &[Diagnostic]) -> Found {
    let lost: Vec<&str> = model
        .plan
        .against
        .iter()
        .filter_map(|&i| analyses.get(i + 1))
        .filter(|a| !a.keeps_full_control())
        .map(|a| a.name.as_str())
        .collect();
    let which = match lost.as_slice() {
        [] => "the vehicle cannot hover".to_string(),
        [one] => format!("mode {one} does not keep full control at hover"),
        [first, rest @ ..] => format!("{first} and {} more modes do not keep full control at hover", rest.len()),
    };
    let errors = diagnostics.iter().filter(|d| d.severity == Severity::Error);
    let warnings = errors.map(|d| match &d.help {
        Some(help) => format!("{}. To fix it: {help}", capital(&d.message)),
        None => capital(&d.message),
    });
    Found { headline: format!("Nothing was planned: {which}"), warnings: warnings.collect(), ..Found::default() }
}

/// A text with its first letter in upper case.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

fn time(problem: Problem, run: &PlannerRun, solved: &MissionPlan) -> Figure {
    let model = problem.model();
    let gap = least_time::gap(problem, run).filter(|_| model.plan.chooses_times);
    let gap = gap.map_or(String::new(), |gap| format!("; {gap}"));
    let note = match (run.run, solved.infeasible_at) {
        (Run::Own, Some(t)) => {
            format!("shortest found; {} s is proved infeasible with {} samples{gap}", number(t), model.plan.samples)
        }
        (Run::Own, None) => format!("shortest found{gap}"),
        (Run::Common, _) => "required by the spec".into(),
    };
    Figure::new("Mission time", format!("{} s", number(solved.time)), note)
}

fn margin(comparison: &Comparison, solved: &MissionPlan) -> Option<Figure> {
    let mode = nearest(solved)?;
    let (name, outside) = (comparison.modes.get(mode)?, &solved.outside[mode]);
    let margin = -outside.max_violation;
    let of = if comparison.provisions[mode] == Provision::WithYaw { "set" } else { "core" };
    let note = format!("in the {of} of {name}, in widths of the healthy set");
    Some(Figure::new("Smallest spare", signed_percent(margin), note).bad_if(outside.last.is_some()))
}

fn stays(comparison: &Comparison, solved: &MissionPlan) -> Option<Figure> {
    let worst = comparison
        .modes
        .iter()
        .zip(&solved.outside)
        .filter_map(|(name, o)| Some((name, o, o.last?)))
        .max_by(|a, b| a.2.total_cmp(&b.2));
    match worst {
        _ if comparison.modes.is_empty() => None,
        None if without_yaw::without_rows(comparison).len() == comparison.modes.len() => None,
        None => Some(Figure::new(
            "Violations of fault sets",
            "none",
            match comparison.provisions.iter().all(|provision| *provision == Provision::WithYaw) {
                true => "the wrench is inside the set of every mode planned against at all times",
                false => "the motion is inside the set, or without yaw the core, of every mode with rows at all times",
            },
        )),
        Some((name, o, last)) => Some(
            Figure::new(
                "Last violation of a fault set",
                format!("{} s", fixed(last, 2)),
                format!("that of {name}, violated for {} s in total", short_seconds(o.seconds)),
            )
            .bad_if(true),
        ),
    }
}

/// The error with the largest share of its tolerance.
fn waypoint_error(planner: &PlannerRecord) -> Option<Figure> {
    let worst = worst(&planner.waypoints)?;
    let note = format!("of its tolerance: {}, at {}", worst.largest(), worst.quoted());
    Some(
        Figure::new("Tightest waypoint", percent(worst.share()), note).bad_if(planner.waypoints.iter().any(|w| !w.met)),
    )
}

/// Greatest height, largest deviation from a leg, and how far the yaw turns; bad where there is a remark.
fn shape_figures(mission: &Mission, planner: &PlannerRecord, shape: &ShapeRecord) -> Vec<Figure> {
    let ShapeRecord { height, deviation, yaw } = shape;
    let is_remarked = |kind: &str| planner.detours.iter().any(|detour| detour.kind == kind);
    let note = format!("{} ({})", height.relation(), height.place(mission));
    let mut figures = vec![
        Figure::new("Greatest height", height.value(), note).bad_if(is_remarked("climb")),
        Figure::new("Largest deviation from a leg", deviation.value(), deviation.place(mission))
            .bad_if(is_remarked("deviation")),
    ];
    figures.extend(yaw.as_ref().map(|yaw| Figure::new("Yaw turned", yaw.value(), yaw.relation())));
    figures
}

fn charge(battery: &BatteryRecord) -> Figure {
    let left = if battery.left < 0.0 { "none".to_string() } else { percent(battery.left) };
    let note = format!("takes {}; {} to keep", battery.used(), percent(battery.keep));
    Figure::new("Charge left", left, note).bad_if(battery.is_short())
}

fn shown_between(model: &Model, planner: &PlannerRecord) -> Option<Figure> {
    let between = planner.between_nodes.as_ref()?;
    let checked = between.iter().filter(|b| b.shown == Shown::Checked).count();
    let (value, note) = match checked {
        0 => {
            let winds = if model.environment().is_uncertain() { " in every wind" } else { "" };
            let within = percent(MOST_PAST_LIMIT);
            ("proved", format!("the imposed rows hold at every instant{winds}, to within {within}"))
        }
        n if n == between.len() => ("checked", "on a grid between the nodes".to_string()),
        n => ("partly proved", format!("{n} of {} kinds of rows are only checked on a grid", between.len())),
    };
    Some(Figure::new("Between the nodes", value, note))
}

/// The conflicting statements and the fixes that were found.
fn conflict(record: &Record) -> Vec<String> {
    let Some(conflict) = &record.conflict else { return Vec::new() };
    let mut ordered: Vec<_> = conflict.statements.iter().collect();
    // In the order of the text; statements of the command line come last.
    ordered.sort_by_key(|s| (s.file == OVERRIDE, &s.file, s.line));
    let statements: Vec<String> = ordered.iter().map(|s| format!("{}: {}", s.place, s.message)).collect();
    let head = match conflict.verdict {
        Verdict::ProvedInfeasible => "Proved infeasible: these statements cannot hold together",
        _ => "Not found: a plan that meets these statements together",
    };
    let fixes =
        conflict.fixes.iter().map(|f| format!("Tried, and gives a plan of {} s: {}", number(f.time_s), f.message));
    std::iter::once(format!("{head}: {}", statements.join("; "))).chain(fixes).collect()
}
