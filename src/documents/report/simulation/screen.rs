//! The output of `mavc simulate`: how the flight ended, and what happened to it.

use super::record::{FaultRecord, FlightRecord, Flown, OutcomeRecord, SpinRecord, WayOutRecord};
use super::text::{
    DIVERGED, broken, duration, ending, heading, indistinguishable, landed, length, loss, manner, no_fault, tilt,
    to_its_end, trespass, waypoints,
};
use crate::admissible::outcome::Outcome;
use crate::flight::equilibrium::outcome_of;
use crate::model::{FaultMode, LandingSite, Model, Strike};
use crate::number::{fixed, number, plural, significant};
use crate::report::battery;
use crate::report::plan_screen::unsafe_until;
use crate::report::screen::{Keep, Screen, Tone};
use crate::report::terminal::vehicle_line;
use crate::report::volumes::{self, VolumeRecord};
use crate::text_table::Table;
use std::cmp::Reverse;

/// Most faults in the table.
const MOST_FAULTS: usize = 6;

/// The output; `verbose` shows all faults, volumes and remarks, and the estimator's regressor.
pub fn screen(flown: &Flown, verbose: bool) -> Screen {
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
        OutcomeRecord::Flown => {
            let is_met = record.waypoints_missed == 0 && record.limits_broken.is_empty();
            let tone = if is_met { Tone::Good } else { Tone::Warning };
            (tone, format!("{}{}", to_its_end(model, &record), no_fault(&record)))
        }
        OutcomeRecord::Landed { at_s, place_m, speed_m_s } => (Tone::Good, landed(at_s, place_m, speed_m_s)),
        OutcomeRecord::Trespassed { at_s } => (Tone::Bad, format!("NOT SURVIVED: {}", trespass(at_s))),
        OutcomeRecord::Lost { at_s, cause, at_end } => {
            let struck = record.faults.iter().any(|fault| fault.struck);
            let without = if struck { "" } else { ", without a fault" };
            (Tone::Bad, format!("LOST at {} s{without}: {}", fixed(at_s, 2), loss(model, cause, at_end)))
        }
        OutcomeRecord::Diverged { at_s } => (Tone::Bad, format!("DIVERGED at {} s: {DIVERGED}", fixed(at_s, 2))),
    };
    screen.paragraph(tone, 2, 2, &ended);
    faults(&mut screen, &record, if verbose { usize::MAX } else { MOST_FAULTS });
    screen.gap();
    let after = record.rms_error_after_m.map_or(String::new(), |e| format!(", {} since the first fault", length(e)));
    let is_lost = matches!(record.outcome, OutcomeRecord::Lost { .. } | OutcomeRecord::Diverged { .. });
    // What the plan promises and the flight did not keep is a remark.
    let mut unkept = Vec::new();
    let mut lines = Vec::new();
    if let Some(text) = waypoints(&record).filter(|_| !is_lost) {
        if record.waypoints_missed > 0 { &mut unkept } else { &mut lines }.push(text);
    }
    lines.extend([
        format!("position error: {} rms{after}; largest {}", length(flight.rms_error), length(flight.max_error)),
        heading(&record).replace("root mean square", "rms"),
    ]);
    lines.push(tilt(flown));
    unkept.extend(broken(&record).filter(|_| !is_lost));
    lines.extend(
        record
            .gave_up_yaw_at_s
            .map(|at| format!("yaw given up at {} s; from then on no heading error counts as a loss", fixed(at, 2))),
    );
    lines.extend(record.way_out.as_ref().map(WayOutRecord::words));
    lines.extend(spin(&record).filter(|spin| is_calm(spin)).map(|spin| ending(spin, model)));
    lines.extend(record.regressor.as_ref().map(|regressor| {
        let refused = match record.refused_reconfigurations {
            0 => String::new(),
            n => format!("; {} refused, with which the vehicle could not hover", plural(n, "estimate")),
        };
        let alarms = format!("estimator: {}{refused}", plural(record.false_alarms, "false alarm"));
        match verbose {
            true => format!("{alarms}; {}", regressor.words()),
            false => alarms,
        }
    }));
    let spare = |volume: &&VolumeRecord| volume.distance_m;
    lines.extend(record.volumes.iter().min_by(|a, b| spare(a).total_cmp(&spare(b))).filter(|_| !verbose).map(
        |nearest| {
            format!(
                "nearest volume: {} `{}` at {} s ({} m required of the plan)",
                beside_boundary(nearest.distance_m),
                nearest.name,
                fixed(nearest.at_s, 2),
                significant(nearest.required_m, 3)
            )
        },
    ));
    lines.push(format!("{}, seed {}", manner(model), record.seed));
    lines.extend(Some(battery::full_thrust(model)).filter(|text| verbose && !text.is_empty()));
    lines.iter().for_each(|line| screen.paragraph(Tone::Plain, 2, 2, line));
    unkept.iter().for_each(|text| screen.remark(Keep::Finding, text));
    remarks(flown, &record).iter().for_each(|(keep, text)| screen.remark(*keep, text));
    match verbose {
        true => volumes::table(&record.volumes, model, " in the flight")
            .lines()
            .for_each(|line| screen.line(Tone::Plain, line)),
        false => screen.close(),
    }
    screen
}

