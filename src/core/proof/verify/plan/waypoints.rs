//! Rest and waypoints at the nodes of a motion.

use super::super::interval::{Interval, exceeds};
use super::super::motion::{Motion, X, Y, YAW, Z};
use super::super::{Rejection, schedule};
use super::{MOST_MISS, Setting};
use crate::model::Heading;
use crate::number::number;
use std::f64::consts::PI;

impl Setting<'_> {
    /// Checks rest at both ends (unless `moving`), at stops and in holds: derivatives are zero, in holds the inputs
    /// too.
    pub(super) fn rest(&self, motion: &Motion) -> Result<(), Rejection> {
        let last = motion.times.len() - 1;
        let ends = [(0, self.mission().start_at_rest), (last, self.mission().end_at_rest)];
        let mut still: Vec<(usize, bool)> = ends.iter().filter(|e| e.1).map(|e| (e.0, false)).collect();
        for (i, point) in self.mission().waypoints.iter().enumerate().filter(|(_, w)| w.hold > 0.0) {
            let node = motion.waypoint_nodes[i];
            let Some(until) = schedule::held_until(self.mission(), motion, i) else {
                let why = format!("the motion does not stay at waypoint {}", i + 1);
                return Err(Rejection { span: point.hold_span, ..Rejection::new("rest", why) });
            };
            still.extend((node..=until).map(|node| (node, true)));
        }
        let stops = self.mission().waypoints.iter().zip(&motion.waypoint_nodes).filter(|(point, _)| point.stop);
        still.extend(stops.map(|(_, &node)| (node, false)));
        for (node, held) in still {
            for axis in [X, Y, Z, YAW] {
                // At rest the jerk vanishes too, unless it is the slope of an input.
                let highest = if held { motion.order(axis) } else { motion.order(axis).min(3) };
                if let Some(order) = (1..=highest).find(|&i| motion.at_node(node, axis, i) != 0.0) {
                    let name = ["x", "y", "z", "yaw"][axis];
                    let value = number(motion.at_node(node, axis, order));
                    let why = format!("derivative {order} of {name} is {value}; the spec requires 0");
                    return Err(Rejection { at: Some(motion.times[node]), ..Rejection::new("rest", why) });
                }
            }
        }
        Ok(())
    }

    /// Checks that every waypoint is met as closely as the spec requires.
    pub(super) fn waypoints(&self, motion: &Motion) -> Result<(), Rejection> {
        for (i, (point, &node)) in self.mission().waypoints.iter().zip(&motion.waypoint_nodes).enumerate() {
            let apart = |axis: usize, due: f64| Interval::point(motion.at_node(node, axis, 0)) - Interval::point(due);
            let [x, y, z] = point.position;
            let distance = [(X, x), (Y, y), (Z, z)]
                .iter()
                .fold(Interval::ZERO, |sum, &(axis, due)| sum + apart(axis, due).square())
                .sqrt();
            let turned = apart(YAW, point.yaw).abs();
            let off = [("position", distance, point.within, "m"), ("yaw", turned, point.yaw_within, "rad")];
            // The yaw of a start that follows a direction is that direction itself, not a full turn away from it.
            let follows = i == 0 && point.heading != Heading::Given;
            if follows && exceeds(turned.high, PI + MOST_MISS) {
                let why = format!(
                    "its yaw is {} rad from where yaws are counted, more than half a turn",
                    number(turned.high)
                );
                let (at, span) = (Some(motion.times[node]), Some(point.span));
                return Err(Rejection { at, span, ..Rejection::new("waypoint 1", why) });
            }
            // A yaw that follows from the motion is checked as a limit.
            let count = if point.heading == Heading::Given { 2 } else { 1 };
            for (what, error, within, unit) in off.into_iter().take(count) {
                if exceeds((error - Interval::point(within)).high, MOST_MISS) {
                    let [error, within] = [error.high, within].map(number);
                    let why = format!("its {what} is missed by {error} {unit}; {within} {unit} is allowed");
                    let (at, span) = (Some(motion.times[node]), Some(point.span));
                    return Err(Rejection { at, span, ..Rejection::new(format!("waypoint {}", i + 1), why) });
                }
            }
        }
        Ok(())
    }
}
