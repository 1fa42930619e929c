//! Claims that there is no plan, where there is one.

use super::witness::{axis_of_flight, claiming, empty, grid_nodes, of_harder, of_rows, of_some, row};
use super::{Kind, Known, unfounded};
use crate::numbers::Numbers;
use crate::specs::{Harder, Spec, WEAKER};
use mavc::certificate::{Certificate, FacetWeight, InfeasibleClaim, Multiplier, RowRecord, Side};
use mavc::model::{LimitKind, PlanModel, PlanRotors};
use mavc::motion::YAW;
use mavc::verify::Premise;

pub const KINDS: &[Kind] = &[
    unfounded("multipliers of a shorter time", &[], |s, _| carried_over(s, Harder::Shorter)),
    unfounded("multipliers of stricter limits", &[], |s, _| carried_over(s, Harder::StricterLimits)),
    unfounded("multipliers of another planner's facets", &[Premise::Rows], |s, _| {
        carried_over(s, Harder::OtherPlanner)
    }),
    unfounded("a weaker vehicle's facets", &[Premise::Facets], weaker_vehicle),
    unfounded("facets moved", &[Premise::Facets], facets_moved),
    unfounded("negative multipliers", &[Premise::DualCone], negative),
    unfounded("multipliers out of their cone", &[Premise::DualCone], out_of_cone),
    unfounded("rest that the spec does not ask for", &[Premise::Rest], unasked_rest),
    unfounded("limits that do not exist", &[], no_such_limit),
    unfounded("inputs left out", &[Premise::Inputs], without_inputs),
    unfounded("weights of the thrust", &[], thrust_weights),
    unfounded("huge and tiny multipliers", &[], extreme),
    unfounded("nodes and intervals near 2^64", &[], far_nodes),
    unfounded("intervals that are not beside their node", &[], elsewhere),
    unfounded("multipliers changed at random", &[], tampered),
    unfounded("nothing at all", &[], nothing),
    Kind { name: "a grid where times are open", known: Known::NoSuchGrid, premises: &[], make: open_times },
];

/// Times the length of its other parts, the first part of a cone is clear of rounding.
const INSIDE: f64 = 1.0 + 1e-9;

fn carried_over(spec: &Spec, how: Harder) -> Option<Certificate> {
    Some(claiming(spec, of_harder(spec, how)?))
}

/// Rows of facets count widths of the healthy set, of which the weaker vehicle's is smaller: its multipliers are
/// weighed anew.
fn weaker_vehicle(spec: &Spec, _: &mut Numbers) -> Option<Certificate> {
    let mut claim = of_harder(spec, Harder::WeakerVehicle)?;
    widen(&mut claim, WEAKER.powi(-2));
    Some(claiming(spec, claim))
}

/// Multipliers of facets for a healthy set that is wider by a factor.
pub fn widen(claim: &mut InfeasibleClaim, wider: f64) {
    for multiplier in &mut claim.multipliers {
        if matches!(multiplier.row, RowRecord::Facet { .. } | RowRecord::Commands { .. }) {
            multiplier.z.iter_mut().for_each(|z| *z *= wider);
        }
    }
    claim.thrust.iter_mut().for_each(|entry| entry.weight *= wider);
}

/// Offsets drawn in or normals turned, as if the set were smaller.
fn facets_moved(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mut claim = of_some(spec, numbers)?;
    let share = numbers.between(0.05, 0.9);
    let turn = numbers.below(3) == 0;
    for facet in &mut claim.facets {
        facet.offset *= share;
        if turn {
            facet.normal[numbers.below(4)] *= 1.0 + numbers.between(-0.5, 0.5);
        }
    }
    (!claim.facets.is_empty()).then(|| claiming(spec, claim))
}

/// A tolerance with a negative weight contradicts everything.
fn negative(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let by = -numbers.magnitude(1e-6, 1e6);
    let waypoint = numbers.below(spec.truth.mission().waypoints.len());
    let multipliers = match numbers.below(3) {
        0 => vec![row(RowRecord::Waypoint { waypoint }, &[by, 0.0, 0.0, 0.0])],
        1 => [Side::Upper, Side::Lower].map(|side| row(RowRecord::WaypointYaw { waypoint, side }, &[by])).to_vec(),
        _ => {
            let mut claim = of_some(spec, numbers)?;
            for multiplier in &mut claim.multipliers {
                if !matches!(multiplier.row, RowRecord::Rest { .. }) && numbers.below(2) == 0 {
                    multiplier.z[0] = -multiplier.z[0];
                }
            }
            return Some(claiming(spec, claim));
        }
    };
    Some(of_rows(spec, multipliers))
}

