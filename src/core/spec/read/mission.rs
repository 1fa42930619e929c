//! `mission` blocks: turns curves, waypoints, holds and tables into one list of waypoints and legs.

mod curve;
mod leg;
mod times;

pub use leg::ARRIVAL;
use leg::LegClauses;
pub(super) use times::{MAX_DURATION, too_long};

use super::written::Written;
use crate::model::MAX_WAYPOINTS;
use std::collections::BTreeMap;

use super::context::{Context, second_block};
use super::expected::Expected;
use super::fields::Fields;
use super::load::FileSet;
use super::volume;
use super::{air, edits, heading, limits, origin, plausibility, recovery, survey};
use crate::diagnostic::Diagnostic;
use crate::language::Group;
use crate::language::table::HOLD;
use crate::language::table::mission as of_mission;
use crate::language::table::waypoint as table;
use crate::model::grid::Spacing;
use crate::model::legs::{Timing, shares, unwrap_yaw};
use crate::model::{Air, Heading, Limit, Mission, Waypoint};
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

impl WaypointDefaults {
    /// With `within`, `yaw_within` and `weight` replaced where `fields` give them; `None` where one has an error.
    fn replaced<'a>(self, cx: &mut Context<'a>, fields: &Fields<'a>) -> Option<Self> {
        let within = fields.quantity(cx, &table::WITHIN, TOLERANCE).or_default(|| self.within);
        let yaw_within = fields.quantity(cx, &table::YAW_WITHIN, TOLERANCE).or_default(|| self.yaw_within);
        let weight = fields.quantity(cx, &table::WEIGHT, WEIGHT).or_default(|| self.weight);
        Some(WaypointDefaults { within: within?, yaw_within: yaw_within?, weight: weight?, ..self })
    }
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
    /// What is written about the leg that arrives here.
    pub leg: Option<LegClauses>,
    pub heading: Option<heading::Rule>,
    pub span: Span,
}

/// The list of waypoints under construction.
#[derive(Default)]
pub(super) struct Route {
    pub waypoints: Vec<Waypoint>,
    pub yaws: Vec<Option<f64>>,
    /// The curve that leg i (from waypoint i to i + 1) belongs to.
    pub curves: Vec<Option<usize>>,
    /// What is written about the legs, in the order of flight.
    legs: Vec<LegClauses>,
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
        let comes_to_rest = stop.leg.as_ref().is_some_and(|leg| leg.stop);
        self.legs.extend(stop.leg.filter(LegClauses::is_written));
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
            stop: comes_to_rest,
            span: stop.span,
            time_span: stop.time.map(|t| t.1),
            hold_span: None,
        });
    }
}

pub(super) fn elaborate<'a>(
    cx: &mut Context<'a>,
    block: &'a Block,
    defaults: WaypointDefaults,
    files: &'a FileSet,
) -> Outline {
    let name = block.name.as_ref().map_or("mission", |n| &n.value).to_string();
    let span = block.name.as_ref().map_or(block.keyword.span, |n| n.span);
    let fields = Fields::of_block(cx, format!("mission `{name}`"), span, &block.body, Group::Mission);
    let body = Body::read(cx, block, defaults, files);
    let yaw_defaulted = matches!((body.route.yaws.first(), body.route.headings.first()), (Some(None), Some(None)));
    let mission = body.mission(cx, block, &fields, &name, defaults);
    Outline { name, span, mission, yaw_defaulted }
}

/// What the statements of a mission say.
#[derive(Default)]
struct Body<'a> {
    route: Route,
    starts_moving: bool,
    ends_moving: bool,
    volumes: Vec<&'a Block>,
    air: Option<&'a Block>,
    limit_block: Option<&'a Block>,
    /// The limits without errors, and whether others have one.
    limits: Vec<Limit>,
    limits_faulty: bool,
    after_fault: recovery::Blocks<'a>,
    /// The number of waypoints before the first statement with an error: these are certain.
    sure: Option<usize>,
    /// The number of each waypoint as its author counts, where no curve or table with an error comes before it.
    numbers: Vec<Option<usize>>,
    /// How many waypoints have errors, and whether others are not counted.
    unread: usize,
    uncounted: bool,
}

impl<'a> Body<'a> {
    fn read(cx: &mut Context<'a>, block: &'a Block, defaults: WaypointDefaults, files: &'a FileSet) -> Self {
        let mut body = Body::default();
        for (index, statement) in block.body.iter().enumerate() {
            let before = body.route.waypoints.len();
            match statement {
                Statement::Start(clauses) => {
                    start_first(cx, clauses, &mut body.route);
                    waypoint(cx, clauses, "`start`", defaults, &mut body.route);
                }
                Statement::Waypoint(clauses) => {
                    let owner =
                        clauses.name.as_ref().map_or("`waypoint`".into(), |n| format!("waypoint `{}`", n.value));
                    waypoint(cx, clauses, &owner, defaults, &mut body.route);
                }
                Statement::Curve { parameter, range, options, body: inner, .. } => {
                    let curve = curve::Curve { index, parameter, range, options, body: inner };
                    curve.fly(cx, defaults, &mut body.route);
                }
                Statement::WaypointsFrom { path, .. } => match files.table(block.keyword.span.file, &path.value) {
                    Some(table) => survey::read(cx, table, defaults, &mut body.route),
                    None => body.route.broken = true,
                },
                Statement::Hold { duration, span } => hold(cx, duration, *span, &mut body.route),
                Statement::Moving { end, .. } if end.value => body.ends_moving = true,
                Statement::Moving { .. } => body.starts_moving = true,
                Statement::Block(inner) => body.block(cx, inner),
                Statement::Broken(_) => body.route.broken = true,
                _ => {}
            }
            body.count(statement, before);
        }
        body
    }

