//! The arguments of every command, as `--help` prints them.

use super::campaign::CampaignArgs;
use super::exports::FRAMES;
use crate::MISSION_TEMPLATES;
use crate::exchange::{flight, trajectory};
use crate::import::estimate::{Battery, battery, propeller, quantity};
use crate::model::SearchEffort;
use crate::text_table::WIDTH;
use crate::verify::cost::Budget;
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

const EXIT_CODES: &str = "\
Exit codes:
  0  success
  1  the spec has errors
  2  wrong usage, or a file cannot be read or written
  3  proved infeasible, or no hover in a mode that the plan must tolerate
  4  no plan was found, or none was attempted
  5  the certificate is rejected
  6  the simulated vehicle is lost, or enters a keep_out or leaves a keep_in
  7  the certificate is accepted, but proves less than the spec requires
  8  checking the certificate would exceed the budget
  9  the integration of a simulated flight diverged
  10  a log shows that a motor lost thrust
  11  a log does not show whether a motor lost thrust
  130  the search was cut short by Ctrl-C; its best plan was written

SPEC may be `-` for standard input.";

/// The words of `effort` in `plan { }`.
const EFFORTS: [&str; 3] = [SearchEffort::Quick.name(), SearchEffort::Normal.name(), SearchEffort::Thorough.name()];

#[derive(Parser)]
#[command(
    name = "mavc",
    version,
    long_version = include_str!(concat!(env!("OUT_DIR"), "/version.txt")),
    about = "Checks a one-page spec of a multirotor mission, analyses which rotor faults the vehicle tolerates, and \
        plans the mission",
    after_help = EXIT_CODES,
    max_term_width = WIDTH
)]
pub(super) struct Cli {
    #[command(subcommand)]
    pub command: Command,
    /// Print results and errors only: no progress, no notes, and no warnings (except in `check`)
    #[arg(short, long, global = true)]
    pub quiet: bool,
    /// Print every table and figure instead of the answer on one screen
    #[arg(short, long, global = true)]
    pub verbose: bool,
    /// Print the time of each stage to standard error
    #[arg(long, global = true)]
    pub timings: bool,
}

#[derive(Subcommand)]
pub(super) enum Command {
    /// Check specs: every mistake, and the fault modes that the plan must tolerate but cannot
    Check(CheckArgs),
    /// Report what the vehicle can still do in each fault mode
    Analyze(AnalyzeArgs),
    /// Plan the mission and write the trajectory
    Plan(PlanArgs),
    /// Plan with RIP, RCP and RSP, and compare the plans
    Compare(CompareArgs),
    /// Show the spec's plan in a browser, on a page that updates whenever you save the spec
    View(ViewArgs),
    /// Check a certificate written by `plan --certificate`, without the planner
    Verify(VerifyArgs),
    /// Plan the mission, look for a way out after each fault, and write the files of a safety assessment: FMEA, fault
    /// tree, argument
    Safety(SafetyArgs),
    /// Plan the mission, then simulate a flight with the faults of the spec
    Simulate(SimulateArgs),
    /// Simulate flights of every planner's plan with every fault mode, at many instants and with many noise seeds
    Campaign(CampaignArgs),
    /// Find in the log of a flight which motor lost thrust, when, and what the vehicle could still do
    Diagnose(DiagnoseArgs),
    /// Write the spec of the vehicle that flew, from the log of a flight, with `?` for what the flight does not show
    Identify(IdentifyArgs),
    /// Format specs: indentation, spaces, columns
    Fmt(FmtArgs),
    /// Print the output of one stage of the compiler
    Emit(EmitArgs),
    /// Write a spec from the file of another tool; unknown figures become `?`
    #[command(subcommand)]
    Import(ImportCommand),
    /// Write a commented spec that can be planned as it is, or a vehicle of estimates
    New {
        /// The file to write, which must not exist yet, or `-` for standard output
        file: PathBuf,
        /// Write a whole mission with volumes and a battery; `room` is for a Crazyflie, the others have legs and wind
        #[arg(long, value_name = "KIND", value_parser = MISSION_TEMPLATES.map(|(kind, _)| kind))]
        mission: Option<String>,
        #[command(flatten)]
        vehicle: NewVehicleArgs,
    },
    /// Run the language server, over standard input and output
    #[cfg(feature = "lsp")]
    Lsp {
        /// Accepted because some editors pass it; there is no other transport
        #[arg(long, hide = true)]
        stdio: bool,
    },
    /// Explain the code of a diagnostic, or list codes
    Explain {
        /// A code such as mavc::unit::mismatch, or a part of one; without it, all codes are listed
        code: Option<String>,
    },
    /// Print a completion script for a shell
    Completions { shell: clap_complete::Shell },
    /// Print the manual page, or write a page for each command into a folder
    Man {
        /// The folder, such as ~/.local/share/man/man1; it is created if it is missing
        folder: Option<PathBuf>,
    },
}

