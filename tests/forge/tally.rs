//! What became of all forgeries, as tables.

use super::kinds::{Kind, Known};
use mavc::verify::Premise;
use std::fmt::Write;
use std::process::ExitCode;

/// What the checker says of a forgery.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Outcome {
    /// With its headline: the checker was deceived.
    Accepted(String),
    /// Accepted, and what it does not show is named.
    Weaker,
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
    weaker: usize,
    rejected: usize,
    refused: usize,
    specs: std::collections::BTreeSet<&'static str>,
    /// Premise, tried, passed.
    premises: Vec<(Premise, usize, usize)>,
}

impl Row {
    fn of(kind: &Kind) -> Self {
        let premises = kind.premises.iter().map(|&premise| (premise, 0, 0)).collect();
        Row { name: kind.name, premises, ..Row::default() }
    }

    /// For each premise how many of those tried pass without it.
    fn passes(&self) -> String {
        let of = |(premise, tried, passed): &(Premise, usize, usize)| format!("{premise:?} {passed}/{tried}");
        self.premises.iter().map(of).collect::<Vec<_>>().join(", ")
    }
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
        let mut rows: Vec<Row> = kinds.iter().map(Row::of).collect();
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
                Outcome::Weaker => row.weaker += 1,
                Outcome::Rejected => row.rejected += 1,
                Outcome::Refused => row.refused += 1,
            }
            for (premise, passed) in result.without {
                let counts = row.premises.iter_mut().find(|p| p.0 == premise);
                counts.into_iter().for_each(|(_, tried, let_through)| {
                    *tried += 1;
                    *let_through += usize::from(passed);
                });
            }
        }
        failed.extend(rows.iter().filter(|r| r.made == 0).map(|r| format!("no forgery was made: {}", r.name)));
        let is_weaker = |kind: &Kind| matches!(kind.known, Known::Weaker(_));
        let never = kinds.iter().zip(&rows).filter(|(kind, row)| is_weaker(kind) && row.weaker == 0);
        failed.extend(never.map(|(kind, _)| format!("never accepted as weaker: {}", kind.name)));
        let of_kinds = |premise: Premise| {
            let counts = rows.iter().flat_map(|row| &row.premises).filter(|counts| counts.0 == premise);
            counts.fold((premise, 0, 0), |sum, counts| (premise, sum.1 + counts.1, sum.2 + counts.2))
        };
        let premises: Vec<(Premise, usize, usize)> = Premise::ALL.iter().map(|&premise| of_kinds(premise)).collect();
        let untried =
            Premise::ALL.iter().filter(|premise| whole && !kinds.iter().any(|k| k.premises.contains(premise)));
        failed.extend(untried.map(|premise| format!("no kind is tried against {premise:?}")));
        let idle = premises.iter().filter(|p| whole && p.2 == 0);
        failed.extend(idle.map(|(premise, tried, _)| format!("none of {tried} passes without {premise:?}")));
        Tally { rows, premises, failed }
    }

    pub fn made(&self) -> usize {
        self.rows.iter().map(|r| r.made).sum()
    }

    /// Both tables, in Markdown.
    pub fn tables(&self) -> String {
        let mut text = String::from(
            "| kind | specs | made | accepted | weaker | rejected | refused | pass without |\n\
             |---|---|---|---|---|---|---|---|\n",
        );
        let mut line = |name: &str, specs: usize, counts: [usize; 5], passes: &str| {
            let [made, accepted, weaker, rejected, refused] = counts;
            let counts = format!("{made} | {accepted} | {weaker} | {rejected} | {refused}");
            writeln!(text, "| {name} | {specs} | {counts} | {passes} |").expect("a string");
        };
        for r in &self.rows {
            line(r.name, r.specs.len(), [r.made, r.accepted, r.weaker, r.rejected, r.refused], &r.passes());
        }
        let sum = |of: fn(&Row) -> usize| self.rows.iter().map(of).sum();
        let sums = [sum(|r| r.made), sum(|r| r.accepted), sum(|r| r.weaker), sum(|r| r.rejected), sum(|r| r.refused)];
        let every: std::collections::BTreeSet<_> = self.rows.iter().flat_map(|r| &r.specs).collect();
        line("all", every.len(), sums, "");
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
