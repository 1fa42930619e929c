//! How the mission is flown: the settings of the blocks `simulate` and `campaign`, with their defaults.

use super::{PlannerKind, Rotor};
use crate::source::Span;

/// Time constant of a rotor in simulations if the spec gives none, s.
pub const MOTOR_TIME_CONSTANT: f64 = 0.02;

impl Rotor {
    /// Time constant with which its speed follows the command, s.
    pub fn lag(&self) -> f64 {
        self.time_constant.unwrap_or(MOTOR_TIME_CONSTANT)
    }
}

/// The controller that follows the plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Controller {
    /// The paper's PD law about hover, (21) to (28).
    Pd,
    /// Geometric tracking on SE(3) (Lee, Leok, McClamroch 2010).
    Geometric,
}

impl Controller {
    pub fn name(self) -> &'static str {
        match self {
            Controller::Pd => "pd",
            Controller::Geometric => "geometric",
        }
    }
}

/// How the commanded wrench becomes rotor speeds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Allocation {
    /// The paper's pseudo-inverse, (42), clipped to the speeds that the rotors can reach.
    PseudoInverse,
    /// Bounded weighted least squares that gives up yaw first.
    Bounded,
}

impl Allocation {
    pub fn name(self) -> &'static str {
        match self {
            Allocation::PseudoInverse => "pseudo_inverse",
            Allocation::Bounded => "bounded",
        }
    }
}

/// What the controller knows of the attitude.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Attitude {
    Exact,
    /// Integrated from the gyroscope, and corrected slowly.
    Estimated,
}

impl Attitude {
    pub fn name(self) -> &'static str {
        match self {
            Attitude::Exact => "exact",
            Attitude::Estimated => "estimated",
        }
    }
}

/// Which vehicle of the spec's intervals flies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlownVehicle {
    /// With the middles of all intervals.
    Middle,
    /// With values drawn evenly from them.
    Drawn,
}

impl FlownVehicle {
    pub fn name(self) -> &'static str {
        match self {
            FlownVehicle::Middle => "middle",
            FlownVehicle::Drawn => "drawn",
        }
    }
}

/// How the controller learns of a fault.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Detection {
    Never,
    /// The mode is known this long after the fault, s.
    After(f64),
    /// From the rotor capacities estimated by recursive least squares, (32) to (42).
    Estimator,
}

impl Detection {
    /// The word of records.
    pub fn name(self) -> &'static str {
        match self {
            Detection::Never => "never",
            Detection::After(_) => "after",
            Detection::Estimator => "estimator",
        }
    }

    /// The delay after which a mode is known, s; `None` unless it is fixed.
    pub fn delay(self) -> Option<f64> {
        if let Detection::After(delay) = self { Some(delay) } else { None }
    }
}

/// Whether a heading error loses the vehicle in a flight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LostYaw {
    /// No heading error does.
    Off,
    /// An error beyond this does, rad, between 0 and pi.
    Beyond(f64),
}

/// The reaction to a detected fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AfterFault {
    /// Fly on as planned.
    Continue,
    /// Come to rest and stay.
    Hold,
    /// Come to rest and descend on the spot.
    Land,
    /// Take a way out, as `recovery` of the plan orders them.
    Recovery,
}

impl AfterFault {
    pub fn name(self) -> &'static str {
        match self {
            AfterFault::Continue => "continue",
            AfterFault::Hold => "hold",
            AfterFault::Land => "land",
            AfterFault::Recovery => "recovery",
        }
    }
}

/// Controller gains per unit of mass or inertia, all positive. The equations are the paper's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gains {
    /// K_p of (24) for x and y, 1/s^2.
    pub position: f64,
    /// K_d of (24) for x and y, 1/s.
    pub velocity: f64,
    /// K_pz of (21), 1/s^2.
    pub altitude: f64,
    /// K_dz of (21), 1/s.
    pub climb: f64,
    /// K_p of (23) for roll and pitch, 1/s^2.
    pub attitude: f64,
    /// K_d of (23) for roll and pitch, 1/s.
    pub attitude_rate: f64,
    /// K_p of (23) for yaw, 1/s^2.
    pub yaw: f64,
    /// K_d of (23) for yaw, 1/s.
    pub yaw_rate: f64,
}

/// A fault that strikes during the flight: `fault M1_6 at 5 s until 9 s`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strike {
    /// Index into [`super::Model::modes`].
    pub mode: usize,
    /// When the fault strikes, s since the start; not negative.
    pub at: f64,
    /// When the rotors recover, s since the start; later than `at`. `None` if the fault stays.
    pub until: Option<f64>,
    pub span: Span,
    /// The place of the time after `at`.
    pub at_span: Span,
}

impl Strike {
    /// Whether both strike with the same mode and are active at the same time.
    pub fn meets(&self, other: &Strike) -> bool {
        let ends_by = |a: &Strike, b: &Strike| a.until.is_some_and(|until| until <= b.at);
        self.mode == other.mode && !ends_by(self, other) && !ends_by(other, self)
    }
}

