//! Which fault modes a plan covers, which not, and until when a fault would meet a violation.

use super::Answer;
use crate::admissible::outcome::Outcome;
use crate::admissible::row::VIOLATED;
use crate::admissible::without_yaw::planned::Provision;
use crate::certify::between::{Between, CORES, Shown, WRENCH};
use crate::flight::equilibrium::outcome_of;
use crate::model::{AfterFault, Mission, Model, PlannerKind};
use crate::motion::outside::Outside;
use crate::motion::wrench_model::WrenchModel;
use crate::number::{fixed, part_of_all, significant, tenths};
use crate::planner::studies::{MissionPlan, PlannerRun, Run};
use crate::report::headline::{by_failure, of_modes};
use crate::report::mode_names::within;
use crate::report::screen::{Keep, Screen, Tone};
use crate::report::without_yaw;
use crate::text_table::Table;
use serde::Serialize;

/// Most columns of the names of modes, in the table and in a sentence.
const NAMES: usize = 32;
const NAMES_IN_TEXT: usize = 44;
/// Most rows of the table.
const MOST_ROWS: usize = 7;
/// The outcomes of up to this many modes that are not planned against are worked out.
const MOST_WORKED_OUT: usize = 64;

/// Digits of a mission time.
const DIGITS_OF_TIME: usize = 4;
/// Most kinds of faults that a sentence tells apart.
const MOST_KINDS: usize = 3;
/// Rows of the table that are always shown.
const ALWAYS: usize = 3;

/// What a sentence says of its modes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Covers {
    /// The plan covers the modes at every instant.
    Always,
    /// It covers them by stops, as far as these were found.
    Stops,
    /// A fault of these modes before some instant meets a violation.
    UnsafeUntil,
    /// It is not planned for these modes, although they are in `against`.
    NotPlanned,
    /// The modes are not in `against`, or not declared.
    Not,
}

impl Covers {
    /// Whether the plan does not cover modes that it is asked to cover.
    pub fn is_bad(self) -> bool {
        self.tone() == Tone::Bad
    }

    fn tone(self) -> Tone {
        match self {
            Covers::Always => Tone::Plain,
            Covers::Stops | Covers::Not => Tone::Warning,
            Covers::UnsafeUntil | Covers::NotPlanned => Tone::Bad,
        }
    }
}

/// A sentence about the fault modes that a plan covers, or does not.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct CoverageRecord {
    /// What it says.
    pub covers: Covers,
    /// The sentence, as on the terminal and the page.
    #[cfg_attr(test, schemars(length(min = 1)))]
    pub sentence: String,
}

/// The sentences on coverage.
pub fn say(answer: &Answer, screen: &mut Screen, run: &PlannerRun, solved: &MissionPlan) {
    for CoverageRecord { covers, sentence } in sentences(answer, run, solved) {
        screen.paragraph(covers.tone(), 2, 2, &sentence);
    }
}

/// The table of modes.
pub fn tabulate(answer: &Answer, screen: &mut Screen, solved: &MissionPlan) {
    let model = answer.problem.model();
    if answer.comparison.modes.is_empty() {
        return;
    }
    screen.gap();
    let ModeTable { rows, hidden, .. } = table(answer, solved, NAMES);
    screen.fitted_modes(NAMES, ALWAYS, &rows, |names| table(answer, solved, names).table);
    if !hidden.is_empty() {
        screen.hide_modes(within(&names(model), &declared(model, &hidden), NAMES_IN_TEXT), hidden.len());
    }
    if answer.comparison.provisions.iter().all(|provision| *provision == Provision::Capture) {
        return;
    }
    let reserve = if model.plan.reserve > 0.0 { " beyond the reserve" } else { "" };
    let legend = format!(
        "spare: what the plan leaves{reserve}, % of the healthy set's width; unsafe: as if faults were known at \
         once"
    );
    screen.part(Keep::Legend, None, |screen| screen.paragraph(Tone::Plain, 2, 2, &legend));
}

