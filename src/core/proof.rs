//! Certificates and the checker that decides them from the spec alone. It does not know how a certificate was made: no
//! planner, no solver and no report can be named here, because they are in another crate.

pub mod certificate;
pub mod verify;
