//! Planning again until faults have ways out: the plan keeps more room inside the sets of the modes than the spec asks
//! of it, and below the limits on speeds that hold after a fault too. So a vehicle that has strayed from it, when a
//! fault becomes known, can come back within both.

use super::{Recovery, Way, recovery};
use crate::certify;
use crate::model::{HeldLimit, Limit, Mission, MissionTime, Model, PlannerKind, Problem};
use crate::planner::studies::{Comparison, MissionPlan, PlanOutcome, Scope, adopted, run_planners};

/// Shares of the sets kept in addition to the reserve, in the order tried. Chosen by hand.
const ROOMS: [f64; 4] = [0.05, 0.1, 0.2, 0.4];
/// A plan stays below the limits on speeds that hold after a fault by this many times the share of the sets. Chosen by
/// hand.
const BELOW_LIMITS: f64 = 0.5;
/// Where the spec leaves the time open: multiples of the time of the first plan, and the share kept with them in
/// addition to the reserve. Chosen by hand.
const LONGER: [f64; 4] = [1.05, 1.1, 1.2, 1.4];
const WITH_TIME: f64 = 0.1;
/// The search ends after so many rooms in turn that leave no smaller share without a way out. Chosen by hand.
const PATIENCE: usize = 3;
/// Shares of plans of other durations differ by rounding.
const ROUNDING: f64 = 1e-9;
/// No reserve reaches this.
const MOST: f64 = 0.95;

/// A plan with ways out in place of one without.
pub struct Replanned {
    /// The comparison with the plan as the outcome of its last run.
    pub comparison: Comparison,
    pub recovery: Recovery,
}

/// How a plan with ways out differs from the one planned first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// The share of each set that the plan keeps: the spec's reserve and more.
    pub reserve: f64,
    /// The mission time of the first plan, s.
    pub time_before: f64,
    /// The share of the time without a way out of the first plan.
    pub uncovered_before: f64,
}

/// A plan in more time than a spec fixes, which leaves less without a way out: the nearest miss.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Longer {
    /// The mission time, s.
    pub time: f64,
    /// The share of the time without a way out.
    pub uncovered: f64,
}

/// What planning again gives.
#[derive(Default)]
pub struct ReplanningOutcome {
    /// The plan that leaves the smallest share without a way out, if it is smaller than that of the first plan.
    pub replanned: Option<Replanned>,
    /// If the spec fixes the time and too much is left without a way out: the shortest of the longer times tried that
    /// leaves little enough, or else the one that leaves least, if that is less.
    pub longer: Option<Longer>,
}

/// Plans again with more and more room, and then in more and more time, until at most a share `bound` of the time has
/// no way out, as `uncovered` measures it, or as little as the modes leave in which none is sought. A plan in more time
/// is taken only if the spec leaves the time open. `tries` receives each reserve, and the time where it is given, s,
/// before they are tried.
pub fn replanned(
    problem: Problem,
    first: &Comparison,
    found: &Recovery,
    uncovered: &dyn Fn(&Recovery) -> f64,
    bound: f64,
    tries: &dyn Fn(f64, Option<f64>),
) -> ReplanningOutcome {
    let Some(before) = first.runs.last().and_then(|run| run.outcome.plan()) else {
        return ReplanningOutcome::default();
    };
    let uncovered_before = uncovered(found);
    let bound = bound.max(uncovered(&all_covered(found)) + ROUNDING);
    let mut best = Best { share: uncovered_before, replanned: None };
    let attempt = |reserve: f64, time: Option<f64>, best: &mut Best| {
        tries(reserve, time);
        let plan = with_reserve(problem, found, reserve, time)?;
        let mut comparison = adopted(problem, first, &plan)?;
        certify::check(problem, &mut comparison);
        let kept = comparison.runs.last()?.outcome.plan()?;
        let mut recovery = recovery(problem, &kept.trajectory, false);
        let share = uncovered(&recovery);
        recovery.change = Some(Change { reserve, time_before: before.time, uncovered_before });
        let is_better = share < best.share;
        if is_better {
            *best = Best { share, replanned: Some(Replanned { comparison, recovery }) };
        }
        Some(is_better)
    };
    let reserves = ROOMS.into_iter().map(|room| problem.model().plan.reserve + room).filter(|reserve| *reserve < MOST);
    let mut in_vain = 0;
    for reserve in reserves {
        match attempt(reserve, None, &mut best) {
            Some(true) => in_vain = 0,
            Some(false) => in_vain += 1,
            None => break,
        }
        if best.share <= bound || in_vain == PATIENCE {
            break;
        }
    }
    let is_open = problem.model().plan.time == MissionTime::Minimum;
    let reserve = (problem.model().plan.reserve + WITH_TIME).min(MOST);
    let mut longer: Option<Longer> = None;
    for time in LONGER.map(|factor| factor * before.time) {
        let least = longer.map_or(best.share, |longer| longer.uncovered);
        if least <= bound {
            break;
        }
        if is_open {
            attempt(reserve, Some(time), &mut best);
        } else {
            tries(reserve, Some(time));
            let share = in_another_time(problem, found, reserve, time).map(|found| uncovered(&found));
            longer = share.filter(|share| *share < least).map(|uncovered| Longer { time, uncovered }).or(longer);
        }
    }
    ReplanningOutcome { longer, replanned: best.replanned }
}

