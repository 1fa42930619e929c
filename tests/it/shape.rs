//! The shape of plans: heights, deviations and turns against values worked out by hand, and remarks on detours.

use crate::cli::flat;
use crate::schemas::schema;
use crate::vehicles::{mission, waypoint};
use mavc::Task;
use mavc::explain::detour::{Detour, DetourKind, Forbids, detours, is_cheap, try_statements};
use mavc::model::{Heading, Problem};
use mavc::motion::shape::{Place, Shape, Turned, distance_from_segment};
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, Trajectory};
use mavc::observer::Silent;
use mavc::planner::studies::{MissionPlan, PlanOutcome, Scope, Verification, run_planners};
use mavc::report::{shape, terminal};

/// A motion of the exact model through the states at these times; waypoints are at the nodes given.
fn motion(times: &[f64], waypoint_nodes: &[usize], state: impl Fn(f64) -> NodeState) -> Trajectory {
    Trajectory {
        times: times.to_vec(),
        nodes: times.iter().map(|&t| state(t)).collect(),
        waypoint_nodes: waypoint_nodes.to_vec(),
        model: WrenchModel::Exact,
    }
}

/// p + v t + a t^2/2 with its derivatives.
fn parabola(p: f64, v: f64, a: f64, t: f64) -> [f64; 5] {
    [p + v * t + 0.5 * a * t * t, v + a * t, a, 0.0, 0.0]
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

#[test]
fn a_straight_climb_strays_nowhere() {
    let climb =
        motion(&[0.0, 2.0], &[0, 1], |t| [parabola(1.0, 1.5, 0.0, t), [0.0; 5], parabola(2.0, 4.0, 0.0, t), [0.0; 5]]);
    let shape = Shape::of(&climb, &mission(vec![waypoint([1.0, 0.0, 2.0], 0.0), waypoint([4.0, 0.0, 10.0], 0.0)]));
    assert!(near(shape.top.value, 10.0) && near(shape.top.at, 2.0) && near(shape.above, 0.0), "{shape:?}");
    assert_eq!(shape.top_place, Place::Waypoint(1));
    let leg = shape.legs[0];
    assert!(near(leg.length, 73.0_f64.sqrt()) && near(leg.deviation.value, 0.0) && near(leg.climb.value, 0.0));
    assert_eq!(shape.yaw, Some(Turned { turned: 0.0, required: 0.0 }));
}

/// Over 4 s along x at 4 m/s, z = 5 + 4 t - t^2 and y = (4 t - t^2)/2, with a node off the vertex; then on along x.
/// The vertex at 2 s is 4 m above the segment and 2 m aside, sqrt(20) m away. The yaw 0.2 + (4 t - t^2)/10 turns by
/// 0.4 rad and back, then by 0.3 rad where 0.1 rad is required.
#[test]
fn an_arc_is_measured_at_its_vertex() {
    let state = |t: f64| match t <= 4.0 {
        true => [
            parabola(0.0, 4.0, 0.0, t),
            parabola(0.0, 2.0, -1.0, t),
            parabola(5.0, 4.0, -2.0, t),
            parabola(0.2, 0.4, -0.2, t),
        ],
        false => [
            parabola(16.0, 4.0, 0.0, t - 4.0),
            [0.0; 5],
            [5.0, 0.0, 0.0, 0.0, 0.0],
            [0.2 + 0.3 * (t - 4.0), 0.3, 0.0, 0.0, 0.0],
        ],
    };
    let mut arc = motion(&[0.0, 1.3, 4.0, 5.0], &[0, 2, 3], state);
    // The yaw's acceleration is linear between nodes: the second leg begins with a node of its own.
    arc.times.insert(3, 4.0 + 1e-9);
    arc.nodes.insert(3, state(4.0 + 1e-9));
    arc.waypoint_nodes[2] = 4;
    let mut mission =
        mission(vec![waypoint([0.0, 0.0, 5.0], 0.2), waypoint([16.0, 0.0, 5.0], 0.2), waypoint([20.0, 0.0, 6.0], 0.3)]);
    let shape = Shape::of(&arc, &mission);
    assert!(near(shape.top.value, 9.0) && (shape.top.at - 2.0).abs() < 1e-4 && near(shape.above, 3.0), "{shape:?}");
    assert_eq!((shape.top_place, shape.farthest()), (Place::Leg(0), 0));
    let leg = shape.legs[0];
    assert!(near(leg.climb.value, 4.0) && near(leg.aside.value, 2.0), "{leg:?}");
    assert!(near(leg.deviation.value, 20.0_f64.sqrt()) && (leg.deviation.at - 2.0).abs() < 1e-4, "{leg:?}");
    // At the end of the second leg the motion is 1 m below the waypoint, 4/sqrt(17) m from the segment.
    assert!(near(shape.legs[1].deviation.value, 4.0 / 17.0_f64.sqrt()), "{shape:?}");
    let yaw = shape.yaw.unwrap();
    assert!(near(yaw.turned, 0.8 + 0.3) && near(yaw.required, 0.1), "{yaw:?}");
    // Legs from and to a free yaw are left out.
    mission.waypoints[2].heading = Heading::Free;
    let yaw = Shape::of(&arc, &mission).yaw.unwrap();
    assert!(near(yaw.turned, 0.8) && yaw.required == 0.0, "{yaw:?}");
    mission.waypoints[1].heading = Heading::Free;
    assert_eq!(Shape::of(&arc, &mission).yaw, None);
}

/// Above the line of a steep leg, but not above its higher waypoint: a limit on height does not forbid it.
#[test]
fn a_deviation_below_the_higher_waypoint_is_no_climb() {
    let steep = motion(&[0.0, 1.0, 2.0], &[0, 2], |t| match t < 1.0 {
        true => [[0.0; 5], [0.0; 5], parabola(0.0, 4.0, 0.0, t), [0.0; 5]],
        false => [parabola(0.0, 3.0, 0.0, t - 1.0), [0.0; 5], [4.0, 0.0, 0.0, 0.0, 0.0], [0.0; 5]],
    });
    let shape = Shape::of(&steep, &mission(vec![waypoint([0.0; 3], 0.0), waypoint([3.0, 0.0, 4.0], 0.0)]));
    // The corner [0, 0, 4] is 3 * 4 / 5 from the line.
    let leg = shape.legs[0];
    assert!(near(leg.climb.value, 0.0) && near(leg.deviation.value, 2.4) && near(leg.aside.value, 2.4), "{leg:?}");
}

#[test]
fn a_hold_belongs_to_its_waypoint() {
    let rest = motion(&[0.0, 1.0, 4.0, 5.0], &[0, 1, 3], |t| {
        let z = if (1.0..=4.0).contains(&t) { 3.0 } else { 2.0 };
        [[0.0; 5], [0.0; 5], [z, 0.0, 0.0, 0.0, 0.0], [0.0; 5]]
    });
    let mut points = vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint([0.0, 0.0, 3.0], 0.0), waypoint([0.0; 3], 0.0)];
    points[1].hold = 3.0;
    assert_eq!(Shape::of(&rest, &mission(points)).top_place, Place::Waypoint(1));
}

