//! The commands of motors whose outputs are not looked at.
//!
//! A mixer adds up what the controller demands: motor k is commanded `e_k d`, d the thrust and the torques. So d
//! follows from the outputs that are seen, and what they leave open from the demands that ArduPilot logs and its
//! [mixer](super::mixer).

use super::fit::Effect;
use super::mixer::Mixer;
use super::outputs::Frozen;
use super::record::{Record, median};
use nalgebra::{DMatrix, Vector4};

/// Demands are not filled in over gaps of more than this, s.
const GAP: f64 = 0.3;
/// ArduPilot's default of `MOT_YAW_HEADROOM`, and its unit.
const HEADROOM: f64 = 200.0;
const THOUSANDTH: f64 = 1e-3;
/// The mixer is the known one if it makes outputs of this error of this share of the rows.
const CLOSE: f64 = 0.05;
const MOSTLY: f64 = 0.9;
/// Less thrust than this is commanded on the ground.
const GROUND: f64 = 0.1;
/// How much of the difference of one row the compensation of the battery's voltage and the air takes over.
const FOLLOWS: f64 = 0.05;
/// The fewest outputs that determine thrust and torques.
pub const DETERMINED: usize = 4;

/// What the mixer would command hidden motors.
pub struct Mixed<'r> {
    effects: &'r [Effect],
    times: &'r [f64],
    /// The motors whose outputs are looked at.
    visible: Vec<usize>,
    demanded: Option<Demanded<'r>>,
    /// From the start of the record on, and anew from each output on that no longer follows the mixer.
    stages: Vec<Stage>,
}

/// What commands follow from, from a time (s) on.
struct Stage {
    from: f64,
    seen: Vec<usize>,
    /// d from the commands that are seen alone: the shortest, 4 x seen.
    of_seen: DMatrix<f64>,
}

/// The demands of a log and the mixer that makes outputs of them.
struct Demanded<'r> {
    record: &'r Record,
    mixer: Mixer,
    /// By row of the outputs: the factor of all demands for the battery's voltage and the density of the air.
    compensation: Vec<f32>,
}

impl Stage {
    fn of(from: f64, seen: Vec<usize>, effects: &[Effect]) -> Option<Self> {
        let matrix = DMatrix::from_fn(seen.len(), 4, |row, axis| effects[seen[row]][axis]);
        let of_seen = if seen.is_empty() { DMatrix::zeros(4, 0) } else { matrix.pseudo_inverse(1e-6).ok()? };
        Some(Stage { from, seen, of_seen })
    }
}

impl<'r> Mixed<'r> {
    /// `None` if no motor is hidden. `commands` are those of outputs. Until it is known which of these are frozen,
    /// demands are preferred to all of them.
    pub fn of(
        record: &'r Record,
        commands: &dyn Fn(usize, usize) -> f64,
        effects: &'r [Effect],
        hidden: &[usize],
    ) -> Option<Self> {
        if hidden.is_empty() {
            return None;
        }
        let visible: Vec<usize> = (0..effects.len()).filter(|k| !hidden.contains(k)).collect();
        let demanded = Demanded::of(record, commands, effects, &visible);
        let seen = if demanded.is_some() { Vec::new() } else { visible.clone() };
        let stages = vec![Stage::of(f64::NEG_INFINITY, seen, effects)?];
        Some(Mixed { effects, times: &record.outputs.times, visible, demanded, stages })
    }

    /// With outputs that say nothing of the mixer from when on they are `frozen`.
    pub fn without(self, frozen: &[Frozen]) -> Option<Self> {
        let begins = std::iter::once(f64::NEG_INFINITY).chain(frozen.iter().map(|one| one.from));
        let stage = |from: f64| {
            let follows = |k: &usize| !frozen.iter().any(|one| one.motor == *k && one.from <= from);
            Stage::of(from, self.visible.iter().copied().filter(follows).collect(), self.effects)
        };
        let mut stages: Vec<Stage> = begins.map(stage).collect::<Option<_>>()?;
        stages.sort_by(|a, b| a.from.total_cmp(&b.from));
        Some(Mixed { stages, ..self })
    }

