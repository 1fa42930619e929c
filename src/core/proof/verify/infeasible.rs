//! Decides a claim that there is no plan.
//!
//! A motion is determined by its start and its inputs at the nodes. Each row states that an expression in the
//! derivatives at a node is not negative (a cone: that its parts have a non-negative product with every vector of the
//! dual cone; rest: that the expression is zero). Hence `sum of z_j expression_j >= 0` for every plan and all
//! multipliers z in the dual cone. Substituting the dynamics backwards turns the sum into
//! `constant + a_0 . start + sum over nodes of c_k . u_k`. The start is known up to the first waypoint's tolerance, and
//! the inputs are bounded. If the largest value over all starts and inputs is negative, there is no plan.
//!
//! In the hover model (one yaw) rows are facets (also of commands if rotors lag), limits and waypoints. In the exact
//! model facets are not linear in the motion. They are replaced by a bound on the thrust m |(x'', y'', z'' + g)|, which
//! is at most the largest thrust in the set.

mod inputs;
mod rows;

use super::core::WithoutYaw;
use super::cost::{self, Budget, Estimate};
use super::facets::named;
use super::interval::Interval;
use super::motion::{Motion, X, Y, YAW, Z};
use super::plan::Setting;
use super::premise::{Premise, Premises};
use super::schedule::{self, Grid};
use super::sets::{Generators, Plane};
use super::{Accepted, Refusal, Rejection, Shown, lag, required_whole};
use crate::certificate::{DynamicModel, FacetRecord, InfeasibleClaim};
use crate::model::Problem;
use crate::number::{number, plural};
use std::collections::HashSet;

struct Rows<'a> {
    problem: Problem<'a>,
    claim: &'a InfeasibleClaim,
    grid: Grid,
    planes: Vec<Plane>,
    /// Bounds on T, tau_x, tau_y and tau_z in the set of a mode in which every plan stays, if there is one.
    extent: Option<[Interval; 4]>,
    kind: DynamicModel,
    /// sin and cos of the one yaw of the hover model.
    yaw: (Interval, Interval),
    /// Time constant tau of lagging rotors, s.
    lag: Option<Interval>,
    /// The largest thrust of any plan in the exact model, N.
    thrust: Option<Interval>,
    premises: Premises,
}

/// Decides a claim that the spec has no plan on its grid.
pub(super) fn decide(
    setting: &Setting,
    kind: DynamicModel,
    claim: &InfeasibleClaim,
    budget: Budget,
) -> Result<Accepted, Refusal> {
    let (model, mission, premises) = (setting.model(), setting.mission(), setting.premises);
    let unsupported = |why: &str| Err(Rejection::new("the claim that there is no plan", why).into());
    let first = &mission.waypoints[0];
    match kind {
        DynamicModel::Hover if mission.waypoints.iter().any(|w| (w.yaw - first.yaw).abs() >= 1e-12) => {
            return unsupported("in the hover model multipliers are checked only for one yaw throughout");
        }
        _ if setting.dynamics().environment.has_drag() => {
            return unsupported("multipliers are checked only without drag");
        }
        _ if !mission.start_at_rest => return unsupported("multipliers are checked only for a start at rest"),
        _ => {}
    }
    let grid = schedule::grid(setting.problem)?;
    let estimate = estimate(setting, claim, &grid)?;
    if !estimate.fits(budget) {
        return Err(Refusal::Budget { estimate, budget });
    }
    setting.reserve_has_hover()?;
    let selected_by = setting.selected_by(&claim.selected_by, &WithoutYaw::wherever_possible(&setting.sets))?;
    let required = required_whole(&setting.sets);
    let planes = planes(setting, claim, &required, &selected_by)?;
    let first_required = required.into_iter().next();
    let extent = first_required.map(|mode| setting.sets.generators(&mode)).transpose()?.map(|set| set.extent());
    let (total, pieces) = (grid.total, grid.times.len() - 1);
    let yaw = Interval::point(first.yaw).sin_cos();
    let lag = lag::constant(model);
    let mut rows =
        Rows { problem: setting.problem, claim, grid, planes, extent, kind, yaw, lag, thrust: None, premises };
    if kind == DynamicModel::Exact {
        rows.thrust = Some(rows.most_thrust()?);
    }
    let most = rows.largest()?;
    // Zero is not a contradiction, and neither is NaN.
    if most.high.partial_cmp(&0.0).is_none_or(std::cmp::Ordering::is_ge) {
        let why = format!("the weighted rows add up to at most {}, which is not a contradiction", number(most.high));
        let claim = "the claim that there is no plan";
        return Err(Rejection { span: Some(mission.span), ..Rejection::new(claim, why) }.into());
    }
    let selection = if claim.selected_by.is_empty() { "" } else { " and the facets that the included plans select" };
    let weighed = claim.multipliers.iter().filter(|m| m.z.iter().any(|z| *z != 0.0)).count();
    let rows_of_proof = format!("{} with multipliers{selection}", plural(weighed, "row"));
    let planner = model.plan.planner.name().to_uppercase();
    let selected = if claim.selected_by.is_empty() { "" } else { ", for the facets selected by the included plans" };
    // Whether the certificate's height is required is not decided.
    let kept = model.plan.require_capture.and_then(|required| required.height);
    let kept = kept.map_or(String::new(), |height| format!(", if {} m above the ground are required", number(height)));
    let headline = format!(
        "proved infeasible on one grid: mission {} has no {planner} plan of {} s whose inputs are linear between the \
         nodes of the spec's {pieces} pieces in flight{selected}{kept}",
        mission.name,
        number(total),
    );
    let proved = Shown { statement: format!("{rows_of_proof} contradict each other"), reach: None };
    let weaker = vec![format!(
        "one grid: motions whose nodes differ from those of {} samples are not excluded",
        model.plan.samples
    )];
    Ok(Accepted { headline, shown: vec![proved], weaker, undecided: Vec::new(), ways_out: Vec::new() })
}

