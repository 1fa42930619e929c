//! Planning as in sections 5.2 and 5.3: waypoint times, rows, selection of facets, shortest times.

pub mod commands;
mod cost;
pub mod hover;
mod limits;
mod plan;
pub mod scp;
pub mod selection;
pub mod spline;
pub mod stop;
pub mod studies;
pub mod timing;
pub mod transcription;
pub mod working_set;
mod wrench_expression;
pub mod yaw;
