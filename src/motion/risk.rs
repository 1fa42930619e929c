//! How long faults threaten a mission, and the risk of losing it.
//!
//! A lost rotor stays lost. A fault any earlier than the last instant outside its mode's set meets that excursion if the
//! mission goes on, so until then the mission is committed.

use super::outside::Outside;

impl Outside {
    /// How long a mission that goes on after a fault is committed, s: until the last instant outside; 0 where the plan never
    /// leaves the set.
    pub fn committed(&self) -> f64 {
        self.last.unwrap_or(0.0)
    }
}

/// Risk of losing the mission, modes taken as independent: `1 - exp(-sum rate x committed)`, each mode given as its rate
/// (1/s) and how long the mission is committed to it (s).
pub fn risk(modes: impl IntoIterator<Item = (f64, f64)>) -> f64 {
    let expected: f64 = modes.into_iter().map(|(rate, committed)| rate * committed).sum();
    -(-expected).exp_m1()
}

/// The risk over the modes that have a rate (1/s), each committed for so long (s); `None` where none has one.
pub fn rated_risk(rates: &[Option<f64>], committed: &[f64]) -> Option<f64> {
    let rated: Vec<(f64, f64)> =
        rates.iter().zip(committed).filter_map(|(rate, committed)| Some(((*rate)?, *committed))).collect();
    (!rated.is_empty()).then(|| risk(rated))
}
