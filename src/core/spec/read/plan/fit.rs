//! Checks that the samples and the time of a plan fit the mission.

use super::super::context::Context;
use crate::diagnostic::Diagnostic;
use crate::language::table::plan as table;
use crate::model::{MAX_SAMPLES, Mission};
use crate::number::{number, plural};
use crate::source::Span;
use crate::syntax::ast::Expr;

/// If legs need more than this share of the samples, the times found depend on the number of samples
/// (docs/performance.md).
const MOST_NEEDED: f64 = 0.6;

/// The samples of a plan, with their place.
pub struct Samples<'e> {
    pub number: usize,
    /// The value that gives them, where it is written.
    pub given: Option<&'e Expr>,
    pub span: Span,
}

/// The samples of a plan that gives none: as many as do not limit its times, if a search allows them.
pub fn usual_samples(mission: &Mission) -> usize {
    let needed = mission.samples_needed();
    let enough = (needed as f64 / MOST_NEEDED).ceil() as usize;
    let usual = enough.min(crate::model::MAX_SAMPLES_OF_A_SEARCH).max(table::SAMPLES.value() as usize);
    usual.max(needed).min(MAX_SAMPLES)
}

impl Samples<'_> {
    /// Reports samples that are fewer than one for each leg and hold, and warns of fewer than legs need.
    pub fn check(&self, cx: &mut Context, mission: &Mission) {
        let Samples { number: samples, given, span } = *self;
        let holds = mission.waypoints.iter().filter(|w| w.hold > 0.0).count();
        let least = mission.legs.len() + holds;
        if samples < least {
            let and_holds = match holds {
                0 => String::new(),
                1 => " and 1 hold".into(),
                _ => format!(" and {holds} holds"),
            };
            let legs = mission.legs.len();
            let message = format!("{samples} samples are fewer than the mission's {legs} legs{and_holds}");
            let error = Diagnostic::error("mavc::plan::samples", span, message).here("too few");
            let enough = usual_samples(mission).max(least);
            let error = error.also(mission.span, "this mission").help(format!("write `samples = {enough}`"));
            cx.report(match given {
                Some(expr) => error.fix(expr.span, enough.to_string()),
                None => error,
            });
            return;
        }
        let needed = mission.samples_needed();
        if samples < needed {
            let message = {
                let (samples, legs) = (plural(samples, "sample"), plural(mission.legs.len(), "leg"));
                format!("{samples} may be too few for a mission with {legs}")
            };
            let warning = Diagnostic::warning("mavc::plan::few_samples", span, message).here("few samples");
            let enough = usual_samples(mission);
            let warning = warning.also(mission.span, "this mission").help(format!(
                "write `samples = {enough}` or more: a leg from rest to rest needs 10 of them, a leg from or to rest 5"
            ));
            cx.report(match given {
                Some(expr) => warning.fix(expr.span, enough.to_string()),
                None => warning,
            });
        }
    }

    /// Warns if the planner searches for times and few samples are left for the longest legs.
    pub fn warn_of_dependence(&self, cx: &mut Context, mission: &Mission) {
        let Samples { number: samples, given, span } = *self;
        let needed = mission.samples_needed();
        if samples < needed || needed as f64 <= MOST_NEEDED * samples as f64 {
            return;
        }
        let enough = (needed as f64 / MOST_NEEDED).ceil() as usize;
        let message = format!(
            "the shortest time may depend on `samples`: of {samples}, legs and holds need at least {needed}, more than \
             60 %"
        );
        let warning = Diagnostic::warning("mavc::plan::coarse_grid", span, message).here("few for a search over times");
        let warning = warning.also(mission.span, "this mission").help(format!("write `samples = {enough}` or more"));
        cx.report(match given {
            Some(expr) => warning.fix(expr.span, enough.to_string()),
            None => warning,
        });
    }

    /// Reports too many samples for a search, which computes many plans and so is limited to fewer samples than a
    /// single plan.
    pub fn check_search(&self, cx: &mut Context) {
        const MOST: usize = crate::model::MAX_SAMPLES_OF_A_SEARCH;
        let (samples, Some(given)) = (self.number, self.given.map(|expr| expr.span)) else { return };
        if samples <= MOST {
            return;
        }
        let message = format!("{samples} samples are too many for a search over times: at most {MOST} are allowed");
        let error = Diagnostic::error("mavc::plan::samples", given, message).here("too many for a search");
        let help = format!("write `samples = {MOST}`, or give the mission a fixed `time` and `timing = proportional`");
        cx.report(error.help(help).fix(given, MOST.to_string()));
    }
}

/// Reports a fixed mission time that leaves no time after holds and fixed waypoint times, or contradicts the last one.
pub fn check_time(cx: &mut Context, time: f64, span: Span, mission: &Mission) {
    const CODE: &str = "mavc::plan::time";
    let mut free_at = 0.0;
    let mut reason = mission.span;
    let mut fixed_by = "the mission";
    let mut fixed_time = None;
    for waypoint in &mission.waypoints {
        if let Some(fixed) = waypoint.time {
            free_at = fixed;
            reason = waypoint.time_span.unwrap_or(waypoint.span);
            fixed_by = "the waypoint's time";
            fixed_time = Some(reason);
        }
        if waypoint.hold > 0.0 {
            free_at += waypoint.hold;
            reason = waypoint.hold_span.unwrap_or(waypoint.span);
            fixed_by = if fixed_time.is_some() { "the waypoint's time or the hold" } else { "the hold" };
        }
    }
    let last = mission.waypoints.last();
    let ends_fixed = last.is_some_and(|w| w.time.is_some());
    let fits = if ends_fixed { (time - free_at).abs() <= 1e-9 * time } else { time > free_at };
    if !fits {
        let ends = if ends_fixed { "ends at" } else { "lasts longer than" };
        let message = format!("the mission {ends} {} s, but `time` is {} s", number(free_at), number(time));
        let error = Diagnostic::error(CODE, span, message).here("the mission time");
        let either = if fixed_by.contains(" or ") { "," } else { " or" };
        let help = format!("change this time{either} {fixed_by}, or write `time = minimum`");
        let error = match fixed_time.filter(|at| *at != reason) {
            Some(at) => error.also(at, "fixed here"),
            None => error,
        };
        cx.report(error.also(reason, if fixed_by.ends_with("hold") { "held here" } else { "fixed here" }).help(help));
    }
}