    fn block(&mut self, cx: &mut Context<'a>, inner: &'a Block) {
        if self.after_fault.take(cx, inner) {
            return;
        }
        if volume::is_one(inner) {
            self.volumes.push(inner);
        } else if air::is_one(inner) {
            match self.air {
                Some(first) => cx.report(second_block("a mission may have only one `air` block".into(), inner, first)),
                None => self.air = Some(inner),
            }
        } else if let Some(first) = self.limit_block {
            cx.report(second_block("a mission may have only one `limits` block".into(), inner, first));
        } else {
            self.limit_block = Some(inner);
            let (limits, whole) = limits::read(cx, &inner.body, Group::Limits);
            (self.limits, self.limits_faulty) = (limits, !whole);
        }
    }

    /// Numbers the waypoints that `statement` adds to the first `before`, and remembers which are certain.
    fn count(&mut self, statement: &Statement, before: usize) {
        let adds_none = self.route.waypoints.len() == before;
        match statement {
            Statement::Start(_) | Statement::Waypoint(_) if adds_none => self.unread += 1,
            Statement::Curve { .. } | Statement::WaypointsFrom { .. } if adds_none => self.uncounted = true,
            Statement::Broken(_) => self.uncounted = true,
            _ => {}
        }
        let added = before..self.route.waypoints.len();
        self.numbers.extend(added.map(|index| (!self.uncounted).then_some(index + self.unread)));
        if self.route.broken {
            // A `hold` changes the waypoint before it.
            let holds = matches!(statement, Statement::Hold { .. });
            self.sure.get_or_insert(before.saturating_sub(usize::from(holds)));
        }
    }

    /// Checks the waypoints together and reads the rest of the block; `None` where the mission has errors.
    fn mission(
        self,
        cx: &mut Context<'a>,
        block: &'a Block,
        fields: &Fields<'a>,
        name: &str,
        defaults: WaypointDefaults,
    ) -> Option<Mission> {
        let Body { mut route, mut limits, mut limits_faulty, .. } = self;
        let span = fields.span;
        let volumes = volume::read(cx, &self.volumes);
        let air = self.air.map_or_else(|| Some(Air::still(span)), |block| air::read(cx, block));
        let mut sure = self.sure.unwrap_or(route.waypoints.len());
        if route.waypoints.len() < 2 && !route.broken {
            too_few(cx, block, span, name, route.waypoints.len());
            (route.broken, sure) = (true, 0);
        }
        let (yaws, goals_known) =
            heading::settle(cx, &mut route.waypoints, &route.headings, &route.yaws, !route.broken);
        route.broken |= !goals_known;
        unwrap_yaw(&mut route.waypoints, &yaws);
        let in_order = times::check(cx, &route.waypoints[..sure]);
        if !route.broken {
            warn_close(cx, &route.waypoints);
            plausibility::check_mission(cx, name, span, &route.waypoints);
            let (of_legs, all) = leg::limits(cx, &route.legs, &route.waypoints, !self.ends_moving);
            limits.extend(of_legs);
            limits_faulty |= !all;
        }
        plausibility::check_limits(cx, &limits);
        limits::check(cx, &limits, &route.waypoints, &self.numbers, sure);
        route.broken |= !in_order;
        let ground = ground(cx, fields, &route);
        let origin = origin::read(cx, fields);
        let after_fault = self.after_fault.read(cx, fields, ground);
        if route.broken || limits_faulty {
            return None;
        }
        Some(Mission {
            name: name.to_string(),
            doc: block.doc.clone(),
            legs: shares(&route.waypoints, &route.curves, defaults.timing),
            waypoints: route.waypoints,
            spacing: defaults.spacing,
            start_at_rest: !self.starts_moving,
            end_at_rest: !self.ends_moving,
            limits,
            volumes: volumes?,
            air: air?,
            ground: ground.optional().ok()?,
            origin: origin.optional().ok()?,
            after_fault: after_fault?,
            span,
        })
    }
}

/// Reports a `start` that comes after other waypoints.
fn start_first(cx: &mut Context, clauses: &Clauses, route: &mut Route) {
    if route.waypoints.is_empty() {
        return;
    }
    let message = "`start` must come before all other waypoints";
    let error = Diagnostic::error("mavc::mission::start_first", clauses.span, message);
    let word = Span { end: clauses.span.start + "start".len() as u32, ..clauses.span };
    let error = error.here("waypoints come before this").help("move it up, or write `waypoint at`");
    cx.report(error.fix(word, "waypoint"));
    route.broken = true;
}

