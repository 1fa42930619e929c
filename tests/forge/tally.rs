//! What became of all forgeries, as tables.

use super::kinds::Kind;
use mavc::verify::Premise;
use std::fmt::Write;
use std::process::ExitCode;

/// What the checker says of a forgery.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Outcome {
    /// With its headline: the checker was deceived.
    Accepted(String),
    Rejected,
    /// Too costly to be decided.
    Refused,
    /// Nothing: it panicked, with every premise or without one.
    Panicked,
}

/// One forgery; nothing where none could be made.
#[derive(Debug, Clone, Default)]
pub struct Result {
    pub spec: &'static str,
    pub outcome: Option<Outcome>,
    /// Premises that were switched off, and whether it passed then.
    pub without: Vec<(Premise, bool)>,
}

#[derive(Debug, Clone, Default)]
struct Row {
    name: &'static str,
    made: usize,
    accepted: usize,
    rejected: usize,
    refused: usize,
    specs: std::collections::BTreeSet<&'static str>,
}

/// Counts of everything.
pub struct Tally {
    rows: Vec<Row>,
    /// Premise, tried, passed.
    premises: Vec<(Premise, usize, usize)>,
    /// What must not be.
    pub failed: Vec<String>,
}

impl Tally {
    /// `whole` where all kinds were asked for, so that every premise has to let some through.
    pub fn of(kinds: &[Kind], results: Vec<(usize, Result)>, whole: bool) -> Self {
        let mut rows: Vec<Row> = kinds.iter().map(|k| Row { name: k.name, ..Row::default() }).collect();
        let mut premises: Vec<(Premise, usize, usize)> = Premise::ALL.iter().map(|&p| (p, 0, 0)).collect();
        let mut failed = Vec::new();
        for (kind, result) in results {
            let row = &mut rows[kind];
            let Some(outcome) = result.outcome else { continue };
            row.made += 1;
            row.specs.insert(result.spec);
            match outcome {
                Outcome::Accepted(headline) => {
                    row.accepted += 1;
                    failed.push(format!("accepted: {} ({}): {headline}", row.name, result.spec));
                }
                Outcome::Panicked => failed.push(format!("panicked: {} ({})", row.name, result.spec)),
                Outcome::Rejected => row.rejected += 1,
                Outcome::Refused => row.refused += 1,
            }
            for (premise, passed) in result.without {
                let counts = premises.iter_mut().find(|p| p.0 == premise);
                counts.into_iter().for_each(|(_, tried, let_through)| {
                    *tried += 1;
                    *let_through += usize::from(passed);
                });
            }
        }
        failed.extend(rows.iter().filter(|r| r.made == 0).map(|r| format!("no forgery was made: {}", r.name)));
        let idle = premises.iter().filter(|p| whole && p.2 == 0);
        failed.extend(idle.map(|(premise, tried, _)| format!("none of {tried} passes without {premise:?}")));
        Tally { rows, premises, failed }
    }

    pub fn made(&self) -> usize {
        self.rows.iter().map(|r| r.made).sum()
    }

    /// Both tables, in Markdown.
    pub fn tables(&self) -> String {
        let mut text =
            String::from("| kind | specs | made | accepted | rejected | refused |\n|---|---|---|---|---|---|\n");
        let mut line = |name: &str, specs: usize, counts: [usize; 4]| {
            let [made, accepted, rejected, refused] = counts;
            writeln!(text, "| {name} | {specs} | {made} | {accepted} | {rejected} | {refused} |").expect("a string");
        };
        for r in &self.rows {
            line(r.name, r.specs.len(), [r.made, r.accepted, r.rejected, r.refused]);
        }
        let sum = |of: fn(&Row) -> usize| self.rows.iter().map(of).sum();
        let sums = [sum(|r| r.made), sum(|r| r.accepted), sum(|r| r.rejected), sum(|r| r.refused)];
        let every: std::collections::BTreeSet<_> = self.rows.iter().flat_map(|r| &r.specs).collect();
        line("all", every.len(), sums);
        text.push_str("\n| premise switched off | tried | forgeries that pass |\n|---|---|---|\n");
        for (premise, tried, passed) in &self.premises {
            writeln!(text, "| {premise:?} | {tried} | {passed} |").expect("a string");
        }
        text.push('\n');
        text
    }

    /// The last line, as other test programs print it: a test for each honest certificate, kind and premise.
    pub fn conclude(&self, specs: usize) -> ExitCode {
        let failed = self.failed.len();
        for why in self.failed.iter().take(40) {
            println!("FAILED: {why}");
        }
        let passed = (specs + self.rows.len() + self.premises.len()).saturating_sub(failed);
        let word = if failed == 0 { "ok" } else { "FAILED" };
        println!("\ntest result: {word}. {passed} passed; {failed} failed; 0 ignored; 0 measured; 0 filtered out");
        if failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }
}
