//! The answer for people, on one screen.

use super::record::name;
use super::why::{speeds, why};
use super::{Against, Answer, Diagnosis};
use crate::admissible::outcome::Outcome;
use crate::admissible::verdict::ModeAnalysis;
use crate::diagnosis::ending::End;
use crate::diagnosis::study::{BEGINS, Evidence, Kind, Loss};
use crate::model::Spin;
use crate::number::{fixed, plural, significant};
use crate::report::screen::{Keep, Screen, Tone};
use crate::text_table::Table;

/// A capacity below this beside stronger motors is worth a remark.
const WEAK: f64 = 0.8;
/// A loss that fits so many other motors as well does not name them.
const MOST_NAMED: usize = 3;
/// At most so many rows of flights.
const MOST_FLIGHTS: usize = 3;

/// The screen.
pub fn screen(diagnosis: &Diagnosis) -> Screen {
    let mut screen = Screen::default();
    let losses = diagnosis.losses();
    match diagnosis.answer() {
        Answer::Unknown => {
            screen.paragraph(Tone::Warning, 0, 2, "the log does not show whether a motor lost thrust");
        }
        Answer::None => screen.paragraph(Tone::Good, 0, 2, &format!("no loss of thrust found{}", searched(diagnosis))),
        Answer::Weaker => {
            for one in diagnosis.weaker() {
                screen.paragraph(Tone::Bad, 0, 2, &weaker(one));
            }
            screen.paragraph(Tone::Plain, 0, 2, &format!("no sudden loss of thrust found{}", searched(diagnosis)));
        }
        Answer::Loss => {
            for (loss, after) in losses.iter().zip(&diagnosis.after) {
                screen.paragraph(Tone::Bad, 0, 2, &headline(diagnosis, loss, after));
            }
        }
    }
    if diagnosis.after.iter().any(|after| after.outcome == Outcome::Undecided) {
        screen.remark(
            Keep::Finding,
            "undecided: the drag in a spin decides, and no log shows it; name a spec that gives `yaw_drag`",
        );
    }
    why(diagnosis).iter().for_each(|why| screen.paragraph(Tone::Strong, 0, 2, &format!("why: {why}")));
    diagnosis.unknown.iter().for_each(|why| screen.remark(Keep::Finding, why));
    screen.gap();
    flights(diagnosis, &mut screen);
    screen.gap();
    capacities(diagnosis, &mut screen);
    screen.gap();
    screen.paragraph(Tone::Plain, 0, 2, &source(diagnosis));
    screen
}

/// Which part of the flights was searched.
fn searched(diagnosis: &Diagnosis) -> String {
    match diagnosis.study.iter().flat_map(|study| &study.searched).any(Option::is_some) {
        true => format!(", from {} s after each take-off on; small and slow losses can be missed", fixed(BEGINS, 1)),
        false => String::new(),
    }
}

/// `motor 1 gives less thrust than in the baseline flights: 0.75 against 0.97`.
fn weaker(one: &Against) -> String {
    format!(
        "motor {} gives less thrust than in the baseline flights: {} against {}, a change of {} (95 % of sound motors: \
         +- {})",
        one.motor + 1,
        fixed(one.mean + one.change, 2),
        fixed(one.mean, 2),
        fixed(one.change, 3),
        fixed(one.half, 3)
    )
}

/// The vehicle by the letters of its rotors' spins counter-clockwise from the nose, if they are a ring.
fn layout(diagnosis: &Diagnosis) -> String {
    let rotors = &diagnosis.model.vehicle.rotors;
    let angle = |p: [f64; 3]| p[1].atan2(p[0]).rem_euclid(std::f64::consts::TAU);
    let mut ring: Vec<(f64, Spin)> = rotors.iter().map(|rotor| (angle(rotor.position), rotor.spin)).collect();
    ring.sort_by(|a, b| a.0.total_cmp(&b.0));
    match ring.windows(2).any(|pair| pair[1].0 - pair[0].0 < 1e-3) {
        true => format!("vehicle with {} rotors", rotors.len()),
        false => {
            let letters: String = ring.iter().map(|(_, spin)| if *spin == Spin::P { 'P' } else { 'N' }).collect();
            format!("{letters} vehicle")
        }
    }
}

/// `motor 3 lost at 21.4 s; after it a PNPNPN: no margin`.
fn headline(diagnosis: &Diagnosis, loss: &Loss, after: &ModeAnalysis) -> String {
    let others: Vec<String> = loss.alternatives.iter().map(|k| (k + 1).to_string()).collect();
    let motor = match &others[..] {
        [] => format!("motor {}", loss.motor + 1),
        _ if others.len() < MOST_NAMED => format!("motor {} (or {})", loss.motor + 1, others.join(" or ")),
        _ => format!("one of {} motors, most likely {},", others.len() + 1, loss.motor + 1),
    };
    let percent = |x: f64| fixed(100.0 * x, 0);
    let half = 0.5 * (loss.interval[1] - loss.interval[0]);
    let time = format!("{} s (+- {} s)", fixed(loss.time, 2), significant(half.max(0.01), 1));
    let what = match (loss.kind, loss.evidence) {
        (Kind::Lost, Evidence::Speed) => format!("{motor} stands still from {time} on"),
        (Kind::Lost, _) => format!("{motor} lost at {time}"),
        (Kind::Reduced, _) => format!(
            "{motor} gives {} % of its thrust ({} to {} %) from {time} on",
            percent(loss.capacity),
            percent(loss.capacity_interval[0]),
            percent(loss.capacity_interval[1])
        ),
        (Kind::Off, _) => format!("{motor}: its output is off from {time} on"),
        (Kind::Held, Evidence::Output) => {
            format!("{motor}: its output is held at {} % of full thrust from {time} on", percent(loss.capacity))
        }
        (Kind::Held, _) => format!(
            "{motor} gives {} % of full thrust ({} to {} %) whatever its command from {time} on",
            percent(loss.capacity),
            percent(loss.capacity_interval[0]),
            percent(loss.capacity_interval[1])
        ),
    };
    format!("{what}; after it the {}: {}", layout(diagnosis), after.outcome.word())
}

