//! Certificates of plans with lagging rotors: the checker's commanded wrench against the planner's and against finite
//! differences, and that every claim about it is required.

use super::wrench::{G, at, exact_by_differences, path, state};
use super::{Numbers, SHA, certified, decide, hop, planned, verify};
use crate::lag::{lagging, planning, shortest, shuttle};
use crate::vehicles::octocopter;
use mavc::certificate::{Certificate, Claim, DynamicModel, InfeasibleClaim, MotionRecord, RowRecord, Vertical};
use mavc::certify::between::{COMMANDS, Shown, between};
use mavc::model::{MissionTime, Model, PlanModel, PlannerKind, Problem};
use mavc::motion::CommandState;
use mavc::motion::wrench_model::WrenchModel;
use mavc::planner::studies::PlanOutcome;
use mavc::verify::interval::Interval;
use mavc::verify::lag::constant;
use mavc::verify::motion::Motion;
use mavc::verify::wrench::{Dynamics, Held};
use mavc::verify::{Scope, Shown as Stands};

const TAU: f64 = 0.1;

fn commands() -> Held {
    Held::Commands { tau: Interval::point(TAU) }
}

#[test]
fn the_constant_is_the_planners() {
    let mut model = lagging(octocopter("PPNNPPNN"), TAU);
    let mut narrow = |idle: f64, low: f64, high: f64| {
        model.vehicle.rotors[3].min_speed = idle;
        model.vehicle.rotors[3].spread.idle_thrust.low = low;
        model.vehicle.rotors[3].spread.full_thrust.high = high;
        let (found, planned) = (constant(&model).unwrap(), model.thrust_lag().unwrap());
        assert!(
            (found.middle() / planned - 1.0).abs() < 1e-14 && found.high - found.low < 1e-14,
            "{found:?} {planned}"
        );
        planned
    };
    let slow = narrow(0.0, 1.0, 1.0);
    assert!((slow - TAU).abs() < 1e-12);
    assert_eq!(narrow(500.0, 0.9, 1.1), slow, "the others are slower");
    model.vehicle.rotors.iter_mut().for_each(|r| r.min_speed = 500.0);
    let quick = (constant(&model).unwrap(), model.thrust_lag().unwrap());
    assert!((quick.0.middle() / quick.1 - 1.0).abs() < 1e-14 && quick.1 < 0.9 * TAU, "{quick:?}");
    assert_eq!(constant(&octocopter("PPNNPPNN")), None);
}

/// w + tau w' as the planner has it, in all three of its models, and by differences of the attitude.
#[test]
fn commanded_wrenches_are_the_planners() {
    let mut vehicle = octocopter("PPNNPPNN").vehicle;
    vehicle.inertia = [0.03, 0.05, 0.07];
    let mut numbers = Numbers(21);
    for _ in 0..200 {
        let path = path(&mut numbers);
        let mut hover = path;
        // Where z'' is the input it changes evenly.
        hover[2][4..].fill(0.0);
        let psi = path[3][0] + 0.2;
        for (kind, one_yaw, planner, path) in [
            (DynamicModel::Exact, None, WrenchModel::Exact, path),
            (DynamicModel::Hover, None, WrenchModel::HoverFollowing, hover),
            (DynamicModel::Hover, Some(psi), WrenchModel::HoverAt(psi), hover),
        ] {
            let dynamics =
                Dynamics { vehicle: &vehicle, environment: mavc::model::Environment::vacuum(G), model: kind, one_yaw };
            let sloped: CommandState = at(&path, 0.0);
            let expected = planner.commanded(&vehicle, &mavc::model::Environment::vacuum(G), TAU, &sloped);
            let found = dynamics.held(commands(), &state(&path, 0.0));
            for i in 0..4 {
                let off = (found.value[i].middle() - expected[i]).abs();
                assert!(off < 1e-9 * (1.0 + expected[i].abs()), "{kind:?} {i}: {found:?} {expected}");
                assert!(found.value[i].high - found.value[i].low < 1e-9, "{kind:?} {i}: {found:?} is wide");
            }
            if kind == DynamicModel::Exact {
                let h = 0.01;
                let [before, after] = [-h, h].map(|t| exact_by_differences(&path, &vehicle, t));
                let now = exact_by_differences(&path, &vehicle, 0.0);
                let bend = |i: usize| (before[i] - 2.0 * now[i] + after[i]).abs() / (h * h);
                for i in (0..4).filter(|&i| bend(i) < 30.0) {
                    let commanded = now[i] + TAU * (after[i] - before[i]) / (2.0 * h);
                    assert!((found.value[i].middle() - commanded).abs() < 0.01, "{i}: {found:?} {commanded}");
                }
            }
            // The rate, from the values shortly before and after.
            let h = 1e-5;
            let [before, after] = [-h, h].map(|t| dynamics.held(commands(), &state(&path, t)).value);
            for i in 0..4 {
                let rate = (after[i].middle() - before[i].middle()) / (2.0 * h);
                let told = found.rate[i];
                assert!((told.middle() - rate).abs() < 1e-3 * (1.0 + rate.abs()), "{kind:?} {i}: {told:?} {rate}");
            }
        }
    }
}

