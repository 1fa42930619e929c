//! Specs without text: the calls of a `Builder`.

use crate::job::detached;
use crate::{Arguments, Value, object};
use mavc::builder::{BuildProblem, Builder, Value as Field};
use mavc::language::{Entry, Group, Takes};
use mavc::unit::parse_unit;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyList, PyString};

/// The blocks whose fields have units, by the names that Python uses.
const GROUPS: [(&str, Group); 19] = [
    ("top", Group::Top),
    ("vehicle", Group::Vehicle),
    ("rotor", Group::Rotor),
    ("placed_rotor", Group::PlacedRotor),
    ("battery", Group::Battery),
    ("parts", Group::Parts),
    ("part", Group::Part),
    ("mode", Group::Mode),
    ("waypoint", Group::Waypoint),
    ("limits", Group::Limits),
    ("volume", Group::Volume),
    ("mission", Group::Mission),
    ("landing_site", Group::LandingSite),
    ("area", Group::KeepOff),
    ("after_fault_limits", Group::AfterFaultLimits),
    ("plan", Group::Plan),
    ("recovery", Group::Recovery),
    ("simulate", Group::Simulate),
    ("campaign", Group::Campaign),
];

/// `unit(block, field)`: the SI unit of a field as written after a number, `""` for a plain number, `None` if the block
/// has no such field or it takes no number.
pub fn unit(arguments: Arguments) -> Value {
    let (block, field): (String, String) = arguments.extract()?;
    object(arguments.py(), entry(&block, &field).and_then(Entry::unit).and_then(si))
}

fn entry(block: &str, field: &str) -> Option<&'static Entry> {
    let group = GROUPS.iter().find(|(name, _)| *name == block).map(|(_, group)| group);
    group.and_then(|group| group.entry(field))
}

/// `is_text(block, field)`: whether a field takes a text in quotes.
pub fn is_text(arguments: Arguments) -> Value {
    let (block, field): (String, String) = arguments.extract()?;
    object(arguments.py(), entry(&block, &field).is_some_and(|entry| entry.takes == Takes::Text))
}

/// `dimension(unit)`: a unit in base units, `None` if it is not a unit of the language. Units of one dimension give one
/// text.
pub fn dimension(arguments: Arguments) -> Value {
    let (unit,): (String,) = arguments.extract()?;
    object(arguments.py(), si(&unit))
}

/// `kg*m^2` for any unit of this dimension.
fn si(unit: &str) -> Option<String> {
    match unit {
        "1" | "" => Some(String::new()),
        _ => parse_unit(unit, 1.0).ok().map(|unit| unit.dimension.to_string()),
    }
}

/// `build(calls)`: `(text, problems)` of calls `(method, arguments)` of `Builder`. A problem is
/// `(field, code, message, label, help)`; without one the text is a spec.
pub fn build(arguments: Arguments) -> Value {
    let (calls,): (Bound<PyList>,) = arguments.extract()?;
    let mut builder = Builder::new();
    for item in calls.iter() {
        let (method, values): (String, Bound<PyList>) = item.extract()?;
        builder = call(builder, &method, &values)?;
    }
    let (text, problems) = detached(arguments.py(), move || {
        let text = builder.text();
        (text, builder.build().err().map_or(Vec::new(), |error| error.problems))
    })?;
    let tuple = |BuildProblem { field, code, message, label, help }: BuildProblem| (field, code, message, label, help);
    object(arguments.py(), (text, problems.into_iter().map(tuple).collect::<Vec<_>>()))
}

fn call(builder: Builder, method: &str, values: &Bound<PyList>) -> PyResult<Builder> {
    let text = |k: usize| values.get_item(k)?.extract::<String>();
    let number = |k: usize| values.get_item(k)?.extract::<f64>();
    let rotors = |k: usize| values.get_item(k)?.extract::<Vec<usize>>();
    let value = |k: usize| field(&values.get_item(k)?);
    let clauses = |k: usize| values.get_item(k)?.extract::<Vec<(String, f64)>>();
    Ok(match method {
        "top" => builder.top(&text(0)?, value(1)?),
        "vehicle" => builder.vehicle(&text(0)?, value(1)?),
        "rotor" => builder.rotor(&text(0)?, value(1)?),
        "battery" => builder.battery(&text(0)?, value(1)?),
        "parts" => builder.parts(&text(0)?, value(1)?),
        "part" => builder.part(
            &text(0)?,
            number(1)?,
            values.get_item(2)?.extract()?,
            values.get_item(3)?.extract::<Option<[f64; 3]>>()?,
        ),
        "placed_rotor" => builder.placed_rotor(values.get_item(0)?.extract()?, &text(1)?, &borrowed(&clauses(2)?)),
        "lost" => builder.lost(&text(0)?, &rotors(1)?),
        "reduced" => builder.reduced(&text(0)?, &rotors(1)?, number(2)?),
        "stuck" => builder.stuck(&text(0)?, &rotors(1)?, number(2)?),
        "mode" => builder.mode(&text(0)?, &text(1)?, value(2)?),
        "plan" => builder.plan(&text(0)?, value(1)?),
        "simulate" => builder.simulate(&text(0)?, value(1)?),
        "strike" => builder.strike(&text(0)?, number(1)?),
        "campaign" => builder.campaign(&text(0)?, value(1)?),
        "waypoint" => builder.waypoint_with(values.get_item(0)?.extract()?, &borrowed(&clauses(1)?)),
        "hold" => builder.hold(number(0)?),
        "start_moving" => builder.start_moving(),
        "end_moving" => builder.end_moving(),
        "at_most" => builder.at_most(&text(0)?, number(1)?),
        "at_least" => builder.at_least(&text(0)?, number(1)?),
        "between" => builder.between(&text(0)?, number(1)?, number(2)?),
        "keep_in" => builder.keep_in(&text(0)?, &text(1)?),
        "keep_out" => builder.keep_out(&text(0)?, &text(1)?),
        "volume" => builder.volume(&text(0)?, &text(1)?, value(2)?),
        "mission" => builder.mission(&text(0)?, value(1)?),
        "landing_site" => builder.landing_site(&text(0)?, values.get_item(1)?.extract()?, number(2)?),
        "keep_off" => builder.keep_off(&text(0)?, &text(1)?),
        "area" => builder.area(&text(0)?, &text(1)?, value(2)?),
        "after_fault_at_most" => builder.after_fault_at_most(&text(0)?, number(1)?),
        "recovery" => builder.recovery(&text(0)?, value(1)?),
        _ => return Err(PyValueError::new_err(format!("the builder has no call {method:?}"))),
    })
}

fn borrowed(clauses: &[(String, f64)]) -> Vec<(&str, f64)> {
    clauses.iter().map(|(name, value)| (name.as_str(), *value)).collect()
}

/// The value of a field: a number, a word, words, three numbers, or points.
fn field(value: &Bound<PyAny>) -> PyResult<Field> {
    if value.is_instance_of::<PyString>() {
        return Ok(Field::Word(value.extract()?));
    }
    if let Ok(number) = value.extract::<f64>() {
        return Ok(Field::Number(number));
    }
    if let Ok(names) = value.extract::<Vec<String>>() {
        return Ok(Field::Names(names));
    }
    if let Ok(vector) = value.extract::<[f64; 3]>() {
        return Ok(Field::Vector(vector));
    }
    if let Ok(points) = value.extract::<Vec<[f64; 2]>>() {
        return Ok(Field::Points(points));
    }
    Err(PyTypeError::new_err("a field takes a number, three numbers, a word, words, or points [x, y]"))
}
