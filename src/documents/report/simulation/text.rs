//! Terminal text of a simulated flight.

use super::record::{FaultRecord, FlightRecord, Flown, OutcomeRecord, SpinRecord};
use crate::flight::indistinguishable::listed;
use crate::model::{
    AfterFault, Allocation, Attitude, Controller, Detection, FlownVehicle, LimitKind, LostYaw, Model, Simulation,
};
use crate::number::{fixed, number, significant};
use crate::report::battery;
use crate::report::terminal::vehicle_line;
use crate::report::volumes::table;
use crate::text_table::{Table, indented};
use crate::verdict::SIMULATED;

/// The output of `mavc simulate`.
pub fn text(flown: &Flown) -> String {
    let record = FlightRecord::new(flown, String::new());
    let Flown { model, solved, flight, .. } = flown;
    let name = model.mission.as_ref().map_or("", |m| m.name.as_str());
    let mut out = format!(
        "Mission {name} {SIMULATED} with {}\nalong the {} plan of {} s\n{}\n{}\n",
        vehicle_line(model),
        record.planner.to_uppercase(),
        number(solved.time),
        manner(model),
        battery::full_thrust(model)
    );
    out.push_str(&match record.outcome {
        OutcomeRecord::Flown => format!("{}{}\n", to_its_end(model, &record), no_fault(&record)),
        OutcomeRecord::Trespassed { at_s } => format!("NOT SURVIVED: {}\n", trespass(at_s)),
        OutcomeRecord::Landed { at_s } => format!("Landed at {} s\n", fixed(at_s, 2)),
        OutcomeRecord::Lost { at_s, cause, at_end } => {
            format!("LOST at {} s: {}\n", fixed(at_s, 2), loss(model, cause, at_end))
        }
        OutcomeRecord::Diverged { at_s } => format!("DIVERGED at {} s: {DIVERGED}\n", fixed(at_s, 2)),
    });
    let after = record.rms_error_after_m.map_or(String::new(), |e| format!(", {} since the first fault", length(e)));
    out.push_str(&format!(
        "  position error: {} root mean square{after}; largest {}\n  {}\n  largest tilt {} degrees\n",
        length(flight.rms_error),
        length(flight.max_error),
        heading(&record),
        fixed(flight.max_tilt.to_degrees(), 1)
    ));
    out.pop();
    out.push_str(&beyond_plan(flown));
    out.push('\n');
    if let Some(seconds) = record.gyroscope_saturated_s {
        let range = number(model.simulation.gyroscope_range.to_degrees());
        out.push_str(&format!(
            "  a body rate was beyond the {range} deg/s that the gyroscope measures for {} s\n",
            fixed(seconds, 2)
        ));
    }
    out.push_str(&record.way_out.as_ref().map_or(String::new(), |way| format!("  {}\n", way.words())));
    if let Some(at) = record.gave_up_yaw_at_s {
        out.push_str(&format!("  yaw given up at {} s: the heading no longer counts as a loss\n", fixed(at, 2)));
        out.push_str(&record.spin.as_ref().map_or(String::new(), |spin| indented(&ending(spin, model))));
        if model.vehicle.yaw_drag.is_none() {
            out.push_str("  the vehicle has no `yaw_drag`, so that the air does not slow its spin\n");
        }
        if matches!(record.outcome, OutcomeRecord::Lost { cause: "position", at_s, .. } if at_s > at) {
            out.push_str(&format!(
                "  a vehicle falls before it is caught by its spin (`mavc analyze --capture`): with a `lost_beyond` \
                 above that\n  height, here {} m, it does not count as lost for it\n",
                number(model.simulation.lost_beyond)
            ));
        }
    }
    if !record.faults.is_empty() {
        out.push('\n');
        out.push_str(&fault_table(&record.faults).render(2));
    }
    out.push_str(&table(&record.volumes, model, " in the flight"));
    if let Some(r) = &record.regressor {
        let alarms = match record.false_alarms {
            0 => "no false alarm".to_string(),
            1 => "1 false alarm".to_string(),
            n => format!("{n} false alarms"),
        };
        let refused = match record.refused_reconfigurations {
            0 => String::new(),
            1 => "; 1 estimate refused, under which the vehicle could not hover".to_string(),
            n => format!("; {n} estimates refused, under which the vehicle could not hover"),
        };
        out.push_str(&format!(
            "\nEstimator: {alarms}{refused}\n  rank of the regressor between {} and {} of {}; median condition number \
             {}\n",
            r.lowest_rank,
            r.highest_rank,
            r.rotors,
            significant(r.median_condition, 3)
        ));
    }
    let fill = |text: &str| format!("\n{}", indented(text));
    indistinguishable(flown).iter().for_each(|text| out.push_str(&fill(text)));
    record.warnings.iter().for_each(|caveat| out.push_str(&fill(&caveat.message)));
    out
}