    /// Whether the commands follow from the demands that are logged.
    pub fn is_demanded(&self) -> bool {
        self.demanded.is_some()
    }

    /// Whether the commands follow from what is seen while no output is frozen.
    pub fn is_determined(&self) -> bool {
        self.visible.len() >= DETERMINED || self.is_demanded()
    }

    /// The command of a hidden motor in a row of the outputs, from those that are seen in it: as demanded, if what is
    /// seen is nearly as demanded too.
    pub fn command(&self, row: usize, motor: usize, commands: &dyn Fn(usize, usize) -> f64) -> f64 {
        let stage = &self.stages[self.stages.partition_point(|stage| stage.from <= self.times[row]).max(1) - 1];
        let demanded = self.demanded.as_ref().and_then(|demanded| Some(demanded.given(row)?.0));
        let mut d = demanded.unwrap_or_default();
        let error = |k: &usize| commands(row, *k) - Vector4::from(self.effects[*k]).dot(&d);
        let errors: Vec<f64> = stage.seen.iter().map(error).collect();
        if demanded.is_none() || errors.iter().any(|error| error.abs() > CLOSE) {
            let corrections = errors.iter().enumerate();
            d += corrections
                .map(|(column, error)| stage.of_seen.fixed_rows::<4>(0).column(column) * *error)
                .sum::<Vector4<f64>>();
        }
        Vector4::from(self.effects[motor]).dot(&d).clamp(0.0, 1.0)
    }
}

impl<'r> Demanded<'r> {
    /// `None` if the log has no demands, or another mixer.
    fn of(
        record: &'r Record,
        commands: &dyn Fn(usize, usize) -> f64,
        effects: &[Effect],
        seen: &[usize],
    ) -> Option<Self> {
        let mixer = Mixer::of(effects, THOUSANDTH * record.parameter("MOT_YAW_HEADROOM", HEADROOM))?;
        let rows = record.outputs.times.len();
        let mut found = Demanded { record, mixer, compensation: vec![1.0; rows] };
        let (mut compensation, mut known, mut close) = (1.0, 0, 0);
        for row in 0..rows {
            found.compensation[row] = compensation as f32;
            let Some((given, fits)) = found.given(row) else { continue };
            let mixed = |k: usize| given.dot(&Vector4::from(effects[k]));
            // The median, because an output that is held or off no longer follows.
            let middle = |of: &dyn Fn(usize) -> f64| median(&mut seen.iter().map(|k| of(*k)).collect::<Vec<_>>());
            // The room for yaw depends on a bound that few logs have.
            if !fits || middle(&|k| commands(row, k)).is_none_or(|command| command.is_nan() || command < GROUND) {
                continue;
            }
            known += 1;
            close += usize::from(middle(&|k| (commands(row, k) - mixed(k)).abs()).is_some_and(|error| error < CLOSE));
            let ratio = middle(&|k| commands(row, k) / mixed(k)).filter(|ratio| ratio.is_finite());
            compensation += FOLLOWS * compensation * (ratio.unwrap_or(1.0).clamp(0.5, 2.0) - 1.0);
        }
        (known > 0 && close as f64 > MOSTLY * known as f64).then_some(found)
    }

    /// The thrust and torques d that the mixer makes of the demands in a row of the outputs, and whether all of them
    /// fit; `None` where the log does not say.
    fn given(&self, row: usize) -> Option<(Vector4<f64>, bool)> {
        let demands = self.record.demands.at(self.record.outputs.times[row], GAP)?;
        let demands = demands.map(|demand| f64::from(self.compensation[row]) * demand);
        let (given, fits) = demands.iter().all(|demand| demand.is_finite()).then(|| self.mixer.mix(demands))?;
        Some((Vector4::from(given), fits))
    }
}
