//! mavc: from a one-page spec to a plan that can be flown.
pub mod actuation;
pub mod admissible;
pub mod cli;
pub mod diagnostic;
pub mod geometry;
pub mod model;
pub mod planner;
pub mod qp;
pub mod report;
pub mod solve;
pub mod source;
pub mod syntax;
pub mod trajectory;
pub mod unit;
