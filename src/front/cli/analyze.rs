//! `mavc analyze`: prints the admissible set of every fault mode in figures.

use super::progress::Watch;
use super::results::{Names, Places, Results, compact_json};
use super::{AnalyzeArgs, CommandError, FINE, Format, Options, SPEC_ERRORS, spec};
use crate::observer::timed;
use crate::pipeline::{Sweep, analyze, capture};
use crate::read::FlightBlocks;
use crate::report::analysis_record::AnalysisRecord;
use crate::report::screen::Screen;
use crate::report::{analysis_screen, analysis_text, capture_text, page};

pub fn run(args: &AnalyzeArgs, options: &Options) -> Result<u8, CommandError> {
    let places = Places::new(Names { page: args.html.as_deref(), ..Names::default() })?;
    let watch = Watch::new(options);
    let (spec, mut findings) = spec::read(&args.spec, FlightBlocks::Unused, &watch)?;
    places.spare(&findings)?;
    findings.eprint(options);
    let Some(spec) = &spec else { return Ok(SPEC_ERRORS) };
    let modes = timed(&watch, "verdicts", || analyze(spec));
    let captures = args.capture.then(|| timed(&watch, "captures", || capture(spec)));
    let sweep = args.sweep.as_ref().map(|text| Sweep::run(text, spec, &modes)).transpose()?;
    let model = spec.model();
    let flips = sweep.as_ref().map(|sweep| sweep.flips.as_slice());
    let record = AnalysisRecord::new(model, &modes, flips, captures.as_deref());
    let mut results = Results::new(&places);
    results.page(|| page::analysis(model, spec.sources(), &findings.diagnostics, &modes, &record));
    let text = match (&sweep, &captures) {
        _ if args.format == Format::Json => Screen::as_it_is(&compact_json(&record)?),
        (Some(sweep), _) => Screen::of_text(&sweep.to_text(model)),
        (None, Some(captures)) => Screen::of_text(&capture_text::captures(model, captures)),
        (None, None) if options.verbose => Screen::of_text(&analysis_text::analysis(model, &modes)),
        (None, None) => analysis_screen::screen(model, &modes),
    };
    results.print(&text)?;
    results.write()?;
    results.print_beside(&text);
    if args.format == Format::Human {
        results.note_page(options)?;
    }
    Ok(FINE)
}
