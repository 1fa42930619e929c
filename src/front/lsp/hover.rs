//! What is shown of the word under the pointer.

mod facts;

use super::documentation;
use super::mentions::{Mention, What};
use super::names::{Definition, NameKind};
use super::navigation::file_named_at;
use super::workspace::Spec;
use crate::admissible::verdict::ModeAnalysis;
use crate::language::{Absent, Entry};
use crate::model::Model;
use crate::number::{number, significant};
use crate::read::Reading;
use crate::read::vocabulary::constants;
use crate::source::{FileId, Span};
use crate::syntax::Place;
use crate::unit::parse_unit;
use std::sync::Arc;

/// Modes of an `every` whose verdicts are shown; of more none is worked out.
const MOST_VERDICTS: usize = 32;

/// Markdown for a place, and the verdicts that are not yet known.
#[derive(Debug, Clone)]
pub struct Shown {
    pub span: Span,
    pub text: String,
    pub wanted: Option<Wanted>,
}

/// Modes whose verdicts are to be shown, by their index in the model.
#[derive(Debug, Clone)]
pub struct Wanted {
    pub model: Arc<Model>,
    pub modes: Vec<usize>,
}

/// The hover for the byte at `offset` of a file.
pub fn hover(spec: &Spec, file: FileId, offset: usize) -> Option<Shown> {
    let Some(mention) = spec.mentions().at(file, offset) else {
        return keyword(spec, file, offset).or_else(|| value(spec, file, offset));
    };
    let plain = |text: String| Some(Shown { span: mention.span, text, wanted: None });
    match mention.what {
        What::Field(place) => plain(field(spec, place, mention.span)?),
        What::Keyword => plain(keyword_text(spec, spec.snippet(mention.span), mention.span)?),
        What::Function | What::Constant => {
            let name = spec.snippet(mention.span);
            let says = documentation::function(name)?;
            let text = if constants().contains(&name) && name == "g0" {
                format!("**`{name}`** = {} m/s^2 · {}", number(spec.understanding.gravity), says)
            } else {
                format!("**`{name}`** · {says}")
            };
            plain(text)
        }
        What::Definition(index) | What::Reference(index) => named(spec, &mention, &spec.names().definitions[index]),
        What::Word => plain(word(spec, &mention)?),
        What::Text => match file_named_at(spec, file, offset) {
            // A table is a file of the spec that declares no name.
            Some(named) => plain(facts::table_at(spec, mention.span).unwrap_or_else(|| facts::file(spec, named))),
            None => value(spec, file, offset),
        },
        What::Number | What::Unit => value(spec, file, offset),
    }
}

/// A word that a field takes: the entry of the field explains its words too.
fn word(spec: &Spec, mention: &Mention) -> Option<String> {
    let before = spec.mentions().in_file(mention.span.file).iter().rev().filter(|m| m.span.start < mention.span.start);
    let (place, field) = before.into_iter().find_map(|m| match m.what {
        What::Field(place) => Some((place, spec.snippet(m.span))),
        _ => None,
    })?;
    let entry = documentation::field(place, field)?;
    let word = spec.snippet(mention.span);
    let default = if entry.default().is_some_and(|(written, _)| written == word) { ", the default" } else { "" };
    Some(format!("**`{word}`** · a value of `{field}`{default}\n\n{}", documentation::line(entry)))
}

/// A word of the language that the tree does not keep: the opening word of a statement, or what fails.
fn keyword(spec: &Spec, file: FileId, offset: usize) -> Option<Shown> {
    let text = &spec.source(file).text;
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let start = text.get(..offset)?.rfind(|c| !is_word(c)).map_or(0, |at| at + 1);
    let start = (start..=offset).find(|at| text.is_char_boundary(*at))?;
    let end = text[offset..].find(|c| !is_word(c)).map_or(text.len(), |length| offset + length);
    let line = text[..start].rsplit('\n').next().unwrap_or("");
    if start == end || line.contains("//") || line.matches('"').count() % 2 == 1 {
        return None;
    }
    let span = Span::new(file, start, end);
    let says = documentation::statement(&text[start..end])?;
    Some(Shown { span, text: format!("**`{}`** · {says}", &text[start..end]), wanted: None })
}

