//! The heading error, with whole turns counted (`docs/flight.md`, section 5).

use super::body::Body;
use crate::model::LostYaw;
use std::f64::consts::{PI, TAU};

/// The tilt, rad (85 degrees), beyond which the nose may point straight up or down, where the heading is not defined.
/// Beyond it the last heading error is kept.
pub const DEFINED_UP_TO: f64 = 1.483_529_864_195_180_1;

/// The flown heading minus the planned one, tracked from sample to sample.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Heading {
    /// rad; whole turns count, so that a vehicle that has made one turn relative to the plan is off by a turn.
    turned: f64,
}

impl Heading {
    /// Updates the heading with the body and the planned psi (rad) at a sample. Between two samples the heading error
    /// must change by less than half a turn, or turns are missed.
    pub fn look(&mut self, body: &Body, planned: f64) {
        if body.tilt() <= DEFINED_UP_TO {
            self.turned += wrapped(body.heading() - planned - self.turned);
        }
    }

    /// The angle by which the vehicle has turned away from the planned heading, whole turns included, rad; positive
    /// counter-clockwise seen from above.
    pub fn turned(&self) -> f64 {
        self.turned
    }

    /// The heading error between -pi and pi, rad.
    pub fn error(&self) -> f64 {
        wrapped(self.turned)
    }
}

/// The angle (rad) plus a multiple of a full turn such that it lies between -pi and pi.
pub fn wrapped(angle: f64) -> f64 {
    (angle + PI).rem_euclid(TAU) - PI
}

/// Statistics of the heading error over a flight.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct HeadingErrors {
    /// Root mean square, rad; at most pi.
    pub rms: f64,
    /// Largest absolute value, rad; at most pi.
    pub max: f64,
    /// Largest absolute value since the first fault, rad; 0 without a fault.
    pub max_after: f64,
    /// The largest number of whole turns by which the vehicle was away from the planned heading.
    pub turns: usize,
}

/// Accumulates [`HeadingErrors`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Collector {
    errors: HeadingErrors,
    squares: f64,
    samples: usize,
}

impl Collector {
    /// Adds a sample; `after` is whether a fault has struck.
    pub(super) fn add(&mut self, heading: &Heading, after: bool) {
        let error = heading.error().abs();
        self.squares += error * error;
        self.samples += 1;
        self.errors.max = self.errors.max.max(error);
        if after {
            self.errors.max_after = self.errors.max_after.max(error);
        }
        self.errors.turns = self.errors.turns.max((heading.turned().abs() / TAU) as usize);
    }

    /// The statistics of the samples so far.
    pub(super) fn errors(&self) -> HeadingErrors {
        HeadingErrors { rms: (self.squares / self.samples.max(1) as f64).sqrt(), ..self.errors }
    }
}

/// Decides whether a heading error has lasted too long.
///
/// A vehicle that spins points in the right direction once a turn. Therefore the time beyond the limit is added up
/// until the heading has been kept without a break for longer than it may be off. This notices fast spins as well as
/// slow ones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patience {
    limit: LostYaw,
    /// Time for which the heading may be off, s.
    longest: f64,
    off_for: f64,
    kept_for: f64,
}

impl Patience {
    /// `longest` is the time for which the heading may be off, s.
    pub fn new(limit: LostYaw, longest: f64) -> Self {
        Patience { limit, longest, off_for: 0.0, kept_for: 0.0 }
    }

    /// Whether a heading error (rad) exceeds the limit.
    pub(super) fn is_off(&self, error: f64) -> bool {
        match self.limit {
            LostYaw::Off => false,
            LostYaw::Beyond(limit) => error.abs() > limit,
        }
    }

    /// Whether the heading counts as lost after another `period` s with this error (rad).
    pub fn is_over(&mut self, error: f64, period: f64) -> bool {
        if self.is_off(error) {
            self.off_for += period;
            self.kept_for = 0.0;
        } else {
            self.kept_for += period;
            if self.kept_for > self.longest {
                self.off_for = 0.0;
            }
        }
        self.off_for > self.longest
    }
}
