//! Certificates: making one from an outcome, and deciding whether it holds.

use super::planned::Planning;
use super::refusals::OtherSpec;
use crate::certificate::{Certificate, Claim};
use crate::certify as write;
use crate::model::Problem;
use crate::recovery::Recovery;
use crate::spec::Spec;
use crate::verify::Accepted;
use crate::verify::cost::Budget;
use std::error::Error;
use std::fmt;

pub use crate::verify::{Rejected, verify_within};

/// Makes the certificate of an outcome of [`plan`](super::plan): the trajectory of a plan, or the multipliers of a
/// proof of infeasibility. All numbers are in SI units. The certificate is checked before it is returned, so [`verify`]
/// accepts it.
///
/// docs/certificates.md states what a certificate shows, as a theorem.
///
/// # Errors
/// The outcome is for another spec; it is neither a plan nor a proof; or the proof covers more mission times than one
/// certificate can show.
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

/// Adds the families of ways out that were found along a plan to its certificate, which [`verify`] then decides too.
pub fn with_ways_out(mut certificate: Certificate, recovery: &Recovery) -> Certificate {
    if let Claim::Plan(claim) = &mut certificate.claim {
        claim.recovery = recovery.claim();
    }
    certificate
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

/// Decides whether a certificate (JSON) holds for a spec. The code works out from the spec what has to hold, and
/// decides it from the certificate's trajectory or multipliers in interval and exact arithmetic. It uses neither the
/// planner nor the solver (docs/certificates.md).
///
/// The default [`Budget`] is 10 s of one core and 500,000,000 bytes; [`verify_within`] takes another.
///
/// The verdict lists what is shown, and in what the certificate proves less than the spec requires.
///
/// # Errors
/// The bytes are not a certificate; the certificate was written for another spec; it does not hold; or the check would
/// exceed the default budget of time and memory.
///
/// ```
/// let spec = mavc::compile(mavc::TEMPLATE).into_result()?;
/// let certificate = serde_json::to_vec(&mavc::certify(&spec, &mavc::plan(&spec)?)?)?;
/// assert!(mavc::verify(&certificate, &spec).is_ok());
/// let rejected = mavc::verify(b"{}", &spec).unwrap_err();
/// assert_eq!(rejected.diagnostic.code, "mavc::verify::malformed");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn verify(certificate: &[u8], spec: &Spec) -> Result<Accepted, Rejected> {
    verify_within(Budget::default(), "<certificate>", certificate, spec)
}
