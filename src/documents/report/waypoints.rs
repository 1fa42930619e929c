//! The error of a plan at each waypoint, compared with the tolerance.

use super::caveats::AWAY_FROM_START;
use crate::model::{Heading, Limit, Mission, Part, Waypoint};
use crate::motion::checks::heading_error;
use crate::motion::{NodeState, YAW};
use crate::number::{DIGITS, beside, significant, tenths};
use crate::planner::studies::MissionPlan;
use crate::text_table::Table;
use crate::verify::plan::MOST_MISS;
use serde::Serialize;
use std::cmp::Ordering;

/// Most waypoints that a table lists in full;
const MOST_LISTED: usize = 8;
/// of more than that it lists this many, those with the largest shares.
const WORST: usize = 5;

/// A plan that begins nearer to the start than this begins there, m. Chosen by hand.
const AT_THE_START: f64 = 1e-3;

/// A waypoint is called tight from this share of its tolerance on. Chosen by hand.
const TIGHT: f64 = 0.1;

/// Errors below this are rounding and are reported as zero, m and rad.
const ROUNDING: f64 = 1e-12;

/// One waypoint of a plan: its errors, their tolerances, and each error as a share of its tolerance.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct WaypointRecord {
    /// Place in the flight, from 1.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub number: usize,
    /// Its name; null if it has none.
    pub name: Option<String>,
    /// When it is passed, s.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub at_s: f64,
    /// Distance from the waypoint when it is passed, m.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub position_error_m: f64,
    /// The largest distance that the spec allows, m.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub position_tolerance_m: f64,
    /// The distance as a share of its tolerance.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub position_share: f64,
    /// The yaw error then, rad.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub yaw_error_rad: f64,
    /// The largest yaw error that the spec allows, rad.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub yaw_tolerance_rad: f64,
    /// The yaw error as a share of its tolerance.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub yaw_share: f64,
    /// Whether the yaw is free.
    #[serde(skip)]
    pub yaw_is_free: bool,
    /// Whether no error is larger than its tolerance by more than the 1e-5 m or rad that `mavc verify` allows.
    pub met: bool,
}

impl WaypointRecord {
    fn new(index: usize, waypoint: &Waypoint, mission: &Mission, solved: &MissionPlan) -> Self {
        let node = solved.trajectory.waypoint_nodes[index];
        let state = &solved.trajectory.nodes[node];
        let distance = (0..3).map(|i| (state[i][0] - waypoint.position[i]).powi(2)).sum::<f64>().sqrt();
        let turn = yaw_error(index, mission, state);
        let [distance, turn] = [distance, turn].map(|error| if error < ROUNDING { 0.0 } else { error });
        WaypointRecord {
            number: index + 1,
            name: waypoint.name.clone(),
            at_s: solved.trajectory.times[node],
            position_error_m: distance,
            position_tolerance_m: waypoint.within,
            position_share: distance / waypoint.within,
            yaw_error_rad: turn,
            yaw_tolerance_rad: waypoint.yaw_within,
            yaw_share: turn / waypoint.yaw_within,
            yaw_is_free: waypoint.heading == Heading::Free,
            met: distance <= waypoint.within + MOST_MISS && turn <= waypoint.yaw_within + MOST_MISS,
        }
    }

    /// The larger of the two shares; NaN counts as larger than any number.
    pub fn share(&self) -> f64 {
        if self.position_share.total_cmp(&self.yaw_share).is_ge() { self.position_share } else { self.yaw_share }
    }

    /// Met before missed, then by share. Shares are compared as printed, so that the solver's last digits decide
    /// nothing.
    fn by_share(&self, other: &Self) -> Ordering {
        let rounded = |w: &Self| format!("{:.*e}", DIGITS - 1, w.share()).parse().unwrap_or(f64::NAN);
        (!self.met).cmp(&!other.met).then(rounded(self).total_cmp(&rounded(other)))
    }

    /// `3`, `3 mast`, `1 (start)`
    pub fn label(&self) -> String {
        match &self.name {
            Some(name) => format!("{} {name}", self.number),
            None if self.number == 1 => "1 (start)".into(),
            None => self.number.to_string(),
        }
    }

    /// ``waypoint 3 `mast` ``: for sentences, where a name such as `land` reads like one of their words.
    pub fn quoted(&self) -> String {
        waypoint(self.number, self.name.as_deref())
    }

    /// `5 of 5 cm allowed`: the error with the larger share of its tolerance.
    pub fn largest(&self) -> String {
        match self.position_share.total_cmp(&self.yaw_share).is_ge() {
            true => {
                let [error, allowed] = [self.position_error_m, self.position_tolerance_m];
                let (unit, per_metre) = length_unit(error.max(allowed));
                let [error, allowed] = [error, allowed].map(|m| per_metre * m);
                format!("{} of {} {unit} allowed", beside(error, allowed, DIGITS), significant(allowed, DIGITS))
            }
            false => {
                let [error, allowed] = [self.yaw_error_rad, self.yaw_tolerance_rad].map(f64::to_degrees);
                let error = beside(error, allowed, DIGITS);
                format!("{error} of {} deg of yaw allowed", significant(allowed, DIGITS))
            }
        }
    }
}

/// ``waypoint 3 `mast` ``, `waypoint 1 (start)`; `number` from 1.
pub fn waypoint(number: usize, name: Option<&str>) -> String {
    match name {
        Some(name) => format!("waypoint {number} `{name}`"),
        None if number == 1 => "waypoint 1 (start)".into(),
        None => format!("waypoint {number}"),
    }
}

