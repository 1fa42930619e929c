//! A drag for each axis of the body, against the equation of motion itself, rigid bodies, differences and closed forms.

use crate::cli::mavc;
use crate::vehicles::{lost, mission, octocopter, waypoint};
use mavc::actuation::Wrench;
use mavc::admissible::airspeed::Airspeed;
use mavc::admissible::{AdmissibleSet, mass_at_rest, trimmed};
use mavc::certificate::DynamicModel;
use mavc::flatness::{self, FlatState, rotor_drag};
use mavc::flight::body::{Body, Frame};
use mavc::model::{Environment, MissionTime, Model, PlanModel, PlannerKind, Problem, Vehicle};
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{CommandState, NodeState, X, Y, YAW, Z, in_air};
use mavc::planner::selection::sets::PlanningSets;
use mavc::planner::stop::Stops;
use mavc::planner::studies::{PlanOutcome, Scope, run_planners};
use mavc::planner::timing::kinematics::least_time_within;
use mavc::verify::interval::Interval;
use mavc::verify::wrench::{Dynamics, Held};
use mavc::{Compiler, Spec};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use std::f64::consts::FRAC_PI_2;

/// The rates (1/s) along x, y and z: equal along x and y, and different along all three.
const RATES: [[f64; 3]; 2] = [[0.2, 0.2, 0.11], [0.17, 0.31, 0.09]];

fn air(drag_rates: [f64; 3]) -> Environment {
    Environment { gravity: 9.81, drag_rates, wind: [4.0, -2.0, 0.7], wind_spread: [0.0; 3], yaw_at_rest: 0.4 }
}

/// Oscillations on each axis and their derivatives: amplitude (m, rad), rate (rad/s), phase.
fn waving<const N: usize>(t: f64) -> [[f64; N]; 4] {
    const WAVES: [(f64, f64, f64); 4] = [(2.2, 1.3, 0.2), (1.4, 1.7, 1.9), (1.1, 1.5, 4.0), (0.8, 1.1, 0.7)];
    std::array::from_fn(|axis| {
        let (amplitude, rate, phase) = WAVES[axis];
        std::array::from_fn(|order| {
            amplitude * rate.powi(order as i32) * (rate * t + phase + FRAC_PI_2 * order as f64).sin()
        })
    })
}

fn order(state: &NodeState, order: usize) -> Vector3<f64> {
    Vector3::new(state[X][order], state[Y][order], state[Z][order])
}

/// The force of the rotors over mass for an attitude: `a + g e_z + R K R' (v - w)`.
fn force(environment: &Environment, state: &NodeState, r: &Matrix3<f64>) -> Vector3<f64> {
    let k = Matrix3::from_diagonal(&Vector3::from(environment.drag_rates));
    let air = order(state, 1) - Vector3::from(environment.wind);
    order(state, 2) + Vector3::z() * environment.gravity + r * k * r.transpose() * air
}

/// The attitude with the yaw of a state whose third axis is along the force, iterated until both agree.
fn iterated(environment: &Environment, state: &NodeState) -> Matrix3<f64> {
    let (s, c) = state[YAW][0].sin_cos();
    let left = Vector3::new(-s, c, 0.0);
    let mut r = Matrix3::identity();
    for _ in 0..200 {
        let b3 = force(environment, state, &r).normalize();
        let b1 = left.cross(&b3).normalize();
        let next = Matrix3::from_columns(&[b1, b3.cross(&b1), b3]);
        let change = (next - r).amax();
        r = next;
        if change < 1e-15 {
            break;
        }
    }
    r
}

fn vehicle() -> Vehicle {
    Vehicle { inertia: [0.021, 0.034, 0.052], ..octocopter("PPNNPPNN").vehicle }
}

