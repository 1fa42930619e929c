//! `mavc verify`: decide a certificate.

use super::spec::{self, timing};
use super::{FINE, Options, Problem, REJECTED, SPEC_ERRORS, VerifyArgs, files};
use crate::certificate::{MAX_BYTES, Scope};
use crate::model::{FlightBlocks, PlannerKind};
use crate::report::table::Table;
use crate::report::terminal::WIDTH;
use crate::source::{FileId, Source};
use crate::verify::{Guarded, Reach, Verdict, read, verify};
use std::time::Instant;

pub fn run(args: &VerifyArgs, options: &Options) -> Result<u8, Problem> {
    let name = args.certificate.display().to_string();
    if name == "-" && args.spec.spec == "-" {
        return Err("only one of the certificate and the spec can be standard input".into());
    }
    let bytes = files::read_spec(&name, MAX_BYTES)?;
    let mut loaded = spec::read(&args.spec, FlightBlocks::Unused, options)?;
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
    if let Some(text) = guarded(&verdict.guarded, planner) {
        out.push_str(&format!("{}\n", textwrap::fill(&text, WIDTH)));
    }
    out
}

/// What is claimed of the modes that the plan is against, and what is not; `None` where their whole sets are.
fn guarded(modes: &[Guarded], planner: PlannerKind) -> Option<String> {
    let partly: Vec<&Guarded> = modes.iter().filter(|mode| !mode.whole).collect();
    if partly.is_empty() {
        return None;
    }
    let none: Vec<&str> = partly.iter().filter(|m| m.facets == 0).map(|m| m.mode.as_str()).collect();
    if planner == PlannerKind::Rip && none.len() == partly.len() {
        return Some(format!("Nothing is claimed of {}: RIP does not look at faults.", none.join(", ")));
    }
    let total: usize = partly.iter().map(|mode| mode.facets).sum();
    let some = partly.iter().filter(|mode| mode.facets > 0).map(|mode| format!("{} of {}", mode.facets, mode.mode));
    let none = (!none.is_empty()).then(|| format!("none of {}", none.join(", ")));
    let each: Vec<String> = some.chain(none).collect();
    let plural = if total == 1 { "" } else { "s" };
    Some(format!(
        "Claimed of the fault sets: {total} facet{plural}, {}. Whether RSP guards more is not claimed: `mavc plan` says how \
         many it guards.",
        each.join(", ")
    ))
}

fn words(reach: Reach) -> String {
    let shown = match reach.scope {
        None => "proved".into(),
        Some(Scope::Nodes) => "checked at nodes".into(),
        // With one of the nodes beside them.
        Some(Scope::Grid(points)) => format!("checked on a grid of {} points an interval", points + 1),
        Some(Scope::EveryInstant) => "proved for every instant".into(),
    };
    let Some((beyond, measure)) = reach.beyond else { return shown };
    let seen = if beyond.scope == Scope::EveryInstant { "at any instant" } else { "on a grid" };
    let of = measure.whole.map_or(String::new(), |whole| format!(" {whole}"));
    format!("{shown}; passed {seen} by at most {}{of}", measure.of(beyond.excess))
}
