//! The pipeline: one function for each question about a [`Spec`]. The crate's root re-exports the functions.

mod baseline;
mod capture_height;
mod certificates;
mod diagnosis;
mod flights;
mod identification;
mod planned;
mod records;
mod recovery;
mod refusals;
#[cfg(feature = "report")]
mod safety;
mod stages;
mod sweep;
mod tasks;

pub use certificates::{Rejected, Uncertified, certify, verify, verify_within, with_ways_out};
pub use diagnosis::{Diagnosed, Undiagnosed, Why, diagnose};
pub use flights::{NoFlight, campaign, departure, fly, fly_plan, indistinguishable, missing_verdict};
pub use identification::{Figure, Identified, identify};
pub use planned::{Explained, Planning};
pub use records::defaults_text;
pub use refusals::{OtherSpec, Refusal, Unexplained};
pub use stages::{NotPrinted, Program, actuation_text, mjcf_text, model_record, px4_params_text, sets_text};
pub use sweep::{Flip, Sweep};
pub use tasks::{NO_MISSION, Task, compare, explain, no_mission, plan};

#[cfg(feature = "cli")]
pub(crate) use flights::sized;

use crate::admissible::diagnose::{self as intolerable, is_too_large};
use crate::admissible::verdict::ModeAnalysis;
use crate::diagnostic::{Checked, Diagnostic, Severity, sort};
use crate::flight::capture::{Capture, captures};
use crate::flight::equilibrium::analyze_each;
use crate::flight::indistinguishable;
use crate::source::{FileId, Source};
use crate::spec::{Compiled, Compiler, Spec};
use std::io::{Error, ErrorKind};

/// Compiles the text of a spec (docs/language.md). Syntax, names, units, ranges and plausibility are checked, and all
/// mistakes are reported together.
///
/// Never fails: [`Compiled::into_result`] gives the error. The result holds the [`Spec`] if the text has no errors, and
/// every diagnostic. All numbers of a spec are in SI units.
///
/// The text may not name other files. A [`Compiler`] reads such files, compiles a file, and takes overrides.
///
/// ```
/// let compiled = mavc::compile("vehicle quad { mass = 1.8 m }");
/// assert!(compiled.spec.is_none());
/// let codes: Vec<_> = compiled.diagnostics.iter().map(|d| d.code).collect();
/// assert!(codes.contains(&"mavc::unit::mismatch"), "{}", compiled.render());
/// ```
pub fn compile(text: &str) -> Compiled {
    let no_files = |_: &std::path::Path| Err(Error::new(ErrorKind::NotFound, "a text names no files"));
    Compiler::new().reading(&no_files).text("<spec>", text.as_bytes())
}

/// Formats the text of a spec: indentation, spaces and columns (docs/formatting.md). The meaning, the order of
/// statements, their line breaks and every comment are kept. Returns the formatted text.
///
/// # Errors
/// The text has errors of syntax, or the formatted text would exceed 1 MiB. The diagnostics are returned.
///
/// ```
/// assert_eq!(mavc::format("let  m=2 kg").unwrap(), "let m = 2 kg\n");
/// assert_eq!(mavc::format("let m = = 2").unwrap_err()[0].code, "mavc::syntax::unexpected");
/// ```
pub fn format(text: &str) -> Result<String, Vec<Diagnostic>> {
    let Checked { value, diagnostics } = crate::format::format(FileId::default(), &Source::new("<spec>", text));
    value.ok_or(diagnostics)
}

/// Analyses what the vehicle can still do in each fault mode: the outcome (`admissible::outcome::Outcome`), the
/// verdict, the margins of hover (N, N m), the largest mass (kg) and the headroom (N, N m). [`ModeAnalysis`] lists the
/// fields with their units. Never fails. The healthy vehicle comes first, then every declared mode in its order.
///
/// The verdicts are those of section 3 of the paper: the available control authority index (ACAI, equation 31) for
/// controllability, the rank of the controllability matrix, and the residual of the nearest admissible wrench. See
/// docs/method/verdicts.md. The mission and the plan have no influence.
///
/// ```
/// let spec = mavc::compile(mavc::TEMPLATE).into_result()?;
/// let modes = mavc::analyze(&spec);
/// assert_eq!(modes.len(), 1 + spec.model().modes.len());
/// assert_eq!(modes[0].verdict.name(), "controllable");
/// # Ok::<(), mavc::CompileError>(())
/// ```
pub fn analyze(spec: &Spec) -> Vec<ModeAnalysis> {
    analyze_each(spec.model())
}

/// Simulates, for each mode in which yaw is given up, the height (m) that the vehicle loses from the fault until it
/// flies level again: over delays of 20 to 300 ms until the fault is known, at rest and at 5 m/s, with the rotors' time
/// constant and twice that. Never fails; empty if yaw is given up in no mode. See docs/flight.md, section 2, "Without
/// yaw"; nothing of this is proved.
///
/// ```
/// let spec = mavc::compile(mavc::TEMPLATE).into_result()?;
/// for case in mavc::capture(&spec) {
///     println!("{} after {} s: {:?} m", case.mode, case.delay_s, case.height_m);
/// }
/// # Ok::<(), mavc::CompileError>(())
/// ```
pub fn capture(spec: &Spec) -> Vec<Capture> {
    captures(spec.model())
}

/// Checks a spec against the admissible sets and the estimator: fault modes that the plan must tolerate but cannot
/// (errors), hover on the edge of a set, and modes that an estimator cannot distinguish (warnings); and what
/// `require capture_height` comes to, which is simulated.
///
/// Returns the diagnostics in the order of their places in the spec; it is empty if there is nothing to report.
/// `mavc check` prints them together with those of [`compile`]. See docs/method/verdicts.md, for the sets.
///
/// ```
/// let spec = mavc::compile(mavc::TEMPLATE).into_result()?;
/// assert!(mavc::check(&spec).iter().all(|d| d.severity != mavc::Severity::Error));
/// # Ok::<(), mavc::CompileError>(())
/// ```
pub fn check(spec: &Spec) -> Vec<Diagnostic> {
    let mut diagnostics = intolerable::diagnose(spec.model());
    diagnostics.extend(indistinguishable::diagnose(spec.model()));
    if !is_too_large(&diagnostics) {
        diagnostics.extend(capture_height::diagnose(spec.model()));
    }
    sort(&mut diagnostics);
    diagnostics
}

/// Whether the diagnostics of [`check`] name a fault mode that the plan must tolerate but cannot. Sets that are too
/// large to work with are errors of another kind: whether the plan tolerates the mode is then unknown.
pub fn is_intolerable(found: &[Diagnostic]) -> bool {
    let is_error = |d: &Diagnostic| d.severity == Severity::Error && !capture_height::is_about(d);
    found.iter().any(is_error) && !is_too_large(found)
}
