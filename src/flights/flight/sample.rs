//! The state of a flight at an instant, which is recorded.

use super::body::Body;
use super::heading::Heading;
use super::knowledge::Knowledge;
use super::reference::Reference;
use super::rotors::Rotors;
use crate::actuation::Wrench;
use nalgebra::Vector3;

/// The state of a flight at an instant.
#[derive(Debug, Clone, Copy)]
pub struct Sample<'a> {
    /// Time since the start, s.
    pub time: f64,
    /// The true state of the rigid body.
    pub body: &'a Body,
    /// The reference that the controller follows.
    pub reference: &'a Reference,
    /// The deviation of the vehicle's heading from that of the reference.
    pub heading: Heading,
    /// The wrench that the rotors produce, N and N m.
    pub wrench: &'a Wrench,
    /// The wrench that the controller demands, N and N m.
    pub wanted: &'a Wrench,
    /// The speed of each rotor, rad/s.
    pub speeds: &'a [f64],
    /// The commanded speed of each rotor, rad/s; of a stuck rotor the speed at which it is.
    pub commands: &'a [f64],
    /// What the vehicle's gyroscope and accelerometer read.
    pub inertial: Inertial,
    /// The capacity theta of each rotor that the allocation uses.
    pub believed: &'a [f64],
    /// The capacity theta of each rotor as estimated; `believed` without an estimator.
    pub estimated: &'a [f64],
    /// Rank and condition number of the estimator's regressor, updated ten times a second.
    pub regressor: Option<(usize, f64)>,
    /// Whether this is the last sample of the flight.
    pub is_last: bool,
}

/// Readings of gyroscope and accelerometer, body frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inertial {
    /// Body rates, rad/s, with the noise and the range of the gyroscope.
    pub rates: Vector3<f64>,
    /// Specific force of the centre of gravity, m/s^2; without noise, as a spec gives none.
    pub force: Vector3<f64>,
}

impl Sample<'_> {
    /// Whether every number is finite.
    pub(super) fn is_finite(&self) -> bool {
        let wrenches = self.wrench.iter().chain(self.wanted);
        let rotors = self.speeds.iter().chain(self.believed).chain(self.estimated);
        self.body.is_finite() && self.reference.is_finite() && wrenches.chain(rotors).all(|x| x.is_finite())
    }
}

/// The parts of a sample that belong neither to the rotors nor to the knowledge of faults.
pub(super) struct View<'a> {
    pub body: &'a Body,
    pub reference: &'a Reference,
    pub heading: Heading,
    pub wrench: &'a Wrench,
    pub wanted: &'a Wrench,
    pub inertial: Inertial,
}

impl<'a> View<'a> {
    pub fn sample(
        self,
        time: f64,
        rotors: &'a Rotors,
        knowledge: &'a Knowledge,
        regressor: Option<&(usize, f64)>,
        is_last: bool,
    ) -> Sample<'a> {
        let View { body, reference, heading, wrench, wanted, inertial } = self;
        Sample {
            time,
            body,
            reference,
            heading,
            wrench,
            wanted,
            speeds: &rotors.speed,
            commands: &rotors.command,
            inertial,
            believed: &knowledge.belief.capacity,
            estimated: knowledge.estimated(),
            regressor: regressor.copied(),
            is_last,
        }
    }
}
