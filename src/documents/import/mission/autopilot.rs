//! What autopilots do where a mission leaves it open: the speeds of their parameters, by default.
//!
//! Sources: ArduCopter 4.5, `AC_WPNav.cpp` (`WPNAV_SPEED`, `_UP`, `_DN`) and `ArduCopter/config.h` (`LAND_SPEED`,
//! `LAND_ALT_LOW`); PX4 1.15, `mc_pos_control` and `FlightTaskAuto` (`MPC_XY_CRUISE`, `MPC_XY_VEL_MAX`,
//! `MPC_Z_V_AUTO_UP`, `_DN`, `MPC_TKO_SPEED`, `MPC_LAND_SPEED`, `MPC_LAND_ALT1`).

use super::draft::{Mark, Speeds};
use std::ops::Range;

/// A speed in m/s and the parameter whose default it is.
pub type Speed = (f64, &'static str);

/// The speeds with which an autopilot flies a mission that sets none.
pub struct Autopilot {
    pub name: &'static str,
    /// In level flight.
    pub horizontal: Speed,
    /// The fastest level flight whatever a mission asks for, if there is a bound.
    pub fastest: Option<Speed>,
    pub climb: Speed,
    pub descent: Speed,
    pub take_off: Speed,
    /// The last part of a landing.
    pub land: Speed,
    /// The height above home at which a landing becomes slow, m.
    pub slows_at: f64,
    /// The height to which a return climbs at least, m above home, and its parameter.
    pub returns_at: Speed,
}

pub const ARDUPILOT: Autopilot = Autopilot {
    name: "ArduPilot",
    horizontal: (10.0, "WPNAV_SPEED"),
    fastest: None,
    climb: (2.5, "WPNAV_SPEED_UP"),
    descent: (1.5, "WPNAV_SPEED_DN"),
    take_off: (2.5, "WPNAV_SPEED_UP"),
    land: (0.5, "LAND_SPEED"),
    slows_at: 10.0,
    returns_at: (15.0, "RTL_ALT"),
};

pub const PX4: Autopilot = Autopilot {
    name: "PX4",
    horizontal: (5.0, "MPC_XY_CRUISE"),
    fastest: Some((12.0, "MPC_XY_VEL_MAX")),
    climb: (3.0, "MPC_Z_V_AUTO_UP"),
    descent: (1.5, "MPC_Z_V_AUTO_DN"),
    take_off: (1.5, "MPC_TKO_SPEED"),
    land: (0.7, "MPC_LAND_SPEED"),
    slows_at: 10.0,
    returns_at: (60.0, "RTL_RETURN_ALT"),
};

impl Autopilot {
    /// The speeds of legs before an item sets others; they count as said at `span`.
    pub fn speeds(&self, span: &Range<usize>) -> Speeds {
        Speeds {
            horizontal: Some(self.marked(self.horizontal, span)),
            climb: Some(self.marked(self.climb, span)),
            descent: Some(self.marked(self.descent, span)),
        }
    }

    /// A default with a name for comments and messages.
    pub fn marked(&self, (speed, parameter): Speed, span: &Range<usize>) -> (f64, Mark) {
        (speed, Mark { name: format!("{}'s default {parameter}", self.name), span: span.clone() })
    }
}
