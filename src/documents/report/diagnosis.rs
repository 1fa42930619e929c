//! What `mavc diagnose` says of a log: the answer on one screen, and its record.

#[cfg(feature = "report")]
mod page;
mod record;
mod text;
mod why;

#[cfg(feature = "report")]
pub use page::page;
pub use record::DiagnosisRecord;
pub use text::screen;

use crate::admissible::AdmissibleSet;
use crate::admissible::verdict::ModeAnalysis;
use crate::diagnosis::aftermath::Aftermath;
use crate::diagnosis::record::Autopilot;
use crate::diagnosis::study::Study;
use crate::model::Model;

/// The answer to a log.
#[derive(Debug, Clone)]
pub struct Diagnosis {
    pub autopilot: Autopilot,
    /// The vehicle: of the log's frame, or of the spec beside it. Its rotors are in the spec's order.
    pub model: Model,
    /// The log's motor (from 0) of each rotor of the model.
    pub motors: Vec<usize>,
    /// What the log says; `None` if it is too slow.
    pub study: Option<Study>,
    /// After each loss, in their order: what all losses until then leave of the vehicle.
    pub after: Vec<ModeAnalysis>,
    /// The sets of wrenches after each loss, likewise.
    pub sets: Vec<AdmissibleSet>,
    /// What the log shows after the losses of the last flight with one.
    pub aftermath: Option<Aftermath>,
    /// Why nothing or not everything can be said, each with the parameter to set.
    pub unknown: Vec<String>,
    /// Rates at which the log has outputs of motors, and rates of turn, Hz.
    pub rates: [f64; 2],
    /// Changes against other flights.
    pub baseline: Option<Vec<Against>>,
}

/// The capacity of a motor against flights that are known to be good.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Against {
    /// From 0.
    pub motor: usize,
    /// Mean of the baseline, and the difference of this flight.
    pub mean: f64,
    pub change: f64,
    /// Half of the 95 % interval in which the difference is without a change.
    pub half: f64,
}

impl Against {
    pub fn is_significant(&self) -> bool {
        self.change.abs() > self.half
    }
}

impl Diagnosis {
    pub fn losses(&self) -> &[crate::diagnosis::study::Loss] {
        self.study.as_ref().map_or(&[], |study| &study.losses)
    }

    /// Whether nothing can be said of losses.
    pub fn is_unknown(&self) -> bool {
        self.study.as_ref().is_none_or(|study| study.flights.is_empty() || !study.is_searched)
    }
}
