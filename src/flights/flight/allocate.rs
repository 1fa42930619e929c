//! Allocation during a flight: from the demanded wrench to rotor speeds, by the pseudo-inverse (42) or by bounded
//! weighted least squares, with the believed capacities (`docs/flight.md`, section 3).

use crate::actuation::{Actuation, Wrench, signed_root, signed_square};
use crate::admissible::allocation::{Bounds, MOST_ROTORS, bounded};
use crate::admissible::pseudo_inverse;
use crate::geometry::polytope::Polytope;
use crate::geometry::zonotope::Zonotope;
use crate::model::{Allocation, Model};
use nalgebra::Vector3;

/// Weights on the missing part of T, tau_x, tau_y and tau_z, as shares of the largest value of each, relative to 1 on
/// the rotors' shares of full thrust. Yaw is given up first, then thrust, then roll and pitch.
const WEIGHTS: [f64; 4] = [1e8, 1e10, 1e10, 1e4];

/// The upper bounds on the shares of full thrust.
const WHOLE: [f64; MOST_ROTORS] = [1.0; MOST_ROTORS];

/// The state of each rotor as the controller believes it.
#[derive(Debug, Clone, PartialEq)]
pub struct Belief {
    /// The capacity theta of (32) of each rotor, 0 to 1.
    pub capacity: Vec<f64>,
    /// The share of full thrust at which a rotor is stuck; `None` for a rotor that is not.
    pub stuck: Vec<Option<f64>>,
}

impl Belief {
    /// All rotors healthy.
    pub fn healthy(rotors: usize) -> Self {
        Belief { capacity: vec![1.0; rotors], stuck: vec![None; rotors] }
    }
}

/// Allocates wrenches to n rotors. Only [`Allocator::new`] allocates memory.
#[derive(Debug, Clone)]
pub struct Allocator {
    method: Allocation,
    /// Wrench of each healthy rotor at full thrust, over `extent`.
    full: Vec<Wrench>,
    /// Wrench of each rotor at full thrust under the belief, over `extent`; zero for stuck rotors.
    columns: Vec<Wrench>,
    /// Share of full thrust at which a rotor is believed stuck.
    stuck: Vec<Option<f64>>,
    /// Wrench of the stuck rotors, over `extent`.
    shift: Wrench,
    /// Sum of the absolute wrenches of all rotors at full thrust: N, N m, N m, N m.
    extent: Wrench,
    /// Share of full thrust of each rotor at its lowest speed.
    least: Vec<f64>,
    max_speed: Vec<f64>,
    /// Largest squared speed of each rotor over the largest of all rotors.
    fullest: Vec<f64>,
    /// Rows of the pseudo-inverse of `columns` (n x 4).
    inverse: Vec<Wrench>,
    /// Multipliers of the last wrench, the warm start for the next one.
    lambda: Wrench,
}

impl Allocator {
    /// An allocator that believes all rotors healthy.
    pub fn new(model: &Model, method: Allocation) -> Self {
        let actuation = Actuation::of(&model.vehicle);
        let full: Vec<Wrench> = (0..actuation.rotors()).map(|k| actuation.full(k)).collect();
        let extent = full.iter().fold(Wrench::zeros(), |sum, g| sum + g.abs());
        let extent = extent.map(|e| if e > 1e-12 * extent.max() { e } else { 1.0 });
        let full: Vec<Wrench> = full.iter().map(|g| g.component_div(&extent)).collect();
        let n = full.len();
        let mut allocator = Allocator {
            method,
            columns: full.clone(),
            full,
            stuck: vec![None; n],
            shift: Wrench::zeros(),
            extent,
            least: model.vehicle.rotors.iter().map(|r| signed_square(r.min_speed / r.max_speed)).collect(),
            fullest: pseudo_inverse::fullest(&actuation),
            max_speed: model.vehicle.rotors.iter().map(|r| r.max_speed).collect(),
            inverse: vec![Wrench::zeros(); n],
            lambda: Wrench::zeros(),
        };
        allocator.believe(&Belief::healthy(n));
        allocator
    }

    /// Reconfigures for a new belief: B = A diag(theta) of (41), and its pseudo-inverse if that is the method.
    pub fn believe(&mut self, belief: &Belief) {
        self.shift = Wrench::zeros();
        self.stuck.copy_from_slice(&belief.stuck);
        for k in 0..self.full.len() {
            self.columns[k] = match belief.stuck[k] {
                Some(share) => {
                    self.shift += self.full[k] * (share * belief.capacity[k]);
                    Wrench::zeros()
                }
                None => self.full[k] * belief.capacity[k],
            };
        }
        if self.method == Allocation::PseudoInverse {
            pseudo_inverse::inverse(&self.columns, &self.fullest, &mut self.inverse);
        }
        self.lambda = Wrench::zeros();
    }

