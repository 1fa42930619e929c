//! `mavc plan`, and what `mavc compare` and the pages share with it.

use super::progress::Progress;
use super::spec::{self, Loaded, timing};
use super::target::{Target, cannot_write, write};
use super::why::{nearby, why};
use super::{FINE, INCONCLUSIVE, NO_PLAN, Options, PlanArgs, Problem, SPEC_ERRORS, files};
use crate::admissible::diagnose::{diagnose, is_too_large};
use crate::certify::{self, between};
use crate::diagnostic::{Diagnostic, Severity, sort};
use crate::explain::{self, Explanation};
use crate::model::{FlightBlocks, Mission, Model};
use crate::planner::studies::{Comparison, NotFound, PlanOutcome, Scope, compare as compare_planners};
use crate::report::conflict_record::ConflictRecord;
use crate::report::page::{self, Kind, Subject};
use crate::report::record::Record;
use crate::report::{self, terminal, trajectory_csv};
use crate::source::visible;
use crate::verdict::Verdict;
use std::io::ErrorKind;
use std::path::Path;
use std::time::Instant;

/// A mission to plan is needed but none is written.
pub const NO_MISSION: &str = "mavc::plan::no_mission";

pub fn plan(args: &PlanArgs, options: &Options) -> Result<u8, Problem> {
    let rate = args.rate.as_deref().map(parse_rate).transpose()?;
    let (table, report) = targets(args.output.as_deref(), args.report.as_deref())?;
    let proof = args.certificate.as_deref().map(Target::new).transpose()?;
    let html = args.html.as_deref().map(Target::new).transpose()?;
    apart(("the certificate", "--certificate"), &proof, &[&table, &report])?;
    apart(PAGE, &html, &[&table, &report, &proof])?;
    args.svg.as_deref().map_or(Ok(()), is_folder)?;
    let mut loaded = spec::read(&args.spec, FlightBlocks::Unused, options)?;
    spare(&loaded, &[&table, &report, &proof, &html])?;
    let Some((model, mission)) = ready(&mut loaded, options) else { return Ok(SPEC_ERRORS) };
    let Some(comparison) = plan_for(&loaded, &model, &mission, Scope::Plan, options) else {
        return refused(&loaded, &model, &report, &html, args.html.as_deref(), options);
    };
    let solved = matches!(comparison.runs.last().map(|r| &r.outcome), Some(PlanOutcome::Planned(_)));
    // Where only the required risk is not met there is a plan for every statement that could be blamed.
    // A motion that fails the check is the planner's failure, and no statement of the spec is to blame for it.
    let is_failed =
        matches!(comparison.runs.last().map(|r| &r.outcome), Some(PlanOutcome::NotFound(NotFound::Check { .. })));
    let found_at: Vec<f64> = nearby(&model, &mission, &comparison, options).times().collect();
    // Nor is one where the planner has a plan at another time.
    let is_elsewhere = !found_at.is_empty();
    let is_settled = solved || is_failed || is_elsewhere || !comparison.trade_off.is_empty();
    let explanation = if is_settled { None } else { why(&model, &mission, options) };
    let progress = Progress::new(options);
    let certified = proof.as_ref().map(|target| {
        let begin = Instant::now();
        progress.say("making the certificate".into());
        let certificate = certify::of(&model, &mission, &comparison, loaded.sha256());
        timing(options, "certify", begin);
        (target, certificate)
    });
    let begin = Instant::now();
    let plan = comparison.runs.last().and_then(|run| match &run.outcome {
        PlanOutcome::Planned(solved) => Some((run, solved)),
        _ => None,
    });
    progress.say("looking for a proof of every instant".into());
    let between = plan.map(|(run, solved)| between::between(&model, &mission, run, solved));
    progress.done();
    timing(options, "prove", begin);
    let begin = Instant::now();
    let mut results = Vec::new();
    let code = match comparison.runs.last().map(|r| &r.outcome) {
        Some(PlanOutcome::Planned(solved)) => {
            if table.is_some() {
                let header = trajectory_csv::header(model.vehicle.rotors.len());
                let rows = trajectory_csv::count(&solved.trajectory, rate);
                trajectory_csv::few_enough("trajectory", rows, &header)?;
            }
            let rows = |target| (target, trajectory_csv::render(&solved.trajectory, &model, rate));
            results.extend(table.as_ref().map(rows));
            FINE
        }
        _ => no_plan_code(&comparison),
    };
    match &certified {
        Some((target, Ok(record))) => results.push((target, json(record)?)),
        Some((_, Err(why))) => files::tell(&format!("mavc: no certificate is written: {why}\n")),
        None => {}
    }
    let why = explanation.as_ref().map(|e| explain::diagnose::diagnose(e, &model, &mission, &loaded.files.sources));
    if report.is_some() || html.is_some() {
        let told = |e: &Explanation| ConflictRecord::new(e, &model, &mission, &loaded.files.sources);
        let conflict = explanation.as_ref().map(told);
        let found_at_s = found_at.clone();
        let mut record = Record { conflict, found_at_s, ..Record::new(&model, &mission, &comparison, loaded.sha256()) };
        if let Some(planner) = record.planners.last_mut() {
            planner.between = between.clone();
        }
        if let Some(target) = &report {
            results.push((target, json(&record)?));
        }
        if let Some(target) = &html {
            let told: Vec<Diagnostic> = loaded.diagnostics.iter().chain(&why).cloned().collect();
            let subject = subject(&loaded, &model, &mission, &told);
            results.push((target, page::plans(Kind::Plan, &subject, &comparison, &record)));
        }
    }
    // A result that goes to standard output has it to itself, and the text goes to standard error.
    let stdout = !results.iter().any(|(target, _)| target.is_stdout());
    let color = if stdout { spec::colored(&std::io::stdout()) } else { spec::colored(&std::io::stderr()) };
    let mut text = terminal::plan(&model, &mission, &comparison, color);
    text.push_str(&terminal::elsewhere(&model, &found_at));
    if let (Some((_, solved)), Some(found)) = (plan, &between) {
        text.push_str(&report::between::between(&model, solved, found));
    }
    let told = stdout;
    if told {
        files::print_painted(&text)?;
    }
    let figures = figures(
        args.svg.as_deref(),
        &subject(&loaded, &model, &mission, &[]),
        &comparison,
        &[&table, &report, &proof, &html],
    )?;
    results.extend(figures.iter().map(|(target, text)| (target, text.clone())));
    write(&results)?;
    if !told && !report.is_some_and(|r| r.is_stdout()) {
        files::tell_painted(&text);
    }
    if let Some(why) = &why {
        loaded.tell_also(why);
    }
    if told && code == FINE && !options.quiet {
        files::print(&match args.output.as_deref() {
            Some(path) => format!("\nTrajectory written to {}\n", files::shown(path)),
            None => "\nNo trajectory was written: say where with -o traj.csv\n".into(),
        })?;
    }
    tell_page(told, &html, args.html.as_deref(), options)?;
    tell_written("Figures", told, args.svg.as_deref(), options)?;
    timing(options, "report", begin);
    Ok(code)
}