#[test]
fn distances_from_a_segment_end_at_its_ends() {
    let segment = [[0.0; 3], [10.0, 0.0, 0.0]];
    for (p, distance) in [([5.0, -2.0, 0.0], 2.0), ([13.0, 4.0, 0.0], 5.0), ([-1.0, 2.0, 2.0], 3.0)] {
        assert!(near(distance_from_segment(p, segment), distance), "{p:?}");
    }
    assert!(near(distance_from_segment([3.0, 4.0, 0.0], [[0.0; 3]; 2]), 5.0));
}

const SPEC: &str = "vehicle octo {
    layout = \"PPNNPPNN\"; arm = 0.211 m; mass = 1.8 kg; inertia = [0.0429, 0.0429, 0.0748] kg*m^2; size = 30 cm
    rotor { max_thrust = 6.53 N; torque_per_thrust = 16 mm; max_speed = 874 rad/s }
}
mission hop {
    start at [0, 0, 5] m
    waypoint far at [20, 0, 5] m CLAUSES
    limits { speed <= 8 m/s; tilt <= 30 deg }
    MORE
}
plan { planner = rip; time = TIME; samples = 40 }
";

fn spec_of(clauses: &str, more: &str, time: &str) -> mavc::Spec {
    let text = SPEC.replace("CLAUSES", clauses).replace("MORE", more).replace("TIME", time);
    mavc::compile(&text).into_result().unwrap()
}

/// A plan with another motion: along x in 4 s, `up` and `aside` (m) off the line in the middle.
fn bent(planning: &mavc::Planning, up: f64, aside: f64) -> MissionPlan {
    let mut plan = planning.plan().unwrap().clone();
    plan.trajectory = motion(&[0.0, 4.0], &[0, 1], |t| {
        [parabola(0.0, 5.0, 0.0, t), parabola(0.0, aside, -0.5 * aside, t), parabola(5.0, up, -0.5 * up, t), [0.0; 5]]
    });
    plan
}

