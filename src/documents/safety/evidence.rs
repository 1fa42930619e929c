//! What the report of `mavc plan --recovery` says of each mode, read from its JSON and compared with the spec: for
//! which part of the mission a fault has which outcome.

use super::SEVERITIES;
use crate::model::{Mission, Problem};
use crate::number::number;
use crate::recovery::RESOLUTION;
use serde::Deserialize;

/// The outcomes of all modes along a plan.
#[derive(Debug, Clone, PartialEq)]
pub struct Evidence {
    /// The duration of the plan, s.
    pub duration: f64,
    /// Legs and holds, in the order of time; they follow each other without gaps, from 0 to the end of the plan.
    pub phases: Vec<Phase>,
    /// In the order of the model's modes.
    pub modes: Vec<ModeEvidence>,
    /// How long after it a fault is known, s: one delay, or the shortest and the longest.
    pub detection: Vec<f64>,
    /// The longest time of a way out, s.
    pub within: f64,
    /// Pairs of a mode and an instant that were looked at.
    pub instants: usize,
    /// Ways out that were flown in simulation, and how many of them ended as planned.
    pub flown: usize,
    pub survived: usize,
}

/// A leg of the mission, or a hold.
#[derive(Debug, Clone, PartialEq)]
pub struct Phase {
    /// `leg` to a waypoint or `hold` at one.
    pub kind: PhaseKind,
    /// The waypoint's number, from 1, and its name.
    pub waypoint: usize,
    pub name: Option<String>,
    /// s since the start of the plan.
    pub from: f64,
    pub to: f64,
    /// Heights of the waypoints at its ends, m.
    pub heights: [f64; 2],
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PhaseKind {
    Leg,
    Hold,
}

impl Phase {
    /// `leg to 3 (south)`, `hold at 3 (south)`
    pub fn label(&self) -> String {
        let name = self.name.as_ref().map(|name| format!(" ({name})")).unwrap_or_default();
        match self.kind {
            PhaseKind::Leg => format!("leg to {}{name}", self.waypoint),
            PhaseKind::Hold => format!("hold at {}{name}", self.waypoint),
        }
    }

    /// `leg-3`, `hold-3`: a part of a name in files.
    pub fn tag(&self) -> String {
        let kind = match self.kind {
            PhaseKind::Leg => "leg",
            PhaseKind::Hold => "hold",
        };
        format!("{kind}-{}", self.waypoint)
    }
}

/// The outcomes of one mode.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeEvidence {
    /// Why no way out was sought, if none was.
    pub not_attempted: Option<String>,
    pub pieces: Vec<Piece>,
}

/// A time with one outcome.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    pub from: f64,
    pub to: f64,
    /// An index into [`SEVERITIES`].
    pub outcome: usize,
    pub site: Option<String>,
    pub branches: Vec<String>,
}

/// The part of a phase with one outcome.
#[derive(Debug, Clone, PartialEq)]
pub struct Share<'a> {
    /// An index into [`SEVERITIES`].
    pub outcome: usize,
    pub site: Option<&'a str>,
    /// s
    pub seconds: f64,
    /// The ways out that begin in this part, as `mavc plan --branches` names their files.
    pub branches: Vec<&'a str>,
}

/// The outcome of a fault without a way out, an index into [`SEVERITIES`].
pub const NONE: usize = SEVERITIES.len() - 1;

