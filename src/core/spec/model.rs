//! The model: the meaning of a spec in SI units. After this stage no name is looked up, every number
//! is a finite `f64`, and every list is complete.

mod after_fault;
mod air;
mod battery;
pub mod capture_height;
mod display;
mod fault;
mod flight_settings;
pub mod grid;
mod heading;
mod interval;
mod lag;
pub mod legs;
mod limits;
mod origin;
mod parts;
mod plan_settings;
mod problem;
mod recovery;
pub mod volume;
mod without_yaw;
mod yaw_drag;

pub use crate::body::{Body, Obstacle};
pub use air::{Air, Environment, STANDARD_DENSITY};
pub use battery::Battery;
pub use fault::{FaultMode, RotorState};
pub use flight_settings::{
    AfterFault, Allocation, Attitude, Campaign, Controller, Detection, FlownVehicle, Gains, LostYaw,
    MOTOR_TIME_CONSTANT, Simulation, Strike,
};
pub use heading::{Heading, SLOWEST, Target};
pub use interval::{DynamicFigure, RotorSpread, Spread};
pub use lag::SLOWEST_SHARE;
pub use limits::{Description, DistanceFrom, Limit, LimitKind, OnLeg, Part, Quantity, USUAL_SPEED};
pub use origin::Origin;
pub use parts::{Composite, Part as VehiclePart, Shape as PartShape};
pub use plan_settings::{
    CaptureHeight, MAX_ROUNDS, MAX_SAMPLES, MAX_SAMPLES_OF_A_SEARCH, MAX_WAYPOINTS, MissionTime, PlanModel, PlanRotors,
    PlanSettings, PlannerKind, SearchEffort,
};
pub use problem::Problem;
pub use recovery::{
    AfterFaultRules, HeldLimit, KeepOff, LandingSite, Recoverable, Recovery, RecoverySettings, STOPS_TURNING, TOUCHDOWN,
};
pub use volume::{Boundary, Side as VolumeSide, Volume};
pub use without_yaw::GiveUpYaw;
pub use yaw_drag::YawDrag;

use crate::language::Entry;
use crate::source::Span;
use grid::Spacing;

/// A checked spec. A changed copy is not checked again.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    /// Acceleration of gravity g, m/s^2.
    pub gravity: f64,
    /// The vehicle that the plan chooses.
    pub vehicle: Vehicle,
    /// Declared fault modes in the order written, without the healthy vehicle.
    pub modes: Vec<FaultMode>,
    /// The mission that the plan chooses; `None` if the spec has no mission.
    pub mission: Option<Mission>,
    /// The `plan` block, or its defaults.
    pub plan: PlanSettings,
    /// How the plan is flown: the `simulate` block, or its defaults.
    pub simulation: Simulation,
    /// The `campaign` block, or its defaults.
    pub campaign: Campaign,
    /// Every default that was used for something not written, for `check --explain-defaults`.
    pub defaults: Vec<DefaultUsed>,
}

#[deprecated = "renamed to `PlanSettings`"]
pub type Plan = PlanSettings;

/// A default that was used because a field is not written.
#[derive(Debug, Clone, PartialEq)]
pub struct DefaultUsed {
    /// Dotted path of the field, such as `plan.reserve`.
    pub field: String,
    /// The default as written in a spec, such as `10 %`.
    pub value: String,
    /// What the default means.
    pub reason: String,
}

impl DefaultUsed {
    /// The default of a field of the language table.
    pub fn of(block: &str, entry: &Entry) -> Self {
        let (value, reason) = entry.default().unwrap_or_default();
        DefaultUsed { field: format!("{block}.{}", entry.name), value: value.into(), reason: reason.into() }
    }
}

