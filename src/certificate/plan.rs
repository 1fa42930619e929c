//! A certificate for a plan, from what the planner found. Bounds are the planner's own figures, rounded up; how far
//! they reach between the nodes is asked of the checker.

use super::between::GRID;
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
use crate::verify::plan::{Checker, EVALUATIONS, MOST_OUTSIDE, MOST_PAST_LIMIT};
use crate::verify::wrench::Held;
use nalgebra::Matrix4;

/// Points of each piece at which the planner's figures are taken between nodes: with an end of the piece, the grid of reports.
const LOOKS: usize = GRID - 1;

/// Added to every figure, and that share of it: what rounding may hide.
const ROUNDING: f64 = 1e-9;

/// Tried as bounds for every instant: what the looks at the motion may have missed, as a share of the size.
const MISSED: [f64; 2] = [1e-6, 1e-3];

/// Evaluations that one attempt to show a bound may take: of a single limit or facet, and of a whole set.
const OF_ONE: usize = 3_000_000;
const OF_A_SET: usize = 40_000_000;

/// Of the evaluations that all bounds of a certificate may take together, what is left to those at nodes alone.
const OF_NODES: usize = EVALUATIONS / 10;

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
    let mut left = EVALUATIONS - OF_NODES;
    let healthy = AdmissibleSet::healthy(model);
    let states = Looks::at(trajectory, kind, |_, state| *state);
    for (index, limit) in mission.limits.iter().enumerate() {
        let told = LimitClaim {
            limit: limit_words(limit.kind).0.into(),
            lower: limit.lower,
            upper: limit.upper,
            bounds: Vec::new(),
        };
        let seen = states.largest(|state| limit_excess(limit, state, model.gravity));
        let size = limit.size();
        let most = MOST_PAST_LIMIT * size;
        let bounds = strongest(seen, size, most, |bounds| {
            let claimed = LimitClaim { bounds, ..told.clone() };
            spent(&mut checker, OF_ONE.min(left), |checker| checker.limit(index, &claimed).is_ok())
        });
        claim.limits.push(LimitClaim { bounds: paid(bounds, &mut left), ..told });
    }
    let wrenches = (Held::Wrench, states.map(|state| trajectory.wrench(&model.vehicle, model.gravity, state)));
    let commands = checker.commands().zip(model.thrust_lag()).map(|(held, tau)| {
        let lead = |k: usize, state: &NodeState| trajectory.lead(&model.vehicle, model.gravity, tau, k, state);
        (held, Looks::at(trajectory, kind, lead))
    });
    for mode in stood(model) {
        let set = set_of(model, mode).guaranteed(model);
        let rows = PlanningSet::of(&[&set.with_reserve(model.plan.reserve)], &healthy).rows;
        // A wrench that passes the facets by a share leaves the set, seen from hover, by that share over hover's
        // margin.
        let margin = rows.iter().filter(|r| !r.equality).map(|r| -r.excess(&set.hover)).fold(1.0, f64::min);
        let mut told = |(held, looks): &(Held, Looks<Wrench>)| {
            let seen = looks.largest(|wrench| {
                let excess = rows.iter().map(|row| row.excess(wrench)).fold(f64::NEG_INFINITY, f64::max);
                excess.max(0.0) / margin
            });
            let bounds = strongest(seen, 1.0, MOST_OUTSIDE, |bounds| {
                spent(&mut checker, OF_A_SET.min(left), |checker| checker.set(&set.name, *held, &bounds).is_ok())
            });
            paid(bounds, &mut left)
        };
        let (bounds, commands) = (told(&wrenches), commands.as_ref().map_or_else(Vec::new, told));
        claim.sets.push(SetClaim { mode: set.name.clone(), bounds, commands });
    }
    for row in run.set.rows.iter().filter(|r| !r.equality) {
        let facets = facets_of(model, row);
        let mut told = |(held, looks): &(Held, Looks<Wrench>)| {
            let seen = looks.largest(|wrench| row.excess(wrench));
            let allowed = facets.len() * OF_ONE;
            let bounds = strongest(seen, 1.0, MOST_OUTSIDE, |bounds| {
                spent(&mut checker, allowed.min(left), |checker| {
                    facets.iter().enumerate().all(|(i, facet)| checker.facet(i, facet, *held, &bounds).is_ok())
                })
            });
            paid(bounds, &mut left)
        };
        let (bounds, commands) = (told(&wrenches), commands.as_ref().map_or_else(Vec::new, told));
        let each = |facet| FacetClaim { facet, bounds: bounds.clone(), commands: commands.clone() };
        claim.facets.extend(facets.into_iter().map(each));
    }
    // The healthy set's, then the modes' as declared.
    claim.facets.sort_by_key(|f| model.modes.iter().position(|mode| mode.name == f.facet.mode));
    Ok(Certificate { schema: SCHEMA, spec_sha256: sha256, model: kind, claim: Claim::Plan(claim) })
}

