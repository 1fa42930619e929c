//! `mission` blocks: turns curves, waypoints, holds and tables into one list of waypoints and legs.

mod curve;
mod leg;
mod times;

pub use leg::ARRIVAL;
pub(super) use times::{MAX_DURATION, too_long};

use super::written::Written;
use crate::model::MAX_WAYPOINTS;
use std::collections::BTreeMap;

use super::context::Context;
use super::expected::Expected;
use super::fields::Fields;
use super::load::FileSet;
use super::volume;
use super::{air, edits, heading, limits, origin, plausibility, survey};
use crate::diagnostic::Diagnostic;
use crate::language::Group;
use crate::language::table::HOLD;
use crate::language::table::mission as of_mission;
use crate::language::table::waypoint as table;
use crate::model::grid::Spacing;
use crate::model::legs::{Timing, shares, unwrap_yaw};
use crate::model::{Air, Heading, Mission, Waypoint};
use crate::number::number;
use crate::source::Span;
use crate::syntax::ast::{Block, Clauses, Expr, Statement};
use crate::unit::Quantity;

/// How far a coordinate may lie from the origin, m: farther than any multirotor flies, and near enough that tolerances
/// of centimetres survive rounding.
pub(super) const MAX_DISTANCE: f64 = 1e6;

/// What applies to a waypoint that does not give these values itself.
#[derive(Debug, Clone, Copy)]
pub(super) struct WaypointDefaults {
    /// m
    pub within: f64,
    /// rad
    pub yaw_within: f64,
    pub weight: f64,
    pub timing: Timing,
    pub spacing: Spacing,
}

/// What is known of a mission, errors or not.
pub(super) struct Outline {
    pub name: String,
    pub span: Span,
    /// The mission, if it has no errors.
    pub mission: Option<Mission>,
    /// Whether the first waypoint gives no yaw.
    pub yaw_defaulted: bool,
}

/// A waypoint whose yaw is not resolved yet.
pub(super) struct Stop {
    pub name: Option<String>,
    pub position: [f64; 3],
    pub yaw: Option<f64>,
    pub within: f64,
    pub yaw_within: f64,
    pub weight: f64,
    pub time: Option<(f64, Span)>,
    pub stop: bool,
    pub(in crate::spec::read) heading: Option<heading::Rule>,
    pub span: Span,
}

/// The list of waypoints under construction.
pub(super) struct Route {
    pub waypoints: Vec<Waypoint>,
    pub yaws: Vec<Option<f64>>,
    /// The curve that leg i (from waypoint i to i + 1) belongs to.
    pub curves: Vec<Option<usize>>,
    /// What is written about the legs, in the order of flight.
    legs: Vec<leg::Written>,
    /// What each waypoint says of its yaw.
    headings: Vec<Option<heading::Rule>>,
    /// A statement had an error, so points may be missing.
    pub broken: bool,
    /// The names of waypoints from statements, not from tables, with their places.
    names: BTreeMap<String, Span>,
    too_many: bool,
    too_far: bool,
}

impl Route {
    pub fn push(&mut self, cx: &mut Context, stop: Stop, curve: Option<usize>) {
        if self.waypoints.len() >= MAX_WAYPOINTS {
            if !self.too_many {
                let message = format!("a mission may have at most {MAX_WAYPOINTS} waypoints");
                let error = Diagnostic::error("mavc::mission::too_many_waypoints", stop.span, message);
                cx.report(error.here("the limit is exceeded here").help("use fewer points"));
            }
            (self.too_many, self.broken) = (true, true);
            return;
        }
        if let Some(far) = stop.position.iter().find(|p| p.abs() > MAX_DISTANCE) {
            if !self.too_far {
                let message = "a waypoint lies more than 1000 km from the origin";
                let error = Diagnostic::error("mavc::mission::too_far", stop.span, message);
                let help = "place the origin where the mission starts: x east, y north, z up";
                cx.report(error.here(format!("a coordinate of {} km", number(far / 1e3))).help(help));
            }
            (self.too_far, self.broken) = (true, true);
            return;
        }
        if !self.waypoints.is_empty() {
            self.curves.push(curve);
        }
        self.yaws.push(stop.yaw);
        self.headings.push(stop.heading);
        self.waypoints.push(Waypoint {
            name: stop.name,
            position: stop.position,
            yaw: 0.0,
            heading: Heading::Given,
            within: stop.within,
            yaw_within: stop.yaw_within,
            weight: stop.weight,
            time: stop.time.map(|t| t.0),
            hold: 0.0,
            stop: stop.stop,
            span: stop.span,
            time_span: stop.time.map(|t| t.1),
            hold_span: None,
        });
    }
}

