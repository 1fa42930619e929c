//! docs/reproduction.md against a new computation: the same words, and numbers within what a plan leaves open.

#[path = "../../benches/reproduce/document.rs"]
mod document;

use document::exact;
use document::plans;
use mavc::model::PlannerKind;
use mavc::planner::timing::search::RESOLUTION;

/// A number of the page with how it is written and where it stands.
struct Number<'a> {
    text: &'a str,
    /// What follows it up to the next number.
    after: &'a str,
    /// Printed in the paper, or computed from sets alone, without a solver.
    exact: bool,
}

impl Number<'_> {
    fn value(&self) -> f64 {
        self.text.parse().unwrap_or_else(|_| panic!("{:?} is not a number", self.text))
    }

    fn in_seconds(&self) -> bool {
        self.after.strip_prefix(" s").is_some_and(|rest| !rest.starts_with(char::is_alphanumeric))
    }

    /// One unit of the last digit written.
    fn last_digit(&self) -> f64 {
        let (mantissa, exponent) = self.text.split_once('e').unwrap_or((self.text, "0"));
        let decimals = mantissa.split_once('.').map_or(0, |(_, d)| d.len() as i32);
        10f64.powi(exponent.parse::<i32>().expect("an exponent") - decimals)
    }

    /// By how much a new computation may differ.
    fn tolerance(&self) -> f64 {
        let value = self.value().abs();
        let is_count = !self.text.contains(['.', 'e']);
        if self.exact {
            // Rounding may fall to the other side; counts are counts.
            return if is_count { 0.0 } else { 1.01 * self.last_digit() };
        }
        if self.in_seconds() {
            // A shortest time is found on steps of this; near the step the solver's last digits decide. An instant
            // moves with the plan.
            return 1.01 * RESOLUTION;
        }
        if is_count {
            // A facet counts as violated from a ten-thousandth of the set's width on, and some violations are close to
            // that.
            return (0.03 * value).ceil().max(2.0);
        }
        // Plans are the solver's to about 1e-4; the last digit may round either way.
        1e-3 * value + 1.01 * self.last_digit()
    }
}

/// A line with `#` for each number, and the numbers. A number begins where no letter, digit or underscore stands
/// before it, so the 1 of M1 and of PPNNPPNN's rows is a word's.
fn split(line: &str, exact: impl Fn(usize) -> bool) -> (String, Vec<Number<'_>>) {
    let bytes = line.as_bytes();
    let digit = |i: usize| bytes.get(i).is_some_and(u8::is_ascii_digit);
    let mut words = String::new();
    let mut spans: Vec<(usize, usize)> = Vec::new();
    let (mut i, mut written) = (0, 0);
    while i < bytes.len() {
        let inside_word = i > 0 && (bytes[i - 1].is_ascii_alphanumeric() || bytes[i - 1] == b'_');
        if inside_word || !(digit(i) || (bytes[i] == b'-' && digit(i + 1))) {
            i += 1;
            continue;
        }
        let begin = i;
        i += 1;
        let mut whole = true;
        while digit(i) || (whole && bytes.get(i) == Some(&b'.') && digit(i + 1)) {
            whole &= digit(i);
            i += 1;
        }
        let signed = usize::from(bytes.get(i + 1) == Some(&b'-'));
        if bytes.get(i) == Some(&b'e') && digit(i + 1 + signed) {
            i += 1 + signed;
            while digit(i) {
                i += 1;
            }
        }
        words += &line[written..begin];
        words.push('#');
        written = i;
        spans.push((begin, i));
    }
    words += &line[written..];
    let ends = spans.iter().skip(1).map(|s| s.0).chain([line.len()]);
    let numbers = spans.iter().zip(ends);
    let numbers =
        numbers.map(|(&(a, b), end)| Number { text: &line[a..b], after: &line[b..end], exact: exact(a) }).collect();
    (words, numbers)
}

