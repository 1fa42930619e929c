//! One flight as one line of CSV: writing and strict reading. SI units.

use super::HEALTHY;
use super::cases::Case;
use super::design::{Design, Identity};
use crate::flight::{BrokenLimits, Cause, Damage, Flight, Outcome};
use crate::number::shortest;
use sha2::{Digest, Sha256};
use std::io::{BufRead, ErrorKind, Read};

/// Names of the columns.
pub const COLUMNS: [&str; 29] = [
    "campaign",
    "cases",
    "case",
    "planner",
    "mode",
    "fault_time_s",
    "seed",
    "outcome",
    "cause",
    "end_s",
    "rms_error_m",
    "max_error_m",
    "rms_error_after_m",
    "max_error_after_m",
    "max_drop_after_m",
    "max_tilt_rad",
    "rms_heading_error_rad",
    "max_heading_error_rad",
    "max_heading_error_after_rad",
    "turns",
    "heading_broken",
    "waypoints_due",
    "waypoints_missed",
    "limits_broken",
    "detected_after_s",
    "isolated_after_s",
    "false_alarms",
    "refused",
    "checksum",
];

/// Longest line, bytes: names of planners and modes are far shorter.
const MOST_LINE: u64 = 1 << 16;

/// Reads the next line, including its end, into `line`, and returns its number of bytes, 0 at the end of the input.
///
/// # Errors
/// Reading fails, or ([`ErrorKind::InvalidData`]) the line is longer than any row.
pub fn read_line(input: &mut impl BufRead, line: &mut Vec<u8>) -> std::io::Result<usize> {
    line.clear();
    let read = input.by_ref().take(MOST_LINE).read_until(b'\n', line)?;
    match read as u64 == MOST_LINE && line.last() != Some(&b'\n') {
        true => Err(std::io::Error::new(ErrorKind::InvalidData, "a line is longer than any row")),
        false => Ok(read),
    }
}

/// The first eight hexadecimal digits of the hash of a line's other cells as written.
fn checksum(cells: &str) -> String {
    Sha256::digest(cells.as_bytes()).iter().take(4).map(|byte| format!("{byte:02x}")).collect()
}

/// The first line, without its line end.
pub fn header() -> String {
    COLUMNS.join(",")
}

/// The result of one case.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    pub campaign: Identity,
    /// Number of cases of the whole campaign.
    pub cases: usize,
    pub case: usize,
    pub planner: String,
    pub mode: String,
    /// s; `None` for a flight without a fault.
    pub fault_time: Option<f64>,
    pub seed: usize,
    pub outcome: FlightOutcome,
    /// s
    pub end: f64,
    /// m
    pub rms_error: f64,
    pub max_error: f64,
    /// m; `None` if no fault struck before the end.
    pub rms_error_after: Option<f64>,
    pub max_error_after: Option<f64>,
    /// Largest height below the reference, m; `None` if no fault struck before the end.
    pub max_drop_after: Option<f64>,
    /// rad
    pub max_tilt: f64,
    /// Heading error, rad; `None` if no fault struck before the end.
    pub rms_heading_error: f64,
    pub max_heading_error: f64,
    pub max_heading_error_after: Option<f64>,
    /// Largest number of whole turns away from the planned heading.
    pub turns: usize,
    /// Since the fault, or over the whole flight without one; `None` if the fault did not strike before the end.
    pub path: Option<Path>,
    /// Seconds after the fault.
    pub detected_after: Option<f64>,
    pub isolated_after: Option<f64>,
    pub false_alarms: usize,
    pub refused: usize,
}

/// What happened to the path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Path {
    /// Whether the heading error exceeded its threshold before yaw was given up on purpose.
    pub heading_broken: bool,
    /// Waypoints that were due, and those of them that were missed.
    pub due: usize,
    pub missed: usize,
    pub limits: BrokenLimits,
}

impl Path {
    fn new(damage: &Damage) -> Self {
        let Damage { waypoints_due, waypoints_missed, limits, heading_broken, .. } = *damage;
        Path { heading_broken, due: waypoints_due, missed: waypoints_missed, limits }
    }
}

