//! Functions that the chapters of the method and the pages beside it name, next to an equation or in a listing, exist
//! in the modules named.

use std::path::{Path, PathBuf};

/// The index of the method, all of its chapters, and the pages beside it.
fn pages() -> Vec<PathBuf> {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
    let chapters = std::fs::read_dir(docs.join("method")).unwrap().map(|entry| entry.unwrap().path());
    let others = ["method.md", "certificates.md", "flight.md", "campaigns.md"].map(|name| docs.join(name));
    others.into_iter().chain(chapters).collect()
}

/// `a::b::f`, with a top-level module of the crate first.
fn is_path(word: &str) -> bool {
    let parts: Vec<&str> = word.split("::").collect();
    let is_name = |part: &&str| !part.is_empty() && part.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    parts.len() > 1 && parts.iter().all(is_name) && source(&parts[..1]).is_file()
}

/// The file of a module, `a::b`, where `a` may be in any room.
fn source(modules: &[&str]) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let rooms = [&root, &root.join("core")].map(|of| std::fs::read_dir(of).unwrap().map(|entry| entry.unwrap().path()));
    let files = rooms
        .into_iter()
        .flatten()
        .chain([root.clone()])
        .map(|room| modules.iter().fold(room, |path, module| path.join(module)).with_extension("rs"));
    files.into_iter().find(|file| file.is_file()).unwrap_or_default()
}

/// Whether the longest module path that has a file is followed by names of items in that file.
fn exists(path: &str) -> bool {
    let parts: Vec<&str> = path.split("::").collect();
    let Some(modules) = (1..=parts.len()).rev().find(|&n| source(&parts[..n]).is_file()) else { return false };
    let text = std::fs::read_to_string(source(&parts[..modules])).expect("a file that is there");
    let is_defined = |name: &&str| {
        ["fn ", "struct ", "enum ", "const "].iter().any(|kind| {
            text.match_indices(&format!("{kind}{name}")).any(|(at, found)| {
                !text[at + found.len()..].starts_with(|c: char| c.is_ascii_alphanumeric() || c == '_')
            })
        })
    };
    parts[modules..].iter().all(is_defined)
}

/// Words of code spans, and of text blocks.
fn named(page: &str) -> Vec<String> {
    let mut in_block = false;
    let mut found = Vec::new();
    for line in page.lines() {
        if line.starts_with("```") {
            in_block = line == "```text";
            continue;
        }
        let words: Vec<&str> = match in_block {
            true => line.split([' ', ',']).collect(),
            false => line.split('`').skip(1).step_by(2).collect(),
        };
        found.extend(words.into_iter().filter(|word| is_path(word)).map(String::from));
    }
    found
}

#[test]
fn functions_named_beside_equations_exist() {
    let mut count = 0;
    for path in pages() {
        let page = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        let all = named(&page);
        count += all.len();
        let missing: Vec<&String> = all.iter().filter(|path| !exists(path)).collect();
        assert!(missing.is_empty(), "{} names functions that do not exist: {missing:?}", path.display());
    }
    assert!(count > 80, "only {count} functions are named");
}

#[test]
fn a_missing_function_is_noticed() {
    assert!(exists("flatness::intermediates::Intermediates::wrench") && exists("verify::series"));
    assert!(!exists("flatness::intermediates::Intermediates::wrenches") && !exists("flatness::cours::Course"));
    assert_eq!(named("`flatness::lead` and `mavc::plan::coarse_grid`"), ["flatness::lead"]);
}