/// What was found, with ways out wherever they are sought: no plan leaves less without one.
fn all_covered(found: &Recovery) -> Recovery {
    let mut covered = found.clone();
    let sought = covered.modes.iter_mut().filter(|mode| mode.not_attempted.is_none());
    sought.flat_map(|mode| &mut mode.pieces).for_each(|piece| piece.way = Some(Way::LandHere));
    covered
}

/// The ways out along a plan in another time than the spec's, s, which is a plan of another spec; `None` if none is
/// found.
fn in_another_time(problem: Problem, found: &Recovery, reserve: f64, time: f64) -> Option<Recovery> {
    let plan = with_reserve(problem, found, reserve, Some(time))?;
    let other = in_time(problem.model().clone(), time);
    Some(recovery(Problem::of(&other)?, &plan.trajectory, false))
}

/// A model with the mission time `time`, s.
fn in_time(mut model: Model, time: f64) -> Model {
    model.plan.time = MissionTime::Fixed(time);
    model
}

/// The plan so far with the smallest share of the time without a way out.
struct Best {
    share: f64,
    replanned: Option<Replanned>,
}

/// Lowers the limits of a mission on speeds to a share below those that hold after a fault; whether any became lower.
fn slow_down(mission: &mut Mission, share: f64) -> bool {
    let mut is_lower = false;
    for HeldLimit { limit: held, .. } in mission.limits_after_fault() {
        let Some(upper) = held.upper.filter(|_| held.kind.is_speed()).map(|upper| (1.0 - share) * upper) else {
            continue;
        };
        match mission.limits.iter_mut().find(|own| own.kind == held.kind && own.is_general()) {
            Some(own) if own.upper.is_some_and(|own| own <= upper) => continue,
            Some(own) => own.upper = Some(upper),
            None => mission.limits.push(Limit { lower: None, upper: Some(upper), ..held }),
        }
        is_lower = true;
    }
    is_lower
}

/// The plan of RCP with a larger reserve and below the limits on speeds, against the modes of the spec and those with
/// gaps; where there is none, one that may reach these limits, and at last one against those of the spec. `time` is the
/// mission time, s, if it is not the spec's.
fn with_reserve(problem: Problem, found: &Recovery, reserve: f64, time: Option<f64>) -> Option<MissionPlan> {
    let own = &problem.model().plan.against;
    let has_gap = |mode: usize| {
        let of_mode = found.modes.iter().find(|found| found.mode == mode);
        of_mode.is_some_and(|of_mode| of_mode.not_attempted.is_none() && of_mode.uncovered() > 0.0)
    };
    let gaps: Vec<usize> = (0..problem.model().modes.len()).filter(|&mode| has_gap(mode)).collect();
    let more: Vec<usize> = own.iter().copied().chain(gaps.iter().copied().filter(|mode| !own.contains(mode))).collect();
    let share = BELOW_LIMITS * (reserve - problem.model().plan.reserve);
    let with = |against: &[usize], is_slower: bool| {
        let own = problem.model().clone();
        let mut model = match time {
            Some(time) => in_time(own, time),
            None => own,
        };
        model.plan.planner = PlannerKind::Rcp;
        model.plan.reserve = reserve;
        model.plan.against = against.to_vec();
        if is_slower && !slow_down(model.mission.as_mut()?, share) {
            return None;
        }
        let variant = Problem::of(&model)?;
        let mut comparison = run_planners(variant, Scope::Plan, None);
        certify::check(variant, &mut comparison);
        match comparison.runs.pop()?.outcome {
            PlanOutcome::Planned(plan) => Some(*plan),
            _ => None,
        }
    };
    let first = with(&more, true).or_else(|| with(&more, false));
    first.or_else(|| (more.len() > own.len()).then(|| with(own, false)).flatten())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Limits on speeds that hold after a fault too are lowered; those that a looser one replaces then are not, and no
    /// other limit is.
    #[test]
    fn only_limits_on_speeds_that_hold_after_a_fault_are_lowered() {
        let upper = |after_fault: &str| -> Vec<(String, f64)> {
            let text = format!(
                "vehicle v {{ layout = \"PNPNPN\"; arm = 0.4 m; mass = 3 kg; inertia = [0.05, 0.06, 0.1] kg*m^2
                    rotor {{ max_thrust = 9 N; torque_per_thrust = 15 mm; max_speed = 900 rad/s }} }}
                mission m {{ start at [0, 0, 2] m; waypoint at [9, 0, 4] m
                    limits {{ speed <= 8 m/s; tilt <= 25 deg; altitude <= 9 m }}; {after_fault} }}"
            );
            let spec = crate::compile(&text).into_result().unwrap();
            let mut mission = spec.model().mission.clone().unwrap();
            assert_eq!(slow_down(&mut mission, 0.25), !after_fault.contains("40"));
            mission.limits.iter().map(|limit| (format!("{:?}", limit.kind), limit.upper.unwrap())).collect()
        };
        let [speed, others @ ..] = &upper("")[..] else { panic!() };
        assert_eq!((speed, others.len()), (&("Speed".to_string(), 6.0), 2));
        assert_eq!(others, &upper("after_fault_limits { speed <= 40 m/s }")[1..]);
        assert_eq!(upper("after_fault_limits { speed <= 40 m/s }")[0].1, 8.0);
        assert_eq!(upper("after_fault_limits { speed <= 4 m/s }")[0].1, 3.0);
    }
}
