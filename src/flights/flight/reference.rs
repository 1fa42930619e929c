//! The reference that a flight follows: the plan, a stop, or a descent after a stop (`docs/flight.md`, section 5).

use crate::flatness::rotor_drag;
use crate::model::Environment;
use crate::motion::{NodeState, Trajectory, X, Y, YAW, Z};
use nalgebra::Vector3;
use std::borrow::Cow;

/// Nominal deceleration of a stop, m/s^2.
const BRAKING: f64 = 3.0;
/// Shortest duration of a stop, s; the vertical part may be shorter close to the ground.
const SHORTEST_STOP: f64 = 1.5;
/// A stop is gentle if its largest acceleration is at most this many times the larger of the initial acceleration and
/// the nominal deceleration.
const GENTLE: f64 = 1.1;

/// Speed of a descent, m/s.
pub const DESCENT: f64 = 1.0;
/// Time from rest to the speed of a descent, s.
const EASING: f64 = 2.0;

/// The reference at an instant, world frame.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Reference {
    /// m
    pub position: Vector3<f64>,
    /// m/s
    pub velocity: Vector3<f64>,
    /// m/s^2
    pub acceleration: Vector3<f64>,
    /// m/s^3
    pub jerk: Vector3<f64>,
    /// m/s^4
    pub snap: Vector3<f64>,
    /// psi, psi', psi'': rad, rad/s, rad/s^2.
    pub yaw: [f64; 3],
}

/// What the vehicle follows.
#[derive(Debug, Clone)]
pub enum Course<'a> {
    /// The plan, and after its end its last position at rest.
    Plan(&'a Trajectory),
    /// A stop, then hover or a descent.
    Stop(Box<Stop>),
    /// A plan that is left for a branch.
    Branch(Box<Branching<'a>>),
}

/// A plan up to some time, then a branch, then rest where that ends, or the plan again.
#[derive(Debug, Clone)]
pub struct Branching<'a> {
    pub plan: &'a Trajectory,
    /// When the branch begins, s since the start of the plan.
    pub begins: f64,
    /// The branch from 0 s on.
    pub motion: Cow<'a, Trajectory>,
    /// Whether the branch ends in the plan.
    pub returns: bool,
    /// How fast the reference sinks where the branch has ended and does not return, m/s.
    pub sink: f64,
}

impl Branching<'_> {
    fn at(&self, t: f64) -> Reference {
        let ends = self.begins + self.motion.duration();
        match t {
            t if t < self.begins || (t > ends && self.returns) => along(self.plan, t),
            t if t > ends => {
                let rest = along(&self.motion, t - self.begins);
                let position = rest.position - Vector3::z() * self.sink * (t - ends);
                Reference { position, velocity: -Vector3::z() * self.sink, ..rest }
            }
            t => along(&self.motion, t - self.begins),
        }
    }
}

/// The reference along a motion, at its last position at rest after its end.
fn along(motion: &Trajectory, t: f64) -> Reference {
    if t > motion.duration() {
        let s = &motion.nodes[motion.intervals()];
        let position = Vector3::new(s[X][0], s[Y][0], s[Z][0]);
        return Reference { position, yaw: [s[YAW][0], 0.0, 0.0], ..Reference::default() };
    }
    Reference::of(motion.at(t))
}

impl Reference {
    /// The reference of the derivatives of position and yaw at an instant.
    fn of(state: NodeState) -> Reference {
        let order = |i: usize| Vector3::new(state[X][i], state[Y][i], state[Z][i]);
        let [psi, rate, acceleration, ..] = state[YAW];
        Reference {
            position: order(0),
            velocity: order(1),
            acceleration: order(2),
            jerk: order(3),
            snap: order(4),
            yaw: [psi, rate, acceleration],
        }
    }

    /// The reference with acceleration, jerk and snap replaced by those of the thrust over mass less gravity, like
    /// [`crate::motion::in_air`]: what a controller demands that knows this air. In free fall, where the attitude of a
    /// drag for each axis of the body is not defined, the drag is taken to be isotropic.
    pub fn in_air(&self, environment: &Environment) -> Reference {
        if !environment.has_drag() {
            return *self;
        }
        if !environment.is_isotropic() {
            let orders = [self.velocity, self.acceleration, self.jerk, self.snap].map(Into::into);
            let [thrust, jerk, snap] = rotor_drag::thrust_vector(environment, orders, self.yaw).map(Vector3::from);
            let acceleration = thrust - Vector3::z() * environment.gravity;
            let felt = Reference { acceleration, jerk, snap, ..*self };
            if felt.is_finite() {
                return felt;
            }
        }
        let rate = environment.turning_rate();
        Reference {
            acceleration: self.acceleration + (self.velocity - Vector3::from(environment.wind)) * rate,
            jerk: self.jerk + self.acceleration * rate,
            snap: self.snap + self.jerk * rate,
            ..*self
        }
    }

    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        let vectors = [&self.position, &self.velocity, &self.acceleration, &self.jerk, &self.snap];
        vectors.iter().all(|v| v.iter().all(|x| x.is_finite())) && self.yaw.iter().all(|x| x.is_finite())
    }
}

