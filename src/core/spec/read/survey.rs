//! `waypoints from "survey.csv"`: a table with one waypoint per row.
//!
//! The header names the columns and their units: `x_m,y_m,z_m`, and optionally `yaw_deg`, `within_cm`,
//! `yaw_within_deg`, `weight`, `time_s`, `name`. Any unit of the right dimension is accepted. An empty cell of an
//! optional column counts as not given. Lines that begin with `#` are comments.

use super::context::{Context, duplicate, listed};
use super::csv_rows::{BrokenRow, Row, rows};
use super::expected::Expected;
use super::load::Table;
use super::mission::{Route, Stop, WaypointDefaults};
use crate::diagnostic::Diagnostic;
use crate::source::{Span, Spanned, visible};
use crate::unit::{Quantity, Unit, parse_unit};
use std::collections::BTreeMap;

const CODE: &str = "mavc::file::table";
/// How many errors are reported for one table.
const MAX_ERRORS: usize = 20;

/// Name, usual unit (empty for text), and whether every row must give it. Where one name begins another, the longer
/// comes first.
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

/// A column of the table: its index in [`COLUMNS`] and its unit.
struct Column {
    kind: usize,
    unit: Option<Unit>,
}

pub(super) fn read(cx: &mut Context, table: &Table, defaults: WaypointDefaults, route: &mut Route) {
    let mut columns: Option<Vec<Column>> = None;
    let mut errors = 0;
    // Where each name was first given.
    let mut names: BTreeMap<String, Span> =
        route.waypoints.iter().rev().filter_map(|w| Some((w.name.clone()?, w.span))).collect();
    for row in rows(table, b',') {
        let outcome = match (&columns, row) {
            (_, Err(BrokenRow { span, message })) => {
                let error = Diagnostic::error(CODE, span, message).here("this row");
                Err(Box::new(error.help("separate cells by commas, and write numbers with a decimal point")))
            }
            (None, Ok(row)) => header(cx, &row).map(|found| columns = Some(found)),
            (Some(columns), Ok(row)) => stop(&row, columns, defaults).and_then(|stop| {
                let twice = second_of_its_name(&row, columns, &mut names);
                route.push(cx, stop, None);
                twice
            }),
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
        cx.report(error.here("expected a header").help("begin with a line such as `x_m,y_m,z_m,yaw_deg`"));
        route.broken = true;
    }
}

/// Adds the row's name to `names`, which maps each name to its first place.
///
/// # Errors
/// The name is taken.
fn second_of_its_name(
    row: &Row,
    columns: &[Column],
    names: &mut BTreeMap<String, Span>,
) -> Result<(), Box<Diagnostic>> {
    let Some(index) = columns.iter().position(|column| COLUMNS[column.kind].0 == "name") else { return Ok(()) };
    let name = Spanned::new(row.record[index].to_string(), row.cells[index]);
    if name.value.is_empty() {
        return Ok(());
    }
    match names.get(&name.value) {
        Some(first) => Err(Box::new(duplicate("waypoint", &name, *first))),
        None => {
            names.insert(name.value, name.span);
            Ok(())
        }
    }
}

fn stop(row: &Row, columns: &[Column], defaults: WaypointDefaults) -> Result<Stop, Box<Diagnostic>> {
    let mut values = [None; COLUMNS.len()];
    let mut name = None;
    for ((column, cell), &span) in columns.iter().zip(&row.record).zip(&row.cells) {
        let fail = |message: String| Diagnostic::error(CODE, span, message).here("this cell");
        let (title, due_unit, due) = COLUMNS[column.kind];
        if due_unit.is_empty() {
            name = (!cell.is_empty()).then(|| visible::line(cell).into_owned());
            continue;
        }
        if cell.is_empty() {
            if due {
                let error = fail(format!("`{title}` is empty"));
                return Err(Box::new(error.help("write a number: every row needs a position")));
            }
            continue;
        }
        let number = cell.parse::<f64>().ok().filter(|x| x.is_finite());
        let value = number.map(|x| column.unit.map_or(x, |unit| Quantity::with_unit(x, unit).value));
        let Some(value) = value.filter(|x| x.is_finite()) else {
            let error = fail(format!("`{cell}` in column `{title}` is not a number"));
            return Err(Box::new(error.help(match column.unit {
                Some(_) => "write a number such as `1.5`; its unit belongs in the header",
                None => "write a number such as `1.5`",
            })));
        };
        values[column.kind] = Some((value, span));
    }
    let given = |title: &str| COLUMNS.iter().position(|c| c.0 == title).and_then(|kind| values[kind]);
    let value = |title: &str| given(title).map(|(value, _)| value);
    let wrong = |code, title: &str, rule: &str| {
        let span = given(title).map_or(row.span, |(_, span)| span);
        Box::new(Diagnostic::error(code, span, format!("`{title}` {rule}")).here("this cell"))
    };
    for title in ["within", "yaw_within"] {
        if value(title).is_some_and(|v| v <= 0.0) {
            return Err(wrong("mavc::mission::tolerance", title, "must be greater than zero"));
        }
    }
    if value("weight").is_some_and(|v| v < 0.0) {
        return Err(wrong("mavc::mission::weight", "weight", "cannot be negative"));
    }
    let [Some(x), Some(y), Some(z)] = ["x", "y", "z"].map(value) else {
        return Err(wrong(CODE, "x", "and the other coordinates are needed in every row"));
    };
    Ok(Stop {
        name,
        position: [x, y, z],
        yaw: value("yaw"),
        within: value("within").unwrap_or(defaults.within),
        yaw_within: value("yaw_within").unwrap_or(defaults.yaw_within),
        weight: value("weight").unwrap_or(defaults.weight),
        time: given("time"),
        leg: None,
        heading: value("yaw").map(|_| super::heading::Rule::Given),
        span: row.span,
    })
}

fn header(cx: &Context, row: &Row) -> Result<Vec<Column>, Box<Diagnostic>> {
    let Row { record, span, cells } = row;
    let fail_whole = |message: String| Diagnostic::error(CODE, *span, message).here("the header");
    if record.len() == 1 && record[0].contains([';', '\t']) {
        let error = fail_whole("the cells of a table must be separated by commas".into());
        return Err(Box::new(error.help("save it as `CSV, comma delimited`, with decimal points")));
    }
    let mut columns: Vec<Column> = Vec::new();
    for (cell, &span) in record.iter().zip(cells) {
        let fail = |message: String| Diagnostic::error(CODE, span, message).here("this column");
        let matching = |(name, ..): &(&str, &str, bool)| cell == *name || cell.starts_with(&format!("{name}_"));
        let Some(kind) = COLUMNS.iter().position(matching) else {
            if cell.parse::<f64>().is_ok() {
                let error = fail_whole("the first line of a table must name its columns".into());
                return Err(Box::new(error.help("put a line such as `x_m,y_m,z_m,yaw_deg` above it")));
            }
            let names = COLUMNS.map(|c| c.0);
            let lower = cell.to_lowercase();
            let error = fail(format!("unknown column `{cell}`"));
            return Err(Box::new(match names.iter().any(|name| lower.starts_with(&format!("{name}_"))) {
                true => error.help(format!("write `{lower}`: column names are lower case")),
                false => error.help(format!("use the columns {}, with units, as in `x_m`", listed(&names))),
            }));
        };
        let (name, unit, _) = COLUMNS[kind];
        let written = cell.strip_prefix(name).and_then(|rest| rest.strip_prefix('_'));
        let unit = match (unit, written) {
            ("" | "1", None) => None,
            ("" | "1", Some(_)) => {
                return Err(Box::new(fail(format!("column `{name}` takes no unit")).help(format!("write `{name}`"))));
            }
            (due, None) => {
                return Err(Box::new(
                    fail(format!("column `{name}` needs a unit")).help(format!("write `{name}_{due}`")),
                ));
            }
            (due, Some(text)) => match parse_unit(text, cx.gravity) {
                Ok(unit) if unit.dimension == Expected::new(name, due).dimension() => Some(unit),
                _ => {
                    let message = format!("`{text}` is not a unit for column `{name}`");
                    return Err(Box::new(fail(message).help(format!("write `{name}_{due}`"))));
                }
            },
        };
        if let Some(first) = columns.iter().position(|c| c.kind == kind) {
            let error = fail(format!("the table has two columns `{name}`")).also(cells[first], "first column");
            return Err(Box::new(error.help("remove one of them")));
        }
        columns.push(Column { kind, unit });
    }
    for (kind, (name, unit, due)) in COLUMNS.iter().enumerate() {
        if *due && !columns.iter().any(|c| c.kind == kind) {
            return Err(Box::new(
                fail_whole(format!("the table has no column `{name}`")).help(format!("add `{name}_{unit}`")),
            ));
        }
    }
    Ok(columns)
}