    /// Writes the rotor speeds (rad/s) for a wrench (N and N m) to `speeds` (n). A rotor believed lost gets its lowest
    /// speed, a stuck one the speed at which it is stuck.
    pub fn speeds(&mut self, wrench: &Wrench, speeds: &mut [f64]) {
        self.speeds_by(self.method, wrench, speeds);
    }

    /// The speeds for a wrench by bounded allocation, whatever the vehicle's method: with yaw given up.
    pub(super) fn bounded_speeds(&mut self, wrench: &Wrench, speeds: &mut [f64]) {
        self.speeds_by(Allocation::Bounded, wrench, speeds);
    }

    fn speeds_by(&mut self, method: Allocation, wrench: &Wrench, speeds: &mut [f64]) {
        let mut wanted = wrench.component_div(&self.extent) - self.shift;
        let bounds = Bounds { least: &self.least, most: &WHOLE };
        // No vehicle produces more yaw torque than this. A larger demand would only trade thrust for yaw.
        if method == Allocation::Bounded {
            wanted[3] = wanted[3].clamp(-1.0, 1.0);
            self.lambda = bounded(&self.columns, bounds, &wanted, &WEIGHTS.into(), self.lambda);
        }
        let (rows, by) = match method {
            Allocation::Bounded => (&self.columns, &self.lambda),
            Allocation::PseudoInverse => (&self.inverse, &wanted),
        };
        for (k, speed) in speeds.iter_mut().enumerate() {
            let share = self.stuck[k].unwrap_or_else(|| bounds.clip(k, rows[k].dot(by)));
            *speed = self.max_speed[k] * signed_root(share);
        }
    }

    /// Sum of the absolute wrenches of all rotors at full thrust: N, N m, N m, N m.
    pub(super) fn extent(&self) -> &Wrench {
        &self.extent
    }

    /// The set of (T, tau_x, tau_y) that rotors within their bounds produce under a belief, N and N m.
    pub(super) fn without_yaw(&self, belief: &Belief) -> Polytope<3, ()> {
        let part = |w: &Wrench| w.component_mul(&self.extent).fixed_rows::<3>(0).into_owned();
        let mut offset = Vector3::zeros();
        let mut generators = Vec::with_capacity(self.full.len());
        for (k, full) in self.full.iter().enumerate() {
            let (full, capacity) = (part(full), belief.capacity[k]);
            match belief.stuck[k] {
                Some(share) => offset += full * (share * capacity),
                None => {
                    offset += full * (self.least[k] * capacity);
                    generators.push(full * ((1.0 - self.least[k]) * capacity));
                }
            }
        }
        Zonotope { offset, generators }.facets().without_origins()
    }

    /// The norm of the part of a wrench's thrust, roll and pitch that rotors within their bounds cannot produce under a
    /// belief, each as a share of its largest value. Yaw is left free.
    pub fn missing(&self, wrench: &Wrench, belief: &Belief) -> f64 {
        self.missing_part(wrench, belief, Wrench::new(1e6, 1e6, 1e6, 1e-3)).fixed_rows::<3>(0).norm()
    }

    /// The part of a wrench, yaw included, that is missing.
    pub(super) fn missing_all(&self, wrench: &Wrench, belief: &Belief) -> f64 {
        self.missing_part(wrench, belief, Wrench::repeat(1e6)).norm()
    }

    fn missing_part(&self, wrench: &Wrench, belief: &Belief, weights: Wrench) -> Wrench {
        let mut wanted = wrench.component_div(&self.extent);
        let mut columns = [Wrench::zeros(); MOST_ROTORS];
        for (k, full) in self.full.iter().enumerate() {
            match belief.stuck[k] {
                Some(share) => wanted -= full * (share * belief.capacity[k]),
                None => columns[k] = full * belief.capacity[k],
            }
        }
        let columns = &columns[..self.full.len()];
        let bounds = Bounds { least: &self.least, most: &WHOLE };
        let lambda = bounded(columns, bounds, &wanted, &weights, Wrench::zeros());
        let given = columns.iter().enumerate().map(|(k, b)| b * bounds.clip(k, b.dot(&lambda))).sum::<Wrench>();
        wanted - given
    }
}
