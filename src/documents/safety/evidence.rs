//! What the report of `mavc plan --recovery` and the certificate say of each mode, compared with the spec: for which
//! part of the mission a fault has which outcome, and how that is known.

mod consistency;

use super::{SEVERITIES, heights};
use crate::certificate::{FamilyRecord, PlanClaim, WayRecord};
use crate::model::{Mission, Problem};
use crate::number::number;
use crate::recovery::RESOLUTION;
use crate::report::recovery::OUTCOMES;
use crate::verify::recovery::Covered;
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
    /// All ways out that the report names; a piece leaves out one that lies between failed ones.
    pub named: Vec<String>,
    /// How many flights failed after a fault at an instant for which the certificate proves a way out.
    pub failed_where_proved: usize,
    /// For how long the certificate proves ways out, whether their flights failed or not, s, over all modes.
    pub families_s: f64,
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
    /// The lowest and the highest height (z) of the plan, m.
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
    /// Whether the certificate proves a way out of this kind at every instant.
    pub is_proved: bool,
    pub branches: Vec<String>,
}

/// The part of a phase with one outcome that is known in one way.
#[derive(Debug, Clone, PartialEq)]
pub struct Share<'a> {
    /// An index into [`SEVERITIES`].
    pub outcome: usize,
    pub site: Option<&'a str>,
    /// Whether the certificate proves a way out of this kind at every instant.
    pub is_proved: bool,
    /// s
    pub seconds: f64,
    /// The ways out that begin in this part, as `mavc plan --branches` names their files.
    pub branches: Vec<&'a str>,
}

/// A way out that was found and whose simulated flight failed, an index into [`SEVERITIES`]. From
/// here on outcomes count as a loss of control.
pub const FAILED: usize = OUTCOMES.len() - 1;

/// The outcome of a fault without a way out, an index into [`SEVERITIES`].
pub const NONE: usize = FAILED + 1;

impl Evidence {
    /// For how long the certificate proves ways out, and for how long faults count as covered, s, over all modes.
    pub fn proved_and_covered(&self) -> [f64; 2] {
        let over_all = |of: fn(&ModeEvidence) -> f64| self.modes.iter().map(of).fold(0.0, |all, seconds| all + seconds);
        [over_all(ModeEvidence::proved), over_all(ModeEvidence::covered)]
    }
}

impl ModeEvidence {
    /// For how long a fault in this phase has each outcome, in the order of time, alike ones together.
    pub fn within(&self, phase: &Phase) -> Vec<Share<'_>> {
        let end = self.pieces.last().map_or(0.0, |piece| piece.to);
        let is_inside = |at: f64| phase.from <= at && (at < phase.to || phase.to >= end);
        let mut shares: Vec<Share<'_>> = Vec::new();
        for piece in &self.pieces {
            let [from, to] = [piece.from.max(phase.from), piece.to.min(phase.to)];
            if from >= to {
                continue;
            }
            let Piece { outcome, is_proved, .. } = *piece;
            let site = piece.site.as_deref();
            let names = piece.branches.iter().map(String::as_str);
            let branches = names.filter(|name| struck_at(name).is_none_or(is_inside));
            let alike = |share: &&mut Share| (share.outcome, share.site, share.is_proved) == (outcome, site, is_proved);
            match shares.iter_mut().find(alike) {
                Some(share) => {
                    share.seconds += to - from;
                    share.branches.extend(branches);
                }
                None => {
                    let (seconds, branches) = (to - from, branches.collect());
                    shares.push(Share { outcome, site, is_proved, seconds, branches });
                }
            }
        }
        shares
    }

    /// For how long a fault in this phase counts as a loss of control, s.
    pub fn uncovered_within(&self, phase: &Phase) -> f64 {
        self.within(phase).iter().filter(|share| share.outcome >= FAILED).fold(0.0, |all, share| all + share.seconds)
    }

    /// For how long a fault in this phase has no way out, s, where failed flights count as ways out.
    pub fn open_within(&self, phase: &Phase) -> f64 {
        self.within(phase).iter().filter(|share| share.outcome == NONE).fold(0.0, |all, share| all + share.seconds)
    }

    /// For how long a fault counts as a loss of control, s.
    pub fn uncovered(&self) -> f64 {
        self.with_outcome(FAILED) + self.with_outcome(NONE)
    }

    /// For how long a fault has an outcome, an index into [`SEVERITIES`], s.
    pub fn with_outcome(&self, outcome: usize) -> f64 {
        self.sum(|piece| piece.outcome == outcome)
    }

    /// For how long a fault counts as covered, s.
    pub fn covered(&self) -> f64 {
        self.sum(|piece| piece.outcome < FAILED)
    }

    /// For how long the certificate proves a way out at every instant, s.
    pub fn proved(&self) -> f64 {
        self.sum(|piece| piece.is_proved)
    }

    fn sum(&self, of: impl Fn(&Piece) -> bool) -> f64 {
        self.pieces.iter().filter(|piece| of(piece)).fold(0.0, |all, piece| all + piece.to - piece.from)
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
    uncovered: f64,
    weighted: bool,
    flown: usize,
    survived: usize,
    modes: Vec<ModeOutcomes>,
}

#[derive(Clone, Deserialize)]
struct ModeOutcomes {
    name: String,
    not_attempted: Option<String>,
    pieces: Vec<PieceOfReport>,
    uncovered_s: f64,
}

#[derive(Clone, Deserialize)]
struct PieceOfReport {
    from_s: f64,
    to_s: f64,
    outcome: String,
    site: Option<String>,
    branches: Vec<String>,
    #[serde(default)]
    failed: Vec<FailedFlight>,
}

#[derive(Clone, Deserialize)]
struct FailedFlight {
    branch: String,
    from_s: f64,
    to_s: f64,
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
const ROUNDING: f64 = 1e-6;

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
        let mut phases = phases(mission, &arrivals, duration)?;
        for phase in &mut phases {
            phase.heights = heights::of(&shown.plan.motion, phase.from, phase.to);
        }
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
        let phase =
            |kind, from, to| Phase { kind, waypoint: index + 1, name: name.clone(), from, to, heights: [f64::NAN; 2] };
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
        // Instants with different ways out may be this far apart; beside a time without one there is no hole.
        let is_between_ways = outcome < NONE && pieces.last().is_some_and(|before| before.outcome < NONE);
        let most = if is_between_ways { RESOLUTION } else { 0.0 };
        let is_next = piece.from_s >= reached - ROUNDING && piece.from_s <= reached + most + ROUNDING;
        if !(is_next && piece.to_s >= piece.from_s) {
            return Err(format!(
                "the outcomes of {name} do not follow each other: one ends at {} s, the next begins at {} s",
                number(reached),
                number(piece.from_s)
            ));
        }
        for part in parts(name, piece, outcome)? {
            // The outcome changes somewhere between two instants that were looked at: the worse one counts for all
            // of it.
            let from = match pieces.last_mut() {
                Some(Piece { to, outcome: earlier, .. }) if *earlier > part.outcome => {
                    *to = part.from;
                    part.from
                }
                _ => reached,
            };
            reached = part.to;
            pieces.push(Piece { from, ..part });
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
const NAMED: f64 = 1e-3;

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
