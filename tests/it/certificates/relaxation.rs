//! Certificates that the exact model has no plan: multipliers of its convex relaxation.

use super::{Numbers, SHA, certified, decide, planned, verify};
use crate::vehicles::{limit, lost, mission, octocopter, waypoint};
use mavc::certificate::{Certificate, Claim, InfeasibleClaim, RowRecord, Side};
use mavc::model::{LimitKind, MissionTime, Model, PlanModel, PlannerKind, Problem};
use mavc::planner::studies::{PlanOutcome, Proof};

/// One leg from rest to rest in the exact model.
fn hop(to: [f64; 3], turn: f64, limits: &[(LimitKind, f64)], time: f64) -> Model {
    let mut model = octocopter("PPNNPPNN");
    model.modes = (1..=8).map(|k| lost(&model, &[k])).collect();
    let mut flight = mission(vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint(to, turn)]);
    flight.limits = limits.iter().map(|(kind, upper)| limit(kind.clone(), *upper)).collect();
    for l in flight.limits.iter_mut().filter(|l| l.kind == LimitKind::YawRate) {
        l.lower = l.upper.map(|u| -u);
    }
    model.mission = Some(flight);
    model.plan.planner = PlannerKind::Rip;
    model.plan.model = PlanModel::Exact;
    model.plan.time = MissionTime::Fixed(time);
    model.plan.samples = 20;
    model
}

fn claim(certificate: &mut Certificate) -> &mut InfeasibleClaim {
    match &mut certificate.claim {
        Claim::Infeasible(claim) => claim,
        _ => panic!("no multipliers"),
    }
}

/// The largest thrust of all rotors over the mass, m/s^2.
fn full() -> f64 {
    8.0 * 8.5485e-6 * 874.0 * 874.0 / 1.8
}

/// Missions that closed forms show to be impossible whatever the attitude, and what makes them so.
fn impossible() -> Vec<(Model, &'static str)> {
    let (up, down) = (full() - 9.81, full() + 9.81);
    let mut against_two = hop([4.5, 0.0, 2.0], 0.0, &[(LimitKind::SpeedHorizontal, 2.0)], 2.0);
    against_two.plan.planner = PlannerKind::Rcp;
    against_two.plan.against = vec![0, 4];
    vec![
        // 2 s at 1 m/s are 2 m.
        (hop([2.2, 0.0, 2.0], 0.0, &[(LimitKind::Speed, 1.0)], 2.0), "speed"),
        // From rest to rest d takes at least 2 sqrt(d / a), a = g tan(10 degrees) in level flight.
        (hop([3.0, 0.0, 2.0], 0.0, &[(LimitKind::Tilt, 10f64.to_radians()), (LimitKind::Z, 2.06)], 1.5), "tilt"),
        // From rest to rest d takes t^2 = 2 d (1/up + 1/down), with full thrust upwards and then downwards.
        (hop([0.0, 0.0, 2.2 + 0.81 / (2.0 * (1.0 / up + 1.0 / down))], 0.0, &[], 0.9), "thrust"),
        // From rest to rest, 32 d = j t^3 at the least.
        (hop([0.0, 3.0, 2.0], 0.0, &[(LimitKind::Jerk, 10.0)], 2.0), "jerk"),
        (hop([0.0, 0.0, 2.0], 1.0, &[(LimitKind::YawRate, 0.4)], 2.0), "yaw rate"),
        (against_two, "horizontal speed"),
        // Further than light thrust carries in a twentieth of a second, by far.
        (hop([40.0, 0.0, 2.0], 0.0, &[], 0.05), "no time at all"),
    ]
}

