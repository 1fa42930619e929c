//! `yaw towards`, `yaw along path` and `yaw free`, and the limits that they impose.

use super::context::Context;
use super::expected::Expected;
use super::fields::Fields;
use super::written::Written;
use crate::diagnostic::Diagnostic;
use crate::language::table::waypoint as table;
use crate::model::{
    Heading, Limit, LimitKind, Mission, OnLeg, Part, PlanModel, PlanSettings, Target, Vehicle, Waypoint,
};
use crate::number::number;
use crate::source::Span;
use crate::syntax::ast::{ExprKind, Name};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// The largest tolerance of a yaw that follows from the motion, rad.
const MOST: f64 = 0.98 * FRAC_PI_2;

const CODE: &str = "mavc::mission::heading";
const MODEL: &str = "mavc::mission::heading_model";

/// What a waypoint says about its yaw beyond a number.
#[derive(Debug, Clone)]
pub(super) enum Rule {
    Given,
    Towards(Goal),
    AlongPath,
    Free,
}

/// What the yaw points to.
#[derive(Debug, Clone)]
pub(super) enum Goal {
    Point([f64; 3]),
    /// A waypoint by its name.
    Named(String, Span),
}

/// What is written about the yaw.
pub(super) fn read<'a>(cx: &mut Context<'a>, fields: &Fields<'a>) -> Written<Rule> {
    let Some(Name { value: how, .. }) = fields.how(table::YAW.name) else {
        return fields.written(table::YAW.name, |_| Some(Rule::Given));
    };
    Written::of(match how.as_str() {
        "towards" => fields.get(table::YAW.name).and_then(|expr| match &expr.kind {
            ExprKind::Name(name) if !cx.in_scope(name) => Some(Rule::Towards(Goal::Named(name.clone(), expr.span))),
            _ => Some(Rule::Towards(Goal::Point(cx.triple(Expected::new("the point of `yaw towards`", "m"), expr)?))),
        }),
        "free" => Some(Rule::Free),
        _ => Some(Rule::AlongPath),
    })
}

/// Gives each waypoint its rule, which continues until another one is written; the yaws (rad) that the rules give at
/// the waypoints where `yaws` has none, as far as these know it; and whether all goals are known. `is_whole` tells
/// whether these are all waypoints of the mission.
pub(super) fn settle(
    cx: &mut Context,
    waypoints: &mut [Waypoint],
    written: &[Option<Rule>],
    yaws: &[Option<f64>],
    is_whole: bool,
) -> (Vec<Option<f64>>, bool) {
    let (mut rule, mut whole) = (Heading::Given, true);
    let places: Vec<[f64; 3]> = waypoints.iter().map(|w| w.position).collect();
    let mut found = Vec::new();
    for index in 0..waypoints.len() {
        match written.get(index).and_then(Option::as_ref) {
            None => {}
            Some(Rule::Given) => rule = Heading::Given,
            Some(Rule::AlongPath) => rule = Heading::AlongPath,
            Some(Rule::Free) => rule = Heading::Free,
            Some(Rule::Towards(Goal::Point([x, y, _]))) => rule = Heading::Towards([*x, *y]),
            Some(Rule::Towards(Goal::Named(name, span))) => {
                match waypoints.iter().find(|w| w.name.as_ref() == Some(name)) {
                    Some(goal) => rule = Heading::Towards([goal.position[0], goal.position[1]]),
                    // A waypoint with an error may have this name.
                    None if !is_whole => whole = false,
                    None => {
                        let named: Vec<String> = waypoints.iter().filter_map(|w| w.name.clone()).collect();
                        let known: Vec<&str> = named.iter().map(String::as_str).collect();
                        cx.unknown("waypoint", name, *span, &known);
                        whole = false;
                    }
                }
            }
        }
        let here = places[index];
        let azimuth = |from: [f64; 3], to: [f64; 2]| {
            let (x, y) = (to[0] - from[0], to[1] - from[1]);
            (x.hypot(y) > 1e-6).then(|| y.atan2(x))
        };
        let flat = |p: [f64; 3]| [p[0], p[1]];
        found.push(match rule {
            Heading::Given => yaws[index],
            Heading::Towards(point) => azimuth(here, point),
            Heading::AlongPath => {
                let arrives = index.checked_sub(1).and_then(|before| azimuth(places[before], flat(here)));
                arrives.or_else(|| places.get(index + 1).and_then(|next| azimuth(here, flat(*next))))
            }
            Heading::Free => None,
        });
        waypoints[index].heading = rule;
        let follows = matches!(rule, Heading::Towards(_) | Heading::AlongPath);
        if follows && waypoints[index].yaw_within > MOST && whole {
            let message = format!(
                "a yaw that follows from the motion takes a tolerance of less than {} deg",
                number(MOST.to_degrees())
            );
            let error = Diagnostic::error(CODE, waypoints[index].span, message).here("a wider tolerance");
            cx.report(error.help("write a smaller `yaw_within`, or `yaw free`"));
            whole = false;
        }
    }
    (found, whole)
}

/// Adds the limits on the yaw of waypoints and legs where it follows from the motion. Between two waypoints with one
/// rule it holds on the whole leg, with the tolerance of the waypoint where the leg ends, otherwise at the waypoint.
/// Where a rule begins, a smaller tolerance of the waypoint holds there.
pub(super) fn impose(mission: &mut Mission, vehicle: &Vehicle) {
    let points = &mission.waypoints;
    let mut found = Vec::new();
    for (index, point) in points.iter().enumerate() {
        let target = match point.heading {
            Heading::Given | Heading::Free => continue,
            Heading::Towards(point) => Target::Towards { point, nearest: vehicle.radius() },
            Heading::AlongPath => Target::AlongPath,
        };
        let same = |other: Option<&Waypoint>| other.is_some_and(|other| other.heading == point.heading);
        let begins = !same(index.checked_sub(1).and_then(|before| points.get(before)));
        // The next waypoint adds the leg that begins here, which keeps its tolerance at this end too.
        let kept_by_next = points.get(index + 1).is_some_and(|n| same(Some(n)) && n.yaw_within <= point.yaw_within);
        let (leg, part) = match index {
            _ if begins && kept_by_next => continue,
            0 => (0, Part::Start),
            _ if begins => (index - 1, Part::End),
            _ => (index - 1, Part::Whole),
        };
        let at = match &point.name {
            Some(name) => format!("waypoint `{name}`"),
            None => format!("waypoint {}", index + 1),
        };
        let name = match part {
            Part::Whole => format!("yaw on the leg to {at}"),
            Part::Start | Part::End => format!("yaw at {at}"),
        };
        let on = OnLeg { leg, part, name };
        let (upper, leg) = (Some(point.yaw_within), Some(Arc::new(on)));
        found.push(Limit { kind: LimitKind::Heading(target), lower: None, upper, span: point.span, volume: None, leg });
    }
    mission.limits.extend(found);
}

/// Reports a yaw that follows from the motion in a plan of the hover model, which plans yaw first.
pub(super) fn only_in_the_exact_model(cx: &mut Context, plan: &PlanSettings, mission: &Mission) -> bool {
    let follows = |w: &&Waypoint| w.heading != Heading::Given;
    let Some(waypoint) = mission.waypoints.iter().find(follows) else { return true };
    if plan.model == PlanModel::Exact {
        return true;
    }
    let message = "`model = hover` plans yaw before the path, and here it follows from the path or is free";
    let error = Diagnostic::error(MODEL, waypoint.span, message).here("no yaw in degrees");
    cx.report(error.help("write `model = exact` in `plan`, or a yaw in degrees"));
    false
}
