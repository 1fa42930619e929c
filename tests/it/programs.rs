//! Quadratic programs: what they hold, and what their solutions satisfy, from the program's data alone.

use crate::vehicles::{inspection, mission, octocopter, paper_case, viviani, waypoint};
use mavc::admissible::AdmissibleSet;
use mavc::model::{Leg, Mission, Model, PlannerKind, Problem};
use mavc::motion::hover_map::{ORDER, WrenchMap, YawState};
use mavc::motion::time_grid::{determined, earliest, time_grid};
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, Trajectory};
use mavc::planner::hover::{ACCEPTED, Decision, FEASIBLE, HoverPlanner, Planned};
use mavc::planner::selection::PlanningSet;
use mavc::planner::transcription::{Purpose, Transcription};
use mavc::planner::working_set::WorkingSet;
use mavc::qp::{QuadraticProgram, RowOrigin, Sparse};
use mavc::solve::{Outcome, Solution, residuals, solve};
use nalgebra::DMatrix;
use proptest::prelude::*;

/// RIP where `against` is empty, else RCP against all of it.
fn planning_set(model: &Model) -> (PlanningSet, AdmissibleSet) {
    let healthy = AdmissibleSet::healthy(model);
    let sets: Vec<AdmissibleSet> = model.plan.against.iter().map(|&i| AdmissibleSet::of_mode(model, i)).collect();
    let sets: Vec<&AdmissibleSet> = if sets.is_empty() { vec![&healthy] } else { sets.iter().collect() };
    (PlanningSet::of(&sets, &healthy), healthy)
}

fn full_program(problem: Problem, set: &PlanningSet, total: f64, purpose: Purpose) -> QuadraticProgram {
    let model = problem.model();
    let healthy = AdmissibleSet::healthy(model);
    let layout = HoverPlanner::new(problem, &healthy).layout(total, model.plan.samples).unwrap().unwrap();
    let maps = layout.yaw.maps(model, layout.flown.nodes());
    Transcription::new(problem, &layout.flown, set, &maps, layout.yaw.axes()).full_program(purpose)
}

fn decide(model: &Model, total: f64) -> Decision {
    let (set, healthy) = planning_set(model);
    HoverPlanner::new(Problem::of(model).unwrap(), &healthy).decide(
        total,
        model.plan.samples,
        &set,
        &mut WorkingSet::default(),
    )
}

fn planned(model: &Model, total: f64) -> Planned {
    match decide(model, total) {
        Decision::Feasible(planned) => *planned,
        other => panic!("no plan at {total} s: {other:?}"),
    }
}

fn solved(program: &QuadraticProgram) -> Solution {
    match solve(program).0 {
        Outcome::Solved(solution) => solution,
        other => panic!("{other:?}"),
    }
}

fn close(a: f64, b: f64, relative: f64) -> bool {
    (a - b).abs() <= relative * b.abs()
}

/// The solver's gap is relative to the objective without its constant, which is large.
fn gap(program: &QuadraticProgram) -> f64 {
    1.1e-8 * (1.0 + program.constant)
}

/// The program with every row: its optimality conditions, its known optimum, and row generation against it.
fn full_and_generated(against: &[usize], known: f64) {
    let model = paper_case(PlannerKind::Rcp, against);
    let (set, _) = planning_set(&model);
    // The known optimum meets every tolerance without slack.
    for slack in [0.0, FEASIBLE] {
        let program = full_program(Problem::of(&model).unwrap(), &set, 20.0, Purpose::Plan { slack });
        assert_eq!(program.row_origin.len(), program.b.len());
        let facet_rows = program.row_origin.iter().filter(|o| matches!(o, RowOrigin::Facet { .. })).count();
        assert_eq!(facet_rows, set.rows.len() * 201);
        let solution = solved(&program);
        let r = residuals(&program, &solution);
        assert!(r.primal < 1e-6 && r.dual < 1e-6 && r.stationarity < 1e-6, "{r:?}");
        assert!(r.complementarity < gap(&program), "{r:?}");
        let certain = solution.objective - solution.bound;
        assert!(certain.abs() < gap(&program), "{} {}", solution.bound, solution.objective);
        if slack == 0.0 {
            assert!(close(solution.objective, known, 1e-5), "{}", solution.objective);
            continue;
        }
        let found = planned(&model, 20.0);
        let apart = found.objective - solution.objective;
        assert!(apart.abs() < gap(&program), "{} {}", found.objective, solution.objective);
        assert!(found.rows < facet_rows / 4, "{} rows generated", found.rows);
        for w in found.trajectory().node_wrenches(&model.vehicle, &model.environment()) {
            assert!(set.rows.iter().all(|r| r.violation(&w) <= ACCEPTED));
        }
    }
}

