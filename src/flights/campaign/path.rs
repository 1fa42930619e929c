//! What faults do to the path: sums over flights.

use super::rows::{FlightOutcome, Row};
use super::statistics::Moments;
use crate::flight::BrokenLimits;

/// Sums over the flights that were struck, lost ones included, or over all flights without a fault. Flights that
/// diverged are left out.
#[derive(Debug, Clone, Default)]
pub struct PathSums {
    pub flights: usize,
    /// Largest distance from the reference, m, since the fault or over the whole flight. A flight that is lost is
    /// followed until then.
    pub deviation: Moments,
    /// Largest height below the reference since the fault, m; without a fault there is none.
    pub drop: Moments,
    pub due: usize,
    pub missed: usize,
    /// Flights that broke each limit of [`BrokenLimits::all`], and any of them.
    pub limits: [usize; BrokenLimits::COUNT],
    pub any_limit: usize,
    pub heading: usize,
}

impl PathSums {
    /// Adds a flight, if its path was judged.
    pub fn add(&mut self, row: &Row) {
        let Some(path) = row.path.filter(|_| row.outcome != FlightOutcome::Diverged) else { return };
        self.flights += 1;
        self.deviation.add(row.max_error_after.unwrap_or(row.max_error));
        row.max_drop_after.into_iter().for_each(|drop| self.drop.add(drop));
        self.due += path.due;
        self.missed += path.missed;
        (0..BrokenLimits::COUNT).for_each(|k| self.limits[k] += usize::from(path.limits.has(k)));
        self.any_limit += usize::from(path.limits.any());
        self.heading += usize::from(path.heading_broken);
    }
}

/// The path errors of one instant of the fault, in little memory.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PathCell {
    /// Sum of the largest distances from the reference, m.
    pub deviation: f64,
    pub due: usize,
    pub missed: usize,
    /// Flights that broke a limit.
    pub limits: usize,
    pub heading: usize,
}

impl PathCell {
    /// Adds a struck flight.
    pub fn add(&mut self, row: &Row) {
        let Some(path) = row.path else { return };
        self.deviation += row.max_error_after.unwrap_or(row.max_error);
        self.due += path.due;
        self.missed += path.missed;
        self.limits += usize::from(path.limits.any());
        self.heading += usize::from(path.heading_broken);
    }
}
