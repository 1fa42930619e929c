//! The columns of a campaign's rows, in one table. It gives the header and the lines of the CSV, how they are read
//! back, their types in Python, and the table in docs/campaigns.md.

use super::rows::{FlightOutcome, Path, Row};
use crate::number::shortest;
use std::fmt;

/// A column.
#[derive(Debug)]
pub struct Column {
    /// Its name in the header.
    pub name: &'static str,
    /// The unit of its numbers; empty if they have none.
    pub unit: &'static str,
    pub kind: ColumnKind,
    /// Whether its cells may be empty.
    pub is_optional: bool,
    /// The meaning, in Markdown.
    pub meaning: &'static str,
    /// The value in a row; `None` for an empty cell.
    pub value: fn(&Row) -> Option<Value>,
    /// Reads its cell into a row.
    ///
    /// # Errors
    /// The cell is not valid.
    pub read: fn(&mut Row, Cell) -> Result<(), String>,
}

/// The type of a column's values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColumnKind {
    Text,
    Count,
    Number,
    Truth,
}

/// The value of a cell that is not empty; its text is that of the cell.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    Text(String),
    Count(usize),
    Number(f64),
    Truth(bool),
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Text(text) => f.write_str(text),
            Value::Count(count) => write!(f, "{count}"),
            // The shortest text that reads back as the same number.
            Value::Number(number) => f.write_str(&shortest(*number)),
            Value::Truth(truth) => write!(f, "{truth}"),
        }
    }
}

/// A cell among all cells of its line.
#[derive(Debug, Clone, Copy)]
pub struct Cell<'a> {
    pub line: &'a [&'a str],
    /// The index of its column.
    pub at: usize,
}

impl<'a> Cell<'a> {
    pub fn text(self) -> &'a str {
        self.line[self.at]
    }

    /// The cell that many columns further on.
    pub fn next(self, columns: usize) -> Self {
        Cell { at: self.at + columns, ..self }
    }

    pub fn wrong(self) -> String {
        format!("{:?} is not a valid {}", self.text(), COLUMNS[self.at].name)
    }

    pub fn parsed<T: std::str::FromStr>(self) -> Result<T, String> {
        self.text().parse().map_err(|_| self.wrong())
    }

    fn number(self) -> Result<f64, String> {
        self.parsed().ok().filter(|number: &f64| number.is_finite()).ok_or_else(|| self.wrong())
    }

    fn optional(self) -> Result<Option<f64>, String> {
        if self.text().is_empty() { Ok(None) } else { self.number().map(Some) }
    }
}

/// A column: its name, unit and meaning, and the field of the row that it shows (`count turns`), or its kind, whether
/// it is optional, its value in a row and how it is read.
macro_rules! column {
    ($name:literal, $unit:literal, $meaning:literal, text $field:ident) => {
        column!($name, $unit, $meaning, Text, false, |row| Some(Value::Text(row.$field.to_string())), |row, cell| {
            row.$field = cell.parsed()?;
            Ok(())
        })
    };
    ($name:literal, $unit:literal, $meaning:literal, count $field:ident) => {
        column!($name, $unit, $meaning, Count, false, |row| Some(Value::Count(row.$field)), |row, cell| {
            row.$field = cell.parsed()?;
            Ok(())
        })
    };
    ($name:literal, $unit:literal, $meaning:literal, number $field:ident) => {
        column!($name, $unit, $meaning, Number, false, |row| Some(Value::Number(row.$field)), |row, cell| {
            row.$field = cell.number()?;
            Ok(())
        })
    };
    ($name:literal, $unit:literal, $meaning:literal, optional $field:ident) => {
        column!($name, $unit, $meaning, Number, true, |row| row.$field.map(Value::Number), |row, cell| {
            row.$field = cell.optional()?;
            Ok(())
        })
    };
    ($name:literal, $unit:literal, $meaning:literal, $kind:ident, $optional:literal, $value:expr, $read:expr) => {
        Column {
            name: $name,
            unit: $unit,
            kind: ColumnKind::$kind,
            is_optional: $optional,
            meaning: $meaning,
            value: $value,
            read: $read,
        }
    };
}

