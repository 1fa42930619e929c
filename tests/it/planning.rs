//! Shortest times and comparisons of planners on the paper's octocopter, against values computed once by an
//! independent bisection (other language, other transcription, bracket 5e-4 s).

use crate::vehicles::{hexacopter, inspection, limit, lost, mission, paper_case, quadcopter, ring_model, waypoint};
use mavc::admissible::AdmissibleSet;
use mavc::admissible::row::VIOLATED;
use mavc::model::{LimitKind, Mission, MissionTime, Model, PlannerKind, Problem};
use mavc::planner::hover::{ACCEPTED, Decision, HoverPlanner};
use mavc::planner::selection::PlanningSet;
use mavc::planner::studies::{Comparison, MissionPlan, PlanOutcome, PlannerRun, Proof, Run, Scope, run_planners};
use mavc::planner::timing::search::RESOLUTION;
use mavc::planner::working_set::WorkingSet;

fn run(model: &Model, scope: Scope) -> Comparison {
    run_planners(Problem::of(model).unwrap(), scope, None)
}

fn solved(run: &PlannerRun) -> &MissionPlan {
    match &run.outcome {
        PlanOutcome::Planned(s) => s,
        other => panic!("{:?} {:?}: {other:?}", run.planner, run.against),
    }
}

/// The shortest time is the first multiple of the resolution at or above the threshold, and shown to be.
fn shortest_is(planner: PlannerKind, against: &[usize], tilt: Option<f64>, threshold: f64) {
    let mut model = paper_case(planner, against);
    let limits = tilt.map(|degrees| limit(LimitKind::Tilt, degrees.to_radians()));
    model.mission.as_mut().unwrap().limits.extend(limits);
    let comparison = run(&model, Scope::Plan);
    let found = solved(&comparison.runs[0]);
    let infeasible = found.infeasible_at.expect("a shorter time shown infeasible");
    assert!(found.time >= threshold - 1e-3, "{} s is too short", found.time);
    assert!(found.time <= threshold + RESOLUTION + 1e-3, "{} s is not the shortest", found.time);
    assert!(infeasible < found.time && infeasible >= found.time - RESOLUTION - 1e-9, "{infeasible}");
    assert!(infeasible <= threshold + 1e-3, "{infeasible} s is feasible");
    assert!(found.infeasible_above.is_empty());
    assert_eq!(found.trajectory.duration(), found.time);
}

#[test]
fn shortest_rip() {
    shortest_is(PlannerKind::Rip, &[], None, 15.526);
}

#[test]
fn shortest_rcp_single() {
    shortest_is(PlannerKind::Rcp, &[0], None, 15.954);
}

#[test]
fn shortest_rcp_double() {
    shortest_is(PlannerKind::Rcp, &[8], None, 19.949);
}

#[test]
fn shortest_rcp_jointly() {
    shortest_is(PlannerKind::Rcp, &[0, 1, 2, 3, 4, 5, 6, 7], None, 16.827);
}

// With the tilt bounded, no set binds: the limit alone decides.

#[test]
fn shortest_rip_with_tilt_limit() {
    shortest_is(PlannerKind::Rip, &[], Some(35.0), 22.937);
}

#[test]
fn shortest_rcp_single_with_tilt_limit() {
    shortest_is(PlannerKind::Rcp, &[0], Some(35.0), 22.937);
}

#[test]
fn shortest_rcp_double_with_tilt_limit() {
    shortest_is(PlannerKind::Rcp, &[8], Some(35.0), 22.937);
}

#[test]
fn shortest_rcp_jointly_with_tilt_limit() {
    shortest_is(PlannerKind::Rcp, &[0, 1, 2, 3, 4, 5, 6, 7], Some(35.0), 22.937);
}

