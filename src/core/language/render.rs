//! Renders the language table as the Markdown tables of docs/language.md.

use super::{Absent, EFFECTS, Entry, Group, Place, STATEMENTS, Takes};

/// The table of a group's entries in Markdown, including its head.
pub fn markdown(group: Group) -> String {
    let subject = match group {
        Group::Top => "top level",
        Group::Vehicle
        | Group::Mode
        | Group::Mission
        | Group::Plan
        | Group::Requirement
        | Group::Simulate
        | Group::Campaign => "field",
        Group::Rotor => "of a rotor",
        Group::PlacedRotor => "of one rotor",
        Group::Battery => "of the battery",
        Group::Parts => "of the parts",
        Group::Part => "of a part",
        Group::Curve => "of a curve",
        Group::CurveHead => "after the range of a curve",
        Group::Waypoint | Group::Strike => "clause",
        Group::Limits | Group::AfterFaultLimits => "limit",
        Group::Volume => "of a volume",
        Group::Air => "of the air",
        Group::LandingSite => "of a landing site",
        Group::KeepOff => "of an area",
        Group::Recovery => "of the recovery",
        Group::Nothing => "",
    };
    if matches!(group, Group::Limits | Group::AfterFaultLimits) {
        let row = |entry: &Entry| vec![quoted(entry.name), unit(entry), forms(entry), entry.doc.to_string()];
        return rows(&[subject, "unit", "forms", ""], group.entries().iter().map(|entry| row(entry)));
    }
    // The clauses that a placed rotor shares with `rotor { }` are listed there.
    let is_own = |entry: &&&Entry| group != Group::PlacedRotor || !Group::Rotor.has(entry.name);
    let row = |entry: &Entry| vec![quoted(entry.name), takes(entry), absent(entry), entry.doc.to_string()];
    rows(&[subject, "takes", "default", ""], group.entries().iter().filter(is_own).map(|entry| row(entry)))
}

/// The table of the statements of a place in Markdown; for [`Place::Faults`], the effects of a fault.
pub fn statement_markdown(place: Place) -> String {
    if place == Place::Faults {
        let row = |&(_, form, capacity, doc): &(&str, &str, &str, &str)| {
            vec![quoted(form), capacity.to_string(), doc.to_string()]
        };
        return rows(&["effect", "capacity", ""], EFFECTS.iter().map(row));
    }
    let entries = STATEMENTS.iter().filter(|(at, _)| *at == place).flat_map(|(_, entries)| *entries);
    rows(&["statement", ""], entries.map(|entry| vec![quoted(entry.form), entry.doc.to_string()]))
}

fn rows(head: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | ")).replace("|  |", "| |");
    let head_cells: Vec<String> = head.iter().map(ToString::to_string).collect();
    let rule = format!("|{}\n", "---|".repeat(head.len()));
    line(&head_cells) + &rule + &rows.map(|cells| line(&cells)).collect::<String>()
}

fn quoted(text: &str) -> String {
    format!("`{text}`")
}

fn listed(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| quoted(word)).collect();
    match quoted.as_slice() {
        [first @ .., last] if !first.is_empty() => format!("{} or {last}", first.join(", ")),
        _ => quoted.concat(),
    }
}

fn unit(entry: &Entry) -> String {
    entry.unit().filter(|unit| *unit != "1").unwrap_or("number").to_string()
}

fn forms(entry: &Entry) -> String {
    entry.forms().iter().map(|form| quoted(form)).collect::<Vec<_>>().join(" ")
}

fn grouped(number: u64) -> String {
    match number {
        _ if number == 1 << 53 => "2^53".into(),
        _ if number < 1_000 => number.to_string(),
        _ => format!("{},{:03}", grouped(number / 1_000), number % 1_000),
    }
}

fn takes(entry: &Entry) -> String {
    match entry.takes {
        Takes::Quantity(..) | Takes::Bound(..) => unit(entry),
        Takes::Vector(..) if unit(entry) == "number" => "three numbers".into(),
        Takes::Vector(..) => format!("three in {}", unit(entry)),
        Takes::PlanePoint(_) => format!("two or three in {}", unit(entry)),
        Takes::QuantityOrVector(..) => format!("one or three in {}", unit(entry)),
        Takes::QuantityOrShare(..) => format!("{}, or a share as in `-60 %`", unit(entry)),
        Takes::Share => "share, as in `60 %`".into(),
        Takes::Whole(least, most) => format!("{} to {}", grouped(least), grouped(most)),
        Takes::Words(words) => listed(words),
        Takes::QuantityOr(_, _, words) => format!("{}, {}", unit(entry), listed(words)),
        Takes::WordList(words) => format!("list of {}", listed(words)),
        Takes::Text => "text".into(),
        Takes::Nothing => "no value".into(),
        Takes::Names([]) => "name".into(),
        Takes::Names(words) => format!("names, {}", listed(words)),
        Takes::NameList(words) => format!("list of names, {}", listed(words)),
        Takes::Points => "list of points".into(),
    }
}

fn absent(entry: &Entry) -> String {
    match entry.absent {
        Absent::Needed => "required".into(),
        Absent::Otherwise(words) => words.into(),
        Absent::Value(_, written, _) => written.into(),
        Absent::Written(written, _) if written.contains(' ') && !written.starts_with('[') => written.into(),
        Absent::Written(written, _) => quoted(written),
    }
}