/// `1.2 m from`, or `3.7 cm past the boundary of`.
fn beside_boundary(distance: f64) -> String {
    let past = if distance < 0.0 { "past the boundary of" } else { "from" };
    format!("{} {past}", length(distance.abs()))
}

/// When each of at most so many faults struck and became known.
fn faults(screen: &mut Screen, record: &FlightRecord, most: usize) {
    if record.faults.is_empty() {
        return;
    }
    let seconds = |t: f64| format!("{} s", number(t));
    let after = |t: Option<f64>| t.map_or("never".into(), |t| format!("after {}", duration(t)));
    let some_end = record.faults.iter().any(|fault| fault.until_s.is_some());
    let headings = ["fault", "struck", "ends", "detected", "isolated"];
    let headings: Vec<&str> = headings.into_iter().filter(|heading| some_end || *heading != "ends").collect();
    let mut table = Table::new(&headings);
    for fault in record.faults.iter().take(most) {
        let mut row = vec![fault.mode.clone(), seconds(fault.at_s)];
        if some_end {
            row.push(fault.until_s.map_or("never".into(), seconds));
        }
        match fault.struck {
            true => row.extend([after(fault.detected_after_s), after(fault.isolated_after_s)]),
            false => row.push("not struck".to_string()),
        }
        table.row(row);
    }
    screen.gap();
    screen.table(&table);
    if record.faults.len() > most {
        screen.line(Tone::Plain, &format!("  and {} more, -v", record.faults.len() - most));
    }
}

/// What the plan does not cover of the faults that struck: a flight that is lost then refutes no plan.
fn not_covered(flown: &Flown, record: &FlightRecord) -> Vec<String> {
    let Flown { model, solved, strikes, .. } = flown;
    let of_strike = |(strike, fault): (&Strike, &FaultRecord)| {
        if !fault.struck {
            return None;
        }
        let Some(place) = model.plan.against.iter().position(|mode| *mode == strike.mode) else {
            return Some(format!("{} is not in `against`: the plan does not cover it", fault.mode));
        };
        let until = unsafe_until(model, solved, place).filter(|until| *until > strike.at)?;
        Some(format!("until {} s the plan does not cover {}", fixed(until, 2), fault.mode))
    };
    let mut all: Vec<String> = strikes.iter().zip(&record.faults).filter_map(of_strike).collect();
    all.dedup();
    all
}

/// The spin in which a flight without yaw ended.
fn spin(record: &FlightRecord) -> Option<&SpinRecord> {
    record.gave_up_yaw_at_s.and(record.spin.as_ref()).filter(|_| record.outcome == OutcomeRecord::Flown)
}

/// Whether a spin has settled where the gyroscope measures it.
fn is_calm(spin: &SpinRecord) -> bool {
    spin.settled && !spin.beyond_gyroscope
}

/// A landing that is on no landing site, if the mission has some.
fn beside_sites(model: &Model, record: &FlightRecord) -> Option<String> {
    let OutcomeRecord::Landed { place_m, .. } = record.outcome else { return None };
    let sites = model.mission.iter().flat_map(|mission| &mission.after_fault.sites);
    let distance = |site: &LandingSite| (place_m[0] - site.at[0]).hypot(place_m[1] - site.at[1]);
    let nearest = sites.min_by(|a, b| (distance(a) - a.radius).total_cmp(&(distance(b) - b.radius)))?;
    let beyond = distance(nearest) - nearest.radius;
    (beyond > 0.0)
        .then(|| format!("the landing is {} m outside the nearest landing site, `{}`", fixed(beyond, 1), nearest.name))
}

/// The remarks, those first that a reader must not overlook.
fn remarks(flown: &Flown, record: &FlightRecord) -> Vec<(Keep, String)> {
    let model = flown.model;
    let mut all = not_covered(flown, record);
    let is_unfaulted = record.outcome == OutcomeRecord::Flown && !record.faults.iter().any(|fault| fault.struck);
    if is_unfaulted && (record.waypoints_missed > 0 || !record.limits_broken.is_empty()) {
        all.push(
            "without a fault the controller does not keep what the plan keeps: a larger `reserve`, or tighter limits \
             in the plan than in flight, may help"
                .into(),
        );
    }
    let restless = spin(record).filter(|spin| !is_calm(spin));
    all.extend(restless.map(|spin| ending(spin, model).trim_start_matches("Warning: ").to_string()));
    all.extend(beside_sites(model, record));
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
            true => "hover without yaw is possible (`mavc analyze`), but this flight did not reach it: a shorter \
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
