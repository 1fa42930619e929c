//! Changes in words: what to write in the spec, or on the command line if the statement came from there.

use super::remedy::Change;
use super::statement::{clause, length, written};
use crate::model::{Description, Limit, MissionTime, Problem};
use crate::number::number;
use crate::read::is_override;
use crate::source::{SourceMap, Span};

impl Change {
    /// What to do, in the words of the language. A value set by `--set` is changed there.
    pub fn instruction(self, problem: Problem, sources: &SourceMap) -> String {
        let (model, mission) = (problem.model(), problem.mission());
        let at = |i: usize| match &mission.waypoints[i].name {
            Some(name) => format!("waypoint `{name}`"),
            None => format!("waypoint {}", i + 1),
        };
        let on_leg = |limit: &Limit| match &limit.leg {
            Some(on) => format!(" on the leg to {}", at(on.leg + 1)),
            None => String::new(),
        };
        let set = |span: Span| is_override(sources, span);
        let plan = &model.plan;
        match self {
            Change::Samples(samples) if set(plan.samples_span) => format!("use `--set plan.samples={samples}`"),
            Change::Samples(samples) => format!("write `samples = {samples}`"),
            Change::Time(time) if set(plan.time_span) => format!("use `--set plan.time={}s`", number(time)),
            Change::Time(time) => format!("write `time = {} s`", number(time)),
            Change::Arrival { waypoint, time } => {
                let last = waypoint + 1 == mission.waypoints.len();
                let total = number(time + mission.waypoints[waypoint].hold);
                let both = match plan.time {
                    MissionTime::Fixed(_) if last && set(plan.time_span) => {
                        format!(", and use `--set plan.time={total}s`")
                    }
                    MissionTime::Fixed(_) if last => format!(", and `time = {total} s` in `plan`"),
                    _ => String::new(),
                };
                format!("write `time {} s` at {}{both}", number(time), at(waypoint))
            }
            Change::Within { first, last, within } if first == last => {
                format!("write `within {}` at {}", length(within), at(first))
            }
            Change::Within { within, .. } => format!("write `within = {}` in the curve", length(within)),
            Change::Bound { limit, upper } => {
                let limit = &mission.limits[limit];
                let of_leg = on_leg(limit);
                let Description { word: name, unit, unit_in_si: scale, .. } = limit.kind.describe();
                let value = number(upper / scale);
                match set(limit.span) {
                    true => format!("use `--set mission.limits.{name}={value}{unit}`"),
                    false => format!("write `{name} <= {value} {unit}`{of_leg}"),
                }
            }
            Change::Reserve(reserve) if set(plan.reserve_span) => {
                format!("use `--set plan.reserve={}%`", number(100.0 * reserve))
            }
            Change::Reserve(reserve) => format!("write `reserve = {} %`", number(100.0 * reserve)),
            Change::NoLimit(limit) => {
                let limit = &mission.limits[limit];
                let of_leg = on_leg(limit);
                if plan.require_capture.is_some_and(|required| required.span == limit.span) {
                    return "remove `require capture_height`".into();
                }
                if let Some((clause, on)) = clause(limit).zip(limit.leg.as_ref()) {
                    return format!("remove `{clause}` at {}", at(on.leg + 1));
                }
                let also = if set(limit.span) { " from `--set`, and from the spec if it is there too" } else { "" };
                format!("remove `{}`{of_leg}{also}", written(limit))
            }
            Change::NoHold(waypoint) => format!("remove the `hold` at {}", at(waypoint)),
            Change::NoStop(waypoint) => format!("remove `stop` at {}", at(waypoint)),
            Change::NoMode(mode) => {
                let list = if set(plan.against_span) { "--set plan.against" } else { "against" };
                format!("remove `{}` from `{list}`", model.modes[mode].name)
            }
            Change::Mass(mass) if set(model.vehicle.mass_span) => {
                format!("make the vehicle lighter: `--set vehicle.mass={}kg`", number(mass))
            }
            Change::Mass(mass) => format!("make the vehicle lighter: `mass = {} kg`", number(mass)),
        }
    }
}