/// A block's keyword; of a vehicle with what it can do.
fn keyword_text(spec: &Spec, word: &str, span: Span) -> Option<String> {
    let says = documentation::statement(word).map(|text| format!("**`{word}`** · {text}"));
    let vehicle = (word == "vehicle")
        .then(|| {
            spec.names()
                .of_kind(NameKind::Vehicle)
                .find(|d| d.statement.start == span.start && d.span.file == span.file)
        })
        .flatten();
    let facts = vehicle.and_then(|definition| facts::vehicle(spec, definition.span));
    Some(says.into_iter().chain(facts).collect::<Vec<_>>().join("\n\n")).filter(|text| !text.is_empty())
}

/// A field: what it is, its unit, and its value here.
fn field(spec: &Spec, place: Place, span: Span) -> Option<String> {
    let name = spec.snippet(span);
    let entry = documentation::field(place, name)?;
    let mut parts = vec![described(entry)];
    parts.extend(facts::table(spec, span.file, name, span.end));
    // The value follows the name: the first reading of the statement that begins here.
    let next = spec.mentions().in_file(span.file).iter().find(|m| m.span.start > span.start && is_field(m));
    let end = next.map_or(u32::MAX, |m| m.span.start);
    let line_end = |reading: &Reading| reading.span.start < end && reading.span.start >= span.end;
    let reading = spec.understanding.readings.iter().filter(|r| r.span.file == span.file && line_end(r));
    if let Some(reading) = reading.min_by_key(|r| (r.span.start, std::cmp::Reverse(r.span.end)))
        && belongs(spec, span, reading.span)
    {
        parts.push(valued(spec, reading));
    }
    Some(parts.join("\n\n"))
}

fn is_field(mention: &Mention) -> bool {
    matches!(mention.what, What::Field(_) | What::Keyword | What::Definition(_))
}

/// Whether only a relation is between a field and its value.
fn belongs(spec: &Spec, field: Span, value: Span) -> bool {
    let between = spec.snippet(Span { start: field.end, end: value.start, ..field }).trim();
    matches!(between, "" | "=" | "<=" | ">=" | "in")
}

/// A field with its unit and default.
pub fn described(entry: &Entry) -> String {
    let mut head = format!("**`{}`**", entry.name);
    if let Some(unit) = documentation::unit(entry) {
        head.push_str(&format!(" · in {unit}"));
    }
    match entry.absent {
        Absent::Needed => head.push_str(" · required"),
        Absent::Otherwise("") => {}
        Absent::Otherwise(words) => head.push_str(&format!(" · default: {words}")),
        Absent::Value(_, written, _) | Absent::Written(written, _) => head.push_str(&format!(" · default: {written}")),
    }
    format!("{head}\n\n{}", documentation::line(entry))
}

/// The value of the innermost expression around a place, and what its unit is.
fn value(spec: &Spec, file: FileId, offset: usize) -> Option<Shown> {
    let holds = |span: Span| span.file == file && (span.start as usize) <= offset && offset <= span.end as usize;
    let reading =
        spec.understanding.readings.iter().filter(|r| holds(r.span)).min_by_key(|r| r.span.end - r.span.start);
    let unit = spec.mentions().at(file, offset).filter(|m| m.what == What::Unit);
    let mut parts = Vec::new();
    parts.extend(reading.map(|reading| valued(spec, reading)));
    parts.extend(unit.and_then(|mention| unit_text(spec, spec.snippet(mention.span))));
    let span = reading.map(|r| r.span).or(unit.map(|m| m.span))?;
    Some(Shown { span, text: parts.join("\n\n"), wanted: None }).filter(|shown| !shown.text.is_empty())
}

/// `1 rpm = 0.10472 rad/s, a turning rate`
fn unit_text(spec: &Spec, text: &str) -> Option<String> {
    let unit = parse_unit(text, spec.understanding.gravity).ok()?;
    let si = unit.dimension.to_string();
    let scale = significant(unit.numerator / unit.denominator, 6);
    let kind = unit.dimension.named().map_or(String::new(), |(name, _)| format!(", {name}"));
    if text == si {
        return Some(format!("`{text}`{kind}, as in SI"));
    }
    Some(format!(
        "`1 {text}` = {scale}{}{kind}",
        if unit.dimension.is_plain() { String::new() } else { format!(" {si}") }
    ))
}

