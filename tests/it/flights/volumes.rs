//! Stops after a fault keep the volumes of the mission, and a vehicle that is past their boundary has not survived.

use super::{quiet, sortie, staying};
use crate::cli::mavc;
use crate::vehicles::{mission, octocopter, waypoint};
use mavc::body::Body;
use mavc::flight::{Outcome, Sortie, fly};
use mavc::model::{Mission, Volume, VolumeSide};
use mavc::source::Span;

const WALL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/specs/flown/wall.mav");

fn volume(side: VolumeSide, centre: [f64; 3], radius: f64) -> Volume {
    Volume {
        name: "v".into(),
        side,
        bodies: vec![Body::Ball { centre, radius }],
        clearance: 0.0,
        span: Span::default(),
    }
}

/// A stop from the speed at the fault would end in the wall or behind it. The vehicle follows the plan, whose end is in
/// front of it; the smallest distance in the flight is above zero.
#[test]
fn a_stop_through_a_wall_is_not_flown() {
    for (after_fault, word) in [("hold", "Simulated to its end"), ("land", "Landed at")] {
        for at in ["1.5 s", "3 s", "4.5 s"] {
            let text = std::fs::read_to_string(WALL).unwrap().replace("fault w at 3 s", &format!("fault w at {at}"));
            let text = text.replace("after_fault = hold", &format!("after_fault = {after_fault}"));
            let ran = crate::cli::mavc_with(&["simulate", "-v", "-", "-q"], &text);
            let told = String::from_utf8_lossy(&ran.stdout);
            assert_eq!(ran.status.code(), Some(0), "{after_fault} {at} {told}");
            assert!(told.contains(word), "{after_fault} {at} {told}");
        }
    }
}

/// A vehicle at a place inside a `keep_out`, outside a `keep_in`, or beside both.
#[test]
fn a_vehicle_past_a_boundary_has_not_survived() {
    let model = quiet(octocopter("PPNNPPNN"));
    let hover = staying([0.0, 0.0, 10.0], 0.0, 1.0);
    let outcome = |side: VolumeSide, centre: [f64; 3], radius: f64| {
        let points = vec![waypoint([0.0, 0.0, 10.0], 0.0), waypoint([0.0, 0.0, 10.0], 0.0)];
        let mission = Mission { volumes: vec![volume(side, centre, radius)], ..mission(points) };
        fly(&Sortie { mission: Some(&mission), ..sortie(&model, &hover, &[]) }, None).outcome
    };
    let size = model.vehicle.radius();
    let past = Outcome::Trespassed { at: 0.0 };
    assert_eq!(outcome(VolumeSide::KeepOut, [0.0, 0.0, 10.0], 3.0), past);
    // The vehicle reaches its radius into the ball, or 1 cm less than 10 cm less far.
    assert_eq!(outcome(VolumeSide::KeepOut, [0.0, 0.0, 5.0], 5.0), past);
    assert_eq!(outcome(VolumeSide::KeepOut, [0.0, 0.0, 5.0], 5.0 - size + 0.09), Outcome::Flown);
    assert_eq!(outcome(VolumeSide::KeepIn, [0.0, 0.0, 5.0], 4.0), past);
    assert_eq!(outcome(VolumeSide::KeepIn, [0.0, 0.0, 5.0], 5.0 + size - 0.09), Outcome::Flown);
    assert!(!past.is_survived() && !past.is_lost());
}

/// The wind carries a vehicle out of its field, and it is not lost: the command ends with 6.
#[test]
fn the_command_ends_with_the_code_of_a_loss_past_a_boundary() {
    let text = std::fs::read_to_string(WALL).unwrap();
    let blown = text.replace("seed = 3 }", "seed = 3; drag = 3 N*s/m; wind = [0, -4, 0] m/s; lost_beyond = 50 m }");
    let ran = crate::cli::mavc_with(&["simulate", "-v", "-", "-q"], &blown);
    let told = String::from_utf8_lossy(&ran.stdout);
    assert_eq!(ran.status.code(), Some(6), "{told}");
    assert!(told.contains("NOT SURVIVED: from 3.") && !told.contains("LOST"), "{told}");
    assert_eq!(mavc(&["check", WALL, "-q"]).status.code(), Some(0));
}
