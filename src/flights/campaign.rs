//! Campaigns: simulated flights with every declared fault mode at many instants, with many noise seeds, along the plan
//! of every planner.
//!
//! A case has a number, and its flight follows from the number alone, so that cases can be flown in any order, by any
//! number of threads and machines. A flight is one row, and rows are streamed: memory grows with planners, modes and
//! instants, not with seeds.

pub mod agreement;
pub mod cases;
pub mod columns;
pub mod design;
pub mod merge;
pub mod path;
pub mod rows;
pub mod run;
pub mod scan;
pub mod statistics;
pub mod tally;

/// Name of the mode of a flight without a fault, in rows.
pub const HEALTHY: &str = "healthy";
