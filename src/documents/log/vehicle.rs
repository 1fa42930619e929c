//! The vehicle of a log: where its motors are and how they turn, by its own parameters and `import::vehicle`.
//!
//! Figures that no log has (mass, arm, inertia) are set to values that do not matter for what is asked of the spec: the
//! outcome of a fault depends on the thrust relative to the weight, which the log shows in hover, and on the shape of
//! the frame.

use super::{ASSUMED, MISSING};
use crate::diagnosis::record::{Autopilot, MOTORS, Record};
use crate::diagnostic::{Diagnostic, Severity};
use crate::import::{unknown, vehicle};
use crate::source::Span;
use crate::spec::{Compiler, Spec};
use std::fmt::Write;

/// `MAV_TYPE` of PX4, and the frame of ArduPilot that has the same order of motors in its X.
const TYPES: [(f64, u32, &str); 3] =
    [(2.0, 1, "a quadcopter X"), (13.0, 2, "a hexacopter X"), (14.0, 3, "an octocopter X")];

/// ArduCopter's `FRAME` of a Y6B before 3.5.
const Y6B: f64 = 10.0;
/// A motor's output moves by so much in a flight, us.
const MOVES: f32 = 30.0;

/// Figures of a vehicle that stand as `?` in the spec of its frame: the last part of a path, and a value of it.
pub type FrameFigures<'f> = &'f [(&'f str, String)];

/// Outputs of an old log that move as those of motors do: by pulses within the range of motors.
fn moving(record: &Record) -> usize {
    let moves = |motor: &usize| {
        let pulses =
            record.outputs.values.iter().map(|row| row[*motor]).filter(|pulse| (900.0..2200.0).contains(pulse));
        let [least, most] = pulses.fold([f32::INFINITY, 0.0], |[least, most], x| [least.min(x), most.max(x)]);
        most - least > MOVES
    };
    (0..MOTORS).filter(moves).count()
}

/// The parameters of a log that place its motors, as a text that `import vehicle` reads; and whether the frame is
/// assumed.
fn parameters(record: &Record) -> Option<(String, Option<&'static str>)> {
    let mut text = String::new();
    let is_named = |name: &str| match record.autopilot {
        Autopilot::ArduPilot => ["FRAME_CLASS", "FRAME_TYPE"].contains(&name),
        _ => name.starts_with("CA_ROTOR") || name == "CA_AIRFRAME",
    };
    for (name, value) in record.parameters.iter().filter(|(name, _)| is_named(name)) {
        let _ = writeln!(text, "{name},{value}");
    }
    match record.autopilot {
        Autopilot::ArduPilot if record.parameters.contains_key("FRAME_CLASS") => Some((text, None)),
        // Before 3.5 the firmware had the class; of six motors the type Y6B has a number of its own.
        Autopilot::ArduPilot => {
            let kind = record.parameters.get("FRAME")?;
            let (class, what) = match (moving(record), *kind == Y6B) {
                (6, true) => (5, "a Y6B, by its six outputs that move and `FRAME`"),
                (4, false) => (1, "a quadcopter, by its four outputs that move"),
                (6, false) => (2, "a hexacopter, by its six outputs that move"),
                (8, false) => (3, "an octocopter, by its eight outputs that move"),
                _ => return None,
            };
            Some((format!("FRAME_CLASS,{class}\nFRAME_TYPE,{kind}\n"), Some(what)))
        }
        _ if record.parameter("CA_ROTOR_COUNT", 0.0) > 0.0 => Some((text, None)),
        _ => {
            let kind = record.parameter("MAV_TYPE", 0.0);
            let (_, class, what) = TYPES.iter().find(|(number, ..)| *number == kind)?;
            Some((format!("FRAME_CLASS,{class}\nFRAME_TYPE,1\n"), Some(what)))
        }
    }
}

/// The text of the frame with `?` for what the log does not say, and warnings.
///
/// # Errors
/// The log does not say the frame, or no spec can express it.
pub fn frame(record: &Record) -> Result<(String, Vec<Diagnostic>), Box<Diagnostic>> {
    let missing = |message: &str, help: &str| {
        Box::new(Diagnostic::error(MISSING, Span::default(), message.to_string()).help(help.to_string()))
    };
    let help = "name the spec of the vehicle after the log: mavc diagnose LOG SPEC";
    let Some((text, assumed)) = parameters(record) else {
        return Err(missing("the log does not say where the motors are", help));
    };
    let imported = vehicle::import("the parameters of the log", text.as_bytes());
    let Some(spec) = imported.text else {
        let why = imported.diagnostics.iter().find(|d| d.severity == Severity::Error);
        let why = why.map_or("its frame is unknown".into(), |d| d.message.clone());
        return Err(missing(&format!("the frame of the log cannot be used: {why}"), help));
    };
    let assumed = assumed.map(|what| {
        let message = format!("the log does not say where the motors are: taken as {what}");
        Diagnostic::warning(ASSUMED, Span::default(), message).help(help)
    });
    Ok((spec, assumed.into_iter().collect()))
}

/// The spec of the text of a frame, each `?` filled in by the last part of its path.
///
/// # Errors
/// A figure is missing or outside the range of a spec: the first message.
pub fn filled(text: &str, figures: FrameFigures) -> Result<Spec, String> {
    let mut compiler = Compiler::new();
    for path in unknown::paths(text) {
        let last = path.rsplit('.').next().unwrap_or(&path);
        if let Some((_, value)) = figures.iter().find(|(name, _)| *name == last) {
            compiler = compiler.set(format!("{path} = {value}"));
        }
    }
    let compiled = compiler.text("the vehicle of the log", text.as_bytes());
    let message = compiled.diagnostics.iter().find(|d| d.severity == Severity::Error).map(|d| d.message.clone());
    compiled.spec.ok_or(message.unwrap_or_default())
}