/// Thrust from the equation of motion, torques from Euler's equation with differences of the attitude.
#[test]
fn the_wrench_solves_the_equations_of_motion() {
    let vehicle = vehicle();
    let j = Matrix3::from_diagonal(&Vector3::from(vehicle.inertia));
    for rates in RATES {
        let environment = air(rates);
        for k in 0..12 {
            let t = 0.47 * f64::from(k);
            let at = |s: f64| iterated(&environment, &waving(t + s));
            let (state, r, h) = (waving(t), at(0.0), 2e-3);
            let wrench = WrenchModel::Exact.wrench(&vehicle, &environment, &state);
            let thrust = force(&environment, &state, &r) * vehicle.mass - r.column(2) * wrench[0];
            assert!(thrust.amax() < 1e-11, "{rates:?} {t}: {thrust}");
            let (roll, pitch) = mavc::motion::roll_pitch(&state, &environment);
            let angles = Rotation3::from_euler_angles(roll, pitch, state[YAW][0]);
            assert!((angles.matrix() - r).amax() < 1e-12, "{rates:?} {t}");
            assert!((mavc::motion::tilt(&state, &environment) - r[(2, 2)].acos()).abs() < 1e-9);
            // Differences of fourth order.
            let [a, b, c, d] = [at(-2.0 * h), at(-h), at(h), at(2.0 * h)];
            let first = (a - d + (c - b) * 8.0) / (12.0 * h);
            let second = ((b + c) * 16.0 - a - d - r * 30.0) / (12.0 * h * h);
            let vee = |m: Matrix3<f64>| {
                Vector3::new(m[(2, 1)] - m[(1, 2)], m[(0, 2)] - m[(2, 0)], m[(1, 0)] - m[(0, 1)]) / 2.0
            };
            let (w, w1) = (vee(r.transpose() * first), vee(r.transpose() * second));
            let torque = j * w1 + w.cross(&(j * w));
            let off = (torque - wrench.fixed_rows::<3>(1)).amax();
            assert!(off < 1e-6 * (1.0 + torque.amax()), "{rates:?} {t}: {off:e}");
            let orders = [1, 2, 3].map(|n| order(&state, n).into());
            let [found, turning] = rotor_drag::rotation(&environment, orders, [state[YAW][0], state[YAW][1]]);
            assert!((found - r).amax() < 1e-12 && (turning - first).amax() < 1e-7, "{rates:?} {t}");
        }
    }
}

/// A rigid body with this drag, flown open loop by the wrench of a motion, follows the motion.
#[test]
fn a_rigid_body_flies_the_wrench() {
    let vehicle = vehicle();
    for rates in RATES {
        let environment = air(rates);
        let frame = Frame {
            yaw_drag: None,
            mass: vehicle.mass,
            inertia: vehicle.inertia.into(),
            gravity: environment.gravity,
            drag: Vector3::from(rates) * vehicle.mass,
        };
        let begin = waving(0.0);
        let orders = [1, 2, 3].map(|n| order(&begin, n).into());
        let [r, turning] = rotor_drag::rotation(&environment, orders, [begin[YAW][0], begin[YAW][1]]);
        let w = r.transpose() * turning;
        let mut body = Body {
            position: order(&begin, 0),
            velocity: order(&begin, 1),
            attitude: UnitQuaternion::from_matrix(&r).into_inner(),
            rates: Vector3::new(w[(2, 1)], w[(0, 2)], w[(1, 0)]),
        };
        let h = 1e-3;
        let wrench = |t: f64| WrenchModel::Exact.wrench(&vehicle, &environment, &waving(t));
        for i in 0..2000 {
            let t = h * f64::from(i);
            let wrenches = [wrench(t), wrench(t + 0.5 * h), wrench(t + h)];
            body.step(&frame, h, [&wrenches[0], &wrenches[1], &wrenches[2]], &environment.wind.into());
        }
        let end: NodeState = waving(2.0);
        let miss = (body.position - order(&end, 0)).norm();
        assert!(miss < 1e-8, "{rates:?}: {miss:e}");
        assert!((body.angles()[2] - end[YAW][0]).sin().abs() < 1e-8);
        // Another drag leads elsewhere.
        assert!((rates[0] - rates[2]).abs() > 0.05);
    }
}

/// With the same drag along all axes the map is that of (60) to (67) for the motion in air.
#[test]
fn equal_drags_are_isotropic() {
    let vehicle = vehicle();
    let environment = air([0.21; 3]);
    for k in 0..20 {
        let state: CommandState = waving(0.31 * f64::from(k));
        let felt = in_air(&state, &environment);
        let flat = FlatState::from_fn(|i, _| if i < 9 { felt[i % 3][2 + i / 3] } else { felt[YAW][i - 9] });
        let expected = flatness::wrench(&vehicle, environment.gravity, &flat);
        let own = rotor_drag::State::from_fn(|i, _| if i < 12 { state[i % 3][1 + i / 3] } else { state[YAW][i - 12] });
        let found = rotor_drag::wrench(&vehicle, &environment, &own);
        assert!((found - expected).amax() < 1e-12 * (1.0 + expected.amax()), "{k}: {found} {expected}");
    }
}

