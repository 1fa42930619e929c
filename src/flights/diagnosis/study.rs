//! The whole question: which rotors lost thrust in a record, when, and how much each has.

use super::capacity::{Capacity, capacities};
use super::change::{Change, strongest};
use super::ending::{Flight, flights};
use super::fit::{Effect, Fit};
use super::hidden::{DETERMINED, Mixed};
use super::lasting::lasts;
use super::onset::onset;
use super::outputs::{Frozen, frozen};
use super::record::{Commands, MOTORS, Record, median};
use super::samples::Samples;
use super::transient::sudden;
use crate::cancel;

/// The earliest change that has this share of the strength of the strongest is taken first.
const FIRST: f64 = 0.5;
/// The most losses that are looked for in one flight.
const MOST_LOSSES: usize = 4;
/// Take-off and landing are left out of the search: seconds at the start of a flight.
const TAKE_OFF: f64 = 1.5;
/// Then the search needs so much of the flight before an instant, and is worth so much of it at least, s.
const WARMS_UP: f64 = 2.0;
const LEAST_SEARCHED: f64 = 1.0;
/// How long after a take-off the search begins, and the shortest flight that is searched, s.
pub const BEGINS: f64 = TAKE_OFF + WARMS_UP;
pub const SHORTEST: f64 = BEGINS + LEAST_SEARCHED;
/// A rotor that is lost has less than this of its thrust.
const LOST: f64 = 0.15;
/// After an output of one motor was off or held, so long (s) no reduced thrust of another is taken from the motion,
/// which follows commands that the log has too few samples of.
const UNSETTLED: f64 = 3.0;
/// Two signs of a fault of one motor within this time are one fault, s.
const SAME: f64 = 0.7;
/// A speed below this share of the others' median is that of a motor that stands.
const STANDING: f64 = 0.3;
/// How long a motor stands before it counts, s.
const STANDS: f64 = 0.25;

/// What happened to a rotor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// No thrust although it is commanded.
    Lost,
    /// Less thrust than commanded.
    Reduced,
    /// The same thrust whatever the command: the autopilot's output is held at one value, or, by the motion, the motor
    /// is.
    Held,
    /// The autopilot's output is off.
    Off,
}

/// What shows a loss.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Evidence {
    /// How the vehicle turned.
    Motion,
    /// The output of the autopilot.
    Output,
    /// The logged speed of the rotor.
    Speed,
}

/// A rotor that lost thrust.
#[derive(Debug, Clone, PartialEq)]
pub struct Loss {
    /// From 0.
    pub motor: usize,
    /// s, in the time of the log, with a 95 % interval.
    pub time: f64,
    pub interval: [f64; 2],
    /// Share of full thrust that follows the command, with a 95 % interval; if held, the share of full thrust that it
    /// is held at.
    pub capacity: f64,
    pub capacity_interval: [f64; 2],
    pub kind: Kind,
    pub evidence: Evidence,
    /// Motors whose loss would explain the motion as well, from 0.
    pub alternatives: Vec<usize>,
}

/// What a record says.
#[derive(Debug, Clone)]
pub struct Study {
    pub flights: Vec<Flight>,
    /// In the order of time.
    pub losses: Vec<Loss>,
    /// Of each rotor relative to the strongest, before the first loss; `None` if fewer than two parts of the flight
    /// are quiet.
    pub capacities: Option<Vec<Capacity>>,
    /// The fit before the first loss; `None` without a flight.
    pub fit: Option<Fit>,
    /// The time of that fit, s.
    pub range: [f64; 2],
    /// Share of full thrust in hover: the median of the mean command.
    pub hover: Option<f64>,
    /// Length of the windows, s.
    pub step: f64,
    /// From when on the motion of each flight was searched for losses, s; `None` if it is too short.
    pub searched: Vec<Option<f64>>,
    /// Whether the commands of all rotors are known, without which the motion says nothing.
    pub is_determined: bool,
}

