//! Terminal output of `mavc plan`, and what other reports share with it.

use super::battery;
use super::binding;
use super::caveats::caveats;
use super::plan_screen::spare;
use super::record::{errors, rates, violated_facets};
use super::verdict_text::{self, statement};
use super::waypoints;
use super::without_yaw;
use super::{headings, shape, volumes};
use crate::admissible::AdmissibleSet;
use crate::admissible::airspeed::{Airspeed, LimitedBy, PLAUSIBLE};
use crate::admissible::row::VIOLATED;
use crate::admissible::without_yaw::planned::Provision;
use crate::explain::detour::Detour;
use crate::flight::capture::heights::CaptureHeights;
use crate::flight::indistinguishable::listed;
use crate::model::{AfterFault, Model, PlanModel, PlannerKind, Problem};
use crate::motion::outside::Outside;
use crate::motion::risk::rated_risk;
use crate::number::{down, fixed, number, part_of_all, percent, short_seconds, significant, tenths};
use crate::planner::selection::PlanningSet;
use crate::planner::studies::protect::Protection;
use crate::planner::studies::{Comparison, MissionPlan, PlanOutcome, PlannerRun, label};
use crate::text_table::{Table, filled, hanging, indented};

/// `octo (PPNNPPNN, 8 rotors, 1.8 kg)`
pub fn vehicle_line(model: &Model) -> String {
    let v = &model.vehicle;
    let layout = v.layout.as_ref().map_or(String::new(), |l| format!("{l}, "));
    let motors = v.other_motors().map_or(String::new(), |motors| {
        let numbers: Vec<String> = motors.iter().map(u32::to_string).collect();
        format!("; rotors 1 to {} are motors {}", motors.len(), numbers.join(", "))
    });
    format!("{} ({layout}{} rotors, {} kg{motors})", v.name, v.rotors.len(), number(v.mass))
}

/// `23.1 m/s`, rounded down, with the limit on tilt if that is the reason; `none` if the mode cannot hover.
pub(super) fn airspeed(airspeed: &Airspeed) -> String {
    let tilt = if airspeed.limited_by == Some(LimitedBy::Tilt) { " (tilt)" } else { "" };
    let yaw = if airspeed.without_yaw { " (no yaw)" } else { "" };
    airspeed.largest_m_per_s.map_or("none".into(), |speed| match speed > PLAUSIBLE {
        true => format!("over {} m/s{yaw}", number(PLAUSIBLE)),
        false => format!("{} m/s{tilt}{yaw}", down(speed, 4)),
    })
}

/// The head of a report: mission, vehicle, fault modes and model.
pub(super) fn head(problem: Problem, comparison: &Comparison, heights: Option<&CaptureHeights>) -> String {
    let (model, mission) = (problem.model(), problem.mission());
    let against = match comparison.modes.as_slice() {
        [] => "no fault modes".to_string(),
        modes => format!("fault modes {}", modes.join(", ")),
    };
    let mut out = format!(
        "Mission {} with {}\nagainst {against}; {} model; reserve {} % of each set; {} samples\n",
        mission.name,
        vehicle_line(model),
        model.plan.model.name(),
        part_of_all(model.plan.reserve),
        model.plan.samples
    );
    if model.vehicle.is_uncertain() {
        out.push_str("The sets are valid for every value in the spec's intervals\n");
    }
    if let Some(tau) = model.thrust_lag() {
        let milliseconds = significant(1e3 * tau, 3);
        out.push_str(&format!("Rotors lag: thrusts follow their commands with a time constant of {milliseconds} ms\n"));
    }
    for sentence in without_yaw::head(comparison, heights) {
        out.push_str(&filled(&sentence));
    }
    out.push_str(&battery::full_thrust(model));
    if model.environment().has_drag() {
        out.push_str(&airspeeds(model));
    }
    if model.plan.model == PlanModel::Hover && !mission.has_one_yaw() {
        out.push_str(
            "Yaw changes: it was planned first, separately; any proof of infeasibility is for that yaw alone\n",
        );
    }
    out
}

/// The largest steady airspeed of the healthy vehicle and of each mode planned against.
fn airspeeds(model: &Model) -> String {
    let modes = model.plan.against.iter().map(|&mode| AdmissibleSet::of_mode(model, mode));
    let sets = std::iter::once(AdmissibleSet::healthy(model)).chain(modes);
    let each = sets.filter_map(|set| Some(format!("{} {}", set.name, airspeed(&Airspeed::of(model, &set)?))));
    let heading = if model.environment().is_isotropic() { "" } else { " in the worst heading" };
    let text = format!(
        "Largest steady airspeed in level flight{heading} with the reserve: {}",
        each.collect::<Vec<_>>().join(", ")
    );
    hanging(&text)
}

