//! What limits the time, against closed forms and against plans of relaxed specs.

use super::{Model, last, planning, solved};
use crate::vehicles::{limit, mission, waypoint};
use mavc::model::{LimitKind, Mission, MissionTime, PlannerKind, Problem};
use mavc::planner::scp::sensitivity::Statement;
use mavc::planner::studies::{MissionPlan, Scope, run_planners};

fn planned(mission: Mission, chooses_times: bool) -> MissionPlan {
    let mut model: Model = planning(mission, PlannerKind::Rip, &[], MissionTime::Minimum);
    model.plan.samples = 40;
    model.plan.chooses_times = chooses_times;
    solved(last(&run_planners(Problem::of(&model).unwrap(), Scope::Plan, None))).clone()
}

/// Up 40 m at no more than 2 m/s: d/v and what starting and stopping take, of which 1 % more speed gives back 1 % of
/// d/v.
#[test]
fn a_long_climb_is_limited_by_its_rate() {
    let mut up = mission(vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint([0.0, 0.0, 42.0], 0.0)]);
    up.limits = vec![limit(LimitKind::Climb, 2.0)];
    let plan = planned(up, false);
    let [leg] = &plan.binding[..] else { panic!("{:?}", plan.binding) };
    let (statement, seconds) = leg.statements[0];
    assert_eq!(statement, Statement::Limit(0));
    assert!((seconds - 0.2).abs() < 0.02, "{seconds}");
    assert!((leg.duration - plan.time).abs() < 1e-9);
}

/// A leg that ends at a fixed time lasts as long as the spec says, however tight that is; after it 1 % more speed gives
/// back 1 % of d/v.
#[test]
fn nothing_before_a_fixed_time_gives_time_back() {
    let stops = [[0.0, 0.0, 2.0], [0.0, 0.0, 22.0], [0.0, 0.0, 62.0]];
    for fixed in [12.0, 30.0] {
        let mut up = mission(stops.map(|at| waypoint(at, 0.0)).to_vec());
        up.waypoints[1].time = Some(fixed);
        up.limits = vec![limit(LimitKind::Climb, 2.0)];
        let plan = planned(up, true);
        let [before, after] = &plan.binding[..] else { panic!("{:?}", plan.binding) };
        assert_eq!(before.statements, [], "{fixed}");
        let (statement, seconds) = after.statements[0];
        assert_eq!(statement, Statement::Limit(0));
        assert!((seconds - 0.2).abs() < 0.03, "{seconds}");
    }
}

mod thorough {
    use super::*;

    /// Legs that one limit governs, against the plan with that limit relaxed by ten units: within a fifth of the
    /// difference, and the 0.02 s to which times are rounded.
    #[test]
    #[ignore = "long"]
    fn figures_are_what_relaxed_specs_give_back() {
        let governed = [
            ([60.0, 0.0, 2.0], limit(LimitKind::Speed, 4.0)),
            ([40.0, 0.0, 2.0], limit(LimitKind::Tilt, f64::to_radians(12.0))),
            ([0.0, 0.0, 42.0], limit(LimitKind::Climb, 3.0)),
            ([30.0, 10.0, 2.0], limit(LimitKind::AccelerationHorizontal, 1.5)),
        ];
        for (to, governing) in governed {
            let flown = |factor: f64| {
                let mut mission = mission(vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint(to, 0.0)]);
                mission.limits =
                    vec![mavc::model::Limit { upper: governing.upper.map(|u| factor * u), ..governing.clone() }];
                planned(mission, false)
            };
            let plan = flown(1.0);
            let own = plan.binding[0].statements.iter().find(|(statement, _)| *statement == Statement::Limit(0));
            let due = 10.0 * own.map_or(0.0, |(_, seconds)| *seconds);
            let given = plan.time - flown(1.1).time;
            println!("{:?}: {due} {given}", governing.kind);
            assert!(
                (given - due).abs() <= 0.2 * given + 0.02,
                "{:?}: {due} s due, {given} s given back",
                governing.kind
            );
        }
    }
}
