//! The arguments of `mavc campaign`.

use crate::campaign::cases::Shard;
use crate::cli::CommandError;
use crate::pipeline::sized;
use crate::spec::Spec;
use clap::{Args, Subcommand};
use std::path::PathBuf;

/// The most instants and seeds of a campaign.
const MAX_TIMES: u64 = 10_000;
const MAX_SEEDS: u64 = 1_000_000;

#[derive(Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct CampaignArgs {
    #[command(subcommand)]
    pub action: Option<Action>,
    /// The spec, or `-` for standard input
    #[arg(required = true)]
    pub spec: Option<String>,
    /// Override a field of the spec for this run: plan.time=20s, vehicle.mass=2kg, plan.reserve=10%
    #[arg(long = "set", value_name = "FIELD=VALUE")]
    pub set: Vec<String>,
    /// Write one row for each flight to this CSV file; `-` for standard output
    #[arg(short, long, value_name = "ROWS.CSV")]
    pub output: Option<PathBuf>,
    /// Write the report (JSON) to this file; `-` prints it instead of the text for people
    #[arg(long, value_name = "CAMPAIGN.JSON")]
    pub report: Option<PathBuf>,
    /// Write the report as one HTML page with the map of survival, which needs no network
    #[arg(long, value_name = "CAMPAIGN.HTML")]
    pub html: Option<PathBuf>,
    /// Fly only part I of N, such as 3/16
    #[arg(long, value_name = "I/N")]
    pub shard: Option<String>,
    /// Use this many threads, at most four for each core; the default is one for each core. Results do not depend on it
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u64).range(1..))]
    pub threads: Option<u64>,
    /// Use this many instants of the fault instead of the spec's
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=MAX_TIMES))]
    pub times: Option<u64>,
    /// Use this many noise seeds instead of the spec's
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=MAX_SEEDS))]
    pub seeds: Option<u64>,
    /// Report from the rows of an earlier run, without flying
    #[arg(long, value_name = "ROWS.CSV", conflicts_with_all = ["output", "threads"])]
    pub rows: Option<PathBuf>,
}

#[derive(Subcommand)]
pub enum Action {
    /// Join the rows of all parts that `--shard` flew
    Merge {
        /// Write all rows to this CSV file
        #[arg(short, long, value_name = "ALL.CSV")]
        output: PathBuf,
        /// The rows of every part (CSV), in any order
        #[arg(required = true, value_name = "ROWS.CSV")]
        rows: Vec<PathBuf>,
    },
}

impl CampaignArgs {
    /// The part that `--shard` names, `3/16` counted from 1; the whole campaign without it.
    pub fn shard(&self) -> Result<Shard, CommandError> {
        let Some(text) = &self.shard else { return Ok(Shard::WHOLE) };
        let numbers = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
        match numbers {
            Some((index @ 1.., of)) if index <= of => Ok(Shard { index: index - 1, of }),
            _ => Err(format!("--shard {text}: write the part and the number of parts, from 1/16 to 16/16")),
        }
    }

    /// The spec with the instants and seeds that `--times` and `--seeds` give.
    pub fn size(&self, spec: &Spec) -> Result<Spec, CommandError> {
        let own = &spec.model().campaign;
        let size = |set: Option<u64>, own: usize| set.map_or(own, |n| n as usize);
        sized(spec, size(self.times, own.times), size(self.seeds, own.seeds)).map_err(|e| e.to_string())
    }
}
