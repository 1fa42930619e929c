//! `mavc analyze`

use super::progress::Watch;
use super::{AnalyzeArgs, FINE, Format, Options, Problem, SPEC_ERRORS, files, spec};
use crate::model::FlightBlocks;
use crate::observer::timed;
use crate::pipeline::{Sweep, analyze};
use crate::report::analysis_record::AnalysisRecord;
use crate::report::analysis_text;
use crate::source::visible;

pub fn run(args: &AnalyzeArgs, options: &Options) -> Result<u8, Problem> {
    let watch = Watch::new(options);
    let (spec, mut told) = spec::read(&args.spec, FlightBlocks::Unused, &watch)?;
    told.tell(options);
    let Some(spec) = &spec else { return Ok(SPEC_ERRORS) };
    let modes = timed(&watch, "verdicts", || analyze(spec));
    let sweep = args.sweep.as_ref().map(|text| Sweep::run(text, spec, &modes)).transpose()?;
    match args.format {
        Format::Json => {
            let record = AnalysisRecord::new(spec.model(), &modes, sweep.as_ref().map(|sweep| sweep.flips.as_slice()));
            let text = serde_json::to_string(&record).map_err(|e| e.to_string())?;
            files::print(&(visible::json(text) + "\n"))?;
        }
        Format::Human => files::print(&match &sweep {
            None => analysis_text::analysis(spec.model(), &modes),
            Some(sweep) => sweep.to_text(spec.model()),
        })?,
    }
    Ok(FINE)
}
