//! The report as one page that a browser opens without a network (`--html`): results as text and tables, and the data
//! behind them for the charts of `assets/page`.
//!
//! Texts and numbers are made here, once, for the page and for the files of `--svg`; the script only draws. Without its
//! script the page still has every result that matters.

mod airframe;
mod analysis;
mod binding_table;
mod capture;
mod chart;
mod content;
mod document;
mod embed;
mod flown;
mod instants;
pub mod live;
mod motion;
mod opening;
pub(super) mod outline;
mod path_harm;
mod planners;
mod prose;
mod recovery;
mod sets;
mod spec;
mod summary;
mod survival;
mod svg;
mod table;
mod verdicts;
mod volumes;
mod waypoint_table;
mod ways;

use crate::admissible::verdict::ModeAnalysis;
use crate::diagnostic::Diagnostic;
use crate::flight::capture::Capture;
use crate::flight::equilibrium::analyze_each;
use crate::model::{Model, Problem};
use crate::planner::studies::{Comparison, PlanOutcome, Run};
use crate::recovery::Recovery;
use crate::report::campaign_record::CampaignRecord;
use crate::report::record::Record;
use crate::report::simulation::FlightRecord;
use crate::source::SourceMap;
use content::Content;
use document::{About, Document, Section};
pub use flown::Track;
use serde::Serialize;

/// Most modes whose sets, margins and strips are shown; if there are more, those with the smallest margins.
const MOST_MODES: usize = 24;

/// The subject of a page.
#[derive(Clone, Copy)]
pub struct Subject<'a> {
    pub problem: Problem<'a>,
    pub sources: &'a SourceMap,
    /// Shown at their places in the spec.
    pub diagnostics: &'a [Diagnostic],
}

/// The command that a page reports on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PageKind {
    Plan,
    Compare,
}

/// What a plan's page shows beside the plan.
#[derive(Clone, Copy, Default)]
pub struct Beside<'a> {
    /// Those that are drawn over delays.
    pub captures: &'a [Capture],
    /// The ways out, if they were sought.
    pub recovery: Option<&'a Recovery>,
}

/// The page of `mavc plan` or `mavc compare`; `record` is the JSON report. Complete HTML, the same for the same input.
pub fn plans(
    kind: PageKind,
    subject: &Subject,
    comparison: &Comparison,
    record: &Record,
    Beside { captures, recovery: found }: Beside,
) -> String {
    let problem = subject.problem;
    let (model, mission) = (problem.model(), problem.mission());
    let analyses = analyze_each(model);
    let shown = sets::shown(model, comparison);
    let mut content = Content::of_plans(subject, comparison, &shown, record).with_places(&analyses);
    content.ways = found.map_or(Vec::new(), |found| ways::contents(model, found));
    let mut sections = vec![Section::new("modes", "Modes", verdicts::section(model, comparison, &analyses))];
    if kind == PageKind::Plan {
        if let Some(section) = recovery::section(record) {
            sections.insert(0, section);
        }
        sections.extend(record.planners.last().and_then(waypoint_table::section));
        sections.extend(record.planners.last().and_then(|planner| volumes::section(problem, planner)));
        sections.extend(record.planners.last().and_then(|planner| binding_table::section(mission, planner)));
        sections.extend(capture::section(record, captures));
    } else {
        sections.insert(0, Section::new("planners", "Planners", planners::section(mission, comparison, record)));
    }
    let picture = (!content.runs.is_empty()).then(|| document::picture(!comparison.modes.is_empty()));
    sections.extend(picture.is_some().then(document::motion));
    sections.push(document::sets());
    sections.push(Section::new("spec", "Spec", spec::section(subject.sources, subject.diagnostics)));
    let found = match kind {
        PageKind::Plan => summary::plan(problem, comparison, record),
        PageKind::Compare => summary::compare(mission, comparison),
    };
    let about = About::of_mission(subject.problem, Some(comparison));
    Document { about, found, drawing: None, picture, sections, content }.render()
}

/// The charts of the plan (or of every planner's plan at the common time) and the sections of the sets, as names and
/// texts of SVG files.
///
/// # Errors
/// The drawing library's message if it cannot draw.
pub fn figures(subject: &Subject, comparison: &Comparison) -> Result<Vec<(String, String)>, String> {
    svg::files(&Content::of_plans(subject, comparison, &sets::shown(subject.problem.model(), comparison), &()))
}

