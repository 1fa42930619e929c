//! Row generation (cutting planes): programs start with few rows and get those that their solution violates.

use super::{ACCEPTED, HoverPlanner, Layout};
use crate::actuation::Wrench;
use crate::motion::NodeState;
use crate::planner::commands::Slope;
use crate::planner::selection::PlanningSet;
use crate::planner::timing::search::NEAR_LEAST;
use crate::planner::transcription::{Purpose, Row, RowAt, Transcription};
use crate::planner::working_set::WorkingSet;
use crate::solve::{Outcome, Solution, solve};

/// Where the violation is minimised: after this many rounds, a violation beyond [`NEAR_LEAST`] ends row generation,
/// because the estimate does not use such a value. Chosen by hand.
const FIRST_ROUNDS: usize = 2;
/// Where the violation is minimised, rows violated by less than this share of it are not added: the result is an
/// estimate. Chosen by hand.
const ACCEPTED_SHARE: f64 = 0.2;

/// The outcome of one program with row generation.
pub(super) struct Generated {
    pub outcome: Outcome,
    /// At the nodes without holds; empty if the program is infeasible.
    pub states: Vec<NodeState>,
    /// Rows in the last program.
    pub rows: usize,
}

impl HoverPlanner<'_> {
    /// Drops the rows that have more slack than [`super::HoverSettings::kept_slack`] at these states, for rows widened
    /// by `sigma`.
    pub(super) fn drop_slack_rows(
        &self,
        layout: &Layout,
        set: &PlanningSet,
        states: &[NodeState],
        sigma: f64,
        working_set: &mut WorkingSet,
    ) {
        let maps = layout.yaw.maps(self.model(), layout.flown.nodes());
        let commands = layout.commands(self.model());
        let stages = Transcription::new(self.problem, &layout.flown, set, &maps, layout.yaw.axes())
            .with_commands(commands.as_ref());
        let kept = self.settings.kept_slack;
        working_set.rows.retain(|r| match r.row {
            Row::Facet(facet) => {
                let row = &set.rows[facet];
                let violation = row.violation(&maps[r.instant].at(&states[r.instant]));
                row.core.map_or(violation, |_| stages.core_violation(row, states, r.instant)) > sigma - kept
            }
            Row::Limit(limit) => {
                stages.limit_violation(&self.mission().limits[limit], states, r.instant, sigma) > -kept
            }
            Row::Upright => false,
            Row::Command { facet, slope } => stages
                .command_wrench(states, (r.instant, slope))
                .is_some_and(|wrench| set.rows[facet].violation(&wrench) > sigma - kept),
        });
    }

    /// Solves with rows added where they are violated by more than [`ACCEPTED`], until none is.
    pub(super) fn generate(
        &mut self,
        layout: &Layout,
        set: &PlanningSet,
        purpose: Purpose,
        working_set: &mut WorkingSet,
    ) -> Generated {
        self.generate_within(layout, set, purpose, working_set, ACCEPTED)
    }

    /// Row generation with another accepted violation. [`Purpose::Violation`] is minimised no further than its `least`,
    /// and no closer than to a fifth of itself: far from zero it need not be known well.
    pub(super) fn generate_within(
        &mut self,
        layout: &Layout,
        set: &PlanningSet,
        purpose: Purpose,
        working_set: &mut WorkingSet,
        accepted: f64,
    ) -> Generated {
        let nodes = layout.flown.nodes();
        let maps = layout.yaw.maps(self.model(), nodes);
        let commands = layout.commands(self.model());
        let new = || {
            Transcription::new(self.problem, &layout.flown, set, &maps, layout.yaw.axes())
                .with_commands(commands.as_ref())
        };
        let (stages, splines) = (new(), new().in_splines());
        let smooth = splines.stiffness() <= self.settings.max_stiffness;
        working_set.fit(nodes);
        let most = match purpose {
            Purpose::Plan { .. } => self.largest_cost(layout).unwrap_or(f64::INFINITY),
            _ => f64::INFINITY,
        };
        let mut round = 0;
        loop {
            let chosen: Vec<RowAt> = working_set.rows.iter().copied().collect();
            let splined = smooth
                && chosen.len() <= self.settings.max_rows_in_splines
                && !matches!(purpose, Purpose::Overshoot { .. });
            let mut form = if splined { &splines } else { &stages };
            let mut program = form.program(purpose, &chosen);
            let (mut outcome, spent) = solve(&program);
            self.effort += spent;
            if splined && matches!(outcome, Outcome::Inconclusive { .. }) {
                form = &stages;
                program = stages.program(purpose, &chosen);
                let (again, spent) = solve(&program);
                self.effort += spent;
                outcome = again;
            }
            if let Outcome::Infeasible { certificate: z } | Outcome::Solved(Solution { z, .. }) = &outcome {
                self.weights = program.weights(z);
            }
            let x = match &outcome {
                // The cost of every feasible plan is lower.
                Outcome::Solved(solution) if solution.bound > most => {
                    let outcome = Outcome::Infeasible { certificate: solution.z.clone() };
                    return Generated { outcome, states: Vec::new(), rows: chosen.len() };
                }
                Outcome::Solved(solution) => &solution.x,
                // Even a point without a verdict shows which rows are missing.
                Outcome::Inconclusive { point: Some(x), .. } => x,
                _ => return Generated { outcome, states: Vec::new(), rows: chosen.len() },
            };
            let mut states = form.states(x);
            let (sigma, accepted) = match purpose {
                Purpose::Violation { least, .. } => {
                    let sigma = x[form.variables()];
                    let far = round >= FIRST_ROUNDS && sigma <= NEAR_LEAST * least;
                    (sigma, if far { f64::INFINITY } else { accepted.max(ACCEPTED_SHARE * sigma.abs()) })
                }
                _ => (0.0, accepted),
            };
            working_set.rows.extend(violated_rows(&stages, &states, sigma, accepted));
            if working_set.rows.len() == chosen.len() {
                layout.yaw.fill(&mut states);
                return Generated { outcome, states, rows: chosen.len() };
            }
            round += 1;
            // More rows go on to be added as they are violated.
            let most = self.settings.max_rows_at_once;
            if round == self.settings.max_rounds && stages.each_row().take(most + 1).count() <= most {
                working_set.rows = stages.every_row().into_iter().collect();
            }
        }
    }
}