#[test]
fn case_1_compared() {
    let mut model = paper_case(PlannerKind::Rsp, &[0]);
    // The paper's times, with the paper's samples, are those of the tests above.
    model.plan.samples = 100;
    let comparison = run(&model, Scope::Everything);
    let of = |planner, which| {
        let mut found = comparison.runs.iter().filter(|r| r.planner == planner && r.run == which);
        let only = found.next().unwrap();
        assert!(found.next().is_none());
        solved(only)
    };
    let at = comparison.common_time.unwrap();
    // One mode: T_d is its RCP's shortest time.
    assert_eq!(of(PlannerKind::Rcp, Run::Own).time, at);
    for which in [Run::Own, Run::Common] {
        let [rip, rcp, rsp] = [PlannerKind::Rip, PlannerKind::Rcp, PlannerKind::Rsp].map(|p| of(p, which));
        // RIP does not care and is outside M1's set; RCP never is.
        let (out, never) = (&rip.outside[0], &rcp.outside[0]);
        assert!(out.max_violation > VIOLATED && out.seconds > 0.0 && out.last.is_some() && out.positions > 0);
        assert!(never.max_violation <= ACCEPTED && never.facets.is_empty() && never.rows == 0);
        assert_eq!((never.seconds, never.last), (0.0, None));
        // RSP keeps what was selected at T_d.
        assert!(!comparison.selected.is_empty());
        for w in rsp.trajectory.node_wrenches(&model.vehicle, &model.environment()) {
            assert!(comparison.selected.iter().all(|row| row.violation(&w) <= ACCEPTED));
        }
        assert!(rip.time <= rsp.time && rsp.time <= rcp.time);
    }
    // At one time: fewer rows, cheaper plans.
    let [rip, rcp, rsp] = [PlannerKind::Rip, PlannerKind::Rcp, PlannerKind::Rsp].map(|p| of(p, Run::Common).objective);
    assert!(rip <= rsp * (1.0 + 1e-5) && rsp <= rcp * (1.0 + 1e-5), "{rip} {rsp} {rcp}");
    assert!(rip < rcp * (1.0 - 1e-4));
    // The selected facets are just those RIP violates at T_d.
    let rip = of(PlannerKind::Rip, Run::Common);
    let wrenches = rip.trajectory.node_wrenches(&model.vehicle, &model.environment());
    assert!(comparison.selected.iter().all(|row| wrenches.iter().any(|w| row.violation(w) > VIOLATED)));
    assert_eq!(rip.outside[0].facets.len(), comparison.selected.len());
    // What a campaign flies are these plans at T_d, found without the others.
    let flown = run(&model, Scope::Common);
    assert_eq!((flown.common_time, flown.runs.len()), (comparison.common_time, 3));
    for run in &flown.runs {
        let (here, there) = (solved(run), of(run.planner, Run::Common));
        assert_eq!((run.run, here.time), (Run::Common, at));
        assert!((here.objective / there.objective - 1.0).abs() < 1e-4, "{} {}", here.objective, there.objective);
    }
    let alone = run(&model, Scope::Plan);
    assert_eq!(alone.common_time, comparison.common_time);
    let (alone, compared) = (solved(&alone.runs[0]), of(PlannerKind::Rsp, Run::Own));
    assert!((alone.time - compared.time).abs() <= RESOLUTION + 1e-9, "{} {}", alone.time, compared.time);
}

/// Fine grids are badly scaled in spline coefficients; stage variables take them in a few iterations.
#[test]
fn a_fine_grid_takes_few_iterations() {
    let model = paper_case(PlannerKind::Rip, &[]);
    let healthy = AdmissibleSet::healthy(&model);
    let set = PlanningSet::of(&[&healthy], &healthy);
    let mut engine = HoverPlanner::new(Problem::of(&model).unwrap(), &healthy);
    let Decision::Feasible(planned) = engine.decide(20.0, 600, &set, &mut WorkingSet::default()) else {
        panic!("20 s are enough");
    };
    // Within a discretisation error of the 200-sample optimum.
    assert!(planned.objective < 2.9416513 && planned.objective > 2.9, "{}", planned.objective);
    assert!(engine.effort.iterations <= 20 * engine.effort.solves, "{:?}", engine.effort);
}

#[test]
fn a_fixed_time_is_the_common_time() {
    let mut model = paper_case(PlannerKind::Rsp, &[0, 8]);
    model.plan.samples = 60;
    model.plan.time = MissionTime::Fixed(24.0);
    let comparison = run(&model, Scope::Plan);
    assert_eq!(comparison.common_time, Some(24.0));
    assert_eq!((comparison.runs.len(), comparison.runs[0].run), (1, Run::Common));
    let found = solved(&comparison.runs[0]);
    assert_eq!((found.time, found.infeasible_at), (24.0, None));
    model.plan.time = MissionTime::Fixed(12.0);
    assert!(
        matches!(run(&model, Scope::Plan).runs[0].outcome, PlanOutcome::Infeasible(Proof { at, .. }) if at == 12.0)
    );
}

#[test]
fn a_reserve_costs_time() {
    let mut model = paper_case(PlannerKind::Rip, &[]);
    model.plan.samples = 60;
    let time = |reserve: f64| {
        let mut model = model.clone();
        model.plan.reserve = reserve;
        solved(&run(&model, Scope::Plan).runs[0]).time
    };
    let times = [0.0, 0.2, 0.5].map(time);
    assert!(times[0] < times[1] && times[1] < times[2], "{times:?}");
}

