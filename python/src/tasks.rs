//! Checks, analyses, comparisons and certificates.

use crate::compile::{Shown, json, json_line, shown};
use crate::held::{Compiled, Held};
use crate::job::Job;
use crate::{Arguments, Value, object};
use mavc::diagnostic::sort;
use mavc::pipeline::{Sweep, Task};
use mavc::report::analysis_record::AnalysisRecord;
use mavc::report::headline::headline;
use mavc::report::{analysis_screen, capture_text};
use mavc::verify::text::verification;
use pyo3::prelude::*;

/// `check(spec, job)`: the diagnostics of `mavc check`.
pub fn check(arguments: Arguments) -> Value {
    let of = Compiled::of(&arguments.get_item(0)?)?;
    let found = Job::of(arguments, 1)?.run(arguments.py(), move |_| {
        let mut found = of.diagnostics.clone();
        found.extend(mavc::check(&of.spec));
        sort(&mut found);
        shown(&found, of.spec.sources())
    })?;
    object(arguments.py(), found)
}

/// `analyze(spec, job, capture, sweep)`: `(json, text, headline)`, or a text that says why the sweep cannot be made.
pub fn analyze(arguments: Arguments) -> Value {
    let of = Compiled::of(&arguments.get_item(0)?)?;
    let (capture, sweep): (bool, Option<String>) =
        (arguments.get_item(4)?.extract()?, arguments.get_item(5)?.extract()?);
    let found = Job::of(arguments, 1)?.run(arguments.py(), move |_| {
        let (spec, model) = (&of.spec, of.spec.model());
        let modes = mavc::analyze(spec);
        let captures = capture.then(|| mavc::capture(spec));
        let sweep = sweep.map(|text| Sweep::run(&text, spec, &modes)).transpose()?;
        let flips = sweep.as_ref().map(|sweep| sweep.flips.as_slice());
        let record = json_line(&AnalysisRecord::new(model, &modes, flips, captures.as_deref()));
        let text = match (&sweep, &captures) {
            (Some(sweep), _) => sweep.to_text(model),
            (None, Some(captures)) => capture_text::captures(model, captures),
            (None, None) => analysis_screen::screen(model, &modes).to_string(),
        };
        Ok::<_, String>((record, text, headline(model, &modes)))
    })?;
    match found {
        Ok(found) => object(arguments.py(), found),
        Err(why) => object(arguments.py(), why),
    }
}

/// `compare(spec, job)`: `(json or None, shown)`; without a record the spec cannot be compared.
pub fn compare(arguments: Arguments) -> Value {
    let of = Compiled::of(&arguments.get_item(0)?)?;
    let found: (Option<String>, Shown) = Job::of(arguments, 1)?.run(arguments.py(), move |reports| {
        let mut found = of.diagnostics.clone();
        let task = Task::to_compare(&of.spec);
        found.extend_from_slice(task.as_ref().map_or_else(|refusal| refusal.diagnostics(), Task::remarks));
        sort(&mut found);
        let record = task.ok().map(|task| {
            let mut record = task.comparison_report(&task.compare(reports));
            record.recoverable = task.recoverable(reports);
            json(&record)
        });
        (record, shown(&found, of.spec.sources()))
    })?;
    object(arguments.py(), found)
}

/// `verify(spec, job, certificate)`: `((text, headline, weaker, undecided), None)`, or `(None, shown)` if it is
/// rejected.
pub fn verify(arguments: Arguments) -> Value {
    let of = Compiled::of(&arguments.get_item(0)?)?;
    let certificate: Vec<u8> = arguments.get_item(4)?.extract()?;
    let found = Job::of(arguments, 1)?.run(arguments.py(), move |_| {
        let verdict = mavc::verify(&certificate, &of.spec);
        verdict.map_err(|rejected| shown(std::slice::from_ref(&*rejected.diagnostic), &rejected.sources))
    })?;
    match found {
        Ok(verdict) => {
            let text = verification("<certificate>", &verdict);
            let accepted = (text, verdict.headline, verdict.weaker, verdict.undecided);
            object(arguments.py(), (Some(accepted), None::<Shown>))
        }
        Err(shown) => object(arguments.py(), (None::<String>, Some(shown))),
    }
}

/// `panic(job)`: panics within a run. Tests need one, and the library has none.
pub fn panic(arguments: Arguments) -> Value {
    Job::of(arguments, 0)?.run(arguments.py(), |_| panic!("as asked"))
}
