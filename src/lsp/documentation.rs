//! What the language reference says of a word. `docs/language.md` is the one source: its tables and the paragraphs that
//! begin with a word are read here, so that editors and the page never differ.

use crate::syntax::Place;
use std::sync::LazyLock;

const LANGUAGE: &str = include_str!("../../docs/language.md");

static REFERENCE: LazyLock<Reference> = LazyLock::new(|| Reference::read(LANGUAGE));

/// What the reference says of one word.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    /// `mass`, `sqrt`, `hold`.
    pub name: String,
    /// The unit one would write; `None` where none is due.
    pub unit: Option<String>,
    /// What holds where nothing is written.
    pub default: Option<String>,
    /// The forms of a limit, such as `<=`.
    pub forms: Vec<String>,
    /// In Markdown.
    pub text: String,
}

struct Table {
    section: String,
    /// The head of the first column, such as `field`.
    subject: String,
    entries: Vec<Entry>,
}

struct Reference {
    tables: Vec<Table>,
    /// Section, the word that the paragraph begins with, the paragraph.
    paragraphs: Vec<(String, String, String)>,
}

/// What is said of a field or clause of a block.
pub fn field(place: Place, name: &str) -> Option<&'static Entry> {
    let (section, subjects): (&str, &[&str]) = match place {
        Place::Vehicle => ("Vehicle", &["field"]),
        Place::Rotor => ("Vehicle", &["of a rotor"]),
        Place::Rotors => ("Vehicle", &["of one rotor", "of a rotor"]),
        Place::Mode | Place::Every => ("Faults", &["field"]),
        Place::Curve => ("Mission", &["of a curve", "clause"]),
        Place::Mission => ("Mission", &["clause"]),
        Place::Limits => ("Limits", &["limit"]),
        Place::Plan => ("Plan", &["field"]),
        Place::Simulate => ("Simulate", &["field", "clause"]),
        Place::Campaign => ("Campaign", &["field"]),
        Place::Top => ("Expressions", &["top level"]),
        Place::Faults | Place::Unknown => return None,
    };
    subjects.iter().find_map(|subject| entry(section, subject, name))
}

/// What is said of a function or a constant.
pub fn function(name: &str) -> Option<&'static Entry> {
    entry("Expressions", "", name)
}

/// What is said of a word that begins a statement or a block, or of what fails in a mode.
pub fn statement(word: &str) -> Option<&'static str> {
    let of_table = || {
        let rows = [("Mission", "statement"), ("Faults", "effect"), ("Vehicle", "field")];
        rows.iter().find_map(|(section, subject)| entry(section, subject, word)).map(|e| e.text.as_str())
    };
    of_table().or_else(|| REFERENCE.paragraphs.iter().find(|p| p.1 == word).map(|p| p.2.as_str()))
}

/// Every unit that the reference gives for some field.
pub fn units() -> impl Iterator<Item = &'static str> {
    REFERENCE.tables.iter().flat_map(|table| &table.entries).filter_map(|entry| entry.unit.as_deref())
}

fn entry(section: &str, subject: &str, name: &str) -> Option<&'static Entry> {
    let tables = REFERENCE.tables.iter().filter(|t| t.section == section && t.subject == subject);
    tables.flat_map(|table| &table.entries).find(|entry| entry.name == name)
}

impl Reference {
    fn read(page: &str) -> Self {
        let mut reference = Reference { tables: Vec::new(), paragraphs: Vec::new() };
        for part in page.split("\n## ").skip(1) {
            let (section, body) = part.split_once('\n').unwrap_or((part, ""));
            let body = without_code(body);
            for paragraph in body.split("\n\n") {
                let paragraph = paragraph.trim();
                if paragraph.starts_with('|') {
                    reference.tables.push(table(section, paragraph));
                } else if let Some(word) = first_code_word(paragraph) {
                    let text = prose(&paragraph.replace('\n', " "));
                    reference.paragraphs.push((section.to_string(), word, text));
                }
            }
        }
        reference
    }
}

/// The text without its code blocks, which stand apart from what they show.
fn without_code(text: &str) -> String {
    text.split("```").step_by(2).collect::<Vec<_>>().join("\n\n")
}

/// The first word of the code that a paragraph begins with, after `One` or a bold lead.
fn first_code_word(paragraph: &str) -> Option<String> {
    let start = paragraph.strip_prefix("One ").unwrap_or(paragraph);
    let start = match start.strip_prefix("**") {
        Some(bold) => bold.split_once("** ")?.1,
        None => start,
    };
    let code = start.strip_prefix('`')?;
    let end = code.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_'))?;
    (end > 0).then(|| code[..end].to_string())
}

fn table(section: &str, text: &str) -> Table {
    let mut rows = text.lines().map(|line| cells(line.trim()));
    let head = rows.next().unwrap_or_default();
    let column = |title: &str| head.iter().position(|h| h == title);
    let (unit, default, forms) = (column("unit"), column("default").or(column("unless said")), column("forms"));
    let mut entries = Vec::new();
    for row in rows.skip(1) {
        let Some(subject) = row.first() else { continue };
        let names: Vec<&str> = subject
            .split('`')
            .skip(1)
            .step_by(2)
            .flat_map(|code| match code.contains(['(', '{', '"', '=']) || code.contains(|c: char| c.is_uppercase()) {
                // A form such as `atan2(y, x)` or `hold TIME` is known by its first word.
                true => code.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).take(1).collect::<Vec<_>>(),
                false => code.split_whitespace().collect(),
            })
            .collect();
        let cell = |index: Option<usize>, k: usize| -> Option<String> {
            let text = row.get(index?)?;
            // Several names of a row may have a value each.
            let each: Vec<&str> = text.split(", ").collect();
            let text = if each.len() == names.len() { each[k] } else { text };
            let text = text.trim().trim_matches('`');
            (!text.is_empty()).then(|| text.to_string())
        };
        for (k, name) in names.iter().enumerate() {
            let forms = row.get(forms.unwrap_or(usize::MAX)).map_or("", String::as_str);
            let last = row.last().filter(|_| row.len() > 1);
            let says = row.iter().enumerate().skip(1).find(|(i, _)| Some(*i) != unit && head[*i].is_empty());
            entries.push(Entry {
                name: name.to_string(),
                unit: cell(unit, k).filter(|u| u != "text"),
                default: cell(default, k),
                forms: forms.split('`').skip(1).step_by(2).map(str::to_string).collect(),
                text: match prose(says.map(|(_, text)| text).or(last).map_or("", String::as_str)) {
                    text if text.is_empty() => row.get(1).map_or(String::new(), |cell| format!("{}: {cell}", head[1])),
                    text => text,
                },
            });
        }
    }
    Table { section: section.to_string(), subject: head.first().cloned().unwrap_or_default(), entries }
}

/// The cells of one row of a table.
fn cells(line: &str) -> Vec<String> {
    let inner = line.trim_start_matches('|').trim_end().trim_end_matches('|');
    inner.split('|').map(|cell| cell.trim().to_string()).collect()
}

/// Markdown without its links, which lead nowhere outside the page.
fn prose(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once('[') {
        out.push_str(before);
        match after.split_once("](") {
            Some((shown, target)) if !shown.contains([']', '[', '`']) || shown.starts_with('`') => {
                out.push_str(shown);
                rest = target.split_once(')').map_or("", |(_, rest)| rest);
            }
            _ => {
                out.push('[');
                rest = after;
            }
        }
    }
    out.push_str(rest);
    out
}
