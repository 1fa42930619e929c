//! Trajectories of plans as other tools read them: one module for each format.

mod crazyflie;
mod csv;
mod gym_pybullet_drones;
pub mod instant;
mod players;
mod px4;
mod refit;
mod rosbag2;
mod rotorpy;
mod rows;

pub use super::Written;
use super::frames::Frame;
use super::mission;
use crate::model::Model;
use crate::motion::Trajectory;
use crate::number::{number, shortest};
use crate::report::trajectory_csv::{count, few_enough};
use instant::Instant;
use std::ops::RangeInclusive;

/// A format of trajectories.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Format {
    /// mavc's table.
    #[default]
    Csv,
    /// Rows with attitude and body rates.
    Rows,
    /// A table of PX4's `TrajectorySetpoint`.
    Px4,
    /// A player for PX4's offboard mode.
    Px4Offboard,
    /// A player for ArduPilot's GUIDED mode.
    ArdupilotGuided,
    /// The table of polynomials of Crazyswarm and uav_trajectories.
    Crazyflie,
    /// A trajectory class for RotorPy.
    Rotorpy,
    /// Waypoints for gym-pybullet-drones.
    GymPybulletDrones,
    /// A ROS 2 bag with a `MultiDOFJointTrajectory`.
    Rosbag2,
    /// A plan of QGroundControl.
    QgcPlan,
    /// A mission of MAVLink in plain text.
    Wpl,
    Kml,
    GeoJson,
}

/// Every format with its name.
pub const FORMATS: [(Format, &str); 13] = [
    (Format::Csv, "csv"),
    (Format::Rows, "rows"),
    (Format::Px4, "px4"),
    (Format::Px4Offboard, "px4-offboard"),
    (Format::ArdupilotGuided, "ardupilot-guided"),
    (Format::Crazyflie, "crazyflie"),
    (Format::Rotorpy, "rotorpy"),
    (Format::GymPybulletDrones, "gym-pybullet-drones"),
    (Format::Rosbag2, "rosbag2"),
    (Format::QgcPlan, "qgc-plan"),
    (Format::Wpl, "wpl"),
    (Format::Kml, "kml"),
    (Format::GeoJson, "geojson"),
];

/// The tolerances of [`Choices`], m.
pub const TOLERANCES: RangeInclusive<f64> = 1e-6..=1e3;

/// How a trajectory is written. `None` is the default of the format.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Choices {
    pub format: Format,
    /// Rows per second, Hz.
    pub rate: Option<f64>,
    pub frame: Option<Frame>,
    /// Largest error of refitted positions, or distance from straight lines, m.
    pub tolerance: Option<f64>,
}

impl Format {
    /// The name that `--format` takes.
    pub fn name(self) -> &'static str {
        FORMATS.iter().find(|(format, _)| *format == self).map_or("", |(_, name)| name)
    }

    /// Rows per second (Hz) unless `--rate` is given; `None` if rows are those of the nodes, or if there are no rows.
    fn default_rate(self) -> Option<f64> {
        match self {
            Format::Px4 | Format::Px4Offboard | Format::ArdupilotGuided => Some(50.0),
            // The control rate of its examples.
            Format::GymPybulletDrones => Some(48.0),
            Format::Rosbag2 => Some(100.0),
            _ => None,
        }
    }

    /// Whether it consists of polynomials instead of rows.
    fn is_of_pieces(self) -> bool {
        matches!(self, Format::Crazyflie | Format::Rotorpy)
    }

    /// Whether it consists of straight lines between places on the Earth.
    fn is_of_places(self) -> bool {
        matches!(self, Format::QgcPlan | Format::Wpl | Format::Kml | Format::GeoJson)
    }

    /// Whether its frames can be chosen.
    fn has_frames(self) -> bool {
        matches!(self, Format::Csv | Format::Rows)
    }

    /// The frames that the format fixes.
    fn fixed_frame(self) -> Frame {
        match self {
            Format::Px4 | Format::Px4Offboard | Format::ArdupilotGuided => Frame::NedFrd,
            _ => Frame::EnuFlu,
        }
    }
}

