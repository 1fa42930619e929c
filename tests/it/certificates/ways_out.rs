//! Families of ways out: each claims a motion from every state in which a fault may become known. Such motions are made
//! here by the definition, from states of simulated flights, and followed in plain `f64`; false claims are refused.

use super::{Numbers, SHA, decide, planned};
use crate::members::{Blend, kept};
use crate::vehicles::{limit, lost, mission, octocopter, waypoint};
use mavc::admissible::AdmissibleSet;
use mavc::certificate::{Certificate, Claim, MotionRecord, RecoveryClaim};
use mavc::model::{LandingSite, LimitKind, Mission, MissionTime, Model, PlanModel, PlannerKind, Problem, Recovery};
use mavc::motion::{NodeState, Trajectory, X, Y, YAW, Z};
use mavc::planner::selection::sets::of_one_mode;
use mavc::recovery::carry::{carry, quiet};
use mavc::recovery::recovery;
use mavc::source::Span;
use mavc::verify::cost::Budget;
use mavc::verify::{Premises, Settings};

/// The landing site.
const PAD: [f64; 2] = [4.0, 4.0];
const RADIUS: f64 = 1.5;

/// An octocopter that loses rotor 1 on a short leg beside a landing site. With one mode more, which never strikes here,
/// claims can name the wrong one.
fn beside_a_site(order: Recovery, detection: [f64; 2]) -> Model {
    let mut model = octocopter("PPNNPPNN");
    model.modes = vec![lost(&model, &[1]), lost(&model, &[2, 3, 4])];
    let limits = vec![limit(LimitKind::Speed, 6.0), limit(LimitKind::Descent, 3.0)];
    let points = vec![waypoint([0.0, 0.0, 4.0], 0.0), waypoint([8.0, 0.0, 5.0], 0.0)];
    let mut flown = Mission { limits, ground: Some(0.0), ..mission(points) };
    let site = |name: &str, [x, y]: [f64; 2]| LandingSite {
        name: name.into(),
        at: [x, y, 0.0],
        radius: RADIUS,
        span: Span::default(),
    };
    flown.after_fault.sites = vec![site("pad", PAD), site("far", [60.0, 0.0])];
    model.mission = Some(flown);
    model.plan.planner = PlannerKind::Rip;
    model.plan.model = PlanModel::Hover;
    model.plan.samples = 30;
    model.plan.reserve = 0.1;
    model.plan.time = MissionTime::Fixed(6.0);
    model.plan.recovery.order = vec![order];
    model.plan.recovery.detection = detection;
    model.plan.recovery.within = 15.0;
    model
}

/// The certificate of a plan with its ways out, and for how long these are proved, s.
fn certified(model: &Model) -> (Certificate, Trajectory, f64) {
    let problem = Problem::of(model).unwrap();
    let comparison = planned(model);
    let plan = comparison.runs.last().unwrap().outcome.plan().unwrap().trajectory.clone();
    let mut certificate = mavc::certify::of(problem, &comparison, SHA.into()).unwrap();
    // The second mode cannot hover: no way out is sought.
    let found = recovery(problem, &plan, true);
    let proved = found.modes[0].families.as_ref().unwrap().proved_s();
    claim_of(&mut certificate).replace(found.claim().unwrap());
    (certificate, plan, proved)
}

fn claim_of(certificate: &mut Certificate) -> &mut Option<RecoveryClaim> {
    match &mut certificate.claim {
        Claim::Plan(claim) => &mut claim.recovery,
        other => panic!("{other:?}"),
    }
}

fn trajectory(record: &MotionRecord, like: &Trajectory) -> Trajectory {
    let padded = |values: &[f64]| std::array::from_fn(|i| values.get(i).copied().unwrap_or(0.0));
    let node = |k: usize| [record.x[k], record.y[k], padded(record.z[k].derivatives()), padded(&record.yaw[k])];
    Trajectory {
        times: record.times_s.clone(),
        nodes: (0..record.times_s.len()).map(node).collect(),
        waypoint_nodes: record.waypoint_nodes.clone(),
        model: like.model,
    }
}

