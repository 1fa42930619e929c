//! The two phases at one mission time: the feasibility phase, which restores an iterate to the set, and the cost phase, which
//! minimises the cost (48) there.

use super::*;
use settings::{ShorteningWeights, StoppingRule};

/// How far a step shortens the duration.
#[derive(Debug, Clone, Copy)]
pub(super) enum Shorter {
    /// By as much as the linear model allows, at most by the first share of the duration; less than the second share is a failure.
    UpTo(f64, f64),
    /// By this share of the duration, even if the linear model predicts a violation: the feasibility phase may still remove it.
    By(f64),
}

/// The state of a cost phase.
struct CostPhase {
    /// Steps that it may still take.
    left: usize,
    proximal: ProximalWeight,
    weights: Weights,
}

impl ScpPlanner<'_, '_> {
    pub(super) fn fixed_durations(&self) -> Durations {
        Durations { legs: vec![None; self.hover.mission.legs.len()], range: (0.0, 0.0), spans: Vec::new() }
    }

    /// Shortens all durations alike: one subproblem about the iterate as it is, because the same iterate flown faster can be far
    /// outside the set, where the linear model predicts nothing; then the feasibility phase. `None` if either fails.
    pub(super) fn shorten_alike(
        &mut self,
        iterate: &Iterate,
        shorter: Shorter,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let settings = self.settings.descent;
        let (range, objective, weights, least) = match shorter {
            Shorter::UpTo(share, least) => ((-share, 0.0), Objective::Time, settings.free_duration, least),
            Shorter::By(share) => ((-share, -share), Objective::Cost, settings.given_duration, 0.0),
        };
        let ShorteningWeights { proximal, cost: cost_weight } = weights;
        let durations = Durations { legs: vec![Some(0); self.hover.mission.legs.len()], range, spans: Vec::new() };
        let weights = Weights { objective, penalty: settings.penalty, cost_weight, input_weight: 0.0 };
        let stepped = self.step(iterate, &durations, ProximalWeight { weight: proximal }, weights, working_set)?;
        if stepped.changes[0] > -least {
            return None;
        }
        if stepped.sigma > self.settings.feasibility.max_predicted {
            return None;
        }
        self.restore_feasibility(iterate.stepped(&stepped.states, &stepped.changes), working_set)
    }

    /// The feasibility phase: steps that minimise the violation, until the iterate is feasible at every instant. `None` if it does
    /// not converge, which proves nothing.
    pub(super) fn restore_feasibility(
        &mut self,
        iterate: Iterate,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        self.restore_feasibility_unless(iterate, self.settings.feasibility.max_predicted, working_set)
    }

    /// The same, ended if the linear model predicts more violation than `max_predicted`.
    pub(super) fn restore_feasibility_unless(
        &mut self,
        mut iterate: Iterate,
        max_predicted: f64,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let (settings, proximal_settings) = (self.settings.feasibility, self.settings.proximal);
        let durations = self.fixed_durations();
        let mut proximal = ProximalWeight { weight: settings.proximal_weight };
        let mut violation = self.violation_by(&iterate, working_set);
        // A nearly feasible iterate needs no very different inputs.
        let input_weight = if violation < settings.nearly_feasible { self.input_weight } else { 0.0 };
        let mut weights = Weights { objective: Objective::Violation, penalty: 1.0, cost_weight: 0.0, input_weight };
        let mut history = Vec::new();
        let mut predicted: Vec<f64> = Vec::new();
        let mut rejected = 0;
        self.forget_multipliers();
        while violation > 0.0 {
            history.push(violation);
            let stuck = violation > settings.nearly_feasible
                && history.len() > settings.patience
                && violation > settings.required_fall * history[history.len() - 1 - settings.patience];
            if history.len() > settings.max_steps || stuck || proximal.is_exhausted(&proximal_settings) {
                return None;
            }
            working_set.extend(self.rows_between(&iterate));
            let stepped = self.step(&iterate, &durations, proximal, weights, working_set)?;
            predicted.push(stepped.sigma);
            let (unavoidable, steady) = (settings.unavoidable, settings.steady_ratio);
            let is_stuck =
                matches!(predicted[..], [.., before, _, last] if last > f64::max(unavoidable, steady * before));
            if stepped.sigma > max_predicted || is_stuck {
                if weights.input_weight == 0.0 {
                    return None;
                }
                // Where most inputs are small any change is a large share of them: this planner goes on without the weight.
                (self.input_weight, weights.input_weight) = (0.0, 0.0);
                predicted.clear();
                history.clear();
                continue;
            }
            // If only a share of this step is taken, the next subproblem still needs the rows that the full step violates.
            let whole = iterate.with_states(stepped.states.clone());
            working_set.extend(self.rows_violated_most(&whole));
            violation = self.violation_by(&iterate, working_set);
            let mut share = 1.0;
            let (reached, now) = loop {
                let reached = iterate.with_states(iterate.towards(&stepped.states, share));
                let now = self.violation_by(&reached, working_set);
                let enough = now <= violation - settings.sufficient_decrease * share * (violation - stepped.sigma);
                if enough || share < 2.0 * settings.min_share {
                    break (reached, now);
                }
                share *= 0.5;
            };
            if share < 0.5 {
                proximal = proximal.increased(&proximal_settings);
            }
            if now < violation {
                (iterate, violation) = (reached, now);
            } else {
                // The subproblem lacked too many rows for any share of its step: it gets all of them.
                working_set.extend(self.rows_at_nodes(&whole, 0.0));
                working_set.extend(self.rows_between(&whole));
                history.pop();
                rejected += 1;
                if rejected > settings.max_rejected {
                    return None;
                }
            }
        }
        // If only a share of a step or no step was taken, gaps remain at waypoints where durations have changed.
        if !iterate.is_joined(self.settings.subproblem.joined_within) {
            let joined = self.joined(&iterate, working_set)?;
            return self.restore_feasibility_unless(joined, max_predicted, working_set);
        }
        self.prune(&iterate, working_set);
        Some(iterate)
    }

