//! Motors and rotors: speeds follow their commands with a first-order lag, thrust and drag follow the speeds, and
//! faults reduce both (`docs/flight.md`, section 1, "Motors").

use super::allocate::Belief;
use crate::actuation::{Actuation, Wrench};
use crate::model::{FaultMode, Spin, Vehicle};

/// The state of the n rotors of a vehicle in flight.
#[derive(Debug, Clone)]
pub struct Rotors {
    /// Columns of A: wrench per squared speed.
    columns: Vec<Wrench>,
    /// Moment of inertia of each rotor, kg m^2; below zero for one that turns clockwise. Empty if all are 0.
    inertia: Vec<f64>,
    /// Time constants, s.
    lag: Vec<f64>,
    /// Largest speeds, rad/s.
    pub max_speed: Vec<f64>,
    /// Factor by which the difference of speed and command decays in half a step: exp(-h / (2 time constant)).
    remaining: Vec<f64>,
    /// Present speeds, rad/s.
    pub speed: Vec<f64>,
    /// Commanded speeds, rad/s, within the bounds of the rotors.
    pub command: Vec<f64>,
    /// Capacity theta of (32) of each rotor, 0 to 1.
    pub capacity: Vec<f64>,
    /// Share of full thrust at which a rotor is stuck; `None` for a rotor that is not.
    pub stuck: Vec<Option<f64>>,
}

impl Rotors {
    /// Rotors at standstill without faults, for integration steps of `h` s.
    pub fn new(vehicle: &Vehicle, h: f64) -> Self {
        let rotors = &vehicle.rotors;
        let n = rotors.len();
        Rotors {
            columns: Actuation::of(vehicle).effectiveness.column_iter().map(nalgebra::Matrix::into_owned).collect(),
            inertia: match rotors.iter().all(|r| r.inertia == 0.0) {
                true => Vec::new(),
                false => rotors.iter().map(|r| if r.spin == Spin::P { r.inertia } else { -r.inertia }).collect(),
            },
            lag: rotors.iter().map(crate::model::Rotor::lag).collect(),
            max_speed: rotors.iter().map(|r| r.max_speed).collect(),
            remaining: rotors.iter().map(|r| (-0.5 * h / r.lag()).exp()).collect(),
            speed: vec![0.0; n],
            command: vec![0.0; n],
            capacity: vec![1.0; n],
            stuck: vec![None; n],
        }
    }

    /// Sets the speeds to the commands at once, as at the start of a flight.
    pub fn settle(&mut self) {
        self.speed.copy_from_slice(&self.command);
    }

    /// Applies the active fault modes. If several affect a rotor, the smallest capacity and the first share at which it
    /// is stuck hold. A stuck rotor takes its speed at once.
    pub fn set_faults<'a>(&mut self, active: impl Iterator<Item = &'a FaultMode>) {
        self.capacity.fill(1.0);
        self.stuck.fill(None);
        for mode in active {
            for (k, capacity) in self.capacity.iter_mut().enumerate() {
                *capacity = capacity.min(mode.rotors[k].capacity());
                self.stuck[k] = self.stuck[k].or(mode.rotors[k].stuck_at());
            }
        }
        for k in 0..self.speed.len() {
            if let Some(share) = self.stuck[k] {
                self.speed[k] = self.max_speed[k] * share.sqrt();
            }
        }
    }

    /// Replaces the commands of stuck rotors by the speeds that they have: what a log of the outputs shows.
    pub fn hold_stuck(&mut self) {
        for (k, stuck) in self.stuck.iter().enumerate() {
            if stuck.is_some() {
                self.command[k] = self.speed[k];
            }
        }
    }

    /// Advances the speeds by half a step of w' = (command - w) / time constant, in closed form.
    pub fn half_step(&mut self) {
        for (k, speed) in self.speed.iter_mut().enumerate() {
            if self.stuck[k].is_none() {
                let difference = (*speed - self.command[k]) * self.remaining[k];
                // The decay is cut off here, because arithmetic with subnormal numbers is slow.
                *speed = if difference.abs() < 1e-12 { self.command[k] } else { self.command[k] + difference };
            }
        }
    }

    /// The wrench A diag(theta) Omega_s of (32), N and N m, with the reaction to rotors whose speed changes.
    pub fn wrench(&self) -> Wrench {
        let rotors = self.columns.iter().zip(&self.capacity).zip(&self.speed);
        let mut wrench = rotors.fold(Wrench::zeros(), |sum, ((column, theta), w)| sum + column * (theta * w * w.abs()));
        for (k, inertia) in self.inertia.iter().enumerate() {
            if self.stuck[k].is_none() && self.capacity[k] > 0.0 {
                wrench[3] -= inertia * (self.command[k] - self.speed[k]) / self.lag[k];
            }
        }
        wrench
    }

    /// The yaw torque (N m) and the momentum about z (N m s) of rotors with the capacities of a belief that keep the
    /// speeds (rad/s) which `command` writes.
    pub(super) fn steady(vehicle: &Vehicle, belief: &Belief, command: impl FnOnce(&mut [f64])) -> (f64, f64) {
        let mut rotors = Rotors::new(vehicle, 1.0);
        rotors.capacity.copy_from_slice(&belief.capacity);
        command(&mut rotors.command);
        rotors.settle();
        (rotors.wrench()[3], rotors.momentum())
    }

    /// The momentum of the rotors about z, N m s. A lost rotor stands still.
    pub fn momentum(&self) -> f64 {
        let turning = |(k, inertia): (usize, &f64)| if self.capacity[k] > 0.0 { inertia * self.speed[k] } else { 0.0 };
        self.inertia.iter().enumerate().map(turning).sum()
    }
}
