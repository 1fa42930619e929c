//! A mode's set from exact arithmetic: every plane that three of its generators span.
//!
//! The set is `{ c + sum of t_k g_k : 0 <= t_k <= 1 }`. In four dimensions it is the intersection of the half-spaces
//! `n.w <= n.c + sum of max(0, n.g_k)` over all n orthogonal to three independent generators, and their negatives. All
//! triples are taken and none is merged, so no tolerance enters: a triple that only rounding makes independent gives a
//! plane that touches the set all the same.

use super::dyadic::{Dyadic, dot, orthogonal};
use super::interval::Interval;
use super::{Rejection, mode_named};
use crate::model::{FaultMode, Model, Rotor, Spin, Vehicle};
use std::cmp::Ordering;

/// The name of the set without faults.
pub const HEALTHY: &str = "healthy";

/// Triples of generators that one certificate may need.
pub const MAX_TRIPLES: usize = 500_000;

type Exact = [Dyadic; 4];

/// A half-space `normal . w <= offset`, both over the healthy set's width along the normal.
#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    pub normal: [Interval; 4],
    pub offset: Interval,
    /// The rotors that span it, from 1; fewer than three in a flat set.
    pub rotors: Vec<usize>,
}

impl Plane {
    /// n.w - e: positive outside.
    pub fn excess(&self, wrench: &[Interval; 4]) -> Interval {
        along(&self.normal, wrench) - self.offset
    }
}

pub fn along(normal: &[Interval; 4], vector: &[Interval; 4]) -> Interval {
    (0..4).fold(Interval::ZERO, |sum, i| sum + normal[i] * vector[i])
}

/// The exact wrenches of a mode.
#[derive(Debug, Clone)]
pub struct Generators {
    center: Exact,
    /// One per rotor; zero where it has no freedom.
    own: Vec<Exact>,
    /// Those of the healthy vehicle.
    healthy: Vec<Exact>,
    hover: Exact,
    /// The share of the way from hover to each plane that is left: one minus the reserve.
    kept: Interval,
}

/// b w_max^2 (1, y, -x, -/+ d/b): thrust, and its torques about the centre of gravity; P drags clockwise.
fn full_thrust(rotor: &Rotor) -> Exact {
    let [x, y, b, d, speed] =
        [rotor.position[0], rotor.position[1], rotor.thrust_coefficient, rotor.drag_coefficient, rotor.max_speed]
            .map(Dyadic::of);
    let square = speed.times(&speed);
    let thrust = b.times(&square);
    let drag = d.times(&square);
    let about_z = match rotor.spin {
        Spin::P => drag.negated(),
        Spin::N => drag,
    };
    [thrust.clone(), thrust.times(&y), thrust.times(&x).negated(), about_z]
}

fn scaled(v: &Exact, factor: f64) -> Exact {
    let factor = Dyadic::of(factor);
    std::array::from_fn(|i| v[i].times(&factor))
}

fn sum(a: &Exact, b: &Exact) -> Exact {
    std::array::from_fn(|i| a[i].plus(&b[i]))
}

fn zero() -> Exact {
    std::array::from_fn(|_| Dyadic::zero())
}

fn is_zero(v: &Exact) -> bool {
    v.iter().all(Dyadic::is_zero)
}

impl Generators {
    /// Of `healthy` or a fault mode, by name.
    pub fn of(model: &Model, mode: &str) -> Result<Self, Rejection> {
        let unknown = || Rejection::new(format!("the set of {mode}"), "the spec has no such mode");
        let found = if mode == HEALTHY { None } else { Some(mode_named(model, mode).ok_or_else(unknown)?) };
        Ok(Generators::new(&model.vehicle, model.gravity, found, model.plan.reserve))
    }

    /// Of a mode, `None` for the healthy vehicle.
    pub fn new(vehicle: &Vehicle, gravity: f64, mode: Option<&FaultMode>, reserve: f64) -> Self {
        let healthy: Vec<Exact> = vehicle.rotors.iter().map(full_thrust).collect();
        let mut center = zero();
        let mut own = healthy.clone();
        if let Some(mode) = mode {
            for (k, generator) in own.iter_mut().enumerate() {
                match mode.stuck.get(k).copied().flatten() {
                    Some(share) => {
                        center = sum(&center, &scaled(generator, share));
                        *generator = zero();
                    }
                    None => *generator = scaled(generator, mode.capacity.get(k).copied().unwrap_or(1.0)),
                }
            }
        }
        let mut hover = zero();
        hover[0] = Dyadic::of(vehicle.mass).times(&Dyadic::of(gravity));
        Generators { center, own, healthy, hover, kept: Interval::ONE - Interval::point(reserve) }
    }

