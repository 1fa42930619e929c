//! Results of a simulated flight: the log (CSV), the JSON record and the output.

mod log;
mod record;
mod screen;
mod text;

pub use log::{Log, Thinning};
pub use record::{FaultRecord, FlightRecord, Flown, OutcomeRecord, RegressorRecord, SpinRecord};
pub use screen::screen;
pub use text::disturbed;
pub(super) use text::manner;
#[cfg(feature = "report")]
pub(super) use text::{DIVERGED, detection, duration, landed, length, loss, no_fault, to_its_end, trespass, turned};
