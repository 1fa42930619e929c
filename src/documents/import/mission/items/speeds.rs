//! The speeds that a mission sets, and those at which autopilots fly.

use super::{Follow, Item, Mark, Step, refuse};
use crate::import::SYNTAX;
use crate::import::mission::ASSUMED;
use crate::number::number;

impl Follow<'_> {
    /// Parameter 1 the kind of speed (0 air, 1 ground, 2 climb, 3 descent), 2 the speed, m/s; -1 no change, -2 the
    /// default.
    pub(super) fn speed(&mut self, item: &Item) -> Step {
        let default = self.autopilot().speeds(&item.mark.span);
        let is_level = matches!(item.params[0], None | Some(0.0 | 1.0));
        if let Some(fastest) = self.autopilot().fastest.filter(|(speed, _)| is_level && item.params[1] > Some(*speed)) {
            let message = format!(
                "{} flies no faster than its parameter `{}`, by default {} m/s",
                self.autopilot().name,
                fastest.1,
                number(fastest.0)
            );
            let help = "the spec has this speed; if the parameter is larger, write your speed into the spec";
            self.warn_with(ASSUMED, item, &message, "faster", help);
            self.speeds.horizontal = Some(self.autopilot().marked(fastest, &item.mark.span));
            return Ok(());
        }
        let (kind, default) = match item.params[0].unwrap_or(0.0) {
            0.0 | 1.0 => (&mut self.speeds.horizontal, default.horizontal),
            2.0 => (&mut self.speeds.climb, default.climb),
            3.0 => (&mut self.speeds.descent, default.descent),
            _ => return refuse(SYNTAX, &item.spans[0], "the kind of a speed is 0 to 3", "no kind of speed"),
        };
        match item.params[1] {
            None | Some(-1.0) => {}
            // ArduCopter, `do_change_speed`: only speeds above zero.
            Some(speed) if self.setting.is_ardupilot && speed <= 0.0 => {}
            Some(-2.0) => *kind = default,
            Some(speed) if speed > 0.0 => *kind = Some((speed, item.mark.clone())),
            Some(_) => return refuse(SYNTAX, &item.spans[1], "a speed must be above zero", "not above zero"),
        }
        Ok(())
    }
}

/// The slower of two speeds.
pub(super) fn slower(set: Option<(f64, Mark)>, own: (f64, Mark)) -> Option<(f64, Mark)> {
    Some(set.filter(|(speed, _)| *speed <= own.0).unwrap_or(own))
}
