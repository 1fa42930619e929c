//! `mavc campaign`: flies a campaign or a shard of it, or tallies rows that are there.

mod merge;
mod output;
mod parquet;

use super::plan::{self, json, plan_for, ready, spare};
use super::progress::Flights;
use super::signals::Saying;
use super::simulate::cannot_fly;
use super::spec::{self, Loaded, hex, timing};
use super::target::{Target, write};
use super::{DIVERGED, FINE, INCONCLUSIVE, NO_PLAN, Options, Problem, SPEC_ERRORS, SpecArgs, files};
use crate::campaign::cases::{MAX_FLIGHTS, Shard};
use crate::campaign::design::{Design, Missing};
use crate::campaign::run::fly_all;
use crate::campaign::tally::Tally;
use crate::model::{FlightBlocks, Model};
use crate::planner::studies::Scope;
use crate::report::campaign_record::CampaignRecord;
use crate::report::campaign_text;
use crate::report::page;
use crate::source::visible;
use crate::verdict::Verdict;
use clap::{Args, Subcommand};
use output::{Output, Stop};
use sha2::{Digest, Sha256};
use std::io::Read;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

/// Most instants and seeds of a campaign.
const MAX_TIMES: u64 = 10_000;
const MAX_SEEDS: u64 = 1_000_000;

#[derive(Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub(crate) struct CampaignArgs {
    #[command(subcommand)]
    action: Option<Action>,
    /// The spec, or `-` for standard input
    #[arg(required = true)]
    spec: Option<String>,
    /// Override a field: plan.time=20s, vehicle.mass=2kg, plan.reserve=10%
    #[arg(long = "set", value_name = "FIELD=VALUE")]
    set: Vec<String>,
    /// Where the rows go, one a flight: CSV, Parquet by its ending, or `-` for standard output
    #[arg(short, long, value_name = "ROWS.CSV")]
    output: Option<PathBuf>,
    /// Where the report goes (JSON); `-` for standard output, without the one for people
    #[arg(long, value_name = "CAMPAIGN.JSON")]
    report: Option<PathBuf>,
    /// Where the page goes (HTML): one file with the map of survival, for a browser without a network
    #[arg(long, value_name = "CAMPAIGN.HTML")]
    html: Option<PathBuf>,
    /// Fly only the I-th of N parts, such as 3/16
    #[arg(long, value_name = "I/N")]
    shard: Option<String>,
    /// Threads that fly, at most four for each core; as many as there are cores without it. Results are the same
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u64).range(1..))]
    threads: Option<u64>,
    /// Instants of the fault, instead of the spec's
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=MAX_TIMES))]
    times: Option<u64>,
    /// Noise seeds, instead of the spec's
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=MAX_SEEDS))]
    seeds: Option<u64>,
    /// Report from rows that were flown, without flying
    #[arg(long, value_name = "ROWS.CSV", conflicts_with_all = ["output", "threads"])]
    rows: Option<PathBuf>,
}

impl CampaignArgs {
    pub fn threads(&self) -> Option<u64> {
        self.threads
    }
}

#[derive(Subcommand)]
enum Action {
    /// Join the rows of all shards
    Merge {
        /// Where the rows go; CSV, or Parquet by its ending
        #[arg(short, long, value_name = "ALL.CSV")]
        output: PathBuf,
        /// The rows of every shard (CSV), in any order
        #[arg(required = true, value_name = "ROWS.CSV")]
        rows: Vec<PathBuf>,
    },
}

