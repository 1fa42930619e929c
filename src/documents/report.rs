//! Results for readers: JSON records (`--report`), terminal text, the report page and the tables of trajectories and
//! flights.

pub mod analysis_record;
pub mod analysis_screen;
pub mod analysis_text;
pub mod battery;
pub mod between;
pub mod binding;
pub mod campaign_record;
pub mod campaign_screen;
pub mod campaign_text;
pub mod capture_height;
pub mod capture_text;
pub mod caveats;
pub mod comparison_screen;
pub mod comparison_text;
pub mod conflict_record;
pub mod diagnosis;
pub mod headings;
pub mod headline;
pub mod least_time;
pub mod mode_names;
pub mod model_record;
#[cfg(feature = "report")]
pub mod page;
pub mod plan_screen;
mod planner_names;
pub mod record;
pub mod recoverable;
pub mod recovery;
pub mod screen;
pub mod shape;
pub mod simulation;
pub mod terminal;
pub mod trajectory_csv;
pub mod verdict_text;
pub mod volumes;
pub mod waypoints;
pub mod without_yaw;
