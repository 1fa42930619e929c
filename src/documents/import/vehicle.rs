//! Vehicles of autopilots and simulators. The format follows from the content of a file, not from its name.

mod ardupilot;
mod draft;
mod frames;
mod parameters;
mod px4;
mod robot;

use super::{ASSUMED, FORMAT, Imported, Outcome, UNSUPPORTED, at};
use crate::diagnostic::Diagnostic;
use crate::foreign::{self, Foreign};
use crate::source::Source;
use parameters::Parameters;

/// Reads the file of a vehicle: parameters of PX4 (`CA_ROTORi_*`, of an airframe script or as QGroundControl saves
/// them) or of ArduPilot (`FRAME_CLASS`, `FRAME_TYPE`); URDF, SDF or MJCF with rotors.
pub fn import(name: &str, bytes: &[u8]) -> Imported {
    super::import(name, bytes, read)
}

/// Whether a text seems to be the file of a vehicle: for the messages of other readers.
pub fn seems_one(text: &str) -> bool {
    matches!(foreign::of_text(text), Some(Foreign::Vehicle(_)))
        || ["CA_ROTOR", "FRAME_CLASS", "param set"].iter().any(|word| text.contains(word))
}

fn read(source: &Source, found: &mut Vec<Diagnostic>) -> Outcome {
    let kind = foreign::of_text(&source.text);
    if let Some(Foreign::Template(_) | Foreign::Certificate | Foreign::Result(_)) = kind {
        return Err(Box::new(super::other(source, kind)));
    }
    if robot::is_one(&source.text) {
        return robot::vehicle(source, found);
    }
    let parameters = parameters::read(source)?;
    let outcome = of_parameters(source, &parameters, found)?;
    if let Some((name, span)) = parameters.included() {
        let message = format!("`{}` is not read: the file includes it", short(name));
        let warning = Diagnostic::warning(ASSUMED, span, message).here("another file");
        found.push(warning.help("put its lines in the place of this one if it has figures of the vehicle"));
    }
    Ok(outcome)
}

fn of_parameters(source: &Source, parameters: &Parameters, found: &mut Vec<Diagnostic>) -> Outcome {
    if let Some(what) = ardupilot::other_vehicle(parameters) {
        return Err(Box::new(what));
    }
    if parameters.is_of("FRAME_CLASS") {
        return ardupilot::vehicle(source, parameters, found);
    }
    if parameters.has_prefix("CA_ROTOR")
        || parameters.is_of("CA_AIRFRAME")
        || parameters.worked_out("CA_ROTOR").is_some()
    {
        return px4::vehicle(source, parameters, found);
    }
    // Of JSON only a plan is one.
    let is_json = source.text.trim_start().starts_with('{');
    let is_plan = matches!(foreign::of_text(&source.text), Some(Foreign::Mission(_)));
    if super::mission::is_one(&source.text) && (is_plan || !is_json) {
        let error = Diagnostic::error(FORMAT, at(source.line(1)), "this is a mission").here("the first line");
        return Err(Box::new(error.help("read it by `mavc import mission`, or name the file of a vehicle")));
    }
    if super::is_spec(source) {
        return Err(Box::new(super::other(source, None)));
    }
    if let Some((name, span)) = parameters.included() {
        let message = format!("no parameter of the file places a rotor, but it includes `{}`", short(name));
        let error = Diagnostic::error(UNSUPPORTED, span, message).here("may have the frame");
        return Err(Box::new(error.help("name this file; or put its lines in the place of this one")));
    }
    Err(Box::new(px4::without_geometry(source, parameters.first()).unwrap_or_else(|| {
        Diagnostic::error(FORMAT, at(0..0), "no vehicle was found in the file").help(
            "name parameters of PX4 (with `CA_ROTOR0_PX`) or ArduPilot (with `FRAME_CLASS`), an airframe script, \
             URDF, SDF or MJCF",
        )
    })))
}

/// A name of a file in a message.
fn short(name: &str) -> String {
    name.chars().take(60).collect()
}