/// The page if some mode that the plan must tolerate cannot hover: nothing was planned.
pub fn refused(subject: &Subject, record: &Record) -> String {
    let model = subject.problem.model();
    let analyses = analyze_each(model);
    let content = Content::of_sets(subject, &sets::declared(model), record).with_places(&analyses);
    let found = summary::refused(model, &analyses, subject.diagnostics);
    let sections = vec![
        Section::new("modes", "Modes", verdicts::refused(model, &analyses)),
        document::sets(),
        Section::new("spec", "Spec", spec::section(subject.sources, subject.diagnostics)),
    ];
    let about = About::of_mission(subject.problem, None);
    Document { about, found, drawing: None, picture: None, sections, content }.render()
}

/// The page of `mavc simulate`: the flight first, then the plan that it follows.
pub fn flight(subject: &Subject, comparison: &Comparison, track: Track, record: &FlightRecord) -> String {
    let model = subject.problem.model();
    let analyses = analyze_each(model);
    let shown = sets::shown(model, comparison);
    let mut content = Content::of_plans(subject, comparison, &shown, record).with_places(&analyses);
    for plan in &mut content.runs {
        plan.label = format!("the plan ({})", plan.label);
    }
    content.runs.insert(0, track.run(model, record));
    let content = content.showing(0);
    let picture = Some(document::picture(!comparison.modes.is_empty()));
    let sections = vec![
        Section::new("faults", "Faults", flown::section(record)),
        Section::new("modes", "Modes", verdicts::section(model, comparison, &analyses)),
        document::motion(),
        document::sets(),
        Section::new("spec", "Spec", spec::section(subject.sources, subject.diagnostics)),
    ];
    let found = summary::flight(model, record);
    let about = About::of_mission(subject.problem, Some(comparison));
    Document { about, found, drawing: None, picture, sections, content }.render()
}

/// The page of `mavc campaign`.
pub fn campaign(subject: &Subject, record: &CampaignRecord) -> String {
    let model = subject.problem.model();
    let analyses = analyze_each(model);
    let content = Content::of_sets(subject, &sets::declared(model), record).with_places(&analyses);
    let sections = vec![
        Section::new("planners", "Planners", survival::table(record)),
        Section::new("map", "Map", survival::maps(record)),
        Section::new("path", "Path", path_harm::tables(record)),
        Section::new("agreement", "Agreement", survival::agreement(record)),
        Section::new("modes", "Modes", verdicts::refused(model, &analyses)),
        document::sets(),
        Section::new("spec", "Spec", spec::section(subject.sources, subject.diagnostics)),
    ];
    let found = survival::found(record);
    let about = About::of_mission(subject.problem, None);
    Document { about, found, drawing: None, picture: None, sections, content }.render()
}

/// The page of `mavc analyze`; `modes` are those of `mavc::analyze`, and `record` is the JSON report. It needs no
/// mission.
pub fn analysis(
    model: &Model,
    sources: &SourceMap,
    diagnostics: &[Diagnostic],
    modes: &[ModeAnalysis],
    record: &impl Serialize,
) -> String {
    let content = Content::of_model(model, &sets::declared(model), record).with_places(modes);
    let sections = vec![
        Section::new("modes", "Margins", verdicts::details(model, modes)),
        document::sets(),
        Section::new("spec", "Spec", spec::section(sources, diagnostics)),
    ];
    let about = About { heading: format!("Vehicle {}", model.vehicle.name), model, setting: String::new() };
    let drawing = Some(airframe::drawing(model));
    let picture = Some(analysis::table(model, modes));
    Document { about, found: analysis::found(model, modes), drawing, picture, sections, content }.render()
}

/// The run that the page shows first: that of the spec's own planner at T_d, otherwise the last one with a plan.
fn shown_first(model: &Model, comparison: &Comparison) -> Option<usize> {
    let solved = |i: &usize| matches!(comparison.runs[*i].outcome, PlanOutcome::Planned(_));
    let own = |i: &usize| comparison.runs[*i].planner == model.plan.planner;
    let common = |i: &usize| comparison.runs[*i].run == Run::Common;
    let all = || (0..comparison.runs.len()).filter(solved);
    all().filter(own).rfind(common).or_else(|| all().rfind(own)).or_else(|| all().next_back())
}
