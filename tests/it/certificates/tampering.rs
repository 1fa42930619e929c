//! A thousand certificates changed at random. Whether a change makes a claim false is decided in plain `f64` by the
//! planner's sets and wrench maps, none of which the checker uses; every certificate found false has to be rejected.

use super::{Numbers, SHA, certified, hop, verify};
use crate::lag::lagging;
use mavc::actuation::Wrench;
use mavc::admissible::{AdmissibleSet, FacetOf, faults_only_take};
use mavc::certificate::{Bound, Certificate, Claim, DynamicModel, FacetClaim, FacetRecord, PlanClaim, Scope, SetClaim};
use mavc::geometry::polytope::Facet;
use mavc::model::{Allocation, LimitKind, Mission, Model, PlannerKind};
use mavc::planner::hover_model::{WrenchMap, X, Y, YAW, Z};
use mavc::planner::transcribe::NodeState;
use mavc::planner::wrench_model::WrenchModel;
use mavc::trajectory::Trajectory;
use mavc::trajectory::checks::past;
use serde_json::{Value, json};

/// What is off by no more than this is not told apart from rounding.
const CLEAR: f64 = 2e-9;

/// Some reason why a claim is false, if one is found.
fn falsehood(certificate: &Certificate, model: &Model) -> Option<String> {
    let Claim::Plan(claim) = &certificate.claim else { return Some("no plan".into()) };
    let mission = model.mission.as_ref().unwrap();
    let record = &claim.motion;
    let n = record.times_s.len();
    let lengths = [record.x.len(), record.y.len(), record.z.len(), record.yaw.len()];
    let bent = certificate.model != DynamicModel::Hover || record.z.iter().any(|z| z.len() != 3);
    if lengths.iter().any(|&l| l != n) || bent || record.times_s.windows(2).any(|w| w[0] >= w[1]) {
        return Some("no motion".into());
    }
    let nodes: Vec<NodeState> = (0..n)
        .map(|k| {
            let mut state = [record.x[k], record.y[k], [0.0; 5], [0.0; 5]];
            state[Z][..3].copy_from_slice(&record.z[k]);
            state[YAW][..3].copy_from_slice(&record.yaw[k]);
            state
        })
        .collect();
    let trajectory = Trajectory {
        times: record.times_s.clone(),
        nodes,
        waypoint_nodes: record.waypoint_nodes.clone(),
        model: WrenchModel::HoverAt(mission.waypoints[0].yaw),
    };
    scheduled(&trajectory, mission, model)
        .or_else(|| flown(&trajectory, mission, claim))
        .or_else(|| limited(&trajectory, mission, claim, model.gravity))
        .or_else(|| inside(&trajectory, claim, model))
}

