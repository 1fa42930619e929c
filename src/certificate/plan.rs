//! A certificate for a plan, from what the planner found. Bounds are the planner's own figures, rounded up; how far
//! they reach between the nodes is asked of the checker.

use super::{
    Bound, Certificate, Claim, DynamicModel, FacetClaim, FacetRecord, LimitClaim, MotionRecord, PlanClaim, SCHEMA,
    Scope, SetClaim,
};
use crate::actuation::Wrench;
use crate::admissible::{AdmissibleSet, FacetOf, faults_only_take};
use crate::model::{Allocation, Limit, LimitKind, Mission, Model, PlannerKind};
use crate::planner::compare::{PlannerRun, Solved};
use crate::planner::hover_model::{X, Y, YAW, Z};
use crate::planner::select::{PlanningSet, SetRow};
use crate::planner::transcribe::{NodeState, UNBOUNDED};
use crate::planner::wrench_model::WrenchModel;
use crate::report::caveats::limit_words;
use crate::trajectory::Trajectory;
use crate::trajectory::checks::past;
use crate::verify::plan::Checker;
use nalgebra::Matrix4;

/// Points of each piece at which the planner's figures are taken between nodes.
const LOOKS: usize = 10;

/// Added to every figure, and that share of it: what rounding may hide.
const ROUNDING: f64 = 1e-9;

/// Tried in turn as bounds for every instant: what the looks at the motion may have missed, as a share of the size.
const MISSED: [f64; 2] = [1e-6, 1e-3];

/// The certificate of a run's plan.
///
/// # Errors
/// Where the numbers do not make a motion.
pub fn certificate(
    model: &Model,
    mission: &Mission,
    run: &PlannerRun,
    solved: &Solved,
    sha256: String,
) -> Result<Certificate, String> {
    let trajectory = &solved.trajectory;
    let kind = model_of(trajectory);
    let mut claim = PlanClaim {
        motion: motion(trajectory, kind),
        joins_within: 0.0,
        position_excess_m: f64::NEG_INFINITY,
        yaw_excess_rad: f64::NEG_INFINITY,
        limits: Vec::new(),
        sets: Vec::new(),
        facets: Vec::new(),
    };
    claim.joins_within = up(joins(trajectory, kind));
    for (w, &node) in mission.waypoints.iter().zip(&trajectory.waypoint_nodes) {
        let state = &trajectory.nodes[node];
        let distance = (0..3).map(|i| (state[i][0] - w.position[i]).powi(2)).sum::<f64>().sqrt();
        if w.within < UNBOUNDED {
            claim.position_excess_m = claim.position_excess_m.max(distance - w.within);
        }
        claim.yaw_excess_rad = claim.yaw_excess_rad.max((state[YAW][0] - w.yaw).abs() - w.yaw_within);
    }
    // Without a bounded tolerance there is nothing to exceed.
    claim.position_excess_m = up(if claim.position_excess_m.is_finite() { claim.position_excess_m } else { 0.0 });
    claim.yaw_excess_rad = up(claim.yaw_excess_rad);
    let mut checker = Checker::new(model, mission, kind, &claim.motion).map_err(|r| r.detail)?;
    let healthy = AdmissibleSet::healthy(model);
    let wrench = |state: &NodeState| trajectory.wrench(&model.vehicle, model.gravity, state);
    for (index, limit) in mission.limits.iter().enumerate() {
        let (nodes, between) = largest(trajectory, kind, |state| limit_excess(limit, state, model.gravity));
        let told = LimitClaim {
            limit: limit_words(limit.kind).0.into(),
            lower: limit.lower,
            upper: limit.upper,
            bounds: Vec::new(),
        };
        let size = limit.upper.or(limit.lower).unwrap_or(0.0).abs().max(1.0);
        let bounds = strongest(up(nodes), between, size, |bounds| {
            checker.limit(index, &LimitClaim { bounds, ..told.clone() }).is_ok()
        });
        claim.limits.push(LimitClaim { bounds, ..told });
    }
    for mode in stood(model) {
        let set = set_of(model, mode).guaranteed(model);
        let rows = PlanningSet::of(&[&set.with_reserve(model.plan.reserve)], &healthy).rows;
        // A wrench that passes the facets by a share leaves the set, seen from hover, by that share over hover's
        // margin.
        let margin = rows.iter().filter(|r| !r.equality).map(|r| -r.excess(&set.hover)).fold(1.0, f64::min);
        let (nodes, between) = largest(trajectory, kind, |state| {
            let wrench = wrench(state);
            let excess = rows.iter().map(|row| row.excess(&wrench)).fold(f64::NEG_INFINITY, f64::max);
            excess.max(0.0) / margin
        });
        let name = set.name.clone();
        let bounds =
            strongest(up(nodes), between, 1.0, |bounds| checker.set(&SetClaim { mode: name.clone(), bounds }).is_ok());
        claim.sets.push(SetClaim { mode: set.name, bounds });
    }
    for row in run.set.rows.iter().filter(|r| !r.equality) {
        let Some(facet) = facet_of(model, row) else { continue };
        let (nodes, between) = largest(trajectory, kind, |state| row.excess(&wrench(state)));
        let index = claim.facets.len();
        let bounds = strongest(up(nodes), between, 1.0, |bounds| {
            checker.facet(index, &FacetClaim { facet: facet.clone(), bounds }).is_ok()
        });
        claim.facets.push(FacetClaim { facet, bounds });
    }
    Ok(Certificate { schema: SCHEMA, spec_sha256: sha256, model: kind, claim: Claim::Plan(claim) })
}

