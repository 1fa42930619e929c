//! The words that the compiler knows, for whoever offers or explains them: fields of every block, words that fields
//! take, functions. The rooms that read a block own its list; here they are only put side by side.

use super::context::{CONSTANTS, FUNCTIONS};
use super::elaborate::TOP_FIELDS;
use super::{allow, campaign, fault, limits, mission, plan, simulate, vehicle};
use crate::syntax::Place;

/// The fields of a block, or the limits of a `limits` block; nothing where no field stands.
pub fn fields(place: Place) -> Vec<&'static str> {
    match place {
        Place::Top => TOP_FIELDS.to_vec(),
        Place::Vehicle => vehicle::VEHICLE_FIELDS.to_vec(),
        Place::Rotor => vehicle::ROTOR_FIELDS.to_vec(),
        Place::Mode | Place::Every => fault::FIELDS.to_vec(),
        Place::Curve => mission::CURVE_FIELDS.to_vec(),
        Place::Limits => limits::names().collect(),
        Place::Plan => plan::FIELDS.to_vec(),
        Place::Simulate => simulate::FIELDS.to_vec(),
        Place::Campaign => campaign::FIELDS.to_vec(),
        Place::Rotors | Place::Faults | Place::Mission | Place::Unknown => Vec::new(),
    }
}

/// The clauses of a statement that begins with `opener`, in a block: `rotor at` in `rotors`, `start` and `waypoint` in a
/// mission, `fault` in `simulate`.
pub fn clauses(place: Place, opener: &str) -> &'static [&'static str] {
    match (place, opener) {
        (Place::Rotors, "rotor") => &vehicle::PLACED_FIELDS,
        (Place::Mission, "start" | "waypoint") => &mission::WAYPOINT_CLAUSES,
        (Place::Simulate, "fault") => &simulate::STRIKE_CLAUSES,
        _ => &[],
    }
}

/// The words that a field takes in place of a value, or beside one.
pub fn words(place: Place, field: &str) -> &'static [&'static str] {
    match (place, field) {
        (Place::Top, "allow") => allow::words(),
        (Place::Vehicle, "allocation") => &["bounded", "pseudo_inverse"],
        (Place::Rotors, "spin") => &["P", "N"],
        (Place::Mode | Place::Every | Place::Plan, "after_fault") => &["continue", "hold"],
        (Place::Plan, "planner") => &["rip", "rcp", "rsp"],
        (Place::Plan, "model") => &["hover", "exact"],
        (Place::Plan, "rotors") => &["instant", "lagging"],
        (Place::Plan, "timing") => &["optimal", "proportional", "uniform", "distance"],
        (Place::Plan, "time") => &["minimum"],
        (Place::Plan, "against") => &["all"],
        (Place::Simulate, "controller") => &["geometric", "pd"],
        (Place::Simulate, "detection") => &["estimator", "never"],
        (Place::Simulate, "lost_yaw") => &["off"],
        (Place::Simulate, "after_fault") => &["continue", "hold", "land"],
        (Place::Campaign, "planners") => &["rip", "rsp", "rcp"],
        _ => &[],
    }
}

/// The code of the warning that a word in `allow` stands for.
pub fn allowed(word: &str) -> Option<&'static str> {
    allow::meant(word)
}

/// The numbers of a fault mode that `against = where` looks at.
pub fn mode_numbers() -> &'static [&'static str] {
    &plan::MODE_NUMBERS
}

/// The functions of the language.
pub fn functions() -> &'static [&'static str] {
    &FUNCTIONS
}

/// The constants of the language.
pub fn constants() -> &'static [&'static str] {
    &CONSTANTS
}

/// Names that no fault mode may have.
pub fn reserved_modes() -> &'static [&'static str] {
    &fault::RESERVED
}
