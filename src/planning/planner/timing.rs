//! Mission time: initial durations of legs from kinematics, and the search for the shortest time.

pub mod kinematics;
pub mod search;
mod turns;
mod weights;

/// No mission is searched beyond this, s: the longest that a spec may have.
pub(super) const MAX_MISSION_TIME: f64 = 100_000.0;
