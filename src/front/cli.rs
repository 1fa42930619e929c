//! The command line: arguments, files, exit codes. Everything about vehicles and missions is in `pipeline` and
//! `report`; the file of a command has at most 80 lines, and what commands share has a module of its own.

mod analyze;
mod arguments;
mod campaign;
mod check;
mod compare;
mod diagnose;
mod emit;
mod endings;
mod explain;
mod exports;
mod files;
mod flight_log;
mod fmt;
mod identify;
mod import;
mod links;
#[cfg(feature = "lsp")]
mod lsp;
mod new;
mod plan;
mod progress;
mod rate;
mod results;
mod safety;
mod shell;
mod signals;
mod simulate;
mod spec;
mod specs;
mod target;
mod temporary;
mod threads;
mod verify;
mod view;
mod watch;

use crate::source::visible;
use crate::verdict::Verdict;
use arguments::{
    AnalyzeArgs, CheckArgs, CheckFormat, Cli, Command, CompareArgs, Deny, DenyOfPlan, DiagnoseArgs, EmitArgs,
    EmitFormat, FmtArgs, Format, IdentifyArgs, ImportArgs, ImportCommand, ImportMissionArgs, NewVehicleArgs, PlanArgs,
    SafetyArgs, SimulateArgs, SpecArgs, Stage, VerifyArgs, ViewArgs,
};
use clap::Parser;
use clap::error::{ContextKind, ContextValue};

/// Success; `analyze` ends with it whatever its verdicts.
pub const FINE: u8 = 0;
/// A search was cut short by Ctrl-C and its best plan was written: as shells report a process that SIGINT ended.
pub const CUT_SHORT: u8 = 130;
/// The spec has errors.
pub const SPEC_ERRORS: u8 = 1;
/// Wrong usage, or a file that cannot be read or written.
pub const USAGE: u8 = 2;
/// Proved infeasible, or a mode that the plan must tolerate cannot hover.
pub const NO_PLAN: u8 = 3;
/// Not found, or not attempted because a plan that the search starts from was not found.
pub const INCONCLUSIVE: u8 = 4;
/// The certificate is rejected.
pub const REJECTED: u8 = 5;
/// The certificate is accepted, but proves less than the spec requires.
pub const WEAKER: u8 = 7;
/// Checking the certificate would exceed the budget.
pub const OVER_BUDGET: u8 = 8;
/// The simulated vehicle is lost, or past the boundary of a volume.
pub const LOST: u8 = 6;
/// The integration of a flight diverged: the fate of the vehicle is unknown.
pub const DIVERGED: u8 = 9;
/// A log shows that a rotor lost thrust.
pub const LOSS: u8 = 10;
/// A log does not show whether a rotor lost thrust.
pub const NOT_IDENTIFIABLE: u8 = 11;

/// The options of every command.
pub(crate) struct Options {
    pub quiet: bool,
    /// Whether people get every table instead of one screen.
    pub verbose: bool,
    pub timings: bool,
}

/// Parses the arguments, runs the command and returns the exit code.
pub fn run() -> u8 {
    let mut cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(e) => {
            let mut e = without_disguise(e);
            without_escape(&mut e);
            return match files::written(e.print()) {
                Ok(()) if !e.use_stderr() => FINE,
                Err(problem) if !e.use_stderr() => usage(&problem),
                _ => USAGE,
            };
        }
    };
    cli.command.set_effort();
    let options = Options { quiet: cli.quiet, verbose: cli.verbose, timings: cli.timings };
    threads::limit(match &cli.command {
        Command::Campaign(args) => args.threads,
        _ => None,
    });
    let result = match &cli.command {
        Command::Check(args) => check::run(args, &options),
        Command::Analyze(args) => analyze::run(args, &options),
        Command::Plan(args) => plan::run(args, &options),
        Command::Compare(args) => compare::run(args, &options),
        Command::View(args) => view::run(args, &options),
        Command::Verify(args) => verify::run(args, &options),
        Command::Safety(args) => safety::run(args, &options),
        Command::Simulate(args) => simulate::run(args, &options),
        Command::Campaign(args) => campaign::run(args, &options),
        Command::Diagnose(args) => diagnose::run(args, &options),
        Command::Identify(args) => identify::run(args, &options),
        Command::Fmt(args) => fmt::run(args, &options),
        Command::Emit(args) => emit::run(args, &options),
        Command::Import(what) => import::run(what, &options),
        Command::New { file, mission, vehicle } => new::run(file, mission.as_deref(), vehicle, &options),
        #[cfg(feature = "lsp")]
        Command::Lsp { stdio: _ } => lsp::run(),
        Command::Explain { code } => explain::run(code.as_deref()),
        Command::Completions { shell } => shell::completions(*shell),
        Command::Man { folder } => shell::man(folder.as_deref()),
    };
    result.unwrap_or_else(|problem| usage(&problem))
}

/// The error with every argument on one line and without disguised characters: arguments may be names of files.
fn without_disguise(error: clap::Error) -> clap::Error {
    let arguments: Vec<String> = std::env::args_os().map(|argument| argument.to_string_lossy().into_owned()).collect();
    if !arguments.iter().any(|argument| argument.contains(visible::is_disguise)) {
        return error;
    }
    Cli::try_parse_from(arguments.iter().map(|argument| visible::line(argument).into_owned())).err().unwrap_or(error)
}

/// Removes the tip to pass an unknown option as a value after `--`: no argument of mavc looks like an option.
fn without_escape(error: &mut clap::Error) {
    if let Some(ContextValue::StyledStrs(mut tips)) = error.remove(ContextKind::Suggested) {
        tips.retain(|tip| !tip.to_string().contains(" as a value, use "));
        if !tips.is_empty() {
            error.insert(ContextKind::Suggested, ContextValue::StyledStrs(tips));
        }
    }
}

/// The exit code of a verdict.
fn code_of(verdict: Verdict) -> u8 {
    match verdict {
        Verdict::Found => FINE,
        Verdict::ProvedInfeasible => NO_PLAN,
        Verdict::NotFound | Verdict::NotAttempted => INCONCLUSIVE,
    }
}

fn usage(problem: &CommandError) -> u8 {
    files::eprint(&format!("mavc: {}\n", visible::line(problem)));
    USAGE
}

/// A problem with usage or files, reported on one line.
pub(crate) type CommandError = String;
