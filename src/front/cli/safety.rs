//! `mavc safety`: writes the files of a safety assessment, or checks them.

use super::progress::Watch;
use super::results::{Names, Places, Results, is_folder, json};
use super::spec::{self, Start};
use super::{
    CommandError, FINE, INCONCLUSIVE, NO_PLAN, OVER_BUDGET, Options, REJECTED, SafetyArgs, WEAKER, code_of, files, plan,
};
use crate::cancel::Cancel;
use crate::certificate::MAX_BYTES;
use crate::model::PlanModel;
use crate::observer::{Observer, timed};
use crate::pipeline::{Explained, Task, certify, verify_within, with_ways_out};
use crate::read::FlightBlocks;
use crate::report::recovery::RecoveryRecord;
use crate::safety::{CERTIFICATE, REPORT};
use crate::verify::{Rejected, TOO_COSTLY};
use std::path::Path;

/// A report and a certificate.
type Pair = [Vec<u8>; 2];

pub fn run(args: &SafetyArgs, options: &Options) -> Result<u8, CommandError> {
    is_folder(&args.output)?;
    let watch = Watch::new(options);
    let (spec, mut findings) = spec::read(&args.spec, FlightBlocks::Unused, &watch)?;
    let task = match findings.start(spec.as_ref(), Task::new, options) {
        Start::Task(task) => task,
        Start::Refused => return Ok(NO_PLAN),
        Start::Ended(code) => return Ok(code),
    };
    task.fits_fault_tree()?;
    let [report, certificate] = match (&args.report, &args.certificate) {
        (Some(report), Some(certificate)) => read([report, certificate])?,
        _ if args.check => read([&args.output.join(REPORT), &args.output.join(CERTIFICATE)])?,
        _ => match planned(&task, &watch, options)? {
            Ok(pair) => pair,
            Err(code) => return Ok(code),
        },
    };
    let budget = args.budget.unwrap_or_default();
    watch.begins("checking the certificate");
    let accepted = match timed(&watch, "verify", || verify_within(budget, CERTIFICATE, &certificate, task.spec())) {
        Ok(accepted) => accepted,
        Err(Rejected { diagnostic, sources }) => {
            let code = if diagnostic.code == TOO_COSTLY { OVER_BUDGET } else { REJECTED };
            files::eprint_as_it_is(&spec::human(std::slice::from_ref(&*diagnostic), &sources, &std::io::stderr()));
            return Ok(code);
        }
    };
    let case = task.safety_case(&report, &certificate, &accepted)?;
    let made = case.files()?;
    if args.check {
        return check(&args.output, &made);
    }
    let places = Places::new(Names::default())?;
    let mut results = Results::new(&places);
    results.folder("a file of the assessment", "-o", &args.output, made, task.spec().sources())?;
    results.write()?;
    results.hint(&case.text(), &Options { quiet: false, ..*options })?;
    results.note("Assessment", Some(&args.output.join("index.html")), options)?;
    Ok(match () {
        () if case.exceeds_target() => INCONCLUSIVE,
        () if !accepted.weaker.is_empty() => WEAKER,
        () => FINE,
    })
}

fn read(names: [&std::path::PathBuf; 2]) -> Result<Pair, CommandError> {
    let [report, certificate] = names.map(|name| files::read_spec(&name.display().to_string(), MAX_BYTES));
    Ok([report?, certificate?])
}

/// Plans, looks for ways out, and certifies; an exit code if there is no plan or no certificate of it. Ways out are
/// proved in the hover model only: in the exact one few are found, in more than the time of all the rest.
fn planned(task: &Task, watch: &Watch, options: &Options) -> Result<Result<Pair, u8>, CommandError> {
    let mut planning = plan::plan(task, &Cancel::new(), watch)?;
    let between = task.model().plan.model == PlanModel::Hover;
    let Some(found) = task.recovery(&mut planning, between, watch).map_err(|e| e.to_string())? else {
        files::print_screen(&task.for_people(&planning, &Explained::default(), None, None, options.verbose))?;
        return Ok(Err(code_of(planning.verdict())));
    };
    watch.begins("making the certificate");
    let certificate = match timed(watch, "certify", || certify(task.spec(), &planning)) {
        Ok(certificate) => json(&with_ways_out(certificate, &found))?.into_bytes(),
        Err(why) => {
            files::eprint(&format!("mavc: nothing was written, because the plan has no certificate: {why}\n"));
            return Ok(Err(REJECTED));
        }
    };
    let mut report = task.report(&planning, &Explained::default(), None);
    report.recovery = Some(RecoveryRecord::new(task.model(), &found));
    Ok(Ok([json(&report)?.into_bytes(), certificate]))
}

/// Compares the files of a folder with those that follow from the spec, the report and the certificate.
fn check(folder: &Path, made: &[(String, Vec<u8>)]) -> Result<u8, CommandError> {
    let mut differ = 0;
    for (name, bytes) in made {
        let path = folder.join(name);
        let there = files::read_spec(&path.display().to_string(), MAX_BYTES);
        if let Some(why) = match there {
            Ok(there) if there == *bytes => None,
            Ok(_) => {
                Some("does not follow from the spec, the report and the certificate: write the folder again".into())
            }
            Err(why) => Some(why),
        } {
            differ += 1;
            files::eprint(&format!("mavc: {name}: {why}\n"));
        }
    }
    match differ {
        0 => {
            files::print(&format!("{} files follow from the spec, the report and the certificate\n", made.len()))?;
            Ok(FINE)
        }
        _ => Ok(REJECTED),
    }
}
