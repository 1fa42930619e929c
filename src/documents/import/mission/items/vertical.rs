//! Take-offs, landings and returns.

use super::speeds::slower;
use super::{Autopilot, CENTIMETRE, FRAMES, Follow, Geodetic, Item, LANDS_AT_HOME, Mark, SAME_PLACE, Step, Way, Yaw};
use crate::import::mission::{ASSUMED, LEFT_OUT};
use crate::number::number;

impl Follow<'_> {
    /// The planned home as the start, straight up, and on to the item's place.
    pub(super) fn take_off(&mut self, item: &Item) -> Step {
        let is_in_the_air = !self.stops.is_empty() && !self.stops.last().is_some_and(|last| last.stops);
        if self.stops.is_empty() {
            let name = if self.setting.home.has_height { "planned home" } else { "below the take-off" };
            let home = Mark { name: name.into(), span: self.setting.home.span.clone() };
            self.push(item, [0.0; 3], "").mark = home;
        }
        let [x, y] = self.stops.last().map_or([0.0; 2], |last| [last.position[0], last.position[1]]);
        let there = self.position(item)?;
        let apart = (there[0] - x).hypot(there[1] - y);
        let above = self.plane.place([x, y, 0.0]);
        let up = self.plane.local(&Geodetic { height: self.plane.place(there).height, ..above })[2];
        if is_in_the_air && self.setting.is_ardupilot && self.stops.last().is_some_and(|last| last.position[2] > up) {
            // `ArduCopter/mode_auto.cpp`, `takeoff_start`.
            let message = "ArduPilot does not descend to a take-off below the present height: it is left out";
            self.warn(LEFT_OUT, item, message, "left out");
            return Ok(());
        }
        let yaw = self.yaw(item);
        let climb = self.autopilot().marked(self.autopilot().take_off, &item.mark.span);
        let stop = self.push(item, [x, y, up], "take-off");
        (stop.yaw, stop.way) = (yaw, Way::Vertical);
        stop.speeds.climb = slower(stop.speeds.climb.take(), climb);
        if apart > SAME_PLACE && self.setting.is_ardupilot {
            self.warn(
                LEFT_OUT,
                item,
                "ArduPilot takes off straight up: latitude and longitude are left out",
                "left out",
            );
        } else if apart > SAME_PLACE {
            self.push(item, there, "to the place of the take-off").yaw = yaw;
        }
        Ok(())
    }

    /// To above the place at the present height, and straight down to the ground, whatever the item's altitude is.
    pub(super) fn land(&mut self, item: &Item) -> Step {
        let home = self.setting.home.place.height;
        if !FRAMES.contains(&item.frame) {
            return self.refuse_frame(item);
        }
        let given = match (item.frame, item.params[6]) {
            (0.0 | 5.0, Some(height)) if height != 0.0 => Some(height),
            (3.0 | 6.0, Some(height)) => Some(home + height),
            (10.0 | 11.0, _) => item.above_sea,
            _ => None,
        };
        // Above home it may be the height of the flight; below home it can only be that of the ground.
        let ground = given.filter(|height| *height < home || matches!(item.frame, 10.0 | 11.0)).unwrap_or(home);
        if let Some(height) = given.filter(|height| (height - ground).abs() > CENTIMETRE) {
            let message = format!(
                "it lands on the ground, for which the spec takes the height of the planned home, not its altitude, {} \
                 m above home",
                number(height - home)
            );
            self.warn(ASSUMED, item, &message, "autopilots descend to the ground");
        }
        self.warn_below_home(item, ground);
        let mut on_ground = Item { frame: 0.0, ..item.clone() };
        on_ground.params[6] = Some(ground);
        let there = self.position(&on_ground)?;
        let yaw = self.yaw(item);
        self.down(item, there, yaw, "land")
    }

    pub(super) fn down(&mut self, item: &Item, there: [f64; 3], yaw: Yaw, remark: &'static str) -> Step {
        let Some(last) = self.stops.last().map(|stop| stop.position) else {
            let stop = self.push(item, there, remark);
            (stop.yaw, stop.way, stop.stops) = (yaw, Way::Any, true);
            return Ok(());
        };
        let mut below = there;
        if (there[0] - last[0]).hypot(there[1] - last[1]) > SAME_PLACE {
            self.push(item, [there[0], there[1], last[2]], "to above the landing").yaw = yaw;
        } else {
            // The vehicle lands below where it is: its own place differs by centimetres of rounding.
            below = [last[0], last[1], there[2]];
        }
        let slow = there[2] + self.autopilot().slows_at;
        if last[2] > slow + SAME_PLACE {
            let stop = self.push(item, [below[0], below[1], slow], "slows down");
            (stop.yaw, stop.way) = (yaw, Way::Vertical);
        }
        let descent = self.autopilot().marked(self.autopilot().land, &item.mark.span);
        let stop = self.push(item, below, remark);
        (stop.yaw, stop.way, stop.stops) = (yaw, Way::Vertical, true);
        stop.speeds.descent = slower(stop.speeds.descent.take(), descent);
        Ok(())
    }

    pub(super) fn back_home(&mut self, item: &Item) -> Step {
        let Autopilot { name, returns_at: (height, parameter), .. } = self.autopilot();
        let message = format!(
            "the spec returns at the present height; {name} first climbs to {parameter}, by default {} m, if it is \
             lower",
            number(*height)
        );
        self.warn(ASSUMED, item, &message, "no height given");
        // Both autopilots return at their default speed (PX4: `RtlDirect::on_activation`; ArduCopter: `RTL_SPEED` 0).
        self.speeds = self.autopilot().speeds(&item.mark.span);
        self.down(item, [0.0; 3], Yaw::Free, LANDS_AT_HOME)?;
        self.ended = Some(item.mark.clone());
        Ok(())
    }
}