fn up(x: f64) -> f64 {
    x + ROUNDING * (1.0 + x.abs())
}

/// The equations that the plan follows.
pub(super) fn model_of(trajectory: &Trajectory) -> DynamicModel {
    match trajectory.model {
        WrenchModel::HoverAt(_) | WrenchModel::HoverFollowing => DynamicModel::Hover,
        WrenchModel::Exact => DynamicModel::Exact,
    }
}

/// The input's derivative order of z.
fn vertical(kind: DynamicModel) -> usize {
    match kind {
        DynamicModel::Hover => 2,
        DynamicModel::Exact => 4,
    }
}

pub(super) fn motion(trajectory: &Trajectory, kind: DynamicModel) -> MotionRecord {
    let nodes = &trajectory.nodes;
    MotionRecord {
        times_s: trajectory.times.clone(),
        x: nodes.iter().map(|s| s[X]).collect(),
        y: nodes.iter().map(|s| s[Y]).collect(),
        z: nodes.iter().map(|s| s[Z][..=vertical(kind)].to_vec()).collect(),
        yaw: nodes.iter().map(|s| [s[YAW][0], s[YAW][1], s[YAW][2]]).collect(),
        waypoint_nodes: trajectory.waypoint_nodes.clone(),
    }
}

/// The widest gap between pieces, |gap of derivative i| h^i.
fn joins(trajectory: &Trajectory, kind: DynamicModel) -> f64 {
    let mut widest = 0.0_f64;
    for k in 0..trajectory.intervals() {
        let h = trajectory.times[k + 1] - trajectory.times[k];
        let (end, next) = (trajectory.within(k, h), &trajectory.nodes[k + 1]);
        for (axis, derivatives) in next.iter().enumerate() {
            let orders = derivatives.iter().enumerate().take([4, 4, vertical(kind), 2][axis]);
            let gaps = orders.map(|(i, d)| (end[axis][i] - d).abs() * h.powi(i as i32));
            widest = gaps.fold(widest, f64::max);
        }
    }
    widest
}

/// The largest value at the nodes, as either piece beside them has it, and between.
fn largest(trajectory: &Trajectory, kind: DynamicModel, quantity: impl Fn(&NodeState) -> f64) -> (f64, f64) {
    let (mut nodes, mut between) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
    for k in 0..trajectory.intervals() {
        let h = trajectory.times[k + 1] - trajectory.times[k];
        let mut last = trajectory.nodes[k + 1];
        if kind == DynamicModel::Hover {
            // z''' is constant over a piece, and jumps at nodes.
            last[Z][3] = trajectory.within(k, h)[Z][3];
        }
        nodes = nodes.max(quantity(&trajectory.within(k, 0.0))).max(quantity(&last));
        for i in 1..=LOOKS {
            between = between.max(quantity(&trajectory.within(k, h * i as f64 / (LOOKS + 1) as f64)));
        }
    }
    (nodes, nodes.max(between))
}

