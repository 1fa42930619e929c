//! Forgeries that were once accepted, and specs of which too much was once said.

use super::decide;
use crate::vehicles::lost;
use mavc::certificate::{Certificate, Claim, InfeasibleClaim, Multiplier, RowRecord, Side, SpinRecord};
use mavc::model::grid::Spacing;
use mavc::model::{GiveUpYaw, Model, PlannerKind, Problem, RotorState, Spread, YawDrag};
use mavc::planner::timing::kinematics::least_time_within;
use mavc::verify::{Premise, Premises, Settings};
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

/// With rotors that reverse the thrust pulls down: the closed form of 198 m at g + 24 m/s^2 and 24 m/s^2 - g is 6.29 s.
#[test]
fn reversed_thrust_falls_faster() {
    let told = refused("reversible_falls");
    assert!(told.starts_with("the earliest arrival at waypoint 2: 7.46 s is claimed"), "{told}");
    let model = spec("reversible_falls");
    let least = least_time_within(Problem::of(&model).unwrap()).seconds;
    let closed = (2.0 * 198.0 * (1.0 / (24.0 + 9.81) + 1.0 / (24.0 - 9.81_f64))).sqrt();
    assert!(least < closed && least > 0.999 * closed, "{least} {closed}");
}

/// Yaw rates with a side of 10 and one of 90 deg/s: turning right is not bounded by the slow one.
#[test]
fn each_direction_of_a_turn_has_its_own_limit() {
    let told = refused("uneven_yaw_rate");
    assert!(told.starts_with("the earliest arrival at waypoint 2: 8.59215 s is claimed"), "{told}");
}

/// A reserve does not enlarge a set without hover: the motion's 9 N lie far above the 2.56 N of the weak vehicle.
#[test]
fn a_reserve_needs_hover() {
    let told = refused("reserve_outside");
    assert!(told.starts_with("the reserve: it is a share of the way from hover"), "{told}");
    // Without the requirement the set is the true one, which the motion leaves.
    let read = (forged("reserve_outside"), spec("reserve_outside"));
    let settings = Settings { premises: Premises::without(Premise::Reserve), ..Settings::default() };
    let told = mavc::verify::decide(&read.0, &read.1, settings).unwrap_err().sentence();
    assert!(told.starts_with("the set of weak"), "{told}");
}

#[test]
fn a_yaw_does_not_point_backwards() {
    let told = refused("opposite_yaw");
    assert!(told.starts_with("limit 1 (yaw on the leg to waypoint 2) at 0 s: violated by 57.2958 deg"), "{told}");
}

#[test]
fn the_first_waypoint_has_a_yaw_tolerance_of_its_own() {
    let told = refused("start_yaw_within");
    assert!(told.starts_with("limit 1 (yaw at waypoint 1) at 0 s"), "{told}");
}

/// RSP's plan to select from stays in the core, the motion does not.
#[test]
fn cores_select_like_facets() {
    let verdict = decide(&forged("selection_without_core"), &spec("selection_without_core")).unwrap();
    let why = "the included plan selects no facet, but the motion leaves the core of L: no facet of the fault sets is \
               guarded";
    assert_eq!(verdict.weaker, [why]);
}

/// Turning accelerates the spin of a body whose moments of inertia about x and y differ.
#[test]
fn uneven_inertia_turns_the_spin() {
    let told = refused("uneven_inertia");
    assert!(told.contains("the moments of inertia about x and y differ"), "{told}");
    let mut forged = forged("uneven_inertia");
    let Claim::Plan(claim) = &mut forged.claim else { panic!("no plan") };
    // A bound that the motion keeps takes more yaw torque than the spin's drag has; one that leaves enough is exceeded.
    claim.without_yaw[0].turning_rad_s = Some(10.0);
    let told = decide(&forged, &spec("uneven_inertia")).unwrap_err().sentence();
    assert!(told.contains("no yaw torque keeps its spin in the range"), "{told}");
    let Claim::Plan(claim) = &mut forged.claim else { panic!("no plan") };
    claim.without_yaw[0] =
        SpinRecord { turning_rad_s: Some(0.1), spin_rad_s: [-1.0, 1.0], ..claim.without_yaw[0].clone() };
    let told = decide(&forged, &spec("uneven_inertia")).unwrap_err().sentence();
    assert!(told.starts_with("the rate of turning in the core of L at"), "{told}");
}

