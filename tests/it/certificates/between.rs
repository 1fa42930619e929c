//! What reports say of plans between their nodes, against dense samples of the motion.

use super::{SHA, certified, decide, hop, planned};
use crate::cli::flat;
use crate::vehicles::{limit, waypoint};
use mavc::certify::between::{Between, Shown, WRENCH, between};
use mavc::model::{LimitKind, MissionTime, Model, PlanModel, PlannerKind, Problem};
use mavc::motion::checks::violation;
use mavc::motion::{NodeState, tilt};
use mavc::planner::studies::{Comparison, MissionPlan, PlanOutcome};
use mavc::report::between as words;
use mavc::report::caveats::{CaveatKind, caveats};
use mavc::verify::Scope;
use mavc::verify::plan::{MOST_OUTSIDE, MOST_PAST_LIMIT};

fn solved(comparison: &Comparison) -> &MissionPlan {
    match &comparison.runs.last().unwrap().outcome {
        PlanOutcome::Planned(solved) => solved,
        other => panic!("{other:?}"),
    }
}

fn told(model: &Model, comparison: &Comparison) -> Vec<Between> {
    between(Problem::of(model).unwrap(), comparison.runs.last().unwrap(), solved(comparison))
}

/// The largest value over the flight, at points that no grid of the reports has.
fn largest(solved: &MissionPlan, quantity: impl Fn(&NodeState) -> f64) -> f64 {
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
        let w = plan.trajectory.wrench(&model.vehicle, &model.environment(), s);
        set.rows.iter().map(|r| r.violation(&w)).fold(f64::NEG_INFINITY, f64::max)
    });
    assert_eq!(found[0].rows, WRENCH);
    let seen = std::iter::once(outside).chain(limits.iter().map(|limit| {
        largest(plan, |s| match limit.kind {
            // |a| sin(tilt - L) / g
            LimitKind::Tilt => {
                let size = (s[0][2].powi(2) + s[1][2].powi(2) + (s[2][2] + model.gravity).powi(2)).sqrt();
                size * (tilt(s, &model.environment()) - limit.upper.unwrap()).sin() / model.gravity
            }
            _ => violation(limit, s, &model.environment()),
        })
    }));
    for (b, seen) in found.iter().zip(seen) {
        match b.shown {
            Shown::Proved => assert!(seen <= b.violation + 1e-9 && b.points.is_none(), "{b:?}: {seen}"),
            // Another grid sees about the same.
            Shown::Checked => assert!((seen - b.violation).abs() < 1e-3 && b.points == Some(64), "{b:?}: {seen}"),
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
    assert!(
        flat(&text).starts_with(
            "Proved at every instant, to within 0.01 %: the linear model's wrench satisfies every imposed facet"
        ),
        "{text}"
    );

    let mut exact = hop(PlannerKind::Rip, 10.0);
    exact.plan.model = PlanModel::Exact;
    let comparison = planned(&exact);
    let found = told(&exact, &comparison);
    assert_true(&exact, &comparison, &found);
    assert!(found.iter().all(|b| b.shown == Shown::Proved), "{found:?}");
    // In the exact model it is the vehicle's wrench.
    let text = words::between(&exact, solved(&comparison), &found);
    assert!(
        flat(&text).starts_with("Proved at every instant, to within 0.01 %: the wrench satisfies every imposed facet"),
        "{text}"
    );
}

/// The same motion in a part of the time.
fn hurry(plan: &mut MissionPlan, factor: f64) {
    plan.trajectory.times.iter_mut().for_each(|t| *t *= factor);
    for axis in plan.trajectory.nodes.iter_mut().flatten() {
        axis.iter_mut().enumerate().for_each(|(order, d)| *d /= factor.powi(order as i32));
    }
}

/// The report of a plan agrees with the checker's result for its certificate.
#[test]
fn reports_and_certificates_say_the_same() {
    for (planner, time) in [(PlannerKind::Rsp, 8.0), (PlannerKind::Rcp, 8.0), (PlannerKind::Rip, 12.0)] {
        let mut model = hop(planner, time);
        model.plan.model = PlanModel::Exact;
        let comparison = planned(&model);
        let found = told(&model, &comparison);
        let mission = model.mission.as_ref().unwrap();
        let certificate = mavc::certify::of(Problem::of(&model).unwrap(), &comparison, SHA.into()).unwrap();
        let shown = decide(&certificate, &model).unwrap().shown;
        let throughout = |prefix: &str| {
            let of = shown.iter().filter(|s| s.statement.starts_with(prefix));
            of.map(|s| s.reach.unwrap().scope == Scope::EveryInstant).collect::<Vec<_>>()
        };
        assert_eq!(found[0].shown == Shown::Proved, throughout("wrench inside").into_iter().all(|all| all));
        let limits = throughout("limit on");
        assert_eq!(limits.len(), mission.limits.len());
        for ((b, limit), proved) in found[1..].iter().zip(&mission.limits).zip(limits) {
            assert_eq!(b.shown == Shown::Proved && b.violation <= MOST_PAST_LIMIT * limit.size(), proved, "{b:?}");
        }
    }
}

/// Of a motion that breaks some facets no more are called proved than dense samples keep, and the words count them.
#[test]
fn some_facets_proved_are_counted() {
    let mut partly = 0;
    for (planner, factor) in [(PlannerKind::Rcp, 0.6), (PlannerKind::Rip, 0.45)] {
        let mut model = hop(planner, 8.0);
        model.plan.model = PlanModel::Exact;
        let mut comparison = planned(&model);
        let PlanOutcome::Planned(plan) = &mut comparison.runs.last_mut().unwrap().outcome else { panic!("no plan") };
        hurry(plan, factor);
        let found = told(&model, &comparison);
        let (plan, rows) = (solved(&comparison), &comparison.runs.last().unwrap().set.rows);
        let keeps = |row: &&mavc::admissible::row::SetRow| {
            let excess =
                |s: &NodeState| row.violation(&plan.trajectory.wrench(&model.vehicle, &model.environment(), s));
            largest(plan, excess) <= MOST_OUTSIDE
        };
        let kept = rows.iter().filter(keeps).count();
        assert_eq!(found[0].imposed, rows.len());
        assert!(found[0].proved <= kept && found[0].proved + 3 >= kept, "{} of {kept}", found[0].proved);
        let some = 0 < found[0].proved && found[0].proved < rows.len();
        partly += usize::from(some);
        let text = words::between(&model, plan, &found);
        let words = format!("the wrench satisfies {} of the {} imposed planes", found[0].proved, rows.len());
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(text.contains(&words), some, "{text}");
    }
    assert!(partly > 0, "all or none are proved");
}

/// A plan flown faster than its set and limits allow: the report claims nothing false and gives the violation of rows.
#[test]
fn what_does_not_hold_is_not_proved() {
    let model = hop(PlannerKind::Rip, 7.2);
    let mut comparison = planned(&model);
    let run = comparison.runs.last_mut().unwrap();
    let PlanOutcome::Planned(plan) = &mut run.outcome else { panic!("no plan") };
    hurry(plan, 0.3);
    let found = told(&model, &comparison);
    assert_true(&model, &comparison, &found);
    let passed: Vec<&str> = found.iter().filter(|b| b.shown == Shown::Checked).map(|b| b.rows.as_str()).collect();
    assert!(passed.contains(&WRENCH) && passed.contains(&"speed"), "{found:?}");
    let text = words::between(&model, solved(&comparison), &found);
    assert!(text.contains("Checked on a grid of 64 points per interval"), "{text}");
    // The violation of a limit is reported once, by the caveat that knows the instant.
    let caveats: Vec<String> = caveats(&model, solved(&comparison)).into_iter().map(|c| c.message).collect();
    let whole = format!("{}\n{text}", caveats.join("\n"));
    assert!(whole.contains("the speed limit is exceeded by"), "{whole}");
    assert_eq!(whole.matches("speed").count(), 1, "{whole}");
}

/// 64 m in 0.6 s at a mean of 107 m/s: without a limit on the speed a plan says how fast it is.
#[test]
fn impossible_speeds_are_reported() {
    let mut model = hop(PlannerKind::Rip, 0.6);
    let flight = model.mission.as_mut().unwrap();
    flight.waypoints = vec![waypoint([0.0, 0.0, 2.0], 0.0), waypoint([64.0, 0.0, 2.0], 0.0)];
    flight.legs.truncate(1);
    (flight.start_at_rest, flight.end_at_rest) = (false, false);
    flight.limits.clear();
    let told = |model: &Model| {
        let comparison = planned(model);
        let found = caveats(model, solved(&comparison)).into_iter().find(|c| c.kind == CaveatKind::Speed);
        let fastest =
            largest(solved(&comparison), |s| s.iter().take(3).map(|axis| axis[1].powi(2)).sum::<f64>().sqrt());
        (found.map(|caveat| caveat.value), fastest)
    };
    let (Some(value), fastest) = told(&model) else { panic!("no caveat about the speed") };
    assert!(fastest > 100.0 && (value / fastest - 1.0).abs() < 1e-3, "{value} {fastest}");
    let mut slow = model.clone();
    slow.plan.time = MissionTime::Fixed(16.0);
    let flight = slow.mission.as_mut().unwrap();
    (flight.start_at_rest, flight.end_at_rest) = (true, true);
    assert_eq!(told(&slow).0, None);
    model.mission.as_mut().unwrap().limits = vec![limit(LimitKind::Speed, 1000.0)];
    assert_eq!(told(&model).0, None, "a limit is what was meant");
}

/// In the hover model a plan that nearly falls keeps any limit on tilt, and certificates of it say so.
#[test]
fn a_limit_on_tilt_says_little_where_thrust_vanishes() {
    let mut model = hop(PlannerKind::Rip, 2.0);
    model.plan.reserve = 0.0;
    let flight = model.mission.as_mut().unwrap();
    // Down by 12 m in two seconds: free fall for as long as it lasts.
    flight.waypoints = vec![waypoint([0.0, 0.0, 14.0], 0.0), waypoint([0.0, 0.0, 3.4], 0.0)];
    flight.legs.truncate(1);
    flight.limits = vec![limit(LimitKind::Tilt, 0.35)];
    let falling = decide(&certified(&model).unwrap(), &model).unwrap();
    assert!(
        falling.weaker.iter().any(|w| w.starts_with("limit on tilt: it is not shown that the thrust")),
        "{falling:?}"
    );
    model.plan.time = MissionTime::Fixed(6.0);
    let calm = decide(&certified(&model).unwrap(), &model).unwrap();
    assert!(calm.weaker.is_empty(), "{calm:?}");
}
