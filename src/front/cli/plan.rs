//! `mavc plan`: plans the mission and writes the results.

use super::exports::Export;
use super::progress::Watch;
use super::results::{Names, Places, Results, subject};
use super::signals::Enough;
use super::spec::{self, Start};
use super::{CUT_SHORT, CommandError, DenyOfPlan, INCONCLUSIVE, Options, PlanArgs, code_of, files};
use crate::cancel::{Cancel, NoResult};
use crate::diagnostic::Diagnostic;
use crate::exchange::mission;
use crate::model::MissionTime;
use crate::observer::{Observer, timed};
use crate::pipeline::{Explained, Planning, Task, certify, with_ways_out};
use crate::read::FlightBlocks;
use crate::recovery::Recovery;
use crate::report::page::{self, Beside, PageKind};
use crate::report::plan_screen::Covers;
use crate::report::recovery::{self as ways, RecoveryRecord};
use std::panic::resume_unwind;

pub fn run(args: &PlanArgs, options: &Options) -> Result<u8, CommandError> {
    let export = Export::of(args)?;
    let places = Places::new(Names {
        table: export.file(),
        report: args.report.as_deref(),
        certificate: args.certificate.as_deref(),
        page: args.html.as_deref(),
        charts: args.svg.as_deref(),
        ..Names::default()
    })?;
    let watch = Watch::new(options);
    let (spec, mut findings) = spec::read(&args.spec, FlightBlocks::Unused, &watch)?;
    places.spare(&findings)?;
    export.is_named_well()?;
    let task = match findings.start(spec.as_ref(), Task::new, options) {
        Start::Task(task) => task,
        Start::Refused => return places.refuse(spec.as_ref(), &findings, options),
        Start::Ended(code) => return Ok(code),
    };
    export.fits(task.model())?;
    watch.wants(task.model().plan.planner);
    let cancel = Cancel::new();
    let mut planning = plan(&task, &cancel, &watch)?;
    // A search that was cut short shows nothing about statements.
    let explained = match planning.was_cut_short() && planning.plan().is_none() {
        true => Explained::default(),
        false => task.explain(&planning, &watch).map_err(|e| e.to_string())?,
    };
    let wants_recovery = args.recovery || args.branches.is_some() || task.model().plan.recovery.require.is_some();
    let between = places.certificate.is_some();
    let recovery = match wants_recovery {
        true => task.recovery(&mut planning, between, &watch).map_err(|e| e.to_string())?,
        false => None,
    };
    let mut results = Results::new(&places);
    if places.certificate.is_some() {
        add_certificate(&mut results, &task, &planning, recovery.as_ref(), &watch)?;
    }
    let between = planning.between(&task, &watch).map_err(|e| e.to_string())?;
    let conflict = task.diagnose(&explained);
    let mut is_unsafe = false;
    timed(&watch, "report", || {
        if let Some(plan) = planning.plan() {
            export.add(&mut results, &plan.trajectory, &task, options)?;
        }
        let mut record = task.report(&planning, &explained, between.clone());
        let coverage = record.planners.iter().flat_map(|planner| &planner.coverage);
        is_unsafe = coverage.map(|sentence| sentence.covers).any(Covers::is_bad);
        record.recovery = recovery.as_ref().map(|found| RecoveryRecord::new(task.model(), found));
        if let (Some(folder), Some(found)) = (&args.branches, &recovery) {
            let mut files = ways::files(task.problem(), found)?;
            // If the mission says where it is.
            let map = mission::footprints(task.problem().mission(), &ways::footprints(task.model(), found));
            files.extend(map.map(|text| ("footprints.geojson".to_string(), text.into_bytes())));
            results.folder("a branch", "--branches", folder, files, task.spec().sources())?;
        }
        results.report(&record)?;
        let shown: Vec<Diagnostic> = findings.diagnostics.iter().chain(&conflict).cloned().collect();
        let comparison = planning.comparison();
        results.page(|| {
            let captures = &task.capture_curves(&planning);
            let beside = Beside { captures, recovery: recovery.as_ref() };
            page::plans(PageKind::Plan, &subject(&task, &shown), comparison, &record, beside)
        });
        let between = between.as_deref();
        let text = task.for_people(&planning, &explained, between, recovery.as_ref(), options.verbose);
        results.print(&text)?;
        results.charts(&subject(&task, &[]), comparison)?;
        results.write()?;
        results.print_beside(&text);
        conflict.iter().for_each(|why| findings.eprint_also(why));
        let gap = if options.verbose { "\n" } else { "" };
        match (planning.plan(), &args.output) {
            (Some(_), None) => {
                let hint = format!("{gap}No trajectory was written: name a file with -o traj.csv\n");
                results.hint(&hint, options)?;
            }
            (Some(_), Some(path)) => results.note(&format!("{gap}Trajectory"), Some(path), options)?,
            (None, _) => {}
        }
        results.note_page(options)
    })?;
    let is_denied = args.deny == Some(DenyOfPlan::Unsafe) && is_unsafe;
    let is_uncovered = recovery.as_ref().is_some_and(|found| task.exceeds_uncovered(found));
    Ok(if planning.was_cut_short() {
        print_cut_short(&planning);
        if args.accept_best { code_of(planning.verdict()) } else { CUT_SHORT }
    } else if is_denied || is_uncovered {
        INCONCLUSIVE
    } else {
        code_of(planning.verdict())
    })
}

/// Adds the certificate to the results, or prints why there is none.
fn add_certificate(
    results: &mut Results,
    task: &Task,
    planning: &Planning,
    recovery: Option<&Recovery>,
    watch: &Watch,
) -> Result<(), CommandError> {
    watch.begins("making the certificate");
    match timed(watch, "certify", || certify(task.spec(), planning)) {
        Ok(certificate) => results.certificate(&match recovery {
            Some(recovery) => with_ways_out(certificate, recovery),
            None => certificate,
        }),
        Err(why) => {
            files::eprint(&format!("mavc: no certificate was written: {why}\n"));
            Ok(())
        }
    }
}

fn print_cut_short(planning: &Planning) {
    files::eprint(match planning.plan() {
        Some(_) => {
            "mavc: the search was cut short: this is its best plan, and a longer search may find a shorter one\n"
        }
        None => "mavc: the search was cut short before it had a plan\n",
    });
}

/// Bytes of stack of a thread that plans: as much as those of the main program.
const STACK: usize = 8 << 20;

/// Plans the mission. Where its time is searched for, the first Ctrl-C ends the search with the best plan that it has.
pub(super) fn plan(task: &Task, cancel: &Cancel, watch: &Watch) -> Result<Planning, CommandError> {
    let _enough = (task.model().plan.time == MissionTime::Minimum).then(|| Enough::new(cancel.clone()));
    within(cancel, || task.plan(watch))
}

/// Runs a search that `cancel` can end.
fn within<T: Send>(cancel: &Cancel, search: impl FnOnce() -> T + Send) -> Result<T, CommandError> {
    match cancel.within(rayon::current_num_threads(), STACK, search) {
        Ok(found) => Ok(found),
        Err(NoResult::Panicked(payload)) => resume_unwind(payload),
        Err(NoResult::NoThreads(why)) => Err(why),
        Err(NoResult::Cancelled(cancelled)) => Err(cancelled.to_string()),
    }
}
