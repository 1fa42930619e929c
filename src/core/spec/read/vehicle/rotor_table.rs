//! `rotor { table = "motor.csv" }`: the thrust table of a motor's maker, measured on a bench with one propeller at one
//! voltage. It gives the numbers of the `rotor` block that are not written there, and the battery's hover power.
//!
//! The header names the columns in their usual spellings: a thrust and its unit (`Thrust (g)`), and optionally
//! throttle, torque, speed, current, voltage and electrical power. The units may be in a second line below the names.
//! Other columns are ignored. Every row is one throttle, from little to full. Commas or semicolons divide the cells.

mod cell;
mod header;

use crate::diagnostic::Diagnostic;
use crate::language::Entry;
use crate::language::table::rotor as table;
use crate::model::{DefaultUsed, Spread};
use crate::number::{number, percent, shortest, significant};
use crate::read::context::Context;
use crate::read::csv_rows::{BrokenRow, Row, rows, start_of_header};
use crate::read::expected::Expected;
use crate::read::fields::Fields;
use crate::read::load::{FileSet, Table};
use crate::read::understanding::FromTable;
use crate::read::written::Written;
use crate::source::{Span, visible};
use crate::syntax::ast::ExprKind;
use crate::unit::Quantity;
use header::{Column, Kind};

const CODE: &str = "mavc::file::rotor_table";
/// How many errors are reported for one table.
const MAX_ERRORS: usize = 20;
/// The most rows of a table: a bench test has 10 to 50, and one in steps of 0.1 % has this many.
const MAX_ROWS: usize = 1000;
/// The largest number of a table in SI units: no bench measures so much, and products of two stay finite.
const MOST: f64 = 1e9;
/// Mechanical over electrical power: motors reach 50 to 90 %, their controllers 90 to 98 %.
const EFFICIENCY: [f64; 2] = [0.5 * 0.9, 0.9 * 0.98];
/// Share by which a written number may differ from the table's without a warning: numbers are often rounded to two or
/// three digits.
const ROUNDED: f64 = 0.01;

/// One throttle of a bench test, in SI units; what its row leaves empty is `None`.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Point {
    /// N
    thrust: f64,
    /// N m
    torque: Option<f64>,
    /// rad/s
    speed: Option<f64>,
    /// Electrical, W.
    power: Option<f64>,
}

/// A thrust table that was read without errors.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct RotorTable {
    /// The path as written, without characters that disguise a text.
    name: String,
    /// The rows in the order of their thrust, of which the last has one above zero.
    points: Vec<Point>,
}

/// Reads the table that the `rotor` block names.
pub(super) fn read<'a>(cx: &mut Context<'a>, fields: &Fields<'a>, files: &FileSet) -> Written<RotorTable> {
    let Some(expr) = fields.get(table::TABLE.name) else {
        return if fields.may_have(table::TABLE.name) { Written::Faulty } else { Written::Absent };
    };
    let ExprKind::Text(path) = &expr.kind else {
        let error = Diagnostic::error("mavc::unit::kind", expr.span, "`table` must be the name of a file");
        cx.report(error.here("not text in quotes").help("write the name in quotes, as in `table = \"motor.csv\"`"));
        return Written::Faulty;
    };
    let Some(found) = files.table(expr.span.file, path) else {
        // What could not be read is reported, except where an override came after all files were read.
        if !files.incomplete {
            let message = format!("the table `{}` has not been read", visible::line(path));
            let error = Diagnostic::error("mavc::file::missing", expr.span, message).here("named here");
            cx.report(error.help("give this override when the spec is compiled, as `--set` does"));
        }
        return Written::Faulty;
    };
    let name = visible::line(path).into_owned();
    let table = points(cx, found).map(|points| RotorTable { name, points });
    Written::of(table.filter(|table| {
        let given = table.given();
        given.iter().all(|given| cx.is_within_magnitude(Expected::of(given.entry), given.value, expr.span))
    }))
}

