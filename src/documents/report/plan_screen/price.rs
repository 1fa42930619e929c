//! What covering the fault modes costs, as far as the run of one planner shows it without further planning.

use super::{Answer, DIGITS, coverage};
use crate::admissible::without_yaw::planned::Provision;
use crate::model::PlannerKind;
use crate::motion::time_grid::determined;
use crate::number::{percent, significant};
use crate::planner::studies::{MissionPlan, PlannerRun, Run};
use crate::planner::timing::kinematics::least_time_within;
use crate::report::{battery, least_time};
use serde::Serialize;

/// A lower bound on the time says something of the price if the plan takes at most this share longer. Chosen by hand.
const MOST_OVER: f64 = 0.5;
/// A difference of energies below this share is called none: rounding to three digits hides it.
const SAME_ENERGY: f64 = 5e-4;

/// What a plan is compared with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Baseline {
    /// The plan that ignores faults, by which RSP selects its constraints; it takes the same time.
    IgnoringFaults,
    /// The lower bound on the time of all motions within limits and thrust, whether they cover faults or not.
    LeastTime,
    /// With `require risk`: the plan without protection.
    Unprotected,
    /// Nothing: the plan itself ignores faults.
    Itself,
    /// Nothing: this run made no plan that ignores faults; `mavc compare` makes one.
    None,
}

/// What covering the fault modes costs.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PriceRecord {
    /// What the plan is compared with.
    pub baseline: Baseline,
    /// The mission time of the baseline, s; null without one.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub baseline_time_s: Option<f64>,
    /// The time that the plan takes beyond the baseline, s; an upper bound of the price if the baseline is
    /// `least_time`; null without one.
    pub more_time_s: Option<f64>,
    /// The last violation of a plan that ignores faults over all modes, s; null if it has none, and with other
    /// baselines.
    #[cfg_attr(test, schemars(range(min = 0)))]
    pub baseline_unsafe_until_s: Option<f64>,
    /// The risk of the plan without protection; null with other baselines.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub baseline_risk: Option<f64>,
    /// The energy that the plan takes beyond a plan that ignores faults, J, negative if it takes less; null without
    /// a battery, and with other baselines.
    pub more_energy_j: Option<f64>,
    /// Whether the plan is unsafe after a mode that it is planned against, so that the price does not buy cover of
    /// all.
    pub still_unsafe: bool,
    /// The price, as on the terminal and the page.
    #[cfg_attr(test, schemars(length(min = 1)))]
    pub sentence: String,
}

impl PriceRecord {
    /// `None` if no mode is planned against.
    pub fn of_plan(answer: &Answer, run: &PlannerRun, solved: &MissionPlan) -> Option<Self> {
        let comparison = answer.comparison;
        let is_planned = |i: &usize| comparison.provisions[*i] != Provision::Capture;
        let planned: Vec<usize> = (0..comparison.modes.len()).filter(is_planned).collect();
        if planned.is_empty() {
            return None;
        }
        let is_unsafe = |i: &usize| coverage::unsafe_until(answer.problem.model(), solved, *i).is_some();
        let still_unsafe = planned.iter().any(is_unsafe);
        let mut price = PriceRecord::against_baseline(answer, run, solved, still_unsafe);
        if still_unsafe && price.baseline != Baseline::Itself {
            price.sentence.push_str("; this plan is still unsafe");
        }
        Some(price)
    }

    /// A price with a sentence and without figures.
    fn without_figures(baseline: Baseline, still_unsafe: bool, sentence: impl Into<String>) -> Self {
        PriceRecord {
            baseline,
            baseline_time_s: None,
            more_time_s: None,
            baseline_unsafe_until_s: None,
            baseline_risk: None,
            more_energy_j: None,
            still_unsafe,
            sentence: sentence.into(),
        }
    }

