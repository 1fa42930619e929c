//! The table of the language, and everything that repeats it: defaults, the language reference, the grammars of editors.

use mavc::language::{Absent, Entry, FUNCTIONS, Group, OPENERS, Place, Takes, markdown, statement_markdown};
use mavc::model::vocabulary::{constants, functions, words};
use mavc::model::{AfterFault, Allocation, Controller, PlanModel, PlanRotors, PlannerKind};
use mavc::unit::parse_unit;
use std::collections::BTreeSet;
use std::path::PathBuf;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn read(name: &str) -> String {
    std::fs::read_to_string(root().join(name)).unwrap()
}

/// The tables of docs/language.md, by the comment above each of them.
fn tables() -> Vec<(&'static str, String)> {
    vec![
        ("top level", markdown(Group::Top)),
        ("vehicle", markdown(Group::Vehicle)),
        ("blocks of a vehicle", statement_markdown(Place::Vehicle)),
        ("rotor", markdown(Group::Rotor)),
        ("placed rotor", markdown(Group::PlacedRotor)),
        ("battery", markdown(Group::Battery)),
        ("effects", statement_markdown(Place::Faults)),
        ("mode", markdown(Group::Mode)),
        ("statements of a mission", statement_markdown(Place::Mission)),
        ("mission", markdown(Group::Mission)),
        ("waypoint", markdown(Group::Waypoint)),
        ("curve", markdown(Group::Curve)),
        ("head of a curve", markdown(Group::CurveHead)),
        ("limits", markdown(Group::Limits)),
        ("volume", markdown(Group::Volume)),
        ("air", markdown(Group::Air)),
        ("plan", markdown(Group::Plan)),
        ("capture height", markdown(Group::Requirement)),
        ("strike", markdown(Group::Strike)),
        ("simulate", markdown(Group::Simulate)),
        ("campaign", markdown(Group::Campaign)),
    ]
}

/// The page with every table as the language has it.
fn with_tables(page: &str) -> String {
    let mut page = page.to_string();
    for (name, table) in tables() {
        let mark = format!("<!-- table: {name} -->\n");
        let at = page.find(&mark).unwrap_or_else(|| panic!("docs/language.md has no `{}`", mark.trim())) + mark.len();
        let old: usize = page[at..].split_inclusive('\n').take_while(|line| line.starts_with('|')).map(str::len).sum();
        page.replace_range(at..at + old, &table);
    }
    page
}

/// `MAVC_UPDATE=1 cargo test --test it language` rewrites them.
#[test]
fn the_tables_of_the_reference_are_those_of_the_language() {
    let path = root().join("docs/language.md");
    let page = std::fs::read_to_string(&path).unwrap();
    let due = with_tables(&page);
    if std::env::var_os("MAVC_UPDATE").is_some() {
        std::fs::write(&path, &due).unwrap();
        return;
    }
    assert!(page == due, "docs/language.md differs from the table: MAVC_UPDATE=1 cargo test --test it language");
}

/// The value of a default as one would write it, in SI.
fn evaluated(written: &str) -> f64 {
    let (digits, unit) = written.split_once(' ').unwrap_or((written, "1"));
    let value: f64 = digits.parse().unwrap();
    let unit = if unit == "%" { return value / 100.0 } else { parse_unit(unit, 9.81).unwrap() };
    value * unit.numerator / unit.denominator
}

fn entries() -> impl Iterator<Item = (Group, &'static Entry)> {
    Group::ALL.into_iter().flat_map(|group| group.entries().iter().map(move |entry| (group, *entry)))
}

#[test]
fn defaults_are_written_as_what_they_are() {
    let mut looked_at = 0;
    for (group, entry) in entries() {
        if let Absent::Value(value, written, why) = entry.absent {
            let evaluated = evaluated(written);
            assert!((evaluated - value).abs() <= 1e-15 * value.abs(), "{} of {group:?}: {written}", entry.name);
            assert!(!why.is_empty());
            looked_at += 1;
        }
        if let (Absent::Written(written, _), Takes::Words(words)) = (entry.absent, entry.takes) {
            assert!(words.contains(&written), "{} of {group:?}: {written}", entry.name);
            looked_at += 1;
        }
    }
    assert!(looked_at > 35, "{looked_at}");
}

#[test]
fn every_entry_has_a_name_of_its_own_and_a_line() {
    for group in Group::ALL {
        let names: BTreeSet<&str> = group.names().collect();
        assert_eq!(names.len(), group.entries().len(), "{group:?}");
    }
    for (group, entry) in entries() {
        assert!(entry.doc.len() > 8 && !entry.doc.ends_with('.'), "{} of {group:?}: {}", entry.name, entry.doc);
        let unit = entry.unit().unwrap_or("1");
        assert!(parse_unit(unit, 9.81).is_ok(), "{} of {group:?}: {unit}", entry.name);
    }
}

