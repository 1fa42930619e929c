//! Costs that the checker counts before it works, and work that it does not do twice.

use super::{Numbers, SHA, certified, decide, hop};
use crate::vehicles::{hexacopter, limit, lost, mission, octocopter, quadcopter, waypoint};
use mavc::body::Body;
use mavc::certificate::{Certificate, Claim, DynamicModel, InfeasibleClaim, PlanClaim, SCHEMA, TooEarlyClaim};
use mavc::model::{
    GiveUpYaw, LimitKind, MissionTime, Model, OnLeg, Part, PlanModel, PlannerKind, RotorState, Spread, Volume,
    VolumeSide, YawDrag,
};
use mavc::source::Span;
use mavc::verify::cost::{Budget, COST_PER_CORE_ROW, COST_PER_CORNER, COST_PER_PLANE, COST_PER_ROTOR, Estimate};
use mavc::verify::interval::Interval;
use mavc::verify::limits;
use mavc::verify::sets::{Generators, Plane, planes_at_most, shadow_at_most};
use mavc::verify::{Refusal, Settings};
use std::path::Path;

/// The bound on the cost of deciding a certificate.
fn estimate(certificate: &Certificate, model: &Model) -> Estimate {
    let settings = Settings { budget: Budget { seconds: 0.0, bytes: 0 }, ..Settings::default() };
    match mavc::verify::decide(certificate, model, settings) {
        Err(Refusal::Budget { estimate, .. }) => estimate,
        other => panic!("{other:?}"),
    }
}

fn claim(certificate: &mut Certificate) -> &mut PlanClaim {
    let Claim::Plan(claim) = &mut certificate.claim else { panic!("no plan") };
    claim
}

/// Twenty million pairs of planes, in place of which the shadow is taken: accepted whole within the usual budget, which
/// was once exceeded by far and ended before every row was proved.
#[test]
fn a_core_of_many_rotors_fits_the_budget() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/specs/findings");
    let model = mavc::Compiler::new().file(folder.join("core_of_32_rotors.mav")).unwrap().into_result().unwrap();
    let model = model.model();
    let text = std::fs::read_to_string(folder.join("core_of_32_rotors.json")).unwrap();
    let mut certificate: Certificate = serde_json::from_str(&text).unwrap();
    assert!(decide(&certificate, model).unwrap().weaker.is_empty());
    // The rows of the core are counted.
    let whole = estimate(&certificate, model);
    let record = claim(&mut certificate).without_yaw.remove(0);
    let without = estimate(&certificate, model);
    let rows = planes_at_most(&model.vehicle) + shadow_at_most(&model.vehicle);
    assert!(rows < 12_000 && whole.units >= without.units + rows * COST_PER_CORE_ROW);
    // With intervals pairs are taken, and counted, but not held at once.
    let mut uncertain = model.clone();
    for rotor in &mut uncertain.vehicle.rotors {
        rotor.spread.full_thrust = Spread { low: 0.99, high: 1.01 };
    }
    claim(&mut certificate).without_yaw.push(record.clone());
    let pairs = estimate(&certificate, &uncertain);
    assert!(pairs.units > 20_000_000 * COST_PER_CORE_ROW && pairs.bytes < 50_000_000, "{pairs:?}");
    // A mode is named once.
    claim(&mut certificate).without_yaw.push(record);
    let why = decide(&certificate, model).unwrap_err().sentence();
    assert!(why.contains("more than once"), "{why}");
}

/// Whether hover lies in a mode's set decides about its yaw: its planes are computed, and counted.
#[test]
fn sets_that_decide_about_yaw_are_counted_and_each_set_once() {
    let mut model = hop(PlannerKind::Rip, 12.0);
    model.vehicle.yaw_drag = Some(YawDrag { linear: 2.75e-3, spread: Spread::NONE, quadratic: 0.0 });
    model.plan.against = (0..8).collect();
    model.plan.without_yaw = GiveUpYaw::Never;
    let mut certificate = certified(&model).unwrap();
    let never = estimate(&certificate, &model).units;
    model.plan.without_yaw = GiveUpYaw::WhereNeeded;
    let planes = planes_at_most(&model.vehicle);
    assert!(estimate(&certificate, &model).units >= never + 8 * planes * COST_PER_PLANE);
    // Each motion that selects adds its rows, and no set.
    model.plan.without_yaw = GiveUpYaw::Never;
    model.plan.planner = PlannerKind::Rsp;
    model.plan.rounds = 9;
    let mut units = Vec::new();
    for _ in 0..3 {
        let motion = claim(&mut certificate).motion.clone();
        claim(&mut certificate).selected_by.push(motion);
        units.push(estimate(&certificate, &model).units);
    }
    assert_eq!(units[2] - units[1], units[1] - units[0]);
    let of_sets = 9 * (planes * COST_PER_PLANE + 8 * COST_PER_ROTOR);
    let of_a_motion = units[1] - units[0];
    // The claimed motion counts one set more than those that select.
    assert!(units[0] > 2 * of_a_motion + of_sets && units[0] < 3 * of_a_motion + of_sets, "{units:?} {of_sets}");
}

