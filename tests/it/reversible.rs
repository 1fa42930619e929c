//! Rotors that may reverse: sets, speeds, plans with their certificates, flights, and what they cannot be combined
//! with.

use crate::vehicles::{lost, ring_model};
use mavc::actuation::Wrench;
use mavc::admissible::AdmissibleSet;
use mavc::admissible::allocation::Allocator;
use mavc::admissible::edge::HoverPlace;
use mavc::admissible::verdict::{HoverVerdict, analyze};
use mavc::flight::Outcome;
use mavc::model::Model;
use mavc::{Spec, certify, compile, fly, plan, verify};

/// The paper's hexacopter, whose rotors give down to the share `-backwards` of full thrust.
fn hexacopter(backwards: f64) -> Model {
    let mut model = ring_model("PNPNPN", 1.54, [0.0168, 0.0168, 0.0308], 8.5485e-6, 1.3678e-7, 874.0);
    model.vehicle.rotors.iter_mut().for_each(|rotor| rotor.min_speed = -874.0 * backwards.sqrt());
    model
}

/// The zonotope is scaled by 1 + share about its centre, and shifted: `{sum of f_k a_k : -share F <= f_k <= F}`.
#[test]
fn the_set_is_scaled_and_shifted() {
    let (forward, both) = (AdmissibleSet::healthy(&hexacopter(0.0)), AdmissibleSet::healthy(&hexacopter(0.4)));
    for (a, b) in forward.zonotope.generators.iter().zip(&both.zonotope.generators) {
        assert!((a * 1.4 - b).amax() < 1e-12);
    }
    let whole: Wrench = forward.zonotope.generators.iter().sum();
    assert!((both.zonotope.offset + whole * 0.4).amax() < 1e-12);
}

/// Without any one rotor PNPNPN is on the edge; with reversible rotors it keeps control of all axes, and the margin is
/// the smallest slack over all planes through three generators.
#[test]
fn a_hexacopter_keeps_yaw_without_any_rotor() {
    for k in 1..=6 {
        for (backwards, place) in [(0.0, HoverPlace::OnEdge), (0.4, HoverPlace::Inside)] {
            let mut model = hexacopter(backwards);
            model.modes = vec![lost(&model, &[k])];
            let set = AdmissibleSet::of_mode(&model, 0);
            let analysis = analyze(&model, &set);
            assert_eq!((analysis.verdict, analysis.hover), (HoverVerdict::Controllable, place), "{k} {backwards}");
            if place == HoverPlace::Inside {
                let by_hand = margin_by_planes(&model, k - 1);
                assert!((analysis.acai.unwrap() - by_hand).abs() < 1e-9, "{:?} {by_hand}", analysis.acai);
                assert!(by_hand > 0.01);
            }
        }
    }
}

/// The distance of hover from the nearest plane that touches the set along three of its generators, from thrusts alone.
fn margin_by_planes(model: &Model, lost: usize) -> f64 {
    let rotors: Vec<_> = model.vehicle.rotors.iter().enumerate().filter(|(k, _)| *k != lost).map(|(_, r)| r).collect();
    let kappa = 1.3678e-7 / 8.5485e-6;
    let column = |r: &&mavc::model::Rotor| {
        let turn = if r.spin == mavc::model::Spin::P { -kappa } else { kappa };
        Wrench::new(1.0, r.position[1], -r.position[0], turn)
    };
    let columns: Vec<Wrench> = rotors.iter().map(column).collect();
    let (full, least) = (8.5485e-6 * 874.0_f64.powi(2), -0.4 * 8.5485e-6 * 874.0_f64.powi(2));
    let hover = Wrench::new(1.54 * 9.81, 0.0, 0.0, 0.0);
    let mut nearest = f64::INFINITY;
    for i in 0..5 {
        for j in i + 1..5 {
            for k in j + 1..5 {
                let [a, b, c] = [columns[i], columns[j], columns[k]];
                let minor = |row: usize| {
                    let m = nalgebra::Matrix4x3::from_columns(&[a, b, c]).remove_row(row);
                    m.determinant() * if row.is_multiple_of(2) { 1.0 } else { -1.0 }
                };
                let normal = Wrench::new(minor(0), minor(1), minor(2), minor(3));
                if normal.norm() < 1e-9 {
                    continue;
                }
                for n in [normal.normalize(), -normal.normalize()] {
                    let support: f64 = columns.iter().map(|w| (n.dot(w) * full).max(n.dot(w) * least)).sum();
                    nearest = nearest.min(support - n.dot(&hover));
                }
            }
        }
    }
    nearest
}

/// Speeds are signed, and give the wrench that was asked for.
#[test]
fn speeds_have_a_sign() {
    let model = hexacopter(0.4);
    let wrench = Wrench::new(6.0, 1.2, -0.8, 0.15);
    let speeds = Allocator::new(&model.vehicle).speeds(&wrench);
    assert!(speeds.iter().any(|w| *w < 0.0) && speeds.iter().all(|w| *w >= -874.0 * 0.4_f64.sqrt() - 1e-9));
    let kappa = 1.3678e-7 / 8.5485e-6;
    let given = model.vehicle.rotors.iter().zip(&speeds).fold(Wrench::zeros(), |sum, (r, w)| {
        let turn = if r.spin == mavc::model::Spin::P { -kappa } else { kappa };
        sum + Wrench::new(1.0, r.position[1], -r.position[0], turn) * (8.5485e-6 * w * w.abs())
    });
    assert!((given - wrench).amax() < 1e-6, "{given}");
}