/// `, in 5 planes`: the number of planes imposed, if some of the facets that RSP guards lie in the same plane.
pub(crate) fn in_planes(comparison: &Comparison) -> String {
    let planes = PlanningSet::default().with(comparison.selected.clone()).rows.len();
    if planes == comparison.selected.len() { String::new() } else { format!(", in {planes} planes") }
}

/// The output of `mavc plan`; the trajectory written is that of the last run.
pub fn plan(problem: Problem, comparison: &Comparison) -> String {
    plan_with(problem, comparison, None)
}

/// The output of `mavc plan` with the heights that faults cost, if they were simulated.
pub fn plan_with(problem: Problem, comparison: &Comparison, heights: Option<&CaptureHeights>) -> String {
    let model = problem.model();
    let mut out = head(problem, comparison, heights);
    let solved = matches!(comparison.runs.last().map(|r| &r.outcome), Some(PlanOutcome::Planned(_)));
    if let Some(time) = comparison
        .common_time
        .filter(|_| solved && model.plan.planner == PlannerKind::Rsp && model.plan.require_risk.is_none())
    {
        let planes = in_planes(comparison);
        out.push_str(&match comparison.selected.len() {
            0 if model.plan.rounds == 0 => "RSP guards nothing beyond RIP: `rounds = 0` selects no facet\n".into(),
            0 if comparison.modes.is_empty() => {
                "RSP guards nothing beyond RIP: no fault mode is planned against\n".into()
            }
            0 => match without_yaw::without_rows(comparison).len() {
                n if n == comparison.modes.len() => {
                    "RSP guards nothing beyond RIP: no mode planned against has rows\n".into()
                }
                n => format!(
                    "RSP guards nothing beyond RIP: the RIP plan at {} s {} the sets of all modes {}\n",
                    number(time),
                    if model.plan.model == PlanModel::Hover { "has every node inside" } else { "stays inside" },
                    if n == 0 { "planned against" } else { "with rows" }
                ),
            },
            1 => format!("RSP guards 1 facet of the fault sets: the one the RIP plan at {} s violates\n", number(time)),
            n if model.plan.rounds > 1 => format!(
                "RSP guards {n} facets of the fault sets{planes}: those violated at {} s by the RIP plan or a plan of \
                 up to {} further rounds\n",
                number(time),
                model.plan.rounds - 1
            ),
            n => format!(
                "RSP guards {n} facets of the fault sets{planes}: those the RIP plan at {} s violates\n",
                number(time)
            ),
        });
    }
    // Without a first plan there is no trade-off.
    if let Some(bound) = model.plan.require_risk.filter(|_| !comparison.trade_off.is_empty()) {
        out.push_str(&trade_off(comparison, bound));
    }
    for run in &comparison.runs {
        out.push('\n');
        match &run.outcome {
            PlanOutcome::Planned(solved) => out.push_str(&solved_run(problem, comparison, run, solved)),
            _ => {
                let of_proof = match &run.outcome {
                    PlanOutcome::Infeasible(proof) if !run.against.is_empty() => {
                        without_yaw::of_proof(problem, comparison, proof)
                    }
                    _ => None,
                };
                let text = format!("{}: {}", label(run.planner, &run.against), statement(problem, comparison, run));
                let text = of_proof.map_or(text.clone(), |note| format!("{text}. {note}"));
                out.push_str(&filled(&text));
            }
        }
    }
    out
}

/// The remarks about the detours of a plan, as paragraphs.
pub fn detours(problem: Problem, solved: &MissionPlan, detours: &[Detour]) -> String {
    let caveats = shape::caveats(problem, solved, detours);
    caveats.iter().map(|caveat| format!("\n{}", indented(&caveat.message))).collect()
}

/// Other times at which plans were found after a run that found none, as a paragraph.
pub fn elsewhere(model: &Model, found_at: &[f64]) -> String {
    verdict_text::elsewhere(model, found_at).map_or(String::new(), |text| indented(&text))
}