    /// Triples of generators there are.
    pub fn triples(&self) -> usize {
        let n = self.own.len();
        n * n.saturating_sub(1) * n.saturating_sub(2) / 6
    }

    /// The plane orthogonal to three rotors' wrenches, on the side that `towards` points to; `None` where they span
    /// none.
    pub fn spanned(&self, rotors: [usize; 3], towards: &[f64; 4]) -> Option<Facet> {
        let [a, b, c] = rotors.map(|k| k.checked_sub(1).and_then(|k| self.own.get(k)));
        let normal = orthogonal(a?, b?, c?);
        let side = dot(&normal, &towards.map(Dyadic::of)).sign();
        let normal = match side {
            Ordering::Greater => normal,
            Ordering::Less => normal.map(|n| n.negated()),
            Ordering::Equal => return None,
        };
        let enclosed = normal.each_ref().map(Dyadic::enclosure);
        let length = enclosed.iter().fold(Interval::ZERO, |sum, n| sum + n.square()).sqrt();
        Some(Facet {
            normal: enclosed.map(|n| n / length),
            offset: self.support(&normal).enclosure() / length,
            plane: self.plane(&normal, rotors.to_vec()),
        })
    }

    /// Every plane that bounds the set. An error where the set has fewer than three dimensions.
    pub fn planes(&self) -> Result<Vec<Plane>, String> {
        let used: Vec<usize> = (0..self.own.len()).filter(|&k| !is_zero(&self.own[k])).collect();
        let mut normals = Vec::new();
        for (i, &a) in used.iter().enumerate() {
            for (j, &b) in used.iter().enumerate().skip(i + 1) {
                for &c in &used[j + 1..] {
                    let normal = orthogonal(&self.own[a], &self.own[b], &self.own[c]);
                    if !is_zero(&normal) {
                        normals.push((normal, vec![a + 1, b + 1, c + 1]));
                    }
                }
            }
        }
        let Some((first, _)) = normals.first().cloned() else {
            return Err("the set has fewer than three dimensions".into());
        };
        if self.own.iter().all(|g| dot(&first, g).is_zero()) {
            // Flat: with the direction it lacks, two generators span what bounds it within its three dimensions.
            for (i, &a) in used.iter().enumerate() {
                for &b in &used[i + 1..] {
                    let normal = orthogonal(&self.own[a], &self.own[b], &first);
                    if !is_zero(&normal) {
                        normals.push((normal, vec![a + 1, b + 1]));
                    }
                }
            }
        }
        let both = |(normal, rotors): (Exact, Vec<usize>)| {
            let opposite = normal.clone().map(|n| n.negated());
            [self.plane(&normal, rotors.clone()), self.plane(&opposite, rotors)]
        };
        Ok(normals.into_iter().flat_map(both).collect())
    }

    /// The range of T, tau_x, tau_y and tau_z over the set, the reserve taken off.
    pub fn extent(&self) -> [Interval; 4] {
        std::array::from_fn(|axis| {
            let reach = |sign: f64| {
                let mut normal = zero();
                normal[axis] = Dyadic::of(sign);
                let plane = self.plane(&normal, Vec::new());
                plane.offset / plane.normal[axis]
            };
            Interval::new(reach(-1.0).low, reach(1.0).high)
        })
    }

    /// n.c + sum of max(0, n.g_k), exactly.
    fn support(&self, normal: &Exact) -> Dyadic {
        let reach = self.own.iter().map(|g| dot(normal, g)).filter(|v| v.sign() == Ordering::Greater);
        reach.fold(dot(normal, &self.center), |sum, v| sum.plus(&v))
    }

    /// The half-space, shrunk about hover by the reserve: n.w <= n.h + (1 - reserve) (e - n.h).
    fn plane(&self, normal: &Exact, rotors: Vec<usize>) -> Plane {
        let width = self.healthy.iter().map(|g| dot(normal, g)).fold(Dyadic::zero(), |sum, v| match v.sign() {
            Ordering::Less => sum.minus(&v),
            _ => sum.plus(&v),
        });
        let width = width.enclosure();
        let hover = dot(normal, &self.hover);
        let room = self.support(normal).minus(&hover).enclosure();
        Plane {
            normal: normal.each_ref().map(|n| n.enclosure() / width),
            offset: (hover.enclosure() + self.kept * room) / width,
            rotors,
        }
    }
}

/// A facet as certificates print it, and the half-space.
#[derive(Debug, Clone)]
pub struct Facet {
    /// Of length 1 in N and N m.
    pub normal: [Interval; 4],
    /// Before the reserve.
    pub offset: Interval,
    pub plane: Plane,
}
