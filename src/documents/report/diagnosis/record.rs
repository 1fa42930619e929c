//! The record of `mavc diagnose --format json`.

use super::why::why;
use super::{Against, Answer, Diagnosis};
use crate::admissible::outcome::Outcome;
use crate::diagnosis::ending::End;
use crate::diagnosis::record::Autopilot;
use crate::diagnosis::study::{Evidence, Kind};
use serde::Serialize;

/// Version of this record.
const SCHEMA: u32 = 1;

/// What a log says of the rotors.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct DiagnosisRecord {
    /// Version of this format.
    #[cfg_attr(test, schemars(extend("const" = SCHEMA)))]
    schema: u32,
    /// The autopilot that wrote the log: `ArduPilot`, `PX4` or `mavc`.
    autopilot: &'static str,
    answer: Answer,
    /// Rotors that lost thrust, in the order of time.
    losses: Vec<LossRecord>,
    /// The capacity of each rotor relative to the strongest before the first loss, in quiet flight; empty if less than
    /// 8 s of it are quiet.
    capacities: Vec<CapacityRecord>,
    /// The flights of the log.
    flights: Vec<FlightRecord>,
    /// After a loss in a flight: what the remaining rotors could not hold, and what the log shows, in one sentence;
    /// otherwise null.
    why: Option<String>,
    /// Why nothing or not everything can be said.
    unknown: Vec<String>,
    /// Rate at which the log has the outputs of motors, Hz; null if it has none.
    outputs_hz: Option<f64>,
    /// Rate at which the log has rates of turn, Hz; null if it has none.
    rates_hz: Option<f64>,
}

/// A rotor that lost thrust.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct LossRecord {
    /// The autopilot's number of the motor.
    #[cfg_attr(test, schemars(range(min = 1)))]
    motor: usize,
    /// When, s in the time of the log.
    time_s: f64,
    /// 95 % interval of the time, s.
    interval_s: [f64; 2],
    /// The share of its thrust that the rotor gives after it; if it is held, the share of full thrust at which
    /// it is.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    capacity: f64,
    /// 95 % interval of the capacity.
    capacity_interval: [f64; 2],
    /// `lost`, `reduced`; `off` or `held` if the autopilot's own output was off or held at one value; `held` by the
    /// motion if the rotor gives the same thrust whatever its command.
    kind: &'static str,
    /// What shows it: `motion` of the vehicle, `output` of the autopilot, or `speed` of the rotor.
    evidence: &'static str,
    /// Other motors whose loss would explain the motion as well; the answer is one of them or `motor`.
    alternatives: Vec<usize>,
    /// What this loss and all before it leave of the vehicle.
    outcome: Outcome,
}

/// The capacity of a rotor.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct CapacityRecord {
    /// The autopilot's number of the motor.
    #[cfg_attr(test, schemars(range(min = 1)))]
    motor: usize,
    /// Relative to the strongest.
    capacity: f64,
    /// 95 % interval.
    interval: [f64; 2],
    /// With `--baseline`: difference from the mean of the baseline; omitted otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    change: Option<f64>,
    /// With `--baseline`: whether the difference is outside the 95 % interval of no change; omitted otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    is_significant: Option<bool>,
}

/// A flight.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct FlightRecord {
    /// Take-off, s in the time of the log.
    from_s: f64,
    /// Landing, impact or end of the log, s.
    to_s: f64,
    /// How it ended: `impact` on the ground, `landed`, or `open` if the log ends before.
    end: &'static str,
    /// From when on the motion was searched for losses, s; null if the flight is too short for that.
    searched_from_s: Option<f64>,
    /// When it hit the ground, s; null if it did not.
    impact_s: Option<f64>,
    /// Speed downwards just before, m/s: the middle of `impact_interval_m_per_s`; null if there is no impact or no
    /// height is logged.
    impact_m_per_s: Option<f64>,
    /// The least and the greatest speed that the heights before the impact show, m/s.
    impact_interval_m_per_s: Option<[f64; 2]>,
    /// The greatest tilt by the autopilot's estimate of its attitude, degrees; null if it is not logged.
    tilt_deg: Option<f64>,
    /// The fastest turn about the vertical axis of the body, degrees/s; null if rates are not logged.
    yaw_rate_deg_per_s: Option<f64>,
}

