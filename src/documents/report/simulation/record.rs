//! The machine-readable record of a flight, schema in `docs/schema/simulate.schema.json`.

#[cfg(test)]
use crate::flight::Cause;
use crate::flight::{Flight, Outcome};
use crate::model::{Model, Strike};
use crate::number::{fixed, significant};
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
const SCHEMA: u32 = 5;

/// Result of one simulated flight along the spec's plan, with faults during the flight.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct FlightRecord {
    /// Version of this format.
    #[cfg_attr(test, schemars(extend("const" = SCHEMA)))]
    pub schema: u32,
    /// The verdict of every flight, whatever its outcome.
    #[cfg_attr(test, schemars(extend("const" = SIMULATED)))]
    pub verdict: &'static str,
    /// SHA-256 over all files of the spec.
    #[cfg_attr(test, schemars(regex(pattern = "^[0-9a-f]{64}$")))]
    pub spec_sha256: String,
    /// The planner of the plan that was flown.
    #[cfg_attr(test, schemars(extend("enum" = crate::language::table::plan::PLANNER.words())))]
    pub planner: &'static str,
    /// Mission time of the plan, s.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub plan_time_s: f64,
    /// The controller.
    #[cfg_attr(test, schemars(extend("enum" = crate::language::table::simulate::CONTROLLER.words())))]
    pub controller: &'static str,
    /// How a wrench becomes rotor speeds.
    #[cfg_attr(test, schemars(extend("enum" = crate::language::table::vehicle::ALLOCATION.words())))]
    pub allocation: &'static str,
    /// How the controller learns of faults.
    #[cfg_attr(test, schemars(extend("enum" = ["never", "after", "estimator"])))]
    pub detection: &'static str,
    /// Delay after which faults are known, s; null unless `detection` is `after`.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub detection_delay_s: Option<f64>,
    /// The reaction to a detected fault.
    #[cfg_attr(test, schemars(extend("enum" = crate::language::table::simulate::AFTER_FAULT.words())))]
    pub after_fault: &'static str,
    /// Steps of the integrator per second.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub rate_hz: f64,
    /// Seed of noise and gusts.
    pub seed: u64,
    /// How the flight ended.
    pub outcome: OutcomeRecord,
    /// When the flight ended, s.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub end_s: f64,
    /// Position error, root mean square, m.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub rms_error_m: f64,
    /// Largest position error, m.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub max_error_m: f64,
    /// The root mean square since the first fault, m; null without a fault.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub rms_error_after_m: Option<f64>,
    /// Waypoints that were due, since the first fault if one struck.
    pub waypoints_due: usize,
    /// Those of them that were missed by more than their tolerance.
    pub waypoints_missed: usize,
    /// The one missed by most; omitted if none was missed, or none before the vehicle was lost.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub worst_miss: Option<MissRecord>,
    /// Limits that were exceeded by more than a tenth of their size (docs/flight.md, section 5), since the first fault
    /// if one struck.
    pub limits_broken: Vec<&'static str>,
    /// Largest angle between body z and the vertical, rad.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub max_tilt_rad: f64,
    /// Angle between the flown and the planned heading, root mean square, rad; at most half a turn.
    #[cfg_attr(test, schemars(range(min = 0, max = 3.15)))]
    pub rms_heading_error_rad: f64,
    /// The largest such angle, rad.
    #[cfg_attr(test, schemars(range(min = 0, max = 3.15)))]
    pub max_heading_error_rad: f64,
    /// The largest since the first fault, rad; null without a fault.
    #[cfg_attr(test, schemars(range(min = 0, max = 3.15)))]
    pub max_heading_error_after_rad: Option<f64>,
    /// Largest number of whole turns away from the planned heading.
    pub turns: usize,
    /// When yaw was first given up on purpose, s since the start; omitted if it never was. The heading error loses no
    /// vehicle while yaw is given up.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub gave_up_yaw_at_s: Option<f64>,
    /// With `after_fault = recovery`: the way out taken after the first fault; omitted if none was sought.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub way_out: Option<WayOutRecord>,
    /// The spin in the end; omitted unless yaw is given up then.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spin: Option<SpinRecord>,
    /// For how long some body rate was beyond the range of the gyroscope, s; omitted if it never was.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub gyroscope_saturated_s: Option<f64>,
    /// In the order of their times.
    pub faults: Vec<FaultRecord>,
    /// How often the estimate of a sound rotor was below 0.7 for longer than 0.1 s.
    pub false_alarms: usize,
    /// How often an estimate was refused because the vehicle could not hover under it.
    pub refused_reconfigurations: usize,
    /// The estimator's regressor along the flight; null if nothing is estimated.
    pub regressor: Option<RegressorRecord>,
    /// Groups of modes that cannot be distinguished at the planned rotor speeds; `healthy` is the vehicle without a
    /// fault.
    #[cfg_attr(test, schemars(inner(length(min = 2))))]
    pub indistinguishable_modes: Vec<Vec<String>>,
    /// How near the flight came to the boundary of each volume; omitted without volumes.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub volumes: Vec<VolumeRecord>,
    /// Caveats of the plan.
    pub warnings: Vec<Caveat>,
}