/// The rows of a table; `None` if it has errors, which are reported.
fn points(cx: &mut Context, table: &Table) -> Option<Vec<Point>> {
    let mut reader = Reader { separator: separator(table), ..Reader::default() };
    let mut errors = 0;
    let mut lines = rows(table, reader.separator).peekable();
    let mut is_header = true;
    while let Some(row) = lines.next() {
        let outcome = match row {
            Err(BrokenRow { span, message }) => {
                let error = Diagnostic::error(CODE, span, message).here("this row");
                Err(Box::new(error.help("write as many cells as in the header; a number with a comma needs quotes")))
            }
            Ok(row) if is_header => {
                // Many makers write the units below the names.
                let separator = reader.separator;
                let is_of_units = |below: &Result<Row, BrokenRow>| {
                    below.as_ref().is_ok_and(|b| header::is_of_units(&row, b, separator))
                };
                let units = lines.next_if(is_of_units).and_then(Result::ok);
                header::columns(&row, units.as_ref(), separator).map(|found| reader.columns = found)
            }
            Ok(row) if row.record.iter().all(str::is_empty) => Ok(()),
            Ok(row) if reader.points.len() >= MAX_ROWS => {
                let message = format!("a thrust table may have at most {MAX_ROWS} rows");
                let error = Diagnostic::error(CODE, row.span, message).here("one too many");
                cx.report(error.help("keep the rows of one run from little to full throttle"));
                return None;
            }
            Ok(row) => reader.point(&row).map(|point| reader.points.push(point)),
        };
        if let Err(error) = outcome {
            cx.report(*error);
            errors += 1;
        }
        if reader.columns.is_empty() || errors >= MAX_ERRORS {
            return None;
        }
        is_header = false;
    }
    if errors > 0 {
        return None;
    }
    if reader.points.last().is_some_and(|last| last.thrust > 0.0) {
        return Some(reader.points);
    }
    let message = match reader.columns.is_empty() {
        true => format!("`{}` is empty", visible::line(&table.name)),
        false => format!("`{}` has no row with a thrust above zero", visible::line(&table.name)),
    };
    let error = Diagnostic::error(CODE, Span::new(table.file, 0, 0), message);
    cx.report(
        error.here("expected a header and its rows").help("begin with a line such as `Thrust (g),RPM,Torque (N*m)`"),
    );
    None
}

/// What divides the cells: a semicolon if the header has one outside quotes, or else a comma.
fn separator(table: &Table) -> u8 {
    let header = &table.bytes[start_of_header(table)..];
    let mut quoted = false;
    let found = header.iter().take_while(|byte| !matches!(byte, b'\n' | b'\r')).find(|byte| {
        quoted ^= **byte == b'"';
        !quoted && **byte == b';'
    });
    found.copied().unwrap_or(b',')
}

#[derive(Default)]
struct Reader {
    separator: u8,
    columns: Vec<Column>,
    points: Vec<Point>,
    /// The last value of each column.
    last: Values,
}

/// The values of one row by [`Kind`], each with its cell.
type Values = [Option<(f64, Span)>; Kind::ALL.len()];

impl Reader {
    fn point(&mut self, row: &Row) -> Result<Point, Box<Diagnostic>> {
        let mut values: Values = [None; Kind::ALL.len()];
        for column in &self.columns {
            let (text, span) = (&row.record[column.index], row.cells[column.index]);
            let fail = |message: String| Diagnostic::error(CODE, span, message).here("this cell");
            let title = column.kind.title();
            if text.is_empty() {
                continue;
            }
            let text = if column.kind == Kind::Throttle { text.trim_end_matches([' ', '%']) } else { text };
            let number = cell::number(text, self.separator).map_err(|mistake| {
                Box::new(
                    fail(format!("`{}` in column `{title}` {}", visible::line(text), mistake.what)).help(mistake.help),
                )
            })?;
            let value = Quantity::with_unit(number, column.unit).value;
            if value < 0.0 {
                let error = fail(format!("`{title}` cannot be negative"));
                return Err(Box::new(error.help("write 0 for the drift of a scale, or remove the row")));
            }
            if value > MOST {
                return Err(Box::new(fail(format!("`{title}` is too large")).help("check the number and its unit")));
            }
            values[column.kind as usize] = Some((value, span));
        }
        self.increases(&values)?;
        for (last, value) in self.last.iter_mut().zip(values) {
            *last = value.or(*last);
        }
        let value = |kind: Kind| values[kind as usize].map(|(value, _)| value);
        let Some(thrust) = value(Kind::Thrust) else {
            let error = Diagnostic::error(CODE, row.span, "`thrust` is empty").here("this row");
            return Err(Box::new(error.help("write the thrust, or remove the row")));
        };
        let product = || Some(value(Kind::Current)? * value(Kind::Voltage)?);
        let power = value(Kind::Power).or_else(product);
        Ok(Point { thrust, torque: value(Kind::Torque), speed: value(Kind::Speed), power })
    }

