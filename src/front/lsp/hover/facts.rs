//! What a vehicle, a mission and fault modes are in numbers.

use super::Spec;
use crate::actuation::Wrench;
use crate::admissible::allocation::Allocator;
use crate::admissible::verdict::{HoverVerdict, ModeAnalysis};
use crate::lsp::names::NameKind;
use crate::model::{FaultMode, Model, Rotor, RotorState};
use crate::number::{down, number, percent, significant};
use crate::read::FromTable;
use crate::source::{FileId, Span};

/// Modes that are named; of more the first and the last.
const NAMED: usize = 6;

/// A vehicle whose name is at `span`: rotors, weight, thrust to weight and hover speed.
pub fn vehicle(spec: &Spec, span: Span) -> Option<String> {
    let vehicle = spec.understanding.vehicles.iter().find(|v| v.span == span)?;
    let weight = vehicle.mass * spec.understanding.gravity;
    let thrust: f64 = vehicle.rotors.iter().map(Rotor::max_thrust).sum();
    let layout = vehicle.layout.as_ref().map_or(String::new(), |layout| format!(" ({layout})"));
    let speeds = Allocator::new(vehicle).speeds(&Wrench::new(weight, 0.0, 0.0, 0.0));
    let share = speeds.iter().zip(&vehicle.rotors).map(|(w, r)| w / r.max_speed).fold(0.0, f64::max);
    let (slow, fast) = speeds.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), w| (low.min(*w), high.max(*w)));
    let rpm = |w: f64| significant(w * 30.0 / std::f64::consts::PI, 4);
    // Equal rotors are listed once.
    let hover = match fast - slow <= 1e-6 * fast {
        true => format!("{} rad/s ({} rpm)", significant(fast, 4), rpm(fast)),
        false => {
            format!("{} to {} rad/s ({} to {} rpm)", significant(slow, 4), significant(fast, 4), rpm(slow), rpm(fast))
        }
    };
    let lasts = vehicle.battery.as_ref().map_or(String::new(), |battery| {
        let minutes = (1.0 - battery.keep) * battery.energy() / battery.hover_power / 60.0;
        format!(
            "\n\nhovers for **{} min** until {} of the charge is left",
            significant(minutes, 3),
            percent(battery.keep)
        )
    });
    Some(format!(
        "{} rotors{layout}, {} kg, weight {} N\n\n\
         thrust to weight **{}** ({} N at full thrust)\n\n\
         hover speed **{hover}**, at most {} of full speed{lasts}",
        vehicle.rotors.len(),
        number(vehicle.mass),
        significant(weight, 4),
        significant(thrust / weight, 3),
        significant(thrust, 4),
        percent(share),
    ))
}

/// A mission whose name is at `span`.
pub fn mission(spec: &Spec, span: Span) -> Option<String> {
    let mission = spec.model.as_ref()?.mission.as_ref().filter(|mission| mission.span == span)?;
    let length: f64 = mission
        .waypoints
        .windows(2)
        .map(|pair| (0..3).map(|i| (pair[1].position[i] - pair[0].position[i]).powi(2)).sum::<f64>().sqrt())
        .sum();
    let hold: f64 = mission.waypoints.iter().map(|w| w.hold).sum();
    let holds = if hold > 0.0 { format!(", {} s of holds", number(hold)) } else { String::new() };
    Some(format!("{} waypoints, {} m along straight lines{holds}", mission.waypoints.len(), significant(length, 4)))
}

/// A file that `use` brings in, by the names that it declares.
pub fn file(spec: &Spec, file: FileId) -> String {
    let declared: Vec<String> = spec
        .names()
        .definitions
        .iter()
        .filter(|d| d.span.file == file && !matches!(d.kind, NameKind::Waypoint | NameKind::Parameter))
        .map(|d| format!("{} `{}`", d.kind.phrase(), d.name))
        .collect();
    let names = if declared.is_empty() { "declares no name".to_string() } else { declared.join(", ") };
    format!("`{}`\n\n{names}", spec.source(file).name)
}