pub fn run(args: &CampaignArgs, options: &Options) -> Result<u8, Problem> {
    if let Some(Action::Merge { output, rows }) = &args.action {
        return merge::run(output, rows, options);
    }
    let shard = args.shard.as_deref().map_or(Ok(Shard::WHOLE), parse_shard)?;
    let rows = args.output.as_deref().map(Target::new).transpose()?;
    let report = args.report.as_deref().map(Target::new).transpose()?;
    if let Some(path) = &args.output {
        parquet::is_possible(path)?;
    }
    let html = args.html.as_deref().map(Target::new).transpose()?;
    apart(&rows, &report)?;
    apart(&rows, &html)?;
    plan::apart(plan::PAGE, &html, &[&report])?;
    let spec_args = SpecArgs { spec: args.spec.clone().unwrap_or_default(), set: args.set.clone() };
    let mut loaded = spec::read(&spec_args, FlightBlocks::Used, options)?;
    spare(&loaded, &[&rows, &report, &html])?;
    if let Some(name) = &args.rows {
        [&report, &html].into_iter().flatten().try_for_each(|target| target.must_spare(name.to_str()))?;
    }
    let Some((mut model, mission)) = ready(&mut loaded, options) else { return Ok(SPEC_ERRORS) };
    resize(args, &mut model)?;
    let Some(comparison) = plan_for(&loaded, &model, &mission, Scope::Common, options) else {
        let silent = [&report, &html].into_iter().flatten().any(Target::is_stdout);
        let code = nothing_flown(&loaded, &model, &[], report.as_ref(), html.as_ref())?;
        plan::tell_page(!silent, &html, args.html.as_deref(), options)?;
        return Ok(code);
    };
    let design = match Design::new(&model, &comparison, &(loaded.sha256() + &binary())) {
        Ok(design) => design,
        Err(missing) => {
            let silent = [&report, &html].into_iter().flatten().any(Target::is_stdout);
            if !silent {
                files::print(campaign_text::left_out(&missing).trim_start())?;
            }
            let code = nothing_flown(&loaded, &model, &missing, report.as_ref(), html.as_ref())?;
            plan::tell_page(!silent, &html, args.html.as_deref(), options)?;
            return Ok(code);
        }
    };
    if cannot_fly(&mut loaded, &model, design.time, options) {
        return Ok(SPEC_ERRORS);
    }
    let tally = match &args.rows {
        Some(path) => output::tally(path, &design, shard)?,
        None => match fly(&design, shard, rows.as_ref(), options)? {
            Some(tally) => tally,
            None => return Ok(FINE),
        },
    };
    let text = campaign_text::campaign(&design, shard, &tally);
    match (&rows, &report) {
        // What goes to standard output has it to itself.
        (_, Some(report)) if report.is_stdout() => {}
        _ if html.as_ref().is_some_and(Target::is_stdout) => files::tell(&text),
        (Some(rows), _) if rows.is_stdout() => files::tell(&text),
        _ => files::print(&text)?,
    }
    let record = CampaignRecord::new(&design, shard, &tally, loaded.sha256());
    tell(&loaded, &model, &record, report.as_ref(), html.as_ref())?;
    let silent = [&rows, &report, &html].into_iter().flatten().any(Target::is_stdout);
    plan::tell_page(!silent, &html, args.html.as_deref(), options)?;
    Ok(match tally.diverged() {
        0 if is_inconclusive(&design.missing) => INCONCLUSIVE,
        0 => FINE,
        _ => DIVERGED,
    })
}

/// Hash of this very program: rows of another build may differ, and must not be joined. That of nothing where it cannot
/// be read.
fn binary() -> String {
    let mut hash = Sha256::new();
    if let Ok(mut file) = std::env::current_exe().and_then(std::fs::File::open) {
        let mut piece = [0; 1 << 16];
        while let Ok(length @ 1..) = file.read(&mut piece) {
            hash.update(&piece[..length]);
        }
    }
    hex(hash)
}

/// Flies what is not there yet. `None`: the reader of the rows has gone away.
fn fly(design: &Design, shard: Shard, rows: Option<&Target>, options: &Options) -> Result<Option<Tally>, Problem> {
    let (mut output, mut tally) = Output::open(rows, design, shard)?;
    // Rows that are there are none of this run's speed.
    let begin = Instant::now();
    let (done, all) = (tally.flights(), shard.count(design.cases.count()));
    if done > 0 && !options.quiet {
        files::tell(&if output.is_complete() {
            format!("mavc: {}: all {all} flights are there, nothing to fly\n", visible::line(&output.name()))
        } else {
            format!("mavc: {}: going on after {done} of {all} flights\n", visible::line(&output.name()))
        });
    }
    let progress = Flights::new(options, done, all);
    let kept = Arc::new(AtomicUsize::new(done));
    let _saying = Saying::new(farewell(&output, kept.clone(), all));
    let flown = fly_all(design, design.cases.of(shard).skip(done), |cases, rows| {
        let lines: String = rows.iter().map(|row| row.line() + "\n").collect();
        output.add(&lines)?;
        cases.iter().zip(rows).for_each(|(case, row)| tally.add(case, row));
        progress.more(rows.len());
        kept.fetch_add(rows.len(), Ordering::Relaxed);
        Ok(())
    });
    progress.done();
    match flown.and_then(|()| output.finish()) {
        Ok(()) => {}
        Err(Stop::ReaderGone) => return Ok(None),
        Err(Stop::Problem(problem)) => return Err(problem),
    }
    timing(options, "fly", begin);
    if options.timings {
        let flights = all - done;
        let rate = flights as f64 / begin.elapsed().as_secs_f64();
        files::tell(&format!("{:<10} {flights} flights, {rate:.1} a second\n", ""));
    }
    Ok(Some(tally))
}

