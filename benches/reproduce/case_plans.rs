//! Tables 8 to 13: shortest times and errors, and the violations of the plans at one common time.

use super::judgement::{agrees_if, differs, listed, not_comparable};
use super::markdown::{fixed, none, paragraph, printed, table};
use super::paper_plans::{Common, Own, TABLE_8, TABLE_9, TABLE_10, TABLE_11, TABLE_12, TABLE_13, WAYPOINTS};
use super::plans::{self, Plans, name};
use mavc::motion::outside::Outside;
use mavc::planner::studies::{PlanOutcome, PlannerRun, Run};
use mavc::report::record::errors;

/// Both tables of a case.
pub fn section(number: usize) -> String {
    let plans = plans::of_case(number);
    match number {
        1 => own_times(8, plans, &TABLE_8) + &one_mode(9, plans, &TABLE_9),
        2 => own_times(10, plans, &TABLE_10) + &one_mode(11, plans, &TABLE_11),
        _ => own_times(12, plans, &TABLE_12) + &all_modes(plans),
    }
}

/// What the paper does not give for any row of digits.
const MISSING: &str = "curve, bounds and tolerance not given";

/// `15.55 s`
pub fn seconds(time: f64) -> String {
    format!("{} s", fixed(time, 2))
}

/// `16 s`
pub fn paper_seconds(time: f64) -> String {
    format!("{} s", printed(time))
}

/// Tables 8, 10 and 12: each planner at its own shortest time.
fn own_times(table_number: usize, plans: &Plans, paper: &[Own]) -> String {
    let rip = plans.shortest("RIP");
    let paper_rip = paper.iter().find(|p| p.planner == "RIP").expect("every table begins with RIP").time;
    let rows: Vec<Vec<String>> = plans
        .runs(Run::Own)
        .map(|run| {
            let planner = name(run);
            let printed_row = paper.iter().find(|p| p.planner == planner);
            let mut cells = vec![planner];
            cells.push(printed_row.map_or_else(none, |p| paper_seconds(p.time)));
            cells.push(time(run));
            cells.push(
                printed_row.map_or_else(none, |p| format!("{} ({})", printed(p.position[0]), printed(p.position[1]))),
            );
            let n = plans.mission.waypoints.len() as f64;
            let e = plans::solved(run).map(|s| errors(&plans.mission, s));
            let both = |sum: f64| format!("{} ({})", fixed(sum, 4), fixed(sum / n, 4));
            cells.push(e.map_or_else(none, |e| both(e.position)));
            cells.push(printed_row.map_or_else(none, |p| format!("{} ({})", printed(p.yaw[0]), printed(p.yaw[1]))));
            cells.push(e.map_or_else(none, |e| both(e.yaw)));
            cells.push(judged_time(run, rip, printed_row, paper_rip));
            cells
        })
        .collect();
    let header = [
        "planner",
        "T, paper",
        "T",
        "e_R (e_R/N) m, paper",
        "e_R (e_R/N) m",
        "e_psi (e_psi/N) rad, paper",
        "e_psi (e_psi/N) rad",
        "row",
    ];
    format!("### Table {table_number}: each planner at its own shortest time\n\n") + &table(&header, &rows)
}

fn time(run: &PlannerRun) -> String {
    match &run.outcome {
        PlanOutcome::Planned(s) => seconds(s.time),
        outcome => outcome.verdict().word().into(),
    }
}

/// Only the order relative to RIP can be compared within a row.
fn judged_time(run: &PlannerRun, rip: f64, paper: Option<&Own>, paper_rip: f64) -> String {
    let Some(paper) = paper else { return not_comparable("the paper has no such row") };
    let mut judged = match plans::solved(run) {
        _ if paper.planner == "RIP" => not_comparable(MISSING),
        Some(s) => {
            let order = agrees_if((paper.time > paper_rip) == (s.time > rip), "the order relative to RIP");
            match order.as_str() {
                "agrees" => format!("agrees: slower than RIP; digits not comparable ({MISSING})"),
                _ => order,
            }
        }
        None => differs("no plan here"),
    };
    for (what, [sum, mean]) in [("e_R/N", paper.position), ("e_psi/N", paper.yaw)] {
        let ratio = mean / (sum / WAYPOINTS as f64);
        if !(0.8..=1.25).contains(&ratio) {
            let sum = what.trim_end_matches("/N");
            judged += &format!("; the printed {what} is {} times {sum}/{WAYPOINTS}", rounded(ratio));
        }
    }
    judged
}

/// Two significant digits.
fn rounded(ratio: f64) -> String {
    mavc::number::significant(ratio, 2)
}

/// Tables 9 and 11: all planners at one time, against the case's only mode.
fn one_mode(table_number: usize, plans: &Plans, paper: &[Common]) -> String {
    let rows: Vec<Vec<String>> = plans.runs(Run::Common).map(|run| common_row(plans, run, paper)).collect();
    let mut header = vec!["planner", "T, paper", "T"];
    let with_errors = paper.iter().any(|p| p.errors.is_some());
    if with_errors {
        header.extend(["e_R m, paper", "e_R m", "e_psi rad, paper", "e_psi rad"]);
    } else {
        header.extend(["e_R m", "e_psi rad"]);
    }
    header.extend(["violated, paper", "facets", "positions", "pairs", "worst", "outside", "last", "row"]);
    let mode = &plans.comparison.modes[0];
    format!("### Table {table_number}: all planners at the common time, against {mode}\n\n") + &table(&header, &rows)
}