/// How a flight ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlightOutcome {
    Flown,
    Landed,
    Lost(Cause),
    /// The integration broke down.
    Diverged,
}

impl Row {
    /// The row of a case and its flight.
    pub fn new(design: &Design, case: &Case, flight: &Flight) -> Self {
        let (planner, mode, fault_time) = names(design, case);
        let found = flight.found.first();
        Row {
            campaign: design.id,
            cases: design.cases.count(),
            case: case.number,
            planner: planner.into(),
            mode: mode.into(),
            fault_time,
            seed: case.seed,
            outcome: match flight.outcome {
                Outcome::Flown => FlightOutcome::Flown,
                Outcome::Landed { .. } => FlightOutcome::Landed,
                Outcome::Lost { cause, .. } => FlightOutcome::Lost(cause),
                Outcome::Diverged { .. } => FlightOutcome::Diverged,
            },
            end: flight.end,
            rms_error: flight.rms_error,
            max_error: flight.max_error,
            // A vehicle that was lost before the fault was never struck.
            rms_error_after: found.map(|_| flight.rms_error_after),
            max_error_after: found.map(|_| flight.damage.max_error),
            max_drop_after: found.map(|_| flight.damage.max_drop),
            max_tilt: flight.max_tilt,
            rms_heading_error: flight.heading.rms,
            max_heading_error: flight.heading.max,
            max_heading_error_after: found.map(|_| flight.heading.max_after),
            turns: flight.heading.turns,
            path: (fault_time.is_none() || found.is_some()).then(|| Path::new(&flight.damage)),
            detected_after: found.and_then(|f| f.detected_after),
            isolated_after: found.and_then(|f| f.isolated_after),
            false_alarms: flight.false_alarms,
            refused: flight.refused,
        }
    }

    pub fn is_lost(&self) -> bool {
        matches!(self.outcome, FlightOutcome::Lost(_))
    }

    pub fn is_survived(&self) -> bool {
        matches!(self.outcome, FlightOutcome::Flown | FlightOutcome::Landed)
    }

    /// Lost before the fault could strike.
    pub fn is_lost_before(&self) -> bool {
        self.is_lost() && self.fault_time.is_some() && self.rms_error_after.is_none()
    }

    /// Whether the row belongs to this case of this campaign.
    pub fn is_of(&self, design: &Design, case: &Case) -> bool {
        let (planner, mode, fault_time) = names(design, case);
        (self.campaign, self.cases, self.case) == (design.id, design.cases.count(), case.number)
            && (self.planner.as_str(), self.mode.as_str(), self.seed) == (planner, mode, case.seed)
            && self.fault_time == fault_time
    }

    /// The line, without its line end. Numbers have the shortest text that reads back as the same number.
    pub fn line(&self) -> String {
        let cells = self.cells();
        let checksum = checksum(&cells);
        cells + "," + &checksum
    }

    /// The last cell of the line.
    pub fn checksum(&self) -> String {
        checksum(&self.cells())
    }

    /// All cells except the checksum.
    fn cells(&self) -> String {
        let optional = |v: Option<f64>| v.map(shortest).unwrap_or_default();
        let (outcome, cause) = match self.outcome {
            FlightOutcome::Flown => ("flown", ""),
            FlightOutcome::Landed => ("landed", ""),
            FlightOutcome::Lost(cause) => ("lost", cause.name()),
            FlightOutcome::Diverged => ("diverged", ""),
        };
        let path = self.path.map_or(",,,".into(), |Path { heading_broken, due, missed, limits }| {
            format!("{heading_broken},{due},{missed},{}", limits.text())
        });
        format!(
            "{},{},{},{},{},{},{},{outcome},{cause},{},{},{},{},{},{},{},{},{},{},{},{path},{},{},{},{}",
            self.campaign,
            self.cases,
            self.case,
            self.planner,
            self.mode,
            optional(self.fault_time),
            self.seed,
            shortest(self.end),
            shortest(self.rms_error),
            shortest(self.max_error),
            optional(self.rms_error_after),
            optional(self.max_error_after),
            optional(self.max_drop_after),
            shortest(self.max_tilt),
            shortest(self.rms_heading_error),
            shortest(self.max_heading_error),
            optional(self.max_heading_error_after),
            self.turns,
            optional(self.detected_after),
            optional(self.isolated_after),
            self.false_alarms,
            self.refused
        )
    }

