//! The independent checker of certificates. It uses only the spec's [`Model`] and the certificate's witness, in
//! interval and exact arithmetic, and none of the code of the planner, the sets or the solver, so that it does not
//! inherit their errors. The conditions to check follow from the spec; docs/certificates.md states them as a theorem,
//! whose premises are those of [`Premise`].

mod capture_height;
pub mod core;
pub mod cost;
pub mod dyadic;
pub mod facets;
mod file;
mod heading;
mod infeasible;
pub mod interval;
pub mod joints;
pub mod lag;
mod least_time;
pub mod limits;
pub mod most_thrust;
pub mod motion;
pub mod plan;
mod premise;
pub mod proof;
mod read;
pub mod recovery;
mod schedule;
pub mod series;
pub mod sets;
pub mod taylor;
pub mod text;
mod volumes;
pub mod wind;
pub mod wrench;

use crate::certificate::{Certificate, Claim, DynamicModel, MotionRecord};
use crate::diagnostic::Diagnostic;
use crate::model::{Allocation, FaultMode, Model, PlanModel, PlannerKind, Problem};
use crate::number::{down, number};
use crate::source::Span;
use cost::{Budget, Estimate};
use plan::Setting;
use proof::{Failure, Measure};
use recovery::Covered;

pub use file::{Rejected, verify_within};
pub use premise::{Premise, Premises};
pub use read::{MALFORMED, Read, read};

/// Code of the error for a certificate that does not prove its claim.
pub const REJECTED: &str = "mavc::verify::rejected";
/// Code of the error for a certificate of another spec.
pub const OTHER_SPEC: &str = "mavc::verify::other_spec";
/// Code of the error for a certificate that would cost more to decide than the budget.
pub const TOO_COSTLY: &str = "mavc::verify::too_costly";

/// The first condition found that does not hold.
#[derive(Debug, Clone, PartialEq)]
pub struct Rejection {
    /// The subject of the condition: a set, a limit, a waypoint.
    pub claim: String,
    /// Why the condition does not hold.
    pub detail: String,
    /// When, s.
    pub at: Option<f64>,
    /// The statement of the spec that requires it.
    pub span: Option<Span>,
}

impl Rejection {
    /// A rejection without an instant and a place.
    pub fn new(claim: impl Into<String>, detail: impl Into<String>) -> Self {
        Rejection { claim: claim.into(), detail: detail.into(), at: None, span: None }
    }

    /// The condition that does not hold, when, and why.
    pub fn sentence(&self) -> String {
        let at = self.at.map_or(String::new(), |t| format!(" at {} s", number(t)));
        format!("{}{at}: {}", self.claim, self.detail)
    }
}

/// Why a certificate is not accepted.
#[derive(Debug, Clone, PartialEq)]
pub enum Refusal {
    /// A condition does not hold.
    Rejected(Rejection),
    /// The decision would cost more than the budget; nothing was decided.
    Budget { estimate: Estimate, budget: Budget },
}

impl From<Rejection> for Refusal {
    fn from(rejection: Rejection) -> Self {
        Refusal::Rejected(rejection)
    }
}

impl Refusal {
    /// The reason in one sentence.
    pub fn sentence(&self) -> String {
        match self {
            Refusal::Rejected(rejection) => rejection.sentence(),
            Refusal::Budget { estimate, budget } => format!(
                "deciding it takes about {} s and {} MB, but the budget is {} s and {} MB",
                number(estimate.seconds()),
                megabytes(estimate.bytes),
                number(budget.seconds),
                megabytes(budget.bytes)
            ),
        }
    }

    fn diagnostic(&self, claim: &Claim, model: &Model) -> Diagnostic {
        match self {
            Refusal::Rejected(rejection) => {
                let message = format!("the certificate is rejected: {}", rejection.sentence());
                let error = Diagnostic::error(REJECTED, rejection.span.unwrap_or(model.plan.span), message);
                let open = match claim {
                    Claim::Plan(_) => "the plan is not proved",
                    Claim::Infeasible(_) | Claim::TooEarly(_) => "it is open whether there is a plan",
                };
                error.here("this plan is not proved").help(format!(
                    "write a new certificate with `mavc plan --certificate`; if it is rejected too, {open}"
                ))
            }
            Refusal::Budget { estimate, budget } => {
                let message = format!("the certificate is not decided: {}", self.sentence());
                let error = Diagnostic::error(TOO_COSTLY, model.plan.span, message);
                let seconds = estimate.seconds().ceil().max(budget.seconds);
                let size = megabytes(estimate.bytes.max(budget.bytes));
                error.here("this is too costly to verify").help(format!(
                    "allow more with `--budget {}s,{size}MB`, or plan with fewer samples or modes",
                    number(seconds)
                ))
            }
        }
    }
}