/// How a flight ended.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(tag = "status", rename_all = "snake_case")]
pub enum OutcomeRecord {
    /// Flown to the end.
    Flown,
    /// It landed after a fault.
    Landed {
        /// When it touched the ground, s.
        #[cfg_attr(test, schemars(range(min = 0)))]
        at_s: f64,
        /// Where it touched the ground, m.
        place_m: [f64; 3],
        /// Its speed just before, m/s.
        #[cfg_attr(test, schemars(range(min = 0)))]
        speed_m_s: f64,
    },
    /// It was not lost, but it entered a `keep_out` or left a `keep_in`.
    Trespassed {
        /// When it first did, s.
        #[cfg_attr(test, schemars(range(min = 0)))]
        at_s: f64,
    },
    /// The vehicle was lost.
    Lost {
        /// When it was lost, s.
        #[cfg_attr(test, schemars(range(min = 0)))]
        at_s: f64,
        /// Why it was lost.
        #[cfg_attr(test, schemars(extend("enum" = Cause::ALL.map(Cause::name))))]
        cause: &'static str,
        /// Whether the vehicle was too far tilted or turned at the end of the flight, for however short a time.
        at_end: bool,
    },
    /// The integration broke down.
    Diverged {
        /// When NaN, infinity or a rotation too fast for the steps first occurred, s.
        #[cfg_attr(test, schemars(range(min = 0)))]
        at_s: f64,
    },
}

/// The way out of a flight after its first fault.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct WayOutRecord {
    /// When the fault became known, s since the start.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub at_s: f64,
    /// Where it leads, for people; null if none was found, so that the vehicle flew on as planned.
    pub way: Option<String>,
}

impl WayOutRecord {
    /// `way out from 30.1 s: landing at depot`
    pub fn words(&self) -> String {
        let at = fixed(self.at_s, 2);
        match &self.way {
            Some(way) => format!("way out from {at} s: {way}"),
            None => format!("no way out was found at {at} s; it flew on as planned"),
        }
    }
}

/// The spin of a vehicle without control of yaw at the end of a flight.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SpinRecord {
    /// The rate about z, rad/s, counter-clockwise seen from above.
    pub rate_rad_s: f64,
    /// Whether the rate has settled; what comes later is not simulated otherwise.
    pub settled: bool,
    /// Whether some rate of the body is beyond the range of the gyroscope.
    pub beyond_gyroscope: bool,
}

