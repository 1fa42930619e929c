//! Steps to an iterate that stops inside the set: short attempts, because risk figures need dozens of them.

use super::*;

/// States count as equal within this, as a share of their size (at least 1, in SI units): the solver leaves less.
const BEGINS_WITHIN: f64 = 1e-5;

impl ScpPlanner<'_, '_> {
    /// A stop over a time grid from the state [`HoverPlanner::struck`]; `None` where the steps find none.
    pub fn stop(&mut self, grid: &TimeGrid) -> Option<Iterate> {
        let smooth = self.minimum_snap(grid)?;
        let violation = self.violation(&smooth);
        self.stop_by_steps(smooth, violation)
    }

    /// A stop with a known one from another state as the initial guess.
    pub fn stop_about(&mut self, other: Iterate) -> Option<Iterate> {
        self.stop_by_steps(other, f64::INFINITY)
    }

    /// With an infinite `violation` the iterate is not one of this mission, and the first step is taken whole. So is
    /// one from an iterate that violates nothing but begins in another state: minimum-snap motions over long legs do,
    /// because they are solved in another time.
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
        if violation <= 0.0 && !self.begins_as_struck(&iterate) {
            violation = f64::INFINITY;
        }
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
            if violation <= 0.0 && !self.begins_as_struck(&iterate) {
                violation = f64::INFINITY;
            }
        }
        Some(iterate)
    }

    /// Whether an iterate begins with the position and the velocity of [`HoverPlanner::struck`].
    fn begins_as_struck(&self, iterate: &Iterate) -> bool {
        let (Some(struck), Some(first)) = (&self.hover.struck, iterate.states.first()) else { return true };
        let is_near = |axis: usize, order: usize| {
            let (due, there) = (struck[axis][order], first[axis][order]);
            (there - due).abs() <= BEGINS_WITHIN * due.abs().max(1.0)
        };
        ALL_AXES.into_iter().all(|axis| is_near(axis, 0) && is_near(axis, 1))
    }
}
