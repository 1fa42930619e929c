//! MAVLink's plain text of missions, `QGC WPL 110`: twelve columns between tabs, the planned home first.

use super::Placed;
use super::items::{CHANGE_SPEED, Item, Items, WAYPOINT};
use super::qgc_plan::{NO_PLACE, RELATIVE};
use crate::number::{fixed, shortest};
use std::fmt::Write;

/// A heading of 0 means none to ArduPilot's ground stations.
const NORTH: f64 = 360.0;

pub fn text(placed: &Placed, items: &Items) -> String {
    let home = placed.home();
    let mut out = String::from("QGC WPL 110\n");
    let place = |latitude: f64, longitude: f64, height: f64| {
        format!("{}\t{}\t{}", fixed(latitude, 9), fixed(longitude, 9), fixed(height, 3))
    };
    let at_home = place(home.latitude, home.longitude, home.height);
    let _ = writeln!(out, "0\t1\t0\t{WAYPOINT}\t0\t0\t0\t0\t{at_home}\t1");
    for (k, item) in items.all.iter().enumerate() {
        let number = k + 1;
        let _ = match item {
            Item::Speed(speed) => {
                writeln!(out, "{number}\t0\t{NO_PLACE}\t{CHANGE_SPEED}\t1\t{}\t-1\t0\t0\t0\t0\t1", shortest(*speed))
            }
            Item::Place { command, spot, hold, heading } => {
                let seconds = if *command == WAYPOINT { *hold } else { 0.0 };
                let heading = if *heading == 0.0 { NORTH } else { *heading };
                let there = place(spot.latitude, spot.longitude, spot.height - home.height);
                let [seconds, heading] = [seconds, heading].map(shortest);
                writeln!(out, "{number}\t0\t{RELATIVE}\t{command}\t{seconds}\t0\t0\t{heading}\t{there}\t1")
            }
        };
    }
    out
}
