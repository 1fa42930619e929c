//! What a vehicle can do, and what a motion asks of it.
//!
//! - What comes in: a [`Model`](crate::model::Model): masses, rotors, fault modes, in SI units; polynomials of a
//!   motion.
//! - What goes out: matrices from thrusts to wrench, admissible sets with their margins, wrenches, power and energy
//!   along a motion.
//! - What it does not know: how a motion is found: planners and solvers; files and terminal.

pub mod actuation;
pub mod admissible;
pub mod energy;
pub mod flatness;
pub mod geometry;
pub mod motion;
