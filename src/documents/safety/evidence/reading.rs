//! Reads the report, and the ways out that the certificate proves.

use super::{Evidence, FAILED, ModeEvidence, NONE, Phase, PhaseKind, Piece, consistency, struck_at};
use crate::certificate::{FamilyRecord, PlanClaim, WayRecord};
use crate::model::{Mission, Problem};
use crate::number::number;
use crate::report::recovery::OUTCOMES;
use crate::safety::SEVERITIES;
use crate::verify::recovery::Covered;
use serde::Deserialize;

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
pub(super) struct Recovery {
    pub detection_s: Vec<f64>,
    pub within_s: f64,
    pub instants: usize,
    pub uncovered: f64,
    pub weighted: bool,
    pub flown: usize,
    pub survived: usize,
    pub modes: Vec<ModeOutcomes>,
}

#[derive(Clone, Deserialize)]
pub(super) struct ModeOutcomes {
    pub name: String,
    pub not_attempted: Option<String>,
    pub pieces: Vec<PieceOfReport>,
    pub uncovered_s: f64,
}

#[derive(Clone, Deserialize)]
pub(super) struct PieceOfReport {
    pub from_s: f64,
    pub to_s: f64,
    pub outcome: String,
    pub site: Option<String>,
    pub branches: Vec<String>,
    #[serde(default)]
    pub failed: Vec<FailedFlight>,
}

#[derive(Clone, Deserialize)]
pub(super) struct FailedFlight {
    pub branch: String,
    pub from_s: f64,
    pub to_s: f64,
}

/// What the certificate shows: of it, the plan, and the ways out that the checker accepts.
pub struct Shown<'a> {
    pub plan: &'a PlanClaim,
    pub ways_out: &'a [Covered],
}

impl Shown<'_> {
    /// The families of a mode that the checker accepts.
    fn families(&self, mode: &str) -> Vec<&FamilyRecord> {
        let covered = self.ways_out.iter().filter(|covered| covered.mode == mode);
        let instants: Vec<[f64; 2]> = covered.flat_map(|covered| covered.instants.iter().copied()).collect();
        let of_mode = self.plan.recovery.iter().flat_map(|claim| &claim.families).filter(|family| family.mode == mode);
        of_mode.filter(|family| instants.contains(&[family.from_s, family.to_s])).collect()
    }
}

/// By how much times in a report may differ from those that they must equal, s: rounding of a sum of pieces.
pub(super) const ROUNDING: f64 = 1e-6;

impl Evidence {
    /// Reads a report, and compares it with the spec that it must be about. `shown` is of a certificate of its plan.
    ///
    /// # Errors
    /// What is wrong with it: it is not a report with ways out, it is that of another spec, it contradicts the spec,
    /// the certificate or itself (its `consistency`), or it does not name the flights that failed.
    pub fn read(problem: Problem, spec_sha256: &str, report: &[u8], shown: &Shown) -> Result<Self, String> {
        let (model, mission) = (problem.model(), problem.mission());
        let report: Report = serde_json::from_slice(report)
            .map_err(|e| format!("it is not a report of `mavc plan --recovery --report`: {e}"))?;
        if report.spec_sha256 != spec_sha256 {
            return Err("it is the report of another spec: plan this spec again".into());
        }
        let plan = report.planners.last().and_then(|planner| Some((planner.time_s?, &planner.waypoints)));
        let (reported, waypoints) = plan.ok_or("it has no plan")?;
        let recovery = report.recovery.ok_or("it has no ways out: write it with `mavc plan --recovery`")?;
        let arrivals: Vec<f64> = waypoints.iter().map(|waypoint| waypoint.at_s).collect();
        let (duration, arrivals) = consistency::times(&shown.plan.motion, mission, reported, &arrivals)?;
        let phases = phases(mission, &arrivals, duration)?;
        let names: Vec<&str> = recovery.modes.iter().map(|mode| mode.name.as_str()).collect();
        if !names.iter().copied().eq(model.modes.iter().map(|mode| mode.name.as_str())) {
            return Err(format!("its modes, {}, are not those of the spec", names.join(", ")));
        }
        let failed: usize = recovery.modes.iter().flat_map(|mode| &mode.pieces).map(|piece| piece.failed.len()).sum();
        if recovery.survived + failed != recovery.flown {
            return Err("it does not name every simulated flight that failed: plan this spec again".into());
        }
        let failed_where_proved = recovery.modes.iter().map(|mode| failed_within(mode, &shown.families(&mode.name)));
        let failed_where_proved = failed_where_proved.sum();
        let of_mode = |mode: ModeOutcomes| {
            let families = shown.families(&mode.name);
            of_mode(mission, mode, duration).map(|mode| proved(mode, &families))
        };
        let modes = recovery.modes.iter().cloned().map(of_mode).collect::<Result<_, _>>()?;
        consistency::ways_out(model, &recovery, duration)?;
        Ok(Evidence {
            duration,
            phases,
            modes,
            detection: recovery.detection_s,
            within: recovery.within_s,
            instants: recovery.instants,
            flown: recovery.flown,
            survived: recovery.survived,
            named: recovery.modes.into_iter().flat_map(|mode| mode.pieces).flat_map(|piece| piece.branches).collect(),
            failed_where_proved,
            families_s: shown.ways_out.iter().map(|covered| covered.seconds).fold(0.0, |all, seconds| all + seconds),
            motion: shown.plan.motion.clone(),
        })
    }
}

