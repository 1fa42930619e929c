//! Decides a claim that there is no plan.
//!
//! Every motion is what its start and its inputs at the nodes make of it. Each row says that some expression in the
//! derivatives at a node is not negative (a cone: that its parts have a non-negative product with every vector of the
//! dual cone); rest says that one is zero. So for multipliers z in the dual cone `sum of z_j expression_j >= 0` for
//! every plan. Carried back through the dynamics the sum is `constant + a_0 . start + sum over nodes of c_k . u_k`. The
//! start is known to the first waypoint's tolerance, and the inputs are bounded; where the largest value over all of
//! these is negative, there is no plan.
//!
//! In the hover model (one yaw) rows are facets, those of commands among them where rotors lag, limits and waypoints. In the exact model facets are not linear in the
//! motion; what stands for them is that m |(x'', y'', z'' + g)| is the thrust, and at most the largest of the set.

mod inputs;
mod rows;

use super::facets::{few, named};
use super::interval::Interval;
use super::motion::{X, Y, YAW, Z};
use super::sets::Plane;
use super::{Rejection, Shown, required};
use super::{lag, schedule};
use crate::certificate::{DynamicModel, InfeasibleClaim};
use crate::model::{Mission, Model, PlannerKind};
use crate::report::number::number;
use rows::UNBOUNDED;

struct Rows<'a> {
    model: &'a Model,
    mission: &'a Mission,
    claim: &'a InfeasibleClaim,
    planes: Vec<Plane>,
    kind: DynamicModel,
    /// sin and cos of the one yaw of the hover model.
    yaw: (Interval, Interval),
    /// tau of rotors that lag, s.
    lag: Option<Interval>,
    /// The largest thrust of any plan in the exact model, N.
    thrust: Option<Interval>,
}

pub(super) fn decide(
    model: &Model,
    mission: &Mission,
    kind: DynamicModel,
    claim: &InfeasibleClaim,
) -> Result<Vec<Shown>, Rejection> {
    let outside = |why: &str| Err(Rejection::new("that there is no plan", why));
    let first = &mission.waypoints[0];
    match kind {
        DynamicModel::Hover if mission.waypoints.iter().any(|w| (w.yaw - first.yaw).abs() >= 1e-12) => {
            return outside("in the hover model multipliers are checked for one yaw throughout");
        }
        _ if !mission.start_at_rest => return outside("multipliers are checked for a start at rest"),
        _ if model.plan.chooses_times => {
            return outside("multipliers are about waypoint times that the spec lays down, and here they are free");
        }
        _ => {}
    }
    let total = schedule::check(model, mission, &claim.times_s, &claim.waypoint_nodes)?;
    few(&claim.facets)?;
    let mut planes = Vec::new();
    for (index, facet) in claim.facets.iter().enumerate() {
        let of_facet = |r: Rejection| Rejection {
            claim: format!("facet {} ({}, rotors {:?})", index + 1, facet.mode, facet.rotors),
            ..r
        };
        if !may_bind(model, &facet.mode) {
            return Err(of_facet(Rejection::new("", "the planner does not keep to this mode's set")));
        }
        planes.push(named(model, facet).map_err(of_facet)?.plane);
    }
    let yaw = Interval::point(first.yaw).sin_cos();
    let mut rows = Rows { model, mission, claim, planes, kind, yaw, lag: lag::constant(model), thrust: None };
    if kind == DynamicModel::Exact {
        rows.thrust = Some(rows.most_thrust()?);
    }
    let most = rows.largest()?;
    if most.high < 0.0 {
        let selected = claim.facets.iter().any(|f| !required(model).contains(&f.mode));
        let keeping = if selected { " keeps the facets selected" } else { "" };
        let pieces = claim.times_s.len() - 1;
        let statement = format!("no plan of {} s with {pieces} pieces in flight{keeping}", number(total));
        Ok(vec![Shown::proved(statement)])
    } else {
        let why = format!("the rows, weighted, add up to {} at most, which contradicts nothing", number(most.high));
        Err(Rejection { span: Some(mission.span), ..Rejection::new("that there is no plan", why) })
    }
}

/// Whether the spec's planner may keep to a facet of this mode's set.
fn may_bind(model: &Model, mode: &str) -> bool {
    let against = model.plan.against.iter().filter_map(|&i| model.modes.get(i));
    let selected = model.plan.planner == PlannerKind::Rsp && against.into_iter().any(|m| m.name == mode);
    selected || required(model).iter().any(|m| m == mode)
}

impl Rows<'_> {
    fn nodes(&self) -> usize {
        self.claim.times_s.len()
    }

    /// The input's derivative order: x, y (and z in the exact model) are quadruple integrators, the others double ones.
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
        let inputs = self.inputs()?;
        let mut most = constant;
        for node in &sums {
            for (axis, order) in self.orders().into_iter().enumerate() {
                // What no multiplier weighs needs no bound.
                if node[axis][order] != Interval::ZERO {
                    most = most + node[axis][order] * inputs[axis];
                }
            }
        }
        // From rest only position and yaw of the start are free.
        let start = &self.mission.waypoints[0];
        let [x, y, z] = start.position;
        let (near, turned) = self.tolerances(0);
        for (axis, due, reach) in [(X, x, near), (Y, y, near), (Z, z, near), (YAW, start.yaw, turned)] {
            let near = Interval::point(due) + Interval::around_zero(reach.high);
            let at = if axis != YAW && start.within >= UNBOUNDED { Interval::WHOLE } else { near };
            if sums[0][axis][0] != Interval::ZERO {
                most = most + sums[0][axis][0] * at;
            }
        }
        Ok(most)
    }

    /// Replaces derivatives at a node by what they are made of one node earlier, from the last to the first. The input is
    /// linear in between, so with m = r - i
    ///
    /// `d_i(k+1) = sum_{j=i}^{r-1} h^(j-i)/(j-i)! d_j(k) + h^m [(1/m! - 1/(m+1)!) u(k) + u(k+1)/(m+1)!]`.
    fn carry_back(&self, sums: &mut [[[Interval; 5]; 4]]) {
        const FACTORIAL: [f64; 6] = [1.0, 1.0, 2.0, 6.0, 24.0, 120.0];
        let over = |power: Interval, n: usize| power / Interval::point(FACTORIAL[n]);
        for k in (1..self.nodes()).rev() {
            let h = Interval::point(self.claim.times_s[k]) - Interval::point(self.claim.times_s[k - 1]);
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
