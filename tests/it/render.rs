//! The three renderings of a diagnostic.

use mavc::diagnostic::{Diagnostic, render_human, render_short, sort, to_json_line};
use mavc::source::{FileId, Source, SourceMap, Span};
use serde_json::{Value, json};

/// Two files, and a diagnostic in the second with a label in each.
fn example() -> (Diagnostic, SourceMap) {
    let mut sources = SourceMap::default();
    let first = sources.add(Source::new("vehicles/a.mav", "// α\nvehicle octo {\n}\n"));
    let second = sources.add(Source::new("b.mav", "let x = \"é\"\nvehicle octo { }\n"));
    let name = |file: FileId, text: &str| {
        let start = text.find("octo").unwrap();
        Span::new(file, start, start + 4)
    };
    let (one, two) = (name(first, &sources.get(first).text), name(second, &sources.get(second).text));
    let diagnostic = Diagnostic::error("mavc::name::duplicate", two, "the name `octo` is given twice")
        .here("the second")
        .also(one, "the first")
        .also(Span::new(second, 4, 5), "beside it")
        .help("rename one")
        .fix(two, "other");
    (diagnostic, sources)
}

#[test]
fn labels_in_another_file_are_shown_with_its_lines() {
    let (diagnostic, sources) = example();
    insta::assert_snapshot!(render_human(&[diagnostic], &sources, 80, false));
}

/// A name that is unknown at three places is one mistake; another name and a diagnostic with labels are others.
#[test]
fn a_repeated_mistake_is_shown_once_with_its_other_lines() {
    let mut sources = SourceMap::default();
    let text = "let a = b\nlet c = b\nlet d = e\nlet f = [b, b]\n";
    let file = sources.add(Source::new("t.mav", text));
    let unknown = |name: &str, at: usize| {
        let span = Span::new(file, at, at + 1);
        Diagnostic::error("mavc::name::unknown", span, format!("unknown name `{name}`")).here("not declared")
    };
    let places: Vec<usize> =
        text.match_indices(['b', 'e']).map(|(at, _)| at).filter(|at| text[..*at].ends_with(['=', ' ', '['])).collect();
    let found: Vec<Diagnostic> =
        places.iter().filter(|at| !text[..**at].ends_with("l")).map(|&at| unknown(&text[at..=at], at)).collect();
    assert_eq!(found.len(), 5);
    let shown = render_human(&found, &sources, 80, false);
    assert_eq!(shown.matches("unknown name `b`").count(), 1, "{shown}");
    assert_eq!(shown.matches("unknown name `e`").count(), 1, "{shown}");
    assert_eq!(shown.matches("  also in lines 2 and 4\n").count(), 1, "{shown}");
    // Programs get every place.
    assert_eq!(render_short(&found, &sources).lines().count(), 5);
}

#[test]
fn color_is_only_there_when_asked_for() {
    let (diagnostic, sources) = example();
    assert!(!render_human(std::slice::from_ref(&diagnostic), &sources, 80, false).contains('\u{1b}'));
    assert!(render_human(&[diagnostic], &sources, 80, true).contains('\u{1b}'));
}

#[test]
fn a_json_line_has_every_place_in_scalars_from_one() {
    let (diagnostic, sources) = example();
    let line = to_json_line(&diagnostic, &sources);
    assert!(!line.contains('\n'));
    let record: Value = serde_json::from_str(&line).unwrap();
    let place = |file: &str, line: u32, from: u32, to: u32| json!({"file": file, "line": line, "column": from, "end_line": line, "end_column": to});
    let label = |message: &str, mut place: Value| {
        place["message"] = json!(message);
        place
    };
    let mut wanted = place("b.mav", 2, 9, 13);
    wanted["code"] = json!("mavc::name::duplicate");
    wanted["severity"] = json!("error");
    wanted["message"] = json!("the name `octo` is given twice");
    wanted["help"] = json!("rename one");
    wanted["labels"] = json!([
        label("the second", place("b.mav", 2, 9, 13)),
        label("the first", place("vehicles/a.mav", 2, 9, 13)),
        label("beside it", place("b.mav", 1, 5, 6)),
    ]);
    let mut fix = place("b.mav", 2, 9, 13);
    fix["text"] = json!("other");
    wanted["fixes"] = json!([fix]);
    assert_eq!(record, wanted);
}

#[test]
fn a_short_line_is_file_line_column() {
    let (diagnostic, sources) = example();
    let short = render_short(&[diagnostic], &sources);
    assert_eq!(short, "b.mav:2:9: error[mavc::name::duplicate]: the name `octo` is given twice\n");
}

#[test]
fn diagnostics_are_sorted_by_place_and_said_once() {
    let at = |file, start| Span::new(FileId(file), start, start + 1);
    let error = |span, message: &str| Diagnostic::error("mavc::name::unknown", span, message);
    let warning = Diagnostic::warning("mavc::name::unused", at(0, 5), "w");
    let mut list = vec![
        error(at(1, 0), "d"),
        warning.clone(),
        error(at(0, 5), "b"),
        error(at(0, 5), "a"),
        error(at(0, 5), "b"),
        error(at(0, 2), "first"),
    ];
    sort(&mut list);
    let order: Vec<_> = list.iter().map(|d| d.message.as_str()).collect();
    assert_eq!(order, ["first", "a", "b", "w", "d"]);
}
