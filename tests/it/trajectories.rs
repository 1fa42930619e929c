//! Polynomials, attitude, crossings, allocation and the table, each against a second way to the same number.

mod rates;

use crate::vehicles::{hexacopter, inspection, lost, octocopter, paper_case, quadcopter, ring_model};
use mavc::actuation::{Actuation, Wrench};
use mavc::admissible::AdmissibleSet;
use mavc::admissible::allocation::Allocator;
use mavc::admissible::row::{SetRow, VIOLATED};
use mavc::flatness::{self, FlatState};
use mavc::model::{Model, PlannerKind, Problem};
use mavc::motion::checks::{limit_violations, peak};
use mavc::motion::hover_map::ORDER;
use mavc::motion::outside::outside;
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, Trajectory, roll_pitch, tilt};
use mavc::planner::hover::{Decision, HoverPlanner};
use mavc::planner::scp::ScpPlanner;
use mavc::planner::selection::PlanningSet;
use mavc::planner::working_set::WorkingSet;
use mavc::qp::RowOrigin;
use mavc::qp::build::{Affine, Builder};
use mavc::report::trajectory_csv::{self, render};
use mavc::solve::{Outcome, solve};
use nalgebra::{Rotation3, Vector3};
use proptest::prelude::*;

fn factorial(n: usize) -> f64 {
    (1..=n).map(|i| i as f64).product()
}

/// A trajectory from its start, steps and inputs, integrated by Taylor's formula with a linear input.
fn integrated(start: NodeState, steps: &[f64], inputs: &[[f64; 4]], model: WrenchModel) -> Trajectory {
    let mut nodes = vec![start];
    let mut times = vec![0.0];
    for (axis, &r) in ORDER.iter().enumerate() {
        nodes[0][axis][r] = inputs[0][axis];
    }
    for (k, h) in steps.iter().enumerate() {
        let mut next = NodeState::default();
        for (axis, &r) in ORDER.iter().enumerate() {
            let (from, u) = (nodes[k][axis], inputs[k + 1][axis]);
            for (i, derivative) in next[axis][..r].iter_mut().enumerate() {
                *derivative = (i..=r).map(|j| from[j] * h.powi((j - i) as i32) / factorial(j - i)).sum::<f64>()
                    + (u - from[r]) * h.powi((r - i) as i32) / factorial(r + 1 - i);
            }
            next[axis][r] = u;
        }
        nodes.push(next);
        times.push(times[k] + h);
    }
    let waypoint_nodes = vec![0, steps.len() / 2, steps.len()];
    Trajectory { times, nodes, waypoint_nodes, model }
}

fn trajectory() -> impl Strategy<Value = Trajectory> {
    let start = prop::array::uniform4(prop::array::uniform4(-1.0..1.0f64)).prop_map(|s| {
        let mut state = NodeState::default();
        for (axis, &r) in ORDER.iter().enumerate() {
            state[axis][..r].copy_from_slice(&s[axis][..r]);
        }
        state
    });
    let free = prop_oneof![(-3.0..3.0f64).prop_map(WrenchModel::HoverAt), Just(WrenchModel::HoverFollowing)];
    (2usize..12, start, free).prop_flat_map(|(n, start, free)| {
        let steps = prop::collection::vec(0.02..0.5f64, n);
        let inputs = prop::collection::vec((-400.0..400.0f64, -400.0..400.0f64, -9.0..9.0f64, -4.0..4.0f64), n + 1);
        (steps, inputs).prop_map(move |(steps, inputs)| {
            let inputs: Vec<[f64; 4]> = inputs.into_iter().map(|(a, b, c, d)| [a, b, c, d]).collect();
            integrated(start, &steps, &inputs, free)
        })
    })
}

