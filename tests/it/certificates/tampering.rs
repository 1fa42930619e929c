//! A thousand motions of certificates changed at random. Whether a change makes a motion no plan is decided in plain
//! `f64` by the planner's rows and wrench maps, at ten times the checker's tolerances, none of which the checker uses;
//! every motion found to be none has to be rejected.

use super::{Numbers, SHA, hop, planned, verify};
use crate::lag::lagging;
use mavc::actuation::Wrench;
use mavc::admissible::row::SetRow;
use mavc::certificate::{Certificate, Claim, DynamicModel, MotionRecord};
use mavc::model::{Allocation, Mission, Model, PlannerKind, Problem};
use mavc::motion::checks::violation;
use mavc::motion::wrench_model::WrenchModel;
use mavc::motion::{NodeState, Trajectory, X, Y, YAW, Z};
use serde_json::{Value, json};

/// Ten times what the checker lets be: of the times, of each derivative at a joint, of a waypoint, of a limit and a
/// set.
const TIME: f64 = 1e-7;
const GAPS: [f64; 4] = [1e-5, 1e-4, 1e-3, 1e-2];
const MISS: f64 = 1e-4;
const EXCESS: f64 = 1e-3;

/// The rows that the plan has to keep, as the planner has them.
struct Asked<'m> {
    model: &'m Model,
    rows: Vec<SetRow>,
}

/// Some reason why the motion is no plan, if one is found.
fn falsehood(certificate: &Certificate, asked: &Asked) -> Option<String> {
    let Claim::Plan(claim) = &certificate.claim else { return Some("no plan".into()) };
    let mission = asked.model.mission.as_ref().unwrap();
    let record = &claim.motion;
    let n = record.times_s.len();
    let lengths = [record.x.len(), record.y.len(), record.z.len(), record.yaw.len()];
    let bent = certificate.model != DynamicModel::Hover || record.z.iter().any(|z| z.derivatives().len() != 3);
    if n < 2 || lengths.iter().any(|&l| l != n) || bent || record.times_s.windows(2).any(|w| w[0] >= w[1]) {
        return Some("no motion".into());
    }
    let trajectory = trajectory(record, mission);
    scheduled(&trajectory, mission, asked.model)
        .or_else(|| flown(&trajectory, mission))
        .or_else(|| bounded(&trajectory, mission, asked))
}

fn trajectory(record: &MotionRecord, mission: &Mission) -> Trajectory {
    let node = |k: usize| {
        let mut state: NodeState = [record.x[k], record.y[k], [0.0; 5], [0.0; 5]];
        state[Z][..3].copy_from_slice(record.z[k].derivatives());
        state[YAW][..3].copy_from_slice(&record.yaw[k]);
        state
    };
    Trajectory {
        times: record.times_s.clone(),
        nodes: (0..record.times_s.len()).map(node).collect(),
        waypoint_nodes: record.waypoint_nodes.clone(),
        model: WrenchModel::HoverAt(mission.waypoints[0].yaw),
    }
}

/// Times, waypoints in order, holds.
fn scheduled(t: &Trajectory, mission: &Mission, model: &Model) -> Option<String> {
    let off = |a: f64, b: f64| (a - b).abs() > TIME;
    let (last, places) = (t.times.len() - 1, &t.waypoint_nodes);
    let in_order = places.windows(2).all(|w| w[0] < w[1]) && places.iter().all(|&p| p <= last);
    if places.len() != mission.waypoints.len() || !in_order || places[0] != 0 || places[places.len() - 1] != last {
        return Some("waypoints out of order".into());
    }
    let mavc::model::MissionTime::Fixed(total) = model.plan.time else { panic!("the time is open") };
    if off(t.times[0], 0.0) || off(t.times[last], total) {
        return Some("other mission time".into());
    }
    let hold = &mission.waypoints[1];
    let leaves = t.times[places[1]] + hold.hold;
    let until = t.times.iter().position(|&s| !off(s, leaves));
    let Some(until) = until else { return Some("no hold".into()) };
    // The legs share what the hold leaves by their lengths.
    let share = mission.legs[0].share / (mission.legs[0].share + mission.legs[1].share);
    if off(t.times[places[1]], share * (total - hold.hold)) {
        return Some("the waypoint has another time".into());
    }
    let highest = [4, 4, 2, 2];
    for (node, held) in [(0, false), (last, false)].into_iter().chain((places[1]..=until).map(|n| (n, true))) {
        for axis in [X, Y, Z, YAW] {
            let orders = if held { highest[axis] } else { [3, 3, 2, 2][axis] };
            if t.nodes[node][axis][1..=orders].iter().any(|&d| d != 0.0) {
                return Some(format!("no rest at node {node}"));
            }
        }
    }
    None
}