#[derive(Args)]
pub(super) struct SpecArgs {
    /// The spec, or `-` for standard input
    #[arg(value_hint = clap::ValueHint::FilePath)]
    pub spec: String,
    /// Override a field of the spec for this run: plan.time=20s, vehicle.mass=2kg, plan.reserve=10%
    #[arg(long = "set", value_name = "FIELD=VALUE", value_hint = clap::ValueHint::Other)]
    pub set: Vec<String>,
}

#[derive(Args)]
pub(super) struct CheckArgs {
    /// Specs, folders with specs (`*.mav`, at any depth), or `-` for standard input
    #[arg(required = true, value_name = "SPEC")]
    pub specs: Vec<String>,
    /// Check missions of ground stations with the vehicle of this spec; the spec's own mission is ignored
    #[arg(long, value_name = "SPEC.MAV", value_hint = clap::ValueHint::FilePath)]
    pub vehicle: Option<String>,
    /// Override a field of the spec for this run: plan.time=20s, vehicle.mass=2kg, plan.reserve=10%
    #[arg(long = "set", value_name = "FIELD=VALUE", value_hint = clap::ValueHint::Other)]
    pub set: Vec<String>,
    /// Print diagnostics for people, on one line each, or as JSON
    #[arg(long, value_enum, default_value_t = CheckFormat::Human)]
    pub format: CheckFormat,
    /// Treat warnings as errors: exit code 1
    #[arg(long, value_name = "warnings", value_enum)]
    pub deny: Option<Deny>,
    /// Print every default that applies because the spec leaves a field out
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
pub(super) enum DenyOfPlan {
    Unsafe,
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
    /// Print tables for people, or JSON
    #[arg(long, value_enum, default_value_t = Format::Human)]
    pub format: Format,
    /// Vary a field of the vehicle, gravity or a `let`, and print where the answer changes: mass=1.5..2.5kg
    #[arg(long, value_name = "FIELD=LOW..HIGH", value_hint = clap::ValueHint::Other)]
    pub sweep: Option<String>,
    /// For modes that give up yaw, simulate the height lost until the vehicle flies level again, at several detection
    /// delays
    #[arg(long, conflicts_with = "sweep")]
    pub capture: bool,
    /// Write the outcomes as one HTML page
    #[arg(long, value_name = "FILE", value_hint = clap::ValueHint::FilePath, conflicts_with_all = ["sweep", "capture"])]
    pub html: Option<PathBuf>,
}

/// The number of a motor.
fn motor(text: &str) -> Result<usize, String> {
    text.trim().parse().ok().filter(|number| *number > 0).ok_or("write the number of a motor, such as 3".into())
}

#[derive(Args)]
pub(super) struct DiagnoseArgs {
    /// A log of ArduPilot (`.bin`) or PX4 (`.ulg`), or `-` for standard input
    #[arg(value_hint = clap::ValueHint::FilePath)]
    pub log: String,
    /// The spec of the vehicle; without it the frame follows from the parameters in the log
    #[arg(value_hint = clap::ValueHint::FilePath)]
    pub spec: Option<String>,
    /// Compare the thrust of each motor with these logs of good flights with the same load
    #[arg(long, value_name = "LOG", num_args = 1.., value_hint = clap::ValueHint::FilePath)]
    pub baseline: Vec<String>,
    /// Do not look at the logged output of this motor, and infer its command from the others'
    #[arg(long, value_name = "MOTOR", value_delimiter = ',', value_parser = motor)]
    pub hide: Vec<usize>,
    /// Write a page with curves of the flight, and the torques that the vehicle can give before and after each loss
    #[arg(long, value_name = "PAGE.HTML", value_hint = clap::ValueHint::FilePath)]
    pub html: Option<PathBuf>,
    /// Print the answer for people, or JSON
    #[arg(long, value_enum, default_value_t = Format::Human)]
    pub format: Format,
}

#[derive(Args)]
pub(super) struct IdentifyArgs {
    /// A log of ArduPilot (`.bin`) or PX4 (`.ulg`), or `-` for standard input
    #[arg(value_hint = clap::ValueHint::FilePath)]
    pub log: String,
    /// The mass of the vehicle as it flew, such as 1.5kg: a log shows thrust only relative to it
    #[arg(long, value_name = "MASS")]
    pub mass: String,
    /// Write the spec to this file, which must not exist yet; without it to standard output
    #[arg(short, long, value_name = "SPEC.MAV", value_hint = clap::ValueHint::FilePath)]
    pub output: Option<PathBuf>,
}

impl Command {
    /// `--effort` sets the field of the spec.
    pub fn set_effort(&mut self) {
        let (effort, spec) = match self {
            Command::Plan(args) => (&args.effort, &mut args.spec),
            Command::Compare(args) => (&args.effort, &mut args.spec),
            _ => return,
        };
        spec.set.extend(effort.iter().map(|effort| format!("plan.effort={effort}")));
    }
}

#[derive(Args)]
pub(super) struct PlanArgs {
    #[command(flatten)]
    pub spec: SpecArgs,
    /// Write the trajectory to this file; `-` for standard output
    #[arg(short, long, value_name = "TRAJ.CSV")]
    pub output: Option<PathBuf>,
    /// Write the trajectory of -o for another tool (docs/exchange.md). Without --format the file's ending decides:
    /// .plan, .waypoints, .kml, .geojson and .mcap choose a format; otherwise csv, mavc's table
    #[arg(long, value_name = "FORMAT", requires = "output", value_parser = trajectory::FORMATS.map(|(_, name)| name))]
    pub format: Option<String>,
    /// The frames of csv and rows: enu-flu (east, north, up; forward, left, up), the default, or ned-frd
    #[arg(long, value_name = "FRAME", requires = "output", value_parser = FRAMES)]
    pub frame: Option<String>,
    /// How far the written path may be from the plan: the polynomials of crazyflie (by default 1cm, and as many radians
    /// of yaw), the straight lines of qgc-plan and wpl (50cm) or of kml and geojson (10cm)
    #[arg(long, value_name = "LENGTH", requires = "output", value_hint = clap::ValueHint::Other)]
    pub tolerance: Option<String>,
    /// Write the report (JSON) to this file; `-` prints it instead of the text for people
    #[arg(long, value_name = "REPORT.JSON")]
    pub report: Option<PathBuf>,
    /// Write rows at a fixed rate, such as 100Hz, instead of one for each node. The last row is at the end of the plan
    /// or just after it, with the last state; each waypoint is marked in the row nearest to it
    #[arg(long, value_name = "RATE", value_hint = clap::ValueHint::Other)]
    pub rate: Option<String>,
    /// How much work the search may take: quick, normal (the default) or thorough
    #[arg(long, value_name = "EFFORT", value_parser = EFFORTS)]
    pub effort: Option<String>,
    /// After Ctrl-C, exit with 0 instead of 130. Ctrl-C ends the search and writes its best plan
    #[arg(long)]
    pub accept_best: bool,
    /// Exit with 4 if the plan does not cover every mode in `against`; the plan is still written
    #[arg(long, value_name = "unsafe", value_enum)]
    pub deny: Option<DenyOfPlan>,
    /// Look for a way out after every declared fault, at instants of the plan: back to the plan, to a landing site, or
    /// down at once. With --certificate also between instants, where that can be proved
    #[arg(long)]
    pub recovery: bool,
    /// Write each way out as a table into this folder, with index.csv; implies --recovery
    #[arg(long, value_name = "DIR")]
    pub branches: Option<PathBuf>,
    /// Write a certificate (JSON) for `mavc verify` to this file
    #[arg(long, value_name = "CERT.JSON")]
    pub certificate: Option<PathBuf>,
    /// Write the report as one HTML page with charts, which needs no network
    #[arg(long, value_name = "REPORT.HTML")]
    pub html: Option<PathBuf>,
    /// Write the charts as SVG files into this folder, which is created if it is missing
    #[arg(long, value_name = "DIR")]
    pub svg: Option<PathBuf>,
}

#[derive(Args)]
pub(super) struct ViewArgs {
    #[command(flatten)]
    pub spec: SpecArgs,
    /// Serve the page at this port of 127.0.0.1; 0 takes any that is free. The address is printed first
    #[arg(long, value_name = "PORT", default_value_t = 0)]
    pub port: u16,
    /// Open the page in the browser of the system
    #[arg(long)]
    pub open: bool,
}

/// What is known of a vehicle before the first measurement.
#[derive(Args)]
pub(super) struct NewVehicleArgs {
    /// Write a vehicle alone, from the figures below; every other figure is an estimate and marked as one
    #[arg(long, conflicts_with = "mission", requires_all = ["mass", "motors", "diagonal", "propeller"])]
    pub vehicle: bool,
    /// The mass in flight
    #[arg(long, requires = "vehicle", value_name = "1.5kg", value_parser = |text: &str| quantity(text, "kg", "1.5kg"))]
    pub mass: Option<f64>,
    /// The number of motors on the ring
    #[arg(long, requires = "vehicle", value_name = "6", value_parser = clap::value_parser!(u32).range(4..=32))]
    pub motors: Option<u32>,
    /// The distance from motor to motor across the middle
    #[arg(long, requires = "vehicle", value_name = "55cm", value_parser = |text: &str| quantity(text, "m", "55cm"))]
    pub diagonal: Option<f64>,
    /// The diameter of a propeller, or its label, such as 10x4.5
    #[arg(long, requires = "vehicle", value_name = "10in", value_parser = propeller)]
    pub propeller: Option<f64>,
    /// The label of the battery
    #[arg(long, requires = "vehicle", value_name = "4S5000mAh", value_parser = battery)]
    pub battery: Option<Battery>,
    /// The full thrust of a motor; without it, all motors together are assumed to lift twice the mass
    #[arg(long, requires = "vehicle", value_name = "9N", value_parser = |text: &str| quantity(text, "N", "9N"))]
    pub thrust: Option<f64>,
}

#[derive(Args)]
pub(super) struct VerifyArgs {
    /// The certificate, or `-` for standard input
    #[arg(value_name = "CERT.JSON")]
    pub certificate: PathBuf,
    #[command(flatten)]
    pub spec: SpecArgs,
    /// Limit the time and memory of the check; a larger budget may also prove more between the nodes
    #[arg(long, value_name = "10s,500MB")]
    pub budget: Option<Budget>,
}

#[derive(Args)]
pub(super) struct SafetyArgs {
    #[command(flatten)]
    pub spec: SpecArgs,
    /// Write the files into this folder, which is created if it is missing. Exit code 4 also means that the risk
    /// exceeds `require risk`
    #[arg(short, long, value_name = "DIR", value_hint = clap::ValueHint::DirPath)]
    pub output: PathBuf,
    /// Take the ways out from this report of `plan --recovery` instead of planning
    #[arg(long, value_name = "REPORT.JSON", requires = "certificate", value_hint = clap::ValueHint::FilePath)]
    pub report: Option<PathBuf>,
    /// Take the certificate of the same run from this file
    #[arg(long, value_name = "CERT.JSON", requires = "report", value_hint = clap::ValueHint::FilePath)]
    pub certificate: Option<PathBuf>,
    /// Write nothing; check that the files in the folder follow from the spec, and from the report and the certificate
    /// in the folder. Exit code 5 if one does not
    #[arg(long, conflicts_with_all = ["report", "certificate"])]
    pub check: bool,
    /// Limit the time and memory of the check of the certificate
    #[arg(long, value_name = "10s,500MB")]
    pub budget: Option<Budget>,
}

#[derive(Args)]
pub(super) struct CompareArgs {
    #[command(flatten)]
    pub spec: SpecArgs,
    /// How much work each search may take: quick, normal (the default) or thorough
    #[arg(long, value_name = "EFFORT", value_parser = EFFORTS)]
    pub effort: Option<String>,
    /// Write the report (JSON) to this file; `-` prints it instead of the text for people
    #[arg(long, value_name = "REPORT.JSON")]
    pub report: Option<PathBuf>,
    /// Write the report as one HTML page with charts, which needs no network
    #[arg(long, value_name = "REPORT.HTML")]
    pub html: Option<PathBuf>,
    /// Write the charts as SVG files into this folder, which is created if it is missing
    #[arg(long, value_name = "DIR")]
    pub svg: Option<PathBuf>,
}

#[derive(Args)]
pub(super) struct SimulateArgs {
    #[command(flatten)]
    pub spec: SpecArgs,
    /// Write the flight log to this file; `-` for standard output
    #[arg(short, long, value_name = "FLIGHT.CSV")]
    pub output: Option<PathBuf>,
    /// Write the log of -o for another tool (docs/exchange.md): mcap for Foxglove, ulog for PlotJuggler; without this
    /// as csv
    #[arg(long, value_name = "FORMAT", requires = "output", value_parser = flight::FORMATS.map(|(_, name)| name))]
    pub format: Option<String>,
    /// Write a layout that shows the log in that tool: JSON for Foxglove, XML for PlotJuggler
    #[arg(long, value_name = "LAYOUT", requires = "format")]
    pub layout: Option<PathBuf>,
    /// Write the report (JSON) to this file; `-` prints it instead of the text for people
    #[arg(long, value_name = "REPORT.JSON")]
    pub report: Option<PathBuf>,
    /// Write rows of the log at this rate, such as 100Hz; at most the rate of the controller
    #[arg(long, value_name = "RATE", value_hint = clap::ValueHint::Other)]
    pub rate: Option<String>,
    /// Write the report as one HTML page with charts, which needs no network
    #[arg(long, value_name = "REPORT.HTML")]
    pub html: Option<PathBuf>,
}

#[derive(Args)]
pub(super) struct FmtArgs {
    /// Specs, folders with specs (`*.mav`, at any depth), or `-` to format standard input to standard output
    #[arg(required = true, value_name = "SPEC")]
    pub specs: Vec<String>,
    /// Write nothing; list the files that would change, and exit with 1 if there are any
    #[arg(long)]
    pub check: bool,
}

#[derive(Args)]
pub(super) struct EmitArgs {
    /// The stage whose output is printed
    #[arg(value_enum)]
    pub stage: Stage,
    #[command(flatten)]
    pub spec: SpecArgs,
    /// The format of `qp`, json with P, q, A, b, cones and the origins of rows, or of `model`, json with all digits
    #[arg(long, value_enum, default_value_t = EmitFormat::Text)]
    pub format: EmitFormat,
}

impl EmitArgs {
    /// Whether the stage is printed in this format.
    pub fn has_format(&self) -> bool {
        matches!((self.stage, self.format), (_, EmitFormat::Text) | (Stage::Qp | Stage::Model, EmitFormat::Json))
    }

