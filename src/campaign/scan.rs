//! Rows that are on disk already: how far they go, and that they are the rows of this campaign and shard, in order.

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
    /// Something follows that is no complete line.
    pub torn: bool,
}

#[derive(Debug)]
pub enum ScanError {
    Read(Error),
    /// A line, counted from 1, and what is wrong with it.
    Damaged {
        line: usize,
        what: String,
    },
    /// Rows of another campaign.
    Foreign,
    /// A row of this campaign that is not the one due in this shard; line counted from 1.
    OutOfOrder {
        line: usize,
        found: usize,
        due: Option<usize>,
    },
}

/// Reads rows, gives each with its case, and stops at the end or before a torn last line.
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
        let text = str::from_utf8(&bytes).map_err(|_| damaged("it is not UTF-8 text".into()))?;
        if line == 1 {
            if text != header() {
                return Err(damaged("it is not the heading of a campaign's rows".into()));
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