/// The rows of a mode's set (0 lost rotors: the healthy one).
fn rows(model: &Model, rotors: &[usize]) -> Vec<SetRow> {
    let mut model = model.clone();
    model.modes = vec![lost(&model, rotors)];
    let healthy = AdmissibleSet::healthy(&model);
    PlanningSet::of(&[&AdmissibleSet::of_mode(&model, 0)], &healthy).rows
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn evaluation_integrates_and_takes_right_limits(flight in trajectory(), share in 0.05..0.95f64) {
        let last = flight.intervals();
        for k in 0..last {
            let h = flight.times[k + 1] - flight.times[k];
            let (begin, end) = (flight.within(k, 0.0), flight.within(k, h));
            prop_assert_eq!(flight.at(flight.times[k]), begin, "a node belongs to the interval on its right");
            let (t, d) = (share * h, 1e-4 * h);
            let (before, here, after) = (flight.within(k, t - d), flight.within(k, t), flight.within(k, t + d));
            let by_time = flight.at(flight.times[k] + t);
            for (axis, &r) in ORDER.iter().enumerate() {
                for i in 0..=r {
                    let size = 1.0 + flight.nodes[k][axis][i].abs() + flight.nodes[k + 1][axis][i].abs();
                    prop_assert!((begin[axis][i] - flight.nodes[k][axis][i]).abs() <= 1e-14 * size);
                    prop_assert!((end[axis][i] - flight.nodes[k + 1][axis][i]).abs() < 1e-10 * size);
                    prop_assert!((by_time[axis][i] - here[axis][i]).abs() < 1e-9 * size * 400.0);
                    // Each order is the slope of the one below.
                    if i < 4 {
                        let slope = (after[axis][i] - before[axis][i]) / (2.0 * d);
                        let size = 1.0 + here[axis][i + 1].abs() + size / h;
                        prop_assert!((slope - here[axis][i + 1]).abs() < 1e-5 * size, "{axis} {i}: {slope}");
                    }
                }
            }
        }
        // The end: left limits, and clamped beyond.
        let end = flight.at(flight.duration());
        let h = flight.times[last] - flight.times[last - 1];
        let slope = (flight.nodes[last][2][2] - flight.nodes[last - 1][2][2]) / h;
        prop_assert!((end[2][3] - slope).abs() < 1e-12 * (1.0 + slope.abs()));
        prop_assert_eq!(flight.at(flight.duration() + 1.0), end);
        prop_assert_eq!(flight.at(-1.0), flight.at(0.0));
    }

    /// The third column of Rz(psi) Ry(theta) Rx(phi) is the thrust's direction, even for thrust pointing down.
    #[test]
    fn attitude_points_the_thrust(a in prop::array::uniform3(-20.0..20.0f64), psi in -9.0..9.0f64) {
        let mut state = NodeState::default();
        for (axis, value) in a.iter().enumerate() {
            state[axis][2] = *value;
        }
        state[3][0] = psi;
        let direction = Vector3::new(a[0], a[1], a[2] + 9.81);
        prop_assume!(direction.norm() > 1e-3);
        let (roll, pitch) = roll_pitch(&state, &mavc::model::Environment::vacuum(9.81));
        // from_euler_angles(roll, pitch, yaw) is Rz Ry Rx.
        let up = Rotation3::from_euler_angles(roll, pitch, psi) * Vector3::z();
        prop_assert!((up - direction.normalize()).norm() < 1e-12);
        prop_assert!((tilt(&state, &mavc::model::Environment::vacuum(9.81)) - direction.angle(&Vector3::z())).abs() < 1e-7);
    }

    #[test]
    fn crossings_agree_with_dense_sampling(flight in trajectory(), rotor in 0usize..9) {
        const DENSE: usize = 1024;
        let model = octocopter("PPNNPPNN");
        let lost: Vec<usize> = (1..=8).filter(|k| *k == rotor).collect();
        let rows = rows(&model, &lost);
        let found = outside(&flight, &model.vehicle, &model.environment(), &rows);
        let excess = |s: &NodeState| {
            let w = flight.wrench(&model.vehicle, &model.environment(), s);
            rows.iter().map(|r| r.violation(&w)).fold(f64::NEG_INFINITY, f64::max)
        };
        let (mut seconds, mut last, mut crossings) = (0.0, None, 0);
        let mut was = None;
        for k in 0..flight.intervals() {
            let h = flight.times[k + 1] - flight.times[k];
            for i in 0..DENSE {
                let t = h * (i as f64 + 0.5) / DENSE as f64;
                let out = excess(&flight.within(k, t)) > VIOLATED;
                crossings += usize::from(was.is_some_and(|w| w != out));
                was = Some(out);
                if out {
                    seconds += h / DENSE as f64;
                    last = Some(flight.times[k] + t);
                }
            }
        }
        let grain = 0.5 / DENSE as f64;
        // Under a changing yaw the wrench is not linear; violations shorter than a sixteenth of an interval may be
        // missed.
        let blind = if flight.model == WrenchModel::HoverFollowing { 0.5 / 16.0 } else { 0.0 };
        let slack = (grain + blind) * (crossings + 1) as f64;
        prop_assert!((found.seconds - seconds).abs() <= slack, "{} {seconds}", found.seconds);
        // At the end of the last violation a row is exactly at its bound, and no row is violated later.
        if blind == 0.0 {
            prop_assert!(found.last.unwrap_or(-1.0) + 1e-9 >= last.unwrap_or(-1.0), "{:?} {last:?}", found.last);
        }
        if let Some(t) = found.last {
            let k = flight.times[..flight.intervals()].iter().rposition(|s| *s < t).unwrap_or(0);
            prop_assert!(excess(&flight.within(k, t - flight.times[k])) > VIOLATED - 1e-7);
        }
        // Counts at the nodes.
        let wrenches: Vec<Wrench> = flight.node_wrenches(&model.vehicle, &model.environment());
        let over: Vec<Vec<bool>> =
            wrenches.iter().map(|w| rows.iter().map(|r| r.violation(w) > VIOLATED).collect()).collect();
        prop_assert_eq!(found.positions, over.iter().filter(|o| o.contains(&true)).count());
        prop_assert_eq!(found.rows, over.iter().flatten().filter(|o| **o).count());
        let facets: Vec<usize> = (0..rows.len()).filter(|&i| over.iter().any(|o| o[i])).collect();
        prop_assert_eq!(found.facets, facets);
        let at_nodes = flight.nodes.iter().map(excess).fold(f64::NEG_INFINITY, f64::max);
        let dense = (0..flight.intervals())
            .flat_map(|k| {
                let h = flight.times[k + 1] - flight.times[k];
                (0..=DENSE).map(move |i| (k, h * i as f64 / DENSE as f64))
            })
            .map(|(k, t)| excess(&flight.within(k, t)))
            .fold(at_nodes, f64::max);
        let rounding = 1e-9 * (1.0 + dense.abs());
        prop_assert!(found.max_violation >= at_nodes - rounding);
        // The peak lies between two of the dense samples.
        prop_assert!(found.max_violation <= dense + 1e-4 * (1.0 + dense.abs()), "{} {dense}", found.max_violation);
        if flight.model != WrenchModel::HoverFollowing {
            // A wrench that is linear between nodes is worst at one of them.
            prop_assert!((found.max_violation - at_nodes).abs() <= rounding);
        }
    }

    #[test]
    fn peaks_are_not_below_any_sample(flight in trajectory()) {
        let found = peak(&flight, |s| tilt(s, &mavc::model::Environment::vacuum(9.81)));
        let dense = (0..=5000).map(|i| tilt(&flight.at(flight.duration() * f64::from(i) / 5000.0), &mavc::model::Environment::vacuum(9.81)));
        let highest = dense.fold(0.0, f64::max);
        prop_assert!(found.value > highest - 0.02, "{} {highest}", found.value);
        prop_assert!((tilt(&flight.at(found.at), &mavc::model::Environment::vacuum(9.81)) - found.value).abs() < 1e-4 || found.at == flight.duration());
    }

    /// F is best exactly when it is feasible and F.(F' - F) >= 0 for every feasible F'.
    #[test]
    fn allocation_is_the_smallest_that_gives_the_wrench(
        which in 0usize..4,
        share in prop::collection::vec(prop_oneof![1 => Just(0.0), 1 => Just(1.0), 3 => 0.0..1.0f64], 12),
        idle in prop_oneof![1 => Just(vec![0.0; 12]), 1 => prop::collection::vec(0.0..0.5f64, 12)],
    ) {
        let mut model = [
            quadcopter(),
            hexacopter("PPNNPN"),
            octocopter("PPNNPPNN"),
            ring_model("PNPNPNPNPNPN", 3.0, [0.1; 3], 8e-6, 1.3e-7, 900.0),
        ][which]
            .clone();
        let actuation = Actuation::of(&model.vehicle);
        let most: Vec<f64> = model.vehicle.rotors.iter().map(mavc::model::Rotor::max_thrust).collect();
        let n = most.len();
        model.vehicle.rotors.iter_mut().zip(&idle).for_each(|(r, share)| r.min_speed = share.sqrt() * r.max_speed);
        let least: Vec<f64> = (0..n).map(|k| idle[k] * most[k]).collect();
        let given: Vec<f64> = (0..n).map(|k| least[k] + share[k] * (most[k] - least[k])).collect();
        let produced = |f: &[f64]| {
            (0..n).fold(Wrench::zeros(), |w, k| w + actuation.full(k) * (f[k] / most[k]))
        };
        let w = produced(&given);
        let allocator = Allocator::new(&model.vehicle);
        let best = allocator.thrusts(&w);
        let scale = Wrench::new(10.0, 1.0, 1.0, 0.1);
        let miss = (produced(&best) - w).component_div(&scale).amax();
        prop_assert!(miss < 1e-8, "asked {w} given {}", produced(&best));
        prop_assert!(best.iter().zip(&most).zip(&least).all(|((f, m), l)| *f >= l * (1.0 - 1e-12) && *f <= m * (1.0 + 1e-12)));
        let ascent: f64 = best.iter().zip(&given).map(|(b, g)| b * (g - b)).sum();
        prop_assert!(ascent > -1e-6, "{ascent}");
        for (speed, (f, r)) in allocator.speeds(&w).iter().zip(best.iter().zip(&model.vehicle.rotors)) {
            prop_assert!((speed * speed * r.thrust_coefficient - f).abs() < 1e-9 && *speed <= r.max_speed * (1.0 + 1e-12));
        }

        let mut builder = Builder::new(n);
        for (k, limit) in most.iter().enumerate() {
            builder.product(k, k, 1.0);
            builder.nonnegative(Affine::term(k, 1.0).plus_constant(-least[k]), RowOrigin::Overshoot);
            builder.nonnegative(Affine::term(k, -1.0).plus_constant(*limit), RowOrigin::Overshoot);
        }
        for i in 0..4 {
            let terms = (0..n).map(|k| (k, actuation.full(k)[i] / most[k] / scale[i])).collect();
            builder.zero(Affine { terms, constant: -w[i] / scale[i] }, RowOrigin::Overshoot);
        }
        let program = builder.finish();
        if let Outcome::Solved(s) = solve(&program).0 {
            let apart = s.x.iter().zip(&best).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            prop_assert!(apart < 1e-3, "{:?} {best:?}", s.x);
            prop_assert!((s.objective - program.objective(&best)).abs() < 1e-4 * (1.0 + s.objective));
        } else {
            // A wrench on the boundary leaves the program no inner point.
            prop_assert!(share[..n].iter().filter(|s| **s == 0.0 || **s == 1.0).count() >= 3);
        }
    }
}

