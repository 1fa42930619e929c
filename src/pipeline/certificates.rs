//! Certificates: making one from an outcome, and deciding whether it holds.

use super::tasks::{OtherSpec, Planning};
use crate::certificate::Certificate;
use crate::certify as write;
use crate::diagnostic::{Diagnostic, render_human};
use crate::model::Problem;
use crate::source::{Source, SourceMap, visible};
use crate::spec::Spec;
use crate::verify::cost::Budget;
use crate::verify::{self as checker, Settings, Verdict};
use std::borrow::Cow;
use std::error::Error;
use std::fmt;

/// In larger certificates, control characters are replaced by question marks, byte by byte: escapes would take many times the
/// memory.
const MOST_ESCAPED: usize = 1 << 20;

/// Makes the certificate of an outcome of [`plan`](super::plan): the trajectory of a plan, or the multipliers of a proof of
/// infeasibility. All numbers are in SI units. The certificate is checked before it is returned, so [`verify`] accepts it.
///
/// docs/certificates.md states what a certificate shows, as a theorem.
///
/// # Errors
/// The outcome is for another spec; it is neither a plan nor a proof; or the proof covers more mission times than one certificate can show.
///
/// ```
/// let spec = mavc::compile(mavc::TEMPLATE).into_result()?;
/// let certificate = mavc::certify(&spec, &mavc::plan(&spec)?)?;
/// let shown = mavc::verify(&serde_json::to_vec(&certificate)?, &spec)?;
/// println!("{}", shown.headline);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn certify(spec: &Spec, planning: &Planning) -> Result<Certificate, Uncertified> {
    planning.check_spec(spec).map_err(Uncertified::OtherSpec)?;
    let kept = planning.height.map(|height| spec.model().keeping(height).map_err(|error| error.message.clone()));
    let kept = kept.transpose().map_err(Uncertified::Other)?;
    let problem = Problem::of(kept.as_ref().unwrap_or(spec.model()));
    let Some(problem) = problem else { return Err(Uncertified::Other("the spec has no mission".into())) };
    write::of(problem, planning.comparison(), spec.sha256().into()).map_err(Uncertified::Other)
}

/// Why an outcome has no certificate.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Uncertified {
    /// The outcome is for another spec.
    OtherSpec(OtherSpec),
    /// The reason, as a text.
    Other(String),
}

impl fmt::Display for Uncertified {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Uncertified::OtherSpec(other) => other.fmt(f),
            Uncertified::Other(reason) => f.write_str(reason),
        }
    }
}

impl Error for Uncertified {}

/// Decides whether a certificate (JSON) holds for a spec. The code works out from the spec what has to hold, and decides it
/// from the certificate's trajectory or multipliers in interval and exact arithmetic. It uses neither the planner nor the
/// solver (docs/certificates.md).
///
/// The default [`Budget`] is 10 s of one core and 500,000,000 bytes; [`verify_within`] takes another.
///
/// The verdict lists what is shown, and in what the certificate proves less than the spec requires.
///
/// # Errors
/// The bytes are not a certificate; the certificate was written for another spec; it does not hold; or the check would exceed
/// the default budget of time and memory.
///
/// ```
/// let spec = mavc::compile(mavc::TEMPLATE).into_result()?;
/// let certificate = serde_json::to_vec(&mavc::certify(&spec, &mavc::plan(&spec)?)?)?;
/// assert!(mavc::verify(&certificate, &spec).is_ok());
/// let rejected = mavc::verify(b"{}", &spec).unwrap_err();
/// assert_eq!(rejected.diagnostic.code, "mavc::verify::malformed");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn verify(certificate: &[u8], spec: &Spec) -> Result<Verdict, Rejected> {
    verify_within(Budget::default(), "<certificate>", certificate, spec)
}

/// As [`verify`], with a budget of time (s) and memory (bytes). `name` is the name of the certificate in messages.
///
/// # Errors
/// As for [`verify`].
pub fn verify_within(budget: Budget, name: &str, certificate: &[u8], spec: &Spec) -> Result<Verdict, Rejected> {
    let mut sources = spec.sources().clone();
    let mut text = Source::from_bytes(name, certificate).unwrap_or_else(|broken| broken.source);
    if text.text.len() > MOST_ESCAPED
        && let Cow::Owned(blanked) = visible::blanked(&text.text)
    {
        text = Source::new(&text.name, blanked);
    }
    let file = sources.add(text);
    let settings = Settings { budget, ..Settings::default() };
    let decided = checker::read(certificate, file)
        .and_then(|certificate| checker::verify(&certificate, spec.model(), spec.sha256(), settings));
    decided.map_err(|diagnostic| Rejected { diagnostic, sources })
}

/// Why a certificate was not accepted.
#[derive(Clone)]
pub struct Rejected {
    pub diagnostic: Box<Diagnostic>,
    /// The texts that the diagnostic refers to: those of the spec, and the certificate.
    pub sources: SourceMap,
}

impl fmt::Display for Rejected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let diagnostics = std::slice::from_ref(&*self.diagnostic);
        f.write_str(render_human(diagnostics, &self.sources, 100, false).trim_end())
    }
}

/// As `Display`, on a new line, because a `main` that returns the error prints it so.
impl fmt::Debug for Rejected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\n{self}")
    }
}

impl Error for Rejected {}