/// A polygon costs with each of its corners: before the work, and in the work of proofs.
#[test]
fn corners_are_counted() {
    let model = hop(PlannerKind::Rip, 12.0);
    let certificate = certified(&model).unwrap();
    let with = |corners: usize| {
        let at = |i: usize| {
            let angle = i as f64 * std::f64::consts::TAU / corners as f64;
            [40.0 + angle.cos(), 40.0 + angle.sin()]
        };
        let body = Body::Prism { corners: (0..corners).map(at).collect(), bottom: 0.0, top: 9.0 };
        let (name, side, span) = ("tower".into(), VolumeSide::KeepOut, Span::default());
        let volume = Volume { name, side, bodies: vec![body], clearance: 0.3, span };
        let mut model = model.clone();
        let limits = volume.limits(0.2);
        let family = limits::family(&limits[0], &model.environment(), None);
        model.mission.as_mut().unwrap().limits.extend(limits.clone());
        (estimate(&certificate, &model).units, family.of_a_member)
    };
    let ((few, of_few), (many, of_many)) = (with(4), with(200));
    let Claim::Plan(PlanClaim { motion, .. }) = &certificate.claim else { panic!("no plan") };
    assert!(many >= few + 196 * COST_PER_CORNER * motion.times_s.len() as u64);
    assert_eq!(of_many, of_few + 196 * COST_PER_CORNER);
}

/// A limit of one leg costs what that leg has of nodes.
#[test]
fn a_limit_of_a_leg_is_counted_on_its_leg() {
    let model = hop(PlannerKind::Rip, 12.0);
    let certificate = certified(&model).unwrap();
    let added = |leg: Option<usize>| {
        let mut model = model.clone();
        let mission = model.mission.as_mut().unwrap();
        let mut own = limit(LimitKind::Acceleration, 9.0);
        let on = |leg| OnLeg { leg, part: Part::Whole, name: "own".into() };
        own.leg = leg.map(|leg| on(leg).into());
        mission.limits.push(own);
        estimate(&certificate, &model).units
    };
    let plain = estimate(&certificate, &model).units;
    let [whole, first, second] = [None, Some(0), Some(1)].map(|leg| added(leg) - plain);
    assert!(first > 0 && second > 0 && first + second <= whole + 40, "{whole} {first} {second}");
}

/// Facets listed twice are looked for twice along the motions that select.
#[test]
fn facets_are_counted_as_often_as_they_are_listed() {
    let mut model = hop(PlannerKind::Rcp, 4.0);
    let certificate = certified(&model).unwrap();
    let Claim::Infeasible(infeasible) = &certificate.claim else { panic!("a plan") };
    model.plan.planner = PlannerKind::Rsp;
    let mut flown = hop(PlannerKind::Rip, 12.0);
    flown.plan.time = MissionTime::Fixed(12.0);
    let Claim::Plan(selecting) = certified(&flown).unwrap().claim else { panic!("no plan") };
    model.plan.time = MissionTime::Fixed(12.0);
    let with = |times: usize| {
        let facets = std::iter::repeat_n(&infeasible.facets, times).flatten().cloned().collect();
        let selected_by = vec![selecting.motion.clone()];
        let claim = InfeasibleClaim { facets, selected_by, ..infeasible.clone() };
        let certificate =
            Certificate { claim: Claim::Infeasible(claim), spec_sha256: SHA.into(), ..certificate.clone() };
        estimate(&certificate, &model).units
    };
    let each = infeasible.facets.len() as u64 * (COST_PER_PLANE + 2 * selecting.motion.times_s.len() as u64);
    assert!(with(2) >= with(1) + each, "{} {}", with(1), with(2));
}

/// The largest violation of planes.
fn excess(planes: &[Plane], w: [f64; 4]) -> f64 {
    planes.iter().map(|p| p.violation(&w.map(Interval::point)).middle()).fold(f64::NEG_INFINITY, f64::max)
}

