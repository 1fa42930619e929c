//! What faults do to the path: sums over flights, and the measures by which plans are compared.

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

/// How much a path suffers: each is a mean over the struck flights of a plan and a mode, lost flights included.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Harm {
    /// Share of the flights that were lost.
    Lost,
    /// Mean of the largest distances from the reference since the fault, m.
    Deviation,
    /// Share of the due waypoints that were missed, less the share that flights without a fault miss: a plan that uses
    /// up the tolerance of a waypoint misses it by any tracking error.
    WaypointsMissed,
    /// Share of the flights that broke a limit.
    LimitsBroken,
    /// Share of the flights that broke the heading.
    HeadingBroken,
}

impl Harm {
    pub const ALL: [Harm; 5] =
        [Harm::Lost, Harm::Deviation, Harm::WaypointsMissed, Harm::LimitsBroken, Harm::HeadingBroken];

    /// Its name in tables.
    pub fn words(self) -> &'static str {
        match self {
            Harm::Lost => "flights lost",
            Harm::Deviation => "deviation",
            Harm::WaypointsMissed => "waypoints missed",
            Harm::LimitsBroken => "limits broken",
            Harm::HeadingBroken => "heading broken",
        }
    }

    /// Its value for the flights of `path`, of which `lost` were lost, along a plan whose flights without a fault are
    /// `healthy`; `None` without flights, or without a waypoint that was due.
    pub fn of(self, path: &PathSums, lost: usize, healthy: &PathSums) -> Option<f64> {
        let share = |count: usize, of: usize| (of > 0).then(|| count as f64 / of as f64);
        match self {
            Harm::Lost => share(lost, path.flights),
            Harm::Deviation => path.deviation.summary().map(|s| s.mean),
            Harm::WaypointsMissed => Some(share(path.missed, path.due)? - share(healthy.missed, healthy.due)?),
            Harm::LimitsBroken => share(path.any_limit, path.flights),
            Harm::HeadingBroken => share(path.heading, path.flights),
        }
    }
}
