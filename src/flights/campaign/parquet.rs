//! Rows as Parquet: the columns of the CSV, typed, in row groups of bounded size. Empty cells are nulls.

use super::rows::{FlightOutcome, Row, header};
use parquet::basic::Compression;
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::{ParquetError, Result};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::parser::parse_message_type;
use std::io::{BufRead, Write};
use std::sync::Arc;

/// Rows in a group: about 10 MB in memory.
const GROUP: usize = 65_536;

/// The columns in the order of [`super::rows::COLUMNS`].
const SCHEMA: &str = "message campaign {
    required byte_array campaign (UTF8);
    required int64 cases;
    required int64 case;
    required byte_array planner (UTF8);
    required byte_array mode (UTF8);
    optional double fault_time_s;
    required int64 seed;
    required byte_array outcome (UTF8);
    optional byte_array cause (UTF8);
    required double end_s;
    required double rms_error_m;
    required double max_error_m;
    optional double rms_error_after_m;
    optional double max_error_after_m;
    optional double max_drop_after_m;
    required double max_tilt_rad;
    required double rms_heading_error_rad;
    required double max_heading_error_rad;
    optional double max_heading_error_after_rad;
    required int64 turns;
    optional boolean heading_broken;
    optional int64 waypoints_due;
    optional int64 waypoints_missed;
    optional byte_array limits_broken (UTF8);
    optional double detected_after_s;
    optional double isolated_after_s;
    required int64 false_alarms;
    required int64 refused;
    required byte_array checksum (UTF8);
}";

/// Writes the rows of a finished CSV as Parquet.
///
/// # Errors
/// Reading or writing fails, or a line is not a row.
pub fn convert(input: impl BufRead, out: impl Write + Send) -> Result<()> {
    let wrong = |line: usize, what: String| ParquetError::General(format!("line {line} of the rows: {what}"));
    let mut lines = input.lines().enumerate();
    match lines.next() {
        Some((_, Ok(line))) if line == header() => {}
        _ => return Err(wrong(1, "not the header".into())),
    }
    let schema = Arc::new(parse_message_type(SCHEMA)?);
    let properties = Arc::new(WriterProperties::builder().set_compression(Compression::SNAPPY).build());
    let mut writer = SerializedFileWriter::new(out, schema, properties)?;
    let mut rows = Vec::new();
    for (k, line) in lines {
        rows.push(Row::read(&line?).map_err(|e| wrong(k + 1, e))?);
        if rows.len() == GROUP {
            group(&mut writer, &rows)?;
            rows.clear();
        }
    }
    if !rows.is_empty() {
        group(&mut writer, &rows)?;
    }
    writer.close().map(drop)
}

fn group<W: Write + Send>(writer: &mut SerializedFileWriter<W>, rows: &[Row]) -> Result<()> {
    let mut columns = Columns { group: writer.next_row_group()?, rows };
    columns.text(|r| Some(r.campaign.to_string()), false)?;
    columns.count(|r| r.cases)?;
    columns.count(|r| r.case)?;
    columns.text(|r| Some(r.planner.clone()), false)?;
    columns.text(|r| Some(r.mode.clone()), false)?;
    columns.optional(|r| r.fault_time)?;
    columns.count(|r| r.seed)?;
    let outcome = |r: &Row| match r.outcome {
        FlightOutcome::Flown => "flown",
        FlightOutcome::Landed => "landed",
        FlightOutcome::Lost(_) => "lost",
        FlightOutcome::Diverged => "diverged",
    };
    columns.text(|r| Some(outcome(r).into()), false)?;
    let cause = |r: &Row| match r.outcome {
        FlightOutcome::Lost(cause) => Some(cause.name().to_string()),
        _ => None,
    };
    columns.text(cause, true)?;
    columns.float(|r| r.end)?;
    columns.float(|r| r.rms_error)?;
    columns.float(|r| r.max_error)?;
    columns.optional(|r| r.rms_error_after)?;
    columns.optional(|r| r.max_error_after)?;
    columns.optional(|r| r.max_drop_after)?;
    columns.float(|r| r.max_tilt)?;
    columns.float(|r| r.rms_heading_error)?;
    columns.float(|r| r.max_heading_error)?;
    columns.optional(|r| r.max_heading_error_after)?;
    columns.count(|r| r.turns)?;
    columns.nullable::<BoolType>(|r| r.path.map(|p| p.heading_broken))?;
    columns.nullable::<Int64Type>(|r| r.path.map(|p| p.due as i64))?;
    columns.nullable::<Int64Type>(|r| r.path.map(|p| p.missed as i64))?;
    columns.text(|r| r.path.map(|p| p.limits.text()), true)?;
    columns.optional(|r| r.detected_after)?;
    columns.optional(|r| r.isolated_after)?;
    columns.count(|r| r.false_alarms)?;
    columns.count(|r| r.refused)?;
    columns.text(|r| Some(r.checksum()), false)?;
    columns.group.close().map(drop)
}

/// One row group, column by column.
struct Columns<'a, W: Write> {
    group: SerializedRowGroupWriter<'a, W>,
    rows: &'a [Row],
}

impl<W: Write + Send> Columns<'_, W> {
    /// Writes the values that are present; for optional columns, `levels` marks them (1) and the missing ones (0).
    fn write<T: DataType>(&mut self, values: &[T::T], levels: Option<&[i16]>) -> Result<()> {
        let end = || ParquetError::General("the schema has too few columns".into());
        let mut column = self.group.next_column()?.ok_or_else(end)?;
        column.typed::<T>().write_batch(values, levels, None)?;
        column.close()
    }

    fn text(&mut self, of: impl Fn(&Row) -> Option<String>, optional: bool) -> Result<()> {
        let cells: Vec<Option<String>> = self.rows.iter().map(of).collect();
        let levels: Vec<i16> = cells.iter().map(|c| i16::from(c.is_some())).collect();
        let values: Vec<ByteArray> = cells.iter().flatten().map(|c| ByteArray::from(c.as_str())).collect();
        self.write::<ByteArrayType>(&values, optional.then_some(&levels))
    }

    fn count(&mut self, of: impl Fn(&Row) -> usize) -> Result<()> {
        let values: Vec<i64> = self.rows.iter().map(|r| of(r) as i64).collect();
        self.write::<Int64Type>(&values, None)
    }

    fn float(&mut self, of: impl Fn(&Row) -> f64) -> Result<()> {
        let values: Vec<f64> = self.rows.iter().map(of).collect();
        self.write::<DoubleType>(&values, None)
    }

    fn optional(&mut self, of: impl Fn(&Row) -> Option<f64>) -> Result<()> {
        self.nullable::<DoubleType>(of)
    }

    fn nullable<T: DataType>(&mut self, of: impl Fn(&Row) -> Option<T::T>) -> Result<()> {
        let cells: Vec<Option<T::T>> = self.rows.iter().map(of).collect();
        let levels: Vec<i16> = cells.iter().map(|c| i16::from(c.is_some())).collect();
        let values: Vec<T::T> = cells.into_iter().flatten().collect();
        self.write::<T>(&values, Some(&levels))
    }
}
