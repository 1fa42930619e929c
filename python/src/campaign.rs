//! Campaigns of simulated flights.

use crate::compile::{Shown, json, shown};
use crate::held::{Compiled, Held};
use crate::job::{Job, Reports};
use crate::plan::prepare;
use crate::{Arguments, Value, object};
use mavc::campaign::cases::Shard;
use mavc::campaign::design::Design;
use mavc::campaign::rows::header;
use mavc::campaign::run::fly_all;
use mavc::campaign::tally::Tally;
use mavc::diagnostic::{Diagnostic, Severity};
use mavc::pipeline::{departure, missing_verdict};
use mavc::report::campaign_record::CampaignRecord;
use mavc::report::page::{self, Subject};
use mavc::report::{campaign_screen, campaign_text};
use pyo3::prelude::*;
use std::convert::Infallible;

/// The texts of a campaign, as the command writes them.
struct Texts {
    /// `simulated`, or the verdict about the plans if none is there to fly.
    verdict: String,
    json: String,
    text: String,
    rows: String,
    page: String,
}

/// Texts, or none if the spec cannot be flown; with the diagnostics in two parts, as the command prints them.
type Found = (Option<Texts>, Shown);

/// `campaign(spec, job, program)`: `(verdict, json, text, rows, page, shown)`, or `(None, shown)` if the spec cannot be
/// planned or flown. `program` is a hash of this library: rows of different builds have different identities.
pub fn campaign(arguments: Arguments) -> Value {
    let py = arguments.py();
    let of = Compiled::of(&arguments.get_item(0)?)?;
    let program: String = arguments.get_item(4)?.extract()?;
    let (texts, shown) = Job::of(arguments, 1)?.run(py, move |reports| flown(&of, &program, reports))?;
    match texts {
        Some(Texts { verdict, json, text, rows, page }) => object(py, (verdict, json, text, rows, page, shown)),
        None => object(py, (None::<String>, shown)),
    }
}

fn flown(of: &Compiled, program: &str, reports: &Reports) -> Found {
    let (task, mut found) = prepare(of);
    let (spec, sources) = (&of.spec, of.spec.sources());
    let task = match task {
        Ok(task) => task,
        Err(true) => {
            let record = CampaignRecord::without_flights(spec.model(), &[], spec.sha256().into());
            let texts = texts(of, &found, mavc::Verdict::NotAttempted.to_string(), &record, String::new());
            return (texts, shown(&found, sources));
        }
        Err(false) => return (None, shown(&found, sources)),
    };
    let comparison = task.at_common_time(reports);
    let origin = spec.sha256().to_string() + program;
    let design = match Design::new(task.model(), &comparison, &origin) {
        Ok(design) => design,
        Err(missing) => {
            let record = CampaignRecord::without_flights(spec.model(), &missing, spec.sha256().into());
            let verdict = missing_verdict(&missing).to_string();
            let text = campaign_text::left_out(&missing).trim_start().to_string();
            return (texts(of, &found, verdict, &record, text), shown(&found, sources));
        }
    };
    let remarks = departure(spec, design.time);
    let (mut human, mut lines) = shown(&found, sources);
    let (more, line) = shown(&remarks, sources);
    (human, lines) = (human + &more, lines + &line);
    if remarks.iter().any(|d| d.severity == Severity::Error) {
        return (None, (human, lines));
    }
    found.extend(remarks);
    (fly(of, &found, &design, reports), (human, lines))
}

/// Flies every case.
fn fly(of: &Compiled, found: &[Diagnostic], design: &Design, reports: &Reports) -> Option<Texts> {
    let mut tally = Tally::new(design.cases);
    let mut rows = header() + "\n";
    let all = design.cases.count();
    let Ok(()) = fly_all(design, design.cases.of(Shard::WHOLE), |cases, flown| {
        for (case, row) in cases.iter().zip(flown) {
            tally.add(case, row);
            rows.push_str(&row.line());
            rows.push('\n');
        }
        reports.flights(tally.flights(), all);
        Ok::<(), Infallible>(())
    });
    let record = CampaignRecord::new(design, Shard::WHOLE, &tally, of.spec.sha256().into());
    let text = campaign_screen::screen(design, Shard::WHOLE, &tally).to_string();
    texts(of, found, mavc::verdict::SIMULATED.into(), &record, text).map(|texts| Texts { rows, ..texts })
}

fn texts(of: &Compiled, found: &[Diagnostic], verdict: String, record: &CampaignRecord, text: String) -> Option<Texts> {
    let subject = Subject { problem: of.spec.problem()?, sources: of.spec.sources(), diagnostics: found };
    let page = page::campaign(&subject, record);
    Some(Texts { verdict, json: json(record), text, rows: header() + "\n", page })
}
