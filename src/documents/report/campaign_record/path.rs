//! What faults do to the path.

use crate::campaign::path::PathSums;
use crate::campaign::statistics::Summary;
use crate::flight::BrokenLimits;
use serde::Serialize;

/// The path since the fault, over all struck flights, lost ones included; without a fault over the whole flight.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PathRecord {
    /// Flights whose path was judged.
    pub flights: usize,
    /// Largest distance from the reference, m.
    pub deviation_m: Option<Summary>,
    /// Largest height below the reference, m; null without a fault.
    pub drop_m: Option<Summary>,
    /// Waypoints that were due, of all flights together.
    pub waypoints_due: usize,
    /// Those of them that were missed by more than their tolerance.
    pub waypoints_missed: usize,
    /// Flights that broke a limit.
    pub limits_broken: usize,
    /// The limits that were broken, in how many flights each.
    pub limits: Vec<LimitRecord>,
    /// Flights that broke the heading.
    pub heading_broken: usize,
}

/// A limit that was broken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LimitRecord {
    /// The limited quantity.
    #[cfg_attr(test, schemars(extend("enum" = BrokenLimits::all())))]
    pub limit: &'static str,
    /// Flights that broke it.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub flights: usize,
}

impl PathRecord {
    pub(super) fn new(path: &PathSums) -> Self {
        let counts = BrokenLimits::all().into_iter().zip(path.limits);
        PathRecord {
            flights: path.flights,
            deviation_m: path.deviation.summary(),
            drop_m: path.drop.summary(),
            waypoints_due: path.due,
            waypoints_missed: path.missed,
            limits_broken: path.any_limit,
            limits: counts
                .filter(|(_, flights)| *flights > 0)
                .map(|(limit, flights)| LimitRecord { limit, flights })
                .collect(),
            heading_broken: path.heading,
        }
    }
}
