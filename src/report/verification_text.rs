//! What an accepted certificate shows, for people.

use super::table::Table;
use super::terminal::WIDTH;
use crate::verify::plan::OF_A_GRID;
use crate::verify::{Reach, Scope, Verdict};

/// What is shown, then in what it is weaker than the spec asks.
pub fn verification(name: &str, verdict: &Verdict) -> String {
    let mut table = Table::new(&["shown", "where"]);
    for shown in &verdict.shown {
        table.row(vec![shown.statement.clone(), shown.reach.map_or("proved".into(), words)]);
    }
    // What its headline tells whole has no rows.
    let mut out = if verdict.shown.is_empty() { String::new() } else { table.render_left(0) + "\n" };
    let strength = match verdict.weaker.is_empty() {
        true => "accepted",
        false => "accepted, weaker than the spec asks",
    };
    out.push_str(&textwrap::fill(&format!("{name}: {strength}: {}", verdict.headline), WIDTH));
    out.push('\n');
    for why in &verdict.weaker {
        let options = textwrap::Options::new(WIDTH).initial_indent("  - ").subsequent_indent("    ");
        out.push_str(&textwrap::fill(why, options));
        out.push('\n');
    }
    out
}

fn words(reach: Reach) -> String {
    let shown: String = match reach.scope {
        Scope::Nodes => "at the nodes".into(),
        // With one of the nodes beside them.
        Scope::Grid => format!("on a grid of {} points an interval", OF_A_GRID + 1),
        Scope::EveryInstant => "proved for every instant".into(),
    };
    let Some(beyond) = reach.beyond else { return shown };
    let of = beyond.measure.whole.map_or(String::new(), |whole| format!(" {whole}"));
    let most = if beyond.throughout { "at most " } else { "" };
    format!("{shown}; exceeded between them by {most}{}{of}", beyond.measure.of(beyond.excess))
}