    /// Reads a line without its line end, which must be exactly what [`Row::line`] writes.
    ///
    /// # Errors
    /// What is wrong with the line.
    pub fn read(line: &str) -> Result<Row, String> {
        let count = line.split(',').count();
        let (cells, sum) = line
            .rsplit_once(',')
            .filter(|_| count == COLUMNS.len())
            .ok_or_else(|| format!("{count} cells instead of {}", COLUMNS.len()))?;
        let row = Row::read_cells(&cells.split(',').collect::<Vec<_>>())?;
        match (sum == checksum(cells), row.cells() == cells) {
            (true, true) => Ok(row),
            (false, _) => Err("the row does not match its checksum: it was changed after it was written".into()),
            (true, false) => Err("a number is not written as mavc writes it".into()),
        }
    }

    /// Reads all cells except the checksum; their number is correct.
    fn read_cells(cells: &[&str]) -> Result<Row, String> {
        let wrong = |k: usize| format!("{:?} is not a valid {}", cells[k], COLUMNS[k]);
        let count = |k: usize| cells[k].parse::<usize>().map_err(|_| wrong(k));
        let float = |k: usize| cells[k].parse().ok().filter(|v: &f64| v.is_finite()).ok_or_else(|| wrong(k));
        let optional = |k: usize| if cells[k].is_empty() { Ok(None) } else { float(k).map(Some) };
        let outcome = match (cells[7], Cause::ALL.into_iter().find(|c| c.name() == cells[8])) {
            ("flown", None) if cells[8].is_empty() => FlightOutcome::Flown,
            ("landed", None) if cells[8].is_empty() => FlightOutcome::Landed,
            ("lost", Some(cause)) => FlightOutcome::Lost(cause),
            ("diverged", None) if cells[8].is_empty() => FlightOutcome::Diverged,
            _ => return Err(format!("{:?} with cause {:?} is not a valid outcome", cells[7], cells[8])),
        };
        let path = match cells[20..24].iter().all(|cell| cell.is_empty()) {
            true => None,
            false => Some(Path {
                heading_broken: cells[20].parse().map_err(|_| wrong(20))?,
                due: count(21)?,
                missed: count(22)?,
                limits: BrokenLimits::read(cells[23]).ok_or_else(|| wrong(23))?,
            }),
        };
        Ok(Row {
            campaign: cells[0].parse().map_err(|()| wrong(0))?,
            cases: count(1)?,
            case: count(2)?,
            planner: cells[3].into(),
            mode: cells[4].into(),
            fault_time: optional(5)?,
            seed: count(6)?,
            outcome,
            end: float(9)?,
            rms_error: float(10)?,
            max_error: float(11)?,
            rms_error_after: optional(12)?,
            max_error_after: optional(13)?,
            max_drop_after: optional(14)?,
            max_tilt: float(15)?,
            rms_heading_error: float(16)?,
            max_heading_error: float(17)?,
            max_heading_error_after: optional(18)?,
            turns: count(19)?,
            path,
            detected_after: optional(24)?,
            isolated_after: optional(25)?,
            false_alarms: count(26)?,
            refused: count(27)?,
        })
    }
}

/// Planner, mode and instant (s) as in rows.
fn names<'a>(design: &'a Design, case: &Case) -> (&'a str, &'a str, Option<f64>) {
    let strike = design.strike(case);
    let mode = strike.map_or(HEALTHY, |(mode, _)| mode.name.as_str());
    (design.plan(case).planner.name(), mode, strike.map(|(_, at)| at))
}
