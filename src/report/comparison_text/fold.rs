//! Runs with one plan, told in one line that names them all.

use super::name_of;
use crate::model::PlannerKind;
use crate::motion::outside::Outside;
use crate::planner::studies::{Comparison, MissionPlan, NotFound, PlanOutcome, PlannerRun, Proof, Run};
use crate::report::terminal::WIDTH;

/// Names in the first column take no more room than this; where they need more, a note below the table has them.
const LONGEST_NAME: usize = 36;

/// Plans of one motion count as one that differ by no more than this: shares of the healthy set's width; s.
const MARGIN: f64 = 1e-5;
const SECONDS: f64 = 1e-3;

/// Runs that ended alike, in their order; at least one.
pub struct Fold<'c> {
    pub runs: Vec<&'c PlannerRun>,
    modes: &'c [String],
}

/// The runs of one kind, those with one plan together, where the first of them stands.
pub fn folded(comparison: &Comparison, which: Run) -> Vec<Fold<'_>> {
    let mut folds: Vec<Fold> = Vec::new();
    for run in comparison.runs.iter().filter(|run| run.run == which) {
        match folds.iter_mut().find(|fold| are_alike(fold.runs[0], run)) {
            Some(fold) => fold.runs.push(run),
            None => folds.push(Fold { runs: vec![run], modes: &comparison.modes }),
        }
    }
    folds
}

/// Whether two runs have one plan, or are RCP for single modes that ended without one in the same way.
fn are_alike(one: &PlannerRun, other: &PlannerRun) -> bool {
    match (&one.outcome, &other.outcome) {
        (PlanOutcome::Planned(a), PlanOutcome::Planned(b)) => have_one_plan(a, b),
        (PlanOutcome::Infeasible(Proof { .. }), PlanOutcome::Infeasible(Proof { .. }))
        | (PlanOutcome::NotFound(NotFound::Search { .. }), PlanOutcome::NotFound(NotFound::Search { .. })) => {
            is_of_one_mode(one) && is_of_one_mode(other)
        }
        _ => false,
    }
}

/// Whether two plans are one but for what the solver's last digits differ by: at every node, and in what is said of the sets.
fn have_one_plan(a: &MissionPlan, b: &MissionPlan) -> bool {
    let same_outside = |(p, q): (&Outside, &Outside)| {
        near(p.max_violation, q.max_violation, MARGIN)
            && near(p.seconds, q.seconds, SECONDS)
            && near(p.last.unwrap_or(0.0), q.last.unwrap_or(0.0), SECONDS)
    };
    a.time == b.time
        && a.trajectory.is_same_motion(&b.trajectory)
        && a.outside.iter().zip(&b.outside).all(same_outside)
        && a.committed.iter().zip(&b.committed).all(|(p, q)| near(*p, *q, SECONDS))
}

fn near(a: f64, b: f64, within: f64) -> bool {
    (a - b).abs() <= within
}

fn is_of_one_mode(run: &PlannerRun) -> bool {
    run.planner == PlannerKind::Rcp && run.against.len() == 1
}

impl Fold<'_> {
    pub fn outcome(&self) -> &PlanOutcome {
        &self.runs[0].outcome
    }

    /// `RIP, RCP M1, M3 .. M6, RSP`: all runs by name, modes that follow each other as ranges.
    pub fn name(&self) -> String {
        let single: Vec<usize> =
            self.runs.iter().filter(|run| is_of_one_mode(run)).filter_map(|r| self.place(r)).collect();
        let mut names = Vec::new();
        let mut told = false;
        for run in &self.runs {
            match is_of_one_mode(run) {
                false => names.push(name_of(run)),
                true if told => {}
                true => {
                    told = true;
                    names.push(format!("RCP {}", self.ranges(&single).join(", ")));
                }
            }
        }
        names.join(", ")
    }

    /// The name where it is short; otherwise that of the first run and how many more there are.
    pub fn short_name(&self) -> String {
        let whole = self.name();
        match self.runs.len() - 1 {
            more if whole.chars().count() > LONGEST_NAME && more > 0 => {
                format!("{} and {more} more", name_of(self.runs[0]))
            }
            _ => whole,
        }
    }

    /// What the short name leaves out, as a paragraph; nothing where it is whole.
    pub fn note(&self) -> String {
        let (whole, short) = (self.name(), self.short_name());
        if whole == short {
            return String::new();
        }
        let options = textwrap::Options::new(WIDTH).initial_indent("  ").subsequent_indent("  ");
        format!("{}\n", textwrap::fill(&format!("{short}: {whole}."), options))
    }

    /// The rows at each node, of which runs with one plan may have different numbers: `52`, `52 to 60`.
    pub fn rows(&self) -> String {
        let rows = || self.runs.iter().map(|run| run.set.rows.len());
        match (rows().min().unwrap_or(0), rows().max().unwrap_or(0)) {
            (least, most) if least == most => least.to_string(),
            (least, most) => format!("{least} to {most}"),
        }
    }

    /// The place of a run's one mode among those of the comparison.
    fn place(&self, run: &PlannerRun) -> Option<usize> {
        self.modes.iter().position(|mode| *mode == run.against[0])
    }

    /// Places as names, three and more of one `every` that follow each other as a range.
    fn ranges(&self, places: &[usize]) -> Vec<String> {
        let name = |place: usize| self.modes[place].clone();
        let family = |place: usize| self.modes[place].trim_end_matches(|c: char| c.is_ascii_digit() || c == '_');
        let runs = places.chunk_by(|a, b| a + 1 == *b && family(*a) == family(*b));
        runs.flat_map(|run| match run {
            [first, _, .., last] => vec![format!("{} .. {}", name(*first), name(*last))],
            few => few.iter().map(|place| name(*place)).collect(),
        })
        .collect()
    }
}
