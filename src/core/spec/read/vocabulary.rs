//! The words that the compiler knows, for completion and hover: those of the language table, warnings and functions.

use super::context::{CONSTANTS, FUNCTIONS};
use super::{allow, fault, plan};
use crate::language::{Entry, Group, Place};

/// The fields of a block, or the limits of a `limits` block; empty where no fields are allowed.
pub fn fields(place: Place) -> Vec<&'static str> {
    Group::of_block(place).names().collect()
}

/// The clauses of a statement that begins with `opener`, in a block: `rotor at` in `rotors`, `start` and `waypoint` in
/// a mission, `fault` in `simulate`.
pub fn clauses(place: Place, opener: &str) -> Vec<&'static str> {
    Group::of_statement(place, opener).names().collect()
}

/// The words that a field or clause accepts instead of a quantity, or in addition to one.
pub fn words(place: Place, field: &str) -> &'static [&'static str] {
    match (place, field) {
        (Place::Top, "allow") => allow::words(),
        _ => Group::within(place).iter().find_map(|group| group.entry(field)).map_or(&[], Entry::words),
    }
}

/// The code of the warning that a word in `allow` stands for.
pub fn allowed(word: &str) -> Option<&'static str> {
    allow::meant(word)
}

/// The numbers of a fault mode that `against = where` can compare.
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
