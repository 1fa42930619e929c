#![doc = include_str!("ARCHITECTURE.md")]

pub mod actuation;
pub mod admissible;
pub mod campaign;
pub mod cli;
pub mod diagnostic;
pub mod flight;
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
