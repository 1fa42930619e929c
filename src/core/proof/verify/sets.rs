//! A mode's set in exact arithmetic: every plane spanned by three of its generators; with `allocation = pseudo_inverse`
//! ([`inverse`]) two planes per rotor; with intervals ([`doubt`]) planes that are valid for all values.
//!
//! The set is `{ c + sum of t_k g_k : 0 <= t_k <= 1 }`. In four dimensions it is the intersection of the half-spaces
//! `n.w <= n.c + sum of max(0, n.g_k)` over all n orthogonal to three independent generators, and their negatives. All
//! triples are used and none are merged, so no tolerance is involved: a triple that is independent only because of
//! rounding still gives a plane that touches the set.

pub mod doubt;
pub mod inverse;
mod once;
mod parallel;

use self::doubt::{RotorWrenches, Uncertainty};
use self::inverse::Inverse;
use super::dyadic::{Dyadic, dot, orthogonal};
use super::interval::{Interval, exceeds};
use super::{Rejection, mode_named};
use crate::model::{Allocation, Environment, FaultMode, Model, Rotor, RotorState, Spin, Vehicle};
use std::cmp::Ordering;

pub use once::Sets;
pub use parallel::{innermost, innermost_at_most};

/// The name of the set without faults.
pub const HEALTHY: &str = "healthy";

/// Three generators count as independent, and their plane as one that contains a facet, if the volume that they span is
/// more than this, each scaled to length 1 in units of the set's extent along each axis. A smaller volume may be
/// rounding.
const INDEPENDENT: f64 = 1e-6;

/// A set counts as thin if its width along some plane's normal is below this share of the healthy set's extents along
/// it. Rows hold to 1e-4 of the healthy set's width, so that a set this thick reaches beyond itself by at most 2 % of
/// its own width, and one that is thinner lies within 1 % of a flat one.
const THIN: f64 = 1e-2;

const TOO_FEW_DIMENSIONS: &str = "it has fewer than three dimensions";

/// Two parallel planes that touch the set.
struct Side {
    normal: Exact,
    opposite: Exact,
    offsets: [Dyadic; 2],
    /// From 1.
    rotors: Vec<usize>,
    is_facet: bool,
    /// The distance between them, as a share of the extents of the healthy set along the normal.
    share: f64,
}

type Exact = [Dyadic; 4];

/// A half-space `normal . w <= offset`, both over the healthy set's width along the normal.
#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    pub normal: [Interval; 4],
    pub offset: Interval,
    /// How far hover lies inside the plane before the reserve is taken; below zero outside.
    pub room: Interval,
    /// The rotors that span it, from 1; fewer than three in a flat set. With the pseudo-inverse, the one at a bound;
    /// none for the row T >= 0.
    pub rotors: Vec<usize>,
    /// Whether the plane is known to contain a facet of the set; others may only touch it.
    pub is_facet: bool,
}

impl Plane {
    /// n.w - e: positive outside, in widths of the healthy set.
    pub fn violation(&self, wrench: &[Interval; 4]) -> Interval {
        along(&self.normal, wrench) - self.offset
    }

    /// The plane as it is before the reserve is taken about `hover`, N.
    pub fn without_reserve(&self, hover: Interval) -> Plane {
        Plane { offset: self.normal[0] * hover + self.room, ..self.clone() }
    }

    /// Whether hover lies outside, for some mass of an interval.
    pub fn excludes_hover(&self) -> bool {
        exceeds(-self.room.low, ROUNDING)
    }
}

/// Distances up to this, in widths of the healthy set, are rounding.
pub const ROUNDING: f64 = 1e-9;

/// What a reserve leaves of the way from hover to a plane, `kept` of it. Behind the plane, where hover lies outside, a
/// share of the way would end outside the set, so that all of it counts.
pub fn shrunk(room: Interval, kept: Interval) -> Interval {
    let share = kept * room;
    Interval { low: share.low.min(room.low), high: share.high.min(room.high) }
}

