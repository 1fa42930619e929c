//! Where the nose points, against where it should: the heading error, whole turns counted.

use super::body::Body;
use std::f64::consts::{PI, TAU};

/// Tilted further than this, rad (85 degrees), the nose may point straight up or down, where heading is undefined: the
/// last heading error is kept.
pub const DEFINED_UP_TO: f64 = 1.483_529_864_195_180_1;

/// The flown heading less the planned one, followed from look to look.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Heading {
    /// rad; whole turns count, so that a vehicle that has turned away once and came back is a turn off.
    turned: f64,
}

impl Heading {
    /// Takes in where the nose points now. `planned` is psi, rad. Between two looks the vehicle turns by less than half a
    /// turn against the plan, or turns are missed.
    pub fn look(&mut self, body: &Body, planned: f64) {
        if body.tilt() <= DEFINED_UP_TO {
            self.turned += wrapped(body.heading() - planned - self.turned);
        }
    }

    /// How far the vehicle has turned away from the planned heading, rad; counter-clockwise seen from above is positive.
    pub fn turned(&self) -> f64 {
        self.turned
    }

    /// The heading error, within half a turn of zero, rad.
    pub fn error(&self) -> f64 {
        wrapped(self.turned)
    }
}

/// An angle brought within half a turn of zero, rad.
pub fn wrapped(angle: f64) -> f64 {
    (angle + PI).rem_euclid(TAU) - PI
}

/// What a flight's heading errors come to.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct HeadingErrors {
    /// Root of the mean square, and largest, rad; at most half a turn.
    pub rms: f64,
    pub max: f64,
    /// Largest since the first fault, rad; 0 where there was none.
    pub max_after: f64,
    /// Most whole turns that the vehicle was away from the planned heading.
    pub turns: usize,
}

/// Collects them, one look after the other.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Collector {
    errors: HeadingErrors,
    squares: f64,
    looks: usize,
}

impl Collector {
    /// `after` where a fault has struck.
    pub fn add(&mut self, heading: &Heading, after: bool) {
        let error = heading.error().abs();
        self.squares += error * error;
        self.looks += 1;
        self.errors.max = self.errors.max.max(error);
        if after {
            self.errors.max_after = self.errors.max_after.max(error);
        }
        self.errors.turns = self.errors.turns.max((heading.turned().abs() / TAU) as usize);
    }

    pub fn errors(&self) -> HeadingErrors {
        HeadingErrors { rms: (self.squares / self.looks.max(1) as f64).sqrt(), ..self.errors }
    }
}

/// Decides when a heading error has lasted too long.
///
/// A vehicle that spins points the right way once a turn. So the seconds off are added up until the heading has been
/// kept again for as long as it may be off: neither a fast spin nor a slow one goes unnoticed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patience {
    /// Largest heading error that counts as kept, rad; `None`: any.
    limit: Option<f64>,
    /// s
    longest: f64,
    off_for: f64,
    kept_for: f64,
}

impl Patience {
    pub fn new(limit: Option<f64>, longest: f64) -> Self {
        Patience { limit, longest, off_for: 0.0, kept_for: 0.0 }
    }

    /// Whether a heading error, rad, is past the limit.
    pub fn is_off(&self, error: f64) -> bool {
        self.limit.is_some_and(|limit| error.abs() > limit)
    }

    /// Whether the heading counts as lost, once `period` more seconds have passed with this error, rad.
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
