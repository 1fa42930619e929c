//! Intervals of `drag`, `yaw_drag` and `rotor_inertia`: how they are written, at which end verdicts take them, and
//! where outcomes change inside.

use crate::cli::mavc;
use mavc::Spec;
use mavc::admissible::outcome::Outcome;
use mavc::flight::equilibrium::flips::interval_flips;
use mavc::flight::variation::corners;
use mavc::model::{DynamicFigure, Model, Spread};
use mavc::report::headline::why_undecided;

fn text(vehicle: &str, rotor: &str, more: &str) -> String {
    format!(
        "vehicle v {{
            layout = \"PNPN\"; arm = 30 cm; mass = 2 kg; inertia = [0.05, 0.05, 0.09] kg*m^2; {vehicle}
            rotor {{ max_thrust = 13 N; torque_per_thrust = 17 mm; max_speed = 7500 rpm; {rotor} }}
        }}
        faults {{ mode a {{ rotor 1 lost }} }}
        {more}"
    )
}

fn spec(vehicle: &str, rotor: &str, more: &str) -> Spec {
    mavc::compile(&text(vehicle, rotor, more)).into_result().unwrap_or_else(|e| panic!("{e}"))
}

fn outcomes(model: &Model) -> Vec<Outcome> {
    mavc::flight::equilibrium::outcomes(model)
}

fn code(vehicle: &str, rotor: &str) -> String {
    let error = mavc::compile(&text(vehicle, rotor, "")).into_result().unwrap_err();
    error.diagnostics.iter().map(|d| d.code).collect::<Vec<_>>().join(" ")
}

#[test]
fn drag_is_an_interval_along_one_or_three_axes() {
    for (written, drag, low) in [
        ("drag = 0.4 N*s/m +- 25 %", [0.4; 3], 0.75),
        ("drag = 0.4 N*s/m +- 0.1 N*s/m", [0.4; 3], 0.75),
        ("drag = (0.4 +- 0.1) N*s/m", [0.4; 3], 0.75),
        ("drag = [0.4, 0.4, 0.2] N*s/m +- 25 %", [0.4, 0.4, 0.2], 0.75),
        ("drag = [0.4, 0.3, 0.2] N*s/m", [0.4, 0.3, 0.2], 1.0),
        ("drag = 0 N*s/m", [0.0; 3], 1.0),
    ] {
        let vehicle = spec(written, "", "").model().vehicle.clone();
        assert!(vehicle.drag.iter().zip(drag).all(|(a, b)| (a - b).abs() < 1e-12), "{written}: {:?}", vehicle.drag);
        let Spread { low: found, high } = vehicle.drag_spread;
        assert!((found - low).abs() < 1e-12 && (high - (2.0 - low)).abs() < 1e-12, "{written}: {found} {high}");
        assert!(vehicle.has_intervals() == (low < 1.0) && !vehicle.is_uncertain(), "{written}");
    }
    for written in [
        "drag = 0.4 N*s/m +- 100 %",
        "drag = 0.4 N*s/m +- 0.1",
        "drag = [0.4, 0.4, 0.2] N*s/m +- 0.1 N*s/m",
        "drag = [0.4, 0.4, 0.2] N*s/m +- 0.2",
        "drag = [0.4, 0.4, 0.2] N*s/m +- 120 %",
    ] {
        assert_eq!(code(written, ""), "mavc::unit::interval", "{written}");
    }
    // Flights have one drag.
    let flown = text("", "", "simulate { drag = 0.4 N*s/m +- 25 % }");
    let error = mavc::compile(&flown).into_result().unwrap_err();
    assert!(error.diagnostics.iter().any(|d| d.code == "mavc::unit::interval"), "{error}");
}

#[test]
fn rotor_inertia_is_an_interval_of_all_rotors_at_the_same_share() {
    let model = spec("yaw_drag = 4e-3 N*m*s/rad", "rotor_inertia = 4e-5 kg*m^2 +- 50 %", "").model().clone();
    let spread = Spread { low: 0.5, high: 1.5 };
    assert!(model.vehicle.rotors.iter().all(|rotor| rotor.inertia == 4e-5 && rotor.inertia_spread == spread));
    let found: Vec<Vec<f64>> =
        corners(&model.vehicle).iter().map(|v| v.rotors.iter().map(|rotor| rotor.inertia).collect()).collect();
    for (found, expected) in found.iter().zip([2e-5, 6e-5]) {
        assert!(found.iter().all(|inertia| (inertia / expected - 1.0).abs() < 1e-12), "{found:?}");
    }
    assert_eq!(found.len(), 2);
    assert_eq!(code("", "rotor_inertia = 4e-5 kg*m^2 +- 100 %"), "mavc::unit::interval");
}

/// Flights at the ends of `drag` have that drag, unless `simulate` gives its own.
#[test]
fn flights_at_the_corners_have_their_own_drag() {
    let drags = |more: &str| {
        let model = spec("drag = 0.4 N*s/m +- 25 %", "", more).model().clone();
        let of = |vehicle| mavc::flight::body::Frame::of_vehicle(vehicle, &model).drag.x;
        corners(&model.vehicle).iter().map(of).collect::<Vec<f64>>()
    };
    assert!(drags("").iter().zip([0.3, 0.5]).all(|(a, b)| (a - b).abs() < 1e-12), "{:?}", drags(""));
    assert_eq!(drags("simulate { drag = 0.1 N*s/m }"), [0.1; 2]);
}

