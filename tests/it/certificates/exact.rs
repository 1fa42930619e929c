//! Certificates in the exact model: a motion from rest to rest with turning yaw, built here, with bounds from
//! differences of its attitude.

use super::wrench::{G, Path, at, exact_by_differences};
use super::{SHA, decide};
use crate::vehicles::{limit, mission, octocopter, waypoint};
use mavc::actuation::Wrench;
use mavc::admissible::AdmissibleSet;
use mavc::certificate::{Certificate, Claim, DynamicModel, MotionRecord, PlanClaim, SCHEMA, Vertical};
use mavc::model::{LimitKind, MissionTime, Model, PlanModel, PlannerKind};
use mavc::verify::{Premise, Premises, Refusal, Scope, Settings};
use nalgebra::{DMatrix, DVector};

const PIECES: usize = 24;
const STEP: f64 = 0.125;

/// Derivatives at all nodes of a chain of `order` integrators whose input is linear between nodes and zero at the ends.
fn integrated(order: usize, start: f64, inputs: &[f64]) -> Vec<Vec<f64>> {
    let mut state = vec![0.0; order];
    state[0] = start;
    let mut nodes = vec![];
    for k in 0..=PIECES {
        let mut node = state.clone();
        node.push(inputs[k]);
        if k < PIECES {
            node.push((inputs[k + 1] - inputs[k]) / STEP);
            let late = |i: usize| (i..node.len()).rev().fold(0.0, |sum, j| node[j] + sum * STEP / (j + 1 - i) as f64);
            state = (0..order).map(late).collect();
            node.pop();
        }
        nodes.push(node);
    }
    nodes
}

/// The inputs of least length that carry such a chain from rest at `start` to rest at `end`.
fn rest_to_rest(order: usize, start: f64, end: f64) -> Vec<Vec<f64>> {
    let unit = |k: usize| -> Vec<f64> { (0..=PIECES).map(|i| f64::from(u8::from(i == k))).collect() };
    let reached = DMatrix::from_fn(order, PIECES - 1, |i, k| integrated(order, 0.0, &unit(k + 1))[PIECES][i]);
    let mut wanted = DVector::zeros(order);
    wanted[0] = end - start;
    let inputs = reached.pseudo_inverse(1e-14).unwrap() * wanted;
    let all: Vec<f64> = std::iter::once(0.0).chain(inputs.iter().copied()).chain([0.0]).collect();
    let mut nodes = integrated(order, start, &all);
    nodes[PIECES][1..].fill(0.0);
    nodes
}

fn model() -> Model {
    let mut model = octocopter("PPNNPPNN");
    model.vehicle.inertia = [0.03, 0.05, 0.07];
    let mut flight = mission(vec![waypoint([0.0, 0.0, 2.0], 0.2), waypoint([2.5, -1.5, 3.0], 1.2)]);
    flight.limits = vec![limit(LimitKind::Tilt, 0.7), limit(LimitKind::Jerk, 40.0), limit(LimitKind::YawRate, 2.0)];
    model.mission = Some(flight);
    model.plan.planner = PlannerKind::Rip;
    model.plan.model = PlanModel::Exact;
    model.plan.time = MissionTime::Fixed(STEP * PIECES as f64);
    model.plan.reserve = 0.05;
    model
}

/// The largest violation of the healthy set's facets, and the largest tilt, jerk and yaw rate, at many instants.
fn sampled(model: &Model, record: &MotionRecord) -> (f64, [f64; 3]) {
    let set = AdmissibleSet::healthy(model).with_reserve(model.plan.reserve);
    let (mut outside, mut past) = (f64::NEG_INFINITY, [f64::NEG_INFINITY; 3]);
    for k in 0..PIECES {
        let mut path: Path = [[0.0; 6]; 4];
        let axes = [&record.x[k][..], &record.y[k], record.z[k].derivatives(), &record.yaw[k]];
        let next = [&record.x[k + 1][..], &record.y[k + 1], record.z[k + 1].derivatives(), &record.yaw[k + 1]];
        for (axis, (now, then)) in axes.into_iter().zip(next).enumerate() {
            path[axis][..now.len()].copy_from_slice(now);
            path[axis][now.len()] = (then[now.len() - 1] - now[now.len() - 1]) / STEP;
        }
        for i in 0..=16 {
            let t = STEP * f64::from(i) / 16.0;
            let w = Wrench::from(exact_by_differences(&path, &model.vehicle, t));
            let excess = |n: &Wrench, e: f64| (n.dot(&w) - e) / set.zonotope.width(n);
            outside = set.polytope.facets.iter().map(|f| excess(&f.normal, f.offset)).fold(outside, f64::max);
            let s = at(&path, t);
            let lift = s[2][2] + G;
            let tilt = s[0][2].hypot(s[1][2]).atan2(lift);
            let jerk = (s[0][3].powi(2) + s[1][3].powi(2) + s[2][3].powi(2)).sqrt();
            for (most, value) in past.iter_mut().zip([tilt, jerk, s[3][1]]) {
                *most = most.max(value);
            }
        }
    }
    (outside, past)
}