/// The slopes of a wrench with respect to each derivative, by differences, against a linear map.
fn compare_slopes(map: &mavc::motion::hover_map::WrenchMap, at: &CommandState, of: &dyn Fn(&CommandState) -> Wrench) {
    assert!((map.at(at) - of(at)).amax() < 1e-11);
    for axis in [X, Y, Z, YAW] {
        for order in 0..6 {
            let moved = |by: f64| {
                let mut moved = *at;
                moved[axis][order] += by;
                of(&moved)
            };
            let h = 1e-5;
            let slope = (moved(h) - moved(-h)) / (2.0 * h);
            let of_map: Wrench = map.terms.iter().filter(|t| (t.0, t.1) == (axis, order)).map(|t| t.2).sum();
            assert!((slope - of_map).amax() < 1e-7 * (1.0 + slope.amax()), "{axis} {order}: {slope} {of_map}");
        }
    }
}

#[test]
fn the_linear_maps_are_derivatives() {
    let vehicle = vehicle();
    let whole = |s: &CommandState| -> NodeState { s.map(|axis| [axis[0], axis[1], axis[2], axis[3], axis[4]]) };
    for rates in RATES {
        let environment = air(rates);
        let at = waving(0.9);
        let map = WrenchModel::Exact.linearised(&vehicle, &environment, &whole(&at));
        compare_slopes(&map, &at, &|s| WrenchModel::Exact.wrench(&vehicle, &environment, &whole(s)));
        let map = WrenchModel::Exact.commanded_linearised(&vehicle, &environment, 0.05, &at);
        compare_slopes(&map, &at, &|s| WrenchModel::Exact.commanded(&vehicle, &environment, 0.05, s));
        // c = w + tau w', by differences in time.
        let wrench = |t: f64| WrenchModel::Exact.wrench(&vehicle, &environment, &waving(t));
        let h = 1e-4;
        let expected = wrench(0.9) + (wrench(0.9 + h) - wrench(0.9 - h)) * (0.05 / (2.0 * h));
        let found = WrenchModel::Exact.commanded(&vehicle, &environment, 0.05, &at);
        assert!((found - expected).amax() < 1e-6, "{found} {expected}");
    }
}

/// The checker's equations are vectors, the planner's ZYX angles.
#[test]
fn the_wrench_is_the_checkers() {
    let vehicle = vehicle();
    let tau = Interval::point(0.05);
    for rates in RATES {
        let environment = air(rates);
        let dynamics = Dynamics { vehicle: &vehicle, environment, model: DynamicModel::Exact, one_yaw: None };
        for k in 0..20 {
            let state: CommandState = waving(0.31 * f64::from(k));
            let whole: NodeState = state.map(|axis| [axis[0], axis[1], axis[2], axis[3], axis[4]]);
            let enclosed = state.map(|axis| axis.map(Interval::point));
            let wrench = WrenchModel::Exact.wrench(&vehicle, &environment, &whole);
            let commands = WrenchModel::Exact.commanded(&vehicle, &environment, 0.05, &state);
            let held = dynamics.held(Held::Commands { tau }, &enclosed).value;
            for (found, wanted) in [(dynamics.value(&enclosed), wrench), (held, commands)] {
                for (found, wanted) in found.iter().zip(wanted.iter()) {
                    let scale = 1e-9 * (1.0 + wanted.abs());
                    assert!(found.low - scale <= *wanted && *wanted <= found.high + scale, "{k}: {found:?} {wanted}");
                    assert!(found.high - found.low < 1e-6, "{k}: {found:?}");
                }
            }
        }
    }
}

const DRAG: [f64; 3] = [0.3, 0.5, 0.2];

fn dash(drag: &str, more: &str) -> String {
    format!(
        "vehicle octo {{
            layout = \"PPNNPPNN\"
            arm = 0.211 m
            mass = 1.8 kg
            inertia = [0.0429, 0.0429, 0.0748] kg*m^2
            drag = {drag} N*s/m
            rotor {{ max_thrust = 6.53 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }}
        }}
        faults {{ every 1 rotor lost as M }}
        mission dash {{
            start at [0, 0, 5] m yaw 30 deg
            waypoint at [25, 0, 5] m yaw 80 deg
            air {{ wind = [-6, 4, 0.5] m/s }}
        }}
        plan {{ planner = rip; samples = 24; time = 4 s }}
        {more}"
    )
}