/// A fault during the flight.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct FaultRecord {
    /// The mode's name.
    pub mode: String,
    /// When it struck, s.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub at_s: f64,
    /// When the rotors recovered, s; null if they did not.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub until_s: Option<f64>,
    /// False if the flight ended before the fault.
    pub struck: bool,
    /// Seconds until some affected rotor was estimated to be weakened; null if never.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub detected_after_s: Option<f64>,
    /// Seconds until every estimated capacity was within 0.2 of the true one; null if never.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub isolated_after_s: Option<f64>,
}

/// A waypoint that a flight missed.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct MissRecord {
    /// Its place in the mission, from 1.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub waypoint: usize,
    /// By how much more than its `within` it was missed, m.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub beyond_m: f64,
}

/// The estimator's regressor along a flight.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct RegressorRecord {
    /// Number of rotors.
    #[cfg_attr(test, schemars(range(min = 4)))]
    pub rotors: usize,
    /// Lowest rank along the flight.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub lowest_rank: usize,
    /// Highest rank along the flight.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub highest_rank: usize,
    /// Ratio of the largest to the smallest significant singular value, median over the flight.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub median_condition: f64,
}

impl RegressorRecord {
    /// `rank of the regressor 4 to 6 of 6 rotors, median condition number 8.1`
    pub(super) fn words(&self) -> String {
        let condition = significant(self.median_condition, 3);
        let RegressorRecord { rotors, lowest_rank: least, highest_rank: most, .. } = self;
        format!("rank of the regressor {least} to {most} of {rotors} rotors, median condition number {condition}")
    }
}

impl FlightRecord {
    /// The record of a flight; `spec_sha256` is the hash over all files of its spec.
    pub fn new(flown: &Flown, spec_sha256: String) -> Self {
        let Flown { model, solved, strikes, flight, indistinguishable, volumes } = flown;
        let s = &model.simulation;
        FlightRecord {
            schema: SCHEMA,
            verdict: SIMULATED,
            spec_sha256,
            planner: model.plan.planner.name(),
            plan_time_s: solved.time,
            controller: s.controller.name(),
            allocation: model.vehicle.allocation.name(),
            detection: s.detection.name(),
            detection_delay_s: s.detection.delay(),
            after_fault: s.after_fault.name(),
            rate_hz: s.rate,
            seed: s.seed,
            outcome: match flight.outcome {
                Outcome::Flown => OutcomeRecord::Flown,
                Outcome::Landed { at, place, speed } => {
                    OutcomeRecord::Landed { at_s: at, place_m: place, speed_m_s: speed }
                }
                Outcome::Trespassed { at } => OutcomeRecord::Trespassed { at_s: at },
                Outcome::Lost { at, cause, at_end } => OutcomeRecord::Lost { at_s: at, cause: cause.name(), at_end },
                Outcome::Diverged { at } => OutcomeRecord::Diverged { at_s: at },
            },
            end_s: flight.end,
            rms_error_m: flight.rms_error,
            max_error_m: flight.max_error,
            rms_error_after_m: (!flight.found.is_empty()).then_some(flight.rms_error_after),
            waypoints_due: flight.damage.waypoints_due,
            waypoints_missed: flight.damage.waypoints_missed,
            worst_miss: flight
                .damage
                .worst_miss
                .map(|miss| MissRecord { waypoint: miss.waypoint + 1, beyond_m: miss.beyond }),
            limits_broken: flight.damage.limits.words(),
            max_tilt_rad: flight.max_tilt,
            rms_heading_error_rad: flight.heading.rms,
            max_heading_error_rad: flight.heading.max,
            max_heading_error_after_rad: (!flight.found.is_empty()).then_some(flight.heading.max_after),
            turns: flight.heading.turns,
            gave_up_yaw_at_s: flight.gave_up_yaw_at,
            way_out: flight.way_out.as_ref().map(|way| WayOutRecord { at_s: way.at, way: way.words.clone() }),
            spin: flight.spin.map(|spin| SpinRecord {
                rate_rad_s: spin.rate,
                settled: spin.is_settled,
                beyond_gyroscope: spin.is_beyond_gyroscope,
            }),
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
