//! Checks that involve several settings: whether the rates divide each other, whether the time step is fine enough and
//! the number of steps is not too large, and whether faults strike before the flight ends.

use crate::diagnostic::Diagnostic;
use crate::model::{Mission, Model, Simulation, Strike, Vehicle};
use crate::number::number;
use crate::read::context::Context;
use crate::read::fields::Fields;
use crate::source::Span;
use crate::syntax::ast::Expr;

/// The highest rate of integration, Hz.
const MAX_RATE: f64 = 100_000.0;
/// The most steps of one flight.
const MAX_STEPS: f64 = 1e8;
/// The lowest rates of controller and estimator, Hz. The state of the flight is examined when the controller acts.
const MIN_RATES: [(&str, f64); 2] = [("control_rate", 10.0), ("estimator_rate", 1.0)];
const RATES: &str = "mavc::simulate::rates";

/// When the flight ends, s, the place that fixes this, and the text of its label.
pub(super) type End = (f64, Span, &'static str);

/// The end of the flight, where the time of the plan or of the last waypoint fixes it.
pub(super) fn fixed_end(plan_time: Option<(f64, Span)>, mission: Option<&Mission>) -> Option<End> {
    if let Some((time, span)) = plan_time {
        return Some((time, span, "the plan takes this time"));
    }
    let last = mission?.waypoints.last()?;
    Some((last.time? + last.hold, last.time_span.unwrap_or(last.span), "the mission ends with this waypoint"))
}

/// The error for `mode`, which strikes at `at` s although the flight ends at `end` s.
pub(super) fn late(mode: &str, at: f64, span: Span, end: f64) -> Diagnostic {
    let message = format!("fault `{mode}` strikes at {} s, but the flight ends at {} s", number(at), number(end));
    Diagnostic::error("mavc::simulate::past_the_end", span, message)
        .here("never strikes")
        .help(format!("write a time before {} s, or extend the flight with a longer `duration`", number(end)))
}

/// The error for `mode`, which recovers at `until` s although the flight ends at `end` s.
pub(super) fn late_recovery(mode: &str, until: f64, span: Span, end: f64) -> Diagnostic {
    let message = format!("fault `{mode}` ends at {} s, but the flight ends at {} s", number(until), number(end));
    Diagnostic::error("mavc::simulate::past_the_end", span, message)
        .here("its rotors never recover")
        .help(format!("write a time up to {} s, or remove `until` for a fault that stays", number(end)))
}

/// Errors for the faults that strike or end after a flight of `end` seconds. This is for plans whose time is known only
/// after planning; a flight with its own `duration` has been checked against that.
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
    let errors = simulation.faults.iter().filter_map(past);
    errors.map(|error| error.also(model.plan.time_span, takes.clone())).collect()
}

/// The error for a flight of `end` seconds that takes too many steps, for plans whose time is known only after
/// planning.
pub fn too_many_steps(model: &Model, end: f64) -> Option<Diagnostic> {
    steps(end, model.simulation.rate, model.simulation.rate_span)
}

/// The error at `span` for more than [`MAX_STEPS`] steps in `duration` seconds.
pub(super) fn steps(duration: f64, rate: f64, span: Span) -> Option<Diagnostic> {
    let steps = duration * rate;
    (steps > MAX_STEPS && rate <= MAX_RATE).then(|| {
        let message = format!("a flight may take at most 100 million steps, not {}", number(steps));
        Diagnostic::error("mavc::simulate::too_many_steps", span, message)
            .here(format!("{} s at {} Hz", number(duration), number(rate)))
            .help(format!("write a shorter `duration`, or a `rate` of {} Hz or less", number(MAX_STEPS / duration)))
    })
}

/// The error for a time step that is too coarse for the rotors or the drag. A spec with neither `simulate` nor
/// `campaign` is not checked until it is flown.
pub fn coarse_step(model: &Model) -> Option<Diagnostic> {
    coarse(&model.simulation, &model.vehicle)
}

pub(super) fn coarse(simulation: &Simulation, vehicle: &Vehicle) -> Option<Diagnostic> {
    coarse_for(simulation.rate, simulation.control_rate, simulation.rate_span, None, vehicle)
        .or_else(|| coarse_drag(simulation, vehicle))
}