/// Rounded up, so that the printed figure is sufficient.
fn megabytes(bytes: u64) -> u64 {
    bytes.div_ceil(1_000_000)
}

/// Where a row is shown to hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Scope {
    /// At the nodes given by the spec's samples.
    Nodes,
    /// On a grid of [`plan::POINTS_OF_A_GRID`] points between two nodes.
    Grid,
    /// At every instant of the flight.
    EveryInstant,
}

/// To what extent rows are shown to hold beyond the nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reach {
    pub scope: Scope,
    /// The violation between the nodes, if a grid shows one.
    pub beyond: Option<Beyond>,
}

/// A violation of rows between the nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beyond {
    /// Its size, in the units that `measure` converts from.
    pub violation: f64,
    /// s
    pub at: f64,
    pub measure: Measure,
    /// Whether `violation` is proved to be a bound at every instant; otherwise it is the largest on the grid.
    pub throughout: bool,
}

impl Reach {
    const NODES: Reach = Reach { scope: Scope::Nodes, beyond: None };
    const EVERY_INSTANT: Reach = Reach { scope: Scope::EveryInstant, beyond: None };

    fn violated(worst: Failure, measure: Measure) -> Self {
        let beyond = Beyond { violation: worst.violation, at: worst.at, measure, throughout: false };
        Reach { scope: Scope::Nodes, beyond: Some(beyond) }
    }

    /// The weaker of two: the one with the larger violation, or the smaller scope.
    fn weakest(self, other: Reach) -> Reach {
        let size = |reach: &Reach| reach.beyond.map_or(f64::NEG_INFINITY, |beyond| beyond.violation);
        let mut weakest = match size(&self).total_cmp(&size(&other)) {
            std::cmp::Ordering::Greater => self,
            std::cmp::Ordering::Less => other,
            std::cmp::Ordering::Equal if self.scope < other.scope => self,
            std::cmp::Ordering::Equal => other,
        };
        // The larger violation bounds both only if each is bounded at every instant.
        let is_bounded =
            |reach: &Reach| reach.scope == Scope::EveryInstant || reach.beyond.is_some_and(|beyond| beyond.throughout);
        let both = is_bounded(&self) && is_bounded(&other);
        weakest.beyond.iter_mut().for_each(|beyond| beyond.throughout &= both);
        weakest
    }

    /// Why a statement is weaker than the spec requires, if it is.
    fn weaker(&self, statement: &str) -> Option<String> {
        match (self.scope, self.beyond) {
            (Scope::EveryInstant, _) => None,
            (Scope::Grid, _) => Some(format!("{statement}: not proved between the points of a grid")),
            (Scope::Nodes, None) => Some(format!("{statement}: shown only at the nodes")),
            (Scope::Nodes, Some(beyond)) => {
                let by = beyond.measure.at_most(beyond.violation);
                let of = beyond.measure.whole.map_or(String::new(), |whole| format!(" {whole}"));
                let most = if beyond.throughout { "at most " } else { "" };
                Some(format!("{statement}: exceeded between the nodes by {most}{by}{of}, at {} s", number(beyond.at)))
            }
        }
    }
}

/// A statement, and where it is shown to hold.
#[derive(Debug, Clone, PartialEq)]
pub struct Shown {
    pub statement: String,
    /// `None` if the statement is not about instants of a motion.
    pub reach: Option<Reach>,
}

impl Shown {
    fn new(statement: String, reach: Reach) -> Self {
        Shown { statement, reach: Some(reach) }
    }

    fn at_nodes(statement: String) -> Self {
        Shown::new(statement, Reach::NODES)
    }
}

/// A fault mode by its name.
fn mode_named<'a>(model: &'a Model, name: &str) -> Option<&'a FaultMode> {
    model.modes.iter().find(|m| m.name == name)
}

