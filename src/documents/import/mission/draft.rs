//! What a file says of a mission, in the axes of a spec.

use crate::geodesy::Geodetic;
use std::ops::Range;

/// A mission before it is written as a spec.
#[derive(Debug, Clone, Default)]
pub struct Draft {
    /// The kind of the file, as a comment names it.
    pub format: &'static str,
    /// The planned home, if the file has places on the Earth.
    pub home: Option<Home>,
    pub stops: Vec<Stop>,
    pub volumes: Vec<Volume>,
    pub sites: Vec<Site>,
    /// The height of the ground, m; written with sites.
    pub ground: f64,
    /// What was left out without a place of its own, in the words of the file.
    pub dropped: Vec<String>,
    /// Comments at the head of the spec.
    pub remarks: Vec<String>,
}

/// The planned home, the origin of the spec.
#[derive(Debug, Clone)]
pub struct Home {
    pub place: Geodetic,
    pub span: Range<usize>,
    /// Whether its height above sea is that of the file: otherwise it is taken as 0 m, and stands as `?`.
    pub has_height: bool,
}

/// What a line of the spec came from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mark {
    /// `item 3`, as comments and messages name it.
    pub name: String,
    pub span: Range<usize>,
}

/// A yaw of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Yaw {
    /// deg, counter-clockwise from east.
    Angle(f64),
    /// Towards a point: x and y, m.
    Towards([f64; 2]),
    /// The autopilot's settings decide.
    Free,
    /// The file has no word for yaw: nothing is written.
    Unsaid,
}

/// The leg to a waypoint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    Any,
    Straight,
    /// Straight up or down.
    Vertical,
}

/// A waypoint.
#[derive(Debug, Clone)]
pub struct Stop {
    pub mark: Mark,
    /// What happens there, as a comment says it; may be empty.
    pub remark: &'static str,
    /// x east, y north, z up, m.
    pub position: [f64; 3],
    pub yaw: Yaw,
    /// m
    pub within: Option<f64>,
    /// Time of arrival, s.
    pub time: Option<f64>,
    /// Seconds at rest, and the item that asks for them.
    pub hold: Option<(f64, Mark)>,
    pub way: Way,
    /// Comes to rest.
    pub stops: bool,
    pub speeds: Speeds,
}

/// The largest speeds of a leg, m/s, each with the item that sets it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Speeds {
    pub horizontal: Option<(f64, Mark)>,
    pub climb: Option<(f64, Mark)>,
    pub descent: Option<(f64, Mark)>,
}

impl Speeds {
    /// The limits with their names in the language.
    pub fn limits(&self) -> impl Iterator<Item = (&'static str, &(f64, Mark))> {
        let all = [("speed_horizontal", &self.horizontal), ("climb", &self.climb), ("descent", &self.descent)];
        all.into_iter().filter_map(|(name, speed)| speed.as_ref().map(|speed| (name, speed)))
    }
}

/// A landing site.
#[derive(Debug, Clone)]
pub struct Site {
    pub mark: Mark,
    /// x east, y north, z up, m.
    pub position: [f64; 3],
    /// The height at which the vehicle arrives, as a comment says it.
    pub arrival: Option<String>,
}

/// A volume.
#[derive(Debug, Clone)]
pub struct Volume {
    pub mark: Mark,
    pub is_inside: bool,
    pub name: String,
    pub shape: Shape,
}

/// m; without heights.
#[derive(Debug, Clone)]
pub enum Shape {
    Polygon(Vec<[f64; 2]>),
    Circle { centre: [f64; 2], radius: f64 },
}