// The objectives were computed once by an independent program (other language, other transcription).

#[test]
fn rip_at_20_s() {
    full_and_generated(&[], 2.9416513);
}

#[test]
fn rcp_against_all_single_losses_at_20_s() {
    full_and_generated(&[0, 1, 2, 3, 4, 5, 6, 7], 2.9418036);
}

#[test]
fn rcp_against_a_double_loss_at_20_s() {
    full_and_generated(&[8], 3.0417457);
}

#[test]
fn rip_at_24_s_steps_exactly_and_meets_every_waypoint() {
    let model = paper_case(PlannerKind::Rip, &[]);
    let found = planned(&model, 24.0);
    assert!(close(found.objective, 0.8386346, 1e-5), "{}", found.objective);
    steps_are_continuous(&found.trajectory());
    for (w, &node) in viviani().waypoints.iter().zip(&found.grid.waypoint_nodes) {
        let miss = (0..3).map(|i| (found.states[node][i][0] - w.position[i]).powi(2)).sum::<f64>().sqrt();
        assert!(miss <= w.within + 2.0 * FEASIBLE, "{miss}");
        assert!((found.states[node][3][0] - w.yaw).abs() <= w.yaw_within + 1e-6);
    }
    at_rest(&found.states[0], 0.0);
    at_rest(&found.states[200], 0.0);
}

/// The polynomial of each interval ends where the next begins.
fn steps_are_continuous(trajectory: &Trajectory) {
    for k in 0..trajectory.intervals() {
        let end = trajectory.within(k, trajectory.times[k + 1] - trajectory.times[k]);
        for (axis, &order) in ORDER.iter().enumerate() {
            let pairs = end[axis].iter().zip(&trajectory.nodes[k + 1][axis]);
            for (i, (a, b)) in pairs.take(order + 1).enumerate() {
                assert!((a - b).abs() < 1e-6 * (1.0 + b.abs()), "interval {k}, axis {axis}, order {i}: {a} {b}");
            }
        }
    }
}

/// Still, level, thrust m g; what the last derivative does is free.
fn at_rest(state: &NodeState, dust: f64) {
    for (axis, &order) in ORDER.iter().enumerate() {
        assert!((1..=order.min(3)).all(|i| state[axis][i].abs() <= dust), "axis {axis}: {state:?}");
    }
}

#[test]
fn too_short_is_infeasible() {
    for against in [&[][..], &[0]] {
        let model = paper_case(PlannerKind::Rcp, against);
        assert!(matches!(decide(&model, 15.0), Decision::Infeasible));
    }
    // What the verdict rests on, with every row.
    let model = paper_case(PlannerKind::Rip, &[]);
    let (set, _) = planning_set(&model);
    let program = full_program(Problem::of(&model).unwrap(), &set, 12.0, Purpose::Plan { slack: FEASIBLE });
    let Outcome::Infeasible { certificate } = solve(&program).0 else { panic!("12 s is far too short") };
    let bz: f64 = program.b.iter().zip(&certificate).map(|(b, z)| b * z).sum();
    let largest = program.a.transposed_times(&certificate).iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    assert!(bz < 0.0 && largest <= 1e-6 * -bz && program.dual_violation(&certificate) <= 1e-6 * -bz);
    // The overshoot that makes it feasible is well above nothing.
    let relaxed = full_program(Problem::of(&model).unwrap(), &set, 12.0, Purpose::Overshoot { epsilon: 1e-9 });
    let solution = solved(&relaxed);
    assert!(*solution.x.last().unwrap() > 0.01, "{:?}", solution.x.last());
}

