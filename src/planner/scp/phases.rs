//! The two phases at one mission time: the feasibility phase, which restores an iterate to the set, and the cost phase, which
//! minimises the cost (48) there.

use super::*;

/// Proximal weight of the feasibility phase: small, so that its steps end near the nearest feasible iterate.
pub(super) const FEASIBILITY_PHASE_WEIGHT: f64 = 0.1;

/// Most steps of the feasibility phase; over each [`PATIENCE`] of them the violation has to fall to the share [`FALL`].
const MOST_FEASIBILITY_STEPS: usize = 12;
const PATIENCE: usize = 2;
/// See [`Step::input_weight`].
pub(super) const INPUT_WEIGHT: f64 = 1e-3;
const MOST_REJECTED: usize = 3;
const FALL: f64 = 0.4;

/// Below this violation the phase goes on although progress is slow: each step adds rows at other instants.
const NEARLY: f64 = 1e-2;

/// If the linear model itself predicts this much violation, the feasibility phase ends without success: further steps fail, or
/// reach an iterate at the edge of what can be flown (measured).
const HOPELESS: f64 = 1e-2;

/// The feasibility phase also ends where the linear model predicts more violation than the first of these, and more than the
/// second times what it predicted two steps before (measured: such sequences took all their steps and failed).
const UNAVOIDABLE: f64 = 2e-4;
const STEADY: f64 = 0.9;

/// Initial proximal weight of the cost phase.
pub(super) const COST_PHASE_WEIGHT: f64 = 0.03;

/// The largest initial weight, if the last cost phase had to raise it.
const MOST_COST_PHASE_WEIGHT: f64 = 1e3;

/// The largest weight after the feasibility phase has restored an iterate.
const MOST_WEIGHT_AFTER_RESTORATION: f64 = 1.0;

/// How far a step shortens the duration.
#[derive(Debug, Clone, Copy)]
pub(super) enum Shorter {
    /// By as much as the linear model allows, at most by the first share of the duration; less than the second share is a failure.
    UpTo(f64, f64),
    /// By this share, even if the linear model predicts a violation: the feasibility phase may still remove it.
    By(f64),
}

/// Penalty weight of these steps; and their proximal weight with the weight of the relative cost, if the program chooses the
/// duration and if it is given.
const SHORTENING_PENALTY: f64 = 20.0;
const FREE_DURATION: (f64, f64) = (3.0, 0.01);
const GIVEN_DURATION: (f64, f64) = (1.0, 0.05);

/// Initial penalty weight of the cost phase: the violation against the relative cost.
const PENALTY: f64 = 6.0;

/// Its growth if the cost outweighs the penalty, and its largest value.
const PENALTY_GROWTH: f64 = 5.0;
const MOST_PENALTY: f64 = 1e4;

/// The line search ends below this share of a step.
const LEAST_SHARE: f64 = 0.05;

/// What may be passed between the instants, in widths of the healthy set or shares of a limit; on a grid so much finer; by
/// what factor of it rows keep more free; and how often that is tried. Half of what counts as a violation, for the grid has
/// gaps as well.
const BETWEEN: f64 = 5e-5;
pub(super) const FINER: usize = 4;
const BENT: f64 = 1.5;
const MOST_TIGHTENINGS: usize = 8;

/// Stopping rule of the cost phase.
#[derive(Debug, Clone, Copy)]
pub(super) struct StoppingRule {
    steps: usize,
    /// Relative gain that ends the sequence.
    small: f64,
}

/// Where any motion inside will do.
pub(super) const WITHOUT_COST_PHASE: StoppingRule = StoppingRule { steps: 0, small: 0.0 };
/// On the way to another time.
pub(super) const ROUGHLY: StoppingRule = StoppingRule { steps: 2, small: 0.03 };
/// Where the way to another time is hard.
pub(super) const CLOSER: StoppingRule = StoppingRule { steps: 6, small: 0.01 };
/// For a plan that is kept.
pub(super) const CLOSELY: StoppingRule = StoppingRule { steps: 12, small: 2e-3 };

