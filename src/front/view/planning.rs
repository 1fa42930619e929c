//! One look at a spec: its diagnostics, the verdicts on its fault modes, its plan, and the page of these.

use super::board::Board;
use crate::cancel::{Cancel, NoResult};
use crate::diagnostic::{Diagnostic, render_human, sort};
use crate::observer::{Observer, Stages, Trial, trial_text};
use crate::pipeline::{Task, analyze};
use crate::report::page::{self, Beside, PageKind, Subject};
use crate::report::{analysis_text, headline};
use crate::source::SourceMap;
use crate::spec::{Compiled, Spec};

/// Columns of diagnostics: those of a wide terminal.
const WIDTH: usize = 100;
/// Bytes of stack of a thread that plans: as much as those of a main program.
const STACK: usize = 8 << 20;

/// Progress as the page shows it.
struct Progress<'a> {
    board: &'a Board,
    /// The planner whose plan is wanted, in upper case.
    wanted: String,
}

impl Stages for Progress<'_> {}

impl Observer for Progress<'_> {
    fn begins(&self, what: &str) {
        self.board.progress(what.to_string());
    }

    fn tries(&self, planner: &str, trial: Trial) {
        self.board.progress(trial_text(Some(&self.wanted), planner, trial));
    }
}

/// Looks at a spec and puts what it finds on the board, until `cancel` cancels it.
pub fn look(compiled: Compiled, board: &Board, cancel: &Cancel) {
    let Compiled { spec, diagnostics, files } = compiled;
    let text = human(&diagnostics, &files.sources);
    let Some(spec) = spec else {
        // Nothing is known of the vehicle of this text.
        board.judge(String::new(), String::new());
        return board.refuse(text);
    };
    board.begin(text);
    match cancel.within(rayon::current_num_threads(), STACK, || plan(&spec, &diagnostics, board)) {
        // Somebody else puts up what comes next.
        Ok(()) | Err(NoResult::Cancelled(_)) => {}
        Err(NoResult::NoThreads(why)) => board.refuse(format!("mavc has no threads to plan with: {why}")),
        Err(NoResult::Panicked(_)) => {
            board.refuse("mavc failed at this spec, which is a mistake in mavc: its message is in the terminal".into());
        }
    }
}

fn human(diagnostics: &[Diagnostic], sources: &SourceMap) -> String {
    render_human(diagnostics, sources, WIDTH, false)
}

fn plan(spec: &Spec, read: &[Diagnostic], board: &Board) {
    let modes = analyze(spec);
    let verdicts = analysis_text::analysis(spec.model(), &modes);
    board.judge(headline::headline(spec.model(), &modes), verdicts);
    let with = |found: &[Diagnostic]| {
        let mut all = [read, found].concat();
        sort(&mut all);
        all
    };
    let task = match Task::new(spec) {
        Ok(task) => task,
        Err(refusal) => return board.refuse(human(&with(refusal.diagnostics()), spec.sources())),
    };
    let diagnostics = with(task.remarks());
    board.begin(human(&diagnostics, spec.sources()));
    let progress = Progress { board, wanted: task.model().plan.planner.name().to_uppercase() };
    let planning = task.plan(&progress);
    const SAME: &str = "the plan is of this spec";
    let explained = task.explain(&planning, &progress).expect(SAME);
    let between = planning.between(&task, &progress).expect(SAME);
    progress.begins("drawing the page");
    let record = task.report(&planning, &explained, between);
    let shown: Vec<Diagnostic> = diagnostics.into_iter().chain(task.diagnose(&explained)).collect();
    let subject = Subject { problem: task.problem(), sources: spec.sources(), diagnostics: &shown };
    let curves = task.capture_curves(&planning);
    let page = page::plans(
        PageKind::Plan,
        &subject,
        planning.comparison(),
        &record,
        Beside { captures: &curves, recovery: None },
    );
    board.publish(&page, human(&shown, spec.sources()));
}