/// Times, waypoints in order, holds.
fn scheduled(t: &Trajectory, mission: &Mission, model: &Model) -> Option<String> {
    let off = |a: f64, b: f64| (a - b).abs() > 1e-7;
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
fn flown(t: &Trajectory, mission: &Mission, claim: &PlanClaim) -> Option<String> {
    for k in 0..t.intervals() {
        let h = t.times[k + 1] - t.times[k];
        let end = t.within(k, h);
        for (axis, order) in [(X, 4), (Y, 4), (Z, 2), (YAW, 2)] {
            for (i, (a, b)) in end[axis].iter().zip(&t.nodes[k + 1][axis]).take(order).enumerate() {
                let gap = (a - b).abs() * h.powi(i as i32);
                if gap > claim.joins_within + CLEAR {
                    return Some(format!("gap {gap} after piece {k}"));
                }
            }
        }
    }
    for (w, &node) in mission.waypoints.iter().zip(&t.waypoint_nodes) {
        let s = &t.nodes[node];
        let distance = (0..3).map(|i| (s[i][0] - w.position[i]).powi(2)).sum::<f64>().sqrt();
        let turned = (s[YAW][0] - w.yaw).abs();
        if distance - w.within > claim.position_excess_m + CLEAR || turned - w.yaw_within > claim.yaw_excess_rad + CLEAR
        {
            return Some(format!("waypoint missed at node {node}"));
        }
    }
    None
}

/// Whether a quantity is seen above some bound.
fn passes(t: &Trajectory, bounds: &[Bound], quantity: impl Fn(usize, &NodeState) -> f64) -> Option<String> {
    for bound in bounds {
        let looks = match bound.scope {
            Scope::Nodes => 1,
            Scope::Grid(points) => points + 1,
            Scope::EveryInstant => 24,
        };
        for k in 0..t.intervals() {
            let h = t.times[k + 1] - t.times[k];
            let mut states: Vec<NodeState> = (0..looks).map(|i| t.within(k, h * i as f64 / looks as f64)).collect();
            states.push(t.nodes[k + 1]);
            let largest = states.iter().map(|s| quantity(k, s)).fold(f64::NEG_INFINITY, f64::max);
            if largest > bound.excess + CLEAR {
                return Some(format!("{largest} over {bound:?} on piece {k}"));
            }
        }
    }
    None
}

fn limited(t: &Trajectory, mission: &Mission, claim: &PlanClaim, g: f64) -> Option<String> {
    if claim.limits.len() != mission.limits.len() {
        return Some("limits missing".into());
    }
    mission.limits.iter().zip(&claim.limits).find_map(|(limit, told)| {
        let words = match limit.kind {
            LimitKind::Speed => "speed",
            LimitKind::Tilt => "tilt",
            LimitKind::Climb => "climb",
            LimitKind::Z => "altitude",
            other => panic!("{other:?}"),
        };
        if told.limit != words || told.lower != limit.lower || told.upper != limit.upper {
            return Some("another limit".into());
        }
        if told.bounds.is_empty() {
            return Some("nothing is claimed".into());
        }
        passes(t, &told.bounds, |_, s| match limit.kind {
            LimitKind::Tilt => {
                // |a| sin(tilt - L) / g
                let lift = s[Z][2] + g;
                let size = (s[X][2].powi(2) + s[Y][2].powi(2) + lift * lift).sqrt();
                size * (s[X][2].hypot(s[Y][2]).atan2(lift) - limit.upper.unwrap()).sin() / g
            }
            _ => past(limit, s, g),
        })
    })
}

/// As planned against: for every value of the spec's intervals.
fn set_named(model: &Model, name: &str) -> Option<AdmissibleSet> {
    let set = match name {
        "healthy" => AdmissibleSet::healthy(model),
        _ => AdmissibleSet::of_mode(model, model.modes.iter().position(|m| m.name == name)?),
    };
    Some(set.guaranteed(model))
}

/// Whether a printed facet is none of its set's.
fn no_facet(set: &AdmissibleSet, facet: &FacetRecord) -> bool {
    let n = Wrench::from(facet.normal);
    let same = |f: &Facet<4, FacetOf>| (f.normal - n).amax() < 1e-6 && (f.offset - facet.offset).abs() < 1e-6;
    if set.allocation == Allocation::PseudoInverse {
        let at_bound = |f: &Facet<4, FacetOf>| f.origin.spanning.generators().all(|k| [k + 1] != facet.rotors[..]);
        return !set.polytope.facets.iter().any(|f| same(f) && at_bound(f));
    }
    let &[a, b, c] = &facet.rotors[..] else { return true };
    a == b || b == c || a == c || !set.polytope.facets.iter().any(same)
}

fn inside(t: &Trajectory, claim: &PlanClaim, model: &Model) -> Option<String> {
    let healthy = AdmissibleSet::healthy(model);
    let WrenchModel::HoverAt(psi) = t.model else { panic!("one yaw") };
    let map = WrenchMap::with_free_yaw(&model.vehicle, model.gravity, psi);
    let faults = model.plan.against.iter().map(|&i| model.modes[i].name.as_str());
    let needed: Vec<&str> = match model.plan.planner {
        PlannerKind::Rcp if faults_only_take(model) => faults.collect(),
        PlannerKind::Rcp => faults.chain(["healthy"]).collect(),
        _ => vec!["healthy"],
    };
    let lag = model.thrust_lag();
    let told = |s: &SetClaim| !s.bounds.is_empty() && (lag.is_none() || !s.commands.is_empty());
    if needed.iter().any(|name| !claim.sets.iter().any(|s| s.mode == *name && told(s))) {
        return Some("a set is missing".into());
    }
    let commanded = |k: usize, s: &NodeState| t.lead(&model.vehicle, model.gravity, lag.unwrap_or(0.0), k, s);
    let shrunk = |w: &Wrench, n: &Wrench, e: f64| {
        let hover = n.dot(&healthy.hover);
        (n.dot(w) - hover - (1.0 - model.plan.reserve) * (e - hover)) / healthy.zonotope.width(n)
    };
    let sets = claim.sets.iter().find_map(|told| {
        let Some(set) = set_named(model, &told.mode) else { return Some("no such mode".into()) };
        let largest = |w: &Wrench| {
            set.polytope.facets.iter().map(|f| shrunk(w, &f.normal, f.offset)).fold(f64::NEG_INFINITY, f64::max)
        };
        passes(t, &told.bounds, |_, s| largest(&map.at(s)))
            .or_else(|| passes(t, &told.commands, |k, s| largest(&commanded(k, s))))
    });
    sets.or_else(|| {
        claim.facets.iter().find_map(|FacetClaim { facet, bounds, commands }| {
            let Some(set) = set_named(model, &facet.mode) else { return Some("no such mode".into()) };
            let n = Wrench::from(facet.normal);
            let certain = model.vehicle.allocation == Allocation::Bounded && !model.vehicle.is_uncertain();
            let spans = !certain
                || facet.rotors.iter().all(|&k| {
                    let g = set.zonotope.generators.get(k.wrapping_sub(1));
                    g.is_some_and(|g| g.norm() > 0.0 && n.dot(g).abs() <= 1e-6 * g.norm())
                });
            if !spans || no_facet(&set, facet) || bounds.is_empty() {
                return Some(format!("not a facet: {facet:?}"));
            }
            passes(t, bounds, |_, s| shrunk(&map.at(s), &n, facet.offset))
                .or_else(|| passes(t, commands, |k, s| shrunk(&commanded(k, s), &n, facet.offset)))
        })
    })
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

fn drop_one(list: &mut Value, numbers: &mut Numbers) {
    if let Some(items) = list.as_array_mut().filter(|items| !items.is_empty()) {
        items.remove(numbers.below(items.len()));
    }
}

/// The bounds of some claim.
fn some_bound<'v>(plan: &'v mut Value, numbers: &mut Numbers) -> Option<&'v mut Value> {
    let kind = ["limits", "sets", "facets"][numbers.below(3)];
    let claim = pick(&mut plan[kind], numbers)?;
    pick(told(claim, numbers), numbers)
}

