//! Terminal text: which constraints are shown to hold between the nodes of a plan.

use super::caveats::exceeded_limits;
use crate::admissible::row::VIOLATED;
use crate::certify::between::{Between, COMMANDS, CORES, GRID, Shown, WRENCH};
use crate::model::Model;
use crate::motion::wrench_model::WrenchModel;
use crate::number::percent;
use crate::planner::studies::MissionPlan;
use crate::text_table::indented;
use crate::tolerance::MOST_PAST_LIMIT;

/// Constraints that are proved at every instant, and constraints that are only checked on a grid. `found` holds the
/// results for the wrench, for each limit in the mission's order, and for the commanded wrench of lagging rotors.
/// Limits that the plan exceeds are omitted: the caveats report by how much and when.
pub fn between(model: &Model, solved: &MissionPlan, found: &[Between]) -> String {
    let (facets, limits): (Vec<&Between>, Vec<&Between>) =
        found.iter().partition(|b| [WRENCH, CORES, COMMANDS].contains(&b.rows.as_str()));
    let linear = solved.trajectory.model != WrenchModel::Exact;
    let (mut proved, mut checked) = (Vec::new(), Vec::new());
    for b in facets {
        let (by_proof, on_grid) = on_facets(b, linear, model.environment().is_uncertain());
        proved.extend(by_proof);
        checked.extend(on_grid);
    }
    // A volume, which may have several limits, holds as the weakest of these does.
    let exceeded = exceeded_limits(model, solved);
    let of_volume = |i: usize| model.mission.as_ref().is_some_and(|mission| mission.limits[i].volume.is_some());
    let are_one = |i: usize, j: usize| i == j || of_volume(i) && of_volume(j) && limits[i].rows == limits[j].rows;
    // A yaw that follows from the motion has a table of its own.
    let is_yaw = |i: usize| model.mission.as_ref().is_some_and(|m| m.limits[i].kind.is_heading());
    let is_exceeded = |i: usize| is_yaw(i) || exceeded.iter().any(|violation| are_one(i, violation.limit));
    let is_checked = |i: usize| (0..limits.len()).any(|j| are_one(i, j) && limits[j].shown == Shown::Checked);
    let satisfied = |shown: Shown| {
        let holds = |(i, _): &(usize, &&Between)| !is_exceeded(*i) && (shown == Shown::Checked) == is_checked(*i);
        let satisfied = limits.iter().enumerate().filter(holds);
        let mut names: Vec<&str> = satisfied.map(|(_, b)| b.rows.as_str()).collect();
        // Two statements may bound the same quantity, from above and from below, and a volume has several limits.
        names.dedup();
        match names[..] {
            [] => None,
            [one] => Some(format!("the limit on {one} holds")),
            [ref all @ .., last] => Some(format!("the limits on {} and {last} hold", all.join(", "))),
        }
    };
    proved.extend(satisfied(Shown::Proved));
    checked.extend(satisfied(Shown::Checked));
    let heads = [
        (format!("Proved at every instant, to within {}:", percent(MOST_PAST_LIMIT)), proved),
        (format!("Checked on a grid of {GRID} points per interval:"), checked),
    ];
    let paragraphs = heads.into_iter().filter(|(_, items)| !items.is_empty());
    paragraphs.map(|(head, items)| format!("\n{}", indented(&format!("{head} {}.", items.join("; "))))).collect()
}

/// What is proved about the imposed facets, and what is only checked. In the `linear` model both are about that model's
/// wrench, which is not the vehicle's. In an interval of winds both are about every wind.
fn on_facets(b: &Between, linear: bool, is_windy: bool) -> (Option<String>, Option<String>) {
    let what = match (b.rows.as_str(), linear) {
        (COMMANDS, false) => "the commanded wrench",
        (COMMANDS, true) => "the linear model's commanded wrench",
        (CORES, false) => "the motion without yaw",
        (CORES, true) => "the linear model's motion without yaw",
        (_, false) => "the wrench",
        (_, true) => "the linear model's wrench",
    };
    let (facet, planes) = if b.rows == CORES { ("row of a core", "rows of cores") } else { ("facet", "planes") };
    let winds = if is_windy { " in every wind" } else { "" };
    let all = format!("{what} satisfies every imposed {facet}{winds}");
    if b.shown == Shown::Proved {
        return (Some(all), None);
    }
    let some =
        (b.proved > 0).then(|| format!("{what} satisfies {} of the {} imposed {planes}{winds}", b.proved, b.imposed));
    let rest = match (b.violation > VIOLATED, b.imposed - b.proved) {
        (true, _) => format!("{what} violates an imposed {facet} by {} of its width{winds}", percent(b.violation)),
        (false, 1) if b.proved > 0 => "it satisfies the other one".into(),
        (false, others) if b.proved > 0 => format!("it satisfies the other {others}"),
        (false, _) => all,
    };
    (some, Some(rest))
}
