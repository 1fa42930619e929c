//! One function for each question of a user, for programs in Rust, for Python and for the command.
//!
//! - What comes in: a [`Spec`](crate::Spec), or values to make one of.
//! - What goes out: results with their records; progress to an [`Observer`](observer::Observer).
//! - What it does not know: files, terminal, editors.

pub mod builder;
pub mod observer;
pub mod pipeline;