fn common_row(plans: &Plans, run: &PlannerRun, paper: &[Common]) -> Vec<String> {
    let planner = name(run);
    let printed_row = paper.iter().find(|p| p.planner == planner);
    let solved = plans::solved(run);
    let mut cells = vec![planner];
    cells.push(printed_row.map_or_else(none, |p| paper_seconds(p.time)));
    cells.push(time(run));
    let e = solved.map(|s| errors(&plans.mission, s));
    let ours = [e.map(|e| e.position), e.map(|e| e.yaw)];
    for (i, ours) in ours.into_iter().enumerate() {
        if paper.iter().any(|p| p.errors.is_some()) {
            cells.push(printed_row.and_then(|p| p.errors).map_or_else(none, |e| printed(e[i])));
        }
        cells.push(ours.map_or_else(none, |v| fixed(v, 4)));
    }
    cells.push(printed_row.map_or_else(none, |p| p.violated.to_string()));
    let out = solved.map(|s| &s.outside[0]);
    let of = |text: &dyn Fn(&Outside) -> String| out.map_or_else(none, text);
    cells.push(of(&|o| o.facets.len().to_string()));
    cells.push(of(&|o| o.positions.to_string()));
    cells.push(of(&|o| o.rows.to_string()));
    cells.push(of(&worst));
    cells.push(of(&|o| seconds(o.seconds)));
    cells.push(of(&last));
    cells.push(match (printed_row, out) {
        (Some(p), Some(o)) => judged_count(p.violated, o),
        (None, _) => not_comparable("the paper has no such row"),
        (_, None) => differs("no plan here"),
    });
    cells
}

/// The largest violation; nothing for a plan that stays inside.
fn worst(out: &Outside) -> String {
    if out.last.is_none() { none() } else { format!("{} %", fixed(100.0 * out.max_violation, 1)) }
}

fn last(out: &Outside) -> String {
    out.last.map_or_else(none, seconds)
}

/// Counts of hull inequalities and of facets differ, but zero means the same.
fn judged_count(paper: usize, out: &Outside) -> String {
    match (paper, out.rows) {
        (0, 0) => "agrees: none violated".into(),
        (0, _) => differs("violated here, see the statements below"),
        (_, 0) => differs("nothing violated here, see the statements below"),
        _ => format!("agrees: some violated; counts not comparable ({MISSING})"),
    }
}

/// Table 13: every planner against every mode. The paper prints one count per pair.
fn all_modes(plans: &Plans) -> String {
    let modes: Vec<&str> = plans.comparison.modes.iter().map(String::as_str).collect();
    let beside = matrix(plans, &["planner"], &modes, &["row"], |planner, outside| {
        let paper = TABLE_13.iter().find(|(p, _)| *p == planner).map(|(_, counts)| counts);
        let mut cells: Vec<String> = outside
            .iter()
            .enumerate()
            .map(|(i, o)| format!("{} / {}", paper.map_or_else(none, |p| p[i].to_string()), o.rows))
            .collect();
        cells.push(paper.map_or_else(|| not_comparable("the paper has no such row"), |p| zeros(p, outside, &modes)));
        cells
    });
    let plain = |of: &dyn Fn(&Outside) -> String| {
        matrix(plans, &["planner"], &modes, &[], |_, outside| outside.iter().map(of).collect())
    };
    [
        format!("### Table 13: all planners at {}, against every mode\n\n", seconds(plans.common_time())),
        paragraph(
            "Violated inequalities at 28 s in the paper / violated pairs here. A row differs if only one of the two \
             numbers is zero; see also the statements below.",
        ),
        beside,
        "Violated facets, and the number of positions with a violation.\n\n".into(),
        plain(&|o| if o.last.is_none() { none() } else { format!("{} at {}", o.facets.len(), o.positions) }),
        "Largest violation.\n\n".into(),
        plain(&worst),
        "Time outside (last violation).\n\n".into(),
        plain(&|o| if o.last.is_none() { none() } else { format!("{} ({})", seconds(o.seconds), last(o)) }),
    ]
    .concat()
}

/// One line per planner with a plan at the common time.
fn matrix(
    plans: &Plans,
    before: &[&str],
    modes: &[&str],
    after: &[&str],
    cells: impl Fn(&str, &[Outside]) -> Vec<String>,
) -> String {
    let header: Vec<&str> = before.iter().chain(modes).chain(after).copied().collect();
    let rows: Vec<Vec<String>> = plans
        .runs(Run::Common)
        .filter_map(|run| {
            let mut line = vec![name(run)];
            line.extend(cells(&line[0], &plans::solved(run)?.outside));
            Some(line)
        })
        .collect();
    table(&header, &rows)
}

/// Which zeros of the paper are zeros here, and the reverse.
fn zeros(paper: &[usize; 8], outside: &[Outside], modes: &[&str]) -> String {
    let where_ = |wanted: &dyn Fn(usize, usize) -> bool| -> Vec<String> {
        let places = paper.iter().zip(outside).zip(modes);
        places.filter(|((p, o), _)| wanted(**p, o.rows)).map(|(_, m)| m.to_string()).collect()
    };
    let violated_here = where_(&|p, o| p == 0 && o > 0);
    let violated_there = where_(&|p, o| p > 0 && o == 0);
    let both = where_(&|p, o| p == 0 && o == 0);
    let mut reasons = Vec::new();
    if !violated_here.is_empty() {
        reasons.push(format!("{} violated here only", listed(&violated_here)));
    }
    if !violated_there.is_empty() {
        reasons.push(format!("{} violated in the paper only", listed(&violated_there)));
    }
    if !both.is_empty() {
        reasons.push(format!("no violation in either: {}", listed(&both)));
    }
    let text = reasons.join("; ");
    match violated_here.is_empty() && violated_there.is_empty() {
        true => format!("agrees: {text}; counts not comparable"),
        false => differs(&text),
    }
}