#[test]
fn inspection_has_a_shortest_time() {
    let mut model = paper_case(PlannerKind::Rip, &[]);
    model.plan.samples = 60;
    model.mission = Some(inspection());
    let comparison = run(&model, Scope::Plan);
    let found = solved(&comparison.runs[0]);
    // The last leg starts at the fixed time; with 6 m/s it takes more than 20 m / 6 m/s.
    assert!(found.time > 18.0 + 20.0 / 6.0, "{}", found.time);
    assert!(found.infeasible_at.is_some_and(|t| t >= found.time - RESOLUTION - 1e-9));
}

/// Four corners of a square, climbing, in one yaw.
fn square(side: f64) -> Mission {
    let corner = |i: usize| {
        let [x, y] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]][i];
        waypoint([side * x, side * y, 2.0 + i as f64], 0.0)
    };
    mission((0..5).map(corner).collect())
}

#[test]
fn four_and_sixteen_rotors_plan() {
    let sixteen = ring_model("PNPNPNPNPNPNPNPN", 4.5, [0.2, 0.2, 0.35], 8.5485e-6, 1.3678e-7, 874.0);
    for mut model in [quadcopter(), sixteen] {
        model.plan.planner = PlannerKind::Rip;
        model.plan.samples = 40;
        model.mission = Some(square(6.0));
        let comparison = run(&model, Scope::Plan);
        let found = solved(&comparison.runs[0]);
        assert!(found.time > 1.0 && found.time < 30.0, "{}", found.time);
        let set = &comparison.runs[0].set;
        for w in found.trajectory.node_wrenches(&model.vehicle, &model.environment()) {
            assert!(set.rows.iter().all(|r| r.violation(&w) <= ACCEPTED));
        }
    }
}

#[test]
fn a_flat_set_is_planned_on_its_plane() {
    let mut model = hexacopter("PNPNPN");
    model.modes.push(lost(&model, &[1, 4]));
    model.plan.samples = 40;
    model.mission = Some(square(4.0));
    let healthy = AdmissibleSet::healthy(&model);
    let flat = AdmissibleSet::of_mode(&model, 0);
    assert_eq!(flat.rank, 3);
    let set = PlanningSet::of(&[&flat], &healthy);
    assert_eq!(set.rows.iter().filter(|r| r.equality).count(), 1);
    let mut engine = HoverPlanner::new(Problem::of(&model).unwrap(), &healthy);
    let Decision::Feasible(planned) = engine.decide(20.0, 40, &set, &mut WorkingSet::default()) else {
        panic!("20 s are plenty");
    };
    let trajectory = planned.trajectory();
    let wrenches = trajectory.node_wrenches(&model.vehicle, &model.environment());
    let largest = wrenches.iter().map(|w| w[1].abs()).fold(0.0, f64::max);
    assert!(largest > 1e-3, "the plan rolls");
    for w in &wrenches {
        // Rotors 2, 3, 5, 6 tie yaw to roll: tau_z / tau_x is one number, d / (b y).
        assert!(flat.polytope.off_plane(w) < 1e-7 && flat.polytope.margin(w) > -1e-6);
        let arm = model.vehicle.rotors[1].position[1];
        assert!((w[3] - w[1] * 1.3678e-7 / 8.5485e-6 / arm).abs() < 1e-7, "{w}");
    }
    // Against the whole search as well.
    model.plan.against = vec![0];
    model.plan.planner = PlannerKind::Rcp;
    let comparison = run(&model, Scope::Plan);
    assert!(solved(&comparison.runs[0]).time < 20.0);
}

#[test]
fn times_out_of_all_reach_are_infeasible() {
    let model = paper_case(PlannerKind::Rip, &[]);
    let healthy = AdmissibleSet::healthy(&model);
    let set = PlanningSet::of(&[&healthy], &healthy);
    for exponent in -30..=1 {
        for time in [1.0, 2.0, 5.0].map(|f| f * 10.0_f64.powi(exponent)).into_iter().filter(|t| *t < 15.5) {
            let mut engine = HoverPlanner::new(Problem::of(&model).unwrap(), &healthy);
            let decision = engine.decide(time, model.plan.samples, &set, &mut WorkingSet::default());
            assert!(matches!(decision, Decision::Infeasible), "{time} s: {decision:?}");
        }
    }
}

/// Very long; a command of their own runs these (CONTRIBUTING.md).
mod thorough {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn two_runs_and_any_number_of_threads_give_the_same_numbers() {
        let mut model = paper_case(PlannerKind::Rsp, &[0, 2]);
        model.plan.samples = 60;
        let text = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let c = pool.install(|| run(&model, Scope::Everything));
            assert!(c.runs.len() >= 10);
            format!("{:?} {:?} {:?} {} {}", c.runs, c.common_time, c.selected, c.effort.solves, c.effort.iterations)
        };
        let once = text(2);
        assert!(once == text(2), "two runs differ");
        assert!(once == text(1), "one thread differs from two");
    }
}
