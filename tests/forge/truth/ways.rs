//! Whether a claim of ways out is false, by members of its families in plain numbers.

use super::{MISS, MOVES, ROW, TIMES, joins};
use crate::members::{Blend, kept};
use crate::motion::of_record;
use mavc::admissible::AdmissibleSet;
use mavc::certificate::{FamilyRecord, RecoveryClaim, WayRecord};
use mavc::model::{Mission, Model, Recovery, TOUCHDOWN};
use mavc::motion::checks::violation;
use mavc::motion::{NodeState, Trajectory, X, Y, YAW, Z};
use mavc::planner::selection::PlanningSet;
use mavc::planner::selection::sets::of_one_mode;

/// Members looked at along each dimension of a family, and instants of each.
const MEMBERS: usize = 3;
const INSTANTS: usize = 60;

/// Instants of a plan after the return that are looked at are so far apart, s.
const LATER: f64 = 0.02;

/// Whether a claim of ways out by landings, or back to the plan, is false.
pub fn are_false(model: &Model, plan: &Trajectory, claim: &RecoveryClaim) -> bool {
    let mission = model.mission.as_ref().expect("every spec here has a mission");
    let branches: Option<Vec<Trajectory>> = claim.branches.iter().map(|branch| of_record(branch, plan.model)).collect();
    let Some(branches) = branches else { return true };
    !branches.iter().all(joins)
        || !are_in_order(model, &claim.families)
        || claim.families.iter().any(|family| is_false(model, mission, plan, family, &branches))
}

/// Whether families of one mode follow each other in time, and those of the same instants in all delays.
fn are_in_order(model: &Model, families: &[FamilyRecord]) -> bool {
    let [first, last] = model.plan.recovery.detection;
    model.modes.iter().all(|mode| {
        let own: Vec<&FamilyRecord> = families.iter().filter(|family| family.mode == mode.name).collect();
        let groups: Vec<&[&FamilyRecord]> =
            own.chunk_by(|a, b| (a.from_s, a.to_s) == (b.from_s, b.to_s) && a.delays_s[1] == b.delays_s[0]).collect();
        groups.windows(2).all(|two| two[0][0].to_s <= two[1][0].from_s)
            && groups.iter().all(|group| group[0].delays_s[0] == first && group[group.len() - 1].delays_s[1] == last)
    })
}

fn is_false(
    model: &Model,
    mission: &Mission,
    plan: &Trajectory,
    family: &FamilyRecord,
    branches: &[Trajectory],
) -> bool {
    let Some(mode) = model.modes.iter().position(|mode| mode.name == family.mode) else { return true };
    let (way, site) = match &family.way {
        WayRecord::Continue => (Recovery::Continue, None),
        WayRecord::LandAt(name) => {
            let Some(site) = mission.after_fault.sites.iter().find(|site| site.name == *name) else { return true };
            (Recovery::LandAtSites, Some(site))
        }
        WayRecord::LandHere => return true,
    };
    let is_allowed = model.recovery(mode).contains(&way);
    let Some(corners) = family.corners.iter().map(|&corner| branches.get(corner)).collect::<Option<Vec<_>>>() else {
        return true;
    };
    let corners = [corners[0], corners[1], corners[2], corners[3]];
    if !is_allowed || corners[0].duration() > model.plan.recovery.within + TIMES * MISS {
        return true;
    }
    let (set, _) = of_one_mode(model, mode, &AdmissibleSet::healthy(model));
    let shares = (0..MEMBERS).map(|i| i as f64 / (MEMBERS - 1) as f64);
    let members = shares.clone().flat_map(|s| shares.clone().map(move |r| (s, r)));
    members.into_iter().any(|(s, r)| {
        let blend = Blend::new(corners, s, r);
        let [at, delay] = Blend::when(family, s, r);
        let joins = at + delay + blend.duration();
        let (is_wrong, last) = match site {
            Some(site) => (ends_elsewhere(&blend, site.at, site.radius), NodeState::default()),
            None => (leaves_later(model, plan, &set, joins), short_of_the_plan(plan, &blend, joins)),
        };
        is_wrong
            || begins_elsewhere(model, plan, &blend, [at, delay])
            || deviations(model, family).iter().any(|by| breaks(model, mission, plan, &set, &blend, [by, &last]))
    })
}