/// How the page and its option are called.
pub(super) const PAGE: (&str, &str) = ("the page", "--html");

/// Refuses one place for two results; `called` is how this one is, and its option.
pub(super) fn apart(called: (&str, &str), result: &Option<Target>, others: &[&Option<Target>]) -> Result<(), Problem> {
    let (Some(result), (name, option)) = (result, called) else { return Ok(()) };
    match others.iter().copied().flatten().any(|other| result.is_same(other)) {
        true => Err(format!("{name} and another result would go to one place: give {option} its own name")),
        false => Ok(()),
    }
}

/// What a page is about.
pub(super) fn subject<'a>(
    loaded: &'a Loaded,
    model: &'a Model,
    mission: &'a Mission,
    diagnostics: &'a [Diagnostic],
) -> Subject<'a> {
    Subject { model, mission, sources: &loaded.files.sources, diagnostics }
}

/// Says early that no folder can be there: something else is, or stands in its way.
pub(super) fn is_folder(name: &Path) -> Result<(), Problem> {
    let standing = name.ancestors().find(|a| a.as_os_str().is_empty() || a.symlink_metadata().is_ok());
    match standing.filter(|a| !a.as_os_str().is_empty()) {
        Some(place) if !place.is_dir() => Err(cannot_write(name, &ErrorKind::NotADirectory.into())),
        _ => Ok(()),
    }
}

/// A chart: where it goes, and its text.
type Figure = (Target, String);

/// Draws the charts for a folder, which is made where it is missing. None goes where `read` is or another result.
pub(super) fn figures(
    folder: Option<&Path>,
    subject: &Subject,
    comparison: &Comparison,
    others: &[&Option<Target>],
) -> Result<Vec<Figure>, Problem> {
    let Some(folder) = folder else { return Ok(Vec::new()) };
    std::fs::create_dir_all(folder).map_err(|e| cannot_write(folder, &e))?;
    let drawn = page::figures(subject, comparison).map_err(|e| format!("cannot draw the charts: {e}"))?;
    let placed = |(name, text): (String, String)| {
        let target = Target::within(folder, &name)?;
        target.must_spare(subject.sources.iter().map(|(_, source)| source.name.as_str()))?;
        match others.iter().copied().flatten().any(|other| target.is_same(other)) {
            true => {
                Err(format!("a chart and another result would go to {}: give --svg its own folder", target.shown()))
            }
            false => Ok((target, text)),
        }
    };
    drawn.into_iter().map(placed).collect()
}

