//! From a file name to a model, with every diagnostic on the way.

use super::{Options, Problem, SpecArgs, files, links};
use crate::diagnostic::{Diagnostic, Severity, render_linked, render_short, sort, to_json_line};
use crate::input::read_named;
use crate::model::{
    FileSet, FlightBlocks, Model, OVERRIDE, Override, elaborate_for, entries, load_among, parse_override,
};
use crate::source::{SourceMap, visible};
use sha2::{Digest, Sha256};
use std::borrow::Cow;
use std::io::IsTerminal;
use std::time::Instant;

/// A spec as far as it could be understood.
pub struct Loaded {
    pub files: FileSet,
    /// `None` where an error stands in the way.
    pub model: Option<Model>,
    pub diagnostics: Vec<Diagnostic>,
}

/// The spec as messages call it.
pub fn name(spec: &str) -> &str {
    if spec == "-" { "<stdin>" } else { spec }
}

/// The spec's name, on one line of a terminal.
pub fn shown(spec: &str) -> Cow<'_, str> {
    visible::line(name(spec))
}

/// Reads and parses: no model yet, and no diagnostic that needs one.
pub fn parse(args: &SpecArgs, options: &Options) -> Result<(Loaded, Vec<Override>), Problem> {
    let begin = Instant::now();
    let bytes = files::read_spec(&args.spec, crate::syntax::MAX_FILE_BYTES)?;
    let name = name(&args.spec);
    let (mut files, mut diagnostics) = load_among(name, &bytes, &read_named, &entries);
    let mut overrides = Vec::new();
    for text in &args.set {
        match parse_override(text, &mut files.sources) {
            Ok(o) => overrides.push(o),
            Err(d) => diagnostics.push(d),
        }
    }
    timing(options, "parse", begin);
    Ok((Loaded { files, model: None, diagnostics }, overrides))
}

/// Reads, parses and elaborates, for a command that may fly nothing.
pub fn read(args: &SpecArgs, flights: FlightBlocks, options: &Options) -> Result<Loaded, Problem> {
    let (Loaded { files, mut diagnostics, .. }, overrides) = parse(args, options)?;
    let begin = Instant::now();
    let checked = elaborate_for(&files, &overrides, flights);
    let broken = diagnostics.iter().any(|d| d.severity == Severity::Error) || checked.has_errors();
    let model = checked.value.filter(|_| !broken);
    diagnostics.extend(checked.diagnostics);
    // Until every `--set` is understood, the spec is not the one that is meant, and warnings may be about the other.
    let of_set = |d: &Diagnostic| files.sources.get(d.span.file).name == OVERRIDE;
    if diagnostics.iter().any(|d| d.severity == Severity::Error && of_set(d)) {
        diagnostics.retain(|d| d.severity == Severity::Error);
    }
    sort(&mut diagnostics);
    timing(options, "model", begin);
    Ok(Loaded { files, model, diagnostics })
}

/// Hexadecimal digits of a finished hash.
pub fn hex(hash: Sha256) -> String {
    hash.finalize().iter().map(|b| format!("{b:02x}")).collect()
}

impl Loaded {
    /// Hash of all files that were read, each with its length, in the order they were named.
    pub fn sha256(&self) -> String {
        let mut hash = Sha256::new();
        for (_, source) in self.files.sources.iter() {
            hash.update((source.text.len() as u64).to_le_bytes());
            hash.update(source.text.as_bytes());
        }
        hex(hash)
    }

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

    /// Tells errors, and unless quiet all else, on standard error.
    pub fn tell(&mut self, options: &Options) {
        if options.quiet {
            self.diagnostics.retain(|d| d.severity == Severity::Error);
        }
        files::tell_as_it_is(&self.human(&std::io::stderr()));
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

pub fn timing(options: &Options, stage: &str, begin: Instant) {
    if options.timings {
        files::tell(&format!("{stage:<10} {:>9.2} ms\n", begin.elapsed().as_secs_f64() * 1e3));
    }
}
