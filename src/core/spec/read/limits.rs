//! The `limits` and `after_fault_limits` blocks of a mission.

use super::context::{Context, listed};
use super::edits;
use super::expected::Expected;
use super::fields::elsewhere;
use super::recovery::LIMIT;
use crate::diagnostic::{Diagnostic, nearest, nearest_by_words};
use crate::language::table::limits as table;
use crate::language::{Entry, Group};
use crate::model::{Limit, LimitKind, Quantity, Waypoint};
use crate::number::number;
use crate::source::Span;
use crate::syntax::ast::{Expr, ExprKind, LimitRelation, Statement};

/// What a limit bounds.
#[derive(Clone, Copy, PartialEq)]
enum Form {
    /// A coordinate.
    Coordinate,
    /// A norm, above zero.
    Norm,
    /// A one-sided rate, zero or above.
    OneSided,
    /// A rate: `<=` bounds both directions, `in` is around zero.
    Rate,
}

/// A limit of the table, with what it bounds.
struct Row {
    entry: &'static Entry,
    kind: LimitKind,
    form: Form,
}

impl Row {
    const fn new(entry: &'static Entry, kind: LimitKind, form: Form) -> Self {
        Row { entry, kind, form }
    }
}

/// The limits of the table.
const LIMITS: [Row; 15] = [
    Row::new(&table::X, LimitKind::X, Form::Coordinate),
    Row::new(&table::Y, LimitKind::Y, Form::Coordinate),
    Row::new(&table::Z, LimitKind::Z, Form::Coordinate),
    Row::new(&table::ALTITUDE, LimitKind::Z, Form::Coordinate),
    Row::new(&table::YAW, LimitKind::Yaw, Form::Coordinate),
    Row::new(&table::SPEED, LimitKind::Speed, Form::Norm),
    Row::new(&table::SPEED_HORIZONTAL, LimitKind::SpeedHorizontal, Form::Norm),
    Row::new(&table::CLIMB, LimitKind::Climb, Form::OneSided),
    Row::new(&table::DESCENT, LimitKind::Descent, Form::OneSided),
    Row::new(&table::ACCELERATION, LimitKind::Acceleration, Form::Norm),
    Row::new(&table::ACCELERATION_HORIZONTAL, LimitKind::AccelerationHorizontal, Form::Norm),
    Row::new(&table::JERK, LimitKind::Jerk, Form::Norm),
    Row::new(&table::YAW_RATE, LimitKind::YawRate, Form::Rate),
    Row::new(&table::YAW_ACCELERATION, LimitKind::YawAcceleration, Form::Rate),
    Row::new(&table::TILT, LimitKind::Tilt, Form::Norm),
];

const FORM: &str = "mavc::mission::limit_form";
const ORDER: &str = "mavc::mission::limit_order";
const VALUE: &str = "mavc::mission::limit_value";

/// Reads the statements of a block that takes the limits of `group`: the limits without errors, and whether these are
/// all of them.
pub(super) fn read<'a>(cx: &mut Context<'a>, body: &'a [Statement], group: Group) -> (Vec<Limit>, bool) {
    let (mut limits, mut whole) = (Vec::new(), true);
    // Name, sides (lower, upper) and place of each limit so far.
    let mut given: Vec<(&str, bool, bool, Span)> = Vec::new();
    for statement in body {
        let limit = match statement {
            Statement::Limit { name, relation, span } => {
                let sides = match relation {
                    LimitRelation::AtMost(_) => (false, true),
                    LimitRelation::AtLeast(_) => (true, false),
                    LimitRelation::In(_) => (true, true),
                };
                let earlier = given.iter().find(|g| g.0 == name.value && ((g.1 && sides.0) || (g.2 && sides.1)));
                if let Some(&(.., first)) = earlier {
                    let message = format!("`{}` is limited twice", name.value);
                    let error = Diagnostic::error("mavc::name::duplicate", *span, message).here("limited again");
                    let again = edits::removal(cx.sources.get(span.file), *span);
                    cx.report(error.also(first, "first limited here").help("remove one of the two").fix(again, ""));
                    whole = false;
                    continue;
                }
                given.push((&name.value, sides.0, sides.1, *span));
                match LIMITS.iter().find(|row| row.entry.name == name.value) {
                    Some(row) if !group.has(row.entry.name) => {
                        of_place(cx, &name.value, *span);
                        None
                    }
                    Some(row) => one(cx, row, relation, *span),
                    None => {
                        unknown(cx, &name.value, name.span, group);
                        None
                    }
                }
            }
            Statement::Field(field) => {
                let name = &field.name.value;
                match LIMITS.iter().find(|row| row.entry.name == name) {
                    Some(_) => {
                        let error = Diagnostic::error(FORM, field.span, format!("the limit `{name}` takes no `=`"));
                        cx.report(error.here("expected a bound").help(format!("write `{name} <= ...`")));
                    }
                    None => unknown(cx, name, field.name.span, group),
                }
                None
            }
            _ => None,
        };
        whole &= limit.is_some();
        limits.extend(limit);
    }
    if let Some(kind) = crossed(cx, &limits) {
        limits.retain(|limit| limit.kind != kind);
        whole = false;
    }
    (limits, whole)
}

