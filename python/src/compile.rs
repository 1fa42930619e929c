//! Texts to specs, and what is known of a spec without work.

use crate::held::{Compiled, Held};
use crate::job::detached;
use crate::{Arguments, Value, object};
use mavc::diagnostic::{Diagnostic, Severity, render_human, to_json_line};
use mavc::pipeline::{actuation_text, defaults_text, mjcf_text, model_record, sets_text};
use mavc::report::screen::WIDTH;
use mavc::source::{SourceMap, visible};
use mavc::spec::Compiler;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use serde::Serialize;

/// Diagnostics as Python takes them: the text of the terminal, and a line of JSON for each.
pub type Shown = (String, String);

pub fn shown(diagnostics: &[Diagnostic], sources: &SourceMap) -> Shown {
    let json = diagnostics.iter().map(|d| to_json_line(d, sources) + "\n").collect();
    (render_human(diagnostics, sources, WIDTH, false), json)
}

/// A record as the command writes it to a file.
pub fn json(record: &impl Serialize) -> String {
    visible::json(serde_json::to_string_pretty(record).expect("texts and numbers always serialise")) + "\n"
}

/// A record as the command prints it on one line.
pub fn json_line(record: &impl Serialize) -> String {
    visible::json(serde_json::to_string(record).expect("texts and numbers always serialise")) + "\n"
}

/// `(handle or None, shown)`
fn answer(py: Python, compiled: mavc::Compiled) -> Value {
    let mavc::Compiled { spec, diagnostics, files } = compiled;
    let shown = shown(&diagnostics, &files.sources);
    let handle = spec.map(|spec| Compiled { spec, diagnostics }.into_handle(py)).transpose()?;
    object(py, (handle, shown))
}

/// `compile(name, bytes, overrides, flights)`; files that the text names are read from the disk.
pub fn compile(arguments: Arguments) -> Value {
    let (name, bytes, overrides, flights): (String, Vec<u8>, Vec<String>, bool) = arguments.extract()?;
    let compiled = detached(arguments.py(), move || {
        let compiler = overrides.into_iter().fold(Compiler::new(), Compiler::set);
        let compiler = if flights { compiler } else { compiler.without_flights() };
        compiler.text(&name, &bytes)
    })?;
    answer(arguments.py(), compiled)
}

/// `facts(spec, what)`: texts about a spec.
pub fn facts(arguments: Arguments) -> Value {
    let (handle, what): (Bound<PyAny>, String) = arguments.extract()?;
    let of = Compiled::of(&handle)?;
    let text = detached(arguments.py(), move || {
        let spec = &of.spec;
        Some(match what.as_str() {
            "sha256" => spec.sha256().into(),
            "defaults" => defaults_text(spec),
            "model" => json(&model_record(spec)),
            "actuation" => actuation_text(spec),
            "sets" => sets_text(spec),
            "mjcf" => mjcf_text(spec),
            "text" => spec.sources().iter().next().map_or(String::new(), |(_, source)| source.text.to_string()),
            "modes" => json_line(&spec.model().modes.iter().map(|mode| &mode.name).collect::<Vec<_>>()),
            "has_errors" => of.diagnostics.iter().any(|d| d.severity == Severity::Error).to_string(),
            _ => return None,
        })
    })?;
    object(arguments.py(), text.ok_or_else(|| PyValueError::new_err("no such fact"))?)
}

/// `format(text)`: `(text or None, shown)`
pub fn format(arguments: Arguments) -> Value {
    let (text,): (String,) = arguments.extract()?;
    let result = detached(arguments.py(), move || {
        let mut sources = SourceMap::default();
        sources.add(mavc::source::Source::new("<spec>", text.as_str()));
        mavc::format(&text).map_err(|diagnostics| shown(&diagnostics, &sources))
    })?;
    match result {
        Ok(text) => object(arguments.py(), (Some(text), (String::new(), String::new()))),
        Err(shown) => object(arguments.py(), (None::<String>, shown)),
    }
}

/// `templates()`: what `mavc new` writes, by kind; the plain one has an empty kind.
pub fn templates(arguments: Arguments) -> Value {
    let plain = [("", mavc::TEMPLATE)];
    object(arguments.py(), plain.into_iter().chain(mavc::MISSION_TEMPLATES).collect::<Vec<_>>())
}
