//! Every code has a page, every page's code is used, and the pages' examples give the code they stand under.

use mavc::diagnostic::codes;
use mavc::source::{FileId, Source};
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

/// The first fenced block of a page whose info string is `info`.
fn fenced<'a>(page: &'a str, info: &str) -> Option<&'a str> {
    let (_, rest) = page.split_once(&format!("```{info}\n"))?;
    rest.split_once("```").map(|(text, _)| text)
}

fn syntax_codes(text: &str) -> Vec<&'static str> {
    let checked = mavc::syntax::parse(FileId(0), &Source::new("page.mav", text));
    checked.diagnostics.iter().map(|d| d.code).collect()
}

#[test]
fn examples_of_the_syntax_pages_give_their_code_and_their_mended_form_none() {
    let pages = codes::all().iter().filter(|p| p.code.starts_with("mavc::syntax::"));
    let mut examples = 0;
    for page in pages {
        if let Some(wrong) = fenced(page.page, "mav wrong") {
            let found = syntax_codes(wrong);
            assert!(!found.is_empty() && found.iter().all(|c| *c == page.code), "{}: {found:?}", page.code);
            examples += 1;
        }
        if let Some(right) = fenced(page.page, "mav") {
            assert_eq!(syntax_codes(right), Vec::<&str>::new(), "the mended example of {}", page.code);
        }
    }
    assert!(examples >= 20, "only {examples} pages have an example");
}
