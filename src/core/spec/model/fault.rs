//! Fault modes: what a fault leaves of each rotor. CONTRIBUTING ("A new kind of limit or of fault") lists what a kind
//! needs.

use super::{AfterFault, GiveUpYaw, Recovery, Spread};
use crate::source::Span;

/// What a fault leaves of a rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RotorState {
    /// Not affected.
    Sound,
    /// It gives this share of the thrust and torque that belong to its speed; between 0 and 1.
    Reduced(f64),
    /// Its thrust stays at this share of full thrust, 0 to 1.
    Stuck(f64),
    /// It gives nothing.
    Lost,
}

impl RotorState {
    /// The state with the capacity theta of the paper's (32), 0 to 1.
    pub fn of_capacity(theta: f64) -> Self {
        match theta {
            0.0 => RotorState::Lost,
            1.0 => RotorState::Sound,
            share => RotorState::Reduced(share),
        }
    }

    /// The capacity theta of (32), with which the rotor gives theta b w^2 at a speed w; 1 for a stuck rotor, whose
    /// speed is what the fault determines.
    pub fn capacity(self) -> f64 {
        match self {
            RotorState::Sound | RotorState::Stuck(_) => 1.0,
            RotorState::Reduced(share) => share,
            RotorState::Lost => 0.0,
        }
    }

    /// The share of full thrust, 0 to 1, at which the rotor is stuck; `None` if it is not.
    pub fn stuck_at(self) -> Option<f64> {
        match self {
            RotorState::Stuck(share) => Some(share),
            RotorState::Sound | RotorState::Reduced(_) | RotorState::Lost => None,
        }
    }
}

/// A fault mode: what it leaves of each rotor.
#[derive(Debug, Clone, PartialEq)]
pub struct FaultMode {
    pub name: String,
    pub title: Option<String>,
    pub doc: Option<String>,
    /// In the order of [`super::Vehicle::rotors`].
    pub rotors: Vec<RotorState>,
    /// FMEA numbers, 1..10.
    pub severity: Option<u8>,
    pub occurrence: Option<u8>,
    pub detection: Option<u8>,
    /// Failure rate, 1/s.
    pub rate: Option<f64>,
    /// The interval of the rate, relative to its middle.
    pub rate_spread: Spread,
    /// The mode's own reaction to the fault, if it gives one: see [`super::Model::after_fault`].
    pub after_fault: Option<AfterFault>,
    /// Whether yaw is given up after this fault, if the mode says so: see [`super::Model::gives_up_yaw`].
    pub without_yaw: Option<GiveUpYaw>,
    /// The mode's own ways out after the fault, if it gives them: see [`super::Model::recovery`].
    pub recovery: Option<Vec<Recovery>>,
    pub span: Span,
}

impl FaultMode {
    /// The numbers of the lost rotors, counted from 1.
    pub fn lost(&self) -> Vec<usize> {
        (1..=self.rotors.len()).filter(|k| self.rotors[k - 1] == RotorState::Lost).collect()
    }

    /// The capacity of each rotor: [`RotorState::capacity`].
    pub fn capacities(&self) -> Vec<f64> {
        self.rotors.iter().map(|rotor| rotor.capacity()).collect()
    }

    /// Where each rotor is stuck: [`RotorState::stuck_at`].
    pub fn stuck(&self) -> Vec<Option<f64>> {
        self.rotors.iter().map(|rotor| rotor.stuck_at()).collect()
    }

    /// Whether some rotor is stuck.
    pub fn has_stuck(&self) -> bool {
        self.rotors.iter().any(|rotor| rotor.stuck_at().is_some())
    }

    /// Risk priority number, severity x occurrence x detection, if all three are given.
    pub fn rpn(&self) -> Option<u32> {
        Some(u32::from(self.severity?) * u32::from(self.occurrence?) * u32::from(self.detection?))
    }
}