#[test]
fn detours_are_named_with_what_forbids_them() {
    let spec = spec_of("", "", "minimum");
    let task = Task::new(&spec).unwrap();
    let planning = mavc::plan(&spec).unwrap();
    let of = |up: f64, aside: f64| detours(task.problem(), &bent(&planning, up, aside));
    // 10 % of 20 m are 2 m.
    assert_eq!(of(0.9, 1.7), []);
    let [Detour { kind: DetourKind::Climb, leg: 0, by, at, forbids: Forbids::Altitude(height), tried: None, .. }] =
        of(3.0, 1.9)[..]
    else {
        panic!("{:?}", of(3.0, 1.9))
    };
    assert!(near(by, 3.0) && (at - 2.0).abs() < 1e-4 && near(height, 6.0), "{by} {at} {height}");
    let [Detour { kind: DetourKind::Deviation, by, forbids: Forbids::Corridor(radius), .. }] = of(0.0, -4.0)[..] else {
        panic!("{:?}", of(0.0, -4.0))
    };
    assert!(near(by, 4.0) && near(radius, 2.0), "{by} {radius}");
    let both = of(3.0, 4.0);
    assert_eq!(both.iter().map(|detour| detour.kind).collect::<Vec<_>>(), [DetourKind::Climb, DetourKind::Deviation]);
}

#[test]
fn what_the_spec_shapes_or_obstructs_is_no_detour() {
    for clauses in ["corridor 6 m", "straight"] {
        let spec = spec_of(clauses, "", "6 s");
        let task = Task::new(&spec).unwrap();
        assert_eq!(detours(task.problem(), &bent(&mavc::plan(&spec).unwrap(), 3.0, 4.0)), [], "{clauses}");
    }
    let spec = spec_of("{ altitude <= 20 m }", "", "6 s");
    let task = Task::new(&spec).unwrap();
    let found = detours(task.problem(), &bent(&mavc::plan(&spec).unwrap(), 3.0, 0.0));
    assert!(found.iter().all(|detour| detour.kind == DetourKind::Deviation), "{found:?}");
    let pole =
        spec_of("", "keep_out pole { shape = cylinder; centre = [10, 0, 0] m; radius = 1 m; height = 20 m }", "9 s");
    let task = Task::new(&pole).unwrap();
    assert_eq!(detours(task.problem(), &bent(&mavc::plan(&pole).unwrap(), 3.0, 4.0)), []);
}

/// With a time that is searched for, the price is a time; otherwise a plan at the same time is what was found.
#[test]
fn statements_are_tried_and_priced() {
    for (time, price) in [("minimum", " s, which is not longer."), ("6 s", " found a plan at the same time.")] {
        let spec = spec_of("", "", time);
        let task = Task::new(&spec).unwrap();
        let planning = mavc::plan(&spec).unwrap();
        let mut plan = bent(&planning, 3.0, 4.0);
        plan.time = 60.0;
        let mut comparison = planning.comparison().clone();
        let run = comparison.runs.last_mut().unwrap();
        run.outcome = PlanOutcome::Planned(Box::new(plan.clone()));
        let run = run.clone();
        let mut found = detours(task.problem(), &plan);
        let untried = flat(&terminal::detours(task.problem(), &plan, &found));
        assert!(untried.contains("`altitude <= ...` in `limits` forbids it."), "{untried}");
        assert!(untried.contains("`straight` or `corridor ...` on waypoint 2 forbids it."), "{untried}");
        assert!(is_cheap(task.problem()));
        let (shorter, _) = try_statements(task.problem(), &comparison, &run, &mut found);
        // A plan that keeps more is one of this mission too; at a fixed time there is no shorter one.
        let shorter = shorter.map(|shorter| shorter.runs.last().unwrap().outcome.plan().unwrap().clone());
        // What limits its time counts limits that this mission does not have.
        assert!(shorter.as_ref().is_none_or(|plan| plan.binding.is_empty()));
        let checked = shorter.as_ref().is_some_and(|plan| plan.verification == Verification::Passed);
        assert_eq!(checked, time == "minimum");
        assert!(shorter.is_none_or(|plan| Some(plan.time) == found[0].tried && plan.time < 60.0));
        assert!(found.iter().all(|detour| detour.tried.is_some()), "{found:?}");
        let text = terminal::detours(task.problem(), &plan, &found).split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            text.contains("The plan climbs 3 m above both waypoints of the leg to waypoint 2 `far`, at 2.00 s"),
            "{text}"
        );
        assert!(
            text.contains("although no volume is in the way; `altitude <= 6 m` in `limits` forbids it. "),
            "{text}"
        );
        assert!(
            text.contains("; `corridor 2 m` on waypoint 2 forbids it. A quick search with the statements of"),
            "{text}"
        );
        assert!(text.contains(price), "{text}");
        let records = serde_json::to_value(shape::detour_records(task.problem(), &found)).unwrap();
        assert_eq!((&records[0]["statement"], &records[0]["place"]), (&"altitude <= 6 m".into(), &"limits".into()));
        assert_eq!((&records[1]["statement"], &records[1]["place"]), (&"corridor 2 m".into(), &"waypoint".into()));
    }
}

