//! Logs of flights: PX4's ULog and ArduPilot's DataFlash, read into a [`Record`] in one pass with a bounded memory.
//!
//! A damaged or truncated log gives what could be read, with a warning.

mod bytes;
mod collect;
mod dataflash;
mod thrust;
mod ulog;
mod vehicle;

pub use thrust::{Curve, assumed, commands};
pub use vehicle::{FrameFigures, filled, frame};

use crate::diagnosis::record::{Autopilot, Record};
use crate::diagnostic::Diagnostic;
use crate::foreign::{self, Foreign};
use crate::source::Span;
use bytes::Input;
use collect::Collector;
use std::io::{self, Read};

/// Code: the file is not a log that can be read here.
pub const FORMAT: &str = "mavc::log::format";
/// Code: a part of the log is missing or unreadable.
pub const DAMAGED: &str = "mavc::log::damaged";
/// Code: the log lacks something without which nothing can be said.
pub const MISSING: &str = "mavc::log::missing";
/// Code: the answer depends on something that the log does not say for certain.
pub const ASSUMED: &str = "mavc::log::assumed";

/// First bytes of MCAP.
const MCAP: &[u8] = b"\x89MCAP0\r\n";

/// A log that was read.
#[derive(Debug)]
pub struct Log {
    pub record: Record,
    /// Warnings.
    pub diagnostics: Vec<Diagnostic>,
}

/// Why there is no log.
#[derive(Debug)]
pub enum Unreadable {
    /// The file is not a log, or has nothing of a flight.
    Not(Box<Diagnostic>),
    Io(io::Error),
}

/// Reads a log to its end.
///
/// # Errors
/// The file cannot be read, or is not a log of PX4 or ArduPilot.
pub fn read(source: &mut dyn Read) -> Result<Log, Unreadable> {
    let mut input = Input::new(source);
    let head = input.peek(64).map_err(Unreadable::Io)?.to_vec();
    let error = |message: String, help: &str| {
        Unreadable::Not(Box::new(Diagnostic::error(FORMAT, Span::default(), message).help(help)))
    };
    let logs = "name a log of PX4 (`.ulg`) or ArduPilot (`.bin`)";
    let mut collector = if head.starts_with(&dataflash::HEAD) {
        let mut collector = Collector::new(Autopilot::ArduPilot);
        dataflash::read(&mut input, &mut collector).map_err(Unreadable::Io)?;
        collector
    } else if head.starts_with(&ulog::MAGIC) {
        let mut collector = Collector::new(Autopilot::Px4);
        ulog::read(&mut input, &mut collector).map_err(Unreadable::Io)?;
        collector
    } else if head.is_empty() {
        return Err(error("the file is empty".into(), logs));
    } else if head.starts_with(MCAP) {
        let help = "of a flight of `mavc simulate` read the ULog: `mavc simulate -o flight.ulg`";
        return Err(error("this is an MCAP recording, and not a log of PX4 or ArduPilot".into(), help));
    } else if let Some(kind) = foreign::of_bytes(&head) {
        let help = if let Foreign::Other(_, help) = kind { help } else { logs };
        return Err(error(format!("this is {}, and not a log of PX4 or ArduPilot", kind.what()), help));
    } else if head.starts_with(b"FMT, 128") || head.starts_with(b"FMT,128") {
        let help = "download the log from the autopilot as `.bin`; the text form `.log` loses the times of messages";
        return Err(error("this is a DataFlash log converted to text".into(), help));
    } else {
        return Err(error("the first bytes are those of no log that mavc knows".into(), logs));
    };
    let diagnostics = collector.damage.diagnostics();
    collector.finish();
    Ok(Log { record: collector.record, diagnostics })
}
