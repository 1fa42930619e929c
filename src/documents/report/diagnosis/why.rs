//! Why a flight with losses ended as it did, in one sentence: what the sets say that the remaining rotors could not
//! hold, and what the log shows. It says no more than the two, and says so where they do not explain the end.

use super::Diagnosis;
use crate::admissible::outcome::Outcome;
use crate::admissible::verdict::ModeAnalysis;
use crate::diagnosis::aftermath::Aftermath;
use crate::diagnosis::ending::End;
use crate::diagnosis::study::{Kind, Loss};
use crate::number::fixed;

/// A yaw torque below this share of that of the other direction is none (chosen by hand: the hover share of a log is
/// not known better).
const NONE: f64 = 0.02;

/// The sentence; `None` without a loss in a flight.
pub fn why(diagnosis: &Diagnosis) -> Option<String> {
    let aftermath = diagnosis.aftermath.as_ref()?;
    let after = diagnosis.after.get(aftermath.losses.end - 1)?;
    let losses = &diagnosis.losses()[aftermath.losses.clone()];
    let missing = Missing::of(after);
    let is_unexplained = after.outcome == Outcome::FullControl && matches!(aftermath.end, End::Impact(_));
    let not = if is_unexplained { ", so that the losses alone do not explain the end" } else { "" };
    Some(format!(
        "{} the other motors {}{}{}{not}; {}{}",
        state(losses),
        can(after, missing),
        later(diagnosis, aftermath, after),
        hover(diagnosis),
        log(aftermath, missing),
        end(aftermath)
    ))
}

/// What a loss after the turn had begun left, where that is no hover at all or one without a margin.
fn later(diagnosis: &Diagnosis, aftermath: &Aftermath, after: &ModeAnalysis) -> String {
    let worse = diagnosis.after.get(aftermath.last).filter(|last| last.outcome != after.outcome);
    let what = worse.and_then(|last| match last.outcome {
        Outcome::Lost => Some("cannot hold the vehicle at all"),
        Outcome::NoMargin => Some("balance weight and torques exactly and no more"),
        _ => None,
    });
    let time = fixed(diagnosis.losses()[aftermath.last].time, 1);
    what.map_or(String::new(), |what| format!(", and after a further loss at {time} s {what}"))
}

/// `without motors 1 and 4`, `with motor 2 at 40 % of its thrust`: the last state of each motor.
fn state(losses: &[Loss]) -> String {
    let last: Vec<&Loss> = (0..losses.len())
        .filter(|&k| losses[k + 1..].iter().all(|later| later.motor != losses[k].motor))
        .map(|k| &losses[k])
        .collect();
    let named = |loss: &Loss| {
        let numbers = std::iter::once(&loss.motor).chain(&loss.alternatives);
        numbers.map(|k| (k + 1).to_string()).collect::<Vec<_>>().join(" or ")
    };
    let is_gone = |loss: &&&Loss| matches!(loss.kind, Kind::Lost | Kind::Off);
    let gone: Vec<String> = last.iter().filter(is_gone).map(|loss| named(loss)).collect();
    let gone = match gone.len() {
        0 => None,
        1 => Some(format!("without motor {}", gone[0])),
        _ => Some(format!("without motors {}", gone.join(" and "))),
    };
    let percent = |share: f64| fixed(100.0 * share, 0);
    let weak = last.iter().filter(|loss| !is_gone(loss)).map(|loss| match loss.kind {
        Kind::Held => format!("with motor {} held at {} % of full thrust", named(loss), percent(loss.capacity)),
        _ => format!("with motor {} at {} % of its thrust", named(loss), percent(loss.capacity)),
    });
    gone.into_iter().chain(weak).collect::<Vec<_>>().join(" and ")
}

/// The yaw torque that hover lacks.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Missing {
    /// That against a turn: 1 for a counter-clockwise one seen from above, -1 for a clockwise one.
    Against(f64),
    /// Any.
    All,
    /// The set does not say.
    Unknown,
}

