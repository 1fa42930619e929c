//! What flight logs show.

use crate::compile::{Shown, json_line, shown};
use crate::held::{Compiled, Held};
use crate::job::Job;
use crate::{Arguments, Value, object};
use mavc::diagnostic::Diagnostic;
use mavc::pipeline::{self, Diagnosed, Figure, Identified, Undiagnosed, Why};
use mavc::report::diagnosis::{DiagnosisRecord, screen};
use mavc::source::{Source, SourceMap};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::fs::File;
use std::io::{self, Read};

/// A log as Python gives it: its name, and its bytes unless it is a file.
type Given = (String, Option<Vec<u8>>);

/// Opens a log; files are streamed.
fn open((name, bytes): Given) -> io::Result<Box<dyn Read>> {
    Ok(match bytes {
        Some(bytes) => Box::new(io::Cursor::new(bytes)),
        None => Box::new(File::open(name)?),
    })
}

/// Diagnostics about a log, which is no text that could be shown.
fn about(name: &str, found: &[Diagnostic]) -> Shown {
    let mut sources = SourceMap::default();
    sources.add(Source::new(name, ""));
    shown(found, &sources)
}

/// The diagnostics of a log that shows nothing.
///
/// # Errors
/// The log could not be read.
fn refused(name: &str, why: Why) -> io::Result<Shown> {
    match why {
        Why::Not(found) => Ok(about(name, &found)),
        Why::Io(error) => Err(error),
        Why::Argument(why) => Err(io::Error::new(io::ErrorKind::InvalidInput, why)),
    }
}

/// `diagnose((name, bytes or None), job, spec or None, hidden, baseline)`: `(json or None, text, shown)`
pub fn diagnose(arguments: Arguments) -> Value {
    let log: Given = arguments.get_item(0)?.extract()?;
    let spec = Some(arguments.get_item(4)?).filter(|handle| !handle.is_none());
    let spec = spec.map(|handle| Compiled::of(&handle)).transpose()?;
    let (hidden, baseline): (Vec<usize>, Vec<Given>) =
        (arguments.get_item(5)?.extract()?, arguments.get_item(6)?.extract()?);
    let found = Job::of(arguments, 1)?.run(arguments.py(), move |_| {
        let name = log.0.clone();
        let good: Vec<String> = baseline.iter().map(|(name, _)| name.clone()).collect();
        let mut log = open(log)?;
        let mut baseline = baseline.into_iter().map(open).collect::<io::Result<Vec<_>>>()?;
        match pipeline::diagnose(&mut log, spec.as_ref().map(|of| &of.spec), &hidden, &mut baseline) {
            Ok(Diagnosed { diagnosis, diagnostics, .. }) => {
                let record = json_line(&DiagnosisRecord::new(&diagnosis));
                Ok((Some(record), screen(&diagnosis).to_string(), about(&name, &diagnostics)))
            }
            Err(Undiagnosed { baseline, why }) => {
                let name = baseline.map_or(&name, |k| &good[k]);
                refused(name, why).map(|shown| (None, String::new(), shown))
            }
        }
    })?;
    object(arguments.py(), found.map_err(raised)?)
}

/// A log that cannot be read, or an argument beside it that cannot be used.
fn raised(error: io::Error) -> PyErr {
    match error.kind() {
        io::ErrorKind::InvalidInput => PyValueError::new_err(error.to_string()),
        _ => error.into(),
    }
}

/// A figure: `(field, value or None, (low, high) or None, remark)`
type Row = (String, Option<f64>, Option<(f64, f64)>, String);

fn row(Figure { field, value, remark }: Figure) -> Row {
    let interval = value.and_then(|(_, interval)| interval);
    (field, value.map(|(value, _)| value), interval.map(|[low, high]| (low, high)), remark)
}

/// `identify((name, bytes or None), job, mass)`: `(text or None, figures, shown)`
pub fn identify(arguments: Arguments) -> Value {
    let (log, mass): (Given, String) = (arguments.get_item(0)?.extract()?, arguments.get_item(4)?.extract()?);
    let found = Job::of(arguments, 1)?.run(arguments.py(), move |_| {
        let name = log.0.clone();
        match pipeline::identify(&mut open(log)?, &mass) {
            Ok(Identified { text, figures, diagnostics }) => {
                let figures: Vec<Row> = figures.into_iter().map(row).collect();
                Ok((Some(text), figures, about(&name, &diagnostics)))
            }
            Err(Undiagnosed { why, .. }) => refused(&name, why).map(|shown| (None, Vec::new(), shown)),
        }
    })?;
    object(arguments.py(), found.map_err(raised)?)
}
