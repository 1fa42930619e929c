//! The options `--format` and `--layout` of `mavc simulate`.

use super::endings::{Others, chosen};
use super::{CommandError, SimulateArgs};
use crate::exchange::flight::{FORMATS, Format, Recorder, layout};
use crate::flight::longest;
use crate::model::Model;

/// How the log is written.
pub struct FlightLog {
    format: Format,
    rate: Option<f64>,
    has_layout: bool,
    /// Why the name of the output says that no flight log is meant.
    misnamed: Option<CommandError>,
}

/// Endings of names that say the format.
const ENDINGS: [(&str, Format); 4] =
    [("csv", Format::Csv), ("mcap", Format::Mcap), ("ulg", Format::Ulog), ("ulog", Format::Ulog)];

/// Endings of files that a flight log is not, and what to write in place of the option.
const OTHERS: &Others = &[
    (
        &["plan", "waypoints", "kml", "geojson", "py"],
        "a flight log is not a file of this kind: `mavc plan -o` writes it",
    ),
    (&["json"], "write --report for a report, or --format mcap"),
    (&["html", "htm"], "write --html for a page"),
    (&["bag", "db3", "bin"], "write --format mcap or ulog"),
    (
        &["mav", "params", "param", "xml", "sdf", "urdf", "svg", "png", "pdf"],
        "a flight log is not a file of this kind: name a `.csv`",
    ),
];

impl FlightLog {
    /// # Errors
    /// The options do not go together.
    pub fn of(args: &SimulateArgs) -> Result<Self, CommandError> {
        let (format, misnamed) = chosen(args.format.as_deref(), &FORMATS, args.output.as_deref(), &ENDINGS, OTHERS);
        let has_layout = args.layout.is_some();
        if has_layout {
            layout(format, 0)?;
        }
        Ok(FlightLog { format, rate: args.rate.as_deref().map(super::rate::parse).transpose()?, has_layout, misnamed })
    }

    /// # Errors
    /// No format is named, and the ending of the output is that of a file that a flight log is not.
    pub fn is_named_well(&self) -> Result<(), CommandError> {
        self.misnamed.clone().map_or(Ok(()), Err)
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
