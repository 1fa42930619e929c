//! What plans in the exact model cost: it is (48), and no more than it need be.

use super::plans::{QUICK, apart, healthy_set, stopping};
use super::{last, planning, solved, turning};
use crate::vehicles::{mission, waypoint};
use mavc::admissible::AdmissibleSet;
use mavc::admissible::row::VIOLATED;
use mavc::model::{Mission, MissionTime, Model, PlannerKind, Problem};
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, Trajectory, X, Y, YAW, Z};
use mavc::planner::hover::{Decision, HoverPlanner, Planned};
use mavc::planner::scp::{PARTS, ScpPlanner};
use mavc::planner::transcription::{Purpose, Transcription};
use mavc::qp::{QuadraticProgram, Sparse};

/// x'P x/2 + q'x + constant.
fn objective(program: &QuadraticProgram, x: &[f64]) -> f64 {
    let Sparse { cols, colptr, rowval, nzval, .. } = &program.p;
    let mut sum = program.constant;
    for j in 0..*cols {
        for (&i, &v) in rowval[colptr[j]..colptr[j + 1]].iter().zip(&nzval[colptr[j]..colptr[j + 1]]) {
            sum += v * x[i] * x[j] * if i == j { 0.5 } else { 1.0 };
        }
        sum += program.q[j] * x[j];
    }
    sum
}

/// (48) of a trajectory by Simpson's rule, fine enough for polynomials of degree 8.
fn cost(model: &Model, plan: &Trajectory) -> f64 {
    let mission = model.mission.as_ref().unwrap();
    let (snap, acceleration) = (model.plan.snap_weight, model.plan.acceleration_weight);
    let rate = |s: &NodeState| {
        let snaps = s[X][4].powi(2) + s[Y][4].powi(2) + s[Z][4].powi(2);
        snap * snaps + acceleration * (s[Z][2].powi(2) + s[YAW][2].powi(2))
    };
    let mut sum = 0.0;
    for k in 0..plan.intervals() {
        let h = plan.times[k + 1] - plan.times[k];
        for (i, weight) in (0..=32).map(|i| (i, if i % 32 == 0 { 1.0 } else { f64::from(2 + i % 2 * 2) })) {
            sum += h / 96.0 * weight * rate(&plan.within(k, h * f64::from(i) / 32.0));
        }
    }
    for (w, &node) in mission.waypoints.iter().zip(&plan.waypoint_nodes) {
        let s = &plan.nodes[node];
        sum += w.weight * (apart(&w.position, &[s[X][0], s[Y][0], s[Z][0]]).powi(2) + (s[YAW][0] - w.yaw).powi(2));
    }
    sum
}

/// One number three ways: what the plan reports, the objective of the program at the plan's states, and the integral.
#[test]
fn the_cost_of_a_plan_is_its_programs_objective() {
    for (mission, time) in [(turning(), 5.0), (stopping(), 9.5)] {
        let model = planning(mission, PlannerKind::Rip, &[], MissionTime::Fixed(time));
        let problem = Problem::of(&model).unwrap();
        let healthy = AdmissibleSet::healthy(&model);
        let set = healthy_set(&model);
        let mut engine = HoverPlanner::new(problem, &healthy);
        let Decision::Feasible(planned) = ScpPlanner::new(&mut engine, WrenchModel::Exact, &set).decide(time, &[])
        else {
            panic!("no plan at {time} s");
        };
        let Planned { grid: profile, states, objective: reported, .. } = &*planned;
        let flown = profile.flown();
        let form = Transcription::new(problem, &flown, &set, &[], &[X, Y, Z, YAW])
            .with_orders(WrenchModel::Exact.orders(), PARTS);
        let program = form.program(Purpose::Plan { slack: 0.0 }, &[]);
        let wanted = profile.without_holds(states);
        // Each variable stands for one derivative at one node, in some unit.
        let x: Vec<f64> = (0..form.variables())
            .map(|i| {
                let mut unit = vec![0.0; form.variables()];
                unit[i] = 1.0;
                let image = form.states(&unit);
                let place = (0..image.len() * 20).find(|p| image[p / 20][p / 5 % 4][p % 5] != 0.0);
                place.map_or(0.0, |p| wanted[p / 20][p / 5 % 4][p % 5] / image[p / 20][p / 5 % 4][p % 5])
            })
            .collect();
        assert_eq!(form.states(&x).len(), wanted.len());
        let found = objective(&program, &x);
        assert!((found / reported - 1.0).abs() < 1e-9, "{found} and {reported}");
        let integral = cost(&model, &planned.trajectory());
        assert!((integral / reported - 1.0).abs() < 1e-5, "{integral} and {reported}");
    }
}