/// An expression as written and in SI.
fn valued(spec: &Spec, reading: &Reading) -> String {
    let written = spec.snippet(reading.span).split_whitespace().collect::<Vec<_>>().join(" ");
    let value = si(reading);
    // `1 .. 20 m` means `1 m .. 20 m`.
    let each = reading.values.iter().map(|v| format!("{} {}", number(*v), reading.unit)).collect::<Vec<_>>();
    let is_same = written == value || written == each.join(" .. ") || written == format!("[{}]", each.join(", "));
    if is_same { format!("`{written}`") } else { format!("`{written}` = **{value}**") }
}

/// Values in SI: `0.6109 rad`, `[0, 0, 2] m`, `1 .. 30 m`.
pub fn si(reading: &Reading) -> String {
    let numbers: Vec<String> = reading.values.iter().map(|v| number(*v)).collect();
    let text = match numbers.as_slice() {
        [one] => one.clone(),
        [low, high] => format!("{low} .. {high}"),
        all => format!("[{}]", all.join(", ")),
    };
    if reading.unit.is_empty() { text } else { format!("{text} {}", reading.unit) }
}

/// A name that the spec declares.
fn named(spec: &Spec, mention: &Mention, definition: &Definition) -> Option<Shown> {
    let name = match definition.kind {
        NameKind::Modes => spec.snippet(mention.span),
        _ => definition.name.as_str(),
    };
    let title = definition.title.as_ref().map_or(String::new(), |title| format!(" “{title}”"));
    // One of the modes of an `every` is one mode.
    let kind = if name == definition.name { definition.kind } else { NameKind::Mode };
    let mut parts = vec![format!("{} **{name}**{title}", kind.phrase())];
    parts.extend(definition.doc.clone());
    let mut wanted = None;
    match definition.kind {
        NameKind::Let => {
            let inside = |r: &&Reading| {
                let (span, whole) = (r.span, definition.statement);
                span.file == whole.file && span.start >= definition.span.end && span.end == whole.end
            };
            parts.extend(spec.understanding.readings.iter().find(inside).map(|reading| valued(spec, reading)));
        }
        NameKind::Vehicle => parts.extend(facts::vehicle(spec, definition.span)),
        NameKind::Mission => parts.extend(facts::mission(spec, definition.span)),
        NameKind::Mode | NameKind::Modes => {
            let names = spec.names();
            let alike = names.declared_at(definition.span).map(|index| names.alike(index)).unwrap_or_default();
            let is_of_family = |span: Span| alike.iter().any(|&k| names.definitions[k].statement == span);
            let of_statement = |k: &usize| {
                let mode = &spec.understanding.modes[*k];
                match definition.kind {
                    NameKind::Mode => mode.span == definition.span,
                    _ if mention.span == definition.span => mode.span == definition.statement,
                    // `against = M` is all of them.
                    _ => is_of_family(mode.span) && (name == definition.name || mode.name == name),
                }
            };
            let modes: Vec<usize> = (0..spec.understanding.modes.len()).filter(of_statement).collect();
            parts.extend(facts::modes(spec, &modes));
            wanted = spec.model.as_ref().filter(|_| !modes.is_empty() && modes.len() <= MOST_VERDICTS).map(|model| {
                // Without errors the modes understood are those of the model.
                Wanted { model: model.clone(), modes }
            });
            if spec.model.is_none() {
                parts.push("Verdicts show once the spec has no errors.".into());
            }
        }
        NameKind::Waypoint | NameKind::LandingSite => {
            parts.extend(position(spec, definition).map(|reading| format!("at {}", valued(spec, reading))));
        }
        NameKind::Parameter => {}
    }
    Some(Shown { span: mention.span, text: parts.join("\n\n"), wanted })
}

/// The position of a waypoint or landing site: the value of its `at`.
fn position<'s>(spec: &'s Spec, definition: &Definition) -> Option<&'s Reading> {
    let clauses = spec.mentions().within(definition.statement).iter();
    let at = clauses.into_iter().find(|m| matches!(m.what, What::Field(_)) && spec.snippet(m.span) == "at")?;
    let readings = spec.understanding.readings.iter().filter(|r| r.span.file == at.span.file);
    let whole = readings.filter(|r| r.span.start >= at.span.end && r.span.end <= definition.statement.end);
    whole.filter(|r| belongs(spec, at.span, r.span)).max_by_key(|r| r.span.end)
}

/// The verdicts that were wanted, as a line or a table.
pub fn verdicts(model: &Model, analyses: &[ModeAnalysis]) -> String {
    facts::verdicts(model, analyses)
}