/// What Ctrl-C says.
fn farewell(output: &Output, kept: Arc<AtomicUsize>, all: usize) -> impl Fn() -> String + Send + 'static {
    let part = output.part().map(|part| visible::line(&part.display().to_string()).into_owned());
    move || match (&part, kept.load(Ordering::Relaxed)) {
        (Some(part), done) => {
            format!("{done} of {all} flights are in {part}: the same command goes on from there")
        }
        (None, _) => "the flights are not kept: with `-o rows.csv` a campaign goes on from where it was stopped".into(),
    }
}

/// No plan, so no flight: the report says why.
fn nothing_flown(
    loaded: &Loaded,
    model: &Model,
    missing: &[Missing],
    report: Option<&Target>,
    html: Option<&Target>,
) -> Result<u8, Problem> {
    let record = CampaignRecord::without_flights(model, missing, loaded.sha256());
    tell(loaded, model, &record, report, html)?;
    // Without any planner asked, the modes themselves are in the way.
    let proved = missing.is_empty() || missing.iter().any(|m| m.verdict() == Verdict::ProvedInfeasible);
    Ok(if proved && !is_inconclusive(missing) { NO_PLAN } else { INCONCLUSIVE })
}

/// Writes report and page.
fn tell(
    loaded: &Loaded,
    model: &Model,
    record: &CampaignRecord,
    report: Option<&Target>,
    html: Option<&Target>,
) -> Result<(), Problem> {
    let mut results = Vec::new();
    if let Some(target) = report {
        results.push((target, json(record)?));
    }
    if let (Some(target), Some(mission)) = (html, &model.mission) {
        let subject = plan::subject(loaded, model, mission, &loaded.diagnostics);
        results.push((target, page::campaign(&subject, record)));
    }
    write(&results)
}

fn is_inconclusive(missing: &[Missing]) -> bool {
    missing.iter().any(|m| m.verdict() == Verdict::NotFound)
}

/// Rows, what is still being written of them, and the report must be three places.
fn apart(rows: &Option<Target>, report: &Option<Target>) -> Result<(), Problem> {
    let (Some(rows), Some(report)) = (rows, report) else { return Ok(()) };
    let part = rows.file().map(output::part_of);
    if rows.is_same(report) || part.is_some() && part.as_deref() == report.file() {
        return Err("the rows and the report would go to one place: give -o and --report two names".into());
    }
    Ok(())
}

/// Takes `--times` and `--seeds`, and refuses more flights than can be meant.
fn resize(args: &CampaignArgs, model: &mut Model) -> Result<(), Problem> {
    let campaign = &mut model.campaign;
    if let Some(times) = args.times {
        campaign.times = times as usize;
    }
    if let Some(seeds) = args.seeds {
        campaign.seeds = seeds as usize;
    }
    let blocks = campaign.times.checked_mul(model.modes.len()).and_then(|n| n.checked_add(1));
    let flights = blocks.and_then(|n| n.checked_mul(campaign.seeds)?.checked_mul(campaign.planners.len()));
    match flights {
        Some(n) if n <= MAX_FLIGHTS => Ok(()),
        _ => Err("a campaign has at most 100 million flights: take fewer modes, --times or --seeds".into()),
    }
}

/// `3/16`, counted from 1.
fn parse_shard(text: &str) -> Result<Shard, Problem> {
    let numbers = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
    match numbers {
        Some((index @ 1.., of)) if index <= of => Ok(Shard { index: index - 1, of }),
        _ => Err(format!("--shard {text}: write the part and the number of parts, from 1/16 to 16/16")),
    }
}