/// A set with fewer rows has every plan of one with more, so its plan need not cost more.
#[test]
fn fewer_rows_do_not_make_a_plan_dearer() {
    let of = |planner| {
        let model = planning(turning(), planner, &[0], QUICK);
        let comparison = super::compared(&model);
        // The second pass exchanges cost for comfort.
        let found = last(&comparison).plainer.as_deref().unwrap_or(solved(last(&comparison)));
        (found.objective, found.outside[0].max_violation)
    };
    let (rip, rsp, rcp) = (of(PlannerKind::Rip), of(PlannerKind::Rsp), of(PlannerKind::Rcp));
    assert!(rcp.1 <= VIOLATED && rip.1 > VIOLATED, "{rip:?} {rcp:?}");
    // Plans are local optima, so the order holds up to the tolerance of the cost phase.
    assert!(rip.0 <= 1.01 * rsp.0 && rsp.0 <= 1.01 * rcp.0, "{rip:?} {rsp:?} {rcp:?}");
}

/// Where steps begin should matter little for the cost at which they end.
#[test]
fn plans_cost_the_same_wherever_steps_begin() {
    let model = planning(turning(), PlannerKind::Rip, &[], MissionTime::Fixed(6.0));
    let healthy = AdmissibleSet::healthy(&model);
    let set = healthy_set(&model);
    let mut engine = HoverPlanner::new(Problem::of(&model).unwrap(), &healthy);
    let mut steps = ScpPlanner::new(&mut engine, WrenchModel::Exact, &set);
    let shortest = steps.shortest(&[], None).unwrap().planned;
    let [anew, begun] = [vec![], vec![&shortest]].map(|initial_guesses| match steps.decide(6.0, &initial_guesses) {
        Decision::Feasible(planned) => planned.objective,
        other => panic!("{other:?}"),
    });
    assert!((anew / begun).ln().abs() < 0.1, "{anew}, and {begun} begun from another plan");
}

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    /// Few waypoints and many samples make stiff splines: a fine grid must still give what a coarse one gives, or
    /// better.
    #[test]
    #[ignore = "long"]
    fn fine_grids_are_no_dearer_than_coarse_ones() {
        let hop = || {
            let mut hop = mission(vec![
                waypoint([0.0, 0.0, 1.0], 0.0),
                waypoint([3.0, 2.0, 2.0], 0.0),
                waypoint([6.0, 0.0, 1.0], 0.0),
                waypoint([6.0, 4.0, 1.0], 0.0),
            ]);
            hop.waypoints[1..=2].iter_mut().for_each(|w| w.within = 0.2);
            hop
        };
        // High, far and slow: a small cost, which the solver's digits must still tell.
        let lift = || {
            let mut lift = mission(vec![
                waypoint([0.0, 0.0, 1.0], 0.0),
                waypoint([0.0, 0.0, 31.0], 0.0),
                waypoint([60.0, 0.0, 31.0], 0.0),
                waypoint([60.0, 30.0, 11.0], 0.0),
            ]);
            lift.waypoints[2].within = 0.5;
            lift
        };
        let objective = |mission: &Mission, time: f64, samples: usize| {
            let mut model = planning(mission.clone(), PlannerKind::Rsp, &[0], MissionTime::Fixed(time));
            model.plan.samples = samples;
            solved(last(&super::super::compared(&model))).objective
        };
        for (mission, time) in [(hop(), 3.6), (lift(), 16.0)] {
            let (coarse, fine) = (objective(&mission, time, 48), objective(&mission, time, 200));
            assert!(fine <= 1.01 * coarse, "{fine} with 200 samples and {coarse} with 48 in {time} s");
        }
    }
}