#[test]
fn what_no_attitude_could_do_is_certified() {
    for (model, why) in impossible() {
        assert!(matches!(planned(&model).runs[0].outcome, PlanOutcome::Infeasible(Proof { .. })), "{why}");
        let certificate = mavc::certify::by_multipliers(Problem::of(&model).unwrap(), &planned(&model), SHA.into());
        let certificate = certificate.unwrap_or_else(|no| panic!("{why}: {no}"));
        let verdict = decide(&certificate, &model).unwrap();
        assert!(verdict.headline.starts_with("proved infeasible on one grid"), "{why}: {verdict:?}");
        // What is about one grid is weaker than what the spec asks.
        assert!(verdict.weaker.len() == 1 && verdict.weaker[0].starts_with("one grid"), "{verdict:?}");
        let text = serde_json::to_vec(&certificate).unwrap();
        assert!(verify(&text, &model, SHA).is_ok(), "{why}");
        assert_eq!(serde_json::from_slice::<Certificate>(&text).unwrap(), certificate);
    }
}

/// Multipliers of an impossible time, moved to one at which there is a plan and changed at random, are all rejected.
#[test]
fn no_multipliers_refute_an_exact_plan() {
    let mut numbers = Numbers(12);
    let limits = [(LimitKind::Speed, 1.5), (LimitKind::Tilt, 0.3), (LimitKind::Jerk, 20.0)];
    let (short, long) = (hop([2.0, 0.5, 2.4], 0.2, &limits, 1.2), hop([2.0, 0.5, 2.4], 0.2, &limits, 5.0));
    assert!(matches!(planned(&long).runs[0].outcome, PlanOutcome::Planned(_)));
    let certificate = certified(&short).expect("no plan of 1.2 s");
    let moved = certificate;
    assert_eq!(decide(&moved, &long).unwrap_err().claim, "the claim that there is no plan");
    for count in 0..400 {
        let mut tampered = moved.clone();
        let changed = claim(&mut tampered);
        let factor = 10f64.powf(6.0 * numbers.unit());
        for _ in 0..=numbers.below(20) {
            if numbers.below(8) == 0 {
                let at = numbers.below(changed.thrust.len());
                let entry = &mut changed.thrust[at];
                match numbers.below(3) {
                    0 => entry.weight *= factor,
                    1 => entry.weight = -entry.weight,
                    _ => entry.facet = numbers.below(20),
                }
                continue;
            }
            let at = numbers.below(changed.multipliers.len());
            let multiplier = &mut changed.multipliers[at];
            match numbers.below(7) {
                0 => multiplier.z.iter_mut().for_each(|z| *z *= factor),
                1 => multiplier.z.iter_mut().for_each(|z| *z = -*z),
                2 => multiplier.z[0] = numbers.unit() * factor,
                3 => {
                    changed.multipliers.remove(at);
                }
                4 => {
                    let again = multiplier.clone();
                    changed.multipliers.push(again);
                }
                5 => multiplier.row = RowRecord::Thrust { node: numbers.below(21) },
                _ => {
                    let node = numbers.below(21);
                    match &mut multiplier.row {
                        RowRecord::Rest { node: n, .. }
                        | RowRecord::Facet { node: n, .. }
                        | RowRecord::Commands { node: n, .. } => {
                            *n = node;
                        }
                        RowRecord::Limit { node: n, .. } | RowRecord::LimitNorm { node: n, .. } => *n = node,
                        RowRecord::Thrust { node: n } => *n = node,
                        RowRecord::Waypoint { waypoint } => *waypoint = node % 3,
                        RowRecord::WaypointYaw { side, .. } => *side = Side::Upper,
                    }
                }
            }
        }
        assert!(decide(&tampered, &long).is_err(), "{count}");
    }
}

