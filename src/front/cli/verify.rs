//! `mavc verify`: checks a certificate.

use super::progress::Watch;
use super::{CommandError, FINE, OVER_BUDGET, Options, REJECTED, SPEC_ERRORS, VerifyArgs, WEAKER, files, spec};
use crate::certificate::MAX_BYTES;
use crate::observer::timed;
use crate::read::FlightBlocks;
use crate::source::FileId;
use crate::verify::text::verification;
use crate::verify::{Rejected, TOO_COSTLY, read, verify_within};

pub fn run(args: &VerifyArgs, options: &Options) -> Result<u8, CommandError> {
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
            files::print(&verification(&spec::shown(&name), &verdict))?;
            Ok(if verdict.weaker.is_empty() { FINE } else { WEAKER })
        }
        Err(Rejected { diagnostic, sources }) => {
            let code = if diagnostic.code == TOO_COSTLY { OVER_BUDGET } else { REJECTED };
            files::eprint_as_it_is(&spec::human(std::slice::from_ref(&*diagnostic), &sources, &std::io::stderr()));
            Ok(code)
        }
    }
}
