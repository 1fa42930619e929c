//! Simulated flights along plans: one with the faults of the spec, or a campaign.

use super::planned::Planning;
use super::refusals::{OtherSpec, Refusal};
use super::tasks::Task;
use crate::campaign::cases::{MAX_FLIGHTS, Shard};
use crate::campaign::design::{Design, Missing};
use crate::campaign::run::fly_all;
use crate::campaign::tally::Tally;
use crate::diagnostic::{Diagnostic, Severity, sort};
use crate::flight::{Flight, Sample, Sortie, WaysOut, fly as fly_sortie, indistinguishable, longest};
use crate::model::Problem;
use crate::observer::{Observer, Silent, timed};
use crate::planner::studies::{Comparison, MissionPlan};
use crate::read::{coarse_step, past_the_end, too_many_steps};
use crate::recovery::flown_way_out;
use crate::report::campaign_record::CampaignRecord;
use crate::spec::{Spec, program_sha256};
use crate::verdict::Verdict;
use std::convert::Infallible;
use std::error::Error;
use std::fmt;
use std::time::Instant;

/// Simulates a flight of the nonlinear vehicle along the plan of an outcome of [`plan`](super::plan), with the faults,
/// air, sensors and controller of the spec's `simulate` block (docs/flight.md). The same spec gives the same flight.
///
/// Returns how the flight ended, with distances in m, times in s and angles in rad. A simulated flight proves nothing.
///
/// # Errors
/// The outcome is for another spec; there is no plan to fly; or the `simulate` block does not fit the plan: a fault
/// after its end, or too many steps.
///
/// ```
/// let spec = mavc::compile(mavc::TEMPLATE).into_result()?;
/// let flight = mavc::fly(&spec, &mavc::plan(&spec)?)?;
/// println!("{:?} after {} s, {:.2} m off at most", flight.outcome, flight.end, flight.max_error);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn fly(spec: &Spec, planning: &Planning) -> Result<Flight, NoFlight> {
    planning.check_spec(spec).map_err(NoFlight::OtherSpec)?;
    let Some(plan) = planning.plan() else { return Err(NoFlight::NoPlan(planning.verdict())) };
    let remarks = departure(spec, plan.time);
    if remarks.iter().any(|d| d.severity == Severity::Error) {
        return Err(NoFlight::Errors(remarks));
    }
    Ok(fly_plan(spec, plan, None, &Silent))
}

/// Simulates a flight along a plan whose [`departure`] has no errors. `record` is called at every instant at which the
/// controller acts, and at the last instant.
pub fn fly_plan(
    spec: &Spec,
    plan: &MissionPlan,
    record: Option<&mut dyn FnMut(&Sample)>,
    observer: &dyn Observer,
) -> Flight {
    let model = spec.model();
    let mut sortie = Sortie::along(model, &plan.trajectory, &model.simulation.faults, model.simulation.seed);
    let find = |mode: usize, at: f64, known: f64| {
        observer.begins("looking for a way out after the fault");
        flown_way_out(Problem::of(model)?, &plan.trajectory, mode, at, known)
    };
    sortie.ways_out = Some(WaysOut { find: &find });
    let begin = Instant::now();
    let is_recorded = record.is_some();
    let flight = timed(observer, "flight", || fly_sortie(&sortie, record));
    observer.flown(&flight, begin.elapsed(), is_recorded);
    flight
}

/// The groups of modes, by name, that the estimator cannot distinguish at the rotor speeds that a plan needs.
pub fn indistinguishable<'s>(spec: &'s Spec, plan: &MissionPlan) -> Vec<Vec<&'s str>> {
    let groups = indistinguishable::along(spec.model(), &plan.trajectory);
    groups.iter().map(|group| indistinguishable::names(spec.model(), group)).collect()
}