#[test]
fn holds_fixed_times_and_yaw_are_planned_as_written() {
    let mut model = octocopter("PPNNPPNN");
    model.plan.samples = 120;
    let inspection = inspection();
    model.mission = Some(inspection.clone());
    let found = planned(&model, 32.0);
    let trajectory = found.trajectory();
    steps_are_continuous(&trajectory);
    assert_eq!(trajectory.model, WrenchModel::HoverFollowing);
    let p = &found.grid;
    assert_eq!(p.node_times[p.waypoint_nodes[2]], 18.0);
    let hold = p.segments.iter().find(|s| s.hold).unwrap();
    assert_eq!((hold.from, hold.duration), (1, 4.0));
    for node in hold.first_node..=hold.first_node + hold.intervals {
        let state = &found.states[node];
        at_rest(state, 1e-9);
        assert!(state[0][4] == 0.0 && state[1][4] == 0.0);
        let first = &found.states[hold.first_node];
        assert!((0..4).all(|a| (state[a][0] - first[a][0]).abs() < 1e-6));
    }
    for s in &found.states {
        assert!((0..3).map(|a| s[a][1].powi(2)).sum::<f64>().sqrt() <= 6.0 + 1e-6);
    }
    for (w, &node) in inspection.waypoints.iter().zip(&p.waypoint_nodes) {
        assert!((found.states[node][3][0] - w.yaw).abs() <= w.yaw_within + 1e-6);
    }
}

/// A smooth motion in closed form: the derivative of order i of sum a sin(w t + p).
fn waves(parts: &[(f64, f64, f64)], t: f64, order: i32) -> f64 {
    let quarter = std::f64::consts::FRAC_PI_2 * f64::from(order);
    parts.iter().map(|(a, w, p)| a * w.powi(order) * (w * t + p + quarter).sin()).sum()
}

#[test]
fn the_wrench_map_follows_a_turning_yaw() {
    let vehicle = octocopter("PPNNPPNN").vehicle;
    let g = 9.81;
    let motion: [&[(f64, f64, f64)]; 4] = [
        &[(3.0, 1.1, 0.2), (0.5, 2.3, 1.0)],
        &[(2.0, 0.9, 1.7), (0.7, 1.9, 0.4)],
        &[(1.0, 1.3, 0.0)],
        &[(1.5, 0.8, 0.3), (0.4, 2.1, 2.0)],
    ];
    // Roll and pitch angles of the linear model, and their second derivatives by central differences (O(h^4)).
    let angles = |t: f64| {
        let (s, c) = waves(motion[3], t, 0).sin_cos();
        let (x, y) = (waves(motion[0], t, 2), waves(motion[1], t, 2));
        [(s * x - c * y) / g, (c * x + s * y) / g]
    };
    let second = |i: usize, t: f64| {
        let h = 1e-3;
        let a = |k: f64| angles(t + k * h)[i];
        (-a(2.0) + 16.0 * a(1.0) - 30.0 * a(0.0) + 16.0 * a(-1.0) - a(-2.0)) / (12.0 * h * h)
    };
    for t in [0.0, 0.37, 1.2, 2.9, 7.7] {
        let state: NodeState = motion.map(|m| std::array::from_fn(|i| waves(m, t, i as i32)));
        let [psi, rate, acceleration, ..] = state[3];
        let w = WrenchMap::new(&vehicle, g, YawState { psi, rate, acceleration }).at(&state);
        let [ixx, iyy, izz] = vehicle.inertia;
        let expected = [vehicle.mass * (g + state[2][2]), ixx * second(0, t), iyy * second(1, t), izz * acceleration];
        for i in 0..4 {
            assert!((w[i] - expected[i]).abs() < 1e-6 * (1.0 + expected[i].abs()), "{i} at {t}: {w} {expected:?}");
        }
        // At one instant of a constant yaw both maps say the same.
        let still = WrenchMap::new(&vehicle, g, YawState { psi, ..YawState::default() }).at(&state);
        let free = WrenchMap::with_free_yaw(&vehicle, g, psi).at(&state);
        assert!((free - still).rows(0, 3).amax() < 1e-12 && (free[3] - w[3]).abs() < 1e-12);
    }
}

