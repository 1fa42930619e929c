//! What is shown of a plan between its nodes, in words.

use super::caveats::passed;
use super::terminal::WIDTH;
use crate::admissible::row::VIOLATED;
use crate::certify::between::{Between, COMMANDS, GRID, Shown, WRENCH};
use crate::model::Model;
use crate::motion::wrench_model::WrenchModel;
use crate::number::percent;
use crate::planner::studies::MissionPlan;
use crate::tolerance::MOST_PAST_LIMIT;

/// Proved for every instant, or checked on a grid; `found` is of the wrench, of each limit in the mission's order, and of what
/// lagging rotors are commanded. Limits that the plan passes are left to the caveats, which say by how much and when.
pub fn between(model: &Model, solved: &MissionPlan, found: &[Between]) -> String {
    let (facets, limits): (Vec<&Between>, Vec<&Between>) =
        found.iter().partition(|b| b.rows == WRENCH || b.rows == COMMANDS);
    let linear = solved.trajectory.model != WrenchModel::Exact;
    let (mut proved, mut checked) = (Vec::new(), Vec::new());
    for b in facets {
        let told = on_facets(b, linear);
        proved.extend(told.0);
        checked.extend(told.1);
    }
    let passed: Vec<usize> = passed(model, solved).iter().map(|excess| excess.limit).collect();
    let kept = |shown: Shown| {
        let kept = limits.iter().enumerate().filter(|(i, b)| b.shown == shown && !passed.contains(i));
        let mut names: Vec<&str> = kept.map(|(_, b)| b.rows).collect();
        // Two statements may bound one thing, from above and from below.
        names.dedup();
        match names[..] {
            [] => None,
            [one] => Some(format!("the limit on {one}")),
            _ => Some(format!("the limits on {}", names.join("; "))),
        }
    };
    proved.extend(kept(Shown::Proved));
    checked.extend(kept(Shown::Checked));
    let heads = [
        (format!("Proved for every instant, to within {}:", percent(MOST_PAST_LIMIT)), proved),
        (format!("Checked on a grid of {GRID} points an interval:"), checked),
    ];
    let options = textwrap::Options::new(WIDTH).initial_indent("  ").subsequent_indent("  ");
    let told = heads.into_iter().filter(|(_, told)| !told.is_empty());
    told.map(|(head, told)| format!("\n{}\n", textwrap::fill(&format!("{head} {}.", told.join("; ")), &options)))
        .collect()
}

/// What is proved of the facets imposed, and what is only checked. In the `linear` model it is about that model's wrench, which
/// is not the vehicle's.
fn on_facets(b: &Between, linear: bool) -> (Option<String>, Option<String>) {
    let what = match (b.rows == COMMANDS, linear) {
        (true, false) => "what the rotors are commanded",
        (true, true) => "what the rotors are commanded in the linear model",
        (false, false) => "the wrench",
        (false, true) => "the linear model's wrench",
    };
    let all = format!("{what} keeps to every facet imposed");
    if b.shown == Shown::Proved {
        return (Some(all), None);
    }
    let some = (b.proved > 0).then(|| format!("{what} keeps to {} of the {} planes imposed", b.proved, b.imposed));
    let rest = match (b.excess > VIOLATED, b.imposed - b.proved) {
        (true, _) => format!("{what} passes a facet imposed by {} of its width", percent(b.excess)),
        (false, 1) if b.proved > 0 => "it keeps to the other one".into(),
        (false, others) if b.proved > 0 => format!("it keeps to the other {others}"),
        (false, _) => all,
    };
    (some, Some(rest))
}