fn text(rotor: &str, more: &str) -> String {
    format!(
        "vehicle hexa {{ layout = \"PNPNPN\"; arm = 0.211 m; mass = 1.54 kg; inertia = [0.0168, 0.0168, 0.0308] kg*m^2
             rotor {{ thrust_coefficient = 8.5485e-6 N*s^2/rad^2; drag_coefficient = 1.3678e-7 N*m*s^2/rad^2; max_speed = 874 rad/s
                     {rotor} }} }}
         faults {{ every 1 rotor lost as L }}
         mission hop {{ start at [0, 0, 10] m yaw 0 deg
             waypoint at [6, 2, 11] m yaw 40 deg }}
         plan {{ planner = rcp; model = exact; time = 6 s; samples = 24; reserve = 10 %; {more} }}
         simulate {{ fault L1 at 2 s; detection = 50 ms }}"
    )
}

fn spec(text: &str) -> Spec {
    compile(text).into_result().unwrap_or_else(|e| panic!("{e}"))
}

/// With yaw: found against every loss, certified, and the heading is kept in flight.
#[test]
fn a_plan_keeps_yaw_against_every_loss() {
    let spec = spec(&text("min_speed = -550 rad/s", ""));
    let planning = plan(&spec).unwrap();
    assert!(planning.plan().is_some(), "{:?}", planning.verdict());
    let certificate = certify(&spec, &planning).unwrap();
    let accepted = verify(&serde_json::to_vec(&certificate).unwrap(), &spec).unwrap();
    assert!(accepted.shown.iter().filter(|s| s.statement.starts_with("wrench inside the set of L")).count() == 6);
    let flight = fly(&spec, &planning).unwrap();
    assert_eq!((flight.outcome, flight.gave_up_yaw_at), (Outcome::Flown, None));
    assert!(flight.heading.max < 0.2, "{}", flight.heading.max);
}

/// What they cannot be combined with is an error at its place.
#[test]
fn some_things_are_not_possible_yet() {
    let codes = |text: &str| -> Vec<(String, String)> {
        compile(text).diagnostics.iter().map(|d| (d.code.to_string(), d.message.clone())).collect()
    };
    let refused = |text: String, what: &str| {
        let found = codes(&text);
        let is_it = |(code, message): &(String, String)| code == "mavc::vehicle::min_speed" && message.contains(what);
        assert!(found.iter().any(is_it), "{found:?}");
    };
    refused(text("min_speed = -900 rad/s", ""), "at least minus `max_speed`");
    refused(text("min_speed = -500 rad/s; time_constant = 20 ms", "rotors = lagging"), "`rotors = lagging`");
    let inverse = text("min_speed = -500 rad/s", "").replace("arm =", "allocation = pseudo_inverse; arm =");
    refused(inverse, "`allocation = pseudo_inverse`");
    refused(text("min_speed = -500 rad/s", "").replace("1.54 kg", "1.54 kg +- 5 %"), "intervals");
}

/// In newtons, as a share and as a speed the same rotors; each form has its range, and two forms at once are a
/// conflict.
#[test]
fn the_lowest_thrust_is_another_way_to_write_the_lowest_speed() {
    let lowest = |rotor: &str| spec(&text(rotor, "")).model().vehicle.rotors[0].min_speed;
    let full = 8.5485e-6 * 874.0_f64.powi(2);
    for (rotor, speed) in [
        ("min_thrust = -40 %", -874.0 * 0.4_f64.sqrt()),
        ("min_thrust = -2 N", -(2.0_f64 / 8.5485e-6).sqrt()),
        ("min_thrust = 0.1", 874.0 * 0.1_f64.sqrt()),
        ("min_thrust = 0 N", 0.0),
        ("min_thrust = -100 %", -874.0),
        (&format!("min_thrust = {} N", -full), -874.0),
    ] {
        assert!((lowest(rotor) - speed).abs() < 1e-9, "{rotor}: {}", lowest(rotor));
    }
    for (rotor, words) in [
        ("min_thrust = -101 %", "`min_thrust` must be at least minus the thrust at full speed"),
        ("min_thrust = 7 N", "`min_thrust` must be below the thrust at full speed"),
        ("min_thrust = 2", "newtons have their"),
        ("min_thrust = 3 rad/s", "`min_thrust`"),
        ("min_thrust = 1 N; min_speed = 3 rad/s", "`min_speed` and `min_thrust` cannot both be given"),
    ] {
        let error = compile(&text(rotor, "")).into_result().expect_err(rotor).to_string();
        assert!(error.contains(words), "{rotor}: {error}");
    }
}
