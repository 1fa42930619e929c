//! Vehicles of autopilots and simulators. The format follows from the file's content, not its name.

mod px4;

use super::{FORMAT, Imported, Outcome, at};
use crate::diagnostic::Diagnostic;
use crate::source::Source;

/// Reads the file of a vehicle.
pub fn import(name: &str, bytes: &[u8]) -> Imported {
    super::import(name, bytes, |source, _| read(source))
}

fn read(source: &Source) -> Outcome {
    if px4::is_one(source) {
        return px4::read(source);
    }
    let error = Diagnostic::error(FORMAT, at(0..0), "this is no vehicle that can be read");
    Err(Box::new(
        error.help("name PX4 parameters (`CA_ROTOR0_PX`), ArduPilot parameters (`FRAME_CLASS`), URDF, SDF or MJCF"),
    ))
}
