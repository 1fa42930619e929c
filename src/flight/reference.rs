//! Where the vehicle should be: along the plan, coming to rest, or descending.

use crate::motion::{Trajectory, X, Y, YAW, Z};
use nalgebra::Vector3;

/// Largest deceleration that a stop is meant to take, m/s^2, and how long it takes at least where nothing presses, s.
const BRAKING: f64 = 3.0;
const UNHURRIED: f64 = 1.5;
/// A stop is gentle where it accelerates no more than this many times what it begins with or brakes by.
const GENTLE: f64 = 1.1;

/// Speed of a descent, m/s, and how long it takes to come to it, s.
pub const DESCENT: f64 = 1.0;
const EASING: f64 = 2.0;

/// Where to be and how to move at an instant, world frame, SI units.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Reference {
    pub position: Vector3<f64>,
    pub velocity: Vector3<f64>,
    pub acceleration: Vector3<f64>,
    pub jerk: Vector3<f64>,
    pub snap: Vector3<f64>,
    /// psi, psi', psi'': rad, rad/s, rad/s^2.
    pub yaw: [f64; 3],
}

/// What is followed.
#[derive(Debug, Clone)]
pub enum Course<'a> {
    /// The plan; past its end its last position, at rest.
    Plan(&'a Trajectory),
    /// A stop, and what follows it.
    Stop(Box<Stop>),
}

impl Reference {
    pub fn is_finite(&self) -> bool {
        let vectors = [&self.position, &self.velocity, &self.acceleration, &self.jerk, &self.snap];
        vectors.iter().all(|v| v.iter().all(|x| x.is_finite())) && self.yaw.iter().all(|x| x.is_finite())
    }
}

impl Course<'_> {
    /// The reference at `t` s since the start.
    pub fn at(&self, t: f64) -> Reference {
        match self {
            Course::Plan(trajectory) if t <= trajectory.duration() => {
                let s = trajectory.at(t);
                let order = |i: usize| Vector3::new(s[X][i], s[Y][i], s[Z][i]);
                let [psi, rate, acceleration, ..] = s[YAW];
                Reference {
                    position: order(0),
                    velocity: order(1),
                    acceleration: order(2),
                    jerk: order(3),
                    snap: order(4),
                    yaw: [psi, rate, acceleration],
                }
            }
            Course::Plan(trajectory) => {
                let s = &trajectory.nodes[trajectory.intervals()];
                let position = Vector3::new(s[X][0], s[Y][0], s[Z][0]);
                Reference { position, yaw: [s[YAW][0], 0.0, 0.0], ..Reference::default() }
            }
            Course::Stop(stop) => stop.at(t),
        }
    }
}

/// Velocities fade to zero along polynomials of fifth degree that continue velocity, acceleration and jerk; a
/// descent may follow. Where that would use up the height above the ground, the vertical velocity fades sooner.
#[derive(Debug, Clone)]
pub struct Stop {
    begin: f64,
    axes: [Fade; 4],
    descends: bool,
}

impl Stop {
    /// From a reference at time `begin`, s, above a ground at height `ground`, m.
    pub fn from(reference: &Reference, begin: f64, descends: bool, ground: f64) -> Self {
        let Reference { position, velocity, acceleration, jerk, yaw, .. } = reference;
        let longest = UNHURRIED.max(1.875 * velocity.norm() / BRAKING).max(acceleration.norm() / BRAKING);
        let fades = |duration: f64, jerk: Vector3<f64>| {
            [0, 1, 2].map(|k| Fade::new(position[k], [velocity[k], acceleration[k], jerk[k]], duration))
        };
        let gentle = GENTLE * BRAKING.max(acceleration.norm());
        let smooth = gentlest(longest, gentle, |duration| fades(duration, *jerk));
        // Where the jerk drives it away, a step in the jerk is better than a thrust that points down.
        let stop = match smooth.0 <= gentle {
            true => smooth,
            false => {
                let stepped = gentlest(longest, gentle, |duration| fades(duration, Vector3::zeros()));
                if stepped.0 < smooth.0 { stepped } else { smooth }
            }
        };
        let [x, y, z] = stop.1;
        let turn = Fade::new(yaw[0], [yaw[1], yaw[2], 0.0], UNHURRIED);
        Stop { begin, axes: [x, y, z.above(ground), turn], descends }
    }

    /// When the vehicle has come to rest, s since the start of the flight.
    pub fn at_rest(&self) -> f64 {
        self.begin + self.axes.iter().map(|fade| fade.duration).fold(0.0, f64::max)
    }

