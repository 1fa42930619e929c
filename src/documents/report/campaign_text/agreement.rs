//! Whether the plans predict which flights are lost.

use crate::campaign::agreement::{Agreement, Scope};
use crate::campaign::statistics::{Contingency, Strength};
use crate::number::{fixed, part_of_all, plural};
use crate::text_table::{Table, indented};

pub(super) fn agreement(agreement: &Agreement) -> String {
    let mut out = String::from("\nDo the plans predict which flights are lost?\n");
    out.push_str(&indented(
        "Predicted lost: the fault strikes before the plan's last violation of the mode's set, or of its core where \
         yaw is given up. Only flights that were still flying when the fault struck are counted. A plan that several \
         planners share is counted once. phi: the correlation of prediction and outcome, from -1 to 1.",
    ));
    let Agreement { all, inside } = agreement;
    if inside.modes == all.modes {
        out.push_str(&scope(all));
    } else if inside.modes == 0 {
        out.push_str(&scope(all));
        out.push_str(&indented(
            "No mode has hover inside its set or core, so no plan can keep a reserve against any mode.",
        ));
    } else {
        out.push_str(&format!("\n  All {}\n{}", plural(all.modes, "mode"), scope(all)));
        let n = plural(inside.modes, "mode");
        out.push_str(&format!(
            "\n  Only the {n} with hover inside their sets or cores: no plan can keep a reserve against the others\n"
        ));
        out.push_str(&scope(inside));
    }
    out.push('\n');
    out.push_str(&indented(
        "Intervals treat flights as independent. Flights struck at the same instant differ only in their noise, so \
         the true uncertainty is larger; more instants help more than more seeds.",
    ));
    out
}

/// The contingency table and its interpretation.
fn scope(scope: &Scope) -> String {
    let headings =
        ["planner", "hits", "misses", "false alarms", "correct negatives", "lost", "lost if predicted", "phi"];
    let mut table = Table::new(&headings);
    let mut row = |name: String, t: &Contingency| {
        let share =
            |a: usize, b: usize| if b == 0 { "-".into() } else { format!("{} %", part_of_all(a as f64 / b as f64)) };
        let mut cells = vec![name];
        cells.extend([t.hits, t.misses, t.false_alarms, t.correct_negatives].map(|n| n.to_string()));
        cells.push(share(t.hits + t.misses, t.total()));
        cells.push(share(t.hits, t.hits + t.false_alarms));
        cells.push(t.phi().map_or("undefined".into(), |phi| fixed(phi, 2)));
        table.row(cells);
    };
    scope.planners.iter().for_each(|(planner, t)| row(planner.name().to_uppercase(), t));
    row("all".into(), &scope.total);
    let safe = scope.planners.iter().filter(|(_, t)| t.hits + t.false_alarms == 0 && t.misses > 0);
    let called_safe: String = safe
        .map(|(planner, t)| {
            let (name, all) = (planner.name().to_uppercase(), plural(t.total(), "struck flight"));
            indented(&format!("{name} predicts no loss, yet {} of {all} were lost.", t.misses))
        })
        .collect();
    table.render(2) + &indented(&by_flight(&scope.total)) + &called_safe
}

/// The interpretation of phi.
pub fn by_flight(t: &Contingency) -> String {
    let lost = t.hits + t.misses;
    match (Strength::of(t.phi()), t.phi()) {
        (Strength::Undefined, _) if t.total() == 0 => {
            "No flight with a known outcome was struck by its fault: the prediction of losses cannot be judged.".into()
        }
        (Strength::Undefined, _) if lost == 0 => {
            "No flight was lost to a fault: the prediction of losses cannot be judged.".into()
        }
        (Strength::Undefined, _) if lost == t.total() => {
            "Every struck flight was lost: the prediction of losses cannot be judged.".into()
        }
        (strength, phi) => {
            let phi = phi.map_or(String::new(), |phi| format!(" (correlation {})", fixed(phi, 2)));
            let what = match strength {
                Strength::Undefined => {
                    "is the same for every flight, so it carries no information: no better than chance"
                }
                Strength::Opposite => "is worse than chance: flights predicted safe are lost more often",
                Strength::Chance => "is no better than chance",
                Strength::Weak => "agrees weakly with the outcomes",
                Strength::Moderate => "agrees moderately with the outcomes",
                Strength::Strong => "agrees strongly with the outcomes",
            };
            format!("Flight by flight, the prediction by the plan's sets {what}{phi}.")
        }
    }
}
