//! What is said where there is no plan: proved on the relaxation, or only not found.

use super::{compared, last, planning};
use crate::cli::flat;
use crate::vehicles::{limit, mission, waypoint};
use mavc::admissible::AdmissibleSet;
use mavc::model::{LimitKind, Mission, MissionTime, Model, PlannerKind, Problem};
use mavc::motion::wrench_model::WrenchModel;
use mavc::planner::hover::{Decision, HoverPlanner, Planned};
use mavc::planner::scp::{NOT_FOUND, ScpPlanner};
use mavc::planner::selection::sets::PlanningSets;
use mavc::planner::studies::{NotFound, PlanOutcome, Proof};
use mavc::report::terminal;
use mavc::report::verdict_text::elsewhere;
use std::io::Write;
use std::process::{Command, Stdio};

fn hop(to: [f64; 3], turn: f64, limits: &[(LimitKind, f64)], time: f64) -> Model {
    let points = vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint(to, turn)];
    let limits = limits.iter().map(|(kind, upper)| limit(kind.clone(), *upper)).collect();
    let mut model = planning(Mission { limits, ..mission(points) }, PlannerKind::Rip, &[], MissionTime::Fixed(time));
    model.plan.samples = 20;
    model
}

fn told(model: &Model) -> (PlanOutcome, String) {
    let comparison = compared(model);
    let text = terminal::plan(Problem::of(model).unwrap(), &comparison);
    (last(&comparison).outcome.clone(), text)
}

/// Speed, jerk, tilt and full thrust bound what any attitude and any torque can do: closed forms say that the way is
/// too far.
#[test]
fn what_no_attitude_could_do_is_proved() {
    let far = |d: f64| [d, 0.0, 2.0];
    let thrust = 8.0 * 8.5485e-6 * 874.0 * 874.0 / 1.8;
    let (up, down) = (thrust - 9.81, thrust + 9.81);
    for (model, why) in [
        // 2 s at 1 m/s are 2 m.
        (hop(far(2.2), 0.0, &[(LimitKind::Speed, 1.0)], 2.0), "speed"),
        // From rest to rest d takes at least 2 sqrt(d / a), a = g tan(10 degrees) in level flight.
        (hop(far(3.0), 0.0, &[(LimitKind::Tilt, 10f64.to_radians()), (LimitKind::Z, 2.06)], 1.5), "tilt"),
        // From rest to rest d takes t^2 = 2 d (1/up + 1/down), with full thrust upwards and then downwards.
        (hop([0.0, 0.0, 2.2 + 0.81 / (2.0 * (1.0 / up + 1.0 / down))], 0.0, &[], 0.9), "thrust"),
        (hop([0.0, 0.0, 2.0], 1.0, &[(LimitKind::YawRate, 0.4)], 2.0), "yaw rate"),
    ] {
        let (outcome, text) = told(&model);
        assert!(matches!(outcome, PlanOutcome::Infeasible(Proof { .. })), "{why}: {text}");
        assert!(text.contains(": proved infeasible at "), "{text}");
        assert!(
            text.contains(" s with 20 samples")
                || flat(&text).contains(": no motion within limits and thrust takes less than "),
            "{text}"
        );
    }
}

/// Each leg alone is flown from rest to rest in its 7 s (a turn of 170 degrees at 30 degrees a second takes 5.7 s), so
/// that both together have a plan, and so has all that leaves more time.
#[test]
fn what_its_parts_have_a_mission_has() {
    for (held, time) in [(0.0, 14.0), (0.0, 16.0), (1.0, 15.0), (1.0, 18.0)] {
        let turned = [(0.0, 0.0), (6.0, 170f64.to_radians()), (12.0, 0.0)];
        let mut points = turned.map(|(x, yaw)| waypoint([x, 0.0, 2.0], yaw));
        (points[1].time, points[1].hold) = (Some(7.0), held);
        let limits = vec![limit(LimitKind::YawRate, 30f64.to_radians())];
        let mission = Mission { limits, ..mission(points.to_vec()) };
        let mut model = planning(mission, PlannerKind::Rip, &[], MissionTime::Fixed(time));
        model.plan.samples = 200;
        let (outcome, text) = told(&model);
        assert!(matches!(outcome, PlanOutcome::Planned(_)), "held {held} s, in {time} s: {text}");
    }
}

