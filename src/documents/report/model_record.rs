//! The vehicle, its fault modes and how it is flown, for programs: `mavc emit model --format json`.
//!
//! Unlike the text of `mavc emit model`, numbers have all their digits: another simulator computes with what mavc
//! computes with.

use crate::model::{FaultMode, Gains, Model, Rotor, Simulation, Spin, Vehicle};
use serde::Serialize;

/// Version of this record; raised when a field or the meaning of its values changes.
const SCHEMA: u32 = 1;

/// The vehicle, its fault modes and how it is flown, with all digits. Frames and signs are those of
/// docs/method/sets.md; mission and plan are in the other outputs.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ModelRecord<'a> {
    /// Version of this format.
    #[cfg_attr(test, schemars(extend("const" = SCHEMA)))]
    schema: u32,
    /// Acceleration of gravity, m/s^2.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    gravity_m_per_s2: f64,
    /// The vehicle.
    vehicle: VehicleRecord<'a>,
    /// Fault modes in the order written.
    modes: Vec<ModeRecord<'a>>,
    /// How it is flown.
    simulate: SimulateRecord<'a>,
}

/// A vehicle.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct VehicleRecord<'a> {
    /// Its name.
    name: &'a str,
    /// Mass, kg.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    mass_kg: f64,
    /// Diagonal of J, kg m^2.
    inertia_kg_m2: [f64; 3],
    /// The centre of gravity from the frame's origin, m; omitted if the spec places rotors from the centre of gravity.
    #[serde(skip_serializing_if = "Option::is_none")]
    centre_of_gravity_m: Option<[f64; 3]>,
    /// How a wrench becomes rotor speeds.
    #[cfg_attr(test, schemars(extend("enum" = crate::language::table::vehicle::ALLOCATION.words())))]
    allocation: &'static str,
    /// Along the axes of the body, as plans and controllers know it, N s/m.
    drag_n_s_per_m: [f64; 3],
    /// The drag about z; omitted if the spec gives none.
    #[serde(skip_serializing_if = "Option::is_none")]
    yaw_drag: Option<YawDragRecord>,
    /// The rotors, in the order written.
    rotors: Vec<RotorRecord>,
}

/// The torque is -(linear r + quadratic r |r|), with the yaw rate r in rad/s.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct YawDragRecord {
    /// The linear coefficient, N m s/rad.
    linear_n_m_s_per_rad: f64,
    /// The quadratic coefficient, N m s^2/rad^2.
    quadratic_n_m_s2_per_rad2: f64,
}

/// A rotor.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct RotorRecord {
    /// The autopilot's number of its motor; omitted if the spec does not give it.
    #[serde(skip_serializing_if = "Option::is_none")]
    motor: Option<u32>,
    /// Its place relative to the centre of gravity, m.
    position_m: [f64; 3],
    /// P: counter-clockwise seen from above; N: clockwise.
    #[cfg_attr(test, schemars(extend("enum" = ["P", "N"])))]
    spin: &'static str,
    /// b: thrust over squared speed, N s^2/rad^2.
    thrust_coefficient_n_s2_per_rad2: f64,
    /// d: drag torque over squared speed, N m s^2/rad^2.
    drag_coefficient_n_m_s2_per_rad2: f64,
    /// Lowest speed, rad/s.
    min_speed_rad_per_s: f64,
    /// Highest speed, rad/s.
    max_speed_rad_per_s: f64,
    /// With which the speed follows its command in flights, s; the default if the spec gives none.
    time_constant_s: f64,
    /// Moment of inertia about its axis, kg m^2.
    inertia_kg_m2: f64,
}

/// A fault mode.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct ModeRecord<'a> {
    /// Its name.
    name: &'a str,
    /// theta of each rotor.
    #[cfg_attr(test, schemars(inner(range(min = 0, max = 1))))]
    capacity: Vec<f64>,
    /// Share of full thrust at which each rotor is stuck; null for one that is not.
    stuck: Vec<Option<f64>>,
    /// Whether yaw is given up after it.
    #[cfg_attr(test, schemars(extend("enum" = crate::language::table::plan::WITHOUT_YAW.words())))]
    without_yaw: &'static str,
}

/// The settings of flights that do not concern noise, gusts or the estimator, with their defaults.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct SimulateRecord<'a> {
    /// Duration of a flight, s; null: that of the plan.
    duration_s: Option<f64>,
    /// Steps of the integrator, Hz.
    rate_hz: f64,
    /// Steps of the controller, Hz.
    control_rate_hz: f64,
    /// The controller.
    #[cfg_attr(test, schemars(extend("enum" = crate::language::table::simulate::CONTROLLER.words())))]
    controller: &'static str,
    /// Seconds until a fault is known; null with an estimator, and if it never is.
    detection_s: Option<f64>,
    /// The reaction to a detected fault.
    #[cfg_attr(test, schemars(extend("enum" = crate::language::table::simulate::AFTER_FAULT.words())))]
    after_fault: &'static str,
    /// The gains of the controller.
    gains: GainsRecord,
    /// The largest body rate that the gyroscope measures, rad/s.
    gyroscope_range_rad_per_s: f64,
    /// Drag in flights along the axes of the body, N s/m.
    drag_n_s_per_m: [f64; 3],
    /// Mean wind, m/s.
    wind_m_per_s: [f64; 3],
    /// Distance from the reference beyond which the vehicle is lost, m.
    lost_beyond_m: f64,
    /// How long it may be tilted by more than 90 degrees, s.
    upside_down_s: f64,
    /// z of the ground, m.
    ground_m: f64,
    /// The faults during a flight.
    faults: Vec<StrikeRecord<'a>>,
}

/// Gains of the controller.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct GainsRecord {
    /// On the deviation in x and y, 1/s^2.
    position_per_s2: f64,
    /// On the deviation of the horizontal velocity, 1/s.
    velocity_per_s: f64,
    /// On the deviation in z, 1/s^2.
    altitude_per_s2: f64,
    /// On the deviation of the vertical velocity, 1/s.
    climb_per_s: f64,
    /// On the deviation in roll and pitch, 1/s^2.
    attitude_per_s2: f64,
    /// On the deviation of the roll and pitch rates, 1/s.
    attitude_rate_per_s: f64,
    /// On the deviation in yaw, 1/s^2.
    yaw_per_s2: f64,
    /// On the deviation of the yaw rate, 1/s.
    yaw_rate_per_s: f64,
}

/// A fault during a flight.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct StrikeRecord<'a> {
    /// The mode's name.
    mode: &'a str,
    /// When it strikes, s.
    at_s: f64,
    /// When the rotors recover, s; null if they do not.
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
        centre_of_gravity_m: vehicle.centre_of_gravity,
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
        detection_s: simulation.detection.delay(),
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