/// The evaluations that a successful check takes, of those it may; `None` where it fails.
fn spent(checker: &mut Checker, allowed: usize, check: impl FnOnce(&mut Checker) -> bool) -> Option<usize> {
    checker.allow(allowed);
    check(checker).then(|| allowed - checker.left())
}

/// Takes what bounds cost off what is left.
fn paid((bounds, evaluations): (Vec<Bound>, usize), left: &mut usize) -> Vec<Bound> {
    *left = left.saturating_sub(evaluations);
    bounds
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

/// Something along a motion: at the nodes, as either piece beside them has it, and between.
struct Looks<T> {
    nodes: Vec<T>,
    between: Vec<T>,
}

/// The largest value at the nodes, and at those and between.
#[derive(Clone, Copy)]
struct Seen {
    nodes: f64,
    all: f64,
}

impl<T> Looks<T> {
    /// What `of` makes of states, each in an interval.
    fn at(trajectory: &Trajectory, kind: DynamicModel, of: impl Fn(usize, &NodeState) -> T) -> Self {
        let mut looks = Looks { nodes: Vec::new(), between: Vec::new() };
        for k in 0..trajectory.intervals() {
            let h = trajectory.times[k + 1] - trajectory.times[k];
            let mut last = trajectory.nodes[k + 1];
            if kind == DynamicModel::Hover {
                // z''' is constant over a piece, and jumps at nodes.
                last[Z][3] = trajectory.within(k, h)[Z][3];
            }
            looks.nodes.extend([trajectory.within(k, 0.0), last].map(|state| of(k, &state)));
            let inside = (1..=LOOKS).map(|i| trajectory.within(k, h * i as f64 / (LOOKS + 1) as f64));
            looks.between.extend(inside.map(|state| of(k, &state)));
        }
        looks
    }

    fn map<U>(&self, of: impl Fn(&T) -> U) -> Looks<U> {
        Looks { nodes: self.nodes.iter().map(&of).collect(), between: self.between.iter().map(&of).collect() }
    }

    fn largest(&self, quantity: impl Fn(&T) -> f64) -> Seen {
        let nodes = self.nodes.iter().map(&quantity).fold(f64::NEG_INFINITY, f64::max);
        Seen { nodes, all: self.between.iter().map(&quantity).fold(nodes, f64::max) }
    }
}

/// A bound at the nodes and the best found beyond them, with the evaluations that they cost together: for every instant if
/// `most` can be shown, which is what means that the rows are kept; else on the grid if that shows as much,
/// with whatever can be shown for every instant. `stands` gives the evaluations that a check takes, or `None`.
fn strongest(
    seen: Seen,
    size: f64,
    most: f64,
    mut stands: impl FnMut(Vec<Bound>) -> Option<usize>,
) -> (Vec<Bound>, usize) {
    let at_nodes = Bound { scope: Scope::Nodes, excess: up(seen.nodes) };
    let missed = MISSED.map(|share| up(seen.all + share * size));
    let mut tried: Vec<f64> = [at_nodes.excess].iter().chain(&missed).chain([&most]).copied().collect();
    // What is seen to be false is not tried.
    tried.retain(|&excess| seen.all <= excess);
    tried.sort_by(f64::total_cmp);
    let mut first = |scope: Scope, excesses: &[f64]| {
        let mut bounds = excesses.iter().map(|&excess| Bound { scope, excess });
        bounds.find_map(|bound| Some((bound, stands(vec![at_nodes, bound])?)))
    };
    let throughout = first(Scope::EveryInstant, &tried);
    let kept = |found: &Option<(Bound, usize)>| found.is_some_and(|(bound, _)| bound.excess <= most);
    let on_grid = match kept(&throughout) {
        true => None,
        false => {
            first(Scope::Grid(LOOKS), &[up(seen.all), missed[0]]).filter(|f| throughout.is_none() || kept(&Some(*f)))
        }
    };
    let found: Vec<(Bound, usize)> = on_grid.into_iter().chain(throughout).collect();
    let cost = found.iter().map(|(_, evaluations)| evaluations).sum();
    (std::iter::once(at_nodes).chain(found.into_iter().map(|(bound, _)| bound)).collect(), cost)
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

/// The facets that a certificate claims for a row: under RSP those of every mode that has its plane, as they were selected;
/// RCP's modes have their whole sets claimed, and one of them stands for it.
fn facets_of(model: &Model, row: &SetRow) -> Vec<FacetRecord> {
    let named = match model.plan.planner {
        PlannerKind::Rsp => row.origin.len(),
        PlannerKind::Rip | PlannerKind::Rcp => 1,
    };
    row.origin.iter().take(named).filter_map(|&origin| record(model, origin)).collect()
}

/// A facet that a row stands for.
pub(super) fn facet_of(model: &Model, row: &SetRow) -> Option<FacetRecord> {
    record(model, *row.origin.first()?)
}

/// `None` where rotors do not name the facet: in a flat set, and where T >= 0 is what it says.
fn record(model: &Model, FacetOf { mode, facet, spanning }: FacetOf) -> Option<FacetRecord> {
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