/// The largest thrust is shown, not believed: other weights and other facets show nothing, nor does the proof hold for
/// a vehicle that is stronger by enough.
#[test]
fn the_largest_thrust_is_part_of_the_proof() {
    let (model, _) = impossible().swap_remove(2);
    let certificate = certified(&model).unwrap();
    let refused = |change: &dyn Fn(&mut InfeasibleClaim), of: &str| {
        let mut changed = certificate.clone();
        change(claim(&mut changed));
        let Err(rejection) = decide(&changed, &model) else { panic!("accepted: {of}") };
        assert!(rejection.claim.starts_with(of), "{rejection:?}");
    };
    refused(&|c| c.thrust[0].weight = -1.0, "the largest thrust");
    refused(&|c| c.thrust[0].weight = f64::NAN, "the largest thrust");
    refused(&|c| c.thrust[0].facet = 1_000, "the largest thrust");
    refused(&|c| c.thrust[0].weight *= 3.0, "the claim that there is no plan");
    refused(&|c| c.facets[0].offset *= 0.5, "facet 1");
    refused(&|c| c.multipliers.clear(), "the claim that there is no plan");
    refused(&|c| c.multipliers[0].row = RowRecord::Facet { facet: 0, node: 1 }, "multiplier 1");
    refused(&|c| c.multipliers[0].z.clear(), "multiplier 1");
    let mut stronger = model.clone();
    stronger.vehicle.rotors.iter_mut().for_each(|r| r.thrust_coefficient *= 1.6);
    assert!(decide(&certificate, &stronger).is_err());
}

fn moving(to: [f64; 3], limits: &[(LimitKind, f64)], time: f64) -> Model {
    let mut model = hop(to, 0.0, limits, time);
    model.mission.as_mut().unwrap().end_at_rest = false;
    model
}

/// Missions that end in motion, where a limit on speed or jerk bounds the last input; closed forms show them to be
/// impossible.
#[test]
fn what_ends_in_motion_is_certified_within_limits() {
    let models = [
        // 2 s at 1 m/s are 2 m.
        (moving([2.2, 0.0, 2.0], &[(LimitKind::Speed, 1.0)], 2.0), "speed"),
        (moving([9.0, 0.0, 2.0], &[(LimitKind::Speed, 1.0)], 2.0), "speed, by far"),
        (moving([0.0, 0.0, 4.2], &[(LimitKind::Climb, 1.0), (LimitKind::Descent, 2.0)], 2.0), "climb"),
        // From rest a t^2/2 at the most, a = thrust/m, which is 58 m. The jerk is bounded at the nodes.
        (moving([0.0, 65.0, 2.0], &[(LimitKind::Jerk, 40.0)], 2.0), "thrust"),
    ];
    for (model, why) in models {
        assert!(matches!(planned(&model).runs[0].outcome, PlanOutcome::Infeasible(Proof { .. })), "{why}");
        let certificate = mavc::certify::by_multipliers(Problem::of(&model).unwrap(), &planned(&model), SHA.into());
        let certificate = certificate.unwrap_or_else(|no| panic!("{why}: {no}"));
        assert!(decide(&certificate, &model).unwrap().headline.starts_with("proved infeasible"), "{why}");
        // At four times the time there is a plan, and the multipliers show nothing.
        let mut longer = model.clone();
        longer.plan.time = MissionTime::Fixed(if why == "speed, by far" { 20.0 } else { 8.0 });
        assert!(matches!(planned(&longer).runs[0].outcome, PlanOutcome::Planned(_)), "{why}");
        assert_eq!(decide(&certificate, &longer).unwrap_err().claim, "the claim that there is no plan", "{why}");
    }
}

/// Ends in motion without such limits, and waypoint times that are free, are beyond these multipliers.
#[test]
fn what_the_relaxation_cannot_say_is_not_written() {
    let unlimited = moving([40.0, 0.0, 2.0], &[], 0.9);
    assert!(matches!(planned(&unlimited).runs[0].outcome, PlanOutcome::Infeasible(Proof { .. })));
    assert!(certified(&unlimited).is_none());
    let short = hop([2.2, 0.0, 2.0], 0.0, &[(LimitKind::Speed, 1.0)], 2.0);
    let certificate = certified(&short).unwrap();
    let mut free = short.clone();
    free.plan.chooses_times = true;
    assert_eq!(decide(&certificate, &free).unwrap_err().claim, "the times");
    let mut hover = short;
    hover.plan.model = PlanModel::Hover;
    assert_eq!(decide(&certificate, &hover).unwrap_err().claim, "the model");
}