/// Mission time and risk after each addition of the greedy choice.
fn trade_off(comparison: &Comparison, bound: f64) -> String {
    let mut table = Table::new(&["protected", "T [s]", "risk"]);
    for step in &comparison.trade_off {
        let added = match &step.added {
            Protection::Nothing => "nothing".to_string(),
            Protection::Facets { mode, facets: 1 } => format!("+ 1 facet of {mode}"),
            Protection::Facets { mode, facets } => format!("+ {facets} facets of {mode}"),
            Protection::Mode { mode } => format!("+ {mode}"),
            Protection::All => "all modes".to_string(),
        };
        table.row(vec![added, number(step.time), significant(step.risk, 3)]);
    }
    format!(
        "\nProtection for a risk of at most {}, chosen greedily; modes are treated as independent\n{}",
        number(bound),
        table.render(2)
    )
}

/// `, 0.279 after the pass for comfort`, if there was one.
fn after_comfort(solved: &MissionPlan) -> String {
    match solved.objective == solved.least_objective {
        true => String::new(),
        false => format!(", {} after the pass for comfort", number(solved.objective)),
    }
}

fn solved_run(problem: Problem, comparison: &Comparison, run: &PlannerRun, solved: &MissionPlan) -> String {
    let (model, mission) = (problem.model(), problem.mission());
    let verdict = statement(problem, comparison, run);
    let text =
        format!("{}: {verdict}{}", label(run.planner, &run.against), without_yaw::beside_the_verdict(comparison));
    let mut out = hanging(&text);
    let (e, waypoints) = (errors(mission, solved), waypoints::waypoints(mission, solved));
    out.push_str(&format!("  {}\n{}", waypoints::headline(&waypoints), waypoints::table(&waypoints, 4)));
    let [position, yaw] = [significant(e.position, 4), significant(e.yaw, 3)];
    out.push_str(&format!("  sum of position errors {position} m, of yaw errors {yaw} rad\n"));
    out.push_str(&format!("  objective {}{}\n", number(solved.least_objective), after_comfort(solved)));
    out.push_str(&shape::text(problem, solved));
    out.push_str(&battery::text(model, &solved.trajectory));
    out.push_str(&volumes::text(problem, solved));
    out.push_str(&headings::text(problem, solved));
    out.push_str(&binding::text(problem, solved));
    if !comparison.modes.is_empty() {
        let by = without_yaw::measured_by(comparison);
        out.push_str(&format!("\n  If a fault strikes: when does the plan violate the mode's {by}?\n"));
        out.push_str(&mode_table(model, comparison, solved).render(2));
        out.push_str(&unguarded(model, comparison, solved));
        out.push_str(&risk_lines(model, comparison, solved));
    }
    if !solved.infeasible_above.is_empty() {
        let times: Vec<String> = solved.infeasible_above.iter().map(|t| number(*t)).collect();
        out.push_str(&format!(
            "\n  A longer time is not always easier here: with {} samples, {} s is proved infeasible.\n",
            model.plan.samples,
            times.join(", ")
        ));
    }
    for caveat in caveats(model, solved) {
        out.push_str(&format!("\n{}", indented(&caveat.message)));
    }
    out
}

/// A note if an RSP plan leaves a set: RSP guards only the selected facets.
fn unguarded(model: &Model, comparison: &Comparison, solved: &MissionPlan) -> String {
    if model.plan.planner != PlannerKind::Rsp || model.plan.require_risk.is_some() {
        return String::new();
    }
    let is_left = |i: &usize| solved.outside[*i].max_violation > VIOLATED;
    let left: Vec<usize> = (0..solved.outside.len()).filter(is_left).collect();
    if left.is_empty() {
        return String::new();
    }
    let most = left.iter().map(|&i| solved.outside[i].max_violation).fold(0.0, f64::max);
    let sets = without_yaw::sets_of(comparison, &left);
    let text = format!(
        "RSP guards the selected facets, not whole sets: this plan leaves {sets}, by up to {}. A larger `rounds` \
         selects more facets; RCP stays in every set.",
        percent(most)
    );
    format!("\n{}", indented(&text))
}

/// Whether the mission holds after some of the faults planned against.
pub(super) fn holds(model: &Model) -> bool {
    model.plan.against.iter().any(|&mode| model.after_fault(mode) == AfterFault::Hold)
}

