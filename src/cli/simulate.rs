//! `mavc simulate`: plan, then fly.

use super::plan::{PAGE, apart, json, no_plan_code, plan_for, ready, refused, spare, subject, targets, tell_page};
use super::spec::{self, Loaded, timing};
use super::target::{Target, write};
use super::{DIVERGED, FINE, LOST, Options, Problem, SPEC_ERRORS, SimulateArgs, files};
use crate::diagnostic::sort;
use crate::flight::{Outcome, Sample, Sortie, fly, longest, twins};
use crate::model::{FlightBlocks, Model, coarse_step, past_the_end, too_many_steps};
use crate::number::number;
use crate::planner::studies::{PlanOutcome, Scope};
use crate::report::flight::{FlightRecord, Log, Told, text};
use crate::report::page::{self, Kind, Track};
use crate::report::record::Record;
use crate::report::{terminal, trajectory_csv};
use std::time::Instant;

/// Rows of the log a second, where nothing is said.
const LOG_RATE: f64 = 100.0;

pub fn run(args: &SimulateArgs, options: &Options) -> Result<u8, Problem> {
    let rate = args.rate.as_deref().map(super::plan::parse_rate).transpose()?;
    let (table, report) = targets(args.output.as_deref(), args.report.as_deref())?;
    let html = args.html.as_deref().map(Target::new).transpose()?;
    apart(PAGE, &html, &[&table, &report])?;
    let mut loaded = spec::read(&args.spec, FlightBlocks::Used, options)?;
    spare(&loaded, &[&table, &report, &html])?;
    let Some((model, mission)) = ready(&mut loaded, options) else { return Ok(SPEC_ERRORS) };
    let Some(comparison) = plan_for(&loaded, &model, &mission, Scope::Plan, options) else {
        return refused(&loaded, &model, &report, &html, args.html.as_deref(), options);
    };
    let Some(PlanOutcome::Planned(solved)) = comparison.runs.last().map(|r| &r.outcome) else {
        // Where nothing is flown the report is that of the plan.
        if ![&report, &html].into_iter().flatten().any(Target::is_stdout) {
            files::print_painted(&terminal::plan(&model, &mission, &comparison, spec::colored(&std::io::stdout())))?;
            files::print("\nNo flight was simulated because there is no plan. Run `mavc plan` for details.\n")?;
        }
        let record = Record::new(&model, &mission, &comparison, loaded.sha256());
        let mut results = Vec::new();
        if let Some(target) = &report {
            results.push((target, json(&record)?));
        }
        if let Some(target) = &html {
            let subject = subject(&loaded, &model, &mission, &loaded.diagnostics);
            results.push((target, page::plans(Kind::Plan, &subject, &comparison, &record)));
        }
        write(&results)?;
        let told = !results.iter().any(|(target, _)| target.is_stdout());
        tell_page(told, &html, args.html.as_deref(), options)?;
        return Ok(no_plan_code(&comparison));
    };
    if cannot_fly(&mut loaded, &model, solved.time, options) {
        return Ok(SPEC_ERRORS);
    }
    let strikes = &model.simulation.faults;
    let sortie = Sortie::along(&model, &solved.trajectory, strikes, model.simulation.seed);
    let mut log = match &table {
        Some(_) => {
            Some(Log::new(model.vehicle.rotors.len(), every(&model, rate, longest(&model, solved.time), options)?))
        }
        None => None,
    };
    let mut track = html.as_ref().map(|_| Track::new(&model, sortie.duration));
    let begin = Instant::now();
    let flight = match log.is_some() || track.is_some() {
        true => fly(
            &sortie,
            Some(&mut |sample: &Sample| {
                log.iter_mut().for_each(|log| log.add(sample));
                track.iter_mut().for_each(|track| track.add(sample));
            }),
        ),
        false => fly(&sortie, None),
    };
    let spent = begin.elapsed().as_secs_f64();
    timing(options, "flight", begin);
    if options.timings {
        files::tell(&format!(
            "{:<10} {:>9} simulated seconds a second, {} ns a step{}\n",
            "",
            number((flight.end / spent).round()),
            number((1e9 * spent / flight.steps.max(1) as f64).round()),
            if log.is_some() { ", with its log" } else { "" }
        ));
    }
    let groups = twins::along(&model, &solved.trajectory);
    let alike: Vec<Vec<&str>> = groups.iter().map(|group| twins::names(&model, group)).collect();
    let told = Told { model: &model, solved, strikes, flight: &flight, alike: &alike };
    let mut results = Vec::new();
    if let (Some(target), Some(log)) = (&table, log) {
        results.push((target, log.csv));
    }
    if let Some(target) = &report {
        results.push((target, json(&FlightRecord::new(&told, loaded.sha256()))?));
    }
    if let (Some(target), Some(track)) = (&html, track) {
        let subject = subject(&loaded, &model, &mission, &loaded.diagnostics);
        let record = FlightRecord::new(&told, loaded.sha256());
        results.push((target, page::flight(&subject, &comparison, track, &record)));
    }
    let words = text(&told);
    let takes_stdout = |(target, _): &(&Target, String)| target.is_stdout();
    let to_people = !results.iter().any(takes_stdout);
    if to_people {
        files::print(&words)?;
    }
    write(&results)?;
    if !to_people && !report.is_some_and(|r| r.is_stdout()) {
        files::tell(&words);
    }
    if let (true, false, Some(path)) = (to_people, options.quiet, args.output.as_deref()) {
        files::print(&format!("\nFlight log written to {}\n", files::shown(path)))?;
    }
    tell_page(to_people, &html, args.html.as_deref(), options)?;
    Ok(match flight.outcome {
        Outcome::Flown | Outcome::Landed { .. } => FINE,
        Outcome::Lost { .. } => LOST,
        Outcome::Diverged { .. } => DIVERGED,
    })
}

/// Tells what keeps a plan of `time` s from being flown; some of it shows only once the mission is planned.
pub(super) fn cannot_fly(loaded: &mut Loaded, model: &Model, time: f64, options: &Options) -> bool {
    let end = model.simulation.duration.unwrap_or(time);
    let late = past_the_end(model, end).into_iter();
    // What was said before is not said again, and stays for the page.
    let late: Vec<_> = late.chain(too_many_steps(model, longest(model, time))).chain(coarse_step(model)).collect();
    let earlier = std::mem::replace(&mut loaded.diagnostics, late);
    sort(&mut loaded.diagnostics);
    loaded.tell(options);
    let has_errors = loaded.has_errors();
    loaded.diagnostics.splice(0..0, earlier);
    has_errors
}

/// Every so many acts of the controller make a row of the log.
fn every(model: &Model, rate: Option<f64>, duration: f64, options: &Options) -> Result<usize, Problem> {
    let control = model.simulation.control_rate;
    let every = (control / rate.unwrap_or(LOG_RATE)).round().max(1.0);
    let rows = duration * control / every;
    trajectory_csv::few_enough("log", rows.ceil() as u64, &Log::header(model.vehicle.rotors.len()))?;
    let got = control / every;
    if let Some(asked) = rate.filter(|asked| !options.quiet && (got - asked).abs() > 1e-6 * asked) {
        let [asked, got, control] = [asked, got, control].map(number);
        files::tell(&format!("mavc: the log has rows at {got} Hz, not {asked}: the controller acts at {control} Hz\n"));
    }
    Ok(every as usize)
}
