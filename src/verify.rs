//! Decides certificates with code of its own: from the spec's [`Model`] and the certificate's numbers alone, in
//! interval and exact arithmetic. Nothing of the planner, the sets or the solver is used, so an error there does not
//! pass here.

pub mod dyadic;
pub mod facets;
mod infeasible;
pub mod interval;
pub mod lag;
pub mod limits;
pub mod motion;
pub mod plan;
pub mod proof;
mod read;
mod schedule;
pub mod series;
pub mod sets;
pub mod wrench;

use crate::certificate::{Bound, Certificate, Claim, DynamicModel, Scope};
use crate::diagnostic::Diagnostic;
use crate::model::{Allocation, FaultMode, Model, PlanModel, PlannerKind};
use crate::report::number::number;
use crate::source::Span;
use plan::Checker;
use proof::{Failure, Measure};

pub use read::{MALFORMED, Read, read};

/// A certificate that does not show what it claims.
pub const REJECTED: &str = "mavc::verify::rejected";
/// A certificate of another spec.
pub const OTHER_SPEC: &str = "mavc::verify::other_spec";

/// The first claim found that does not stand.
#[derive(Debug, Clone, PartialEq)]
pub struct Rejection {
    /// What is claimed of: a set, a limit, a waypoint.
    pub claim: String,
    pub detail: String,
    /// s
    pub at: Option<f64>,
    /// The statement of the spec.
    pub span: Option<Span>,
}

impl Rejection {
    pub fn new(claim: impl Into<String>, detail: impl Into<String>) -> Self {
        Rejection { claim: claim.into(), detail: detail.into(), at: None, span: None }
    }

    /// A bound that does not stand; `place` says where beside the instant.
    fn of_bound(bound: &Bound, failure: &Failure, measure: Measure, place: String) -> Self {
        let [claimed, found] = [bound.excess, failure.excess].map(|excess| measure.kept_or_passed(excess));
        let of = measure.whole.map_or(String::new(), |whole| format!(" ({whole})"));
        let detail = match failure.refuted {
            true => format!("it is {found}{place}; claimed: {claimed}{of}"),
            false => format!("that it is {claimed} could not be proved{place}{of}"),
        };
        Rejection { at: Some(failure.at), ..Rejection::new("", detail) }
    }

    fn diagnostic(&self, claim: &Claim, model: &Model) -> Diagnostic {
        let at = self.at.map_or(String::new(), |t| format!(" at {} s", number(t)));
        let message = format!("the certificate is rejected: {}{at}: {}", self.claim, self.detail);
        let error = Diagnostic::error(REJECTED, self.span.unwrap_or(model.plan.span), message);
        let unproved = match claim {
            Claim::Plan(_) => "the plan does not hold",
            Claim::Infeasible(_) => "it is open whether there is a plan",
        };
        error.here("not shown for this").help(format!(
            "write the certificate anew with `mavc plan --certificate`; if that one is rejected too, {unproved}"
        ))
    }
}

/// How far a claim is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reach {
    /// `None` where it is about no motion.
    pub scope: Option<Scope>,
    /// A wider scope, and by how much the quantity exceeds what it may be there, where that is more than nothing.
    pub beyond: Option<(Bound, Measure)>,
}

/// What stands, and where it does.
#[derive(Debug, Clone, PartialEq)]
pub struct Shown {
    pub statement: String,
    pub reach: Reach,
    /// So many of the kind.
    pub count: usize,
}

impl Shown {
    fn new(statement: String, reach: Reach) -> Self {
        Shown { statement, reach, count: 1 }
    }

    fn at_nodes(statement: String) -> Self {
        Shown::new(statement, Reach { scope: Some(Scope::Nodes), beyond: None })
    }

    /// A proof about all motions.
    fn proved(statement: String) -> Self {
        Shown::new(statement, Reach { scope: None, beyond: None })
    }

