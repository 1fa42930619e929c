//! The spec that a command is about, with its overrides, and the diagnostics found in it.

use super::progress::Watch;
use super::{CommandError, Options, SPEC_ERRORS, SpecArgs, files, links};
use crate::diagnostic::{Diagnostic, Severity, render_linked, render_short, sort, to_json_line};
use crate::foreign;
use crate::input::MAX_FILE_BYTES;
use crate::pipeline::{Refusal, Task};
use crate::read::{FileSet, FlightBlocks};
use crate::source::{SourceMap, visible};
use crate::spec::{Compiled, Compiler, Parsed, Spec};
use crate::text_table::WIDTH;
use std::borrow::Cow;
use std::io::IsTerminal;
use std::sync::Arc;

/// The files and diagnostics of a spec that was read.
pub struct Findings {
    pub files: Arc<FileSet>,
    pub diagnostics: Vec<Diagnostic>,
}

/// Whether a command can plan.
pub enum Start<'s> {
    Task(Box<Task<'s>>),
    /// A mode that the plan must tolerate cannot hover: the report says that nothing was planned.
    Refused,
    /// The command ends with this exit code.
    Ended(u8),
}

/// The spec's name in messages.
pub fn name(spec: &str) -> &str {
    if spec == "-" { "<stdin>" } else { spec }
}

/// The spec's name, on one line of a terminal.
pub fn shown(spec: &str) -> Cow<'_, str> {
    visible::line(name(spec))
}

/// Refuses the file of another tool where a command line names the spec of a vehicle.
///
/// # Errors
/// The file cannot be read, or is not a spec; the message names the command that makes one of it.
pub fn must_be_one(vehicle: &str) -> Result<(), CommandError> {
    let bytes = files::read_spec(vehicle, MAX_FILE_BYTES)?;
    match foreign::of_bytes(&bytes) {
        Some(kind) => {
            Err(format!("expected a spec, found {} in {}: {}", kind.what(), shown(vehicle), kind.help(vehicle)))
        }
        None => Ok(()),
    }
}

fn compiler<'a>(args: &SpecArgs, watch: &'a Watch) -> Compiler<'a> {
    args.set.iter().fold(Compiler::new().observed_by(watch), Compiler::set)
}

/// Reads and parses a spec, without the diagnostics of later stages.
pub fn parse(args: &SpecArgs, watch: &Watch) -> Result<Findings, CommandError> {
    let bytes = files::read_spec(&args.spec, MAX_FILE_BYTES)?;
    let Parsed { files, diagnostics, .. } = compiler(args, watch).parse(name(&args.spec), &bytes);
    Ok(Findings { files: Arc::new(files), diagnostics })
}

/// Reads and compiles a spec; `flights` says whether the command flies. The spec is `None` if it has errors.
pub fn read(args: &SpecArgs, flights: FlightBlocks, watch: &Watch) -> Result<(Option<Spec>, Findings), CommandError> {
    let bytes = files::read_spec(&args.spec, MAX_FILE_BYTES)?;
    let compiler = match flights {
        FlightBlocks::Used => compiler(args, watch),
        FlightBlocks::Unused => compiler(args, watch).without_flights(),
    };
    let Compiled { spec, diagnostics, files } = compiler.text(name(&args.spec), &bytes);
    Ok((spec, Findings { files, diagnostics }))
}

impl Findings {
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Error)
    }

    /// The diagnostics for people who read them on `stream`.
    pub fn human(&self, stream: &impl IsTerminal) -> String {
        human(&self.diagnostics, &self.files.sources, stream)
    }

    /// Prints one more diagnostic to standard error.
    pub fn eprint_also(&self, diagnostic: &Diagnostic) {
        files::eprint_as_it_is(&human(std::slice::from_ref(diagnostic), &self.files.sources, &std::io::stderr()));
    }

    pub fn short(&self) -> String {
        render_short(&self.diagnostics, &self.files.sources)
    }

    pub fn json(&self) -> String {
        self.diagnostics.iter().map(|d| to_json_line(d, &self.files.sources) + "\n").collect()
    }

    /// Prints errors, and unless quiet all other diagnostics, to standard error.
    pub fn eprint(&mut self, options: &Options) {
        if options.quiet {
            self.diagnostics.retain(|d| d.severity == Severity::Error);
        }
        files::eprint_as_it_is(&self.human(&std::io::stderr()));
    }

    /// Prints new diagnostics to standard error and adds them to those printed before, which the page shows too.
    pub fn eprint_new(&mut self, found: Vec<Diagnostic>, options: &Options) {
        let earlier = std::mem::replace(&mut self.diagnostics, found);
        self.eprint(options);
        self.diagnostics.splice(0..0, earlier);
    }

    /// Makes the task of a spec by `prepare` ([`Task::new`] or [`Task::to_compare`]), and prints all diagnostics.
    pub fn start<'s>(
        &mut self,
        spec: Option<&'s Spec>,
        prepare: fn(&'s Spec) -> Result<Task<'s>, Refusal>,
        options: &Options,
    ) -> Start<'s> {
        let prepared = spec.map(prepare);
        let remarks = prepared.as_ref().map_or(&[][..], |task| match task {
            Ok(task) => task.remarks(),
            Err(refusal) => refusal.diagnostics(),
        });
        self.diagnostics.extend_from_slice(remarks);
        sort(&mut self.diagnostics);
        self.eprint(options);
        match prepared {
            Some(Ok(task)) => Start::Task(Box::new(task)),
            Some(Err(Refusal::Intolerable(_))) => Start::Refused,
            Some(Err(Refusal::NoMission(_) | Refusal::TooLarge(_) | Refusal::TooLow(_))) | None => {
                Start::Ended(SPEC_ERRORS)
            }
        }
    }
}

/// The largest width taken from `COLUMNS`, instead of that of all texts: each line takes as much memory.
const MOST_COLUMNS: usize = 1000;

/// Diagnostics for people who read them on `stream`.
pub fn human(diagnostics: &[Diagnostic], sources: &SourceMap, stream: &impl IsTerminal) -> String {
    let width = std::env::var("COLUMNS").ok().and_then(|c| c.parse().ok()).unwrap_or(WIDTH).clamp(20, MOST_COLUMNS);
    render_linked(diagnostics, sources, width, links::colored(stream), links::docs(stream).as_deref())
}