/// Where a sequence of steps towards the least cost stands.
struct Descent {
    /// Steps that it may still take.
    left: usize,
    proximal: ProximalWeight,
    weights: Weights,
}

impl ScpPlanner<'_, '_> {
    pub(super) fn durations_stand(&self) -> Durations {
        Durations { legs: vec![None; self.hover.mission.legs.len()], range: (0.0, 0.0), spans: Vec::new() }
    }

    /// Shortens all durations alike: one program about the iterate as it is, because the same iterate flown faster can be far
    /// outside the set, where the linear model predicts nothing; then the feasibility phase.
    pub(super) fn shorten_alike(
        &mut self,
        iterate: &Iterate,
        shorter: Shorter,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let (range, objective, (proximal_weight, smoothing), least) = match shorter {
            Shorter::UpTo(share, least) => ((-share, 0.0), Objective::Time, FREE_DURATION, least),
            Shorter::By(share) => ((-share, -share), Objective::Cost, GIVEN_DURATION, 0.0),
        };
        let durations = Durations { legs: vec![Some(0); self.hover.mission.legs.len()], range, spans: Vec::new() };
        let weights = Weights { objective, penalty: SHORTENING_PENALTY, smoothing, input_weight: 0.0 };
        let stepped =
            self.step(iterate, &durations, ProximalWeight { weight: proximal_weight }, weights, working_set)?;
        if stepped.changes[0] > -least {
            return None;
        }
        if stepped.sigma > HOPELESS {
            return None;
        }
        self.restore_feasibility(iterate.stepped(&stepped.states, &stepped.changes), working_set)
    }

    /// The feasibility phase: steps that minimise the violation, until the iterate is inside at every instant. `None` if it does
    /// not converge.
    pub(super) fn restore_feasibility(
        &mut self,
        iterate: Iterate,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        self.restore_feasibility_unless(iterate, HOPELESS, working_set)
    }

    /// The same, ended if the linear model predicts more violation than `hopeless`.
    pub(super) fn restore_feasibility_unless(
        &mut self,
        mut iterate: Iterate,
        hopeless: f64,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let durations = self.durations_stand();
        let mut proximal = ProximalWeight { weight: FEASIBILITY_PHASE_WEIGHT };
        let mut violation = self.violation_by(&iterate, working_set);
        // An iterate that nearly fits has no need of other inputs.
        let input_weight = if violation < NEARLY { self.input_weight } else { 0.0 };
        let mut weights = Weights { objective: Objective::Violation, penalty: 1.0, smoothing: 0.0, input_weight };
        let mut history = Vec::new();
        let mut lines: Vec<f64> = Vec::new();
        let mut rejected = 0;
        self.forget_multipliers();
        while violation > 0.0 {
            history.push(violation);
            let stuck = violation > NEARLY
                && history.len() > PATIENCE
                && violation > FALL * history[history.len() - 1 - PATIENCE];
            if history.len() > MOST_FEASIBILITY_STEPS || stuck || proximal.exhausted() {
                return None;
            }
            working_set.extend(self.rows_between(&iterate));
            let stepped = self.step(&iterate, &durations, proximal, weights, working_set)?;
            lines.push(stepped.sigma);
            let is_stuck = matches!(lines[..], [.., before, _, last] if last > f64::max(UNAVOIDABLE, STEADY * before));
            if stepped.sigma > hopeless || is_stuck {
                if weights.input_weight == 0.0 {
                    return None;
                }
                // Where most inputs are small every change is a large share of them: other inputs after all, from now on.
                (self.input_weight, weights.input_weight) = (0.0, 0.0);
                lines.clear();
                history.clear();
                continue;
            }
            // If only a share of this step is taken, the next program still needs the rows that the full step violates.
            let whole = iterate.with_states(stepped.states.clone());
            working_set.extend(self.rows_violated_most(&whole));
            violation = self.violation_by(&iterate, working_set);
            let mut share = 1.0;
            let (reached, now) = loop {
                let reached = iterate.with_states(iterate.towards(&stepped.states, share));
                let now = self.violation_by(&reached, working_set);
                if now <= violation - 0.2 * share * (violation - stepped.sigma) || share < 2.0 * LEAST_SHARE {
                    break (reached, now);
                }
                share *= 0.5;
            };
            if share < 0.5 {
                proximal = proximal.less();
            }
            if now < violation {
                (iterate, violation) = (reached, now);
            } else {
                // Too many rows were unknown to the program for any share of its step: it gets all of them.
                working_set.extend(self.rows_at_nodes(&whole, 0.0));
                working_set.extend(self.rows_between(&whole));
                history.pop();
                rejected += 1;
                if rejected > MOST_REJECTED {
                    return None;
                }
            }
        }
        // Steps of which only a share was taken, or none, leave gaps at waypoints where durations have changed.
        if !iterate.is_joined() {
            let joined = self.joined(&iterate, working_set)?;
            return self.restore_feasibility_unless(joined, hopeless, working_set);
        }
        self.prune(&iterate, working_set);
        Some(iterate)
    }