/// At each node the facet with the largest violation and every limit with a violation, above `accepted`, there and at
/// the neighbouring nodes; where rotors lag, also the facet that the commanded wrench violates most, on each side of
/// the node. All rows are widened by `sigma`.
fn violated_rows(form: &Transcription, states: &[NodeState], sigma: f64, accepted: f64) -> Vec<RowAt> {
    let (rows, last) = (&form.set.rows, states.len() - 1);
    let mut found = Vec::new();
    // The facet with the largest violation stands for its neighbours; those follow in a later round if they are still
    // violated.
    let most_violated = |wrench: &Wrench| {
        let inequalities = (0..rows.len()).filter(|&f| !rows[f].equality && rows[f].core.is_none());
        let violations = inequalities.map(|f| (f, rows[f].violation(wrench) - sigma));
        violations.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|worst| worst.1 > accepted).map(|(f, _)| f)
    };
    for (node, (state, map)) in states.iter().zip(form.maps).enumerate() {
        let facet = most_violated(&map.at(state)).map(Row::Facet);
        let cores = (0..rows.len()).filter(|&f| rows[f].core.is_some());
        let cores = cores.map(|f| (f, form.core_violation(&rows[f], states, node) - sigma));
        let core =
            cores.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|worst| worst.1 > accepted).map(|(f, _)| Row::Facet(f));
        let command = |slope: Slope| {
            let facet = most_violated(&form.command_wrench(states, (node, slope))?)?;
            Some(Row::Command { facet, slope })
        };
        let commands = [Slope::Before, Slope::After].into_iter().filter_map(command);
        let limits = form.mission.limits.iter().enumerate();
        let limits = limits.filter(|(_, l)| form.limit_violation(l, states, node, sigma) > accepted);
        for row in facet.into_iter().chain(core).chain(commands).chain(limits.map(|(i, _)| Row::Limit(i))) {
            let around = node.saturating_sub(1)..=(node + 1).min(last);
            found.extend(around.map(|instant| RowAt { row, instant }));
        }
    }
    found
}
