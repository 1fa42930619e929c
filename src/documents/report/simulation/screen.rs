//! The short output of `mavc simulate`: how the flight ended, and what happened to it.

use super::record::{FlightRecord, Flown, OutcomeRecord, WayOutRecord};
use super::text::{
    DIVERGED, beyond_plan, ending, fault_table, heading, indistinguishable, length, loss, manner, no_fault, to_its_end,
    trespass,
};
use crate::admissible::outcome::Outcome;
use crate::flight::equilibrium::outcome_of;
use crate::model::FaultMode;
use crate::number::{fixed, number, plural, significant};
use crate::report::screen::{Keep, Screen, Tone};
use crate::report::terminal::vehicle_line;
use crate::report::volumes::VolumeRecord;
use std::cmp::Reverse;

/// Most faults in the table.
const MOST_FAULTS: usize = 6;

/// The output.
pub fn screen(flown: &Flown) -> Screen {
    let record = FlightRecord::new(flown, String::new());
    let Flown { model, solved, flight, .. } = flown;
    let mut screen = Screen::default();
    let mission = model.mission.as_ref().map_or("", |m| m.name.as_str());
    screen.paragraph(
        Tone::Plain,
        0,
        2,
        &format!(
            "{mission} with {}, along the {} ({}) plan of {} s",
            vehicle_line(model),
            record.planner.to_uppercase(),
            model.plan.planner.in_full(),
            number(solved.time)
        ),
    );
    screen.gap();
    let (tone, ended) = match record.outcome {
        OutcomeRecord::Flown => (Tone::Good, format!("{}{}", to_its_end(model, &record), no_fault(&record))),
        OutcomeRecord::Landed { at_s } => (Tone::Good, format!("Landed at {} s", fixed(at_s, 2))),
        OutcomeRecord::Trespassed { at_s } => (Tone::Bad, format!("NOT SURVIVED: {}", trespass(at_s))),
        OutcomeRecord::Lost { at_s, cause, at_end } => {
            let struck = record.faults.iter().any(|fault| fault.struck);
            let without = if struck { "" } else { ", without a fault" };
            (Tone::Bad, format!("LOST at {} s{without}: {}", fixed(at_s, 2), loss(model, cause, at_end)))
        }
        OutcomeRecord::Diverged { at_s } => (Tone::Bad, format!("DIVERGED at {} s: {DIVERGED}", fixed(at_s, 2))),
    };
    screen.paragraph(tone, 2, 2, &ended);
    faults(&mut screen, &record);
    screen.gap();
    let after = record.rms_error_after_m.map_or(String::new(), |e| format!(", {} since the first fault", length(e)));
    let mut lines = vec![
        format!("position error: {} rms{after}; largest {}", length(flight.rms_error), length(flight.max_error)),
        heading(&record).replace("root mean square", "rms"),
        format!("largest tilt {} degrees{}", fixed(flight.max_tilt.to_degrees(), 1), beyond_plan(flown)),
    ];
    lines.extend(
        record
            .gave_up_yaw_at_s
            .map(|at| format!("yaw given up at {} s; from then on no heading error counts as a loss", fixed(at, 2))),
    );
    lines.extend(record.way_out.as_ref().map(WayOutRecord::words));
    lines.extend(record.regressor.as_ref().map(|_| {
        let refused = match record.refused_reconfigurations {
            0 => String::new(),
            n => format!("; {} refused, with which the vehicle could not hover", plural(n, "estimate")),
        };
        format!("estimator: {}{refused}", plural(record.false_alarms, "false alarm"))
    }));
    let spare = |volume: &&VolumeRecord| volume.distance_m;
    lines.extend(record.volumes.iter().min_by(|a, b| spare(a).total_cmp(&spare(b))).map(|nearest| {
        format!(
            "nearest volume: {} m from {} at {} s ({} m required of the plan)",
            significant(nearest.distance_m, 3),
            nearest.name,
            fixed(nearest.at_s, 2),
            significant(nearest.required_m, 3)
        )
    }));
    lines.push(manner(model));
    lines.iter().for_each(|line| screen.paragraph(Tone::Plain, 2, 2, line));
    remarks(flown, &record).iter().for_each(|(keep, text)| screen.remark(*keep, text));
    screen.close(0);
    screen
}

/// When each fault struck and became known.
fn faults(screen: &mut Screen, record: &FlightRecord) {
    if record.faults.is_empty() {
        return;
    }
    screen.gap();
    screen.table(&fault_table(&record.faults[..record.faults.len().min(MOST_FAULTS)]));
    if record.faults.len() > MOST_FAULTS {
        screen.line(Tone::Plain, &format!("  and {} more, -v", record.faults.len() - MOST_FAULTS));
    }
}

/// The remarks, those first that a reader must not overlook.
fn remarks(flown: &Flown, record: &FlightRecord) -> Vec<(Keep, String)> {
    let model = flown.model;
    let mut all = Vec::new();
    let spin = record.gave_up_yaw_at_s.and(record.spin.as_ref());
    all.extend(spin.map(|spin| ending(spin, model).trim_start_matches("Warning: ").to_string()));
    if let Some(seconds) = record.gyroscope_saturated_s {
        all.push(format!(
            "a body rate was beyond the {} deg/s that the gyroscope measures for {} s",
            number(model.simulation.gyroscope_range.to_degrees()),
            fixed(seconds, 2)
        ));
    }
    if record.gave_up_yaw_at_s.is_some() && model.vehicle.yaw_drag.is_none() {
        all.push("the vehicle has no `yaw_drag`: no air slows its spin".into());
    }
    let gave_up = record.gave_up_yaw_at_s.unwrap_or(f64::INFINITY);
    if matches!(record.outcome, OutcomeRecord::Lost { cause: "position", at_s, .. } if at_s > gave_up) {
        let is_struck = |of: &FaultMode| record.faults.iter().any(|fault| fault.struck && fault.mode == of.name);
        let mut struck = (0..model.modes.len()).filter(|&mode| is_struck(&model.modes[mode])).peekable();
        let is_some = struck.peek().is_some();
        all.push(match is_some && struck.all(|mode| outcome_of(model, mode) == Outcome::FliesOn) {
            true => "a balance without yaw is left (`mavc analyze`), but this flight did not come to it: a shorter \
                     `detection` or slower flight may help"
                .into(),
            false => format!(
                "a vehicle falls before its spin catches it (`mavc analyze --capture`); with a larger `lost_beyond` \
                 than {} m the fall does not count as a loss",
                number(model.simulation.lost_beyond)
            ),
        });
    }
    all.extend(indistinguishable(flown));
    let of_plan = record.warnings.iter().map(|caveat| (caveat.kind.keep(), caveat.message.clone()));
    let mut all: Vec<(Keep, String)> = all.into_iter().map(|text| (Keep::Finding, text)).chain(of_plan).collect();
    all.sort_by_key(|(keep, _)| Reverse(*keep));
    all
}
