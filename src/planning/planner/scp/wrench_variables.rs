//! Variables for the wrench at instants with many facets.
//!
//! The row of a facet couples the twenty or more variables on which the motion at its instant depends. Where many
//! facets hold at an instant, four variables u stand for the change of the wrench there, and a row has these, sigma and
//! epsilon. With the linearised wrench w(s) of (70), w_0 and its change w_t per relative change of time at the iterate,
//!
//! ```text
//! diag(unit) u = w(s) - w_0 + (4 w_0 + w_t) epsilon
//! e (1 + 4 epsilon) - n.w_0 - n.diag(unit) u + sigma >= 0
//! ```
//!
//! which with u eliminated is the row of (73).

use super::subproblem::{ORDER_OF_TIME, Step};
use crate::actuation::Wrench;
use crate::admissible::row::SetRow;
use crate::planner::selection::PlanningSet;
use crate::planner::transcription::{Row, RowAt, Transcription};
use crate::qp::RowOrigin;
use crate::qp::build::{Affine, Builder};
use std::collections::BTreeMap;

/// The variables for the wrench of one program.
pub(super) struct WrenchVariables {
    /// By instant the first of its four variables.
    first: BTreeMap<usize, usize>,
    /// The change of each component that counts as one, N and N m: no facet's row then has a coefficient above one.
    unit: Wrench,
    /// The number of variables with those before.
    end: usize,
}

impl WrenchVariables {
    /// For the rows `chosen` of a program that has `before` other variables, at instants with at least `many` facets.
    pub fn of(chosen: &[RowAt], set: &PlanningSet, many: usize, before: usize) -> Self {
        let mut facets: BTreeMap<usize, usize> = BTreeMap::new();
        for RowAt { row, instant } in chosen {
            if matches!(row, Row::Facet(facet) if set.rows[*facet].core.is_none()) {
                *facets.entry(*instant).or_default() += 1;
            }
        }
        facets.retain(|_, facets| *facets >= many);
        let first: BTreeMap<usize, usize> = facets.into_keys().zip((before..).step_by(4)).collect();
        let largest = |k: usize| set.rows.iter().fold(0.0_f64, |most, row| most.max(row.normal[k].abs()));
        let unit = Wrench::from_fn(|k, _| if largest(k) > 0.0 { 1.0 / largest(k) } else { 1.0 });
        WrenchVariables { end: before + 4 * first.len(), first, unit }
    }

    /// The number of the program's variables.
    pub fn end(&self) -> usize {
        self.end
    }

    /// `n.diag(unit) u` at an instant; `None` where it has no variables.
    fn along(&self, instant: usize, n: &Wrench) -> Option<Affine> {
        let first = *self.first.get(&instant)?;
        let terms = (0..4).map(|k| (first + k, n[k] * self.unit[k])).filter(|term| term.1 != 0.0);
        Some(Affine { terms: terms.collect(), constant: 0.0 })
    }
}

impl Transcription<'_> {
    /// The slack of a facet at an instant with variables for its wrench; `None` elsewhere.
    pub(super) fn slack_in(
        &self,
        variables: &WrenchVariables,
        step: &Step,
        instant: usize,
        row: &SetRow,
    ) -> Option<Affine> {
        let mut slack = variables.along(instant, &-row.normal)?;
        slack.constant = row.offset - row.normal.dot(&step.wrenches[instant]);
        slack.add(&self.duration_change(self.leg_of(instant)), ORDER_OF_TIME * row.offset);
        Some(slack)
    }

    /// The equations of the variables for the wrench.
    pub(super) fn wrench_equations(&self, builder: &mut Builder, variables: &WrenchVariables, step: &Step) {
        for (&instant, &first) in &variables.first {
            let wrench = self.wrench_expression(instant);
            let now = step.wrenches[instant];
            let longer = ORDER_OF_TIME * now + step.time_sensitivities[instant];
            let epsilon = self.duration_change(self.leg_of(instant));
            for k in 0..4 {
                let n = Wrench::from_fn(|i, _| if i == k { 1.0 / variables.unit[k] } else { 0.0 });
                let mut row = wrench.along(&n).plus_constant(-n.dot(&now)).plus(first + k, -1.0);
                row.add(&epsilon, n.dot(&longer));
                builder.zero(row, RowOrigin::Wrench { node: instant / self.parts });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::model::Problem;
    use crate::motion::wrench_model::WrenchModel;
    use crate::planner::hover::HoverPlanner;
    use crate::planner::scp::subproblem::Objective;
    use crate::planner::scp::{ProximalWeight, ScpPlanner, ScpSettings, Weights};
    use crate::planner::selection::sets::PlanningSets;
    use std::collections::BTreeSet;

    /// A step takes the same durations with variables for the wrench as without.
    #[test]
    fn variables_for_the_wrench_leave_the_step_as_it_is() {
        let spec = crate::compile(
            "vehicle v { layout = \"PNPNPN\"; arm = 0.4 m; mass = 3 kg; inertia = [0.05, 0.06, 0.1] kg*m^2
    rotor { max_thrust = 9 N; torque_per_thrust = 15 mm; max_speed = 900 rad/s } }
mission m { start at [0, 0, 2] m; waypoint at [9, 0, 4] m  yaw 60 deg; waypoint at [9, 5, 4] m }
plan { planner = rip; against = []; samples = 60 }",
        );
        let spec = spec.into_result().unwrap();
        let sets = PlanningSets::of(spec.model());
        let step = |many_facets: usize| {
            let mut settings = ScpSettings::DEFAULT;
            settings.subproblem.many_facets = many_facets;
            settings.subproblem.slack_of_working_set = 1.0;
            let mut hover = HoverPlanner::new(Problem::of(spec.model()).unwrap(), &sets.healthy);
            let mut planner = ScpPlanner::with_settings(&mut hover, WrenchModel::Exact, &sets.rip, settings);
            let from = planner.rest_to_rest(60).unwrap();
            let durations = planner.durations_to_shorten(0.2);
            let weights = Weights { objective: Objective::Time, penalty: 100.0, cost_weight: 0.05, input_weight: 1e-3 };
            let stepped =
                planner.step(&from, &durations, ProximalWeight { weight: 0.1 }, weights, &mut BTreeSet::new());
            (stepped.unwrap().changes, planner.hover.effort.work)
        };
        let ((with, little), (without, much)) = (step(1), step(usize::MAX));
        assert!(little < much, "{little} {much}");
        assert!(with.iter().any(|change| change.abs() > 0.01), "{with:?}");
        assert!(with.iter().zip(&without).all(|(a, b)| (a - b).abs() < 1e-3), "{with:?} {without:?}");
    }
}