fn planned(problem: Problem, total: f64) -> Trajectory {
    let model = problem.model();
    let healthy = AdmissibleSet::healthy(model);
    let set = PlanningSet::of(&[&healthy], &healthy);
    let mut engine = HoverPlanner::new(problem, &healthy);
    match engine.decide(total, model.plan.samples, &set, &mut WorkingSet::default()) {
        Decision::Feasible(planned) => planned.trajectory(),
        other => panic!("{other:?}"),
    }
}

const HEADER: &str = "t,x,y,z,yaw,vx,vy,vz,yaw_rate,ax,ay,az,yaw_acc,jx,jy,jz,sx,sy,sz,roll,pitch,thrust,tau_x,tau_y,\
tau_z,omega_1,omega_2,omega_3,omega_4,omega_5,omega_6,omega_7,omega_8,waypoint";

/// The cells, each shown to be the shortest text of its number.
fn table(text: &str) -> Vec<Vec<f64>> {
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some(HEADER));
    assert!(text.ends_with('\n') && !text.contains('\r') && !text.contains("-0,"));
    let number = |cell: &str| {
        let v: f64 = cell.parse().unwrap();
        assert!(v.is_finite());
        let digits = |s: &str| s.split('e').next().unwrap().chars().filter(char::is_ascii_digit).count();
        assert!(cell == format!("{v}") || cell == format!("{v:e}") && digits(cell) <= 17, "{cell}");
        v
    };
    let rows: Vec<Vec<f64>> = lines.map(|l| l.split(',').map(number).collect()).collect();
    assert!(rows.iter().all(|r| r.len() == HEADER.split(',').count()));
    rows
}