/// Studies a record.
///
/// `hidden` outputs (motors from 0) are not looked at. `None` if commands or rates are logged too slowly for any
/// answer.
pub fn study(record: &Record, commands: &Commands, effects: &[Effect], hidden: &[usize]) -> Option<Study> {
    let seen = |row: usize, motor: usize| commands(row, motor).0;
    let mixed = Mixed::of(record, &seen, effects, hidden);
    let can_search = is_determined(mixed.as_ref(), effects);
    let command = |mixed: Option<&Mixed>, row: usize, motor: usize| match mixed {
        Some(mixed) if hidden.contains(&motor) => mixed.command(row, motor, &seen),
        _ => seen(row, motor),
    };
    let first = Samples::of(record, effects.len(), &|row, motor| command(mixed.as_ref(), row, motor))?;
    let flights = flights(record, &first);
    let known = |row: usize, motor: usize| match hidden.contains(&motor) {
        true => (command(mixed.as_ref(), row, motor), false),
        false => commands(row, motor),
    };
    let stopped = |flight: &Flight| -> Vec<Frozen> {
        let range = [flight.from + TAKE_OFF, flight.to];
        let found = frozen(&record.outputs.times, &record.outputs.values, &known, range, effects);
        found.into_iter().filter(|one| !hidden.contains(&one.motor)).collect()
    };
    let stopped: Vec<Vec<Frozen>> = flights.iter().map(stopped).collect();
    // Once more without the outputs that no longer follow the mixer.
    let mixed = mixed.and_then(|mixed| mixed.without(&stopped.concat()));
    let samples = match &mixed {
        Some(mixed) => Samples::of(record, effects.len(), &|row, motor| command(Some(mixed), row, motor))?,
        None => first,
    };
    let mut study = Study {
        flights,
        losses: Vec::new(),
        capacities: None,
        fit: None,
        range: [0.0; 2],
        hover: None,
        step: samples.step,
        searched: Vec::new(),
        is_determined: can_search,
    };
    for (flight, stopped) in study.flights.clone().into_iter().zip(&stopped) {
        let found = losses_of(record, stopped, hidden, effects, &samples, &flight, mixed.as_ref());
        let was_off = |loss: &Loss| {
            loss.kind == Kind::Off && study.losses.iter().any(|l| l.kind == Kind::Off && l.motor == loss.motor)
        };
        let new: Vec<Loss> = found.into_iter().filter(|loss| !was_off(loss)).collect();
        study.losses.extend(new);
        let is_long = flight.to - flight.from > SHORTEST;
        study.searched.push((can_search && is_long).then_some(flight.from + BEGINS));
    }
    study.losses.sort_by(|a, b| a.time.total_cmp(&b.time));
    if let Some(flight) = study.flights.iter().max_by(|a, b| (a.to - a.from).total_cmp(&(b.to - b.from))) {
        let first = study.losses.iter().map(|loss| loss.interval[0]).fold(f64::INFINITY, f64::min);
        let range = [flight.from + TAKE_OFF, flight.to.min(first) - TAKE_OFF];
        let fit = Fit::of(&samples, effects, range);
        study.capacities = capacities(&samples, &fit, effects, range);
        let inside = samples.samples.iter().filter(|s| s.time > range[0] && s.time < range[1].max(range[0] + 1.0));
        let mut means: Vec<f64> = inside.map(|s| s.commands.iter().sum::<f64>() / effects.len() as f64).collect();
        study.hover = median(&mut means).filter(|h| h.is_finite());
        study.fit = Some(fit);
        study.range = range;
    }
    Some(study)
}

/// Whether the commands of all rotors are known: otherwise a torque or the thrust is open.
fn is_determined(mixed: Option<&Mixed>, effects: &[Effect]) -> bool {
    mixed.map_or(effects.len() >= DETERMINED, Mixed::is_determined)
}

