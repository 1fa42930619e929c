//! Missions of ground stations: plans of QGroundControl, MAVLink's plain text (`QGC WPL 110`), and tables of waypoints.
//! The format follows from the file's content, not its name.
//!
//! # Steps
//! 1. `qgc_plan`, `wpl` or `table` reads the file; places on the Earth become x east, y north, z up about the planned
//!    home.
//! 2. `items` follows MAVLink's commands and makes the waypoints of a draft, `fence` its volumes, `rally` its landing
//!    sites.
//! 3. `write` makes the text of the spec, and keeps for each of its lines the item that it came from.
//! 4. `join` compiles this text with a vehicle, and reports each mistake at the item.

mod autopilot;
mod commands;
mod draft;
mod fence;
mod flyable;
mod items;
mod join;
mod qgc_plan;
mod rally;
mod table;
mod wpl;
mod write;

pub use join::{Joined, join, names_in};
pub use write::Written;

use super::{ASSUMED, FORMAT, Imported, at};
use crate::diagnostic::Diagnostic;
use crate::foreign::{self, Foreign};
use crate::source::Source;
use draft::Draft;

/// Code: an item or a value that the spec leaves out, or only approximates.
pub const LEFT_OUT: &str = "mavc::import::left_out";
/// Code: an item sets a speed that the vehicle does not reach.
pub const SPEED: &str = "mavc::import::speed";
/// Code: an item has a time at which the vehicle cannot be there yet.
pub const TOO_SOON: &str = "mavc::import::too_soon";

/// Whether a text is a mission that [`import`] can read: for commands that take specs and missions.
pub fn is_one(text: &str) -> bool {
    let start = text.trim_start();
    start.starts_with('{') || start.starts_with("QGC WPL") || table::is_one(text)
}

/// Reads the file of a mission. The spec begins with `use` of `vehicle`, the path of a spec as the new one names it, if
/// it is given.
pub fn import(name: &str, bytes: &[u8], vehicle: Option<&str>) -> Imported {
    import_beside(name, bytes, vehicle, &[])
}

/// [`import`], where the mission gets none of the names `taken`: those of the vehicle's spec ([`names_in`]).
pub fn import_beside(name: &str, bytes: &[u8], vehicle: Option<&str>, taken: &[String]) -> Imported {
    super::import(name, bytes, |source, found| {
        let draft = read(source, found)?;
        let Written { text, .. } = write::text(source, &draft, vehicle, &write::name(&source.name, taken))?;
        let laid_out = crate::format::format(crate::source::FileId(0), &Source::new(name, text.as_str()));
        match laid_out.value {
            Some(text) => Ok((text, draft.dropped)),
            None => Err(too_large()),
        }
    })
}

fn too_large() -> Box<Diagnostic> {
    let error = Diagnostic::error(super::UNSUPPORTED, at(0..0), "the mission is too large for a spec");
    Box::new(error.help("divide it into several missions"))
}

/// What the file says; warnings are added to `found`.
fn read(source: &Source, found: &mut Vec<Diagnostic>) -> Result<Draft, Box<Diagnostic>> {
    let start = source.text.trim_start();
    let kind = foreign::of_text(&source.text);
    if let Some(Foreign::Template(_) | Foreign::Certificate | Foreign::Result(_)) = kind {
        return Err(Box::new(super::other(source, kind)));
    }
    if start.starts_with('{') {
        return qgc_plan::read(source, found);
    }
    if start.starts_with("QGC WPL") {
        return wpl::read(source, found);
    }
    if table::is_one(&source.text) {
        return table::read(source, found);
    }
    let first = source.line(1);
    let lines = || source.text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
    if lines().next().is_some_and(rally::is_line) {
        return Err(Box::new(wpl::no_mission("a list of rally points", first)));
    }
    if super::is_spec(source) {
        return Err(Box::new(super::other(source, None)));
    }
    if super::vehicle::seems_one(&source.text) {
        let error = Diagnostic::error(FORMAT, at(first), "this is a vehicle and no mission").here("the first line");
        return Err(Box::new(error.help("read it by `mavc import vehicle`, or name the file of a mission")));
    }
    let error = Diagnostic::error(FORMAT, at(first), "this is not a mission that mavc reads").here("the first line");
    Err(Box::new(error.help(
        "name a plan of QGroundControl (`.plan`), MAVLink's plain text (`QGC WPL 110`) or a table of waypoints \
         (`x,y,z`)",
    )))
}