/// The vehicle: mass, inertia and rotors with parallel axes along body z.
#[derive(Debug, Clone, PartialEq)]
pub struct Vehicle {
    pub name: String,
    pub doc: Option<String>,
    /// The layout string of a ring, `None` where rotors are placed one by one.
    pub layout: Option<String>,
    /// Mass m, kg. This and all numbers of the vehicle are the middles of intervals where the spec gives intervals.
    pub mass: f64,
    /// The interval of the mass, relative to its middle.
    pub mass_spread: Spread,
    /// Diagonal of the inertia matrix J: Ixx, Iyy, Izz, kg m^2.
    pub inertia: [f64; 3],
    /// From the frame's origin, m: where the spec places rotors from the origin of its frame. `None` if it places them
    /// from the centre of gravity.
    pub centre_of_gravity: Option<[f64; 3]>,
    /// Linear drag along the axes x, y and z of the body, N s/m: the force along an axis is -drag times the velocity
    /// through the air along it. 0 if the spec gives none.
    pub drag: [f64; 3],
    /// The interval of `drag`, relative to its middle, the same along all axes. Plans are made for the middle:
    /// certificates and reports name it.
    pub drag_spread: Spread,
    /// The place of `drag`, if the spec gives it.
    pub drag_span: Option<Span>,
    /// The drag of the body that turns about z; `None` if the spec gives none.
    pub yaw_drag: Option<YawDrag>,
    /// Radius of a propeller, m, if the spec gives it.
    pub propeller_radius: Option<f64>,
    /// Radius about the centre of gravity within which the vehicle stays, m, if the spec gives it; see
    /// [`Vehicle::radius`].
    pub size: Option<f64>,
    /// In the order of the spec: rotor k of the language is `rotors[k - 1]`.
    pub rotors: Vec<Rotor>,
    /// How a commanded wrench becomes rotor speeds, in flights and in the admissible sets of plans.
    pub allocation: Allocation,
    pub battery: Option<Battery>,
    pub span: Span,
    pub mass_span: Span,
}

/// The direction in which a rotor turns, seen from above.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spin {
    /// Counter-clockwise: the drag torque on the body is negative about z.
    P,
    /// Clockwise: the drag torque on the body is positive about z.
    N,
}

/// One rotor: thrust and drag torque grow with the square of its speed.
#[derive(Debug, Clone, PartialEq)]
pub struct Rotor {
    /// Position from the centre of gravity, m: x forward, y left, z up.
    pub position: [f64; 3],
    pub spin: Spin,
    /// b, N s^2 (thrust = b w^2, w in rad/s).
    pub thrust_coefficient: f64,
    /// d, N m s^2 (drag torque = d w^2).
    pub drag_coefficient: f64,
    /// w_min, rad/s: 0 for a rotor that may stop, below 0 for one that may reverse, always below `max_speed`.
    pub min_speed: f64,
    /// w_max, rad/s; with a battery, that at the lowest charge ([`Battery::lowest_full_thrust`]).
    pub max_speed: f64,
    /// Time constant with which the speed follows its command, s; `None` if the spec gives none.
    pub time_constant: Option<f64>,
    /// Moment of inertia about its axis, kg m^2; 0 if the spec gives none.
    pub inertia: f64,
    /// The interval of `inertia`, relative to its middle.
    pub inertia_spread: Spread,
    /// The number of its motor at the autopilot; `None` if the spec gives none.
    pub motor: Option<u32>,
    /// The intervals of these numbers.
    pub spread: RotorSpread,
}

impl Vehicle {
    /// The autopilot's numbers of the motors, in the order of the rotors; `None` if the spec gives none.
    pub fn motors(&self) -> Option<Vec<u32>> {
        self.rotors.iter().map(|rotor| rotor.motor).collect()
    }

    /// Whether some rotor has a moment of inertia.
    pub fn has_rotor_inertia(&self) -> bool {
        self.rotors.iter().any(|rotor| rotor.inertia > 0.0)
    }

    /// The autopilot's numbers where they differ from the rotors' own.
    pub fn other_motors(&self) -> Option<Vec<u32>> {
        self.motors().filter(|motors| !motors.iter().copied().eq(1..=motors.len() as u32))
    }
}

impl Rotor {
    /// Full thrust, b w_max^2, N.
    pub fn max_thrust(&self) -> f64 {
        self.thrust_coefficient * self.max_speed * self.max_speed
    }

    /// Thrust at the lowest speed, b w_min |w_min|, N.
    pub fn idle_thrust(&self) -> f64 {
        self.thrust_coefficient * self.min_speed * self.min_speed.abs()
    }

    /// Whether the rotor may turn backwards.
    pub fn is_reversible(&self) -> bool {
        self.min_speed < 0.0
    }
}

/// A mission: waypoints in flight order, the legs between them, and limits on the motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Mission {
    pub name: String,
    pub doc: Option<String>,
    /// In flight order; at least two.
    pub waypoints: Vec<Waypoint>,
    /// `legs[i]` leads from `waypoints[i]` to `waypoints[i + 1]`.
    pub legs: Vec<Leg>,
    /// How the time grid divides each leg.
    pub spacing: Spacing,
    /// Whether the mission starts at rest; `false` with `start moving`.
    pub start_at_rest: bool,
    /// Whether the mission ends at rest; `false` with `end moving`.
    pub end_at_rest: bool,
    /// The limits of the `limits` block, then those that `volumes` impose on this vehicle.
    pub limits: Vec<Limit>,
    pub volumes: Vec<Volume>,
    pub air: Air,
    /// z of the ground, below every waypoint, m, if the spec gives it.
    pub ground: Option<f64>,
    /// Where `[0, 0, 0] m` is on the Earth, if the spec gives it.
    pub origin: Option<Origin>,
    /// What holds after a fault, and where the vehicle may come down then.
    pub after_fault: AfterFaultRules,
    pub span: Span,
}