/// How many flights of a mode failed after a fault at an instant that one of these families has.
fn failed_within(mode: &ModeOutcomes, families: &[&FamilyRecord]) -> usize {
    let is_within = |at: f64| families.iter().any(|family| (family.from_s - NAMED..=family.to_s + NAMED).contains(&at));
    let failed = mode.pieces.iter().flat_map(|piece| &piece.failed);
    failed.filter(|flight| struck_at(&flight.branch).is_some_and(is_within)).count()
}

/// Legs and holds between the arrivals at waypoints.
fn phases(mission: &Mission, arrivals: &[f64], duration: f64) -> Result<Vec<Phase>, String> {
    let mut phases = Vec::new();
    let mut reached = 0.0;
    for (index, (waypoint, &arrival)) in mission.waypoints.iter().zip(arrivals).enumerate() {
        let name = &waypoint.name;
        let phase = |kind, from, to| Phase { kind, waypoint: index + 1, name: name.clone(), from, to };
        if !(arrival >= reached - ROUNDING && arrival <= duration + ROUNDING) {
            return Err(format!("it reaches waypoint {} at {} s, out of order", index + 1, number(arrival)));
        }
        if index > 0 {
            phases.push(phase(PhaseKind::Leg, reached, arrival));
        }
        reached = arrival;
        if waypoint.hold > 0.0 {
            let end = if index + 1 == arrivals.len() { duration } else { arrival + waypoint.hold };
            phases.push(phase(PhaseKind::Hold, arrival, end));
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
        let outcome = OUTCOMES.iter().position(|known| *known == word);
        let outcome = outcome.ok_or_else(|| format!("it has the unknown outcome `{word}` for {name}"))?;
        let outcome = if outcome < FAILED { outcome } else { NONE };
        let sites = &mission.after_fault.sites;
        if let Some(site) = piece.site.iter().find(|site| sites.iter().all(|known| known.name != **site)) {
            return Err(format!("it lands {name} at `{site}`, which is not a landing site of the spec"));
        }
        if !((piece.from_s - reached).abs() <= ROUNDING && piece.to_s >= piece.from_s) {
            return Err(format!(
                "the outcomes of {name} do not follow each other: one ends at {} s, the next begins at {} s",
                number(reached),
                number(piece.from_s)
            ));
        }
        for part in parts(name, piece, outcome)? {
            pieces.push(Piece { from: reached, ..part });
            reached = part.to;
        }
    }
    match (reached - duration).abs() <= ROUNDING {
        true => Ok(ModeEvidence { not_attempted: found.not_attempted, pieces }),
        false => {
            Err(format!("the outcomes of {name} end at {} s, the plan at {} s", number(reached), number(duration),))
        }
    }
}

/// By how much the instant in the name of a branch may be off, s: it has three decimals.
pub(super) const NAMED: f64 = 1e-3;

/// A piece of the report, divided where flights failed.
fn parts(mode: &str, piece: PieceOfReport, outcome: usize) -> Result<Vec<Piece>, String> {
    let PieceOfReport { from_s, to_s, site, branches, failed, .. } = piece;
    let part = |from, to, outcome| Piece { from, to, outcome, site: site.clone(), is_proved: false, branches: vec![] };
    let mut parts: Vec<Piece> = Vec::new();
    let mut reached = from_s;
    for FailedFlight { branch, from_s: from, to_s: to } in failed {
        let follows = parts.last().is_none_or(|before| before.from <= from);
        if !(follows && outcome < NONE && from_s <= from && from <= to && to <= to_s && branches.contains(&branch)) {
            return Err(format!("the failed flight {branch} of {mode} is not one of its piece"));
        }
        match parts.last_mut().filter(|before| before.to >= from) {
            Some(before) => {
                before.to = before.to.max(to);
                before.branches.push(branch);
            }
            None => {
                if reached < from {
                    parts.push(part(reached, from, outcome));
                }
                parts.push(Piece { branches: vec![branch], ..part(from, to, FAILED) });
            }
        }
        reached = reached.max(to);
    }
    if reached < to_s || parts.is_empty() {
        parts.push(part(reached, to_s, outcome));
    }
    let named: Vec<String> = parts.iter().flat_map(|part| part.branches.iter().cloned()).collect();
    for branch in branches.into_iter().filter(|branch| !named.contains(branch)) {
        let at = struck_at(&branch);
        let holds = |part: &&mut Piece| {
            part.outcome != FAILED && at.is_none_or(|at| part.from - NAMED <= at && at <= part.to + NAMED)
        };
        if let Some(part) = parts.iter_mut().find(holds) {
            part.branches.push(branch);
        }
    }
    Ok(parts)
}

/// Divides the pieces of a mode where families of the same way out prove them.
fn proved(mode: ModeEvidence, families: &[&FamilyRecord]) -> ModeEvidence {
    let mut pieces: Vec<Piece> = Vec::new();
    for mut piece in mode.pieces {
        let word = SEVERITIES[piece.outcome].0;
        let leads = |way: &WayRecord| match way {
            WayRecord::Continue => word == "continue",
            WayRecord::LandAt(site) => piece.site.as_ref() == Some(site),
            WayRecord::LandHere => word == "land here",
        };
        // Families of the same instants, for several delays, all have to lead there.
        let is_proved = |instants: &[f64; 2]| {
            let mut alike = families.iter().filter(|family| [family.from_s, family.to_s] == *instants);
            piece.outcome < FAILED && alike.all(|family| leads(&family.way))
        };
        let mut instants: Vec<[f64; 2]> = families.iter().map(|family| [family.from_s, family.to_s]).collect();
        instants.dedup();
        instants.retain(is_proved);
        let (mut reached, mut parts) = (piece.from, Vec::new());
        for [from, to] in instants {
            let [from, to] = [from.max(piece.from), to.min(piece.to)];
            if from >= to {
                continue;
            }
            match parts.last_mut() {
                Some(Piece { to: end, is_proved: true, .. }) if *end == from => *end = to,
                _ => {
                    if reached < from {
                        parts.push(Piece { from: reached, to: from, branches: vec![], ..piece.clone() });
                    }
                    parts.push(Piece { from, to, is_proved: true, branches: vec![], ..piece.clone() });
                }
            }
            reached = to;
        }
        if reached < piece.to || parts.is_empty() {
            parts.push(Piece { from: reached, branches: vec![], ..piece.clone() });
        }
        for branch in std::mem::take(&mut piece.branches) {
            let at = struck_at(&branch);
            let last = parts.len() - 1;
            let place = parts.iter().position(|part| at.is_none_or(|at| at <= part.to + NAMED)).unwrap_or(last);
            parts[place].branches.push(branch);
        }
        pieces.extend(parts);
    }
    ModeEvidence { pieces, ..mode }
}
