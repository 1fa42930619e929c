//! From a wanted wrench to rotor speeds, by (42) or by bounded weighted least squares, with the capacities that the
//! controller believes in.

use crate::actuation::{Actuation, Wrench};
use crate::admissible::allocation::{Bounds, MOST_ROTORS, bounded};
use crate::admissible::pseudo_inverse;
use crate::model::{Allocation, Model};

/// Weights on the missing part of the wrench beside one on the rotors' shares of full thrust, for T, tau_x, tau_y,
/// tau_z in shares of the largest each can be. Yaw is given up first, thrust next, roll and pitch last.
const WEIGHTS: [f64; 4] = [1e8, 1e10, 1e10, 1e4];

/// The largest share of full thrust, rotor by rotor.
const WHOLE: [f64; MOST_ROTORS] = [1.0; MOST_ROTORS];

/// What the controller believes of each rotor.
#[derive(Debug, Clone, PartialEq)]
pub struct Belief {
    /// theta of (32).
    pub capacity: Vec<f64>,
    /// Share of full thrust at which a rotor is stuck.
    pub stuck: Vec<Option<f64>>,
}

impl Belief {
    pub fn healthy(rotors: usize) -> Self {
        Belief { capacity: vec![1.0; rotors], stuck: vec![None; rotors] }
    }
}

/// Allocates wrenches; nothing here allocates memory once it is made.
#[derive(Debug, Clone)]
pub struct Allocator {
    method: Allocation,
    /// Wrench at full thrust over `extent`, healthy; one a rotor.
    full: Vec<Wrench>,
    /// The same under the belief; zero for stuck rotors.
    columns: Vec<Wrench>,
    /// Share of full thrust at which a rotor is believed stuck.
    stuck: Vec<Option<f64>>,
    /// What the stuck rotors give, over `extent`.
    shift: Wrench,
    /// Sum of the rotors' absolute wrenches: N, N m, N m, N m.
    extent: Wrench,
    /// Share of full thrust at the lowest speed, rotor by rotor.
    least: Vec<f64>,
    max_speed: Vec<f64>,
    /// Largest squared speed over the largest of all rotors'.
    fullest: Vec<f64>,
    /// Pseudo-inverse of `columns`, n x 4 as its rows.
    inverse: Vec<Wrench>,
    /// Multipliers of the last wrench: near those of the next.
    lambda: Wrench,
}

impl Allocator {
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
            least: model.vehicle.rotors.iter().map(|r| (r.min_speed / r.max_speed).powi(2)).collect(),
            fullest: pseudo_inverse::fullest(&actuation),
            max_speed: model.vehicle.rotors.iter().map(|r| r.max_speed).collect(),
            inverse: vec![Wrench::zeros(); n],
            lambda: Wrench::zeros(),
        };
        allocator.believe(&Belief::healthy(n));
        allocator
    }

    /// Reconfigures: B = A diag(theta) of (41), and its pseudo-inverse where that is in use.
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

    /// Speeds (rad/s) into `speeds` for a wrench. A rotor believed lost gets its lowest, a stuck one what it has.
    pub fn speeds(&mut self, wrench: &Wrench, speeds: &mut [f64]) {
        let mut wanted = wrench.component_div(&self.extent) - self.shift;
        let bounds = Bounds { least: &self.least, most: &WHOLE };
        // No vehicle gives more yaw than this, and what is missing of it draws on thrust by its weight.
        if self.method == Allocation::Bounded {
            wanted[3] = wanted[3].clamp(-1.0, 1.0);
            self.lambda = bounded(&self.columns, bounds, &wanted, &WEIGHTS.into(), self.lambda);
        }
        let (rows, by) = match self.method {
            Allocation::Bounded => (&self.columns, &self.lambda),
            Allocation::PseudoInverse => (&self.inverse, &wanted),
        };
        for (k, speed) in speeds.iter_mut().enumerate() {
            let share = self.stuck[k].unwrap_or_else(|| bounds.clip(k, rows[k].dot(by)));
            *speed = self.max_speed[k] * share.sqrt();
        }
    }

    /// How much of a wrench's thrust, roll and pitch (in shares of the largest each can be) cannot be given under a
    /// belief by rotors within their bounds; yaw is left free.
    pub fn missing(&self, wrench: &Wrench, belief: &Belief) -> f64 {
        let mut wanted = wrench.component_div(&self.extent);
        let mut columns = [Wrench::zeros(); MOST_ROTORS];
        for (k, full) in self.full.iter().enumerate() {
            match belief.stuck[k] {
                Some(share) => wanted -= full * (share * belief.capacity[k]),
                None => columns[k] = full * belief.capacity[k],
            }
        }
        let columns = &columns[..self.full.len()];
        let weights = Wrench::new(1e6, 1e6, 1e6, 1e-3);
        let bounds = Bounds { least: &self.least, most: &WHOLE };
        let lambda = bounded(columns, bounds, &wanted, &weights, Wrench::zeros());
        let given = columns.iter().enumerate().map(|(k, b)| b * bounds.clip(k, b.dot(&lambda))).sum::<Wrench>();
        (wanted - given).fixed_rows::<3>(0).norm()
    }
}