/// Says where the page is, where anything is said.
pub(super) fn tell_page(
    told: bool,
    page: &Option<Target>,
    name: Option<&Path>,
    options: &Options,
) -> Result<(), Problem> {
    tell_written("Page", told && page.is_some(), name, options)
}

pub(super) fn tell_written(what: &str, told: bool, name: Option<&Path>, options: &Options) -> Result<(), Problem> {
    match name {
        Some(name) if told && !options.quiet => files::print(&format!("{what} written to {}\n", files::shown(name))),
        _ => Ok(()),
    }
}

/// Where the trajectory and the report go.
pub(super) fn targets(
    table: Option<&Path>,
    report: Option<&Path>,
) -> Result<(Option<Target>, Option<Target>), Problem> {
    let (table, report) = (table.map(Target::new).transpose()?, report.map(Target::new).transpose()?);
    match (&table, &report) {
        (Some(a), Some(b)) if a.is_same(b) => {
            Err("the trajectory and the report would go to one place: give -o and --report two names".into())
        }
        _ => Ok((table, report)),
    }
}

/// Refuses targets that would replace a file of the spec.
pub(super) fn spare(loaded: &Loaded, targets: &[&Option<Target>]) -> Result<(), Problem> {
    let read = || loaded.files.sources.iter().map(|(_, source)| source.name.as_str());
    targets.iter().copied().flatten().try_for_each(|target| target.must_spare(read()))
}

/// The model with its mission, once all diagnostics are told.
pub(super) fn ready(loaded: &mut Loaded, options: &Options) -> Option<(Model, Mission)> {
    if let Some(model) = &loaded.model {
        let answers = diagnose(model);
        let is_too_large = is_too_large(&answers);
        loaded.diagnostics.extend(answers);
        loaded.diagnostics.extend(no_mission(model));
        sort(&mut loaded.diagnostics);
        if is_too_large {
            loaded.model = None;
        }
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
pub(super) fn plan_for(
    loaded: &Loaded,
    model: &Model,
    mission: &Mission,
    scope: Scope,
    options: &Options,
) -> Option<Comparison> {
    if loaded.diagnostics.iter().any(|d| d.severity == Severity::Error) {
        return None;
    }
    let begin = Instant::now();
    let progress = Progress::new(options);
    let tell = |planner: &str, time: f64| progress.tell(planner, time);
    let mut comparison = compare_planners(model, mission, scope, Some(&tell));
    progress.done();
    timing(options, "plan", begin);
    let checking = Instant::now();
    certify::check(model, mission, &mut comparison);
    timing(options, "check", checking);
    if options.timings {
        let e = comparison.effort;
        files::tell(&format!(
            "{:<10} {:>9.2} ms in {} solves, {} iterations{}\n",
            "  solver",
            e.time.as_secs_f64() * 1e3,
            e.solves,
            e.iterations,
            match e.starts {
                0 => String::new(),
                1 => ", 1 start".into(),
                starts => format!(", {starts} starts"),
            }
        ));
    }
    Some(comparison)
}

/// The exit code where the last run has no plan.
pub(super) fn no_plan_code(comparison: &Comparison) -> u8 {
    match comparison.runs.last().map(|r| r.outcome.verdict()) {
        Some(Verdict::ProvedInfeasible) => NO_PLAN,
        _ => INCONCLUSIVE,
    }
}

/// A mode cannot be stood: the report says that nothing was planned.
pub(super) fn refused(
    loaded: &Loaded,
    model: &Model,
    report: &Option<Target>,
    page: &Option<Target>,
    name: Option<&Path>,
    options: &Options,
) -> Result<u8, Problem> {
    let record = Record::refused(model, loaded.sha256());
    let mut results = Vec::new();
    if let Some(target) = report {
        results.push((target, json(&record)?));
    }
    if let (Some(target), Some(mission)) = (page, &model.mission) {
        let subject = subject(loaded, model, mission, &loaded.diagnostics);
        results.push((target, page::refused(&subject, &record)));
    }
    write(&results)?;
    let told = !results.iter().any(|(target, _)| target.is_stdout());
    tell_page(told, page, name, options)?;
    Ok(NO_PLAN)
}

pub(super) fn json(record: &impl serde::Serialize) -> Result<String, Problem> {
    let text = serde_json::to_string_pretty(record).map_err(|e| format!("cannot write the report: {e}"))?;
    Ok(visible::json(text) + "\n")
}

/// `100Hz`, `100 Hz` or `0.5kHz`, as Hz.
pub(super) fn parse_rate(text: &str) -> Result<f64, Problem> {
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
