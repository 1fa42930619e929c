//! Certificates of outcomes, and the decision whether one holds.

use super::tasks::Planning;
use crate::certificate::Certificate;
use crate::certify as write;
use crate::diagnostic::{Diagnostic, render_human};
use crate::source::{Source, SourceMap, visible};
use crate::spec::Spec;
use crate::verify::cost::Budget;
use crate::verify::{self as checker, Settings, Verdict};
use std::borrow::Cow;
use std::error::Error;
use std::fmt;

/// In larger certificates question marks replace control characters, byte by byte: their escapes would take many times the
/// memory.
const MOST_ESCAPED: usize = 1 << 20;

/// Writes the certificate of an outcome: of a plan its trajectory, of a proof the multipliers that show it. It is decided
/// before it is given, so [`verify`] accepts it. docs/certificates.md states what it shows as a theorem.
///
/// # Errors
/// The outcome is neither a plan nor a proof, or the proof is about more mission times than one certificate can show.
///
/// ```
/// let spec = mavc::compile(mavc::TEMPLATE).into_result()?;
/// let certificate = mavc::certify(&spec, &mavc::plan(&spec)?)?;
/// let shown = mavc::verify(&serde_json::to_vec(&certificate)?, &spec)?;
/// println!("{}", shown.headline);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn certify(spec: &Spec, planning: &Planning) -> Result<Certificate, Uncertified> {
    let Some(mission) = spec.mission() else { return Err(Uncertified("the spec has no mission".into())) };
    write::of(spec.model(), mission, planning.comparison(), spec.sha256().into()).map_err(Uncertified)
}

/// Why an outcome has no certificate, in words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Uncertified(pub String);

impl fmt::Display for Uncertified {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl Error for Uncertified {}

/// Decides a certificate (JSON) with code of its own, in interval and exact arithmetic: it uses the spec and the
/// certificate's trajectory or multipliers, and neither the planner nor the solver.
///
/// # Errors
/// The bytes are not a certificate, it was written for another spec, it does not hold, or deciding it costs more than the
/// usual budget of time and memory.
///
/// ```
/// let spec = mavc::compile(mavc::TEMPLATE).into_result()?;
/// let rejected = mavc::verify(b"{}", &spec).unwrap_err();
/// assert_eq!(rejected.diagnostic.code, "mavc::verify::malformed");
/// # Ok::<(), mavc::CompileError>(())
/// ```
pub fn verify(certificate: &[u8], spec: &Spec) -> Result<Verdict, Rejected> {
    verify_within(Budget::default(), "<certificate>", certificate, spec)
}

/// As [`verify`], within a budget; `name` is the certificate's, for messages.
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

/// Why a certificate is not accepted.
#[derive(Clone)]
pub struct Rejected {
    pub diagnostic: Box<Diagnostic>,
    /// The texts that the diagnostic points into: the spec's and the certificate.
    pub sources: SourceMap,
}

impl fmt::Display for Rejected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let told = std::slice::from_ref(&*self.diagnostic);
        f.write_str(render_human(told, &self.sources, 100, false).trim_end())
    }
}

/// As `Display`, on lines of its own: what a `main` that returns the error prints.
impl fmt::Debug for Rejected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\n{self}")
    }
}

impl Error for Rejected {}
