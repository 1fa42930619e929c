//! The command line: arguments, files, exit codes. No logic of the field.

mod analyze;
mod campaign;
mod check;
mod compare;
mod emit;
mod explain;
mod files;
mod fmt;
mod links;
mod lsp;
mod new;
mod plan;
mod progress;
mod shell;
mod signals;
mod simulate;
mod spec;
mod specs;
mod sweep;
mod target;
mod temporary;
mod threads;
mod verify;
mod watch;
mod why;

use crate::source::visible;
use crate::verify::cost::Budget;
use clap::error::{ContextKind, ContextValue};
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

/// Done; `analyze` ends so whatever its verdicts.
pub const FINE: u8 = 0;
/// The spec has errors.
pub const SPEC_ERRORS: u8 = 1;
/// Wrong usage, or a file that cannot be read or written.
pub const USAGE: u8 = 2;
/// Proved infeasible, or a mode that the plan must tolerate cannot hover.
pub const NO_PLAN: u8 = 3;
/// Not found, or not attempted because a plan that the search starts from was not found.
pub const INCONCLUSIVE: u8 = 4;
/// A certificate does not show what it claims.
pub const REJECTED: u8 = 5;
/// `verify` accepts the certificate, which is weaker than the spec asks.
pub const WEAKER: u8 = 7;
/// `verify` would need more than its budget.
pub const OVER_BUDGET: u8 = 8;
/// The simulated vehicle is lost.
pub const LOST: u8 = 6;
/// The integration of a flight broke down: what became of the vehicle is unknown.
pub const DIVERGED: u8 = 9;

#[derive(Parser)]
#[command(
    name = "mavc",
    version,
    long_version = include_str!(concat!(env!("OUT_DIR"), "/version.txt")),
    about = "Checks a one-page multirotor spec, says which rotor faults it survives and by what margin, and plans the mission",
    after_help = "Exit codes: 0 fine; 1 the spec has errors; 2 usage or files; 3 proved infeasible, or a mode the plan\nmust tolerate cannot hover; 4 not found; 5 the certificate is rejected; 6 the simulated vehicle is lost;\n7 the certificate is true but weaker than the spec asks; 8 deciding it would exceed the budget; 9 the integration of a flight broke down. SPEC may be `-` for standard input."
)]
struct Cli {
    #[command(subcommand)]
    command: Command,
    /// Keep results and errors only: no warnings or advice (but of `check`), no progress, no notes such as where a file went
    #[arg(short, long, global = true)]
    quiet: bool,
    /// Print what each stage took, on standard error
    #[arg(long, global = true)]
    timings: bool,
}