/// The modes in whose sets every plan of the spec's planner stays: under RCP the fault modes, and the healthy one if
/// their sets need not lie inside its set.
fn required(model: &Model) -> Vec<String> {
    let against = model.plan.against.iter().filter_map(|&i| model.modes.get(i)).map(|m| m.name.clone());
    match model.plan.planner {
        PlannerKind::Rcp if model.plan.against.is_empty() => vec![sets::HEALTHY.into()],
        PlannerKind::Rcp if faults_may_add(model) => std::iter::once(sets::HEALTHY.into()).chain(against).collect(),
        PlannerKind::Rcp => against.collect(),
        _ => vec![sets::HEALTHY.into()],
    }
}

/// The modes of [`required`] in whose whole sets every plan stays: those in which plans may give up yaw are left out,
/// and then the healthy vehicle's is one of them.
fn required_whole(sets: &sets::Sets) -> Vec<String> {
    let mut modes = required(sets.model());
    let kept = |name: &String| sets.mode(name).is_none_or(|mode| !core::may_be_freed(sets, mode));
    let before = modes.len();
    modes.retain(kept);
    if modes.len() < before && !modes.iter().any(|mode| mode == sets::HEALTHY) {
        modes.insert(0, sets::HEALTHY.into());
    }
    modes
}

/// Whether a fault mode's set may extend beyond the healthy set: a lost rotor gives less than the idle thrust of a
/// rotor that cannot stop, and the pseudo-inverse distributes wrenches differently after a fault.
fn faults_may_add(model: &Model) -> bool {
    let vehicle = &model.vehicle;
    vehicle.allocation == Allocation::PseudoInverse || vehicle.rotors.iter().any(|r| r.min_speed > 0.0)
}

/// What an accepted certificate proves.
#[derive(Debug, Clone, PartialEq)]
pub struct Accepted {
    /// One sentence about the spec.
    pub headline: String,
    /// The statements that hold, and where.
    pub shown: Vec<Shown>,
    /// Where it is weaker than the spec requires; empty if it is as strong.
    pub weaker: Vec<String>,
    /// Conditions that could not be decided at all; `weaker` lists them too.
    pub undecided: Vec<String>,
    /// When a fault has a way out that the certificate shows, for each mode with such an instant.
    pub ways_out: Vec<Covered>,
}

#[deprecated = "renamed to `Accepted`"]
pub type Verdict = Accepted;

/// Budget and premises of a decision.
#[derive(Debug, Clone, Copy, Default)]
pub struct Settings {
    pub budget: Budget,
    pub premises: Premises,
}

/// Decides a certificate for a checked spec with the given hash.
///
/// # Errors
/// The certificate was written for another spec, does not prove its claim, or costs more than the budget.
pub fn verify(read: &Read, model: &Model, spec_sha256: &str, settings: Settings) -> Result<Accepted, Box<Diagnostic>> {
    let certificate = &read.certificate;
    if settings.premises.has(Premise::Spec) && certificate.spec_sha256 != spec_sha256 {
        // Enough digits to distinguish specs.
        let [written, given] = [&certificate.spec_sha256, spec_sha256].map(|hash| hash.chars().take(12).collect());
        let (written, given): (String, String) = (written, given);
        let message = format!("the certificate was written for another spec: {written}, but this one is {given}");
        let error = Diagnostic::error(OTHER_SPEC, read.hash, message).here("not the SHA-256 of this spec");
        return Err(error.help("give the spec it was written for, with the same files and the same `--set`").into());
    }
    decide(certificate, model, settings).map_err(|r| r.diagnostic(&certificate.claim, model).into())
}

/// Decides a certificate that is known to be about this model.
///
/// # Errors
/// The certificate does not prove its claim, or costs more than the budget.
pub fn decide(certificate: &Certificate, model: &Model, settings: Settings) -> Result<Accepted, Refusal> {
    decided(certificate, model, settings, true)
}

/// Decides a certificate at the nodes only: whether a motion is a plan, without checking rows between the nodes.
///
/// # Errors
/// The certificate does not prove its claim at the nodes, or costs more than the budget.
pub fn decide_at_nodes(certificate: &Certificate, model: &Model, settings: Settings) -> Result<Accepted, Refusal> {
    decided(certificate, model, settings, false)
}

