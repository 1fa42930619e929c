//! Every code has a page, and every page's code is used.

use mavc::diagnostic::codes;
use std::collections::BTreeSet;
use std::path::Path;

/// The codes written as string literals in the sources, outside tests.
fn codes_in(folder: &Path, found: &mut BTreeSet<String>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            codes_in(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            let text = std::fs::read_to_string(&path).unwrap();
            let code = text.split("#[cfg(test)]").next().unwrap();
            for rest in code.split("\"mavc::").skip(1) {
                let end = rest.find(|c: char| !(c.is_ascii_lowercase() || c == '_' || c == ':')).unwrap();
                if end > 0 && rest[end..].starts_with('"') {
                    found.insert(format!("mavc::{}", &rest[..end]));
                }
            }
        }
    }
}

#[test]
fn codes_and_pages_are_the_same_set() {
    let mut used = BTreeSet::new();
    codes_in(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut used);
    let documented: BTreeSet<String> = codes::all().iter().map(|p| p.code.to_string()).collect();
    let without_page: Vec<_> = used.difference(&documented).collect();
    let without_use: Vec<_> = documented.difference(&used).collect();
    assert!(without_page.is_empty(), "codes without a page: {without_page:#?}");
    assert!(without_use.is_empty(), "pages for codes that nothing gives: {without_use:#?}");
}
