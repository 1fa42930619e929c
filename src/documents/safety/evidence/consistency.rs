//! Whether a report agrees with the certificate of its plan, with the spec, and with itself. This proves nothing about
//! the ways out: a report that was forged with care agrees too.

use super::reading::{ModeOutcomes, NAMED, PieceOfReport, ROUNDING, Recovery};
use super::{CAUGHT, struck_at};
use crate::certificate::MotionRecord;
use crate::model::{Mission, Model};
use crate::number::number;
use crate::recovery::{NotAttempted, RESOLUTION, apart, not_attempted, steps};
use crate::report::recovery::OUTCOMES;

/// The duration of the plan and its arrivals at waypoints, s: those of the certificate, which the report's must equal.
pub fn times(
    motion: &MotionRecord,
    mission: &Mission,
    duration: f64,
    arrivals: &[f64],
) -> Result<(f64, Vec<f64>), String> {
    let end = motion.times_s.last().copied().ok_or("the plan of the certificate has no nodes")?;
    if (end - duration).abs() > ROUNDING {
        let [end, duration] = [end, duration].map(number);
        return Err(format!("its plan takes {duration} s, that of the certificate {end} s: write both in one run"));
    }
    if arrivals.len() != mission.waypoints.len() {
        return Err("its waypoints are not those of the spec".into());
    }
    let nodes = motion.waypoint_nodes.iter().map(|node| motion.times_s.get(*node).copied());
    let nodes: Option<Vec<f64>> = nodes.collect();
    let nodes = nodes.filter(|nodes| nodes.len() == arrivals.len());
    let nodes = nodes.ok_or("the certificate has other waypoints")?;
    for (index, (at, node)) in arrivals.iter().zip(&nodes).enumerate() {
        if (at - node).abs() > ROUNDING {
            return Err(format!(
                "it reaches waypoint {} at {} s, the plan of the certificate at {} s: write both in one run",
                index + 1,
                number(*at),
                number(*node)
            ));
        }
    }
    Ok((end, nodes))
}

/// Compares the delays with the spec, and sums and counts with the pieces.
pub fn ways_out(model: &Model, recovery: &Recovery, duration: f64) -> Result<(), String> {
    let settings = &model.plan.recovery;
    let [least, most] = settings.detection;
    let delays = if least < most { vec![least, most] } else { vec![most] };
    let same = |a: f64, b: f64| (a - b).abs() <= ROUNDING;
    let agrees = recovery.detection_s.len() == delays.len()
        && recovery.detection_s.iter().zip(&delays).all(|(a, b)| same(*a, *b))
        && same(recovery.within_s, settings.within);
    if !agrees {
        return Err("its delays or its longest way out are not those of the spec".into());
    }
    for (index, mode) in recovery.modes.iter().enumerate() {
        if mode.not_attempted.as_deref() != not_attempted(model, index).map(NotAttempted::word) {
            return Err(format!("whether a way out was sought after {} does not follow from the spec", mode.name));
        }
        of_mode(mode, most, duration)?;
    }
    instants(recovery, duration)?;
    let branches: usize = recovery.modes.iter().flat_map(|mode| &mode.pieces).map(|piece| piece.branches.len()).sum();
    if branches != recovery.flown {
        return Err(format!("it names {branches} ways out, and counts {} that were flown", recovery.flown));
    }
    if branches > recovery.instants {
        return Err(format!("it names {branches} ways out at {} instants", recovery.instants));
    }
    let rates: Option<Vec<f64>> = model.modes.iter().map(|mode| mode.rate).collect();
    let rates = rates.filter(|rates| rates.iter().sum::<f64>() > 0.0);
    let weight = |mode: usize| rates.as_ref().map_or(1.0, |rates| rates[mode]);
    let open = recovery.modes.iter().enumerate().map(|(at, mode)| weight(at) * mode.uncovered_s).sum::<f64>();
    let all = (0..recovery.modes.len()).map(|at| weight(at) * duration).sum::<f64>();
    let share = if all > 0.0 { open / all } else { 0.0 };
    if rates.is_some() != recovery.weighted || (share - recovery.uncovered).abs() > ROUNDING {
        return Err(format!(
            "its share without a way out is {}, that of its modes {}",
            number(recovery.uncovered),
            number(share)
        ));
    }
    Ok(())
}