#[test]
fn text_record_and_schema_agree() {
    let spec = spec_of("", "", "6 s");
    let task = Task::new(&spec).unwrap();
    let planning = task.plan(&Silent);
    let record = serde_json::to_value(task.report(&planning, &mavc::Explained::default(), None)).unwrap();
    schema("report").assert_valid(&record);
    let shape = &record["planners"][0]["shape"];
    assert!(shape["deviation"]["leg"] == 1 && shape["yaw"]["required_rad"] == 0.0, "{shape}");
    let text = task.text(&planning, &mavc::Explained::default(), None);
    let lines: Vec<&str> =
        text.lines().filter(|line| line.starts_with("  height up to") || line.contains("yaw turns")).collect();
    assert!(lines.len() == 2 && lines.iter().all(|line| line.len() <= 80), "{text}");
    assert!(text.contains("m from the straight leg (leg to waypoint 2 `far`, "), "{text}");
}

/// `yaw along path` from a start at rest: the vehicle begins in the direction of its first leg and turns with the
/// path, 252 degrees to the given yaw of the first mission and 360 degrees in the second, and no whole turn more.
#[test]
fn a_yaw_along_the_path_begins_in_its_direction() {
    let first = "[6, 2, 5] m; waypoint at [8, 8, 5] m; waypoint at [2, 10, 5] m; waypoint at [-2, 5, 5] m";
    let round =
        format!("{first}; waypoint at [0, 0, 5] m; waypoint at [6, -1, 5] m; waypoint at [10, -1, 5] m yaw 0 deg");
    let branch = format!("{first}; waypoint at [-2, 2, 5] m yaw -90 deg");
    for (way, turn) in [(branch, 252.0), (round, 360.0)] {
        let text = format!(
            "vehicle hexa {{
                layout = \"PNPNPN\"; arm = 0.3 m; mass = 2 kg; inertia = [0.03, 0.03, 0.05] kg*m^2
                rotor {{ max_thrust = 8 N; torque_per_thrust = 16 mm; max_speed = 800 rad/s }}
            }}
            mission m {{
                start at [0, 0, 5] m yaw along path yaw_within 10 deg
                waypoint at {}
                limits {{ speed <= 4 m/s; yaw_rate <= 90 deg/s }}
            }}
            plan {{ planner = rip; time = minimum; samples = 100 }}",
            way.replace("; waypoint", " within 30 cm\n waypoint")
        );
        let spec = mavc::compile(&text).into_result().unwrap();
        let planning = mavc::plan(&spec).unwrap();
        let nodes = &planning.plan().expect("a plan").trajectory.nodes;
        let yaw: Vec<f64> = nodes.iter().map(|state| state[3][0].to_degrees()).collect();
        let first = 2.0_f64.atan2(6.0).to_degrees();
        assert!((yaw[0] - first).abs() < 30.0, "{yaw:?}");
        assert!((yaw[yaw.len() - 1] - yaw[0] - turn).abs() < 60.0, "{yaw:?}");
        let turned: f64 = yaw.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum();
        assert!(turned < turn + 120.0, "{turned} {yaw:?}");
    }
}

/// At a fixed time with room, a plan keeps the heights of its legs, to within half a metre, where least snap does not.
#[test]
fn a_plan_with_time_keeps_its_heights() {
    let text = "vehicle hexa {
            layout = \"PNPNPN\"; arm = 0.45 m; mass = 2.9 kg; inertia = [0.085, 0.085, 0.16] kg*m^2
            rotor { max_thrust = 18 N; torque_per_thrust = 17.5 mm; max_speed = 640 rad/s }
        }
        mission m {
            start at [0, 0, 2] m
            waypoint at [0, 0, 20] m
            waypoint at [50, 0, 20] m
            waypoint at [50, 40, 25] m
            waypoint at [10, 45, 25] m
            waypoint at [0, 0, 10] m
            waypoint at [0, 0, 2] m
            limits { speed <= 10 m/s; tilt <= 30 deg }
        }
        plan { planner = rip; time = 26 s; samples = 100 }";
    let spec = mavc::compile(text).into_result().unwrap();
    let comparison = run_planners(Problem::of(spec.model()).unwrap(), Scope::Plan, None);
    let mission = spec.model().mission.as_ref().unwrap();
    let climb = |plan: &MissionPlan| {
        let legs = Shape::of(&plan.trajectory, mission).legs;
        legs.iter().map(|leg| leg.climb.value).fold(f64::NEG_INFINITY, f64::max)
    };
    let plan = comparison.runs[0].outcome.plan().expect("a plan");
    assert!(climb(plan) < 0.55, "{}", climb(plan));
    let plainer = comparison.runs[0].plainer.as_deref().expect("a plan before the second pass");
    assert!(climb(plainer) > 1.0, "{}", climb(plainer));
}
