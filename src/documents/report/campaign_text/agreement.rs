//! Whether the plans, and what is known of the modes, predict which flights are lost and what the path suffers.

use crate::campaign::agreement::{Agreement, Scope};
use crate::campaign::correlations::Correlation;
use crate::campaign::predictors::{ClassCount, Forecast};
use crate::campaign::statistics::{Contingency, FEWEST, Strength};
use crate::number::{fixed, part_of_all, plural};
use crate::text_table::{Table, indented};

pub(super) fn agreement(agreement: &Agreement) -> String {
    let mut out = String::from("\nDo the plans predict which flights are lost?\n");
    out.push_str(&indented(
        "Predicted lost: the fault strikes before the plan's last violation of the mode's set, or of its core where \
         yaw is given up. Only flights that were still flying when the fault struck are counted. A plan that several \
         planners share is counted once.",
    ));
    let Agreement { all, inside, forecasts } = agreement;
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
    out.push_str(&predictors(forecasts));
    out.push_str(&harm(&all.harm, &inside.harm));
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
    table.render(2) + &indented(&by_flight(&scope.total)) + &called_safe + &indented(&by_mode(scope))
}

/// The interpretation of phi.
pub fn by_flight(t: &Contingency) -> String {
    let lost = t.hits + t.misses;
    match (Strength::of(t.phi()), t.phi()) {
        (Strength::Undefined, _) if t.total() == 0 => {
            "No flight with a known outcome was struck by its fault: the prediction cannot be judged.".into()
        }
        (Strength::Undefined, _) if lost == 0 => {
            "No flight was lost to a fault: the prediction cannot be judged.".into()
        }
        (Strength::Undefined, _) if lost == t.total() => {
            "Every struck flight was lost: the prediction cannot be judged.".into()
        }
        (strength, phi) => {
            let phi = phi.map_or(String::new(), |phi| format!(" (phi {})", fixed(phi, 2)));
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
            format!("Flight by flight, the prediction {what}{phi}.")
        }
    }
}

/// The interpretation of the rank correlation.
fn by_mode(scope: &Scope) -> String {
    let rho = scope.rank_correlation;
    let what = match Strength::of(rho) {
        Strength::Undefined => {
            return "Violation durations cannot be ranked against losses: one of the two never varies.".into();
        }
        Strength::Opposite => "longer violations go with fewer losses",
        Strength::Chance => "the duration of violations predicts losses no better than chance",
        Strength::Weak => "longer violations correlate weakly with more losses",
        Strength::Moderate => "longer violations correlate moderately with more losses",
        Strength::Strong => "longer violations correlate strongly with more losses",
    };
    let rho = rho.map_or(String::new(), |rho| fixed(rho, 2));
    format!("Over {} of plan and mode, {what} (Spearman's rank correlation {rho}).", plural(scope.pairs, "pair"))
}

/// Every predictor against the flights, and the shares lost in its classes.
fn predictors(forecasts: &[Forecast]) -> String {
    if forecasts.is_empty() {
        return String::new();
    }
    let mut out = String::from("\n  Predicted lost against lost, for everything that predicts, over all modes\n");
    let share =
        |a: usize, b: usize| if b == 0 { "-".into() } else { format!("{} %", part_of_all(a as f64 / b as f64)) };
    let score = |score: Option<f64>| score.map_or("-".into(), |score| fixed(score, 3));
    let mut table = Table::new(&[
        "predictor",
        "hits",
        "misses",
        "false alarms",
        "correct negatives",
        "phi",
        "Brier",
        "by class",
        "base rate",
    ]);
    for forecast in forecasts {
        let t = &forecast.counts;
        let mut cells = vec![forecast.predictor.words().to_string()];
        cells.extend([t.hits, t.misses, t.false_alarms, t.correct_negatives].map(|n| n.to_string()));
        cells.push(t.phi().map_or("undefined".into(), |phi| fixed(phi, 2)));
        cells.extend([forecast.brier, forecast.brier_by_class, forecast.brier_base].map(score));
        table.row(cells);
    }
    out.push_str(&table.render(2));
    out.push_str(&indented(
        "Brier: mean squared error of the predicted probability of loss, 0 is best. First the prediction as 0 or 1; by \
         class: the share lost in the same class with the other modes; base rate: the share lost with the other modes, \
         which a predictor has to beat.",
    ));
    for Forecast { predictor, classes, .. } in forecasts {
        let class = |c: &ClassCount| {
            let predicted = if c.predicted_lost { "lost" } else { "safe" };
            format!("{} ({predicted}): {} of {} lost, {}", c.class, c.lost, c.struck, share(c.lost, c.struck))
        };
        let classes: Vec<String> = classes.iter().map(class).collect();
        out.push_str(&indented(&format!("{}: {}.", predictor.words(), classes.join("; "))));
    }
    out
}

/// Whether worse plans do more harm, over all modes and over those with hover inside their sets or cores.
fn harm(all: &[Correlation], inside: &[Correlation]) -> String {
    let mut out = String::from(
        "\n  Do worse plans do more harm? Spearman's rank correlation over pairs of plan and mode (95 % interval)\n",
    );
    let value = |r: Option<f64>| r.map_or("-".into(), |r| fixed(r, 2));
    let over = |c: &Correlation| match c.interval {
        Some(i) => format!("{} ({} .. {})", value(c.rank_correlation), fixed(i.low, 2), fixed(i.high, 2)),
        None => value(c.rank_correlation),
    };
    let mut table = Table::new(&["quality", "harm", "all modes", "hover inside", "within modes", "modes"]);
    for (a, i) in all.iter().zip(inside) {
        let (quality, harm) = (a.quality.words().to_string(), a.harm.words().to_string());
        table.row(vec![quality, harm, over(a), over(i), value(i.within_modes), i.modes.to_string()]);
    }
    out.push_str(&table.render(2));
    out.push_str(&indented(&format!(
        "Each pair has the mean over its struck flights, lost ones included. Within modes: over ranks within each mode \
         with hover inside its set or core, so that plans are compared and not modes; modes: those in which both vary. \
         Pairs are not independent, since plans and modes resemble each other, and fewer than {FEWEST} pairs have no \
         interval: a small correlation of few pairs means nothing."
    )));
    out
}
