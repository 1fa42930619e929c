//! Merging the rows of shards: every case exactly once, in order, byte for byte as a single run writes them.

use super::cases::MAX_FLIGHTS;
use super::design::CampaignId;
use super::rows::{Row, header, read_line};
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::io::{BufRead, Error, Write};

/// Most missing cases that a message names.
const NAMED: usize = 5;

/// Why rows could not be merged.
#[derive(Debug)]
pub enum MergeError {
    /// The source that could not be read.
    Read(String, Error),
    Write(Error),
    /// The sources do not form a whole campaign.
    Content(String),
}

/// The merged campaign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Merged {
    pub campaign: CampaignId,
    pub cases: usize,
}

/// One source's next row.
struct Source<R> {
    name: String,
    input: R,
    line: usize,
    /// The line with its end, and its case.
    bytes: Vec<u8>,
    case: usize,
    /// Distance between its first two cases, which is the likely number of shards.
    stride: Option<usize>,
}

/// Writes the rows of all sources in the order of their cases. Memory: one line of each source.
///
/// # Errors
/// A source cannot be read, `out` cannot be written, or the sources do not form a whole campaign.
pub fn merge<R: BufRead>(sources: Vec<(String, R)>, out: &mut impl Write) -> Result<Merged, MergeError> {
    let mut campaign: Option<(Merged, String)> = None;
    let mut next = BinaryHeap::new();
    let mut sources: Vec<Source<R>> = sources
        .into_iter()
        .map(|(name, input)| Source { name, input, line: 0, bytes: Vec::new(), case: 0, stride: None })
        .collect();
    for (k, source) in sources.iter_mut().enumerate() {
        source.heading()?;
        if source.advance(&mut campaign)? {
            next.push(Reverse((source.case, k)));
        }
    }
    let Some((merged, _)) = campaign.clone() else {
        return Err(MergeError::Content("these files contain no rows".into()));
    };
    let mut missing = Missing::default();
    let mut due = 0;
    let mut last = 0;
    writeln!(out, "{}", header()).map_err(MergeError::Write)?;
    while let Some(Reverse((case, k))) = next.pop() {
        if case < due {
            let (a, b) = (&sources[last].name, &sources[k].name);
            return Err(MergeError::Content(format!("case {case} is in both {a} and {b}: give each shard once")));
        }
        missing.add(due..case);
        // After a missing case nothing more is written.
        if missing.count == 0 {
            out.write_all(&sources[k].bytes).map_err(MergeError::Write)?;
        }
        (due, last) = (case + 1, k);
        if sources[k].advance(&mut campaign)? {
            next.push(Reverse((sources[k].case, k)));
        }
    }
    missing.add(due..merged.cases);
    match missing.count {
        0 => Ok(merged),
        _ => Err(MergeError::Content(missing.message(merged.cases, sources.iter().find_map(|s| s.stride)))),
    }
}

impl<R: BufRead> Source<R> {
    fn wrong(&self, what: &str) -> MergeError {
        MergeError::Content(format!("{}, line {}: {what}", self.name, self.line))
    }

    /// Reads the next line with its end; false where there is none.
    fn read(&mut self) -> Result<bool, MergeError> {
        self.line += 1;
        read_line(&mut self.input, &mut self.bytes).map_err(|e| MergeError::Read(self.name.clone(), e))?;
        match self.bytes.last() {
            None => Ok(false),
            Some(b'\n') => Ok(true),
            Some(_) => Err(self.wrong("the line is incomplete: let that shard run to its end")),
        }
    }

    fn heading(&mut self) -> Result<(), MergeError> {
        if self.read()? && self.bytes.strip_suffix(b"\n") == Some(header().as_bytes()) {
            return Ok(());
        }
        Err(self.wrong("this is not the header of a campaign's rows"))
    }

    /// Advances to the next row, which must belong to the campaign and follow the previous one; false at the end.
    fn advance(&mut self, campaign: &mut Option<(Merged, String)>) -> Result<bool, MergeError> {
        if !self.read()? {
            return Ok(false);
        }
        let text = str::from_utf8(&self.bytes).ok().and_then(|t| t.strip_suffix('\n'));
        let row = Row::read(text.ok_or_else(|| self.wrong("not UTF-8 text"))?).map_err(|e| self.wrong(&e))?;
        let own = Merged { campaign: row.campaign, cases: row.cases };
        let (first, of) = campaign.get_or_insert_with(|| (own, self.name.clone()));
        if own != *first {
            let what = match own.campaign == first.campaign {
                true => format!("a row of a campaign with {} cases, but {of} has {}", own.cases, first.cases),
                false => format!("a row of campaign {}, but {of} belongs to {}", own.campaign, first.campaign),
            };
            return Err(self.wrong(&what));
        }
        if row.cases > MAX_FLIGHTS {
            return Err(self.wrong(&format!("{} cases, but a campaign has at most {MAX_FLIGHTS}", row.cases)));
        }
        if row.case >= row.cases {
            return Err(self.wrong(&format!("case {} of a campaign with {}", row.case, row.cases)));
        }
        if self.line > 2 && row.case <= self.case {
            return Err(self.wrong(&format!("case {} comes after case {}", row.case, self.case)));
        }
        if self.line == 3 {
            self.stride = Some(row.case - self.case);
        }
        self.case = row.case;
        Ok(true)
    }
}

/// Cases that are in no source.
#[derive(Default)]
struct Missing {
    count: usize,
    first: Vec<usize>,
    /// The last missing case.
    last: usize,
    /// The distance between missing cases, if it is always the same.
    stride: Option<usize>,
    is_uneven: bool,
}

impl Missing {
    fn add(&mut self, cases: std::ops::Range<usize>) {
        if cases.is_empty() {
            return;
        }
        if self.count > 0 {
            self.step(cases.start - self.last);
        }
        if cases.len() > 1 {
            self.step(1);
        }
        self.count += cases.len();
        self.last = cases.end - 1;
        self.first.extend(cases.take(NAMED - self.first.len()));
    }

    /// Records the distance from one missing case to the next.
    fn step(&mut self, step: usize) {
        self.is_uneven |= *self.stride.get_or_insert(step) != step;
    }

    /// The message; `shards` is the likely number of shards.
    fn message(&self, of: usize, shards: Option<usize>) -> String {
        let named: Vec<String> = self.first.iter().map(usize::to_string).collect();
        let more = match self.count - self.first.len() {
            0 => String::new(),
            n => format!(" and {n} more"),
        };
        let whole = shards.filter(|&n| n > 1 && !self.is_uneven && self.stride.is_none_or(|s| s == n));
        let shard = whole.map_or(String::new(), |n| format!(": they belong to shard {}/{n}", self.first[0] % n + 1));
        let plural = if self.count == 1 { "" } else { "s" };
        format!("{} of {of} cases are missing, case{plural} {}{more}{shard}", self.count, named.join(", "))
    }
}