impl ModeEvidence {
    /// For how long a fault in this phase has each outcome, in the order of time, alike ones together.
    pub fn within(&self, phase: &Phase) -> Vec<Share<'_>> {
        let mut shares: Vec<Share<'_>> = Vec::new();
        for piece in &self.pieces {
            let [from, to] = [piece.from.max(phase.from), piece.to.min(phase.to)];
            if from >= to {
                continue;
            }
            let site = piece.site.as_deref();
            let is_inside = |name: &&str| struck_at(name).is_none_or(|at| from <= at && at < to);
            let branches = piece.branches.iter().map(String::as_str).filter(is_inside);
            match shares.iter_mut().find(|share| share.outcome == piece.outcome && share.site == site) {
                Some(share) => {
                    share.seconds += to - from;
                    share.branches.extend(branches);
                }
                None => {
                    let branches = branches.collect();
                    shares.push(Share { outcome: piece.outcome, site, seconds: to - from, branches });
                }
            }
        }
        shares
    }

    /// For how long a fault in this phase has no way out, s.
    pub fn uncovered_within(&self, phase: &Phase) -> f64 {
        self.within(phase).iter().filter(|share| share.outcome == NONE).fold(0.0, |all, share| all + share.seconds)
    }

    /// For how long there is no way out, s.
    pub fn uncovered(&self) -> f64 {
        self.with_outcome(NONE)
    }

    /// For how long a fault has an outcome, an index into [`SEVERITIES`], s.
    pub fn with_outcome(&self, outcome: usize) -> f64 {
        self.pieces.iter().filter(|piece| piece.outcome == outcome).fold(0.0, |all, piece| all + piece.to - piece.from)
    }
}

/// The instant of the fault in the name of a branch: 12.5 of `M1_12.500s_200ms.csv`.
fn struck_at(name: &str) -> Option<f64> {
    name.rsplit('_').nth(1)?.strip_suffix('s')?.parse().ok()
}

/// The parts of the report that are read.
#[derive(Deserialize)]
struct Report {
    spec_sha256: String,
    planners: Vec<Planner>,
    recovery: Option<Recovery>,
}

#[derive(Deserialize)]
struct Planner {
    time_s: Option<f64>,
    #[serde(default)]
    waypoints: Vec<Waypoint>,
}

#[derive(Deserialize)]
struct Waypoint {
    at_s: f64,
}

#[derive(Deserialize)]
struct Recovery {
    detection_s: Vec<f64>,
    within_s: f64,
    instants: usize,
    flown: usize,
    survived: usize,
    modes: Vec<ModeOutcomes>,
}

#[derive(Deserialize)]
struct ModeOutcomes {
    name: String,
    not_attempted: Option<String>,
    pieces: Vec<PieceOfReport>,
}

#[derive(Deserialize)]
struct PieceOfReport {
    from_s: f64,
    to_s: f64,
    outcome: String,
    site: Option<String>,
    branches: Vec<String>,
}

/// By how much times in a report may differ from those that they must equal, s: rounding of a sum of pieces.
const ROUNDING: f64 = 1e-6;

impl Evidence {
    /// Reads a report, and compares it with the spec that it must be about.
    ///
    /// # Errors
    /// What is wrong with it: it is not a report with ways out, it is that of another spec, or it names modes, sites or
    /// times that the spec does not have.
    pub fn read(problem: Problem, spec_sha256: &str, report: &[u8]) -> Result<Self, String> {
        let (model, mission) = (problem.model(), problem.mission());
        let report: Report = serde_json::from_slice(report)
            .map_err(|e| format!("it is not a report of `mavc plan --recovery --report`: {e}"))?;
        if report.spec_sha256 != spec_sha256 {
            return Err("it is the report of another spec: plan this spec again".into());
        }
        let plan = report.planners.last().and_then(|planner| Some((planner.time_s?, &planner.waypoints)));
        let (duration, waypoints) = plan.ok_or("it has no plan")?;
        let recovery = report.recovery.ok_or("it has no ways out: write it with `mavc plan --recovery`")?;
        if waypoints.len() != mission.waypoints.len() {
            return Err("its waypoints are not those of the spec".into());
        }
        let arrivals: Vec<f64> = waypoints.iter().map(|waypoint| waypoint.at_s).collect();
        let phases = phases(mission, &arrivals, duration)?;
        let names: Vec<&str> = recovery.modes.iter().map(|mode| mode.name.as_str()).collect();
        if !names.iter().copied().eq(model.modes.iter().map(|mode| mode.name.as_str())) {
            return Err(format!("its modes, {}, are not those of the spec", names.join(", ")));
        }
        let modes = recovery.modes.into_iter().map(|mode| of_mode(mission, mode, duration));
        Ok(Evidence {
            duration,
            phases,
            modes: modes.collect::<Result<_, _>>()?,
            detection: recovery.detection_s,
            within: recovery.within_s,
            instants: recovery.instants,
            flown: recovery.flown,
            survived: recovery.survived,
        })
    }
}

