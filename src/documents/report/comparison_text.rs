//! Terminal output of `mavc compare`.

mod fold;

use super::record::{errors, rates};
use super::recoverable::{self, RecoverableRecord};
use super::terminal::{head, holds, in_planes};
use super::{least_time, without_yaw};
use crate::admissible::row::VIOLATED;
use crate::model::{AfterFault, Mission, MissionTime, Model, PlannerKind, Problem};
use crate::motion::outside::Outside;
use crate::motion::risk::rated_risk;
use crate::motion::time_grid::determined;
use crate::number::{fixed, number, significant};
use crate::planner::studies::{Comparison, MissionPlan, PlanOutcome, PlannerRun, Proof, Run, label};
use crate::planner::timing::kinematics::least_time_within;
use crate::text_table::{Table, filled, indented};
use crate::verdict::Verdict;
use fold::{Fold, folded};

/// An objective counts as lower than another if it is lower by more than this share.
const CHEAPER: f64 = 1e-3;

/// The most modes that a cell of a table names.
const NAMED: usize = 4;

/// The tables of the paper's section 5.4, for any spec, and the plan with ways out after faults, if the spec requires
/// them.
pub fn compare(problem: Problem, comparison: &Comparison, recoverable: Option<&RecoverableRecord>) -> String {
    let (model, mission) = (problem.model(), problem.mission());
    let mut out = head(problem, comparison, None);
    out.push_str(match determined(mission) {
        Some(_) => "\nEach planner alone, at the only time that the mission's fixed times allow\n",
        None => "\nEach planner alone, at the shortest time found for it\n",
    });
    out.push_str(&run_table(mission, comparison, Run::Own).render(2));
    out.push_str(&notes(comparison, Run::Own));
    out.push_str(&own_note(problem, comparison));
    out.push_str(&match comparison.common_time {
        Some(t) => {
            format!("\nAll planners at the common time T_d = {} s, {}\n", number(t), common_time(problem, comparison))
        }
        None if comparison.modes.is_empty() => "\nWithout fault modes there is no common time T_d.\n".into(),
        None => "\nNo plan was found for any mode, so there is no common time T_d.\n".into(),
    });
    if comparison.runs.iter().any(|run| run.run == Run::Common) {
        out.push_str(&run_table(mission, comparison, Run::Common).render(2));
        out.push_str(&notes(comparison, Run::Common));
        out.push_str(&local_optima(comparison));
    }
    if !comparison.modes.is_empty() {
        let holds = holds(model);
        let own =
            if determined(mission).is_some() { "each planner alone" } else { "each planner at its shortest time" };
        let has_plans = |which: Run| {
            comparison.runs.iter().any(|run| run.run == which && matches!(run.outcome, PlanOutcome::Planned(_)))
        };
        for (run, title) in [(Run::Own, own), (Run::Common, "all planners at T_d")] {
            if !has_plans(run) {
                continue;
            }
            let held = if holds { "; with `hold` also the last instant without a stop" } else { "" };
            let by = match without_yaw::measured_by(comparison) {
                "admissible set" => "set",
                other => other,
            };
            let text = format!("Seconds outside each mode's {by} (last violation{held}): {title}");
            out.push_str(&format!("\n{}", filled(&text)));
            out.push_str(&outside_table(model, comparison, run).render(2));
        }
        if has_plans(Run::Own) || has_plans(Run::Common) {
            out.push_str(risk_note(model, comparison));
        }
    }
    out.push_str(&recoverable::text(recoverable));
    out.push_str(&guarded(comparison));
    out.push_str(&words(problem, comparison));
    out
}

/// The meaning of the verdicts in the tables, if some planner has no plan.
fn words(problem: Problem, comparison: &Comparison) -> String {
    let mission = problem.mission();
    let has = |verdict: Verdict| comparison.runs.iter().any(|run| run.outcome.verdict() == verdict);
    let least = least_time_within(problem);
    // The last waypoint's time is that of the mission.
    let is_of_all = least.too_early.is_some_and(|(waypoint, _)| waypoint + 1 < mission.waypoints.len());
    let at_any_time = is_of_all.then(|| {
        format!("no plan exists at any mission time, because {}.", least_time::sentence(mission, &least, 0.0))
    });
    let proved = at_any_time
        .unwrap_or("no plan exists at any of the times that `--report` lists; each was proved separately.".into());
    let meanings = [
        (Verdict::ProvedInfeasible, proved.as_str()),
        (Verdict::NotFound, "no plan was found; one may exist."),
        (Verdict::NotAttempted, "no plan was searched for, because no RIP plan was found to select facets from."),
    ];
    let present = meanings.into_iter().filter(|(verdict, _)| has(*verdict));
    let lines: String = present.map(|(verdict, meaning)| format!("  {verdict}: {meaning}\n")).collect();
    if lines.is_empty() { lines } else { format!("\n{lines}") }
}