impl Course<'_> {
    /// When it comes to its end, s since the start; that of a stop is its rest.
    pub(super) fn end(&self) -> f64 {
        match self {
            Course::Plan(trajectory) => trajectory.duration(),
            Course::Stop(stop) => stop.at_rest(),
            Course::Branch(branching) => branching.plan.duration().max(branching.begins + branching.motion.duration()),
        }
    }

    /// The reference at `t` s since the start.
    pub fn at(&self, t: f64) -> Reference {
        match self {
            Course::Plan(trajectory) => along(trajectory, t),
            Course::Stop(stop) => stop.at(t),
            Course::Branch(branching) => branching.at(t),
        }
    }
}

/// A stop: the velocity on each axis goes to zero along a polynomial of fifth degree that continues velocity and
/// acceleration, and the jerk unless that needs much acceleration. A descent may follow. If the stop would use up the
/// height above the ground, the vertical velocity goes to zero sooner.
#[derive(Debug, Clone)]
pub struct Stop {
    begin: f64,
    axes: [Fade; 4],
    descends: bool,
}

impl Stop {
    /// The stop from a reference at time `begin` (s) above a ground at height `ground` (m), followed by a descent if
    /// `descends`.
    pub fn from(reference: &Reference, begin: f64, descends: bool, ground: f64) -> Self {
        let Reference { position, velocity, acceleration, jerk, yaw, .. } = reference;
        let longest = SHORTEST_STOP.max(1.875 * velocity.norm() / BRAKING).max(acceleration.norm() / BRAKING);
        let fades = |duration: f64, jerk: Vector3<f64>| {
            [0, 1, 2].map(|k| Fade::new(position[k], [velocity[k], acceleration[k], jerk[k]], duration))
        };
        let gentle = GENTLE * BRAKING.max(acceleration.norm());
        let smooth = gentlest(longest, gentle, |duration| fades(duration, *jerk));
        // If continuing the jerk needs too much acceleration at every duration, a step in the jerk is better than a
        // thrust that points down.
        let stop = match smooth.0 <= gentle {
            true => smooth,
            false => {
                let stepped = gentlest(longest, gentle, |duration| fades(duration, Vector3::zeros()));
                if stepped.0 < smooth.0 { stepped } else { smooth }
            }
        };
        let [x, y, z] = stop.1;
        let turn = Fade::new(yaw[0], [yaw[1], yaw[2], 0.0], SHORTEST_STOP);
        Stop { begin, axes: [x, y, z.above(ground), turn], descends }
    }

    /// When the reference comes to rest, s since the start of the flight.
    pub fn at_rest(&self) -> f64 {
        self.begin + self.axes.iter().map(|fade| fade.duration).fold(0.0, f64::max)
    }

    /// Where the reference comes to rest, m.
    pub fn place_of_rest(&self) -> Vector3<f64> {
        self.at(self.at_rest()).position
    }

    /// The reference at `t` s since the start of the flight.
    pub(super) fn at(&self, t: f64) -> Reference {
        let s = t - self.begin;
        let [x, y, z, yaw] = &self.axes;
        let mut reference = Reference::of([x.at(s), y.at(s), z.at(s), yaw.at(s)]);
        let down = t - self.at_rest();
        if self.descends && down > 0.0 {
            // The speed of the descent is DESCENT (3 u^2 - 2 u^3) with u = t / EASING until u = 1.
            let u = (down / EASING).min(1.0);
            let eased = EASING * (u.powi(3) - 0.5 * u.powi(4)) + (down - EASING).max(0.0);
            reference.position.z -= DESCENT * eased;
            reference.velocity.z -= DESCENT * u * u * (3.0 - 2.0 * u);
            reference.acceleration.z -= DESCENT * 6.0 * u * (1.0 - u) / EASING;
            if down < EASING {
                reference.jerk.z -= DESCENT * 6.0 * (1.0 - 2.0 * u) / EASING.powi(2);
                reference.snap.z += DESCENT * 12.0 / EASING.powi(3);
            }
        }
        reference
    }
}

