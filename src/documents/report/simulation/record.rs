//! The machine-readable record of a flight, schema in `docs/schema/simulate.schema.json`.

use crate::flight::{Flight, Outcome};
use crate::model::{Detection, Model, Strike};
use crate::planner::studies::MissionPlan;
use crate::report::caveats::{Caveat, caveats};
use crate::report::volumes::VolumeRecord;
use crate::verdict::SIMULATED;
use serde::Serialize;

/// A flight with its spec, plan and faults.
#[derive(Debug, Clone, Copy)]
pub struct Flown<'a> {
    pub model: &'a Model,
    pub solved: &'a MissionPlan,
    pub strikes: &'a [Strike],
    pub flight: &'a Flight,
    /// Groups of modes, by name, that the estimator cannot distinguish at the planned rotor speeds.
    pub indistinguishable: &'a [Vec<&'a str>],
    /// How near the flight came to each volume.
    pub volumes: &'a [VolumeRecord],
}

/// Version of this record; raised when a field or the meaning of its values changes.
const SCHEMA: u32 = 3;

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FlightRecord {
    pub schema: u32,
    /// Always `simulated`.
    pub verdict: &'static str,
    pub spec_sha256: String,
    pub planner: &'static str,
    pub plan_time_s: f64,
    pub controller: &'static str,
    pub allocation: &'static str,
    /// `never`, `after` or `estimator`.
    pub detection: &'static str,
    pub detection_delay_s: Option<f64>,
    pub after_fault: &'static str,
    pub rate_hz: f64,
    pub seed: u64,
    pub outcome: OutcomeRecord,
    pub end_s: f64,
    pub rms_error_m: f64,
    pub max_error_m: f64,
    /// Since the first fault; `None` without one.
    pub rms_error_after_m: Option<f64>,
    pub max_tilt_rad: f64,
    /// Between the flown and the planned heading, at most half a turn.
    pub rms_heading_error_rad: f64,
    pub max_heading_error_rad: f64,
    /// Since the first fault; `None` without one.
    pub max_heading_error_after_rad: Option<f64>,
    /// Largest number of whole turns away from the planned heading.
    pub turns: usize,
    /// When yaw was first given up on purpose; `None` if it never was.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gave_up_yaw_at_s: Option<f64>,
    /// For how long some body rate was beyond the range of the gyroscope; `None` if never.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gyroscope_saturated_s: Option<f64>,
    pub faults: Vec<FaultRecord>,
    pub false_alarms: usize,
    pub refused_reconfigurations: usize,
    pub regressor: Option<RegressorRecord>,
    /// Groups of modes that cannot be distinguished at the planned rotor speeds.
    pub indistinguishable_modes: Vec<Vec<String>>,
    /// How near the flight came to the boundary of each volume; omitted without volumes.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub volumes: Vec<VolumeRecord>,
    /// Caveats of the plan.
    pub warnings: Vec<Caveat>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "status", rename_all = "snake_case")]
pub enum OutcomeRecord {
    Flown,
    Landed {
        at_s: f64,
    },
    Lost {
        at_s: f64,
        cause: &'static str,
        /// Too far tilted or turned at the end of the flight, for however short a time.
        at_end: bool,
    },
    Diverged {
        at_s: f64,
    },
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FaultRecord {
    pub mode: String,
    pub at_s: f64,
    pub until_s: Option<f64>,
    /// False if the flight ended before the fault.
    pub struck: bool,
    pub detected_after_s: Option<f64>,
    pub isolated_after_s: Option<f64>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RegressorRecord {
    pub rotors: usize,
    pub lowest_rank: usize,
    pub highest_rank: usize,
    pub median_condition: f64,
}

impl FlightRecord {
    /// The record of a flight; `spec_sha256` is the hash over all files of its spec.
    pub fn new(flown: &Flown, spec_sha256: String) -> Self {
        let Flown { model, solved, strikes, flight, indistinguishable, volumes } = flown;
        let s = &model.simulation;
        let (detection, delay) = match s.detection {
            Detection::Never => ("never", None),
            Detection::After(delay) => ("after", Some(delay)),
            Detection::Estimator => ("estimator", None),
        };
        FlightRecord {
            schema: SCHEMA,
            verdict: SIMULATED,
            spec_sha256,
            planner: model.plan.planner.name(),
            plan_time_s: solved.time,
            controller: s.controller.name(),
            allocation: model.vehicle.allocation.name(),
            detection,
            detection_delay_s: delay,
            after_fault: s.after_fault.name(),
            rate_hz: s.rate,
            seed: s.seed,
            outcome: match flight.outcome {
                Outcome::Flown => OutcomeRecord::Flown,
                Outcome::Landed { at } => OutcomeRecord::Landed { at_s: at },
                Outcome::Lost { at, cause, at_end } => OutcomeRecord::Lost { at_s: at, cause: cause.name(), at_end },
                Outcome::Diverged { at } => OutcomeRecord::Diverged { at_s: at },
            },
            end_s: flight.end,
            rms_error_m: flight.rms_error,
            max_error_m: flight.max_error,
            rms_error_after_m: (!flight.found.is_empty()).then_some(flight.rms_error_after),
            max_tilt_rad: flight.max_tilt,
            rms_heading_error_rad: flight.heading.rms,
            max_heading_error_rad: flight.heading.max,
            max_heading_error_after_rad: (!flight.found.is_empty()).then_some(flight.heading.max_after),
            turns: flight.heading.turns,
            gave_up_yaw_at_s: flight.gave_up_yaw_at,
            gyroscope_saturated_s: Some(flight.gyroscope_saturated).filter(|seconds| *seconds > 0.0),
            faults: faults(model, strikes, flight),
            false_alarms: flight.false_alarms,
            refused_reconfigurations: flight.refused,
            regressor: flight.regressor.map(|r| RegressorRecord {
                rotors: model.vehicle.rotors.len(),
                lowest_rank: r.lowest_rank,
                highest_rank: r.highest_rank,
                median_condition: r.median_condition,
            }),
            indistinguishable_modes: indistinguishable
                .iter()
                .map(|group| group.iter().map(ToString::to_string).collect())
                .collect(),
            volumes: volumes.to_vec(),
            warnings: caveats(model, solved),
        }
    }
}

/// One record per fault; detection times only for faults that struck before the end.
fn faults(model: &Model, strikes: &[Strike], flight: &Flight) -> Vec<FaultRecord> {
    let found = |index: usize| flight.found.get(index);
    let record = |(index, strike): (usize, &Strike)| FaultRecord {
        mode: model.modes[strike.mode].name.clone(),
        at_s: strike.at,
        until_s: strike.until,
        struck: found(index).is_some(),
        detected_after_s: found(index).and_then(|f| f.detected_after),
        isolated_after_s: found(index).and_then(|f| f.isolated_after),
    };
    strikes.iter().enumerate().map(record).collect()
}
