//! The short output of `mavc analyze`: the outcome of every mode on one screen.

use super::headline::{by_rotors, headline, why_undecided};
use super::mode_names::within;
use super::screen::{Keep, Screen, Tone, fits};
use super::terminal::{airspeed, vehicle_line};
use crate::admissible;
use crate::admissible::airspeed::PLAUSIBLE;
use crate::admissible::diagnose::diagnose_by;
use crate::admissible::outcome::Outcome;
use crate::admissible::parallel::least_angle;
use crate::admissible::verdict::ModeAnalysis;
use crate::diagnostic::Severity;
use crate::flight::equilibrium::{SettledSpin, settled_spins};
use crate::model::{Allocation, Model};
use crate::number::{down, number, part_of_all, significant};
use crate::report::battery;
use crate::text_table::Table;
use std::collections::BTreeSet;

/// Most rows of modes; with more groups of modes each outcome has its weakest, and the others are counted.
const MOST_ROWS: usize = 12;
/// Most columns of the names of modes.
const NAMES: usize = 32;
/// Most modes whose rotors are listed.
const MOST_NAMED: usize = 6;
/// Without room for so many columns of names the spins are left to `-v`.
const FEWEST_NAMES: usize = 18;
/// Digits of every figure.
const DIGITS: usize = 3;
/// Marks the outcome of the mode with full control that leaves least of it.
const WEAKEST: &str = ", least margin";

/// The output.
pub fn screen(model: &Model, modes: &[ModeAnalysis]) -> Screen {
    let mut screen = Screen::default();
    let worst = modes.iter().map(|mode| mode.outcome).max();
    let tone = match worst {
        Some(Outcome::FullControl) => Tone::Good,
        Some(Outcome::Lost | Outcome::NoMargin) => Tone::Bad,
        _ => Tone::Warning,
    };
    screen.paragraph(tone, 0, 2, &headline(model, modes));
    let vehicle = vehicle_line(model);
    screen.paragraph(Tone::Plain, 0, 2, vehicle.strip_prefix(&model.vehicle.name).unwrap_or(&vehicle).trim_start());
    screen.gap();
    let mut spins = settled_spins(model);
    if !fits(&table(model, modes, &spins, FEWEST_NAMES)) {
        spins.clear();
    }
    screen.fitted(NAMES, |names| table(model, modes, &spins, names));
    screen.gap();
    columns(model, modes).iter().for_each(|line| screen.paragraph(Tone::Plain, 2, 2, line));
    legend(model, modes, &spins).iter().for_each(|line| screen.paragraph(Tone::Plain, 2, 2, line));
    remarks(model, modes).iter().for_each(|text| screen.remark(Keep::Finding, text));
    screen.close();
    screen
}

/// The headings of the cells of a row, with the unit of each; the last of them only where some mode has a spin.
pub(super) const HEADINGS: [(&str, &str); 5] =
    [("after it", ""), ("climb", "N"), ("yaw", "N m"), ("max", "kg"), ("rad/s", "deg")];

/// The table of outcomes, of the terminal and of the page.
pub(super) struct Overview {
    /// The cells of the healthy vehicle.
    pub healthy: Vec<String>,
    /// The modes, alike ones together: all, or of many the weakest of each outcome.
    pub rows: Vec<Row>,
    /// How many modes of each outcome are in no row.
    pub others: Vec<(Outcome, usize)>,
}

impl Overview {
    /// `spins` are those of [`settled_spins`]; without any there is no column of them.
    pub fn of(model: &Model, modes: &[ModeAnalysis], spins: &[SettledSpin]) -> Self {
        let (mut rows, others) = shown(rows(model, modes, spins));
        let controlled: Vec<f64> =
            rows.iter().filter(|row| row.outcome == Outcome::FullControl).map(|row| row.margin).collect();
        let weakest = controlled.iter().copied().reduce(f64::min).filter(|_| controlled.len() > 1);
        for row in &mut rows {
            if row.outcome == Outcome::FullControl && weakest == Some(row.margin) {
                row.cells[0].push_str(WEAKEST);
            }
        }
        let healthy = modes.first().map_or(Vec::new(), |healthy| cells(model, healthy, spins));
        Overview { healthy, rows, others }
    }
}

/// Modes with the same row; a yaw margin that is larger in the other direction does not part them.
pub(super) struct Row {
    pub outcome: Outcome,
    /// One for each of [`HEADINGS`].
    pub cells: Vec<String>,
    /// Indices into the declared modes.
    pub modes: Vec<usize>,
    /// The margin by which rows of one outcome are ordered, N and N m.
    margin: f64,
}