#[test]
fn a_way_out_is_claimed_from_every_state_in_which_a_fault_becomes_known() {
    for detection in [[0.2; 2], [0.1, 0.2]] {
        let model = beside_a_site(Recovery::LandAtSites, detection);
        let (mut certificate, plan, proved) = certified(&model);
        assert!(proved > 0.9 * plan.duration(), "only {proved} s are proved");
        let shown = decide(&certificate, &model).unwrap().shown;
        assert!(shown.iter().any(|shown| shown.statement.starts_with("after M1, for ")), "{shown:?}");
        let claim = claim_of(&mut certificate).clone().unwrap();
        let branches: Vec<Trajectory> = claim.branches.iter().map(|branch| trajectory(branch, &plan)).collect();
        let healthy = AdmissibleSet::healthy(&model);
        let (set, _) = of_one_mode(&model, 0, &healthy);
        let mut numbers = Numbers(45);
        for _ in 0..150 {
            let family = &claim.families[numbers.below(claim.families.len())];
            let [s, r] = [0, 1].map(|_| 0.5 + 0.5 * numbers.unit());
            let [at, delay] = Blend::when(family, s, r);
            let struck = carry(&model, &quiet(&model), &plan, 0, at, delay).unwrap().state;
            let blend = Blend::new(family.corners.map(|corner| &branches[corner]), s, r);
            let (first, duration) = (blend.at(0.0), blend.duration());
            let apart: NodeState =
                std::array::from_fn(|axis| std::array::from_fn(|k| struck[axis][k] - first[axis][k]));
            let flown = |t: f64| blend.between(&apart, &NodeState::default(), t);
            let begin = flown(0.0);
            for axis in [X, Y, Z, YAW] {
                for (flown, struck) in begin[axis].iter().zip(&struck[axis]).take(kept(axis)) {
                    assert!((flown - struck).abs() < 1e-9, "axis {axis} begins at {flown}, not {struck}");
                }
            }
            for step in 0..=400 {
                let t = duration * f64::from(step) / 400.0;
                let state = flown(t);
                let wrench = plan.wrench(&model.vehicle, &model.environment(), &state);
                let outside = set.rows.iter().map(|row| row.violation(&wrench)).fold(f64::NEG_INFINITY, f64::max);
                assert!(outside <= 1.001e-4, "{at} s, {delay} s: {outside} outside at {t} s");
                let speed = [X, Y, Z].map(|axis| state[axis][1].powi(2)).iter().sum::<f64>().sqrt();
                assert!(speed <= 6.0 + 1e-3 && state[Z][1] >= -3.0 - 1e-3 && state[Z][0] >= -1e-3, "at {t} s");
            }
            let end = flown(duration);
            let miss = (end[X][0] - PAD[0]).hypot(end[Y][0] - PAD[1]);
            let moving = [X, Y, Z].iter().map(|&axis| end[axis][1].abs()).fold(0.0, f64::max);
            assert!(miss <= RADIUS && end[Z][0] <= 0.03 && moving < 1e-6, "{miss} m, {} m, {moving} m/s", end[Z][0]);
        }
    }
}

#[test]
fn a_way_back_ends_in_the_plan() {
    let model = beside_a_site(Recovery::Continue, [0.2; 2]);
    let (mut certificate, plan, proved) = certified(&model);
    assert!(proved > 0.9 * plan.duration(), "only {proved} s are proved");
    decide(&certificate, &model).unwrap();
    // A branch that joins the plan of another instant is not one.
    let claim = claim_of(&mut certificate).as_mut().unwrap();
    let last = claim.families.len() - 1;
    claim.families[last].corners = claim.families[0].corners;
    assert!(decide(&certificate, &model).is_err());
}

