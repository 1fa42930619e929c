//! Faults after which a vehicle has to be caught: at which heights simulated flights catch and land it.

use mavc::flight::capture::heights::CaptureHeights;
use mavc::model::Problem;
use mavc::motion::{Trajectory, Z};
use mavc::planner::studies::{PlanOutcome, Scope, run_planners};
use mavc::recovery::{ModeRecovery, NotAttempted, Way, flown_way_out, recovery};

/// Up from half a metre to 9 m.
const CLIMB: &str = "vehicle quad {
    layout = \"PNPN\"; first = 45 deg; arm = 23 cm; mass = 1.9 kg; inertia = [0.018, 0.018, 0.033] kg*m^2
    yaw_drag = 5e-3 N*m*s/rad
    rotor {
        max_thrust = 11 N; torque_per_thrust = 15 mm; max_speed = 8000 rpm
        time_constant = 20 ms; rotor_inertia = 4e-5 kg*m^2
    }
}
faults { mode L1 { rotor 1 lost } }
mission climb {
    ground = 0 m
    start at [0, 0, 0.5] m  yaw 0 deg
    waypoint at [0, 0, 9] m  yaw 0 deg
}
plan {
    planner = rip; against = []; time = 16 s; samples = 40
    recovery { order = [land_here]; detection = 100 ms; within = 30 s }
}";

fn looked_for(text: &str) -> (ModeRecovery, Trajectory) {
    let spec = mavc::compile(text).into_result().unwrap();
    let problem = Problem::of(spec.model()).unwrap();
    let comparison = run_planners(problem, Scope::Plan, None);
    let PlanOutcome::Planned(plan) = &comparison.runs.last().unwrap().outcome else { panic!("no plan") };
    let found = recovery(problem, &plan.trajectory, false);
    assert!(found.branches.is_empty() && found.failed.is_empty());
    (found.modes[0].clone(), plan.trajectory.clone())
}

/// Too low it hits the ground, and above some height it is caught. That height is at most what regaining level flight
/// costs, and more than a fall during the delay takes.
#[test]
fn a_quadcopter_is_caught_above_some_height() {
    let (found, plan) = looked_for(CLIMB);
    let ways: Vec<Option<Way>> = found.pieces.iter().map(|piece| piece.way).collect();
    assert_eq!((ways, found.not_attempted), (vec![None, Some(Way::Caught)], None));
    let least = plan.at(found.pieces[1].from)[Z][0];
    let spec = mavc::compile(CLIMB).into_result().unwrap();
    let model = spec.model();
    let heights = CaptureHeights::simulate(model, 0.1, 0.0, 5).unwrap();
    let lost = heights.greatest();
    assert!(0.3 * lost < least && least < 1.1 * lost, "{least} {lost}");
    // A flight that takes its way out lands, as told.
    let problem = Problem::of(model).unwrap();
    let way = flown_way_out(problem, &plan, 0, 15.0, 15.1).unwrap();
    assert_eq!(way.words(), "caught by its spin, stopping and landing");
}

#[test]
#[ignore = "long"]
fn where_it_may_not_land_it_is_not_caught() {
    let without = |from: &str, to: &str| {
        assert!(CLIMB.contains(from));
        let (found, plan) = looked_for(&CLIMB.replace(from, to));
        assert!((found.uncovered() - plan.duration()).abs() < 1e-9, "{found:?}");
        found.not_attempted
    };
    // A fall and a landing take longer.
    assert_eq!(without("within = 30 s", "within = 1 s"), None);
    let street = "keep_off street { shape = box; from = [-50, -50] m; to = [50, 50] m }\n    start at";
    assert_eq!(without("start at", street), None);
    let pad = "landing_site pad { at = [40, 0, 0] m; radius = 1 m }\n    start at";
    let to_pad = CLIMB.replace("start at", pad).replace("[land_here]", "[land_at_sites]");
    assert!(looked_for(&to_pad).0.pieces.iter().all(|piece| piece.way.is_none()));
    // Where the plan may only be continued, nothing is sought.
    assert_eq!(without("[land_here]", "[continue]"), Some(NotAttempted::Caught));
}