    pub fn place_of_rest(&self) -> Vector3<f64> {
        self.at(self.at_rest()).position
    }

    fn at(&self, t: f64) -> Reference {
        let s = t - self.begin;
        let [x, y, z, yaw] = &self.axes;
        let orders = [x.at(s), y.at(s), z.at(s)];
        let order = |i: usize| Vector3::new(orders[0][i], orders[1][i], orders[2][i]);
        let [psi, rate, acceleration, ..] = yaw.at(s);
        let mut reference = Reference {
            position: order(0),
            velocity: order(1),
            acceleration: order(2),
            jerk: order(3),
            snap: order(4),
            yaw: [psi, rate, acceleration],
        };
        let down = t - self.at_rest();
        if self.descends && down > 0.0 {
            // The speed grows as 3 u^2 - 2 u^3 with u = t / EASING.
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

/// `longest`, and shorter durations down to `least`, s.
fn durations(longest: f64, least: f64) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(longest), |duration| Some(duration * SHORTER)).take_while(move |d| *d >= least)
}

/// The first of the stops with such durations that accelerates by no more than `gentle`, m/s^2; where none does, the one
/// that accelerates least. A long stop goes on for long with the acceleration and jerk that it begins with, a short one
/// brakes hard. With its largest acceleration, m/s^2.
fn gentlest(longest: f64, gentle: f64, stop: impl Fn(f64) -> [Fade; 3]) -> (f64, [Fade; 3]) {
    let mut best = (f64::INFINITY, stop(longest));
    for tried in durations(longest, UNHURRIED).map(stop) {
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

/// Largest acceleration on the way, m/s^2.
fn hardest(stop: &[Fade; 3]) -> f64 {
    let at = |k: usize| {
        let squares = stop.iter().map(|fade| fade.at(fade.duration * k as f64 / LOOKS as f64)[2].powi(2));
        squares.sum::<f64>().sqrt()
    };
    (0..=LOOKS).map(at).fold(0.0, f64::max)
}

/// One coordinate whose velocity fades to zero.
#[derive(Debug, Clone, Copy)]
struct Fade {
    start: f64,
    /// Velocity, acceleration and jerk where it begins.
    begins: [f64; 3],
    /// s
    duration: f64,
    /// Coefficients of the velocity in t.
    velocity: [f64; 6],
}

/// Share of the height above the ground that a stop may use up: what remains is for the vehicle's own error.
const USED_UP: f64 = 0.75;
/// Each shorter fade that is tried has this share of the duration of the one before.
const SHORTER: f64 = 0.95;
/// No fade is shorter than this, s: nothing could follow it.
const SHORTEST_FADE: f64 = 0.1;
/// Instants at which a fade is looked at.
const LOOKS: usize = 200;

impl Fade {
    /// The polynomial v of fifth degree with v, v', v'' as given at 0 and zero at `duration`.
    fn new(start: f64, [v, a, j]: [f64; 3], duration: f64) -> Self {
        let t = duration;
        // What the first three terms leave at the end, in value, slope and curvature.
        let (p, q, r) = (v + a * t + 0.5 * j * t * t, a + j * t, j);
        let c3 = (-10.0 * p + 4.0 * q * t - 0.5 * r * t * t) / t.powi(3);
        let c4 = (15.0 * p - 7.0 * q * t + r * t * t) / t.powi(4);
        let c5 = (-6.0 * p + 3.0 * q * t - 0.5 * r * t * t) / t.powi(5);
        Fade { start, begins: [v, a, j], duration, velocity: [v, a, 0.5 * j, c3, c4, c5] }
    }

    /// Itself, or the longest one tried that leaves a share of the height above `ground`. Where it begins on the ground or
    /// below, nothing helps.
    fn above(self, ground: f64) -> Self {
        let floor = ground + (1.0 - USED_UP) * (self.start - ground);
        if self.start <= ground || self.lowest() >= floor {
            return self;
        }
        let mut shorter =
            durations(self.duration, SHORTEST_FADE).map(|duration| Fade::new(self.start, self.begins, duration));
        shorter.find(|fade| fade.lowest() >= floor).unwrap_or(self)
    }

    fn lowest(&self) -> f64 {
        let places = (0..=LOOKS).map(|k| self.at(self.duration * k as f64 / LOOKS as f64)[0]);
        places.fold(f64::INFINITY, f64::min)
    }

    /// Place and its first four derivatives, `t` s after it began; at rest once it is over.
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
