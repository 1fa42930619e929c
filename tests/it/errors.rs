//! The error corpus: every file under `tests/specs/errors/<stage>/` is rejected at that stage, with the codes that
//! its first lines name and the messages in `messages.snap`.

use mavc::diagnostic::{Diagnostic, render_human, sort};
use mavc::read::{elaborate, entries, load_among};
use mavc::source::{Source, SourceMap};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// All that one file gives, up to the stage its folder names. What it uses stands in folders beside it. `mend` sees the
/// name and the bytes of every file that is read.
pub fn compile(path: &Path, mend: &dyn Fn(&str, Vec<u8>) -> Vec<u8>) -> (Vec<Diagnostic>, SourceMap) {
    let name = path.file_name().unwrap().to_str().unwrap();
    let stage = path.parent().unwrap().file_name().unwrap();
    let bytes = mend(name, std::fs::read(path).unwrap());
    if stage == "syntax" {
        let mut sources = SourceMap::default();
        let file = sources.add(Source::from_bytes(name, &bytes).unwrap());
        let diagnostics = mavc::syntax::parse(file, sources.get(file)).diagnostics;
        return (diagnostics, sources);
    }
    let folder = path.parent().unwrap();
    let (files, mut diagnostics) = load_among(
        name,
        &bytes,
        &|used| std::fs::read(folder.join(used)).map(|bytes| mend(&used.to_string_lossy(), bytes)),
        &|beside| entries(&folder.join(beside)),
    );
    diagnostics.extend(elaborate(&files, &[]).diagnostics);
    sort(&mut diagnostics);
    (diagnostics, files.sources)
}

/// `error: mavc::syntax::depth`, one for each comment line at the top of the file.
fn expected(text: &str) -> Vec<&str> {
    text.lines().map_while(|line| line.strip_prefix("// ")).take_while(|line| line.contains(": mavc::")).collect()
}

/// The specs in folders of `tests/specs`, in order. (`insta::glob!` would also count failed snapshots of other tests.)
pub fn specs(folders: &[&str]) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/specs");
    let entries = |folder: &&str| std::fs::read_dir(root.join(folder)).unwrap().map(|entry| entry.unwrap().path());
    let mut specs: Vec<PathBuf> = folders.iter().flat_map(entries).collect();
    specs.retain(|path| path.extension().is_some_and(|e| e == "mav"));
    specs.sort();
    specs
}

/// The folders of the error corpus.
pub const STAGES: [&str; 3] = ["errors/model", "errors/syntax", "errors/unit"];

/// Codes, messages and helps of one file.
fn listed(path: &Path, diagnostics: &[Diagnostic], sources: &SourceMap) -> String {
    let mut text = format!("{}\n", path.file_name().unwrap().to_str().unwrap());
    for diagnostic in diagnostics {
        let line = sources.get(diagnostic.span.file).place(diagnostic.span.start as usize).line;
        text += &format!("  {line}: {} {}: {}\n", diagnostic.severity.name(), diagnostic.code, diagnostic.message);
        diagnostic.help.iter().flat_map(|help| help.lines()).for_each(|help| text += &format!("      {help}\n"));
    }
    text
}

/// The columns of a usual terminal.
const COLUMNS: usize = 80;
/// A label has so many columns at least, behind its mark.
const LEAST_LABEL: usize = 24;

/// Whether a line is wider than a terminal, although neither a line of source nor the place that a label marks is.
fn is_too_wide(line: &str) -> bool {
    let text = line.trim_start();
    let is_source = text.starts_with(|c: char| c.is_ascii_digit());
    let letters: Vec<char> = line.chars().collect();
    let label = letters.iter().rposition(|c| "╰├┤│".contains(*c)).unwrap_or(0);
    let underline = text.starts_with('·') && letters.iter().all(|c| " ·─┬▲".contains(*c));
    let is_label_of_wide_source = text.starts_with('·') && label + 4 + LEAST_LABEL + 1 > COLUMNS;
    letters.len() > COLUMNS && !is_source && !underline && !is_label_of_wide_source
}

/// One snapshot lists the messages of all files; the first file with a code also has one of how it is rendered.
#[test]
fn every_file_is_rejected_as_it_says() {
    let (mut failures, mut messages, mut too_wide) = (Vec::new(), String::new(), Vec::<String>::new());
    let mut rendered_codes = BTreeSet::new();
    let mut settings = insta::Settings::clone_current();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for path in specs(&STAGES) {
        let (diagnostics, sources) = compile(&path, &|_, bytes| bytes);
        let found: Vec<String> = diagnostics.iter().map(|d| format!("{}: {}", d.severity.name(), d.code)).collect();
        let rendered = render_human(&diagnostics, &sources, COLUMNS, false);
        let text = std::fs::read_to_string(&path).unwrap();
        let wanted = expected(&text);
        if found != wanted || wanted.is_empty() {
            failures.push(format!("{} names {wanted:#?} and gives {found:#?}\n{rendered}", path.display()));
        }
        messages += &listed(&path, &diagnostics, &sources);
        too_wide.extend(
            rendered.lines().filter(|line| is_too_wide(line)).map(|line| format!("{}: {line}", path.display())),
        );
        if diagnostics.iter().filter(|d| rendered_codes.insert(d.code)).count() > 0 {
            settings.set_snapshot_path(path.parent().unwrap());
            settings.bind(|| insta::assert_snapshot!(path.file_stem().unwrap().to_str().unwrap(), rendered));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(too_wide.is_empty(), "{}", too_wide.join("\n"));
    settings.set_snapshot_path("../specs/errors");
    settings.bind(|| insta::assert_snapshot!("messages", messages));
}

#[test]
fn every_mismatch_shows_both_sides_factor_by_factor() {
    const SIDES: [[&str; 2]; 4] = [["expected", "found"], ["left", "right"], ["first", "other"], ["start", "end"]];
    let mut count = 0;
    for path in [specs(&STAGES), specs(&["several"])].concat() {
        let (diagnostics, _) = compile(&path, &|_, bytes| bytes);
        for diagnostic in diagnostics.iter().filter(|d| d.code == "mavc::unit::mismatch") {
            let help = diagnostic.help.as_deref().unwrap_or("");
            let rows: Vec<&str> = help.lines().take(2).filter_map(|row| row.split_whitespace().next()).collect();
            let shown = SIDES.iter().any(|sides| sides[..] == rows[..]);
            assert!(shown, "{}: {}\n{help}", path.display(), diagnostic.message);
            count += 1;
        }
    }
    assert!(count > 30, "{count} mismatches");
}
