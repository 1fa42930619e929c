//! `mavc safety`: writes the files of a safety assessment, or checks them.

mod check;

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
use crate::report::recovery::{self, RecoveryRecord};
use crate::safety::CERTIFICATE;
use crate::safety::inputs::{Inputs, version};
use crate::verify::{Rejected, TOO_COSTLY};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// What the files are written from: a report, its certificate, and the tables of its ways out, if they are known.
struct Read {
    report: Vec<u8>,
    certificate: Vec<u8>,
    tables: Vec<(String, Vec<u8>)>,
    /// The version that wrote the folder.
    written_by: String,
    /// The names of the spec's texts in the folder, with their hashes.
    spec_files: Vec<(String, String)>,
}

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
    let read = match (&args.report, &args.certificate) {
        (Some(report), Some(certificate)) => read([report, certificate])?,
        _ if args.check => match check::read(&args.output) {
            Some(read) => read,
            None => return Ok(REJECTED),
        },
        _ => match planned(&task, &watch, options)? {
            Ok(read) => read,
            Err(code) => return Ok(code),
        },
    };
    let Read { report, certificate, tables, written_by, spec_files } = &read;
    let budget = args.budget.unwrap_or_default();
    watch.begins("checking the certificate");
    let accepted = match timed(&watch, "verify", || verify_within(budget, CERTIFICATE, certificate, task.spec())) {
        Ok(accepted) => accepted,
        Err(Rejected { diagnostic, sources }) => {
            let code = if diagnostic.code == TOO_COSTLY { OVER_BUDGET } else { REJECTED };
            files::eprint_as_it_is(&spec::human(std::slice::from_ref(&*diagnostic), &sources, &std::io::stderr()));
            return Ok(code);
        }
    };
    let inputs = Inputs { report, certificate, tables, written_by, spec_files };
    let case = match task.safety_case(inputs, &accepted) {
        Ok(case) => case,
        Err(why) if args.check => return Ok(check::rejected(&why)),
        Err(why) => return Err(why),
    };
    if args.check {
        return check::compare(&args.output, &case.derived()?, &case.inputs);
    }
    let places = Places::new(Names::default())?;
    let mut results = Results::new(&places);
    let mut folders: BTreeMap<PathBuf, Vec<(String, Vec<u8>)>> = BTreeMap::new();
    let mut names = Vec::new();
    for (name, bytes) in case.files()? {
        names.push(name.clone());
        let (folder, file) = name.rsplit_once('/').unwrap_or(("", &name));
        folders.entry(args.output.join(folder)).or_default().push((file.into(), bytes));
    }
    for (folder, files) in folders {
        results.folder("a file of the assessment", "-o", &folder, files, task.spec().sources())?;
    }
    results.write()?;
    results.hint(&case.text(), &Options { quiet: false, ..*options })?;
    results.note("Assessment", Some(&args.output.join("index.html")), options)?;
    let strangers = check::strangers(&args.output, names.iter().map(String::as_str));
    if let Some(names) = check::listed_briefly(&strangers) {
        files::eprint(&format!(
            "mavc: {names}: not of this assessment; move it out, or `--check` will reject the folder\n"
        ));
    }
    Ok(match () {
        () if case.exceeds_target() => INCONCLUSIVE,
        () if !accepted.weaker.is_empty() => WEAKER,
        () => FINE,
    })
}

fn read(names: [&PathBuf; 2]) -> Result<Read, CommandError> {
    let [report, certificate] = names.map(|name| files::read_spec(&name.display().to_string(), MAX_BYTES));
    let (report, certificate) = (report?, certificate?);
    Ok(Read { report, certificate, tables: Vec::new(), written_by: version(), spec_files: Vec::new() })
}

/// Plans, looks for ways out, and certifies; an exit code if there is no plan or no certificate of it. Ways out are
/// proved in the hover model only: in the exact one few are found, in more than the time of all the rest.
fn planned(task: &Task, watch: &Watch, options: &Options) -> Result<Result<Read, u8>, CommandError> {
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
    let tables = recovery::files(task.problem(), &found)?;
    let report = json(&report)?.into_bytes();
    Ok(Ok(Read { report, certificate, tables, written_by: version(), spec_files: Vec::new() }))
}
