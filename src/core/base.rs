//! Texts with places, diagnostics, numbers, units and tolerances: what every other room uses and none of it knows what
//! a vehicle or a mission is.

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
