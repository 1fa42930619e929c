//! Constraint tightening, so that rows also hold between the instants.

use super::iterate::Iterate;
use super::{PARTS, ScpPlanner, settings};
use crate::model::Limit;
use crate::planner::transcription::{Row, RowAt};
use settings::StoppingRule;
use std::collections::{BTreeMap, BTreeSet};

impl ScpPlanner<'_, '_> {
    /// The cost phase, then constraint tightening until no row is violated between the instants by more than
    /// [`settings::TighteningSettings::max_violation`]. `None` if this does not converge. The local tightening belongs
    /// to this iterate: other durations and grids have other instants.
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

    /// Rows that are violated between the instants are tightened at the instants on both sides (those on the commanded
    /// wrench at all instants), and the feasibility phase is repeated. The iterate restored in the last round is not
    /// evaluated.
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

    /// The rows violated by more than the tightening accepts on the finer grid, each at the instant before, with its
    /// largest violation until the next instant.
    fn between_instants(&self, iterate: &Iterate) -> Vec<(RowAt, f64)> {
        let form = self.transcription(&iterate.grid, &[]);
        let mut over: BTreeMap<RowAt, f64> = BTreeMap::new();
        let settings = self.settings.tightening;
        let parts = PARTS * settings.parts;
        for interval in 0..iterate.grid.intervals() {
            for part in 0..parts {
                let state = iterate.inside(interval, part as f64 / parts as f64);
                let instant = interval * PARTS + part / settings.parts;
                let holds = |limit: &Limit| form.covers_interval(limit, interval);
                let violations = self.violations_of_state(&form, &state, holds, || settings.max_violation).enumerate();
                for (place, violation) in violations.filter(|(_, e)| *e > settings.max_violation) {
                    let entry = over.entry(RowAt { row: self.row(place), instant }).or_default();
                    *entry = entry.max(violation);
                }
            }
        }
        // Limits on places have no width for a tightening, except distances from bodies.
        let limits = &self.mission().limits;
        let is_place = |limit: &Limit| limit.kind.is_of_place() && !limit.kind.is_clearance();
        over.retain(|at, _| !matches!(at.row, Row::Limit(limit) if is_place(&limits[limit])));
        over.into_iter().collect()
    }
}
