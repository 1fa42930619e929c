//! Simulated flights of a plan, with faults.
//!
//! - What comes in: a trajectory, and what a spec says of motors, sensors, gusts and faults.
//! - What goes out: states in time, what was estimated, whether the flight ended well; rows and statistics of many.
//! - What it does not know: how the plan was found; files and terminal.

pub mod campaign;
pub mod diagnosis;
pub mod flight;
pub mod recovery;
