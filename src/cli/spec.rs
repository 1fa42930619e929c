//! Reading specs for commands, and telling what was found in them.

use super::progress::Watch;
use super::{Options, Problem, SPEC_ERRORS, SpecArgs, files, links};
use crate::diagnostic::{Diagnostic, Severity, render_linked, render_short, sort, to_json_line};
use crate::model::{FileSet, FlightBlocks};
use crate::pipeline::{Refusal, Task};
use crate::source::{SourceMap, visible};
use crate::spec::{Compiled, Compiler, Parsed, Spec};
use crate::syntax::MAX_FILE_BYTES;
use std::borrow::Cow;
use std::io::IsTerminal;
use std::sync::Arc;

/// What is known about a spec that was read, beside the spec itself.
pub struct Told {
    pub files: Arc<FileSet>,
    pub diagnostics: Vec<Diagnostic>,
}

/// Whether a command can go on to plan.
pub enum Start<'s> {
    Task(Box<Task<'s>>),
    /// A mode that the plan must tolerate leaves no hover: the report says that nothing was planned.
    Refused,
    /// With this exit code.
    Ended(u8),
}

/// The spec as messages call it.
pub fn name(spec: &str) -> &str {
    if spec == "-" { "<stdin>" } else { spec }
}

/// The spec's name, on one line of a terminal.
pub fn shown(spec: &str) -> Cow<'_, str> {
    visible::line(name(spec))
}

fn compiler<'a>(args: &SpecArgs, watch: &'a Watch) -> Compiler<'a> {
    args.set.iter().fold(Compiler::new().observed_by(watch), Compiler::set)
}

/// Reads and parses: no spec yet, and no diagnostic that needs one.
pub fn parse(args: &SpecArgs, watch: &Watch) -> Result<Told, Problem> {
    let bytes = files::read_spec(&args.spec, MAX_FILE_BYTES)?;
    let Parsed { files, diagnostics, .. } = compiler(args, watch).parse(name(&args.spec), &bytes);
    Ok(Told { files: Arc::new(files), diagnostics })
}

/// Reads and compiles, for a command that may fly nothing. The spec is missing where it has errors.
pub fn read(args: &SpecArgs, flights: FlightBlocks, watch: &Watch) -> Result<(Option<Spec>, Told), Problem> {
    let bytes = files::read_spec(&args.spec, MAX_FILE_BYTES)?;
    let compiler = match flights {
        FlightBlocks::Used => compiler(args, watch),
        FlightBlocks::Unused => compiler(args, watch).without_flights(),
    };
    let Compiled { spec, diagnostics, files } = compiler.text(name(&args.spec), &bytes);
    Ok((spec, Told { files, diagnostics }))
}

impl Told {
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Error)
    }

    /// For people who read it on `stream`.
    pub fn human(&self, stream: &impl IsTerminal) -> String {
        human(&self.diagnostics, &self.files.sources, stream)
    }

    /// Tells one more thing about the spec on standard error.
    pub fn tell_also(&self, diagnostic: &Diagnostic) {
        files::tell_as_it_is(&human(std::slice::from_ref(diagnostic), &self.files.sources, &std::io::stderr()));
    }

    pub fn short(&self) -> String {
        render_short(&self.diagnostics, &self.files.sources)
    }

    pub fn json(&self) -> String {
        self.diagnostics.iter().map(|d| to_json_line(d, &self.files.sources) + "\n").collect()
    }

    /// Tells errors, and unless quiet everything else, on standard error.
    pub fn tell(&mut self, options: &Options) {
        if options.quiet {
            self.diagnostics.retain(|d| d.severity == Severity::Error);
        }
        files::tell_as_it_is(&self.human(&std::io::stderr()));
    }

    /// Tells what is new on standard error; what was told before is not repeated, and stays for the page.
    pub fn tell_new(&mut self, found: Vec<Diagnostic>, options: &Options) {
        let earlier = std::mem::replace(&mut self.diagnostics, found);
        self.tell(options);
        self.diagnostics.splice(0..0, earlier);
    }

    /// The task of a spec that was read, by [`Task::new`] or [`Task::to_compare`], once everything is told.
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
        self.tell(options);
        match prepared {
            Some(Ok(task)) => Start::Task(Box::new(task)),
            Some(Err(Refusal::Intolerable(_))) => Start::Refused,
            Some(Err(Refusal::NoMission(_) | Refusal::TooLarge(_))) | None => Start::Ended(SPEC_ERRORS),
        }
    }
}

/// Columns that `COLUMNS` can ask for: each line is as wide as that in memory.
const MOST_COLUMNS: usize = 1000;

/// Diagnostics for people who read them on `stream`.
pub fn human(diagnostics: &[Diagnostic], sources: &SourceMap, stream: &impl IsTerminal) -> String {
    let width = std::env::var("COLUMNS").ok().and_then(|c| c.parse().ok()).unwrap_or(100).clamp(20, MOST_COLUMNS);
    render_linked(diagnostics, sources, width, colored(stream), links::docs(stream).as_deref())
}

/// Colour where the stream is a terminal and NO_COLOR is not set.
pub fn colored(stream: &impl IsTerminal) -> bool {
    stream.is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|v| v.is_empty())
}