/// What happened in each flight.
fn flights(diagnosis: &Diagnosis, screen: &mut Screen) {
    let Some(study) = &diagnosis.study else { return };
    let earlier = study.flights.len().saturating_sub(MOST_FLIGHTS);
    if earlier > 0 {
        screen.line(Tone::Plain, &format!("{}, then:", plural(earlier, "flight")));
    }
    for flight in &study.flights[earlier..] {
        let last = diagnosis.losses().iter().rfind(|loss| loss.time >= flight.from && loss.time <= flight.to);
        let after = last.map(|loss| flight.to - loss.time);
        let end = match flight.end {
            End::Impact(speed) => {
                let speed = speed.map_or(" (no height is logged)".into(), |speed| format!(" at {}", speeds(speed)));
                let after = after.map_or(String::new(), |s| format!(", {} s after the last loss", fixed(s, 1)));
                format!("hit the ground{speed}{after}")
            }
            End::Landed => {
                after.map_or("landed".into(), |s| format!("its motors at rest {} s after the last loss", fixed(s, 0)))
            }
            End::Open => {
                let after = after.map_or(String::new(), |s| format!(", {} s after the last loss", fixed(s, 0)));
                format!("in the air when the log ends{after}")
            }
        };
        let degrees = |angle: f64| fixed(angle.to_degrees(), 0);
        let yaw = flight.yaw_rate.map(|rate| format!("yaw up to {} deg/s", degrees(rate)));
        let tilt = flight.tilt.map(|tilt| format!("tilt up to {} deg (estimated)", degrees(tilt)));
        let parts: Vec<String> = yaw.into_iter().chain(tilt).collect();
        let parts = if parts.is_empty() { String::new() } else { format!("{}; ", parts.join(", ")) };
        let text = format!("flight from {} to {} s: {parts}{end}", fixed(flight.from, 1), fixed(flight.to, 1));
        screen.paragraph(Tone::Plain, 0, 2, &text);
    }
}

/// The capacities in one row for each motor.
fn capacities(diagnosis: &Diagnosis, screen: &mut Screen) {
    let Some(capacities) = diagnosis.study.as_ref().and_then(|study| study.capacities.as_ref()) else { return };
    let against = diagnosis.baseline.as_deref();
    let mut heads = vec!["motor", "thrust", "95 %"];
    if against.is_some() {
        heads.extend(["baseline", "change", ""]);
    }
    let mut table = Table::new(&heads);
    for (k, capacity) in capacities.iter().enumerate() {
        let interval = format!("{} to {}", fixed(capacity.low, 2), fixed(capacity.high, 2));
        let mut cells = vec![(k + 1).to_string(), fixed(capacity.value, 2), interval];
        if let Some(one) = against.and_then(|all| all.iter().find(|one| one.motor == k)) {
            let word = if one.is_significant() { "significant" } else { "not significant" };
            let change = format!("{}{}", if one.change > 0.0 { "+" } else { "" }, fixed(one.change, 2));
            cells.extend([fixed(one.mean, 2), change, format!("{word} (+- {})", fixed(one.half, 2))]);
        }
        table.row(cells);
    }
    screen.line(Tone::Strong, "thrust for the same command in quiet flight, relative to the strongest motor");
    screen.table(&table);
    if against.is_some() {
        screen.paragraph(Tone::Plain, 2, 2, "a change can be a weaker motor, or a centre of gravity that moved");
    } else if capacities.iter().any(|capacity| capacity.high < WEAK) {
        screen.paragraph(
            Tone::Plain,
            2,
            2,
            "one flight cannot tell a weak motor from a centre of gravity off the middle, nor weak motors all around \
             from a low battery or more mass; compare with flights of the same load by --baseline",
        );
    }
}

/// What the answer is from.
fn source(diagnosis: &Diagnosis) -> String {
    let rate = |hz: f64, what: &str| match hz > 0.0 {
        true => format!("{what} at {} Hz", significant(hz, 2)),
        false => format!("no {what}"),
    };
    format!(
        "log of {}, {} motors; {}, {}",
        name(diagnosis.autopilot),
        diagnosis.motors.len(),
        rate(diagnosis.rates[0], "outputs of motors"),
        rate(diagnosis.rates[1], "rates of turn")
    )
}
