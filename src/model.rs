//! The model: what the spec means, in SI units. After this stage no string is looked up, every number
//! is a finite `f64`, and every list is complete.

mod after_fault;
mod allow;
mod arithmetic;
mod blame;
mod campaign;
mod context;
mod display;
mod due;
mod elaborate;
mod expression;
mod fault;
mod fields;
mod flight;
mod flight_blocks;
mod function;
pub mod grid;
mod interval;
mod lag;
mod legs;
mod likely_unit;
mod limits;
mod load;
mod magnitude;
mod mend;
mod mission;
mod near_files;
mod overrides;
mod plan;
mod sense;
mod simulate;
mod slip;
mod survey;
mod understanding;
mod unreadable;
mod vehicle;
pub mod vocabulary;

pub use crate::input::MAX_TABLE_BYTES;
pub use elaborate::{elaborate, elaborate_for, understand};
pub use flight::{
    AfterFault, Allocation, Campaign, Controller, Detection, Gains, MOTOR_TIME_CONSTANT, Simulation, Strike,
};
pub use flight_blocks::FlightBlocks;
pub use interval::{RotorSpread, Spread};
pub use load::{FileSet, MAX_FILES, Table, load, load_among, resolve};
pub use mission::MAX_WAYPOINTS;
#[cfg(feature = "lsp")]
pub(crate) use near_files::is_unfit;
pub use near_files::{List, entries};
pub use overrides::{OVERRIDE, Override, is_override, parse_override};
pub use plan::{MAX_ROUNDS, MAX_SAMPLES, MAX_SAMPLES_OF_A_SEARCH};
pub use simulate::{coarse_step, past_the_end, too_many_steps};
pub use understanding::{Reading, Understanding};

use crate::language::Entry;
use crate::source::Span;
use grid::Spacing;

/// A checked spec.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    /// g, m/s^2.
    pub gravity: f64,
    pub vehicle: Vehicle,
    /// Declared fault modes in the order written; the healthy vehicle is not among them.
    pub modes: Vec<FaultMode>,
    /// `None` where the file set only describes vehicles or faults.
    pub mission: Option<Mission>,
    /// The `plan` block, or its defaults where there is none.
    pub plan: Plan,
    /// How the plan is flown.
    pub simulation: Simulation,
    pub campaign: Campaign,
    /// Every default that filled in for something not written, for `check --explain-defaults`.
    pub defaults: Vec<DefaultUsed>,
}

/// `field` took `value` because nothing was written.
#[derive(Debug, Clone, PartialEq)]
pub struct DefaultUsed {
    /// Dotted path, such as `plan.reserve`.
    pub field: String,
    /// As one would write it, such as `10 %`.
    pub value: String,
    pub reason: String,
}

impl DefaultUsed {
    /// Of a field of the language's table.
    fn of(block: &str, entry: &Entry) -> Self {
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
    /// m, kg; where the spec gives an interval, its middle, as with all numbers here.
    pub mass: f64,
    pub mass_spread: Spread,
    /// Diagonal of J: Ixx, Iyy, Izz, kg m^2.
    pub inertia: [f64; 3],
    /// In the spec's order; rotor k of the language is `rotors[k - 1]`.
    pub rotors: Vec<Rotor>,
    /// How a wanted wrench becomes rotor speeds, in flight and so in the sets that plans keep to.
    pub allocation: Allocation,
    pub span: Span,
    pub mass_span: Span,
}

/// P turns counter-clockwise seen from above: its drag torque on the body is negative about z.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spin {
    P,
    N,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Rotor {
    /// Position from the centre of gravity, m: x forward, y left, z up.
    pub position: [f64; 3],
    pub spin: Spin,
    /// b, N s^2 (thrust = b w^2, w in rad/s).
    pub thrust_coefficient: f64,
    /// d, N m s^2 (drag torque = d w^2).
    pub drag_coefficient: f64,
    /// w_min, rad/s: 0 for a rotor that may stop, otherwise below `max_speed`.
    pub min_speed: f64,
    /// w_max, rad/s.
    pub max_speed: f64,
    /// Time constant with which the speed follows its command, s.
    pub time_constant: Option<f64>,
    /// How well these numbers are known.
    pub spread: RotorSpread,
}

impl Rotor {
    /// b w_max^2, N.
    pub fn max_thrust(&self) -> f64 {
        self.thrust_coefficient * self.max_speed * self.max_speed
    }