/// Reports a lower and an upper bound, in separate statements, that leave no value between them.
fn crossed(cx: &mut Context, limits: &[Limit]) -> Option<LimitKind> {
    let crossed = limits.iter().enumerate().find_map(|(i, limit)| {
        let other = limits[..i].iter().find(|other| {
            let is_above = |low: Option<f64>, high: Option<f64>| low.zip(high).is_some_and(|(low, high)| low > high);
            other.kind == limit.kind && (is_above(other.lower, limit.upper) || is_above(limit.lower, other.upper))
        });
        other.map(|other| (limit, other))
    });
    let (limit, other) = crossed?;
    let name = cx.sources.snippet(limit.span).split_whitespace().next().unwrap_or_default().to_string();
    let message = format!("the lower bound of `{name}` exceeds the upper bound");
    let error = Diagnostic::error(ORDER, limit.span, message).here("no value satisfies this");
    cx.report(error.also(other.span, "and this").help("lower the lower bound, or raise the upper bound"));
    Some(limit.kind.clone())
}

/// Reports a limit on a place or on the yaw in `after_fault_limits`.
fn of_place(cx: &mut Context, name: &str, span: Span) {
    let message = format!("`after_fault_limits` takes no limit on `{name}`");
    let (here, help) = match name {
        "yaw" => ("the yaw is free after a fault", "remove it"),
        _ => ("a place", "remove it: the mission's `buffer` widens every limit on a place after a fault"),
    };
    cx.report(Diagnostic::error(LIMIT, span, message).here(here).help(help));
}

fn unknown(cx: &mut Context, name: &str, span: Span, group: Group) {
    let names = || group.names();
    let error = Diagnostic::error("mavc::name::unknown_field", span, format!("unknown limit `{name}`"));
    let error = error.here("not a limit");
    const HABITS: [(&str, &str); 8] = [
        ("velocity", "speed"),
        ("height", "altitude"),
        ("roll", "tilt"),
        ("pitch", "tilt"),
        ("bank", "tilt"),
        ("climb_rate", "climb"),
        ("descent_rate", "descent"),
        ("heading", "yaw"),
    ];
    let habit = HABITS.iter().find(|(wrong, _)| *wrong == name).map(|(_, right)| *right);
    let habit = habit.filter(|right| group.has(right));
    let near = habit.or_else(|| nearest(name, names())).or_else(|| nearest_by_words(name, names()));
    cx.report(match (near, elsewhere(name)) {
        (Some(near), _) => error.help(format!("did you mean `{near}`?")).fix(span, near),
        (None, Some(place)) => error.help(place),
        (None, None) => error.help(format!("use one of the limits {}", listed(&names().collect::<Vec<_>>()))),
    });
}