fn losses_of(
    record: &Record,
    stopped: &[Frozen],
    hidden: &[usize],
    effects: &[Effect],
    samples: &Samples,
    flight: &Flight,
    mixed: Option<&Mixed>,
) -> Vec<Loss> {
    let motors = effects.len();
    let mut losses: Vec<Loss> = stopped.iter().map(|found| of_output(found, record.outputs.period())).collect();
    let range = [flight.from + TAKE_OFF, flight.to];
    for (motor, time) in standing(record, range, motors) {
        let interval = [time - record.speeds.period(), time];
        add(
            &mut losses,
            Loss {
                motor,
                time,
                interval,
                capacity: 0.0,
                capacity_interval: [0.0, LOST],
                kind: Kind::Lost,
                evidence: Evidence::Speed,
                alternatives: Vec::new(),
            },
        );
    }
    let in_air = range;
    let window = |t: f64| samples.samples.partition_point(|s| s.time < t);
    let range = window(range[0])..window(range[1]);
    let mut fit = Fit::of(samples, effects, in_air);
    let mut moved: Vec<Change> = Vec::new();
    if !is_determined(mixed, effects) {
        return losses;
    }
    for round in 0..MOST_LOSSES {
        cancel::checkpoint();
        let samples = samples.with(&moved);
        let candidates = sudden(&samples, effects, range.clone());
        let found = candidates.strongest.iter().filter_map(|one| onset(&samples, effects, range.clone(), one.time));
        // What is left of a change that is known is not another one, and a disturbed flight shows only whole losses, or
        // those whose outputs are not seen to be held.
        let is_whole = |one: &Change| match one.is_held {
            true => hidden.contains(&one.motor),
            false => one.capacity < LOST,
        };
        let is_new = |one: &Change| moved.iter().all(|known| (known.time - one.time).abs() > SAME && is_whole(one));
        let found: Vec<Change> = found.filter(is_new).filter(|one| lasts(&samples, effects, one, flight.to)).collect();
        let strongest = found.iter().map(|one| one.strength).fold(0.0, f64::max);
        // What follows a change that is not known yet is disturbed by it.
        let found = found.into_iter().filter(|one| one.strength > FIRST * strongest);
        let mut found = found.min_by(|a, b| a.time.total_cmp(&b.time));
        if round == 0 {
            if let (Some(found), Some(clear)) = (&mut found, &candidates.clear) {
                found.narrow(clear);
            }
            found = found.or(candidates.clear.filter(|one| lasts(&samples, effects, one, flight.to)));
        }
        let Some(found) = found else { break };
        moved.push(found);
        moved.sort_by(|a, b| a.time.total_cmp(&b.time));
    }
    for round in 0..=MOST_LOSSES {
        cancel::checkpoint();
        let residuals = residuals_after(&fit, samples, effects, &moved);
        let known: Vec<usize> = moved.iter().map(|change| change.motor).collect();
        let Some(change) = strongest(samples, &fit, effects, &residuals, range.clone(), &known) else { break };
        if round == 0 {
            // Once more, with an answer to commands that no fault has spoilt.
            let before = Fit::of(samples, effects, [in_air[0], change.interval[0]]);
            if before.gains[0].is_some() && before.gains[1].is_some() {
                fit = before;
            }
            let residuals = residuals_after(&fit, samples, effects, &moved);
            moved.push(strongest(samples, &fit, effects, &residuals, range.clone(), &known).unwrap_or(change));
        } else if round < MOST_LOSSES {
            moved.push(change);
        }
    }
    let taken: Vec<(usize, f64)> =
        losses.iter().filter(|loss| loss.evidence == Evidence::Output).map(|loss| (loss.motor, loss.time)).collect();
    // With a hidden motor, no demands and no more than four outputs that follow the mixer, nothing shows whether the
    // mixer is saturated, so that the command of the hidden one is doubtful to the end.
    let follow = (0..motors).filter(|k| !hidden.contains(k) && stopped.iter().all(|one| one.motor != *k)).count();
    let is_open = mixed.is_some_and(|mixed| !mixed.is_demanded()) && follow <= DETERMINED;
    let [most, lasts] = if is_open { [LOST, f64::INFINITY] } else { [0.5, UNSETTLED] };
    let is_doubtful = |change: &Change| {
        let is_known = hidden.contains(&change.motor) && !is_open;
        let is_weak = |motor: usize| match change.is_held {
            true => !is_known || change.motor == motor,
            false => change.capacity >= most || change.motor == motor,
        };
        let is_near = |t: f64| change.time > t - SAME && change.time < t + lasts;
        taken.iter().any(|(motor, t)| is_near(*t) && (is_weak(*motor) || change.time < t + SAME))
    };
    for change in moved.into_iter().filter(|change| !is_doubtful(change)) {
        add(
            &mut losses,
            Loss {
                motor: change.motor,
                time: change.time,
                interval: change.interval,
                capacity: change.capacity,
                capacity_interval: change.capacity_interval,
                kind: match change.capacity {
                    c if c < LOST => Kind::Lost,
                    _ if change.is_held => Kind::Held,
                    _ => Kind::Reduced,
                },
                evidence: Evidence::Motion,
                alternatives: change.alternatives,
            },
        );
    }
    losses
}