impl Choices {
    /// Whether the choices go together; known before anything is planned.
    ///
    /// # Errors
    /// One of them means nothing for the format.
    pub fn check(&self) -> Result<(), String> {
        let name = self.format.name();
        if self.format.is_of_places() && (self.frame.is_some() || self.rate.is_some()) {
            return Err(format!(
                "--format {name} has places on the Earth instead of rows: leave --frame and --rate out"
            ));
        }
        if self.frame.is_some() && !self.format.has_frames() {
            let fixed = match self.format.fixed_frame() {
                Frame::EnuFlu => "east, north, up and forward, left, up",
                Frame::NedFrd => "north, east, down and forward, right, down",
            };
            return Err(format!(
                "--format {name} fixes its frames ({fixed}): leave --frame out, which is for csv and rows"
            ));
        }
        if self.rate.is_some() && self.format.is_of_pieces() {
            return Err(format!(
                "--rate has no effect with --format {name}, which has polynomials instead of rows: remove it"
            ));
        }
        if self.tolerance.is_some() && self.format != Format::Crazyflie && !self.format.is_of_places() {
            return Err(format!(
                "--tolerance has no effect with --format {name}: remove it; only crazyflie, qgc-plan, wpl, kml and \
                 geojson take it"
            ));
        }
        Ok(())
    }

    /// Whether the format can carry plans of a model's mission.
    ///
    /// # Errors
    /// It has places on the Earth, and the mission does not say where it is.
    pub fn fit(&self, model: &Model) -> Result<(), String> {
        if self.format.is_of_places() { mission::origin(model, self.format.name()).map(drop) } else { Ok(()) }
    }

    fn rate(&self) -> Option<f64> {
        self.rate.or(self.format.default_rate())
    }

    fn frame(&self) -> Frame {
        self.frame.unwrap_or(self.format.fixed_frame())
    }
}

/// Writes a trajectory of a model's mission.
///
/// # Errors
/// The choices do not go together, the result would be too large, the attitude is not defined at some instant, or the
/// trajectory does not fit the format.
pub fn write(trajectory: &Trajectory, model: &Model, choices: &Choices) -> Result<Written, String> {
    choices.check()?;
    let plan = Exported { trajectory, model };
    match choices.format {
        Format::Csv => csv::text(&plan, choices).map(Into::into),
        Format::Rows => rows::text(&plan, choices).map(Into::into),
        Format::Px4 => px4::text(&plan, choices).map(Into::into),
        Format::Px4Offboard => players::px4_offboard(&plan, choices).map(Into::into),
        Format::ArdupilotGuided => players::ardupilot_guided(&plan, choices).map(Into::into),
        Format::Crazyflie => crazyflie::written(&plan, choices),
        Format::Rotorpy => Ok(rotorpy::text(&plan).into()),
        Format::GymPybulletDrones => gym_pybullet_drones::text(&plan, choices).map(Into::into),
        Format::Rosbag2 => rosbag2::mcap(&plan, choices).map(|bytes| Written { bytes, remark: None }),
        Format::QgcPlan => mission::qgc_plan(trajectory, model, choices.tolerance),
        Format::Wpl => mission::wpl(trajectory, model, choices.tolerance),
        Format::Kml => mission::kml(trajectory, model, choices.tolerance),
        Format::GeoJson => mission::geojson(trajectory, model, choices.tolerance),
    }
}

/// The file `metadata.yaml` beside `file`, the bag of [`Format::Rosbag2`].
pub fn bag_metadata(file: &str) -> String {
    rosbag2::metadata(file)
}

/// The files of a bag, with their names, in a folder called `folder`: `bytes` and their `metadata.yaml`.
pub fn bag_files(folder: &str, bytes: Vec<u8>) -> [(String, Vec<u8>); 2] {
    // What YAML would read as something else is left out of the name.
    let stem: String = folder.chars().filter(|c| c.is_ascii_alphanumeric() || "_-".contains(*c)).collect();
    let name = format!("bag_{stem}_0.mcap");
    [(name.clone(), bytes), ("metadata.yaml".into(), bag_metadata(&name).into_bytes())]
}

/// What is written.
struct Exported<'a> {
    trajectory: &'a Trajectory,
    model: &'a Model,
}

impl Exported<'_> {
    /// The rows of [`crate::report::trajectory_csv::rows`], for a text with `header`.
    fn instants(&self, rate: Option<f64>, header: &str) -> Result<Vec<Instant>, String> {
        few_enough("trajectory", count(self.trajectory, rate), header)?;
        instant::all(self.trajectory, self.model, rate)
    }

    /// Two lines for the head of a text: what is flown, and the version of mavc.
    fn origin(&self) -> [String; 2] {
        let mission = self.model.mission.as_ref().map_or("a mission", |mission| mission.name.as_str());
        let duration = number(self.trajectory.duration());
        [
            format!("{mission} with {}, {duration} s", self.model.vehicle.name),
            format!("Written by mavc {}.", env!("CARGO_PKG_VERSION")),
        ]
    }
}

/// Numbers as a list of Python, the shortest text that reads back as the same number.
fn list(numbers: impl IntoIterator<Item = f64>) -> String {
    let texts: Vec<String> = numbers.into_iter().map(shortest).collect();
    format!("[{}]", texts.join(", "))
}
