//! `waypoints from "survey.csv"`: a table with one waypoint a row.
//!
//! The header names the columns and their units: `x_m,y_m,z_m`, and where wanted `yaw_deg`, `within_cm`,
//! `yaw_within_deg`, `weight`, `time_s`, `name`. Any unit of the right dimension will do. An empty cell of an optional
//! column says nothing. Lines that begin with `#` are comments.

use super::context::{Context, listed};
use super::due::Due;
use super::load::Table;
use super::mission::{Manner, Route, Stop};
use crate::diagnostic::Diagnostic;
use crate::source::Span;
use crate::unit::{Quantity, Unit, parse_unit};

const CODE: &str = "mavc::file::table";
/// Errors told of one table.
const MAX_ERRORS: usize = 20;

/// Name, unit one would write (empty for text), whether every row has it. Longer names first where one begins another.
const COLUMNS: [(&str, &str, bool); 9] = [
    ("x", "m", true),
    ("y", "m", true),
    ("z", "m", true),
    ("yaw_within", "deg", false),
    ("yaw", "deg", false),
    ("within", "m", false),
    ("weight", "1", false),
    ("time", "s", false),
    ("name", "", false),
];

/// A column of the table: which of [`COLUMNS`] it is, and its unit.
struct Column {
    kind: usize,
    unit: Option<Unit>,
}

pub(super) fn read(cx: &mut Context, table: &Table, manner: Manner, route: &mut Route) {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .from_reader(table.bytes.as_slice());
    let mut columns: Option<Vec<Column>> = None;
    let mut errors = 0;
    for record in reader.records() {
        let outcome = match (&columns, record) {
            (_, Err(error)) => {
                let error =
                    Diagnostic::error(CODE, place(table, error.position()), broken_row(&error)).here("this row");
                Err(Box::new(error.help("commas separate cells, and numbers have a decimal point, no comma")))
            }
            (None, Ok(record)) => header(cx, &record, table).map(|found| columns = Some(found)),
            (Some(columns), Ok(record)) => row(columns, &record, table, manner).map(|stop| route.push(cx, stop, None)),
        };
        if let Err(error) = outcome {
            cx.report(*error);
            route.broken = true;
            errors += 1;
        }
        if columns.is_none() || errors >= MAX_ERRORS {
            return;
        }
    }
    if columns.is_none() {
        let span = Span::new(table.file, 0, 0);
        let error = Diagnostic::error(CODE, span, format!("`{}` is empty", table.name));
        cx.report(error.here("a header is due").help("begin with a line such as `x_m,y_m,z_m,yaw_deg`"));
        route.broken = true;
    }
}

/// The bytes of one line of the table.
fn place(table: &Table, position: Option<&csv::Position>) -> Span {
    let start = position.map_or(0, |p| p.byte() as usize).min(table.bytes.len());
    let skipped = table.bytes[start..].iter().take_while(|b| b.is_ascii_whitespace()).count();
    let start = (start + skipped).min(table.bytes.len());
    let length = table.bytes[start..].iter().take_while(|b| !matches!(b, b'\n' | b'\r')).count();
    Span::new(table.file, start, start + length)
}

fn broken_row(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("this row has {len} cells, the header {expected_len}")
        }
        _ => "this row cannot be read".into(),
    }
}