/// Missions with holds and fixed times in order, and a total that may or may not suffice.
fn timed_mission() -> impl Strategy<Value = (Mission, f64, usize)> {
    let point = (prop_oneof![2 => Just(0.0), 1 => 0.1..5.0f64], prop::option::weighted(0.3, 0.2..9.0f64), 0.1..4.0f64);
    (prop::collection::vec(point, 2..9), -3.0..30.0f64, 1usize..80).prop_map(|(points, more, samples)| {
        let mut all = mission(points.iter().map(|_| waypoint([0.0; 3], 0.0)).collect());
        let mut at = 0.0;
        for (i, (hold, gap, share)) in points.iter().enumerate() {
            all.waypoints[i].hold = *hold;
            if let (Some(gap), true) = (gap, i > 0) {
                at += gap;
                all.waypoints[i].time = Some(at);
            }
            at += hold;
            if let Some(leg) = all.legs.get_mut(i) {
                *leg = Leg { share: *share };
            }
        }
        let total = determined(&all).unwrap_or(earliest(&all) + more);
        (all, total, samples)
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn profiles_keep_what_the_mission_says((mission, total, samples) in timed_mission()) {
        let points = &mission.waypoints;
        let last = points.len() - 1;
        let Some(p) = time_grid(&mission, total, samples) else {
            // Holds fill the time between some two fixed times.
            let mut from = 0;
            let mut leave = 0.0;
            let mut squeezed = false;
            for (i, w) in points.iter().enumerate().skip(1) {
                let arrival = w.time.or((i == last).then_some(total - w.hold));
                if let Some(arrival) = arrival {
                    squeezed |= arrival - leave - points[from..i].iter().map(|w| w.hold).sum::<f64>() <= 1e-12;
                    (from, leave) = (i, arrival);
                }
            }
            prop_assert!(squeezed, "refused though every leg has time");
            return Ok(());
        };
        let holds = points.iter().filter(|w| w.hold > 0.0).count();
        prop_assert_eq!(p.segments.len(), mission.legs.len() + holds);
        prop_assert!(p.segments.iter().all(|s| s.intervals >= 1 && s.duration > 0.0));
        let intervals: usize = p.segments.iter().map(|s| s.intervals).sum();
        prop_assert_eq!(intervals, samples.max(p.segments.len()));
        prop_assert_eq!(p.intervals(), intervals);
        prop_assert!(p.node_times.windows(2).all(|w| w[0] < w[1]));
        prop_assert_eq!(p.node_times[0], 0.0);
        prop_assert_eq!(p.node_times[intervals], total);
        prop_assert!((p.steps().sum::<f64>() - total).abs() < 1e-9 * total.max(1.0));
        for (k, step) in p.steps().enumerate() {
            prop_assert!((p.node_times[k + 1] - p.node_times[k] - step).abs() < 1e-9 * total.max(1.0));
        }
        // A hold takes one interval; legs get a fair share of the others, unless they need more.
        prop_assert!(p.segments.iter().all(|s| !s.hold || s.intervals == 1));
        let legs: Vec<_> = p.segments.iter().filter(|s| !s.hold).collect();
        let need = |from: usize| mission.least_intervals(from);
        let enough = legs.iter().map(|s| need(s.from)).sum::<usize>() + holds <= samples;
        let least = |from: usize| if enough { need(from) } else { 1 };
        let above: Vec<_> = legs.iter().filter(|s| s.intervals > least(s.from)).collect();
        for s in &legs {
            prop_assert!(s.intervals >= least(s.from));
            for longer in above.iter().filter(|l| l.duration <= s.duration) {
                prop_assert!(s.intervals + 1 >= longer.intervals.min(s.intervals + 2), "the longer leg has fewer");
            }
        }
        let time: f64 = above.iter().map(|s| s.duration).sum();
        let shared: usize = above.iter().map(|s| s.intervals).sum();
        for s in &above {
            let fair = s.duration / time * shared as f64;
            // A leg with just its least may have been due up to one more by its duration, which went to these.
            let passed_on = (legs.len() - above.len()) as f64 * s.duration / time;
            let off = (s.intervals as f64 - fair).abs();
            prop_assert!(off < 1.0 + passed_on + 1e-6 * fair, "{} for {fair}", s.intervals);
        }
        prop_assert_eq!(p.waypoint_nodes.len(), points.len());
        let arrival = |i: usize| p.node_times[p.waypoint_nodes[i]];
        for (i, w) in points.iter().enumerate() {
            if let Some(t) = w.time {
                prop_assert_eq!(arrival(i), t);
            }
            let hold = p.segments.iter().find(|s| s.hold && s.from == i);
            prop_assert_eq!(hold.map_or(0.0, |s| s.duration), w.hold);
            if let Some(s) = hold {
                prop_assert_eq!(s.first_node, p.waypoint_nodes[i]);
            }
        }
        // Legs that no fixed time parts share time in proportion.
        let legs: Vec<_> = p.segments.iter().filter(|s| !s.hold).collect();
        for i in 1..legs.len() {
            if points[i].time.is_none() {
                let (a, b) = (legs[i - 1].duration / mission.legs[i - 1].share, legs[i].duration / mission.legs[i].share);
                prop_assert!((a - b).abs() < 1e-9 * a.max(b));
            }
        }
    }

    #[test]
    fn sparse_matrices_are_the_sum_of_their_entries(
        entries in prop::collection::vec((0usize..6, 0usize..5, -3.0..3.0f64), 0..60),
        x in prop::collection::vec(-1.0..1.0f64, 5),
        y in prop::collection::vec(-1.0..1.0f64, 6),
    ) {
        let sparse = Sparse::from_entries(6, 5, &entries);
        let mut dense = DMatrix::<f64>::zeros(6, 5);
        for &(r, c, v) in &entries {
            dense[(r, c)] += v;
        }
        prop_assert_eq!((sparse.colptr.len(), sparse.colptr[5]), (6, sparse.rowval.len()));
        let mut seen = DMatrix::<f64>::zeros(6, 5);
        for c in 0..5 {
            let rows = &sparse.rowval[sparse.colptr[c]..sparse.colptr[c + 1]];
            prop_assert!(rows.windows(2).all(|w| w[0] < w[1]), "rows ascend, each once");
            for (&r, v) in rows.iter().zip(&sparse.nzval[sparse.colptr[c]..]) {
                seen[(r, c)] = *v;
            }
        }
        prop_assert!((&seen - &dense).amax() < 1e-12);
        let mut product = vec![1.0; 6];
        sparse.multiply_into(&x, &mut product);
        let expected = &dense * DMatrix::from_column_slice(5, 1, &x);
        prop_assert!(product.iter().zip(expected.iter()).all(|(a, b)| (a - 1.0 - b).abs() < 1e-12));
        let expected = dense.transpose() * DMatrix::from_column_slice(6, 1, &y);
        prop_assert!(sparse.transposed_times(&y).iter().zip(expected.iter()).all(|(a, b)| (a - b).abs() < 1e-12));
    }
}
