//! The arguments of every command, as `--help` prints them.

use super::campaign::CampaignArgs;
use super::verify;
use crate::verify::cost::Budget;
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

#[derive(Parser)]
#[command(
    name = "mavc",
    version,
    long_version = include_str!(concat!(env!("OUT_DIR"), "/version.txt")),
    about = "Checks a one-page multirotor spec, says which rotor faults it survives and by what margin, and plans the mission",
    after_help = "Exit codes: 0 fine; 1 the spec has errors; 2 usage or files; 3 proved infeasible, or a mode the plan\nmust tolerate cannot hover; 4 not found; 5 the certificate is rejected; 6 the simulated vehicle is lost;\n7 the certificate is true but weaker than the spec asks; 8 deciding it would exceed the budget; 9 the integration of a flight broke down. SPEC may be `-` for standard input."
)]
pub(super) struct Cli {
    #[command(subcommand)]
    pub command: Command,
    /// Keep results and errors only: no warnings or advice (but of `check`), no progress, no notes such as where a file went
    #[arg(short, long, global = true)]
    pub quiet: bool,
    /// Print what each stage took, on standard error
    #[arg(long, global = true)]
    pub timings: bool,
}

#[derive(Subcommand)]
pub(super) enum Command {
    /// Find every mistake in specs, and the fault modes that the plan must stand but cannot
    Check(CheckArgs),
    /// Say for every fault mode what is left: verdict, margins, critical mass, headroom
    Analyze(AnalyzeArgs),
    /// Plan the mission and write the trajectory
    Plan(PlanArgs),
    /// Run RIP, RCP and RSP side by side
    Compare(CompareArgs),
    /// Check a certificate that `plan --certificate` wrote, without the planner
    Verify(VerifyArgs),
    /// Plan the mission and fly it, with the spec's faults in flight
    Simulate(SimulateArgs),
    /// Fly every planner's plan with every fault mode, at many instants and with many noise seeds
    Campaign(CampaignArgs),
    /// Lay specs out in the one way: indentation, blanks, columns
    Fmt(FmtArgs),
    /// Print what one stage of the compiler makes of the spec
    Emit(EmitArgs),
    /// Write a commented spec that plans as it stands
    New {
        /// The file to write, which must not exist, or `-` for standard output
        file: PathBuf,
    },
    /// Serve an editor over standard input and output (Language Server Protocol)
    #[cfg(feature = "lsp")]
    Lsp {
        /// Said by some editors; there is no other way
        #[arg(long, hide = true)]
        stdio: bool,
    },
    /// Explain a diagnostic's code
    Explain {
        /// Such as mavc::unit::mismatch; without one, all codes are listed with what they mean
        code: Option<String>,
    },
    /// Print what a shell needs to complete mavc's commands and options
    Completions { shell: clap_complete::Shell },
    /// Print mavc's manual page, or write a page for each command into a folder
    Man {
        /// A folder that exists, such as ~/.local/share/man/man1
        folder: Option<PathBuf>,
    },
}

#[derive(Args)]
pub(super) struct SpecArgs {
    /// The spec, or `-` for standard input
    #[arg(value_hint = clap::ValueHint::FilePath)]
    pub spec: String,
    /// Override a field: plan.time=20s, vehicle.mass=2kg, plan.reserve=10%
    #[arg(long = "set", value_name = "FIELD=VALUE", value_hint = clap::ValueHint::Other)]
    pub set: Vec<String>,
}

