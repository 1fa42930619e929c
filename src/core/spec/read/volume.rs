//! The `keep_in` and `keep_out` blocks of a mission.

mod impose;
mod statements;

pub use impose::{impose, only_in_the_exact_model};
pub use statements::{is_one, read};
