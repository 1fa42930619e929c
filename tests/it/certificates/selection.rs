//! What RSP selects is worked out from the plans that its certificate carries, and they are checked as plans.

use super::{certified, decide, hop};
use mavc::certificate::{Certificate, Claim, MotionRecord, PlanClaim};
use mavc::model::{MissionTime, Model, PlannerKind};

fn claim(certificate: &Certificate) -> &PlanClaim {
    match &certificate.claim {
        Claim::Plan(claim) => claim,
        _ => panic!("no plan"),
    }
}

fn with(certificate: &Certificate, motion: &MotionRecord, selected_by: &[MotionRecord]) -> Certificate {
    let claim = PlanClaim {
        motion: motion.clone(),
        selected_by: selected_by.to_vec(),
        without_yaw: vec![],
        least_time_s: None,
        weights: Vec::new(),
        recovery: None,
    };
    Certificate { claim: Claim::Plan(claim), ..certificate.clone() }
}

/// A hop without limits that is quick enough to leave the sets of lost rotors.
fn quick(planner: PlannerKind, rounds: usize) -> Model {
    let mut model = hop(planner, 3.3);
    model.mission.as_mut().unwrap().limits.clear();
    model.plan.rounds = rounds;
    model
}

#[test]
fn rsp_is_decided_by_the_plan_it_carries() {
    let model = quick(PlannerKind::Rsp, 1);
    let certificate = certified(&model).unwrap();
    let verdict = decide(&certificate, &model).unwrap();
    assert!(verdict.headline.ends_with("for the facets selected by the included RIP plan"), "{verdict:?}");
    let selected: Vec<_> = verdict.shown.iter().filter(|s| s.statement.contains("selected facet")).collect();
    assert!(!selected.is_empty(), "{verdict:?}");

    let rsp = claim(&certificate);
    let rip = certified(&quick(PlannerKind::Rip, 1)).unwrap();
    let rip = &claim(&rip).motion;
    // The RIP plan violates what it selects.
    let told = decide(&with(&certificate, rip, &rsp.selected_by), &model).unwrap_err();
    assert!(told.claim.contains("that RSP selects"), "{told:?}");
    // Without a plan to select by, or with more than the spec has rounds.
    let told = decide(&with(&certificate, &rsp.motion, &[]), &model).unwrap_err();
    assert!(told.claim == "the selection" && told.detail.contains("includes none"), "{told:?}");
    let twice = [rip.clone(), rip.clone()];
    let told = decide(&with(&certificate, &rsp.motion, &twice), &model).unwrap_err();
    assert!(told.claim == "the selection" && told.detail.contains("in 1 rounds"), "{told:?}");
    // A plan to select by has to be one.
    let mut tame = rip.clone();
    tame.x.iter_mut().for_each(|x| x[0] += 0.5);
    let told = decide(&with(&certificate, &rsp.motion, &[tame]), &model).unwrap_err();
    assert!(told.claim.starts_with("plan 1 to select from: waypoint 1"), "{told:?}");
    // Planners that select nothing carry none.
    let told = decide(&with(&certificate, rip, &twice[..1]), &quick(PlannerKind::Rip, 1)).unwrap_err();
    assert!(told.claim == "the selection" && told.detail.contains("selects no facets"), "{told:?}");
}

#[test]
fn rounds_carry_a_plan_each() {
    let model = quick(PlannerKind::Rsp, 2);
    let certificate = certified(&model).unwrap();
    let verdict = decide(&certificate, &model).unwrap();
    let carried = claim(&certificate).selected_by.len();
    assert!((1..=2).contains(&carried));
    assert_eq!(verdict.weaker.iter().filter(|w| w.contains("rounds")).count(), 0, "{verdict:?}");
    // One round fewer is carried than the spec has: said, unless the rounds had ended by themselves.
    let fewer = with(&certificate, &claim(&certificate).motion, &claim(&certificate).selected_by[..1]);
    match decide(&fewer, &model) {
        Ok(verdict) if carried == 2 => {
            let closed = !verdict.weaker.iter().any(|w| w.contains("selects in 2 rounds"));
            assert!(closed || verdict.headline.contains("included RIP plan"), "{verdict:?}");
        }
        other => assert!(carried == 1 && other.is_ok(), "{other:?}"),
    }
}

/// A plan to select by that stays inside every set selects nothing; a motion that leaves one is then guarded by
/// nothing.
#[test]
fn a_tame_plan_to_select_by_guards_nothing() {
    let model = quick(PlannerKind::Rsp, 1);
    let rip = certified(&quick(PlannerKind::Rip, 1)).unwrap();
    let tame = certified(&quick(PlannerKind::Rcp, 1)).unwrap();
    let forged = with(&rip, &claim(&rip).motion, std::slice::from_ref(&claim(&tame).motion));
    let weaker = decide(&forged, &model).unwrap().weaker;
    assert!(
        weaker.iter().any(|w| w.starts_with("the included plan selects no facet, but the motion leaves")),
        "{weaker:?}"
    );
    // Where the motion stays inside as well nothing is missing.
    let whole = with(&rip, &claim(&tame).motion, std::slice::from_ref(&claim(&tame).motion));
    assert!(decide(&whole, &model).unwrap().weaker.is_empty());
}

/// All rounds select at one time, and where the spec leaves time free the headline names it.
#[test]
fn plans_to_select_by_take_one_time() {
    let model = |rounds: usize| {
        let mut model = quick(PlannerKind::Rsp, rounds);
        model.plan.time = MissionTime::Minimum;
        model
    };
    let at = |planner: PlannerKind, time: f64| {
        let mut model = quick(planner, 1);
        model.plan.time = MissionTime::Fixed(time);
        claim(&certified(&model).unwrap()).motion.clone()
    };
    let tame = certified(&quick(PlannerKind::Rcp, 1)).unwrap();
    let (motion, slow) = (claim(&tame).motion.clone(), at(PlannerKind::Rip, 3.5));
    let [tame_too, later] = [3.5, 3.6].map(|time| at(PlannerKind::Rcp, time));
    let verdict = decide(&with(&tame, &motion, std::slice::from_ref(&slow)), &model(1)).unwrap();
    assert!(verdict.headline.ends_with("for the facets selected by the included RIP plan, of 3.5 s"), "{verdict:?}");
    let twice = decide(&with(&tame, &motion, &[slow.clone(), tame_too]), &model(2)).unwrap();
    assert!(twice.headline.ends_with("for the facets selected by the 2 included plans, of 3.5 s"), "{twice:?}");
    let told = decide(&with(&tame, &motion, &[slow, later]), &model(2)).unwrap_err();
    assert_eq!(
        (told.claim.as_str(), told.detail.as_str()),
        ("the selection", "plans 1 and 2 to select from take 3.5 s and 3.6 s")
    );
}
