//! When a vehicle is lost, and how far it was from its place and heading until then.

use super::body::Body;
use super::heading::{Collector, Heading, HeadingErrors, Patience};
use super::reference::Reference;
use crate::model::Simulation;
use std::f64::consts::{FRAC_PI_2, PI};

/// A vehicle that lands touches the ground no faster than this, m/s, and tilted no further than this, rad.
const TOUCHDOWN_SPEED: f64 = 2.0;
const TOUCHDOWN_TILT: f64 = 0.5;

/// How a flight ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Outcome {
    /// To its end.
    Flown,
    /// It came down as it was to; s.
    Landed { at: f64 },
    Lost {
        at: f64,
        cause: Cause,
        /// It pointed or leaned too far away as the flight ended, however short it had been so.
        at_end: bool,
    },
    /// The integration broke down, first seen at `at`, s: a number was NaN or infinite, or the vehicle turned by more than
    /// half a turn in one step. What became of the vehicle is unknown.
    Diverged { at: f64 },
}

impl Outcome {
    pub fn is_lost(&self) -> bool {
        matches!(self, Outcome::Lost { .. })
    }

    /// Place, attitude and heading were kept to the end or the ground.
    pub fn is_survived(&self) -> bool {
        matches!(self, Outcome::Flown | Outcome::Landed { .. })
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cause {
    /// Farther from its place than `lost_beyond`.
    Position,
    /// Tilted past 90 degrees for longer than `upside_down`, or at the flight's end.
    UpsideDown,
    /// It struck the ground.
    Ground,
    /// Its heading was farther off than `lost_yaw`, for longer than `lost_yaw_after` or at the flight's end.
    Heading,
}

impl Cause {
    pub const ALL: [Cause; 4] = [Cause::Position, Cause::UpsideDown, Cause::Ground, Cause::Heading];

    pub fn name(self) -> &'static str {
        match self {
            Cause::Position => "position",
            Cause::UpsideDown => "upside_down",
            Cause::Ground => "ground",
            Cause::Heading => "heading",
        }
    }
}

/// Looks at the vehicle every `period` s.
#[derive(Debug, Clone)]
pub struct Watch {
    lost_beyond: f64,
    upside_down: f64,
    ground: f64,
    period: f64,
    /// rad/s; half a turn in one step of the integrator.
    fastest_turn: f64,
    /// Seconds upside down without a break.
    upside_down_for: f64,
    patience: Patience,
    pub heading: Heading,
    headings: Collector,
    /// A stop has begun.
    pub is_stopping: bool,
    /// It is to touch the ground.
    pub may_land: bool,
    pub max_error: f64,
    pub max_tilt: f64,
    squares: f64,
    looks: usize,
    squares_after: f64,
    looks_after: usize,
}

impl Watch {
    pub fn new(simulation: &Simulation, period: f64) -> Self {
        Watch {
            lost_beyond: simulation.lost_beyond,
            upside_down: simulation.upside_down,
            ground: simulation.ground,
            period,
            fastest_turn: PI * simulation.rate,
            upside_down_for: 0.0,
            patience: Patience::new(simulation.lost_yaw, simulation.lost_yaw_after),
            heading: Heading::default(),
            headings: Collector::default(),
            is_stopping: false,
            may_land: false,
            max_error: 0.0,
            max_tilt: 0.0,
            squares: 0.0,
            looks: 0,
            squares_after: 0.0,
            looks_after: 0,
        }
    }

    /// The flight's end where it has come; `after` where a fault has struck.
    pub fn look(&mut self, t: f64, body: &Body, reference: &Reference, after: bool) -> Option<Outcome> {
        let lost = |cause| Some(Outcome::Lost { at: t, cause, at_end: false });
        let error = (body.position - reference.position).norm();
        // The distance of finite numbers, or its square, may not be finite.
        let finite = body.is_finite() && reference.is_finite() && (self.squares + error * error).is_finite();
        if !finite || body.rates.norm() > self.fastest_turn {
            return Some(Outcome::Diverged { at: t });
        }
        let tilt = body.tilt();
        self.heading.look(body, reference.yaw[0]);
        self.max_error = self.max_error.max(error);
        self.max_tilt = self.max_tilt.max(tilt);
        if body.position.z <= self.ground {
            let soft = body.velocity.norm() <= TOUCHDOWN_SPEED && tilt <= TOUCHDOWN_TILT;
            return match (self.may_land && soft, self.patience.is_off(self.heading.error())) {
                (false, _) => lost(Cause::Ground),
                (true, true) => Some(Outcome::Lost { at: t, cause: Cause::Heading, at_end: true }),
                (true, false) => Some(Outcome::Landed { at: t }),
            };
        }
        self.headings.add(&self.heading, after);
        self.squares += error * error;
        self.looks += 1;
        if after {
            self.squares_after += error * error;
            self.looks_after += 1;
        }
        if error > self.lost_beyond {
            return lost(Cause::Position);
        }
        self.upside_down_for = if tilt > FRAC_PI_2 { self.upside_down_for + self.period } else { 0.0 };
        if self.upside_down_for > self.upside_down {
            return lost(Cause::UpsideDown);
        }
        if self.patience.is_over(self.heading.error(), self.period) { lost(Cause::Heading) } else { None }
    }

    /// What a flight that has come to its end ended in: a vehicle that points or leans too far away then has not kept its
    /// heading or attitude, however short it has been so.
    pub fn end(&self, t: f64, body: &Body) -> Outcome {
        let lost = |cause| Outcome::Lost { at: t, cause, at_end: true };
        match (body.tilt() > FRAC_PI_2, self.patience.is_off(self.heading.error())) {
            (true, _) => lost(Cause::UpsideDown),
            (false, true) => lost(Cause::Heading),
            (false, false) => Outcome::Flown,
        }
    }

    pub fn heading_errors(&self) -> HeadingErrors {
        self.headings.errors()
    }

    pub fn rms_error(&self) -> f64 {
        (self.squares / self.looks.max(1) as f64).sqrt()
    }

    pub fn rms_error_after(&self) -> f64 {
        (self.squares_after / self.looks_after.max(1) as f64).sqrt()
    }
}
