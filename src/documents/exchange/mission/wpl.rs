//! MAVLink's plain text of missions, `QGC WPL 110`: twelve columns between tabs, the planned home first.
//!
//! ArduCopter takes no heading from an item: `CONDITION_YAW` before it turns the vehicle on the way, until the next
//! item (`mode_auto.cpp` of 4.5, `verify_yaw`). It keeps heights in centimetres and takes 0 for the present height
//! (`loc_from_cmd`).

use super::Placed;
use super::items::{CHANGE_SPEED, CONDITION_YAW, Item, Items, LAND, TAKE_OFF, WAYPOINT};
use super::qgc_plan::{NO_PLACE, RELATIVE};
use crate::number::{fixed, shortest};
use std::fmt::Write;

/// The least height above home of a waypoint, m: a millimetre more than the centimetre that is left when an autopilot
/// truncates.
const LOWEST: f64 = 0.011;

/// The text, and the number of its items.
pub fn text(placed: &Placed, items: &Items) -> (String, usize) {
    let home = placed.home();
    let place = |latitude: f64, longitude: f64, height: f64| {
        format!("{}\t{}\t{}", fixed(latitude, 9), fixed(longitude, 9), fixed(height, 3))
    };
    let at_home = place(home.latitude, home.longitude, home.height);
    let mut lines = vec![format!("1\t0\t{WAYPOINT}\t0\t0\t0\t0\t{at_home}")];
    for item in &items.all {
        match item {
            Item::Speed(speed) => {
                lines.push(format!("0\t{NO_PLACE}\t{CHANGE_SPEED}\t1\t{}\t-1\t0\t0\t0\t0", shortest(*speed)));
            }
            Item::Place { command, spot, hold, heading } => {
                if *command != TAKE_OFF {
                    // By the shorter way, with the autopilot's own rate.
                    let heading = shortest(*heading);
                    lines.push(format!("0\t{NO_PLACE}\t{CONDITION_YAW}\t{heading}\t0\t0\t0\t0\t0\t0"));
                }
                let seconds = shortest(if *command == WAYPOINT { *hold } else { 0.0 });
                let height = spot.height - home.height;
                let height = if *command != LAND && height.abs() < LOWEST { LOWEST } else { height };
                let there = place(spot.latitude, spot.longitude, height);
                lines.push(format!("0\t{RELATIVE}\t{command}\t{seconds}\t0\t0\t0\t{there}"));
            }
        }
    }
    let mut out = String::from("QGC WPL 110\n");
    for (number, line) in lines.iter().enumerate() {
        let _ = writeln!(out, "{number}\t{line}\t1");
    }
    (out, lines.len() - 1)
}
