use super::spec::{self, timing};
use super::sweep::{Flip, Subject, Sweep};
use super::{AnalyzeArgs, FINE, Format, Options, Problem, SPEC_ERRORS, files};
use crate::admissible::verdict::{ModeAnalysis, analyze_each};
use crate::model::FlightBlocks;
use crate::report::analysis_text;
use crate::source::visible;
use serde::Serialize;
use std::time::Instant;

#[derive(Serialize)]
struct Record<'a> {
    schema: u32,
    vehicle: &'a str,
    rotors: usize,
    modes: &'a [ModeAnalysis],
    #[serde(skip_serializing_if = "Option::is_none")]
    flips: Option<&'a [Flip]>,
}

/// `mavc analyze`
pub fn run(args: &AnalyzeArgs, options: &Options) -> Result<u8, Problem> {
    let mut loaded = spec::read(&args.spec, FlightBlocks::Unused, options)?;
    loaded.tell(options);
    let Some(model) = &loaded.model else { return Ok(SPEC_ERRORS) };
    let begin = Instant::now();
    let modes = analyze_each(model);
    timing(options, "verdicts", begin);
    let flips = match &args.sweep {
        Some(text) => {
            let subject = Subject { files: &loaded.files, set: &args.spec.set, model, modes: &modes };
            Some(Sweep::run(text, &subject)?)
        }
        None => None,
    };
    match args.format {
        Format::Json => {
            let record = Record {
                schema: 2,
                vehicle: &model.vehicle.name,
                rotors: model.vehicle.rotors.len(),
                modes: &modes,
                flips: flips.as_ref().map(|f| f.flips.as_slice()),
            };
            let text = serde_json::to_string(&record).map_err(|e| e.to_string())?;
            let text = visible::json(text);
            files::print(&(text + "\n"))?;
        }
        Format::Human => match &flips {
            None => files::print(&analysis_text::analysis(model, &modes))?,
            Some(f) => files::print(&f.to_text(model))?,
        },
    }
    Ok(FINE)
}
