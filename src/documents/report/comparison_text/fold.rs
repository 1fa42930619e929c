//! Runs with the same plan, joined into one line that names them all.

use super::name_of;
use crate::model::PlannerKind;
use crate::motion::outside::Outside;
use crate::planner::studies::{Comparison, MissionPlan, NotFound, PlanOutcome, PlannerRun, Proof, Run};
use crate::report::mode_names::ranges;
use crate::text_table::indented;

/// Longest name in the first column; longer ones are written out in a note below the table.
const LONGEST_NAME: usize = 36;

/// Two plans with the same trajectory are the same if their margins differ by at most this share of the healthy set's
/// width, and their times by at most [`SECONDS`].
const MARGIN: f64 = 1e-5;
/// s
const SECONDS: f64 = 1e-3;

/// Runs with the same result, in their order; at least one.
pub struct Fold<'c> {
    pub runs: Vec<&'c PlannerRun>,
    modes: &'c [String],
}

/// The runs of one kind; runs with the same plan are joined at the position of the first of them.
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

/// Whether two runs have the same plan, or are RCP runs for single modes that failed in the same way.
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

/// Whether two plans are the same up to the solver's last digits: at every node, and in their violations of the sets.
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

/// `M1, M3 .. M6`
fn named(all: &[String], places: &[usize]) -> String {
    ranges(all, places).into_iter().map(|(name, _)| name).collect::<Vec<_>>().join(", ")
}

fn is_of_one_mode(run: &PlannerRun) -> bool {
    run.planner == PlannerKind::Rcp && run.against.len() == 1
}

impl Fold<'_> {
    pub fn outcome(&self) -> &PlanOutcome {
        &self.runs[0].outcome
    }

    /// `RIP, RCP M1, M3 .. M6, RSP`: all runs by name, consecutive modes as ranges.
    pub fn name(&self) -> String {
        let single: Vec<usize> =
            self.runs.iter().filter(|run| is_of_one_mode(run)).filter_map(|r| self.place(r)).collect();
        let mut names = Vec::new();
        let mut listed = false;
        for run in &self.runs {
            match is_of_one_mode(run) {
                false => names.push(name_of(run)),
                true if listed => {}
                true => {
                    listed = true;
                    names.push(format!("RCP {}", named(self.modes, &single)));
                }
            }
        }
        names.join(", ")
    }

    /// The name if it is short; otherwise that of the first run and the number of others.
    pub fn short_name(&self) -> String {
        let whole = self.name();
        match self.runs.len() - 1 {
            more if whole.chars().count() > LONGEST_NAME && more > 0 => {
                format!("{} and {more} more", name_of(self.runs[0]))
            }
            _ => whole,
        }
    }

    /// A paragraph with the whole name if the short name omits something; otherwise empty.
    pub fn note(&self) -> String {
        let (whole, short) = (self.name(), self.short_name());
        if whole == short {
            return String::new();
        }
        indented(&format!("{short}: {whole}."))
    }

    /// The number of rows at each node, which may differ between runs with the same plan: `52`, `52 to 60`.
    pub fn rows(&self) -> String {
        let rows = || self.runs.iter().map(|run| run.set.rows.len());
        match (rows().min().unwrap_or(0), rows().max().unwrap_or(0)) {
            (least, most) if least == most => least.to_string(),
            (least, most) => format!("{least} to {most}"),
        }
    }

    /// The index of a run's single mode among those of the comparison.
    fn place(&self, run: &PlannerRun) -> Option<usize> {
        self.modes.iter().position(|mode| *mode == run.against[0])
    }
}