/// Where every time tried is proved to have no plan that is said, whether or not some waypoint has a time of its own;
/// and a mission that has plans at long times only has them.
#[test]
fn no_plan_at_any_time_tried_is_proved() {
    let mut up = hop([3.0, 0.0, 5.0], 0.0, &[(LimitKind::Climb, 0.0)], 0.0);
    let turned = [(0.0, 0.0), (2.0, 170f64.to_radians()), (4.0, 170f64.to_radians())];
    let mut points = turned.map(|(x, yaw)| waypoint([x, 0.0, 2.0], yaw));
    points[1].time = Some(4.0);
    let limits = vec![limit(LimitKind::YawRate, 30f64.to_radians())];
    let mission = Mission { limits, ..mission(points.to_vec()) };
    let mut early = planning(mission, PlannerKind::Rip, &[], MissionTime::Minimum);
    early.plan.samples = 40;
    up.plan.time = MissionTime::Minimum;
    for (model, due) in
        [(&up, "at each of "), (&early, "at any mission time: no motion within limits and thrust reaches")]
    {
        let (outcome, text) = told(model);
        assert!(matches!(outcome, PlanOutcome::Infeasible(Proof { .. })), "{text}");
        assert!(flat(&text).contains(&format!("proved infeasible {due}")), "{text}");
    }
    up.mission.as_mut().unwrap().limits = vec![limit(LimitKind::Climb, 0.05)];
    let (outcome, text) = told(&up);
    assert!(matches!(&outcome, PlanOutcome::Planned(solved) if solved.time > 58.0), "{text}");
}

/// The time of the last waypoint is the mission's, whoever says it.
#[test]
fn the_last_waypoints_time_is_the_plans() {
    let by_plan = hop([9.0, 0.0, 3.0], 0.0, &[(LimitKind::Speed, 3.0)], 5.0);
    let mut by_waypoint = by_plan.clone();
    by_waypoint.plan.time = MissionTime::Minimum;
    by_waypoint.mission.as_mut().unwrap().waypoints[1].time = Some(5.0);
    let [one, other] = [by_plan, by_waypoint].map(|model| told(&model).0);
    let (PlanOutcome::Planned(one), PlanOutcome::Planned(other)) = (&one, &other) else { panic!("{one:?}, {other:?}") };
    assert_eq!((one.time, one.objective), (other.time, other.objective));
    assert_eq!(one.trajectory, other.trajectory);
}

/// Torques are not in the relaxation: a turn that takes more than the largest tau_z is not found, and no proof is
/// claimed.
#[test]
fn what_only_torques_forbid_is_not_found() {
    // Nearly level a turn from rest to rest takes tau = 4 Izz psi / t^2 at the least; four rotors of full thrust give
    // less. (Without a limit on tilt there is a plan: it pitches up by 83 degrees and turns there with tau_x.)
    let model = hop([0.0, 0.0, 2.2], 2.6, &[(LimitKind::Tilt, 10f64.to_radians())], 1.0);
    let [psi, t] = [2.6 - 2.0 * 0.05, 1.0];
    let largest = 4.0 * 1.3678e-7 * 874.0 * 874.0;
    assert!(4.0 * model.vehicle.inertia[2] * psi / (t * t) > largest, "the turn is possible");
    let (outcome, text) = told(&model);
    assert!(
        matches!(&outcome, PlanOutcome::NotFound(NotFound::Search { status, .. }) if status == NOT_FOUND),
        "{outcome:?}"
    );
    assert!(text.contains("not found at 1 s with 20 samples"), "{text}");
    assert!(!text.contains("proved"), "{text}");
}

/// `mavc plan` of a spec on its standard input: exit code and both streams.
fn plan(mission: &str, plan: &str) -> (i32, String) {
    let spec = format!(
        r#"
vehicle octo {{
    layout  = "PPNNPPNN"
    arm     = 0.211 m
    mass    = 1.8 kg
    inertia = [0.0429, 0.0512, 0.0748] kg*m^2
    rotor {{ thrust_coefficient = 8.5485e-6 N*s^2/rad^2; drag_coefficient = 1.3678e-7 N*m*s^2/rad^2; max_speed = 874 rad/s }}
}}
mission hop {{ {mission} }}
plan {{ planner = rip; samples = 10; reserve = 0 %; {plan} }}
"#
    );
    let mut child = Command::new(env!("CARGO_BIN_EXE_mavc"))
        .args(["plan", "-v", "-"])
        .env("NO_COLOR", "1")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(spec.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), flat(&(text(output.stdout) + &text(output.stderr))))
}

#[test]
fn exit_codes_tell_proved_from_not_found() {
    let up = "start at [0, 0, 2] m\n waypoint at [0, 0, 2.2] m";
    let (code, text) = plan(up, "time = 4 s");
    assert_eq!(code, 0, "{text}");
    assert!(text.contains("exact model"), "exact is the default: {text}");

    let (code, text) =
        plan("start at [0, 0, 2] m\n waypoint at [2.2, 0, 2] m\n limits { speed <= 1 m/s }", "time = 2 s");
    assert_eq!(code, 3, "{text}");
    assert!(text.contains("proved infeasible at 2 s") && text.contains("cannot hold together"), "{text}");

    let (code, text) = plan(&format!("{up} yaw 150 deg"), "time = 1 s");
    assert_eq!(code, 4, "{text}");
    assert!(text.contains("not found at 1 s") && !text.contains("proved infeasible"), "{text}");
}

