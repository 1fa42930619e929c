//! Constraint tightening, so that rows also hold between the instants.

use super::iterate::Iterate;
use super::{PARTS, ScpPlanner, settings};
use crate::model::Limit;
use crate::planner::limits::has_inset;
use crate::planner::transcription::{Row, RowAt, Transcription};
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
        // A motion that leaves limits on places between instants, and nothing else: a plan if none is found without.
        let mut kept = None;
        let limits = &self.mission().limits;
        let of_place = |(at, _): &(RowAt, f64)| matches!(at.row, Row::Limit(limit) if has_inset(&limits[limit]));
        for _ in 0..settings.max_rounds {
            // The iterate whose pieces join is the one that is reported and checked.
            let joined = iterate.with_joined_pieces();
            let over = self.between_instants(&joined);
            let commands_over = self.commands_between_instants(&joined);
            let (of_places, others): (Vec<_>, Vec<_>) = over.into_iter().partition(of_place);
            let mut over = others;
            if over.is_empty() && commands_over.iter().all(|violation| *violation <= settings.max_violation) {
                if of_places.is_empty() {
                    return Some(joined);
                }
                kept = Some(joined.clone());
                over = of_places;
            }
            let form = self.transcription(&joined.grid, &[]);
            for (at, violation) in over {
                let Some(place) = self.place(at.row) else { continue };
                for instant in [at.instant, at.instant + 1] {
                    self.tighten_at(&form, &joined, instant, place, settings.factor * violation);
                    working_set.insert(RowAt { instant, ..at });
                }
            }
            let command_tightening = self.lag.iter_mut().flat_map(|lag| &mut lag.local_tightening);
            for (tightening, violation) in command_tightening.zip(&commands_over) {
                *tightening += settings.factor * violation.max(0.0);
            }
            match self.restore_feasibility(iterate, working_set) {
                Some(restored) => iterate = restored,
                None => break,
            }
        }
        kept
    }

    /// Tightens the row at a place so that the iterate violates it by at least `by` at an instant: the tightening takes
    /// the slack that the row has there, without which the iterate would stay as it is.
    fn tighten_at(&mut self, form: &Transcription, iterate: &Iterate, instant: usize, place: usize, by: f64) {
        let state = iterate.at(instant);
        let mut all = self.violations_at(form, &state, instant, || f64::NEG_INFINITY);
        let violation = all.find(|(at, _)| *at == place).map_or(0.0, |(_, violation)| violation);
        drop(all);
        let slack = if violation.is_finite() { (-violation).max(0.0) } else { 0.0 };
        *self.local_tightening.entry(instant).or_default().entry(place).or_default() += slack + by;
    }

    /// The rows violated by more than the tightening accepts on the finer grid or, by [`peak`], between its points,
    /// each at the instant before, with its largest violation until the next instant.
    fn between_instants(&self, iterate: &Iterate) -> Vec<(RowAt, f64)> {
        let form = self.transcription(&iterate.grid, &[]);
        let mut over: BTreeMap<RowAt, f64> = BTreeMap::new();
        let settings = self.settings.tightening;
        let parts = PARTS * settings.parts;
        for interval in 0..iterate.grid.intervals() {
            let holds = |limit: &Limit| form.covers_interval(limit, interval);
            let violations = |part: usize| -> Vec<f64> {
                let state = iterate.inside(interval, part as f64 / parts as f64);
                self.violations_of_state(&form, &state, holds, || settings.max_violation).collect()
            };
            peaks(parts, violations, |place, part, violation| {
                if violation > settings.max_violation {
                    let instant = interval * PARTS + part / settings.parts;
                    let entry = over.entry(RowAt { row: self.row(place), instant }).or_default();
                    *entry = entry.max(violation);
                }
            });
        }
        over.into_iter().collect()
    }
}