    /// Thrust, speed and throttle increase from row to row.
    fn increases(&self, values: &Values) -> Result<(), Box<Diagnostic>> {
        for kind in [Kind::Throttle, Kind::Thrust, Kind::Speed] {
            let (now, before) = (values[kind as usize], self.last[kind as usize]);
            let (Some((now, span)), Some((before, above))) = (now, before) else { continue };
            if now > before {
                continue;
            }
            let message = format!("`{}` must increase from row to row", kind.title());
            // A throttle has the scale of its table.
            let unit = if kind == Kind::Throttle { String::new() } else { format!(" {}", kind.unit()) };
            let here = format!("{}{unit}, after {}{unit}", number(now), number(before));
            let error = Diagnostic::error(CODE, span, message).here(here).also(above, "the value before");
            let help = "sort the rows from little to full throttle, and keep those of one propeller at one voltage";
            return Err(Box::new(error.help(help)));
        }
        Ok(())
    }
}

/// A number of the `rotor` block as the table gives it.
struct Given {
    entry: &'static Entry,
    /// In SI units.
    value: f64,
    reason: String,
}

impl RotorTable {
    /// The thrust of the last row, N.
    pub fn max_thrust(&self) -> f64 {
        self.full().thrust
    }

    /// The speed of the last row, rad/s; `None` if it has none.
    pub fn max_speed(&self) -> Option<f64> {
        self.full().speed.filter(|speed| *speed > 0.0)
    }

    /// Torque per thrust k, m, by least squares of Q = k T over the rows with a torque; `None` without such rows.
    pub fn torque_per_thrust(&self) -> Option<f64> {
        let (products, squares) = self.torques().fold((0.0, 0.0), |(p, s), (t, q)| (p + t * q, s + t * t));
        Some(products / squares).filter(|ratio| ratio.is_finite() && *ratio > 0.0)
    }

    /// Thrust and torque of the rows that have both.
    fn torques(&self) -> impl Iterator<Item = (f64, f64)> {
        self.points.iter().filter_map(|point| Some((point.thrust, point.torque?)))
    }

    /// The last row.
    fn full(&self) -> Point {
        // A table has a row with a thrust above zero.
        self.points[self.points.len() - 1]
    }

    /// The torque per thrust, m, and its interval that the electrical power of the last row suggests, with the
    /// efficiencies of usual motors: for a table without torques.
    pub fn estimated_torque_per_thrust(&self) -> Option<(f64, Spread)> {
        let Point { thrust, power, .. } = self.full();
        let electrical = power? / (self.max_speed()? * thrust);
        let [low, high] = EFFICIENCY.map(|share| share * electrical);
        let middle = 0.5 * (low + high);
        (middle > 0.0).then(|| (middle, Spread { low: low / middle, high: high / middle }))
    }

    /// Whether the table can give a hover power.
    pub fn has_power(&self) -> bool {
        self.powers().count() > 1
    }

    /// Thrust and electrical power of the rows that have both.
    fn powers(&self) -> impl Iterator<Item = (f64, f64)> {
        self.points.iter().filter_map(|point| Some((point.thrust, point.power?)))
    }

    /// The electrical power (W) of one motor at a thrust (N), on straight lines between the rows; `None` outside them.
    pub fn power(&self, thrust: f64) -> Option<f64> {
        let rows: Vec<_> = self.powers().collect();
        let around = rows.windows(2).find(|pair| (pair[0].0..=pair[1].0).contains(&thrust))?;
        let [(below, least), (above, most)] = [around[0], around[1]];
        Some(least + (most - least) * (thrust - below) / (above - below))
    }

