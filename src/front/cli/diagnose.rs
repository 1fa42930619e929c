//! `mavc diagnose`: which motor lost thrust in the flight of a log.

use super::progress::Watch;
use super::results::{Names, Places, Results, compact_json};
use super::spec::human;
use super::{CommandError, DiagnoseArgs, FINE, Format, LOSS, NOT_IDENTIFIABLE, Options, SPEC_ERRORS, SpecArgs};
use super::{files, spec};
use crate::diagnostic::{Diagnostic, Severity};
use crate::foreign::{self, Foreign};
use crate::log::commands;
use crate::pipeline::{Diagnosed, Undiagnosed, Why, diagnose};
use crate::read::{FlightBlocks, UNKNOWN};
use crate::report::diagnosis::{Answer, DiagnosisRecord, page, screen};
use crate::report::screen::Screen;
use crate::source::{Source, SourceMap};
use std::io::Read;
use std::path::Path;

pub fn run(args: &DiagnoseArgs, options: &Options) -> Result<u8, CommandError> {
    let places = Places::new(Names { page: args.html.as_deref(), ..Names::default() })?;
    let read = || std::iter::once(&args.log).chain(&args.spec).chain(&args.baseline).map(String::as_str);
    places.page.iter().try_for_each(|target| target.must_spare(read()))?;
    must_be_in_order(args)?;
    let vehicle = match &args.spec {
        None => None,
        Some(path) => {
            let of = SpecArgs { spec: path.clone(), set: Vec::new() };
            let (spec, mut findings) = spec::read(&of, FlightBlocks::Unused, &Watch::new(options))?;
            findings.eprint(options);
            let Some(spec) = spec else {
                if findings.diagnostics.iter().any(|d| d.code == UNKNOWN) {
                    let log = spec::shown(&args.log);
                    files::eprint(&format!(
                        "mavc: without a spec, the frame follows from the log: mavc diagnose {log}\n"
                    ));
                }
                return Ok(SPEC_ERRORS);
            };
            Some(spec)
        }
    };
    let mut log = open(&args.log)?;
    let mut baseline = args.baseline.iter().map(|name| open(name)).collect::<Result<Vec<_>, _>>()?;
    match diagnose(&mut log, vehicle.as_ref(), &args.hide, &mut baseline) {
        Err(Undiagnosed { baseline, why }) => refused(baseline.map_or(&args.log, |k| &args.baseline[k]), why, options),
        Ok(Diagnosed { diagnosis, record, diagnostics }) => {
            eprint(&args.log, diagnostics, options);
            let mut results = Results::new(&places);
            results.page(|| page(&spec::shown(&args.log), &diagnosis, &record, &commands(&record)));
            let text = match args.format {
                Format::Json => Screen::as_it_is(&compact_json(&DiagnosisRecord::new(&diagnosis))?),
                Format::Human => screen(&diagnosis),
            };
            results.print(&text)?;
            results.write()?;
            results.print_beside(&text);
            if args.format == Format::Human {
                results.note_page(options)?;
            }
            Ok(match diagnosis.answer() {
                Answer::Loss | Answer::Weaker => LOSS,
                Answer::Unknown => NOT_IDENTIFIABLE,
                Answer::None => FINE,
            })
        }
    }
}

/// Refuses a log where a spec is expected, and a spec among the logs of `--baseline`.
fn must_be_in_order(args: &DiagnoseArgs) -> Result<(), CommandError> {
    let is_log = |name: &str| {
        let mut head = Vec::new();
        let read = name != "-" && open(name).is_ok_and(|file| file.take(64).read_to_end(&mut head).is_ok());
        read && matches!(foreign::of_first_bytes(&head), Some(Foreign::Log(_)))
    };
    let log = spec::shown(&args.log);
    if let Some(other) = args.spec.as_deref().filter(|name| is_log(name)) {
        let other = spec::shown(other);
        return Err(format!("{other} is a log, expected a spec; the log comes first: `mavc diagnose {other} {log}`"));
    }
    match args.baseline.iter().find(|name| Path::new(name).extension().is_some_and(|ending| ending == "mav")) {
        Some(name) => Err(format!(
            "--baseline takes logs, and {0} is a spec, which comes before: `mavc diagnose {log} {0} --baseline ...`",
            spec::shown(name)
        )),
        None => Ok(()),
    }
}

/// Says why a log has no answer.
pub fn refused(name: &str, why: Why, options: &Options) -> Result<u8, CommandError> {
    match why {
        Why::Io(e) => Err(files::cannot_read(Path::new(name), &e)),
        Why::Argument(why) => Err(why),
        Why::Not(found) => {
            eprint(name, found, options);
            Ok(SPEC_ERRORS)
        }
    }
}

/// Opens a log as a stream.
pub fn open(name: &str) -> Result<Box<dyn Read>, CommandError> {
    if name == "-" {
        return Ok(Box::new(std::io::stdin()));
    }
    let path = Path::new(name);
    let file = std::fs::File::open(path).map_err(|e| files::cannot_read(path, &e))?;
    Ok(Box::new(file))
}

/// Prints what was found in a log, which is not a text that could be shown.
pub fn eprint(name: &str, mut found: Vec<Diagnostic>, options: &Options) {
    if options.quiet {
        found.retain(|d| d.severity == Severity::Error);
    }
    let mut sources = SourceMap::default();
    sources.add(Source::new(spec::name(name), ""));
    files::eprint_as_it_is(&human(&found, &sources, &std::io::stderr()));
}
