//! The items of a mission from the corners of a line.

use super::polyline::{self, Corner, MOST_CORNERS, fastest};
use super::{Placed, Spot};
use crate::geodesy::heading_of_yaw;
use crate::motion::YAW;

/// Commands of MAVLink (`MAV_CMD`, common.xml).
pub const WAYPOINT: u16 = 16;
pub const LAND: u16 = 21;
pub const TAKE_OFF: u16 = 22;
pub const CONDITION_YAW: u16 = 115;
pub const CHANGE_SPEED: u16 = 178;

/// A plan that ends at most this far above the ground lands, m.
const LANDED: f64 = 0.5;
/// The lowest take-off that is one, m.
const LOWEST: f64 = 0.1;
/// A leg of the mission that is slower than this share of the speed in force, or faster at all, gets a speed of its
/// own.
const SLOWER: f64 = 0.8;
/// Speeds are rounded up to a tenth; slower legs are vertical or turns.
const STEP: f64 = 0.1;
const SLOWEST: f64 = 0.3;

#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    Speed(f64),
    Place {
        command: u16,
        spot: Spot,
        /// s
        hold: f64,
        /// Degrees clockwise from north.
        heading: f64,
    },
}

pub struct Items {
    pub all: Vec<Item>,
    /// The largest distance of the plan from the lines between items, m.
    pub deviation: f64,
    pub takes_off: bool,
}

impl Items {
    pub fn of(placed: &Placed) -> Result<Self, String> {
        let line = polyline::through(placed)?;
        let corners = without_rests(placed, &line.corners);
        let (up, deviation) = climbed(placed, &corners, line.deviation);
        let takes_off = corners[up].position[2] > LOWEST;
        let last = corners.len() - 1;
        let lands = lands(placed, &corners);
        let mut all = Vec::new();
        let mut speed: Option<f64> = None;
        // When the leg of the mission ends for which the speed is known, s.
        let mut leg_end = f64::NEG_INFINITY;
        let first = if takes_off { up } else { 0 };
        for (k, corner) in corners.iter().enumerate().skip(first) {
            let command = match k {
                _ if k == first && takes_off => TAKE_OFF,
                _ if k == last && lands => LAND,
                _ => WAYPOINT,
            };
            if k > first && corner.time > leg_end {
                leg_end = corners[k..].iter().find(|c| c.waypoint.is_some()).unwrap_or(&corners[last]).time;
                let most = (fastest(placed, corners[k - 1].time, leg_end) / STEP).ceil() * STEP;
                if most >= SLOWEST && speed.is_none_or(|speed| most > speed || most < SLOWER * speed) {
                    all.push(Item::Speed(super::rounded(most, 10.0)));
                    speed = Some(most);
                }
            }
            let hold = hold(placed, corner);
            let mut place = |command, hold| {
                let yaw = placed.trajectory.at(corner.time)[YAW][0];
                let heading = super::rounded(heading_of_yaw(yaw), 1e3);
                all.push(Item::Place { command, spot: placed.spot(corner.position), hold, heading });
            };
            match command {
                TAKE_OFF if hold > 0.0 => {
                    place(TAKE_OFF, 0.0);
                    place(WAYPOINT, hold);
                }
                command => place(command, hold),
            }
        }
        if all.len() > MOST_CORNERS {
            return Err(format!("the plan needs more than {MOST_CORNERS} items: give a larger --tolerance"));
        }
        Ok(Items { all, deviation, takes_off })
    }
}

/// The seconds that the mission holds at the waypoint of a corner.
fn hold(placed: &Placed, corner: &Corner) -> f64 {
    corner.waypoint.map_or(0.0, |k| super::rounded(placed.mission.waypoints[k].hold, 1e3))
}

/// Without corners at which the vehicle still is where the one before is: the ends of holds, and the turns on the spot
/// without a waypoint.
fn without_rests(placed: &Placed, corners: &[Corner]) -> Vec<Corner> {
    const SAME_PLACE: f64 = 1e-3;
    let mut kept: Vec<Corner> = Vec::new();
    for corner in corners {
        let is_same =
            kept.last().is_some_and(|last| (0..3).all(|i| (corner.position[i] - last.position[i]).abs() < SAME_PLACE));
        let holds = hold(placed, corner) > 0.0;
        if !is_same || corner.waypoint.is_some() && (holds || corner.waypoint != Some(0)) {
            kept.push(*corner);
        }
    }
    kept
}

/// The corner at which a climb from the start, straight up to within the tolerance, ends, at the latest at a waypoint
/// of the mission; and the largest distance of the plan from the lines if the corners on the way are left out, m.
fn climbed(placed: &Placed, corners: &[Corner], deviation: f64) -> (usize, f64) {
    let start = corners[0].position;
    let mut found = (0, deviation);
    while hold(placed, &corners[found.0]) == 0.0 && (found.0 == 0 || corners[found.0].waypoint.is_none()) {
        let (before, next) = (corners[found.0].position, found.0 + 1);
        let Some(position) = corners.get(next).map(|corner| corner.position) else { break };
        let aside = (position[0] - start[0]).hypot(position[1] - start[1]);
        let kept: Vec<Corner> = corners[..1].iter().chain(&corners[next..]).copied().collect();
        let deviation = polyline::deviation(placed, &kept);
        if aside > placed.tolerance || position[2] <= before[2] || deviation > placed.tolerance {
            break;
        }
        found = (next, deviation);
    }
    found
}

/// Whether the mission ends at rest on the ground, which is that of the mission or the height of its origin, below
/// where it was.
fn lands(placed: &Placed, corners: &[Corner]) -> bool {
    let [.., before, end] = corners else { return false };
    let ground = placed.mission.ground.unwrap_or(0.0);
    let aside = (end.position[0] - before.position[0]).hypot(end.position[1] - before.position[1]);
    placed.mission.end_at_rest
        && end.position[2] <= ground + LANDED
        && end.position[2] < before.position[2]
        && aside <= placed.tolerance
}
