//! What is told of a flight: the log, the record, the text for people.

mod log;
mod record;
mod text;

pub use log::Log;
pub use record::{FaultRecord, FlightRecord, OutcomeRecord, RegressorRecord, Told};
pub use text::text;
#[cfg(feature = "report")]
pub(super) use text::{DIVERGED, detection, duration, length, loss, to_its_end, turned};
