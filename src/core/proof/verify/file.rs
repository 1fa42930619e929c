//! Decides the bytes of a certificate's file for a spec.

use super::cost::Budget;
use super::{Accepted, Settings, read, verify};
use crate::diagnostic::{Diagnostic, render_human};
use crate::source::{Source, SourceMap, visible};
use crate::spec::Spec;
use std::borrow::Cow;
use std::error::Error;
use std::fmt;

/// In larger certificates, control characters are replaced by question marks, byte by byte: escapes would take many
/// times the memory.
const MOST_ESCAPED: usize = 1 << 20;

/// Decides a certificate (JSON) for a spec within a budget of time (s) and memory (bytes). `name` is the name of the
/// certificate in messages.
///
/// # Errors
/// The bytes are not a certificate; it was written for another spec; it does not hold; or deciding it would exceed the
/// budget.
pub fn verify_within(budget: Budget, name: &str, certificate: &[u8], spec: &Spec) -> Result<Accepted, Rejected> {
    let mut sources = spec.sources().clone();
    let mut text = Source::from_bytes(name, certificate).unwrap_or_else(|broken| broken.source);
    if text.text.len() > MOST_ESCAPED
        && let Cow::Owned(blanked) = visible::blanked(&text.text)
    {
        text = Source::new(&text.name, blanked);
    }
    let file = sources.add(text);
    let settings = Settings { budget, ..Settings::default() };
    let decided =
        read(certificate, file).and_then(|certificate| verify(&certificate, spec.model(), spec.sha256(), settings));
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

/// The text of `Display` on a new line, because a `main` that returns the error prints it so.
impl fmt::Debug for Rejected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\n{self}")
    }
}

impl Error for Rejected {}
