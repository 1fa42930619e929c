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

/// A value and how one would write it.
pub(super) type Written<T> = (T, &'static str, &'static str);

/// Defaults: value in SI, as written, why.
pub(super) mod default {
    use super::{AfterFault, Controller, Detection, PlannerKind, Written};

    pub const DURATION: Written<Option<f64>> = (None, "that of the plan", "how long the flight is simulated");
    pub const RATE: Written<f64> = (1000.0, "1 kHz", "steps of the integration");
    pub const CONTROL_RATE: Written<f64> = (500.0, "500 Hz", "how often the controller acts");
    pub const ESTIMATOR_RATE: Written<f64> = (100.0, "100 Hz", "how often capacities are estimated");
    pub const CONTROLLER: Written<Controller> = (Controller::Geometric, "geometric", "tracks far from hover too");
    pub const DETECTION: Written<Detection> =
        (Detection::Estimator, "estimator", "how the controller learns of a fault");
    pub const AFTER_FAULT: Written<AfterFault> = (AfterFault::Continue, "continue", "flies on as planned");
    pub const FORGETTING: Written<f64> = (0.95, "0.95", "memory of the estimator per sample");
    pub const POSITION_GAIN: Written<f64> = (4.0, "4 1/s^2", "gain on the deviation in x and y");
    pub const VELOCITY_GAIN: Written<f64> = (3.2, "3.2 1/s", "gain on the deviation of the horizontal velocity");
    pub const ALTITUDE_GAIN: Written<f64> = (6.0, "6 1/s^2", "gain on the deviation in z");
    pub const CLIMB_GAIN: Written<f64> = (4.0, "4 1/s", "gain on the deviation of the vertical velocity");
    pub const ATTITUDE_GAIN: Written<f64> = (100.0, "100 1/s^2", "gain on the deviation in roll and pitch");
    pub const ATTITUDE_RATE_GAIN: Written<f64> = (16.0, "16 1/s", "gain on the deviation of their rates");
    pub const YAW_GAIN: Written<f64> = (4.0, "4 1/s^2", "gain on the deviation in yaw");
    pub const YAW_RATE_GAIN: Written<f64> = (3.2, "3.2 1/s", "gain on the deviation of the yaw rate");
    pub const GYROSCOPE_NOISE: Written<f64> =
        (0.005, "0.005 rad/s", "standard deviation of a sample, as of a small MEMS gyroscope");
    pub const POSITION_NOISE: Written<f64> = (0.01, "1 cm", "standard deviation of a sample on each axis");
    pub const DRAG: Written<f64> = (0.0, "0 N*s/m", "as in the paper's model");
    pub const WIND: Written<[f64; 3]> = ([0.0; 3], "[0, 0, 0] m/s", "still air");
    pub const GUSTS: Written<f64> = (0.0, "0 m/s", "still air");
    pub const GUST_LENGTH: Written<f64> = (50.0, "50 m", "length scale of gusts");
    pub const LOST_BEYOND: Written<f64> = (2.0, "2 m", "farther from where it should be the vehicle is lost");
    pub const UPSIDE_DOWN: Written<f64> = (0.5, "0.5 s", "tilted past 90 degrees for longer the vehicle is lost");
    pub const LOST_YAW: Written<Option<f64>> =
        (Some(std::f64::consts::FRAC_PI_2), "90 deg", "with its heading farther off the vehicle is lost");
    pub const LOST_YAW_AFTER: Written<f64> = (1.0, "1 s", "how long the heading may be that far off");
    pub const GROUND: Written<f64> = (0.0, "0 m", "height of the ground");
    pub const SEED: Written<u64> = (1, "1", "of noise and gusts");
    pub const CAMPAIGN_SEED: Written<u64> = (1, "1", "what the seeds of the flights are drawn from");
    pub const TIMES: Written<usize> = (20, "20", "instants of the fault along the mission");
    pub const PLANNERS: Written<[PlannerKind; 3]> = (
        [PlannerKind::Rip, PlannerKind::Rsp, PlannerKind::Rcp],
        "[rip, rsp, rcp]",
        "plans that are flown side by side",
    );
    pub const SEEDS: Written<usize> = (10, "10", "flights for each mode and instant");
}

impl Default for Gains {
    fn default() -> Self {
        use default::*;
        Gains {
            position: POSITION_GAIN.0,
            velocity: VELOCITY_GAIN.0,
            altitude: ALTITUDE_GAIN.0,
            climb: CLIMB_GAIN.0,
            attitude: ATTITUDE_GAIN.0,
            attitude_rate: ATTITUDE_RATE_GAIN.0,
            yaw: YAW_GAIN.0,
            yaw_rate: YAW_RATE_GAIN.0,
        }
    }
}

impl Default for Simulation {
    fn default() -> Self {
        use default::*;
        Simulation {
            duration: DURATION.0,
            rate: RATE.0,
            control_rate: CONTROL_RATE.0,
            estimator_rate: ESTIMATOR_RATE.0,
            controller: CONTROLLER.0,
            detection: DETECTION.0,
            after_fault: AFTER_FAULT.0,
            gains: Gains::default(),
            forgetting: FORGETTING.0,
            gyroscope_noise: GYROSCOPE_NOISE.0,
            position_noise: POSITION_NOISE.0,
            drag: DRAG.0,
            wind: WIND.0,
            gusts: GUSTS.0,
            gust_length: GUST_LENGTH.0,
            seed: SEED.0,
            faults: Vec::new(),
            lost_beyond: LOST_BEYOND.0,
            upside_down: UPSIDE_DOWN.0,
            lost_yaw: LOST_YAW.0,
            lost_yaw_after: LOST_YAW_AFTER.0,
            ground: GROUND.0,
            written: false,
            span: Span::default(),
            rate_span: Span::default(),
        }
    }
}

impl Default for Campaign {
    fn default() -> Self {
        Campaign {
            times: default::TIMES.0,
            seeds: default::SEEDS.0,
            planners: default::PLANNERS.0.to_vec(),
            seed: default::CAMPAIGN_SEED.0,
            written: false,
            span: Span::default(),
        }
    }
}
