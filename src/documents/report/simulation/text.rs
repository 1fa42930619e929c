//! What is said of a simulated flight, on the terminal and the page.

use super::record::{FlightRecord, Flown, OutcomeRecord, SpinRecord};
use crate::flight::damage::{LIMIT_BROKEN, is_judged};
use crate::flight::indistinguishable::listed;
use crate::model::{
    AfterFault, Allocation, Attitude, Controller, Detection, FlownVehicle, Limit, LimitKind, LostYaw, Model, Simulation,
};
use crate::number::{fixed, number, significant};
use std::collections::BTreeSet;

/// The modes that the estimator cannot tell apart along the plan, if there are some.
pub(super) fn indistinguishable(flown: &Flown) -> Option<String> {
    // Each mode of a group was compared with the first.
    let of_group =
        |group: &Vec<&str>| format!("the torques of {} differ little from those of {}", listed(&group[1..]), group[0]);
    let groups: Vec<String> = flown.indistinguishable.iter().map(of_group).collect();
    (!groups.is_empty()).then(|| {
        format!(
            "Throughout the plan {}: by less than the estimator's threshold, so it may take long to \
             tell them apart.",
            groups.join("; ")
        )
    })
}

/// `geometric controller, bounded allocation, capacities estimated; after a fault it continues; 1000 Hz`
pub fn manner(model: &Model) -> String {
    let s = &model.simulation;
    let controller = match s.controller {
        Controller::Pd => "PD controller",
        Controller::Geometric => "geometric controller",
    };
    let allocation = match model.vehicle.allocation {
        Allocation::PseudoInverse => "clipped pseudo-inverse",
        Allocation::Bounded => "bounded allocation",
    };
    let detection = match s.detection {
        Detection::Never => return format!("{controller}, {allocation}, faults never known{}", air_and_rate(model)),
        Detection::After(delay) => format!("faults known after {}", duration(delay)),
        Detection::Estimator => "capacities estimated".to_string(),
    };
    let after = match s.after_fault {
        AfterFault::Continue => "continues",
        AfterFault::Hold => "stops and holds",
        AfterFault::Land => "stops and lands",
        AfterFault::Recovery => "takes a way out",
    };
    format!("{controller}, {allocation}, {detection}; after a fault it {after}{}", air_and_rate(model))
}

/// `; gusts of 2 m/s; the ground is at z = -1 m; 1000 Hz`
fn air_and_rate(model: &Model) -> String {
    let s = &model.simulation;
    let speed = s.wind.iter().map(|w| w * w).sum::<f64>().sqrt();
    let air = match (s.wind.iter().any(|w| *w != 0.0), s.gusts > 0.0) {
        (false, false) => String::new(),
        (true, false) => format!("; steady wind of {} m/s", significant(speed, 3)),
        (true, true) => format!("; wind of {} m/s with gusts of {} m/s", significant(speed, 3), number(s.gusts)),
        (false, true) => format!("; gusts of {} m/s", number(s.gusts)),
    };
    let ground = if s.ground == 0.0 { String::new() } else { format!("; the ground is at z = {} m", number(s.ground)) };
    format!("{air}{}{ground}; {} Hz", disturbed(s), number(s.rate))
}

/// `; torque gusts of 0.1 N m; attitude estimated; vehicle drawn from the intervals`: what differs from the vehicle and
/// the sensors that the controller assumes.
pub fn disturbed(s: &Simulation) -> String {
    let mut parts = Vec::new();
    if s.torque_gusts > 0.0 {
        parts.push(format!("torque gusts of {} N m", number(s.torque_gusts)));
    }
    if s.attitude == Attitude::Estimated {
        parts.push("attitude estimated from the gyroscope".to_string());
    }
    if let Some(assumed) = s.assumed_gyroscope_noise {
        let (noise, assumed) = (number(s.gyroscope_noise), number(assumed));
        parts.push(format!("gyroscope noise of {noise} rad/s, assumed {assumed} rad/s"));
    }
    if s.spread == FlownVehicle::Drawn {
        parts.push("vehicle drawn from the intervals".to_string());
    }
    if s.centre_offset > 0.0 {
        parts.push(format!("centre of gravity off by up to {}", length(s.centre_offset)));
    }
    parts.iter().map(|part| format!("; {part}")).collect()
}

/// `largest tilt 21.5 degrees (limit of the plan: 20)`: the mission's limit applies to the plan and not to the flight.
pub(super) fn tilt(flown: &Flown) -> String {
    let limits = flown.model.mission.iter().flat_map(|mission| &mission.limits);
    let of_all = limits.filter(|limit| limit.is_general() && limit.kind == LimitKind::Tilt);
    let most = of_all.filter_map(|limit| limit.upper).reduce(f64::min);
    let in_plan = most.map_or(String::new(), |most| format!(" (limit of the plan: {})", number(most.to_degrees())));
    format!("largest tilt {} degrees{in_plan}", fixed(flown.flight.max_tilt.to_degrees(), 1))
}