/// What the planes of a set leave for some yaw torque is its shadow, also of flat sets and of rotors in a line.
#[test]
fn a_shadow_is_what_some_yaw_torque_leaves() {
    let mut numbers = Numbers(23);
    let mut in_a_line = octocopter("PNPNPNPN");
    for (k, rotor) in in_a_line.vehicle.rotors.iter_mut().enumerate().take(5) {
        rotor.position = [0.1 * k as f64 - 0.2, 0.0, 0.0];
    }
    in_a_line.modes = vec![lost(&in_a_line, &[6, 7, 8])];
    for mut model in [octocopter("PPNNPPNN"), hexacopter("PPNNPN"), quadcopter(), in_a_line] {
        let (mut stuck, one) = (lost(&model, &[2]), lost(&model, &[1]));
        stuck.rotors[1] = RotorState::Stuck(0.3);
        model.modes.extend([one, stuck]);
        for mode in std::iter::once(None).chain(model.modes.iter().map(Some)) {
            // Not every mode can hover, and a reserve needs hover.
            let generators = Generators::new(&model.vehicle, &model.environment(), mode, 0.0);
            let (planes, shadow) = (generators.planes().unwrap(), generators.shadow().unwrap());
            assert!(shadow.len() as u64 <= shadow_at_most(&model.vehicle));
            assert!(shadow.iter().all(|plane| plane.normal[3].magnitude() < 1e-300));
            let extent = generators.extent();
            let (mut inside, mut outside) = (0, 0);
            for _ in 0..400 {
                let mut w: [f64; 4] = std::array::from_fn(|i| {
                    extent[i].middle() + 0.7 * numbers.unit() * (extent[i].high - extent[i].low)
                });
                // The yaw torques that the planes leave.
                let (mut low, mut high, mut flat) = (f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY);
                w[3] = 0.0;
                for plane in &planes {
                    let (n, room) = (plane.normal[3].middle(), -plane.violation(&w.map(Interval::point)).middle());
                    match n {
                        _ if n > 1e-9 => high = high.min(room / n),
                        _ if n < -1e-9 => low = low.max(room / n),
                        _ => flat = flat.max(-room),
                    }
                }
                let found = excess(&shadow, w);
                let empty = flat.max((low - high) * 1e-3);
                // Rounding decides near the boundary, and about everything that a flat shadow has.
                if found < -1e-6 {
                    assert!(empty < 1e-9, "{found} {empty}");
                    inside += 1;
                } else if found > 1e-6 {
                    assert!(empty > 1e-12, "{found} {empty}");
                    outside += 1;
                }
            }
            // In a flat shadow no wrench is inside by more than rounding.
            let is_flat = extent.iter().any(|range| range.high - range.low < 1e-9);
            assert!(outside > 40 && (is_flat || inside + outside > 300), "{inside} {outside}");
        }
    }
}

/// What keeps out of the box about a polygon keeps out of the polygon; few corners and limits of other kinds have no
/// box.
#[test]
fn boxes_about_polygons_are_stricter() {
    let corners = |count: usize| -> Vec<[f64; 2]> {
        let at = |i: usize| (i as f64 * std::f64::consts::TAU / count as f64).sin_cos();
        (0..count).map(|i| [3.0 + 2.0 * at(i).1, 1.0 + at(i).0]).collect()
    };
    let limit_of = |count: usize| {
        let body = Body::Prism { corners: corners(count), bottom: 0.0, top: 4.0 };
        let (name, side, span) = ("tower".into(), VolumeSide::KeepOut, Span::default());
        Volume { name, side, bodies: vec![body], clearance: 0.3, span }.limits(0.2).remove(0)
    };
    let own = limit_of(9);
    let about = limits::about(&own).unwrap();
    let mut numbers = Numbers(3);
    let mut apart = 0;
    for _ in 0..500 {
        let p = [3.0 + 4.0 * numbers.unit(), 1.0 + 3.0 * numbers.unit(), 2.0 + 4.0 * numbers.unit()];
        let [of_box, of_body] = [&about, &own].map(|limit| limit.violation_at(p).unwrap());
        assert!(of_box >= of_body - 1e-12, "{p:?}");
        apart += usize::from(of_box > of_body + 0.1);
    }
    assert!(apart > 50, "{apart}");
    assert!(limits::about(&limit_of(4)).is_none() && limits::about(&limit(LimitKind::Speed, 2.0)).is_none());
    assert!(limits::about(&mavc::model::Limit { upper: Some(9.0), ..own }).is_none());
}

/// A claim that a waypoint is due too early looks at every limit of every leg.
#[test]
fn least_times_are_in_the_estimate() {
    let mut model = octocopter("PPNNPPNN");
    let points = (0..1000).map(|i| waypoint([f64::from(i), 0.0, 2.0], 0.0)).collect();
    let mut flight = mission(points);
    flight.limits = vec![limit(LimitKind::Speed, 2.0); 1000];
    model.mission = Some(flight);
    let claim = Claim::TooEarly(TooEarlyClaim { waypoint: 2, soonest_s: 0.1, weights: Vec::new() });
    let certificate = Certificate {
        schema: SCHEMA,
        spec_sha256: SHA.into(),
        model: DynamicModel::Exact,
        capture_height_m: None,
        claim,
    };
    let settings = Settings { budget: Budget { seconds: 1e-4, ..Budget::default() }, ..Settings::default() };
    model.plan.model = PlanModel::Exact;
    let refused = mavc::verify::decide(&certificate, &model, settings);
    assert!(matches!(refused, Err(Refusal::Budget { .. })), "{refused:?}");
}