/// The risk that follows from the modes' rates and the time committed to them; empty if no mode has a rate.
fn risk_lines(model: &Model, comparison: &Comparison, solved: &MissionPlan) -> String {
    let rates = rates(model);
    let Some(risk) = rated_risk(&rates, &solved.committed) else { return String::new() };
    let without = rates.iter().filter(|r| r.is_none()).count();
    let unrated = match without {
        0 => String::new(),
        1 => " 1 mode has no rate and is not counted.".to_string(),
        n => format!(" {n} modes have no rate and are not counted."),
    };
    // A mode that never strikes adds no risk.
    let leaves = |(rate, out): (&Option<f64>, &Outside)| rate.is_some_and(|r| r > 0.0) && out.last.is_some();
    let meaning = match (risk == 0.0, holds(model)) {
        (true, true) if rates.iter().zip(&solved.outside).any(leaves) => {
            "the plan violates only the sets of modes after which the mission holds, and from every node before the \
             violation a stop inside the mode's set was found."
        }
        (true, _) if rates.contains(&Some(0.0)) => "the plan never violates the set of a mode with a rate above zero.",
        (true, _) => "the plan never violates the set of a mode with a rate.",
        (false, false) => {
            "the probability that some mode strikes before its last violation, so that the mission meets the violation \
             if it continues. Modes are treated as independent."
        }
        (false, true) => {
            "the probability that some mode strikes while the mission is committed to it: if the mission continues, \
             before the mode's last violation; if it holds, before the last instant from which no stop inside the \
             mode's set was found. Stops are searched for at the nodes; a stop that was not found may exist, but is \
             not counted. Modes are treated as independent."
        }
    };
    let text = format!(
        "Risk {}: {meaning}{unrated}{}{}",
        significant(risk, 3),
        between_samples(model, &rates, comparison, solved),
        not_looked_at(model)
    );
    format!("\n{}", indented(&text))
}

/// A note on modes with a rate that are not planned against: they may strike too, and their sets were not considered.
pub(super) fn not_looked_at(model: &Model) -> String {
    let others = model
        .modes
        .iter()
        .enumerate()
        .filter(|(i, mode)| !model.plan.against.contains(i) && mode.rate.is_some_and(|rate| rate > 0.0));
    let names: Vec<&str> = others.map(|(_, mode)| mode.name.as_str()).collect();
    match names[..] {
        [] => String::new(),
        [one] => format!(" This covers only the modes planned against; {one} has a rate too and is not among them."),
        _ => format!(
            " This covers only the modes planned against; others have rates and are not among them: {}.",
            listed(&names)
        ),
    }
}

/// A note on modes that the plan violates only between samples. Under RCP this is an effect of the grid.
fn between_samples(model: &Model, rates: &[Option<f64>], comparison: &Comparison, solved: &MissionPlan) -> String {
    let counts = |i: &usize| {
        let out = &solved.outside[*i];
        rates[*i].is_some_and(|r| r > 0.0) && out.last == Some(solved.committed[*i]) && out.positions == 0
    };
    let modes: Vec<usize> = (0..rates.len()).filter(counts).collect();
    if modes.is_empty() {
        return String::new();
    }
    let most = modes.iter().map(|&i| solved.outside[i].max_violation).fold(0.0, f64::max);
    let names: Vec<&str> = modes.iter().map(|&i| comparison.modes[i].as_str()).collect();
    format!(
        " For {} it counts only violations between samples, of at most {} of the width{}.",
        listed(&names),
        percent(most),
        if model.plan.planner == PlannerKind::Rcp { "; try more samples" } else { "" }
    )
}

fn mode_table(model: &Model, comparison: &Comparison, solved: &MissionPlan) -> Table {
    let mut headings = vec!["mode", "spare", "tightest", "facets", "nodes", "worst", "duration", "last violation"];
    let holds = holds(model);
    if holds {
        headings.extend(["after fault", "committed"]);
    }
    let mut table = Table::new(&headings);
    let dash = || "-".to_string();
    let seconds = |at: f64| format!("{} s", fixed(at, 2));
    for (i, (name, out)) in comparison.modes.iter().zip(&solved.outside).enumerate() {
        let is_captured = comparison.provisions[i] == Provision::Capture;
        let mut cells = vec![name.clone()];
        cells.extend(match is_captured {
            true => [dash(), dash()],
            false => [tenths(spare(out)), out.worst_at.map_or_else(dash, seconds)],
        });
        cells.extend(match out.last {
            None if is_captured => ["no rows".into(), dash(), dash(), dash(), "not planned".into()],
            None => ["0".into(), "0".into(), dash(), dash(), "never".into()],
            Some(last) => [
                violated_facets(solved, out).to_string(),
                out.positions.to_string(),
                percent(out.max_violation),
                format!("{} s", short_seconds(out.seconds)),
                seconds(last),
            ],
        });
        if holds {
            cells.push(model.after_fault(model.plan.against[i]).name().to_string());
            let until = solved.committed.get(i).copied().unwrap_or(0.0);
            cells.push(if until > 0.0 { seconds(until) } else { "never".into() });
        }
        table.row(cells);
    }
    table
}