/// Enclosures over a stretch hold every value on it.
#[test]
fn intervals_enclose_the_commanded_wrenches() {
    let vehicle = octocopter("PPNNPPNN").vehicle;
    let mut numbers = Numbers(22);
    let dynamics = Dynamics {
        vehicle: &vehicle,
        environment: mavc::model::Environment::vacuum(G),
        model: DynamicModel::Exact,
        one_yaw: None,
    };
    for _ in 0..30 {
        let path = path(&mut numbers);
        let ends = [0.0, 0.05].map(|t| at(&path, t));
        let record = MotionRecord {
            times_s: vec![0.0, 0.05],
            x: ends.iter().map(|d| d[0][..5].try_into().unwrap()).collect(),
            y: ends.iter().map(|d| d[1][..5].try_into().unwrap()).collect(),
            z: ends.iter().map(|d| Vertical::Exact(d[2][..5].try_into().unwrap())).collect(),
            yaw: ends.iter().map(|d| d[3][..3].try_into().unwrap()).collect(),
            waypoint_nodes: vec![0, 1],
        };
        let motion = Motion::new(&record, DynamicModel::Exact, true).unwrap();
        let over = dynamics.held(commands(), &motion.over(0, Interval::new(0.0, 0.05)));
        for i in 0..=10 {
            let found = dynamics.held(commands(), &motion.over(0, Interval::point(0.005 * f64::from(i))));
            for axis in 0..4 {
                assert!(over.value[axis].contains(found.value[axis].middle()), "{axis} {i}");
                assert!(over.rate[axis].contains(found.rate[axis].middle()), "{axis} {i}");
            }
        }
    }
}

/// Plans of every planner in both models, of the pseudo-inverse and of intervals; each with the scope to which most of
/// the rows on commands are shown.
#[test]
fn lagging_plans_are_certified() {
    let exact = |planner, time| {
        let mut model = hop(planner, time);
        model.plan.model = PlanModel::Exact;
        model
    };
    let mut inverted = hop(PlannerKind::Rcp, 9.0);
    inverted.vehicle.allocation = mavc::model::Allocation::PseudoInverse;
    let mut uncertain = hop(PlannerKind::Rcp, 9.0);
    super::sets::doubt(&mut uncertain);
    let mut turning = hop(PlannerKind::Rip, 9.0);
    turning.mission.as_mut().unwrap().waypoints[2].yaw = 0.8;
    let plans = [
        hop(PlannerKind::Rip, 8.0),
        hop(PlannerKind::Rsp, 9.0),
        exact(PlannerKind::Rip, 9.0),
        exact(PlannerKind::Rcp, 10.0),
        inverted,
        uncertain,
        turning,
    ];
    for (which, model) in plans.into_iter().enumerate() {
        let model = lagging(model, TAU);
        let comparison = planned(&model);
        let problem = Problem::of(&model).unwrap();
        let certificate = mavc::certify::of(problem, &comparison, SHA.into());
        let certificate = certificate.unwrap_or_else(|no| panic!("{which}: {no}"));
        let verdict = verify(&serde_json::to_vec(&certificate).unwrap(), &model, SHA).unwrap();
        let commanded: Vec<&Stands> = verdict.shown.iter().filter(|s| s.statement.contains("commands")).collect();
        let inside = |of: &str| verdict.shown.iter().filter(|s| s.statement.contains(&format!("{of} inside"))).count();
        assert!(inside("commands") > 0 && inside("commands") == inside("wrench"), "{which}: {verdict:?}");
        let throughout = |s: &&Stands| s.reach.is_some_and(|r| r.scope == Scope::EveryInstant);
        assert!(commanded.iter().any(throughout), "{which}: {commanded:?}");
        // The report's statement about commands agrees with dense samples.
        let run = comparison.runs.last().unwrap();
        let PlanOutcome::Planned(solved) = &run.outcome else { panic!("no plan") };
        let told = between(problem, run, solved);
        let told = told.iter().find(|b| b.rows == COMMANDS).unwrap();
        let (plan, tau) = (&solved.trajectory, model.thrust_lag().unwrap());
        let looks = (0..plan.intervals()).flat_map(|k| (0..=97).map(move |i| (k, f64::from(i) / 97.0)));
        let seen = looks.map(|(k, share)| {
            let s = plan.within(k, share * (plan.times[k + 1] - plan.times[k]));
            let commanded = plan.commanded(&model.vehicle, &model.environment(), tau, k, &s);
            run.set.rows.iter().map(|r| r.violation(&commanded)).fold(f64::NEG_INFINITY, f64::max)
        });
        let seen = seen.fold(f64::NEG_INFINITY, f64::max);
        match told.shown {
            Shown::Proved => assert!(seen <= told.violation + 1e-9, "{which}: {told:?} {seen}"),
            Shown::Checked => assert!((seen - told.violation).abs() < 1e-3, "{which}: {told:?} {seen}"),
        }
    }
}

