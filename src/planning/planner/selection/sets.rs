//! The sets that each planner imposes on the wrench of one spec.

use crate::admissible::row::SetRow;
use crate::admissible::without_yaw::planned::Provision;
use crate::admissible::{AdmissibleSet, faults_only_take};
use crate::model::Model;
use crate::motion::outside::outside;
use crate::motion::wrench_model::WrenchModel;
use crate::planner::Planned;
use crate::planner::selection::PlanningSet;

/// The sets of a spec as planned against: for every value of its intervals, and shrunk by the reserve.
#[derive(Debug, Clone)]
pub struct PlanningSets {
    /// The whole healthy set, whose widths make rows dimensionless.
    pub healthy: AdmissibleSet,
    /// RIP's set: the healthy one as planned against.
    pub rip: PlanningSet,
    /// RCP's set for each mode of `against` alone: the mode's, and the healthy one too if the mode's need not lie
    /// inside it, because until a fault strikes the vehicle is healthy.
    pub singles: Vec<PlanningSet>,
    /// RCP's set for all modes of `against`, in the same way.
    pub joint: PlanningSet,
    /// Each mode's set alone, or its core, by which violations of plans are measured; without rows where the mode is
    /// caught and landed.
    pub modes: Vec<PlanningSet>,
    /// Names of the modes, in their order.
    pub names: Vec<String>,
    /// How plans provide for each mode.
    pub provisions: Vec<Provision>,
}

/// A set as planned against.
fn planned(set: AdmissibleSet, model: &Model) -> AdmissibleSet {
    set.guaranteed(model).with_reserve(model.plan.reserve)
}

/// The set of a mode as planned against, and how a plan provides for it.
fn planned_set(model: &Model, mode: usize, healthy: &AdmissibleSet) -> (AdmissibleSet, Provision) {
    let set = AdmissibleSet::of_mode(model, mode);
    let provision = Provision::of(model, &set, healthy);
    (planned(set, model), provision)
}

/// The rows of one mode's set, or of its core.
fn alone(set: &AdmissibleSet, provision: &Provision, healthy: &AdmissibleSet) -> PlanningSet {
    match provision {
        Provision::WithYaw => PlanningSet::of(&[set], healthy),
        Provision::WithoutYaw(_) | Provision::Capture => PlanningSet { rows: provision.core_rows().to_vec() },
    }
}

/// The set of one mode, whether in `against` or not, as planned against, or its core, and how plans provide for it;
/// without rows where the mode is caught and landed. `healthy` is the whole healthy set.
///
/// # Panics
/// If there is no such mode.
pub fn of_one_mode(model: &Model, mode: usize, healthy: &AdmissibleSet) -> (PlanningSet, Provision) {
    let (set, provision) = planned_set(model, mode, healthy);
    (alone(&set, &provision, healthy), provision)
}

impl PlanningSets {
    /// The sets of the modes in `against` of the spec's plan.
    pub fn of(model: &Model) -> Self {
        let healthy = AdmissibleSet::healthy(model);
        let of_mode = |&mode: &usize| planned_set(model, mode, &healthy);
        let modes: Vec<(AdmissibleSet, Provision)> = model.plan.against.iter().map(of_mode).collect();
        let shrunk = planned(healthy.clone(), model);
        let rip = PlanningSet::of(&[&shrunk], &healthy);
        let each: Vec<PlanningSet> = modes.iter().map(|(set, provision)| alone(set, provision, &healthy)).collect();
        // Until a fault strikes the vehicle is healthy, and cores leave the yaw torque free.
        let imposed = |modes: &[(AdmissibleSet, Provision)], each: &[PlanningSet]| {
            let whole: Vec<&AdmissibleSet> =
                modes.iter().filter(|(_, provision)| *provision == Provision::WithYaw).map(|(set, _)| set).collect();
            let before = (whole.is_empty() || whole.len() < modes.len() || !faults_only_take(model)).then_some(&shrunk);
            // A minimal description takes long, and those of single sets are known.
            let joint = match (before, &whole[..], each) {
                (Some(_), [], _) => rip.clone(),
                (None, [_], [alone]) => alone.clone(),
                _ => PlanningSet::of(&before.into_iter().chain(whole).collect::<Vec<_>>(), &healthy),
            };
            joint.with(modes.iter().flat_map(|(_, provision)| provision.core_rows().to_vec()).collect())
        };
        let single = |(mode, alone)| imposed(std::slice::from_ref(mode), std::slice::from_ref(alone));
        PlanningSets {
            singles: modes.iter().zip(&each).map(single).collect(),
            joint: imposed(&modes, &each),
            rip,
            modes: each,
            names: modes.iter().map(|(set, _)| set.name.clone()).collect(),
            provisions: modes.into_iter().map(|(_, provision)| provision).collect(),
            healthy,
        }
    }

    /// A set with the facets of the modes' sets as far as a plan keeps them: those of RCP's set that it keeps, and
    /// those that it violates with the largest violation of their mode's set added to the bound.
    pub fn kept(&self, model: &Model, planned: &Planned, set: &PlanningSet) -> PlanningSet {
        let trajectory = planned.trajectory();
        let mut violated = Vec::new();
        for mode in &self.modes {
            let found = outside(&trajectory, &model.vehicle, &model.environment(), &mode.rows);
            let rows = found.violated.iter().map(|&row| &mode.rows[row]).filter(|row| !row.equality);
            violated.extend(rows.map(|row| (row.clone(), found.max_violation)));
        }
        let same = |a: &SetRow, b: &SetRow| (a.normal - b.normal).amax() < 1e-9 && (a.offset - b.offset).abs() < 1e-9;
        let is_kept = |row: &&SetRow| !violated.iter().any(|(other, _)| same(row, other));
        let mut rows: Vec<SetRow> = self.joint.rows.iter().filter(is_kept).cloned().collect();
        rows.extend(violated.into_iter().map(|(row, by)| SetRow { offset: row.offset + by, ..row }));
        set.with(rows)
    }

    /// Step (e) of section 5.3 of the paper: the facets of the modes' sets that a plan violates at some node, in the
    /// exact model at some instant, because its rows are imposed at instants too.
    pub fn violated(&self, model: &Model, planned: &Planned) -> Vec<SetRow> {
        let trajectory = planned.trajectory();
        let of = |set: &PlanningSet| {
            let found = outside(&trajectory, &model.vehicle, &model.environment(), &set.rows);
            let rows = if planned.model == WrenchModel::Exact { found.violated } else { found.facets };
            // The bound on turning is a premise of a core's other rows.
            let turning = set.rows.iter().position(|row| row.core.is_some_and(|core| core.bounds_turning()));
            let missing = turning.filter(|turning| !rows.is_empty() && !rows.contains(turning));
            rows.into_iter().chain(missing).map(|row| set.rows[row].clone()).collect::<Vec<_>>()
        };
        self.modes.iter().flat_map(of).collect()
    }
}
