//! The cost of deciding a certificate, bounded from its size before any work begins, and the budget.
//!
//! Work is counted in units and not in time, so that the same certificate has the same verdict on every machine. The
//! weights below are chosen so that the bound is not too low: for four shipped specs it was 1 to 20 times the time of
//! the check at the nodes (docs/certificates.md, *Cost*).

use super::interval::exceeds;
use std::str::FromStr;

/// Units of work that the budget counts as one second.
pub const UNITS_PER_SECOND: f64 = 2e7;

/// Units of evaluating one bounding plane of a set, or one side of a limit, at one state.
pub const COST_PER_ROW: u64 = 1;

/// Units of one state of a motion with its wrench in the hover model.
pub const OF_HOVER_WRENCH: u64 = 20;
/// Units of one state of a motion with its wrench in the exact model.
pub const OF_EXACT_WRENCH: u64 = 100;
/// Units of one state of a motion for a limit.
pub const COST_PER_LIMIT: u64 = 10;
/// Limits of which one unit finds those that concern a leg.
pub const LIMITS_OF_A_UNIT: u64 = 16;
/// Units of a corner of a polygon, for the distance of one state from it.
pub const COST_PER_CORNER: u64 = 1;
/// Units of one state for the torque that a spinning body needs, at one of its momenta and rates.
pub const COST_PER_SPIN: u64 = 10;

/// Bounding planes of which one unit finds in plain numbers whether a wrench violates them: four products each, where a
/// row takes intervals with their rates of change.
pub const PLANES_OF_A_UNIT: u64 = 8;

/// Units of a joint between two pieces.
pub const COST_PER_JOINT: u64 = 50;

/// Units of a plane in exact arithmetic: the vector orthogonal to three, and its support.
pub const COST_PER_PLANE: u64 = 300;

/// Units of a rotor's exact wrenches, of which a set is made.
pub const COST_PER_ROTOR: u64 = 100;
/// Units of a row of which a core is made, with its share of the sorting.
pub const COST_PER_CORE_ROW: u64 = 10;

/// Units of a weight on the acceleration, with its share of a leg.
pub const COST_PER_WEIGHT: u64 = 100;

/// Units of a multiplier's row.
pub const COST_PER_MULTIPLIER: u64 = 20;
/// Units of expressing one node's derivatives by those of the node before.
pub const COST_PER_CARRIED_NODE: u64 = 100;

/// Bytes of a plane, including the allocator's overhead and the lists of a proof.
pub const BYTES_OF_A_PLANE: u64 = 512;
/// Bytes of a row of which a core is made.
pub const BYTES_OF_A_CORE_ROW: u64 = 256;
/// Bytes of a row of a core at one of its momenta and rates.
pub const BYTES_OF_A_MEMBER: u64 = 512;
/// Bytes of a node of a motion.
pub const BYTES_OF_A_NODE: u64 = 1024;
/// Bytes of a node of a branch, as a record and as a motion.
pub const BYTES_OF_A_BRANCH_NODE: u64 = 512;
/// Bytes of a multiplier.
pub const BYTES_OF_A_MULTIPLIER: u64 = 160;

/// The largest cost of one decision.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Budget {
    /// Seconds of one core, as [`UNITS_PER_SECOND`] counts them.
    pub seconds: f64,
    pub bytes: u64,
}

impl Default for Budget {
    fn default() -> Self {
        Budget { seconds: 10.0, bytes: 500_000_000 }
    }
}

impl FromStr for Budget {
    type Err = String;

    /// Reads `10s`, `500MB` or both with a comma between.
    fn from_str(text: &str) -> Result<Budget, String> {
        let mut budget = Budget::default();
        for part in text.split(',').map(str::trim) {
            let figure = |unit: &str| part.strip_suffix(unit).and_then(|digits| digits.trim().parse::<f64>().ok());
            let positive = |x: f64| x.is_finite() && x > 0.0;
            match (figure("GB"), figure("MB"), figure("s")) {
                (Some(gb), _, _) if positive(gb) => budget.bytes = (gb * 1e9) as u64,
                (_, Some(mb), _) if positive(mb) => budget.bytes = (mb * 1e6) as u64,
                (_, _, Some(seconds)) if positive(seconds) => budget.seconds = seconds,
                _ => {
                    return Err(format!(
                        "`{part}` is neither a time in s nor a size in MB or GB: write `60s`, `2GB` or `60s,2GB`"
                    ));
                }
            }
        }
        Ok(budget)
    }
}

impl Budget {
    /// The budget in units of work.
    pub fn units(self) -> u64 {
        // A float cast saturates, and NaN becomes 0.
        (self.seconds * UNITS_PER_SECOND) as u64
    }
}

/// The cost of deciding a certificate, without proofs between the nodes.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Estimate {
    pub units: u64,
    pub bytes: u64,
}

impl Estimate {
    /// Adds work (units) and memory (bytes), saturating.
    pub fn add(&mut self, units: u64, bytes: u64) {
        self.units = self.units.saturating_add(units);
        self.bytes = self.bytes.saturating_add(bytes);
    }

    /// The work in seconds, as [`UNITS_PER_SECOND`] counts them.
    pub fn seconds(self) -> f64 {
        self.units as f64 / UNITS_PER_SECOND
    }

    /// Whether work and memory are within the budget.
    pub fn fits(self, budget: Budget) -> bool {
        !exceeds(self.seconds(), budget.seconds) && self.bytes <= budget.bytes
    }
}

/// The remaining work, in units.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WorkLeft(pub u64);

impl WorkLeft {
    /// Takes units; `false` if there are too few, in which case none remain.
    pub fn spend(&mut self, units: u64) -> bool {
        match self.0.checked_sub(units) {
            Some(left) => {
                self.0 = left;
                true
            }
            None => {
                self.0 = 0;
                false
            }
        }
    }
}

/// `a * b`, saturating.
pub fn times(a: u64, b: u64) -> u64 {
    a.saturating_mul(b)
}
