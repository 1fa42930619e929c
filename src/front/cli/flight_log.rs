//! The options `--format` and `--layout` of `mavc simulate`.

use super::{CommandError, SimulateArgs};
use crate::exchange::flight::{FORMATS, Format, Recorder, layout};
use crate::flight::longest;
use crate::model::Model;

/// How the log is written.
pub struct FlightLog {
    format: Format,
    rate: Option<f64>,
    has_layout: bool,
}

impl FlightLog {
    /// # Errors
    /// The options do not go together.
    pub fn of(args: &SimulateArgs) -> Result<Self, CommandError> {
        let format = args.format.as_deref().and_then(|name| FORMATS.iter().find(|(_, n)| *n == name));
        let format = format.map(|(format, _)| *format).unwrap_or_default();
        let has_layout = args.layout.is_some();
        if has_layout {
            layout(format, 0)?;
        }
        Ok(FlightLog { format, rate: args.rate.as_deref().map(super::rate::parse).transpose()?, has_layout })
    }

    /// A log of a flight along a plan of `time` s.
    pub fn begin(&self, model: &Model, time: f64) -> Result<Recorder, CommandError> {
        Recorder::new(self.format, model, self.rate, longest(model, time))
    }

    /// The layout, if one is to be written.
    pub fn layout(&self, model: &Model) -> Result<Option<String>, CommandError> {
        self.has_layout.then(|| layout(self.format, model.vehicle.rotors.len())).transpose()
    }
}