/// Bounds on the wrench or, where there are, on commands.
fn told<'v>(claim: &'v mut Value, numbers: &mut Numbers) -> &'v mut Value {
    let commands = claim.get("commands").is_some() && numbers.below(2) == 0;
    &mut claim[if commands { "commands" } else { "bounds" }]
}

/// One change to a certificate.
fn tamper(certificate: &mut Value, numbers: &mut Numbers) -> Option<()> {
    let way = numbers.below(16);
    if way == 0 {
        certificate["model"] = json!("exact");
        return Some(());
    }
    let plan = &mut certificate["claim"]["plan"];
    match way {
        1..=3 => {
            let axis = ["x", "y", "z", "yaw"][numbers.below(4)];
            let node = pick(&mut plan["motion"][axis], numbers)?;
            nudge(pick(node, numbers)?, numbers);
        }
        4 => nudge(pick(&mut plan["motion"]["times_s"], numbers)?, numbers),
        5 => {
            let node = pick(&mut plan["motion"]["waypoint_nodes"], numbers)?;
            *node = json!(node.as_u64()?.saturating_add(numbers.below(3) as u64).saturating_sub(1));
        }
        6 | 7 => {
            let bound = some_bound(plan, numbers)?;
            bound["excess"] = json!(bound["excess"].as_f64()? - small(numbers).abs());
        }
        8 => some_bound(plan, numbers)?["scope"] = json!("every_instant"),
        9 => {
            let facet = &mut pick(&mut plan["facets"], numbers)?["facet"];
            match numbers.below(4) {
                0 => *pick(&mut facet["rotors"], numbers)? = json!(numbers.below(10)),
                1 => nudge(pick(&mut facet["normal"], numbers)?, numbers),
                2 => nudge(&mut facet["offset"], numbers),
                _ => facet["normal"].as_array_mut()?.iter_mut().for_each(|n| *n = json!(-n.as_f64().unwrap_or(0.0))),
            }
        }
        10 => drop_one(&mut plan[["limits", "sets", "facets"][numbers.below(3)]], numbers),
        11 => {
            let mode = json!(format!("M{}", numbers.below(10)));
            if numbers.below(2) == 0 {
                pick(&mut plan["sets"], numbers)?["mode"] = mode;
            } else {
                pick(&mut plan["facets"], numbers)?["facet"]["mode"] = mode;
            }
        }
        12 => {
            let side = ["lower", "upper"][numbers.below(2)];
            nudge(&mut pick(&mut plan["limits"], numbers)?[side], numbers);
        }
        13 => {
            let name = ["joins_within", "position_excess_m", "yaw_excess_rad"][numbers.below(3)];
            plan[name] = json!(plan[name].as_f64()? - small(numbers).abs());
        }
        14 => {
            let axis = ["x", "y", "z", "yaw", "times_s"][numbers.below(5)];
            let items = plan["motion"][axis].as_array_mut()?;
            let (a, b) = (numbers.below(items.len()), numbers.below(items.len()));
            items.swap(a, b);
        }
        _ => {
            let claim = pick(&mut plan[["limits", "sets", "facets"][numbers.below(3)]], numbers)?;
            drop_one(told(claim, numbers), numbers);
        }
    }
    Some(())
}