#[derive(Subcommand)]
enum Command {
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
    Campaign(campaign::CampaignArgs),
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
pub(crate) struct SpecArgs {
    /// The spec, or `-` for standard input
    #[arg(value_hint = clap::ValueHint::FilePath)]
    spec: String,
    /// Override a field: plan.time=20s, vehicle.mass=2kg, plan.reserve=10%
    #[arg(long = "set", value_name = "FIELD=VALUE", value_hint = clap::ValueHint::Other)]
    set: Vec<String>,
}

#[derive(Args)]
pub(crate) struct CheckArgs {
    /// Specs, folders with specs (`*.mav`, at any depth), or `-` for standard input
    #[arg(required = true, value_name = "SPEC")]
    specs: Vec<String>,
    /// Override a field: plan.time=20s, vehicle.mass=2kg, plan.reserve=10%
    #[arg(long = "set", value_name = "FIELD=VALUE", value_hint = clap::ValueHint::Other)]
    set: Vec<String>,
    /// How problems are printed
    #[arg(long, value_enum, default_value_t = CheckFormat::Human)]
    format: CheckFormat,
    /// Treat warnings as errors
    #[arg(long, value_name = "warnings", value_enum)]
    deny: Option<Deny>,
    /// Print every default that filled in for something not written
    #[arg(long)]
    explain_defaults: bool,
    /// Check again whenever a file that was read changes, until Ctrl-C
    #[arg(long)]
    watch: bool,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(crate) enum CheckFormat {
    Human,
    Short,
    Json,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(crate) enum Deny {
    Warnings,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(crate) enum Format {
    Human,
    Json,
}

#[derive(Args)]
pub(crate) struct AnalyzeArgs {
    #[command(flatten)]
    spec: SpecArgs,
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    /// Vary a field of the vehicle, gravity or a `let` and print where verdicts flip: mass=1.5..2.5kg
    #[arg(long, value_name = "FIELD=LOW..HIGH", value_hint = clap::ValueHint::Other)]
    sweep: Option<String>,
}

#[derive(Args)]
pub(crate) struct PlanArgs {
    #[command(flatten)]
    spec: SpecArgs,
    /// Where the trajectory goes (CSV); `-` for standard output
    #[arg(short, long, value_name = "TRAJ.CSV")]
    output: Option<PathBuf>,
    /// Where the report goes (JSON); `-` for standard output, without the one for people
    #[arg(long, value_name = "REPORT.JSON")]
    report: Option<PathBuf>,
    /// Rows of the trajectory at a fixed rate, such as 100Hz, in place of one for each node: the last at or just after the
    /// plan's end, where it keeps its last state; waypoints are marked at the nearest row
    #[arg(long, value_name = "RATE", value_hint = clap::ValueHint::Other)]
    rate: Option<String>,
    /// Where the certificate goes (JSON), for `mavc verify`
    #[arg(long, value_name = "CERT.JSON")]
    certificate: Option<PathBuf>,
    /// Where the page goes (HTML): one file with charts, for a browser without a network
    #[arg(long, value_name = "REPORT.HTML")]
    html: Option<PathBuf>,
    /// A folder for the charts as SVG files, for papers; it is made where it is missing
    #[arg(long, value_name = "DIR")]
    svg: Option<PathBuf>,
}

#[derive(Args)]
pub(crate) struct VerifyArgs {
    /// The certificate
    #[arg(value_name = "CERT.JSON")]
    certificate: PathBuf,
    #[command(flatten)]
    spec: SpecArgs,
    /// What deciding it may cost at most; more work may also prove more between the nodes
    #[arg(long, value_name = "10s,500MB", value_parser = verify::parse_budget)]
    budget: Option<Budget>,
}

#[derive(Args)]
pub(crate) struct CompareArgs {
    #[command(flatten)]
    spec: SpecArgs,
    /// Where the report goes (JSON); `-` for standard output, without the one for people
    #[arg(long, value_name = "REPORT.JSON")]
    report: Option<PathBuf>,
    /// Also compare numbers of rounds of selection at T_d, such as 0..5
    #[arg(long, value_name = "FIRST..LAST", value_hint = clap::ValueHint::Other)]
    rounds: Option<String>,
    /// Where the page goes (HTML): one file with charts, for a browser without a network
    #[arg(long, value_name = "REPORT.HTML")]
    html: Option<PathBuf>,
    /// A folder for the charts as SVG files, for papers; it is made where it is missing
    #[arg(long, value_name = "DIR")]
    svg: Option<PathBuf>,
}

#[derive(Args)]
pub(crate) struct SimulateArgs {
    #[command(flatten)]
    spec: SpecArgs,
    /// Where the flight log goes (CSV); `-` for standard output
    #[arg(short, long, value_name = "FLIGHT.CSV")]
    output: Option<PathBuf>,
    /// Where the report goes (JSON); `-` for standard output, without the one for people
    #[arg(long, value_name = "REPORT.JSON")]
    report: Option<PathBuf>,
    /// Rows of the log, such as 100Hz; at most as often as the controller acts
    #[arg(long, value_name = "RATE", value_hint = clap::ValueHint::Other)]
    rate: Option<String>,
    /// Where the page goes (HTML): one file with charts, for a browser without a network
    #[arg(long, value_name = "REPORT.HTML")]
    html: Option<PathBuf>,
}

#[derive(Args)]
pub(crate) struct FmtArgs {
    /// Specs, folders with specs (`*.mav`, at any depth), or `-` for standard input to standard output
    #[arg(required = true, value_name = "SPEC")]
    specs: Vec<String>,
    /// Write nothing: list the files that would change and end with 1 if there are any
    #[arg(long)]
    check: bool,
}

#[derive(Args)]
pub(crate) struct EmitArgs {
    #[arg(value_enum)]
    stage: Stage,
    #[command(flatten)]
    spec: SpecArgs,
    /// For `qp`: text, json (P, q, A, b, cones, row origins) or free MPS
    #[arg(long, value_enum, default_value_t = EmitFormat::Text)]
    format: EmitFormat,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(crate) enum EmitFormat {
    Text,
    Json,
    Mps,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(crate) enum Stage {
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

/// What every subcommand is told.
pub(crate) struct Options {
    pub quiet: bool,
    pub timings: bool,
}

/// Parses the arguments, does what they say and returns the exit code.
pub fn run() -> u8 {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(e) => {
            let mut e = without_disguise(e);
            without_escape(&mut e);
            return match files::told(e.print()) {
                Ok(()) if !e.use_stderr() => FINE,
                Err(problem) if !e.use_stderr() => usage(&problem),
                _ => USAGE,
            };
        }
    };
    let options = Options { quiet: cli.quiet, timings: cli.timings };
    threads::limit(match &cli.command {
        Command::Campaign(args) => args.threads(),
        _ => None,
    });
    let result = match &cli.command {
        Command::Check(args) => check::run(args, &options),
        Command::Analyze(args) => analyze::run(args, &options),
        Command::Plan(args) => plan::plan(args, &options),
        Command::Compare(args) => compare::compare(args, &options),
        Command::Verify(args) => verify::run(args, &options),
        Command::Simulate(args) => simulate::run(args, &options),
        Command::Campaign(args) => campaign::run(args, &options),
        Command::Fmt(args) => fmt::run(args, &options),
        Command::Emit(args) => emit::run(args, &options),
        Command::New { file } => new::run(file, &options),
        Command::Lsp { stdio: _ } => lsp::run(),
        Command::Explain { code } => explain::run(code.as_deref()),
        Command::Completions { shell } => shell::completions(*shell),
        Command::Man { folder } => shell::man(folder.as_deref()),
    };
    result.unwrap_or_else(|problem| usage(&problem))
}

/// The error with all arguments on one line each and free of disguises: they may be names of files.
fn without_disguise(error: clap::Error) -> clap::Error {
    let arguments: Vec<String> = std::env::args_os().map(|argument| argument.to_string_lossy().into_owned()).collect();
    if !arguments.iter().any(|argument| argument.contains(visible::is_disguise)) {
        return error;
    }
    Cli::try_parse_from(arguments.iter().map(|argument| visible::line(argument).into_owned())).err().unwrap_or(error)
}

/// Takes out the tip to pass an unknown option as a value, after `--`: no argument of mavc looks like an option.
fn without_escape(error: &mut clap::Error) {
    if let Some(ContextValue::StyledStrs(mut tips)) = error.remove(ContextKind::Suggested) {
        tips.retain(|tip| !tip.to_string().contains(" as a value, use "));
        if !tips.is_empty() {
            error.insert(ContextKind::Suggested, ContextValue::StyledStrs(tips));
        }
    }
}

fn usage(problem: &Problem) -> u8 {
    files::tell(&format!("mavc: {}\n", visible::line(problem)));
    USAGE
}

/// A problem with usage or files, told on one line.
pub(crate) type Problem = String;