/// The scalar product.
pub fn along(normal: &[Interval; 4], vector: &[Interval; 4]) -> Interval {
    (0..4).fold(Interval::ZERO, |sum, i| sum + normal[i] * vector[i])
}

/// Most planes of a mode's set.
pub fn planes_at_most(vehicle: &Vehicle) -> u64 {
    let n = vehicle.rotors.len() as u64;
    match vehicle.allocation {
        Allocation::PseudoInverse => 2 * n + 1,
        _ => parallel::through_three_at_most(n) + n * n.saturating_sub(1) + 1,
    }
}

/// Most planes of the shadow of a mode's set.
pub fn shadow_at_most(vehicle: &Vehicle) -> u64 {
    let n = vehicle.rotors.len() as u64;
    n * n.saturating_sub(1) + 2 * n
}

/// The exact wrenches of a mode.
#[derive(Debug, Clone)]
pub struct Generators {
    offset: Exact,
    /// One per rotor; zero if it cannot vary.
    own: Vec<Exact>,
    /// Each parallel to that of `own`, as long as with the rotor's full capacity: the planes of all modes get the same
    /// normals, not only parallel ones.
    directions: Vec<Exact>,
    /// Generators of the healthy vehicle.
    healthy: Vec<Exact>,
    /// The extent of the healthy set along each axis, in units of which a set's thickness is measured.
    extents: [f64; 4],
    hover: Exact,
    /// The share of the distance from hover to each plane that plans may use: one minus the reserve.
    kept: Interval,
    /// How the set shrinks if rotors or the mass are known only to within intervals.
    doubts: Option<Uncertainty>,
    /// With `allocation = pseudo_inverse`.
    inverse: Option<Inverse>,
}

