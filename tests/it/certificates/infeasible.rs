//! Certificates that there is no plan.

use super::{Numbers, SHA, certified, decide, hop, planned, verify};
use crate::vehicles::{inspection, paper_case};
use mavc::certificate::{Certificate, Claim, InfeasibleClaim, RowRecord, Side};
use mavc::model::{Allocation, MissionTime, Model, PlannerKind, Problem};
use mavc::planner::studies::{PlanOutcome, Proof};
use mavc::planner::timing::kinematics::least_time_within;

fn claim(certificate: &mut Certificate) -> &mut InfeasibleClaim {
    match &mut certificate.claim {
        Claim::Infeasible(claim) => claim,
        _ => panic!("no multipliers"),
    }
}

fn is_infeasible(model: &Model) -> bool {
    matches!(planned(model).runs[0].outcome, PlanOutcome::Infeasible(Proof { .. }))
}

/// Every kind of row, and a time just below the independent threshold of 15.526 s.
#[test]
fn what_has_no_plan_is_certified() {
    let fixed = |planner, time| {
        let mut model = paper_case(planner, &[0]);
        model.plan.time = MissionTime::Fixed(time);
        model.plan.reserve = 0.0;
        model
    };
    let mut models = vec![fixed(PlannerKind::Rip, 15.5), fixed(PlannerKind::Rcp, 15.9), fixed(PlannerKind::Rip, 2.0)];
    models.extend([2.0, 3.0, 4.0].map(|time| hop(PlannerKind::Rcp, time)));
    for model in models {
        assert!(is_infeasible(&model), "{:?}", model.plan.time);
        let certificate = certified(&model).expect("a certificate");
        decide(&certificate, &model).unwrap();
        let text = serde_json::to_vec(&certificate).unwrap();
        assert!(verify(&text, &model, SHA).is_ok() && text.len() < 1 << 20);
        assert_eq!(verify(&text, &model, "4567").unwrap_err().code, "mavc::verify::other_spec");
        assert_eq!(serde_json::from_slice::<Certificate>(&text).unwrap(), certificate);
    }
}

/// The facets of rotors that may not stop, of the pseudo-inverse and of intervals weigh as others do.
#[test]
fn other_vehicles_without_a_plan_are_certified() {
    let mut idling = hop(PlannerKind::Rcp, 3.0);
    idling.vehicle.rotors.iter_mut().for_each(|r| r.min_speed = 150.0);
    let mut inverted = hop(PlannerKind::Rcp, 3.0);
    inverted.vehicle.allocation = Allocation::PseudoInverse;
    let mut uncertain = hop(PlannerKind::Rcp, 3.0);
    super::sets::doubt(&mut uncertain);
    for (which, model) in [idling, inverted, uncertain].iter().enumerate() {
        assert!(is_infeasible(model), "{which}");
        let certificate = mavc::certify::of(Problem::of(model).unwrap(), &planned(model), SHA.into());
        let certificate = certificate.unwrap_or_else(|no| panic!("{which}: {no}"));
        decide(&certificate, model).unwrap();
    }
}

/// Where there is a plan, no multipliers show that there is none: those of shorter times, moved to the longer one and
/// changed at random, are all rejected.
#[test]
fn no_multipliers_refute_a_plan() {
    let mut numbers = Numbers(10);
    let (short, long) = (hop(PlannerKind::Rcp, 4.0), hop(PlannerKind::Rcp, 9.0));
    assert!(!is_infeasible(&long));
    let certificate = certified(&short).unwrap();
    // The checker works the nodes of the longer time out itself.
    let moved = certificate;
    let refused = decide(&moved, &long).unwrap_err();
    assert_eq!(refused.claim, "the claim that there is no plan", "{refused:?}");
    for count in 0..400 {
        let mut tampered = moved.clone();
        let changed = claim(&mut tampered);
        let factor = 10f64.powf(6.0 * numbers.unit());
        for _ in 0..=numbers.below(20) {
            let at = numbers.below(changed.multipliers.len());
            let multiplier = &mut changed.multipliers[at];
            match numbers.below(6) {
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
                _ => {
                    let node = numbers.below(31);
                    match &mut multiplier.row {
                        RowRecord::Rest { node: n, .. }
                        | RowRecord::Facet { node: n, .. }
                        | RowRecord::Commands { node: n, .. } => {
                            *n = node;
                        }
                        RowRecord::Limit { node: n, .. } | RowRecord::LimitNorm { node: n, .. } => *n = node,
                        RowRecord::Thrust { node: n } => *n = node,
                        RowRecord::Waypoint { waypoint } => *waypoint = node % 4,
                        RowRecord::WaypointYaw { side, .. } => *side = Side::Upper,
                    }
                }
            }
        }
        assert!(decide(&tampered, &long).is_err(), "{count}");
    }
}

/// Facets that do not bind, rows that the spec does not have: the claim would be about another mission.
#[test]
fn another_missions_rows_are_refused() {
    let model = hop(PlannerKind::Rcp, 4.0);
    let certificate = certified(&model).unwrap();
    let refused = |change: &dyn Fn(&mut InfeasibleClaim), of: &str| {
        let mut changed = certificate.clone();
        change(claim(&mut changed));
        let Err(rejection) = decide(&changed, &model) else { panic!("accepted: {of}") };
        assert!(rejection.claim.starts_with(of), "{rejection:?}");
    };
    refused(&|c| c.facets[0].mode = "healthy".into(), "facet 1");
    refused(&|c| c.facets[1].mode = "M2".into(), "facet 2");
    refused(&|c| c.facets[2].offset += 0.01, "facet 3");
    refused(&|c| c.multipliers.clear(), "the claim that there is no plan");
    refused(&|c| c.multipliers[0].row = RowRecord::Rest { node: 4, axis: 0, derivative: 1 }, "multiplier 1");
    refused(&|c| c.multipliers[0].row = RowRecord::Rest { node: 0, axis: 9, derivative: 9 }, "multiplier 1");
    refused(&|c| c.multipliers[0].row = RowRecord::Facet { facet: 0, node: usize::MAX }, "multiplier 1");
    refused(&|c| c.multipliers[0].z.clear(), "multiplier 1");
    refused(&|c| c.multipliers[0].z = vec![f64::NAN], "multiplier 1");
}

/// Yaw planned first and starts in motion are beyond these multipliers: no certificate rather than a wrong one.
#[test]
fn what_cannot_be_certified_is_not() {
    let mut turning = hop(PlannerKind::Rip, 5.0);
    turning.mission = Some(inspection());
    // Above what distances and limits take whatever the yaw.
    let least = least_time_within(Problem::of(&turning).unwrap()).seconds;
    turning.plan.time = MissionTime::Fixed(1.001 * least);
    assert!(!is_infeasible(&turning), "{least}");
    assert!(certified(&turning).is_none());
    let mut moving = hop(PlannerKind::Rip, 2.0);
    moving.mission.as_mut().unwrap().start_at_rest = false;
    if is_infeasible(&moving) {
        assert!(certified(&moving).is_none());
    }
    let mut open = hop(PlannerKind::Rip, 2.0);
    open.plan.time = MissionTime::Minimum;
    let certificate = certified(&hop(PlannerKind::Rip, 2.0)).unwrap();
    assert_eq!(decide(&certificate, &open).unwrap_err().claim, "the times");
}
