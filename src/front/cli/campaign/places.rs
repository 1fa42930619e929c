//! The places that the rows, the report and the page of a campaign go to.

use super::{CampaignArgs, output};
use crate::cli::results::{self, apart};
use crate::cli::spec::Findings;
use crate::cli::target::{Target, write};
use crate::cli::{CommandError, Options, files};
use crate::report::campaign_record::CampaignRecord;
use crate::report::page::{self, Subject};
use crate::report::screen::Screen;
use crate::spec::Spec;
use std::path::Path;

/// The places, all different.
pub struct Places<'a> {
    pub rows: Option<Target>,
    report: Option<Target>,
    page: Option<Target>,
    page_name: Option<&'a Path>,
    /// The file of rows that were flown before (`--rows`).
    read: Option<&'a Path>,
}

impl<'a> Places<'a> {
    /// Finds every place before minutes of work.
    pub fn new(args: &'a CampaignArgs) -> Result<Self, CommandError> {
        let target = |name: Option<&Path>| name.map(Target::new).transpose();
        let (rows, report) = (target(args.output.as_deref())?, target(args.report.as_deref())?);
        let page = target(args.html.as_deref())?;
        rows_apart(&rows, &report)?;
        rows_apart(&rows, &page)?;
        apart("the page", "--html", &page, &[&report])?;
        Ok(Places { rows, report, page, page_name: args.html.as_deref(), read: args.rows.as_deref() })
    }

    /// Refuses places at which a result would replace a file that is read.
    pub fn spare(&self, findings: &Findings) -> Result<(), CommandError> {
        let read = || findings.files.sources.iter().map(|(_, source)| source.name.as_str());
        [&self.rows, &self.report, &self.page].into_iter().flatten().try_for_each(|t| t.must_spare(read()))?;
        let rows = self.read.and_then(Path::to_str);
        [&self.report, &self.page].into_iter().flatten().try_for_each(|target| target.must_spare(rows))
    }

    fn is_stdout(target: &Option<Target>) -> bool {
        target.as_ref().is_some_and(Target::is_stdout)
    }

    /// Prints the text for people: to standard error if standard output takes rows or a page, not at all if it takes
    /// the report.
    pub fn print(&self, text: &Screen) -> Result<(), CommandError> {
        match (Self::is_stdout(&self.report), Self::is_stdout(&self.page) || Self::is_stdout(&self.rows)) {
            (true, _) => Ok(()),
            (false, true) => {
                files::eprint_screen(text);
                Ok(())
            }
            (false, false) => files::print_screen(text),
        }
    }

    /// Prints the text for people, unless standard output takes the report or the page.
    pub fn print_alone(&self, text: &str) -> Result<(), CommandError> {
        match Self::is_stdout(&self.report) || Self::is_stdout(&self.page) {
            true => Ok(()),
            false => files::print(text),
        }
    }

    /// Writes the report and the page, and prints where the page is.
    pub fn write(
        &self,
        spec: &Spec,
        findings: &Findings,
        record: &CampaignRecord,
        options: &Options,
    ) -> Result<(), CommandError> {
        let report =
            self.report.as_ref().map(|target| Ok::<_, CommandError>((target, results::json(record)?))).transpose()?;
        let page = self.page.as_ref().zip(spec.problem()).map(|(target, problem)| {
            let subject = Subject { problem, sources: spec.sources(), diagnostics: &findings.diagnostics };
            (target, page::campaign(&subject, record))
        });
        let made: Vec<_> = report.iter().chain(&page).map(|(target, text)| (*target, text.as_bytes())).collect();
        write(&made)?;
        let is_silent = [&self.rows, &self.report, &self.page].into_iter().any(Self::is_stdout) || options.quiet;
        match self.page_name.filter(|_| !is_silent) {
            Some(name) => files::print(&format!("Page written to {}\n", files::shown(name))),
            None => Ok(()),
        }
    }
}

/// Refuses one place for the rows, or their `.part`, and another result.
fn rows_apart(rows: &Option<Target>, other: &Option<Target>) -> Result<(), CommandError> {
    let (Some(rows), Some(other)) = (rows, other) else { return Ok(()) };
    let part = rows.file().map(output::part_of);
    if rows.is_same(other) || part.is_some() && part.as_deref() == other.file() {
        return Err("the rows and another result have the same place: give each its own name".into());
    }
    Ok(())
}
