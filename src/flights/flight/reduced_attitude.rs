//! Control with yaw given up: the direction of the thrust alone is controlled, while the body turns as the rotors that
//! are left make it turn (`docs/flight.md`, section 2, "Without yaw").
//!
//! Relaxing the attitude of a vehicle with lost rotors in this way is due to M. W. Mueller and R. D'Andrea (ICRA 2014,
//! doi 10.1109/ICRA.2014.6906588); their patent US 9,856,016 covers such flight controllers.

use super::allocate::{Allocator, Belief};
use super::body::{Body, Frame};
use super::control::{demanded_force, direction};
use super::reference::Reference;
use super::rotors::Rotors;
use super::single_axis::SingleAxis;
use crate::actuation::Wrench;
use crate::geometry::polytope::Polytope;
use crate::model::{Gains, GiveUpYaw, Model};
use nalgebra::{Vector2, Vector3};

/// Hover keeps all axes if each torque can still change by this share of its largest value in both directions.
const KEPT: f64 = 0.01;

/// At most this share of a wrench may be missing.
const REACHED: f64 = 1e-3;

/// The largest tangent of the angle between the primary axis and z. A larger one leaves less of the thrust upright, a
/// smaller one takes longer to free torques in both directions. Measured from 0.25 to 0.7: 0.45 costs the least height
/// over the vehicles and delays of docs/flight.md; beyond 0.5 rotors of 40 ms cost more.
const MOST_TILT: f64 = 0.45;

/// The gyroscopic terms that tilt the primary axis are taken to be at least this share of those without rotors'
/// momentum, with the sign that they have once the spin is settled. Heights hardly depend on it from 0.1 to 0.6.
const LEAST_SHARE: f64 = 0.3;

/// By these factors feedback on the place is slower where torques about hover point to one side until the body spins,
/// and where they are about one axis alone. With larger ones a quadcopter at 5 m/s with rotors of 40 ms is not always
/// caught, or its place drifts.
const SLOWER_ONE_SIDED: f64 = 0.45;
const SLOWER_WITH_ONE_AXIS: f64 = 0.3;

/// Radii of discs that differ by less than this share of the largest torque are the same.
const SAME: f64 = 1e-9;

/// Rounds of a search on an interval; (2/3)^60 is below 1e-10.
const ROUNDS: usize = 60;

/// Below this rate of spin (rad/s) the primary axis is z.
const SLOW: f64 = 0.5;

/// A body that gives up yaw, and the torques that its spin shall take.
#[derive(Debug, Clone, PartialEq)]
pub struct WithoutYaw {
    /// Roll and pitch torques (N m) that the rotors give about the equilibrium, in the middle of those that are
    /// possible at the thrust of hover; 0 if torques are possible in every direction about 0.
    bias: Vector2<f64>,
    /// The signs of the two gyroscopic terms of [`WithoutYaw::steady`] once the spin is settled: 1 or -1.
    signs: [f64; 2],
    /// Where torques about one axis alone are left.
    single_axis: Option<SingleAxis>,
}

/// What control with yaw given up takes from the rotors.
#[derive(Debug, Clone, Copy)]
pub struct SpinningRotors {
    /// Their time constant, s.
    pub lag: f64,
    /// Their angular momentum about z, h, N m s.
    pub momentum: f64,
}

impl WithoutYaw {
    /// `None` if yaw is not given up; see [`Self::is_given_up`].
    pub fn of(
        gives_up: GiveUpYaw,
        model: &Model,
        allocator: &Allocator,
        hover: &Wrench,
        belief: &Belief,
        gains: &Gains,
    ) -> Option<Self> {
        Self::is_given_up(gives_up, allocator, hover, belief).then(|| {
            let frame = Frame::of(model);
            let projection = allocator.without_yaw(belief);
            let reach = allocator.extent()[1].max(allocator.extent()[2]);
            let single_axis = single_axis(&projection, hover[0], &frame, gains);
            let bias = bias(&projection, hover[0], reach);
            let signs = settled_signs(model, &frame, allocator, belief, &Wrench::new(hover[0], bias.x, bias.y, 0.0));
            WithoutYaw { bias, signs, single_axis }
        })
    }

