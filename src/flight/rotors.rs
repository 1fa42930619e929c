//! Motors and rotors: speeds follow their commands, thrust and drag follow the speeds, faults take their share.

use crate::actuation::{Actuation, Wrench};
use crate::model::{FaultMode, Model};

/// The rotors of a vehicle in flight.
#[derive(Debug, Clone)]
pub struct Rotors {
    /// Columns of A, per squared speed.
    columns: Vec<Wrench>,
    /// rad/s
    pub max_speed: Vec<f64>,
    /// What is left of a difference to the command after half a step: exp(-h / (2 time constant)).
    remaining: Vec<f64>,
    /// rad/s
    pub speed: Vec<f64>,
    /// Commanded speeds, rad/s, within what the rotors can turn.
    pub command: Vec<f64>,
    /// theta of (32).
    pub capacity: Vec<f64>,
    /// Share of full thrust at which a rotor is stuck.
    pub stuck: Vec<Option<f64>>,
}

impl Rotors {
    /// At rest, for steps of `h` s.
    pub fn new(model: &Model, h: f64) -> Self {
        let rotors = &model.vehicle.rotors;
        let n = rotors.len();
        Rotors {
            columns: Actuation::of(&model.vehicle)
                .effectiveness
                .column_iter()
                .map(nalgebra::Matrix::into_owned)
                .collect(),
            max_speed: rotors.iter().map(|r| r.max_speed).collect(),
            remaining: rotors.iter().map(|r| (-0.5 * h / r.lag()).exp()).collect(),
            speed: vec![0.0; n],
            command: vec![0.0; n],
            capacity: vec![1.0; n],
            stuck: vec![None; n],
        }
    }

    /// Takes on the commands at once, as where a flight begins.
    pub fn settle(&mut self) {
        self.speed.copy_from_slice(&self.command);
    }

    /// Capacities and stuck rotors of the modes that are active: of several the smallest capacity holds, and a stuck
    /// rotor stays stuck.
    pub fn set_faults<'a>(&mut self, active: impl Iterator<Item = &'a FaultMode>) {
        self.capacity.fill(1.0);
        self.stuck.fill(None);
        for mode in active {
            for (k, capacity) in self.capacity.iter_mut().enumerate() {
                *capacity = capacity.min(mode.capacity[k]);
                self.stuck[k] = self.stuck[k].or(mode.stuck[k]);
            }
        }
        for k in 0..self.speed.len() {
            if let Some(share) = self.stuck[k] {
                self.speed[k] = self.max_speed[k] * share.sqrt();
            }
        }
    }

    /// Lets half a step pass: w' = (command - w) / time constant in closed form, the motor of (85).
    pub fn half_step(&mut self) {
        for (k, speed) in self.speed.iter_mut().enumerate() {
            if self.stuck[k].is_none() {
                let difference = (*speed - self.command[k]) * self.remaining[k];
                // What fades for ever ends here: numbers near the smallest are slow to compute with.
                *speed = if difference.abs() < 1e-12 { self.command[k] } else { self.command[k] + difference };
            }
        }
    }

    /// A diag(theta) Omega_s of (32).
    pub fn wrench(&self) -> Wrench {
        let rotors = self.columns.iter().zip(&self.capacity).zip(&self.speed);
        rotors.fold(Wrench::zeros(), |sum, ((column, theta), w)| sum + column * (theta * w * w))
    }
}
