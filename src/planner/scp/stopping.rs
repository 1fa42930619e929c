//! Steps to an iterate that stops inside the set: short attempts, because risk figures need dozens of them.

use super::*;

impl ScpPlanner<'_, '_> {
    /// A stop over a time grid from the state [`HoverPlanner::struck`]; `None` where the steps find none.
    pub fn stop(&mut self, grid: &TimeGrid) -> Option<Iterate> {
        let smooth = self.minimum_snap(grid)?;
        let violation = self.violation(&smooth);
        self.stop_by_steps(smooth, violation)
    }

    /// The same with a known stop from another state as the initial guess.
    pub fn stop_about(&mut self, other: Iterate) -> Option<Iterate> {
        self.stop_by_steps(other, f64::INFINITY)
    }

    /// With an infinite `violation` the iterate is not one of this mission, and the first step is taken whole.
    fn stop_by_steps(&mut self, mut iterate: Iterate, mut violation: f64) -> Option<Iterate> {
        let (settings, margin) = (self.settings.stops, self.settings.tightening.margin);
        let proximal_settings = self.settings.proximal;
        let durations = self.fixed_durations();
        let linear = matches!(self.wrench, WrenchModel::HoverAt(_));
        let mut proximal = ProximalWeight {
            weight: if linear { settings.proximal_weight_if_linear } else { settings.proximal_weight },
        };
        let weights = Weights { objective: Objective::Violation, penalty: 1.0, cost_weight: 0.0, input_weight: 0.0 };
        let mut working_set = BTreeSet::new();
        let mut history: Vec<f64> = Vec::new();
        self.multipliers.clear();
        while violation > 0.0 {
            history.push(violation);
            let is_slow = !linear
                && history.len() > settings.patience
                && violation > settings.required_fall * history[history.len() - 1 - settings.patience];
            if history.len() > settings.max_steps || is_slow || proximal.is_exhausted(&proximal_settings) {
                return None;
            }
            working_set.extend(self.rows_between(&iterate));
            let stepped = self.step(&iterate, &durations, proximal, weights, &mut working_set)?;
            if linear && stepped.sigma > 2.0 * margin {
                return None; // this program is not an approximation, and no row that it lacks would help
            }
            let mut share = 1.0;
            let (reached, now) = loop {
                let reached = iterate.with_states(iterate.towards(&stepped.states, share));
                let now = self.violation(&reached);
                let enough = now <= violation - settings.sufficient_decrease * share * (violation - stepped.sigma);
                if linear || violation.is_infinite() || enough || share < 2.0 * settings.min_share {
                    break (reached, now);
                }
                share *= 0.5;
            };
            if share < 0.5 {
                proximal = proximal.increased(&proximal_settings);
            }
            if linear || now < violation {
                (iterate, violation) = (reached, now);
            }
        }
        Some(iterate)
    }
}
