//! What was found, told: the record (`--report`), text for the terminal, and the trajectory table.

pub mod analysis_record;
pub mod analysis_text;
pub mod between;
pub mod binding;
pub mod campaign_record;
pub mod campaign_text;
pub mod caveats;
pub mod comparison_text;
pub mod conflict_record;
pub mod flight;
pub mod heat;
pub mod least_time;
#[cfg(feature = "report")]
pub mod page;
pub mod record;
pub mod table;
pub mod terminal;
pub mod trajectory_csv;
pub mod verdict_text;
pub mod verification_text;
pub mod waypoints;