/// The modes as rows, alike ones together, in the order in which they are declared.
fn rows(model: &Model, modes: &[ModeAnalysis], spins: &[SettledSpin]) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for (index, mode) in modes.iter().enumerate().skip(1) {
        let cells = cells(model, mode, spins);
        match rows.iter_mut().find(|row| row.outcome == mode.outcome && row.cells == cells) {
            Some(row) => {
                row.modes.push(index - 1);
                row.margin = row.margin.min(margin(mode));
            }
            None => rows.push(Row { outcome: mode.outcome, cells, modes: vec![index - 1], margin: margin(mode) }),
        }
    }
    rows
}

/// How far hover is inside the set that the outcome is about, N and N m.
fn margin(mode: &ModeAnalysis) -> f64 {
    let margin = if mode.outcome == Outcome::FullControl { mode.acai } else { mode.acai_yaw_free };
    margin.unwrap_or(0.0)
}

/// Whether the outcome is one with control of yaw.
fn holds_heading(mode: &ModeAnalysis) -> bool {
    matches!(mode.outcome, Outcome::FullControl | Outcome::NoMargin) && mode.headroom.is_some()
}

/// Climb, yaw, largest mass, and the spin where some mode has one.
fn cells(model: &Model, mode: &ModeAnalysis, spins: &[SettledSpin]) -> Vec<String> {
    let hover = admissible::hover(model)[0];
    let level = mode.without_yaw.as_ref().map(|figures| figures.level_thrust_n - hover);
    let climb = match (&mode.headroom, holds_heading(mode)) {
        (Some(headroom), true) => Some(headroom.thrust[1]),
        _ => level,
    };
    let yaw = mode.headroom.as_ref().filter(|_| holds_heading(mode)).map(|headroom| {
        let [less, more] = [0, 1].map(|i| headroom.tau_z[i]);
        let [less, more] = [less.min(more), less.max(more)].map(|torque| significant(torque, DIGITS));
        format!("{less}/{more}")
    });
    let mass = if holds_heading(mode) { mode.critical_mass_kg } else { mode.critical_mass_yaw_free_kg };
    let positive = |value: &f64| *value > 0.0;
    let mut cells = vec![
        mode.outcome.word().to_string(),
        climb.map_or("-".into(), |newton| format!("+{}", down(newton.max(0.0), DIGITS))),
        yaw.unwrap_or("-".into()),
        mass.filter(positive).map_or("none".into(), |mass| down(mass, DIGITS)),
    ];
    if !spins.is_empty() {
        let of_mode = |spin: &&SettledSpin| spin.mode == mode.name && !holds_heading(mode);
        cells.push(spins.iter().find(of_mode).map_or("-".into(), spin));
    }
    cells
}

/// `7.8, 19.4`: the rate, rad/s, and the angle between its axis and z of the body, deg
fn spin(spin: &SettledSpin) -> String {
    let rate = spin.spin_rad_s.abs();
    match rate < 1e-3 {
        true => "none".into(),
        false => format!(
            "{}, {}",
            significant(rate, DIGITS),
            significant((10.0 * spin.axis_tilt_deg).round() / 10.0, DIGITS)
        ),
    }
}

fn table(model: &Model, modes: &[ModeAnalysis], spins: &[SettledSpin], names: usize) -> Table {
    let mut headings = vec!["fault".to_string()];
    headings.extend(HEADINGS.iter().take(if spins.is_empty() { 4 } else { 5 }).map(|(name, unit)| match *name {
        "rad/s" => format!("{name}, {unit}"),
        _ => format!("{name} {unit}").trim_end().to_string(),
    }));
    let mut table = Table::new(&headings.iter().map(String::as_str).collect::<Vec<_>>()).with_words(1);
    let Overview { healthy, rows, others } = Overview::of(model, modes, spins);
    table.row(std::iter::once("none".to_string()).chain(healthy).collect());
    let all: Vec<String> = model.modes.iter().map(|mode| mode.name.clone()).collect();
    for row in rows {
        table.row(std::iter::once(within(&all, &row.modes, names)).chain(row.cells).collect());
    }
    for (outcome, count) in others {
        table.row(vec![format!("and {count} more"), outcome.word().into()]);
    }
    table
}