fn decided(certificate: &Certificate, model: &Model, settings: Settings, between: bool) -> Result<Accepted, Refusal> {
    let model = &*capture_height::kept(certificate, model)?;
    let Some(problem) = Problem::of(model) else {
        return Err(Rejection::new("the mission", "the spec has none").into());
    };
    let required = match model.plan.model {
        PlanModel::Hover => DynamicModel::Hover,
        PlanModel::Exact => DynamicModel::Exact,
    };
    if settings.premises.has(Premise::Equations) && certificate.model != required {
        let name = model.plan.model.name();
        let why = {
            let of = match certificate.model {
                DynamicModel::Hover => "hover",
                DynamicModel::Exact => "exact",
            };
            format!("the certificate is for `model = {of}`, the spec for `model = {name}`")
        };
        return Err(Rejection::new("the model", why).into());
    }
    let setting = Setting::new(problem, certificate.model, settings.premises);
    match &certificate.claim {
        Claim::Plan(claim) => {
            let mut found = setting.decide(claim, settings.budget, between)?;
            if settings.premises.has(Premise::LeastTime) {
                least_time::not_beaten(problem, &claim.motion, found.most_thrust, &claim.weights)?;
            }
            if let Some(least) = claim.least_time_s {
                if settings.premises.has(Premise::LeastTime) {
                    least_time::bound(problem, least, found.most_thrust, &claim.weights)?;
                }
                let least = down(least, 4);
                let covers = model.plan.planner != PlannerKind::Rip && !model.plan.against.is_empty();
                let within = problem.mission().bounded_within(covers);
                let statement = format!("no motion {within} takes less than {least} s");
                found.shown.push(Shown { statement, reach: None });
            }
            let headline = plan_headline(problem, found.total, &claim.selected_by);
            let weaker = found.weaker.into_iter().chain(capture_height::weaker(model, false));
            let weaker = weaker.chain(one_drag(model)).collect();
            Ok(Accepted { headline, shown: found.shown, weaker, undecided: found.undecided, ways_out: found.ways_out })
        }
        Claim::TooEarly(claim) => {
            let (estimate, budget) = (least_time::cost(problem, &claim.weights), settings.budget);
            if !estimate.fits(budget) {
                return Err(Refusal::Budget { estimate, budget });
            }
            let headline = match settings.premises.has(Premise::LeastTime) {
                true => least_time::too_early(problem, claim)?,
                false => String::new(),
            };
            Ok(Accepted {
                headline,
                shown: Vec::new(),
                weaker: Vec::new(),
                undecided: Vec::new(),
                ways_out: Vec::new(),
            })
        }
        Claim::Infeasible(claim) => {
            let mut verdict = infeasible::decide(&setting, certificate.model, claim, settings.budget)?;
            verdict.weaker.extend(capture_height::weaker(model, true));
            Ok(verdict)
        }
    }
}

/// Why a plan of a vehicle with an interval of `drag` shows less than the spec asks for. That there is none for the
/// middle shows that there is none for all values.
fn one_drag(model: &Model) -> Option<String> {
    let (spread, [x, y, z]) = (model.vehicle.drag_spread, model.vehicle.drag);
    if spread.is_none() {
        return None;
    }
    let [low, high] = [spread.low, spread.high].map(|share| number(100.0 * share));
    let middle = match x == y && y == z {
        true => number(x),
        false => format!("[{}, {}, {}]", number(x), number(y), number(z)),
    };
    Some(format!(
        "`drag`: shown for {middle} N*s/m alone, the middle of its interval, and not for the other values from {low} \
         to {high} % of it"
    ))
}

/// The claim of an accepted plan in one sentence.
fn plan_headline(problem: Problem, total: f64, selected_by: &[MotionRecord]) -> String {
    let (model, mission) = (problem.model(), problem.mission());
    let planner = model.plan.planner.name().to_uppercase();
    // If the spec leaves the time free, RSP selects facets at a time different from its own.
    let selects_at = selected_by.first().and_then(|motion| motion.times_s.last()).copied().unwrap_or(total);
    let of = match schedule::is_one_time(selects_at, total, total) {
        true => String::new(),
        false => format!(", of {} s", number(selects_at)),
    };
    let selection = match selected_by.len() {
        0 => String::new(),
        1 => format!(", for the facets selected by the included RIP plan{of}"),
        rounds => format!(", for the facets selected by the {rounds} included plans{of}"),
    };
    let in_hover = match model.plan.model {
        PlanModel::Hover => " in the linear model about hover",
        PlanModel::Exact => "",
    };
    format!("the motion of {} s is a plan of mission {} by {planner}{in_hover}{selection}", number(total), mission.name)
}
