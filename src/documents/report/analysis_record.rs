//! The machine-readable report of an analysis (`mavc analyze --format json`).

use super::headline::{headline, headline_of};
use crate::admissible::HEALTHY;
use crate::admissible::outcome::Outcome;
use crate::admissible::verdict::ModeAnalysis;
use crate::flight::capture::Capture;
use crate::flight::equilibrium::flips::{IntervalFlip, interval_flips};
use crate::flight::equilibrium::{SettledSpin, settled_spins};
use crate::model::Model;
use serde::Serialize;

/// Version of this record; raised when a field or the meaning of its values changes.
const SCHEMA: u32 = 5;

/// Controllability and admissible set of each fault mode. `F` is the record of one flip: the value of a swept field
/// at which a verdict changes.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct AnalysisRecord<'a, F> {
    /// Version of this format.
    #[cfg_attr(test, schemars(extend("const" = SCHEMA)))]
    schema: u32,
    /// The vehicle's name.
    vehicle: &'a str,
    /// Number of rotors.
    #[cfg_attr(test, schemars(range(min = 1)))]
    rotors: usize,
    /// The autopilot's numbers of their motors, in the order of the rotors, if the spec gives them.
    #[serde(skip_serializing_if = "Option::is_none")]
    motors: Option<Vec<u32>>,
    /// What the modes leave of the vehicle in one sentence, as on the terminal and the page.
    #[cfg_attr(test, schemars(length(min = 1)))]
    headline: String,
    /// The healthy vehicle first, then the declared modes in the order written.
    #[cfg_attr(test, schemars(length(min = 1)))]
    modes: &'a [ModeAnalysis],
    /// Where flights settle in each mode in which they give up yaw; empty without `yaw_drag`.
    settled_spins: Vec<SettledSpin>,
    /// Where outcomes that are undecided change inside the interval of `drag`, `yaw_drag` or `rotor_inertia`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    interval_flips: Vec<IntervalFlip>,
    /// With `--sweep`: where outcomes and verdicts change, ascending; omitted otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    flips: Option<&'a [F]>,
    /// With `--capture`: the height lost after each fault in which yaw is given up, by simulation; omitted otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    captures: Option<&'a [Capture]>,
}

impl<'a, F> AnalysisRecord<'a, F> {
    pub fn new(
        model: &'a Model,
        modes: &'a [ModeAnalysis],
        flips: Option<&'a [F]>,
        captures: Option<&'a [Capture]>,
    ) -> Self {
        let (vehicle, rotors) = (model.vehicle.name.as_str(), model.vehicle.rotors.len());
        AnalysisRecord {
            schema: SCHEMA,
            vehicle,
            rotors,
            motors: model.vehicle.motors(),
            headline: headline(model, modes),
            modes,
            settled_spins: settled_spins(model),
            interval_flips: interval_flips(model, &modes.iter().map(|mode| mode.outcome).collect::<Vec<_>>()),
            flips,
            captures,
        }
    }
}

/// The last line of `mavc check --format json` for a spec without errors: what the modes leave of the vehicle. The
/// other lines are diagnostics, which have a `code`.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct OutcomesRecord<'a> {
    /// The spec's name as given.
    file: &'a str,
    /// The vehicle's name.
    vehicle: &'a str,
    /// What the modes leave of the vehicle in one sentence, as on the terminal.
    #[cfg_attr(test, schemars(length(min = 1)))]
    headline: String,
    /// The healthy vehicle first, then the declared modes in the order written.
    #[cfg_attr(test, schemars(length(min = 1)))]
    modes: Vec<OutcomeOfMode<'a>>,
}

/// One mode.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct OutcomeOfMode<'a> {
    /// The mode's name.
    name: &'a str,
    /// What it leaves of the vehicle in hover.
    outcome: Outcome,
}

impl<'a> OutcomesRecord<'a> {
    /// `outcomes` are those of the healthy vehicle, then of every declared mode.
    pub fn new(file: &'a str, model: &'a Model, outcomes: &[Outcome]) -> Self {
        let names = std::iter::once(HEALTHY).chain(model.modes.iter().map(|mode| mode.name.as_str()));
        let modes = names.zip(outcomes).map(|(name, outcome)| OutcomeOfMode { name, outcome: *outcome }).collect();
        OutcomesRecord { file, vehicle: &model.vehicle.name, headline: headline_of(model, outcomes), modes }
    }
}