/// The cost of deciding a claim.
fn estimate(setting: &Setting, claim: &InfeasibleClaim, grid: &Grid) -> Result<Estimate, Rejection> {
    let mut all = setting.estimate_of(&claim.selected_by)?;
    let (rows, nodes, facets) = (claim.multipliers.len() as u64, grid.times.len() as u64, claim.facets.len() as u64);
    all.add(cost::times(rows, cost::COST_PER_MULTIPLIER), cost::times(rows, cost::BYTES_OF_A_MULTIPLIER));
    all.add(cost::times(nodes, cost::COST_PER_CARRIED_NODE), cost::times(nodes, cost::BYTES_OF_A_NODE));
    let of_generators = cost::times(setting.model().vehicle.rotors.len() as u64, cost::COST_PER_ROTOR);
    let of_facet = of_generators.saturating_add(cost::COST_PER_PLANE);
    all.add(cost::times(facets, of_facet), cost::times(facets, cost::BYTES_OF_A_PLANE));
    // Facets may be listed more than once, and each is looked for along the motions.
    for record in &claim.selected_by {
        let motion = setting.motion(record)?;
        all.add(setting.cost_of_selecting(motion.checkpoints(), facets), 0);
    }
    all.add(cost::times(claim.thrust.len() as u64, cost::COST_PER_ROW), 0);
    Ok(all)
}

/// The planes of the listed facets. Each must belong to a set in which every plan stays, or be selected by the included
/// plans.
fn planes(
    setting: &Setting,
    claim: &InfeasibleClaim,
    required: &[String],
    selected_by: &[Motion],
) -> Result<Vec<Plane>, Rejection> {
    let required: HashSet<&str> = required.iter().map(String::as_str).collect();
    // Facets of one mode usually follow each other.
    let mut last: Option<(&str, Generators)> = None;
    let selectable_modes = setting.selectable_modes();
    let mut planes = Vec::new();
    let mut to_select = Vec::new();
    for (index, facet) in claim.facets.iter().enumerate() {
        let (kept, selectable) =
            (required.contains(facet.mode.as_str()), selectable_modes.contains(facet.mode.as_str()));
        if last.as_ref().is_none_or(|(mode, _)| *mode != facet.mode) {
            let generators = setting.sets.generators(&facet.mode).map_err(of_facet(index, facet))?;
            last = Some((&facet.mode, generators));
        }
        let Some((_, generators)) = &last else { continue };
        if setting.premises.has(Premise::Rows) && !kept && !selectable {
            return Err(of_facet(index, facet)(Rejection::new("", "the planner does not impose this mode's set")));
        }
        let strict = setting.premises.has(Premise::Facets);
        planes.push(named(generators, facet, strict).map_err(of_facet(index, facet))?.plane);
        if !kept && selectable {
            to_select.push(index);
        }
    }
    if setting.premises.has(Premise::Selection) {
        if let Some(&index) = to_select.iter().find(|&&index| !planes[index].is_facet) {
            let why = "it is not known to contain a facet, which alone RSP selects";
            return Err(of_facet(index, &claim.facets[index])(Rejection::new("", why)));
        }
        let violated = setting.violated(to_select.iter().map(|&index| &planes[index]), selected_by);
        if let Some((&index, _)) = to_select.iter().zip(&violated).find(|(_, over)| !**over) {
            let why = "no included plan violates it, so RSP does not select it";
            return Err(of_facet(index, &claim.facets[index])(Rejection::new("", why)));
        }
    }
    Ok(planes)
}

