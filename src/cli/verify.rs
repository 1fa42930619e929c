//! `mavc verify`: checks a certificate.

use super::progress::Watch;
use super::{FINE, OVER_BUDGET, Options, Problem, REJECTED, SPEC_ERRORS, VerifyArgs, WEAKER, files, spec};
use crate::certificate::MAX_BYTES;
use crate::model::FlightBlocks;
use crate::observer::timed;
use crate::pipeline::{Rejected, verify_within};
use crate::report::verification_text;
use crate::source::FileId;
use crate::verify::cost::Budget;
use crate::verify::{TOO_COSTLY, read};

pub fn run(args: &VerifyArgs, options: &Options) -> Result<u8, Problem> {
    let name = args.certificate.display().to_string();
    if name == "-" && args.spec.spec == "-" {
        return Err("only one of the certificate and the spec can be standard input".into());
    }
    let bytes = files::read_spec(&name, MAX_BYTES)?;
    let watch = Watch::new(options);
    let (spec, mut findings) = spec::read(&args.spec, FlightBlocks::Unused, &watch)?;
    let Some(spec) = spec else {
        let text = findings.files.sources.iter().next().map_or("", |(_, spec)| &spec.text);
        if read(text.as_bytes(), FileId::default()).is_ok() {
            return Err(format!("{} is a certificate; give the certificate first, then its spec", args.spec.spec));
        }
        findings.eprint(options);
        return Ok(SPEC_ERRORS);
    };
    // Warnings about the spec are left to `mavc check`.
    let budget = args.budget.unwrap_or_default();
    match timed(&watch, "verify", || verify_within(budget, spec::name(&name), &bytes, &spec)) {
        Ok(verdict) => {
            files::print(&verification_text::verification(&spec::shown(&name), &verdict))?;
            Ok(if verdict.weaker.is_empty() { FINE } else { WEAKER })
        }
        Err(Rejected { diagnostic, sources }) => {
            let code = if diagnostic.code == TOO_COSTLY { OVER_BUDGET } else { REJECTED };
            files::eprint_as_it_is(&spec::human(std::slice::from_ref(&*diagnostic), &sources, &std::io::stderr()));
            Ok(code)
        }
    }
}

/// Reads `10s`, `500MB` or both with a comma between.
///
/// # Errors
/// The text is neither a time nor a size.
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
