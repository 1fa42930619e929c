//! The results of a run. Each goes to a place of its own; standard output takes one of them or the text for people;
//! files appear together.

use super::spec::Findings;
use super::target::{Target, cannot_write, write};
use super::{CommandError, NO_PLAN, Options, code_of, files};
use crate::diagnostic::Diagnostic;
use crate::pipeline::{Explained, Planning, Task};
use crate::planner::studies::Comparison;
use crate::report::page::{self, Beside, PageKind, Subject};
use crate::report::record::Record;
use crate::report::screen::Screen;
use crate::source::{SourceMap, visible};
use crate::spec::Spec;
use serde::Serialize;
use std::io::ErrorKind;
use std::path::Path;

/// The names of the results, as given on the command line.
#[derive(Default)]
pub struct Names<'a> {
    pub table: Option<&'a Path>,
    pub report: Option<&'a Path>,
    pub certificate: Option<&'a Path>,
    pub page: Option<&'a Path>,
    pub layout: Option<&'a Path>,
    /// A folder.
    pub charts: Option<&'a Path>,
}

/// The places that the results of one run go to, all different.
pub struct Places<'a> {
    names: Names<'a>,
    pub table: Option<Target>,
    pub report: Option<Target>,
    pub certificate: Option<Target>,
    pub page: Option<Target>,
    pub layout: Option<Target>,
}

impl<'a> Places<'a> {
    /// Finds every place before minutes of work, and refuses one place for two results.
    pub fn new(names: Names<'a>) -> Result<Self, CommandError> {
        let target = |name: Option<&Path>| name.map(Target::new).transpose();
        let (table, report) = (target(names.table)?, target(names.report)?);
        if let (Some(a), Some(b)) = (&table, &report)
            && a.is_same(b)
        {
            return Err("-o and --report name the same place: give them different names".into());
        }
        let (certificate, page) = (target(names.certificate)?, target(names.page)?);
        apart("the certificate", "--certificate", &certificate, &[&table, &report])?;
        apart("the page", "--html", &page, &[&table, &report, &certificate])?;
        let layout = target(names.layout)?;
        apart("the layout", "--layout", &layout, &[&table, &report, &page])?;
        names.charts.map_or(Ok(()), is_folder)?;
        Ok(Places { names, table, report, certificate, page, layout })
    }

    fn all(&self) -> impl Iterator<Item = &Target> {
        [&self.table, &self.report, &self.certificate, &self.page, &self.layout].into_iter().flatten()
    }

    /// Refuses places at which a result would replace a file of the spec.
    pub fn spare(&self, findings: &Findings) -> Result<(), CommandError> {
        let read = || findings.files.sources.iter().map(|(_, source)| source.name.as_str());
        self.all().try_for_each(|target| target.must_spare(read()))
    }

    /// Writes the report of a mission that was not planned, because a mode that the plan must tolerate cannot hover.
    pub fn refuse(&self, spec: Option<&Spec>, findings: &Findings, options: &Options) -> Result<u8, CommandError> {
        let Some(spec) = spec else { return Ok(NO_PLAN) };
        let record = Record::refused(spec.model(), spec.sha256().into());
        let mut results = Results::new(self);
        results.report(&record)?;
        if let Some(problem) = spec.problem() {
            let subject = Subject { problem, sources: spec.sources(), diagnostics: &findings.diagnostics };
            results.page(|| page::refused(&subject, &record));
        }
        results.write()?;
        results.note_page(options)?;
        Ok(NO_PLAN)
    }

    /// Writes the report of the outcome of planning, because there is no plan to fly.
    pub fn report_no_flight(
        &self,
        task: &Task,
        planning: &Planning,
        findings: &Findings,
        options: &Options,
    ) -> Result<u8, CommandError> {
        let comparison = planning.comparison();
        let record = task.report(planning, &Explained::default(), None);
        let mut results = Results::new(self);
        results.report(&record)?;
        results.page(|| {
            page::plans(PageKind::Plan, &subject(task, &findings.diagnostics), comparison, &record, Beside::default())
        });
        results.print(&task.for_people(planning, &Explained::default(), None, None, options.verbose))?;
        let why = "\nNo flight was simulated because there is no plan. Run `mavc plan` for details.\n";
        results.print(&Screen::of_text(why))?;
        results.write()?;
        results.note_page(options)?;
        Ok(code_of(planning.verdict()))
    }
}

/// The results of one run, collected until they are written.
pub struct Results<'p> {
    places: &'p Places<'p>,
    made: Vec<(&'p Target, Vec<u8>)>,
    /// Files in folders.
    within: Vec<(Target, Vec<u8>)>,
}

impl<'p> Results<'p> {
    pub fn new(places: &'p Places<'p>) -> Self {
        Results { places, made: Vec::new(), within: Vec::new() }
    }

    pub fn table(&mut self, bytes: Vec<u8>) {
        self.made.extend(self.places.table.as_ref().map(|target| (target, bytes)));
    }

    pub fn layout(&mut self, text: String) {
        self.made.extend(self.places.layout.as_ref().map(|target| (target, text.into_bytes())));
    }

    pub fn report(&mut self, record: &impl Serialize) -> Result<(), CommandError> {
        let Some(target) = &self.places.report else { return Ok(()) };
        self.made.push((target, json(record)?.into_bytes()));
        Ok(())
    }