/// `heading error: 1.2 degrees root mean square; largest 4.0 degrees, 4.0 since the first fault`
pub(super) fn heading(record: &FlightRecord) -> String {
    let degrees = |angle: f64| fixed(angle.to_degrees(), 1);
    let after =
        record.max_heading_error_after_rad.map_or(String::new(), |e| format!(", {} since the first fault", degrees(e)));
    format!(
        "heading error: {} degrees root mean square; largest {}{after}{}",
        degrees(record.rms_heading_error_rad),
        degrees(record.max_heading_error_rad),
        turned(record.turns)
    )
}

/// `waypoints: 1 of 4 missed; waypoint 3 by 4.2 cm more than its `within``, of those due after the first fault; `None`
/// if none was due.
pub(super) fn waypoints(record: &FlightRecord) -> Option<String> {
    let (due, missed) = (record.waypoints_due, record.waypoints_missed);
    let since = if record.faults.iter().any(|fault| fault.struck) { " after the first fault" } else { "" };
    (due > 0).then(|| match missed {
        0 => format!("waypoints{since}: {due} of {due} met"),
        _ => format!("waypoints{since}: {missed} of {due} missed{}", worst_miss(record)),
    })
}

/// `; waypoint 3 by 4.2 cm more than its `within``
fn worst_miss(record: &FlightRecord) -> String {
    let most = if record.waypoints_missed > 1 { "worst " } else { "" };
    record.worst_miss.as_ref().map_or(String::new(), |miss| {
        format!("; {most}waypoint {} by {} more than its `within`", miss.waypoint, length(miss.beyond_m))
    })
}

/// `; 8 whole turns away from the planned heading`, if the vehicle turned at all.
pub fn turned(turns: usize) -> String {
    match turns {
        0 => String::new(),
        1 => "; one whole turn away from the planned heading".into(),
        n => format!("; {n} whole turns away from the planned heading"),
    }
}

/// `; no fault simulated`, because such a flight shows nothing about faults, and how to have one.
pub fn no_fault(record: &FlightRecord) -> &'static str {
    match &record.faults[..] {
        [] => "; no fault simulated: add `fault NAME at 5 s` to `simulate`",
        faults if faults.iter().any(|fault| fault.struck) => "",
        _ => "; no fault struck",
    }
}

/// Why a flight in which the vehicle was not lost is not survived.
pub fn trespass(at: f64) -> String {
    format!("from {} s on the vehicle was inside a `keep_out` or outside a `keep_in`", fixed(at, 2))
}

/// The spin in which a flight without yaw ended.
pub(super) fn ending(spin: &SpinRecord, model: &Model) -> String {
    let rate = significant(spin.rate_rad_s, 3);
    let range = significant(model.simulation.gyroscope_range, 3);
    let settled = match (spin.settled, spin.beyond_gyroscope) {
        (true, false) => return format!("the spin settled at {rate} rad/s"),
        (true, true) => "settled at",
        (false, _) => "has not settled: in the end it is",
    };
    let beyond = match spin.beyond_gyroscope {
        true => format!(
            ". The gyroscope measures rates up to {range} rad/s: beyond them the controller may lose the vehicle later."
        ),
        false => ". What the vehicle does later is not known.".to_string(),
    };
    format!("Warning: the spin {settled} {rate} rad/s{beyond}")
}

/// `: waypoints met, no limit exceeded by more than a tenth`: whether a flight met its waypoints and limits, since the
/// first fault if one struck, up to what flights may exceed limits by ([`crate::flight::damage::LIMIT_BROKEN`]); empty
/// if it had neither.
fn met(model: &Model, record: &FlightRecord) -> String {
    let mut parts = Vec::new();
    if record.waypoints_due > 0 {
        parts.push(if record.waypoints_missed == 0 { "waypoints met" } else { "waypoints MISSED" }.to_string());
    }
    if model.mission.as_ref().is_some_and(|mission| !mission.limits.is_empty()) {
        parts.push(match record.limits_broken.is_empty() {
            true => format!("no limit exceeded by more than a tenth{}", wider_tolerances(model)),
            false => "limits BROKEN".into(),
        });
    }
    if parts.is_empty() { String::new() } else { format!(": {}", parts.join(", ")) }
}