    /// b w_min^2, N.
    pub fn idle_thrust(&self) -> f64 {
        self.thrust_coefficient * self.min_speed * self.min_speed
    }
}

/// A fault mode sets theta of (32): rotor k gives theta_k b w^2 with w at most w_max.
#[derive(Debug, Clone, PartialEq)]
pub struct FaultMode {
    pub name: String,
    pub title: Option<String>,
    pub doc: Option<String>,
    /// theta, one per rotor, 0..1; 1 for untouched rotors, 0 for lost ones, 1 for stuck ones.
    pub capacity: Vec<f64>,
    /// Some(x) where the thrust is pinned at x of full thrust (0..1).
    pub stuck: Vec<Option<f64>>,
    /// FMEA numbers, 1..10.
    pub severity: Option<u8>,
    pub occurrence: Option<u8>,
    pub detection: Option<u8>,
    /// Failure rate, 1/s.
    pub rate: Option<f64>,
    /// What the mission does after it strikes, where the mode says so itself: see [`Model::after_fault`].
    pub after_fault: Option<AfterFault>,
    pub span: Span,
}

impl FaultMode {
    /// Rotors with capacity 0, counted from 1.
    pub fn lost(&self) -> Vec<usize> {
        (1..=self.capacity.len()).filter(|k| self.capacity[k - 1] == 0.0).collect()
    }

    /// Risk priority number: severity x occurrence x detection, where all three are given.
    pub fn rpn(&self) -> Option<u32> {
        Some(u32::from(self.severity?) * u32::from(self.occurrence?) * u32::from(self.detection?))
    }
}

#[derive(Debug, Clone, PartialEq)]
pub struct Mission {
    pub name: String,
    pub doc: Option<String>,
    /// In flight order; at least two.
    pub waypoints: Vec<Waypoint>,
    /// `legs[i]` leads from `waypoints[i]` to `waypoints[i + 1]`.
    pub legs: Vec<Leg>,
    pub spacing: Spacing,
    /// At rest unless `start moving` / `end moving`.
    pub start_at_rest: bool,
    pub end_at_rest: bool,
    pub limits: Vec<Limit>,
    pub span: Span,
}

impl Mission {
    /// Intervals that leg `leg` needs for a motion near the best: from rest and to rest are four derivatives each to
    /// meet, and with fewer than five intervals a leg from rest to rest has no choice left, or no motion at all.
    pub fn least_intervals(&self, leg: usize) -> usize {
        let last = self.waypoints.len() - 1;
        let rests = |at: usize| self.waypoints[at].hold > 0.0;
        let from = rests(leg) || leg == 0 && self.start_at_rest;
        let to = rests(leg + 1) || leg + 1 == last && self.end_at_rest;
        match (from, to) {
            (true, true) => 10,
            (true, false) | (false, true) => 5,
            (false, false) => 1,
        }
    }

    /// Whether some waypoint between start and end has no time of its own, so that legs can divide time in more than one way.
    pub fn leaves_times_free(&self) -> bool {
        let between = self.waypoints.split_last().map_or(&[][..], |(_, others)| others);
        between.iter().skip(1).any(|w| w.time.is_none())
    }

    /// Samples that holds and legs need ([`Mission::least_intervals`]); fewer are warned of.
    pub fn samples_needed(&self) -> usize {
        let holds = self.waypoints.iter().filter(|w| w.hold > 0.0).count();
        holds + (0..self.legs.len()).map(|leg| self.least_intervals(leg)).sum::<usize>()
    }