/// The yaw error at a waypoint, rad: off the yaw that is given, or off the direction that it follows. Zero where
/// nothing is required.
pub fn yaw_error(index: usize, mission: &Mission, state: &NodeState) -> f64 {
    let waypoint = &mission.waypoints[index];
    if waypoint.heading == Heading::Given {
        return (state[YAW][0] - waypoint.yaw).abs();
    }
    let holds_here = |limit: &&Limit| {
        limit.leg.as_ref().is_some_and(|on| match on.part {
            Part::Start => on.leg == index,
            Part::End => on.leg + 1 == index,
            Part::Whole => on.leg == index || on.leg + 1 == index,
        })
    };
    let of_yaw = mission.limits.iter().filter(|limit| limit.kind.is_heading()).filter(holds_here);
    of_yaw.filter_map(|limit| heading_error(limit, state)).map(f64::abs).fold(0.0, f64::max)
}

/// The record of every waypoint of a plan, in the order of flight.
pub fn waypoints(mission: &Mission, solved: &MissionPlan) -> Vec<WaypointRecord> {
    mission.waypoints.iter().enumerate().map(|(i, w)| WaypointRecord::new(i, w, mission, solved)).collect()
}

/// The waypoint with the largest share of its tolerance, the first of several; missed waypoints come before met ones.
pub fn worst(waypoints: &[WaypointRecord]) -> Option<&WaypointRecord> {
    waypoints.iter().rev().max_by(|a, b| a.by_share(b))
}

/// `21 waypoints met`, or `2 of 21 waypoints missed`.
pub fn met_or_missed(waypoints: &[WaypointRecord]) -> String {
    let all = waypoints.len();
    match waypoints.iter().filter(|w| !w.met).count() {
        0 => format!("{all} waypoints met"),
        missed => format!("{missed} of {all} waypoints missed"),
    }
}

/// `21 waypoints met; tightest: waypoint 7, 5 of 5 cm allowed; begins 4.9 cm from the start`. The tightest after the
/// start has the largest share of its tolerance, which need not be the largest error. Where the plan begins is said by
/// itself: the vehicle has to be there.
pub fn headline(waypoints: &[WaypointRecord]) -> String {
    let (start, later) = waypoints.split_at(waypoints.len().min(1));
    let tightest = |w: &WaypointRecord| format!("; tightest: {}, {}", w.quoted(), w.largest());
    let begins = |w: &WaypointRecord| {
        let (unit, per_metre) = length_unit(w.position_error_m);
        format!("; begins {} {unit} from the start", significant(per_metre * w.position_error_m, 2))
    };
    // Of more there is a caveat.
    let is_small = |w: &&WaypointRecord| (AT_THE_START..=AWAY_FROM_START).contains(&w.position_error_m);
    let begins = start.first().filter(is_small).map_or(String::new(), begins);
    let tight = worst(later).filter(|w| !w.met || w.share() >= TIGHT);
    format!("{}{}{begins}", met_or_missed(waypoints), tight.map_or(String::new(), tightest))
}

/// The waypoints that a table lists, in the order of flight: all, or of many the `WORST`; and for the others their
/// number and largest share.
pub fn listed(waypoints: &[WaypointRecord]) -> (Vec<&WaypointRecord>, Option<(usize, f64)>) {
    if waypoints.len() <= MOST_LISTED {
        return (waypoints.iter().collect(), None);
    }
    let mut ranked: Vec<&WaypointRecord> = waypoints.iter().collect();
    ranked.sort_by(|a, b| b.by_share(a));
    let others = ranked.split_off(WORST);
    ranked.sort_by_key(|w| w.number);
    let largest = others.iter().map(|w| w.share()).max_by(f64::total_cmp).unwrap_or(0.0);
    (ranked, Some((others.len(), largest)))
}

/// The list as a table, each line indented by `indent` spaces.
pub fn table(waypoints: &[WaypointRecord], indent: usize) -> String {
    let (listed, others) = listed(waypoints);
    let mut table = Table::new(&["waypoint", "error", "allowed", "share", "yaw error", "allowed", "share"]);
    for w in listed {
        table.row(std::iter::once(w.label()).chain(w.cells()).collect());
    }
    let rest = others.map_or(String::new(), |(n, share)| {
        format!("{}{n} more, with errors of at most {} of their tolerances\n", " ".repeat(indent), tenths(share))
    });
    table.render(indent) + &rest
}

impl WaypointRecord {
    /// Error, tolerance and share of position, then of yaw.
    pub fn cells(&self) -> [String; 6] {
        let [error, allowed, share] = match self.yaw_is_free {
            true => ["-", "free", "-"].map(String::from),
            false => [
                angle_beside(self.yaw_error_rad, self.yaw_tolerance_rad),
                angle(self.yaw_tolerance_rad),
                tenths(self.yaw_share),
            ],
        };
        [
            length_beside(self.position_error_m, self.position_tolerance_m),
            length(self.position_tolerance_m),
            tenths(self.position_share),
            error,
            allowed,
            share,
        ]
    }
}

/// The unit in which a length is printed, and how many of it are a metre.
fn length_unit(metres: f64) -> (&'static str, f64) {
    if metres >= 1.0 { ("m", 1.0) } else { ("cm", 100.0) }
}

fn length(metres: f64) -> String {
    let (unit, per_metre) = length_unit(metres);
    format!("{} {unit}", significant(per_metre * metres, DIGITS))
}

/// A length in the unit of the one that it is compared with, and as fine.
fn length_beside(metres: f64, whole: f64) -> String {
    let (unit, per_metre) = length_unit(metres.max(whole));
    format!("{} {unit}", beside(per_metre * metres, per_metre * whole, DIGITS))
}

fn angle(radians: f64) -> String {
    format!("{} deg", significant(radians.to_degrees(), DIGITS))
}

fn angle_beside(radians: f64, whole: f64) -> String {
    format!("{} deg", beside(radians.to_degrees(), whole.to_degrees(), DIGITS))
}
