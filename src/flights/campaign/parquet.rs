//! Rows as Parquet: the columns of the CSV, typed, in row groups of bounded size. Empty cells are nulls.

use super::columns::{COLUMNS, ColumnKind, Value};
use super::rows::{Row, header};
use parquet::basic::Compression;
use parquet::data_type::{BoolType, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::{ParquetError, Result};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::parser::parse_message_type;
use std::io::{BufRead, Write};
use std::sync::Arc;

/// Rows in a group: about 10 MB in memory.
const GROUP: usize = 65_536;

/// The schema: the columns of the CSV.
fn schema() -> String {
    let columns = COLUMNS.iter().map(|column| {
        let presence = if column.is_optional { "optional" } else { "required" };
        let (kind, note) = match column.kind {
            ColumnKind::Text => ("byte_array", " (UTF8)"),
            ColumnKind::Count => ("int64", ""),
            ColumnKind::Number => ("double", ""),
            ColumnKind::Truth => ("boolean", ""),
        };
        format!("{presence} {kind} {}{note};", column.name)
    });
    format!("message campaign {{ {} }}", columns.collect::<String>())
}

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
    let schema = Arc::new(parse_message_type(&schema())?);
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
    let mut group = writer.next_row_group()?;
    for column in &COLUMNS {
        let cells: Vec<Option<Value>> = rows.iter().map(column.value).collect();
        // Which values of an optional column are present (1) and which are missing (0).
        let levels: Vec<i16> = cells.iter().map(|cell| i16::from(cell.is_some())).collect();
        let levels = column.is_optional.then_some(&levels[..]);
        let values = cells.into_iter().flatten();
        match column.kind {
            ColumnKind::Text => {
                write::<ByteArrayType, _>(&mut group, values.map(|v| v.to_string().as_str().into()), levels)?
            }
            ColumnKind::Count => write::<Int64Type, _>(&mut group, values.filter_map(count), levels)?,
            ColumnKind::Number => write::<DoubleType, _>(&mut group, values.filter_map(number), levels)?,
            ColumnKind::Truth => write::<BoolType, _>(&mut group, values.filter_map(truth), levels)?,
        }
    }
    group.close().map(drop)
}

fn count(value: Value) -> Option<i64> {
    if let Value::Count(count) = value { Some(count as i64) } else { None }
}

fn number(value: Value) -> Option<f64> {
    if let Value::Number(number) = value { Some(number) } else { None }
}

fn truth(value: Value) -> Option<bool> {
    if let Value::Truth(truth) = value { Some(truth) } else { None }
}

/// Writes the next column of a group.
fn write<T: DataType, W: Write + Send>(
    group: &mut SerializedRowGroupWriter<W>,
    values: impl Iterator<Item = T::T>,
    levels: Option<&[i16]>,
) -> Result<()> {
    let end = || ParquetError::General("the schema has too few columns".into());
    let mut column = group.next_column()?.ok_or_else(end)?;
    column.typed::<T>().write_batch(&values.collect::<Vec<_>>(), levels, None)?;
    column.close()
}