/// The rows that are shown: all, or of many the weakest of each outcome; and how many modes of each outcome are not.
fn shown(mut rows: Vec<Row>) -> (Vec<Row>, Vec<(Outcome, usize)>) {
    if rows.len() <= MOST_ROWS {
        return (rows, Vec::new());
    }
    let present: Vec<Outcome> =
        Outcome::ALL.into_iter().filter(|outcome| rows.iter().any(|row| row.outcome == *outcome)).collect();
    let each = (MOST_ROWS / present.len()).saturating_sub(1).max(1);
    let (mut shown, mut others) = (Vec::new(), Vec::new());
    for outcome in present {
        let mut of_outcome: Vec<Row> = rows.extract_if(.., |row| row.outcome == outcome).collect();
        of_outcome.sort_by(|a, b| a.margin.total_cmp(&b.margin));
        let left = of_outcome.split_off(each.min(of_outcome.len()));
        let count: usize = left.iter().map(|row| row.modes.len()).sum();
        shown.extend(of_outcome);
        others.extend((count > 0).then_some((outcome, count)));
    }
    (shown, others)
}

/// The meaning of the columns that every table has.
fn columns(model: &Model, modes: &[ModeAnalysis]) -> [String; 2] {
    let is_weakest = |row: &Row| row.cells[0].ends_with(WEAKEST);
    let weakest = match Overview::of(model, modes, &[]).rows.iter().any(is_weakest) {
        true => "; least margin: hover nearest to the edge",
        false => "",
    };
    let without_yaw = match modes.iter().skip(1).any(|mode| !holds_heading(mode)) {
        true => ", turning if the heading is not held",
        false => "",
    };
    [
        "climb: thrust left beyond hover; yaw: torque left, weaker/stronger direction".into(),
        format!("max kg: the largest mass that hovers{without_yaw}{weakest}"),
    ]
}

/// What else the table shows.
pub(super) fn legend(model: &Model, modes: &[ModeAnalysis], spins: &[SettledSpin]) -> Vec<String> {
    let mut lines = Vec::new();
    if !spins.is_empty() {
        lines.push("rad/s, deg: the spin in which flights settle (none: no spin), and its axis from z".into());
    }
    if modes.iter().skip(1).any(|mode| mode.outcome == Outcome::FliesOn) {
        lines.push("flies on: it can hover, but may be lost on the way there: `mavc simulate`".into());
    }
    lines.extend(rotors_of_modes(model));
    lines.extend(planned_against(model));
    if model.vehicle.has_intervals() {
        lines.push("outcomes hold for all values of the intervals; figures are those of the middle".into());
    }
    lines.extend(speeds(model, modes));
    lines
}

/// `board1: rotors 1, 2 lost; board2: rotors 3, 4 lost`, of modes that are not named after their rotors; `None` if they
/// are none or many.
fn rotors_of_modes(model: &Model) -> Option<String> {
    let each: Vec<String> =
        model.modes.iter().filter_map(|mode| Some(format!("{}: {}", mode.name, by_rotors(mode)?))).collect();
    (1..=MOST_NAMED).contains(&each.len()).then(|| each.join("; "))
}

/// `planned against: M1 .. M4; not planned against: M5, M6`; `None` without a mission, and if plans are made against
/// all modes.
pub fn planned_against(model: &Model) -> Option<String> {
    model.mission.as_ref()?;
    let all: Vec<String> = model.modes.iter().map(|mode| mode.name.clone()).collect();
    let (yes, no): (Vec<usize>, Vec<usize>) = (0..all.len()).partition(|mode| model.plan.against.contains(mode));
    let names = |modes: &[usize]| if modes.is_empty() { "no mode".into() } else { within(&all, modes, NAMES) };
    (!no.is_empty())
        .then(|| format!("planned against: {}; not planned against: {} (`against`)", names(&yes), names(&no)))
}

/// `steady airspeed with the reserve: 23.1 m/s without a fault, least after M2: 12.3 m/s`
fn speeds(model: &Model, modes: &[ModeAnalysis]) -> Option<String> {
    let healthy = modes.first()?.airspeed.as_ref()?;
    let speed = |mode: &ModeAnalysis| mode.airspeed.as_ref().map_or(0.0, |air| air.largest_m_per_s.unwrap_or(0.0));
    let least = modes.iter().skip(1).min_by(|a, b| speed(a).total_cmp(&speed(b)));
    let heading = if model.environment().is_isotropic() { "" } else { " in the worst heading" };
    // Where every speed is beyond what the drag is for, none is of use.
    if modes.iter().all(|mode| speed(mode) > PLAUSIBLE) {
        let most = number(PLAUSIBLE);
        return Some(format!(
            "steady airspeed with the plan's reserve{heading}: over {most} m/s in every mode, where drag in proportion \
             to speed is not plausible"
        ));
    }
    let after =
        least.and_then(|mode| Some(format!(", least after {}: {}", mode.name, airspeed(mode.airspeed.as_ref()?))));
    let implausible = modes.iter().any(|mode| speed(mode) > PLAUSIBLE);
    let note = if implausible { "; drag in proportion to speeds over 40 m/s is not plausible" } else { "" };
    Some(format!(
        "steady airspeed with the plan's reserve{heading}: {} without a fault{}{note}",
        airspeed(healthy),
        after.unwrap_or_default()
    ))
}

