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
use crate::diagnosis::ending::End;
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
    /// Whether a part of the log was left out, because its times are before those of another part.
    pub is_partial: bool,
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

    /// Motors that give less than in the baseline flights by more than the 95 % interval.
    pub fn weaker(&self) -> impl Iterator<Item = &Against> {
        self.baseline.iter().flatten().filter(|one| one.change < -one.half)
    }

    pub fn answer(&self) -> Answer {
        let study = self.study.as_ref();
        let flights = || study.into_iter().flat_map(|study| study.flights.iter().zip(&study.searched));
        let is_searched = flights().any(|(_, searched)| searched.is_some());
        // An impact that no loss explains is not a flight without a loss.
        let is_open = flights().any(|(flight, searched)| {
            flight.has_crashed_in_a_spin() || searched.is_none() && matches!(flight.end, End::Impact(_))
        });
        match () {
            () if !self.losses().is_empty() => Answer::Loss,
            () if self.weaker().next().is_some() => Answer::Weaker,
            () if !is_searched || is_open || self.is_partial => Answer::Unknown,
            () => Answer::None,
        }
    }
}

/// The answer in one word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Answer {
    /// A rotor lost thrust, or an output was off or held in flight.
    Loss,
    /// No loss was found, but a rotor gives less thrust than in the baseline flights.
    Weaker,
    /// No loss was found.
    None,
    /// The log does not show it.
    Unknown,
}