    /// The cost phase. The iterate given and the one returned are inside at every instant; iterates in between are judged by the
    /// merit function, the cost and a penalty on the violation.
    pub(super) fn minimise_cost(
        &mut self,
        iterate: Iterate,
        care: StoppingRule,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Iterate {
        let weights = Weights { objective: Objective::Cost, penalty: PENALTY, smoothing: 1.0, input_weight: 0.0 };
        let mut descent = Descent {
            left: care.steps,
            proximal: ProximalWeight { weight: self.proximal_weight_of_cost_phase },
            weights,
        };
        let mut best = (self.cost(&iterate), iterate);
        loop {
            let outside = self.lower(&mut best, &mut descent, care.small, working_set);
            self.proximal_weight_of_cost_phase = descent.proximal.weight.min(MOST_COST_PHASE_WEIGHT);
            // Where the last iterate is still outside, the nearest one inside may well be the best, or lead to it.
            let mut known = working_set.clone();
            let Some(inside) = outside.and_then(|outside| self.restore_feasibility(outside, &mut known)) else {
                return best.1;
            };
            let (cost, was) = (self.cost(&inside), best.0);
            if cost < was {
                *working_set = known;
                best = (cost, inside);
            }
            if descent.left == 0 || cost > (1.0 - care.small) * was {
                return best.1;
            }
            descent.proximal.weight = descent.proximal.weight.min(MOST_WEIGHT_AFTER_RESTORATION);
        }
    }

    /// The steps of [`Self::minimise_cost`] from `best`, which is inside and is replaced by the cheapest iterate inside that they
    /// meet. Returns the last iterate if it is outside and cheaper.
    fn lower(
        &mut self,
        best: &mut (f64, Iterate),
        Descent { left, proximal, weights }: &mut Descent,
        small: f64,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let durations = self.durations_stand();
        let (mut at, mut violation) = (best.1.clone(), 0.0);
        while *left > 0 {
            *left -= 1;
            let here = self.cost(&at);
            let Some(stepped) = self.step(&at, &durations, *proximal, *weights, working_set) else { break };
            // A sigma within the tightening is inside.
            let sigma = stepped.sigma - TIGHTENING;
            // The cost outweighs the penalty: the penalty is raised and the subproblem solved again.
            if sigma > 0.0 && weights.penalty < MOST_PENALTY {
                weights.penalty *= PENALTY_GROWTH;
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
            while was - merit(cost, now) < 0.3 * share * expected && share > LEAST_SHARE {
                share *= 0.5;
                (cost, now, reached) = towards(self, working_set, share);
            }
            let gained = was - merit(cost, now);
            if now <= 0.0 && cost < best.0 {
                *best = (cost, reached.clone());
            }
            working_set.extend(self.rows_between(&reached));
            *proximal = match share {
                1.0 if expected > 0.0 => proximal.after(gained, expected),
                _ => proximal.shared(share),
            };
            if gained > 0.0 {
                // Measured again, with the instants that the working set has now.
                at = reached;
                violation = self.violation_by(&at, working_set);
            }
            if expected < small && sigma <= 0.0 || proximal.exhausted() {
                break;
            }
        }
        (violation > 0.0 && self.cost(&at) < best.0).then_some(at)
    }

    /// The cost phase, then constraint tightening until no row is violated between the instants by more than [`BETWEEN`]. `None` if
    /// this does not converge. The tightening belongs to this iterate: other durations and grids have other instants.
    pub(super) fn minimise_cost_between_instants(
        &mut self,
        iterate: Iterate,
        care: StoppingRule,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let kept = self.tighten_until_inside(iterate, care, working_set);
        self.local_tightening.clear();
        self.lag.iter_mut().for_each(|lag| lag.local_tightening.fill(0.0));
        kept
    }

    /// Rows that are violated between the instants are tightened by as much at the instants beside, and the feasibility phase is
    /// repeated.
    fn tighten_until_inside(
        &mut self,
        iterate: Iterate,
        care: StoppingRule,
        working_set: &mut BTreeSet<RowAt>,
    ) -> Option<Iterate> {
        let mut iterate = self.minimise_cost(iterate, care, working_set);
        for _ in 0..MOST_TIGHTENINGS {
            // What is reported and checked is the iterate whose pieces join.
            let joined = iterate.with_joined_pieces();
            let over = self.between_instants(&joined);
            let commands_over = self.commands_between_instants(&joined);
            if over.is_empty() && commands_over.iter().all(|violation| *violation <= BETWEEN) {
                return Some(joined);
            }
            for (at, violation) in over {
                let Some(place) = self.place(at.row) else { continue };
                for instant in [at.instant, at.instant + 1] {
                    *self.local_tightening.entry(instant).or_default().entry(place).or_default() += BENT * violation;
                    working_set.insert(RowAt { instant, ..at });
                }
            }
            let command_tightening = self.lag.iter_mut().flat_map(|lag| &mut lag.local_tightening);
            for (bend, violation) in command_tightening.zip(&commands_over) {
                *bend += BENT * violation.max(0.0);
            }
            iterate = self.restore_feasibility(iterate, working_set)?;
        }
        None
    }

    /// The rows violated by more than [`BETWEEN`] on a grid [`FINER`] times finer than the instants, each at the instant before
    /// with its largest violation until the next.
    fn between_instants(&self, iterate: &Iterate) -> Vec<(RowAt, f64)> {
        let form = self.transcription(&iterate.grid, &[]);
        let mut over: BTreeMap<RowAt, f64> = BTreeMap::new();
        let parts = PARTS * FINER;
        for interval in 0..iterate.grid.intervals() {
            for part in 0..parts {
                let state = iterate.inside(interval, part as f64 / parts as f64);
                let instant = interval * PARTS + part / FINER;
                for (place, violation) in self.violations(&form, &state).enumerate().filter(|(_, e)| *e > BETWEEN) {
                    let entry = over.entry(RowAt { row: self.row(place), instant }).or_default();
                    *entry = entry.max(violation);
                }
            }
        }
        // Places have no width to keep a share of free.
        let limits = &self.hover.mission.limits;
        over.retain(|at, _| !matches!(at.row, Row::Limit(limit) if place(limits[limit].kind)));
        over.into_iter().collect()
    }

    pub(super) fn cost(&self, iterate: &Iterate) -> f64 {
        self.transcription(&iterate.grid, &[]).cost_of(&iterate.states)
    }

    /// Drops the rows that an iterate keeps well clear of.
    fn prune(&self, iterate: &Iterate, working_set: &mut BTreeSet<RowAt>) {
        let form = self.transcription(&iterate.grid, &[]);
        working_set.retain(|r| {
            let state = iterate.at(r.instant);
            let violation = match r.row {
                Row::Facet(facet) => self.violation_of_row(facet, &self.wrench_at(&state)),
                Row::Limit(limit) => form.violation_of(&self.hover.mission.limits[limit], &state, 0.0),
                Row::Upright => form.violation_upright(&state),
                Row::Command { facet, slope } => self.lead_excess_of(iterate, facet, (r.instant, slope)),
            };
            violation > -NEAR
        });
    }
}
