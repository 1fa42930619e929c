//! Why a task cannot be done: what a spec lacks, or that it is another spec's.

use crate::diagnostic::{Diagnostic, Severity};
use std::error::Error;
use std::fmt;

/// Why a spec was not explained.
#[derive(Debug, Clone, PartialEq)]
pub enum Unexplained {
    /// The mission cannot be planned.
    Refused(Refusal),
    /// The outcome is for another spec.
    OtherSpec(OtherSpec),
}

impl From<Refusal> for Unexplained {
    fn from(refusal: Refusal) -> Self {
        Unexplained::Refused(refusal)
    }
}

impl From<OtherSpec> for Unexplained {
    fn from(other: OtherSpec) -> Self {
        Unexplained::OtherSpec(other)
    }
}

impl fmt::Display for Unexplained {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unexplained::Refused(refusal) => refusal.fmt(f),
            Unexplained::OtherSpec(other) => other.fmt(f),
        }
    }
}

impl Error for Unexplained {}

/// The outcome of `plan` was given together with another spec than the one that was planned: another text, or other
/// overrides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OtherSpec;

impl fmt::Display for OtherSpec {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("this plan was made for another spec: plan this spec again")
    }
}

impl Error for OtherSpec {}

/// Why planning was not attempted for a spec.
#[derive(Debug, Clone, PartialEq)]
pub enum Refusal {
    /// The spec has no mission.
    NoMission(Vec<Diagnostic>),
    /// The spec is larger than what can be planned or compared.
    TooLarge(Vec<Diagnostic>),
    /// Hover is not inside every set that the plan must keep to.
    Intolerable(Vec<Diagnostic>),
    /// The mission cannot keep the height that `require capture_height` asks for.
    TooLow(Vec<Diagnostic>),
}

impl Refusal {
    /// The reasons, and warnings, at their places in the spec.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        match self {
            Refusal::NoMission(found)
            | Refusal::TooLarge(found)
            | Refusal::Intolerable(found)
            | Refusal::TooLow(found) => found,
        }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let errors = self.diagnostics().iter().filter(|d| d.severity == Severity::Error);
        let messages: Vec<&str> = errors.map(|d| d.message.as_str()).collect();
        f.write_str(&messages.join("; "))
    }
}

impl Error for Refusal {}