pub(super) fn elaborate<'a>(
    cx: &mut Context<'a>,
    block: &'a Block,
    manner: WaypointDefaults,
    files: &'a FileSet,
) -> Outline {
    let name = block.name.as_ref().map_or("mission", |n| &n.value).to_string();
    let span = block.name.as_ref().map_or(block.keyword.span, |n| n.span);
    let fields = Fields::of_block(cx, format!("mission `{name}`"), span, &block.body, Group::Mission);
    let mut route = Route {
        waypoints: Vec::new(),
        yaws: Vec::new(),
        curves: Vec::new(),
        legs: Vec::new(),
        headings: Vec::new(),
        broken: false,
        names: BTreeMap::new(),
        too_many: false,
        too_far: false,
    };
    let (mut start_at_rest, mut end_at_rest) = (true, true);
    let mut limit_block: Option<&Block> = None;
    let mut volume_blocks: Vec<&Block> = Vec::new();
    let mut air_block: Option<&Block> = None;
    let (mut limits, mut limits_whole) = (Vec::new(), true);
    // The number of waypoints before the first statement with an error: these are certain.
    let mut sure = None;
    // The number of each waypoint as its author counts, where no curve or table with an error comes before it.
    let (mut numbers, mut unread) = (Vec::new(), Some(0));
    for (index, statement) in block.body.iter().enumerate() {
        let before = route.waypoints.len();
        match statement {
            Statement::Start(clauses) => {
                if !route.waypoints.is_empty() {
                    let message = "`start` must come before all other waypoints";
                    let error = Diagnostic::error("mavc::mission::start_first", clauses.span, message);
                    let word = Span { end: clauses.span.start + "start".len() as u32, ..clauses.span };
                    let error = error.here("waypoints come before this").help("move it up, or write `waypoint at`");
                    cx.report(error.fix(word, "waypoint"));
                    route.broken = true;
                }
                waypoint(cx, clauses, "`start`", manner, &mut route);
            }
            Statement::Waypoint(clauses) => {
                let owner = clauses.name.as_ref().map_or("`waypoint`".into(), |n| format!("waypoint `{}`", n.value));
                waypoint(cx, clauses, &owner, manner, &mut route);
            }
            Statement::Curve { parameter, range, options, body, .. } => {
                let curve = curve::Curve { index, parameter, range, options, body };
                curve.fly(cx, manner, &mut route);
            }
            Statement::WaypointsFrom { path, .. } => match files.table(block.keyword.span.file, &path.value) {
                Some(table) => survey::read(cx, table, manner, &mut route),
                None => route.broken = true,
            },
            Statement::Hold { duration, span } => hold(cx, duration, *span, &mut route),
            Statement::Moving { end, .. } => *if end.value { &mut end_at_rest } else { &mut start_at_rest } = false,
            Statement::Block(inner) if volume::is_one(inner) => volume_blocks.push(inner),
            Statement::Block(inner) if air::is_one(inner) => match air_block {
                Some(first) => second_block(cx, "one `air`", first, inner),
                None => air_block = Some(inner),
            },
            Statement::Block(inner) => match limit_block {
                Some(first) => second_block(cx, "one `limits`", first, inner),
                None => {
                    limit_block = Some(inner);
                    (limits, limits_whole) = limits::read(cx, &inner.body);
                }
            },
            Statement::Broken(_) => route.broken = true,
            _ => {}
        }
        match statement {
            Statement::Start(_) | Statement::Waypoint(_) if route.waypoints.len() == before => {
                unread = unread.map(|unread| unread + 1);
            }
            Statement::Curve { .. } | Statement::WaypointsFrom { .. } if route.waypoints.len() == before => {
                unread = None;
            }
            Statement::Broken(_) => unread = None,
            _ => {}
        }
        numbers.extend((before..route.waypoints.len()).map(|index| unread.map(|unread| index + unread)));
        if route.broken {
            // A `hold` changes the waypoint before it.
            let holds = matches!(statement, Statement::Hold { .. });
            sure.get_or_insert(before.saturating_sub(usize::from(holds)));
        }
    }
    let (volumes, volumes_whole) = volume::read(cx, &volume_blocks);
    let air = air_block.map_or_else(|| Some(Air::still(span)), |block| air::read(cx, block));
    let mut sure = sure.unwrap_or(route.waypoints.len());
    if route.waypoints.len() < 2 && !route.broken {
        let message = format!("mission `{name}` needs at least two waypoints");
        let error = Diagnostic::error("mavc::mission::too_few_waypoints", span, message);
        let count = if route.waypoints.is_empty() { "it has no waypoint" } else { "it has only one" };
        let error = error.here(count).help("add `waypoint at [10, 0, 5] m` or a `curve`");
        let last = block.body.last().map(Statement::span);
        let slot = edits::insertion(cx.sources.get(span.file), span, last, "waypoint at [10, 0, 5] m");
        cx.report(match slot.filter(|_| route.waypoints.len() == 1) {
            Some((span, text)) => error.fix(span, text),
            None => error,
        });
        (route.broken, sure) = (true, 0);
    }
    let yaw_defaulted = matches!((route.yaws.first(), route.headings.first()), (Some(None), Some(None)));
    let (yaws, goals_known) = heading::settle(cx, &mut route.waypoints, &route.headings, &route.yaws, !route.broken);
    route.broken |= !goals_known;
    unwrap_yaw(&mut route.waypoints, &yaws);
    let in_order = times::check(cx, &route.waypoints[..sure]);
    if !route.broken {
        warn_close(cx, &route.waypoints);
        plausibility::check_mission(cx, &name, span, &route.waypoints);
    }
    if !route.broken {
        let (of_legs, all) = leg::limits(cx, &route.legs, &route.waypoints, end_at_rest);
        limits.extend(of_legs);
        limits_whole &= all;
    }
    plausibility::check_limits(cx, &limits);
    limits::check(cx, &limits, &route.waypoints, &numbers, sure);
    route.broken |= !in_order;
    let ground = ground(cx, &fields, &route);
    let origin = origin::read(cx, &fields);
    route.broken |= ground.is_faulty() || origin.is_faulty();
    let legs = shares(&route.waypoints, &route.curves, manner.timing);
    let air = air.filter(|_| limits_whole && volumes_whole && !route.broken);
    let mission = air.map(|air| Mission {
        name: name.clone(),
        doc: block.doc.clone(),
        waypoints: route.waypoints,
        legs,
        spacing: manner.spacing,
        start_at_rest,
        end_at_rest,
        limits,
        volumes,
        air,
        ground: ground.value(),
        origin: origin.value(),
        span,
    });
    Outline { name, span, mission, yaw_defaulted }
}