/// The state of the plan, at rest after its end.
fn planned(plan: &Trajectory, at: f64) -> NodeState {
    match at < plan.duration() {
        true => plan.at(at),
        false => plan.nodes[plan.nodes.len() - 1].map(|axis| [axis[0], 0.0, 0.0, 0.0, 0.0]),
    }
}

/// How far the plan is from the end of a blend.
fn short_of_the_plan(plan: &Trajectory, blend: &Blend, joins: f64) -> NodeState {
    let (there, end) = (planned(plan, joins), blend.at(blend.duration()));
    std::array::from_fn(|axis| std::array::from_fn(|k| there[axis][k] - end[axis][k]))
}

/// Whether the plan is outside the mode's set at some instant after the return.
fn leaves_later(model: &Model, plan: &Trajectory, set: &PlanningSet, joins: f64) -> bool {
    let air = model.environment();
    let rest = plan.duration() - joins;
    let parts = (rest / LATER).ceil().max(0.0) as usize;
    (0..=parts).any(|part| {
        let state = planned(plan, joins + rest.max(0.0) * part as f64 / parts.max(1) as f64);
        let wrench = plan.wrench(&model.vehicle, &air, &state);
        set.rows.iter().any(|row| row.violation(&wrench) > TIMES * ROW)
    })
}

/// Farther from the plan than the largest thrust and the weight can bring a vehicle within the delay.
fn begins_elsewhere(model: &Model, plan: &Trajectory, blend: &Blend, [at, delay]: [f64; 2]) -> bool {
    let full: f64 = model.vehicle.rotors.iter().map(mavc::model::Rotor::max_thrust).sum();
    let (there, first) = (plan.at((at + delay).min(plan.duration())), blend.at(0.0));
    let apart = [X, Y, Z].iter().map(|&axis| (there[axis][0] - first[axis][0]).powi(2)).sum::<f64>().sqrt();
    // Both thrusts over the mass are at most the largest.
    apart > 1.01 * full / model.vehicle.mass * delay * delay
}

fn ends_elsewhere(blend: &Blend, [x, y, z]: [f64; 3], radius: f64) -> bool {
    let end = blend.at(blend.duration());
    let moving = [X, Y, Z, YAW].iter().any(|&axis| end[axis][1].abs() > TIMES * MOVES);
    (end[X][0] - x).hypot(end[Y][0] - y) > radius + TIMES * ROW || end[Z][0] > z + TOUCHDOWN + TIMES * ROW || moving
}

/// Corners of the tolerances, and no deviation.
fn deviations(model: &Model, family: &FamilyRecord) -> Vec<NodeState> {
    let t = &family.tolerance;
    let linear = [t.position_m, t.velocity_m_s, model.gravity * t.tilt_rad, model.gravity * t.turning_rad_s];
    let turned = [t.yaw_rad, t.yaw_rate_rad_s];
    let of = |sign: f64, only: usize| -> NodeState {
        std::array::from_fn(|axis| {
            std::array::from_fn(|k| match (axis == YAW, k < kept(axis)) {
                (_, false) => 0.0,
                (true, true) => sign * turned[k],
                (false, true) => {
                    if axis == only {
                        sign * linear[k]
                    } else {
                        0.0
                    }
                }
            })
        })
    };
    let each = [X, Y, Z].into_iter().flat_map(|axis| [of(1.0, axis), of(-1.0, axis)]);
    std::iter::once(NodeState::default()).chain(each).collect()
}

/// Whether a member with these deviations at its ends leaves the mode's set, or a limit within which it began.
fn breaks(
    model: &Model,
    mission: &Mission,
    plan: &Trajectory,
    set: &PlanningSet,
    blend: &Blend,
    [first, last]: [&NodeState; 2],
) -> bool {
    let air = model.environment();
    let begins = blend.between(first, last, 0.0);
    (0..=INSTANTS).any(|step| {
        let state = blend.between(first, last, blend.duration() * step as f64 / INSTANTS as f64);
        let wrench = plan.wrench(&model.vehicle, &air, &state);
        set.rows.iter().any(|row| row.violation(&wrench) > TIMES * ROW)
            || mission.limits.iter().any(|limit| {
                let past = |state: &NodeState| violation(limit, state, &air);
                past(&state) > past(&begins).max(0.0) + TIMES * ROW * limit.size()
            })
    })
}
