//! Vehicles, plans and flights in the formats of other tools. What each format keeps, and what was measured when its
//! own reader read it, is in `docs/exchange.md`.

pub mod bytes;
pub mod cdr;
pub mod flight;
pub mod frames;
pub mod mcap;
pub mod mission;
pub mod trajectory;
pub mod vehicle;
