//! The lists of words that grammar/mav.pest and the grammars of editors repeat.

use super::table::waypoint::ARRIVE;
use super::{BLOCKS, Entry, FUNCTIONS, Group, OPENERS, Takes};

/// One of the lists by the name that the marks in those files give it. A word comes before its own beginnings,
/// `yaw_within` before `yaw`, because the first alternative of a grammar wins; otherwise the words are in
/// alphabetical order. `None` for an unknown name.
pub fn word_list(name: &str) -> Option<Vec<&'static str>> {
    let clauses = || Group::OF_CLAUSES.into_iter().flat_map(Group::entries).copied();
    let is_bare = |entry: &Entry| entry.takes == Takes::Nothing;
    // `arrive` has `from` before its value.
    let has_value = |entry: &Entry| !is_bare(entry) && entry.name != ARRIVE.name;
    let fields = || {
        let groups = Group::ALL.into_iter().filter(|group| !Group::OF_CLAUSES.contains(group));
        groups.flat_map(Group::entries).copied()
    };
    let is_list = |entry: &Entry| matches!(entry.takes, Takes::WordList(_) | Takes::NameList(_));
    let openers = || OPENERS.iter().flat_map(|(_, words)| words.iter().copied());
    let is_value = |name: &str| matches!(name, "pi" | "g0");
    let functions = || FUNCTIONS.iter().map(|(name, _)| *name);
    let mut words: Vec<&'static str> = match name {
        "clauses" => clauses().map(|entry| entry.name).collect(),
        "clauses with a value" => clauses().filter(|entry| has_value(entry)).map(|entry| entry.name).collect(),
        "clauses without a value" => clauses().filter(|entry| is_bare(entry)).map(|entry| entry.name).collect(),
        "values of clauses" => clauses().flat_map(Entry::words).copied().collect(),
        "values of fields" => fields().filter(|entry| !is_list(entry)).flat_map(Entry::words).copied().collect(),
        "values in lists" => fields().filter(|entry| is_list(entry)).flat_map(Entry::words).copied().collect(),
        "statements" => openers().collect(),
        // Those that name no file, which editors show in another colour.
        "statements of the spec" => openers().filter(|word| !matches!(*word, "use" | "waypoints")).collect(),
        "blocks without a name" => BLOCKS.iter().filter(|block| !block.is_named).map(|block| block.keyword).collect(),
        "functions" => functions().filter(|name| !is_value(name)).collect(),
        "constants" => functions().filter(|name| is_value(name)).collect(),
        _ => return None,
    };
    words.sort_by_key(|word| format!("{word}~"));
    words.dedup();
    Some(words)
}