/// `longest` and shorter durations down to `least`, s, each [`SHORTER`] times the one before.
fn durations(longest: f64, least: f64) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(longest), |duration| Some(duration * SHORTER)).take_while(move |d| *d >= least)
}

/// The longest stop whose largest acceleration is at most `gentle` (m/s^2), or the one with the smallest if none is;
/// with its largest acceleration (m/s^2). A long stop follows the initial acceleration and jerk for a long time, a
/// short one brakes hard.
fn gentlest(longest: f64, gentle: f64, stop: impl Fn(f64) -> [Fade; 3]) -> (f64, [Fade; 3]) {
    let mut best = (f64::INFINITY, stop(longest));
    for tried in durations(longest, SHORTEST_STOP).map(stop) {
        let hardest = hardest(&tried);
        if hardest < best.0 {
            best = (hardest, tried);
        }
        if hardest <= gentle {
            break;
        }
    }
    best
}

/// The largest acceleration of a stop, m/s^2.
fn hardest(stop: &[Fade; 3]) -> f64 {
    let at = |k: usize| {
        let squares = stop.iter().map(|fade| fade.at(fade.duration * k as f64 / SAMPLES as f64)[2].powi(2));
        squares.sum::<f64>().sqrt()
    };
    (0..=SAMPLES).map(at).fold(0.0, f64::max)
}

/// One coordinate of a stop, whose velocity fades to zero.
#[derive(Debug, Clone, Copy)]
struct Fade {
    /// Initial position.
    start: f64,
    /// Initial velocity, acceleration and jerk.
    begins: [f64; 3],
    /// s
    duration: f64,
    /// Coefficients of the velocity as a polynomial in t, from t^0 on.
    velocity: [f64; 6],
}

/// Share of the height above the ground that a stop may use up. The rest is a margin for the vehicle's tracking error.
const USED_UP: f64 = 0.75;
/// Ratio of the durations of two fades tried one after the other.
const SHORTER: f64 = 0.95;
/// Shortest duration of a fade, s; a vehicle could not follow a shorter one.
const SHORTEST_FADE: f64 = 0.1;
/// Steps in which a fade is sampled.
const SAMPLES: usize = 200;

impl Fade {
    /// The polynomial v of fifth degree with v, v', v'' as given at 0 and zero at `duration`.
    fn new(start: f64, [v, a, j]: [f64; 3], duration: f64) -> Self {
        let t = duration;
        // Value, slope and curvature of the first three terms at the end, which the other three cancel.
        let (p, q, r) = (v + a * t + 0.5 * j * t * t, a + j * t, j);
        let c3 = (-10.0 * p + 4.0 * q * t - 0.5 * r * t * t) / t.powi(3);
        let c4 = (15.0 * p - 7.0 * q * t + r * t * t) / t.powi(4);
        let c5 = (-6.0 * p + 3.0 * q * t - 0.5 * r * t * t) / t.powi(5);
        Fade { start, begins: [v, a, j], duration, velocity: [v, a, 0.5 * j, c3, c4, c5] }
    }

    /// This fade if it uses up at most [`USED_UP`] of the height above `ground` (m), or else the longest shorter one
    /// tried that does. This fade too if it starts on or below the ground, or if no shorter one does.
    fn above(self, ground: f64) -> Self {
        let floor = ground + (1.0 - USED_UP) * (self.start - ground);
        if self.start <= ground || self.lowest() >= floor {
            return self;
        }
        let mut shorter =
            durations(self.duration, SHORTEST_FADE).map(|duration| Fade::new(self.start, self.begins, duration));
        shorter.find(|fade| fade.lowest() >= floor).unwrap_or(self)
    }

    /// The smallest sampled value of the coordinate.
    fn lowest(&self) -> f64 {
        let places = (0..=SAMPLES).map(|k| self.at(self.duration * k as f64 / SAMPLES as f64)[0]);
        places.fold(f64::INFINITY, f64::min)
    }

    /// The coordinate and its first four derivatives `t` s after the start; at rest after the end.
    fn at(&self, t: f64) -> [f64; 5] {
        if t > self.duration {
            return [self.at(self.duration)[0], 0.0, 0.0, 0.0, 0.0];
        }
        let (t, c) = (t.max(0.0), &self.velocity);
        let place = (0..6).rev().fold(0.0, |sum, k| sum * t + c[k] / (k + 1) as f64) * t;
        let derivative = |order: usize| {
            let falling = |k: usize| (0..order).fold(1.0, |f, i| f * (k - i) as f64);
            (order..6).rev().fold(0.0, |sum, k| sum * t + c[k] * falling(k))
        };
        [self.start + place, derivative(0), derivative(1), derivative(2), derivative(3)]
    }
}
