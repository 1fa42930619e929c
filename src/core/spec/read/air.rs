//! The `air` block of a mission.

use super::context::Context;
use super::expected::Expected;
use super::fields::Fields;
use super::plausibility::check_strong_air;
use crate::diagnostic::Diagnostic;
use crate::language::Group;
use crate::language::table::air as table;
use crate::model::{Air, LimitKind, Mission, PlanModel, PlanSettings, STANDARD_DENSITY, Vehicle};
use crate::number::number;
use crate::source::Span;
use crate::syntax::ast::{Block, Expr, ExprKind};

const INVALID: &str = "mavc::air::value";
const MODEL: &str = "mavc::air::model";
const CONFLICT: &str = "mavc::air::conflict";

/// Whether a block of a mission is its air.
pub(super) fn is_one(block: &Block) -> bool {
    block.keyword.value == "air"
}

/// Reads the `air` block; `None` where it has an error.
pub(super) fn read<'a>(cx: &mut Context<'a>, block: &'a Block) -> Option<Air> {
    let span = block.keyword.span;
    let fields = Fields::of_block(cx, "`air`".into(), span, &block.body, Group::Air);
    let wind = fields.written("wind", |expr| wind(cx, expr)).or_default(|| ([0.0; 3], [0.0; 3]));
    let gusts = fields.quantity(cx, &table::GUSTS, INVALID).or_default(|| table::GUSTS.value());
    let density = fields.quantity(cx, &table::DENSITY, INVALID);
    let altitude = fields.quantity(cx, &table::ALTITUDE, INVALID);
    let mut is_whole = block.is_whole();
    if let (Some(here), Some(first)) = (fields.span_of("altitude"), fields.span_of("density")) {
        let error = Diagnostic::error(CONFLICT, here, "`altitude` and `density` both give the density of the air");
        cx.report(error.here("second density").also(first, "first density").help("remove one of the two"));
        is_whole = false;
    }
    let density_ratio = match (density.optional().ok()?, altitude.optional().ok()?) {
        (Some(density), _) => density / STANDARD_DENSITY,
        (None, Some(altitude)) => ratio_at(cx, altitude, fields.get("altitude").map_or(span, |expr| expr.span))?,
        (None, None) => 1.0,
    };
    let (wind, wind_spread) = wind?;
    let strongest = wind.iter().zip(wind_spread).map(|(w, s)| (w.abs() + s).powi(2)).sum::<f64>().sqrt();
    let given = |name: &str, value: Option<f64>| value.zip(fields.span_of(name));
    check_strong_air(cx, given("wind", Some(strongest)), given("gusts", gusts));
    let air = Air { wind, wind_spread, gusts: gusts?, density_ratio, span };
    is_whole.then_some(air)
}

/// The density of the air at a height (m) as a share of the standard density; reports a height outside the troposphere.
fn ratio_at(cx: &mut Context, altitude: f64, at: Span) -> Option<f64> {
    let ratio = standard_ratio(altitude);
    if ratio.is_none() {
        let message = format!("`altitude` must be between {} m and {} m", number(LOWEST), number(HIGHEST));
        let error = Diagnostic::error(INVALID, at, message).here(format!("this is {} m", number(altitude)));
        cx.report(error.help("write the height above sea level, or the density: `density = 1.1 kg/m^3`"));
    }
    ratio
}

/// `[6, 0, 0] m/s`, with `+- 2 m/s` or `+- [2, 2, 0] m/s`: the middle and the largest deviation on each axis, m/s.
fn wind<'a>(cx: &mut Context<'a>, expr: &'a Expr) -> Option<([f64; 3], [f64; 3])> {
    let due = Expected::of(&table::WIND);
    let ExprKind::Interval { value, by } = &expr.kind else {
        return Some((cx.triple(due, expr)?, [0.0; 3]));
    };
    let middle = cx.triple(due, value);
    let spread = match by.kind {
        ExprKind::List { .. } => cx.triple(due, by),
        _ => cx.number(due, by).map(|spread| [spread; 3]),
    };
    let (middle, spread) = (middle?, spread?);
    if spread.iter().any(|s| *s < 0.0) {
        let error = Diagnostic::error(INVALID, by.span, "the value after `+-` cannot be negative");
        cx.report(error.here("below zero").help("remove the minus sign"));
        return None;
    }
    Some((middle, spread))
}

/// The heights of the lowest layer of the standard atmosphere, m.
const LOWEST: f64 = -2000.0;
const HIGHEST: f64 = 11_000.0;

