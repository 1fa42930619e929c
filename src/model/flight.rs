//! How the mission is flown: what the blocks `simulate` and `campaign` say, or their defaults.

use super::{PlannerKind, Rotor};
use crate::source::Span;

/// Time constant of a rotor for which the spec gives none, s.
pub const MOTOR_TIME_CONSTANT: f64 = 0.02;

impl Rotor {
    /// Time constant with which its speed follows, s.
    pub fn lag(&self) -> f64 {
        self.time_constant.unwrap_or(MOTOR_TIME_CONSTANT)
    }
}

/// The controller that follows the plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Controller {
    /// The paper's PD law, (21) to (28), about hover.
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

/// How the wanted wrench becomes rotor speeds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Allocation {
    /// (42), clipped to the speeds that the rotors can turn.
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

/// How the controller learns of a fault.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Detection {
    Never,
    /// It knows the mode this long after the fault, s.
    After(f64),
    /// From the capacities that recursive least squares estimates, (32) to (42).
    Estimator,
}

/// What the vehicle does once it knows of a fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AfterFault {
    /// Fly on as planned.
    Continue,
    /// Come to rest and stay.
    Hold,
    /// Come to rest and descend where it is.
    Land,
}

impl AfterFault {
    pub fn name(self) -> &'static str {
        match self {
            AfterFault::Continue => "continue",
            AfterFault::Hold => "hold",
            AfterFault::Land => "land",
        }
    }
}

/// Gains per unit of mass or inertia: those on a deviation in 1/s^2, those on its rate in 1/s; all > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gains {
    /// K_p and K_d of (24) for x and y.
    pub position: f64,
    pub velocity: f64,
    /// K_pz and K_dz of (21).
    pub altitude: f64,
    pub climb: f64,
    /// K_p and K_d of (23) for roll and pitch.
    pub attitude: f64,
    pub attitude_rate: f64,
    /// K_p and K_d of (23) for yaw.
    pub yaw: f64,
    pub yaw_rate: f64,
}

/// `fault M1_6 at 5 s until 9 s`
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strike {
    /// Index into [`super::Model::modes`].
    pub mode: usize,
    /// s since the start; >= 0.
    pub at: f64,
    /// When the rotors recover, s; > `at`.
    pub until: Option<f64>,
    pub span: Span,
    /// Of the time behind `at`.
    pub at_span: Span,
}

impl Strike {
    /// Whether both are in force at some instant, by the same mode.
    pub fn meets(&self, other: &Strike) -> bool {
        let ends_by = |a: &Strike, b: &Strike| a.until.is_some_and(|until| until <= b.at);
        self.mode == other.mode && !ends_by(self, other) && !ends_by(other, self)
    }
}

/// The `simulate` block, or its defaults.
#[derive(Debug, Clone, PartialEq)]
pub struct Simulation {
    /// s; `None`: as long as the plan.
    pub duration: Option<f64>,
    /// Steps of the integrator per second, Hz.
    pub rate: f64,
    /// Hz; divides `rate`.
    pub control_rate: f64,
    /// Hz; divides `control_rate`.
    pub estimator_rate: f64,
    pub controller: Controller,
    pub detection: Detection,
    pub after_fault: AfterFault,
    pub gains: Gains,
    /// lambda of the recursive least squares, per sample of the estimator; 0 < lambda < 1.
    pub forgetting: f64,
    /// Standard deviation of a sample of the body rates, rad/s.
    pub gyroscope_noise: f64,
    /// Standard deviation of a sample of the position, m on each axis.
    pub position_noise: f64,
    /// Linear drag, N s/m: the force is -drag times the velocity through the air.
    pub drag: f64,
    /// Mean wind, m/s, world frame: where the air goes.
    pub wind: [f64; 3],
    /// Standard deviation of Dryden gusts, m/s on each axis, and their length scale, m.
    pub gusts: f64,
    pub gust_length: f64,
    pub seed: u64,
    /// In the order of their times, then as written.
    pub faults: Vec<Strike>,
    /// The vehicle is lost where it is this far from where it should be, m.
    pub lost_beyond: f64,
    /// The vehicle is lost where it tilts past 90 degrees for longer than this, s.
    pub upside_down: f64,
    /// The vehicle is lost where its heading is farther than this from the planned one, rad, for longer than
    /// `lost_yaw_after`, s; `None`: whatever its heading.
    pub lost_yaw: Option<f64>,
    pub lost_yaw_after: f64,
    /// Height of the ground, m; below every waypoint.
    pub ground: f64,
    /// Whether the spec has a `simulate` block.
    pub written: bool,
    /// The `simulate` block, or the plan's place where there is none.
    pub span: Span,
    /// Of `rate`, or the block.
    pub rate_span: Span,
}

/// The `campaign` block, or its defaults.
#[derive(Debug, Clone, PartialEq)]
pub struct Campaign {
    /// Fault instants, evenly spread over the mission.
    pub times: usize,
    /// Noise seeds for each.
    pub seeds: usize,
    /// Without repeats, in the order written.
    pub planners: Vec<PlannerKind>,
    pub seed: u64,
    /// Whether the spec has a `campaign` block.
    pub written: bool,
    /// The `campaign` block, or the plan's place where there is none.
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
            gyroscope_noise: GYROSCOPE_NOISE.value(),
            position_noise: POSITION_NOISE.value(),
            drag: DRAG.value(),
            wind: [0.0; 3],
            gusts: GUSTS.value(),
            gust_length: GUST_LENGTH.value(),
            seed: SEED.value() as u64,
            faults: Vec::new(),
            lost_beyond: LOST_BEYOND.value(),
            upside_down: UPSIDE_DOWN.value(),
            lost_yaw: Some(LOST_YAW.value()),
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
