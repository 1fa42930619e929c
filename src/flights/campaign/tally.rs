//! Counts and sums over a stream of rows; their number does not depend on the number of seeds.

use super::cases::{Case, Cases};
use super::path::{PathCell, PathSums};
use super::rows::{FlightOutcome, Row};
use super::statistics::{Delays, Moments};
use crate::flight::Cause;

/// Flights with the same plan, mode and instant.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Cell {
    pub flights: usize,
    /// Flights that were still flying when the fault struck.
    pub struck: usize,
    /// Struck flights that were not survived: lost or trespassed.
    pub lost: usize,
    /// Neither struck nor lost: their simulation diverged.
    pub diverged: usize,
    /// Over the struck flights.
    pub path: PathCell,
}

/// Flights with the same plan and mode, or without a fault.
#[derive(Debug, Clone, Default)]
pub struct Group {
    pub flights: usize,
    pub flown: usize,
    pub landed: usize,
    /// Not lost, but past the boundary of a volume.
    pub trespassed: usize,
    /// By [`Cause::ALL`].
    pub lost: [usize; Cause::ALL.len()],
    /// Flights whose simulation diverged: they count as not survived.
    pub diverged: usize,
    /// Lost before the fault could strike; counted in `lost` too.
    pub lost_before: usize,
    /// m, over the flights not lost: since the fault, or, without a fault, over the whole flight.
    pub rms_error: Moments,
    /// m, the same flights, over the whole flight.
    pub max_error: Moments,
    /// m, the same flights: since the fault, or, without a fault, over the whole flight.
    pub max_error_after: Moments,
    /// Largest heading error, rad, the same flights: since the fault, or, without a fault, over the whole flight.
    pub max_heading_error: Moments,
    /// s, over the flights in which it happened.
    pub detected_after: Moments,
    pub isolated_after: Moments,
    /// Over the flights that were struck.
    pub isolation: Delays,
    /// Time flown, s, over all flights, and the false alarms in it.
    pub seconds: f64,
    pub false_alarms: usize,
    pub refused: usize,
    /// What happened to the path, lost flights included.
    pub path: PathSums,
}

impl Group {
    /// False alarms in an hour of flight; `None` without any time.
    pub fn alarms_per_hour(&self) -> Option<f64> {
        (self.seconds > 0.0).then(|| 3600.0 * self.false_alarms as f64 / self.seconds)
    }

    /// Flights lost to any cause.
    pub fn all_lost(&self) -> usize {
        self.lost.iter().sum()
    }

    pub fn survived(&self) -> usize {
        self.flown + self.landed
    }

    /// Flights that were still flying when the fault struck.
    pub fn struck(&self) -> usize {
        self.flights - self.lost_before - self.diverged
    }

    fn add(&mut self, row: &Row) {
        self.flights += 1;
        match row.outcome {
            FlightOutcome::Flown => self.flown += 1,
            FlightOutcome::Landed => self.landed += 1,
            FlightOutcome::Trespassed => self.trespassed += 1,
            FlightOutcome::Lost(cause) => {
                let of_cause = Cause::ALL.iter().zip(&mut self.lost).filter(|(known, _)| **known == cause);
                of_cause.for_each(|(_, count)| *count += 1);
            }
            FlightOutcome::Diverged => self.diverged += 1,
        }
        self.lost_before += usize::from(row.is_lost_before());
        if row.is_survived() {
            self.rms_error.add(row.rms_error_after.unwrap_or(row.rms_error));
            self.max_error.add(row.max_error);
            self.max_error_after.add(row.max_error_after.unwrap_or(row.max_error));
            self.max_heading_error.add(row.max_heading_error_after.unwrap_or(row.max_heading_error));
        }
        row.detected_after.into_iter().for_each(|s| self.detected_after.add(s));
        row.isolated_after.into_iter().for_each(|s| self.isolated_after.add(s));
        if row.rms_error_after.is_some() {
            self.isolation.add(row.isolated_after);
        }
        self.seconds += row.end;
        self.false_alarms += row.false_alarms;
        self.refused += row.refused;
        self.path.add(row);
    }
}

/// The counts of a campaign or of a part of it.
#[derive(Debug, Clone)]
pub struct Tally {
    cases: Cases,
    /// Planner, then healthy and the modes.
    groups: Vec<Group>,
    /// Planner, mode, instant.
    cells: Vec<Cell>,
}

impl Tally {
    pub fn new(cases: Cases) -> Self {
        let Cases { planners, modes, times, .. } = cases;
        let groups = vec![Group::default(); planners * (1 + modes)];
        Tally { cases, groups, cells: vec![Cell::default(); planners * modes * times] }
    }

    /// Adds the row of a case.
    pub fn add(&mut self, case: &Case, row: &Row) {
        let mode = case.strike.map_or(0, |s| 1 + s.mode);
        self.groups[case.planner * (1 + self.cases.modes) + mode].add(row);
        if let Some(strike) = case.strike {
            let at = (case.planner * self.cases.modes + strike.mode) * self.cases.times + strike.time;
            let cell = &mut self.cells[at];
            let diverged = row.outcome == FlightOutcome::Diverged;
            let struck = !diverged && !row.is_lost_before();
            cell.flights += 1;
            cell.diverged += usize::from(diverged);
            cell.struck += usize::from(struck);
            cell.lost += usize::from(struck && !row.is_survived());
            if struck {
                cell.path.add(row);
            }
        }
    }

    pub fn flights(&self) -> usize {
        self.groups.iter().map(|g| g.flights).sum()
    }

    pub fn diverged(&self) -> usize {
        self.groups.iter().map(|g| g.diverged).sum()
    }

    pub fn healthy(&self, planner: usize) -> &Group {
        &self.groups[planner * (1 + self.cases.modes)]
    }

    pub fn mode(&self, planner: usize, mode: usize) -> &Group {
        &self.groups[planner * (1 + self.cases.modes) + 1 + mode]
    }

    /// One cell per instant.
    pub fn cells(&self, planner: usize, mode: usize) -> &[Cell] {
        let begin = (planner * self.cases.modes + mode) * self.cases.times;
        &self.cells[begin..begin + self.cases.times]
    }
}
