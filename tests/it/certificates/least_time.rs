//! Least times: closed forms, the planner's own, plans, and what is claimed beyond them.

use super::{Numbers, SHA, decide, planned, verify};
use crate::vehicles::{hexacopter, limit, lost, mission, octocopter, waypoint};
use mavc::certificate::{Certificate, Claim, DynamicModel, SCHEMA, TooEarlyClaim, WeightsRecord};
use mavc::model::{LimitKind, MissionTime, Model, PlanModel, PlannerKind, Problem};
use mavc::planner::selection::PlanningSet;
use mavc::planner::selection::sets::PlanningSets;
use mavc::planner::timing::kinematics::least_time_within;
use nalgebra::{Matrix4, Vector4};
use std::path::Path;

/// One leg from rest to rest in the exact model, waypoints met to the millimetre.
fn hop(to: [f64; 3], turn: f64, limits: &[(LimitKind, f64)]) -> Model {
    let mut model = octocopter("PPNNPPNN");
    let mut flight = mission(vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint(to, turn)]);
    for point in &mut flight.waypoints {
        (point.within, point.yaw_within) = (1e-3, 1e-3);
    }
    flight.limits = limits.iter().map(|(kind, upper)| limit(kind.clone(), *upper)).collect();
    model.mission = Some(flight);
    model.plan.planner = PlannerKind::Rip;
    model.plan.model = PlanModel::Exact;
    model.plan.samples = 20;
    model
}

fn bound(model: &Model) -> f64 {
    least_time_within(Problem::of(model).unwrap()).seconds
}

fn claiming(model: &Model, waypoint: usize, soonest_s: f64) -> Certificate {
    let kind = match model.plan.model {
        PlanModel::Exact => DynamicModel::Exact,
        PlanModel::Hover => DynamicModel::Hover,
    };
    let claim = Claim::TooEarly(TooEarlyClaim { waypoint, soonest_s, weights: Vec::new() });
    Certificate { schema: SCHEMA, spec_sha256: SHA.into(), model: kind, capture_height_m: None, claim }
}

/// Missions whose least time has a closed form, up to the tolerances of waypoints and of the check.
fn closed_forms() -> Vec<(Model, f64)> {
    let full = octocopter("PPNNPPNN");
    let force: f64 = full.vehicle.rotors.iter().map(mavc::model::Rotor::max_thrust).sum::<f64>() / full.vehicle.mass;
    // A climb begins with the thrust that the weight leaves and ends by falling; a descent the other way round.
    let ends = |speed: f64| 0.5 * speed * (1.0 / (force - 9.81) + 1.0 / 9.81);
    let leans = 20f64.to_radians();
    let tilted = force * leans.sin();
    vec![
        // d/v + v/a, full thrust lying on its side.
        (hop([100.0, 0.0, 2.0], 0.0, &[(LimitKind::Speed, 2.0)]), 50.0 + 2.0 / force),
        (
            hop([60.0, 80.0, 2.0], 0.0, &[(LimitKind::SpeedHorizontal, 5.0), (LimitKind::Tilt, leans)]),
            20.0 + 5.0 / tilted,
        ),
        (hop([0.0, 0.0, 42.0], 0.0, &[(LimitKind::Climb, 4.0)]), 10.0 + ends(4.0)),
        (hop([0.0, 0.0, -38.0], 0.0, &[(LimitKind::Descent, 2.0)]), 20.0 + ends(2.0)),
        (hop([50.0, 0.0, 2.0], 0.0, &[(LimitKind::AccelerationHorizontal, 2.0)]), 10.0),
        (hop([32.0, 0.0, 2.0], 0.0, &[(LimitKind::Jerk, 1.0)]), 1024f64.cbrt()),
        (hop([0.0, 0.0, 2.0], 3.0, &[(LimitKind::YawRate, 0.3)]), 10.0),
        (hop([0.0, 0.0, 2.0], 2.0, &[(LimitKind::YawAcceleration, 0.5)]), 4.0),
    ]
}

