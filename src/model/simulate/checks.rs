//! What only several settings show together: rates that fit, steps that are fine enough and not too many, faults that
//! strike before the flight is over.

use crate::diagnostic::Diagnostic;
use crate::model::context::Context;
use crate::model::fields::Fields;
use crate::model::{Mission, Model, Simulation, Strike, Vehicle};
use crate::number::number;
use crate::source::Span;
use crate::syntax::ast::Expr;

/// Fastest integration, Hz.
const MAX_RATE: f64 = 100_000.0;
/// Most steps of one flight.
const MAX_STEPS: f64 = 1e8;
/// Slowest controller and estimator, Hz: the vehicle is looked at when the controller acts.
const MIN_RATES: [(&str, f64); 2] = [("control_rate", 10.0), ("estimator_rate", 1.0)];
const RATES: &str = "mavc::simulate::rates";

/// When the flight is over, s, where that is said, and what is said there.
pub(super) type End = (f64, Span, &'static str);

/// The end of the flight where the spec fixes it: by the plan's time or that of the last waypoint.
pub(super) fn fixed_end(plan_time: Option<(f64, Span)>, mission: Option<&Mission>) -> Option<End> {
    if let Some((time, span)) = plan_time {
        return Some((time, span, "the plan takes this time"));
    }
    let last = mission?.waypoints.last()?;
    Some((last.time? + last.hold, last.time_span.unwrap_or(last.span), "the mission ends with this waypoint"))
}

/// `mode` strikes at `at`, and the flight is over at `end`.
pub(super) fn late(mode: &str, at: f64, span: Span, end: f64) -> Diagnostic {
    let message = format!("fault `{mode}` at {} s comes too late: the flight is over at {} s", number(at), number(end));
    Diagnostic::error("mavc::simulate::past_the_end", span, message)
        .here("never strikes")
        .help(format!("write a time before {} s, or let the flight go on with a longer `duration`", number(end)))
}

/// `mode` recovers at `until`, and the flight is over at `end`.
pub(super) fn late_recovery(mode: &str, until: f64, span: Span, end: f64) -> Diagnostic {
    let message =
        format!("fault `{mode}` is over at {} s, after the flight, which ends at {} s", number(until), number(end));
    Diagnostic::error("mavc::simulate::past_the_end", span, message)
        .here("its rotors never recover")
        .help(format!("write a time up to {} s, or take `until` out: the fault then stays", number(end)))
}

/// The faults that strike or end after a flight of `end` seconds, for plans whose time is known only once they are
/// made. A flight with a `duration` of its own has been checked against that.
pub fn past_the_end(model: &Model, end: f64) -> Vec<Diagnostic> {
    let simulation = &model.simulation;
    if simulation.duration.is_some() {
        return Vec::new();
    }
    let past = |fault: &Strike| {
        let mode = &model.modes[fault.mode].name;
        match fault.until {
            _ if fault.at >= end => Some(late(mode, fault.at, fault.at_span, end)),
            Some(until) if until > end => Some(late_recovery(mode, until, fault.span, end)),
            _ => None,
        }
    };
    let takes = format!("the plan takes {} s", number(end));
    let told = simulation.faults.iter().filter_map(past);
    told.map(|error| error.also(model.plan.time_span, takes.clone())).collect()
}

/// The error of a flight of `end` seconds that takes too many steps, as [`past_the_end`].
pub fn too_many_steps(model: &Model, end: f64) -> Option<Diagnostic> {
    steps(end, model.simulation.rate, model.simulation.rate_span)
}

/// More than [`MAX_STEPS`] in `duration` seconds is an error at `span`.
pub(super) fn steps(duration: f64, rate: f64, span: Span) -> Option<Diagnostic> {
    let steps = duration * rate;
    (steps > MAX_STEPS && rate <= MAX_RATE).then(|| {
        let message = format!("a flight takes at most 100 million steps, not {}", number(steps));
        Diagnostic::error("mavc::simulate::too_many_steps", span, message)
            .here(format!("{} s at {} Hz", number(duration), number(rate)))
            .help(format!("write a shorter `duration`, or a `rate` of {} Hz or less", number(MAX_STEPS / duration)))
    })
}

/// The error of steps that are too coarse for the rotors. A spec with neither `simulate` nor `campaign` is not checked
/// until it is flown.
pub fn coarse_step(model: &Model) -> Option<Diagnostic> {
    coarse(&model.simulation, &model.vehicle)
}

pub(super) fn coarse(simulation: &Simulation, vehicle: &Vehicle) -> Option<Diagnostic> {
    coarse_for(simulation.rate, simulation.control_rate, simulation.rate_span, None, vehicle)
        .or_else(|| coarse_drag(simulation, vehicle))
}

/// Drag slows the vehicle at the rate drag/mass; two steps at least in its time constant, as for rotors.
pub(super) fn coarse_drag(simulation: &Simulation, vehicle: &Vehicle) -> Option<Diagnostic> {
    let slowing = simulation.drag / vehicle.mass;
    (2.0 * slowing > simulation.rate).then(|| {
        let message = format!(
            "a step of {} ms is too coarse for a drag that stops the vehicle in {} ms",
            number(1e3 / simulation.rate),
            number(1e3 / slowing)
        );
        Diagnostic::error("mavc::simulate::coarse_step", simulation.span, message)
            .here(format!("`drag` is {} N*s/m here", number(simulation.drag)))
            .help("look at the `drag`: that of a small multirotor is below 1 N*s/m")
    })
}

/// Two steps at least in the time constant of the fastest rotor: beyond that the integration goes astray. `given` is
/// where the rate is written.
fn coarse_for(rate: f64, control_rate: f64, span: Span, given: Option<Span>, vehicle: &Vehicle) -> Option<Diagnostic> {
    let fastest = vehicle.rotors.iter().min_by(|a, b| a.lag().total_cmp(&b.lag()))?;
    let least = 2.0 / fastest.lag();
    if rate >= least * (1.0 - 1e-9) {
        return None;
    }
    let milliseconds = |seconds: f64| number(seconds * 1e3);
    let lag = milliseconds(fastest.lag());
    let message =
        format!("a step of {} ms is too coarse for a rotor that follows in {lag} ms", milliseconds(1.0 / rate));
    let said = match fastest.time_constant {
        Some(_) => format!("its fastest rotor has a time constant of {lag} ms"),
        None => format!("its rotors follow in {lag} ms, as no `time_constant` is given"),
    };
    // A rate that `control_rate` divides as well, if there is one.
    let enough = (least / control_rate * (1.0 - 1e-9)).ceil().max(1.0) * control_rate;
    let enough = if enough <= MAX_RATE { enough } else { least.ceil() };
    let error = Diagnostic::error("mavc::simulate::coarse_step", span, message)
        .here("longer than half of its time constant")
        .also(vehicle.span, said);
    Some(match enough <= MAX_RATE {
        true => {
            let error = error.help(format!("write `rate = {} Hz` or more", number(enough)));
            match given {
                Some(given) => error.fix(given, format!("{} Hz", number(enough))),
                None => error,
            }
        }
        false => {
            error.help(format!("no rate up to {} kHz is enough: check the `time_constant`", number(MAX_RATE / 1e3)))
        }
    })
}

/// Whether each rate divides the one before, and the steps are fine enough. `given` holds `rate`, `control_rate` and
/// `estimator_rate`, `None` where one has an error.
pub(super) fn rates<'a>(
    cx: &mut Context<'a>,
    fields: &Fields<'a>,
    given: [Option<f64>; 3],
    vehicle: Option<&Vehicle>,
    block: Span,
) -> bool {
    let [rate, control_rate, estimator_rate] = given;
    let mut fine = true;
    let mut report = |cx: &mut Context<'a>, error: Option<Diagnostic>| {
        let found = error.is_some();
        fine &= !found;
        error.into_iter().for_each(|error| cx.report(error));
        found
    };
    let place = |name: &str| fields.get(name).map_or(block, |expr| expr.span);
    let too_fast = rate.filter(|rate| *rate > MAX_RATE).map(|rate| {
        let error = Diagnostic::error(RATES, place("rate"), "`rate` is at most 100 kHz");
        let error = error.here(format!("this is {} kHz", number(rate / 1e3))).help("write `rate = 100 kHz` or less");
        written(fields, "rate", error, "100 kHz".into())
    });
    let mut told = report(cx, too_fast);
    for ((name, least), given) in MIN_RATES.into_iter().zip([control_rate, estimator_rate]) {
        let too_slow = given.filter(|rate| *rate < least).map(|rate| {
            let error = Diagnostic::error(RATES, place(name), format!("`{name}` is at least {} Hz", number(least)));
            let error = error.here(format!("this is {} Hz", number(rate)));
            let mended = format!("{} Hz", number(least));
            written(fields, name, error.help(format!("write `{name} = {mended}` or more")), mended)
        });
        told |= report(cx, too_slow);
    }
    // What `control_rate` is to be, where it has to change.
    let mut undecided = false;
    if let (Some(rate), Some(control_rate), Some(vehicle), false) = (rate, control_rate, vehicle, told) {
        // Its help mends `rate` for `control_rate` too.
        let given = fields.get("rate").map(|expr| expr.span);
        told = report(cx, coarse_for(rate, control_rate, place("rate"), given, vehicle));
    }
    if let (Some(rate), Some(control_rate), false) = (rate, control_rate, told) {
        let error = undivided(cx, fields, ("rate", rate), ("control_rate", control_rate), estimator_rate, block);
        undecided = report(cx, error);
    }
    if let (Some(control_rate), Some(estimator_rate), false) = (control_rate, estimator_rate, undecided) {
        let error =
            undivided(cx, fields, ("control_rate", control_rate), ("estimator_rate", estimator_rate), None, block);
        report(cx, error);
    }
    fine
}