    /// The path as written, for messages.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What the table gives, each with where it comes from and how far the rows are from it.
    fn given(&self) -> Vec<Given> {
        let name = &self.name;
        let mut given = vec![Given {
            entry: &table::MAX_THRUST,
            value: self.max_thrust(),
            reason: format!("the last row of `{name}`"),
        }];
        if let Some(ratio) = self.torque_per_thrust() {
            let largest = self.torques().map(|(_, torque)| torque).fold(0.0, f64::max);
            let residual = self.torques().map(|(t, q)| (q - ratio * t).abs()).fold(0.0, f64::max);
            let reason = format!(
                "least squares over the rows of `{name}`, whose torques differ from it by at most {} of the largest",
                percent(residual / largest)
            );
            given.push(Given { entry: &table::TORQUE_PER_THRUST, value: ratio, reason });
        }
        if let Some(speed) = self.max_speed() {
            let coefficient = self.max_thrust() / (speed * speed);
            let residual = self.points.iter().filter_map(|p| Some((p.thrust - coefficient * p.speed?.powi(2)).abs()));
            let reason = format!(
                "the last row of `{name}`; the thrusts of its rows differ from the square of the speed by at most {} \
                 of the largest",
                percent(residual.fold(0.0, f64::max) / self.max_thrust())
            );
            given.push(Given { entry: &table::MAX_SPEED, value: speed, reason });
        }
        given
    }

    /// The numbers that the table gives, for editors.
    pub fn note(&self, cx: &mut Context, fields: &Fields) {
        let Some(path) = fields.get(table::TABLE.name) else { return };
        let of = |given: Given| FromTable {
            span: path.span,
            field: given.entry.name,
            value: given.value,
            unit: given.entry.unit().unwrap_or("1"),
            is_used: is_unwritten(&given, fields),
            reason: given.reason,
        };
        cx.from_tables.extend(self.given().into_iter().map(of));
    }

    /// The numbers that are taken from the table, as records of defaults: those that `fields` do not write.
    pub fn used(&self, fields: &Fields) -> Vec<DefaultUsed> {
        let taken = self.given().into_iter().filter(|given| is_unwritten(given, fields));
        let record = |Given { entry, value, reason }: Given| DefaultUsed {
            field: format!("vehicle.rotor.{}", entry.name),
            value: format!("{} {}", shortest(value), entry.unit().unwrap_or("1")),
            reason,
        };
        taken.map(record).collect()
    }

    /// Warns of a field beside the table that differs from it. `value` is in the SI unit of `entry`, the row with which
    /// it is compared.
    pub fn compare(
        &self,
        cx: &mut Context,
        fields: &Fields,
        field: &Entry,
        entry: &'static Entry,
        value: f64,
        spread: Spread,
    ) {
        let Some(given) = self.given().into_iter().find(|given| given.entry.name == entry.name) else { return };
        let is_inside = (value * spread.low..=value * spread.high).contains(&given.value);
        let difference = value / given.value - 1.0;
        if is_inside || difference.abs() <= ROUNDED {
            return;
        }
        let side = if difference > 0.0 { "above" } else { "below" };
        let message = format!("`{}` is {} {side} that of `{}`", field.name, percent(difference.abs()), self.name);
        let span = fields.span_of(field.name).unwrap_or(fields.span);
        let unit = entry.unit().unwrap_or("1");
        let shown = [value, given.value].map(|value| significant(value, 4));
        let here = format!("gives {} {unit}, the table {} {unit}", shown[0], shown[1]);
        let help = "remove it to use the table; if the value is intended, write `allow = [rotor_table]` outside all \
                    blocks";
        cx.report(Diagnostic::warning("mavc::sense::rotor_table", span, message).here(here).help(help));
    }
}

/// Whether the fields write a number in no form.
fn is_unwritten(given: &Given, fields: &Fields) -> bool {
    !written_forms(given.entry).any(|form| fields.get(form).is_some())
}

/// The fields of `rotor` that replace a number of the table.
fn written_forms(entry: &'static Entry) -> impl Iterator<Item = &'static str> {
    let other = table::ENTRIES.iter().filter(|row| row.excludes.contains(&entry.name)).map(|row| row.name);
    std::iter::once(entry.name).chain(other)
}

#[cfg(test)]
mod tests;