/// Cones without the part that bounds them: speeds that may not be at all, or at the start a thrust that does not carry
/// the weight.
fn out_of_cone(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let share = numbers.between(0.0, 0.95);
    if spec.model().plan.model == PlanModel::Exact && numbers.below(2) == 0 {
        let weight = numbers.magnitude(1e-3, 1e3);
        return Some(of_rows(
            spec,
            vec![row(RowRecord::Thrust { node: 0 }, &[share * 1e-2 * weight, 0.0, 0.0, -weight])],
        ));
    }
    let mut claim = of_harder(spec, Harder::StricterLimits)?;
    for multiplier in &mut claim.multipliers {
        if matches!(multiplier.row, RowRecord::LimitNorm { .. }) {
            multiplier.z[0] *= 0.4 * share;
        }
    }
    Some(claiming(spec, claim))
}

/// The end of the mission held at the origin of an axis.
fn unasked_rest(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let points = &spec.truth.mission().waypoints;
    let waypoint = numbers.below(points.len());
    let point = &points[waypoint];
    let far: Vec<usize> = (0..3).filter(|&i| point.position[i].abs() > 0.2).collect();
    let axis = *numbers.pick(&far)?;
    let holds = points[..waypoint].iter().filter(|w| w.hold > 0.0).count();
    let node = spec.honest.waypoint_nodes[waypoint] - holds;
    // A power of two, so that both rows cancel.
    let weight = 2f64.powi(numbers.below(20) as i32 - 10);
    let towards = point.position[axis].signum();
    let mut z = [INSIDE * weight, 0.0, 0.0, 0.0];
    z[axis + 1] = towards * weight;
    let derivative = if numbers.below(8) == 0 { 1 + numbers.below(9) } else { 0 };
    let rest = row(RowRecord::Rest { node, axis, derivative }, &[-towards * weight]);
    Some(of_rows(spec, vec![row(RowRecord::Waypoint { waypoint }, &z), rest]))
}

fn no_such_limit(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let count = spec.truth.mission().limits.len();
    let node = numbers.below(grid_nodes(spec));
    let limit = if numbers.below(2) == 0 { count + numbers.below(3) } else { usize::MAX - numbers.below(3) };
    let side = [Side::Upper, Side::Lower][numbers.below(2)];
    let weight = numbers.magnitude(1e-3, 1e3);
    let absent = match numbers.below(3) {
        0 => row(RowRecord::Limit { limit, node, side }, &[weight]),
        1 => row(RowRecord::LimitNorm { limit, node, interval: node }, &[weight, -weight, 0.0, 0.0]),
        // Sides and norms that the limits there are do not have.
        _ => row(RowRecord::Limit { limit: numbers.below(count.max(1)), node, side: Side::Lower }, &[weight]),
    };
    let mut claim = of_some(spec, numbers).unwrap_or_else(empty);
    claim.multipliers.push(absent);
    Some(claiming(spec, claim))
}

/// The end is where the start is, unless something moves the vehicle.
fn without_inputs(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let points = &spec.truth.mission().waypoints;
    if !spec.truth.mission().start_at_rest {
        return None;
    }
    let axis = axis_of_flight(spec, numbers)?;
    let last = points.len() - 1;
    let weight = numbers.magnitude(1e-6, 1e6);
    let mut z = [INSIDE * weight, 0.0, 0.0, 0.0];
    z[axis + 1] = weight * (points[last].position[axis] - points[0].position[axis]).signum();
    Some(of_rows(spec, vec![row(RowRecord::Waypoint { waypoint: last }, &z)]))
}

/// Weights that are negative, too large, not numbers or of facets that are not listed.
fn thrust_weights(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mut claim = of_some(spec, numbers)?;
    let count = claim.thrust.len();
    let at = numbers.below(count);
    let factor = numbers.magnitude(1e-6, 1e6);
    let entry = claim.thrust.get_mut(at)?;
    match numbers.below(6) {
        0 => entry.weight = -entry.weight,
        1 => entry.weight *= factor,
        2 => entry.weight = [f64::NAN, f64::INFINITY, -0.0][numbers.below(3)],
        3 => entry.facet = usize::MAX - numbers.below(2),
        4 => claim.thrust.clear(),
        _ => {
            let again: FacetWeight = *entry;
            claim.thrust.push(again);
        }
    }
    Some(claiming(spec, claim))
}

/// Factors under which rounding, overflow or what is lost below the smallest number might decide.
fn extreme(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mut claim = of_some(spec, numbers)?;
    let factor = [1e300, 1e-300, 1e308, 1e150, 5e-324, f64::MAX][numbers.below(6)];
    let all = numbers.below(2) == 0;
    for multiplier in &mut claim.multipliers {
        if all || numbers.below(4) == 0 {
            multiplier.z.iter_mut().for_each(|z| *z *= factor);
        }
    }
    // Rows that cancel up to the last bit, of any size.
    let axis = numbers.below(3);
    let huge = numbers.magnitude(1e10, 1e300);
    for sign in [1.0, -1.0] {
        let mut z = [huge, 0.0, 0.0, 0.0];
        z[axis + 1] = sign * huge;
        claim.multipliers.push(row(RowRecord::Waypoint { waypoint: 0 }, &z));
    }
    Some(claiming(spec, claim))
}

