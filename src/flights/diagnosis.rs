//! What a recorded flight says of its rotors: which of them lost thrust, when, and how much each one has.
//!
//! The record comes from a log (`documents::log`); nothing here knows its format. Methods: `docs/diagnose.md`.

pub mod aftermath;
pub mod capacity;
pub mod change;
pub mod ending;
pub mod fit;
pub mod hidden;
pub mod lasting;
pub mod mixer;
pub mod onset;
pub mod outputs;
pub mod record;
pub mod samples;
pub mod study;
pub mod transient;
