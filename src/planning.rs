//! From a mission to a trajectory, its certificate, or the reason why there is none.
//!
//! - What comes in: a [`Problem`](crate::model::Problem) and the admissible sets of its modes.
//! - What goes out: trajectories, proofs that none exists, certificates, explanations.
//! - What it does not know: simulated flights, reports, files and terminal.

pub mod certify;
pub mod explain;
pub mod planner;
pub mod qp;
pub mod solve;