#[test]
fn the_table_is_what_was_planned() {
    let mut model = paper_case(PlannerKind::Rip, &[]);
    model.plan.samples = 100;
    let flight = planned(Problem::of(&model).unwrap(), 20.0);
    let text = render(&flight, &model, None);
    let rows = table(&text);
    assert_eq!(rows.len(), 101);
    let actuation = Actuation::of(&model.vehicle);
    for (k, row) in rows.iter().enumerate() {
        let s = flight.at(flight.times[k]);
        assert_eq!(row[0], flight.times[k]);
        for axis in 0..4 {
            for order in 0..3 {
                assert_eq!(row[1 + axis + 4 * order], s[axis][order], "numbers survive the way through text");
            }
            if axis < 3 {
                assert_eq!((row[13 + axis], row[16 + axis]), (s[axis][3], if axis < 2 { s[axis][4] } else { 0.0 }));
            }
        }
        let w = flight.wrench(&model.vehicle, &model.environment(), &s);
        assert_eq!(row[21..25], [w[0], w[1], w[2], w[3]]);
        // The speeds give the wrench.
        let by_speeds =
            (0..8).fold(Wrench::zeros(), |sum, i| sum + actuation.effectiveness.column(i) * row[25 + i].powi(2));
        assert!((by_speeds - w).amax() < 1e-5, "row {k}: {by_speeds} {w}");
        assert!(row[25..33].iter().all(|o| (0.0..=874.0 + 1e-9).contains(o)));
    }
    assert_eq!(rows[100][0], 20.0);
    assert_eq!(render(&flight, &model, None), text);
}

