//! Plans in the exact model satisfy the spec at the nodes and between them.

use super::{last, planning, solved, turning};
use crate::vehicles::{limit, mission, waypoint};
use mavc::admissible::AdmissibleSet;
use mavc::admissible::row::SetRow;
use mavc::model::{LimitKind, Mission, MissionTime, Model, PlannerKind};
use mavc::motion::{NodeState, Trajectory, X, Y, YAW, Z};
use mavc::planner::selection::PlanningSet;
use mavc::planner::studies::Comparison;

use mavc::motion::wrench_model::WrenchModel;
use mavc::tolerance::UPRIGHT;

/// The violation of rows that is allowed between the [`PARTS`] instants of an interval, as a share. Rows hold at the
/// instants; the deviation of wrenches and norms from straight lines in between decreases with the square of the step.
const BETWEEN: f64 = 1e-4;

/// What rows of a program may be missed by, as everywhere.
const MISSED: f64 = 1e-6;

/// What rounding may leave of the derivatives of a motion at rest, SI units.
const RESTING: f64 = 1e-9;

fn norm(state: &NodeState, axes: &[usize], order: usize) -> f64 {
    axes.iter().map(|&a| state[a][order].powi(2)).sum::<f64>().sqrt()
}

/// By how much a state violates a limit, as a share of it (rad for an angle).
fn past(kind: LimitKind, upper: f64, state: &NodeState, gravity: f64) -> f64 {
    match kind {
        LimitKind::Speed => norm(state, &[X, Y, Z], 1) / upper - 1.0,
        LimitKind::Tilt => norm(state, &[X, Y], 2).atan2(state[Z][2] + gravity) - upper,
        LimitKind::YawRate => state[YAW][1].abs() / upper - 1.0,
        LimitKind::Climb => state[Z][1] / upper - 1.0,
        LimitKind::Z => state[Z][0] - upper,
        LimitKind::Jerk => norm(state, &[X, Y, Z], 3) / upper - 1.0,
        LimitKind::Acceleration => norm(state, &[X, Y, Z], 2) / upper - 1.0,
        LimitKind::AccelerationHorizontal => norm(state, &[X, Y], 2) / upper - 1.0,
        other => panic!("{other:?} is not checked here"),
    }
}

/// The largest violation of facets, limits and the upright rule: at the nodes, and at nine instants in each interval,
/// with the row that is violated most there.
fn passed(model: &Model, plan: &Trajectory, rows: &[SetRow]) -> (f64, f64, String) {
    let limits = &model.mission.as_ref().unwrap().limits;
    let (mut nodes, mut between, mut what) = (f64::NEG_INFINITY, f64::NEG_INFINITY, String::new());
    for k in 0..plan.intervals() {
        let h = plan.times[k + 1] - plan.times[k];
        for part in 0..=10 {
            let state = match part {
                0 => plan.nodes[k],
                10 => plan.nodes[k + 1],
                _ => plan.within(k, h * f64::from(part) / 10.0),
            };
            let wrench = WrenchModel::Exact.wrench(&model.vehicle, &model.environment(), &state);
            let facets = rows.iter().map(|row| (row.violation(&wrench), format!("{:?}", row.origin)));
            let limits = limits
                .iter()
                .map(|l| (past(l.kind.clone(), l.upper.unwrap(), &state, model.gravity), format!("{:?}", l.kind)));
            let upright = (UPRIGHT - 1.0 - state[Z][2] / model.gravity, "upright".into());
            let worst = facets.chain(limits).chain([upright]).max_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
            if part % 10 == 0 {
                nodes = nodes.max(worst.0);
            } else if worst.0 > between {
                (between, what) = (worst.0, format!("{} {part}/10 of interval {k}", worst.1));
            }
        }
    }
    (nodes, between, what)
}

/// Nothing is violated at a node, and little between nodes.
fn keeps(model: &Model, plan: &Trajectory, rows: &[SetRow]) {
    let (nodes, between, what) = passed(model, plan, rows);
    // Bounds in degrees and radians may round.
    assert!(nodes <= 1e-12, "a row is passed by {nodes:e} at a node");
    assert!(between <= BETWEEN, "{what} is passed by {between:e}");
}