fn of_facet(index: usize, facet: &FacetRecord) -> impl Fn(Rejection) -> Rejection {
    let claim = format!("facet {} ({}, rotors {:?})", index + 1, facet.mode, facet.rotors);
    move |r| Rejection { claim: claim.clone(), ..r }
}

impl Rows<'_> {
    fn nodes(&self) -> usize {
        self.grid.times.len()
    }

    /// The derivative order of each axis's input: x, y (and z in the exact model) are quadruple integrators, the others
    /// double integrators.
    fn orders(&self) -> [usize; 4] {
        match self.kind {
            DynamicModel::Hover => [4, 4, 2, 2],
            DynamicModel::Exact => [4, 4, 4, 2],
        }
    }

    /// The largest value of the weighted sum over all starts and inputs.
    fn largest(&self) -> Result<Interval, Rejection> {
        let mut sums = vec![[[Interval::ZERO; 5]; 4]; self.nodes()];
        let mut constant = Interval::ZERO;
        for (index, multiplier) in self.claim.multipliers.iter().enumerate() {
            let parts =
                self.weighed(multiplier).map_err(|why| Rejection::new(format!("multiplier {}", index + 1), why))?;
            for (expression, &z) in parts.iter().zip(&multiplier.z) {
                let z = Interval::point(z);
                for &(node, axis, order, coefficient) in &expression.terms {
                    sums[node][axis][order] = sums[node][axis][order] + z * coefficient;
                }
                constant = constant + z * expression.constant.unwrap_or(Interval::ZERO);
            }
        }
        self.carry_back(&mut sums);
        let inputs = match self.premises.has(Premise::Inputs) {
            true => self.inputs(),
            false => [Interval::ZERO; 4],
        };
        let mut most = constant;
        for node in &sums {
            for (axis, order) in self.orders().into_iter().enumerate() {
                // Inputs without a multiplier need no bound.
                if node[axis][order] != Interval::ZERO {
                    most = most + node[axis][order] * inputs[axis];
                }
            }
        }
        // At a start at rest only position and yaw are free.
        let start = &self.problem.mission().waypoints[0];
        let [x, y, z] = start.position;
        let (near, turned) = self.tolerances(0);
        for (axis, due, reach) in [(X, x, near), (Y, y, near), (Z, z, near), (YAW, start.yaw, turned)] {
            let near = Interval::point(due) + Interval::around_zero(reach.high);
            if sums[0][axis][0] != Interval::ZERO {
                most = most + sums[0][axis][0] * near;
            }
        }
        Ok(most)
    }

    /// Expresses derivatives at a node by those at the node before, from the last to the first. The input is linear in
    /// between, so with m = r - i
    ///
    /// `d_i(k+1) = sum_{j=i}^{r-1} h^(j-i)/(j-i)! d_j(k) + h^m [(1/m! - 1/(m+1)!) u(k) + u(k+1)/(m+1)!]`.
    fn carry_back(&self, sums: &mut [[[Interval; 5]; 4]]) {
        const FACTORIAL: [f64; 6] = [1.0, 1.0, 2.0, 6.0, 24.0, 120.0];
        let over = |power: Interval, n: usize| power / Interval::point(FACTORIAL[n]);
        for k in (1..self.nodes()).rev() {
            let h = Interval::point(self.grid.times[k]) - Interval::point(self.grid.times[k - 1]);
            let mut powers = [Interval::ONE; 5];
            for n in 1..5 {
                powers[n] = powers[n - 1] * h;
            }
            for (axis, r) in self.orders().into_iter().enumerate() {
                for i in 0..r {
                    let weight = sums[k][axis][i];
                    if weight == Interval::ZERO {
                        continue;
                    }
                    for j in i..r {
                        sums[k - 1][axis][j] = sums[k - 1][axis][j] + weight * over(powers[j - i], j - i);
                    }
                    let m = r - i;
                    let late = over(powers[m], m + 1);
                    let early = over(powers[m], m) - late;
                    sums[k - 1][axis][r] = sums[k - 1][axis][r] + weight * early;
                    sums[k][axis][r] = sums[k][axis][r] + weight * late;
                    sums[k][axis][i] = Interval::ZERO;
                }
            }
        }
    }
}