    /// Whether the flight blocks matter: the model is printed with them, and MuJoCo has the rate of `simulate`.
    pub fn is_flown(&self) -> bool {
        matches!(self.stage, Stage::Model | Stage::Mjcf)
    }
}

#[derive(Subcommand)]
pub(super) enum ImportCommand {
    /// A vehicle: PX4 parameters or airframe script, ArduPilot parameters, URDF, SDF or MJCF
    Vehicle(ImportArgs),
    /// A mission: a plan of QGroundControl, a mission of MAVLink (`QGC WPL 110`) or a table of waypoints
    Mission(ImportMissionArgs),
    /// A file without the word for what it is
    #[command(external_subcommand)]
    Unsaid(Vec<String>),
}

#[derive(Args)]
pub(super) struct ImportMissionArgs {
    #[command(flatten)]
    pub import: ImportArgs,
    /// Begin the spec with `use` of this spec, which has the vehicle
    #[arg(long, value_name = "SPEC.MAV", value_hint = clap::ValueHint::FilePath)]
    pub vehicle: Option<PathBuf>,
}

#[derive(Args)]
pub(super) struct ImportArgs {
    /// The file, or `-` for standard input
    #[arg(value_hint = clap::ValueHint::FilePath)]
    pub file: String,
    /// Write the spec to this file instead of standard output
    #[arg(short, long, value_name = "SPEC.MAV")]
    pub output: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum EmitFormat {
    Text,
    Json,
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
    /// The rows that the planner imposes on the wrench
    Constraints,
    /// The convex program of the hover model, at the time of the plan
    Qp,
    /// The vehicle and the mission for the simulator MuJoCo (MJCF)
    Mjcf,
    /// The rotors as parameters of PX4's control allocation, for QGroundControl
    Px4Params,
}