    pub fn certificate(&mut self, record: &impl Serialize) -> Result<(), CommandError> {
        let Some(target) = &self.places.certificate else { return Ok(()) };
        self.made.push((target, json(record)?.into_bytes()));
        Ok(())
    }

    pub fn page(&mut self, make: impl FnOnce() -> String) {
        self.made.extend(self.places.page.as_ref().map(|target| (target, make().into_bytes())));
    }

    /// Draws the charts into a folder.
    pub fn charts(&mut self, subject: &Subject, comparison: &Comparison) -> Result<(), CommandError> {
        let Some(folder) = self.places.names.charts else { return Ok(()) };
        let drawn = page::figures(subject, comparison).map_err(|e| format!("cannot draw the charts: {e}"))?;
        let files = drawn.into_iter().map(|(name, text)| (name, text.into_bytes()));
        self.folder("a chart", "--svg", folder, files, subject.sources)
    }

    /// Takes files for a folder, which is created if it is missing. Such a file, `called` so in messages, replaces
    /// neither one that is read nor another result.
    pub fn folder(
        &mut self,
        called: &str,
        option: &str,
        folder: &Path,
        files: impl IntoIterator<Item = (String, Vec<u8>)>,
        read: &SourceMap,
    ) -> Result<(), CommandError> {
        std::fs::create_dir_all(folder).map_err(|e| cannot_write(folder, &e))?;
        let placed = |(name, bytes): (String, Vec<u8>)| {
            let target = Target::within(folder, &name)?;
            target.must_spare(read.iter().map(|(_, source)| source.name.as_str()))?;
            let mut others = self.places.all().chain(self.within.iter().map(|(target, _)| target));
            match others.any(|other| target.is_same(other)) {
                true => {
                    let shown = target.shown();
                    Err(format!(
                        "{called} and another result have the same place {shown}: give {option} its own folder"
                    ))
                }
                false => Ok((target, bytes)),
            }
        };
        let placed = files.into_iter().map(placed).collect::<Result<Vec<_>, CommandError>>()?;
        self.within.extend(placed);
        Ok(())
    }

    /// Whether standard output takes a result. The text for people then goes to standard error.
    pub fn take_stdout(&self) -> bool {
        self.made.iter().any(|(target, _)| target.is_stdout())
    }

    /// Writes everything: files appear together, or none does.
    pub fn write(&self) -> Result<(), CommandError> {
        let made = self.made.iter().map(|(target, bytes)| (*target, bytes.as_slice()));
        let within = self.within.iter().map(|(target, bytes)| (target, bytes.as_slice()));
        write(&made.chain(within).collect::<Vec<_>>())
    }

    /// Prints the text for people, unless standard output takes a result.
    pub fn print(&self, text: &Screen) -> Result<(), CommandError> {
        if self.take_stdout() { Ok(()) } else { files::print_screen(text) }
    }

    /// Prints the text for people to standard error if standard output takes a result other than the report.
    pub fn print_beside(&self, text: &Screen) {
        if self.take_stdout() && !self.places.report.as_ref().is_some_and(Target::is_stdout) {
            files::eprint_screen(text);
        }
    }

    /// Prints a hint at what to do next after the text for people, unless quiet.
    pub fn hint(&self, text: &str, options: &Options) -> Result<(), CommandError> {
        if self.take_stdout() || options.quiet { Ok(()) } else { files::print(text) }
    }

    /// Prints where a result is, after the text for people, unless quiet.
    pub fn note(&self, what: &str, name: Option<&Path>, options: &Options) -> Result<(), CommandError> {
        name.map_or(Ok(()), |name| self.hint(&format!("{what} written to {}\n", files::shown(name)), options))
    }

    /// Prints where the page and the charts are.
    pub fn note_page(&self, options: &Options) -> Result<(), CommandError> {
        self.note("Page", self.places.names.page, options)?;
        self.note("Figures", self.places.names.charts, options)
    }
}

/// Refuses one place for two results. `called` is the result that `option` names.
pub fn apart(
    called: &str,
    option: &str,
    result: &Option<Target>,
    others: &[&Option<Target>],
) -> Result<(), CommandError> {
    let Some(result) = result else { return Ok(()) };
    match others.iter().copied().flatten().any(|other| result.is_same(other)) {
        true => Err(format!("{called} and another result have the same place: give {option} its own name")),
        false => Ok(()),
    }
}

/// Refuses a folder that cannot be created because its name, or a part of it, is a file.
pub fn is_folder(name: &Path) -> Result<(), CommandError> {
    let there = name.ancestors().find(|a| a.as_os_str().is_empty() || a.symlink_metadata().is_ok());
    match there.filter(|a| !a.as_os_str().is_empty()) {
        Some(place) if !place.is_dir() => Err(cannot_write(name, &ErrorKind::NotADirectory.into())),
        _ => Ok(()),
    }
}

pub fn json(record: &impl Serialize) -> Result<String, CommandError> {
    let text = serde_json::to_string_pretty(record).map_err(|e| format!("cannot write the report: {e}"))?;
    Ok(visible::json(text) + "\n")
}

/// A record as JSON on one line.
pub fn compact_json(record: &impl Serialize) -> Result<String, CommandError> {
    let text = serde_json::to_string(record).map_err(|e| e.to_string())?;
    Ok(visible::json(text) + "\n")
}

/// The subject of a page.
pub fn subject<'a>(task: &'a Task<'_>, diagnostics: &'a [Diagnostic]) -> Subject<'a> {
    Subject { problem: task.problem(), sources: task.spec().sources(), diagnostics }
}
