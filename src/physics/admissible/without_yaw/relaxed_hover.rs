//! Equilibria of a vehicle that has given up yaw: the body turns at a constant rate about the vertical, which is fixed
//! in the body, and the centre of gravity goes around a small circle. M. W. Mueller, R. D'Andrea, *Relaxed hover
//! solutions for multicopters*, Int. J. of Robotics Research 35:8 (2016), doi 10.1177/0278364915596233.

use super::core::disc;
use crate::actuation::{Actuation, Wrench, signed_root};
use crate::admissible::allocation::{Allocator, Bounds, MOST_ROTORS, bounded};
use crate::admissible::{AdmissibleSet, HEALTHY, edge, hover};
use crate::geometry::polytope::Polytope;
use crate::model::{Model, Spin, Vehicle, YawDrag};
use nalgebra::{Vector2, Vector3};
use serde::Serialize;

/// One equilibrium.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct RelaxedHover {
    /// Angular velocity in body axes, rad/s; the vertical is parallel to it.
    pub body_rates_rad_s: [f64; 3],
    /// The angle between the z axis of the body and the vertical, deg.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub axis_tilt_deg: f64,
    /// Thrust of each rotor, N, with the smallest sum of squares.
    pub thrusts_n: Vec<f64>,
    /// Radius of the circle of the centre of gravity, m: `g tan(tilt) / |w|^2`.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub circle_radius_m: f64,
    /// Radius of the disc of roll and pitch torques about those of the equilibrium, N m.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub disc_n_m: f64,
    /// Mechanical power of the rotors divided by that of healthy hover.
    pub power_ratio: f64,
}

/// The equations of the equilibria of a mode, with the vertical n and w = omega n in body axes:
///
/// ```text
/// (96)  w x (J w + h) = tau - D(w) e_z      T n_z = m g
/// ```
///
/// D is the drag about z, and h the momentum of the rotors, along z.
pub struct System<'a> {
    model: &'a Model,
    set: &'a AdmissibleSet,
    yaw_free: &'a Polytope<3, ()>,
    drag: YawDrag,
    allocation: Allocation,
    /// Mechanical power of healthy hover, W.
    healthy: f64,
    /// Whether some rotor has inertia.
    has_momentum: bool,
}

/// What balances at an angular velocity, or a guess of it.
#[derive(Default)]
struct Guess {
    /// That of the rotors, N m s about z.
    momentum: f64,
    /// Those of [`bounded`].
    multipliers: Wrench,
}

/// Steps of the momentum of the rotors, which depends on the thrusts and they on it.
const STEPS: usize = 20;

/// Tilts of the axis that are searched, rad, and the numbers of tilts and of directions of the first grid.
const MOST_TILT: f64 = 0.6;
const TILTS: usize = 24;
const AZIMUTHS: usize = 36;

/// Directions of the search that follows. The disc has ridges, along which few directions lead upwards.
const WAYS: usize = 24;

impl<'a> System<'a> {
    /// `yaw_free` is the projection of the mode's set on (T, tau_x, tau_y).
    pub fn new(model: &'a Model, set: &'a AdmissibleSet, yaw_free: &'a Polytope<3, ()>, drag: YawDrag) -> Self {
        let vehicle = &model.vehicle;
        let thrusts = Allocator::new(vehicle).thrusts(&hover(model));
        let healthy = power(vehicle, &thrusts, &vec![1.0; vehicle.rotors.len()]);
        let has_momentum = vehicle.rotors.iter().any(|rotor| rotor.inertia > 0.0);
        System { model, set, yaw_free, drag, allocation: Allocation::new(model, set), healthy, has_momentum }
    }

    /// The wrench that an angular velocity (rad/s) takes: (96). `momentum` (N m s) is that of the rotors.
    fn wrench(&self, w: &Vector3<f64>, momentum: f64) -> Wrench {
        let inertia = Vector3::from(self.model.vehicle.inertia);
        let torque =
            w.cross(&(inertia.component_mul(w) + Vector3::z() * momentum)) + Vector3::z() * self.drag.torque(w.z);
        let upright = if w.z == 0.0 { 1.0 } else { w.z.abs() / w.norm() };
        Wrench::new(hover(self.model)[0] / upright, torque.x, torque.y, torque.z)
    }

