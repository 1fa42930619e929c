//! Ten and more mistakes in one spec, of every kind, as its author would type them: none hides another. The first lines
//! of each file of `tests/specs/many` name the line and the code of every mistake, `// 12 mavc::unit::missing`, or
//! `// parts/fleet.mav:7 mavc::unit::unknown` in a file that the spec uses. One run reports these errors and no others.
//! Once every fix of that run is made, only those errors of that run remain that had no fix.

use super::errors::{compile, specs};
use super::fixes::{Mended, told};
use mavc::diagnostic::{Diagnostic, Fix, Severity, render_short};
use mavc::source::SourceMap;
use std::path::Path;

/// File, empty for the spec itself, line and code.
type Mistake = (String, usize, String);

fn planted(text: &str) -> Vec<Mistake> {
    let header = text.lines().map_while(|line| line.strip_prefix("// ")?.split_once(' '));
    let mistakes = header.map_while(|(place, code)| {
        let (file, line) = place.rsplit_once(':').unwrap_or(("", place));
        Some((file.to_string(), line.parse().ok()?, code.to_string()))
    });
    let mut mistakes: Vec<Mistake> = mistakes.collect();
    mistakes.sort();
    mistakes
}

fn is_error(diagnostic: &&Diagnostic) -> bool {
    diagnostic.severity == Severity::Error
}

fn found(diagnostics: &[Diagnostic], sources: &SourceMap, main: &str) -> Vec<Mistake> {
    let mistake = |d: &Diagnostic| {
        let source = sources.get(d.span.file);
        let file = if source.name == main { "" } else { &source.name };
        (file.to_string(), source.place(d.span.start as usize).line, d.code.to_string())
    };
    let mut mistakes: Vec<Mistake> = diagnostics.iter().filter(is_error).map(mistake).collect();
    mistakes.sort();
    mistakes
}

/// What is in `a` and not in `b`.
fn without<T: PartialEq + Clone>(a: &[T], b: &[T]) -> Vec<T> {
    let mut rest = b.to_vec();
    let mut is_new = |item: &T| match rest.iter().position(|other| other == item) {
        Some(at) => {
            rest.remove(at);
            false
        }
        None => true,
    };
    a.iter().filter(|item| is_new(item)).cloned().collect()
}

/// The texts with every fix in them; of two that overlap, the first.
fn fixed(diagnostics: &[Diagnostic], sources: &SourceMap) -> Mended {
    let mut fixes: Vec<&Fix> = diagnostics.iter().filter(is_error).filter_map(|d| d.fix.as_ref()).collect();
    fixes.sort_by_key(|fix| (fix.span.file, fix.span.start, fix.span.end));
    let mut apart: Vec<&Fix> = Vec::new();
    for fix in fixes {
        if apart.last().is_none_or(|last| last.span.file != fix.span.file || last.span.end <= fix.span.start) {
            apart.push(fix);
        }
    }
    let mut mended = Mended::new();
    for fix in apart.iter().rev() {
        let source = sources.get(fix.span.file);
        let text = mended.entry(source.name.clone()).or_insert_with(|| source.text.clone());
        text.replace_range(fix.span.start as usize..fix.span.end as usize, &fix.text);
    }
    mended
}

/// Code and message: places move as fixes are made.
fn said<'d>(diagnostics: impl Iterator<Item = &'d Diagnostic>) -> Vec<(&'static str, String)> {
    diagnostics.map(|d| (d.code, d.message.clone())).collect()
}

fn check(path: &Path, failures: &mut Vec<String>) {
    let main = path.file_name().unwrap().to_str().unwrap();
    let text = std::fs::read_to_string(path).unwrap();
    let (first, sources) = compile(path, &|_, bytes| bytes);
    let (wanted, found) = (planted(&text), found(&first, &sources, main));
    assert!(wanted.len() >= 10, "{main} has {} mistakes", wanted.len());
    let (missed, surplus) = (without(&wanted, &found), without(&found, &wanted));
    if !missed.is_empty() || !surplus.is_empty() {
        let rendered = render_short(&first, &sources);
        failures.push(format!("{main}: missed {missed:#?}, and there are too many: {surplus:#?}\n{rendered}"));
    }
    let mut mended = Mended::new();
    let (mut after, mut left) = (first.clone(), sources.clone());
    let of_first: Vec<_> = said(first.iter());
    // Of two fixes that overlap the second is made in the next round.
    for _ in 0..4 {
        let known: Vec<Diagnostic> =
            after.iter().filter(|d| of_first.contains(&(d.code, d.message.clone()))).cloned().collect();
        mended.extend(fixed(&known, &left));
        (after, left) = told(path, &mended);
    }
    let had_no_fix = said(first.iter().filter(is_error).filter(|d| d.fix.is_none()));
    let new = without(&said(after.iter().filter(is_error)), &had_no_fix);
    if !new.is_empty() {
        let text = mended.get(main).map_or("", |text| text);
        let rendered = render_short(&after, &left);
        failures.push(format!("{main}: new after all fixes: {new:#?}\n{text}\n{rendered}"));
    }
}

#[test]
fn no_mistake_hides_another_and_no_fix_makes_a_new_one() {
    let (mut failures, mut files) = (Vec::new(), 0);
    for path in specs(&["many"]) {
        check(&path, &mut failures);
        files += 1;
    }
    assert!(failures.is_empty(), "{} failures\n{}", failures.len(), failures.join("\n"));
    assert!(files >= 12, "{files} files");
}