/// The height of the ground.
fn ground<'a>(cx: &mut Context<'a>, fields: &Fields<'a>, route: &Route) -> Written<f64> {
    const CODE: &str = "mavc::mission::ground";
    let Some(expr) = fields.get("ground") else { return Written::Absent };
    let Some(ground) = cx.quantity(&of_mission::GROUND, expr, CODE) else { return Written::Faulty };
    let heights = route.waypoints.iter().map(|w| (w.position[2], w.span));
    let lowest = heights.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|_| !route.broken);
    let Some((z, span)) = lowest.filter(|(z, _)| *z <= ground) else { return Written::Value(ground) };
    let message = format!("`ground` must be below every waypoint, not at {} m", number(ground));
    let error = Diagnostic::error(CODE, expr.span, message).here("too high");
    let error = error.also(span, format!("the lowest waypoint is at {} m", number(z)));
    cx.report(error.help(format!("write a height below {} m, such as `{} m`", number(z), number(z - 1.0))));
    Written::Faulty
}

/// Reports the second block of a kind of which a mission may have one.
fn second_block(cx: &mut Context, kind: &str, first: &Block, second: &Block) {
    let message = format!("a mission may have only {kind} block");
    let error = Diagnostic::error("mavc::name::duplicate", second.keyword.span, message);
    let error = error.here("second block").also(first.keyword.span, "first block");
    cx.report(error.help("move its contents into the first block, then remove this one"));
}

const TOLERANCE: &str = "mavc::mission::tolerance";
const WEIGHT: &str = "mavc::mission::weight";

