//! What a fault does to the path: the largest deviation, waypoints missed, limits and heading broken (`docs/flight.md`,
//! section 5, "The path after a fault"). None of this loses a vehicle.

use super::Sortie;
use super::body::Body;
use super::reference::{Course, Reference};
use crate::model::{Environment, Limit, LimitKind, Mission, Part};
use crate::motion::checks::{leg_intervals, violation};
use crate::motion::{NodeState, Trajectory, X, Y, YAW, Z};
use crate::tolerance::MOST_MISS;
use nalgebra::Vector3;

/// The heading is broken beyond this error, rad (30 degrees): a third of the default of `lost_yaw`, and several times
/// the largest heading error that healthy flights of the paper's octocopter have.
pub const HEADING_BROKEN: f64 = std::f64::consts::FRAC_PI_6;

/// A limit is broken where it is exceeded by more than this share of its size ([`Limit::size`]); of places (coordinates
/// and volumes) by more than this, m. Plans use their limits up, so that every flight exceeds some by its tracking
/// error.
pub const LIMIT_BROKEN: f64 = 0.1;

/// The limits that are judged, in the words of the language; `volume` stands for those of volumes and corridors.
const WORDS: [&str; 12] = [
    "x",
    "y",
    "altitude",
    "speed",
    "speed_horizontal",
    "climb",
    "descent",
    "acceleration",
    "acceleration_horizontal",
    "yaw_rate",
    "tilt",
    "volume",
];

/// The place in [`WORDS`] of a limit; `None` for those that are not judged: limits on yaw, which the heading error
/// judges, directions of arrival, and derivatives that a vehicle with noisy motors has no smooth values of.
fn class(limit: &Limit) -> Option<usize> {
    if limit.volume.is_some() {
        return Some(WORDS.len() - 1);
    }
    match limit.kind {
        LimitKind::X => Some(0),
        LimitKind::Y => Some(1),
        LimitKind::Z => Some(2),
        LimitKind::Speed => Some(3),
        LimitKind::SpeedHorizontal => Some(4),
        LimitKind::Climb => Some(5),
        LimitKind::Descent => Some(6),
        LimitKind::Acceleration => Some(7),
        LimitKind::AccelerationHorizontal => Some(8),
        LimitKind::YawRate => Some(9),
        LimitKind::Tilt => Some(10),
        LimitKind::Face(_) | LimitKind::Distance(_) | LimitKind::Clearance(_) => Some(11),
        LimitKind::Yaw | LimitKind::Jerk | LimitKind::YawAcceleration => None,
        LimitKind::Arrival(_) | LimitKind::Heading(_) => None,
    }
}

/// Whether flights are judged by the limit.
pub fn is_judged(limit: &Limit) -> bool {
    class(limit).is_some()
}

/// A set of broken limits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct BrokenLimits(u16);

impl BrokenLimits {
    /// Number of limits that are judged.
    pub const COUNT: usize = WORDS.len();

    /// The words of all limits that are judged.
    pub fn all() -> [&'static str; Self::COUNT] {
        WORDS
    }

    /// Whether the limit in this place of [`BrokenLimits::all`] is broken.
    pub fn has(self, class: usize) -> bool {
        self.0 >> class & 1 == 1
    }

    /// Whether any limit is broken.
    pub fn any(self) -> bool {
        self.0 != 0
    }

    fn insert(&mut self, class: usize) {
        self.0 |= 1 << class;
    }

    /// The words of the limits that are broken.
    pub fn words(self) -> Vec<&'static str> {
        (0..WORDS.len()).filter(|&k| self.has(k)).map(|k| WORDS[k]).collect()
    }

    /// `speed+tilt`, or `none`.
    pub fn text(self) -> String {
        let words = self.words();
        if words.is_empty() { "none".into() } else { words.join("+") }
    }

    /// Reads what [`BrokenLimits::text`] writes, its words in any order.
    pub fn read(text: &str) -> Option<Self> {
        let mut broken = BrokenLimits::default();
        if text != "none" {
            for word in text.split('+') {
                broken.insert(WORDS.iter().position(|known| *known == word)?);
            }
        }
        Some(broken)
    }
}

/// What happened to the path since the first fault, or over the whole flight if it has none.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Damage {
    /// Largest distance from the reference position, m.
    pub max_error: f64,
    /// Largest height below the reference, m; 0 if the vehicle was never below it.
    pub max_drop: f64,
    /// Waypoints that were due.
    pub waypoints_due: usize,
    /// Those of them that were missed by more than their tolerance.
    pub waypoints_missed: usize,
    /// The one that was missed by most of those whose turn came.
    pub worst_miss: Option<Miss>,
    pub limits: BrokenLimits,
    /// Whether the heading error exceeded [`HEADING_BROKEN`] before yaw was given up on purpose.
    pub heading_broken: bool,
}

