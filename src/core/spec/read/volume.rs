//! The `keep_in`, `keep_out` and `keep_off` blocks of a mission.

mod impose;
mod keep_off;
mod outline;
mod statements;

pub use impose::{impose, only_in_the_exact_model};
pub use keep_off::read_keep_off;
pub use statements::{is_one, read};
