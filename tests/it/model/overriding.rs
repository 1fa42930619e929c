//! `--set` replaces or adds fields, and its mistakes have places of their own.

use super::QUAD;
use mavc::diagnostic::Checked;
use mavc::model::{Limit, LimitKind, MissionTime, Model};
use mavc::read::{elaborate, load, parse_override};
use std::io;

const REST: &str = "let a = 4 m\nfaults { every 1 rotor lost as M }\nmission m {\n start at [0, 0, 2] m\n waypoint at [a, 0, 2] m\n limits { tilt <= 30 deg }\n}\nplan { time = minimum; against = all }\n";

fn with(sets: &[&str]) -> Checked<Model> {
    let text = format!("{QUAD}{REST}");
    let (mut files, diagnostics) = load("s.mav", text.as_bytes(), &|_| Err(io::Error::from(io::ErrorKind::NotFound)));
    assert_eq!(diagnostics, vec![]);
    let overrides: Vec<_> = sets.iter().map(|text| parse_override(text, &mut files.sources).unwrap()).collect();
    elaborate(&files, &overrides)
}

#[test]
fn fields_of_every_block_can_be_set() {
    let sets = [
        "plan.time=20s",
        "plan.against=[M1]",
        "plan.reserve = 5 %",
        "vehicle.mass=2kg",
        "vehicle.rotor.max_speed=850 rad/s",
        "mission.limits.tilt=20deg",
        "mission.limits.altitude=1 .. 9 m",
        "gravity=9.80665m/s^2",
        "a=5 m",
    ];
    let model = with(&sets).value.unwrap();
    assert_eq!((model.plan.time, model.plan.against, model.plan.reserve), (MissionTime::Fixed(20.0), vec![0], 0.05));
    assert_eq!((model.vehicle.mass, model.vehicle.rotors[0].max_speed, model.gravity), (2.0, 850.0, 9.80665));
    let mission = model.mission.unwrap();
    assert_eq!(mission.waypoints[1].position, [5.0, 0.0, 2.0]);
    let limits: Vec<(LimitKind, Option<f64>, Option<f64>)> =
        mission.limits.iter().map(|l: &Limit| (l.kind.clone(), l.lower, l.upper)).collect();
    assert_eq!(limits, [(LimitKind::Tilt, None, Some(20f64.to_radians())), (LimitKind::Z, Some(1.0), Some(9.0))]);
    assert!(model.defaults.iter().all(|d| d.field != "plan.reserve"));
}

#[test]
fn flights_can_be_set_with_or_without_their_blocks() {
    let model = with(&["simulate.rate=2kHz", "simulate.detection=never", "campaign.seeds=3"]).value.unwrap();
    assert_eq!((model.simulation.written, model.simulation.rate), (true, 2000.0));
    assert_eq!(model.simulation.detection, mavc::model::Detection::Never);
    assert_eq!((model.campaign.written, model.campaign.seeds, model.campaign.times), (true, 3, 20));
    let found = with(&["simulate.rate=-2kHz"]).diagnostics;
    assert_eq!(found[0].code, "mavc::simulate::not_positive");
}

#[test]
fn a_filter_can_be_set() {
    let checked = with(&["plan.against=where severity >= 3"]);
    assert_eq!(checked.value.unwrap().plan.against, Vec::<usize>::new());
    assert_eq!(checked.diagnostics[0].code, "mavc::plan::none_selected");
}

#[test]
fn mistakes_in_overrides_have_places_in_them() {
    for (set, code, text) in [
        ("plan.time=20m", "mavc::unit::mismatch", "20m"),
        ("plan.tme=20s", "mavc::name::unknown_field", "tme"),
        ("plane.time=20s", "mavc::name::override", "plane"),
        ("mission.wind.speed=3m/s", "mavc::name::override", "wind"),
        ("b=3 m", "mavc::name::override", "b"),
        ("vehicle.mass=-2kg", "mavc::vehicle::not_positive", "-2kg"),
    ] {
        let checked = with(&[set]);
        assert!(checked.value.is_none());
        let found = &checked.diagnostics[0];
        assert_eq!(found.code, code, "{set}");
        assert_eq!(&set[found.span.start as usize..found.span.end as usize], text);
    }
}

#[test]
fn a_misspelt_override_is_reported_though_the_spec_has_the_field_too() {
    let checked = with(&["plan.tiem=8s"]);
    assert_eq!(checked.diagnostics[0].help.as_deref(), Some("write `--set plan.time=8s`"));
}

#[test]
fn what_is_no_override_is_an_error() {
    let mut sources = mavc::source::SourceMap::default();
    for text in [
        "",
        "plan",
        "plan.time",
        "plan.time=",
        "=3",
        "plan..time=3 s",
        "plan.time=20 s; x=3",
        "a b.c=3",
        "plan.time==3 s",
        "plan {",
    ] {
        let error = parse_override(text, &mut sources).unwrap_err();
        assert!(error.code.starts_with("mavc::"), "{text}");
        assert!(error.span.end as usize <= text.len(), "{text}");
    }
}

/// The blocks of the time after a fault are added where a spec has none, and changed where it has.
#[test]
fn recovery_and_the_limits_after_a_fault_can_be_set() {
    let sets = [
        "mission.ground=0 m",
        "mission.buffer=3 m",
        "mission.after_fault_limits.tilt=45deg",
        "mission.after_fault_limits.descent=4 m/s",
        "plan.recovery.order=[land_here]",
        "plan.recovery.detection=100 ms .. 200 ms",
        "plan.recovery.within=12 s",
    ];
    let model = with(&sets).value.unwrap();
    let rules = model.mission.unwrap().after_fault;
    let limits: Vec<String> = rules.limits.iter().map(ToString::to_string).collect();
    assert_eq!((rules.buffer, limits), (3.0, vec!["tilt <= 45 deg".to_string(), "descent <= 4 m/s".to_string()]));
    let recovery = model.plan.recovery;
    assert_eq!((recovery.order, recovery.detection), (vec![mavc::model::Recovery::LandHere], [0.1, 0.2]));
    assert_eq!(recovery.within, 12.0);
    for (set, code) in [
        ("plan.recovery.until=3 s", "mavc::name::unknown_field"),
        ("mission.after_fault_limits.altitude=30 m", "mavc::recovery::limit"),
        ("plan.recovery.order=[pad]", "mavc::name::unknown"),
        ("plan.recovery.order=land_here", "mavc::recovery::order"),
    ] {
        let found = with(&["mission.ground=0 m", set]).diagnostics;
        assert!(found.iter().any(|d| d.code == code), "{set}: {found:?}");
    }
}