/// A waypoint that was missed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Miss {
    /// Its index in [`Mission::waypoints`].
    pub waypoint: usize,
    /// By how much more than its tolerance, m.
    pub beyond: f64,
}

/// A waypoint: passed where the vehicle comes within its tolerance between the middles, in time, of the legs before and
/// after it.
#[derive(Debug, Clone, Copy)]
struct Gate {
    /// When the plan reaches it, and until when the vehicle may, s.
    time: f64,
    until: f64,
    /// m
    place: Vector3<f64>,
    within: f64,
}

/// A limit that is judged.
#[derive(Debug, Clone, Copy)]
struct JudgedLimit<'a> {
    limit: &'a Limit,
    class: usize,
    /// By how much it may be exceeded, in its SI unit.
    slack: f64,
    /// When it holds, s; `None` for the whole flight.
    span: Option<[f64; 2]>,
}

/// The errors at a sample.
#[derive(Debug, Clone, Copy)]
pub(super) struct Errors {
    /// Distance from the reference position, m.
    pub(super) position: f64,
    /// rad
    pub(super) tilt: f64,
    /// rad; `None` once yaw is given up on purpose.
    pub(super) heading: Option<f64>,
}

/// Collects the [`Damage`] of a flight.
#[derive(Debug, Clone)]
pub(super) struct Collector<'a> {
    gates: Vec<Gate>,
    bounds: Vec<JudgedLimit<'a>>,
    needs_acceleration: bool,
    needs_yaw_rate: bool,
    environment: Environment,
    /// Index of the waypoint whose turn it is, and the nearest distance from it so far, m.
    next: usize,
    nearest: f64,
    /// Since when the path is judged, and when a stop began, s.
    from: f64,
    stopped: f64,
    damage: Damage,
}

impl<'a> Collector<'a> {
    /// For a flight; without its mission, or along a stop, there are neither waypoints nor limits.
    pub(super) fn new(sortie: &Sortie<'a>) -> Self {
        let (gates, bounds) = match (&sortie.course, sortie.mission) {
            (Course::Plan(trajectory), Some(mission)) => (gates(trajectory, mission), bounds(trajectory, mission)),
            _ => (Vec::new(), Vec::new()),
        };
        let needs = |kinds: &[LimitKind]| bounds.iter().any(|bound| kinds.contains(&bound.limit.kind));
        Collector {
            needs_acceleration: needs(&[LimitKind::Acceleration, LimitKind::AccelerationHorizontal]),
            needs_yaw_rate: needs(&[LimitKind::YawRate]),
            gates,
            bounds,
            environment: sortie.model.environment(),
            next: 0,
            nearest: f64::INFINITY,
            from: sortie.strikes.first().map_or(0.0, |strike| strike.at),
            stopped: f64::INFINITY,
            damage: Damage::default(),
        }
    }

    /// A stop has begun at `t` s: the waypoints that are still to come are given up on purpose.
    pub(super) fn stop(&mut self, t: f64) {
        self.stopped = self.stopped.min(t);
    }

    /// Processes a sample at time `t` (s); `acceleration` gives that of the body, m/s^2, where a limit needs it.
    pub(super) fn look(
        &mut self,
        t: f64,
        body: &Body,
        reference: &Reference,
        errors: Errors,
        acceleration: impl FnOnce() -> Vector3<f64>,
    ) {
        while let Some(gate) = self.gates.get(self.next).copied() {
            if t <= gate.until {
                self.nearest = self.nearest.min((body.position - gate.place).norm());
                break;
            }
            self.pass(gate);
        }
        if t < self.from {
            return;
        }
        let damage = &mut self.damage;
        damage.max_error = damage.max_error.max(errors.position);
        damage.max_drop = damage.max_drop.max(reference.position.z - body.position.z);
        damage.heading_broken |= errors.heading.is_some_and(|error| error.abs() > HEADING_BROKEN);
        self.judge(t, body, errors, acceleration);
    }