/// The density of the standard atmosphere at a height above sea level (m), divided by that at sea level; `None` outside
/// the troposphere. ISO 2533: with the temperature T = T0 - L h the density is `rho0 (T/T0)^(g/(R L) - 1)`.
fn standard_ratio(altitude: f64) -> Option<f64> {
    const T0: f64 = 288.15; // K
    const LAPSE: f64 = 0.0065; // K/m
    const G: f64 = 9.806_65; // m/s^2
    const R: f64 = 287.052_87; // J/(kg K)
    const EARTH: f64 = 6_356_766.0; // m
    // Geopotential height.
    let h = EARTH * altitude / (EARTH + altitude);
    (LOWEST..=HIGHEST).contains(&altitude).then(|| (1.0 - LAPSE * h / T0).powf(G / (R * LAPSE) - 1.0))
}

/// Scales the coefficients of rotors and drag, which are proportional to the density, from the standard density to that
/// of the mission.
pub(super) fn impose(vehicle: &mut Vehicle, air: &Air) {
    let ratio = air.density_ratio;
    if ratio == 1.0 {
        return;
    }
    vehicle.drag = vehicle.drag.map(|drag| drag * ratio);
    if let Some(drag) = &mut vehicle.yaw_drag {
        (drag.linear, drag.quadratic) = (drag.linear * ratio, drag.quadratic * ratio);
    }
    for rotor in &mut vehicle.rotors {
        rotor.thrust_coefficient *= ratio;
        rotor.drag_coefficient *= ratio;
    }
}

/// Reports air that this plan cannot take into account; whether there is none.
pub(super) fn check(cx: &mut Context, plan: &PlanSettings, mission: Option<&Mission>, vehicle: &Vehicle) -> bool {
    let Some(mission) = mission else { return true };
    let air = &mission.air;
    let is_moving = air.wind.iter().chain(&air.wind_spread).any(|v| *v != 0.0) || air.gusts > 0.0;
    if vehicle.drag == [0.0; 3] {
        if is_moving {
            let message = format!("vehicle `{}` has no `drag`, so wind and gusts do not act on it", vehicle.name);
            let warning = Diagnostic::warning("mavc::air::no_drag", air.span, message).here("moving air");
            cx.report(
                warning
                    .also(vehicle.span, "no `drag`")
                    .help("add `drag = 0.3 N*s/m` to the vehicle, with its own value"),
            );
        }
        return true;
    }
    let drag = vehicle.drag_span.unwrap_or(vehicle.span);
    if plan.model == PlanModel::Hover {
        let error = Diagnostic::error(MODEL, drag, "`drag` needs `model = exact`: the hover model has no air");
        let error = error.here("not in the hover model");
        cx.report(
            error.help("write `model = exact` in `plan`, or move `drag` to `simulate`, where only flights use it"),
        );
        return false;
    }
    if !vehicle.mass_spread.is_none() {
        let message = "`drag` cannot be combined with an interval of the mass: no bound is known for both";
        let error = Diagnostic::error(CONFLICT, drag, message).here("with drag");
        let error = error.also(vehicle.mass_span, "an interval");
        cx.report(error.help("write the mass without `+-`, for example its largest value"));
        return false;
    }
    let has_spread = mission.air.wind_spread.iter().any(|spread| *spread > 0.0);
    let [x, y, z] = vehicle.drag;
    let differs = has_spread && !(x == y && y == z);
    if differs {
        let message = "an interval of the wind needs the same `drag` along all axes";
        let error = Diagnostic::error(CONFLICT, mission.air.span, message).here("an interval of the wind");
        let error = error.also(drag, "differs along the axes");
        cx.report(
            error.help("write one number for `drag`, such as the largest of the three, or the wind without `+-`"),
        );
    }
    !limits_tilt(cx, drag, mission, vehicle) && !differs
}

/// Reports limits on tilt with a drag that differs along x and y, with which the attitude depends on the yaw; whether
/// there is one.
fn limits_tilt(cx: &mut Context, drag: Span, mission: &Mission, vehicle: &Vehicle) -> bool {
    if vehicle.drag[0] == vehicle.drag[1] {
        return false;
    }
    let Some(limit) = mission.limits.iter().find(|limit| limit.kind == LimitKind::Tilt) else { return false };
    let message =
        "a limit on tilt cannot be combined with a `drag` that differs along x and y: tilt then depends on yaw";
    let error = Diagnostic::error(CONFLICT, limit.span, message).here("limit on tilt");
    let error = error.also(drag, "differs along x and y");
    cx.report(error.help("write the same drag along x and y, such as their larger value"));
    true
}
