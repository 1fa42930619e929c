//! Results of a simulated flight: the log (CSV), the JSON record and the terminal text.

mod log;
mod record;
mod text;

pub use log::{Log, Thinning};
pub use record::{FaultRecord, FlightRecord, Flown, OutcomeRecord, RegressorRecord};
pub use text::text;
#[cfg(feature = "report")]
pub(super) use text::{DIVERGED, detection, duration, length, loss, to_its_end, turned};
