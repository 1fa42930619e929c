//! Where the vehicle points. PX4 takes a heading from parameter 4 of an item. ArduCopter does not: its
//! `MAV_CMD_CONDITION_YAW` turns on the way to the next place, after which `WP_YAW_BEHAVIOR` decides again
//! (`ArduCopter/mode_auto.cpp`, `do_yaw`, `verify_yaw` and `do_nav_wp`, 4.5). A region of interest holds in both until
//! another or none is set, or ArduCopter turns (in PX4 if `MIS_MNT_YAW_CTL` is 0, its default).

use super::{Follow, Item, Read, Yaw};
use crate::import::mission::{ASSUMED, LEFT_OUT};

impl Follow<'_> {
    /// The yaw with which the vehicle arrives at the place of an item.
    pub(super) fn yaw(&mut self, item: &Item) -> Yaw {
        // PX4 takes none from take-offs and landings (`mission.cpp`, `handleTakeoff`, `handleLanding`, 1.16).
        let has_heading = item.command == 16.0 || self.setting.is_ardupilot && matches!(item.command, 21.0 | 22.0);
        let heading = item.params[3].filter(|_| has_heading);
        if self.setting.is_ardupilot && heading.is_some_and(|heading| heading != 0.0) {
            let message = "parameter 4 is left out: ArduCopter takes no heading from it";
            self.warn_with(
                LEFT_OUT,
                item,
                message,
                "left out",
                "set a heading by CONDITION_YAW (115) before the item, as `mavc plan --format wpl` does",
            );
        }
        match (self.turn.take(), self.region, heading) {
            (Some(yaw), ..) => {
                // The turn replaces the region.
                self.region = None;
                Yaw::Angle(yaw)
            }
            (None, Some(place), _) => Yaw::Towards(place),
            (None, None, Some(heading)) if !self.setting.is_ardupilot => Yaw::Angle(90.0 - heading),
            _ => Yaw::Free,
        }
    }

    /// `MAV_CMD_CONDITION_YAW`: parameter 1 the angle (deg), 3 the direction (-1 counter-clockwise), 4 whether the
    /// angle is added to the present one.
    pub(super) fn condition_yaw(&mut self, item: &Item) {
        if !self.setting.is_ardupilot {
            return self.warn(LEFT_OUT, item, "PX4 does not know command 115 (CONDITION_YAW)", "left out");
        }
        let angle = item.params[0].unwrap_or(0.0);
        let is_relative = item.params[3].is_some_and(|relative| relative > 0.0);
        if !is_relative {
            self.turn = Some(90.0 - angle);
            return;
        }
        match self.stops.last().map(|stop| stop.yaw) {
            Some(Yaw::Angle(before)) => {
                let direction = if item.params[2].is_some_and(|direction| direction < 0.0) { -1.0 } else { 1.0 };
                self.turn = Some(before - direction * angle);
            }
            _ => self.warn(
                LEFT_OUT,
                item,
                "a turn by an angle is left out: the mission does not say from which heading",
                "left out",
            ),
        }
    }

    /// `MAV_CMD_DO_SET_ROI`, `_LOCATION`, `MAV_CMD_NAV_ROI`: the place to look at; none for latitude, longitude and
    /// altitude 0.
    pub(super) fn look_at(&mut self, item: &Item) -> Read<()> {
        if item.params[4..].iter().all(|x| x.is_none_or(|x| x == 0.0)) {
            self.region = None;
            return Ok(());
        }
        let place = super::place([item.params[4], item.params[5]], 0.0, [&item.spans[4], &item.spans[5]])?;
        let height = self.plane.place([0.0; 3]).height;
        let [x, y, _] = self.plane.local(&crate::geodesy::Geodetic { height, ..place });
        self.region = Some([x, y]);
        self.turn = None;
        let message = "the region of interest becomes `yaw towards`: a gimbal that turns by itself would look there \
                       instead of the vehicle";
        self.warn(ASSUMED, item, message, "a region of interest");
        Ok(())
    }
}