/// Waypoints within tolerance, pieces that join, rests that are rests, holds that stand still, times that are met.
fn meets(model: &Model, plan: &Trajectory) {
    let mission = model.mission.as_ref().unwrap();
    for (i, (w, &node)) in mission.waypoints.iter().zip(&plan.waypoint_nodes).enumerate() {
        let state = &plan.nodes[node];
        let apart: f64 = (0..3).map(|a| (state[a][0] - w.position[a]).powi(2)).sum::<f64>().sqrt();
        assert!(apart <= w.within + MISSED, "waypoint {i} is missed by {apart}");
        assert!((state[YAW][0] - w.yaw).abs() <= w.yaw_within + MISSED, "yaw at waypoint {i}");
        if let Some(time) = w.time {
            assert_eq!(plan.times[node], time, "waypoint {i}");
        }
        let rests =
            w.hold > 0.0 || i == 0 && mission.start_at_rest || i + 1 == mission.waypoints.len() && mission.end_at_rest;
        if rests {
            assert!(highest(state) <= RESTING, "waypoint {i} is no rest: {state:?}");
        }
        if w.hold > 0.0 {
            assert!((plan.times[node + 1] - plan.times[node] - w.hold).abs() < 1e-12);
            assert_eq!(plan.nodes[node + 1], *state, "the hold moves");
            for share in [0.0, 0.3, 0.9] {
                let held = plan.within(node, share * w.hold);
                assert_eq!(held, *state, "the hold moves");
                assert_eq!(held.map(|axis| axis[4]), [0.0; 4]);
            }
        }
    }
    for k in 0..plan.intervals() {
        let h = plan.times[k + 1] - plan.times[k];
        let end = plan.within(k, h);
        for (axis, r) in WrenchModel::Exact.orders().into_iter().enumerate() {
            let (found, wanted) = (&end[axis][..=r], &plan.nodes[k + 1][axis][..=r]);
            for (order, (a, b)) in found.iter().zip(wanted).enumerate() {
                let allowed = MISSED * h.powi(-(order as i32));
                assert!((a - b).abs() <= allowed, "axis {axis}, derivative {order} jumps by {:e} after {k}", a - b);
            }
        }
    }
}

/// The largest velocity, acceleration or jerk of x, y, z, or rate or acceleration of yaw.
fn highest(state: &NodeState) -> f64 {
    let orders = |axis: usize| if axis == YAW { 1..=2 } else { 1..=3 };
    (0..4).flat_map(|axis| orders(axis).map(move |m| state[axis][m].abs())).fold(0.0, f64::max)
}

fn modes_set(model: &Model, mode: usize) -> Vec<SetRow> {
    PlanningSet::of(&[&AdmissibleSet::of_mode(model, mode)], &AdmissibleSet::healthy(model)).rows
}

pub(super) fn healthy_set(model: &Model) -> PlanningSet {
    let healthy = AdmissibleSet::healthy(model);
    PlanningSet::of(&[&healthy], &healthy)
}

/// Plans, and looks at all but the fault sets.
pub fn planned(model: &Model) -> Comparison {
    let comparison = super::compared(model);
    let plan = &solved(last(&comparison)).trajectory;
    meets(model, plan);
    keeps(model, plan, &healthy_set(model).rows);
    if let MissionTime::Fixed(time) = model.plan.time {
        assert_eq!(plan.duration(), time);
    }
    comparison
}

/// A time at which the modes' sets and both limits matter.
pub(super) const QUICK: MissionTime = MissionTime::Fixed(5.0);

#[test]
fn rip_rcp_and_rsp_hold_at_one_time() {
    let rip = planning(turning(), PlannerKind::Rip, &[0], QUICK);
    let found = planned(&rip);
    // Facets are selected by the plan before the second pass.
    let least_snap = last(&found).plainer.as_deref().unwrap_or(solved(last(&found)));
    let outside = &least_snap.outside[0];
    assert!(outside.max_violation > 0.05, "RIP stays inside: {outside:?}");

    let rcp = planning(turning(), PlannerKind::Rcp, &[0], QUICK);
    let found = planned(&rcp);
    let conservative = solved(last(&found));
    keeps(&rcp, &conservative.trajectory, &modes_set(&rcp, 0));
    assert_eq!(conservative.outside[0].seconds, 0.0);

    let rsp = planning(turning(), PlannerKind::Rsp, &[0], QUICK);
    let found = planned(&rsp);
    assert!(!found.selected.is_empty());
    keeps(&rsp, &solved(last(&found)).trajectory, &found.selected);
    // The selected facets are those that the RIP plan violates at some instant.
    let facets: Vec<usize> = modes_set(&rsp, 0)
        .iter()
        .enumerate()
        .filter(|(_, row)| found.selected.iter().any(|s| s.normal == row.normal && s.offset == row.offset))
        .map(|(i, _)| i)
        .collect();
    assert_eq!(facets, outside.violated);
    assert!(facets.len() < modes_set(&rsp, 0).len());
}

