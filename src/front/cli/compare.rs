//! `mavc compare`: runs every planner, side by side.

use super::progress::Watch;
use super::results::{Names, Places, Results, subject};
use super::spec::{self, Start};
use super::{CommandError, CompareArgs, Options, code_of};
use crate::pipeline::Task;
use crate::read::FlightBlocks;
use crate::report::page::{self, Beside, PageKind};
use crate::report::screen::Screen;
use crate::report::{comparison_screen, comparison_text};

pub fn run(args: &CompareArgs, options: &Options) -> Result<u8, CommandError> {
    let places = Places::new(Names {
        report: args.report.as_deref(),
        page: args.html.as_deref(),
        charts: args.svg.as_deref(),
        ..Names::default()
    })?;
    let watch = Watch::new(options);
    let (spec, mut findings) = spec::read(&args.spec, FlightBlocks::Unused, &watch)?;
    places.spare(&findings)?;
    let task = match findings.start(spec.as_ref(), Task::to_compare, options) {
        Start::Task(task) => task,
        Start::Refused => return places.refuse(spec.as_ref(), &findings, options),
        Start::Ended(code) => return Ok(code),
    };
    let comparison = task.compare(&watch);
    let problem = task.problem();
    let mut record = task.comparison_report(&comparison);
    record.recoverable = task.recoverable(&watch);
    let mut results = Results::new(&places);
    results.report(&record)?;
    results.page(|| {
        page::plans(PageKind::Compare, &subject(&task, &findings.diagnostics), &comparison, &record, Beside::default())
    });
    results.print(&match options.verbose {
        true => Screen::of_text(&comparison_text::compare(problem, &comparison, record.recoverable.as_ref())),
        false => comparison_screen::screen(problem, &comparison, record.recoverable.as_ref()),
    })?;
    results.charts(&subject(&task, &[]), &comparison)?;
    results.write()?;
    results.note_page(options)?;
    Ok(code_of(comparison.verdict(problem)))
}