#[test]
fn every_function_has_a_line() {
    let documented: BTreeSet<&str> = FUNCTIONS.iter().map(|(name, _)| *name).collect();
    let known: BTreeSet<&str> = functions().iter().chain(constants()).copied().collect();
    assert_eq!(documented, known);
    let page = read("docs/language.md");
    let section = page.split("\n## ").find(|part| part.starts_with("Expressions")).unwrap();
    for name in known {
        assert!(section.contains(name), "{name} is not in the section on expressions");
    }
}

/// The words between quotes of `kind` in a text.
fn quoted(text: &str, quote: char) -> BTreeSet<String> {
    let is_word = |word: &str| !word.is_empty() && word.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    text.split(quote).skip(1).step_by(2).filter(|word| is_word(word)).map(String::from).collect()
}

/// The words that begin statements, clauses, and words that fields take.
fn openers() -> BTreeSet<String> {
    OPENERS.iter().flat_map(|(_, words)| *words).map(ToString::to_string).collect()
}

fn clauses() -> BTreeSet<String> {
    let groups = [Group::Waypoint, Group::PlacedRotor, Group::Strike];
    groups.into_iter().flat_map(Group::names).map(String::from).collect()
}

#[test]
fn the_grammar_of_tree_sitter_has_the_same_words() {
    let grammar = read("editors/tree-sitter-mav/grammar.js");
    let list = |name: &str| {
        let (_, rest) = grammar.split_once(&format!("const {name} = [")).unwrap_or_else(|| panic!("no {name}"));
        quoted(rest.split(']').next().unwrap(), '\'')
    };
    let all = ["CLAUSE_WORDS", "BARE_WORDS", "FROM_WORDS"].into_iter().flat_map(list);
    assert_eq!(all.collect::<BTreeSet<String>>(), clauses());
    assert_eq!(list("STATEMENT_WORDS"), openers());
}

/// The queries list the same words as the table: a word too many is found as well as one that is missing.
#[test]
fn the_queries_of_tree_sitter_have_the_same_words() {
    let queries = read("editors/tree-sitter-mav/queries/highlights.scm");
    let any_of = |node: &str| {
        let (_, rest) = queries.split_once(node).unwrap_or_else(|| panic!("highlights.scm has no {node}"));
        quoted(rest.split("))").find(|part| part.contains("#any-of?")).unwrap(), '"')
    };
    let names = |all: &[&str]| all.iter().map(ToString::to_string).collect::<BTreeSet<String>>();
    assert_eq!(any_of("(call function: (name)"), names(functions()));
    assert_eq!(any_of("((reference (name)"), names(constants()));
    assert_eq!(any_of("((field value: (reference"), words_of(|group, entry| !is_clause(group) && !is_list(entry)));
    assert_eq!(any_of("((field value: (list"), words_of(|_, entry| is_list(entry)));
    assert_eq!(any_of("((clause value:"), words_of(|group, _| is_clause(group)));
    for list in [&queries, &read("editors/emacs/mav-ts-mode.el")] {
        let keywords = quoted(list, '"');
        for word in openers() {
            assert!(keywords.contains(&word), "`{word}` is no keyword in\n{list}");
        }
    }
}

fn is_clause(group: Group) -> bool {
    matches!(group, Group::Waypoint | Group::PlacedRotor | Group::Strike)
}

fn is_list(entry: &Entry) -> bool {
    matches!(entry.takes, Takes::WordList(_))
}

/// The words that some entries accept, without the names of warnings. Words of a list may also stand alone.
fn words_of(wanted: impl Fn(Group, &Entry) -> bool) -> BTreeSet<String> {
    let found = entries().filter(|(group, entry)| wanted(*group, entry));
    found.flat_map(|(_, entry)| entry.words()).map(ToString::to_string).collect()
}

/// The texts of the regular expressions in the TextMate grammar.
fn patterns(grammar: &serde_json::Value, found: &mut Vec<String>) {
    match grammar {
        serde_json::Value::Object(fields) => {
            let own = ["match", "begin", "end"].into_iter().filter_map(|key| fields.get(key)?.as_str());
            found.extend(own.map(String::from));
            fields.values().for_each(|inner| patterns(inner, found));
        }
        serde_json::Value::Array(all) => all.iter().for_each(|inner| patterns(inner, found)),
        _ => {}
    }
}

/// The alternatives `a|b|c` of a regular expression, wherever it has several words; `atan2?` is two.
fn alternatives(pattern: &str) -> Vec<BTreeSet<String>> {
    let is_part = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '|' | '?');
    let runs = pattern.split(|c: char| !is_part(c)).filter(|run| run.contains('|'));
    let both = |word: &str| match word.trim_start_matches('?').strip_suffix('?') {
        Some(long) => vec![long.to_string(), long[..long.len() - 1].to_string()],
        None => vec![word.trim_start_matches('?').to_string()],
    };
    runs.map(|run| run.split('|').flat_map(both).filter(|word| !word.is_empty()).collect()).collect()
}