fn compiled(text: &str) -> Spec {
    Compiler::new().text("dash.mav", text.as_bytes()).into_result().unwrap()
}

/// The thrust at rest is that of the iterated attitude at the yaw of the start, and the largest mass inverts it.
#[test]
fn rest_in_wind_depends_on_the_yaw_of_the_start() {
    for (drag, yaw) in [("[0.3, 0.5, 0.2]", 30.0_f64), ("[0.3, 0.3, 0.2]", 0.0), ("[1.5, 0.5, 0.1]", 30.0)] {
        let model = compiled(&dash(drag, "")).model().clone();
        let environment = model.environment();
        assert!((environment.yaw_at_rest - yaw.to_radians()).abs() < 1e-12);
        let mut rest = NodeState::default();
        rest[YAW][0] = yaw.to_radians();
        let expected = force(&environment, &rest, &iterated(&environment, &rest)).norm() * model.vehicle.mass;
        let found = trimmed(&model, &environment)[0];
        assert!((found - expected).abs() < 1e-10, "{drag}: {found} {expected}");
        let mass = mass_at_rest(&model, found).unwrap();
        assert!((mass - model.vehicle.mass).abs() < 1e-9, "{drag}: {mass}");
        assert_eq!(mass_at_rest(&model, 0.1), None);
    }
}

/// With the same drag along x and y the thrust in level flight at the airspeed u is
/// `(W^2 + dx dz u^2)/sqrt(W^2 + dx^2 u^2)`; with other drags the largest airspeed is the least over all headings.
#[test]
fn airspeeds_are_those_of_the_worst_heading() {
    let of = |drag: [f64; 3]| {
        let mut model: Model = octocopter("PPNNPPNN");
        model.vehicle.drag = drag;
        model.plan.reserve = 0.1;
        let set = AdmissibleSet::healthy(&model);
        (Airspeed::of(&model, &set).and_then(|speed| speed.largest_m_per_s), model)
    };
    let (speed, model) = of([0.35, 0.35, 0.3]);
    let (u, weight) = (speed.unwrap(), 1.8 * model.gravity);
    let full = 8.0 * 8.5485e-6 * 874.0_f64.powi(2);
    let most = weight + 0.9 * (full - weight);
    let thrust = (weight.powi(2) + 0.35 * 0.3 * u * u) / weight.hypot(0.35 * u);
    assert!((thrust - most).abs() < 1e-6 * most, "{u}: {thrust} {most}");
    let (mixed, model) = of([0.3, 0.5, 0.45]);
    let environment = model.environment();
    let mut least = f64::INFINITY;
    for degrees in 0..=90 {
        let thrust = |u: f64| {
            let mut state = NodeState::default();
            (state[X][1], state[YAW][0]) = (u, f64::from(degrees).to_radians());
            force(&environment, &state, &iterated(&environment, &state)).norm() * 1.8
        };
        let (mut low, mut high) = (0.0, 1000.0);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if thrust(middle) < most { low = middle } else { high = middle }
        }
        least = least.min(low);
    }
    assert!((mixed.unwrap() - least).abs() < 1e-3 * least, "{mixed:?} {least}");
    assert_eq!(of([0.0, 0.0, 0.2]).0, None);
}

/// One number and three equal ones are the same spec in all but its text, and give the same plan.
#[test]
fn three_equal_drags_give_the_plan_of_one() {
    let [one, three] = ["0.35", "[0.35, 0.35, 0.35]"].map(|drag| compiled(&dash(drag, "")));
    let planned = |spec: &Spec| match mavc::plan(spec).unwrap().outcome() {
        PlanOutcome::Planned(plan) => plan.trajectory.clone(),
        other => panic!("{other:?}"),
    };
    assert_eq!(planned(&one), planned(&three));
    assert_eq!(one.model().simulation.drag, three.model().simulation.drag);
    let shown = |spec: &Spec| spec.model().to_string();
    assert!(shown(&one).contains("drag 0.35 N*s/m") && shown(&three).contains("drag 0.35 N*s/m"));
    assert!(shown(&compiled(&dash("[0.3, 0.5, 0.2]", ""))).contains("drag [0.3, 0.5, 0.2] N*s/m"));
}

