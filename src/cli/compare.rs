//! `mavc compare`: every planner, side by side.

use super::plan::{
    PAGE, apart, figures, is_folder, json, plan_for, ready, refused, spare, subject, targets, tell_page, tell_written,
};
use super::progress::Progress;
use super::spec;
use super::target::{Target, write};
use super::{CompareArgs, FINE, INCONCLUSIVE, NO_PLAN, Options, Problem, SPEC_ERRORS, files};
use crate::certify;
use crate::diagnostic::Diagnostic;
use crate::model::{FlightBlocks, MAX_ROUNDS, MAX_SAMPLES_OF_A_SEARCH, Mission, MissionTime, Model};
use crate::motion::time_grid::determined;
use crate::planner::studies::rounds;
use crate::planner::studies::{Comparison, PlannerRun, Run, Scope};
use crate::report::comparison_text;
use crate::report::page::{self, Kind, Subject};
use crate::report::record::{Record, RoundRecord};
use crate::verdict::Verdict;

pub fn compare(args: &CompareArgs, options: &Options) -> Result<u8, Problem> {
    let wanted = args.rounds.as_deref().map(parse_rounds).transpose()?;
    let (_, report) = targets(None, args.report.as_deref())?;
    let html = args.html.as_deref().map(Target::new).transpose()?;
    apart(PAGE, &html, &[&report])?;
    args.svg.as_deref().map_or(Ok(()), is_folder)?;
    let mut loaded = spec::read(&args.spec, FlightBlocks::Unused, options)?;
    spare(&loaded, &[&report, &html])?;
    if let Some(error) = loaded.model.as_ref().and_then(too_many_samples) {
        loaded.diagnostics.push(error);
        loaded.tell(options);
        return Ok(SPEC_ERRORS);
    }
    let Some((model, mission)) = ready(&mut loaded, options) else { return Ok(SPEC_ERRORS) };
    let Some(mut comparison) = plan_for(&loaded, &model, &mission, Scope::Everything, options) else {
        return refused(&loaded, &model, &report, &html, args.html.as_deref(), options);
    };
    let rounds = wanted.map(|wanted| {
        let progress = Progress::new(options);
        let tell = |round: &str, time: f64| progress.tell(round, time);
        let mut rounds = rounds::rounds(&model, &mission, &mut comparison, wanted, Some(&tell));
        progress.done();
        certify::check_rounds(&model, &mission, &mut rounds);
        rounds
    });
    let told = ![&report, &html].into_iter().flatten().any(Target::is_stdout);
    if told {
        files::print_painted(&comparison_text::compare(
            &model,
            &mission,
            &comparison,
            spec::colored(&std::io::stdout()),
        ))?;
        if let Some(rounds) = &rounds {
            files::print(&comparison_text::rounds(&model, &mission, &comparison, rounds))?;
        }
    }
    let subject = subject(&loaded, &model, &mission, &[]);
    let figures = figures(args.svg.as_deref(), &subject, &comparison, &[&report, &html])?;
    let mut results: Vec<_> = figures.iter().map(|(target, text)| (target, text.clone())).collect();
    if report.is_some() || html.is_some() {
        let rounds = rounds.map(|all| all.iter().map(|r| RoundRecord::new(&mission, r)).collect());
        let record = Record { rounds, ..Record::new(&model, &mission, &comparison, loaded.sha256()) };
        if let Some(target) = &report {
            results.push((target, json(&record)?));
        }
        if let Some(target) = &html {
            let subject = Subject { diagnostics: &loaded.diagnostics, ..subject };
            results.push((target, page::plans(Kind::Compare, &subject, &comparison, &record)));
        }
    }
    write(&results)?;
    tell_page(told, &html, args.html.as_deref(), options)?;
    tell_written("Figures", told, args.svg.as_deref(), options)?;
    Ok(compared_code(&model, &mission, &comparison))
}

/// The exit code of planners side by side, at the time that the spec asks for where it asks for one.
fn compared_code(model: &Model, mission: &Mission, comparison: &Comparison) -> u8 {
    let is_fixed = determined(mission).is_some() || matches!(model.plan.time, MissionTime::Fixed(_));
    let asked = |run: &&PlannerRun| !is_fixed || run.run == Run::Common;
    let any = |verdict: Verdict| comparison.runs.iter().filter(asked).any(|r| r.outcome.verdict() == verdict);
    match (any(Verdict::NotFound), any(Verdict::Found), any(Verdict::ProvedInfeasible)) {
        (false, true, _) => FINE,
        (false, false, true) => NO_PLAN,
        _ => INCONCLUSIVE,
    }
}

/// Every planner looks for its shortest time too, which takes many plans.
fn too_many_samples(model: &Model) -> Option<Diagnostic> {
    let samples = model.plan.samples;
    let most = MAX_SAMPLES_OF_A_SEARCH;
    let message = format!("{samples} samples are too many to compare planners: at most {most}");
    let error = Diagnostic::error("mavc::plan::samples", model.plan.samples_span, message);
    let help = format!("`mavc compare --set plan.samples={most}` leaves the file as it is");
    (samples > most).then(|| error.here("too many for every planner's shortest time").help(help))
}

/// `0..5` or `3`, both ends included.
fn parse_rounds(text: &str) -> Result<(usize, usize), Problem> {
    let (first, last) = text.split_once("..").unwrap_or((text, text));
    let whole = |t: &str| t.trim().parse::<usize>().ok().filter(|n| *n <= MAX_ROUNDS);
    match (whole(first), whole(last)) {
        (Some(a), Some(b)) if a <= b => Ok((a, b)),
        (Some(_), Some(_)) => Err(format!("--rounds {text}: the first number is the smaller one, as in 0..5")),
        _ => Err(format!("--rounds {text}: write whole numbers up to {MAX_ROUNDS}, such as 0..5")),
    }
}