    /// Whether yaw is given up: with [`GiveUpYaw::WhereNeeded`], if the vehicle does not keep control of all axes about
    /// hover under these beliefs. `hover` is in N and N m.
    pub fn is_given_up(gives_up: GiveUpYaw, allocator: &Allocator, hover: &Wrench, belief: &Belief) -> bool {
        let is_missing = |axis: usize, share: f64| {
            let mut wrench = *hover;
            wrench[axis] += share * allocator.extent()[axis];
            allocator.missing_all(&wrench, belief) > REACHED
        };
        match gives_up {
            GiveUpYaw::Never => false,
            GiveUpYaw::WhereNeeded => (1..4).any(|axis| is_missing(axis, KEPT) || is_missing(axis, -KEPT)),
            GiveUpYaw::Always => true,
        }
    }

    /// The wrench (N and N m, body frame) for the direction of the thrust.
    ///
    /// The primary axis n of the body is that of an equilibrium at the present rate r, which balances the bias b:
    ///
    /// ```text
    /// n = w0/|w0|      w0 = (b_y/((Jx - Jz) r - h), b_x/((Jz - Jy) r + h), r)      its angle from z limited
    /// ```
    ///
    /// While the body spins up, the momentum h of the rotors may exceed the terms with r, and that equilibrium is
    /// tilted the other way than the one in which the vehicle settles. An axis that followed it would flip where a
    /// term passes zero, so both terms keep the sign of the settled spin (`Self::steady`).
    ///
    /// With the demanded force over mass F, its direction d, and s = R n in the world frame,
    ///
    /// ```text
    /// alpha  = d x d'' + k_R angle(s, d) (s x d)/|s x d| + k_w (d x d' - R w_n)        w_n = w - (w.n) n, across n
    /// w'     = R^T alpha - (w.n) n x w_n + l n,  with l for which r' = 0
    /// tau    = J w' + w x (J w + h e_z)         T = m F.s/n_z
    /// ```
    ///
    /// A torque that is fixed in space turns at -r in the body, faster than lagging rotors follow. So the difference u
    /// of tau to that of the equilibrium is commanded ahead by the rotors' time constant:
    /// `u + lag (r u_y, -r u_x)`. The yaw torque slows the spin as far as rotors are left for it. `force` is the
    /// present thrust over mass, m/s^2.
    pub fn control(
        &self,
        frame: &Frame,
        gains: &Gains,
        measured: &Body,
        force: f64,
        reference: &Reference,
        rotors: SpinningRotors,
    ) -> Wrench {
        let SpinningRotors { lag, momentum } = rotors;
        let inertia = frame.inertia;
        let torque_of = |w: &Vector3<f64>| w.cross(&(inertia.component_mul(w) + Vector3::z() * momentum));
        let w = measured.rates;
        let steady = self.steady(&inertia, w.z, momentum);
        let n = if w.z.abs() < SLOW { Vector3::z() } else { steady.normalize() * w.z.signum() };
        let rotation = measured.rotation();
        let s = rotation * n;
        let of_place = self.slowed(gains);
        let demanded = demanded_force(frame, &of_place, measured, force, reference);
        let small = demanded[0].norm() < 0.05 * frame.gravity;
        let [d, d1, d2] = if small { [s, Vector3::zeros(), Vector3::zeros()] } else { direction(demanded) };
        let across = w - n * w.dot(&n);
        let axis = s.cross(&d);
        let angle = axis.norm().atan2(s.dot(&d));
        // Exactly upside down every axis across s will do.
        let towards = if axis.norm() > 1e-9 { axis.normalize() * angle } else { rotation * Vector3::x() * angle };
        let rate_error = d.cross(&d1) - rotation * across;
        let alpha = d.cross(&d2) + towards * gains.attitude + rate_error * gains.attitude_rate;
        let turned = rotation.inverse() * alpha - n.cross(&across) * w.dot(&n);
        let thrust = frame.mass * demanded[0].dot(&s) / n.z;
        let yaw = -gains.yaw_rate * inertia.z * w.z;
        if let Some(single_axis) = &self.single_axis {
            let towards = rotation.inverse() * d;
            let torque = single_axis.torque(&inertia, momentum, &w, &towards, lag);
            return Wrench::new(thrust, torque.x, torque.y, yaw);
        }
        let acceleration = turned - n * (turned.z / n.z);
        let torque = inertia.component_mul(&acceleration) + torque_of(&w);
        let ahead = torque - torque_of(&steady);
        let [x, y] = [torque.x + lag * w.z * ahead.y, torque.y - lag * w.z * ahead.x];
        Wrench::new(thrust, x, y, yaw)
    }

