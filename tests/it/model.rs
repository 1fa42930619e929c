//! Text to model.

mod algebra;
mod families;
mod flights;
mod intervals;
mod numbers;
mod overriding;
mod pages;
mod parts;
mod reading;
mod recovering;
mod sense;
mod shipped;

use mavc::diagnostic::Diagnostic;
use mavc::model::Model;
use mavc::read::{FileSet, elaborate, load};
use std::io;
use std::path::Path;

/// A quadcopter for specs that are about something else.
const QUAD: &str = include_str!("../specs/parts/quad.mav");

/// Model and diagnostics of a text that reads no files but the quadcopter.
fn check(text: &str) -> (Option<Model>, Vec<Diagnostic>) {
    let read = |path: &Path| match path.to_str() {
        Some("vehicles/quad.mav") => Ok(QUAD.as_bytes().to_vec()),
        _ => Err(io::Error::from(io::ErrorKind::NotFound)),
    };
    let (set, diagnostics) = load("spec.mav", text.as_bytes(), &read);
    finish(&set, diagnostics)
}

/// Model and diagnostics of a file.
fn check_file(name: &str) -> (Option<Model>, Vec<Diagnostic>) {
    let bytes = std::fs::read(name).unwrap();
    let (set, diagnostics) = load(name, &bytes, &|path: &Path| std::fs::read(path));
    finish(&set, diagnostics)
}

fn finish(set: &FileSet, mut diagnostics: Vec<Diagnostic>) -> (Option<Model>, Vec<Diagnostic>) {
    let checked = elaborate(set, &[]);
    diagnostics.extend(checked.diagnostics);
    (checked.value, diagnostics)
}

/// The model of a spec about which there is nothing to say; the quadcopter is added.
fn model(text: &str) -> Model {
    let (model, diagnostics) = check(&format!("{QUAD}{text}"));
    assert_eq!(diagnostics, vec![], "{text}");
    model.unwrap()
}

fn codes(text: &str) -> Vec<&'static str> {
    check(text).1.iter().map(|d| d.code).collect()
}
