//! `mavc campaign`: flies a campaign or a shard of it, or reports from rows that were flown.

mod arguments;
mod flying;
mod merge;
mod output;
mod places;

use super::progress::Watch;
use super::spec::{self, Start};
use super::{CommandError, DIVERGED, FINE, INCONCLUSIVE, NO_PLAN, Options, SPEC_ERRORS, SpecArgs, code_of};
use crate::pipeline::{Task, departure, missing_verdict};
use crate::read::FlightBlocks;
use crate::report::campaign_record::CampaignRecord;
use crate::report::screen::Screen;
use crate::report::{campaign_screen, campaign_text};
use crate::verdict::Verdict;
use arguments::Action;
pub use arguments::CampaignArgs;
use places::Places;

pub fn run(args: &CampaignArgs, options: &Options) -> Result<u8, CommandError> {
    if let Some(Action::Merge { output, rows }) = &args.action {
        return merge::run(output, rows, options);
    }
    let shard = args.shard()?;
    let places = Places::new(args)?;
    let spec_args = SpecArgs { spec: args.spec.clone().unwrap_or_default(), set: args.set.clone() };
    let watch = Watch::new(options);
    let (spec, mut findings) = spec::read(&spec_args, FlightBlocks::Used, &watch)?;
    places.spare(&findings)?;
    let spec = spec.map(|spec| args.size(&spec)).transpose()?;
    let task = match findings.start(spec.as_ref(), Task::new, options) {
        Start::Task(task) => task,
        Start::Refused => {
            let Some(spec) = &spec else { return Ok(NO_PLAN) };
            let record = CampaignRecord::without_flights(spec.model(), &[], spec.sha256().into());
            places.write(spec, &findings, &record, options)?;
            return Ok(NO_PLAN);
        }
        Start::Ended(code) => return Ok(code),
    };
    let comparison = task.at_common_time(&watch);
    let spec = task.spec();
    let design = match task.design(&comparison) {
        Ok(design) => design,
        Err(missing) => {
            places.print_alone(campaign_text::left_out(&missing).trim_start())?;
            let record = CampaignRecord::without_flights(spec.model(), &missing, spec.sha256().into());
            places.write(spec, &findings, &record, options)?;
            return Ok(code_of(missing_verdict(&missing)));
        }
    };
    findings.eprint_new(departure(spec, design.time), options);
    if findings.has_errors() {
        return Ok(SPEC_ERRORS);
    }
    let tally = match &args.rows {
        Some(path) => output::tally(path, &design, shard)?,
        None => match flying::fly(&design, shard, places.rows.as_ref(), options)? {
            Some(tally) => tally,
            None => return Ok(FINE),
        },
    };
    places.print(&match options.verbose {
        true => Screen::of_text(&campaign_text::campaign(&design, shard, &tally)),
        false => campaign_screen::screen(&design, shard, &tally),
    })?;
    places.write(spec, &findings, &CampaignRecord::new(&design, shard, &tally, spec.sha256().into()), options)?;
    Ok(match tally.diverged() {
        0 if missing_verdict(&design.missing) == Verdict::NotFound => INCONCLUSIVE,
        0 => FINE,
        _ => DIVERGED,
    })
}