/// The error for a time step longer than half the time constant mass/drag with which drag slows the vehicle.
pub(super) fn coarse_drag(simulation: &Simulation, vehicle: &Vehicle) -> Option<Diagnostic> {
    let drag = simulation.largest_drag();
    let slowing = drag / vehicle.mass;
    (2.0 * slowing > simulation.rate).then(|| {
        let message = format!(
            "a time step of {} ms is too coarse for a drag that slows the vehicle with a time constant of {} ms",
            number(1e3 / simulation.rate),
            number(1e3 / slowing)
        );
        Diagnostic::error("mavc::simulate::coarse_step", simulation.span, message)
            .here(format!("`drag` is {} N*s/m here", number(drag)))
            .help("check `drag`: that of a small multirotor is below 1 N*s/m")
    })
}

/// The error for a time step longer than half the time constant of the fastest rotor, with which the integration would
/// be inaccurate. `given` is where the rate is written.
fn coarse_for(rate: f64, control_rate: f64, span: Span, given: Option<Span>, vehicle: &Vehicle) -> Option<Diagnostic> {
    let fastest = vehicle.rotors.iter().min_by(|a, b| a.lag().total_cmp(&b.lag()))?;
    let least = 2.0 / fastest.lag();
    if rate >= least * (1.0 - 1e-9) {
        return None;
    }
    let milliseconds = |seconds: f64| number(seconds * 1e3);
    let lag = milliseconds(fastest.lag());
    let message = format!(
        "a time step of {} ms is too coarse for a rotor with a time constant of {lag} ms",
        milliseconds(1.0 / rate)
    );
    let said = match fastest.time_constant {
        Some(_) => format!("its fastest rotor has a time constant of {lag} ms"),
        None => format!("its rotors have the default `time_constant` of {lag} ms"),
    };
    // Preferably a multiple of `control_rate`.
    let enough = (least / control_rate * (1.0 - 1e-9)).ceil().max(1.0) * control_rate;
    let enough = if enough <= MAX_RATE { enough } else { least.ceil() };
    let error = Diagnostic::error("mavc::simulate::coarse_step", span, message)
        .here("longer than half the time constant")
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
            error.help(format!("check the `time_constant`: no rate up to {} kHz suffices", number(MAX_RATE / 1e3)))
        }
    })
}

/// Whether each rate divides the one before it and the time step is fine enough; reports errors otherwise. `given`
/// holds `rate`, `control_rate` and `estimator_rate`, `None` where one has an error.
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
        let error = Diagnostic::error(RATES, place("rate"), "`rate` must be at most 100 kHz");
        let error = error.here(format!("this is {} kHz", number(rate / 1e3))).help("write `rate = 100 kHz` or less");
        written(fields, "rate", error, "100 kHz".into())
    });
    let mut reported = report(cx, too_fast);
    for ((name, least), given) in MIN_RATES.into_iter().zip([control_rate, estimator_rate]) {
        let too_slow = given.filter(|rate| *rate < least).map(|rate| {
            let error =
                Diagnostic::error(RATES, place(name), format!("`{name}` must be at least {} Hz", number(least)));
            let error = error.here(format!("this is {} Hz", number(rate)));
            let corrected = format!("{} Hz", number(least));
            written(fields, name, error.help(format!("write `{name} = {corrected}` or more")), corrected)
        });
        reported |= report(cx, too_slow);
    }
    // Whether `control_rate` has to change, so that the estimator's rate cannot be checked against it.
    let mut undecided = false;
    if let (Some(rate), Some(control_rate), Some(vehicle), false) = (rate, control_rate, vehicle, reported) {
        // The suggested `rate` is a multiple of `control_rate` too.
        let given = fields.get("rate").map(|expr| expr.span);
        reported = report(cx, coarse_for(rate, control_rate, place("rate"), given, vehicle));
    }
    let rate = rate.map(|hz| Rate { name: "rate", hz });
    let controls = control_rate.map(|hz| Rate { name: "control_rate", hz });
    let estimates = estimator_rate.map(|hz| Rate { name: "estimator_rate", hz });
    if let (Some(rate), Some(controls), false) = (&rate, &controls, reported) {
        let error = undivided(cx, fields, rate, controls, estimator_rate, block);
        undecided = report(cx, error);
    }
    if let (Some(controls), Some(estimates), false) = (&controls, &estimates, undecided) {
        let error = undivided(cx, fields, controls, estimates, None, block);
        report(cx, error);
    }
    fine
}

