//! The results of a run: each has a place of its own, standard output takes one of them or the text for people, and files
//! appear together.

use super::spec::{Told, colored};
use super::target::{Target, cannot_write, write};
use super::{NO_PLAN, Options, Problem, files, plan};
use crate::diagnostic::Diagnostic;
use crate::pipeline::{Explained, Planning, Task};
use crate::planner::studies::Comparison;
use crate::report::page::{self, Kind, Subject};
use crate::report::record::Record;
use crate::source::visible;
use crate::spec::Spec;
use serde::Serialize;
use std::io::ErrorKind;
use std::path::Path;

/// The names that the arguments give.
#[derive(Default)]
pub struct Names<'a> {
    pub table: Option<&'a Path>,
    pub report: Option<&'a Path>,
    pub certificate: Option<&'a Path>,
    pub page: Option<&'a Path>,
    /// A folder.
    pub charts: Option<&'a Path>,
}

/// Where the results of one run go: apart from each other.
pub struct Places<'a> {
    names: Names<'a>,
    pub table: Option<Target>,
    pub report: Option<Target>,
    pub certificate: Option<Target>,
    pub page: Option<Target>,
}

impl<'a> Places<'a> {
    /// Finds every place, before minutes of work. Two results do not go to one.
    pub fn new(names: Names<'a>) -> Result<Self, Problem> {
        let target = |name: Option<&Path>| name.map(Target::new).transpose();
        let (table, report) = (target(names.table)?, target(names.report)?);
        if let (Some(a), Some(b)) = (&table, &report)
            && a.is_same(b)
        {
            return Err("the trajectory and the report would go to one place: give -o and --report two names".into());
        }
        let (certificate, page) = (target(names.certificate)?, target(names.page)?);
        apart("the certificate", "--certificate", &certificate, &[&table, &report])?;
        apart("the page", "--html", &page, &[&table, &report, &certificate])?;
        names.charts.map_or(Ok(()), is_folder)?;
        Ok(Places { names, table, report, certificate, page })
    }

    fn all(&self) -> impl Iterator<Item = &Target> {
        [&self.table, &self.report, &self.certificate, &self.page].into_iter().flatten()
    }

    /// Refuses places where a result would replace a file of the spec.
    pub fn spare(&self, told: &Told) -> Result<(), Problem> {
        let read = || told.files.sources.iter().map(|(_, source)| source.name.as_str());
        self.all().try_for_each(|target| target.must_spare(read()))
    }

    /// A mode cannot be tolerated: the report says that nothing was planned.
    pub fn refuse(&self, spec: Option<&Spec>, told: &Told, options: &Options) -> Result<u8, Problem> {
        let Some(spec) = spec else { return Ok(NO_PLAN) };
        let record = Record::refused(spec.model(), spec.sha256().into());
        let mut results = Results::new(self);
        results.report(&record)?;
        if let Some(mission) = spec.mission() {
            let subject =
                Subject { model: spec.model(), mission, sources: spec.sources(), diagnostics: &told.diagnostics };
            results.page(|| page::refused(&subject, &record));
        }
        results.write()?;
        results.note_page(options)?;
        Ok(NO_PLAN)
    }

    /// There is no plan to fly: the report is that of the plan.
    pub fn report_no_flight(
        &self,
        task: &Task,
        planning: &Planning,
        told: &Told,
        options: &Options,
    ) -> Result<u8, Problem> {
        let comparison = planning.comparison();
        let record = task.report(planning, &Explained::default(), None);
        let mut results = Results::new(self);
        results.report(&record)?;
        results.page(|| page::plans(Kind::Plan, &subject(task, &told.diagnostics), comparison, &record));
        results.print(&task.text(planning, &Explained::default(), None, results.are_coloured()))?;
        results.print("\nNo flight was simulated because there is no plan. Run `mavc plan` for details.\n")?;
        results.write()?;
        results.note_page(options)?;
        Ok(plan::code(planning.verdict()))
    }
}

/// What one run gives, until it is written.
pub struct Results<'p> {
    places: &'p Places<'p>,
    made: Vec<(&'p Target, String)>,
    charts: Vec<(Target, String)>,
}

impl<'p> Results<'p> {
    pub fn new(places: &'p Places<'p>) -> Self {
        Results { places, made: Vec::new(), charts: Vec::new() }
    }

    pub fn table(&mut self, text: String) {
        self.made.extend(self.places.table.as_ref().map(|target| (target, text)));
    }

    pub fn report(&mut self, record: &impl Serialize) -> Result<(), Problem> {
        let Some(target) = &self.places.report else { return Ok(()) };
        self.made.push((target, json(record)?));
        Ok(())
    }