/// Every way in which `new` is not `old`.
fn differences(old: &str, new: &str) -> Vec<String> {
    let mut found = Vec::new();
    if old.lines().count() != new.lines().count() {
        found.push(format!("{} lines, now {}", old.lines().count(), new.lines().count()));
    }
    let (mut by_plans, mut header): (bool, Vec<&str>) = (false, Vec::new());
    for (number, (was, is)) in old.lines().zip(new.lines()).enumerate() {
        if was.starts_with("## ") {
            by_plans = ["## How the plans", "## Case", "## What changes"].iter().any(|h| was.starts_with(h));
        }
        match (was.starts_with('|'), header.is_empty()) {
            (true, true) => header = was.split('|').collect(),
            (false, _) => header.clear(),
            _ => {}
        }
        let from_paper = |line: &str, at: usize| {
            let cell = line[..at].matches('|').count();
            header.get(cell).is_some_and(|h| h.trim().ends_with("paper"))
        };
        let (words, numbers) = split(was, |at| !by_plans || from_paper(was, at));
        let (new_words, new_numbers) = split(is, |at| !by_plans || from_paper(is, at));
        if words != new_words {
            found.push(format!("line {}: {was}\n  is now: {is}", number + 1));
            continue;
        }
        for (a, b) in numbers.iter().zip(&new_numbers) {
            if (a.value() - b.value()).abs() > a.tolerance() {
                let line = number + 1;
                found.push(format!("line {line}: {} is now {} (within {}): {was}", a.text, b.text, a.tolerance()));
            }
        }
    }
    found
}

const REMEDY: &str = "cargo bench --bench reproduce -- --write, and read what changed";

fn page() -> String {
    let path = document::specs::root().join("docs/reproduction.md");
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

#[test]
#[ignore = "long"]
fn the_page_says_what_is_computed() {
    let page = page();
    let found = differences(&page, &document::whole(|| exact::written(&page).into()));
    assert!(found.is_empty(), "{REMEDY}\n{}", found.join("\n"));
}

#[test]
fn a_changed_page_is_noticed() {
    let page = "## Fault sets and verdicts\n\n| 1 | 0.1956 | agrees |\n\n## Case 1\n\n\
                | planner | T, paper | T | e_R m | pairs |\n|---|---|---|---|---|\n\
                | RCP M1 | 20 s | 16.00 s | 0.8951 | 57 |\n";
    assert!(differences(page, page).is_empty());
    let changes = [
        ("0.1956", "0.1958", true),
        ("0.1956", "0.1957", false),
        ("| agrees", "| differs", true),
        ("M1", "M2", true),
        ("20 s", "20.01 s", true),
        ("16.00 s", "16.05 s", false),
        ("16.00 s", "16.10 s", true),
        ("0.8951", "0.8955", false),
        ("0.8951", "0.9000", true),
        ("| 57", "| 59", false),
        ("| 57", "| 60", true),
        ("57 |", "57 | 3 |", true),
    ];
    for (from, to, noticed) in changes {
        let changed = page.replace(from, to);
        assert_ne!(page, changed);
        assert_eq!(!differences(page, &changed).is_empty(), noticed, "{from} -> {to}");
    }
}

/// Very long tests; see CONTRIBUTING.
mod thorough {
    use super::*;

    /// Searches in the exact model take minutes. Cheaper: the hover model's cells, and that RIP has a plan a little
    /// later than the page says, of which an evaluation of its own finds nothing outside.
    #[test]
    #[ignore = "long"]
    fn shortest_times_of_the_exact_model_are_reproduced() {
        let page = page();
        let rows: Vec<Vec<&str>> = exact::written(&page)
            .lines()
            .filter(|line| line.starts_with("| ") && !line.starts_with("| case"))
            .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
            .collect();
        let seconds = |cell: &str| cell.strip_suffix(" s").and_then(|t| t.parse::<f64>().ok()).expect(cell);
        assert_eq!(rows.len(), 4, "{REMEDY}");
        for row in &rows {
            let hover = plans::of_case(row[0].parse().expect("a case")).shortest(row[1]);
            assert!((seconds(row[2]) - hover).abs() < 1.01 * RESOLUTION, "{REMEDY}: {row:?}, now {hover}");
            assert!((seconds(row[3]) / seconds(row[2]) - row[4].parse::<f64>().unwrap()).abs() < 0.006, "{row:?}");
            assert_eq!(row[7], "never", "{row:?}");
        }
        let time = 1.1 * seconds(rows[0][3]);
        let spec = exact::exact_case(1, PlannerKind::Rip, Some(time));
        let planning = exact::plan(&spec).unwrap_or_else(|| panic!("no plan at {time} s, {REMEDY}"));
        let plan = planning.plan().unwrap();
        assert_eq!(exact::exactly(plan, spec.model(), &planning.set().rows).outside, 0.0);
    }
}
