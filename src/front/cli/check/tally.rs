//! Counts of errors and warnings, of one spec and of several.

use crate::cli::spec::{self, Findings};
use crate::cli::{CommandError, Options, files};
use crate::diagnostic::{Diagnostic, Severity};
use crate::flight::equilibrium::outcomes;
use crate::number::plural;
use crate::report::analysis_screen::planned_against;
use crate::report::headline::{headline_of, why_undecided};
use crate::report::screen::{Screen, Tone};
use crate::spec::Spec;
use std::collections::HashSet;
use std::fmt;
use std::path::{Path, PathBuf};

/// The number of errors and of warnings.
#[derive(Debug, Clone, Copy, Default)]
pub struct Count {
    pub errors: usize,
    pub warnings: usize,
}

impl Count {
    pub fn of(diagnostics: &[Diagnostic]) -> Self {
        let of = |severity: Severity| diagnostics.iter().filter(|d| d.severity == severity).count();
        Count { errors: of(Severity::Error), warnings: of(Severity::Warning) }
    }
}

/// `no problems`, or `1 error, 2 warnings`.
impl fmt::Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.errors, self.warnings) {
            (0, 0) => f.write_str("no problems"),
            (0, w) => f.write_str(&plural(w, "warning")),
            (e, 0) => f.write_str(&plural(e, "error")),
            (e, w) => write!(f, "{}, {}", plural(e, "error"), plural(w, "warning")),
        }
    }
}

/// Where a diagnostic is and what it says: file, first and last byte, code, message and label.
type DiagnosticKey = (PathBuf, u32, u32, &'static str, [String; 2]);

/// Counts over several specs. A diagnostic that several specs share counts once.
#[derive(Default)]
pub struct Tally {
    printed: HashSet<DiagnosticKey>,
    count: Count,
    with_problems: usize,
    pub unreadable: usize,
    /// The files that the specs use.
    pub used: Vec<String>,
    /// Bad entries of folders.
    skipped: usize,
}

impl Tally {
    /// `skipped` entries of folders are bad.
    pub fn new(skipped: usize) -> Self {
        Tally { skipped, ..Tally::default() }
    }

    /// Counts the diagnostics of one spec and removes those that an earlier spec had; returns how many these were.
    pub fn take(&mut self, findings: &mut Findings) -> usize {
        let count = Count::of(&findings.diagnostics);
        self.with_problems += usize::from(count.errors + count.warnings > 0);
        let before = findings.diagnostics.len();
        let sources = &findings.files.sources;
        findings.diagnostics.retain(|d| {
            // One file may have several names.
            let file = Path::new(&sources.get(d.span.file).name);
            let file = std::fs::canonicalize(file).unwrap_or_else(|_| file.to_path_buf());
            self.printed.insert((file, d.span.start, d.span.end, d.code, [&d.message, &d.label].map(String::clone)))
        });
        let count = Count::of(&findings.diagnostics);
        self.count.errors += count.errors;
        self.count.warnings += count.warnings;
        before - findings.diagnostics.len()
    }

    /// `3 specs, 1 with problems: 1 error`
    pub fn summary(&self, specs: usize) -> String {
        let mut text = plural(specs, "spec");
        if self.with_problems > 0 {
            text += &format!(", {} with problems", self.with_problems);
        }
        if self.unreadable > 0 {
            text += &format!(", {} could not be read", self.unreadable);
        }
        match self.skipped {
            0 => {}
            1 => text += ", 1 entry skipped",
            n => text += &format!(", {n} entries skipped"),
        }
        let all_unreadable = self.unreadable == specs;
        if all_unreadable { text + "\n" } else { text + &format!(": {}\n", self.count) }
    }
}

impl Findings {
    /// Prints the diagnostics for people and, unless quiet, what the fault modes of a spec without errors leave of the
    /// vehicle, and a line that counts the diagnostics, before it if the spec `is_alone`; `repeated` of `count` were
    /// printed for an earlier spec.
    pub fn print_human(
        &self,
        name: &str,
        spec: Option<&Spec>,
        is_alone: bool,
        count: Count,
        repeated: usize,
        options: &Options,
    ) -> Result<(), CommandError> {
        files::print_as_it_is(&self.human(&std::io::stdout()))?;
        if options.quiet {
            return Ok(());
        }
        let left = spec.filter(|_| count.errors == 0).map(|spec| {
            let (model, indent) = (spec.model(), if is_alone { 0 } else { 2 });
            let mut screen = Screen::default();
            let outcomes = outcomes(model);
            screen.paragraph(Tone::Plain, indent, indent + 2, &headline_of(model, &outcomes));
            let why = why_undecided(model, &outcomes).filter(|_| is_alone);
            why.iter().for_each(|line| screen.paragraph(Tone::Plain, 0, 2, line));
            let against = planned_against(model).filter(|_| is_alone);
            against.iter().for_each(|line| screen.paragraph(Tone::Plain, 0, 2, line));
            screen
        });
        let above = if repeated > 0 { format!(" ({repeated} reported above)") } else { String::new() };
        let counted = format!("{}: {count}{above}\n", spec::shown(name));
        if is_alone {
            left.iter().try_for_each(files::print_screen)?;
            return files::print(&counted);
        }
        files::print(&counted)?;
        left.iter().try_for_each(files::print_screen)
    }
}
