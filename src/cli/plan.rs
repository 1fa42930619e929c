//! `mavc plan` and `mavc compare`: one engine, two reports.

use super::progress::Progress;
use super::spec::{self, Loaded, timing};
use super::{CompareArgs, FINE, INCONCLUSIVE, NO_PLAN, Options, PlanArgs, Problem, SPEC_ERRORS, files};
use crate::admissible::diagnose::diagnose;
use crate::diagnostic::{Diagnostic, Severity, sort};
use crate::model::{Mission, Model};
use crate::planner::compare::{Comparison, Ending, Scope, compare as compare_planners};
use crate::report::record::Record;
use crate::report::{terminal, trajectory_csv};
use std::path::Path;
use std::time::Instant;

/// A mission to plan is needed but none is written.
pub const NO_MISSION: &str = "mavc::plan::no_mission";

pub fn plan(args: &PlanArgs, options: &Options) -> Result<u8, Problem> {
    let rate = args.rate.as_deref().map(parse_rate).transpose()?;
    if let Some(path) = args.output.as_deref().filter(|o| *o != "-") {
        files::must_be_writable(Path::new(path))?;
    }
    if let Some(path) = &args.report {
        files::must_be_writable(path)?;
    }
    let mut loaded = spec::read(&args.spec, options)?;
    let Some((model, mission)) = ready(&mut loaded, options) else { return Ok(SPEC_ERRORS) };
    let Some(comparison) = run(&loaded, &model, &mission, Scope::Plan, options) else {
        return refused(&loaded, &model, args.report.as_deref());
    };
    let begin = Instant::now();
    if let Some(path) = &args.report {
        write_record(&loaded, &model, &mission, &comparison, path)?;
    }
    let text = terminal::plan(&model, &mission, &comparison);
    let code = match comparison.runs.last().map(|r| &r.ending) {
        Some(Ending::Solved(solved)) => {
            match args.output.as_deref() {
                Some("-") => {
                    // The table has standard output to itself.
                    files::print(&trajectory_csv::render(&solved.trajectory, &model, rate));
                    eprint!("{text}");
                    return Ok(FINE);
                }
                Some(path) => {
                    let table = trajectory_csv::render(&solved.trajectory, &model, rate);
                    files::write_whole(Path::new(path), table.as_bytes())?;
                }
                None => {}
            }
            FINE
        }
        Some(Ending::Inconclusive { .. }) => INCONCLUSIVE,
        _ => NO_PLAN,
    };
    files::print(&text);
    if code == FINE && !options.quiet {
        match args.output.as_deref() {
            Some(path) => files::print(&format!("\nTrajectory written to {path}\n")),
            None => files::print("\nNo trajectory was written: say where with -o traj.csv\n"),
        }
    }
    timing(options, "report", begin);
    Ok(code)
}

pub fn compare(args: &CompareArgs, options: &Options) -> Result<u8, Problem> {
    if let Some(path) = &args.report {
        files::must_be_writable(path)?;
    }
    let mut loaded = spec::read(&args.spec, options)?;
    let Some((model, mission)) = ready(&mut loaded, options) else { return Ok(SPEC_ERRORS) };
    let Some(comparison) = run(&loaded, &model, &mission, Scope::Everything, options) else {
        return refused(&loaded, &model, args.report.as_deref());
    };
    if let Some(path) = &args.report {
        write_record(&loaded, &model, &mission, &comparison, path)?;
    }
    files::print(&terminal::compare(&model, &mission, &comparison));
    let any = |wanted: fn(&Ending) -> bool| comparison.runs.iter().any(|r| wanted(&r.ending));
    Ok(if any(|e| matches!(e, Ending::Inconclusive { .. })) {
        INCONCLUSIVE
    } else if !any(|e| matches!(e, Ending::Solved(_))) {
        NO_PLAN
    } else {
        FINE
    })
}

/// The model with its mission, once all diagnostics are told.
fn ready(loaded: &mut Loaded, options: &Options) -> Option<(Model, Mission)> {
    if let Some(model) = &loaded.model {
        let answers = diagnose(model);
        loaded.diagnostics.extend(answers);
        loaded.diagnostics.extend(no_mission(model));
        sort(&mut loaded.diagnostics);
    }
    loaded.tell(options);
    let model = loaded.model.clone()?;
    let mission = model.mission.clone()?;
    Some((model, mission))
}

/// What to say where a plan is asked for and none is described.
pub(super) fn no_mission(model: &Model) -> Option<Diagnostic> {
    let error =
        Diagnostic::error(NO_MISSION, model.vehicle.span, "this spec describes a vehicle but no mission to plan");
    let error = error.here("only a vehicle stands here");
    model.mission.is_none().then(|| error.help("add a `mission` block, or use `mavc analyze` for the vehicle alone"))
}

/// Runs the planners unless some mode cannot be stood.
fn run(loaded: &Loaded, model: &Model, mission: &Mission, scope: Scope, options: &Options) -> Option<Comparison> {
    if loaded.diagnostics.iter().any(|d| d.severity == Severity::Error) {
        return None;
    }
    let begin = Instant::now();
    let progress = Progress::new(options);
    let tell = |planner: &str, time: f64| progress.tell(planner, time);
    let comparison = compare_planners(model, mission, scope, Some(&tell));
    progress.done();
    timing(options, "plan", begin);
    if options.timings {
        let e = comparison.effort;
        eprintln!(
            "{:<10} {:>9.2} ms in {} solves, {} iterations",
            "  solver",
            e.time.as_secs_f64() * 1e3,
            e.solves,
            e.iterations
        );
    }
    Some(comparison)
}

/// A mode cannot be stood: the report says that nothing was planned.
fn refused(loaded: &Loaded, model: &Model, report: Option<&Path>) -> Result<u8, Problem> {
    if let Some(path) = report {
        let record = Record::refused(model, loaded.sha256());
        write_json(&record, path)?;
    }
    Ok(NO_PLAN)
}

fn write_record(
    loaded: &Loaded,
    model: &Model,
    mission: &Mission,
    comparison: &Comparison,
    path: &Path,
) -> Result<(), Problem> {
    write_json(&Record::new(model, mission, comparison, loaded.sha256()), path)
}

fn write_json(record: &Record, path: &Path) -> Result<(), Problem> {
    let mut text = serde_json::to_string_pretty(record).map_err(|e| format!("cannot write the report: {e}"))?;
    text.push('\n');
    files::write_whole(path, text.as_bytes())
}

/// `100Hz`, `100 Hz` or `0.5kHz`, as Hz.
fn parse_rate(text: &str) -> Result<f64, Problem> {
    let trimmed = text.trim();
    let (digits, factor) = match (trimmed.strip_suffix("kHz"), trimmed.strip_suffix("Hz")) {
        (Some(d), _) => (d, 1e3),
        (None, Some(d)) => (d, 1.0),
        _ => return Err(format!("--rate {text}: write a frequency such as 100Hz")),
    };
    let rate = digits.trim().parse::<f64>().ok().map(|r| r * factor).filter(|r| r.is_finite());
    match rate {
        Some(r) if (1e-3..=1e5).contains(&r) => Ok(r),
        Some(_) => Err(format!("--rate {text}: between 0.001 Hz and 100 kHz, please")),
        None => Err(format!("--rate {text}: {:?} is not a number", digits.trim())),
    }
}
