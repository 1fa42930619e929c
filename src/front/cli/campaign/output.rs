//! The place that the rows of a campaign go to. A file grows as `.part` beside its final name, so that an interrupted
//! campaign can continue.

use super::super::files::{cannot_read, reason};
use super::super::target::{Pieces, Target, cannot_write};
use super::CommandError;
use crate::campaign::cases::Shard;
use crate::campaign::design::Design;
use crate::campaign::rows::header;
use crate::campaign::scan::{Scan, ScanError, scan};
use crate::campaign::tally::Tally;
use crate::input::{open_regular, regular, without_waiting};
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{BufRead, BufReader, Error, ErrorKind, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

pub struct Output<'a> {
    place: RowDestination<'a>,
}

enum RowDestination<'a> {
    /// The rows are not kept.
    Nowhere,
    /// Standard output, a pipe or a device.
    Stream(Pieces<'a>),
    Part {
        file: File,
        part: PathBuf,
        path: &'a Path,
    },
    /// The file holds every row already.
    Complete(&'a Path),
}

/// Why a run of flights ends early.
pub enum Stop {
    /// Nobody reads the rows any more.
    ReaderGone,
    Failed(CommandError),
}

/// The file that rows are appended to: `rows.csv.part`.
pub fn part_of(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_os_string();
    name.push(".part");
    name.into()
}

impl<'a> Output<'a> {
    /// Opens the place and tallies the rows that it holds already.
    pub fn open(target: Option<&'a Target>, design: &Design, shard: Shard) -> Result<(Self, Tally), CommandError> {
        let empty = || Tally::new(design.cases);
        let Some(target) = target else { return Ok((Output { place: RowDestination::Nowhere }, empty())) };
        let Some(path) = target.file() else {
            let mut stream = target.begin()?;
            // If the reader has gone away already, the first rows report it.
            let _ = writeln!(stream, "{}", header());
            return Ok((Output { place: RowDestination::Stream(stream) }, empty()));
        };
        if let Some(tally) = complete(path, design, shard) {
            return Ok((Output { place: RowDestination::Complete(path) }, tally));
        }
        if holds_rows(path) {
            return Err(format!(
                "{} holds rows of another campaign or shard, or not all of this one: delete it, or choose another \
                 name with -o",
                path.display()
            ));
        }
        let part = part_of(path);
        let (file, tally) = resume(&part, design, shard)?;
        Ok((Output { place: RowDestination::Part { file, part, path } }, tally))
    }

    pub fn is_complete(&self) -> bool {
        matches!(self.place, RowDestination::Complete(_))
    }

    /// The file of rows that an interrupted campaign continues from.
    pub fn part(&self) -> Option<&Path> {
        match &self.place {
            RowDestination::Part { part, .. } => Some(part),
            _ => None,
        }
    }

    pub fn name(&self) -> String {
        match &self.place {
            RowDestination::Part { part, .. } => part.display().to_string(),
            RowDestination::Complete(path) => path.display().to_string(),
            _ => "rows".into(),
        }
    }

    /// Appends whole lines, which are handed to the operating system when this returns.
    pub fn add(&mut self, lines: &str) -> Result<(), Stop> {
        match &mut self.place {
            RowDestination::Nowhere | RowDestination::Complete(_) => Ok(()),
            RowDestination::Stream(stream) => {
                stream.write_all(lines.as_bytes()).and_then(|()| stream.flush()).map_err(|e| match e.kind() {
                    ErrorKind::BrokenPipe => Stop::ReaderGone,
                    _ => Stop::Failed(format!("cannot write the rows: {}", reason(&e))),
                })
            }
            RowDestination::Part { file, part, .. } => {
                file.write_all(lines.as_bytes()).map_err(|e| Stop::Failed(cannot_write(part, &e)))
            }
        }
    }

    /// Renames the file of all rows to its final name.
    pub fn finish(self) -> Result<(), Stop> {
        let RowDestination::Part { file, part, path } = self.place else { return Ok(()) };
        let cannot = |e: Error| Stop::Failed(cannot_write(path, &e));
        if let Ok(there) = path.metadata() {
            file.set_permissions(there.permissions()).map_err(cannot)?;
        }
        file.sync_all().map_err(cannot)?;
        std::fs::rename(&part, path).map_err(cannot)
    }
}

/// Whether a file starts with the heading of rows and holds at least one row.
fn holds_rows(path: &Path) -> bool {
    let Ok(file) = open_regular(path) else { return false };
    let mut lines = BufReader::new(file).lines();
    lines.next().is_some_and(|line| line.is_ok_and(|l| l == header())) && lines.next().is_some()
}

/// The tally of a file, if it holds every row of the shard.
fn complete(path: &Path, design: &Design, shard: Shard) -> Option<Tally> {
    let mut tally = Tally::new(design.cases);
    let input = BufReader::new(open_regular(path).ok()?);
    let scan = scan(design, shard, input, |case, row| tally.add(case, row)).ok()?;
    is_whole(&scan, design, shard).then_some(tally)
}

fn is_whole(scan: &Scan, design: &Design, shard: Shard) -> bool {
    // A shard may have no cases, but a whole file has at least a heading.
    !scan.torn && scan.bytes > 0 && scan.rows == shard.count(design.cases.count())
}

/// Opens the file of rows after its last complete line, and tallies the rows that it holds.
fn resume(part: &Path, design: &Design, shard: Shard) -> Result<(File, Tally), CommandError> {
    let cannot = |e: Error| cannot_write(part, &e);
    let mut options = OpenOptions::new();
    options.read(true).write(true).create(true).truncate(false);
    without_waiting(&mut options);
    let mut file = options.open(part).map_err(cannot)?;
    file.metadata().and_then(|there| regular(&there)).map_err(cannot)?;
    // A file system may have no locks; then the file is used without one.
    if let Err(TryLockError::WouldBlock) = file.try_lock() {
        return Err(format!("{} is being written by another run: wait for it, or choose another name", part.display()));
    }
    let mut tally = Tally::new(design.cases);
    let found = scan(design, shard, BufReader::new(&file), |case, row| tally.add(case, row));
    let found = found.map_err(|e| {
        format!("{}; delete it to start again, or choose another name with -o", unfit(part, &e, design))
    })?;
    file.set_len(found.bytes).map_err(cannot)?;
    file.seek(SeekFrom::Start(found.bytes)).map_err(cannot)?;
    if found.bytes == 0 {
        writeln!(file, "{}", header()).map_err(cannot)?;
    }
    Ok((file, tally))
}

/// The tally of rows that were flown before (`--rows`).
pub fn tally(path: &Path, design: &Design, shard: Shard) -> Result<Tally, CommandError> {
    let input = open_regular(path).map_err(|e| cannot_read(path, &e))?;
    let mut tally = Tally::new(design.cases);
    let found = scan(design, shard, BufReader::new(input), |case, row| tally.add(case, row));
    let found = found.map_err(|e| unfit(path, &e, design))?;
    let due = shard.count(design.cases.count());
    if !is_whole(&found, design, shard) {
        return Err(format!("{} holds {} of {due} rows: run the campaign to its end", path.display(), found.rows));
    }
    Ok(tally)
}

/// Why a file does not hold the rows of this campaign or shard.
fn unfit(path: &Path, error: &ScanError, design: &Design) -> CommandError {
    let name = path.display();
    match error {
        ScanError::Read(e) => format!("cannot read {name}: {}", reason(e)),
        ScanError::Damaged { line, what } => format!("{name}, line {line}: {what}"),
        ScanError::Foreign => format!(
            "{name} holds rows of another campaign (this one is {}; it depends on the spec, --set, --times, --seeds \
             and the version)",
            design.id
        ),
        ScanError::OutOfOrder { line, found, due: Some(due) } if found == due => {
            format!("{name}, line {line}: this row of case {due} has another plan, mode, instant or seed than the case")
        }
        ScanError::OutOfOrder { line, found, due } => {
            let due = due.map_or("no more".into(), |due| format!("case {due}"));
            format!("{name}, line {line}: case {found} is where {due} is expected, as in rows of another shard")
        }
    }
}