/// The error with a fix that replaces the value of `name` by `corrected`, if it is written.
fn written(fields: &Fields, name: &str, error: Diagnostic, corrected: String) -> Diagnostic {
    match fields.get(name) {
        Some(expr) => error.fix(expr.span, corrected),
        None => error,
    }
}

/// A rate with its field.
struct Rate {
    name: &'static str,
    hz: f64,
}

/// The error for a rate `part` that does not divide the faster rate `whole`. `slower` is a rate that must divide
/// `part`.
fn undivided(
    cx: &Context,
    fields: &Fields,
    whole: &Rate,
    part: &Rate,
    slower: Option<f64>,
    block: Span,
) -> Option<Diagnostic> {
    if divides(part.hz, whole.hz) {
        return None;
    }
    let message = format!(
        "`{}` of {} Hz does not divide `{}` of {} Hz",
        part.name,
        number(part.hz),
        whole.name,
        number(whole.hz)
    );
    let (part_given, whole_given) = (fields.get(part.name), fields.get(whole.name));
    let span = |expr: Option<&Expr>| expr.map(|e| e.span);
    let error = Diagnostic::error(RATES, span(part_given.or(whole_given)).unwrap_or(block), message);
    let ratio = format!("{} / {} is {}", number(whole.hz), number(part.hz), number(whole.hz / part.hz));
    let error = error.here(match part.hz > whole.hz {
        true if part_given.is_some() => format!("faster than `{}`", whole.name),
        true => format!("slower than `{}`", part.name),
        false => format!("{ratio}, not a whole number"),
    });
    let error = match (part_given, whole_given) {
        (Some(_), Some(whole_given)) => error.also(whole_given.span, "must be a whole multiple"),
        _ => error,
    };
    // Where `part` is the default, a round number, `whole` is the one to change.
    if let (None, Some(given), true) = (part_given, whole_given, whole.hz > part.hz) {
        let corrected = format!("{} Hz", number((whole.hz / part.hz).round() * part.hz));
        let help =
            format!("write `{} = {corrected}`; `{}` is {} Hz by default", whole.name, part.name, number(part.hz));
        return Some(error.help(help).fix(given.span, corrected));
    }
    let corrected = format!("{} Hz", number(nearest_part(part.hz, whole.hz, slower)));
    Some(match part_given {
        Some(expr) => error.help(format!("write `{} = {corrected}`", part.name)).fix(expr.span, corrected),
        None => {
            let error = error.help(format!("add `{} = {corrected}`; the default is {} Hz", part.name, number(part.hz)));
            fields.add(cx, error, &format!("{} = {corrected}", part.name))
        }
    })
}

/// Whether `whole` is a whole multiple of `part`, up to rounding.
fn divides(part: f64, whole: f64) -> bool {
    let times = whole / part;
    times > 0.5 && (times - times.round()).abs() <= 1e-9 * times
}

/// The rate nearest to `part` that divides `whole` and can be written in few digits, preferably one that `slower`
/// divides.
fn nearest_part(part: f64, whole: f64, slower: Option<f64>) -> f64 {
    let times = (whole / part).round().max(1.0);
    let written = |times: f64| number(whole / times).parse::<f64>().is_ok_and(|rate| divides(rate, whole));
    let holds = |times: f64| slower.is_none_or(|slower| divides(slower, whole / times));
    let near = || (0..100).flat_map(|d| [times + f64::from(d), times - f64::from(d)]).filter(|times| *times >= 1.0);
    let found = near().find(|times| written(*times) && holds(*times)).or_else(|| near().find(|times| written(*times)));
    found.map_or(whole, |times| whole / times)
}