/// A torque below this share of the other direction's is none.
const EXHAUSTED: f64 = 1e-6;

/// `roll or pitch torque`: the torques of which hover leaves none in one direction; `None` if each is left, as where
/// only several at once are not.
fn exhausted_axes(mode: &ModeAnalysis) -> Option<String> {
    let left = mode.headroom.as_ref().filter(|_| mode.outcome == Outcome::NoMargin)?;
    let axes = [("roll", left.tau_x), ("pitch", left.tau_y), ("yaw", left.tau_z)];
    let exhausted = axes.into_iter().filter(|(_, [less, more])| less.min(*more) <= EXHAUSTED * less.max(*more));
    let names: Vec<&str> = exhausted.map(|(name, _)| name).collect();
    (!names.is_empty()).then(|| format!("{} torque", names.join(" or ")))
}

/// What a reader must not overlook.
pub(super) fn remarks(model: &Model, modes: &[ModeAnalysis]) -> Vec<String> {
    let all: Vec<String> = modes.iter().map(|mode| mode.name.clone()).collect();
    let named = |which: &dyn Fn(&ModeAnalysis) -> bool| {
        let places: Vec<usize> = (0..modes.len()).filter(|&i| which(&modes[i])).collect();
        (!places.is_empty()).then(|| within(&all, &places, 40))
    };
    let needs_spin = |mode: &ModeAnalysis| {
        let excludes_zero = |[low, high]: [f64; 2]| low > 0.0 || high < 0.0;
        mode.outcome == Outcome::FliesOn
            && mode
                .without_yaw
                .as_ref()
                .is_some_and(|free| free.spin_rad_s.is_none() && excludes_zero(free.yaw_torque_n_m))
    };
    // The healthy vehicle comes first.
    let known = diagnose_by(model, |mode| modes.get(mode.map_or(0, |mode| mode + 1)).cloned());
    let error = known.into_iter().flatten().find(|found| found.severity == Severity::Error);
    let unplannable = error.filter(|_| model.mission.is_some());
    let mut remarks: Vec<String> = unplannable
        .map(|error| format!("no plan of the mission can be made: {}; `mavc check` names remedies", error.message))
        .into_iter()
        .collect();
    let outcomes: Vec<Outcome> = modes.iter().map(|mode| mode.outcome).collect();
    remarks.extend(why_undecided(model, &outcomes));
    remarks.extend(
        named(&needs_spin)
            .map(|names| format!("{names}: the vehicle must spin; the rate is unknown without `yaw_drag`")),
    );
    remarks.extend(named(&|mode| mode.outcome == Outcome::Caught).map(|names| {
        format!("{names}: the vehicle loses height before it is caught; `mavc analyze --capture` simulates how much")
    }));
    // Alike modes need not follow each other.
    let exhausted: BTreeSet<Option<String>> = modes.iter().map(exhausted_axes).collect();
    for axes in exhausted {
        let has_these = |mode: &ModeAnalysis| mode.outcome == Outcome::NoMargin && exhausted_axes(mode) == axes;
        remarks.extend(named(&has_these).map(|names| match &axes {
            Some(axes) => format!(
                "{names}: in hover no {axes} remains to one side, so a disturbance to the other side cannot be \
                 countered"
            ),
            None => format!(
                "{names}: hover is on the edge of what the remaining rotors can give, so some disturbance cannot be \
                 countered"
            ),
        }));
    }
    let faint = |mode: &ModeAnalysis| mode.nearest_rows.is_some_and(|rows| rows.angle < least_angle());
    remarks.extend(named(&faint).map(|names| {
        format!("{names}: nearly parallel rows of the actuation matrix, so the rotors hardly separate two axes")
    }));
    let lowered = battery::full_thrust(model);
    remarks.extend((!lowered.is_empty()).then(|| lowered.trim_end().to_string()));
    if model.vehicle.allocation == Allocation::PseudoInverse {
        let most = modes.iter().filter_map(|mode| mode.unreached_share).fold(0.0, f64::max);
        remarks.push(format!(
            "the pseudo-inverse does not reach up to {} % of a set; outcomes are those of what it reaches",
            part_of_all(most)
        ));
    }
    remarks
}
