//! Planning as in sections 5.2 and 5.3: waypoint times, rows, selection of facets, shortest times.

pub mod compare;
mod cost;
pub mod kinematics;
pub mod lead;
mod limits;
pub mod pool;
pub mod rows;
pub mod search;
pub mod select;
pub mod sets;
pub mod spline;
pub mod stop;
pub mod successive;
pub mod transcribe;
mod wrench_expression;
pub mod yaw;