/// A bound at the nodes, and the best found beyond them.
fn strongest(nodes: f64, between: f64, size: f64, mut stands: impl FnMut(Vec<Bound>) -> bool) -> Vec<Bound> {
    let at_nodes = Bound { scope: Scope::Nodes, excess: nodes };
    let wider = std::iter::once(Bound { scope: Scope::EveryInstant, excess: nodes })
        .chain(MISSED.iter().map(|m| Bound { scope: Scope::EveryInstant, excess: up(between + m * size) }))
        .chain([Bound { scope: Scope::Grid(LOOKS), excess: up(between + MISSED[0] * size) }]);
    let found = wider.into_iter().find(|&bound| stands(vec![at_nodes, bound]));
    std::iter::once(at_nodes).chain(found).collect()
}

/// How far a state passes a limit, as certificates measure it.
pub(super) fn limit_excess(limit: &Limit, state: &NodeState, gravity: f64) -> f64 {
    match (limit.kind, limit.upper) {
        (LimitKind::Tilt, Some(upper)) => {
            let out = state[X][2].hypot(state[Y][2]) * upper.cos() - (state[Z][2] + gravity) * upper.sin();
            out / gravity
        }
        _ => past(limit, state, gravity),
    }
}

/// The modes that the planner keeps to: 0 is healthy, i + 1 is `Model::modes[i]`.
fn stood(model: &Model) -> Vec<usize> {
    let against = model.plan.against.iter().map(|i| i + 1);
    match model.plan.planner {
        PlannerKind::Rcp if model.plan.against.is_empty() => vec![0],
        PlannerKind::Rcp if !faults_only_take(model) => std::iter::once(0).chain(against).collect(),
        PlannerKind::Rcp => against.collect(),
        _ => vec![0],
    }
}

fn set_of(model: &Model, mode: usize) -> AdmissibleSet {
    match mode.checked_sub(1) {
        None => AdmissibleSet::healthy(model),
        Some(index) => AdmissibleSet::of_mode(model, index),
    }
}

/// The facet that a row stands for; `None` where rotors do not name it: in a flat set, and where T >= 0 is what it says.
pub(super) fn facet_of(model: &Model, row: &SetRow) -> Option<FacetRecord> {
    let FacetOf { mode, facet, spanning } = *row.origin.first()?;
    let set = set_of(model, mode).guaranteed(model);
    let plane = set.polytope.facets.get(facet)?;
    let spanning: Vec<usize> = spanning.generators().collect();
    let rotors = match set.allocation {
        Allocation::Bounded => steepest(&set.zonotope.generators, &spanning, &plane.normal)?.map(|k| k + 1).to_vec(),
        // All others span it.
        Allocation::PseudoInverse => {
            (1..=model.vehicle.rotors.len()).find(|k| !spanning.contains(&(k - 1))).into_iter().collect()
        }
    };
    Some(FacetRecord { mode: set.name, rotors, normal: plane.normal.into(), offset: plane.offset })
}

/// The three rotors of a facet whose wrenches are furthest from dependence, in coordinates of like size.
fn steepest(generators: &[Wrench], rotors: &[usize], normal: &Wrench) -> Option<[usize; 3]> {
    let extent = generators.iter().fold(Wrench::zeros(), |sum, g| sum + g.abs());
    let scaled = |v: &Wrench| v.component_div(&extent.map(|e| if e > 0.0 { e } else { 1.0 })).normalize();
    let up = normal.component_mul(&extent).normalize();
    let mut best: Option<(f64, [usize; 3])> = None;
    for (i, &a) in rotors.iter().enumerate() {
        for (j, &b) in rotors.iter().enumerate().skip(i + 1) {
            for &c in &rotors[j + 1..] {
                let [p, q, r] = [a, b, c].map(|k| scaled(&generators[k]));
                let volume = Matrix4::from_columns(&[p, q, r, up]).determinant().abs();
                if volume.is_finite() && best.is_none_or(|(most, _)| volume > most) {
                    best = Some((volume, [a, b, c]));
                }
            }
        }
    }
    best.filter(|(volume, _)| *volume > 1e-6).map(|(_, rotors)| rotors)
}
