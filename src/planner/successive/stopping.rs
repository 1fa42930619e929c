//! Steps to a motion that stops inside the set: short attempts, for they are asked by the dozen.

use super::*;

/// Proximity of steps: where the wrench is linear in the motion a step need not stay near.
const LINEAR: f64 = 1e-5;
const CURVED: f64 = 0.1;

/// Most steps; over each [`PATIENCE`] of them the excess has to fall by half.
const MOST_STEPS: usize = 8;
const PATIENCE: usize = 2;

/// A step that keeps less than this share of itself is not worth a try.
const LEAST_SHARE: f64 = 0.1;

impl Successive<'_, '_> {
    /// A stop over a profile, from the engine's `struck` on; `None` where the steps find none.
    pub fn stop(&mut self, profile: &Profile) -> Option<Motion> {
        let smooth = self.smooth(profile)?;
        let excess = self.excess(&smooth);
        self.stop_by_steps(smooth, excess)
    }

    /// The same begun from a stop found elsewhere, which begins in another state.
    pub fn stop_about(&mut self, other: Motion) -> Option<Motion> {
        self.stop_by_steps(other, f64::INFINITY)
    }

    /// With an infinite `excess` the motion is none of this mission, and the first step is taken whole.
    fn stop_by_steps(&mut self, mut motion: Motion, mut excess: f64) -> Option<Motion> {
        let durations = self.durations_stand();
        let linear = matches!(self.wrench, WrenchModel::HoverAt(_));
        let mut trust = Trust { proximity: if linear { LINEAR } else { CURVED } };
        let weights = Weights { objective: Objective::Excess, penalty: 1.0, smoothing: 0.0, calming: 0.0 };
        let mut pool = BTreeSet::new();
        let mut history: Vec<f64> = Vec::new();
        self.multipliers.clear();
        while excess > 0.0 {
            history.push(excess);
            let stuck = !linear && history.len() > PATIENCE && excess > 0.5 * history[history.len() - 1 - PATIENCE];
            if history.len() > MOST_STEPS || stuck || trust.exhausted() {
                return None;
            }
            pool.extend(self.rows_between(&motion));
            let stepped = self.step(&motion, &durations, trust, weights, &mut pool)?;
            if linear && stepped.sigma > 2.0 * BACK_OFF {
                return None; // this program is no approximation, and lacks no row that could help
            }
            let mut share = 1.0;
            let (reached, now) = loop {
                let reached = motion.with_states(motion.towards(&stepped.states, share));
                let now = self.excess(&reached);
                let enough = now <= excess - 0.2 * share * (excess - stepped.sigma);
                if linear || excess.is_infinite() || enough || share < 2.0 * LEAST_SHARE {
                    break (reached, now);
                }
                share *= 0.5;
            };
            if share < 0.5 {
                trust = trust.less();
            }
            if linear || now < excess {
                (motion, excess) = (reached, now);
            }
        }
        Some(motion)
    }
}