/// A table of faults, a row each: when it struck, and when it was known.
pub(super) fn fault_table(faults: &[FaultRecord]) -> Table {
    let mut table = Table::new(&["fault", "struck", "ends", "detected", "isolated"]);
    let after = |t: Option<f64>| t.map_or("never".into(), |t| format!("after {}", duration(t)));
    for fault in faults {
        let mut row = vec![fault.mode.clone(), format!("{} s", number(fault.at_s))];
        row.push(fault.until_s.map_or("never".into(), |t| format!("{} s", number(t))));
        match fault.struck {
            true => row.extend([after(fault.detected_after_s), after(fault.isolated_after_s)]),
            false => row.push("not struck".to_string()),
        }
        table.row(row);
    }
    table
}

/// The modes that the estimator cannot tell apart along the plan, if there are some.
pub(super) fn indistinguishable(flown: &Flown) -> Option<String> {
    // Each mode of a group was compared with the first.
    let of_group =
        |group: &Vec<&str>| format!("the torques of {} differ little from those of {}", listed(&group[1..]), group[0]);
    let groups: Vec<String> = flown.indistinguishable.iter().map(of_group).collect();
    (!groups.is_empty()).then(|| {
        format!(
            "Throughout the plan {}: by less than the estimator's threshold for one sample, so it may take long to \
             tell them apart.",
            groups.join("; ")
        )
    })
}

/// `geometric controller, bounded allocation, capacities estimated; after a fault it continues; 1000 Hz, seed 1`
pub(super) fn manner(model: &Model) -> String {
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

/// `; gusts of 2 m/s; the ground is at z = -1 m; 1000 Hz, seed 1`
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
    format!("{air}{}{ground}; {} Hz, seed {}", disturbed(s), number(s.rate), s.seed)
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

/// `, beyond the plan's limit of 20 degrees`: the mission's limit applies to the plan and not to the flight.
pub(super) fn beyond_plan(flown: &Flown) -> String {
    let limits = flown.model.mission.iter().flat_map(|mission| &mission.limits);
    let tilt =
        limits.filter(|limit| limit.is_general() && limit.kind == LimitKind::Tilt).filter_map(|limit| limit.upper);
    match tilt.filter(|most| flown.flight.max_tilt > *most).reduce(f64::min) {
        Some(most) => format!(", beyond the plan's limit of {} degrees", number(most.to_degrees())),
        None => String::new(),
    }
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

/// `; 8 whole turns away from the planned heading`, if the vehicle turned at all.
pub fn turned(turns: usize) -> String {
    match turns {
        0 => String::new(),
        1 => "; one whole turn away from the planned heading".into(),
        n => format!("; {n} whole turns away from the planned heading"),
    }
}

/// `; no fault struck`, because such a flight shows nothing about faults, and how to have one strike.
pub fn no_fault(record: &FlightRecord) -> &'static str {
    match &record.faults[..] {
        [] => "; no fault struck: `fault NAME at 5 s` in `simulate` lets one",
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

/// How a flight that was neither lost nor landed has ended: a `duration` may end it before its plan does.
pub fn to_its_end(model: &Model, record: &FlightRecord) -> String {
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
