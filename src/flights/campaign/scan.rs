//! Scans rows that are already on disk: how far they go, and whether they are the rows of this campaign and shard, in
//! order.

use super::cases::{Case, Shard};
use super::design::Design;
use super::rows::{Row, header, read_line};
use std::io::{BufRead, Error};

/// How far the rows go.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Scan {
    pub rows: usize,
    /// Up to the end of the last complete line.
    pub bytes: u64,
    /// An incomplete line follows.
    pub torn: bool,
}

/// Why rows on disk cannot be continued.
#[derive(Debug)]
pub enum ScanError {
    Read(Error),
    /// A line, counted from 1, and its defect.
    Damaged {
        line: usize,
        what: String,
    },
    /// Rows of another campaign.
    Foreign,
    /// A row of this campaign that is not the expected one of this shard; the line is counted from 1.
    OutOfOrder {
        line: usize,
        found: usize,
        due: Option<usize>,
    },
}

/// Reads rows, passes each with its case to `take`, and stops at the end or before an incomplete last line.
///
/// # Errors
/// Reading fails, or a row is damaged, foreign or out of order.
pub fn scan(
    design: &Design,
    shard: Shard,
    mut input: impl BufRead,
    mut take: impl FnMut(&Case, &Row),
) -> Result<Scan, ScanError> {
    let mut cases = design.cases.of(shard);
    let mut scan = Scan::default();
    let mut bytes = Vec::new();
    for line in 1.. {
        let read = read_line(&mut input, &mut bytes).map_err(ScanError::Read)?;
        if bytes.pop() != Some(b'\n') {
            scan.torn = read > 0;
            break;
        }
        let damaged = |what: String| ScanError::Damaged { line, what };
        let text = str::from_utf8(&bytes).map_err(|_| damaged("not UTF-8 text".into()))?;
        if line == 1 {
            if text != header() {
                return Err(damaged("not the header of a campaign's rows".into()));
            }
        } else {
            let row = Row::read(text).map_err(damaged)?;
            if row.campaign != design.id {
                return Err(ScanError::Foreign);
            }
            let due = cases.next();
            match due.filter(|case| row.is_of(design, case)) {
                Some(case) => take(&case, &row),
                None => {
                    return Err(ScanError::OutOfOrder { line, found: row.case, due: due.map(|c| c.number) });
                }
            }
            scan.rows += 1;
        }
        scan.bytes += read as u64;
    }
    Ok(scan)
}
