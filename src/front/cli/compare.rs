//! `mavc compare`: runs every planner, side by side.

use super::progress::Watch;
use super::results::{Names, Places, Results, subject};
use super::spec::{self, Start};
use super::{CommandError, CompareArgs, Options, code_of};
use crate::model::MAX_ROUNDS;
use crate::pipeline::Task;
use crate::read::FlightBlocks;
use crate::report::page::{self, PageKind};
use crate::report::screen::Screen;
use crate::report::{comparison_screen, comparison_text};

pub fn run(args: &CompareArgs, options: &Options) -> Result<u8, CommandError> {
    let wanted = args.rounds.as_deref().map(parse_rounds).transpose()?;
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
    let mut comparison = task.compare(&watch);
    let rounds = wanted.map(|wanted| task.rounds(&mut comparison, wanted, &watch));
    let problem = task.problem();
    let record = task.comparison_report(&comparison, rounds.as_deref());
    let mut results = Results::new(&places);
    results.report(&record)?;
    results.page(|| page::plans(PageKind::Compare, &subject(&task, &findings.diagnostics), &comparison, &record, &[]));
    results.print(&match options.verbose {
        true => Screen::of_text(&comparison_text::compare(problem, &comparison)),
        false => comparison_screen::screen(problem, &comparison),
    })?;
    if let Some(rounds) = &rounds {
        results.print(&Screen::of_text(&comparison_text::rounds(problem, &comparison, rounds)))?;
    }
    results.charts(&subject(&task, &[]), &comparison)?;
    results.write()?;
    results.note_page(options)?;
    Ok(code_of(comparison.verdict(problem)))
}

/// Reads `0..5` or `3`; both ends are included.
fn parse_rounds(text: &str) -> Result<(usize, usize), CommandError> {
    let (first, last) = text.split_once("..").unwrap_or((text, text));
    let whole = |t: &str| t.trim().parse::<usize>().ok().filter(|n| *n <= MAX_ROUNDS);
    match (whole(first), whole(last)) {
        (Some(a), Some(b)) if a <= b => Ok((a, b)),
        (Some(_), Some(_)) => Err(format!("--rounds {text}: the first number must be the smaller one, as in 0..5")),
        _ => Err(format!("--rounds {text}: write whole numbers up to {MAX_ROUNDS}, such as 0..5")),
    }
}
