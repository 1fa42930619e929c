//! The commands of motors whose outputs are not looked at.
//!
//! A mixer adds up what the controller demands: motor k is commanded `e_k d`, d the thrust and the torques. So d
//! follows from the outputs that are seen, and, if they leave it open, from the demands that the log has.

use super::fit::Effect;
use super::outputs::Frozen;
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
    times: &'r [f64],
    /// From the start of the record on, and anew from each output on that no longer follows the mixer.
    stages: Vec<Stage<'r>>,
}

/// What commands follow from, from a time (s) on.
struct Stage<'r> {
    from: f64,
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
    /// `None` if no motor is hidden. Outputs say nothing of the mixer from when on they are `frozen`.
    pub fn of(record: &'r Record, effects: &'r [Effect], hidden: &[usize], frozen: &[Frozen]) -> Option<Self> {
        if hidden.is_empty() {
            return None;
        }
        let begins = std::iter::once(f64::NEG_INFINITY).chain(frozen.iter().map(|one| one.from));
        let stage = |from: f64| {
            let follows =
                |k: &usize| !hidden.contains(k) && !frozen.iter().any(|one| one.motor == *k && one.from <= from);
            let seen: Vec<usize> = (0..effects.len()).filter(follows).collect();
            let matrix = DMatrix::from_fn(seen.len(), 4, |row, axis| effects[seen[row]][axis]);
            let of_seen = if seen.is_empty() { DMatrix::zeros(4, 0) } else { matrix.pseudo_inverse(1e-6).ok()? };
            let demands = Demands::of(record, effects, &seen);
            Some(Stage { from, seen, of_seen, demands })
        };
        let mut stages: Vec<Stage> = begins.map(stage).collect::<Option<_>>()?;
        stages.sort_by(|a, b| a.from.total_cmp(&b.from));
        Some(Mixed { effects, times: &record.outputs.times, stages })
    }

    /// Whether the commands follow from what is seen while no output is frozen.
    pub fn is_determined(&self) -> bool {
        self.stages[0].seen.len() >= DETERMINED || self.stages[0].demands.is_some()
    }

    /// The command of a hidden motor in a row of the outputs, from those that are seen in it.
    pub fn command(&self, row: usize, motor: usize, commands: &dyn Fn(usize, usize) -> f64) -> f64 {
        let effect = Vector4::from(self.effects[motor]);
        let stage = &self.stages[self.stages.partition_point(|stage| stage.from <= self.times[row]).max(1) - 1];
        let with_demands = stage.demands.as_ref().and_then(|demands| {
            let wanted = demands.at(row)?;
            let mut sum = wanted.component_mul(&demands.weights);
            stage.seen.iter().for_each(|k| sum += Vector4::from(self.effects[*k]) * commands(row, *k));
            Some(effect.dot(&(demands.inverse * sum)))
        });
        let of_seen = || {
            let columns = stage.seen.iter().enumerate();
            let part =
                |(i, k): (usize, &usize)| effect.dot(&stage.of_seen.fixed_rows::<4>(0).column(i)) * commands(row, *k);
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