/// Joins and waypoints.
fn flown(t: &Trajectory, mission: &Mission) -> Option<String> {
    for k in 0..t.intervals() {
        let end = t.within(k, t.times[k + 1] - t.times[k]);
        for (axis, order) in [(X, 4), (Y, 4), (Z, 2), (YAW, 2)] {
            for (i, (a, b)) in end[axis].iter().zip(&t.nodes[k + 1][axis]).take(order).enumerate() {
                if (a - b).abs() > GAPS[i] {
                    return Some(format!("gap {} after piece {k}", (a - b).abs()));
                }
            }
        }
    }
    for (w, &node) in mission.waypoints.iter().zip(&t.waypoint_nodes) {
        let s = &t.nodes[node];
        let distance = (0..3).map(|i| (s[i][0] - w.position[i]).powi(2)).sum::<f64>().sqrt();
        if distance - w.within > MISS || (s[YAW][0] - w.yaw).abs() - w.yaw_within > MISS {
            return Some(format!("waypoint missed at node {node}"));
        }
    }
    None
}

/// Limits, and the rows on the wrench and on what lagging rotors are commanded, at the nodes.
fn bounded(t: &Trajectory, mission: &Mission, asked: &Asked) -> Option<String> {
    let (model, last) = (asked.model, t.intervals());
    let outside = |w: &Wrench| asked.rows.iter().map(|row| row.violation(w)).fold(f64::NEG_INFINITY, f64::max);
    for node in 0..=last {
        let state = t.within(node.min(last - 1), if node == last { t.times[last] - t.times[last - 1] } else { 0.0 });
        let over = mission.limits.iter().find(|l| violation(l, &state, &model.environment()) > EXCESS * l.size());
        if let Some(limit) = over {
            return Some(format!("{:?} exceeded at node {node}", limit.kind));
        }
        if outside(&t.wrench(&model.vehicle, &model.environment(), &state)) > EXCESS {
            return Some(format!("outside at node {node}"));
        }
        let Some(tau) = model.thrust_lag() else { continue };
        if outside(&t.commanded(&model.vehicle, &model.environment(), tau, node.min(last - 1), &state)) > EXCESS {
            return Some(format!("commands outside at node {node}"));
        }
    }
    None
}

/// 10^-8 to 1, either sign.
fn small(numbers: &mut Numbers) -> f64 {
    10f64.powf(-4.0 + 4.0 * numbers.unit()) * numbers.unit().signum()
}

fn pick<'v>(list: &'v mut Value, numbers: &mut Numbers) -> Option<&'v mut Value> {
    let items = list.as_array_mut()?;
    let at = numbers.below(items.len());
    items.get_mut(at)
}

fn nudge(number: &mut Value, numbers: &mut Numbers) {
    if let Some(x) = number.as_f64() {
        *number = json!(x + small(numbers));
    }
}

/// One change to a certificate.
fn tamper(certificate: &mut Value, numbers: &mut Numbers) -> Option<()> {
    let way = numbers.below(12);
    if way == 0 {
        certificate["model"] = json!("exact");
        return Some(());
    }
    let motion = &mut certificate["claim"]["plan"]["motion"];
    let axis = ["x", "y", "z", "yaw"][numbers.below(4)];
    match way {
        1..=6 => {
            let node = pick(&mut motion[axis], numbers)?;
            nudge(pick(node, numbers)?, numbers);
        }
        7 => nudge(pick(&mut motion["times_s"], numbers)?, numbers),
        8 => {
            let node = pick(&mut motion["waypoint_nodes"], numbers)?;
            *node = json!(node.as_u64()?.saturating_add(numbers.below(3) as u64).saturating_sub(1));
        }
        9 => {
            let items = motion[[axis, "times_s"][numbers.below(2)]].as_array_mut()?;
            let (a, b) = (numbers.below(items.len()), numbers.below(items.len()));
            items.swap(a, b);
        }
        10 => {
            let items = motion[[axis, "times_s", "waypoint_nodes"][numbers.below(3)]].as_array_mut()?;
            items.remove(numbers.below(items.len()));
        }
        _ => {
            // The whole motion a little larger.
            let factor = 1.0 + small(numbers);
            for node in motion[axis].as_array_mut()? {
                let numbers = node.as_array_mut()?;
                numbers.iter_mut().for_each(|x| *x = json!(x.as_f64().unwrap_or(0.0) * factor));
            }
        }
    }
    Some(())
}

