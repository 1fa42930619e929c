//! What can be done after a fault, as text for a terminal.

use super::{RecoveryRecord, WORDS, site_name, uncovered};
use crate::admissible::outcome::Outcome;
use crate::flight::equilibrium::outcome_of;
use crate::model::Model;
use crate::number::{fixed, number, percent, plural, significant};
use crate::recovery::{Families, ModeRecovery, NotAttempted, Piece, Recovery, Way};
use crate::report::mode_names::within;
use crate::report::screen::{Counted, Keep, Screen, Tone, WIDTH};
use crate::text_table::Table;

/// Columns of a strip.
const STRIP: usize = 40;

/// The most lines of modes on the screen.
const MOST_MODES: usize = 10;

/// Most columns of the names of modes.
const NAMES: usize = 20;

/// So many of them stay where a screen has no room.
const ROWS: usize = 3;

/// The sign of an outcome on a strip. Where several share a column, the last of this order is shown.
fn sign(way: Option<Way>) -> (usize, char) {
    match way {
        Some(Way::Continue) => (0, '='),
        Some(Way::ContinueSpinning) => (1, '~'),
        Some(Way::LandAt(_)) => (2, 'L'),
        Some(Way::LandHere) => (3, 'h'),
        Some(Way::Caught) => (4, 'c'),
        None => (5, 'x'),
    }
}

fn strip(mode: &ModeRecovery, duration: f64) -> String {
    let of_column = |column: usize| {
        let [from, to] = [column, column + 1].map(|c| duration * c as f64 / STRIP as f64);
        let here = mode.pieces.iter().filter(|piece| piece.to >= from && piece.from <= to);
        here.map(|piece| sign(piece.way)).max().map_or(' ', |(_, sign)| sign)
    };
    (0..STRIP).map(of_column).collect()
}

/// The outcome of every fault, those with the longest gaps first, and on what it rests. What explains more may be left
/// out of a screen.
pub fn write(screen: &mut Screen, model: &Model, recovery: &Recovery, verbose: bool) {
    let (open, _) = uncovered(model, recovery);
    let required = model.plan.recovery.require.map(|require| require.uncovered);
    let tone = match (open, required) {
        (open, Some(required)) if open > required => Tone::Bad,
        (open, None) if open > 0.0 => Tone::Warning,
        _ => Tone::Good,
    };
    let record = RecoveryRecord::new(model, recovery);
    screen.paragraph(tone, 2, 2, &format!("AFTER A FAULT {}", sentence(&record)));
    if let Some(replanned) = &record.replanned {
        screen.paragraph(Tone::Plain, 2, 2, &replanned.sentence(model.plan.reserve));
    }
    if let Some(longer) = &record.longer {
        screen.paragraph(Tone::Plain, 2, 2, &longer.sentence(recovery.duration));
    }
    let mut table = Table::new(&["fault", &scale(recovery.duration), "no way out s"]);
    let rows = rows(model, recovery);
    let shown = if verbose { rows.len() } else { rows.len().min(MOST_MODES) };
    for row in &rows[..shown] {
        table.row(vec![row.names.clone(), row.bar.clone(), row.seconds.clone()]);
    }
    for (row, line) in table.render_left(2).lines().enumerate() {
        match row > ROWS {
            true => {
                // The first line has the headings.
                let modes = rows[row - 1].modes;
                screen.part(Keep::Row, Some((Counted::Gap, modes)), |screen| screen.line(Tone::Plain, line));
            }
            false => screen.line(Tone::Plain, line),
        }
    }
    let hidden: usize = rows[shown..].iter().map(|row| row.modes).sum();
    if hidden > 0 {
        screen.line(Tone::Plain, &format!("  {} more with shorter gaps: -v", plural(hidden, "mode")));
    }
    for line in legend(recovery) {
        screen.line(Tone::Plain, &format!("  {line}"));
    }
    let (gaps, rest) = gaps(model, recovery, if verbose { usize::MAX } else { 3 });
    for gap in gaps {
        screen.part(Keep::Reason, Some((Counted::Remark, 1)), |screen| screen.paragraph(Tone::Warning, 2, 2, &gap));
    }
    if rest > 0 {
        let counted = Some((Counted::Remark, rest));
        let text = format!("  {} more: -v", plural(rest, "gap"));
        screen.part(Keep::Reason, counted, |screen| screen.line(Tone::Plain, &text));
    }
    if let Some(text) = between(model, recovery) {
        screen.paragraph(Tone::Plain, 2, 2, &text);
    }
    let [basis, beside] = premise(&record, model.plan.reserve);
    screen.paragraph(if record.survived == record.flown { Tone::Plain } else { Tone::Warning }, 2, 2, &basis);
    screen.part(Keep::Reason, None, |screen| screen.paragraph(Tone::Plain, 2, 2, &beside));
}