/// In level flight through still air only the product of drag and speed matters.
#[test]
fn the_airspeed_is_that_of_the_largest_drag() {
    let speed = |drag: &str| mavc::analyze(&spec(drag, "", ""))[0].airspeed.unwrap().largest_m_per_s.unwrap();
    for (interval, largest) in [
        ("drag = 0.4 N*s/m +- 25 %", "drag = 0.5 N*s/m"),
        ("drag = [0.4, 0.2, 0.1] N*s/m +- 25 %", "drag = [0.5, 0.25, 0.125] N*s/m"),
    ] {
        let [of_interval, of_largest] = [interval, largest].map(speed);
        assert!((of_interval / of_largest - 1.0).abs() < 1e-9, "{interval}: {of_interval} {of_largest}");
    }
}

/// The outcome changes once inside the interval, at the value that is named: a little below and above it the outcomes
/// without an interval are those of the two sides.
fn changes_where_it_says(interval: &Model, field: &str, with: impl Fn(f64) -> Model) {
    let found = outcomes(interval);
    let flips = interval_flips(interval, &found);
    assert!(!flips.is_empty() && flips.iter().all(|flip| flip.field == field), "{flips:?} {found:?}");
    for flip in &flips {
        let mode = interval.modes.iter().position(|mode| mode.name == flip.mode).map_or(0, |mode| mode + 1);
        assert_eq!(found[mode], Outcome::Undecided);
        assert_eq!(outcomes(&with(0.99 * flip.at))[mode], flip.below_outcome, "{flip:?}");
        assert_eq!(outcomes(&with(1.01 * flip.at))[mode], flip.above_outcome, "{flip:?}");
        assert_ne!(flip.below_outcome, flip.above_outcome);
    }
    let why = why_undecided(interval, &found).unwrap();
    assert!(why.contains(&format!("up to `{field}` = ")), "{why}");
}

#[test]
fn an_interval_of_the_yaw_drag_says_where_the_spin_leaves_the_gyroscope() {
    let with = |drag: &str| {
        let mut model = spec(&format!("yaw_drag = {drag}"), "", "").model().clone();
        let slow = mavc::flight::equilibrium::settled_spins(&model)[0].spin_rad_s.abs();
        model.simulation.gyroscope_range = 1.0;
        (model, slow)
    };
    let (mut model, slow) = with("4e-3 N*m*s/rad +- 50 %");
    model.simulation.gyroscope_range = 1.01 * slow;
    let range = model.simulation.gyroscope_range;
    changes_where_it_says(&model, "yaw_drag", |at| {
        let (mut model, _) = with(&format!("{at} N*m*s/rad"));
        model.simulation.gyroscope_range = range;
        model
    });
}

/// In a wind the thrust of hover grows with the drag, until the healthy vehicle cannot give it.
#[test]
fn an_interval_of_the_drag_says_where_hover_in_the_wind_ends() {
    let mission = "mission m { start at [0, 0, 5] m; waypoint at [5, 0, 5] m; air { wind = [20, 0, 0] m/s } }
        plan { model = exact; against = [] }";
    let with = |drag: &str| spec(&format!("drag = {drag}"), "", mission).model().clone();
    // The rotors give 52 N: the wind may take sqrt(52^2 - 19.62^2) = 48.2 N, 2.4 N*s/m at 20 m/s.
    let model = with("2 N*s/m +- 40 %");
    changes_where_it_says(&model, "drag", |at| with(&format!("{at} N*s/m")));
    let flips = interval_flips(&model, &outcomes(&model));
    let healthy = flips.iter().find(|flip| flip.mode == "healthy").unwrap();
    let ends = (52.0_f64.powi(2) - (2.0 * model.gravity).powi(2)).sqrt() / 20.0;
    assert!((healthy.at / ends - 1.0).abs() < 2e-3, "{} {ends}", healthy.at);
    assert_eq!((healthy.below_outcome, healthy.above_outcome), (Outcome::FullControl, Outcome::Lost));
    // An interval that decides nothing leaves the outcomes of its middle.
    assert_eq!(outcomes(&with("0.5 N*s/m +- 50 %")), outcomes(&with("0.5 N*s/m")));
}

/// `mavc check` and `mavc analyze` say which value decides.
#[test]
fn check_and_analyze_name_the_value() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("v.mav");
    let air = "mission m { start at [0, 0, 5] m; waypoint at [5, 0, 5] m; air { wind = [20, 0, 0] m/s } }
        plan { model = exact; against = [] }";
    std::fs::write(&path, text("drag = 2 N*s/m +- 40 %", "", air)).unwrap();
    let path = path.to_str().unwrap();
    for command in [&["check", path][..], &["analyze", path]] {
        let printed = String::from_utf8(mavc(command).stdout).unwrap();
        let printed = printed.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(printed.contains("healthy: full control up to `drag` = 2.4"), "{printed}");
    }
    let json = mavc(&["analyze", path, "--format", "json"]).stdout;
    let json: serde_json::Value = serde_json::from_slice(&json).unwrap();
    assert!(json["interval_flips"].as_array().unwrap().iter().all(|flip| flip["field"] == "drag"), "{json}");
}

#[test]
fn the_ends_of_a_figure_are_those_of_its_interval() {
    let model = spec("drag = 0.4 N*s/m +- 25 %; yaw_drag = 4e-3 N*m*s/rad +- 50 %", "", "").model().clone();
    for (figure, share, value) in
        [(DynamicFigure::Drag, 0.0, 0.3), (DynamicFigure::Drag, 1.0, 0.5), (DynamicFigure::YawDrag, 0.5, 4e-3)]
    {
        let moved = model.at(figure, share);
        assert!((figure.largest(&moved.vehicle) - value).abs() < 1e-12);
        assert!(figure.spread(&moved.vehicle).is_none());
        assert_eq!(moved.simulation.drag, moved.vehicle.drag);
    }
}