/// Changes certificates of plans of each model; how many became false, and how many others passed.
fn tampered(models: &[Model], often: usize, seed: u64) -> (usize, usize) {
    let mut numbers = Numbers(seed);
    let (mut false_claims, mut accepted) = (0, 0);
    for (which, model) in models.iter().enumerate() {
        let certificate = certified(model).unwrap_or_else(|| panic!("no certificate of model {which}"));
        assert_eq!(falsehood(&certificate, model), None);
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
                Ok(read) => falsehood(&read, model),
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
    assert!(false_claims > 600, "only {false_claims} of 1000 changes made a claim false");
    assert!(accepted > 20, "only {accepted} harmless changes pass: the checker may reject everything");
}

/// The same of rotors that may not stop, of the pseudo-inverse, and of vehicles known to within intervals.
#[test]
#[ignore = "seconds long: cargo test -- --include-ignored"]
fn no_false_claim_passes_of_other_vehicles() {
    let mut idling = hop(PlannerKind::Rcp, 9.0);
    idling.vehicle.rotors.iter_mut().for_each(|r| r.min_speed = 150.0);
    let mut inverted = hop(PlannerKind::Rcp, 9.0);
    inverted.vehicle.allocation = Allocation::PseudoInverse;
    let mut uncertain = hop(PlannerKind::Rcp, 9.0);
    super::sets::doubt(&mut uncertain);
    let (false_claims, accepted) = tampered(&[idling, inverted, uncertain], 150, 13);
    assert!(false_claims > 270, "only {false_claims} of 450 changes made a claim false");
    assert!(accepted > 10, "only {accepted} harmless changes pass: the checker may reject everything");
}

/// The same of rotors that lag, and of what they are commanded.
#[test]
#[ignore = "seconds long: cargo test -- --include-ignored"]
fn no_false_claim_passes_of_lagging_rotors() {
    let plans = [(PlannerKind::Rip, 8.0), (PlannerKind::Rcp, 9.0), (PlannerKind::Rsp, 9.0)];
    let models = plans.map(|(planner, time)| lagging(hop(planner, time), 0.1));
    let (false_claims, accepted) = tampered(&models, 150, 17);
    assert!(false_claims > 270, "only {false_claims} of 450 changes made a claim false");
    assert!(accepted > 10, "only {accepted} harmless changes pass: the checker may reject everything");
}
