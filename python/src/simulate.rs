//! Simulated flights along plans.

use crate::compile::{json, shown};
use crate::export;
use crate::held::Held;
use crate::job::{Job, Reports};
use crate::plan::Planned;
use crate::{Arguments, Value, object};
use mavc::diagnostic::{Diagnostic, Severity};
use mavc::flight::{Outcome, Sample, longest};
use mavc::pipeline::{departure, fly_plan, indistinguishable};
use mavc::report::page::{self, Subject, Track};
use mavc::report::simulation::{FlightRecord, Flown, Log, screen};
use mavc::report::volumes::Nearest;
use pyo3::prelude::*;

/// What of a flight is wanted besides its record.
#[derive(Clone, Copy)]
struct Wanted {
    /// Of the log, Hz.
    rate: Option<f64>,
    page: bool,
}

/// The texts of a flight, as the command writes them.
struct Texts {
    outcome: &'static str,
    json: String,
    text: String,
    csv: String,
    remark: Option<String>,
    page: Option<String>,
}

/// `simulate(plan, job, rate or None, page)`: `(outcome, json, text, csv, remark, page or None, shown)`, or
/// `(None, shown)` if the `simulate` block does not fit the plan.
pub fn simulate(arguments: Arguments) -> Value {
    let py = arguments.py();
    let of = Planned::of(&arguments.get_item(0)?)?;
    let wanted = Wanted { rate: export::rate(&arguments.get_item(4)?)?, page: arguments.get_item(5)?.extract()? };
    let result = Job::of(arguments, 1)?.run(py, move |reports| {
        let remarks = remarks(&of)?;
        let shown = shown(&remarks, of.sources());
        match remarks.iter().any(|d| d.severity == Severity::Error) {
            true => Ok((None, shown)),
            false => flown(&of, &remarks, wanted, reports).map(|texts| (Some(texts), shown)),
        }
    })?;
    match result.map_err(crate::error)? {
        (Some(Texts { outcome, json, text, csv, remark, page }), shown) => {
            object(py, (outcome, json, text, csv, remark, page, shown))
        }
        (None, shown) => object(py, (None::<String>, shown)),
    }
}

/// Errors and warnings about the flight along the plan.
fn remarks(planned: &Planned) -> Result<Vec<Diagnostic>, String> {
    Ok(departure(&planned.of.spec, planned.to_fly()?.time))
}

fn flown(planned: &Planned, remarks: &[Diagnostic], wanted: Wanted, reports: &Reports) -> Result<Texts, String> {
    let task = planned.task()?;
    let solved = planned.to_fly()?;
    let done = planned.done.as_ref().ok_or("nothing was planned")?;
    let model = task.model();
    let mut log = Log::at(model, wanted.rate, longest(model, solved.time))?;
    let mut track = wanted.page.then(|| Track::along(model, &solved.trajectory));
    let mut nearest = Nearest::new(model);
    let mut record = |sample: &Sample| {
        log.add(sample);
        track.iter_mut().for_each(|track| track.add(sample));
        nearest.add(sample.time, sample.body.position.into());
    };
    let flight = fly_plan(task.spec(), solved, Some(&mut record), reports);
    let volumes = &nearest.records();
    let indistinguishable = &indistinguishable(task.spec(), solved);
    let flown = Flown { model, solved, strikes: &model.simulation.faults, flight: &flight, indistinguishable, volumes };
    let record = FlightRecord::new(&flown, task.spec().sha256().into());
    let page = track.map(|track| {
        let shown: Vec<Diagnostic> = planned.diagnostics.iter().chain(remarks).cloned().collect();
        let subject = Subject { problem: task.problem(), sources: planned.sources(), diagnostics: &shown };
        page::flight(&subject, done.planning.comparison(), track, &record)
    });
    let outcome = match flight.outcome {
        Outcome::Flown => "flown",
        Outcome::Landed { .. } => "landed",
        Outcome::Trespassed { .. } => "trespassed",
        Outcome::Lost { .. } => "lost",
        Outcome::Diverged { .. } => "diverged",
    };
    Ok(Texts {
        outcome,
        json: json(&record),
        text: screen(&flown, false).to_string(),
        remark: log.thinning.remark,
        csv: log.csv,
        page,
    })
}