/// Changes certificates of plans of each model; how many became false, and how many others were accepted.
fn tampered(models: &[Model], often: usize, seed: u64) -> (usize, usize) {
    let mut numbers = Numbers(seed);
    let (mut false_claims, mut accepted) = (0, 0);
    for (which, model) in models.iter().enumerate() {
        let comparison = planned(model);
        let certificate = mavc::certify::of(Problem::of(model).unwrap(), &comparison, SHA.into());
        let certificate = certificate.unwrap_or_else(|why| panic!("no certificate of model {which}: {why}"));
        let asked = Asked { model, rows: comparison.runs.last().unwrap().set.rows.clone() };
        assert_eq!(falsehood(&certificate, &asked), None);
        let original = serde_json::to_value(&certificate).unwrap();
        let told = |value: &Value| verify(value.to_string().as_bytes(), model, SHA);
        told(&original).unwrap();
        for count in 0..often {
            let mut tampered = original.clone();
            // Sometimes several at once: one false claim is enough.
            for _ in 0..=numbers.below(2) {
                let _ = tamper(&mut tampered, &mut numbers);
            }
            let why = match serde_json::from_value::<Certificate>(tampered.clone()) {
                Ok(read) => falsehood(&read, &asked),
                Err(unreadable) => Some(unreadable.to_string()),
            };
            let verdict = told(&tampered);
            if let Some(why) = why {
                false_claims += 1;
                assert!(verdict.is_err(), "model {which}, {count}: accepted, though {why}");
            } else {
                accepted += usize::from(verdict.is_ok());
            }
        }
    }
    (false_claims, accepted)
}

#[test]
fn no_false_claim_passes() {
    let plans = [(PlannerKind::Rip, 7.2), (PlannerKind::Rcp, 7.6), (PlannerKind::Rsp, 8.0), (PlannerKind::Rcp, 12.0)];
    let (false_claims, accepted) = tampered(&plans.map(|(planner, time)| hop(planner, time)), 250, 9);
    assert!(false_claims > 500, "only {false_claims} of 1000 changes made a claim false");
    assert!(accepted > 20, "only {accepted} harmless changes pass: the checker may reject everything");
}

/// The same of rotors that may not stop, of the pseudo-inverse, and of vehicles known to within intervals.
#[test]
#[ignore = "long"]
fn no_false_claim_passes_of_other_vehicles() {
    let mut idling = hop(PlannerKind::Rcp, 9.0);
    idling.vehicle.rotors.iter_mut().for_each(|r| r.min_speed = 150.0);
    let mut inverted = hop(PlannerKind::Rcp, 9.0);
    inverted.vehicle.allocation = Allocation::PseudoInverse;
    let mut uncertain = hop(PlannerKind::Rcp, 9.0);
    super::sets::doubt(&mut uncertain);
    let (false_claims, accepted) = tampered(&[idling, inverted, uncertain], 150, 13);
    assert!(false_claims > 220, "only {false_claims} of 450 changes made a claim false");
    assert!(accepted > 10, "only {accepted} harmless changes pass: the checker may reject everything");
}

/// The same of rotors that lag, and of what they are commanded.
#[test]
#[ignore = "long"]
fn no_false_claim_passes_of_lagging_rotors() {
    let plans = [(PlannerKind::Rip, 8.0), (PlannerKind::Rcp, 9.0), (PlannerKind::Rsp, 9.0)];
    let models = plans.map(|(planner, time)| lagging(hop(planner, time), 0.1));
    let (false_claims, accepted) = tampered(&models, 150, 17);
    assert!(false_claims > 220, "only {false_claims} of 450 changes made a claim false");
    assert!(accepted > 10, "only {accepted} harmless changes pass: the checker may reject everything");
}