    pub fn certificate(&mut self, record: &impl Serialize) -> Result<(), Problem> {
        let Some(target) = &self.places.certificate else { return Ok(()) };
        self.made.push((target, json(record)?));
        Ok(())
    }

    pub fn page(&mut self, make: impl FnOnce() -> String) {
        self.made.extend(self.places.page.as_ref().map(|target| (target, make())));
    }

    /// Draws the charts for a folder, which is made where it is missing. None goes where a file is read or another result
    /// goes.
    pub fn charts(&mut self, subject: &Subject, comparison: &Comparison) -> Result<(), Problem> {
        let Some(folder) = self.places.names.charts else { return Ok(()) };
        std::fs::create_dir_all(folder).map_err(|e| cannot_write(folder, &e))?;
        let drawn = page::figures(subject, comparison).map_err(|e| format!("cannot draw the charts: {e}"))?;
        let placed = |(name, text): (String, String)| {
            let target = Target::within(folder, &name)?;
            target.must_spare(subject.sources.iter().map(|(_, source)| source.name.as_str()))?;
            match self.places.all().any(|other| target.is_same(other)) {
                true => {
                    let shown = target.shown();
                    Err(format!("a chart and another result would go to {shown}: give --svg its own folder"))
                }
                false => Ok((target, text)),
            }
        };
        self.charts = drawn.into_iter().map(placed).collect::<Result<_, Problem>>()?;
        Ok(())
    }

    /// Whether standard output takes a result: it then has it to itself, and the text goes to standard error.
    pub fn take_stdout(&self) -> bool {
        self.made.iter().any(|(target, _)| target.is_stdout())
    }

    /// Writes everything; files appear together, or none does.
    pub fn write(&self) -> Result<(), Problem> {
        let made = self.made.iter().map(|(target, text)| (*target, text.as_str()));
        let charts = self.charts.iter().map(|(target, text)| (target, text.as_str()));
        write(&made.chain(charts).collect::<Vec<_>>())
    }

    /// Whether the text for people is in colour.
    pub fn are_coloured(&self) -> bool {
        if self.take_stdout() { colored(&std::io::stderr()) } else { colored(&std::io::stdout()) }
    }

    /// Prints the text for people, unless standard output takes a result.
    pub fn print(&self, text: &str) -> Result<(), Problem> {
        if self.take_stdout() { Ok(()) } else { files::print_painted(text) }
    }

    /// Prints the text for people on standard error where standard output takes a result, unless that is the report.
    pub fn print_beside(&self, text: &str) {
        if self.take_stdout() && !self.places.report.as_ref().is_some_and(Target::is_stdout) {
            files::tell_painted(text);
        }
    }

    /// Prints what one may do next, beside the text for people.
    pub fn hint(&self, text: &str, options: &Options) -> Result<(), Problem> {
        if self.take_stdout() || options.quiet { Ok(()) } else { files::print(text) }
    }

    /// Says where a result is, beside the text for people.
    pub fn note(&self, what: &str, name: Option<&Path>, options: &Options) -> Result<(), Problem> {
        name.map_or(Ok(()), |name| self.hint(&format!("{what} written to {}\n", files::shown(name)), options))
    }

    /// Says where page and charts are.
    pub fn note_page(&self, options: &Options) -> Result<(), Problem> {
        self.note("Page", self.places.names.page, options)?;
        self.note("Figures", self.places.names.charts, options)
    }
}

/// Refuses one place for two results; `called` is this one, given by `option`.
pub fn apart(called: &str, option: &str, result: &Option<Target>, others: &[&Option<Target>]) -> Result<(), Problem> {
    let Some(result) = result else { return Ok(()) };
    match others.iter().copied().flatten().any(|other| result.is_same(other)) {
        true => Err(format!("{called} and another result would go to one place: give {option} its own name")),
        false => Ok(()),
    }
}

/// Says early that no folder can be there: something else is, or is in its way.
fn is_folder(name: &Path) -> Result<(), Problem> {
    let there = name.ancestors().find(|a| a.as_os_str().is_empty() || a.symlink_metadata().is_ok());
    match there.filter(|a| !a.as_os_str().is_empty()) {
        Some(place) if !place.is_dir() => Err(cannot_write(name, &ErrorKind::NotADirectory.into())),
        _ => Ok(()),
    }
}

pub fn json(record: &impl Serialize) -> Result<String, Problem> {
    let text = serde_json::to_string_pretty(record).map_err(|e| format!("cannot write the report: {e}"))?;
    Ok(visible::json(text) + "\n")
}

/// What a page is about.
pub fn subject<'a>(task: &Task<'a>, diagnostics: &'a [Diagnostic]) -> Subject<'a> {
    Subject { model: task.model(), mission: task.mission(), sources: task.spec().sources(), diagnostics }
}
