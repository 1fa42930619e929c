//! Every fix that a diagnostic offers removes this diagnostic and adds no other, and making one fix after another comes
//! to an end.

use super::errors::{STAGES, compile, specs};
use mavc::diagnostic::{Diagnostic, Severity};
use mavc::source::SourceMap;
use std::collections::BTreeMap;
use std::path::Path;

/// The texts that fixes have changed, by file name.
pub type Mended = BTreeMap<String, String>;

pub fn told(path: &Path, mended: &Mended) -> (Vec<Diagnostic>, SourceMap) {
    compile(path, &|name, bytes| mended.get(name).map_or(bytes, |text| text.clone().into_bytes()))
}

/// The texts with one more fix in them.
fn apply(diagnostic: &Diagnostic, sources: &SourceMap, before: &Mended) -> Mended {
    let fix = diagnostic.fix.as_ref().unwrap();
    let source = sources.get(fix.span.file);
    let mut text = source.text.clone();
    text.replace_range(fix.span.start as usize..fix.span.end as usize, &fix.text);
    let mut after = before.clone();
    after.insert(source.name.clone(), text);
    after
}

/// How often each code is reported, without warnings: one may appear once no error hides it.
fn errors(diagnostics: &[Diagnostic]) -> BTreeMap<&'static str, usize> {
    let mut count = BTreeMap::new();
    let errors = diagnostics.iter().filter(|d| d.severity == Severity::Error);
    errors.for_each(|d| *count.entry(d.code).or_default() += 1);
    count
}

/// A text that ends in an open block may be cut off, so what the block is missing is not reported.
const CUT_OFF: &str = "mavc::syntax::unclosed_block";

/// Second errors that are reported once a value is known, each checked by eye: the file and the code that appears.
const REVEALED: [(&str, &str); 6] = [
    // Lagging rotors need more than the right word.
    ("rotors_word", "mavc::plan::time_constant"),
    // The estimator's rate is held against that of the controller.
    ("simulate_rates", "mavc::simulate::rates"),
    // Field and value are both misspelt.
    ("capitals", "mavc::vehicle::layout"),
    ("capitals", "mavc::plan::choice"),
    // The start needs its unit, and another waypoint after it.
    ("heads", "mavc::mission::too_few_waypoints"),
    // `max_speed` and `velocity` are both meant as `speed`.
    ("limits_as_people_write_them", "mavc::name::duplicate"),
];

/// What is wrong with one fix of one file, if anything.
fn fault(file: &str, diagnostic: &Diagnostic, before: &[Diagnostic], after: &[Diagnostic]) -> Option<String> {
    let same = |d: &&Diagnostic| d.code == diagnostic.code && d.message == diagnostic.message;
    let (had, has) = (before.iter().filter(same).count(), after.iter().filter(same).count());
    if has >= had {
        return Some(format!("is told {has} times after its fix, {had} before"));
    }
    let mut room = errors(before);
    if let Some(count) = room.get_mut(diagnostic.code) {
        *count -= usize::from(diagnostic.severity == Severity::Error);
    }
    let gained = errors(after).into_iter().find(|(code, count)| {
        let hidden = diagnostic.code == CUT_OFF && *code == "mavc::name::missing_field";
        let revealed = REVEALED.contains(&(file, code));
        !hidden && !revealed && *count > room.get(code).copied().unwrap_or(0)
    });
    gained.map(|(code, _)| format!("gives {code} after its fix"))
}

/// Every fix of a file alone, and then one after the other.
fn check(path: &Path, failures: &mut Vec<String>) -> usize {
    let file = path.file_stem().unwrap().to_str().unwrap();
    let (first, sources) = told(path, &Mended::new());
    let offered: Vec<&Diagnostic> = first.iter().filter(|d| d.fix.is_some()).collect();
    for diagnostic in &offered {
        let mended = apply(diagnostic, &sources, &Mended::new());
        let (after, left) = told(path, &mended);
        if let Some(fault) = fault(file, diagnostic, &first, &after) {
            let text = mended.values().next().unwrap();
            let rendered = mavc::diagnostic::render_short(&after, &left);
            failures.push(format!(
                "{}: {} `{}` {fault}\n{text}\n{rendered}",
                path.display(),
                diagnostic.code,
                diagnostic.message
            ));
        }
    }
    let mut mended = Mended::new();
    for _ in 0..3 * first.len() + 30 {
        let (now, sources) = told(path, &mended);
        let Some(next) = now.iter().find(|d| d.fix.is_some()) else {
            return offered.len();
        };
        mended = apply(next, &sources, &mended);
    }
    failures.push(format!("{}: the fixes come to no end\n{mended:#?}", path.display()));
    offered.len()
}

#[test]
fn every_fix_in_the_corpora_works_and_they_come_to_an_end() {
    let (mut failures, mut count) = (Vec::new(), 0);
    for path in [specs(&STAGES), specs(&["several"])].concat() {
        count += check(&path, &mut failures);
    }
    assert!(failures.is_empty(), "{} of {count} fixes fail\n{}", failures.len(), failures.join("\n"));
    assert!(count > 400, "{count} fixes");
}
