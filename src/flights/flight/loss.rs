//! When a vehicle is lost, and its errors of position and heading until then (`docs/flight.md`, section 5).

use super::Sortie;
use super::body::Body;
use super::damage::{self, Damage, Errors};
use super::heading::{Collector, Heading, HeadingErrors, Patience};
use super::reference::Reference;
use super::volumes::Volumes;
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, PI};

/// A vehicle lands if it touches the ground no faster than this (m/s) and with no more than this tilt (rad).
const TOUCHDOWN_SPEED: f64 = 2.0;
const TOUCHDOWN_TILT: f64 = 0.5;

/// How a flight ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Outcome {
    /// The vehicle kept position, attitude and heading to the end of the flight.
    Flown,
    /// The vehicle landed as intended.
    Landed {
        /// s since the start.
        at: f64,
        /// Where it touched the ground, m.
        place: [f64; 3],
        /// Its speed just before, m/s.
        speed: f64,
    },
    /// The vehicle was not lost, but it entered a `keep_out` or left a `keep_in` ([`super::volumes::PAST_BOUNDARY`]).
    Trespassed {
        /// When it first did, s since the start.
        at: f64,
    },
    /// The vehicle was lost.
    Lost {
        /// s since the start.
        at: f64,
        /// The limit that was exceeded.
        cause: Cause,
        /// Whether heading or attitude was beyond its limit only at the end of the flight, for however short a time.
        at_end: bool,
    },
    /// The integration broke down: a number was NaN or infinite, or the vehicle turned by more than half a turn in one
    /// step. Whether the vehicle survived is unknown.
    Diverged {
        /// When this was first observed, s since the start.
        at: f64,
    },
}

impl Outcome {
    /// Whether the vehicle was lost.
    pub fn is_lost(&self) -> bool {
        matches!(self, Outcome::Lost { .. })
    }

    /// Whether position, attitude, heading and the volumes were kept to the end of the flight or to a landing.
    pub fn is_survived(&self) -> bool {
        matches!(self, Outcome::Flown | Outcome::Landed { .. })
    }
}

/// Why a vehicle was lost.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cause {
    /// It was farther than `lost_beyond` from the reference position.
    Position,
    /// It was tilted by more than 90 degrees for longer than `upside_down`, or at the end of the flight.
    UpsideDown,
    /// It hit the ground.
    Ground,
    /// Its heading error exceeded `lost_yaw` for longer than `lost_yaw_after`, or at the end of the flight.
    Heading,
}

impl Cause {
    /// All causes, in the order of reports.
    pub const ALL: [Cause; 4] = [Cause::Position, Cause::UpsideDown, Cause::Ground, Cause::Heading];

    /// The name in tables and JSON.
    pub fn name(self) -> &'static str {
        match self {
            Cause::Position => "position",
            Cause::UpsideDown => "upside_down",
            Cause::Ground => "ground",
            Cause::Heading => "heading",
        }
    }
}

/// Monitors the vehicle every `period` s.
#[derive(Debug, Clone)]
pub(super) struct Watch<'a> {
    lost_beyond: f64,
    upside_down: f64,
    ground: f64,
    period: f64,
    /// The body rate of half a turn in one step of the integrator, rad/s.
    fastest_turn: f64,
    /// For how long the vehicle has been upside down without a break, s.
    upside_down_for: f64,
    patience: Patience,
    pub(super) heading: Heading,
    headings: Collector,
    damage: damage::Collector<'a>,
    pub(super) volumes: Volumes,
    /// When the vehicle was first past the boundary of a volume, s.
    trespassed_at: Option<f64>,
    /// Whether a stop has begun.
    pub(super) is_stopping: bool,
    /// Whether yaw has been given up on purpose, so that the heading error loses no vehicle.
    pub(super) gave_up_yaw: bool,
    /// Whether the vehicle may touch the ground.
    may_land: bool,
    /// From when on the ground is where a way out lands, s, and its z, m.
    pad: Option<(f64, f64)>,
    /// Largest distance from the reference position, m.
    pub(super) max_error: f64,
    /// Largest tilt, rad.
    pub(super) max_tilt: f64,
    /// Sum of the squared position errors (m^2) and number of samples, over the flight and since the first fault.
    squares: f64,
    samples: usize,
    squares_after: f64,
    samples_after: usize,
}