/// Adds a loss unless an earlier kind of evidence has it.
fn add(losses: &mut Vec<Loss>, loss: Loss) {
    let is_known = |known: &Loss| known.motor == loss.motor && (known.time - loss.time).abs() < SAME;
    if !losses.iter().any(is_known) {
        losses.push(loss);
    }
}

/// The residuals with what the rotors give after the changes that are known.
fn residuals_after(fit: &Fit, samples: &Samples, effects: &[Effect], changes: &[Change]) -> Vec<[f64; 4]> {
    let n = samples.samples.len();
    (0..n)
        .map(|i| {
            let mut given = fit.commands[i].clone();
            for change in changes.iter().filter(|change| samples.samples[i].time > change.time) {
                given[change.motor] = change.given(given[change.motor]);
            }
            fit.residual(samples, effects, i, &given)
        })
        .collect()
}

fn of_output(found: &Frozen, period: f64) -> Loss {
    Loss {
        motor: found.motor,
        time: found.from - 0.5 * period,
        interval: [found.from - period, found.from],
        capacity: if found.is_off { 0.0 } else { found.share },
        capacity_interval: [if found.is_off { 0.0 } else { found.share }; 2],
        kind: if found.is_off { Kind::Off } else { Kind::Held },
        evidence: Evidence::Output,
        alternatives: Vec::new(),
    }
}

/// Motors whose logged speed stands while the others turn, with the time from which it does, s.
fn standing(record: &Record, range: [f64; 2], motors: usize) -> Vec<(usize, f64)> {
    let [a, b] = range.map(|t| record.speeds.times.partition_point(|x| *x < t));
    let mut since: [Option<f64>; MOTORS] = [None; MOTORS];
    let mut found: Vec<(usize, f64)> = Vec::new();
    for i in a..b {
        let (time, row) = (record.speeds.times[i], &record.speeds.values[i]);
        let mut known: Vec<f64> = row[..motors].iter().filter(|v| v.is_finite()).map(|v| f64::from(*v)).collect();
        let Some(middle) = median(&mut known).filter(|middle| *middle > 500.0) else { continue };
        for motor in 0..motors {
            let stands = f64::from(row[motor]) < STANDING * middle;
            let start = since[motor].filter(|_| stands).or(stands.then_some(time));
            since[motor] = start;
            if start.is_some_and(|start| time - start > STANDS) && !found.iter().any(|(k, _)| *k == motor) {
                found.push((motor, start.unwrap_or(time)));
            }
        }
    }
    found
}
