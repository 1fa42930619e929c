//! The entries of the table of the language for a word.

use crate::language::{EFFECTS, Entry, FUNCTIONS, Group, Place, STATEMENTS};

/// The entry of a field or clause of a block.
pub fn field(place: Place, name: &str) -> Option<&'static Entry> {
    // The braces of a curve take some clauses of a waypoint, and the head others.
    let groups = Group::within(place).iter();
    groups.chain(if place == Place::Curve { &[Group::Waypoint][..] } else { &[] }).find_map(|group| group.entry(name))
}

/// The usual unit of an entry; `None` where a plain number or no quantity is taken.
pub fn unit(entry: &Entry) -> Option<&'static str> {
    entry.unit().filter(|unit| *unit != "1")
}

/// The line about an entry, without links.
pub fn line(entry: &Entry) -> String {
    prose(entry.doc)
}

/// The line about a function or a constant.
pub fn function(name: &str) -> Option<&'static str> {
    FUNCTIONS.iter().find(|(function, _)| *function == name).map(|(_, doc)| *doc)
}

/// The line about a word that begins a statement or a block, or about an effect of a fault.
pub fn statement(word: &str) -> Option<String> {
    let effect = EFFECTS.iter().find(|effect| effect.0 == word).map(|effect| effect.3);
    let statement = || STATEMENTS.iter().flat_map(|(_, entries)| *entries).find(|entry| entry.word == word);
    effect.or_else(|| statement().map(|entry| entry.doc)).map(prose)
}

/// The usual unit of every field.
pub fn units() -> impl Iterator<Item = &'static str> {
    Group::ALL.into_iter().flat_map(Group::entries).filter_map(|entry| unit(entry))
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
