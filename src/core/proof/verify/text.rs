//! Terminal text: what an accepted certificate shows.

use super::plan::POINTS_OF_A_GRID;
use super::{Accepted, Reach, Scope};
use crate::text_table::{Table, filled, lines};

/// The output of `mavc verify` for an accepted certificate `name`: what is shown, then where it is weaker than the spec
/// requires.
pub fn verification(name: &str, verdict: &Accepted) -> String {
    let mut table = Table::new(&["shown", "where"]);
    for shown in &verdict.shown {
        table.row(vec![shown.statement.clone(), shown.reach.map_or("proved".into(), words)]);
    }
    // A certificate whose headline says everything has no rows.
    let mut out = if verdict.shown.is_empty() { String::new() } else { table.render_left(0) + "\n" };
    let strength = match verdict.weaker.is_empty() {
        true => "accepted",
        false => "accepted, weaker than the spec requires",
    };
    out.push_str(&filled(&format!("{name}: {strength}: {}", verdict.headline)));
    for why in &verdict.weaker {
        out.push_str(&lines(why, "  - ", "    ").join("\n"));
        out.push('\n');
    }
    out
}

fn words(reach: Reach) -> String {
    let shown: String = match reach.scope {
        Scope::Nodes => "at the nodes".into(),
        // The points between the nodes and one of the nodes.
        Scope::Grid => format!("on a grid of {} points per interval", POINTS_OF_A_GRID + 1),
        Scope::EveryInstant => "proved at every instant".into(),
    };
    let Some(beyond) = reach.beyond else { return shown };
    let of = beyond.measure.whole.map_or(String::new(), |whole| format!(" {whole}"));
    let most = if beyond.throughout { "at most " } else { "" };
    format!("{shown}; exceeded between them by {most}{}{of}", beyond.measure.at_most(beyond.violation))
}