#[test]
fn least_times_are_closed_forms() {
    for (mut model, expected) in closed_forms() {
        let least = bound(&model);
        assert!(least <= expected && least > expected * (1.0 - 3e-3), "{least} {expected}");
        // The checker comes to the same with code of its own: it accepts this, and nothing above.
        model.plan.time = MissionTime::Fixed(0.9 * least);
        let verdict = decide(&claiming(&model, 2, least), &model).unwrap();
        assert!(verdict.weaker.is_empty() && verdict.headline.contains("however the time is divided"), "{verdict:?}");
        let above = decide(&claiming(&model, 2, least * (1.0 + 1e-8)), &model).unwrap_err();
        assert_eq!(above.claim, "the earliest arrival at waypoint 2");
        // A time that is long enough is none to be too early for.
        model.plan.time = MissionTime::Fixed(1.1 * least);
        assert_eq!(decide(&claiming(&model, 2, least), &model).unwrap_err().claim, "the time of a waypoint");
        model.plan.time = MissionTime::Minimum;
        assert_eq!(decide(&claiming(&model, 2, least), &model).unwrap_err().claim, "the time of a waypoint");
    }
}

/// Holds add to it, fixed times delay it, and rest at a hold counts like rest at an end.
#[test]
fn holds_and_fixed_times_count() {
    let mut model = hop([10.0, 0.0, 2.0], 0.0, &[(LimitKind::Speed, 1.0), (LimitKind::Acceleration, 1.0)]);
    let flight = model.mission.as_mut().unwrap();
    flight.waypoints.push(waypoint([20.0, 0.0, 2.0], 0.0));
    flight.waypoints[2].within = 1e-3;
    flight.legs.push(flight.legs[0]);
    let near = |model: &Model, expected: f64| {
        let least = bound(model);
        assert!(least <= expected && least > expected - 0.02, "{least} {expected}");
    };
    // Two legs of 10 s, and half a second at either end for 1 m/s at 1 m/s^2.
    near(&model, 21.0);
    model.mission.as_mut().unwrap().waypoints[1].hold = 5.0;
    near(&model, 27.0);
    model.mission.as_mut().unwrap().waypoints[1].time = Some(30.0);
    near(&model, 46.0);
    assert!(least_time_within(Problem::of(&model).unwrap()).too_early.is_none());
    model.mission.as_mut().unwrap().waypoints[1].time = Some(10.0);
    let (waypoint, soonest) = least_time_within(Problem::of(&model).unwrap()).too_early.unwrap();
    assert!(waypoint == 1 && (soonest - 11.0).abs() < 0.02, "{soonest}");
    assert!(decide(&claiming(&model, 2, soonest * (1.0 - 1e-9)), &model).is_ok());
    assert!(decide(&claiming(&model, 0, 1.0), &model).is_err() && decide(&claiming(&model, 9, 1.0), &model).is_err());
    for nonsense in [f64::NAN, f64::INFINITY] {
        assert!(decide(&claiming(&model, 2, nonsense), &model).is_err());
    }
}

/// A shipped spec, elaborated.
fn shipped(name: &str) -> Model {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("specs");
    let path = folder.join(format!("{name}.mav"));
    mavc::Compiler::new().file(path).unwrap().into_result().unwrap().model().clone()
}

/// No plan of a shipped spec is shorter than its bound, and each certificate carries one that is accepted.
#[test]
fn plans_stay_above_their_bounds() {
    for name in ["paper/case1", "paper/case2", "paper/figure12", "missions/inspection"] {
        let mut model = shipped(name);
        model.plan.samples = 60;
        let mission = model.mission.clone().unwrap();
        let found = planned(&model);
        let Some(solved) = found.runs.last().unwrap().outcome.plan() else { panic!("{name}") };
        assert!(bound(&model) > 0.0 && bound(&model) < solved.time, "{name}: {} {}", bound(&model), solved.time);
        let certificate = mavc::certify::of(Problem::of(&model).unwrap(), &found, SHA.into()).unwrap();
        let Claim::Plan(claim) = &certificate.claim else { panic!("{name}") };
        // A time that the last waypoint fixes needs no bound.
        let is_open = mission.waypoints.last().unwrap().time.is_none();
        // The modes' sets may leave less thrust than the healthy one.
        let least = claim.least_time_s.unwrap_or(bound(&model));
        assert_eq!(claim.least_time_s.is_some(), is_open, "{name}");
        assert!(least >= bound(&model) * (1.0 - 1e-9) && least < solved.time, "{name} {least}");
        assert!(verify(&serde_json::to_vec(&certificate).unwrap(), &model, SHA).is_ok(), "{name}");
        for claimed in [1.001 * least, -5.0] {
            let mut other = certificate.clone();
            let Claim::Plan(claim) = &mut other.claim else { panic!("{name}") };
            claim.least_time_s = Some(claimed);
            assert_eq!(decide(&other, &model).unwrap_err().claim, "the least time", "{name}");
        }
    }
}