/// ` (tilt: 5.7 deg allowed)`: what flights may exceed small limits by, which is more than a tenth of them.
fn wider_tolerances(model: &Model) -> String {
    let limits = model.mission.iter().flat_map(|mission| &mission.limits);
    let is_small = |limit: &&Limit| {
        let bound = limit.lower.into_iter().chain(limit.upper).map(f64::abs).fold(0.0, f64::max);
        is_judged(limit) && !limit.kind.is_of_place() && bound < limit.size()
    };
    let words = |limit: &Limit| {
        let description = limit.kind.describe();
        let most = significant(LIMIT_BROKEN * limit.size() * description.factor(), 2);
        format!("{}: {most} {}", limit.name(), description.unit)
    };
    let all: BTreeSet<String> = limits.filter(is_small).map(words).collect();
    let all: Vec<String> = all.into_iter().collect();
    if all.is_empty() { String::new() } else { format!(" ({} allowed)", all.join(", ")) }
}

/// Which limits were broken; `None` if none was.
pub(super) fn broken(record: &FlightRecord) -> Option<String> {
    let since = if record.faults.iter().any(|fault| fault.struck) { " since the first fault" } else { "" };
    // A landing is below every least altitude.
    let is_landing = matches!(record.outcome, OutcomeRecord::Landed { .. });
    let counted = record.limits_broken.iter().filter(|limit| !is_landing || **limit != "altitude");
    let limits = counted.copied().collect::<Vec<_>>().join(", ");
    if limits.is_empty() {
        return None;
    }
    Some(format!("limits broken{since}: {limits}"))
}

/// `Landed at 40.20 s at [3.1, 2, 0] m, touching down at 0.42 m/s`
pub fn landed(at: f64, place: [f64; 3], speed: f64) -> String {
    // To a centimetre and a centimetre a second.
    let hundredths = |x: f64| number((100.0 * x).round() / 100.0);
    let place = place.map(hundredths).join(", ");
    format!("Landed at {} s at [{place}] m, touching down at {} m/s", fixed(at, 2), hundredths(speed))
}

/// How a flight that was neither lost nor landed has ended, and whether it met its waypoints and limits: a `duration`
/// may end it before its plan does.
pub fn to_its_end(model: &Model, record: &FlightRecord) -> String {
    ended(model, record) + &met(model, record)
}

fn ended(model: &Model, record: &FlightRecord) -> String {
    let end = fixed(record.end_s, 2);
    let tick = 1.0 / model.simulation.control_rate;
    let duration = model.simulation.duration;
    match record.end_s < record.plan_time_s - tick {
        false
            if duration.is_some_and(|duration| record.end_s < duration - tick)
                && (record.end_s - record.plan_time_s).abs() <= tick =>
        {
            format!("Simulated to the end of the plan at {end} s, where it is still in motion")
        }
        true => {
            format!("Simulated for {end} s, the `duration`; the plan continues to {} s", number(record.plan_time_s))
        }
        false => format!("Simulated to its end at {end} s"),
    }
}

/// Why a flight that diverged has no result.
pub const DIVERGED: &str = "the integration broke down (NaN, infinity, or more than half a turn in one step); \
                            what happened to the vehicle is unknown";

/// Why the vehicle counts as lost; `cause` is a name of [`crate::flight::Cause`], `at_end` whether it applied only at
/// the end of the flight.
pub fn loss(model: &Model, cause: &str, at_end: bool) -> String {
    let s = &model.simulation;
    let when = |after: f64| {
        if at_end { "when the flight ended".into() } else { format!("for longer than {} s", number(after)) }
    };
    match cause {
        "ground" => "it hit the ground".into(),
        "heading" => {
            let limit = if let LostYaw::Beyond(limit) = s.lost_yaw { limit } else { 0.0 };
            format!("heading more than {} degrees off {}", number(limit.to_degrees()), when(s.lost_yaw_after))
        }
        "upside_down" => format!("tilted past 90 degrees {}", when(s.upside_down)),
        _ => format!("more than {} m off the plan", number(s.lost_beyond)),
    }
}

/// A length in m as text, in mm or cm if it is short.
pub fn length(metres: f64) -> String {
    match metres {
        m if m < 0.01 => format!("{} mm", significant(1000.0 * m, 2)),
        m if m < 1.0 => format!("{} cm", significant(100.0 * m, 2)),
        m => format!("{} m", significant(m, 3)),
    }
}

/// How a fault becomes known: the spec's word, with the delay (s) if there is one, as in `after 20 ms`.
#[cfg(feature = "report")]
pub fn detection(word: &str, delay: Option<f64>) -> String {
    delay.map_or_else(|| word.to_string(), |delay| format!("{word} {}", duration(delay)))
}

/// A duration in s as text, in ms below 1 s.
pub fn duration(seconds: f64) -> String {
    if seconds < 1.0 {
        format!("{} ms", significant(1000.0 * seconds, 3))
    } else {
        format!("{} s", significant(seconds, 3))
    }
}
