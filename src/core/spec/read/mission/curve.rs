//! Turns a curve into waypoints, evenly spaced in its parameter.

use super::{Route, Stop, WaypointDefaults};
use crate::diagnostic::Diagnostic;
use crate::language::Group;
use crate::language::table::curve as table;
use crate::language::table::curve_head::POINTS;
use crate::number::number;
use crate::read::context::Context;
use crate::read::expected::Expected;
use crate::read::fields::Fields;
use crate::read::written::Written;
use crate::syntax::ast::{Expr, Field, Name, Statement};
use crate::unit::Quantity;

/// `curve s in 0 .. 4*pi, points = 21 { .. }`
pub(super) struct Curve<'a> {
    pub index: usize,
    pub parameter: &'a Name,
    pub range: &'a Expr,
    pub options: &'a [Field],
    pub body: &'a [Statement],
}

impl<'a> Curve<'a> {
    pub fn fly(&self, cx: &mut Context<'a>, defaults: WaypointDefaults, route: &mut Route) {
        let owner = "`curve`".to_string();
        let head = self.parameter.span.to(self.range.span);
        let fields = Fields::of_block(cx, owner.clone(), head, self.body, Group::Curve);
        let mut options = Fields::of_block(cx, owner, head, &[], Group::CurveHead);
        self.options.iter().for_each(|field| options.take_field(cx, field, Group::CurveHead));
        let points = options
            .demand(cx, "points", ", points = 21")
            .and_then(|e| cx.count(&POINTS, "the number of points", e, "mavc::mission::curve_points"));
        let range = self.read_range(cx);
        let own = defaults.replaced(cx, &fields);
        let x = fields.demand(cx, "x", "x = 4 m * cos(s)");
        let y = fields.demand(cx, "y", "y = 4 m * sin(s)");
        let z = fields.demand(cx, "z", "z = 10 m");
        let yaw = fields.get("yaw");
        let (Some(points), Some((low, high)), Some(own)) = (points, range, own) else {
            // The coordinates are evaluated once all the same, so that their own errors are reported.
            if let Some((low, _)) = range {
                self.at(cx, low, [x, y, z], yaw);
            }
            route.broken = true;
            return;
        };
        for k in 0..points {
            let t = k as f64 / (points - 1) as f64;
            let value = low.value * (1.0 - t) + high.value * t;
            let Some((position, yaw)) = self.at(cx, Quantity::new(value, low.dimension), [x, y, z], yaw) else {
                route.broken = true;
                return;
            };
            if k == 0 && self.joins(route, position, yaw) {
                continue;
            }
            let stop = Stop {
                name: None,
                position,
                yaw,
                within: own.within,
                yaw_within: own.yaw_within,
                weight: own.weight,
                time: None,
                leg: None,
                heading: yaw.map(|_| crate::read::heading::Rule::Given),
                span: head,
            };
            let within_curve = (k > 0).then_some(self.index);
            route.push(cx, stop, within_curve);
            if route.broken {
                return;
            }
        }
    }

    /// Whether the curve starts at the last waypoint, and so shares it.
    fn joins(&self, route: &Route, position: [f64; 3], yaw: Option<f64>) -> bool {
        let Some(last) = route.waypoints.last() else {
            return false;
        };
        let before = route.yaws.iter().rev().find_map(|yaw| *yaw).unwrap_or(0.0);
        let same_yaw = yaw.is_none_or(|yaw| (yaw - before).abs() < 1e-9);
        crate::model::legs::distance(last.position, position) < 1e-9 && same_yaw
    }

    fn read_range(&self, cx: &mut Context<'a>) -> Option<(Quantity, Quantity)> {
        let (low, high) = cx.range_ends(self.range, "a range `a .. b`")?;
        if low.value == high.value {
            let message = format!("the range of `{}` has zero length", self.parameter.value);
            let error = Diagnostic::error("mavc::mission::curve_range", self.range.span, message);
            let error = error.here(format!("both ends are {}", number(low.value)));
            cx.report(error.help("write two different ends, as in `0 .. 2*pi`"));
            return None;
        }
        Some((low, high))
    }

    /// Position and yaw, if one is written, at one value of the parameter; `None` where one has an error.
    fn at(
        &self,
        cx: &mut Context<'a>,
        value: Quantity,
        axes: [Option<&'a Expr>; 3],
        yaw: Option<&'a Expr>,
    ) -> Option<([f64; 3], Option<f64>)> {
        cx.parameter = Some((&self.parameter.value, value));
        let [x, y, z] = axes;
        let x = x.and_then(|e| cx.number(Expected::of(&table::X), e));
        let y = y.and_then(|e| cx.number(Expected::of(&table::Y), e));
        let z = z.and_then(|e| cx.number(Expected::of(&table::Z), e));
        let yaw = yaw.map_or(Written::Absent, |e| Written::of(cx.number(Expected::of(&table::YAW), e)));
        cx.parameter = None;
        Some(([x?, y?, z?], yaw.optional().ok()?))
    }
}
