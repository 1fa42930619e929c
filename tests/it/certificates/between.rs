//! What reports say of plans between their nodes, against dense samples of the motion.

use super::{hop, planned};
use mavc::certificate::between::{Between, Shown, WRENCH, between};
use mavc::model::{LimitKind, Model, PlanModel, PlannerKind};
use mavc::planner::compare::{Comparison, Ending, Solved};
use mavc::planner::transcribe::NodeState;
use mavc::report::between as words;
use mavc::trajectory::checks::past;
use mavc::trajectory::tilt;

fn solved(comparison: &Comparison) -> &Solved {
    match &comparison.runs.last().unwrap().ending {
        Ending::Solved(solved) => solved,
        other => panic!("{other:?}"),
    }
}

fn told(model: &Model, comparison: &Comparison) -> Vec<Between> {
    between(model, model.mission.as_ref().unwrap(), comparison.runs.last().unwrap(), solved(comparison))
}

/// The largest value over the flight, at points that no grid of the reports has.
fn largest(solved: &Solved, quantity: impl Fn(&NodeState) -> f64) -> f64 {
    let t = &solved.trajectory;
    let looks = (0..t.intervals()).flat_map(|k| (0..=97).map(move |i| (k, f64::from(i) / 97.0)));
    looks
        .map(|(k, share)| quantity(&t.within(k, share * (t.times[k + 1] - t.times[k]))))
        .fold(f64::NEG_INFINITY, f64::max)
}

fn assert_true(model: &Model, comparison: &Comparison, found: &[Between]) {
    let (plan, set) = (solved(comparison), &comparison.runs.last().unwrap().set);
    let limits = &model.mission.as_ref().unwrap().limits;
    assert_eq!(found.len(), 1 + limits.len());
    let outside = largest(plan, |s| {
        let w = plan.trajectory.wrench(&model.vehicle, model.gravity, s);
        set.rows.iter().map(|r| r.excess(&w)).fold(f64::NEG_INFINITY, f64::max)
    });
    assert_eq!(found[0].rows, WRENCH);
    let seen = std::iter::once(outside).chain(limits.iter().map(|limit| {
        largest(plan, |s| match limit.kind {
            // |a| sin(tilt - L) / g
            LimitKind::Tilt => {
                let size = (s[0][2].powi(2) + s[1][2].powi(2) + (s[2][2] + model.gravity).powi(2)).sqrt();
                size * (tilt(s, model.gravity) - limit.upper.unwrap()).sin() / model.gravity
            }
            _ => past(limit, s, model.gravity),
        })
    }));
    for (b, seen) in found.iter().zip(seen) {
        match b.shown {
            Shown::Proved => assert!(seen <= b.excess + 1e-9 && b.points.is_none(), "{b:?}: {seen}"),
            // Another grid sees about the same.
            Shown::Checked => assert!((seen - b.excess).abs() < 1e-3 && b.points == Some(64), "{b:?}: {seen}"),
        }
    }
}

#[test]
fn plans_say_what_is_proved() {
    let model = hop(PlannerKind::Rcp, 8.0);
    let comparison = planned(&model);
    let found = told(&model, &comparison);
    assert_true(&model, &comparison, &found);
    assert_eq!(found[0].shown, Shown::Proved);
    let text = words::between(&model, solved(&comparison), &found);
    assert!(text.starts_with("\n  Proved for every instant: the linear model's wrench keeps to every facet imposed"), "{text}");

    let mut exact = hop(PlannerKind::Rip, 10.0);
    exact.plan.model = PlanModel::Exact;
    let comparison = planned(&exact);
    let found = told(&exact, &comparison);
    assert_true(&exact, &comparison, &found);
    assert!(found.iter().all(|b| b.shown == Shown::Proved), "{found:?}");
}

/// A plan flown faster than its set and limits allow: nothing false is said, and how far rows are passed is.
#[test]
fn what_does_not_hold_is_not_proved() {
    let model = hop(PlannerKind::Rip, 7.2);
    let mut comparison = planned(&model);
    let run = comparison.runs.last_mut().unwrap();
    let Ending::Solved(plan) = &mut run.ending else { panic!("no plan") };
    let factor: f64 = 0.3;
    plan.trajectory.times.iter_mut().for_each(|t| *t *= factor);
    for axis in plan.trajectory.nodes.iter_mut().flatten() {
        axis.iter_mut().enumerate().for_each(|(order, d)| *d /= factor.powi(order as i32));
    }
    let found = told(&model, &comparison);
    assert_true(&model, &comparison, &found);
    let passed: Vec<&str> = found.iter().filter(|b| b.shown == Shown::Checked).map(|b| b.rows).collect();
    assert!(passed.contains(&WRENCH) && passed.contains(&"speed"), "{found:?}");
    let text = words::between(&model, solved(&comparison), &found);
    assert!(text.contains("Checked on a grid of 64 points an interval") && text.contains("speed, passed by"), "{text}");
}
