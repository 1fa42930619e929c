//! Tables of numbers as columns of bytes.

use crate::job::detached;
use crate::{Arguments, Value, object};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// `columns(csv)`: `[(name, bytes)]`, each with the numbers of one column as native `f64`. An empty cell is not a
/// number.
pub fn columns(arguments: Arguments) -> Value {
    let (text,): (String,) = arguments.extract()?;
    let columns = detached(arguments.py(), move || parse(&text))?;
    let columns = columns.ok_or_else(|| PyValueError::new_err("not a table of numbers"))?;
    let bytes = |(name, bytes): (String, Vec<u8>)| (name, PyBytes::new(arguments.py(), &bytes).unbind());
    object(arguments.py(), columns.into_iter().map(bytes).collect::<Vec<_>>())
}

fn parse(text: &str) -> Option<Vec<(String, Vec<u8>)>> {
    let mut lines = text.lines();
    let mut columns: Vec<(String, Vec<u8>)> = lines.next()?.split(',').map(|name| (name.into(), Vec::new())).collect();
    for line in lines {
        let mut cells = line.split(',');
        for (_, column) in &mut columns {
            let number: f64 = match cells.next()? {
                "" => f64::NAN,
                cell => cell.parse().ok()?,
            };
            column.extend_from_slice(&number.to_ne_bytes());
        }
    }
    Some(columns)
}
