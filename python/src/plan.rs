//! Plans.

use crate::compile::{json, shown};
use crate::export;
use crate::held::{Compiled, Held};
use crate::job::{Job, Reports};
use crate::{Arguments, Value, object};
use mavc::certify::between::Between;
use mavc::diagnostic::{Diagnostic, sort};
use mavc::pipeline::{Explained, NoFlight, Planning, Refusal, Task, certify, with_ways_out};
use mavc::recovery::Recovery;
use mavc::report::page::{self, Beside, PageKind, Subject};
use mavc::report::record::Record;
use mavc::report::recovery::{self, RecoveryRecord};
use mavc::report::trajectory_csv;
use mavc::source::SourceMap;
use mavc::{MissionPlan, Verdict};
use pyo3::prelude::*;
use std::ffi::CStr;
use std::sync::Arc;

/// The outcome of planning: of a mission, or the refusal to plan because a mode cannot hover.
pub struct Planned {
    pub of: Arc<Compiled>,
    /// Those of the spec, then those of planning.
    pub diagnostics: Vec<Diagnostic>,
    pub done: Option<Done>,
}

/// What was planned.
pub struct Done {
    pub planning: Planning,
    explained: Explained,
    between: Option<Vec<Between>>,
    /// The ways out after faults, if they were sought.
    recovery: Option<Recovery>,
    /// Why no plan was found.
    conflict: Option<Diagnostic>,
}

impl Done {
    /// What `--report` writes.
    fn record(&self, task: &Task) -> Record {
        let mut record = task.report(&self.planning, &self.explained, self.between.clone());
        record.recovery = self.recovery.as_ref().map(|found| RecoveryRecord::new(task.model(), found));
        record
    }
}

impl Held for Planned {
    const NAME: &'static CStr = c"mavc.plan";
}

/// The texts of a plan, as the command writes them.
struct Texts {
    verdict: String,
    json: String,
    text: String,
    csv: Option<String>,
}

impl Planned {
    pub fn sources(&self) -> &SourceMap {
        self.of.spec.sources()
    }

    /// The diagnostics that the page shows.
    pub fn on_page(&self) -> Vec<Diagnostic> {
        self.diagnostics.iter().chain(self.done.iter().flat_map(|done| &done.conflict)).cloned().collect()
    }

    /// The plan.
    ///
    /// # Errors
    /// There is none.
    pub fn plan(&self) -> Result<&MissionPlan, String> {
        self.solved().ok_or_else(|| format!("there is no plan: {}", self.verdict()))
    }

    /// The plan to fly.
    ///
    /// # Errors
    /// There is none.
    pub fn to_fly(&self) -> Result<&MissionPlan, String> {
        self.solved().ok_or_else(|| NoFlight::NoPlan(self.verdict()).to_string())
    }

    fn solved(&self) -> Option<&MissionPlan> {
        self.done.as_ref().and_then(|done| done.planning.plan())
    }

    fn verdict(&self) -> Verdict {
        self.done.as_ref().map_or(Verdict::NotAttempted, |done| done.planning.verdict())
    }

    /// The task, made again.
    ///
    /// # Errors
    /// Never for a mission that was planned.
    pub fn task(&self) -> Result<Task<'_>, String> {
        Task::new(&self.of.spec).map_err(|refusal| refusal.to_string())
    }
}

/// The errors for which nothing is planned and nothing is reported, as texts; with a mode that cannot hover there is a
/// report.
pub fn prepare(of: &Compiled) -> (Result<Task<'_>, bool>, Vec<Diagnostic>) {
    let task = Task::new(&of.spec);
    let mut found = of.diagnostics.clone();
    found.extend_from_slice(task.as_ref().map_or_else(Refusal::diagnostics, Task::remarks));
    sort(&mut found);
    (task.map_err(|refusal| matches!(refusal, Refusal::Intolerable(_))), found)
}

fn refused(of: &Arc<Compiled>, diagnostics: Vec<Diagnostic>) -> (Planned, Texts) {
    let record = Record::refused(of.spec.model(), of.spec.sha256().into());
    let verdict = Verdict::NotAttempted.to_string();
    let planned = Planned { of: of.clone(), diagnostics, done: None };
    (planned, Texts { verdict, json: json(&record), text: String::new(), csv: None })
}

/// What is asked for besides the plan.
#[derive(Clone, Copy)]
struct Wanted {
    /// The plan is to be flown: nothing is explained or proved.
    flight: bool,
    /// The ways out after faults, also where the spec does not require any.
    recovery: bool,
}

