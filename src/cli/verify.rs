//! `mavc verify`: decide a certificate.

use super::spec::{self, timing};
use super::{FINE, OVER_BUDGET, Options, Problem, REJECTED, SPEC_ERRORS, VerifyArgs, WEAKER, files};
use crate::certificate::MAX_BYTES;
use crate::model::FlightBlocks;
use crate::report::table::Table;
use crate::report::terminal::WIDTH;
use crate::source::{FileId, Source, visible};
use crate::verify::cost::Budget;
use crate::verify::plan::OF_A_GRID;
use crate::verify::{Reach, Scope, Settings, TOO_COSTLY, Verdict, read, verify};
use std::borrow::Cow;
use std::time::Instant;

/// In larger certificates question marks stand for control characters, bytes: their escapes would take many times the memory.
const MOST_ESCAPED: usize = 1 << 20;

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
    let mut text = Source::from_bytes(spec::name(&name), &bytes).unwrap_or_else(|broken| broken.source);
    if text.text.len() > MOST_ESCAPED
        && let Cow::Owned(blanked) = visible::blanked(&text.text)
    {
        text = Source::new(&text.name, blanked);
    }
    let file = loaded.files.sources.add(text);
    let settings = Settings { budget: args.budget.unwrap_or_default(), ..Settings::default() };
    let verdict = read(&bytes, file).and_then(|certificate| verify(&certificate, &model, &sha256, settings));
    timing(options, "verify", begin);
    match verdict {
        Ok(verdict) => {
            files::print(&report(&spec::shown(&name), &verdict))?;
            Ok(if verdict.weaker.is_empty() { FINE } else { WEAKER })
        }
        Err(diagnostic) => {
            let code = if diagnostic.code == TOO_COSTLY { OVER_BUDGET } else { REJECTED };
            loaded.diagnostics.push(*diagnostic);
            loaded.tell(options);
            Ok(code)
        }
    }
}

/// What is shown, then in what it is weaker than the spec asks.
fn report(name: &str, verdict: &Verdict) -> String {
    let mut table = Table::new(&["shown", "where"]);
    for shown in &verdict.shown {
        table.row(vec![shown.statement.clone(), shown.reach.map_or("proved".into(), words)]);
    }
    // What its headline tells whole has no rows.
    let mut out = if verdict.shown.is_empty() { String::new() } else { table.render_left(0) + "\n" };
    let strength = match verdict.weaker.is_empty() {
        true => "accepted",
        false => "accepted, weaker than the spec asks",
    };
    out.push_str(&textwrap::fill(&format!("{name}: {strength}: {}", verdict.headline), WIDTH));
    out.push('\n');
    for why in &verdict.weaker {
        let options = textwrap::Options::new(WIDTH).initial_indent("  - ").subsequent_indent("    ");
        out.push_str(&textwrap::fill(why, options));
        out.push('\n');
    }
    out
}

fn words(reach: Reach) -> String {
    let shown: String = match reach.scope {
        Scope::Nodes => "at the nodes".into(),
        // With one of the nodes beside them.
        Scope::Grid => format!("on a grid of {} points an interval", OF_A_GRID + 1),
        Scope::EveryInstant => "proved for every instant".into(),
    };
    let Some(beyond) = reach.beyond else { return shown };
    let of = beyond.measure.whole.map_or(String::new(), |whole| format!(" {whole}"));
    let most = if beyond.throughout { "at most " } else { "" };
    format!("{shown}; exceeded between them by {most}{}{of}", beyond.measure.of(beyond.excess))
}

/// `10s`, `500MB` or both with a comma between.
///
/// # Errors
/// It is neither.
pub fn parse_budget(text: &str) -> Result<Budget, String> {
    let mut budget = Budget::default();
    for part in text.split(',').map(str::trim) {
        let figure = |unit: &str| part.strip_suffix(unit).and_then(|digits| digits.trim().parse::<f64>().ok());
        let positive = |x: f64| x.is_finite() && x > 0.0;
        match (figure("GB"), figure("MB"), figure("s")) {
            (Some(gb), _, _) if positive(gb) => budget.bytes = (gb * 1e9) as u64,
            (_, Some(mb), _) if positive(mb) => budget.bytes = (mb * 1e6) as u64,
            (_, _, Some(seconds)) if positive(seconds) => budget.seconds = seconds,
            _ => {
                return Err(format!(
                    "`{part}` is neither a time in s nor a size in MB or GB: write `60s`, `2GB` or `60s,2GB`"
                ));
            }
        }
    }
    Ok(budget)
}
