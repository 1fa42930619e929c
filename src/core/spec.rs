//! Specs, and the compiler that makes one from a text.
//!
//! - What comes in: texts, files that they use, overrides.
//! - What goes out: a [`Spec`] with its [`Model`], or diagnostics.
//! - What it does not know: admissible sets, planners, flights.

pub mod model;
pub mod read;

use crate::diagnostic::{Diagnostic, Severity, render_human, sort};
use crate::input::read_named;
use crate::model::{Mission, Model, Problem};
use crate::read::{FileSet, FlightBlocks, OVERRIDE, Override, elaborate_for, entries, load_among, parse_override};
use crate::source::{Source, SourceMap};
use crate::stages::{Silent, Stages, timed};
use crate::text_table::WIDTH;
use sha2::{Digest, Sha256};
use std::error::Error;
use std::fmt;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::sync::Arc;

/// A spec without errors: names resolved, units and ranges checked, every number finite and in SI units.
///
/// Only a [`Compiler`] makes one (`mavc::compile` and `mavc::Builder` use it), so all functions that take a `Spec` rely
/// on this.
#[derive(Debug, Clone)]
pub struct Spec {
    model: Model,
    files: Arc<FileSet>,
    overrides: Vec<Override>,
    flights: FlightBlocks,
    sha256: String,
}

impl Spec {
    /// The vehicle, fault modes, mission and settings in SI units.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// The mission; `None` if the spec describes only vehicles or faults.
    pub fn mission(&self) -> Option<&Mission> {
        self.model.mission.as_ref()
    }

    /// The model with its mission; `None` if the spec has no mission.
    pub fn problem(&self) -> Option<Problem<'_>> {
        Problem::of(&self.model)
    }

    /// The texts that the spec was read from.
    pub fn sources(&self) -> &SourceMap {
        &self.files.sources
    }

    /// The parsed files and tables that the spec was read from.
    pub fn files(&self) -> &FileSet {
        &self.files
    }

    /// SHA-256 of all texts that were read, including the overrides, each with its length, in the order in which they
    /// were named; 64 hexadecimal digits. A certificate identifies its spec by it.
    pub fn sha256(&self) -> &str {
        &self.sha256
    }

    /// This spec with one more field overridden, as by `--set`: `vehicle.mass=2kg`.
    ///
    /// # Errors
    /// The override has an error, or the spec has errors with it.
    ///
    /// ```
    /// let spec = mavc::compile(mavc::TEMPLATE).into_result()?;
    /// assert_eq!(spec.set("vehicle.mass = 2 kg")?.model().vehicle.mass, 2.0);
    /// assert!(spec.set("vehicle.mass = 2 m").is_err());
    /// # Ok::<(), mavc::CompileError>(())
    /// ```
    pub fn set(&self, text: &str) -> Result<Spec, CompileError> {
        let mut files = FileSet::clone(&self.files);
        let mut overrides = self.overrides.clone();
        match parse_override(text, &mut files.sources) {
            Ok(understood) => overrides.push(understood),
            Err(diagnostic) => return Err(CompileError { diagnostics: vec![diagnostic], files: Arc::new(files) }),
        }
        elaborated(files, overrides, self.flights, Vec::new()).into_result()
    }

    /// What distinguishes this spec from every other one.
    pub fn identity(&self) -> SpecIdentity {
        let campaign = &self.model.campaign;
        SpecIdentity { sha256: self.sha256.clone(), campaign: (campaign.times, campaign.seeds) }
    }

    /// This spec with another size of its campaign, within the bounds of `mavc::campaign::cases`.
    pub fn with_campaign(&self, times: usize, seeds: usize) -> Self {
        let mut spec = self.clone();
        (spec.model.campaign.times, spec.model.campaign.seeds) = (times, seeds);
        spec
    }
}

/// Two specs with the same identity are the same spec.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SpecIdentity {
    /// The hash of all texts, including the overrides.
    sha256: String,
    /// Instants and seeds, which `mavc campaign` can change without a text.
    campaign: (usize, usize),
}

/// The result of compiling a text: a spec if there are no errors, and every diagnostic.
#[derive(Debug, Clone)]
pub struct Compiled {
    /// `None` if there is an error.
    pub spec: Option<Spec>,
    /// Errors, warnings and advice, in the order in which they are shown.
    pub diagnostics: Vec<Diagnostic>,
    /// The texts that the diagnostics refer to.
    pub files: Arc<FileSet>,
}

impl Compiled {
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Error)
    }

    /// The diagnostics for people, with excerpts of the text, at most 100 columns wide and without colour.
    pub fn render(&self) -> String {
        render_human(&self.diagnostics, &self.files.sources, WIDTH, false)
    }

    /// The spec.
    ///
    /// # Errors
    /// The text has errors; the error lists them, and its `Display` shows them with excerpts.
    pub fn into_result(self) -> Result<Spec, CompileError> {
        match self.spec {
            Some(spec) => Ok(spec),
            None => Err(CompileError { diagnostics: self.diagnostics, files: self.files }),
        }
    }
}

/// The diagnostics of a text that is not a spec; at least one is an error.
#[derive(Clone)]
pub struct CompileError {
    pub diagnostics: Vec<Diagnostic>,
    /// The texts that the diagnostics refer to.
    pub files: Arc<FileSet>,
}

impl fmt::Display for CompileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(render_human(&self.diagnostics, &self.files.sources, WIDTH, false).trim_end())
    }
}

/// The text of `Display` on a new line, because a `main` that returns the error prints it so.
impl fmt::Debug for CompileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\n{self}")
    }
}

