//! Reports of plans and comparisons, for programs (docs/schema) and for people.

use super::planned::{Explained, Planning};
use super::tasks::Task;
use crate::certify::between::Between;
use crate::diagnostic::Diagnostic;
use crate::explain::diagnose::diagnose;
use crate::flight::capture::heights::CaptureHeights;
use crate::planner::studies::Comparison;
use crate::recovery::Recovery;
use crate::report::capture_height::{self, CaptureRecord};
use crate::report::conflict_record::ConflictRecord;
use crate::report::plan_screen::Answer;
use crate::report::record::Record;
use crate::report::screen::Screen;
use crate::report::{self, terminal};
use crate::spec::Spec;
use crate::text_table::{Table, indented};

// The path of a method of `Answer` stands for one lifetime only.
#[expect(clippy::redundant_closure_for_method_calls)]
impl Task<'_> {
    /// The report of a plan: `mavc plan --report`.
    pub fn report(&self, planning: &Planning, explained: &Explained, between: Option<Vec<Between>>) -> Record {
        let (problem, sources) = (self.problem(), self.spec().sources());
        let mut record = Record::new(problem, planning.comparison(), self.spec().sha256().into());
        record.conflict = explained.conflict.as_ref().map(|why| ConflictRecord::new(why, problem, sources));
        record.found_at_s = explained.nearby.times().collect();
        let heights = self.capture_heights(planning);
        let (coverage, price) = self.answered(planning, explained, heights.as_deref(), between.as_deref(), |answer| {
            (answer.coverage(), answer.price())
        });
        let mut record = self.with_captures(record, planning.comparison(), heights.as_deref());
        if let Some(planner) = record.planners.last_mut() {
            planner.between_nodes = between;
            planner.coverage = coverage;
            planner.price = price;
            if let Some(plan) = planning.plan() {
                planner.add_detours(problem, plan, planning.detours());
            }
        }
        record
    }

    /// What `look` makes of the answer for people.
    fn answered<T>(
        &self,
        planning: &Planning,
        explained: &Explained,
        heights: Option<&CaptureHeights>,
        between: Option<&[Between]>,
        look: impl FnOnce(&Answer) -> T,
    ) -> T {
        look(&Answer {
            problem: self.problem(),
            comparison: planning.comparison(),
            heights,
            exposed: &self.exposed(planning.comparison(), heights).pop().unwrap_or_default(),
            detours: planning.detours(),
            found_at: &explained.nearby.times().collect::<Vec<_>>(),
            between,
        })
    }

    /// The report of a plan for people: the text of `mavc plan`.
    pub fn text(&self, planning: &Planning, explained: &Explained, between: Option<&[Between]>) -> String {
        let heights = self.capture_heights(planning);
        let mut text = terminal::plan_with(self.problem(), planning.comparison(), heights.as_deref());
        if let Some(price) = self.answered(planning, explained, heights.as_deref(), between, |answer| answer.price()) {
            text.push_str(&indented(&format!("price: {}", price.sentence)));
        }
        if let Some(plan) = planning.plan() {
            text.push_str(&terminal::detours(self.problem(), plan, planning.detours()));
        }
        text.push_str(&terminal::elsewhere(self.model(), &explained.nearby.times().collect::<Vec<_>>()));
        if let Some(heights) = heights
            && let Some(record) = CaptureRecord::new(self.model(), &heights)
        {
            let exposed = self.exposed(planning.comparison(), Some(&heights)).pop().unwrap_or_default();
            text.push_str(&capture_height::text(&record, &exposed));
        }
        if let (Some(plan), Some(found)) = (planning.plan(), between) {
            text.push_str(&report::between::between(self.model(), plan, found));
        }
        text
    }

    /// The answer for people: one screen, or with `verbose` the whole report. `ways_out` are those that were sought.
    pub fn for_people(
        &self,
        planning: &Planning,
        explained: &Explained,
        between: Option<&[Between]>,
        ways_out: Option<&Recovery>,
        verbose: bool,
    ) -> Screen {
        let write = ways_out.map(|found| {
            move |screen: &mut Screen| {
                screen.gap();
                report::recovery::write(screen, self.model(), found, verbose);
            }
        });
        if verbose {
            let mut screen = Screen::of_text(&self.text(planning, explained, between));
            write.into_iter().for_each(|write| write(&mut screen));
            return screen;
        }
        let heights = self.capture_heights(planning);
        self.answered(planning, explained, heights.as_deref(), between, |answer| answer.screen(write))
    }

    /// The record with the captures and how long its plans are lower.
    fn with_captures(&self, record: Record, comparison: &Comparison, heights: Option<&CaptureHeights>) -> Record {
        let captures = heights.and_then(|heights| CaptureRecord::new(self.model(), heights));
        record.measured(captures, self.exposed(comparison, heights))
    }

    /// The conflict as a diagnostic of the spec that labels each of its statements.
    pub fn diagnose(&self, explained: &Explained) -> Option<Diagnostic> {
        let diagnostic = |why| diagnose(why, self.problem(), self.spec().sources());
        explained.conflict.as_ref().map(diagnostic)
    }

    /// The report of a comparison: `mavc compare --report`.
    pub fn comparison_report(&self, comparison: &Comparison) -> Record {
        let record = Record::new(self.problem(), comparison, self.spec().sha256().into());
        let heights = self.capture_heights_of(comparison);
        self.with_captures(record, comparison, heights.as_deref())
    }
}

/// The defaults that filled in for fields that the spec leaves out, as a table: `mavc check --explain-defaults`.
pub fn defaults_text(spec: &Spec) -> String {
    let mut table = Table::new(&["field", "default", "why"]);
    for d in &spec.model().defaults {
        table.row(vec![d.field.clone(), d.value.clone(), d.reason.clone()]);
    }
    table.render_left(0)
}
