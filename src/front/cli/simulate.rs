//! `mavc simulate`: plans the mission, then flies the plan.

use super::flight_log::FlightLog;
use super::progress::Watch;
use super::results::{Names, Places, Results, subject};
use super::spec::{self, Start};
use super::{CommandError, DIVERGED, FINE, LOST, Options, SPEC_ERRORS, SimulateArgs, files};
use crate::exchange::flight::Recorder;
use crate::flight::{Outcome, Sample};
use crate::pipeline::{Task, departure, fly_plan, indistinguishable};
use crate::read::FlightBlocks;
use crate::report::page::{self, Track};
use crate::report::simulation::{FlightRecord, Flown, screen};
use crate::report::volumes::Nearest;

pub fn run(args: &SimulateArgs, options: &Options) -> Result<u8, CommandError> {
    let described = FlightLog::of(args)?;
    let places = Places::new(Names {
        table: args.output.as_deref(),
        report: args.report.as_deref(),
        page: args.html.as_deref(),
        layout: args.layout.as_deref(),
        ..Names::default()
    })?;
    let watch = Watch::new(options);
    let (spec, mut findings) = spec::read(&args.spec, FlightBlocks::Used, &watch)?;
    places.spare(&findings)?;
    described.is_named_well()?;
    let task = match findings.start(spec.as_ref(), Task::new, options) {
        Start::Task(task) => task,
        Start::Refused => return places.refuse(spec.as_ref(), &findings, options),
        Start::Ended(code) => return Ok(code),
    };
    let mut planning = task.plan(&watch);
    if task.model().plan.recovery.require.is_some() {
        // `mavc plan` may plan again for ways out: the same plan is flown.
        task.recovery(&mut planning, false, &watch).map_err(|e| e.to_string())?;
    }
    let Some(solved) = planning.plan() else { return places.report_no_flight(&task, &planning, &findings, options) };
    findings.eprint_new(departure(task.spec(), solved.time), options);
    if findings.has_errors() {
        return Ok(SPEC_ERRORS);
    }
    let model = task.model();
    let mut log = places.table.as_ref().map(|_| described.begin(model, solved.time)).transpose()?;
    if let Some(remark) = log.as_ref().and_then(Recorder::remark).filter(|_| !options.quiet) {
        files::eprint(&format!("mavc: {remark}\n"));
    }
    let mut track = places.page.as_ref().map(|_| Track::along(model, &solved.trajectory));
    let mut nearest = Nearest::new(model);
    let is_recorded = log.is_some() || track.is_some() || !nearest.is_empty();
    let mut record = |sample: &Sample| {
        log.iter_mut().for_each(|log| log.add(sample));
        track.iter_mut().for_each(|track| track.add(sample));
        nearest.add(sample.time, sample.body.position.into());
    };
    let record: Option<&mut dyn FnMut(&Sample)> = if is_recorded { Some(&mut record) } else { None };
    let flight = fly_plan(task.spec(), solved, record, &watch);
    let volumes = &nearest.records();
    let indistinguishable = &indistinguishable(task.spec(), solved);
    let flown = Flown { model, solved, strikes: &model.simulation.faults, flight: &flight, indistinguishable, volumes };
    let record = FlightRecord::new(&flown, task.spec().sha256().into());
    let mut results = Results::new(&places);
    log.into_iter().for_each(|log| results.table(log.finish()));
    described.layout(model)?.into_iter().for_each(|layout| results.layout(layout));
    results.report(&record)?;
    if let Some(track) = track {
        results.page(|| page::flight(&subject(&task, &findings.diagnostics), planning.comparison(), track, &record));
    }
    let shown = screen(&flown, options.verbose);
    results.print(&shown)?;
    results.write()?;
    results.print_beside(&shown);
    results.note("\nFlight log", args.output.as_deref(), options)?;
    results.note_page(options)?;
    Ok(match flight.outcome {
        Outcome::Flown | Outcome::Landed { .. } => FINE,
        Outcome::Trespassed { .. } | Outcome::Lost { .. } => LOST,
        Outcome::Diverged { .. } => DIVERGED,
    })
}
