//! Committed seconds, risk and its strip against sampling and another formulation; what a required risk chooses.

use crate::vehicles::{lost, octocopter, paper_case, viviani};
use mavc::model::{FaultMode, MissionTime, Model, PlannerKind};
use mavc::planner::compare::protect::{Protection, UNMET};
use mavc::planner::compare::{Comparison, Ending, Scope, Solved, compare};
use mavc::planner::rows::ACCEPTED;
use mavc::planner::select::VIOLATED;
use mavc::trajectory::nearness::nearness;
use mavc::trajectory::risk::{rated_risk, risk};
use proptest::prelude::*;

fn run(model: &Model, scope: Scope) -> Comparison {
    compare(model, model.mission.as_ref().unwrap(), scope, None)
}

fn solved(comparison: &Comparison) -> &Solved {
    match &comparison.runs.last().unwrap().ending {
        Ending::Solved(s) => s,
        other => panic!("{other:?}"),
    }
}

proptest! {
    /// Modes taken as independent: the mission is spared if each mode spares it.
    #[test]
    fn risk_is_what_no_mode_spares(modes in prop::collection::vec((0.0..1e-2f64, 0.0..100.0f64), 0..12)) {
        let spared: f64 = modes.iter().map(|(rate, committed)| (-rate * committed).exp()).product();
        prop_assert!((risk(modes) - (1.0 - spared)).abs() < 1e-12);
    }
}

#[test]
fn tiny_risks_keep_their_digits() {
    let rate = 1e-9 / 3600.0;
    assert!((risk([(rate, 15.0)]) / (rate * 15.0) - 1.0).abs() < 1e-11);
    assert_eq!(risk([]), 0.0);
}

/// A flight of the paper's curve that cares for no fault, at a time at which it passes the set of rotor 1's loss.
fn careless(modes: &[usize]) -> Model {
    let mut model = paper_case(PlannerKind::Rip, modes);
    model.plan.samples = 100;
    model.plan.time = MissionTime::Fixed(17.0);
    model
}

#[test]
fn committed_until_the_last_sample_outside() {
    let model = careless(&[0, 3]);
    let comparison = run(&model, Scope::Plan);
    let s = solved(&comparison);
    let steps = 20_000;
    for (out, set) in s.outside.iter().zip(&comparison.sets) {
        let step = s.time / f64::from(steps);
        let is_out = |t: f64| {
            let w = s.trajectory.wrench(&model.vehicle, model.gravity, &s.trajectory.at(t));
            set.rows.iter().any(|r| r.excess(&w) > VIOLATED)
        };
        let last = (0..=steps).rev().map(|i| f64::from(i) * step).find(|t| is_out(*t));
        assert!((out.committed() - last.unwrap_or(0.0)).abs() <= step, "{} {last:?}", out.committed());
    }
    assert!(s.outside.iter().any(|o| o.committed() > 0.0), "the plan leaves some set");
    // Only what has a rate counts.
    assert_eq!(rated_risk(&[None, None], &s.committed), None);
    let rate = 1e-3;
    let alone = rated_risk(&[Some(rate), None], &s.committed).unwrap();
    assert!((alone - (1.0 - (-rate * s.outside[0].committed()).exp())).abs() < 1e-12);
}

#[test]
fn strips_show_the_smallest_margin_of_each_part() {
    let model = careless(&[0]);
    let comparison = run(&model, Scope::Plan);
    let s = solved(&comparison);
    let rows = &comparison.sets[0].rows;
    let columns = 32;
    let strip = nearness(&s.trajectory, &model.vehicle, model.gravity, rows, columns);
    let margin = |t: f64| {
        let w = s.trajectory.wrench(&model.vehicle, model.gravity, &s.trajectory.at(t));
        rows.iter().map(|r| -r.excess(&w)).fold(f64::INFINITY, f64::min)
    };
    for (column, smallest) in strip.iter().enumerate() {
        let at = |i: i32| s.time * (column as f64 + (f64::from(i) + 0.5) / 400.0) / columns as f64;
        let sampled = (0..400).map(|i| margin(at(i))).fold(f64::INFINITY, f64::min);
        // The wrench is linear between nodes, so the smallest margin lies at a node or at an end.
        assert!(*smallest <= sampled + 1e-9 && *smallest >= sampled - 0.02, "{column}: {smallest} {sampled}");
    }
    let least = strip.iter().copied().fold(f64::INFINITY, f64::min);
    assert!((least + s.outside[0].max_violation).abs() < 1e-9, "{least} {}", s.outside[0].max_violation);
}

/// All single losses, the curve, and a bound on the risk.
fn required(bound: f64, time: MissionTime) -> Model {
    let mut model = octocopter("PPNNPPNN");
    model.modes = (1..=4).map(|k| FaultMode { rate: Some(1e-5 / 3600.0), ..lost(&model, &[k]) }).collect();
    model.mission = Some(viviani());
    model.plan.against = (0..4).collect();
    model.plan.samples = 60;
    model.plan.time = time;
    model.plan.require_risk = Some(bound);
    model
}

#[test]
fn a_required_risk_is_kept_and_each_addition_takes_risk_away() {
    for time in [MissionTime::Minimum, MissionTime::Fixed(18.0)] {
        let free = required(0.9, time);
        let nothing = run(&free, Scope::Plan);
        // A bound that the RIP plan keeps asks for no protection.
        assert_eq!(nothing.trade_off.len(), 1);
        assert_eq!(nothing.trade_off[0].added, Protection::Nothing);
        let before = nothing.trade_off[0].risk;
        assert!(before > 0.0, "the plan is committed to some mode");
        let bound = 0.3 * before;
        let model = required(bound, time);
        let found = run(&model, Scope::Plan);
        let s = solved(&found);
        let rates: Vec<Option<f64>> = model.modes.iter().map(|m| m.rate).collect();
        let kept = rated_risk(&rates, &s.committed).unwrap();
        assert!(kept <= bound, "{kept}");
        assert_eq!((found.trade_off[0].risk, found.trade_off.last().unwrap().risk), (before, kept));
        assert!(found.trade_off.len() > 1);
        assert!(found.trade_off.windows(2).all(|w| w[1].risk < w[0].risk && w[1].time >= w[0].time));
        // The plan is inside the set that it reports.
        for w in s.trajectory.node_wrenches(&model.vehicle, model.gravity) {
            assert!(found.runs[0].set.rows.iter().all(|r| r.excess(&w) <= ACCEPTED));
        }
    }
}

#[test]
fn a_risk_that_cannot_be_kept_is_told_with_the_best_curve() {
    // At 16 s RIP has a plan and RCP jointly, from 16.83 s on, has none.
    let mut model = required(0.0, MissionTime::Fixed(16.2));
    model.plan.samples = 100;
    let found = run(&model, Scope::Plan);
    let ending = &found.runs[0].ending;
    assert!(matches!(ending, Ending::Inconclusive { status, .. } if status == UNMET), "{ending:?}");
    assert!(!found.trade_off.is_empty());
    // Where there is no plan at all, no risk is to blame.
    let early = run(&required(0.0, MissionTime::Fixed(12.0)), Scope::Plan);
    assert!(matches!(early.runs[0].ending, Ending::Infeasible { .. }) && early.trade_off.is_empty());
}