/// Which modes a plan covers and which not, in sentences.
pub fn sentences(answer: &Answer, run: &PlannerRun, solved: &MissionPlan) -> Vec<CoverageRecord> {
    let (model, comparison) = (answer.problem.model(), answer.comparison);
    let mut found = Vec::new();
    let mut say = |covers: Covers, sentence: String| found.push(CoverageRecord { covers, sentence });
    if model.modes.is_empty() {
        say(Covers::Not, "No fault modes are declared: this plan covers none.".into());
        return found;
    }
    let all = comparison.modes.len();
    let places = |wanted: &dyn Fn(usize) -> bool| (0..all).filter(|&i| wanted(i)).collect::<Vec<usize>>();
    let is_captured = |i: usize| comparison.provisions[i] == Provision::Capture;
    let stops = |i: usize| solved.outside[i].last.is_some() && unsafe_until(model, solved, i).is_none();
    let is_safe = |i: usize| !is_captured(i) && solved.outside[i].last.is_none();
    let is_core = |i: usize| matches!(comparison.provisions[i], Provision::WithoutYaw(_));
    let with_yaw = places(&|i| is_safe(i) && !is_core(i));
    let without_yaw = places(&|i| is_safe(i) && is_core(i));
    let reserve = match model.plan.reserve > 0.0 {
        true => format!(", with {} % in reserve", part_of_all(model.plan.reserve)),
        false => String::new(),
    };
    let wrench = match solved.trajectory.model {
        WrenchModel::Exact => "this plan's thrust and torques",
        _ => "the thrust and torques that the linear model gives this plan",
    };
    // What is unsafe comes first.
    let unsafe_ones = places(&|i| !is_captured(i) && unsafe_until(model, solved, i).is_some());
    if !unsafe_ones.is_empty() {
        let until = unsafe_ones.iter().filter_map(|&i| unsafe_until(model, solved, i)).fold(0.0, f64::max);
        say(
            Covers::UnsafeUntil,
            format!(
                "UNSAFE until {}: after {} the remaining rotors cannot always give {wrench}{reserve}.{}",
                instant(solved, until),
                named(answer, &unsafe_ones),
                advice(answer, run)
            ),
        );
    }
    let mut safe = Vec::new();
    if !with_yaw.is_empty() {
        let names = named(answer, &with_yaw);
        safe.push(format!("After {names} at any instant the remaining rotors still give {wrench}{reserve}."));
    }
    if !without_yaw.is_empty() {
        let names = named(answer, &without_yaw);
        safe.push(format!(
            "After {names} at any instant the remaining rotors still give {wrench} except about yaw{reserve}: the \
             heading is not held."
        ));
    }
    if !safe.is_empty() {
        safe.push(how_shown(answer, run));
        say(Covers::Always, safe.join(" "));
    }
    let stopping = places(&|i| !is_captured(i) && stops(i));
    if !stopping.is_empty() {
        let names = named(answer, &stopping);
        say(
            Covers::Stops,
            format!(
                "After {names} the plan leaves what the remaining rotors can give, but from every node before that a \
                 stop within it was found (`after_fault = hold`)."
            ),
        );
    }
    without_yaw::not_planned(comparison, answer.heights).into_iter().for_each(|text| say(Covers::NotPlanned, text));
    match not_covered(model) {
        Some(text) => say(Covers::Not, text),
        None => say(Covers::Not, "Faults that the spec does not declare are NOT covered.".into()),
    }
    found
}

/// What covers the modes that RSP leaves out: its facets were selected too few times.
fn advice(answer: &Answer, run: &PlannerRun) -> String {
    let comparison = answer.comparison;
    if run.planner != PlannerKind::Rsp || answer.problem.model().plan.require_risk.is_some() {
        return String::new();
    }
    match comparison.covering_time.filter(|_| run.run == Run::Own) {
        Some(time) => {
            let all: Vec<usize> = (0..comparison.modes.len()).collect();
            let all = within(&names(answer.problem.model()), &declared(answer.problem.model(), &all), NAMES);
            let time = significant(time, DIGITS_OF_TIME);
            format!(" `--set plan.planner=rcp` covers {all} in {time} s or less.")
        }
        None => " `--set plan.rounds=3` or `--set plan.planner=rcp` may cover them.".into(),
    }
}

/// Modes that are planned against, given by their places there, with what fails in them if that is of few kinds: `M1 ..
/// M8 (one rotor lost)`.
fn named(answer: &Answer, places: &[usize]) -> String {
    let model = answer.problem.model();
    let of = by_failure(model, declared(model, places).into_iter());
    if of.len() > MOST_KINDS {
        return within(&names(model), &declared(model, places), NAMES_IN_TEXT);
    }
    let each = of.iter().map(|(what, modes)| {
        format!("{} ({})", within(&names(model), modes, NAMES_IN_TEXT), of_modes(model, what, modes))
    });
    each.collect::<Vec<_>>().join(", ")
}