/// The plan is inside its set by the equation of motion, the certificate is accepted, and flights follow the plan only
/// in its air.
#[test]
fn certificates_and_flights_have_the_drag_of_each_axis() {
    let folder = tempfile::tempdir().unwrap();
    let [spec, proof, other] = ["dash.mav", "proof.json", "other.mav"].map(|name| folder.path().join(name));
    let text = dash("[0.3, 0.5, 0.2]", "simulate { gyroscope_noise = 0 rad/s; position_noise = 0 m }");
    std::fs::write(&spec, &text).unwrap();
    std::fs::write(&other, text.replace("[0.3, 0.5, 0.2]", "[0.5, 0.3, 0.2]")).unwrap();
    let [spec, proof, other] = [&spec, &proof, &other].map(|path| path.to_str().unwrap());
    let output = mavc(&["plan", "-v", spec, "--certificate", proof]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let output = mavc(&["verify", proof, spec]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let shown = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(shown.contains("upright attitude") && !shown.contains("weaker"), "{shown}");
    assert_eq!(mavc(&["verify", proof, other]).status.code(), Some(5));
    let error = |settings: &[&str]| -> f64 {
        let output = mavc(&[&["simulate", spec, "--report", "-"], settings].concat());
        let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        report["max_error_m"].as_f64().unwrap()
    };
    let known = error(&[]);
    let unknown = error(&["--set", "simulate.drag=[0.5, 0.3, 0.2] N*s/m"]);
    assert!(known < 0.1 && unknown > 2.0 * known, "{known} {unknown}");
}

/// Rotors that lag: the commanded wrench of the plan is proved as well.
#[test]
fn commands_of_lagging_rotors_are_certified() {
    let folder = tempfile::tempdir().unwrap();
    let [spec, proof] = ["dash.mav", "proof.json"].map(|name| folder.path().join(name));
    let text =
        dash("[0.3, 0.5, 0.2]", "").replace("max_speed = 874 rad/s", "max_speed = 874 rad/s; time_constant = 30 ms");
    std::fs::write(&spec, text.replace("samples = 24", "samples = 24; rotors = lagging")).unwrap();
    let [spec, proof] = [&spec, &proof].map(|path| path.to_str().unwrap());
    assert_eq!(mavc(&["plan", "-v", spec, "--certificate", proof]).status.code(), Some(0));
    let output = mavc(&["verify", proof, spec]);
    let shown = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(shown.contains("commands inside the set of healthy"), "{shown}");
}

/// A scaled density scales all three.
#[test]
fn density_scales_every_axis() {
    let spec = compiled(&dash("[0.3, 0.5, 0.2]", "").replace("wind = [-6, 4, 0.5] m/s", "density = 0.98 kg/m^3"));
    for (found, drag) in spec.model().vehicle.drag.iter().zip(DRAG) {
        assert!((found - 0.8 * drag).abs() < 1e-12);
    }
    assert_eq!(spec.model().simulation.drag, spec.model().vehicle.drag);
}

/// With the same drag along x and y the rows hold in the extreme winds of an interval, and a limit on tilt in all of
/// them.
#[test]
fn limits_on_tilt_hold_with_equal_drags_across() {
    let text = dash("[0.35, 0.35, 0.2]", "").replace("[-6, 4, 0.5] m/s", "[6, 0, 0] m/s");
    let text = text.replace("air {", "limits { tilt <= 30 deg }\n air {").replace("time = 4 s", "time = 5 s");
    let spec = compiled(&text);
    let model = spec.model();
    let plan = match mavc::plan(&spec).unwrap().outcome() {
        PlanOutcome::Planned(plan) => plan.trajectory.clone(),
        other => panic!("{other:?}"),
    };
    let set = AdmissibleSet::healthy(model);
    let kept = set.with_reserve(model.plan.reserve);
    for wind in model.environment().corners() {
        for step in 0..=480 {
            let state = plan.at(plan.duration() * f64::from(step) / 480.0);
            let r = iterated(&wind, &state);
            assert!(r[(2, 2)].acos().to_degrees() < 30.01, "{step}");
            let wrench = plan.wrench(&model.vehicle, &wind, &state);
            assert!((wrench[0] - model.vehicle.mass * force(&wind, &state, &r).norm()).abs() < 1e-10);
            for facet in &kept.polytope.facets {
                let out = (facet.normal.dot(&wrench) - facet.offset) / set.zonotope.width(&facet.normal);
                assert!(out < 1e-4, "{step}: {out}");
            }
        }
    }
}

/// A stop begins with the attitude and the body rates of the plan, by iterated attitudes and their differences.
#[test]
#[ignore = "long"]
fn a_stop_keeps_attitude_and_body_rates() {
    let mut model = octocopter("PPNNPPNN");
    model.vehicle.drag = DRAG;
    model.modes = vec![lost(&model, &[1])];
    let points = [[0.0, 0.0, 4.0], [8.0, 0.0, 6.0], [8.0, 8.0, 4.0]];
    let points = points.iter().enumerate().map(|(i, p)| waypoint(*p, 0.8 * i as f64)).collect();
    let mut mission = mission(points);
    mission.air.wind = [3.0, -2.0, 0.0];
    model.mission = Some(mission);
    model.plan.planner = PlannerKind::Rip;
    model.plan.against = vec![0];
    model.plan.model = PlanModel::Exact;
    model.plan.samples = 40;
    model.plan.time = MissionTime::Fixed(5.0);
    let environment = model.environment();
    let comparison = run_planners(Problem::of(&model).unwrap(), Scope::Plan, None);
    let plan = match &comparison.runs.last().unwrap().outcome {
        PlanOutcome::Planned(plan) => &plan.trajectory,
        other => panic!("{other:?}"),
    };
    let sets = PlanningSets::of(&model);
    let mut stops = Stops::new(Problem::of(&model).unwrap(), &sets.healthy, &sets.modes[0], plan.model);
    let (mut found, dt) = (0, 1e-5);
    for node in [8, 16, 24] {
        let struck = &plan.nodes[node];
        let Some(stop) = stops.find(struck) else { continue };
        let h = stop.grid.node_times[1];
        let ends = [0.0, dt / h].map(|share| iterated(&environment, &stop.inside(0, share)));
        let planned = [0.0, dt].map(|later| iterated(&environment, &plan.within(node, later)));
        assert!((ends[0] - planned[0]).amax() < 1e-5, "{node}: {}", ends[0] - planned[0]);
        let [rate, of_plan] = [ends, planned].map(|[now, later]| (later - now) / dt);
        assert!((rate - of_plan).amax() < 1e-3, "{node}: {rate} {of_plan}");
        // The plan moves and turns there, so that this says something.
        assert!(of_plan.amax() > 0.1 && order(struck, 1).norm() > 1.0);
        found += 1;
    }
    assert!(found >= 2, "{found}");
}

/// Point masses that push as hard as they can along the mission, in every attitude of the drag, are not faster than the
/// bound.
#[test]
fn no_motion_beats_the_least_time() {
    let spec = compiled(&dash("[0.3, 1.5, 0.2]", "").replace("[-6, 4, 0.5]", "[9, 2, 0]"));
    let model = spec.model();
    let bound = least_time_within(Problem::of(model).unwrap()).seconds;
    let full: f64 = model.vehicle.rotors.iter().map(mavc::model::Rotor::max_thrust).sum();
    let most = full / model.vehicle.mass;
    let environment = model.environment();
    let k = Matrix3::from_diagonal(&Vector3::from(environment.drag_rates));
    let mut fastest = f64::INFINITY;
    for turn in 0..60 {
        let turn = f64::from(turn);
        let r = Rotation3::from_euler_angles(0.9 * turn, 1.3 * turn, 0.2 * turn).into_inner();
        let drag = r * k * r.transpose();
        let (mut x, mut v, mut t) = (0.0, Vector3::zeros(), 0.0);
        let h = 1e-3;
        while x < 24.9 && t < 20.0 {
            // All of the thrust along x, and gravity is carried by nothing.
            let a =
                Vector3::x() * most - Vector3::z() * environment.gravity - drag * (v - Vector3::from(environment.wind));
            v += a * h;
            x += v.x * h;
            t += h;
        }
        fastest = fastest.min(t);
    }
    assert!(bound > 0.5 && bound < fastest, "{bound} {fastest}");
}