    /// Whether all waypoints ask for the same yaw, to rounding (1e-12 rad).
    pub fn has_one_yaw(&self) -> bool {
        self.waypoints.iter().all(|w| (w.yaw - self.waypoints[0].yaw).abs() < 1e-12)
    }
}

#[derive(Debug, Clone, PartialEq)]
pub struct Waypoint {
    pub name: Option<String>,
    /// World frame, m, z up.
    pub position: [f64; 3],
    /// psi, rad, unwrapped along the mission (turns take the shorter way).
    pub yaw: f64,
    /// Position tolerance, m (Euclidean), > 0.
    pub within: f64,
    /// Yaw tolerance, rad, > 0.
    pub yaw_within: f64,
    /// alpha_i of (47), >= 0.
    pub weight: f64,
    /// Arrival time since the start of the mission, s, where the spec fixes it.
    pub time: Option<f64>,
    /// How long the vehicle stands still here after arriving, s; 0 where it flies on.
    pub hold: f64,
    /// The statement that made it: parameter and range of a `curve` for its points, the row of a table.
    pub span: Span,
    pub time_span: Option<Span>,
    pub hold_span: Option<Span>,
}

/// A leg's share of the time that fixed times and holds leave free.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leg {
    /// > 0; only ratios between legs matter.
    pub share: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LimitKind {
    X,
    Y,
    /// `z` and `altitude`.
    Z,
    Yaw,
    Speed,
    SpeedHorizontal,
    Climb,
    Descent,
    Acceleration,
    AccelerationHorizontal,
    Jerk,
    YawRate,
    YawAcceleration,
    Tilt,
}

/// One limit in SI units. For `Speed`, `Acceleration`, `Jerk`, `Tilt` and the horizontal ones only `upper` is set:
/// they bound a norm. `Climb` bounds the upward speed, `Descent` the downward speed (both upper, >= 0). A single
/// `<=` on `YawRate` or `YawAcceleration` bounds both directions (lower = -upper).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    pub kind: LimitKind,
    pub lower: Option<f64>,
    pub upper: Option<f64>,
    pub span: Span,
}

impl Limit {
    /// What an excess is measured against, in its SI unit: the larger bound, and 1 if that is more.
    pub fn size(&self) -> f64 {
        self.upper.unwrap_or(0.0).abs().max(self.lower.unwrap_or(0.0).abs()).max(1.0)
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlannerKind {
    /// Risk-insensitive: the healthy set.
    Rip,
    /// Risk-conservative: the intersection of the modes' sets.
    Rcp,
    /// Risk-sensitive: the healthy set and the facets the RIP plan violates.
    Rsp,
}

impl PlannerKind {
    pub fn name(self) -> &'static str {
        match self {
            PlannerKind::Rip => "rip",
            PlannerKind::Rcp => "rcp",
            PlannerKind::Rsp => "rsp",
        }
    }
}

/// What a plan takes for the wrench of its motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlanModel {
    /// The paper's, linear about hover.
    Hover,
    /// Exact, by differential flatness.
    Exact,
}

impl PlanModel {
    pub fn name(self) -> &'static str {
        match self {
            PlanModel::Hover => "hover",
            PlanModel::Exact => "exact",
        }
    }
}

/// How plans take the rotors to follow their commands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlanRotors {
    /// At once: any admissible wrench can follow any other.
    Instant,
    /// With [`Model::thrust_lag`].
    Lagging,
}

impl PlanRotors {
    pub fn name(self) -> &'static str {
        match self {
            PlanRotors::Instant => "instant",
            PlanRotors::Lagging => "lagging",
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MissionTime {
    Minimum,
    /// s
    Fixed(f64),
}

#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    pub planner: PlannerKind,
    pub model: PlanModel,
    pub rotors: PlanRotors,
    /// Whether the planner chooses when waypoints are passed, beyond fixed times.
    pub chooses_times: bool,
    /// Indices into [`Model::modes`], in the order written, without repeats.
    pub against: Vec<usize>,
    pub time: MissionTime,
    /// Intervals of the whole mission.
    pub samples: usize,
    /// Share of each set kept for feedback, 0 <= reserve < 1.
    pub reserve: f64,
    /// Weight of the integral of x''''^2 + y''''^2 (1/(m^2 s^-8 s)).
    pub snap_weight: f64,
    /// Weight of the integral of z''^2 + psi''^2.
    pub acceleration_weight: f64,
    /// The `plan` block, or the mission where there is none.
    pub span: Span,
    pub against_span: Span,
    pub time_span: Span,
    pub samples_span: Span,
    pub reserve_span: Span,
    pub rotors_span: Span,
    /// How often RSP selects facets, at one mission time (step (e)): 0 is RIP, 1 the paper's RSP.
    pub rounds: usize,
    /// The largest risk that the plan may have: the planner then chooses what to protect.
    pub require_risk: Option<f64>,
    /// What the mission does after a fault, for the risk: [`AfterFault::Continue`] or [`AfterFault::Hold`]. A mode may say
    /// otherwise: see [`Model::after_fault`].
    pub after_fault: AfterFault,
    /// The `require` statement, or the plan's place where there is none.
    pub require_span: Span,
}
