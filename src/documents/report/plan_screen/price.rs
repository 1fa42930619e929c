//! What covering the fault modes costs, as far as the run of one planner shows it without further planning.

use super::{Answer, DIGITS, coverage};
use crate::admissible::without_yaw::planned::Provision;
use crate::model::PlannerKind;
use crate::motion::Trajectory;
use crate::motion::time_grid::determined;
use crate::number::{fixed, percent, significant};
use crate::planner::studies::{MissionPlan, PlannerRun, Run};
use crate::planner::timing::kinematics::least_time_within;
use crate::report::{battery, least_time};

/// A lower bound on the time says something of the price if the plan takes at most this share longer. Chosen by hand.
const MOST_OVER: f64 = 0.5;
/// A difference of energies below this share is called none: rounding to three digits hides it.
const SAME_ENERGY: f64 = 5e-4;

/// `at most 0.89 s (0.912 %) over the fastest motion ignoring faults`; `None` if the plan covers no mode or is not
/// made to.
pub fn of_plan(answer: &Answer, run: &PlannerRun, solved: &MissionPlan) -> Option<String> {
    let comparison = answer.comparison;
    let model = answer.problem.model();
    let covers =
        |i: usize| comparison.provisions[i] != Provision::Capture && coverage::unsafe_until(model, solved, i).is_none();
    if run.planner == PlannerKind::Rip || !(0..comparison.modes.len()).any(covers) {
        return None;
    }
    let seconds = |time: f64| format!("{} s", significant(time, DIGITS + 1));
    if let Some(without) = comparison.trade_off.first() {
        let risk = significant(without.risk, DIGITS);
        return Some(match solved.time > without.time {
            true => format!(
                "{} ({}) over the plan without protection, whose risk is {risk}",
                seconds(solved.time - without.time),
                percent(solved.time / without.time - 1.0)
            ),
            false => format!("no time: without protection the risk is {risk} in the same {}", seconds(solved.time)),
        });
    }
    let is_fixed = run.run == Run::Common || determined(answer.problem.mission()).is_some();
    let ignoring = comparison.ignoring.as_ref().and_then(|run| run.outcome.plan());
    match (is_fixed, run.planner, ignoring) {
        (true, PlannerKind::Rsp, Some(_)) if comparison.selected.is_empty() => {
            Some("nothing: the plan that ignores faults is the same".into())
        }
        (true, PlannerKind::Rsp, Some(rip)) => Some(format!(
            "no time: ignoring faults also takes {}{}{}",
            seconds(solved.time),
            last_violation(rip),
            more_energy(answer, &rip.trajectory, solved)
        )),
        (true, ..) => {
            Some(format!("no time at {}; `mavc compare` finds it at the shortest times", seconds(solved.time)))
        }
        (false, ..) => {
            // The bound is about the limits alone, so it holds for every motion that ignores faults.
            let least = least_time_within(answer.problem);
            let is_near = solved.time <= (1.0 + MOST_OVER) * least.seconds && !least.is_above(solved.time);
            match is_near {
                true => {
                    // As the headline shows it, so that a reader may subtract.
                    let bound = least_time::shown(least.seconds);
                    Some(format!(
                        "at most {} ({}) over the fastest motion ignoring faults",
                        seconds(solved.time - bound),
                        percent(solved.time / bound - 1.0)
                    ))
                }
                false => Some("not known from this planner alone; `mavc compare` finds it".into()),
            }
        }
    }
}

/// `, unsafe until 18.90 s`: the last violation of a plan that ignores faults, over all modes.
fn last_violation(rip: &MissionPlan) -> String {
    let last = rip.outside.iter().filter_map(|outside| outside.last).reduce(f64::max);
    last.map_or(String::new(), |last| format!(", unsafe until {} s", fixed(last, 2)))
}

/// `; covering uses 0.4 % more energy`: what a plan takes from the battery beyond one that ignores faults.
fn more_energy(answer: &Answer, rip: &Trajectory, solved: &MissionPlan) -> String {
    let energy = |trajectory: &Trajectory| Some(battery::record(answer.problem.model(), trajectory)?.energy_j);
    let Some((ignoring, covering)) = energy(rip).zip(energy(&solved.trajectory)) else { return String::new() };
    let more = covering / ignoring - 1.0;
    match more.abs() < SAME_ENERGY {
        true => String::new(),
        false => format!("; covering uses {} {} energy", percent(more.abs()), if more > 0.0 { "more" } else { "less" }),
    }
}