    /// The momentum of the rotors at these thrusts, N m s about z.
    fn momentum(&self, thrusts: &[f64]) -> f64 {
        let of = |(k, rotor): (usize, &crate::model::Rotor)| {
            let way = if rotor.spin == Spin::P { 1.0 } else { -1.0 };
            way * rotor.inertia * self.allocation.speed(rotor, k, thrusts[k])
        };
        self.model.vehicle.rotors.iter().enumerate().map(of).sum()
    }

    /// The wrench and the thrusts at an angular velocity; `None` if the mode does not produce it.
    fn balance(&self, w: &Vector3<f64>) -> Option<(Wrench, Vec<f64>)> {
        let (mut momentum, mut wrench, mut multipliers) = (0.0, self.wrench(w, 0.0), Wrench::zeros());
        let mut thrusts = self.allocation.thrusts(&wrench, &mut multipliers);
        for _ in 0..if self.has_momentum { STEPS } else { 0 } {
            let next = self.momentum(&thrusts);
            if (next - momentum).abs() <= 1e-12 * (1.0 + next.abs()) {
                break;
            }
            momentum = next;
            wrench = self.wrench(w, momentum);
            thrusts = self.allocation.thrusts(&wrench, &mut multipliers);
        }
        let width = edge::width(&self.set.hover);
        self.set.polytope.contains(&wrench, width).then_some((wrench, thrusts))
    }

    /// The equilibrium with this angular velocity in body axes (rad/s), if the mode has it.
    pub fn at(&self, w: &Vector3<f64>) -> Option<RelaxedHover> {
        let (wrench, thrusts) = self.balance(w)?;
        let width = edge::width(&self.set.hover);
        let tilt = if w.z == 0.0 { 0.0 } else { w.xy().norm().atan2(w.z.abs()) };
        let radius = if tilt == 0.0 { 0.0 } else { self.model.gravity * tilt.tan() / w.norm_squared() };
        Some(RelaxedHover {
            body_rates_rad_s: (*w).into(),
            axis_tilt_deg: tilt.to_degrees(),
            circle_radius_m: radius,
            disc_n_m: disc(self.yaw_free, wrench[0], [wrench[1], wrench[2]], width)?,
            power_ratio: power(&self.model.vehicle, &thrusts, &self.allocation.capacity) / self.healthy,
            thrusts_n: thrusts,
        })
    }

    /// The equilibria about a direction of the body (unit vector, z above zero) that a flat set of dimension 3 leaves:
    /// its equality is a quadratic equation in the rate.
    pub fn about(&self, axis: &Vector3<f64>) -> Vec<RelaxedHover> {
        let [equality] = &self.set.polytope.equalities[..] else { return Vec::new() };
        // The equality as a function of the rate takes the momentum of the rotors and a drag of second order along. Its
        // roots are found between changes of sign; what balances at one rate is the first guess at the next.
        let mut guess = Guess::default();
        let mut off = |rate: f64| {
            let w = axis * rate;
            self.settle(&w, &mut guess);
            equality.normal.dot(&self.wrench(&w, guess.momentum)) - equality.offset
        };
        let most = self.fastest();
        let rates = (0..=SCAN).map(|k| most * (2.0 * k as f64 / SCAN as f64 - 1.0));
        let points: Vec<(f64, f64)> = rates.map(|rate| (rate, off(rate))).collect();
        let crossings = points.windows(2).filter(|two| (two[0].1 < 0.0) != (two[1].1 < 0.0));
        let roots: Vec<f64> = crossings.map(|two| root(&mut off, two[0], two[1])).collect();
        roots.into_iter().filter_map(|rate| self.at(&(axis * rate))).collect()
    }

