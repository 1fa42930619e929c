//! `mavc verify`: decide a certificate.

use super::spec::{self, timing};
use super::{FINE, Options, Problem, REJECTED, SPEC_ERRORS, VerifyArgs, files};
use crate::certificate::{MAX_BYTES, Scope};
use crate::model::PlannerKind;
use crate::report::number::number;
use crate::report::table::Table;
use crate::report::terminal::WIDTH;
use crate::source::{FileId, Source};
use crate::verify::{Reach, Verdict, read, verify};
use std::time::Instant;

pub fn run(args: &VerifyArgs, options: &Options) -> Result<u8, Problem> {
    let name = args.certificate.display().to_string();
    if name == "-" && args.spec.spec == "-" {
        return Err("only one of the certificate and the spec can be standard input".into());
    }
    let bytes = files::read_spec(&name, MAX_BYTES)?;
    let mut loaded = spec::read(&args.spec, options)?;
    let sha256 = loaded.sha256();
    let Some(model) = loaded.model.clone() else {
        let text = loaded.files.sources.iter().next().map_or("", |(_, spec)| &spec.text);
        if read(text.as_bytes(), FileId::default()).is_ok() {
            return Err(format!("{} is a certificate; give the certificate first, then its spec", args.spec.spec));
        }
        loaded.tell(options);
        return Ok(SPEC_ERRORS);
    };
    // Remarks on the spec are `mavc check`'s to make.
    loaded.diagnostics.clear();
    let begin = Instant::now();
    let text = Source::from_bytes(spec::name(&name), &bytes).unwrap_or_else(|broken| broken.source);
    let file = loaded.files.sources.add(text);
    let verdict = read(&bytes, file).and_then(|certificate| verify(&certificate, &model, &sha256));
    timing(options, "verify", begin);
    match verdict {
        Ok(verdict) => {
            files::print(&table(&verdict, model.plan.planner))?;
            files::print(&format!("{name}: every claim holds\n"))?;
            Ok(FINE)
        }
        Err(diagnostic) => {
            loaded.diagnostics.push(*diagnostic);
            loaded.tell(options);
            Ok(REJECTED)
        }
    }
}

/// Every claim and how far it is shown, then what is not claimed.
fn table(verdict: &Verdict, planner: PlannerKind) -> String {
    let mut table = Table::new(&["shown", "where"]);
    for shown in &verdict.shown {
        let statement = match (shown.count, shown.statement.strip_prefix("facets of")) {
            (1, Some(rest)) => format!("1 facet of{rest}"),
            (1, None) => shown.statement.clone(),
            (count, _) => format!("{count} {}", shown.statement),
        };
        table.row(vec![statement, words(shown.reach)]);
    }
    let mut out = table.render_left(0);
    if !verdict.unclaimed.is_empty() {
        let why = match planner {
            PlannerKind::Rip => "RIP does not look at faults",
            _ => "`mavc plan` says which facets RSP guards, if any",
        };
        let text = format!("Not claimed: that a facet of {} is kept; {why}.", verdict.unclaimed.join(", "));
        out.push_str(&format!("{}\n", textwrap::fill(&text, WIDTH)));
    }
    out
}

fn words(reach: Reach) -> String {
    let shown = match reach.scope {
        None => "proved".into(),
        Some(Scope::Nodes) => "checked at nodes".into(),
        // With one of the nodes beside them.
        Some(Scope::Grid(points)) => format!("checked on a grid of {} points an interval", points + 1),
        Some(Scope::EveryInstant) => "proved for every instant".into(),
    };
    let Some(beyond) = reach.beyond else { return shown };
    let seen = if beyond.scope == Scope::EveryInstant { "at any instant" } else { "on a grid" };
    format!("{shown}; passed {seen} by at most {}", number(beyond.excess))
}
