//! The clauses of a waypoint about the leg that arrives there, and the limits that they impose on it.

use super::super::limits as reader;
use crate::diagnostic::Diagnostic;
use crate::language::Group;
use crate::language::table::waypoint as table;
use crate::model::legs::distance;
use crate::model::volume::corridor;
use crate::model::{Limit, LimitKind, OnLeg, Part, Waypoint};
use crate::number::number;
use crate::read::context::Context;
use crate::read::expected::Expected;
use crate::read::fields::Fields;
use crate::read::written::Written;
use crate::source::Span;
use crate::syntax::ast::Clauses;
use std::sync::Arc;

/// The largest angle between the velocity at a waypoint and the direction that `arrive from` gives, rad.
pub const ARRIVAL: f64 = std::f64::consts::PI / 36.0;

/// Waypoints nearer to each other than this have no line between them, and those of a vertical leg are above each other
/// to within this, m.
const SAME_PLACE: f64 = 1e-6;

const FIRST: &str = "mavc::mission::leg_first";
const CONFLICT: &str = "mavc::mission::leg_conflict";
const LINE: &str = "mavc::mission::leg_line";
const ARRIVE: &str = "mavc::mission::arrival";

/// How far a leg may stray from its line.
#[derive(Debug, Clone, Copy)]
enum Shape {
    Straight,
    Vertical,
    /// m
    Corridor(f64),
}

impl Shape {
    fn word(self) -> &'static str {
        match self {
            Shape::Straight => "straight",
            Shape::Vertical => "vertical",
            Shape::Corridor(_) => "corridor",
        }
    }
}

/// What is written about the leg that arrives at a waypoint.
#[derive(Debug)]
pub struct LegClauses {
    /// The waypoint's index.
    to: usize,
    pub stop: bool,
    stop_span: Option<Span>,
    pass_span: Option<Span>,
    shape: Option<(Shape, Span)>,
    /// The direction from which the vehicle comes, not of unit length.
    from: Option<([f64; 3], Span)>,
    limits: Vec<Limit>,
}

impl LegClauses {
    /// Whether anything is written.
    pub fn is_written(&self) -> bool {
        let LegClauses { stop_span, pass_span, shape, from, limits, .. } = self;
        stop_span.is_some() || pass_span.is_some() || shape.is_some() || from.is_some() || !limits.is_empty()
    }
}

/// Reads the clauses about the leg and the limits in braces; `None` where one has an error. `to` is the index of the
/// waypoint, if that is certain.
pub fn read<'a>(
    cx: &mut Context<'a>,
    clauses: &'a Clauses,
    fields: &Fields<'a>,
    to: Option<usize>,
) -> Option<LegClauses> {
    let mut is_refused = false;
    if to == Some(0) {
        let words = ["straight", "vertical", "corridor", "arrive", "stop", "pass"];
        let clause = clauses.clauses.iter().find(|clause| words.contains(&clause.word.value.as_str()));
        let braces = clauses.body.first().map(|statement| ("limits", statement.span()));
        if let Some((what, span)) = clause.map(|c| (c.word.value.as_str(), c.span())).or(braces) {
            let what = if what == "limits" { "limits".to_string() } else { format!("`{what}`") };
            let message = format!("the first waypoint takes no {what}: no leg arrives there");
            let error = Diagnostic::error(FIRST, span, message).here("the mission begins here");
            cx.report(error.help("write it at the waypoint where the leg arrives, or remove it"));
            is_refused = true;
        }
    }
    let shapes = [table::STRAIGHT.name, table::VERTICAL.name, table::CORRIDOR.name];
    let mut given: Vec<(&str, Span)> = shapes.iter().filter_map(|word| Some((*word, fields.clause(word)?))).collect();
    given.sort_by_key(|(_, span)| span.start);
    if let [(first, at), (second, again), ..] = given[..] {
        let message = format!("`{first}` and `{second}` contradict each other: a leg has one shape");
        let error = Diagnostic::error(CONFLICT, again, message).here("another shape");
        cx.report(error.also(at, "the first one").help("remove one of the two"));
        return None;
    }
    let shape = given.first().map_or(Written::Absent, |&(word, span)| {
        let shape = match word {
            "straight" => Some(Shape::Straight),
            "vertical" => Some(Shape::Vertical),
            _ => fields.quantity(cx, &table::CORRIDOR, super::TOLERANCE).value().map(Shape::Corridor),
        };
        Written::of(shape.map(|shape| (shape, span)))
    });
    let (stop_span, pass_span) = (fields.clause(table::STOP.name), fields.clause(table::PASS.name));
    if let (Some(stop), Some(pass)) = (stop_span, pass_span) {
        let message = "`stop` and `pass` contradict each other";
        let error = Diagnostic::error(CONFLICT, pass, message).here("flies through").also(stop, "comes to rest");
        cx.report(error.help("remove one of the two"));
        return None;
    }
    let from = fields.written(table::ARRIVE.name, |expr| {
        let from = cx.triple(Expected::of(&table::ARRIVE), expr)?;
        if from == [0.0; 3] {
            let message = "`arrive from` needs a direction, but all its parts are zero";
            let error = Diagnostic::error(ARRIVE, expr.span, message).here("no direction");
            cx.report(error.help("write where the vehicle comes from, as in `arrive from [0, 0, 1]`"));
            return None;
        }
        Some((from, fields.clause(table::ARRIVE.name).unwrap_or(expr.span)))
    });
    let (limits, whole) = reader::read(cx, &clauses.body, Group::Limits);
    let leg = LegClauses {
        to: to.unwrap_or(0),
        stop: stop_span.is_some(),
        stop_span,
        pass_span,
        shape: shape.optional().ok()?,
        from: from.optional().ok()?,
        limits,
    };
    (whole && !is_refused).then_some(leg)
}