/// Modes with the same outcomes.
struct Row {
    names: String,
    /// How many they are.
    modes: usize,
    /// The outcomes along the mission, or why none was sought.
    bar: String,
    /// For how long no way out was found.
    seconds: String,
}

/// The outcomes of all modes, those with the longest gaps first; of these, modes for which ways out were sought before
/// others.
fn rows(model: &Model, recovery: &Recovery) -> Vec<Row> {
    let mut modes: Vec<&ModeRecovery> = recovery.modes.iter().collect();
    modes.sort_by(|a, b| {
        let longer = b.uncovered().total_cmp(&a.uncovered());
        longer.then(a.not_attempted.is_some().cmp(&b.not_attempted.is_some()))
    });
    let bar = |mode: &ModeRecovery| match mode.not_attempted {
        None => strip(mode, recovery.duration),
        Some(NotAttempted::NoHover) => match outcome_of(model, mode.mode) {
            Outcome::FliesOn => "not sought: heading not held (`yaw_drag`)".into(),
            _ => "not sought: no margin to hover with".into(),
        },
        Some(NotAttempted::Caught) => "not sought: caught, but no place to land".into(),
    };
    let mut grouped: Vec<(Vec<usize>, String, String)> = Vec::new();
    for mode in modes {
        let (bar, seconds) = (bar(mode), fixed(mode.uncovered(), 2));
        match grouped.iter_mut().find(|(_, known, at)| *known == bar && *at == seconds) {
            Some((of, ..)) => of.push(mode.mode),
            None => grouped.push((vec![mode.mode], bar, seconds)),
        }
    }
    let all: Vec<String> = model.modes.iter().map(|mode| mode.name.clone()).collect();
    let row = |(mut modes, bar, seconds): (Vec<usize>, String, String)| {
        modes.sort_unstable();
        Row { names: within(&all, &modes, NAMES), modes: modes.len(), bar, seconds }
    };
    grouped.into_iter().map(row).collect()
}

/// `0 s                                20 s`
fn scale(duration: f64) -> String {
    let end = format!("{} s", significant(duration, 3));
    format!("0 s{end:>width$}", width = STRIP - 3)
}

/// The signs that the strips have, in lines.
fn legend(recovery: &Recovery) -> Vec<String> {
    let mut signs: Vec<(usize, char)> =
        recovery.modes.iter().flat_map(|mode| &mode.pieces).map(|piece| sign(piece.way)).collect();
    signs.sort_unstable();
    signs.dedup();
    let mut lines: Vec<String> = Vec::new();
    for (order, sign) in signs {
        let entry = format!("{sign} {}", WORDS[order]);
        match lines.last_mut().filter(|line| line.chars().count() + entry.chars().count() + 5 <= WIDTH) {
            Some(line) => line.push_str(&format!("   {entry}")),
            None => lines.push(entry),
        }
    }
    lines
}

/// The outcome of all faults in one sentence.
pub fn sentence(record: &RecoveryRecord) -> String {
    let delays = match record.detection_s[..] {
        [least, most] => format!("{} to {} ms", number(1e3 * least), number(1e3 * most)),
        _ => format!("{} ms", number(1e3 * record.detection_s[0])),
    };
    let of = if record.weighted { "of the failure rate" } else { "of all instants and faults" };
    let known = format!("known after {delays}, down or back on the plan within {} s", number(record.within_s));
    match record.uncovered == 0.0 {
        true => format!("{known}: a way out at every instant looked at"),
        false => format!("{known}: no way out found for {} {of}", percent(record.uncovered)),
    }
}

