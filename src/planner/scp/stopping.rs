//! Steps to an iterate that stops inside the set: short attempts, for they are asked by the dozen.

use super::*;

/// Proximal weight of steps: where the wrench is linear in the motion a step need not stay near.
const LINEAR: f64 = 1e-5;
const CURVED: f64 = 0.1;

/// Most steps; over each [`PATIENCE`] of them the violation has to fall by half.
const MOST_STEPS: usize = 8;
const PATIENCE: usize = 2;

/// A step that keeps less than this share of itself is not worth a try.
const LEAST_SHARE: f64 = 0.1;

impl ScpPlanner<'_, '_> {
    /// A stop over a profile, from the engine's `struck` on; `None` where the steps find none.
    pub fn stop(&mut self, grid: &TimeGrid) -> Option<Iterate> {
        let smooth = self.smooth(grid)?;
        let violation = self.violation(&smooth);
        self.stop_by_steps(smooth, violation)
    }

    /// The same with a known stop from another state as the initial guess.
    pub fn stop_about(&mut self, other: Iterate) -> Option<Iterate> {
        self.stop_by_steps(other, f64::INFINITY)
    }

    /// With an infinite `violation` the iterate is none of this mission, and the first step is taken whole.
    fn stop_by_steps(&mut self, mut iterate: Iterate, mut violation: f64) -> Option<Iterate> {
        let durations = self.durations_stand();
        let linear = matches!(self.wrench, WrenchModel::HoverAt(_));
        let mut proximal = ProximalWeight { weight: if linear { LINEAR } else { CURVED } };
        let weights = Weights { objective: Objective::Violation, penalty: 1.0, smoothing: 0.0, input_weight: 0.0 };
        let mut working_set = BTreeSet::new();
        let mut history: Vec<f64> = Vec::new();
        self.multipliers.clear();
        while violation > 0.0 {
            history.push(violation);
            let stuck = !linear && history.len() > PATIENCE && violation > 0.5 * history[history.len() - 1 - PATIENCE];
            if history.len() > MOST_STEPS || stuck || proximal.exhausted() {
                return None;
            }
            working_set.extend(self.rows_between(&iterate));
            let stepped = self.step(&iterate, &durations, proximal, weights, &mut working_set)?;
            if linear && stepped.sigma > 2.0 * TIGHTENING {
                return None; // this program is no approximation, and lacks no row that could help
            }
            let mut share = 1.0;
            let (reached, now) = loop {
                let reached = iterate.with_states(iterate.towards(&stepped.states, share));
                let now = self.violation(&reached);
                let enough = now <= violation - 0.2 * share * (violation - stepped.sigma);
                if linear || violation.is_infinite() || enough || share < 2.0 * LEAST_SHARE {
                    break (reached, now);
                }
                share *= 0.5;
            };
            if share < 0.5 {
                proximal = proximal.less();
            }
            if linear || now < violation {
                (iterate, violation) = (reached, now);
            }
        }
        Some(iterate)
    }
}