fn one<'a>(cx: &mut Context<'a>, row: &Row, relation: &'a LimitRelation, span: Span) -> Option<Limit> {
    let Row { entry, kind, form } = row;
    let (written, bound) = match relation {
        LimitRelation::AtMost(e) => ("<=", e),
        LimitRelation::AtLeast(e) => (">=", e),
        LimitRelation::In(e) => ("in", e),
    };
    let (name, due) = (entry.name, Expected::of(entry));
    let unit = due.unit;
    if !entry.forms().contains(&written) {
        let highest = if let ExprKind::Range { high, .. } = &bound.kind { high } else { bound };
        let corrected = format!("{name} <= {}", cx.sources.snippet(highest.span));
        let error = Diagnostic::error(FORM, span, format!("`{name}` takes only an upper bound"));
        let error = error.here(format!("`{written}` is not allowed"));
        cx.report(error.help(format!("write `{corrected}`")).fix(span, corrected));
        return None;
    }
    let (lower, upper, at): (Option<f64>, Option<f64>, &Expr) = match relation {
        LimitRelation::AtMost(e) => {
            let upper = cx.number(due, e)?;
            (if *form == Form::Rate { Some(-upper) } else { None }, Some(upper), e)
        }
        LimitRelation::AtLeast(e) => (Some(cx.number(due, e)?), None, e),
        LimitRelation::In(e) => {
            let (low, high) = cx.range_of(due, e)?;
            (Some(low), Some(high), e)
        }
    };
    if let (Some(low), Some(high)) = (lower, upper)
        && low > high
        && written == "in"
    {
        let message = format!("the lower bound of `{name}` exceeds the upper bound");
        let error = Diagnostic::error(ORDER, at.span, message);
        let error = error.here("empty range").help("swap the two ends");
        cx.report(error);
        return None;
    }
    let wrong = match (form, upper) {
        (Form::Norm, Some(upper)) if upper <= 0.0 => {
            Some(("must be greater than zero", format!("write a value above 0 {unit}")))
        }
        (Form::Norm, Some(upper)) if *kind == LimitKind::Tilt && upper >= std::f64::consts::FRAC_PI_2 => {
            let rule = "must be below 90 deg: there the thrust has no vertical component";
            Some((rule, "write a smaller angle, as in `tilt <= 35 deg`".to_string()))
        }
        (Form::OneSided, Some(upper)) if upper < 0.0 => {
            Some(("cannot be negative", "remove the sign: the name gives the direction".to_string()))
        }
        (Form::Rate, Some(upper)) if upper < 0.0 || lower.is_some_and(|low| low > 0.0) => {
            let both_ways = format!("write `{name} <= ...` with a value above 0 {unit}: it bounds both directions");
            Some(("must include zero, the rate at rest", both_ways))
        }
        _ => None,
    };
    if let Some((wrong, help)) = wrong {
        let error = Diagnostic::error(VALUE, at.span, format!("`{name}` {wrong}"));
        cx.report(error.here("out of range").help(help));
        return None;
    }
    Some(Limit { kind: kind.clone(), lower, upper, span, volume: None, leg: None })
}

/// Reports waypoints outside the limits on coordinates and yaw, once for each limit.
pub(super) fn check(
    cx: &mut Context,
    limits: &[Limit],
    waypoints: &[Waypoint],
    numbers: &[Option<usize>],
    sure: usize,
) {
    for limit in limits {
        let described = limit.kind.describe();
        let Quantity::Axis { axis, order: 0, sign } = described.quantity else { continue };
        let coordinate = |waypoint: &Waypoint| sign * waypoint.position.get(axis).copied().unwrap_or(waypoint.yaw);
        let is_below = |value: f64| limit.lower.is_some_and(|low| value < low - 1e-9);
        let is_above = |value: f64| limit.upper.is_some_and(|high| value > high + 1e-9);
        // The yaw counts on from the waypoint before.
        let known = if limit.kind == LimitKind::Yaw { &waypoints[..sure] } else { waypoints };
        let concerned = |i: usize| limit.leg.as_ref().is_none_or(|on| i == on.leg || i == on.leg + 1);
        let known = known.iter().enumerate().filter(|(i, _)| concerned(*i));
        let mut outside = known.filter_map(|(i, waypoint)| {
            let value = Some(coordinate(waypoint)).filter(|&value| is_below(value) || is_above(value))?;
            Some((i, waypoint, value))
        });
        let Some((index, waypoint, value)) = outside.next() else {
            continue;
        };
        let called = |index: usize, waypoint: &Waypoint| match &waypoint.name {
            Some(name) => format!("waypoint `{name}`"),
            None => match numbers[index] {
                Some(0) => "the first waypoint".to_string(),
                Some(number) => format!("waypoint {}", number + 1),
                None => "a waypoint".to_string(),
            },
        };
        let which = called(index, waypoint);
        let side = if is_below(value) { "below" } else { "above" };
        let others: Vec<(usize, &Waypoint)> = outside.map(|(i, waypoint, _)| (i, waypoint)).collect();
        // The start counts as waypoint 1, which a number needs to explain.
        let is_numbered = |index: usize, waypoint: &Waypoint| {
            numbers[index].is_some_and(|number| number > 0) && waypoint.name.is_none()
        };
        let numbered = is_numbered(index, waypoint) || matches!(others[..], [(i, w)] if is_numbered(i, w));
        let counted = if numbered { "; the first waypoint is the start" } else { "" };
        let others = match others[..] {
            [] => String::new(),
            [(i, waypoint)] => format!("; {} violates it too", called(i, waypoint)),
            _ => format!("; {} more waypoints violate it", others.len()),
        };
        let (word, unit, shown) = (described.word, described.unit, number(value * described.factor()));
        let message = format!("{which} has {word} = {shown} {unit}, {side} the limit{others}");
        let error = Diagnostic::error("mavc::mission::outside_limits", waypoint.span, message);
        let help = if others.is_empty() {
            "move the waypoint or widen the limit"
        } else {
            "move the waypoints or widen the limit"
        };
        let error = error.here("violates the limit").also(limit.span, "the limit");
        cx.report(error.help(format!("{help}{counted}")));
    }
}