/// The names of the declared modes.
fn names(model: &Model) -> Vec<String> {
    model.modes.iter().map(|mode| mode.name.clone()).collect()
}

/// The places among the declared modes of those at some places in `against`, ascending.
fn declared(model: &Model, places: &[usize]) -> Vec<usize> {
    let mut modes: Vec<usize> = places.iter().map(|&i| model.plan.against[i]).collect();
    modes.sort_unstable();
    modes
}

/// Until when a fault of the mode with this place in `against` meets a violation, s: the last one, or, if the mission
/// holds after the fault, the last instant from which no stop was found. `None` if it never does.
pub(in crate::documents::report) fn unsafe_until(model: &Model, solved: &MissionPlan, i: usize) -> Option<f64> {
    match model.after_fault(model.plan.against[i]) {
        AfterFault::Hold => solved.committed.get(i).copied().filter(|until| *until > 0.0),
        _ => solved.outside[i].last,
    }
}

/// `4.31 s`, or `the end`
pub(in crate::documents::report) fn instant(solved: &MissionPlan, at: f64) -> String {
    if at >= solved.trajectory.duration() { "the end".into() } else { format!("{} s", fixed(at, 2)) }
}

/// Whether a fault of some mode planned against meets a violation, or is not planned.
pub fn is_partial(answer: &Answer, solved: &MissionPlan) -> bool {
    let model = answer.problem.model();
    let is_unsafe = |i: usize| unsafe_until(model, solved, i).is_some();
    answer.comparison.provisions.contains(&Provision::Capture) || (0..solved.outside.len()).any(is_unsafe)
}

/// The modes that a plan should cover, where none was found.
pub fn demanded(answer: &Answer, screen: &mut Screen) {
    let (model, all) = (answer.problem.model(), &answer.comparison.modes);
    if !all.is_empty() {
        let places: Vec<usize> = (0..all.len()).collect();
        screen.paragraph(Tone::Plain, 2, 2, &format!("It has to cover {}.", named(answer, &places)));
    }
    warn_of_not_covered(model, screen);
}

/// The sentence of [`not_covered`] on a screen.
pub(in crate::documents::report) fn warn_of_not_covered(model: &Model, screen: &mut Screen) {
    not_covered(model).iter().for_each(|text| screen.paragraph(Covers::Not.tone(), 2, 2, text));
}

/// The declared modes that are not planned against, with what they leave of the vehicle; `None` if there are none.
fn not_covered(model: &Model) -> Option<String> {
    let all = names(model);
    let left: Vec<usize> = (0..all.len()).filter(|mode| !model.plan.against.contains(mode)).collect();
    if left.is_empty() {
        return None;
    }
    let names = |modes: &[usize]| within(&all, modes, NAMES_IN_TEXT);
    let outcomes = |modes: &[usize]| -> Vec<(Outcome, Vec<usize>)> {
        let each: Vec<Outcome> = modes.iter().map(|&mode| outcome_of(model, mode)).collect();
        let of = |outcome: Outcome| {
            (0..modes.len()).filter(|&i| each[i] == outcome).map(|i| modes[i]).collect::<Vec<usize>>()
        };
        Outcome::ALL.into_iter().map(|outcome| (outcome, of(outcome))).filter(|(_, of)| !of.is_empty()).collect()
    };
    let kinds = by_failure(model, left.iter().copied());
    let groups: Vec<String> = if left.len() > MOST_WORKED_OUT {
        vec![names(&left)]
    } else if kinds.len() > MOST_KINDS {
        let each = outcomes(&left).into_iter();
        each.map(|(outcome, modes)| format!("{} (in hover: {})", names(&modes), outcome.words_of(modes.len())))
            .collect()
    } else {
        let each = kinds.iter().flat_map(|(what, modes)| outcomes(modes).into_iter().map(move |of| (what, of)));
        each.map(|(what, (outcome, modes))| {
            let what = of_modes(model, what, &modes);
            format!("{} ({what}; in hover: {})", names(&modes), outcome.words_of(modes.len()))
        })
        .collect()
    };
    let groups = groups.join(", ");
    Some(format!("NOT covered at any time, not in `against`: {groups}; nor faults that the spec does not declare."))
}

