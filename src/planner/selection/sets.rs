//! The sets that each planner imposes on the wrench of one spec.

use crate::admissible::row::SetRow;
use crate::admissible::{AdmissibleSet, faults_only_take};
use crate::model::Model;
use crate::motion::outside::outside;
use crate::motion::wrench_model::WrenchModel;
use crate::planner::hover::Planned;
use crate::planner::selection::PlanningSet;

/// The sets of a spec as planned against: for every value of its intervals, and shrunk by the reserve.
#[derive(Debug, Clone)]
pub struct PlanningSets {
    /// The whole healthy set, whose widths make rows dimensionless.
    pub healthy: AdmissibleSet,
    /// RIP's set: the healthy one as planned against.
    pub rip: PlanningSet,
    /// RCP's set for each mode of `against` alone: the mode's, and the healthy one too if the mode's need not lie inside it, because
    /// until a fault strikes the vehicle is healthy.
    pub singles: Vec<PlanningSet>,
    /// RCP's set for all modes of `against`, in the same way.
    pub joint: PlanningSet,
    /// Each mode's set alone, by which violations of plans are measured.
    pub modes: Vec<PlanningSet>,
    /// Names of the modes, in their order.
    pub names: Vec<String>,
}

impl PlanningSets {
    /// The sets of the modes in `against` of the spec's plan.
    pub fn of(model: &Model) -> Self {
        let healthy = AdmissibleSet::healthy(model);
        let planned = |set: AdmissibleSet| set.guaranteed(model).with_reserve(model.plan.reserve);
        let sets: Vec<AdmissibleSet> =
            model.plan.against.iter().map(|&mode| planned(AdmissibleSet::of_mode(model, mode))).collect();
        let shrunk = planned(healthy.clone());
        let imposed = |modes: &[AdmissibleSet]| {
            let before = (modes.is_empty() || !faults_only_take(model)).then_some(&shrunk);
            PlanningSet::of(&before.into_iter().chain(modes).collect::<Vec<_>>(), &healthy)
        };
        PlanningSets {
            rip: PlanningSet::of(&[&shrunk], &healthy),
            singles: sets.iter().map(|s| imposed(std::slice::from_ref(s))).collect(),
            joint: imposed(&sets),
            modes: sets.iter().map(|s| PlanningSet::of(&[s], &healthy)).collect(),
            names: sets.iter().map(|s| s.name.clone()).collect(),
            healthy,
        }
    }

    /// Step (e) of section 5.3 of the paper: the facets of the modes' sets that a plan violates at some node, in the exact model at
    /// some instant, because its rows are imposed at instants too.
    pub fn violated(&self, model: &Model, planned: &Planned) -> Vec<SetRow> {
        let trajectory = planned.trajectory();
        let of = |set: &PlanningSet| {
            let found = outside(&trajectory, &model.vehicle, &model.environment(), &set.rows);
            let rows = if planned.model == WrenchModel::Exact { found.violated } else { found.facets };
            rows.into_iter().map(|row| set.rows[row].clone()).collect::<Vec<_>>()
        };
        self.modes.iter().flat_map(of).collect()
    }
}