impl Mission {
    /// The number of intervals that leg `leg` needs for a nearly optimal motion. A rest at one end fixes four
    /// derivatives there; with fewer than five intervals a leg from rest to rest has no freedom left, or no motion at
    /// all.
    ///
    /// # Panics
    /// If there is no such leg.
    pub fn least_intervals(&self, leg: usize) -> usize {
        match (self.rests_at(leg), self.rests_at(leg + 1)) {
            (true, true) => 10,
            (true, false) | (false, true) => 5,
            (false, false) => 1,
        }
    }

    /// Whether the spec fixes the time of some waypoint after the first.
    pub fn has_fixed_times(&self) -> bool {
        self.waypoints.iter().skip(1).any(|w| w.time.is_some())
    }

    /// The constraints under which a lower bound on the time holds, in words; with `faults` they leave less thrust.
    pub fn bounded_within(&self, faults: bool) -> &'static str {
        match (faults, self.has_fixed_times()) {
            (false, false) => "within limits and thrust",
            (false, true) => "within limits and thrust and at the fixed times",
            (true, false) => "within limits and remaining thrust",
            (true, true) => "within limits and remaining thrust and at the fixed times",
        }
    }

    /// Whether the vehicle is at rest when it reaches a waypoint.
    ///
    /// # Panics
    /// If there is no such waypoint.
    pub fn rests_at(&self, waypoint: usize) -> bool {
        let Waypoint { hold, stop, .. } = self.waypoints[waypoint];
        let last = self.waypoints.len() - 1;
        hold > 0.0 || stop || waypoint == 0 && self.start_at_rest || waypoint == last && self.end_at_rest
    }

    /// Whether some waypoint between start and end has no fixed time, so that legs can divide the time in more than one
    /// way.
    pub fn leaves_times_free(&self) -> bool {
        let between = self.waypoints.split_last().map_or(&[][..], |(_, others)| others);
        between.iter().skip(1).any(|w| w.time.is_none())
    }

    /// The number of samples that holds and legs need ([`Mission::least_intervals`]); a plan with fewer gets a warning.
    pub fn samples_needed(&self) -> usize {
        let holds = self.waypoints.iter().filter(|w| w.hold > 0.0).count();
        holds + (0..self.legs.len()).map(|leg| self.least_intervals(leg)).sum::<usize>()
    }

    /// Whether all waypoints have the same given yaw, up to rounding (1e-12 rad).
    pub fn has_one_yaw(&self) -> bool {
        self.waypoints.iter().all(|w| w.heading == Heading::Given && (w.yaw - self.waypoints[0].yaw).abs() < 1e-12)
    }
}

/// A waypoint with its tolerances.
#[derive(Debug, Clone, PartialEq)]
pub struct Waypoint {
    pub name: Option<String>,
    /// Position in the world frame, m: x east, y north, z up.
    pub position: [f64; 3],
    /// Yaw psi, rad, unwrapped along the mission (turns take the shorter way). If it follows from the motion, that at
    /// the waypoint itself, as far as the waypoints tell it.
    pub yaw: f64,
    /// Position tolerance (Euclidean), m; positive.
    pub within: f64,
    /// What the yaw follows from; `yaw` and `yaw_within` are required if it is given.
    pub heading: Heading,
    /// Yaw tolerance, rad; positive.
    pub yaw_within: f64,
    /// Weight alpha_i of the paper's (47); not negative.
    pub weight: f64,
    /// Fixed arrival time since the start of the mission, s; `None` if it is free.
    pub time: Option<f64>,
    /// How long the vehicle stays at rest here after arriving, s; 0 if it flies on.
    pub hold: f64,
    /// Whether the vehicle comes to rest here even without a hold.
    pub stop: bool,
    /// The place of its statement: for a `curve`, parameter and range; for a table, the row.
    pub span: Span,
    pub time_span: Option<Span>,
    pub hold_span: Option<Span>,
}

/// The part of a mission between two consecutive waypoints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leg {
    /// Share of the time that fixed times and holds leave free; positive. Only ratios between legs matter.
    pub share: f64,
}
