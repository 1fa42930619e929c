//! What is written by hand about the columns of rows, against their table (`src/flights/campaign/columns.rs`).

use mavc::campaign::columns::{COLUMNS, Column, ColumnKind, table};

const PAGE: &str = "docs/campaigns.md";

fn path(name: &str) -> String {
    format!("{}/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// The page with its table of columns written anew.
fn renewed(text: &str) -> String {
    let start = text.find("| column |").expect("a table of columns");
    let rest: String = text[start..].split_inclusive('\n').skip_while(|line| line.starts_with('|')).collect();
    format!("{}{}{rest}", &text[..start], table())
}

#[test]
fn the_page_has_the_table_of_columns() {
    let text = std::fs::read_to_string(path(PAGE)).unwrap();
    let renewed = renewed(&text);
    if std::env::var_os("MAVC_UPDATE").is_some() {
        return std::fs::write(path(PAGE), renewed).unwrap();
    }
    assert!(text == renewed, "{PAGE} differs from the columns: MAVC_UPDATE=1 cargo test --test it columns");
}

#[test]
fn a_stale_table_is_found() {
    let text = std::fs::read_to_string(path(PAGE)).unwrap();
    let stale = text.replacen("largest tilt", "tilt", 1);
    assert!(stale != text && renewed(&stale) == renewed(&text));
}

#[test]
fn names_end_in_their_units() {
    for Column { name, unit, kind, .. } in &COLUMNS {
        let suffix = if unit.is_empty() { String::new() } else { format!("_{unit}") };
        assert!(name.ends_with(&suffix), "{name}");
        assert_eq!(unit.is_empty(), *kind != ColumnKind::Number, "{name}");
    }
}

/// The Python package makes arrays of these types.
#[test]
fn python_knows_the_types_of_the_columns() {
    let text = std::fs::read_to_string(path("python/mavc/table.py")).unwrap();
    let listed = |kind: ColumnKind, is_optional: Option<bool>| {
        let own = COLUMNS.iter().filter(|c| c.kind == kind && is_optional.is_none_or(|is| c.is_optional == is));
        own.map(|c| format!("\"{}\"", c.name)).collect::<Vec<_>>().join(", ")
    };
    for line in [
        format!("_TEXTS = ({})", listed(ColumnKind::Text, None)),
        format!("_COUNTS = ({})", listed(ColumnKind::Count, Some(false))),
        format!("_MISSING_COUNTS = ({})", listed(ColumnKind::Count, Some(true))),
        format!("if name == {}:", listed(ColumnKind::Truth, None)),
    ] {
        assert!(text.contains(&line), "{line}");
    }
}