/// Plans, and unless the plan is to be flown explains, tries and proves what the report of a plan states.
fn planned(
    of: &Arc<Compiled>,
    (task, diagnostics): (&Task, Vec<Diagnostic>),
    wanted: Wanted,
    reports: &Reports,
) -> Result<(Planned, Texts), String> {
    let mut planning = task.plan(reports);
    let (mut explained, mut between, mut recovery) = (Explained::default(), None, None);
    if !wanted.flight {
        explained = task.explain(&planning, reports).map_err(|e| e.to_string())?;
        if wanted.recovery || task.model().plan.recovery.require.is_some() {
            recovery = task.recovery(&mut planning, false, reports).map_err(|e| e.to_string())?;
        }
        between = planning.between(task, reports).map_err(|e| e.to_string())?;
    }
    let conflict = task.diagnose(&explained);
    let table = |plan: &MissionPlan| trajectory_csv::table(&plan.trajectory, task.model(), None);
    let (verdict, csv) = (planning.verdict().to_string(), planning.plan().map(table).transpose()?);
    let text = task.for_people(&planning, &explained, between.as_deref(), recovery.as_ref(), false).to_string();
    let done = Done { planning, explained, between, recovery, conflict };
    let texts = Texts { verdict, json: json(&done.record(task)), text, csv };
    Ok((Planned { of: of.clone(), diagnostics, done: Some(done) }, texts))
}

/// `plan(spec, job, flies, recovery)`: `(handle, verdict, json, text, csv or None, shown)`; `(None, shown)` if the spec
/// cannot be planned.
pub fn plan(arguments: Arguments) -> Value {
    let py = arguments.py();
    let of = Compiled::of(&arguments.get_item(0)?)?;
    let wanted = Wanted { flight: arguments.get_item(4)?.extract()?, recovery: arguments.get_item(5)?.extract()? };
    let result = Job::of(arguments, 1)?.run(py, move |reports| {
        let (task, found) = prepare(&of);
        match task {
            Ok(task) => planned(&of, (&task, found), wanted, reports).map(Ok),
            Err(true) => Ok(Ok(refused(&of, found))),
            Err(false) => Ok(Err(shown(&found, of.spec.sources()))),
        }
    })?;
    match result.map_err(crate::error)? {
        Ok((planned, Texts { verdict, json, text, csv })) => {
            // The terminal shows the conflict after all others.
            let (mut human, mut lines) = shown(&planned.diagnostics, planned.sources());
            if let Some(conflict) = planned.done.as_ref().and_then(|done| done.conflict.as_ref()) {
                let (more, line) = shown(std::slice::from_ref(conflict), planned.sources());
                human += &more;
                lines += &line;
            }
            let handle = planned.into_handle(py)?;
            object(py, (Some(handle), verdict, json, text, csv, (human, lines)))
        }
        Err(shown) => object(py, (None::<Py<PyAny>>, shown)),
    }
}

/// `certificate(plan, job)`: the text that `--certificate` writes.
pub fn certificate(arguments: Arguments) -> Value {
    let of = Planned::of(&arguments.get_item(0)?)?;
    let text = Job::of(arguments, 1)?.run(arguments.py(), move |_| match &of.done {
        Some(done) => {
            let certificate = certify(&of.of.spec, &done.planning).map_err(|e| e.to_string())?;
            Ok(json(&match &done.recovery {
                Some(found) => with_ways_out(certificate, found),
                None => certificate,
            }))
        }
        None => Err("nothing was planned".into()),
    })?;
    object(arguments.py(), text.map_err(crate::error)?)
}

/// `page(plan, job)`: the page that `--html` writes.
pub fn page(arguments: Arguments) -> Value {
    let of = Planned::of(&arguments.get_item(0)?)?;
    let text = Job::of(arguments, 1)?.run(arguments.py(), move |_| page_of(&of))?;
    object(arguments.py(), text.map_err(crate::error)?)
}

fn page_of(planned: &Planned) -> Result<String, String> {
    let (spec, shown) = (&planned.of.spec, planned.on_page());
    let Some(done) = &planned.done else {
        let problem = spec.problem().ok_or("the spec has no mission")?;
        let subject = Subject { problem, sources: spec.sources(), diagnostics: &shown };
        return Ok(page::refused(&subject, &Record::refused(spec.model(), spec.sha256().into())));
    };
    let task = planned.task()?;
    let record = done.record(&task);
    let subject = Subject { problem: task.problem(), sources: spec.sources(), diagnostics: &shown };
    let curves = task.capture_curves(&done.planning);
    let beside = Beside { captures: &curves, recovery: done.recovery.as_ref() };
    Ok(page::plans(PageKind::Plan, &subject, done.planning.comparison(), &record, beside))
}

/// `branches(plan, job)`: `(name, text)` of each file that `--branches` writes.
pub fn branches(arguments: Arguments) -> Value {
    let of = Planned::of(&arguments.get_item(0)?)?;
    let files = Job::of(arguments, 1)?.run(arguments.py(), move |_| {
        let found = of.done.as_ref().and_then(|done| done.recovery.as_ref());
        recovery::files(of.task()?.problem(), found.ok_or("no ways out were sought: `plan(recovery=True)`")?)
    })?;
    object(arguments.py(), files.map_err(crate::error)?)
}

/// `table(plan, job, rate)`: the trajectory with rows at a rate, Hz.
pub fn table(arguments: Arguments) -> Value {
    let of = Planned::of(&arguments.get_item(0)?)?;
    let rate = export::rate(&arguments.get_item(4)?)?;
    let text = Job::of(arguments, 1)?
        .run(arguments.py(), move |_| trajectory_csv::table(&of.plan()?.trajectory, of.task()?.model(), rate))?;
    object(arguments.py(), text.map_err(crate::error)?)
}
