use super::progress::Watch;
use super::spec::{self, Told};
use super::{CheckArgs, CheckFormat, Deny, FINE, NO_PLAN, Options, Problem, SPEC_ERRORS, SpecArgs};
use super::{files, specs, usage, watch};
use crate::admissible::diagnose::is_too_large;
use crate::diagnostic::{Diagnostic, Severity, sort};
use crate::model::FlightBlocks;
use crate::number::plural;
use crate::pipeline::check;
use crate::report::table::Table;
use std::collections::HashSet;
use std::path::{Path, PathBuf};

/// `mavc check`
pub fn run(args: &CheckArgs, options: &Options) -> Result<u8, Problem> {
    if args.explain_defaults && args.format != CheckFormat::Human {
        return Err("--explain-defaults prints a table for people: leave --format out".into());
    }
    if args.watch {
        return watch::run(args, options);
    }
    Ok(round(args, options)?.code)
}

/// What one look at all specs came to.
pub struct Round {
    /// The worst of all.
    pub code: u8,
    /// The specs and what they use, as named.
    pub files: Vec<String>,
}

/// Checks every spec once and prints what it finds. What is wrong with a file that several specs use is told once.
pub fn round(args: &CheckArgs, options: &Options) -> Result<Round, Problem> {
    let found = specs::find(&args.specs);
    let mut tally = Tally { passed_over: found.problems.len(), ..Tally::default() };
    let mut round = Round { code: found.tell(), files: found.specs.clone() };
    let found = found.specs;
    for name in &found {
        let outcome = one(name, args, options, &mut tally, &mut round.files);
        let code = outcome.unwrap_or_else(|problem| {
            tally.unreadable += 1;
            usage(&problem)
        });
        round.code = specs::worst([round.code, code]);
    }
    let is_alone = found.len() == 1 && !args.specs.iter().any(|name| Path::new(name).is_dir());
    if !is_alone && !found.is_empty() && !options.quiet && args.format == CheckFormat::Human {
        files::print(&tally.summary(found.len()))?;
    }
    Ok(round)
}

/// Over several specs, what several share counted once.
#[derive(Default)]
struct Tally {
    /// File, place, code, message and label.
    told: HashSet<(PathBuf, u32, u32, &'static str, [String; 2])>,
    errors: usize,
    warnings: usize,
    with_problems: usize,
    unreadable: usize,
    /// Entries of folders that are bad.
    passed_over: usize,
}

impl Tally {
    /// Counts the diagnostics of one spec and takes out those told before; how many these were.
    fn take(&mut self, loaded: &mut Told) -> usize {
        let (errors, warnings) = count(&loaded.diagnostics);
        self.with_problems += usize::from(errors + warnings > 0);
        let before = loaded.diagnostics.len();
        let sources = &loaded.files.sources;
        loaded.diagnostics.retain(|d| {
            // One file may go by several names.
            let file = Path::new(&sources.get(d.span.file).name);
            let file = std::fs::canonicalize(file).unwrap_or_else(|_| file.to_path_buf());
            self.told.insert((file, d.span.start, d.span.end, d.code, [&d.message, &d.label].map(String::clone)))
        });
        let (errors, warnings) = count(&loaded.diagnostics);
        self.errors += errors;
        self.warnings += warnings;
        before - loaded.diagnostics.len()
    }

    fn summary(&self, specs: usize) -> String {
        let mut text = plural(specs, "spec");
        if self.with_problems > 0 {
            text += &format!(", {} with problems", self.with_problems);
        }
        if self.unreadable > 0 {
            text += &format!(", {} could not be read", self.unreadable);
        }
        match self.passed_over {
            0 => {}
            1 => text += ", 1 entry passed over",
            n => text += &format!(", {n} entries passed over"),
        }
        let all_unreadable = self.unreadable == specs;
        if all_unreadable { text + "\n" } else { text + &format!(": {}\n", verdict(self.errors, self.warnings)) }
    }
}

fn one(
    name: &str,
    args: &CheckArgs,
    options: &Options,
    tally: &mut Tally,
    used: &mut Vec<String>,
) -> Result<u8, Problem> {
    let args_of_spec = SpecArgs { spec: name.into(), set: args.set.clone() };
    let (spec, mut loaded) = spec::read(&args_of_spec, FlightBlocks::Used, &Watch::new(options))?;
    used.extend(loaded.files.names());
    let mut code = if loaded.has_errors() { SPEC_ERRORS } else { FINE };
    if let Some(spec) = &spec {
        let found = check(spec);
        if found.iter().any(|d| d.severity == Severity::Error) {
            code = if is_too_large(&found) { SPEC_ERRORS } else { NO_PLAN };
        }
        loaded.diagnostics.extend(found);
        sort(&mut loaded.diagnostics);
    }
    let (errors, warnings) = count(&loaded.diagnostics);
    if args.deny == Some(Deny::Warnings) && warnings > 0 && code == FINE {
        code = SPEC_ERRORS;
    }
    let repeated = tally.take(&mut loaded);
    match args.format {
        CheckFormat::Json => files::print(&loaded.json())?,
        CheckFormat::Short => files::print(&loaded.short())?,
        CheckFormat::Human => {
            files::print_as_it_is(&loaded.human(&std::io::stdout()))?;
            if !options.quiet {
                let above = if repeated > 0 { format!(" ({repeated} told above)") } else { String::new() };
                files::print(&format!("{}: {}{above}\n", spec::shown(name), verdict(errors, warnings)))?;
            }
        }
    }
    if let Some(spec) = spec.as_ref().filter(|_| args.explain_defaults) {
        let mut table = Table::new(&["field", "default", "why"]);
        for d in &spec.model().defaults {
            table.row(vec![d.field.clone(), d.value.clone(), d.reason.clone()]);
        }
        files::print(&table.render_left(0))?;
    }
    Ok(code)
}

/// Errors and warnings.
fn count(diagnostics: &[Diagnostic]) -> (usize, usize) {
    let of = |severity: Severity| diagnostics.iter().filter(|d| d.severity == severity).count();
    (of(Severity::Error), of(Severity::Warning))
}

fn verdict(errors: usize, warnings: usize) -> String {
    match (errors, warnings) {
        (0, 0) => "no problems".into(),
        (0, w) => plural(w, "warning"),
        (e, 0) => plural(e, "error"),
        (e, w) => format!("{}, {}", plural(e, "error"), plural(w, "warning")),
    }
}