/// The planner's run at T_d; there is one if there is a T_d.
fn at_common(comparison: &Comparison, planner: PlannerKind) -> Option<&PlannerRun> {
    comparison.runs.iter().find(|run| run.planner == planner && run.run == Run::Common)
}

/// Whether facets were selected at all: RIP's plan at T_d selects them.
fn selects(comparison: &Comparison) -> bool {
    let rip = at_common(comparison, PlannerKind::Rip);
    !comparison.modes.is_empty() && rip.is_none_or(|run| matches!(run.outcome, PlanOutcome::Planned(_)))
}

/// How many facets RSP guards, and why it has no plan at T_d if it has none.
fn guarded(comparison: &Comparison) -> String {
    let n = comparison.selected.len();
    match (selects(comparison), comparison.common_time.map(number)) {
        _ if comparison.modes.is_empty() || comparison.common_time.is_none() => String::new(),
        (false, Some(at)) => {
            format!("\nNo RIP plan was found at T_d = {at} s to select facets from, so RSP selects none.\n")
        }
        _ => {
            let plural = if n == 1 { "" } else { "s" };
            let planes = in_planes(comparison);
            let mut text =
                format!("\nRSP guards {n} facet{plural} of the fault sets{planes} in addition to the healthy set's.\n");
            if let Some(PlanOutcome::Infeasible(Proof { at, .. })) =
                at_common(comparison, PlannerKind::Rsp).map(|run| &run.outcome)
            {
                let at = number(*at);
                text += &format!("RSP is proved infeasible at {at} s; the first table has its own shortest time.\n");
            }
            text
        }
    }
}

/// The meaning of the risk column: one line if all risks are zero; empty if no mode has a rate.
fn risk_note(model: &Model, comparison: &Comparison) -> &'static str {
    let rates = rates(model);
    let risks = comparison.runs.iter().filter_map(|run| match &run.outcome {
        PlanOutcome::Planned(solved) => rated_risk(&rates, &solved.committed),
        _ => None,
    });
    match (rates.iter().any(Option::is_some), holds(model)) {
        (false, _) => "",
        (true, _) if risks.fold(0.0, f64::max) == 0.0 => {
            "  risk 0: these plans are never committed to a mode that is planned against and has a rate.\n"
        }
        (true, false) => {
            "  risk: the probability that some mode with a rate strikes before its last violation, if the mission \
             continues; modes are treated as independent.\n"
        }
        (true, true) => {
            "  risk: the probability that some mode with a rate strikes before its last violation or, if the mission \
             holds, before the last node from which no stop was found; modes are treated as independent.\n"
        }
    }
}

/// The notes under the first table: the lower bound, why its times differ from the spec's, and which facets RSP uses.
fn own_note(problem: Problem, comparison: &Comparison) -> String {
    let (model, mission) = (problem.model(), problem.mission());
    let rip = comparison.runs.iter().find(|run| run.planner == PlannerKind::Rip && run.run == Run::Own);
    let gap = rip.filter(|_| determined(mission).is_none()).and_then(|rip| least_time::gap(problem, rip));
    let bound = gap.map(|gap| format!("For RIP, {gap}."));
    let at = comparison.common_time.map(number);
    let is_beside = matches!(model.plan.time, MissionTime::Fixed(_)) && determined(mission).is_none();
    let beside = at
        .as_ref()
        .filter(|_| is_beside)
        .map(|at| format!("The spec requires {at} s; these times were searched for in addition, for comparison."));
    let selected = at.as_ref().filter(|_| selects(comparison)).map(|at| match comparison.own_selected_by {
        Some(_) => "RSP's shortest time is for the facets selected at RCP's shortest time.".to_string(),
        None => format!("RSP uses the facets selected at T_d = {at} s, also at its own time."),
    });
    let text: Vec<String> = bound.into_iter().chain(beside).chain(selected).collect();
    if text.is_empty() {
        return String::new();
    }
    indented(&text.join(" "))
}

/// The plan at T_d whose cost exceeds that of a more constrained plan by the largest factor. Searches are local, so
/// that this can happen.
fn local_optima(comparison: &Comparison) -> String {
    let all = comparison.modes.len();
    let solved: Vec<(&PlannerRun, f64)> = comparison
        .runs
        .iter()
        .filter(|run| run.run == Run::Common)
        .filter_map(|run| Some((run, run.outcome.plan()?.least_objective)))
        .collect();
    let is_joint = |run: &PlannerRun| run.planner == PlannerKind::Rcp && run.against.len() == all;
    let lies_inside = |inner: &PlannerRun, outer: &PlannerRun| match outer.planner {
        PlannerKind::Rip => inner.planner != PlannerKind::Rip,
        PlannerKind::Rsp => is_joint(inner),
        PlannerKind::Rcp => is_joint(inner) && !is_joint(outer),
    };
    let pairs = solved.iter().flat_map(|outer| solved.iter().map(move |inner| (outer, inner)));
    let dearer =
        pairs.filter(|((outer, dear), (inner, cheap))| lies_inside(inner, outer) && *cheap < (1.0 - CHEAPER) * dear);
    let ratio = |((_, dear), (_, cheap)): &(&(&PlannerRun, f64), &(&PlannerRun, f64))| dear / cheap;
    let Some(((outer, dear), (inner, cheap))) = dearer.max_by(|a, b| ratio(a).total_cmp(&ratio(b))) else {
        return String::new();
    };
    let text = format!(
        "At T_d, {} ({}) costs more than {} ({}), although its set admits that plan too. Each plan is the cheapest \
         that its own search found; none is proved to be the cheapest.",
        name_of(outer),
        number(*dear),
        name_of(inner),
        number(*cheap)
    );
    indented(&text)
}