/// How it was shown that the plan stays inside the sets: only imposed rows are proved.
fn how_shown(answer: &Answer, run: &PlannerRun) -> String {
    let of_sets = |between: &&Between| [WRENCH, CORES].contains(&between.rows.as_str());
    let rows: Vec<&Between> = answer.between.unwrap_or(&[]).iter().filter(of_sets).collect();
    let is_protected = !answer.comparison.trade_off.is_empty();
    let is_proved = !rows.is_empty() && rows.iter().all(|rows| rows.shown == Shown::Proved);
    match (run.planner, is_proved) {
        (PlannerKind::Rsp, _) if answer.problem.model().plan.rounds == 0 && !is_protected => {
            "Sampled along the plan, not proved: with `rounds = 0` RSP guards no mode.".into()
        }
        (PlannerKind::Rsp, _) if answer.comparison.selected.is_empty() && !is_protected => {
            "Sampled along the plan, not proved: the plan that ignores faults violates no constraint of these modes; \
             RSP adds none."
                .into()
        }
        (PlannerKind::Rcp, true) => "Proved at every instant.".into(),
        (PlannerKind::Rcp, false) => "Checked on a grid of instants, not proved between them.".into(),
        (PlannerKind::Rsp, true) => {
            "Constraints guarded by RSP are proved at every instant, the others sampled along the plan.".into()
        }
        (PlannerKind::Rsp, false) => "Sampled along the plan, not proved.".into(),
        (PlannerKind::Rip, _) => "Sampled along the plan, not proved: RIP guards no mode.".into(),
    }
}

/// What a plan leaves of a mode's set beyond the reserve, as a share of the healthy width; negative for a violation.
pub(in crate::documents::report) fn spare(out: &Outside) -> f64 {
    if out.max_violation.abs() <= VIOLATED { 0.0 } else { -out.max_violation }
}

/// A [`spare`] for people, who learn nothing from the digits of a violation above the whole width, such as one of a
/// core, whose constraints depend on the body rates.
fn spare_words(spare: f64) -> String {
    if spare < -1.0 { "< -100 %".into() } else { tenths(spare) }
}

/// Spare, the tightest instant and the last violation of each mode, alike modes together, the tightest first.
struct ModeTable {
    table: Table,
    /// The names of modes in each row, and how many there are.
    rows: Vec<(String, usize)>,
    /// The modes in no row, by their places in `against`.
    hidden: Vec<usize>,
}

/// The table of modes, with names of at most `names` columns.
fn table(answer: &Answer, solved: &MissionPlan, names: usize) -> ModeTable {
    let (model, comparison) = (answer.problem.model(), answer.comparison);
    let headings = ["fault", "spare", "tightest", "unsafe"];
    let mut rows: Vec<(f64, Vec<usize>, Vec<String>)> = Vec::new();
    for (i, out) in solved.outside.iter().enumerate() {
        let is_captured = comparison.provisions[i] == Provision::Capture;
        let spare = spare(out);
        let seconds = |at: f64| format!("{} s", fixed(at, 2));
        let cells = match is_captured {
            true => vec!["-".to_string(), "-".into(), "not planned".into()],
            false => vec![
                spare_words(spare),
                out.worst_at
                    .map_or("-".into(), |at| format!("{}{}", seconds(at), leg(answer.problem.mission(), solved, at))),
                unsafe_until(model, solved, i).map_or("never".into(), |at| format!("until {}", instant(solved, at))),
            ],
        };
        let rank = if is_captured { f64::NEG_INFINITY } else { spare };
        match rows.iter_mut().find(|(_, _, same)| *same == cells) {
            Some((_, modes, _)) => modes.push(i),
            None => rows.push((rank, vec![i], cells)),
        }
    }
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    let hidden = rows.split_off(rows.len().min(MOST_ROWS));
    let mut table = Table::new(&headings);
    let mut of_rows = Vec::new();
    for (_, modes, cells) in &rows {
        let name = within(&self::names(model), &declared(model, modes), names);
        of_rows.push((name.clone(), modes.len()));
        table.row(std::iter::once(name).chain(cells.iter().cloned()).collect());
    }
    ModeTable { table, rows: of_rows, hidden: hidden.into_iter().flat_map(|row| row.1).collect() }
}

/// `, to waypoint 3`: the leg on which an instant is.
fn leg(mission: &Mission, solved: &MissionPlan, at: f64) -> String {
    let trajectory = &solved.trajectory;
    let next = trajectory.waypoint_nodes.iter().position(|&node| trajectory.times[node] >= at);
    match next.filter(|waypoint| *waypoint > 0 && *waypoint < mission.waypoints.len()) {
        Some(waypoint) => format!(", to waypoint {}", waypoint + 1),
        None => String::new(),
    }
}
