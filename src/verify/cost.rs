//! What a certificate costs to decide, bounded from its size before any work begins, and the budget it has to fit.
//!
//! Work is counted in units, never in time, so that the same certificate has the same verdict on every machine. The weights
//! below are chosen so that the bound is not too low: for four shipped specs it was 2 to 40 times the time that the check
//! at the nodes took (docs/certificates.md, *Cost*).

use super::interval::exceeds;

/// Units of work that the budget counts as one second.
pub const UNITS_PER_SECOND: f64 = 1e7;

/// Units of evaluating one bounding plane of a set, or one side of a limit, at one state.
pub const OF_A_ROW: u64 = 1;

/// Units of one state of a motion with its wrench, in the hover and the exact model, and of one for limits alone.
pub const OF_HOVER_WRENCH: u64 = 20;
pub const OF_EXACT_WRENCH: u64 = 100;
pub const OF_A_LIMIT: u64 = 10;

/// Units of a joint between two pieces.
pub const OF_A_JOINT: u64 = 50;

/// Units of a plane in exact arithmetic: the vector orthogonal to three, and its support.
pub const OF_A_PLANE: u64 = 300;

/// Units of a multiplier's row, and of carrying one node's derivatives back to the one before.
pub const OF_A_MULTIPLIER: u64 = 20;
pub const OF_A_NODE_CARRIED: u64 = 100;

/// Bytes of a plane, of a node of a motion and of a multiplier, with what the allocator adds.
pub const BYTES_OF_A_PLANE: u64 = 256;
pub const BYTES_OF_A_NODE: u64 = 1024;
pub const BYTES_OF_A_MULTIPLIER: u64 = 160;

/// What one decision may cost.
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

impl Budget {
    /// Units of work.
    pub fn units(self) -> u64 {
        // A float cast saturates, and NaN is no budget at all.
        (self.seconds * UNITS_PER_SECOND) as u64
    }
}

/// What a certificate will cost at the least: the work that decides it, without proofs between the nodes.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Estimate {
    pub units: u64,
    pub bytes: u64,
}

impl Estimate {
    pub fn add(&mut self, units: u64, bytes: u64) {
        self.units = self.units.saturating_add(units);
        self.bytes = self.bytes.saturating_add(bytes);
    }

    pub fn seconds(self) -> f64 {
        self.units as f64 / UNITS_PER_SECOND
    }

    pub fn fits(self, budget: Budget) -> bool {
        !exceeds(self.seconds(), budget.seconds) && self.bytes <= budget.bytes
    }
}

/// Work that is left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Purse(pub u64);

impl Purse {
    /// Takes units; `false` where there are too few, and then nothing is left.
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

/// `a * b`, or as much as there is.
pub fn times(a: u64, b: u64) -> u64 {
    a.saturating_mul(b)
}