/// Whether a piece has no way out.
fn is_open(piece: &PieceOfReport) -> bool {
    piece.outcome == OUTCOMES[OUTCOMES.len() - 1]
}

/// Compares the number of instants with the ends of gaps, each of which was bisected.
fn instants(recovery: &Recovery, duration: f64) -> Result<(), String> {
    let halvings = (apart(duration) / RESOLUTION).log2().ceil().max(0.0) as usize;
    let sought = recovery.modes.iter().filter(|mode| mode.not_attempted.is_none());
    let (least, ends) = sought.fold((0, 0), |(least, ends), mode| {
        let of_mode = mode.pieces.windows(2).filter(|pair| is_open(&pair[0]) != is_open(&pair[1])).count();
        (least + steps(duration) as usize + 1, ends + of_mode)
    });
    match (least..=least + ends * halvings).contains(&recovery.instants) {
        true => Ok(()),
        false => Err(format!("a search of its outcomes does not look at {} instants", recovery.instants)),
    }
}

/// Compares what a report says of one mode with its pieces; faults are known after `delay` s.
fn of_mode(mode: &ModeOutcomes, delay: f64, duration: f64) -> Result<(), String> {
    let name = &mode.name;
    let open: f64 = mode.pieces.iter().filter(|piece| is_open(piece)).map(|piece| piece.to_s - piece.from_s).sum();
    if (open - mode.uncovered_s).abs() > ROUNDING {
        return Err(format!(
            "{name} is uncovered for {} s, its pieces without a way out take {} s",
            number(mode.uncovered_s),
            number(open)
        ));
    }
    if mode.not_attempted.is_some() && mode.pieces.iter().any(|piece| !is_open(piece)) {
        return Err(format!("it has a way out after {name}, and says that none was sought"));
    }
    for piece in &mode.pieces {
        let [from, to] = [piece.from_s, piece.to_s].map(number);
        let instants: Vec<f64> = match is_open(piece) {
            true if piece.branches.is_empty() => continue,
            false if piece.outcome == OUTCOMES[CAUGHT] && piece.branches.is_empty() => continue,
            true => return Err(format!("it names a way out after {name} from {from} to {to} s, where none was found")),
            false => {
                let known = format!("_{:.0}ms.csv", 1e3 * delay);
                let is_own = |branch: &&String| branch.starts_with(&format!("{name}_")) && branch.ends_with(&known);
                let own = piece.branches.iter().filter(is_own);
                let instants: Vec<f64> = own.filter_map(|branch| struck_at(branch)).collect();
                if instants.len() != piece.branches.len() {
                    return Err(format!(
                        "a way out from {from} to {to} s is not one after {name} that is known after {} ms",
                        number(1e3 * delay)
                    ));
                }
                instants
            }
        };
        if piece.site.is_some() != (piece.outcome == OUTCOMES[2]) {
            return Err(format!("after {name} from {from} to {to} s, it names a site and does not land at it"));
        }
        for flight in &piece.failed {
            let place = piece.branches.iter().position(|branch| *branch == flight.branch);
            let due = place.map(|at| {
                let before = if at == 0 { piece.from_s } else { instants[at - 1] };
                [before, instants.get(at + 1).copied().unwrap_or(piece.to_s)]
            });
            let counts = |[before, after]: [f64; 2]| {
                (flight.from_s - before).abs() <= NAMED && (flight.to_s - after).abs() <= NAMED
            };
            if !due.is_some_and(counts) {
                return Err(format!("the failed flight {} does not count for the time around it", flight.branch));
            }
        }
        // A search finds a way out at each of its instants, or ends the piece: it has one at both ends, and between
        // them no two neighbours are further apart than instants are.
        let ends = instants.first().zip(instants.last());
        let reaches = ends.is_some_and(|(a, b)| (a - piece.from_s).abs() <= NAMED && (b - piece.to_s).abs() <= NAMED);
        let is_dense = |pair: &[f64]| pair[0] < pair[1] + NAMED && pair[1] - pair[0] <= apart(duration) + NAMED;
        if !(reaches && instants.windows(2).all(is_dense)) {
            return Err(format!(
                "the ways out after {name} do not cover the time from {from} to {to} s, in which it has one"
            ));
        }
    }
    Ok(())
}