#[derive(Args)]
pub(super) struct CheckArgs {
    /// Specs, folders with specs (`*.mav`, at any depth), or `-` for standard input
    #[arg(required = true, value_name = "SPEC")]
    pub specs: Vec<String>,
    /// Override a field: plan.time=20s, vehicle.mass=2kg, plan.reserve=10%
    #[arg(long = "set", value_name = "FIELD=VALUE", value_hint = clap::ValueHint::Other)]
    pub set: Vec<String>,
    /// How problems are printed
    #[arg(long, value_enum, default_value_t = CheckFormat::Human)]
    pub format: CheckFormat,
    /// Treat warnings as errors
    #[arg(long, value_name = "warnings", value_enum)]
    pub deny: Option<Deny>,
    /// Print every default that filled in for something not written
    #[arg(long)]
    pub explain_defaults: bool,
    /// Check again whenever a file that was read changes, until Ctrl-C
    #[arg(long)]
    pub watch: bool,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum CheckFormat {
    Human,
    Short,
    Json,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum Deny {
    Warnings,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum Format {
    Human,
    Json,
}

#[derive(Args)]
pub(super) struct AnalyzeArgs {
    #[command(flatten)]
    pub spec: SpecArgs,
    #[arg(long, value_enum, default_value_t = Format::Human)]
    pub format: Format,
    /// Vary a field of the vehicle, gravity or a `let` and print where verdicts flip: mass=1.5..2.5kg
    #[arg(long, value_name = "FIELD=LOW..HIGH", value_hint = clap::ValueHint::Other)]
    pub sweep: Option<String>,
}

#[derive(Args)]
pub(super) struct PlanArgs {
    #[command(flatten)]
    pub spec: SpecArgs,
    /// Where the trajectory goes (CSV); `-` for standard output
    #[arg(short, long, value_name = "TRAJ.CSV")]
    pub output: Option<PathBuf>,
    /// Where the report goes (JSON); `-` for standard output, without the one for people
    #[arg(long, value_name = "REPORT.JSON")]
    pub report: Option<PathBuf>,
    /// Rows of the trajectory at a fixed rate, such as 100Hz, in place of one for each node: the last at or just after the
    /// plan's end, where it keeps its last state; waypoints are marked at the nearest row
    #[arg(long, value_name = "RATE", value_hint = clap::ValueHint::Other)]
    pub rate: Option<String>,
    /// Where the certificate goes (JSON), for `mavc verify`
    #[arg(long, value_name = "CERT.JSON")]
    pub certificate: Option<PathBuf>,
    /// Where the page goes (HTML): one file with charts, for a browser without a network
    #[arg(long, value_name = "REPORT.HTML")]
    pub html: Option<PathBuf>,
    /// A folder for the charts as SVG files, for papers; it is made where it is missing
    #[arg(long, value_name = "DIR")]
    pub svg: Option<PathBuf>,
}

#[derive(Args)]
pub(super) struct VerifyArgs {
    /// The certificate
    #[arg(value_name = "CERT.JSON")]
    pub certificate: PathBuf,
    #[command(flatten)]
    pub spec: SpecArgs,
    /// What deciding it may cost at most; more work may also prove more between the nodes
    #[arg(long, value_name = "10s,500MB", value_parser = verify::parse_budget)]
    pub budget: Option<Budget>,
}

#[derive(Args)]
pub(super) struct CompareArgs {
    #[command(flatten)]
    pub spec: SpecArgs,
    /// Where the report goes (JSON); `-` for standard output, without the one for people
    #[arg(long, value_name = "REPORT.JSON")]
    pub report: Option<PathBuf>,
    /// Also compare numbers of rounds of selection at T_d, such as 0..5
    #[arg(long, value_name = "FIRST..LAST", value_hint = clap::ValueHint::Other)]
    pub rounds: Option<String>,
    /// Where the page goes (HTML): one file with charts, for a browser without a network
    #[arg(long, value_name = "REPORT.HTML")]
    pub html: Option<PathBuf>,
    /// A folder for the charts as SVG files, for papers; it is made where it is missing
    #[arg(long, value_name = "DIR")]
    pub svg: Option<PathBuf>,
}

#[derive(Args)]
pub(super) struct SimulateArgs {
    #[command(flatten)]
    pub spec: SpecArgs,
    /// Where the flight log goes (CSV); `-` for standard output
    #[arg(short, long, value_name = "FLIGHT.CSV")]
    pub output: Option<PathBuf>,
    /// Where the report goes (JSON); `-` for standard output, without the one for people
    #[arg(long, value_name = "REPORT.JSON")]
    pub report: Option<PathBuf>,
    /// Rows of the log, such as 100Hz; at most as often as the controller acts
    #[arg(long, value_name = "RATE", value_hint = clap::ValueHint::Other)]
    pub rate: Option<String>,
    /// Where the page goes (HTML): one file with charts, for a browser without a network
    #[arg(long, value_name = "REPORT.HTML")]
    pub html: Option<PathBuf>,
}

#[derive(Args)]
pub(super) struct FmtArgs {
    /// Specs, folders with specs (`*.mav`, at any depth), or `-` for standard input to standard output
    #[arg(required = true, value_name = "SPEC")]
    pub specs: Vec<String>,
    /// Write nothing: list the files that would change and end with 1 if there are any
    #[arg(long)]
    pub check: bool,
}

#[derive(Args)]
pub(super) struct EmitArgs {
    #[arg(value_enum)]
    pub stage: Stage,
    #[command(flatten)]
    pub spec: SpecArgs,
    /// For `qp`: text, json (P, q, A, b, cones, row origins) or free MPS
    #[arg(long, value_enum, default_value_t = EmitFormat::Text)]
    pub format: EmitFormat,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum EmitFormat {
    Text,
    Json,
    Mps,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum Stage {
    /// The parsed text
    Ast,
    /// The spec in SI units
    Model,
    /// The actuation matrix
    Actuation,
    /// The admissible set of every mode
    Sets,
    /// The rows the planner imposes on the wrench
    Constraints,
    /// The convex program
    Qp,
}
