//! What can be done after a fault: its record, its files, and in `screen` the text for a terminal.

mod screen;

use super::trajectory_csv;
use crate::model::{Model, Problem};
use crate::motion::Trajectory;
use crate::number::{percent, significant};
use crate::recovery::flown::flight_seed;
use crate::recovery::{Families, FoundBranch, ModeRecovery, NotAttempted, Piece, Recovery, Way};
use serde::Serialize;

pub use screen::{premise, sentence, write};

/// What can be done after each fault, at the instants that were looked at. Nothing is claimed between them.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct RecoveryRecord {
    /// How long after it a fault is known, s: one delay, or the shortest and the longest. There is a branch for each.
    #[cfg_attr(test, schemars(length(min = 1, max = 2)))]
    pub detection_s: Vec<f64>,
    /// The longest time of a branch, s.
    pub within_s: f64,
    /// How the outcomes were found: at instants, each with branches that were checked at the instants of their grids;
    /// `caught` by simulated flights.
    #[cfg_attr(test, schemars(extend("const" = BASIS)))]
    pub basis: &'static str,
    /// The number of pairs of a mode and an instant that were looked at.
    pub instants: usize,
    /// The share of the time without a way out over all modes, weighted with their rates if all have one.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub uncovered: f64,
    /// Whether `uncovered` is weighted with rates.
    pub weighted: bool,
    /// The number of branches for the longest delay, each of which was flown once by simulation, with the noise and
    /// gusts of `simulate`.
    pub flown: usize,
    /// How many of these flights ended as planned.
    pub survived: usize,
    /// With `require uncovered`: the largest share that it allows.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub required: Option<f64>,
    /// If the mission was planned again because `require uncovered` did not hold: how.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub replanned: Option<ReplannedRecord>,
    /// If the spec fixes the mission time and `require uncovered` does not hold: a longer time that was tried and
    /// leaves less. Omitted if there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub longer: Option<LongerRecord>,
    /// Every declared mode, in their order.
    pub modes: Vec<ModeRecoveryRecord>,
}

/// How a plan with ways out differs from the one planned first.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ReplannedRecord {
    /// The share of each set that the plan keeps, at least the spec's reserve.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub reserve: f64,
    /// The mission time of this plan less that of the first, s.
    pub price_s: f64,
    /// The mission time of the plan found first, s.
    pub time_before_s: f64,
    /// The share of the time without a way out of the plan found first.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub uncovered_before: f64,
}

impl ReplannedRecord {
    /// `Planned again for ways out, with 12 % in reserve instead of 10 %: the time is the same. Before, 4.18 % had
    /// none.`
    fn sentence(&self, reserve: f64) -> String {
        let price = match self.price_s {
            price if price.abs() < 5e-3 => "the time is the same".to_string(),
            price => format!("{} s ({}) longer", significant(price, 3), percent(price / self.time_before_s)),
        };
        format!(
            "Planned again for ways out, with {} in reserve instead of {}: {price}. Before, {} had none.",
            percent(self.reserve),
            percent(reserve),
            percent(self.uncovered_before)
        )
    }
}

/// A plan in more time than the spec fixes.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LongerRecord {
    /// Mission time, s.
    #[cfg_attr(test, schemars(extend("exclusiveMinimum" = 0)))]
    pub time_s: f64,
    /// The share of the time without a way out.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub uncovered: f64,
}

impl LongerRecord {
    /// `A plan was found that takes 21 s instead of 20 s and leaves 0 % without a way out.`
    fn sentence(&self, duration: f64) -> String {
        let [time, instead] = [self.time_s, duration].map(|t| significant(t, 4));
        let left = percent(self.uncovered);
        format!("A plan was found that takes {time} s instead of {instead} s and leaves {left} without a way out.")
    }
}

/// The value of [`RecoveryRecord::basis`].
pub const BASIS: &str = "checked at instants";

/// The outcomes of the faults of one mode.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ModeRecoveryRecord {
    /// The name of the mode.
    pub name: String,
    /// Why no way out was sought: `no hover`, hover has no margin inside the mode's set; `caught`, the vehicle has to
    /// be caught, and the spec has no ground or no landing among the ways out. Omitted if one was sought.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, schemars(extend("enum" = ["no hover", "caught"])))]
    pub not_attempted: Option<&'static str>,
    /// In the order of time.
    pub pieces: Vec<PieceRecord>,
    /// For how long there is no way out, s.
    pub uncovered_s: f64,
    /// For how long a way out is proved at every instant, as the certificate shows, s. Omitted without --certificate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub proved_s: Option<f64>,
}