    /// Moves a guess to what balances at an angular velocity.
    fn settle(&self, w: &Vector3<f64>, guess: &mut Guess) {
        if !self.has_momentum {
            return;
        }
        for _ in 0..STEPS {
            let before = guess.momentum;
            let thrusts = self.allocation.thrusts(&self.wrench(w, before), &mut guess.multipliers);
            guess.momentum = self.momentum(&thrusts);
            if (guess.momentum - before).abs() <= ROUNDING * guess.momentum.abs() {
                break;
            }
        }
    }

    /// A rate (rad/s) above those of all equilibria: that of the largest yaw torque of the set.
    fn fastest(&self) -> f64 {
        let yaw = Wrench::new(0.0, 0.0, 0.0, 1.0);
        let most = self.set.zonotope.support(&yaw).max(self.set.zonotope.support(&-yaw));
        let [least_drag, _] = self.drag.ends();
        2.0 * least_drag.spin(most)
    }

    /// The equilibrium with the largest disc, of a flat set of dimension 3; `None` for another set, or if none has a
    /// disc.
    pub fn widest(&self) -> Option<RelaxedHover> {
        let best = |at: Vector2<f64>| {
            let axis = Vector3::new(at.x, at.y, (1.0 - at.norm_squared()).max(0.0).sqrt());
            let all = self.about(&axis).into_iter();
            all.max_by(|a, b| a.disc_n_m.total_cmp(&b.disc_n_m)).map(|found| (at, found))
        };
        let larger = |a: Option<(Vector2<f64>, RelaxedHover)>, b: Option<(Vector2<f64>, RelaxedHover)>| match (a, b) {
            (Some(a), Some(b)) => Some(if b.1.disc_n_m > a.1.disc_n_m { b } else { a }),
            (a, b) => a.or(b),
        };
        let grid = (0..AZIMUTHS).flat_map(|j| (1..=TILTS).map(move |i| (i, j)));
        let polar = |(i, j): (usize, usize)| {
            let (sin, cos) = (std::f64::consts::TAU * j as f64 / AZIMUTHS as f64).sin_cos();
            Vector2::new(cos, sin) * (MOST_TILT * i as f64 / TILTS as f64).sin()
        };
        let mut found = grid.map(|at| best(polar(at))).fold(None, larger)?;
        // Compass search.
        let mut step = MOST_TILT / TILTS as f64;
        while step > 1e-7 {
            let from = found.0;
            let around = (0..WAYS).map(|k| {
                let (sin, cos) = (std::f64::consts::TAU * k as f64 / WAYS as f64).sin_cos();
                best(from + Vector2::new(cos, sin) * step)
            });
            match around.fold(None, larger) {
                Some(next) if next.1.disc_n_m > found.1.disc_n_m => found = next,
                _ => step /= 2.0,
            }
        }
        (found.1.disc_n_m > edge::width(&self.set.hover)).then_some(found.1)
    }
}

/// Rates at which an equation is evaluated to find its changes of sign.
const SCAN: usize = 64;

/// Most steps of [`root`], which takes about ten.
const MOST_STEPS: usize = 100;
/// Relative changes below this are rounding.
const ROUNDING: f64 = 1e-15;

/// The root of a function between two arguments with values of different sign, by the Illinois method: false position
/// that halves the value at an end that stays. M. Dowell, P. Jarratt, *A modified regula falsi method for computing the
/// root of an equation*, BIT 11 (1971), doi 10.1007/BF01934364.
fn root(of: &mut impl FnMut(f64) -> f64, mut low: (f64, f64), mut high: (f64, f64)) -> f64 {
    let mut last = f64::NAN;
    for _ in 0..MOST_STEPS {
        let at = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
        if !at.is_finite() || (at - last).abs() <= ROUNDING * at.abs() {
            break;
        }
        let value = of(at);
        let (replaced, kept) =
            if (value < 0.0) == (low.1 < 0.0) { (&mut low, &mut high) } else { (&mut high, &mut low) };
        let stays = replaced.0 == last;
        *replaced = (at, value);
        if stays {
            kept.1 /= 2.0;
        }
        last = at;
        if value == 0.0 {
            break;
        }
    }
    last
}

