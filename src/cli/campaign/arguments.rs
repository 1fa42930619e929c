//! The arguments of `mavc campaign`.

use clap::{Args, Subcommand};
use std::path::PathBuf;

/// Most instants and seeds of a campaign.
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
    /// Override a field: plan.time=20s, vehicle.mass=2kg, plan.reserve=10%
    #[arg(long = "set", value_name = "FIELD=VALUE")]
    pub set: Vec<String>,
    /// Where the rows go, one a flight: CSV, Parquet by its ending, or `-` for standard output
    #[arg(short, long, value_name = "ROWS.CSV")]
    pub output: Option<PathBuf>,
    /// Where the report goes (JSON); `-` for standard output, without the one for people
    #[arg(long, value_name = "CAMPAIGN.JSON")]
    pub report: Option<PathBuf>,
    /// Where the page goes (HTML): one file with the map of survival, for a browser without a network
    #[arg(long, value_name = "CAMPAIGN.HTML")]
    pub html: Option<PathBuf>,
    /// Fly only the I-th of N parts, such as 3/16
    #[arg(long, value_name = "I/N")]
    pub shard: Option<String>,
    /// Threads that fly, at most four for each core; as many as there are cores without it. Results are the same
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u64).range(1..))]
    pub threads: Option<u64>,
    /// Instants of the fault, instead of the spec's
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=MAX_TIMES))]
    pub times: Option<u64>,
    /// Noise seeds, instead of the spec's
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=MAX_SEEDS))]
    pub seeds: Option<u64>,
    /// Report from rows that were flown, without flying
    #[arg(long, value_name = "ROWS.CSV", conflicts_with_all = ["output", "threads"])]
    pub rows: Option<PathBuf>,
}

#[derive(Subcommand)]
pub enum Action {
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