/// A waypoint that is due before any motion can be there rules out every mission time, whatever planner is asked and
/// however legs share the time.
#[test]
fn a_waypoint_due_too_early_is_proved_infeasible_at_any_mission_time() {
    let mission = "start at [0, 0, 2] m\n waypoint a at [10, 0, 6] m\n waypoint b at [20, 10, 6] m time 3 s
        waypoint c at [30, 0, 2] m\n limits { speed <= 5 m/s; tilt <= 25 deg }";
    for timing in ["optimal", "proportional"] {
        let (code, text) = plan(mission, &format!("time = minimum; timing = {timing}"));
        assert_eq!(code, 3, "{text}");
        let due = "proved infeasible at any mission time: no motion within limits and thrust reaches waypoint 3 before";
        assert!(text.contains(due) && !text.contains("not found"), "{text}");
    }
}

/// Where there is a plan at another time that is said, and no statement is blamed.
#[test]
fn plans_at_other_times_are_named_before_anything_is_blamed() {
    let turn = "start at [0, 0, 2] m\n waypoint at [4, 0, 2] m yaw 60 deg";
    let (code, text) = plan(turn, "time = minimum");
    assert_eq!(code, 0, "{text}");
    let found = text.split_once("found, ").unwrap().1;
    let shortest: f64 = found.split(' ').next().unwrap().parse().unwrap();
    let (code, text) = plan(turn, &format!("time = {:.2} s", 0.95 * shortest));
    assert_eq!(code, 4, "{text}");
    assert!(text.contains("A plan was found at ") && text.contains("whether one exists is open"), "{text}");
    assert!(!text.contains("mavc::plan::conflict"), "{text}");
    // That time has a plan.
    let named = text.split_once("A plan was found at ").unwrap().1.split_once(" s.").unwrap().0;
    let (code, text) = plan(turn, &format!("time = {named} s"));
    assert_eq!(code, 0, "{text}");
}

#[test]
fn sentences_about_other_times_claim_no_more_than_was_found() {
    let model = hop([2.0, 0.0, 2.0], 0.0, &[], 3.0);
    let both = elsewhere(&model, &[2.9, 3.1]).unwrap();
    assert!(both.starts_with("Plans were found at 2.9 s and at 3.1 s. At 3 s none was found"), "{both}");
    let longer = elsewhere(&model, &[3.3]).unwrap();
    assert!(
        longer.starts_with("A plan was found at 3.3 s. At 3 s none was found; whether one exists is open"),
        "{longer}"
    );
    assert_eq!(elsewhere(&model, &[]), None);
}

/// Across in 2.5 s, then around the corner and back: against both modes there is a plan of 7.01 s.
const DASH: &str = r#"
vehicle hexa {
    layout  = "PPNNPN"
    arm     = 30 cm
    mass    = 3.4 kg
    inertia = [0.05, 0.05, 0.09] kg*m^2
    rotor { max_thrust = 13 N; torque_per_thrust = 17 mm; max_speed = 7500 rpm }
}
faults { every 1 rotor lost as M }
mission dash {
    start at [0, 0, 5] m yaw 0 deg
    waypoint at [8, 0, 5] m time 2.5 s
    waypoint at [8, 8, 9] m yaw 120 deg
    waypoint at [0, 8, 5] m yaw 180 deg
    limits { tilt <= 30 deg; yaw_rate <= 60 deg/s }
}
plan { planner = rcp; timing = proportional; against = [M1, M2]; time = 7.01 s; samples = 60 }
"#;

/// With a fixed waypoint time, another set's plan with the same times serves as an initial guess too: the set of one
/// mode contains that of two.
#[test]
fn with_fixed_times_one_mode_has_the_plan_of_two() {
    let model = mavc::compile(DASH).into_result().unwrap().model().clone();
    let (sets, healthy) = (PlanningSets::of(&model), AdmissibleSet::healthy(&model));
    let mut engine = HoverPlanner::new(Problem::of(&model).unwrap(), &healthy);
    let mut plan = |set, initial_guesses: &[&Planned]| match ScpPlanner::new(&mut engine, WrenchModel::Exact, set)
        .decide(7.01, initial_guesses)
    {
        Decision::Feasible(planned) => planned,
        other => panic!("{other:?}"),
    };
    let both = plan(&sets.joint, &[]);
    let one = plan(&sets.singles[1], &[&both]);
    assert!(one.objective <= 1.01 * both.objective, "{} and {} for both", one.objective, both.objective);
}
