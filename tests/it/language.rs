//! The table of the language, and everything that repeats it: defaults, the language reference, the grammars of
//! editors.

mod generated;
mod sweepable;

use mavc::language::{Absent, Entry, FUNCTIONS, Group, OPENERS, Place, Takes, markdown, statement_markdown};
use mavc::model::{AfterFault, Allocation, Controller, PlanModel, PlanRotors, PlannerKind};
use mavc::read::vocabulary::{constants, functions, words};
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
        ("parts", markdown(Group::Parts)),
        ("part", markdown(Group::Part)),
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
        ("recovery", markdown(Group::Recovery)),
        ("landing site", markdown(Group::LandingSite)),
        ("area", markdown(Group::KeepOff)),
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

/// The value in SI units of one of a unit.
fn scale(unit: &str) -> f64 {
    let unit = parse_unit(unit, 9.81).unwrap();
    unit.numerator / unit.denominator
}

#[test]
fn the_further_columns_fit_their_rows() {
    for (group, entry) in entries() {
        let who = format!("{} of {group:?}", entry.name);
        for other in entry.excludes {
            assert!(*other != entry.name && (group.has(other) || Place::opens_statement(other)), "{who}: {other}");
            assert!(group.entry(other).is_none_or(|other| !other.excludes.contains(&entry.name)), "{who}: twice");
        }
        // Overrides reach the fields that rotors share, not the clauses of one rotor.
        let is_reached = group.path().is_some() || group == Group::PlacedRotor;
        assert!(!entry.sweepable || entry.unit().is_some() && is_reached, "{who}");
        assert!(entry.bounds.is_none_or(|(least, most)| least < most && entry.unit().is_some()), "{who}");
        assert!(entry.family.is_none() || entry.unit().is_some(), "{who}");
        let sizes = entry.likely;
        assert!(sizes.is_sorted_by(|a, b| a.0 < b.0), "{who}");
        assert!(sizes.is_sorted_by(|a, b| scale(a.1[0]) >= scale(b.1[0])), "larger numbers have smaller units: {who}");
        assert!(sizes.last().is_none_or(|(below, _)| *below == f64::INFINITY), "{who}");
        for unit in sizes.iter().flat_map(|(_, units)| *units) {
            let own = parse_unit(entry.unit().unwrap(), 9.81).unwrap();
            assert_eq!(parse_unit(unit, 9.81).unwrap().dimension, own.dimension, "{who}: {unit}");
        }
    }
}

/// Fields of one name and unit are bounded alike wherever they are written.
#[test]
fn rows_of_one_name_and_unit_have_the_same_bounds_and_likely_units() {
    for (group, entry) in entries() {
        let alike = entries().filter(|(_, other)| (other.name, other.unit()) == (entry.name, entry.unit()));
        for (other_group, other) in alike {
            let (own, its) = ((entry.bounds, entry.likely), (other.bounds, other.likely));
            assert_eq!(own, its, "{} of {group:?} and of {other_group:?}", entry.name);
        }
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

/// Its patterns of statements are written by hand, because each has its own form.
#[test]
fn the_textmate_grammar_has_every_statement() {
    let grammar = read("editors/vscode/syntaxes/mav.tmLanguage.json");
    let mut all = Vec::new();
    patterns(&serde_json::from_str(&grammar).unwrap(), &mut all);
    let is_letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let words: BTreeSet<&str> =
        all.iter().flat_map(|pattern| pattern.split(|c| !is_letter(c))).map(|w| w.trim_start_matches('b')).collect();
    for word in OPENERS.iter().flat_map(|(_, words)| *words) {
        assert!(words.contains(word.trim_start_matches('b')), "the TextMate grammar has no `{word}`");
    }
}

/// A snippet with a field that the language no longer has would insert a mistake.
#[test]
fn the_snippets_write_fields_of_the_language() {
    let snippets: serde_json::Value = serde_json::from_str(&read("editors/vscode/snippets/mav.json")).unwrap();
    let mut looked_at = 0;
    for body in snippets.as_object().unwrap().values().map(|snippet| &snippet["body"]) {
        let lines = body.as_array().into_iter().flatten().filter_map(|line| line.as_str());
        for line in lines {
            let mut words = line.split_whitespace();
            if let (Some(name), Some("=" | "<=")) = (words.next(), words.next()) {
                assert!(entries().any(|(_, entry)| entry.name == name), "{line}");
                looked_at += 1;
            }
        }
    }
    assert!(looked_at > 20, "{looked_at}");
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
    let reactions = [AfterFault::Continue, AfterFault::Hold, AfterFault::Land, AfterFault::Recovery];
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

/// A new limit counts after a fault too, unless it bounds a place or the yaw.
#[test]
fn limits_after_a_fault_are_those_of_no_place_and_no_yaw() {
    use mavc::language::table::{after_fault_limits, limits};
    let forms = |entry: &Entry| match entry.takes {
        Takes::Bound(_, forms) => format!("{forms:?}"),
        ref other => panic!("{}: {other:?}", entry.name),
    };
    let places = forms(&limits::X);
    let others = limits::ENTRIES.iter().filter(|entry| forms(entry) != places).map(|entry| entry.name);
    let after: Vec<&str> = after_fault_limits::ENTRIES.iter().map(|entry| entry.name).collect();
    assert_eq!(after, others.collect::<Vec<_>>());
}