    /// The gains of feedback on the place, slower where the direction of the thrust follows more slowly.
    fn slowed(&self, gains: &Gains) -> Gains {
        let slower = match (&self.single_axis, self.bias == Vector2::zeros()) {
            (Some(_), _) => SLOWER_WITH_ONE_AXIS,
            (None, false) => SLOWER_ONE_SIDED,
            (None, true) => 1.0,
        };
        Gains { position: slower * slower * gains.position, velocity: slower * gains.velocity, ..*gains }
    }

    /// w0: the angular velocity of the equilibrium at a rate r (rad/s). With s the signs of the terms at the settled
    /// spin, `s |Jx - Jz| r^2` and `s |Jz - Jy| r^2`, each times [`LEAST_SHARE`], are the smallest terms.
    pub(super) fn steady(&self, inertia: &Vector3<f64>, r: f64, momentum: f64) -> Vector3<f64> {
        let least = |difference: f64| LEAST_SHARE * difference.abs() * r * r;
        let terms = gyroscopic_terms(inertia, r, momentum);
        let by_p = self.signs[0] * (self.signs[0] * terms[0]).max(least(inertia.x - inertia.z));
        let by_q = self.signs[1] * (self.signs[1] * terms[1]).max(least(inertia.z - inertia.y));
        let ratio = |torque: f64, by: f64| if torque == 0.0 || by == 0.0 { 0.0 } else { torque / by };
        let across = Vector2::new(ratio(self.bias.y, by_p), ratio(self.bias.x, by_q));
        let across = if across.norm() > MOST_TILT { across * (MOST_TILT / across.norm()) } else { across };
        Vector3::new(across.x * r, across.y * r, r)
    }
}

/// `((Jx - Jz) r - h) r` and `((Jz - Jy) r + h) r`: the torques about y and x (N m) for each unit of tangent by which
/// the axis of a spin r (rad/s) is tilted towards x and y. h is the momentum of the rotors, N m s.
fn gyroscopic_terms(inertia: &Vector3<f64>, r: f64, momentum: f64) -> [f64; 2] {
    [((inertia.x - inertia.z) * r - momentum) * r, ((inertia.z - inertia.y) * r + momentum) * r]
}

/// The signs of [`gyroscopic_terms`] at the spin in which the drag balances the yaw torque of the rotors that give
/// `wrench` (N and N m). Without yaw drag the spin has no end, and the inertia decides.
fn settled_signs(model: &Model, frame: &Frame, allocator: &Allocator, belief: &Belief, wrench: &Wrench) -> [f64; 2] {
    let command = |speeds: &mut [f64]| allocator.clone().bounded_speeds(wrench, speeds);
    let (torque, momentum) = Rotors::steady(&model.vehicle, belief, command);
    let inertia = frame.inertia;
    let terms = match frame.yaw_drag {
        Some(drag) => gyroscopic_terms(&inertia, drag.spin(torque), momentum),
        None => [inertia.x - inertia.z, inertia.z - inertia.y],
    };
    terms.map(|term| if term < 0.0 { -1.0 } else { 1.0 })
}