/// Torque times speed of the rotors at these thrusts (N), W; a weak rotor gives the share `capacity` of the thrust of
/// its speed.
fn power(vehicle: &Vehicle, thrusts: &[f64], capacity: &[f64]) -> f64 {
    let of = |((rotor, thrust), capacity): ((&crate::model::Rotor, &f64), &f64)| match *capacity > 0.0 {
        true => rotor.drag_coefficient * (thrust / capacity / rotor.thrust_coefficient).abs().sqrt().powi(3),
        false => 0.0,
    };
    vehicle.rotors.iter().zip(thrusts).zip(capacity).map(of).sum()
}

/// The allocation of wrenches to the rotors of a mode.
struct Allocation {
    /// Wrench of each rotor over its range, and the scale of its components.
    columns: Vec<Wrench>,
    scale: Wrench,
    offset: Wrench,
    /// Lowest thrust of each rotor and the width of its range, N.
    lowest: Vec<f64>,
    range: Vec<f64>,
    capacity: Vec<f64>,
}

impl Allocation {
    fn new(model: &Model, set: &AdmissibleSet) -> Self {
        let vehicle = &model.vehicle;
        let mode = if set.name == HEALTHY { None } else { set.mode.checked_sub(1).map(|i| &model.modes[i]) };
        let actuation = Actuation::of(vehicle);
        let (offset, generators) = mode.map_or_else(|| actuation.healthy(), |mode| actuation.under(mode));
        let extent = generators.iter().fold(Wrench::zeros(), |sum, g| sum + g.abs());
        let scale = extent.map(|e| if e > 1e-12 * extent.max() { 1.0 / e } else { 0.0 });
        let rotors = || vehicle.rotors.iter().enumerate();
        let capacity: Vec<f64> = rotors().map(|(k, _)| mode.map_or(1.0, |mode| mode.rotors[k].capacity())).collect();
        let stuck = |k: usize| mode.and_then(|mode| mode.rotors[k].stuck_at());
        Allocation {
            columns: generators.iter().map(|g| g.component_mul(&scale)).collect(),
            scale,
            offset,
            lowest: rotors()
                .map(|(k, r)| stuck(k).map_or(capacity[k] * r.idle_thrust(), |s| s * r.max_thrust()))
                .collect(),
            range: rotors()
                .map(|(k, r)| if stuck(k).is_some() { 0.0 } else { capacity[k] * (r.max_thrust() - r.idle_thrust()) })
                .collect(),
            capacity,
        }
    }

    /// Thrusts (N) with the smallest sum of squares of the shares of their ranges that give the wrench, or come nearest
    /// to it. `multipliers` are where the search starts, and then where it ended.
    fn thrusts(&self, wrench: &Wrench, multipliers: &mut Wrench) -> Vec<f64> {
        let n = self.columns.len();
        let bounds = Bounds { least: &[0.0; MOST_ROTORS][..n], most: &[1.0; MOST_ROTORS][..n] };
        let w = (wrench - self.offset).component_mul(&self.scale);
        *multipliers = bounded(&self.columns, bounds, &w, &Wrench::repeat(1e12), *multipliers);
        let share = |k: usize, column: &Wrench| bounds.clip(k, column.dot(multipliers));
        let columns = self.columns.iter().enumerate();
        columns.map(|(k, column)| self.lowest[k] + self.range[k] * share(k, column)).collect()
    }

    /// The speed (rad/s) of rotor k at a thrust (N).
    fn speed(&self, rotor: &crate::model::Rotor, k: usize, thrust: f64) -> f64 {
        match self.capacity[k] > 0.0 {
            true => signed_root(thrust / self.capacity[k] / rotor.thrust_coefficient),
            false => 0.0,
        }
    }
}