/// A time during which the faults of a mode have one outcome.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PieceRecord {
    /// s since the start of the plan.
    pub from_s: f64,
    /// s since the start of the plan.
    pub to_s: f64,
    /// `none` where none was found.
    #[cfg_attr(test, schemars(extend("enum" = OUTCOMES)))]
    pub outcome: &'static str,
    /// The landing site of `land at site`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub site: Option<String>,
    /// The branch in the middle of the piece, a file name of `--branches`; null if there is none, as for `caught`.
    pub branch: Option<String>,
    /// All branches of the piece.
    pub branches: Vec<String>,
    /// Those whose simulated flight did not end as planned. Omitted if all did.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub failed: Vec<FailedFlightRecord>,
    /// Of a gap, if there is one: a landing site that is reached from its middle in more time than is allowed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub near_miss: Option<NearMissRecord>,
}

/// A branch whose simulated flight did not end as planned, and the time for which it counts: to the instants before and
/// after it, or to the ends of the piece.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct FailedFlightRecord {
    /// The branch.
    pub branch: String,
    /// s since the start of the plan.
    pub from_s: f64,
    /// s since the start of the plan.
    pub to_s: f64,
}

/// A landing that takes longer than is allowed.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct NearMissRecord {
    /// The name of the landing site.
    pub site: String,
    /// When the fault strikes, s since the start of the plan.
    pub fault_s: f64,
    /// The time from the fault's detection to the touchdown in which a landing was found, s.
    pub takes_s: f64,
}

/// The words of outcomes.
pub const OUTCOMES: [&str; 6] = ["continue", "continue spinning", "land at site", "land here", "caught", "none"];

/// The words for people, in the order of [`OUTCOMES`].
pub const WORDS: [&str; 6] = [
    "back on the plan",
    "back on the plan, spinning",
    "lands at a site",
    "lands where it is",
    "caught, lands",
    "none found",
];

/// The word of an outcome.
pub(super) fn outcome(way: Option<Way>) -> &'static str {
    match way {
        Some(Way::Continue) => OUTCOMES[0],
        Some(Way::ContinueSpinning) => OUTCOMES[1],
        Some(Way::LandAt(_)) => OUTCOMES[2],
        Some(Way::LandHere) => OUTCOMES[3],
        Some(Way::Caught) => OUTCOMES[4],
        None => OUTCOMES[5],
    }
}

/// The share of the time without a way out over all modes, and whether it is weighted with their rates.
pub fn uncovered(model: &Model, recovery: &Recovery) -> (f64, bool) {
    let rates: Option<Vec<f64>> = model.modes.iter().map(|mode| mode.rate).collect();
    let weighted = rates.as_ref().is_some_and(|rates| rates.iter().sum::<f64>() > 0.0);
    let weight = |mode: usize| rates.as_ref().filter(|_| weighted).map_or(1.0, |rates| rates[mode]);
    let all: f64 = recovery.modes.iter().map(|mode| weight(mode.mode) * recovery.duration).sum();
    let open = recovery.modes.iter().fold(0.0, |sum, mode| sum + weight(mode.mode) * mode.uncovered());
    (if all > 0.0 { open / all } else { 0.0 }, weighted)
}

/// The name of a landing site; empty without a mission.
fn site_name(model: &Model, site: usize) -> &str {
    model.mission.as_ref().and_then(|mission| mission.after_fault.sites.get(site)).map_or("", |site| &site.name)
}

/// The name of the landing site of a way out that leads to one.
pub(super) fn site_of(model: &Model, way: Way) -> Option<&str> {
    match way {
        Way::LandAt(site) => Some(site_name(model, site)),
        Way::Continue | Way::ContinueSpinning | Way::LandHere | Way::Caught => None,
    }
}

/// `M1_12.50s_200ms`: mode, instant of the fault, delay.
fn branch_name(model: &Model, branch: &FoundBranch) -> String {
    let FoundBranch { mode, fault_at, delay, .. } = branch;
    format!("{}_{fault_at:.3}s_{:.0}ms", model.modes[*mode].name, 1e3 * delay)
}