/// Whether a changed claim is refused, and whether the one that was found is not.
fn refused(model: &Model, found: &Certificate, why: &str, change: impl FnOnce(&mut RecoveryClaim)) {
    let mut forged = found.clone();
    change(claim_of(&mut forged).as_mut().unwrap());
    let rejection = decide(&forged, model).expect_err(why);
    assert!(rejection.sentence().contains(why), "{}", rejection.sentence());
}

#[test]
fn false_ways_out_are_refused() {
    let model = beside_a_site(Recovery::LandAtSites, [0.1, 0.2]);
    let (found, plan, _) = certified(&model);
    decide(&found, &model).unwrap();
    let middle = |claim: &RecoveryClaim| claim.families.len() / 2;
    refused(&model, &found, "which no fault explains", |claim| {
        // The motions of another instant.
        let place = middle(claim);
        claim.families[place].corners = claim.families[0].corners;
    });
    refused(&model, &found, "do not follow", |claim| {
        let place = middle(claim);
        claim.families.insert(place, claim.families[place].clone());
    });
    refused(&model, &found, "do not follow", |claim| {
        // The longest delay of some instants is left out.
        let longest = claim.families.iter().position(|family| family.delays_s[1] == 0.2).unwrap();
        claim.families.remove(longest);
    });
    refused(&model, &found, "do not follow", |claim| {
        claim.families.last_mut().unwrap().to_s = plan.duration() + 1.0;
    });
    refused(&model, &found, "no delay above", |claim| {
        let last = claim.families.iter().rposition(|family| family.delays_s[1] == 0.2).unwrap();
        claim.families.truncate(last);
        claim.families.retain(|family| family.delays_s[0] == 0.1 || family.delays_s[1] < 0.2);
        claim.families.truncate(1);
        claim.families[0].delays_s[1] = 0.15;
    });
    refused(&model, &found, "the landing", |claim| {
        // Beside the other site.
        claim.families.iter_mut().for_each(|family| family.way = mavc::certificate::WayRecord::LandAt("far".into()));
    });
    refused(&model, &found, "does not allow", |claim| {
        claim.families[0].way = mavc::certificate::WayRecord::Continue;
    });
    refused(&model, &found, "only bounded", |claim| {
        let place = middle(claim);
        claim.families[place].tolerance.turning_rad_s = 3.0;
    });
    refused(&model, &found, "the landing", |claim| {
        // The same without a last part, in which it has to be above the site.
        claim.families.iter_mut().for_each(|family| family.way = mavc::certificate::WayRecord::LandAt("far".into()));
        for branch in &mut claim.branches {
            let (parts, last) = (branch.waypoint_nodes.len(), branch.times_s.len() - 1);
            branch.waypoint_nodes[parts - 2] = last;
        }
    });
    refused(&model, &found, "negative", |claim| claim.families[0].tolerance.tilt_rad = -0.1);
    refused(&model, &found, "no fault mode", |claim| claim.families[0].mode = "M99".into());
    refused(&model, &found, "not among", |claim| claim.families[0].corners[2] = claim.branches.len());
    refused(&model, &found, "ends in motion", |claim| {
        let branch = &mut claim.branches[claim.families[0].corners[0]];
        let last = branch.x.len() - 1;
        branch.x[last][1] = 5e-6;
    });
    refused(&model, &found, "the gap between", |claim| {
        let branch = &mut claim.branches[claim.families[0].corners[0]];
        let place = branch.x.len() / 2;
        branch.x[place][0] += 0.01;
    });
    // With all premises, a budget that ends too soon shows less and says so.
    let settings = Settings { budget: Budget { seconds: 0.05, ..Budget::default() }, premises: Premises::default() };
    let shown = mavc::verify::decide(&found, &model, settings);
    assert!(shown.is_err() || shown.is_ok_and(|shown| shown.weaker.iter().any(|why| why.contains("budget"))));
}
