//! Certificates and the checker that decides them from the spec alone.
//!
//! - What comes in: a spec and the bytes of a certificate.
//! - What goes out: what is shown, what is undecided, or the statement that does not hold.
//! - What it does not know: how a certificate was made. No planner, solver or report can be named here, because they
//!   are in another crate.

pub mod certificate;
pub mod verify;