/// Simulates a campaign of flights: every planner's plan at the common time T_d, with every declared fault mode, at
/// many instants and with many noise seeds (docs/campaigns.md). The `campaign` block of the spec sets their numbers.
///
/// Returns the record of `mavc campaign --report`: shares (0 to 1) of flights that survived, and times in s. All
/// flights are simulated in parallel before it returns.
///
/// # Errors
/// The mission cannot be planned, the campaign has too many flights, or the `simulate` block does not fit the plan. If
/// no planner found a plan, the result is a record without flights that lists the reasons.
///
/// ```
/// let text = mavc::TEMPLATE.to_string() + "campaign { times = 2; seeds = 1 }";
/// let record = mavc::campaign(&mavc::compile(&text).into_result()?)?;
/// assert!(record.flights > 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn campaign(spec: &Spec) -> Result<CampaignRecord, NoFlight> {
    let size = &spec.model().campaign;
    let spec = &sized(spec, size.times, size.seeds)?;
    let task = Task::new(spec).map_err(NoFlight::Refused)?;
    let comparison = task.at_common_time(&Silent);
    let sha256 = spec.sha256().to_string();
    let design = match Design::new(spec.model(), &comparison, &sha256) {
        Ok(design) => design,
        Err(missing) => return Ok(CampaignRecord::without_flights(spec.model(), &missing, sha256)),
    };
    let remarks = departure(spec, design.time);
    if remarks.iter().any(|d| d.severity == Severity::Error) {
        return Err(NoFlight::Errors(remarks));
    }
    let mut tally = Tally::new(design.cases);
    let Ok(()) = fly_all(&design, design.cases.of(Shard::WHOLE), |cases, rows| {
        cases.iter().zip(rows).for_each(|(case, row)| tally.add(case, row));
        Ok::<(), Infallible>(())
    });
    Ok(CampaignRecord::new(&design, Shard::WHOLE, &tally, sha256))
}

/// The spec with another size of its campaign: `times` instants of each fault and `seeds` noise seeds.
///
/// # Errors
/// The campaign would have more flights than [`MAX_FLIGHTS`].
pub(crate) fn sized(spec: &Spec, times: usize, seeds: usize) -> Result<Spec, NoFlight> {
    let (modes, planners) = (spec.model().modes.len(), spec.model().campaign.planners.len());
    let blocks = times.checked_mul(modes).and_then(|n| n.checked_add(1));
    let flights = blocks.and_then(|n| n.checked_mul(seeds)?.checked_mul(planners));
    match flights {
        Some(n) if n <= MAX_FLIGHTS => Ok(spec.with_campaign(times, seeds)),
        _ => Err(NoFlight::TooMany),
    }
}

impl Task<'_> {
    /// The campaign that `mavc campaign` flies along the plans at the common time. Its identity, by which rows of
    /// different campaigns are kept apart, depends on the spec and on the running program.
    ///
    /// # Errors
    /// No planner has a plan; the error lists the outcome of each.
    pub fn design(&self, comparison: &Comparison) -> Result<Design<'_>, Vec<Missing>> {
        let origin = self.spec().sha256().to_string() + &program_sha256();
        Design::new(self.model(), comparison, &origin)
    }
}

/// One verdict for the planners of a campaign that have no plan: `not found` if a search ended without a plan and
/// without a proof, else `proved infeasible` if there is a proof, else `not attempted`.
pub fn missing_verdict(missing: &[Missing]) -> Verdict {
    let verdicts: Vec<Verdict> = missing.iter().map(Missing::verdict).collect();
    let order = [Verdict::NotFound, Verdict::ProvedInfeasible];
    order.into_iter().find(|verdict| verdicts.contains(verdict)).unwrap_or(Verdict::NotAttempted)
}

/// The errors that prevent a simulated flight along a plan of `time` s, and warnings about it. They depend on the
/// duration, so they are known only after planning.
pub fn departure(spec: &Spec, time: f64) -> Vec<Diagnostic> {
    let model = spec.model();
    let mut found = past_the_end(model, model.simulation.duration.unwrap_or(time));
    found.extend(too_many_steps(model, longest(model, time)));
    found.extend(coarse_step(model));
    sort(&mut found);
    found
}

/// Why no flight was simulated.
#[derive(Debug, Clone, PartialEq)]
pub enum NoFlight {
    /// The mission cannot be planned.
    Refused(Refusal),
    /// The outcome is for another spec.
    OtherSpec(OtherSpec),
    /// There is no plan to fly, with this verdict.
    NoPlan(Verdict),
    /// The campaign would have more flights than [`MAX_FLIGHTS`].
    TooMany,
    /// The `simulate` block does not fit the plan; the errors have their places in the spec.
    Errors(Vec<Diagnostic>),
}

impl fmt::Display for NoFlight {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoFlight::Refused(refusal) => refusal.fmt(f),
            NoFlight::OtherSpec(other) => other.fmt(f),
            NoFlight::NoPlan(verdict) => write!(f, "there is no plan to fly: {verdict}"),
            NoFlight::TooMany => {
                f.write_str("a campaign has at most 100 million flights: take fewer modes, instants or seeds")
            }
            NoFlight::Errors(diagnostics) => {
                let errors = diagnostics.iter().filter(|d| d.severity == Severity::Error);
                let messages: Vec<&str> = errors.map(|d| d.message.as_str()).collect();
                f.write_str(&messages.join("; "))
            }
        }
    }
}

impl Error for NoFlight {}
