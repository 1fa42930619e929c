//! The options `--format`, `--frame` and `--tolerance` of `mavc plan`, and the file that they describe.

use super::endings::{Others, chosen};
use super::results::{Results, is_folder};
use super::{CommandError, Options, PlanArgs, files, rate};
use crate::exchange::frames::Frame;
use crate::exchange::trajectory::{Choices, FORMATS, Format, TOLERANCES, bag_files, write};
use crate::model::Model;
use crate::motion::Trajectory;
use crate::pipeline::Task;
use std::path::Path;

/// How and where the trajectory is written.
pub struct Export<'a> {
    choices: Choices,
    output: Option<&'a Path>,
    /// Whether `output` is the folder of a bag.
    is_bag: bool,
    /// Why the name of `output` says that a table is not meant.
    misnamed: Option<CommandError>,
}

impl<'a> Export<'a> {
    /// # Errors
    /// The options do not go together.
    pub fn of(args: &'a PlanArgs) -> Result<Self, CommandError> {
        let (format, misnamed) = chosen(args.format.as_deref(), &FORMATS, args.output.as_deref(), &ENDINGS, OTHERS);
        let choices = Choices {
            format,
            rate: args.rate.as_deref().map(rate::parse).transpose()?,
            frame: args.frame.as_deref().map(|name| if name == NED { Frame::NedFrd } else { Frame::EnuFlu }),
            tolerance: args.tolerance.as_deref().map(tolerance).transpose()?,
        };
        choices.check()?;
        let output = args.output.as_deref();
        let is_file = |path: &Path| path.as_os_str() == "-" || path.extension().is_some_and(|e| e == "mcap");
        let is_bag = choices.format == Format::Rosbag2 && output.is_some_and(|path| !is_file(path));
        output.filter(|_| is_bag).map_or(Ok(()), is_folder)?;
        Ok(Export { choices, output, is_bag, misnamed })
    }

    /// # Errors
    /// No format is named, and the ending of the output is that of a file that a table is not.
    pub fn is_named_well(&self) -> Result<(), CommandError> {
        self.misnamed.clone().map_or(Ok(()), Err)
    }

    /// The file, unless the trajectory is written into a folder.
    pub fn file(&self) -> Option<&'a Path> {
        self.output.filter(|_| !self.is_bag)
    }

    /// Whether the format can carry plans of this model; known before anything is planned.
    pub fn fits(&self, model: &Model) -> Result<(), CommandError> {
        self.choices.fit(model)
    }

    /// Takes the trajectory as a result.
    pub fn add(
        &self,
        results: &mut Results,
        trajectory: &Trajectory,
        task: &Task,
        options: &Options,
    ) -> Result<(), CommandError> {
        let Some(output) = self.output else { return Ok(()) };
        let written = write(trajectory, task.model(), &self.choices)?;
        if let Some(remark) = written.remark.filter(|_| !options.quiet) {
            files::eprint(&format!("mavc: {remark}\n"));
        }
        if !self.is_bag {
            results.table(written.bytes);
            return Ok(());
        }
        let name = output.file_name().map_or("plan".into(), |name| name.to_string_lossy());
        results.folder("a file of the bag", "-o", output, bag_files(&name, written.bytes), task.spec().sources())
    }
}

/// Endings of names that say the format.
const ENDINGS: [(&str, Format); 6] = [
    ("plan", Format::QgcPlan),
    ("waypoints", Format::Wpl),
    ("kml", Format::Kml),
    ("geojson", Format::GeoJson),
    ("mcap", Format::Rosbag2),
    ("csv", Format::Csv),
];

/// Endings of files that a table is not, and what to write in place of the option.
const OTHERS: &Others = &[
    (&["py"], "name the script: --format px4-offboard, ardupilot-guided or rotorpy; or --format csv"),
    (&["json"], "write --report for a report, --certificate for a certificate, or --format geojson"),
    (&["html", "htm"], "write --html for a page"),
    (&["svg", "png", "pdf"], "write --svg for charts"),
    (&["bag", "db3"], "a ROS 2 bag is --format rosbag2, an MCAP file or a folder"),
    (
        &["mav", "params", "param", "xml", "sdf", "urdf", "ulg", "bin"],
        "a trajectory is not a file of this kind: name a `.csv`",
    ),
];

/// The word for north, east, down.
const NED: &str = "ned-frd";
/// The words of `--frame`.
pub const FRAMES: [&str; 2] = ["enu-flu", NED];

/// Reads `5mm`, `1 cm` or `0.1m`; m.
fn tolerance(text: &str) -> Result<f64, CommandError> {
    let trimmed = text.trim();
    let unit = [("mm", 1e-3), ("cm", 1e-2), ("m", 1.0)].into_iter().find(|(unit, _)| trimmed.ends_with(unit));
    let number = unit.and_then(|(unit, factor)| {
        let digits = trimmed.strip_suffix(unit)?.trim();
        digits.parse::<f64>().ok().map(|value| value * factor)
    });
    match number.filter(|value| TOLERANCES.contains(value)) {
        Some(value) => Ok(value),
        None => Err(format!("--tolerance {text}: write a length such as 1cm, from 0.001mm to 1000m")),
    }
}