/// The reserve keeps its share of the way from hover to full thrust.
#[test]
fn the_reserve_leaves_less_thrust() {
    let mut model = hop([100.0, 0.0, 2.0], 0.0, &[(LimitKind::Speed, 2.0)]);
    let full: f64 = model.vehicle.rotors.iter().map(mavc::model::Rotor::max_thrust).sum::<f64>() / model.vehicle.mass;
    for reserve in [0.0, 0.3, 0.9] {
        model.plan.reserve = reserve;
        let expected = 50.0 + 2.0 / (reserve * 9.81 + (1.0 - reserve) * full);
        let least = bound(&model);
        assert!(least <= expected && least > expected - 0.01, "{reserve}: {least} {expected}");
        model.plan.time = MissionTime::Fixed(0.9 * least);
        assert!(decide(&claiming(&model, 2, least), &model).is_ok());
        assert!(decide(&claiming(&model, 2, least * (1.0 + 1e-8)), &model).is_err());
    }
}

/// The largest thrust of the vertices of a planning set, N: brute force over all four of its planes.
fn highest_vertex(set: &PlanningSet) -> f64 {
    let rows = &set.rows;
    let mut highest = f64::NEG_INFINITY;
    for four in (0..rows.len())
        .flat_map(|a| (0..a).flat_map(move |b| (0..b).flat_map(move |c| (0..c).map(move |d| [a, b, c, d]))))
    {
        let matrix = Matrix4::from_fn(|i, k| rows[four[i]].normal[k]);
        let offsets = Vector4::from_fn(|i, _| rows[four[i]].offset);
        let Some(vertex) = matrix.lu().solve(&offsets).filter(|v| v.iter().all(|x| x.is_finite())) else { continue };
        if rows.iter().all(|row| row.violation(&vertex) < 1e-9) {
            highest = highest.max(vertex[0]);
        }
    }
    highest
}

#[test]
fn the_bound_on_the_thrust_is_the_highest_vertex() {
    let all = |mut model: Model, modes: &[&[usize]]| {
        model.modes = modes.iter().map(|rotors| lost(&model, rotors)).collect();
        model.plan.against = (0..modes.len()).collect();
        model
    };
    let octocopter = all(octocopter("PPNNPPNN"), &[&[1], &[2], &[3], &[4], &[5], &[6], &[7], &[8]]);
    let hexacopter = all(hexacopter("PPNNPN"), &[&[1], &[2]]);
    for mut model in [octocopter, hexacopter] {
        for reserve in [0.0, 0.2] {
            model.plan.reserve = reserve;
            let sets = PlanningSets::of(&model);
            for set in sets.singles.iter().chain([&sets.rip, &sets.joint]) {
                let (found, highest) = (set.most_thrust(&model.vehicle), highest_vertex(set));
                // The tolerance of the check of plans adds to it.
                assert!(found >= highest && found < highest * (1.0 + 1e-3), "{found} {highest}");
            }
            assert!(sets.joint.most_thrust(&model.vehicle) < 0.9 * sets.rip.most_thrust(&model.vehicle));
        }
    }
}

/// Under RCP the modes' sets bound the thrust, so that the bound exceeds RIP's; the checker accepts it and no more.
#[test]
fn fault_modes_raise_the_bound() {
    let mut model = hop([30.0, 0.0, 2.0], 0.0, &[]);
    model.modes = (1..=8).map(|rotor| lost(&model, &[rotor])).collect();
    model.plan.against = (0..8).collect();
    model.plan.time = MissionTime::Minimum;
    let claims = [PlannerKind::Rip, PlannerKind::Rsp, PlannerKind::Rcp].map(|planner| {
        model.plan.planner = planner;
        let found = planned(&model);
        let certificate = mavc::certify::of(Problem::of(&model).unwrap(), &found, SHA.into()).unwrap();
        assert!(decide(&certificate, &model).is_ok());
        let mut more = certificate.clone();
        let Claim::Plan(claim) = &mut more.claim else { panic!("{planner:?}") };
        let least = claim.least_time_s.unwrap();
        claim.least_time_s = Some(least * (1.0 + 1e-6));
        assert_eq!(decide(&more, &model).unwrap_err().claim, "the least time", "{planner:?}");
        least
    });
    assert!(claims[0] <= claims[1] * (1.0 + 1e-9) && claims[1] <= claims[2] * (1.0 + 1e-9), "{claims:?}");
    assert!(claims[2] > 1.05 * claims[0], "{claims:?}");
}

