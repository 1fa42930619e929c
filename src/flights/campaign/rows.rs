//! One flight as one line of CSV: writing and strict reading. SI units.

use super::HEALTHY;
use super::cases::Case;
use super::columns::{COLUMNS, Cell, Column};
use super::design::{CampaignId, Design};
use crate::flight::{BrokenLimits, Cause, Damage, Flight, Outcome};
use sha2::{Digest, Sha256};
use std::fmt::Write;
use std::io::{BufRead, ErrorKind, Read};

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
    COLUMNS.each_ref().map(|column| column.name).join(",")
}

/// All columns but the last, the checksum of the others.
fn checked() -> &'static [Column] {
    const ALL: &[Column] = &COLUMNS;
    &ALL[..ALL.len() - 1]
}

/// The result of one case.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Row {
    pub campaign: CampaignId,
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

    /// Reads four cells, of which the first is given; `None` if all are empty.
    pub(super) fn read(first: Cell) -> Result<Option<Self>, String> {
        let [heading_broken, due, missed, limits] = [0, 1, 2, 3].map(|k| first.next(k));
        if [heading_broken, due, missed, limits].iter().all(|cell| cell.text().is_empty()) {
            return Ok(None);
        }
        Ok(Some(Path {
            heading_broken: heading_broken.parsed()?,
            due: due.parsed()?,
            missed: missed.parsed()?,
            limits: BrokenLimits::read(limits.text()).ok_or_else(|| limits.wrong())?,
        }))
    }
}

/// How a flight ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FlightOutcome {
    #[default]
    Flown,
    Landed,
    /// Not lost, but past the boundary of a volume.
    Trespassed,
    Lost(Cause),
    /// The integration broke down.
    Diverged,
}

impl FlightOutcome {
    /// The word in rows.
    pub fn word(self) -> &'static str {
        match self {
            FlightOutcome::Flown => "flown",
            FlightOutcome::Landed => "landed",
            FlightOutcome::Trespassed => "trespassed",
            FlightOutcome::Lost(_) => "lost",
            FlightOutcome::Diverged => "diverged",
        }
    }

    /// The cause of a loss.
    pub fn cause(self) -> Option<Cause> {
        if let FlightOutcome::Lost(cause) = self { Some(cause) } else { None }
    }

    /// Reads the word, and the cause from the cell after it.
    pub(super) fn read(cell: Cell) -> Result<Self, String> {
        let (word, cause) = (cell.text(), cell.next(1).text());
        match (word, Cause::ALL.into_iter().find(|c| c.name() == cause)) {
            ("flown", None) if cause.is_empty() => Ok(FlightOutcome::Flown),
            ("landed", None) if cause.is_empty() => Ok(FlightOutcome::Landed),
            ("trespassed", None) if cause.is_empty() => Ok(FlightOutcome::Trespassed),
            ("lost", Some(cause)) => Ok(FlightOutcome::Lost(cause)),
            ("diverged", None) if cause.is_empty() => Ok(FlightOutcome::Diverged),
            _ => Err(format!("{word:?} with cause {cause:?} is not a valid outcome")),
        }
    }
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
                Outcome::Trespassed { .. } => FlightOutcome::Trespassed,
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
        let mut cells = String::new();
        for (at, column) in checked().iter().enumerate() {
            let comma = if at == 0 { "" } else { "," };
            let value = (column.value)(self).map_or(String::new(), |value| value.to_string());
            let _ = write!(cells, "{comma}{value}");
        }
        cells
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
        let mut row = Row::default();
        for (at, column) in checked().iter().enumerate() {
            (column.read)(&mut row, Cell { line: cells, at })?;
        }
        Ok(row)
    }
}

/// Planner, mode and instant (s) of a row, in the spelling of its columns.
fn names<'a>(design: &'a Design, case: &Case) -> (&'a str, &'a str, Option<f64>) {
    let strike = design.strike(case);
    let mode = strike.map_or(HEALTHY, |(mode, _)| mode.name.as_str());
    (design.plan(case).planner.name(), mode, strike.map(|(_, at)| at))
}