    fn against_baseline(answer: &Answer, run: &PlannerRun, solved: &MissionPlan, still_unsafe: bool) -> Self {
        let comparison = answer.comparison;
        let bare = |baseline, sentence: String| PriceRecord::without_figures(baseline, still_unsafe, sentence);
        let timed = |baseline, time: f64, sentence: String| PriceRecord {
            baseline_time_s: Some(time),
            more_time_s: Some(solved.time - time),
            ..bare(baseline, sentence)
        };
        if run.planner == PlannerKind::Rip {
            let sentence = match still_unsafe {
                true => "none, because this plan ignores faults; `mavc compare` finds what covering them costs",
                false => "nothing: this plan ignores faults and covers them",
            };
            return bare(Baseline::Itself, sentence.into());
        }
        if let Some(without) = comparison.trade_off.first() {
            let risk = significant(without.risk, DIGITS);
            let sentence = match solved.time > without.time {
                true => format!(
                    "{} ({}) over the plan without protection, whose risk is {risk}",
                    seconds(solved.time - without.time),
                    percent(solved.time / without.time - 1.0)
                ),
                false => {
                    format!("no time: without protection the risk is {risk} in the same {}", seconds(solved.time))
                }
            };
            let price = timed(Baseline::Unprotected, without.time, sentence);
            return PriceRecord { baseline_risk: Some(without.risk), ..price };
        }
        let is_fixed = run.run == Run::Common || determined(answer.problem.mission()).is_some();
        let ignoring = comparison.ignoring.as_ref().and_then(|run| run.outcome.plan());
        match (is_fixed, run.planner, ignoring) {
            (true, PlannerKind::Rsp, Some(rip)) => {
                let last = rip.outside.iter().filter_map(|outside| outside.last).reduce(f64::max);
                let energy =
                    |plan: &MissionPlan| Some(battery::record(answer.problem.model(), &plan.trajectory)?.energy_j);
                let energies = energy(rip).zip(energy(solved));
                let sentence = match comparison.selected.is_empty() {
                    true => "nothing: the plan that ignores faults is the same".to_string(),
                    false => format!(
                        "no time: a plan that ignores faults also takes {}{}{}",
                        seconds(solved.time),
                        last.map_or(String::new(), |last| format!(
                            " and is unsafe until {}",
                            coverage::instant(rip, last)
                        )),
                        energies.map_or(String::new(), |(ignoring, covering)| more_energy(ignoring, covering))
                    ),
                };
                PriceRecord {
                    baseline_unsafe_until_s: last,
                    more_energy_j: energies.map(|(ignoring, covering)| covering - ignoring),
                    ..timed(Baseline::IgnoringFaults, rip.time, sentence)
                }
            }
            (true, ..) => {
                let time = seconds(solved.time);
                bare(
                    Baseline::None,
                    format!("no time, because the spec asks for {time}; `mavc compare` prices the shortest plan"),
                )
            }
            (false, PlannerKind::Rsp, _) if comparison.selected.is_empty() => {
                bare(Baseline::None, "nothing: the plan that ignores faults is the same".into())
            }
            (false, ..) => {
                // The bound is about the limits alone, so it holds for every motion that ignores faults.
                let least = least_time_within(answer.problem);
                let is_near = solved.time <= (1.0 + MOST_OVER) * least.seconds && !least.is_above(solved.time);
                if !is_near {
                    let sentence = "not known from this planner alone; `mavc compare` finds it";
                    return bare(Baseline::None, sentence.into());
                }
                // Rounded like the headline, so that a reader may subtract.
                let bound = least_time::shown(least.seconds);
                let sentence = format!(
                    "at most {}: no motion within limits and thrust is faster than {}, whether it covers faults or \
                     not; `mavc compare` finds the price",
                    seconds(solved.time - bound),
                    seconds(bound)
                );
                timed(Baseline::LeastTime, bound, sentence)
            }
        }
    }
}

/// A time with one digit more than other figures, so that small prices show.
fn seconds(time: f64) -> String {
    format!("{} s", significant(time, DIGITS + 1))
}

/// `; covering uses 0.4 % (0.012 W*h) more energy`: what a plan takes from the battery beyond one that ignores faults,
/// from the energies of both, J.
fn more_energy(ignoring: f64, covering: f64) -> String {
    let more = covering / ignoring - 1.0;
    let energy = battery::watt_hours((covering - ignoring).abs());
    match more.abs() < SAME_ENERGY {
        true => String::new(),
        false => {
            format!(
                "; covering uses {} ({energy}) {} energy",
                percent(more.abs()),
                if more > 0.0 { "more" } else { "less" }
            )
        }
    }
}