    /// One more of a kind.
    fn count(shown: &mut Vec<Shown>, statement: &str, reach: Reach) {
        match shown.iter_mut().find(|s| s.statement == statement && s.reach == reach) {
            Some(same) => same.count += 1,
            None => shown.push(Shown::new(statement.into(), reach)),
        }
    }
}

/// A fault mode by its name.
fn mode_named<'a>(model: &'a Model, name: &str) -> Option<&'a FaultMode> {
    model.modes.iter().find(|m| m.name == name)
}

/// The modes whose sets the spec's planner keeps to: under RCP the faults', and the healthy one where they need not lie
/// inside it.
fn required(model: &Model) -> Vec<String> {
    let against = model.plan.against.iter().filter_map(|&i| model.modes.get(i)).map(|m| m.name.clone());
    match model.plan.planner {
        PlannerKind::Rcp if model.plan.against.is_empty() => vec![sets::HEALTHY.into()],
        PlannerKind::Rcp if faults_may_add(model) => std::iter::once(sets::HEALTHY.into()).chain(against).collect(),
        PlannerKind::Rcp => against.collect(),
        _ => vec![sets::HEALTHY.into()],
    }
}

/// A lost rotor that could not stop gives less than the healthy vehicle can; the pseudo-inverse shares wrenches out
/// otherwise once it knows of a fault.
fn faults_may_add(model: &Model) -> bool {
    let vehicle = &model.vehicle;
    vehicle.allocation == Allocation::PseudoInverse || vehicle.rotors.iter().any(|r| r.min_speed > 0.0)
}

/// What a certificate shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// Every claim, in order.
    pub shown: Vec<Shown>,
    /// What a plan's certificate claims of each mode that the spec's plan is against.
    pub guarded: Vec<Guarded>,
}

/// How much of a mode's set is claimed to be kept to.
#[derive(Debug, Clone, PartialEq)]
pub struct Guarded {
    pub mode: String,
    /// All of it.
    pub whole: bool,
    /// So many different facets.
    pub facets: usize,
}

/// Decides a certificate for a checked spec with the given hash.
///
/// # Errors
/// It was written for another spec, or shows less than it claims.
pub fn verify(read: &Read, model: &Model, spec_sha256: &str) -> Result<Verdict, Box<Diagnostic>> {
    let certificate = &read.certificate;
    if certificate.spec_sha256 != spec_sha256 {
        // As many digits as tell specs apart.
        let [written, given] = [&certificate.spec_sha256, spec_sha256].map(|hash| hash.chars().take(12).collect());
        let (written, given): (String, String) = (written, given);
        let message = format!("the certificate was written for another spec: {written}, and this one is {given}");
        let error = Diagnostic::error(OTHER_SPEC, read.hash, message).here("not the SHA-256 of the spec given");
        return Err(error.help("give the spec it was written for, with the same files and the same `--set`").into());
    }
    decide(certificate, model).map_err(|r| r.diagnostic(&certificate.claim, model).into())
}

/// Decides a certificate that is known to be about this model.
pub fn decide(certificate: &Certificate, model: &Model) -> Result<Verdict, Rejection> {
    let Some(mission) = &model.mission else {
        return Err(Rejection::new("the mission", "the spec has none"));
    };
    let asked = match model.plan.model {
        PlanModel::Hover => DynamicModel::Hover,
        PlanModel::Exact => DynamicModel::Exact,
    };
    if certificate.model != asked {
        let name = model.plan.model.name();
        return Err(Rejection::new(
            "the model",
            format!("the certificate has another, the spec plans with `model = {name}`"),
        ));
    }
    match &certificate.claim {
        Claim::Plan(claim) => {
            let mut checker = Checker::new(model, mission, certificate.model, &claim.motion)?;
            Ok(Verdict { shown: checker.decide(claim)?, guarded: checker.guarded(claim) })
        }
        Claim::Infeasible(claim) => {
            let shown = infeasible::decide(model, mission, certificate.model, claim)?;
            Ok(Verdict { shown, guarded: Vec::new() })
        }
    }
}