/// The one axis about which torques are possible at a thrust (N) both ways; `None` if there are more or none.
fn single_axis(projection: &Polytope<3, ()>, thrust: f64, frame: &Frame, gains: &Gains) -> Option<SingleAxis> {
    let [equality] = &projection.equalities[..] else { return None };
    let across = equality.normal.yz();
    let axis = Vector2::new(-across.y, across.x) / across.norm();
    let [start, along] = [Vector3::new(thrust, 0.0, 0.0), Vector3::new(0.0, axis.x, axis.y)];
    let (low, high) = projection.chord(&start, &along, 1e-6 * thrust)?;
    let reach = high.min(-low);
    (reach > 0.0).then(|| SingleAxis::new(axis, reach, &frame.inertia, gains.attitude))
}

/// The middle of the roll and pitch torques that are possible at a thrust (N), if those about 0 end in some direction;
/// N m. `reach` bounds their size (N m).
fn bias(projection: &Polytope<3, ()>, thrust: f64, reach: f64) -> Vector2<f64> {
    if !projection.equalities.is_empty() {
        return Vector2::zeros();
    }
    let torques = Torques::at(projection, thrust, reach);
    let middle = torques.middle();
    if torques.radius(Vector2::zeros()) >= 0.5 * torques.radius(middle) { Vector2::zeros() } else { middle }
}

/// The roll and pitch torques that are possible at a thrust, a polygon.
struct Torques {
    /// Normals of length one, outward, and distances from 0 (N m).
    edges: Vec<(Vector2<f64>, f64)>,
    /// Bound on the size of each component, N m.
    reach: f64,
}

impl Torques {
    /// The section of the projected set at a thrust (N).
    fn at(projection: &Polytope<3, ()>, thrust: f64, reach: f64) -> Self {
        let edges = projection.facets.iter().filter_map(|facet| {
            let across = facet.normal.yz();
            let length = across.norm();
            (length > 1e-9).then(|| (across / length, (facet.offset - facet.normal.x * thrust) / length))
        });
        Torques { edges: edges.collect(), reach }
    }

    /// Distance of a torque from the nearest edge, N m; below zero outside.
    fn radius(&self, torque: Vector2<f64>) -> f64 {
        self.edges.iter().map(|(normal, offset)| offset - normal.dot(&torque)).fold(f64::INFINITY, f64::min)
    }

    /// The centre of the largest disc, N m. Between two parallel edges many discs are the largest: their centres fill a
    /// segment, and this is its middle. So rotors that are placed symmetrically have a symmetric middle.
    fn middle(&self) -> Vector2<f64> {
        let over_y = |x: f64| move |y: f64| self.radius(Vector2::new(x, y));
        let x = self.middle_of_highest(|x| over_y(x)(self.highest(over_y(x))));
        Vector2::new(x, self.middle_of_highest(over_y(x)))
    }

    /// Where a concave function is highest, by a search that drops a third of the interval in each round.
    fn highest(&self, f: impl Fn(f64) -> f64) -> f64 {
        let (mut low, mut high) = (-self.reach, self.reach);
        for _ in 0..ROUNDS {
            let third = (high - low) / 3.0;
            if f(low + third) < f(high - third) { low += third } else { high -= third }
        }
        0.5 * (low + high)
    }

    /// The middle of the interval where a concave function is highest up to [`SAME`].
    fn middle_of_highest(&self, f: impl Fn(f64) -> f64) -> f64 {
        let at = self.highest(&f);
        let least = f(at) - SAME * self.reach;
        let end = |outside: f64| {
            let (mut inside, mut outside) = (at, outside);
            for _ in 0..ROUNDS {
                let half = 0.5 * (inside + outside);
                if f(half) >= least { inside = half } else { outside = half }
            }
            inside
        };
        0.5 * (end(-self.reach) + end(self.reach))
    }
}
