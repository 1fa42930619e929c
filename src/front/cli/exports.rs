//! The options `--format`, `--frame` and `--tolerance` of `mavc plan`, and the file that they describe.

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
}

impl<'a> Export<'a> {
    /// # Errors
    /// The options do not go together.
    pub fn of(args: &'a PlanArgs) -> Result<Self, CommandError> {
        let format = args.format.as_deref().and_then(|name| FORMATS.iter().find(|(_, n)| *n == name));
        let choices = Choices {
            format: format.map(|(format, _)| *format).unwrap_or_default(),
            rate: args.rate.as_deref().map(rate::parse).transpose()?,
            frame: args.frame.as_deref().map(|name| if name == NED { Frame::NedFrd } else { Frame::EnuFlu }),
            tolerance: args.tolerance.as_deref().map(tolerance).transpose()?,
        };
        choices.check()?;
        let output = args.output.as_deref();
        let is_file = |path: &Path| path.as_os_str() == "-" || path.extension().is_some_and(|e| e == "mcap");
        let is_bag = choices.format == Format::Rosbag2 && output.is_some_and(|path| !is_file(path));
        output.filter(|_| is_bag).map_or(Ok(()), is_folder)?;
        Ok(Export { choices, output, is_bag })
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