/// With `mended` in the place of what is written for `name`.
fn written(fields: &Fields, name: &str, error: Diagnostic, mended: String) -> Diagnostic {
    match fields.get(name) {
        Some(expr) => error.fix(expr.span, mended),
        None => error,
    }
}

/// The error of a rate that does not divide the faster one it runs in. `slower` is a rate that has to divide `part`.
fn undivided(
    cx: &Context,
    fields: &Fields,
    whole: (&str, f64),
    part: (&str, f64),
    slower: Option<f64>,
    block: Span,
) -> Option<Diagnostic> {
    if divides(part.1, whole.1) {
        return None;
    }
    let message =
        format!("`{}` of {} Hz does not divide `{}` of {} Hz", part.0, number(part.1), whole.0, number(whole.1));
    let (part_given, whole_given) = (fields.get(part.0), fields.get(whole.0));
    let span = |expr: Option<&Expr>| expr.map(|e| e.span);
    let error = Diagnostic::error(RATES, span(part_given.or(whole_given)).unwrap_or(block), message);
    let ratio = format!("{} / {} is {}", number(whole.1), number(part.1), number(whole.1 / part.1));
    let error = error.here(match part.1 > whole.1 {
        true if part_given.is_some() => format!("faster than `{}`", whole.0),
        true => format!("slower than `{}`", part.0),
        false => format!("{ratio}, no whole number"),
    });
    let error = match (part_given, whole_given) {
        (Some(_), Some(whole_given)) => error.also(whole_given.span, "to be divided"),
        _ => error,
    };
    // A part that nobody has written is a round number: the whole is the odd one.
    if let (None, Some(given), true) = (part_given, whole_given, whole.1 > part.1) {
        let mended = format!("{} Hz", number((whole.1 / part.1).round() * part.1));
        let help = format!("write `{} = {mended}`; `{}` is {} Hz by default", whole.0, part.0, number(part.1));
        return Some(error.help(help).fix(given.span, mended));
    }
    let mended = format!("{} Hz", number(nearest_part(part.1, whole.1, slower)));
    Some(match part_given {
        Some(expr) => error.help(format!("write `{} = {mended}`", part.0)).fix(expr.span, mended),
        None => {
            let error = error.help(format!("add `{} = {mended}`, which is {} Hz otherwise", part.0, number(part.1)));
            fields.add(cx, error, &format!("{} = {mended}", part.0))
        }
    })
}

/// Whether `whole` is a whole multiple of `part`, to rounding.
fn divides(part: f64, whole: f64) -> bool {
    let times = whole / part;
    times > 0.5 && (times - times.round()).abs() <= 1e-9 * times
}

/// The rate nearest to `part` that divides `whole` and can be written in a few digits; one that `slower` divides, if
/// there is any near.
fn nearest_part(part: f64, whole: f64, slower: Option<f64>) -> f64 {
    let times = (whole / part).round().max(1.0);
    let written = |times: f64| number(whole / times).parse::<f64>().is_ok_and(|rate| divides(rate, whole));
    let holds = |times: f64| slower.is_none_or(|slower| divides(slower, whole / times));
    let near = || (0..100).flat_map(|d| [times + f64::from(d), times - f64::from(d)]).filter(|times| *times >= 1.0);
    let found = near().find(|times| written(*times) && holds(*times)).or_else(|| near().find(|times| written(*times)));
    found.map_or(whole, |times| whole / times)
}