fn far_nodes(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mut claim = of_some(spec, numbers)?;
    let far = [usize::MAX, usize::MAX - 1, 1 << 63, (1 << 32) + 1, grid_nodes(spec)][numbers.below(5)];
    let near = numbers.below(grid_nodes(spec));
    let rows = [
        row(RowRecord::Rest { node: far, axis: 0, derivative: 1 }, &[1.0]),
        row(RowRecord::Rest { node: 0, axis: far, derivative: 1 }, &[1.0]),
        row(RowRecord::Rest { node: 0, axis: 0, derivative: far }, &[1.0]),
        row(RowRecord::Facet { facet: far, node: near }, &[1.0]),
        row(RowRecord::Facet { facet: 0, node: far }, &[1.0]),
        row(RowRecord::Commands { facet: 0, node: near, interval: far }, &[1.0]),
        row(RowRecord::Commands { facet: 0, node: far, interval: far.wrapping_sub(1) }, &[1.0]),
        row(RowRecord::LimitNorm { limit: 0, node: far, interval: far }, &[1.0, 0.0, 0.0, 0.0]),
        row(RowRecord::LimitNorm { limit: 0, node: near, interval: far }, &[1.0, 0.0, 0.0, 0.0]),
        row(RowRecord::Thrust { node: far }, &[1.0, 0.0, 0.0, -1.0]),
        row(RowRecord::Waypoint { waypoint: far }, &[1.0, -1.0, 0.0, 0.0]),
        row(RowRecord::WaypointYaw { waypoint: far, side: Side::Upper }, &[1.0]),
    ];
    claim.multipliers.extend(numbers.pick(&rows).cloned());
    Some(claiming(spec, claim))
}

/// Slopes of an interval before the first, behind the last or elsewhere.
fn elsewhere(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let nodes = grid_nodes(spec);
    let (node, weight) = ([0, nodes - 1, numbers.below(nodes)][numbers.below(3)], numbers.magnitude(1e-3, 1e3));
    let interval = [usize::MAX, usize::MAX - 1, nodes - 1, nodes, node + 1][numbers.below(5)];
    let lags = spec.model().plan.rotors == PlanRotors::Lagging;
    let jerk = spec.truth.mission().limits.iter().position(|l| l.kind == LimitKind::Jerk);
    let mut claim = of_some(spec, numbers).unwrap_or_else(empty);
    match jerk {
        Some(limit) if spec.model().plan.model == PlanModel::Hover => {
            let z = [weight, 0.0, 0.0, -weight];
            claim.multipliers.push(row(RowRecord::LimitNorm { limit, node, interval }, &z));
        }
        _ if lags && !claim.facets.is_empty() => {
            claim.multipliers.push(row(RowRecord::Commands { facet: 0, node, interval }, &[weight]));
        }
        _ => return None,
    }
    Some(claiming(spec, claim))
}

fn tampered(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let mut claim = of_some(spec, numbers)?;
    let factor = numbers.magnitude(1e-6, 1e6);
    for _ in 0..=numbers.below(20) {
        let at = numbers.below(claim.multipliers.len());
        let node = numbers.below(grid_nodes(spec));
        match numbers.below(6) {
            0 => claim.multipliers[at].z.iter_mut().for_each(|z| *z *= factor),
            1 => claim.multipliers[at].z.iter_mut().for_each(|z| *z = -*z),
            2 => claim.multipliers[at].z[0] *= factor,
            3 if claim.multipliers.len() > 1 => drop(claim.multipliers.remove(at)),
            4 => {
                let again = claim.multipliers[at].clone();
                claim.multipliers.push(again);
            }
            _ => moved(&mut claim.multipliers[at], node),
        }
    }
    Some(claiming(spec, claim))
}

/// The row at another node.
fn moved(multiplier: &mut Multiplier, to: usize) {
    match &mut multiplier.row {
        RowRecord::Rest { node, .. }
        | RowRecord::Facet { node, .. }
        | RowRecord::Commands { node, .. }
        | RowRecord::Limit { node, .. }
        | RowRecord::LimitNorm { node, .. }
        | RowRecord::Thrust { node } => *node = to,
        RowRecord::Waypoint { waypoint } => *waypoint = to % 4,
        RowRecord::WaypointYaw { side, .. } => *side = Side::Upper,
    }
}

/// No rows, or rows of weight nothing.
fn nothing(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    let count = numbers.below(4);
    let zero = [0.0, -0.0, 5e-324][numbers.below(3)];
    let rest = |k| row(RowRecord::Rest { node: 0, axis: k % (YAW + 1), derivative: 1 }, &[zero]);
    Some(of_rows(spec, (0..count).map(rest).collect()))
}

/// Multipliers of a grid that the spec does not lay down; they would hold for any.
fn open_times(spec: &Spec, numbers: &mut Numbers) -> Option<Certificate> {
    without_inputs(spec, numbers)
}