impl Error for CompileError {}

/// Reads the file at a path.
type Reader<'a> = &'a dyn Fn(&Path) -> io::Result<Vec<u8>>;

/// Compiles specs from files or texts, with overrides, and with or without their flights.
#[derive(Clone)]
pub struct Compiler<'a> {
    read: Reader<'a>,
    overrides: Vec<String>,
    flights: FlightBlocks,
    observer: &'a dyn Stages,
}

impl Default for Compiler<'_> {
    fn default() -> Self {
        Compiler { read: &read_named, overrides: Vec::new(), flights: FlightBlocks::Used, observer: &Silent }
    }
}

/// A text that is parsed but not elaborated.
pub struct Parsed {
    pub files: FileSet,
    pub overrides: Vec<Override>,
    pub diagnostics: Vec<Diagnostic>,
}

impl<'a> Compiler<'a> {
    /// A compiler that reads named files from the disk, without overrides; mistakes in `simulate` and `campaign` are
    /// errors.
    pub fn new() -> Self {
        Compiler::default()
    }

    /// Overrides a field, as by `--set`: `plan.time=20s`.
    pub fn set(mut self, text: impl Into<String>) -> Self {
        self.overrides.push(text.into());
        self
    }

    /// Treats mistakes in `simulate` and `campaign` as warnings, and ignores a block with a mistake.
    pub fn without_flights(mut self) -> Self {
        self.flights = FlightBlocks::Unused;
        self
    }

    /// Reads the files that a spec names by `read`. A relative path is relative to the same folder as the spec's own
    /// name.
    pub fn reading(mut self, read: Reader<'a>) -> Self {
        self.read = read;
        self
    }

    /// Reports the stages `parse` and `model` to an observer.
    pub fn observed_by(mut self, observer: &'a dyn Stages) -> Self {
        self.observer = observer;
        self
    }

    /// Compiles a file.
    ///
    /// # Errors
    /// The file cannot be read. If a file that it names cannot be read, this is a diagnostic instead.
    pub fn file(&self, path: impl AsRef<Path>) -> io::Result<Compiled> {
        let path = path.as_ref();
        Ok(self.text(&path.display().to_string(), &std::fs::read(path)?))
    }

    /// Compiles a text. Diagnostics show `name`, and paths in the text are relative to its folder.
    pub fn text(&self, name: &str, bytes: &[u8]) -> Compiled {
        let Parsed { files, overrides, diagnostics } = self.parse(name, bytes);
        timed(self.observer, "model", || elaborated(files, overrides, self.flights, diagnostics))
    }

    /// Parses a text, the files that it names, and the overrides, without the diagnostics of later stages.
    pub fn parse(&self, name: &str, bytes: &[u8]) -> Parsed {
        timed(self.observer, "parse", || {
            let (mut files, mut diagnostics) = load_among(name, bytes, self.read, &entries);
            let mut overrides = Vec::new();
            for text in &self.overrides {
                match parse_override(text, &mut files.sources) {
                    Ok(understood) => overrides.push(understood),
                    Err(diagnostic) => diagnostics.push(diagnostic),
                }
            }
            diagnostics.extend(files.bring_tables_of(&overrides, self.read, &entries));
            Parsed { files, overrides, diagnostics }
        })
    }
}

/// Elaborates parsed files; `diagnostics` are those of parsing.
fn elaborated(
    files: FileSet,
    overrides: Vec<Override>,
    flights: FlightBlocks,
    mut diagnostics: Vec<Diagnostic>,
) -> Compiled {
    let checked = elaborate_for(&files, &overrides, flights);
    let broken = diagnostics.iter().any(|d| d.severity == Severity::Error) || checked.has_errors();
    let model = checked.value.filter(|_| !broken);
    diagnostics.extend(checked.diagnostics);
    // If an override has an error, the spec is not the intended one, and warnings about it could mislead.
    let of_set = |d: &Diagnostic| files.sources.get(d.span.file).name == OVERRIDE;
    if diagnostics.iter().any(|d| d.severity == Severity::Error && of_set(d)) {
        diagnostics.retain(|d| d.severity == Severity::Error);
    }
    sort(&mut diagnostics);
    let sha256 = sha256(&files.sources);
    let files = Arc::new(files);
    let spec = model.map(|model| Spec { model, files: files.clone(), overrides, flights, sha256 });
    Compiled { spec, diagnostics, files }
}

/// The hash of all texts in order, each with its length. How much a search may take is not part of what a plan must
/// satisfy: a certificate is one for the spec whatever the `--effort`.
fn sha256(sources: &SourceMap) -> String {
    let mut hash = Sha256::new();
    let is_effort = |source: &Source| source.name == OVERRIDE && source.text.starts_with("plan.effort");
    for (_, source) in sources.iter().filter(|(_, source)| !is_effort(source)) {
        hash.update((source.text.len() as u64).to_le_bytes());
        hash.update(source.text.as_bytes());
    }
    hex(hash)
}

/// Hexadecimal digits of a finished hash.
fn hex(hash: Sha256) -> String {
    hash.finalize().iter().map(|b| format!("{b:02x}")).collect()
}

/// SHA-256 of the running program, because another build may give other numbers; of no bytes if the program cannot be
/// read.
pub fn program_sha256() -> String {
    let mut hash = Sha256::new();
    if let Ok(mut file) = std::env::current_exe().and_then(File::open) {
        let mut piece = [0; 1 << 16];
        while let Ok(length @ 1..) = file.read(&mut piece) {
            hash.update(&piece[..length]);
        }
    }
    hex(hash)
}
