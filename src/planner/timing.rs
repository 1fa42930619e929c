//! Mission time: initial durations of legs from kinematics, and the search for the shortest time.

pub mod kinematics;
pub mod search;
