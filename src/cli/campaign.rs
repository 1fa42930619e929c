//! `mavc campaign`: flies a campaign or a shard of it, or tallies rows that are there.

mod arguments;
mod flying;
mod merge;
mod output;
mod parquet;
mod places;

use super::progress::Watch;
use super::spec::{self, Start};
use super::{DIVERGED, FINE, INCONCLUSIVE, NO_PLAN, Options, Problem, SPEC_ERRORS, SpecArgs};
use crate::campaign::cases::Shard;
use crate::campaign::design::{Design, Missing};
use crate::model::FlightBlocks;
use crate::pipeline::{Task, departure, sized};
use crate::report::campaign_record::CampaignRecord;
use crate::report::campaign_text;
use crate::spec::program_sha256;
use crate::verdict::Verdict;
use arguments::Action;
pub use arguments::CampaignArgs;
use places::Places;

pub fn run(args: &CampaignArgs, options: &Options) -> Result<u8, Problem> {
    if let Some(Action::Merge { output, rows }) = &args.action {
        return merge::run(output, rows, options);
    }
    let shard = args.shard.as_deref().map_or(Ok(Shard::WHOLE), parse_shard)?;
    let places = Places::new(args)?;
    let spec_args = SpecArgs { spec: args.spec.clone().unwrap_or_default(), set: args.set.clone() };
    let watch = Watch::new(options);
    let (spec, mut told) = spec::read(&spec_args, FlightBlocks::Used, &watch)?;
    places.spare(&told)?;
    let size = |set: Option<u64>, own: usize| set.map_or(own, |n| n as usize);
    let spec = spec.map(|spec| {
        let own = &spec.model().campaign;
        sized(&spec, size(args.times, own.times), size(args.seeds, own.seeds)).map_err(|e| e.to_string())
    });
    let spec = spec.transpose()?;
    let task = match told.start(spec.as_ref(), Task::new, options) {
        Start::Task(task) => task,
        Start::Refused => {
            let Some(spec) = &spec else { return Ok(NO_PLAN) };
            let record = CampaignRecord::without_flights(spec.model(), &[], spec.sha256().into());
            places.write(spec, &told, &record, options)?;
            return Ok(NO_PLAN);
        }
        Start::Ended(code) => return Ok(code),
    };
    let comparison = task.at_common_time(&watch);
    let spec = task.spec();
    let design = match Design::new(spec.model(), &comparison, &(spec.sha256().to_string() + &program_sha256())) {
        Ok(design) => design,
        Err(missing) => {
            places.print_alone(campaign_text::left_out(&missing).trim_start())?;
            let record = CampaignRecord::without_flights(spec.model(), &missing, spec.sha256().into());
            places.write(spec, &told, &record, options)?;
            let proved = missing.iter().any(|m| m.verdict() == Verdict::ProvedInfeasible);
            return Ok(if proved && !is_inconclusive(&missing) { NO_PLAN } else { INCONCLUSIVE });
        }
    };
    told.tell_new(departure(spec, design.time), options);
    if told.has_errors() {
        return Ok(SPEC_ERRORS);
    }
    let tally = match &args.rows {
        Some(path) => output::tally(path, &design, shard)?,
        None => match flying::fly(&design, shard, places.rows.as_ref(), options)? {
            Some(tally) => tally,
            None => return Ok(FINE),
        },
    };
    places.print(&campaign_text::campaign(&design, shard, &tally))?;
    places.write(spec, &told, &CampaignRecord::new(&design, shard, &tally, spec.sha256().into()), options)?;
    Ok(match tally.diverged() {
        0 if is_inconclusive(&design.missing) => INCONCLUSIVE,
        0 => FINE,
        _ => DIVERGED,
    })
}

fn is_inconclusive(missing: &[Missing]) -> bool {
    missing.iter().any(|m| m.verdict() == Verdict::NotFound)
}

/// `3/16`, counted from 1.
fn parse_shard(text: &str) -> Result<Shard, Problem> {
    let numbers = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
    match numbers {
        Some((index @ 1.., of)) if index <= of => Ok(Shard { index: index - 1, of }),
        _ => Err(format!("--shard {text}: write the part and the number of parts, from 1/16 to 16/16")),
    }
}