fn certificate() -> Certificate {
    let wide = |start, end| -> Vec<[f64; 5]> {
        rest_to_rest(4, start, end).into_iter().map(|n| n.try_into().unwrap()).collect()
    };
    let motion = MotionRecord {
        times_s: (0..=PIECES).map(|k| STEP * k as f64).collect(),
        x: wide(0.0, 2.5),
        y: wide(0.0, -1.5),
        z: wide(2.0, 3.0).into_iter().map(Vertical::Exact).collect(),
        yaw: rest_to_rest(2, 0.2, 1.2).into_iter().map(|n| n.try_into().unwrap()).collect(),
        waypoint_nodes: vec![0, PIECES],
    };
    let claim = PlanClaim {
        motion,
        selected_by: vec![],
        without_yaw: vec![],
        least_time_s: None,
        weights: vec![],
        recovery: None,
    };
    Certificate {
        schema: SCHEMA,
        spec_sha256: SHA.into(),
        model: DynamicModel::Exact,
        capture_height_m: None,
        claim: Claim::Plan(claim),
    }
}

fn motion(certificate: &Certificate) -> &MotionRecord {
    match &certificate.claim {
        Claim::Plan(claim) => &claim.motion,
        _ => panic!("no plan"),
    }
}

fn changed(certificate: &Certificate, change: impl Fn(&mut PlanClaim)) -> Certificate {
    let mut changed = certificate.clone();
    let Claim::Plan(claim) = &mut changed.claim else { panic!("no plan") };
    change(claim);
    changed
}

/// Limits just above what differences of the attitude show are proved for every instant; just below they are exceeded,
/// by as much as was sampled. So is the set, whose reserve takes the place of a limit.
#[test]
fn exact_motions_are_decided_at_every_instant() {
    let mut model = model();
    // As many samples as the motion has pieces: what is between its nodes is between the spec's.
    model.plan.samples = PIECES;
    let certificate = certificate();
    let (outside, most) = sampled(&model, motion(&certificate));
    assert!(outside < -0.01, "the motion leaves the set: {outside}");
    let with = |change: &dyn Fn(&mut Model)| {
        let mut model = model.clone();
        change(&mut model);
        model
    };
    let limits = |model: &mut Model, more: f64| {
        let limits = &mut model.mission.as_mut().unwrap().limits;
        limits.iter_mut().zip(most).for_each(|(limit, most)| limit.upper = Some(most + more));
    };
    let verdict = decide(&certificate, &with(&|m| limits(m, 0.02))).unwrap();
    assert_eq!(verdict.weaker, Vec::<String>::new(), "{verdict:?}");
    let proved = |s: &&mavc::verify::Shown| s.reach.is_some_and(|r| r.scope == Scope::EveryInstant);
    // Three limits, that thrust points up, and the set.
    assert_eq!(verdict.shown.iter().filter(proved).count(), 5, "{verdict:?}");
    // A little less than what was sampled is false, and found to be: at a node, or between two.
    for index in 0..3 {
        let tighter = with(&|m| {
            limits(m, 0.05);
            let limit = &mut m.mission.as_mut().unwrap().limits[index];
            limit.upper = limit.upper.map(|upper| upper - 0.07);
        });
        match decide(&certificate, &tighter) {
            Err(rejection) => assert!(rejection.claim.starts_with(&format!("limit {}", index + 1)), "{rejection:?}"),
            Ok(verdict) => assert!(verdict.weaker.iter().any(|w| w.contains("exceeded between")), "{verdict:?}"),
        }
    }
    // Half of what the set leaves is kept, a tenth more than all of it is not.
    let share = |reserve: f64| with(&|m| m.plan.reserve = reserve);
    let leaves = |reserve: f64| sampled(&share(reserve), motion(&certificate)).0;
    let edge = (6..100).map(|i| f64::from(i) / 100.0).find(|&r| leaves(r) > 0.0).unwrap();
    assert!(decide(&certificate, &share(edge - 0.02)).unwrap().weaker.is_empty());
    let told = decide(&certificate, &share(edge + 0.05)).unwrap_err();
    assert!(told.claim.starts_with("the set of healthy"), "{told:?}");
}

/// The two models differ by more than the claims leave, and a certificate in one is none in the other.
#[test]
fn models_are_distinguished() {
    let mut model = model();
    let exact = certificate();
    let hover = Certificate { model: DynamicModel::Hover, ..exact.clone() };
    assert_eq!(decide(&hover, &model).unwrap_err().claim, "the model");
    model.plan.model = PlanModel::Hover;
    assert_eq!(decide(&hover, &model).unwrap_err().claim, "the motion");
    model.plan.model = PlanModel::Exact;
    // A vehicle that full thrust hardly lifts does not fly the same motion.
    let mass = model.vehicle.mass;
    let mut accepts = |factor: f64| {
        model.vehicle.mass = mass * factor;
        decide(&exact, &model).is_ok()
    };
    assert!(accepts(1.0) && !accepts(2.9));
}

/// Without thrust there is no attitude: nothing is proved, and nothing is accepted.
#[test]
fn free_fall_is_not_proved() {
    let model = model();
    let falling = changed(&certificate(), |c| {
        c.motion.x.iter_mut().chain(&mut c.motion.y).for_each(|n| n[1..].fill(0.0));
        let Vertical::Exact(z) = &mut c.motion.z[5] else { panic!("exact") };
        z[2] = -G;
    });
    // Whether the pieces join does not matter for this.
    let settings = Settings { premises: Premises::without(Premise::Joints), ..Settings::default() };
    for verdict in [
        decide(&falling, &model),
        mavc::verify::decide(&falling, &model, settings).map_err(|r| match r {
            Refusal::Rejected(rejection) => rejection,
            other => panic!("{other:?}"),
        }),
    ] {
        assert!(verdict.is_err());
    }
}
