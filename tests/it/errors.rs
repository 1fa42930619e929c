//! The error corpus: every file under `tests/specs/errors/<stage>/` is rejected at that stage, with the codes that
//! its first lines name and with the message in the snapshot beside it.

use mavc::diagnostic::{Diagnostic, render_human, sort};
use mavc::source::SourceMap;
use std::path::Path;
use std::sync::Mutex;

/// All that one file's text gives, up to the stage its folder names. Paths in it count from its folder.
fn compile(stage: &str, folder: &Path, name: &str, text: &str) -> (Vec<Diagnostic>, SourceMap) {
    let read = |path: &Path| std::fs::read(folder.join(path));
    let (set, mut diagnostics) = mavc::model::load(name, text.as_bytes(), &read);
    if stage != "syntax" {
        diagnostics.extend(mavc::model::elaborate(&set, &[]).diagnostics);
    }
    sort(&mut diagnostics);
    (diagnostics, set.sources)
}

/// `error: mavc::syntax::depth`, one for each comment line at the top of the file.
fn expected(text: &str) -> Vec<&str> {
    text.lines()
        .map_while(|line| line.strip_prefix("// "))
        .take_while(|line| line.contains(": mavc::"))
        .collect()
}

/// What is wrong with the corpus at this file, if anything.
fn check(path: &Path) -> Option<String> {
    let folder = path.parent().unwrap();
    let stage = folder.file_name().unwrap().to_str().unwrap();
    let name = path.file_name().unwrap().to_str().unwrap();
    let text = std::fs::read_to_string(path).unwrap();
    let (diagnostics, sources) = compile(stage, folder, name, &text);
    let found: Vec<String> = diagnostics
        .iter()
        .map(|d| format!("{}: {}", d.severity.name(), d.code))
        .collect();
    let rendered = render_human(&diagnostics, &sources, 100, false);
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(folder);
    settings.set_snapshot_suffix("");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings
        .bind(|| insta::assert_snapshot!(path.file_stem().unwrap().to_str().unwrap(), rendered));
    let wanted = expected(&text);
    (found != wanted || wanted.is_empty())
        .then(|| format!("{stage}/{name} names {wanted:#?} and gives {found:#?}\n{rendered}"))
}

#[test]
fn every_file_is_rejected_as_it_says() {
    let failures = Mutex::new(Vec::new());
    insta::glob!("../specs/errors", "*/*.mav", |path| failures
        .lock()
        .unwrap()
        .extend(check(path)));
    let failures = failures.into_inner().unwrap();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