#[test]
fn the_textmate_grammar_has_the_same_words() {
    let grammar = read("editors/vscode/syntaxes/mav.tmLanguage.json");
    let mut all = Vec::new();
    patterns(&serde_json::from_str(&grammar).unwrap(), &mut all);
    let lists: Vec<BTreeSet<String>> = all.iter().flat_map(|pattern| alternatives(pattern)).collect();
    let with = |word: &str| lists.iter().filter(|list| list.contains(word)).collect::<Vec<_>>();
    // Every list of clauses, of which there are several, is complete.
    let of_clauses = with("yaw_within");
    assert!(of_clauses.len() >= 4, "{of_clauses:?}");
    for list in of_clauses {
        assert!(clauses().is_subset(list), "{:?} are missing", clauses().difference(list).collect::<Vec<_>>());
    }
    let fields = words_of(|group, entry| !is_clause(group) && !is_list(entry));
    assert_eq!(with("pseudo_inverse"), [&fields]);
    let known: BTreeSet<String> = functions().iter().map(ToString::to_string).collect();
    assert_eq!(with("acos"), [&known]);
    assert!(constants().iter().all(|name| with("g0")[0].contains(*name)));
    let planners = words_of(|_, entry| is_list(entry));
    assert!(with("rip").contains(&&planners), "{planners:?}");
    let is_letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let words: BTreeSet<&str> =
        all.iter().flat_map(|pattern| pattern.split(|c| !is_letter(c))).map(|w| w.trim_start_matches('b')).collect();
    for word in openers() {
        let plural = word.strip_suffix('s').is_some_and(|one| all.iter().any(|p| p.contains(&format!("{one}s?"))));
        assert!(plural || words.contains(word.trim_start_matches('b')), "the TextMate grammar has no `{word}`");
    }
}

/// The words by which the model names a choice are those of the table.
#[test]
fn choices_of_the_model_have_the_words_of_the_table() {
    use mavc::language::table::{plan, simulate, vehicle};
    let same = |entry: &Entry, names: &[&str]| {
        let sorted = |words: &[&str]| words.iter().map(ToString::to_string).collect::<BTreeSet<_>>();
        assert_eq!(sorted(entry.words()), sorted(names), "{}", entry.name);
    };
    same(&plan::PLANNER, &[PlannerKind::Rip, PlannerKind::Rcp, PlannerKind::Rsp].map(PlannerKind::name));
    same(&plan::MODEL, &[PlanModel::Hover, PlanModel::Exact].map(PlanModel::name));
    same(&plan::ROTORS, &[PlanRotors::Instant, PlanRotors::Lagging].map(PlanRotors::name));
    same(&plan::AFTER_FAULT, &[AfterFault::Continue, AfterFault::Hold].map(AfterFault::name));
    let reactions = [AfterFault::Continue, AfterFault::Hold, AfterFault::Land];
    same(&simulate::AFTER_FAULT, &reactions.map(AfterFault::name));
    same(&simulate::CONTROLLER, &[Controller::Geometric, Controller::Pd].map(Controller::name));
    same(&vehicle::ALLOCATION, &[Allocation::Bounded, Allocation::PseudoInverse].map(Allocation::name));
}

#[test]
fn every_word_that_is_offered_is_of_the_table() {
    assert_eq!(words(Place::Plan, "planner"), ["rip", "rcp", "rsp"]);
    assert_eq!(words(Place::Simulate, "detection"), ["estimator", "never"]);
    assert_eq!(words(Place::Rotors, "spin"), ["P", "N"]);
    assert!(words(Place::Top, "allow").contains(&"tip_speed"));
    assert!(words(Place::Plan, "samples").is_empty());
}

/// Values of `"enum"` in a schema, at any depth.
fn enumerations(schema: &serde_json::Value, found: &mut Vec<BTreeSet<String>>) {
    match schema {
        serde_json::Value::Object(fields) => {
            let values = fields.get("enum").and_then(serde_json::Value::as_array);
            found.extend(values.map(|all| all.iter().filter_map(|v| v.as_str()).map(String::from).collect()));
            fields.values().for_each(|inner| enumerations(inner, found));
        }
        serde_json::Value::Array(all) => all.iter().for_each(|inner| enumerations(inner, found)),
        _ => {}
    }
}

#[test]
fn the_schemas_of_reports_have_the_same_words() {
    let mut found = Vec::new();
    for name in ["report", "campaign", "simulate", "certificate"] {
        let text = read(&format!("docs/schema/{name}.schema.json"));
        enumerations(&serde_json::from_str(&text).unwrap(), &mut found);
    }
    let mut compared = 0;
    for (group, entry) in entries().filter(|(_, entry)| matches!(entry.takes, Takes::Words(_))) {
        let own: BTreeSet<String> = entry.words().iter().map(ToString::to_string).collect();
        // A word such as `never` belongs to more than one field, so two must be common.
        let shared = |values: &&BTreeSet<String>| own.intersection(values).count() >= 2;
        let reported = found.iter().filter(shared).collect::<Vec<_>>();
        let is_same = reported.iter().any(|values| own.is_subset(values));
        assert!(reported.is_empty() || is_same, "{} of {group:?}: {own:?} against {reported:?}", entry.name);
        compared += usize::from(is_same);
    }
    assert!(compared >= 6, "{compared}");
}
