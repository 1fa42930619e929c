//! What the report of `mavc plan --recovery` and the certificate say of each mode, compared with the spec: for which
//! part of the mission a fault has which outcome, and how that is known.

mod consistency;
mod reading;

use super::heights;
use super::quantities::largest_share;
use crate::certificate::MotionRecord;
use crate::report::recovery::OUTCOMES;
pub use reading::Shown;

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
    /// The motion of the plan.
    pub motion: MotionRecord,
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
    /// An index into [`SEVERITIES`](super::SEVERITIES).
    pub outcome: usize,
    pub site: Option<String>,
    /// Whether the certificate proves a way out of this kind at every instant.
    pub is_proved: bool,
    pub branches: Vec<String>,
}

impl Piece {
    /// The ways out at instants in a part of its time, and at those next to it on both sides.
    fn around(&self, [from, to]: [f64; 2]) -> impl Iterator<Item = &str> {
        let instants = || self.branches.iter().filter_map(|name| struck_at(name));
        let low = instants().filter(|at| *at <= from).fold(f64::NEG_INFINITY, f64::max);
        let high = instants().filter(|at| *at >= to).fold(f64::INFINITY, f64::min);
        let names = self.branches.iter().map(String::as_str);
        names.filter(move |name| struck_at(name).is_none_or(|at| low <= at && at <= high))
    }
}

/// The part of a phase with one outcome that is known in one way.
#[derive(Debug, Clone, PartialEq)]
pub struct Share<'a> {
    /// An index into [`SEVERITIES`](super::SEVERITIES).
    pub outcome: usize,
    pub site: Option<&'a str>,
    /// Whether the certificate proves a way out of this kind at every instant.
    pub is_proved: bool,
    /// When, s since the start of the plan, ascending.
    pub times: Vec<[f64; 2]>,
    /// The ways out in this part and at the instants next to it, as `mavc plan --branches` names their files.
    pub branches: Vec<&'a str>,
}

impl Share<'_> {
    /// For how long, s.
    pub fn seconds(&self) -> f64 {
        self.times.iter().fold(0.0, |all, [from, to]| all + to - from)
    }
}

/// A vehicle that is caught and lands, in simulated flights, an index into [`SEVERITIES`](super::SEVERITIES).
pub const CAUGHT: usize = FAILED - 1;

/// A way out that was found and whose simulated flight failed, an index into [`SEVERITIES`](super::SEVERITIES). From
/// here on outcomes count as a loss of control.
pub const FAILED: usize = OUTCOMES.len() - 1;

/// The outcome of a fault without a way out, an index into [`SEVERITIES`](super::SEVERITIES).
pub const NONE: usize = FAILED + 1;

impl Evidence {
    /// For how long the certificate proves ways out, and for how long faults count as covered, s, over all modes.
    pub fn proved_and_covered(&self) -> [f64; 2] {
        let over_all = |of: fn(&ModeEvidence) -> f64| self.modes.iter().map(of).fold(0.0, |all, seconds| all + seconds);
        [over_all(ModeEvidence::proved), over_all(ModeEvidence::covered)]
    }

    /// The largest share of simulated flights that fail, at 95 % confidence.
    pub fn largest_share_of_failures(&self) -> f64 {
        largest_share(self.flown - self.survived, self.flown)
    }

    /// The lowest and the highest height (z) of the plan at these times, m.
    pub fn heights(&self, times: impl Iterator<Item = [f64; 2]>) -> [f64; 2] {
        let all = times.map(|[from, to]| heights::of(&self.motion, from, to));
        all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], [a, b]| [low.min(a), high.max(b)])
    }
}

impl ModeEvidence {
    /// For how long a fault in this phase has each outcome, in the order of time, alike ones together.
    pub fn within(&self, phase: &Phase) -> Vec<Share<'_>> {
        let mut shares: Vec<Share<'_>> = Vec::new();
        for piece in &self.pieces {
            let [from, to] = [piece.from.max(phase.from), piece.to.min(phase.to)];
            if from >= to {
                continue;
            }
            let Piece { outcome, is_proved, .. } = *piece;
            let site = piece.site.as_deref();
            let branches = piece.around([from, to]);
            let alike = |share: &&mut Share| (share.outcome, share.site, share.is_proved) == (outcome, site, is_proved);
            match shares.iter_mut().find(alike) {
                Some(share) => {
                    share.times.push([from, to]);
                    share.branches.extend(branches);
                }
                None => {
                    let (times, branches) = (vec![[from, to]], branches.collect());
                    shares.push(Share { outcome, site, is_proved, times, branches });
                }
            }
        }
        shares
    }

    /// For how long a fault in this phase counts as a loss of control, s.
    pub fn uncovered_within(&self, phase: &Phase) -> f64 {
        self.within(phase).iter().filter(|share| share.outcome >= FAILED).fold(0.0, |all, share| all + share.seconds())
    }

    /// For how long a fault in this phase has no way out, s, where failed flights count as ways out.
    pub fn open_within(&self, phase: &Phase) -> f64 {
        self.within(phase).iter().filter(|share| share.outcome == NONE).fold(0.0, |all, share| all + share.seconds())
    }

    /// For how long a fault counts as a loss of control, s.
    pub fn uncovered(&self) -> f64 {
        self.with_outcome(FAILED) + self.with_outcome(NONE)
    }

    /// For how long a fault has an outcome, an index into [`SEVERITIES`](super::SEVERITIES), s.
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