/// Turns are looked for between all rests, but what the thrust can do is computed once: with a stop at each of 3,000
/// waypoints the bound once took a minute.
#[test]
fn thousands_of_rests_are_bounded() {
    let mut model = hop([10.0, 0.0, 2.0], 0.0, &[]);
    let flight = model.mission.as_mut().unwrap();
    for i in 2..3000 {
        flight.waypoints.push(waypoint([10.0 * f64::from(i % 2), f64::from(i), 2.0], 0.0));
        flight.legs.push(flight.legs[0]);
    }
    flight.waypoints.iter_mut().for_each(|point| point.stop = true);
    let least = bound(&model);
    assert!(least > 0.0);
    model.plan.time = MissionTime::Fixed(0.9 * least);
    assert!(decide(&claiming(&model, 3000, least), &model).is_ok());
}

/// Random motions from rest to rest, through waypoints on their way, take no less than the bound for the thrust and the
/// accelerations that they reach, whether the bound comes from legs, turns or weights; and weights show more than the
/// others do. The checker accepts what they show.
#[test]
fn random_motions_stay_above_their_bounds() {
    let mut numbers = Numbers(3);
    let mut shown = [0, 0];
    for k in 0..60 {
        let total = 7.5 + 4.5 * numbers.unit();
        let waves: Vec<[f64; 4]> = (0..4).map(|_| std::array::from_fn(|_| numbers.unit())).collect();
        // Sums of (1 - cos(j s))/j^2 and of s/2 - sin(2 s)/4 for s in 0 .. 2 pi, which rest at both ends.
        let rate = std::f64::consts::TAU / total;
        let at = |t: f64, order: i32| -> [f64; 3] {
            let s = rate * t;
            std::array::from_fn(|axis| {
                let wave = |(j, wave): (usize, &[f64; 4])| {
                    let n = (j + 1) as f64;
                    wave[axis] / n
                        * match order {
                            0 => (1.0 - (n * s).cos()) / n,
                            1 => rate * (n * s).sin(),
                            _ => rate * rate * n * (n * s).cos(),
                        }
                };
                let drift = match order {
                    0 => 0.5 * s - 0.25 * (2.0 * s).sin(),
                    1 => rate * s.sin().powi(2),
                    _ => rate * rate * (2.0 * s).sin(),
                };
                3.0 * (waves.iter().enumerate().map(wave).sum::<f64>() + waves[0][3] * drift)
            })
        };
        let count = 2 + k % 7;
        let instants: Vec<f64> = (0..=count).map(|i| total * i as f64 / count as f64).collect();
        let mut model = hop([0.0; 3], 0.0, &[]);
        let (mass, g) = (model.vehicle.mass, model.gravity);
        let drag = if k % 3 == 0 { 0.3 } else { 0.0 };
        let wind = [0, 1, 2].map(|_| if k % 6 == 0 { 2.0 * numbers.unit() } else { 0.0 });
        let steps = (0..=20_000).map(|i| total * f64::from(i) / 20_000.0);
        let (mut force, mut tilt, mut speed, mut sideways) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
        for t in steps {
            let ([ax, ay, az], v) = (at(t, 2), at(t, 1));
            let f = [0, 1, 2].map(|i| [ax, ay, az + g][i] + drag * (v[i] - wind[i]));
            force = force.max(f.iter().map(|f| f * f).sum::<f64>().sqrt());
            tilt = tilt.max(f[0].hypot(f[1]).atan2(f[2]));
            speed = speed.max(v.iter().map(|v| v * v).sum::<f64>().sqrt());
            sideways = sideways.max(ax.hypot(ay));
        }
        let full: f64 = model.vehicle.rotors.iter().map(mavc::model::Rotor::max_thrust).sum();
        model.vehicle.rotors.iter_mut().for_each(|rotor| rotor.thrust_coefficient *= force * mass / full);
        model.vehicle.drag = [drag * mass; 3];
        let flight = model.mission.as_mut().unwrap();
        flight.waypoints = instants.iter().map(|t| waypoint(at(*t, 0), 0.0)).collect();
        flight.waypoints.iter_mut().for_each(|point| point.within = 1e-3);
        flight.legs = vec![flight.legs[0]; count];
        flight.air.wind = wind;
        // Each motion is at its limits with respect to some of these.
        if k % 2 == 0 && tilt < 1.5 {
            flight.limits.push(limit(LimitKind::Tilt, tilt));
        }
        if k % 5 == 0 {
            flight.limits.push(limit(LimitKind::AccelerationHorizontal, sideways));
        }
        if k % 4 == 0 || drag > 0.0 {
            flight.limits.push(limit(LimitKind::Speed, speed));
        }
        let least = least_time_within(Problem::of(&model).unwrap());
        assert!(least.seconds > 0.0 && least.seconds < total, "{k}: {} {total}", least.seconds);
        model.plan.time = MissionTime::Fixed(0.9 * least.seconds);
        let mut certificate = claiming(&model, count + 1, least.seconds);
        let Claim::TooEarly(claim) = &mut certificate.claim else { panic!() };
        claim.weights = least.weights;
        let has_weights = !claim.weights.is_empty();
        assert!(decide(&certificate, &model).is_ok(), "{k}");
        let Claim::TooEarly(claim) = &mut certificate.claim else { panic!() };
        claim.weights.clear();
        assert_eq!(decide(&certificate, &model).is_err(), has_weights, "{k}");
        shown[usize::from(has_weights)] += 1;
    }
    assert!(shown[1] >= 20, "{shown:?}");
}