/// The word of a kind of loss.
pub(super) fn word(kind: Kind) -> &'static str {
    match kind {
        Kind::Lost => "lost",
        Kind::Reduced => "reduced",
        Kind::Held => "held",
        Kind::Off => "off",
    }
}

/// The autopilot's name.
pub(super) fn name(autopilot: Autopilot) -> &'static str {
    match autopilot {
        Autopilot::ArduPilot => "ArduPilot",
        Autopilot::Px4 => "PX4",
        Autopilot::Mavc => "mavc",
    }
}

/// Rounded to so many decimals: more would say more than was measured.
fn rounded(x: f64, decimals: i32) -> f64 {
    let scale = 10_f64.powi(decimals);
    (x * scale).round() / scale
}

impl DiagnosisRecord {
    pub fn new(diagnosis: &Diagnosis) -> Self {
        let seconds = |t: f64| rounded(t, 3);
        let share = |c: f64| rounded(c, 3);
        let losses = diagnosis.losses().iter().zip(&diagnosis.after).map(|(loss, after)| LossRecord {
            motor: loss.motor + 1,
            time_s: seconds(loss.time),
            interval_s: loss.interval.map(seconds),
            capacity: share(loss.capacity),
            capacity_interval: loss.capacity_interval.map(share),
            kind: word(loss.kind),
            evidence: match loss.evidence {
                Evidence::Motion => "motion",
                Evidence::Output => "output",
                Evidence::Speed => "speed",
            },
            alternatives: loss.alternatives.iter().map(|k| k + 1).collect(),
            outcome: after.outcome,
        });
        let study = diagnosis.study.as_ref();
        let capacities = study.and_then(|study| study.capacities.as_deref()).unwrap_or_default();
        let capacities = capacities.iter().enumerate().map(|(k, capacity)| {
            let against = diagnosis.baseline.as_ref().and_then(|all| all.iter().find(|one| one.motor == k));
            CapacityRecord {
                motor: k + 1,
                capacity: share(capacity.value),
                interval: [share(capacity.low), share(capacity.high)],
                change: against.map(|one| share(one.change)),
                is_significant: against.map(Against::is_significant),
            }
        });
        let flights = study.into_iter().flat_map(|study| study.flights.iter().zip(&study.searched));
        let flights = flights.map(|(flight, searched)| {
            let speed = if let End::Impact(speed) = flight.end { speed } else { None };
            FlightRecord {
                from_s: seconds(flight.from),
                to_s: seconds(flight.to),
                end: match flight.end {
                    End::Impact(_) => "impact",
                    End::Landed => "landed",
                    End::Open => "open",
                },
                searched_from_s: searched.map(seconds),
                impact_s: matches!(flight.end, End::Impact(_)).then(|| seconds(flight.to)),
                impact_m_per_s: speed.map(|[least, most]| rounded(0.5 * (least + most), 1)),
                impact_interval_m_per_s: speed.map(|ends| ends.map(|v| rounded(v, 1))),
                tilt_deg: flight.tilt.map(|tilt| rounded(tilt.to_degrees(), 0)),
                yaw_rate_deg_per_s: flight.yaw_rate.map(|rate| rounded(rate.to_degrees(), 0)),
            }
        });
        let rate = |hz: f64| (hz > 0.0).then(|| rounded(hz, 1));
        DiagnosisRecord {
            schema: SCHEMA,
            autopilot: name(diagnosis.autopilot),
            answer: diagnosis.answer(),
            losses: losses.collect(),
            capacities: capacities.collect(),
            flights: flights.collect(),
            why: why(diagnosis),
            unknown: diagnosis.unknown.clone(),
            outputs_hz: rate(diagnosis.rates[0]),
            rates_hz: rate(diagnosis.rates[1]),
        }
    }
}
