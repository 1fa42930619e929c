//! The vehicle, its fault modes and how it is flown, for programs: `mavc emit model --format json`.
//!
//! Unlike the text of `mavc emit model`, numbers have all their digits: another simulator computes with what mavc computes with.

use crate::model::{Detection, FaultMode, Gains, Model, Rotor, Simulation, Spin, Vehicle};
use serde::Serialize;

/// Version of this record; raised when a field or the meaning of its values changes.
const SCHEMA: u32 = 1;

/// A model in SI units. Mission and plan are in the other outputs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ModelRecord<'a> {
    schema: u32,
    gravity_m_per_s2: f64,
    vehicle: VehicleRecord<'a>,
    modes: Vec<ModeRecord<'a>>,
    simulate: SimulateRecord<'a>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct VehicleRecord<'a> {
    name: &'a str,
    mass_kg: f64,
    /// Diagonal of J.
    inertia_kg_m2: [f64; 3],
    /// `bounded` or `pseudo_inverse`.
    allocation: &'static str,
    /// Along the axes of the body, as plans and controllers know it.
    drag_n_s_per_m: [f64; 3],
    #[serde(skip_serializing_if = "Option::is_none")]
    yaw_drag: Option<YawDragRecord>,
    rotors: Vec<RotorRecord>,
}

/// The torque is -(linear r + quadratic r |r|).
#[derive(Debug, Clone, PartialEq, Serialize)]
struct YawDragRecord {
    linear_n_m_s_per_rad: f64,
    quadratic_n_m_s2_per_rad2: f64,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct RotorRecord {
    /// The autopilot's number of its motor, if the spec gives it.
    #[serde(skip_serializing_if = "Option::is_none")]
    motor: Option<u32>,
    position_m: [f64; 3],
    /// `P`: counter-clockwise seen from above, or `N`.
    spin: &'static str,
    /// b and d: thrust and drag torque over the squared speed.
    thrust_coefficient_n_s2_per_rad2: f64,
    drag_coefficient_n_m_s2_per_rad2: f64,
    min_speed_rad_per_s: f64,
    max_speed_rad_per_s: f64,
    /// With which speeds follow their commands in flights; the default if the spec gives none.
    time_constant_s: f64,
    inertia_kg_m2: f64,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct ModeRecord<'a> {
    name: &'a str,
    /// theta of each rotor.
    capacity: Vec<f64>,
    /// Share of full thrust at which each rotor is stuck; `null` for one that is not.
    stuck: Vec<Option<f64>>,
    /// `never`, `where_needed` or `always`.
    without_yaw: &'static str,
}

/// The settings of flights that do not concern noise, gusts or the estimator.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct SimulateRecord<'a> {
    duration_s: Option<f64>,
    rate_hz: f64,
    control_rate_hz: f64,
    /// `geometric` or `pd`.
    controller: &'static str,
    /// Seconds until a fault is known; `null` with an estimator, and if it never is.
    detection_s: Option<f64>,
    /// `continue`, `hold` or `land`.
    after_fault: &'static str,
    gains: GainsRecord,
    gyroscope_range_rad_per_s: f64,
    drag_n_s_per_m: [f64; 3],
    wind_m_per_s: [f64; 3],
    lost_beyond_m: f64,
    upside_down_s: f64,
    ground_m: f64,
    faults: Vec<StrikeRecord<'a>>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct GainsRecord {
    position_per_s2: f64,
    velocity_per_s: f64,
    altitude_per_s2: f64,
    climb_per_s: f64,
    attitude_per_s2: f64,
    attitude_rate_per_s: f64,
    yaw_per_s2: f64,
    yaw_rate_per_s: f64,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct StrikeRecord<'a> {
    mode: &'a str,
    at_s: f64,
    until_s: Option<f64>,
}

impl<'a> ModelRecord<'a> {
    pub fn new(model: &'a Model) -> Self {
        ModelRecord {
            schema: SCHEMA,
            gravity_m_per_s2: model.gravity,
            vehicle: vehicle(&model.vehicle),
            modes: model.modes.iter().enumerate().map(|(k, mode)| fault_mode(model, k, mode)).collect(),
            simulate: simulate(&model.simulation, &model.modes),
        }
    }
}

fn vehicle(vehicle: &Vehicle) -> VehicleRecord<'_> {
    VehicleRecord {
        name: &vehicle.name,
        mass_kg: vehicle.mass,
        inertia_kg_m2: vehicle.inertia,
        allocation: vehicle.allocation.name(),
        drag_n_s_per_m: vehicle.drag,
        yaw_drag: vehicle
            .yaw_drag
            .map(|drag| YawDragRecord { linear_n_m_s_per_rad: drag.linear, quadratic_n_m_s2_per_rad2: drag.quadratic }),
        rotors: vehicle.rotors.iter().map(rotor).collect(),
    }
}

fn rotor(rotor: &Rotor) -> RotorRecord {
    RotorRecord {
        motor: rotor.motor,
        position_m: rotor.position,
        spin: if rotor.spin == Spin::P { "P" } else { "N" },
        thrust_coefficient_n_s2_per_rad2: rotor.thrust_coefficient,
        drag_coefficient_n_m_s2_per_rad2: rotor.drag_coefficient,
        min_speed_rad_per_s: rotor.min_speed,
        max_speed_rad_per_s: rotor.max_speed,
        time_constant_s: rotor.lag(),
        inertia_kg_m2: rotor.inertia,
    }
}

fn fault_mode<'a>(model: &Model, index: usize, mode: &'a FaultMode) -> ModeRecord<'a> {
    ModeRecord {
        name: &mode.name,
        capacity: mode.capacities(),
        stuck: mode.stuck(),
        without_yaw: model.gives_up_yaw(index).name(),
    }
}

fn simulate<'a>(simulation: &Simulation, modes: &'a [FaultMode]) -> SimulateRecord<'a> {
    let strikes = simulation.faults.iter().map(|strike| StrikeRecord {
        mode: &modes[strike.mode].name,
        at_s: strike.at,
        until_s: strike.until,
    });
    SimulateRecord {
        duration_s: simulation.duration,
        rate_hz: simulation.rate,
        control_rate_hz: simulation.control_rate,
        controller: simulation.controller.name(),
        detection_s: match simulation.detection {
            Detection::After(delay) => Some(delay),
            Detection::Never | Detection::Estimator => None,
        },
        after_fault: simulation.after_fault.name(),
        gains: gains(&simulation.gains),
        gyroscope_range_rad_per_s: simulation.gyroscope_range,
        drag_n_s_per_m: simulation.drag,
        wind_m_per_s: simulation.wind,
        lost_beyond_m: simulation.lost_beyond,
        upside_down_s: simulation.upside_down,
        ground_m: simulation.ground,
        faults: strikes.collect(),
    }
}

fn gains(gains: &Gains) -> GainsRecord {
    GainsRecord {
        position_per_s2: gains.position,
        velocity_per_s: gains.velocity,
        altitude_per_s2: gains.altitude,
        climb_per_s: gains.climb,
        attitude_per_s2: gains.attitude,
        attitude_rate_per_s: gains.attitude_rate,
        yaw_per_s2: gains.yaw,
        yaw_rate_per_s: gains.yaw_rate,
    }
}