/// A height of 1 cm that no flight gave: the checker says whose it is.
#[test]
fn a_claimed_height_is_called_a_claim() {
    let verdict = decide(&forged("claimed_height"), &spec("claimed_height")).unwrap();
    let why = "`require capture_height`: the certificate claims that 0.01 m above the ground is enough after a fault; \
               this is not checked, and neither is whether the height was simulated";
    assert!(verdict.weaker.iter().any(|weaker| weaker == why), "{:?}", verdict.weaker);
}

/// Four rotors nearly on a beam: their facets are those of a set 10 um thick, far below the tolerance of the healthy
/// set.
#[test]
fn a_thin_set_is_bounded_across() {
    let told = refused("thin_set");
    assert!(told.starts_with("the set of sides, at the plane of rotors [1, 3] at 4.336 s: violated by 212"), "{told}");
    let told = refused("thin_core");
    assert!(told.starts_with("the core of sides at 9 s: violated by 37.6"), "{told}");
}

/// The healthy set takes the place of a set with fewer than three dimensions.
#[test]
fn a_set_that_is_not_decided_does_not_lift_the_healthy_one() {
    let told = refused("undecided_set");
    assert!(told.starts_with("the set of healthy"), "{told}");
}

/// A plane that an interval moves may not contain a facet; that it is left is said all the same.
#[test]
fn intervals_do_not_hide_a_set_that_is_left() {
    let verdict = decide(&forged("selection_in_intervals"), &spec("selection_in_intervals")).unwrap();
    let why = "the included plan selects no facet, but the motion leaves the set of ice: no facet of the fault sets is \
               guarded";
    assert_eq!(verdict.weaker, [why]);
}

#[test]
fn a_second_plan_keeps_the_rows_of_cores_that_the_first_selects() {
    let told = refused("second_plan");
    assert!(told.starts_with("plan 2 to select from: the core of L1"), "{told}");
}

/// A limit of 90 deg on the yaw, which begins a full turn below its direction and ends at a heading of 121 deg.
#[test]
fn yaws_are_counted_from_the_start() {
    let told = refused("start_turned");
    assert!(told.starts_with("waypoint 1 at 0 s: its yaw is 6.28319 rad from where yaws are counted"), "{told}");
}

/// Both ends of a leg may have a fixed time, each with its tolerance.
#[test]
fn two_fixed_times_have_two_tolerances() {
    let told = refused("due_twice");
    assert!(told.starts_with("the earliest arrival at waypoint 3"), "{told}");
}

#[test]
fn a_proof_with_a_claimed_height_is_conditional() {
    let verdict = decide(&forged("height_too_high"), &spec("height_too_high")).unwrap();
    assert!(verdict.headline.ends_with(", if 15 m above the ground are required"), "{}", verdict.headline);
    assert!(verdict.weaker.iter().any(|weaker| weaker.contains("are required after a fault")), "{:?}", verdict.weaker);
}

/// The grid steps over a wall of 1 cm, so that its bound on another part of the volume, 0.201 m, bounds nothing here;
/// an instant at which the proof fails does.
#[test]
fn a_bound_on_a_part_of_a_volume_does_not_bound_the_whole() {
    let verdict = decide(&forged("between_walls"), &spec("between_walls")).unwrap();
    let of_walls = verdict.weaker.iter().find(|weaker| weaker.starts_with("keep_out walls")).unwrap();
    assert!(of_walls.contains("exceeded between the nodes by at most 0.600"), "{of_walls}");
}

#[test]
fn a_rate_is_not_a_share_of_a_width() {
    let verdict = decide(&forged("own_rate"), &spec("own_rate")).unwrap();
    let of_rate = verdict.weaker.iter().find(|weaker| weaker.starts_with("rate of the motion itself")).unwrap();
    assert!(of_rate.contains("by at most 0.30") && of_rate.contains("rad/s"), "{of_rate}");
}

/// The drag that ends a spin falls with the density.
#[test]
fn thin_air_ends_a_spin_later() {
    let told = refused("thin_air");
    assert!(told.starts_with("the core of L1 at 0.230667 s: violated by 8.34"), "{told}");
}

/// A mode in which the rotors give a tenth of their thrust: nothing catches it, spinning or not, so that without a
/// record its whole set is imposed.
#[test]
fn what_cannot_hover_is_not_caught_by_its_spin() {
    let mut model = super::hop(PlannerKind::Rip, 12.0);
    model.plan.reserve = 0.0;
    let certificate = super::certified(&model).unwrap();
    let mut weak = lost(&model, &[]);
    (weak.name, weak.without_yaw) = ("weak".into(), Some(GiveUpYaw::Always));
    weak.rotors.fill(RotorState::Reduced(0.1));
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