/// The numbers that a thrust table gives, whose path is at `span`.
pub fn table_at(spec: &Spec, span: Span) -> Option<String> {
    let of_it: Vec<&FromTable> = spec.understanding.from_tables.iter().filter(|given| given.span == span).collect();
    let item = |given: &&FromTable| {
        let FromTable { field, value, unit, reason, is_used, .. } = given;
        let unused = if *is_used { "" } else { "; the spec writes its own" };
        format!("- `{field}` = **{} {unit}**: {reason}{unused}", significant(*value, 4))
    };
    (!of_it.is_empty()).then(|| of_it.iter().map(item).collect::<Vec<_>>().join("\n"))
}

/// The numbers of the first thrust table after a place of a file, if the field there is a `table`.
pub fn table(spec: &Spec, file: FileId, field: &str, from: u32) -> Option<String> {
    let after = |given: &&FromTable| given.span.file == file && given.span.start >= from;
    let is_table = field == crate::language::table::rotor::TABLE.name;
    let first =
        spec.understanding.from_tables.iter().filter(|_| is_table).filter(after).min_by_key(|g| g.span.start)?;
    // Only the relation is between the field and its path.
    let between = spec.snippet(Span { start: from, end: first.span.start, ..first.span });
    (between.trim() == "=").then(|| table_at(spec, first.span))?
}

/// What modes do to the rotors; their names, where they are several.
pub fn modes(spec: &Spec, modes: &[usize]) -> Option<String> {
    let all = &spec.understanding.modes;
    match modes {
        [] => None,
        [one] => Some(effect(&all[*one])),
        [first, .., last] if modes.len() > NAMED => {
            Some(format!("{} modes: {} ... {}", modes.len(), all[*first].name, all[*last].name))
        }
        few => {
            let names: Vec<&str> = few.iter().map(|k| all[*k].name.as_str()).collect();
            Some(format!("{} modes: {}", few.len(), names.join(", ")))
        }
    }
}

/// `rotor 1 lost, rotor 3 reduced to 60 %; rate 1e-5 1/h`
fn effect(mode: &FaultMode) -> String {
    let rotors = (1..).zip(&mode.rotors).filter_map(|(k, rotor)| match *rotor {
        RotorState::Sound => None,
        RotorState::Reduced(share) => Some(format!("rotor {k} reduced to {}", percent(share))),
        RotorState::Stuck(share) => Some(format!("rotor {k} stuck at {}", percent(share))),
        RotorState::Lost => Some(format!("rotor {k} lost")),
    });
    let mut text = rotors.collect::<Vec<_>>().join(", ");
    if text.is_empty() {
        text.push_str("nothing fails");
    }
    if let Some(rate) = mode.rate {
        text.push_str(&format!("; rate {} 1/h", significant(rate * 3600.0, 4)));
    }
    if let Some(rpn) = mode.rpn() {
        text.push_str(&format!("; RPN {rpn}"));
    }
    text
}

/// One verdict as a sentence, several as a table.
pub fn verdicts(model: &Model, analyses: &[ModeAnalysis]) -> String {
    match analyses {
        [one] => {
            let mass = one.critical_mass_kg.filter(|m| *m > 0.0);
            let heaviest = mass.map_or(String::new(), |m| format!(", hovers up to {} kg", down(m, 4)));
            let uncertain = if model.vehicle.is_uncertain() { ", at the middle of the spec's intervals" } else { "" };
            let paper = format!("{}, hover {}", one.verdict.name(), one.hover_words());
            format!("**{}** ({paper}), margin **{}**{heaviest}{uncertain}", one.outcome.word(), margin(one))
        }
        all => {
            let row = |a: &ModeAnalysis| format!("| {} | {} | {} |", a.name, a.outcome.word(), margin(a));
            let rows = all.iter().map(row);
            let head = ["| mode | outcome | margin |".to_string(), "|---|---|---|".to_string()];
            head.into_iter().chain(rows).collect::<Vec<_>>().join("\n")
        }
    }
}

/// The distance from hover to the boundary of the set (ACAI), N and N m alike.
fn margin(analysis: &ModeAnalysis) -> String {
    let of = match analysis.verdict {
        HoverVerdict::Stabilizable => analysis.acai_yaw_free.map(|a| (a, " without yaw")),
        _ => analysis.acai.map(|a| (a, "")),
    };
    of.map_or("none".into(), |(acai, which)| format!("{}{which}", significant(acai, 3)))
}