/// b w |w| (1, y, -x, -/+ d/b): thrust and torques about the centre of gravity of a rotor at a speed (rad/s); the drag
/// of P rotors is clockwise. `thrust` and `ratio` are factors on b w^2 and on d/b.
fn wrench_at(rotor: &Rotor, speed: f64, thrust: &Dyadic, ratio: &Dyadic) -> Exact {
    let [x, y, b, d, speed] =
        [rotor.position[0], rotor.position[1], rotor.thrust_coefficient, rotor.drag_coefficient, speed].map(Dyadic::of);
    let backwards = speed.sign() == Ordering::Less;
    let square = speed.times(&speed).times(thrust);
    let square = if backwards { square.negated() } else { square };
    let thrust = b.times(&square);
    let drag = d.times(&square).times(ratio);
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

fn difference(a: &Exact, b: &Exact) -> Exact {
    std::array::from_fn(|i| a[i].minus(&b[i]))
}

fn zero() -> Exact {
    std::array::from_fn(|_| Dyadic::zero())
}

fn is_zero(v: &Exact) -> bool {
    v.iter().all(Dyadic::is_zero)
}

/// The thrust over mass at rest with a drag for each axis of the body, at the yaw of the start, rounded: the reserve is
/// taken about this number. As in [`super::wrench::Dynamics`].
fn thrust_at_rest(environment: &Environment) -> f64 {
    let cross =
        |a: [f64; 3], b: [f64; 3]| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let unit = |a: [f64; 3]| a.map(|x| x / dot(a, a).sqrt());
    let [alpha, beta, gamma] = environment.drag_rates.map(|rate| {
        let [x, y, z] = environment.wind.map(|w| -rate * w);
        [x, y, z + environment.gravity]
    });
    let (sine, cosine) = environment.yaw_at_rest.sin_cos();
    let b1 = unit(cross([-sine, cosine, 0.0], alpha));
    let b2 = unit(cross(beta, b1));
    dot(cross(b1, b2), gamma)
}

/// The thrust of hover, N, about which the reserve is taken.
pub(super) fn hover_thrust(vehicle: &Vehicle, environment: &Environment) -> Dyadic {
    match environment.has_drag() {
        true if !environment.is_isotropic() => Dyadic::of(vehicle.mass * thrust_at_rest(environment)),
        // |m g e_z - drag wind|, rounded: the reserve is taken about this number.
        true => {
            let [x, y, z] = environment.wind.map(|w| vehicle.drag[0] * w);
            let up = vehicle.mass * environment.gravity - z;
            Dyadic::of((x * x + y * y + up * up).sqrt())
        }
        false => Dyadic::of(vehicle.mass).times(&Dyadic::of(environment.gravity)),
    }
}

impl Generators {
    /// The generators of `healthy` or of a fault mode, by name.
    ///
    /// # Errors
    /// The spec has no such mode.
    pub fn of(model: &Model, mode: &str) -> Result<Self, Rejection> {
        let unknown = || Rejection::new(format!("the set of {mode}"), "the spec has no such mode");
        let found = if mode == HEALTHY { None } else { Some(mode_named(model, mode).ok_or_else(unknown)?) };
        Ok(Generators::new(&model.vehicle, &model.environment(), found, model.plan.reserve))
    }

    /// The generators of a mode, `None` for the healthy vehicle.
    pub fn new(vehicle: &Vehicle, environment: &Environment, mode: Option<&FaultMode>, reserve: f64) -> Self {
        let nominal = |rotor: &Rotor| {
            let one = Dyadic::of(1.0);
            let [idle, full] = [rotor.min_speed, rotor.max_speed].map(|speed| wrench_at(rotor, speed, &one, &one));
            (idle, full)
        };
        let healthy: Vec<Exact> =
            vehicle.rotors.iter().map(nominal).map(|(idle, full)| difference(&full, &idle)).collect();
        let reach = |axis: usize| healthy.iter().map(|g| g[axis].enclosure().magnitude()).sum::<f64>();
        // Along an axis of none every unit is as good: rotors in a line give no roll torque.
        let extents = std::array::from_fn(|axis| Some(reach(axis)).filter(|extent| *extent > 0.0).unwrap_or(1.0));
        let mut offset = zero();
        let (mut own, mut directions) = (Vec::new(), Vec::new());
        for (k, rotor) in vehicle.rotors.iter().enumerate() {
            let known = RotorWrenches::of(rotor);
            // From the lowest speed to the highest, or at one speed, times the capacity.
            let whole = difference(&known.full, &known.idle);
            let (at, range) = match mode.map_or(RotorState::Sound, |mode| mode.rotors[k]) {
                RotorState::Sound => (known.idle, whole.clone()),
                RotorState::Reduced(capacity) => (scaled(&known.idle, capacity), scaled(&whole, capacity)),
                RotorState::Stuck(share) => (scaled(&known.middle, share), zero()),
                RotorState::Lost => (zero(), zero()),
            };
            offset = sum(&offset, &at);
            directions.push(if is_zero(&range) { zero() } else { whole });
            own.push(range);
        }
        let mut hover = zero();
        hover[0] = hover_thrust(vehicle, environment);
        Generators {
            offset,
            own,
            directions,
            healthy,
            extents,
            hover,
            kept: Interval::ONE - Interval::point(reserve),
            doubts: vehicle.is_uncertain().then(|| Uncertainty::of(vehicle, mode)),
            inverse: (vehicle.allocation == Allocation::PseudoInverse).then(|| Inverse::of(vehicle, mode)),
        }
    }

    /// The thrust of hover, N.
    pub fn hover_thrust(&self) -> Interval {
        self.hover[0].enclosure()
    }

    /// The facet that a certificate names by rotors, on the side to which `towards` points; `None` if they name none.
    pub fn named(&self, rotors: &[usize], towards: &[f64; 4]) -> Option<Facet> {
        let towards = towards.map(Dyadic::of);
        if let Some(inverse) = &self.inverse {
            let [rotor] = *rotors else { return None };
            let bounds = inverse.bounds(rotor)?;
            let (normal, offset) = bounds.into_iter().find(|(n, _)| dot(n, &towards).sign() == Ordering::Greater)?;
            return Some(self.facet(&normal, &offset, rotors, false));
        }
        let &[a, b, c] = rotors else { return None };
        let [a, b, c] = [a, b, c].map(|k| k.checked_sub(1).and_then(|k| self.directions.get(k)));
        let (a, b, c) = (a?, b?, c?);
        let normal = orthogonal(a, b, c);
        let is_facet = self.is_facet([a, b, c], &self.side(normal.clone(), Vec::new())?);
        let normal = match dot(&normal, &towards).sign() {
            Ordering::Greater => normal,
            Ordering::Less => normal.map(|n| n.negated()),
            Ordering::Equal => return None,
        };
        Some(self.facet(&normal, &self.support(&normal), rotors, is_facet))
    }

    /// Whether the planes through three generators are known to contain facets. Planes moved by intervals may no longer
    /// contain one, and those across a thin set mean little.
    fn is_facet(&self, through: [&Exact; 3], side: &Side) -> bool {
        let [a, b, c] = through.map(|g| in_units_of(&self.extents, g));
        volume([&a, &b, &c]) > INDEPENDENT && self.doubts.is_none() && side.share >= THIN
    }

    /// The facet as certificates print it: normal of length 1, shrunk by intervals, not by the reserve.
    fn facet(&self, normal: &Exact, offset: &Dyadic, rotors: &[usize], is_facet: bool) -> Facet {
        let (row, bound) = self.row(normal, offset);
        let length = row.iter().fold(Interval::ZERO, |sum, n| sum + n.square()).sqrt();
        Facet {
            normal: row.map(|n| n / length),
            offset: bound / length,
            plane: self.plane(normal, offset, rotors.to_vec(), is_facet),
        }
    }

    /// Every plane that bounds the set.
    ///
    /// # Errors
    /// The set has fewer than three dimensions, or fewer than four with the pseudo-inverse.
    pub fn planes(&self) -> Result<Vec<Plane>, String> {
        let mut planes = match &self.inverse {
            Some(_) if self.through_three().iter().any(|side| side.share < THIN) => {
                return Err(inverse::NOT_ALL_GIVEN.into());
            }
            Some(inverse) => {
                let rows = inverse.rows()?;
                // A rotor's bound may be unreachable because of the others, so the plane need not contain a facet.
                rows.into_iter()
                    .map(|(rotor, normal, offset)| self.plane(&normal, &offset, vec![rotor], false))
                    .collect()
            }
            None => self.spanned()?,
        };
        if self.doubts.is_some() {
            let mut down = zero();
            down[0] = Dyadic::of(-1.0);
            planes.push(self.plane(&down, &Dyadic::zero(), Vec::new(), false));
        }
        Ok(planes)
    }

    fn spanned(&self) -> Result<Vec<Plane>, String> {
        let mut sides = self.through_three();
        let Some(thinnest) = sides.iter().min_by(|a, b| a.share.total_cmp(&b.share)) else {
            return Err(TOO_FEW_DIMENSIONS.into());
        };
        if thinnest.share < THIN {
            // Thin: planes through two generators along the thin direction bound the set across it. Those through three
            // are nearly parallel to each other, and given a tolerance they bound it only along that direction.
            let thin = thinnest.normal.clone();
            let used = self.used();
            let pairs = used.iter().enumerate().flat_map(|(i, &a)| used[i + 1..].iter().map(move |&b| [a, b]));
            let normal_of =
                |[a, b]: [usize; 2]| (orthogonal(&self.directions[a], &self.directions[b], &thin), vec![a + 1, b + 1]);
            let across: Vec<Side> =
                pairs.map(normal_of).filter_map(|(normal, rotors)| self.side(normal, rotors)).collect();
            if across.is_empty() || across.iter().any(|side| side.share < THIN) {
                return Err(TOO_FEW_DIMENSIONS.into());
            }
            sides.extend(across);
        }
        Ok(sides.into_iter().flat_map(|side| self.both(side)).collect())
    }

    /// The rotors whose thrust can vary.
    fn used(&self) -> Vec<usize> {
        (0..self.own.len()).filter(|&k| !is_zero(&self.own[k])).collect()
    }

    /// The pairs of planes through every three generators that span one.
    fn through_three(&self) -> Vec<Side> {
        let used = self.used();
        let mut sides = Vec::new();
        for (i, &a) in used.iter().enumerate() {
            for (j, &b) in used.iter().enumerate().skip(i + 1) {
                for &c in &used[j + 1..] {
                    let through = [a, b, c].map(|k| &self.directions[k]);
                    let normal = orthogonal(through[0], through[1], through[2]);
                    let Some(mut side) = self.side(normal, vec![a + 1, b + 1, c + 1]) else { continue };
                    side.is_facet = self.is_facet(through, &side);
                    sides.push(side);
                }
            }
        }
        sides
    }

    /// The two planes with a normal that touch the set; `None` if it is zero.
    fn side(&self, normal: Exact, rotors: Vec<usize>) -> Option<Side> {
        if is_zero(&normal) {
            return None;
        }
        let opposite = normal.clone().map(|n| n.negated());
        let offsets = [self.support(&normal), self.support(&opposite)];
        let width = offsets[0].plus(&offsets[1]).enclosure().high;
        let whole: f64 = (0..4).map(|axis| normal[axis].enclosure().magnitude() * self.extents[axis]).sum();
        Some(Side { normal, opposite, offsets, rotors, is_facet: false, share: width / whole })
    }

    fn both(&self, side: Side) -> [Plane; 2] {
        let Side { normal, opposite, offsets: [above, below], rotors, is_facet, .. } = side;
        [(normal, above), (opposite, below)].map(|(n, e)| self.plane(&n, &e, rotors.clone(), is_facet))
    }

    /// The planes that bound the set's shadow along tau_z, the wrenches of which some yaw torque is in the set; `None`
    /// if there are none, or if intervals or the pseudo-inverse move planes, so that the set is no sum of generators.
    ///
    /// The shadow is the sum of the generators' shadows, so planes along tau_z through two of them bound it. All pairs
    /// are used.
    pub fn shadow(&self) -> Option<Vec<Plane>> {
        if self.doubts.is_some() || self.inverse.is_some() {
            return None;
        }
        let mut along_yaw = zero();
        along_yaw[3] = Dyadic::of(1.0);
        let used = self.used();
        let mut sides: Vec<Side> = Vec::new();
        for (i, &a) in used.iter().enumerate() {
            for &b in &used[i + 1..] {
                let normal = orthogonal(&self.directions[a], &self.directions[b], &along_yaw);
                sides.extend(self.side(normal, vec![a + 1, b + 1]));
            }
        }
        let thinnest = sides.iter().min_by(|a, b| a.share.total_cmp(&b.share))?;
        if thinnest.share < THIN {
            // Thin, as in `spanned`: rotors in a line.
            let thin = thinnest.normal.clone();
            let across = used.iter().map(|&a| (orthogonal(&self.directions[a], &thin, &along_yaw), vec![a + 1]));
            let across: Vec<Side> = across.filter_map(|(normal, rotors)| self.side(normal, rotors)).collect();
            sides.extend(across);
        }
        Some(sides.into_iter().flat_map(|side| self.both(side)).collect())
    }

    /// Bounds on T, tau_x, tau_y and tau_z over the set of everything that the rotors can give, shrunk by the reserve.
    pub fn extent(&self) -> [Interval; 4] {
        std::array::from_fn(|axis| {
            let reach = |sign: f64| {
                let mut normal = zero();
                normal[axis] = Dyadic::of(sign);
                let hover = dot(&normal, &self.hover);
                let room = self.support(&normal).minus(&hover).enclosure();
                Interval::point(sign) * (hover.enclosure() + shrunk(room, self.kept))
            };
            Interval::new(reach(-1.0).low, reach(1.0).high)
        })
    }

    /// n.c + sum of max(0, n.g_k), exactly.
    fn support(&self, normal: &Exact) -> Dyadic {
        let reach = self.own.iter().map(|g| dot(normal, g)).filter(|v| v.sign() == Ordering::Greater);
        reach.fold(dot(normal, &self.offset), |sum, v| sum.plus(&v))
    }

    /// n.w <= e after shrinking by intervals.
    fn row(&self, normal: &Exact, offset: &Dyadic) -> ([Interval; 4], Interval) {
        match &self.doubts {
            Some(doubts) => doubts.row(normal, offset),
            None => (normal.each_ref().map(Dyadic::enclosure), offset.enclosure()),
        }
    }

    /// The half-space, shrunk about hover by the reserve: n.w <= n.h + (1 - reserve) (e - n.h), and n.w <= e where
    /// hover is outside.
    fn plane(&self, normal: &Exact, offset: &Dyadic, rotors: Vec<usize>, is_facet: bool) -> Plane {
        if self.doubts.is_none() {
            let width = absolute(self.healthy.iter().map(|g| dot(normal, g))).enclosure();
            let hover = dot(normal, &self.hover);
            let room = offset.minus(&hover).enclosure();
            return Plane {
                normal: normal.each_ref().map(|n| n.enclosure() / width),
                offset: (hover.enclosure() + shrunk(room, self.kept)) / width,
                room: room / width,
                rotors,
                is_facet,
            };
        }
        let (normal, offset) = self.row(normal, offset);
        let enclosed = |v: &Exact| v.each_ref().map(Dyadic::enclosure);
        let width = self.healthy.iter().fold(Interval::ZERO, |sum, g| sum + along(&normal, &enclosed(g)).abs());
        let hover = along(&normal, &enclosed(&self.hover));
        let room = offset - hover;
        let offset = (hover + shrunk(room, self.kept)) / width;
        Plane { normal: normal.map(|n| n / width), offset, room: room / width, rotors, is_facet }
    }
}

/// A generator of length 1, in units of `extent` along each axis.
fn in_units_of(extent: &[f64; 4], generator: &Exact) -> [f64; 4] {
    let parts: [f64; 4] = std::array::from_fn(|axis| generator[axis].enclosure().middle() / extent[axis]);
    let length = parts.iter().map(|p| p * p).sum::<f64>().sqrt();
    parts.map(|p| p / length)
}

/// The volume that three vectors span.
fn volume([a, b, c]: [&[f64; 4]; 3]) -> f64 {
    let dot = |p: &[f64; 4], q: &[f64; 4]| (0..4).map(|i| p[i] * q[i]).sum::<f64>();
    // Gram's determinant, of rows that have length 1.
    let (ab, ac, bc) = (dot(a, b), dot(a, c), dot(b, c));
    (1.0 + 2.0 * ab * ac * bc - ab * ab - ac * ac - bc * bc).max(0.0).sqrt()
}

/// The sum of absolute values.
fn absolute(values: impl Iterator<Item = Dyadic>) -> Dyadic {
    values.fold(Dyadic::zero(), |sum, v| match v.sign() {
        Ordering::Less => sum.minus(&v),
        _ => sum.plus(&v),
    })
}

/// A facet as certificates print it, and its half-space.
#[derive(Debug, Clone)]
pub struct Facet {
    /// The outward normal, of length 1 in N and N m.
    pub normal: [Interval; 4],
    /// The offset before the reserve, N and N m.
    pub offset: Interval,
    pub plane: Plane,
}