    /// The cost phase. The iterate given and the one returned are feasible at every instant; iterates in between are judged by the
    /// merit function: the relative cost, with a penalty on the violation.
    pub(super) fn minimise_cost(
        &mut self,
        iterate: Iterate,
        rule: StoppingRule,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Iterate {
        let settings = self.settings.cost;
        let (objective, penalty) = (Objective::Cost, settings.penalty);
        let weights = Weights { objective, penalty, cost_weight: 1.0, input_weight: 0.0 };
        let mut phase = CostPhase {
            left: rule.max_steps,
            proximal: ProximalWeight { weight: self.proximal_weight_of_cost_phase },
            weights,
        };
        let mut best = (self.cost(&iterate), iterate);
        loop {
            let outside = self.lower_merit(&mut best, &mut phase, rule.min_gain, working_set);
            self.proximal_weight_of_cost_phase = phase.proximal.weight.min(settings.max_initial_proximal_weight);
            // If the last iterate is infeasible, the nearest feasible one may well be the best, or lead to it.
            let mut known = working_set.clone();
            let Some(inside) = outside.and_then(|outside| self.restore_feasibility(outside, &mut known)) else {
                return best.1;
            };
            let (cost, was) = (self.cost(&inside), best.0);
            if cost < was {
                *working_set = known;
                best = (cost, inside);
            }
            if phase.left == 0 || cost > (1.0 - rule.min_gain) * was {
                return best.1;
            }
            let most = settings.max_proximal_weight_after_restoration;
            phase.proximal.weight = phase.proximal.weight.min(most);
        }
    }

    /// The steps of [`Self::minimise_cost`] from `best`, which is feasible and is replaced by the cheapest feasible iterate on the
    /// way. Returns the last iterate if it is infeasible and cheaper.
    fn lower_merit(
        &mut self,
        best: &mut (f64, Iterate),
        CostPhase { left, proximal, weights }: &mut CostPhase,
        min_gain: f64,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let (settings, proximal_settings) = (self.settings.cost, self.settings.proximal);
        let durations = self.fixed_durations();
        let (mut at, mut violation) = (best.1.clone(), 0.0);
        while *left > 0 {
            *left -= 1;
            let here = self.cost(&at);
            let Some(stepped) = self.step(&at, &durations, *proximal, *weights, working_set) else { break };
            // A sigma below the margin of the tightening is feasible.
            let sigma = stepped.sigma - self.settings.tightening.margin;
            // The cost outweighs the penalty: the penalty is raised and the subproblem solved again.
            if sigma > 0.0 && weights.penalty < settings.max_penalty {
                weights.penalty *= settings.penalty_growth;
                continue;
            }
            let penalty = weights.penalty;
            let merit = |cost: f64, violation: f64| cost / here + penalty * f64::max(violation, 0.0);
            let was = merit(here, violation);
            let towards = |s: &Self, working_set: &BTreeSet<RowAt>, share: f64| {
                let reached = at.with_states(at.towards(&stepped.states, share));
                (s.cost(&reached), s.violation_by(&reached, working_set), reached)
            };
            let expected = was - merit(self.cost(&at.with_states(stepped.states.clone())), sigma);
            if expected <= 0.0 && sigma <= 0.0 {
                break; // the linear model predicts no gain
            }
            let mut share = 1.0;
            let (mut cost, mut now, mut reached) = towards(self, working_set, share);
            while was - merit(cost, now) < settings.sufficient_gain * share * expected && share > settings.min_share {
                share *= 0.5;
                (cost, now, reached) = towards(self, working_set, share);
            }
            let gained = was - merit(cost, now);
            if now <= 0.0 && cost < best.0 {
                *best = (cost, reached.clone());
            }
            working_set.extend(self.rows_between(&reached));
            *proximal = match share {
                1.0 if expected > 0.0 => proximal.after(gained, expected, &proximal_settings),
                _ => proximal.after_share(share, &proximal_settings),
            };
            if gained > 0.0 {
                // Evaluated again, at the instants that the working set has now.
                at = reached;
                violation = self.violation_by(&at, working_set);
            }
            if expected < min_gain && sigma <= 0.0 || proximal.is_exhausted(&proximal_settings) {
                break;
            }
        }
        (violation > 0.0 && self.cost(&at) < best.0).then_some(at)
    }

    /// The cost phase, then constraint tightening until no row is violated between the instants by more than
    /// [`settings::TighteningSettings::max_violation`]. `None` if this does not converge. The local tightening belongs to this
    /// iterate: other durations and grids have other instants.
    pub(super) fn minimise_cost_between_instants(
        &mut self,
        iterate: Iterate,
        rule: StoppingRule,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let kept = self.tighten_until_inside(iterate, rule, working_set);
        self.local_tightening.clear();
        self.lag.iter_mut().for_each(|lag| lag.local_tightening.fill(0.0));
        kept
    }

    /// Rows that are violated between the instants are tightened by as much at the instants beside, and the feasibility phase is
    /// repeated.
    fn tighten_until_inside(
        &mut self,
        iterate: Iterate,
        rule: StoppingRule,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let settings = self.settings.tightening;
        let mut iterate = self.minimise_cost(iterate, rule, working_set);
        for _ in 0..settings.max_rounds {
            // The iterate whose pieces join is the one that is reported and checked.
            let joined = iterate.with_joined_pieces();
            let over = self.between_instants(&joined);
            let commands_over = self.commands_between_instants(&joined);
            if over.is_empty() && commands_over.iter().all(|violation| *violation <= settings.max_violation) {
                return Some(joined);
            }
            for (at, violation) in over {
                let Some(place) = self.place(at.row) else { continue };
                for instant in [at.instant, at.instant + 1] {
                    *self.local_tightening.entry(instant).or_default().entry(place).or_default() +=
                        settings.factor * violation;
                    working_set.insert(RowAt { instant, ..at });
                }
            }
            let command_tightening = self.lag.iter_mut().flat_map(|lag| &mut lag.local_tightening);
            for (tightening, violation) in command_tightening.zip(&commands_over) {
                *tightening += settings.factor * violation.max(0.0);
            }
            iterate = self.restore_feasibility(iterate, working_set)?;
        }
        None
    }

    /// The rows violated by more than the tightening accepts on the finer grid, each at the instant before, with its largest
    /// violation until the next instant.
    fn between_instants(&self, iterate: &Iterate) -> Vec<(RowAt, f64)> {
        let form = self.transcription(&iterate.grid, &[]);
        let mut over: BTreeMap<RowAt, f64> = BTreeMap::new();
        let settings = self.settings.tightening;
        let parts = PARTS * settings.parts;
        for interval in 0..iterate.grid.intervals() {
            for part in 0..parts {
                let state = iterate.inside(interval, part as f64 / parts as f64);
                let instant = interval * PARTS + part / settings.parts;
                let violations = self.violations(&form, &state).enumerate();
                for (place, violation) in violations.filter(|(_, e)| *e > settings.max_violation) {
                    let entry = over.entry(RowAt { row: self.row(place), instant }).or_default();
                    *entry = entry.max(violation);
                }
            }
        }
        // Limits on places have no width for a tightening.
        let limits = &self.hover.mission.limits;
        over.retain(|at, _| !matches!(at.row, Row::Limit(limit) if place(limits[limit].kind)));
        over.into_iter().collect()
    }

    pub(super) fn cost(&self, iterate: &Iterate) -> f64 {
        self.transcription(&iterate.grid, &[]).cost_of(&iterate.states)
    }

    /// Drops the rows with more slack at an iterate than [`settings::SubproblemSettings::slack_of_working_set`].
    fn prune(&self, iterate: &Iterate, working_set: &mut BTreeSet<RowAt>) {
        let form = self.transcription(&iterate.grid, &[]);
        working_set.retain(|r| {
            let state = iterate.at(r.instant);
            let violation = match r.row {
                Row::Facet(facet) => self.violation_of_row(facet, &self.wrench_at(&state)),
                Row::Limit(limit) => form.violation_of(&self.hover.mission.limits[limit], &state, 0.0),
                Row::Upright => form.violation_upright(&state),
                Row::Command { facet, slope } => self.command_violation_of(iterate, facet, (r.instant, slope)),
            };
            violation > -self.settings.subproblem.slack_of_working_set
        });
    }
}