/// `manner` with `within`, `yaw_within` and `weight` replaced where `fields` give them; `None` where one has an error.
fn manner_of<'a>(cx: &mut Context<'a>, fields: &Fields<'a>, manner: WaypointDefaults) -> Option<WaypointDefaults> {
    let within = match fields.get("within") {
        Some(e) => cx.quantity(&table::WITHIN, e, TOLERANCE),
        None => Some(manner.within),
    };
    let yaw_within = match fields.get("yaw_within") {
        Some(e) => cx.quantity(&table::YAW_WITHIN, e, TOLERANCE),
        None => Some(manner.yaw_within),
    };
    let weight = match fields.get("weight") {
        Some(e) => cx.quantity(&table::WEIGHT, e, WEIGHT),
        None => Some(manner.weight),
    };
    Some(WaypointDefaults { within: within?, yaw_within: yaw_within?, weight: weight?, ..manner })
}

fn waypoint<'a>(cx: &mut Context<'a>, clauses: &'a Clauses, owner: &str, manner: WaypointDefaults, route: &mut Route) {
    let fields = Fields::of_clauses(cx, owner.to_string(), clauses, Group::Waypoint);
    let position = fields.demand(cx, "at", "at [10, 0, 5] m").and_then(|e| cx.triple(Expected::of(&table::AT), e));
    let heading = heading::read(cx, &fields).optional();
    let yaw = if fields.how("yaw").is_some() {
        Written::Absent
    } else {
        fields.written("yaw", |e| cx.number(Expected::of(&table::YAW), e))
    };
    let manner = manner_of(cx, &fields, manner);
    let leg = leg::read(cx, clauses, &fields, (!route.broken).then_some(route.waypoints.len()));
    let time =
        fields.written("time", |e| cx.quantity(&table::TIME, e, "mavc::mission::time_order").map(|t| (t, e.span)));
    let (Some(position), Some(manner), Some(leg), Some(heading), false, false) =
        (position, manner, leg, heading, yaw.is_faulty(), time.is_faulty())
    else {
        route.broken = true;
        return;
    };
    let name = clauses.name.as_ref();
    if let Some(name) = name {
        let of_table = || route.waypoints.iter().find(|w| w.name.as_deref() == Some(&name.value)).map(|w| w.span);
        match route.names.get(&name.value).copied().or_else(of_table) {
            Some(first) => cx.report(super::context::duplicate("waypoint", name, first)),
            None => drop(route.names.insert(name.value.clone(), name.span)),
        }
    }
    let stop = Stop {
        name: name.map(|n| n.value.clone()),
        position,
        yaw: yaw.value(),
        within: manner.within,
        yaw_within: manner.yaw_within,
        weight: manner.weight,
        time: time.value(),
        stop: leg.stop,
        heading,
        span: clauses.head(),
    };
    route.legs.extend(leg.is_written().then_some(leg));
    route.push(cx, stop, None);
}

fn hold<'a>(cx: &mut Context<'a>, duration: &'a Expr, span: Span, route: &mut Route) {
    let seconds = cx.quantity(&HOLD, duration, "mavc::mission::duration");
    match (route.waypoints.last_mut(), seconds) {
        (Some(last), Some(seconds)) if (last.hold + seconds).is_finite() => {
            last.hold += seconds;
            last.hold_span.get_or_insert(span);
        }
        (Some(_), Some(seconds)) => {
            cx.finite(Quantity::plain(seconds * f64::INFINITY), span);
            route.broken = true;
        }
        (None, _) if !route.broken => {
            let message = "`hold` needs a waypoint before it";
            let error = Diagnostic::error("mavc::mission::hold_first", span, message);
            cx.report(error.here("no waypoint comes before this").help("put `start at [0, 0, 2] m` first"));
            route.broken = true;
        }
        _ => route.broken = true,
    }
}

/// Warns of waypoints that the next one makes redundant, once for each statement.
fn warn_close(cx: &mut Context, waypoints: &[Waypoint]) {
    let mut last: Option<Span> = None;
    for pair in waypoints.windows(2) {
        let distance = crate::model::legs::distance(pair[0].position, pair[1].position);
        let turns = (pair[1].yaw - pair[0].yaw).abs() > pair[0].yaw_within;
        if distance < pair[0].within && !turns && pair[0].hold == 0.0 && last != Some(pair[0].span) {
            last = Some(pair[0].span);
            let message = format!(
                "a waypoint lies {} m from the next, closer than its tolerance of {} m",
                number(distance),
                number(pair[0].within)
            );
            let warning = Diagnostic::warning("mavc::mission::close_waypoints", pair[0].span, message);
            let warning = warning.here("one waypoint may suffice");
            let warning = match pair[1].span == pair[0].span {
                true => warning,
                false => warning.also(pair[1].span, "the next waypoint"),
            };
            cx.report(warning.help("remove one, use fewer points, or lower `within`"));
        }
    }
}
