//! What is shown of a plan between its nodes, in words.

use super::caveats::limit_words;
use super::number::{percent, significant};
use super::terminal::WIDTH;
use crate::certificate::between::{Between, COMMANDS, GRID, Shown, WRENCH};
use crate::model::{Limit, LimitKind, Mission};
use crate::planner::select::VIOLATED;

/// Proved for every instant, or checked on a grid; `found` is of the wrench, of each limit in the mission's order, and of what
/// lagging rotors are commanded.
pub fn between(mission: &Mission, found: &[Between]) -> String {
    let limits = std::iter::once(None).chain(mission.limits.iter().map(Some)).chain([None]);
    let named: Vec<(&Between, String)> =
        found.iter().zip(limits).map(|(b, limit)| (b, limit.map_or_else(|| wrench(b), |l| limited(b, l)))).collect();
    let heads = [
        (Shown::Proved, "Proved for every instant:".to_string()),
        (Shown::Checked, format!("Checked on a grid of {GRID} points an interval:")),
    ];
    let mut out = String::new();
    for (shown, head) in heads {
        let (wrench, limits): (Vec<_>, Vec<_>) =
            named.iter().filter(|(b, _)| b.shown == shown).partition(|(b, _)| b.rows == WRENCH || b.rows == COMMANDS);
        let limits: Vec<&str> = limits.iter().map(|(_, words)| words.as_str()).collect();
        let limits = match limits[..] {
            [] => None,
            [one] => Some(format!("the limit on {one}")),
            _ => Some(format!("the limits on {}", limits.join("; "))),
        };
        let told: Vec<String> = wrench.iter().map(|(_, words)| words.clone()).chain(limits).collect();
        if !told.is_empty() {
            let options = textwrap::Options::new(WIDTH).initial_indent("  ").subsequent_indent("  ");
            out.push_str(&format!("\n{}\n", textwrap::fill(&format!("{head} {}.", told.join("; ")), options)));
        }
    }
    out
}

fn wrench(b: &Between) -> String {
    let what = if b.rows == COMMANDS { "what the rotors are commanded" } else { "the wrench" };
    match b.excess > VIOLATED {
        true => format!("{what} passes a facet imposed by {} of its width", percent(b.excess)),
        false => format!("{what} keeps to every facet imposed"),
    }
}

fn limited(b: &Between, limit: &Limit) -> String {
    let (name, unit, factor) = limit_words(limit.kind);
    // Of tilt it is the acceleration's way out of the cone.
    let (excess, unit) = if limit.kind == LimitKind::Tilt { (b.excess, "g") } else { (b.excess * factor, unit) };
    match b.shown == Shown::Checked && b.excess > 0.0 {
        true => format!("{name}, passed by {} {unit}", significant(excess, 3)),
        false => name.to_string(),
    }
}
