//! The commands of motors whose outputs are not looked at.
//!
//! A mixer adds up what the controller demands: motor k is commanded `e_k d`, d the thrust and the torques. So d
//! follows from the outputs that are seen, and, if they leave it open, from the demands that the log has.

use super::fit::Effect;
use super::record::{Record, Series};
use nalgebra::{DMatrix, Matrix4, Vector4};

/// Weights of the demands of thrust, roll, pitch and yaw against those of the commands that are seen: a mixer that
/// saturates gives up yaw and thrust before it gives up roll and pitch.
const WEIGHTS: [f64; 4] = [1e-3, 0.1, 0.1, 1e-3];
/// Demands are not filled in over gaps of more than this, s.
const GAP: f64 = 0.3;
/// The largest factor of roll, pitch or yaw in ArduPilot's mixers.
const LARGEST: f64 = 0.5;
/// The fewest outputs that determine thrust and torques.
pub const DETERMINED: usize = 4;

/// What the mixer would command hidden motors.
pub struct Mixed<'r> {
    effects: &'r [Effect],
    seen: Vec<usize>,
    /// d from the commands that are seen alone: the shortest, 4 x seen.
    of_seen: DMatrix<f64>,
    demands: Option<Demands<'r>>,
}

/// The demands of a log, in units of the effects.
struct Demands<'r> {
    times: &'r [f64],
    series: &'r Series<4>,
    scales: Vector4<f64>,
    weights: Vector4<f64>,
    /// The inverse of the normal equations of commands and demands.
    inverse: Matrix4<f64>,
}

impl<'r> Mixed<'r> {
    /// `None` if no motor is hidden.
    pub fn of(record: &'r Record, effects: &'r [Effect], hidden: &[usize]) -> Option<Self> {
        let seen: Vec<usize> = (0..effects.len()).filter(|k| !hidden.contains(k)).collect();
        if hidden.is_empty() {
            return None;
        }
        let matrix = DMatrix::from_fn(seen.len(), 4, |row, axis| effects[seen[row]][axis]);
        let of_seen = if seen.is_empty() { DMatrix::zeros(4, 0) } else { matrix.pseudo_inverse(1e-6).ok()? };
        let demands = Demands::of(record, effects, &seen);
        Some(Mixed { effects, seen, of_seen, demands })
    }

    /// Whether the commands follow from what is seen.
    pub fn is_determined(&self) -> bool {
        self.seen.len() >= DETERMINED || self.demands.is_some()
    }

    /// The command of a hidden motor in a row of the outputs, from those that are seen in it.
    pub fn command(&self, row: usize, motor: usize, commands: &dyn Fn(usize, usize) -> f64) -> f64 {
        let effect = Vector4::from(self.effects[motor]);
        let with_demands = self.demands.as_ref().and_then(|demands| {
            let wanted = demands.at(row)?;
            let mut sum = wanted.component_mul(&demands.weights);
            self.seen.iter().for_each(|k| sum += Vector4::from(self.effects[*k]) * commands(row, *k));
            Some(effect.dot(&(demands.inverse * sum)))
        });
        let of_seen = || {
            let columns = self.seen.iter().enumerate();
            let part =
                |(i, k): (usize, &usize)| effect.dot(&self.of_seen.fixed_rows::<4>(0).column(i)) * commands(row, *k);
            columns.map(part).sum::<f64>()
        };
        with_demands.unwrap_or_else(of_seen).clamp(0.0, 1.0)
    }
}

impl<'r> Demands<'r> {
    /// `None` if the log has none. ArduPilot's mixer scales the factors of roll, pitch and yaw so that the largest is
    /// [`LARGEST`] (`AP_MotorsMatrix::normalise_rpy_factors`, 4.5).
    fn of(record: &'r Record, effects: &[Effect], seen: &[usize]) -> Option<Self> {
        let largest = |axis: usize| effects.iter().map(|effect| effect[axis].abs()).fold(0.0, f64::max);
        let scales = Vector4::from_fn(|axis, _| if axis == 0 { 1.0 } else { LARGEST / largest(axis) });
        let of_seen: Matrix4<f64> =
            seen.iter().map(|k| Vector4::from(effects[*k])).map(|effect| effect * effect.transpose()).sum();
        let weights = Vector4::from(WEIGHTS).component_div(&scales.component_mul(&scales));
        let inverse = (of_seen + Matrix4::from_diagonal(&weights)).try_inverse()?;
        let is_known = !record.demands.is_empty() && scales.iter().all(|scale| scale.is_finite());
        is_known.then_some(Demands { times: &record.outputs.times, series: &record.demands, scales, weights, inverse })
    }

    /// The thrust and the torques that are demanded in a row of the outputs; `None` where the log does not say.
    fn at(&self, row: usize) -> Option<Vector4<f64>> {
        let demand = self.series.at(self.times[row], GAP).map(Vector4::from)?;
        Some(demand.component_mul(&self.scales)).filter(|demand| demand.iter().all(|x| x.is_finite()))
    }
}