/// The largest values of quantities over an interval, at the ends of its `parts` and, by [`peak`], between them: calls
/// `found` with the quantity, the part and the value. `values` gives all quantities at a point, from 0 to `parts`.
pub(super) fn peaks(parts: usize, values: impl Fn(usize) -> Vec<f64>, mut found: impl FnMut(usize, usize, f64)) {
    let (mut before, mut now) = (values(0), values(1));
    for part in 1..parts {
        let after = values(part + 1);
        for (quantity, ((&a, &b), &c)) in before.iter().zip(&now).zip(&after).enumerate() {
            let (top, largest) = peak([a, b, c]);
            found(quantity, ((part as f64 + top) as usize).min(parts - 1), largest);
        }
        (before, now) = (now, after);
    }
    now.iter().enumerate().for_each(|(quantity, &last)| found(quantity, parts - 1, last));
}

/// Where a quantity is largest, in parts from the second of three values at equal distances, and that value: the top of
/// the parabola through them, or else the larger of the first two.
fn peak([before, at, after]: [f64; 3]) -> (f64, f64) {
    let (slope, bend) = (after - before, 2.0 * at - before - after);
    let top = slope / (2.0 * bend);
    match bend > 0.0 && top.abs() <= 1.0 {
        true => (top, at + slope * top / 4.0),
        false if before > at => (-1.0, before),
        false => (0.0, at),
    }
}

#[cfg(test)]
mod tests {
    use crate::model::Problem;
    use crate::motion::wrench_model::WrenchModel;
    use crate::planner::hover::HoverPlanner;
    use crate::planner::scp::ScpPlanner;
    use crate::planner::selection::sets::PlanningSets;

    #[test]
    fn a_peak_between_points_is_found() {
        let parabola = |t: f64| 3.0 - 2.0 * (t - 0.3).powi(2);
        let (top, most) = super::peak([-1.0, 0.0, 1.0].map(parabola));
        assert!((top - 0.3).abs() < 1e-12 && (most - 3.0).abs() < 1e-12);
        assert_eq!(super::peak([1.0, 0.5, 0.25]), (-1.0, 1.0));
        assert_eq!(super::peak([0.0, 1.0, 4.0]), (0.0, 1.0));
        assert_eq!(super::peak([f64::NEG_INFINITY, 1.0, 0.0]), (0.0, 1.0));
    }

    /// Where a row has slack at the instants beside a violation, a tightening by the violation alone changes nothing.
    #[test]
    fn a_tightened_row_is_violated_at_its_instant() {
        let spec = crate::compile(
            "vehicle v { layout = \"PNPNPN\"; arm = 0.4 m; mass = 3 kg; inertia = [0.05, 0.06, 0.1] kg*m^2
    rotor { max_thrust = 9 N; torque_per_thrust = 15 mm; max_speed = 900 rad/s } }
mission m { start at [0, 0, 2] m; waypoint at [9, 0, 4] m; limits { speed <= 4 m/s } }
plan { planner = rip; against = []; samples = 40 }",
        );
        let spec = spec.into_result().unwrap();
        let sets = PlanningSets::of(spec.model());
        let mut hover = HoverPlanner::new(Problem::of(spec.model()).unwrap(), &sets.healthy);
        let mut planner = ScpPlanner::new(&mut hover, WrenchModel::Exact, &sets.rip);
        let slow = planner.rest_to_rest(40).unwrap().slower(2.0);
        let form = planner.transcription(&slow.grid, &[]);
        let (instant, speed) = (slow.states.len() / 2 * super::PARTS, sets.rip.rows.len());
        let violation = |planner: &ScpPlanner| {
            let state = slow.at(instant);
            let mut all = planner.violations_at(&form, &state, instant, || f64::NEG_INFINITY);
            all.find(|(place, _)| *place == speed).unwrap().1
        };
        assert!(violation(&planner) < -0.1, "{}", violation(&planner));
        for by in [1e-4, 3e-4] {
            planner.tighten_at(&form, &slow, instant, speed, by);
            assert!(violation(&planner) >= 0.99 * by, "{} {by}", violation(&planner));
        }
    }
}