    /// Judges the limits that hold at `t` s and are not broken yet.
    fn judge(&mut self, t: f64, body: &Body, errors: Errors, acceleration: impl FnOnce() -> Vector3<f64>) {
        let (broken, keeps_yaw) = (self.damage.limits, errors.heading.is_some());
        let holds = |bound: &&JudgedLimit| {
            let now = bound.span.is_none_or(|[begin, end]| (begin..=end).contains(&t) && t < self.stopped);
            now && !broken.has(bound.class) && (keeps_yaw || bound.limit.kind != LimitKind::YawRate)
        };
        let mut due = self.bounds.iter().filter(holds).peekable();
        if due.peek().is_none() {
            return;
        }
        let acceleration = if self.needs_acceleration { acceleration() } else { Vector3::zeros() };
        let state = state(body, &acceleration, self.needs_yaw_rate);
        for bound in due {
            let over = match (&bound.limit.kind, bound.limit.upper) {
                (LimitKind::Tilt, Some(upper)) => errors.tilt - upper,
                _ => violation(bound.limit, &state, &self.environment),
            };
            if over > bound.slack {
                self.damage.limits.insert(bound.class);
            }
        }
    }

    /// Counts the waypoint whose turn is over.
    fn pass(&mut self, gate: Gate) {
        if gate.time >= self.from && gate.time <= self.stopped {
            self.damage.waypoints_due += 1;
            let miss = Miss { waypoint: self.next, beyond: self.nearest - gate.within };
            self.damage.waypoints_missed += usize::from(miss.beyond > MOST_MISS);
            let is_worst = self.damage.worst_miss.is_none_or(|worst| worst.beyond < miss.beyond);
            if miss.beyond > MOST_MISS && miss.beyond.is_finite() && is_worst {
                self.damage.worst_miss = Some(miss);
            }
        }
        self.next += 1;
        self.nearest = f64::INFINITY;
    }

    /// The damage of a flight that ended at `end` s. A vehicle that was lost misses the waypoints that were still to
    /// come.
    pub(super) fn finish(&mut self, end: f64, is_lost: bool) -> Damage {
        while let Some(gate) = self.gates.get(self.next).copied().filter(|gate| is_lost || gate.time <= end) {
            self.pass(gate);
        }
        self.damage
    }
}

/// The motion of a body in the variables in which limits are written; yaw itself is not in it.
fn state(body: &Body, acceleration: &Vector3<f64>, with_yaw_rate: bool) -> NodeState {
    let mut state = NodeState::default();
    for (k, axis) in [X, Y, Z].into_iter().enumerate() {
        (state[axis][0], state[axis][1], state[axis][2]) = (body.position[k], body.velocity[k], acceleration[k]);
    }
    if with_yaw_rate {
        // psi' = (Q sin(phi) + R cos(phi))/cos(theta), (6) of the paper.
        let [roll, pitch, _] = body.angles();
        state[YAW][1] = (body.rates.y * roll.sin() + body.rates.z * roll.cos()) / pitch.cos();
    }
    state
}

fn gates(trajectory: &Trajectory, mission: &Mission) -> Vec<Gate> {
    let times: Vec<f64> = trajectory.waypoint_nodes.iter().map(|&node| trajectory.times[node]).collect();
    let last = times.len().saturating_sub(1);
    let gate = |(k, waypoint): (usize, &crate::model::Waypoint)| Gate {
        time: times[k],
        until: match k < last {
            true => 0.5 * (times[k] + times[k + 1]),
            // Its turn ends as long after the flight as it began before.
            false => times[k] + 0.5 * (times[k] - times[k.saturating_sub(1)]),
        },
        place: waypoint.position.into(),
        within: waypoint.within,
    };
    mission.waypoints.iter().take(times.len()).enumerate().map(gate).collect()
}

fn bounds<'a>(trajectory: &Trajectory, mission: &'a Mission) -> Vec<JudgedLimit<'a>> {
    let bound = |limit: &'a Limit| {
        let class = class(limit)?;
        let span = match limit.leg.as_deref() {
            None => None,
            Some(on) if on.part == Part::Whole => {
                let nodes = leg_intervals(trajectory, mission, on.leg);
                Some([trajectory.times[nodes.start], trajectory.times[nodes.end]])
            }
            Some(_) => return None,
        };
        let is_position = limit.kind.is_of_place() && !limit.kind.is_of_yaw();
        let size = if is_position { 1.0 } else { limit.size() };
        Some(JudgedLimit { limit, class, slack: LIMIT_BROKEN * size, span })
    };
    mission.limits.iter().filter_map(bound).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn broken_limits_read_back_as_written() {
        let mut broken = BrokenLimits::default();
        assert_eq!((broken.text().as_str(), BrokenLimits::read("none")), ("none", Some(broken)));
        broken.insert(10);
        broken.insert(3);
        assert_eq!(broken.text(), "speed+tilt");
        assert_eq!(BrokenLimits::read("tilt+speed"), Some(broken));
        assert_eq!((BrokenLimits::read("speed+mood"), BrokenLimits::read("")), (None, None));
    }
}