/// A plan for rotors that follow at once is none for rotors that lag, nor one for rotors that lag less.
#[test]
fn commands_are_looked_at() {
    let mut instant = hop(PlannerKind::Rip, 4.0);
    instant.mission.as_mut().unwrap().limits.clear();
    let at_once = certified(&instant).unwrap();
    let told = decide(&at_once, &lagging(instant.clone(), 20.0 * TAU)).unwrap_err();
    assert!(told.claim.contains("the commands in the set of healthy"), "{told:?}");
    // A plan for rotors that lag a little is none for slower ones.
    let model = lagging(instant, TAU);
    let certificate = certified(&model).unwrap();
    decide(&certificate, &model).unwrap();
    let told = decide(&certificate, &lagging(model, 20.0 * TAU)).unwrap_err();
    assert!(told.claim.contains("the commands in "), "{told:?}");
}

fn infeasible(certificate: &mut Certificate) -> &mut InfeasibleClaim {
    match &mut certificate.claim {
        Claim::Infeasible(claim) => claim,
        _ => panic!("no multipliers"),
    }
}

/// A mission that only the lag makes infeasible is proved so by rows on commands; such rows are rejected for rotors
/// without lag.
#[test]
fn a_time_too_short_for_lagging_rotors_is_certified() {
    let instant = planning(shuttle(), PlanModel::Hover, MissionTime::Minimum);
    let fixed = |time: f64| Model {
        plan: mavc::model::PlanSettings { time: MissionTime::Fixed(time), ..instant.plan.clone() },
        ..instant.clone()
    };
    let time = 1.03 * shortest(&instant);
    assert!(matches!(planned(&fixed(time)).runs[0].outcome, PlanOutcome::Planned(_)));
    let model = lagging(fixed(time), 0.3);
    let certificate = certified(&model).expect("no plan");
    let verdict = decide(&certificate, &model).unwrap();
    assert!(verdict.headline.starts_with("proved infeasible"), "{verdict:?}");
    let is_commands = |row: &RowRecord| matches!(row, RowRecord::Commands { .. });
    let refused = |change: &dyn Fn(&mut InfeasibleClaim), model: &Model, why: &str| {
        let mut changed = certificate.clone();
        change(infeasible(&mut changed));
        let rejection = decide(&changed, model).unwrap_err();
        assert!(rejection.detail.contains(why), "{rejection:?}");
    };
    refused(&|c| c.multipliers.retain(|m| !is_commands(&m.row)), &model, "is not a contradiction");
    refused(&|_| (), &fixed(time), "follow their commands without lag");
    refused(
        &|c| {
            for m in &mut c.multipliers {
                if let RowRecord::Commands { interval, node, .. } = &mut m.row {
                    *interval = *node + 1;
                }
            }
        },
        &model,
        "is not adjacent to node",
    );
    // At a time that has a plan they show nothing.
    let long = 3.0 * time;
    let enough = lagging(fixed(long), 0.3);
    assert!(matches!(planned(&enough).runs[0].outcome, PlanOutcome::Planned(_)));
    refused(&|_| (), &enough, "is not a contradiction");
    // Rotors with less lag have a plan at this time, so the multipliers must not prove infeasibility there.
    assert!(decide(&certificate, &lagging(fixed(time), 1e-6)).is_err());
}
