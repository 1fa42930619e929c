//! `mavc analyze`: prints the admissible set of every fault mode in figures.

use super::progress::Watch;
use super::results::compact_json;
use super::{AnalyzeArgs, CommandError, FINE, Format, Options, SPEC_ERRORS, files, spec};
use crate::observer::timed;
use crate::pipeline::{Sweep, analyze, capture};
use crate::read::FlightBlocks;
use crate::report::analysis_record::AnalysisRecord;
use crate::report::{analysis_screen, analysis_text, capture_text};

pub fn run(args: &AnalyzeArgs, options: &Options) -> Result<u8, CommandError> {
    let watch = Watch::new(options);
    let (spec, mut findings) = spec::read(&args.spec, FlightBlocks::Unused, &watch)?;
    findings.eprint(options);
    let Some(spec) = &spec else { return Ok(SPEC_ERRORS) };
    let modes = timed(&watch, "verdicts", || analyze(spec));
    let captures = args.capture.then(|| timed(&watch, "captures", || capture(spec)));
    let sweep = args.sweep.as_ref().map(|text| Sweep::run(text, spec, &modes)).transpose()?;
    match args.format {
        Format::Json => {
            let flips = sweep.as_ref().map(|sweep| sweep.flips.as_slice());
            let record = AnalysisRecord::new(spec.model(), &modes, flips, captures.as_deref());
            files::print(&compact_json(&record)?)?;
        }
        Format::Human => match (&sweep, &captures) {
            (Some(sweep), _) => files::print(&sweep.to_text(spec.model()))?,
            (None, Some(captures)) => files::print(&capture_text::captures(spec.model(), captures))?,
            (None, None) if options.verbose => files::print(&analysis_text::analysis(spec.model(), &modes))?,
            (None, None) => files::print_screen(&analysis_screen::screen(spec.model(), &modes))?,
        },
    }
    Ok(FINE)
}