/// The checker accepts the bound where a leg is vertical: it is flown through, so that it takes no least time of its
/// own, and its weights add nothing, exactly.
#[test]
fn vertical_legs_that_are_flown_through_add_nothing() {
    let mut model = hop([10.0, 0.0, 2.0], 0.0, &[(LimitKind::Tilt, 0.4)]);
    let flight = model.mission.as_mut().unwrap();
    for to in [[10.0, 0.0, 5.0], [10.0, 8.0, 5.0], [0.0, 8.0, 5.0]] {
        flight.waypoints.push(waypoint(to, 0.0));
        flight.legs.push(flight.legs[0]);
    }
    flight.waypoints[1..3].iter_mut().for_each(|point| point.within = 0.5);
    let least = least_time_within(Problem::of(&model).unwrap());
    let [record] = &least.weights[..] else { panic!("{:?}", least.weights) };
    assert_eq!((record.weights[1], least.legs[1].seconds), (record.weights[2], 0.0));
    model.plan.time = MissionTime::Fixed(0.9 * least.seconds);
    let mut certificate = claiming(&model, 5, least.seconds);
    let Claim::TooEarly(claim) = &mut certificate.claim else { panic!() };
    claim.weights = least.weights.clone();
    assert!(decide(&certificate, &model).is_ok());
}

/// Malformed and foreign weights show nothing, whatever they claim.
#[test]
fn weights_are_not_trusted() {
    let mut model = hop([10.0, 0.0, 2.0], 0.0, &[(LimitKind::Tilt, 0.4)]);
    let flight = model.mission.as_mut().unwrap();
    for to in [[10.0, 6.0, 2.0], [0.0, 6.0, 2.0], [0.0, 12.0, 2.0]] {
        flight.waypoints.push(waypoint(to, 0.0));
        flight.legs.push(flight.legs[0]);
    }
    let least = least_time_within(Problem::of(&model).unwrap());
    assert_eq!(least.weights.len(), 1);
    model.plan.time = MissionTime::Fixed(0.9 * least.seconds);
    let with = |change: &dyn Fn(&mut WeightsRecord)| {
        let mut certificate = claiming(&model, 5, least.seconds);
        let Claim::TooEarly(claim) = &mut certificate.claim else { panic!() };
        claim.weights = least.weights.clone();
        change(&mut claim.weights[0]);
        decide(&certificate, &model).is_ok()
    };
    assert!(with(&|_| ()));
    assert!(!with(&|record| record.price_s2_per_m *= 1.1) && !with(&|record| record.price_s2_per_m *= 0.9));
    assert!(!with(&|record| record.price_s2_per_m = -record.price_s2_per_m));
    assert!(!with(&|record| record.price_s2_per_m = f64::INFINITY));
    assert!(!with(&|record| record.vertical = 1.0) && !with(&|record| record.vertical = f64::NAN));
    assert!(!with(&|record| record.weights[2][0] = f64::NAN) && !with(&|record| record.weights[2][0] = f64::MAX));
    assert!(!with(&|record| record.weights.truncate(4)) && !with(&|record| record.waypoints.reverse()));
    assert!(!with(&|record| record.waypoints = vec![1, 1, 1, 1, 5]));
    assert!(!with(&|record| record.waypoints = vec![1, 2, 3, 4, 9]));
    assert!(!with(&|record| record.waypoints = vec![0, 2, 3, 4, 5]));
    assert!(!with(&|record| (record.waypoints, record.weights) = (vec![1], vec![[1.0, 0.0]])));
    assert!(!with(&|record| (record.waypoints, record.weights) = (Vec::new(), Vec::new())));
}