impl<'a> Watch<'a> {
    pub(super) fn new(sortie: &Sortie<'a>, period: f64) -> Self {
        let simulation = sortie.simulation;
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
            damage: damage::Collector::new(sortie),
            volumes: Volumes::of(sortie.mission, &sortie.model.vehicle, simulation.ground),
            trespassed_at: None,
            is_stopping: false,
            gave_up_yaw: false,
            may_land: false,
            pad: None,
            max_error: 0.0,
            max_tilt: 0.0,
            squares: 0.0,
            samples: 0,
            squares_after: 0.0,
            samples_after: 0,
        }
    }

    /// A stop begins at `t` s, which ends in a landing if it `lands`.
    pub(super) fn stop(&mut self, t: f64, lands: bool) {
        self.is_stopping = true;
        self.may_land = lands;
        self.damage.stop(t);
    }

    /// A way out begins at `t` s that has come to rest on the ground at `ends` s, at a height of `z` m; from then on
    /// the ground is there.
    pub(super) fn land(&mut self, t: f64, ends: f64, z: f64) {
        self.stop(t, true);
        self.pad = Some((ends, z));
    }

    /// Processes a sample at time `t` (s); `after` is whether a fault has struck, and `acceleration` gives that of the
    /// body, m/s^2. Returns the outcome if the flight ends here.
    pub(super) fn look(
        &mut self,
        t: f64,
        body: &Body,
        reference: &Reference,
        after: bool,
        acceleration: impl FnOnce() -> Vector3<f64>,
    ) -> Option<Outcome> {
        let lost = |cause| Some(Outcome::Lost { at: t, cause, at_end: false });
        let error = (body.position - reference.position).norm();
        // The distance of finite positions, or its square, may overflow.
        let finite = body.is_finite() && reference.is_finite() && (self.squares + error * error).is_finite();
        if !finite || body.rates.norm() > self.fastest_turn {
            return Some(Outcome::Diverged { at: t });
        }
        let tilt = body.tilt();
        self.heading.look(body, reference.yaw[0]);
        self.max_error = self.max_error.max(error);
        self.max_tilt = self.max_tilt.max(tilt);
        let heading = (!self.gave_up_yaw).then(|| self.heading.error());
        self.damage.look(t, body, reference, Errors { position: error, tilt, heading }, acceleration);
        if self.trespassed_at.is_none() && self.volumes.is_past(&body.position, self.may_land) {
            self.trespassed_at = Some(t);
        }
        let ground = self.pad.filter(|(from, _)| t >= *from).map_or(self.ground, |(_, z)| z.max(self.ground));
        if body.position.z <= ground {
            let soft = body.velocity.norm() <= TOUCHDOWN_SPEED && tilt <= TOUCHDOWN_TILT;
            return match (self.may_land && soft, self.is_off_its_heading()) {
                (false, _) => lost(Cause::Ground),
                (true, true) => Some(Outcome::Lost { at: t, cause: Cause::Heading, at_end: true }),
                (true, false) => {
                    let (place, speed) = (body.position.into(), body.velocity.norm());
                    Some(self.unless_trespassed(Outcome::Landed { at: t, place, speed }))
                }
            };
        }
        self.headings.add(&self.heading, after);
        self.squares += error * error;
        self.samples += 1;
        if after {
            self.squares_after += error * error;
            self.samples_after += 1;
        }
        if error > self.lost_beyond {
            return lost(Cause::Position);
        }
        self.upside_down_for = if tilt > FRAC_PI_2 { self.upside_down_for + self.period } else { 0.0 };
        if self.upside_down_for > self.upside_down {
            return lost(Cause::UpsideDown);
        }
        if self.gave_up_yaw {
            return None;
        }
        if self.patience.is_over(self.heading.error(), self.period) { lost(Cause::Heading) } else { None }
    }

    /// Whether the heading error alone would lose the vehicle now.
    fn is_off_its_heading(&self) -> bool {
        !self.gave_up_yaw && self.patience.is_off(self.heading.error())
    }

    /// The outcome of a flight whose duration has elapsed. A vehicle that is upside down or off its heading now is
    /// lost, for however short a time it has been so.
    pub(super) fn end(&self, t: f64, body: &Body) -> Outcome {
        let lost = |cause| Outcome::Lost { at: t, cause, at_end: true };
        match (body.tilt() > FRAC_PI_2, self.is_off_its_heading()) {
            (true, _) => lost(Cause::UpsideDown),
            (false, true) => lost(Cause::Heading),
            (false, false) => self.unless_trespassed(Outcome::Flown),
        }
    }

    fn unless_trespassed(&self, outcome: Outcome) -> Outcome {
        self.trespassed_at.map_or(outcome, |at| Outcome::Trespassed { at })
    }

    pub(super) fn heading_errors(&self) -> HeadingErrors {
        self.headings.errors()
    }

    /// What happened to the path of a flight that ended at `end` s.
    pub(super) fn damage(&mut self, end: f64, is_lost: bool) -> Damage {
        self.damage.finish(end, is_lost)
    }

    /// Root mean square of the position error, m.
    pub(super) fn rms_error(&self) -> f64 {
        (self.squares / self.samples.max(1) as f64).sqrt()
    }

    /// Root mean square of the position error since the first fault, m.
    pub(super) fn rms_error_after(&self) -> f64 {
        (self.squares_after / self.samples_after.max(1) as f64).sqrt()
    }
}
