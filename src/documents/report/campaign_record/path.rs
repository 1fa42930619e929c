//! What faults do to the path.

use crate::campaign::path::PathSums;
use crate::campaign::statistics::Summary;
use crate::flight::BrokenLimits;
use serde::Serialize;

/// The path since the fault, over all struck flights, lost ones included; without a fault over the whole flight.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PathRecord {
    /// Flights whose path was judged.
    pub flights: usize,
    /// Largest distance from the reference.
    pub deviation_m: Option<Summary>,
    /// Largest height below the reference; `None` without a fault.
    pub drop_m: Option<Summary>,
    pub waypoints_due: usize,
    pub waypoints_missed: usize,
    /// Flights that broke a limit, and each of the limits that were broken.
    pub limits_broken: usize,
    pub limits: Vec<LimitRecord>,
    /// Flights that broke the heading.
    pub heading_broken: usize,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct LimitRecord {
    pub limit: &'static str,
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
