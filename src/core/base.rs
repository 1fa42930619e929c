//! Texts with places, diagnostics, numbers, units and tolerances.
//!
//! - What comes in: texts, numbers, names of files.
//! - What goes out: sources with their lines, diagnostics for people and programs, numbers as texts.
//! - What it does not know: what a vehicle or a mission is. Every other room uses it.

pub mod body;
pub mod diagnostic;
pub mod foreign;
pub mod geodesy;
pub mod input;
pub mod number;
#[cfg(test)]
pub mod schemas;
pub mod source;
pub mod stages;
pub mod text_table;
pub mod tolerance;
pub mod unit;
pub mod verdict;
