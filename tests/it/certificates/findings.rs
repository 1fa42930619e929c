//! Forgeries that were once accepted, and specs of which too much was once said.

use super::decide;
use crate::vehicles::lost;
use mavc::certificate::{Certificate, Claim, InfeasibleClaim, Multiplier, RowRecord, Side};
use mavc::model::grid::Spacing;
use mavc::model::{GiveUpYaw, Model, PlannerKind, Spread, YawDrag};
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/specs/findings")
}

/// A spec of the corpus, elaborated.
fn spec(name: &str) -> Model {
    let path = folder().join(format!("{name}.mav"));
    mavc::Compiler::new().file(path).unwrap().into_result().unwrap().model().clone()
}

fn forged(name: &str) -> Certificate {
    let text = std::fs::read_to_string(folder().join(format!("{name}.forged.json"))).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn refused(name: &str) -> String {
    decide(&forged(name), &spec(name)).unwrap_err().sentence()
}

/// Five metres in a second under 5 m/s^2, by velocities that jump at both ends of pieces of a microsecond.
#[test]
fn short_pieces_buy_no_jump() {
    let told = refused("teleport");
    assert!(told.starts_with("the joints of the motion at ") && told.contains("m/s in velocity"), "{told}");
}

/// Ten pieces where a thousand samples are asked for: rows are looked at where those samples lie.
#[test]
fn few_pieces_hide_nothing() {
    let told = refused("nodes_not_tied");
    assert!(told.starts_with("limit 1 (jerk) at "), "{told}");
}

/// A leg from rest to rest in one piece has no motion; the spec's samples make more pieces.
#[test]
fn pieces_per_leg_are_the_specs() {
    let told = refused("nodes_per_leg");
    assert!(told.starts_with("the claim that there is no plan") || told.starts_with("multiplier"), "{told}");
}

/// RCP's proof is none for RSP, which selects other facets; without rounds it selects none.
#[test]
fn another_planners_proof_shows_nothing() {
    let told = refused("other_planner");
    assert!(told.contains("the planner does not impose this mode's set"), "{told}");
    let mut model = spec("other_planner");
    model.plan.rounds = 1;
    let told = decide(&forged("other_planner"), &model).unwrap_err().sentence();
    assert!(told.contains("no included plan violates it"), "{told}");
}

/// Numbers near 2^64 in every place that counts nodes, intervals, waypoints, limits, facets, axes or derivatives.
#[test]
fn no_index_overflows() {
    assert!(decide(&forged("overflow"), &spec("overflow")).is_err());
    let model = spec("other_planner");
    let Claim::Infeasible(whole) = forged("other_planner").claim else { panic!("a plan") };
    for most in [usize::MAX, usize::MAX - 1, usize::MAX / 2, 1 << 32, 81] {
        for row in [
            RowRecord::Rest { node: most, axis: 0, derivative: 1 },
            RowRecord::Rest { node: 0, axis: most, derivative: 1 },
            RowRecord::Rest { node: 0, axis: 0, derivative: most },
            RowRecord::Facet { facet: most, node: 0 },
            RowRecord::Facet { facet: 0, node: most },
            RowRecord::Commands { facet: 0, node: 0, interval: most },
            RowRecord::Commands { facet: 0, node: most, interval: most },
            RowRecord::Limit { limit: most, node: 0, side: Side::Upper },
            RowRecord::Limit { limit: 0, node: most, side: Side::Upper },
            RowRecord::LimitNorm { limit: 0, node: 0, interval: most },
            RowRecord::LimitNorm { limit: 0, node: most, interval: most },
            RowRecord::Thrust { node: most },
            RowRecord::Waypoint { waypoint: most },
            RowRecord::WaypointYaw { waypoint: most, side: Side::Lower },
        ] {
            for exact in [false, true] {
                let mut model = model.clone();
                let kind =
                    if exact { mavc::certificate::DynamicModel::Exact } else { mavc::certificate::DynamicModel::Hover };
                model.plan.model = if exact { mavc::model::PlanModel::Exact } else { mavc::model::PlanModel::Hover };
                model.plan.planner = PlannerKind::Rcp;
                let multipliers = vec![Multiplier { row, z: vec![1.0] }];
                let claim = InfeasibleClaim { multipliers, ..whole.clone() };
                let certificate =
                    Certificate { model: kind, claim: Claim::Infeasible(claim), ..forged("other_planner") };
                let told = decide(&certificate, &model).unwrap_err();
                assert!(!told.claim.is_empty(), "{row:?}");
            }
        }
    }
}

/// A motion on a coarser grid than the spec's samples whose rows hold all the same is true, and weaker.
#[test]
fn fewer_pieces_are_weaker() {
    let mut model = super::hop(PlannerKind::Rip, 12.0);
    let certificate = super::certified(&model).unwrap();
    assert!(decide(&certificate, &model).unwrap().weaker.is_empty());
    model.plan.samples = 61;
    let weaker = decide(&certificate, &model).unwrap().weaker;
    assert!(
        weaker.len() == 1 && weaker[0].starts_with("fewer pieces than the spec's 61 samples give, on 2 of 2 legs"),
        "{weaker:?}"
    );
}

/// A mode in which the rotors give a tenth of their thrust: nothing catches it, spinning or not, so that without a record its
/// whole set is imposed.
#[test]
fn what_cannot_hover_is_not_caught_by_its_spin() {
    let mut model = super::hop(PlannerKind::Rip, 12.0);
    model.plan.reserve = 0.0;
    let certificate = super::certified(&model).unwrap();
    let mut weak = lost(&model, &[]);
    (weak.name, weak.without_yaw) = ("weak".into(), Some(GiveUpYaw::Always));
    weak.capacity.fill(0.1);
    model.modes.push(weak);
    model.vehicle.yaw_drag = Some(YawDrag { linear: 2.75e-3, spread: Spread::NONE, quadratic: 0.0 });
    model.plan.planner = PlannerKind::Rcp;
    model.plan.against = vec![model.modes.len() - 1];
    let told = decide(&certificate, &model).unwrap_err().sentence();
    assert!(told.contains("the set of weak"), "{told}");
}

/// Times of a certificate whose ratio is not a number, which only the check of shapes keeps away from grids.
#[test]
fn graded_pieces_have_no_endless_share() {
    assert!(Spacing::Graded.share(f64::INFINITY, f64::NAN).is_nan());
    assert!((Spacing::Graded.share(4.0, 0.75) + Spacing::Graded.share(4.0, 0.25) - 1.0).abs() < 1e-12);
}
