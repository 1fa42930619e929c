//! What a reader of a campaign must not overlook, as sentences.

use crate::campaign::design::Design;
use crate::campaign::statistics::{Delays, QUANTILES};
use crate::campaign::tally::Tally;
use crate::flight::indistinguishable::listed;
use crate::model::Detection;
use crate::number::{fixed, number, plural, significant};

/// Modes of which a fault costs more height than `lost_beyond`: vehicles that are caught count as lost.
pub fn beyond_the_limit(design: &Design) -> Option<String> {
    let limit = design.model.simulation.lost_beyond;
    let most = |m: &usize| design.modes[*m].capture.iter().filter_map(|c| c.height_m).fold(0.0, f64::max);
    let beyond: Vec<usize> = (0..design.cases.modes).filter(|m| most(m) > limit).collect();
    let names: Vec<&str> = beyond.iter().map(|m| design.model.modes[*m].name.as_str()).collect();
    let height = beyond.iter().map(most).fold(0.0, f64::max);
    (!beyond.is_empty()).then(|| {
        format!(
            "Caught by its spin after {}, the vehicle falls by up to {} m, more than the {} m of `lost_beyond`: \
             flights that go on count as lost.",
            listed(&names),
            significant(height, 3),
            number(limit)
        )
    })
}

/// Flights lost without a fault.
pub fn lost_healthy(tally: &Tally, p: usize) -> Option<String> {
    let healthy = tally.healthy(p);
    let lost = healthy.all_lost();
    (lost > 0).then(|| {
        format!(
            "Warning: {lost} of {} without a fault {} lost. The vehicle cannot fly this plan, so its losses say little \
             about faults: limit the tilt, or give the mission more time.",
            plural(healthy.flights, "flight"),
            if lost == 1 { "was" } else { "were" }
        )
    })
}

/// Flights lost before their fault.
pub fn lost_before(design: &Design, tally: &Tally, p: usize) -> Option<String> {
    let before: usize = (0..design.cases.modes).map(|m| tally.mode(p, m).lost_before).sum();
    let were = if before == 1 { "was" } else { "were" };
    (before > 0).then(|| format!("{} {were} lost before the fault could strike.", plural(before, "flight")))
}

/// Flights of which nothing is known.
pub fn diverged(design: &Design, tally: &Tally, p: usize) -> Option<String> {
    let diverged =
        tally.healthy(p).diverged + (0..design.cases.modes).map(|m| tally.mode(p, m).diverged).sum::<usize>();
    (diverged > 0).then(|| {
        format!(
            "{} diverged: the integration broke down (NaN, infinity, or more than half a turn in one step). What \
             happened to the vehicle is unknown: such a flight counts as a flight, but neither as lost nor as survived.",
            plural(diverged, "flight")
        )
    })
}

/// How often the estimator raised false alarms, and how soon it isolated the faults; `None` without an estimator.
pub fn estimator(design: &Design, tally: &Tally, p: usize) -> Option<String> {
    if design.model.simulation.detection != Detection::Estimator {
        return None;
    }
    let healthy = tally.healthy(p);
    let per_hour = healthy.alarms_per_hour()?;
    let mut isolation = Delays::default();
    (0..design.cases.modes).for_each(|m| isolation.join(&tally.mode(p, m).isolation));
    let within = |share: f64| {
        let of = format!("{} % ", number(100.0 * share));
        isolation.quantile(share).map_or(format!("{of}never"), |s| format!("{of}{} s", fixed(s, 2)))
    };
    let isolated = match isolation.is_empty() {
        true => String::new(),
        false => format!("; faults are isolated within: {}", QUANTILES.map(within).join(", ")),
    };
    Some(format!(
        "The estimator raised {} in {} h of healthy flight, {} an hour{isolated}.",
        plural(healthy.false_alarms, "false alarm"),
        significant(healthy.seconds / 3600.0, 3),
        significant(per_hour, 3)
    ))
}

/// What the reserve of a plan does not cover, if flights are lost after faults whose sets the plan never leaves.
pub fn uncovered(design: &Design, tally: &Tally, p: usize) -> Option<String> {
    let plan = &design.plans[p];
    let inside = |m: &usize| {
        let name = &design.model.modes[*m].name;
        plan.against.contains(name) && plan.outside[*m].last.is_none()
    };
    let (lost, struck) =
        (0..design.cases.modes).filter(inside).map(|m| tally.mode(p, m)).fold((0, 0), |(lost, struck), group| {
            (lost + group.struck().saturating_sub(group.survived()), struck + group.struck())
        });
    let reserve = number(100.0 * design.model.plan.reserve);
    (lost > 0).then(|| {
        format!(
            "{lost} of {} that struck were not survived although the plan never leaves the sets of their modes: its \
             reserve of {reserve} % is a share of the sets of the modelled vehicle. It covers neither gusts nor a \
             thrust below the modelled one, nor the time until the fault is known.",
            plural(struck, "fault")
        )
    })
}