#[test]
fn shortest_times_hold_and_guards_cost_time() {
    let time = |planner| {
        let model = planning(turning(), planner, &[0], MissionTime::Minimum);
        let comparison = planned(&model);
        let plan = solved(last(&comparison));
        assert_eq!(plan.trajectory.duration(), plan.time);
        if planner == PlannerKind::Rcp {
            keeps(&model, &plan.trajectory, &modes_set(&model, 0));
        }
        plan.time
    };
    let (rip, rcp) = (time(PlannerKind::Rip), time(PlannerKind::Rcp));
    // The way alone takes longer than this at 4 m/s.
    let way: f64 = turning().waypoints.windows(2).map(|w| apart(&w[0].position, &w[1].position)).sum();
    assert!(rip > way / 4.0 - 0.1 && rip < 6.0, "{rip} s");
    assert!(rcp > rip, "{rcp} s with a rotor to spare, {rip} s without");
}

pub(super) fn apart(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

/// A hold, a fixed time, a height and a turning rate that bind.
pub(super) fn stopping() -> Mission {
    let mut points =
        vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint([4.0, 2.0, 5.0], 1.0), waypoint([7.0, -1.0, 4.0], 2.2)];
    points[1].hold = 1.5;
    points[1].time = Some(4.0);
    let mut mission = mission(points);
    mission.limits =
        vec![limit(LimitKind::Z, 5.0), limit(LimitKind::YawRate, 0.9), limit(LimitKind::Acceleration, 4.0)];
    mission
}

#[test]
fn holds_and_fixed_times_are_kept() {
    for (planner, time) in [
        (PlannerKind::Rip, MissionTime::Fixed(9.5)),
        (PlannerKind::Rcp, MissionTime::Fixed(9.5)),
        (PlannerKind::Rcp, MissionTime::Minimum),
    ] {
        let model = planning(stopping(), planner, &[0], time);
        let comparison = planned(&model);
        let plan = &solved(last(&comparison)).trajectory;
        let second = plan.waypoint_nodes[1];
        assert_eq!((plan.times[second], plan.times[second + 1]), (4.0, 5.5));
        if planner == PlannerKind::Rcp {
            keeps(&model, plan, &modes_set(&model, 0));
        }
    }
}

fn moving() -> Mission {
    Mission { start_at_rest: false, end_at_rest: false, ..turning() }
}

#[test]
fn missions_may_begin_and_end_moving() {
    let model = planning(moving(), PlannerKind::Rip, &[], MissionTime::Fixed(8.0));
    let comparison = planned(&model);
    let plan = &solved(last(&comparison)).trajectory;
    assert!(highest(&plan.nodes[0]) > 0.1 && highest(plan.nodes.last().unwrap()) > 0.1);
}

/// A plan from rest to rest is one of the mission that may begin and end as it likes.
#[test]
fn free_ends_are_no_harder_than_rests() {
    for time in [5.0, 6.0] {
        planned(&planning(turning(), PlannerKind::Rip, &[], MissionTime::Fixed(time)));
        planned(&planning(moving(), PlannerKind::Rip, &[], MissionTime::Fixed(time)));
    }
}

/// Between free ends a straight line at constant speed costs nothing.
#[test]
fn a_straight_line_is_found_between_free_ends() {
    let ends = vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint([4.0, 0.0, 2.0], 0.0)];
    let straight = Mission { start_at_rest: false, end_at_rest: false, ..mission(ends) };
    let tilt = limit(LimitKind::Tilt, 20f64.to_radians());
    for bound in [tilt, limit(LimitKind::AccelerationHorizontal, 1.0)] {
        let limits = vec![bound];
        let model = planning(Mission { limits, ..straight.clone() }, PlannerKind::Rip, &[], MissionTime::Fixed(3.0));
        let comparison = planned(&model);
        let found = solved(last(&comparison));
        assert!(found.objective < 1e-9, "{}", found.objective);
    }
}

fn has_one_plan(planner: PlannerKind, time: MissionTime) {
    let model = planning(turning(), planner, &[0, 1], time);
    let [one, two] = [(), ()].map(|()| super::compared(&model));
    let (one, two) = (solved(last(&one)), solved(last(&two)));
    assert_eq!(one.trajectory, two.trajectory);
    assert_eq!((one.objective, one.time), (two.objective, two.time));
}

#[test]
fn equal_specs_have_equal_plans() {
    has_one_plan(PlannerKind::Rsp, QUICK);
}

#[test]
#[ignore = "long"]
fn equal_specs_have_equal_shortest_plans() {
    has_one_plan(PlannerKind::Rip, MissionTime::Minimum);
}

/// Everything holds to 1e-4 at every instant.
#[test]
fn rows_hold_between_their_instants() {
    let mut jerking = stopping();
    jerking.limits.push(limit(LimitKind::Jerk, 25.0));
    for (mission, time) in [(turning(), MissionTime::Minimum), (jerking, MissionTime::Fixed(9.5))] {
        let model = planning(mission, PlannerKind::Rip, &[], time);
        let comparison = super::compared(&model);
        let (_, between, what) = passed(&model, &solved(last(&comparison)).trajectory, &healthy_set(&model).rows);
        assert!(between <= 1e-4, "{what} is passed by {between:e}");
    }
}