fn header(cx: &Context, record: &csv::StringRecord, table: &Table) -> Result<Vec<Column>, Box<Diagnostic>> {
    let span = place(table, record.position());
    let fail = |message: String| Diagnostic::error(CODE, span, message).here("the header");
    if record.len() == 1 && record[0].contains([';', '\t']) {
        let error = fail("the cells of a table are separated by commas".into());
        return Err(Box::new(error.help("save it as `CSV, comma delimited`, with decimal points")));
    }
    let mut columns: Vec<Column> = Vec::new();
    for cell in record {
        let matching = |(name, ..): &(&str, &str, bool)| cell == *name || cell.starts_with(&format!("{name}_"));
        let Some(kind) = COLUMNS.iter().position(matching) else {
            if cell.parse::<f64>().is_ok() {
                let error = fail("the first line of a table names its columns".into());
                return Err(Box::new(error.help("put a line such as `x_m,y_m,z_m,yaw_deg` above it")));
            }
            let names = COLUMNS.map(|c| c.0);
            let lower = cell.to_lowercase();
            let error = fail(format!("the table has an unknown column `{cell}`"));
            return Err(Box::new(match names.iter().any(|name| lower.starts_with(&format!("{name}_"))) {
                true => error.help(format!("names of columns are small letters: write `{lower}`")),
                false => error.help(format!("columns are {}, with their units, as in `x_m`", listed(&names))),
            }));
        };
        let (name, unit, _) = COLUMNS[kind];
        let written = cell.strip_prefix(name).and_then(|rest| rest.strip_prefix('_'));
        let unit = match (unit, written) {
            ("" | "1", None) => None,
            ("" | "1", Some(_)) => {
                return Err(Box::new(fail(format!("column `{name}` has no unit"))));
            }
            (due, None) => {
                return Err(Box::new(
                    fail(format!("column `{name}` needs its unit")).help(format!("write `{name}_{due}`")),
                ));
            }
            (due, Some(text)) => match parse_unit(text, cx.gravity) {
                Ok(unit) if unit.dimension == Due::new(name, due).dimension() => Some(unit),
                _ => {
                    let message = format!("`{text}` is no unit for column `{name}`");
                    return Err(Box::new(fail(message).help(format!("write `{name}_{due}`"))));
                }
            },
        };
        if columns.iter().any(|c| c.kind == kind) {
            return Err(Box::new(fail(format!("the table has two columns `{name}`"))));
        }
        columns.push(Column { kind, unit });
    }
    for (kind, (name, unit, due)) in COLUMNS.iter().enumerate() {
        if *due && !columns.iter().any(|c| c.kind == kind) {
            return Err(Box::new(
                fail(format!("the table has no column `{name}`")).help(format!("add `{name}_{unit}`")),
            ));
        }
    }
    Ok(columns)
}

fn row(columns: &[Column], record: &csv::StringRecord, table: &Table, manner: Manner) -> Result<Stop, Box<Diagnostic>> {
    let span = place(table, record.position());
    let mut values = [None; COLUMNS.len()];
    let mut name = None;
    for (column, cell) in columns.iter().zip(record) {
        let (title, due_unit, due) = COLUMNS[column.kind];
        if due_unit.is_empty() {
            name = (!cell.is_empty()).then(|| cell.to_string());
            continue;
        }
        if cell.is_empty() {
            if due {
                return Err(Box::new(Diagnostic::error(CODE, span, format!("`{title}` is empty")).here("this row")));
            }
            continue;
        }
        let number = cell.parse::<f64>().ok().filter(|x| x.is_finite());
        let value = number.map(|x| column.unit.map_or(x, |unit| Quantity::with_unit(x, unit).value));
        let Some(value) = value.filter(|x| x.is_finite()) else {
            let message = format!("`{cell}` is no number for `{title}`");
            return Err(Box::new(Diagnostic::error(CODE, span, message).here("this row")));
        };
        values[column.kind] = Some(value);
    }
    let value = |title: &str| COLUMNS.iter().position(|c| c.0 == title).and_then(|kind| values[kind]);
    let wrong = |code, message: &str| Diagnostic::error(code, span, message).here("this row");
    let within = value("within").unwrap_or(manner.within);
    let yaw_within = value("yaw_within").unwrap_or(manner.yaw_within);
    let weight = value("weight").unwrap_or(manner.weight);
    if within <= 0.0 || yaw_within <= 0.0 {
        return Err(Box::new(wrong("mavc::mission::tolerance", "a tolerance has to be greater than zero")));
    }
    if weight < 0.0 {
        return Err(Box::new(wrong("mavc::mission::weight", "`weight` cannot be negative")));
    }
    let position = [value("x").unwrap_or(0.0), value("y").unwrap_or(0.0), value("z").unwrap_or(0.0)];
    let time = value("time").map(|t| (t, span));
    Ok(Stop { name, position, yaw: value("yaw"), within, yaw_within, weight, time, span })
}
