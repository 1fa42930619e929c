//! How long a mission is committed to each fault mode, and the risk of losing it (`docs/method/risk.md`,
//! "Committed" and "Risk").
//!
//! A lost rotor stays lost. If the mission continues after a fault, a fault before the last violation of its mode's set
//! still meets that violation, so the mission is committed until then.

use super::outside::Outside;

impl Outside {
    /// How long a mission that continues after a fault is committed to the mode, s: until the last violation; 0 without
    /// one.
    pub fn committed(&self) -> f64 {
        self.last.unwrap_or(0.0)
    }
}

/// The risk of losing the mission, `1 - exp(-sum_i lambda_i committed_i)`, with modes taken as independent. Each item
/// is the failure rate of a mode (1/s) and how long the mission is committed to it (s).
pub fn risk(modes: impl IntoIterator<Item = (f64, f64)>) -> f64 {
    let expected: f64 = modes.into_iter().map(|(rate, committed)| rate * committed).sum();
    -(-expected).exp_m1()
}

/// The [`risk`] over the modes that have a rate (1/s), with the time for which the mission is committed to each mode
/// (s). `None` if no mode has a rate.
pub fn rated_risk(rates: &[Option<f64>], committed: &[f64]) -> Option<f64> {
    let rated: Vec<(f64, f64)> =
        rates.iter().zip(committed).filter_map(|(rate, committed)| Some(((*rate)?, *committed))).collect();
    (!rated.is_empty()).then(|| risk(rated))
}