/// The `simulate` block, or its defaults.
#[derive(Debug, Clone, PartialEq)]
pub struct Simulation {
    /// Duration of the flight, s; `None` for that of the plan.
    pub duration: Option<f64>,
    /// Steps of the integration per second, Hz.
    pub rate: f64,
    /// Rate of the controller, Hz; divides `rate`.
    pub control_rate: f64,
    /// Rate of the estimator, Hz; divides `control_rate`.
    pub estimator_rate: f64,
    pub controller: Controller,
    pub detection: Detection,
    pub after_fault: AfterFault,
    pub gains: Gains,
    /// Forgetting factor lambda of the recursive least squares, per sample of the estimator; 0 < lambda < 1.
    pub forgetting: f64,
    /// Standard deviations of the torque noise beyond which the estimator uses a sample; positive.
    pub threshold: f64,
    /// Standard deviation of a sample of the body rates, rad/s.
    pub gyroscope_noise: f64,
    /// Largest body rate on each axis that is measured, rad/s.
    pub gyroscope_range: f64,
    /// The noise of the gyroscope that the estimator assumes, rad/s; `None` for the true one.
    pub assumed_gyroscope_noise: Option<f64>,
    pub attitude: Attitude,
    /// Standard deviation of a sample of the position, m on each axis.
    pub position_noise: f64,
    /// Linear drag along the axes x, y and z of the body, N s/m: the force along an axis is -drag times the velocity
    /// through the air along it.
    pub drag: [f64; 3],
    /// Mean velocity of the air in the world frame, m/s.
    pub wind: [f64; 3],
    /// Standard deviation of Dryden gusts on each axis, m/s.
    pub gusts: f64,
    /// Length scale of Dryden gusts, m.
    pub gust_length: f64,
    /// Standard deviation of the torque of gusts about each axis of the body, N m.
    pub torque_gusts: f64,
    pub spread: FlownVehicle,
    /// Largest offset of the centre of gravity along x and along y of the body, m.
    pub centre_offset: f64,
    /// Seed of noise and gusts.
    pub seed: u64,
    /// The faults that strike, in the order of their times, then as written.
    pub faults: Vec<Strike>,
    /// The vehicle is lost when it is this far from its reference, m.
    pub lost_beyond: f64,
    /// The vehicle is lost when it tilts past 90 degrees for longer than this, s.
    pub upside_down: f64,
    /// The heading error that loses the vehicle where it lasts longer than `lost_yaw_after`.
    pub lost_yaw: LostYaw,
    /// How long the heading error may exceed `lost_yaw`, s.
    pub lost_yaw_after: f64,
    /// Height of the ground, m; below every waypoint.
    pub ground: f64,
    /// Whether the spec has a `simulate` block.
    pub written: bool,
    /// The place of the `simulate` block, or of the plan where there is none.
    pub span: Span,
    /// The place of `rate`, or of the block.
    pub rate_span: Span,
}

/// The `campaign` block, or its defaults.
#[derive(Debug, Clone, PartialEq)]
pub struct Campaign {
    /// Number of fault instants, evenly spread over the mission.
    pub times: usize,
    /// Number of flights, each with its own noise, for every mode and instant.
    pub seeds: usize,
    /// The planners whose plans are flown, without repetitions, in the order written.
    pub planners: Vec<PlannerKind>,
    /// Seed from which the seeds of the flights are drawn.
    pub seed: u64,
    /// Whether the spec has a `campaign` block.
    pub written: bool,
    /// The place of the `campaign` block, or of the plan where there is none.
    pub span: Span,
}

impl Default for Gains {
    fn default() -> Self {
        use crate::language::table::simulate::*;
        Gains {
            position: POSITION_GAIN.value(),
            velocity: VELOCITY_GAIN.value(),
            altitude: ALTITUDE_GAIN.value(),
            climb: CLIMB_GAIN.value(),
            attitude: ATTITUDE_GAIN.value(),
            attitude_rate: ATTITUDE_RATE_GAIN.value(),
            yaw: YAW_GAIN.value(),
            yaw_rate: YAW_RATE_GAIN.value(),
        }
    }
}

impl Simulation {
    /// The largest drag along an axis of the body, N s/m.
    pub fn largest_drag(&self) -> f64 {
        self.drag.into_iter().fold(0.0, f64::max)
    }
}

impl Default for Simulation {
    fn default() -> Self {
        use crate::language::table::simulate::*;
        Simulation {
            duration: None,
            rate: RATE.value(),
            control_rate: CONTROL_RATE.value(),
            estimator_rate: ESTIMATOR_RATE.value(),
            controller: Controller::Geometric,
            detection: Detection::Estimator,
            after_fault: AfterFault::Continue,
            gains: Gains::default(),
            forgetting: FORGETTING.value(),
            threshold: THRESHOLD.value(),
            gyroscope_noise: GYROSCOPE_NOISE.value(),
            gyroscope_range: GYROSCOPE_RANGE.value(),
            assumed_gyroscope_noise: None,
            attitude: Attitude::Exact,
            position_noise: POSITION_NOISE.value(),
            drag: [DRAG.value(); 3],
            wind: [0.0; 3],
            gusts: GUSTS.value(),
            gust_length: GUST_LENGTH.value(),
            torque_gusts: TORQUE_GUSTS.value(),
            spread: FlownVehicle::Middle,
            centre_offset: CENTRE_OFFSET.value(),
            seed: SEED.value() as u64,
            faults: Vec::new(),
            lost_beyond: LOST_BEYOND.value(),
            upside_down: UPSIDE_DOWN.value(),
            lost_yaw: LostYaw::Beyond(LOST_YAW.value()),
            lost_yaw_after: LOST_YAW_AFTER.value(),
            ground: GROUND.value(),
            written: false,
            span: Span::default(),
            rate_span: Span::default(),
        }
    }
}

impl Default for Campaign {
    fn default() -> Self {
        use crate::language::table::campaign::*;
        Campaign {
            times: TIMES.value() as usize,
            seeds: SEEDS.value() as usize,
            planners: vec![PlannerKind::Rip, PlannerKind::Rsp, PlannerKind::Rcp],
            seed: SEED.value() as u64,
            written: false,
            span: Span::default(),
        }
    }
}