impl Missing {
    fn of(after: &ModeAnalysis) -> Self {
        let Some(free) = &after.without_yaw else { return Missing::Unknown };
        let [low, high] = free.yaw_torque_n_m;
        let size = low.abs().max(high.abs());
        match (low >= -NONE * size, high <= NONE * size) {
            (true, false) => Missing::Against(1.0),
            (false, true) => Missing::Against(-1.0),
            (true, true) => Missing::All,
            (false, false) => Missing::Unknown,
        }
    }
}

fn way(sign: f64) -> &'static str {
    if sign > 0.0 { "counter-clockwise" } else { "clockwise" }
}

/// What the remaining motors can do in hover, from their set.
fn can(after: &ModeAnalysis, missing: Missing) -> String {
    let yaw = || match missing {
        Missing::Against(sign) => format!("have no yaw torque against a {} turn", way(sign)),
        Missing::All => "have no yaw torque to spare".to_string(),
        Missing::Unknown => "cannot hold the heading".to_string(),
    };
    match after.outcome {
        Outcome::FullControl => "can hold height, attitude and heading".into(),
        Outcome::FliesOn => format!("can hold height, roll and pitch, but {}", yaw()),
        Outcome::Caught | Outcome::Undecided => {
            format!("{} and hold roll or pitch one way only, unless the vehicle spins", yaw())
        }
        Outcome::NoMargin => {
            "balance weight and torques exactly and no more: no controller can hold the attitude against a disturbance"
                .into()
        }
        Outcome::Lost => {
            let [thrust, roll, pitch] = after.residual3;
            let is_of_torques = roll.hypot(pitch) > 0.0 && thrust.abs() < 1e-6 * after.capacity.len() as f64;
            match is_of_torques {
                true => "cannot balance roll and pitch while they carry the weight".into(),
                false => "cannot carry the weight with roll and pitch in balance".into(),
            }
        }
    }
}

/// ` (hover takes 42 % of full thrust)`: what is left depends on the load.
fn hover(diagnosis: &Diagnosis) -> String {
    match diagnosis.study.as_ref().and_then(|study| study.hover) {
        Some(share) => format!(" (hover takes {} % of full thrust)", fixed(100.0 * share, 0)),
        None => " (the log does not show the thrust in hover; assumed: half)".into(),
    }
}

/// What the log shows from the first loss to the end of the flight.
fn log(aftermath: &Aftermath, missing: Missing) -> String {
    let degrees = |angle: f64| fixed(angle.to_degrees(), 0);
    let mut shown = Vec::new();
    if let Some(rate) = aftermath.yaw_rate {
        let turn = aftermath.fast_from.map_or("no fast turn".to_string(), |(from, sign)| {
            let which = if missing == Missing::Against(sign) { "that way" } else { way(sign) };
            format!("a fast turn {which} from {} s on", fixed(from, 1))
        });
        shown.push(format!("{turn} (yaw up to {} deg/s)", degrees(rate)));
    }
    match (aftermath.off, aftermath.tilt) {
        (Some(off), _) => shown.push(format!("an attitude up to {} deg off the commanded one", degrees(off))),
        (None, Some(tilt)) => shown.push(format!("a tilt of up to {} deg", degrees(tilt))),
        (None, None) => {}
    }
    match shown.is_empty() {
        true => "the log has neither rates of turn nor attitudes after it".into(),
        false => format!("the log shows {}", shown.join(" and ")),
    }
}

fn end(aftermath: &Aftermath) -> String {
    let seconds = aftermath.to - aftermath.from;
    match aftermath.end {
        End::Impact(speed) => {
            let speed = speed.map_or(String::new(), |speed| format!(" at {}", speeds(speed)));
            format!(", then the impact{speed}, {} s after the first loss", fixed(seconds, 1))
        }
        End::Landed => format!(", and the vehicle in the air for {} s after the first loss", fixed(seconds, 0)),
        End::Open => {
            format!(", and the vehicle in the air until the log ends, {} s after the first loss", fixed(seconds, 0))
        }
    }
}

/// `14 to 18 m/s`, or one number if both are the same.
pub(super) fn speeds(ends: [f64; 2]) -> String {
    let [least, most] = ends.map(|v| fixed(v, 0));
    if least == most { format!("{least} m/s") } else { format!("{least} to {most} m/s") }
}