#[test]
fn the_table_has_what_an_exact_wrench_depends_on() {
    let mut model = paper_case(PlannerKind::Rip, &[]);
    model.plan.samples = 100;
    let healthy = AdmissibleSet::healthy(&model);
    let set = PlanningSet::of(&[&healthy], &healthy);
    let mut engine = HoverPlanner::new(Problem::of(&model).unwrap(), &healthy);
    let Decision::Feasible(planned) = ScpPlanner::new(&mut engine, WrenchModel::Exact, &set).decide(26.0, &[]) else {
        panic!("no plan")
    };
    let rows = table(&render(&planned.trajectory(), &model, None));
    for pair in rows.windows(2) {
        // Snap is linear between the nodes, so jerk changes by its mean.
        let (change, mean) = (pair[1][15] - pair[0][15], 0.5 * (pair[0][18] + pair[1][18]));
        assert!((change - mean * (pair[1][0] - pair[0][0])).abs() < 1e-6 * (1.0 + change.abs()), "{change} {mean}");
    }
    for row in &rows {
        let state = [9, 10, 11, 13, 14, 15, 16, 17, 18, 4, 8, 12].map(|column| row[column]);
        let wrench = flatness::wrench(&model.vehicle, model.gravity, &FlatState::from(state));
        assert!((0..4).all(|i| (wrench[i] - row[21 + i]).abs() < 1e-9), "{wrench} {row:?}");
    }
}

#[test]
fn yaw_is_continuous_past_half_a_turn() {
    let mut model = octocopter("PPNNPPNN");
    model.plan.samples = 80;
    let mut turning = inspection();
    for (w, yaw) in turning.waypoints.iter_mut().zip([2.5, 3.5, 4.2, 5.5]) {
        w.yaw = yaw;
    }
    model.mission = Some(turning);
    let flight = planned(Problem::of(&model).unwrap(), 32.0);
    let rows = table(&render(&flight, &model, Some(50.0)));
    assert!(rows.windows(2).all(|w| (w[1][4] - w[0][4]).abs() < 0.05));
    assert!((rows[0][4] - 2.5).abs() < 0.06 && (rows[rows.len() - 1][4] - 5.5).abs() < 0.06);
    // The limit on speed holds at nodes; its violation between them is small and reported.
    let fastest = rows.iter().map(|r| Vector3::new(r[5], r[6], r[7]).norm()).fold(0.0, f64::max);
    let excess = limit_violations(&flight, &model, 1e-9);
    let by = excess.first().map_or(0.0, |e| e.by);
    assert!(fastest <= 6.0 + by + 1e-6 && by < 0.05, "{fastest} {by}");
    assert!(excess.iter().all(|e| e.limit == 0 && (0.0..=32.0).contains(&e.at)));
}