/// Legs and holds between the arrivals at waypoints.
fn phases(mission: &Mission, arrivals: &[f64], duration: f64) -> Result<Vec<Phase>, String> {
    let mut phases = Vec::new();
    let mut reached = 0.0;
    for (index, (waypoint, &arrival)) in mission.waypoints.iter().zip(arrivals).enumerate() {
        let height = |index: usize| mission.waypoints[index].position[2];
        let phase = |kind, from: f64, to: f64, heights| Phase {
            kind,
            waypoint: index + 1,
            name: waypoint.name.clone(),
            from,
            to,
            heights,
        };
        if !(arrival >= reached - ROUNDING && arrival <= duration + ROUNDING) {
            return Err(format!("it reaches waypoint {} at {} s, out of order", index + 1, number(arrival)));
        }
        if index > 0 {
            phases.push(phase(PhaseKind::Leg, reached, arrival, [height(index - 1), height(index)]));
        }
        reached = arrival;
        if waypoint.hold > 0.0 {
            let end = if index + 1 == arrivals.len() { duration } else { arrival + waypoint.hold };
            phases.push(phase(PhaseKind::Hold, arrival, end, [height(index); 2]));
            reached = end;
        }
    }
    match (reached - duration).abs() <= ROUNDING {
        true => Ok(phases),
        false => Err(format!("its waypoints end at {} s, its plan at {} s", number(reached), number(duration))),
    }
}

/// The outcomes of one mode.
fn of_mode(mission: &Mission, found: ModeOutcomes, duration: f64) -> Result<ModeEvidence, String> {
    let name = &found.name;
    let mut pieces: Vec<Piece> = Vec::with_capacity(found.pieces.len());
    let mut reached = 0.0;
    for piece in found.pieces {
        let word = piece.outcome.as_str();
        let outcome = SEVERITIES.iter().position(|(known, ..)| *known == word);
        let outcome = outcome.ok_or_else(|| format!("it has the unknown outcome `{word}` for {name}"))?;
        let sites = &mission.after_fault.sites;
        if let Some(site) = piece.site.iter().find(|site| sites.iter().all(|known| known.name != **site)) {
            return Err(format!("it lands {name} at `{site}`, which is not a landing site of the spec"));
        }
        let is_next = piece.from_s >= reached - ROUNDING && piece.from_s <= reached + RESOLUTION + ROUNDING;
        if !(is_next && piece.to_s >= piece.from_s) {
            return Err(format!("the outcomes of {name} do not follow each other at {} s", number(piece.from_s)));
        }
        // The outcome changes somewhere between two instants that were looked at: the worse one counts for all of it.
        let from = match pieces.last_mut() {
            Some(Piece { to, outcome: earlier, .. }) if *earlier > outcome => {
                *to = piece.from_s;
                piece.from_s
            }
            _ => reached,
        };
        reached = piece.to_s;
        let PieceOfReport { to_s: to, site, branches, .. } = piece;
        pieces.push(Piece { from, to, outcome, site, branches });
    }
    match (reached - duration).abs() <= ROUNDING {
        true => Ok(ModeEvidence { not_attempted: found.not_attempted, pieces }),
        false => {
            Err(format!("the outcomes of {name} end at {} s, the plan at {} s", number(reached), number(duration),))
        }
    }
}