impl RecoveryRecord {
    pub fn new(model: &Model, recovery: &Recovery) -> Self {
        let (uncovered, weighted) = uncovered(model, recovery);
        let name = |index: &usize| branch_name(model, &recovery.branches[*index]) + ".csv";
        let site = |way: Option<Way>| way.and_then(|way| site_of(model, way)).map(String::from);
        let piece = |piece: &Piece| PieceRecord {
            from_s: piece.from,
            to_s: piece.to,
            outcome: outcome(piece.way),
            site: site(piece.way),
            branch: piece.branches.get(piece.branches.len() / 2).map(name),
            branches: piece.branches.iter().map(name).collect(),
            failed: failed(recovery, piece)
                .map(|(index, from_s, to_s)| FailedFlightRecord { branch: name(&index), from_s, to_s })
                .collect(),
            near_miss: piece.near_miss.map(|miss| NearMissRecord {
                site: site_name(model, miss.site).into(),
                fault_s: miss.at,
                takes_s: miss.takes,
            }),
        };
        let mode = |found: &ModeRecovery| ModeRecoveryRecord {
            name: model.modes[found.mode].name.clone(),
            not_attempted: found.not_attempted.map(NotAttempted::word),
            pieces: found.pieces.iter().map(piece).collect(),
            uncovered_s: found.uncovered(),
            proved_s: found.families.as_ref().map(Families::proved_s),
        };
        RecoveryRecord {
            detection_s: recovery.delays.clone(),
            within_s: recovery.within,
            basis: BASIS,
            instants: recovery.modes.iter().map(|mode| mode.instants).sum(),
            uncovered,
            weighted,
            flown: recovery.branches.len(),
            survived: recovery.branches.len() - recovery.failed.len(),
            required: model.plan.recovery.require.map(|require| require.uncovered),
            replanned: recovery.change.map(|change| ReplannedRecord {
                reserve: change.reserve,
                price_s: recovery.duration - change.time_before,
                time_before_s: change.time_before,
                uncovered_before: change.uncovered_before,
            }),
            longer: recovery.longer.map(|longer| LongerRecord { time_s: longer.time, uncovered: longer.uncovered }),
            modes: recovery.modes.iter().map(mode).collect(),
        }
    }
}

/// The branches of a piece whose flights failed, with the times for which they count.
fn failed<'a>(recovery: &'a Recovery, piece: &'a Piece) -> impl Iterator<Item = (usize, f64, f64)> + 'a {
    let struck = |place: usize| piece.branches.get(place).map(|index| recovery.branches[*index].fault_at);
    piece.branches.iter().enumerate().filter(|(_, index)| recovery.failed.binary_search(index).is_ok()).map(
        move |(place, index)| {
            let before = place.checked_sub(1).and_then(struck).unwrap_or(piece.from);
            (*index, before, struck(place + 1).unwrap_or(piece.to))
        },
    )
}

/// The files of `--branches`: a table for each branch, in the form of the plan's, and `index.csv`.
pub fn files(problem: Problem, recovery: &Recovery) -> Result<Vec<(String, Vec<u8>)>, String> {
    let model = problem.model();
    let mut index = String::from("file,mode,outcome,site,fault_s,delay_s,begins_s,ends_s,deviation_m,seed,flight\n");
    let mut files = Vec::with_capacity(recovery.branches.len() + 1);
    for (place, branch) in recovery.branches.iter().enumerate() {
        let name = branch_name(model, branch) + ".csv";
        let site = site_of(model, branch.way).unwrap_or_default();
        let begins = branch.fault_at + branch.delay;
        let flight = if recovery.failed.binary_search(&place).is_ok() { "failed" } else { "as planned" };
        index.push_str(&format!(
            "{name},{},{},{site},{},{},{begins},{},{},{},{flight}\n",
            model.modes[branch.mode].name,
            outcome(Some(branch.way)),
            branch.fault_at,
            branch.delay,
            begins + branch.motion.duration(),
            branch.deviation,
            flight_seed(model, place)
        ));
        files.push((name, trajectory_csv::table(&branch.motion, model, None)?.into_bytes()));
    }
    files.push(("index.csv".into(), index.into_bytes()));
    Ok(files)
}

/// A way out on a map.
pub struct Footprint<'b> {
    /// The file with its table.
    pub file: String,
    pub mode: &'b str,
    pub outcome: &'b str,
    /// The instant of the fault, s since the start of the plan.
    pub fault_s: f64,
    pub motion: &'b Trajectory,
}

/// What is drawn of each branch on a map.
pub fn footprints<'b>(model: &'b Model, recovery: &'b Recovery) -> Vec<Footprint<'b>> {
    let of_branch = |branch: &'b FoundBranch| Footprint {
        file: branch_name(model, branch) + ".csv",
        mode: &model.modes[branch.mode].name,
        outcome: outcome(Some(branch.way)),
        fault_s: branch.fault_at,
        motion: &branch.motion,
    };
    recovery.branches.iter().map(of_branch).collect()
}