/// On what the outcomes rest: what was computed, and what was flown.
pub fn premise(record: &RecoveryRecord, reserve: f64) -> [String; 2] {
    let mut basis = format!("Looked at {} instants, not between them.", record.instants);
    if record.flown > 0 {
        basis.push_str(&format!(
            " Delays are simulated without noise; with the noise and gusts of `simulate`, or its defaults, {} of {} \
             simulated branches end as planned.",
            record.survived, record.flown
        ));
    }
    let mut pieces = record.modes.iter().flat_map(|mode| &mode.pieces);
    if pieces.any(|piece| piece.outcome == super::outcome(Some(Way::Caught))) {
        basis.push_str(" Where caught, simulated flights with and without noise and gusts landed.");
    }
    // A plan can be covered at an instant from which no way out is found.
    let strayed = match record.uncovered > 0.0 {
        true => " When the fault is known, the vehicle has left the plan. Where none was found, a flight may survive.",
        false => "",
    };
    let beside =
        format!("Branches keep the fault's set with {} % in reserve.{strayed}", significant(100.0 * reserve, 3));
    [basis, beside]
}

/// For how much of the time with a way out that is proved at every instant, and why not for the rest; `None` if no
/// proof was sought.
fn between(model: &Model, recovery: &Recovery) -> Option<String> {
    let families: Vec<(&ModeRecovery, &Families)> =
        recovery.modes.iter().filter_map(|mode| Some((mode, mode.families.as_ref()?))).collect();
    if families.is_empty() {
        return None;
    }
    let proved: f64 = families.iter().map(|(_, families)| families.proved_s()).sum();
    let with_a_way: f64 = families.iter().map(|(mode, _)| recovery.duration - mode.uncovered()).sum();
    let share = if with_a_way > 0.0 { proved / with_a_way } else { 0.0 };
    let longest = families.iter().filter_map(|(mode, families)| Some((mode, families.not_proved.as_ref()?)));
    let longest = longest.max_by(|(_, a), (_, b)| (a.to - a.from).total_cmp(&(b.to - b.from)));
    let why = longest.map(|(mode, why)| {
        let [from, to] = [why.from, why.to].map(|t| fixed(t, 2));
        format!(" Not proved, for example: {} from {from} to {to} s ({}).", model.modes[mode.mode].name, why.why)
    });
    Some(format!(
        "Proved at every instant, by the certificate: {} of the time with a way out.{}",
        percent(share),
        why.unwrap_or_default()
    ))
}

/// The longest gaps, and how many more there are.
fn gaps(model: &Model, recovery: &Recovery, most: usize) -> (Vec<String>, usize) {
    let mut all: Vec<(&ModeRecovery, &Piece)> = recovery
        .modes
        .iter()
        .filter(|mode| mode.not_attempted.is_none())
        .flat_map(|mode| mode.pieces.iter().filter(|piece| piece.way.is_none()).map(move |piece| (mode, piece)))
        .collect();
    all.sort_by(|a, b| (b.1.to - b.1.from).total_cmp(&(a.1.to - a.1.from)));
    // One more line says as much as a line that counts it.
    let most = if all.len() == most.saturating_add(1) { all.len() } else { most };
    let rest = all.len().saturating_sub(most);
    let sentence = |(mode, piece): &(&ModeRecovery, &Piece)| {
        let [from, to] = [piece.from, piece.to].map(|t| fixed(t, 2));
        let near = piece.near_miss.map(|miss| {
            let [at, takes, within] = [miss.at, miss.takes, recovery.within].map(|t| significant(t, 3));
            format!("; at {at} s, {} was reached in {takes} s, not in {within} s", site_name(model, miss.site))
        });
        format!("! {} from {from} to {to} s: none found{}", model.modes[mode.mode].name, near.unwrap_or_default())
    };
    (all.iter().take(most).map(sentence).collect(), rest)
}