/// All columns, in the order of the cells. The checksum is the last.
pub const COLUMNS: [Column; 29] = [
    column!(
        "campaign",
        "",
        "sixteen hexadecimal digits that identify the campaign: a hash of the spec with all its files, `--set`, times, \
         seeds, T_d, the planners flown and the mavc program itself",
        text campaign
    ),
    column!("cases", "", "number of flights in the whole campaign", count cases),
    column!(
        "case",
        "",
        "number of this flight, from 0: planner, then mode (`healthy` first), instant, seed; the seed changes fastest",
        count case
    ),
    column!("planner", "", "`rip`, `rsp`, `rcp`", text planner),
    column!(
        "mode",
        "",
        "the fault mode; `healthy` and no `fault_time_s` for a flight without a fault",
        text mode
    ),
    column!("fault_time_s", "s", "when the fault strikes", optional fault_time),
    column!("seed", "", "index of the noise seed, from 0", count seed),
    column!(
        "outcome",
        "",
        "`flown` to the end, `landed` as intended, `trespassed`: not lost, but in a `keep_out` or outside a `keep_in`, \
         `lost`, or `diverged`: the integration broke down \
         ([flight](flight.md#5-after-a-fault-and-when-the-vehicle-is-lost))",
        Text,
        false,
        |row| Some(Value::Text(row.outcome.word().into())),
        |row, cell| {
            row.outcome = FlightOutcome::read(cell)?;
            Ok(())
        }
    ),
    column!(
        "cause",
        "",
        "cause of a loss: `position` (too far from the reference), `upside_down`, `ground`, `heading`",
        Text,
        true,
        |row| row.outcome.cause().map(|cause| Value::Text(cause.name().into())),
        // Read with the outcome.
        |_, _| Ok(())
    ),
    column!("end_s", "s", "when the flight ended", number end),
    column!(
        "rms_error_m",
        "m",
        "distance from the reference over the whole flight, root mean square",
        number rms_error
    ),
    column!("max_error_m", "m", "largest distance from the reference over the whole flight", number max_error),
    column!(
        "rms_error_after_m",
        "m",
        "root mean square distance since the fault",
        optional rms_error_after
    ),
    column!(
        "max_error_after_m",
        "m",
        "largest distance since the fault",
        optional max_error_after
    ),
    column!(
        "max_drop_after_m",
        "m",
        "largest height below the reference since the fault, 0 if it was never below",
        optional max_drop_after
    ),
    column!("max_tilt_rad", "rad", "largest tilt", number max_tilt),
    column!(
        "rms_heading_error_rad",
        "rad",
        "heading error over the whole flight, within half a turn, root mean square",
        number rms_heading_error
    ),
    column!(
        "max_heading_error_rad",
        "rad",
        "the largest over the whole flight",
        number max_heading_error
    ),
    column!(
        "max_heading_error_after_rad",
        "rad",
        "the largest since the fault",
        optional max_heading_error_after
    ),
    column!(
        "turns",
        "",
        "largest number of whole turns by which the vehicle was away from the planned heading",
        count turns
    ),
    column!(
        "heading_broken",
        "",
        "`true` or `false`: whether the heading error exceeded 30 degrees before yaw was given up on purpose",
        Truth,
        true,
        |row| row.path.map(|path| Value::Truth(path.heading_broken)),
        |row, cell| {
            row.path = Path::read(cell)?;
            Ok(())
        }
    ),
    // These three are read with the one before.
    column!(
        "waypoints_due",
        "",
        "waypoints that were [due](flight.md#the-path-after-a-fault)",
        Count,
        true,
        |row| row.path.map(|path| Value::Count(path.due)),
        |_, _| Ok(())
    ),
    column!(
        "waypoints_missed",
        "",
        "those of them that were missed by more than their tolerance, `within`",
        Count,
        true,
        |row| row.path.map(|path| Value::Count(path.missed)),
        |_, _| Ok(())
    ),
    column!(
        "limits_broken",
        "",
        "the limits of the mission that were broken: `none`, or words of the language such as `speed+tilt`",
        Text,
        true,
        |row| row.path.map(|path| Value::Text(path.limits.text())),
        |_, _| Ok(())
    ),
    column!(
        "detected_after_s",
        "s",
        "time until the controller knew that a rotor of the mode was weakened",
        optional detected_after
    ),
    column!(
        "isolated_after_s",
        "s",
        "time until the controller knew every capacity to within 0.2 of its true value",
        optional isolated_after
    ),
    column!(
        "false_alarms",
        "",
        "number of times that a healthy rotor was assumed weak for longer than 0.1 s",
        count false_alarms
    ),
    column!(
        "refused",
        "",
        "number of reconfigurations refused because the vehicle could not hover with them",
        count refused
    ),
    column!(
        "checksum",
        "",
        "the first eight hexadecimal digits of the SHA-256 of the line up to the comma before this cell",
        Text,
        false,
        |row| Some(Value::Text(row.checksum())),
        // Compared with that of the line.
        |_, _| Ok(())
    ),
];

/// The table of docs/campaigns.md.
pub fn table() -> String {
    let rows = COLUMNS.iter().map(|column| format!("| `{}` | {} | {} |\n", column.name, column.unit, column.meaning));
    format!("| column | unit | meaning |\n|---|---|---|\n{}", rows.collect::<String>())
}
