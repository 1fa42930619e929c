//! Plans and flight logs in the formats of other tools.

use crate::held::Held;
use crate::job::Job;
use crate::plan::Planned;
use crate::{Arguments, Value, error, object};
use mavc::exchange::flight::{self, Recorder};
use mavc::exchange::frames::Frame;
use mavc::exchange::trajectory::{self, Choices, TOLERANCES, Written, write};
use mavc::flight::{Sample, longest};
use mavc::pipeline::fly_plan;
use mavc::report::trajectory_csv::RATES;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::ops::RangeInclusive;

/// A rate in Hz, or none.
///
/// # Errors
/// It is not one that the command takes.
pub fn rate(value: &Bound<PyAny>) -> PyResult<Option<f64>> {
    within(value, &RATES, "a rate lies between 0.001 Hz and 100 kHz")
}

fn within(value: &Bound<PyAny>, bounds: &RangeInclusive<f64>, rule: &str) -> PyResult<Option<f64>> {
    let value: Option<f64> = value.extract()?;
    match value.is_none_or(|value| bounds.contains(&value)) {
        true => Ok(value),
        false => Err(error(rule.into())),
    }
}

/// The value of a name among some.
fn named<T: Copy>(what: &str, name: &str, known: &[(T, &str)]) -> PyResult<T> {
    let found = known.iter().find(|(_, known)| *known == name).map(|(value, _)| *value);
    found.ok_or_else(|| {
        let names: Vec<&str> = known.iter().map(|(_, name)| *name).collect();
        error(format!("there is no {what} {name:?}: choose one of {}", names.join(", ")))
    })
}

/// Bytes, and a line about what they lack.
fn answer(py: Python, bytes: &[u8], remark: Option<String>) -> Value {
    object(py, (PyBytes::new(py, bytes), remark))
}

/// `export(plan, job, format, rate, frame, tolerance)`: `(bytes, remark)` of what `mavc plan -o --format` writes.
/// `rate` is in Hz, `tolerance` in m.
pub fn plan(arguments: Arguments) -> Value {
    let of = Planned::of(&arguments.get_item(0)?)?;
    let (format, frame): (String, Option<String>) =
        (arguments.get_item(4)?.extract()?, arguments.get_item(6)?.extract()?);
    let frames = [(Frame::EnuFlu, "enu-flu"), (Frame::NedFrd, "ned-frd")];
    let choices = Choices {
        format: named("format of plans", &format, &trajectory::FORMATS)?,
        rate: rate(&arguments.get_item(5)?)?,
        frame: frame.map(|frame| named("frame", &frame, &frames)).transpose()?,
        tolerance: within(&arguments.get_item(7)?, &TOLERANCES, "a tolerance lies between 0.001 mm and 1000 m")?,
    };
    choices.check().map_err(error)?;
    let written = Job::of(arguments, 1)?.run(arguments.py(), move |_| {
        let model = of.of.spec.model();
        choices.fit(model)?;
        write(&of.plan()?.trajectory, model, &choices)
    })?;
    let Written { bytes, remark } = written.map_err(error)?;
    answer(arguments.py(), &bytes, remark)
}

/// `bag_files(folder, bytes)`: `[(name, bytes)]`, the files of a bag in a folder of this name.
pub fn bag_files(arguments: Arguments) -> Value {
    let (folder, bytes): (String, Vec<u8>) = arguments.extract()?;
    let file = |(name, bytes): (String, Vec<u8>)| (name, PyBytes::new(arguments.py(), &bytes).unbind());
    object(arguments.py(), trajectory::bag_files(&folder, bytes).into_iter().map(file).collect::<Vec<_>>())
}

/// `export_log(plan, job, format, rate)`: `(bytes, remark)` of what `mavc simulate -o --format` writes. The flight is
/// simulated again.
pub fn log(arguments: Arguments) -> Value {
    let of = Planned::of(&arguments.get_item(0)?)?;
    let name: String = arguments.get_item(4)?.extract()?;
    let format = named("format of flight logs", &name, &flight::FORMATS)?;
    let rate = rate(&arguments.get_item(5)?)?;
    let found = Job::of(arguments, 1)?.run(arguments.py(), move |reports| {
        let (solved, spec) = (of.to_fly()?, &of.of.spec);
        let mut log = Recorder::new(format, spec.model(), rate, longest(spec.model(), solved.time))?;
        let remark = log.remark().map(String::from);
        fly_plan(spec, solved, Some(&mut |sample: &Sample| log.add(sample)), reports);
        Ok((log.finish(), remark))
    })?;
    let (bytes, remark) = found.map_err(error)?;
    answer(arguments.py(), &bytes, remark)
}

/// `layout(plan, format)`: the layout that `mavc simulate --layout` writes.
pub fn layout(arguments: Arguments) -> Value {
    let of = Planned::of(&arguments.get_item(0)?)?;
    let name: String = arguments.get_item(1)?.extract()?;
    let format = named("format of flight logs", &name, &flight::FORMATS)?;
    let text = flight::layout(format, of.of.spec.model().vehicle.rotors.len());
    object(arguments.py(), text.map_err(error)?)
}