/// The origin of T_d.
fn common_time(problem: Problem, comparison: &Comparison) -> &'static str {
    let (model, mission) = (problem.model(), problem.mission());
    let jointly = |run: &&PlannerRun| run.planner == PlannerKind::Rcp && run.against.len() == comparison.modes.len();
    let joint = comparison.runs.iter().filter(|run| run.run == Run::Own).find(jointly);
    match (model.plan.time, joint.map(|run| &run.outcome)) {
        _ if determined(mission).is_some() => "the time that the mission's fixed times give",
        (MissionTime::Fixed(_), _) => "the time that the spec requires",
        (_, Some(PlanOutcome::Planned(_))) if comparison.modes.len() == 1 => "RCP's shortest time",
        (_, Some(PlanOutcome::Planned(_))) => "the shortest time of RCP against all modes jointly",
        _ => "the largest of RCP's shortest times against single modes",
    }
}

/// `RIP`, `RCP M1`, `RCP jointly`, `RSP`.
pub fn name_of(run: &PlannerRun) -> String {
    match (run.planner, run.against.len()) {
        (PlannerKind::Rcp, k) if k > 1 => "RCP jointly".to_string(),
        _ => label(run.planner, &run.against),
    }
}

/// Below a table: the names that do not fit into its first column.
fn notes(comparison: &Comparison, which: Run) -> String {
    folded(comparison, which).iter().map(Fold::note).collect()
}

fn run_table(mission: &Mission, comparison: &Comparison, which: Run) -> Table {
    let mut table = Table::new(&[
        "planner",
        "T [s]",
        "e_R [m]",
        "e_R/N [m]",
        "e_psi [rad]",
        "largest [cm]",
        "objective",
        "rows/node",
        "leaves the sets of",
    ]);
    let n = mission.waypoints.len() as f64;
    for fold in folded(comparison, which) {
        let name = fold.short_name();
        match fold.outcome() {
            PlanOutcome::Planned(s) => {
                let e = errors(mission, s);
                table.row(vec![
                    name,
                    number(s.time),
                    significant(e.position, 4),
                    significant(e.position / n, 3),
                    significant(e.yaw, 3),
                    significant(100.0 * e.largest, 3),
                    number(s.least_objective),
                    fold.rows(),
                    leaves(comparison, s),
                ]);
            }
            outcome => table.row(vec![name, outcome.verdict().word().into()]),
        }
    }
    table
}

/// The modes whose sets a plan leaves: `M2, M3`. A shorter time means little beside that of a plan that stays in them.
fn leaves(comparison: &Comparison, solved: &MissionPlan) -> String {
    let is_left = |(_, outside): &(&String, &Outside)| outside.max_violation > VIOLATED;
    let left: Vec<&str> =
        comparison.modes.iter().zip(&solved.outside).filter(is_left).map(|(name, _)| name.as_str()).collect();
    match left.len() {
        0 => "-".into(),
        n if n == comparison.modes.len() && n > 1 => format!("all {n} modes"),
        n if n > NAMED => format!("{} and {} more", left[..NAMED].join(", "), n - NAMED),
        _ => left.join(", "),
    }
}

fn outside_table(model: &Model, comparison: &Comparison, which: Run) -> Table {
    let mut headings = vec!["planner"];
    headings.extend(comparison.modes.iter().map(String::as_str));
    let rates = rates(model);
    if rates.iter().any(Option::is_some) {
        headings.push("risk");
    }
    let mut table = Table::new(&headings);
    for fold in folded(comparison, which) {
        let PlanOutcome::Planned(s) = fold.outcome() else { continue };
        let mut cells = vec![fold.short_name()];
        let modes = s.outside.iter().zip(&s.committed).zip(&model.plan.against);
        cells.extend(modes.map(|((o, committed), &mode)| match (o.last, model.after_fault(mode)) {
            (None, _) if *committed == 0.0 => "0".to_string(),
            (last, AfterFault::Hold) => {
                let last = fixed(last.unwrap_or(0.0), 2);
                format!("{} ({last}; {})", fixed(o.seconds, 2), fixed(*committed, 2))
            }
            (last, _) => format!("{} ({})", fixed(o.seconds, 2), fixed(last.unwrap_or(0.0), 2)),
        }));
        cells.extend(rated_risk(&rates, &s.committed).map(|r| significant(r, 3)));
        table.row(cells);
    }
    table
}