/// The limits of all legs without errors, in the order of flight, and whether these are all of them.
pub fn limits(cx: &mut Context, legs: &[LegClauses], waypoints: &[Waypoint], end_at_rest: bool) -> (Vec<Limit>, bool) {
    let mut found = Vec::new();
    let mut whole = true;
    for leg in legs.iter().filter(|leg| leg.to > 0 && leg.to < waypoints.len()) {
        let (from, to) = (&waypoints[leg.to - 1], &waypoints[leg.to]);
        let is_last = leg.to + 1 == waypoints.len();
        let at = match &to.name {
            Some(name) => format!("waypoint `{name}`"),
            None => format!("waypoint {}", leg.to + 1),
        };
        whole &= agrees(cx, leg, to, is_last && end_at_rest, is_last && !end_at_rest);
        let on = |name: String, part: Part| Some(Arc::new(OnLeg { leg: leg.to - 1, part, name }));
        if let Some((shape, span)) = leg.shape {
            match line(cx, from, to, shape, span) {
                Some(radius) => {
                    let name = match shape {
                        Shape::Corridor(_) => format!("corridor to {at}"),
                        _ => format!("{} leg to {at}", shape.word()),
                    };
                    found.extend(corridor::limits([from, to], leg.to - 1, radius, &name, span));
                }
                None => whole = false,
            }
        }
        if let Some((comes_from, span)) = leg.from {
            let length = comes_from.iter().map(|part| part * part).sum::<f64>().sqrt();
            let kind = LimitKind::Arrival(comes_from.map(|part| -part / length));
            let leg = on(format!("direction of arrival at {at}"), Part::End);
            found.push(Limit { kind, lower: None, upper: Some(ARRIVAL), span, volume: None, leg });
        }
        found.extend(leg.limits.iter().map(|limit| {
            let name = format!("{} on the leg to {at}", limit.kind.describe().name);
            Limit { leg: on(name, Part::Whole), ..limit.clone() }
        }));
    }
    (found, whole)
}

/// Whether the clauses agree with the statements about rest: `rests` and `moves` at the end of the mission.
fn agrees(cx: &mut Context, leg: &LegClauses, to: &Waypoint, rests: bool, moves: bool) -> bool {
    let held = to.hold_span.filter(|_| to.hold > 0.0);
    if let (Some(pass), Some(hold)) = (leg.pass_span, held) {
        let message = "`pass` and `hold` contradict each other";
        let error = Diagnostic::error(CONFLICT, pass, message).here("flies through").also(hold, "stays at rest");
        cx.report(error.help("remove one of the two"));
        return false;
    }
    if let Some(pass) = leg.pass_span.filter(|_| rests) {
        let message = "`pass` at the last waypoint, where the mission ends at rest";
        let error = Diagnostic::error(CONFLICT, pass, message).here("flies through");
        cx.report(error.help("remove it, or add `end moving`"));
        return false;
    }
    if let Some(stop) = leg.stop_span.filter(|_| moves) {
        let message = "`stop` and `end moving` contradict each other";
        let error = Diagnostic::error(CONFLICT, stop, message).here("comes to rest at the last waypoint");
        cx.report(error.help("remove one of the two"));
        return false;
    }
    let rest = held.or(leg.stop_span).or(rests.then_some(to.span));
    if let (Some((_, span)), Some(rest)) = (leg.from, rest) {
        let message = "`arrive from` gives the direction of the velocity, but the vehicle comes to rest here";
        let error = Diagnostic::error(ARRIVE, span, message).here("no velocity, no direction");
        let error = if rest == to.span { error } else { error.also(rest, "at rest") };
        let instead = if rests { "or add `end moving`" } else { "or let it pass" };
        cx.report(error.help(format!("write `straight` instead, {instead}")));
        return false;
    }
    true
}

/// How far a leg may stray from its line, m; `None` with an error for a leg that has no such line.
fn line(cx: &mut Context, from: &Waypoint, to: &Waypoint, shape: Shape, span: Span) -> Option<f64> {
    let length = distance(from.position, to.position);
    let word = shape.word();
    if length <= SAME_PLACE {
        let message = format!("a leg without length has no line: `{word}` has no meaning");
        let error = Diagnostic::error(LINE, span, message).here("the leg that arrives here has no length");
        let error = if from.span == to.span { error } else { error.also(from.span, "it begins at the same place") };
        cx.report(error.help("remove it, or move one of the waypoints"));
        return None;
    }
    let aside = (to.position[0] - from.position[0]).hypot(to.position[1] - from.position[1]);
    if matches!(shape, Shape::Vertical) && aside > SAME_PLACE {
        let message = format!("the leg is not vertical: its ends are {} m apart horizontally", number(aside));
        let error =
            Diagnostic::error(LINE, span, message).here("the leg arrives here").also(from.span, "it begins here");
        cx.report(error.help("write `straight`, or give both waypoints the same x and y"));
        return None;
    }
    Some(match shape {
        Shape::Corridor(radius) => radius,
        Shape::Straight | Shape::Vertical => from.within.max(to.within),
    })
}
