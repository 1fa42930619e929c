//! `mavc check`: checks specs, once or with `--watch` again and again.

mod tally;

use super::progress::Watch;
use super::results::compact_json;
use super::spec::{self, Findings};
use super::{CheckArgs, CheckFormat, CommandError, Deny, FINE, NO_PLAN, Options, SPEC_ERRORS, SpecArgs};
use super::{files, specs, usage, watch};
use crate::diagnostic::sort;
use crate::flight::equilibrium::outcomes;
use crate::foreign::{self, Foreign};
use crate::import::{MAX_BYTES, mission};
use crate::pipeline::{self, defaults_text, is_intolerable};
use crate::read::FlightBlocks;
use crate::report::analysis_record::OutcomesRecord;
use crate::source::FileId;
use crate::spec::{Compiler, Spec};
use std::path::Path;
use tally::{Count, Tally};

pub fn run(args: &CheckArgs, options: &Options) -> Result<u8, CommandError> {
    if args.explain_defaults && args.format != CheckFormat::Human {
        return Err("--explain-defaults prints a table for people and cannot be combined with --format".into());
    }
    if args.watch { watch::run(args, options) } else { Ok(round(args, options)?.code) }
}

/// The outcome of checking all specs once.
pub struct Round {
    /// The worst exit code of all specs.
    pub code: u8,
    /// The specs and the files that they use, as named.
    pub files: Vec<String>,
}

/// Checks every spec once and prints the diagnostics. Those of a file that several specs use are printed once.
pub fn round(args: &CheckArgs, options: &Options) -> Result<Round, CommandError> {
    let found = specs::find(&args.specs);
    let mut tally = Tally::new(found.problems.len());
    let mut code = found.eprint();
    let is_alone = found.specs.len() == 1 && !args.specs.iter().any(|name| Path::new(name).is_dir());
    for name in &found.specs {
        let code_of_spec = one(name, args, is_alone, options, &mut tally).unwrap_or_else(|problem| {
            tally.unreadable += 1;
            usage(&problem)
        });
        code = specs::worst([code, code_of_spec]);
    }
    if !is_alone && !found.specs.is_empty() && !options.quiet && args.format == CheckFormat::Human {
        files::print(&tally.summary(found.specs.len()))?;
    }
    Ok(Round { code, files: [found.specs, tally.used].concat() })
}

/// Checks one spec; `is_alone` if it is the only one.
fn one(name: &str, args: &CheckArgs, is_alone: bool, options: &Options, tally: &mut Tally) -> Result<u8, CommandError> {
    let (spec, mut findings) = read(name, args, options)?;
    tally.used.extend(findings.files.names());
    let count = Count::of(&findings.diagnostics);
    let is_denied = args.deny == Some(Deny::Warnings) && count.warnings > 0;
    let code = match count.errors {
        0 if is_denied => SPEC_ERRORS,
        0 => FINE,
        _ if spec.is_some() && is_intolerable(&findings.diagnostics) => NO_PLAN,
        _ => SPEC_ERRORS,
    };
    let repeated = tally.take(&mut findings);
    match args.format {
        CheckFormat::Json => {
            files::print(&findings.json())?;
            if let Some(spec) = spec.as_ref().filter(|_| count.errors == 0) {
                let found = outcomes(spec.model());
                files::print(&compact_json(&OutcomesRecord::new(spec::name(name), spec.model(), &found))?)?;
            }
        }
        CheckFormat::Short => files::print(&findings.short())?,
        CheckFormat::Human => {
            findings.print_human(name, spec.as_ref(), is_alone, count, repeated, options)?;
        }
    }
    if let Some(spec) = spec.as_ref().filter(|_| args.explain_defaults) {
        files::print(&defaults_text(spec))?;
    }
    Ok(code)
}

/// The spec, if it has no errors, and everything that is wrong with it.
fn read(name: &str, args: &CheckArgs, options: &Options) -> Result<(Option<Spec>, Findings), CommandError> {
    let watch = Watch::new(options);
    let Some(vehicle) = &args.vehicle else {
        let args = SpecArgs { spec: name.into(), set: args.set.clone() };
        let (spec, mut findings) = spec::read(&args, FlightBlocks::Used, &watch)?;
        let text = &findings.files.sources.get(FileId(0)).text;
        if findings.has_errors() && matches!(foreign::of_text(text), Some(Foreign::Mission(_))) {
            let name = spec::shown(name);
            return Err(format!(
                "{name} is a mission of a ground station: name the spec of its vehicle by --vehicle v.mav"
            ));
        }
        if let Some(spec) = &spec {
            findings.diagnostics.extend(pipeline::check(spec));
            sort(&mut findings.diagnostics);
        }
        return Ok((spec, findings));
    };
    // A vehicle that cannot be read is a mistake in the command line, not in the mission.
    files::read_spec(vehicle, 0)?;
    if Path::new(vehicle).file_name().is_none() || vehicle == "-" {
        return Err(format!("--vehicle names a file, not {}", crate::source::visible::line(vehicle)));
    }
    spec::must_be_one(vehicle)?;
    let bytes = files::read_spec(name, MAX_BYTES)?;
    let compiler = args.set.iter().fold(Compiler::new().observed_by(&watch), Compiler::set);
    let joined = mission::join(spec::name(name), &bytes, vehicle, &compiler, pipeline::check);
    Ok((joined.spec, Findings { files: joined.files, diagnostics: joined.diagnostics }))
}