/// Reports a mission with `count` waypoints, fewer than two.
fn too_few(cx: &mut Context, block: &Block, span: Span, name: &str, count: usize) {
    let message = format!("mission `{name}` needs at least two waypoints");
    let error = Diagnostic::error("mavc::mission::too_few_waypoints", span, message);
    let error = error.here(if count == 0 { "it has no waypoint" } else { "it has only one" });
    let error = error.help("add `waypoint at [10, 0, 5] m` or a `curve`");
    let last = block.body.last().map(Statement::span);
    let slot = edits::insertion(cx.sources.get(span.file), span, last, "waypoint at [10, 0, 5] m");
    cx.report(match slot.filter(|_| count == 1) {
        Some((span, text)) => error.fix(span, text),
        None => error,
    });
}

/// Height (m) and place of the lowest waypoint.
pub(super) fn lowest(waypoints: &[Waypoint]) -> Option<(f64, Span)> {
    let heights = waypoints.iter().map(|w| (w.position[2], w.span));
    heights.min_by(|a, b| a.0.total_cmp(&b.0))
}

/// The error for a ground (m) that is above the lowest waypoint, or not below it, of which the height (m) and place are
/// given; `rule` says which.
pub(super) fn ground_too_high(
    code: &'static str,
    rule: &str,
    at: Span,
    ground: f64,
    lowest: (f64, Span),
) -> Diagnostic {
    let (z, span) = lowest;
    let message = format!("`ground` must {rule}, not at {} m", number(ground));
    let error = Diagnostic::error(code, at, message).here("too high");
    let error = error.also(span, format!("the lowest waypoint is at {} m", number(z)));
    error.help(format!("write a height below {} m, such as `{} m`", number(z), number(z - 1.0)))
}

/// The height of the ground.
fn ground<'a>(cx: &mut Context<'a>, fields: &Fields<'a>, route: &Route) -> Written<f64> {
    const CODE: &str = "mavc::mission::ground";
    fields.written("ground", |expr| {
        let ground = cx.quantity(&of_mission::GROUND, expr, CODE)?;
        let lowest = lowest(&route.waypoints).filter(|_| !route.broken);
        // A mission may begin and end on the ground.
        match lowest.filter(|(z, _)| *z < ground) {
            Some(lowest) => {
                cx.report(ground_too_high(CODE, "not be above a waypoint", expr.span, ground, lowest));
                None
            }
            None => Some(ground),
        }
    })
}

const TOLERANCE: &str = "mavc::mission::tolerance";
const WEIGHT: &str = "mavc::mission::weight";

fn waypoint<'a>(
    cx: &mut Context<'a>,
    clauses: &'a Clauses,
    owner: &str,
    defaults: WaypointDefaults,
    route: &mut Route,
) {
    let index = (!route.broken).then_some(route.waypoints.len());
    let Some(stop) = read_stop(cx, clauses, owner, defaults, index) else {
        route.broken = true;
        return;
    };
    if let Some(name) = &clauses.name {
        let of_table = || route.waypoints.iter().find(|w| w.name.as_deref() == Some(&name.value)).map(|w| w.span);
        match route.names.get(&name.value).copied().or_else(of_table) {
            Some(first) => cx.report(super::context::duplicate("waypoint", name, first)),
            None => drop(route.names.insert(name.value.clone(), name.span)),
        }
    }
    route.push(cx, stop, None);
}

/// Reads `start` or `waypoint`; `None` where it has an error. `index` is that of the waypoint, if it is certain.
fn read_stop<'a>(
    cx: &mut Context<'a>,
    clauses: &'a Clauses,
    owner: &str,
    defaults: WaypointDefaults,
    index: Option<usize>,
) -> Option<Stop> {
    let fields = Fields::of_clauses(cx, owner.to_string(), clauses, Group::Waypoint);
    let position = fields.demand(cx, "at", "at [10, 0, 5] m").and_then(|e| cx.triple(Expected::of(&table::AT), e));
    let heading = heading::read(cx, &fields);
    let yaw = match fields.how("yaw") {
        Some(_) => Written::Absent,
        None => fields.written("yaw", |e| cx.number(Expected::of(&table::YAW), e)),
    };
    let own = defaults.replaced(cx, &fields);
    let leg = leg::read(cx, clauses, &fields, index);
    let time =
        fields.written("time", |e| cx.quantity(&table::TIME, e, "mavc::mission::time_order").map(|t| (t, e.span)));
    let own = own?;
    Some(Stop {
        name: clauses.name.as_ref().map(|n| n.value.clone()),
        position: position?,
        yaw: yaw.optional().ok()?,
        within: own.within,
        yaw_within: own.yaw_within,
        weight: own.weight,
        time: time.optional().ok()?,
        leg: Some(leg?),
        heading: heading.optional().ok()?,
        span: clauses.head(),
    })
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
