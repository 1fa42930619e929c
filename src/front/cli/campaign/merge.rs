//! `mavc campaign merge`: joins the rows of all shards to those of the whole campaign.

use super::super::files::{self, cannot_read, reason};
use super::super::target::Target;
use super::super::{CommandError, FINE, Options};
use crate::campaign::merge::{MergeError, merge};
use crate::input::open_regular;
use std::io::{BufReader, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

pub fn run(output: &Path, rows: &[PathBuf], options: &Options) -> Result<u8, CommandError> {
    let target = Target::new(output)?;
    for path in rows {
        target.must_spare(path.to_str())?;
    }
    let open = |path: &PathBuf| {
        let file = open_regular(path).map_err(|e| cannot_read(path, &e))?;
        Ok((path.display().to_string(), BufReader::new(file)))
    };
    let sources = rows.iter().map(open).collect::<Result<Vec<_>, CommandError>>()?;
    let problem = |e: MergeError| match e {
        MergeError::Read(name, e) => format!("cannot read {name}: {}", reason(&e)),
        MergeError::Write(e) => format!("cannot write {}: {}", output.display(), reason(&e)),
        MergeError::Content(what) => format!("cannot merge: {what}"),
    };
    let cannot = |e| problem(MergeError::Write(e));
    let mut out = BufWriter::new(target.begin()?);
    let merged = match merge(sources, &mut out) {
        Err(MergeError::Write(e)) if e.kind() == ErrorKind::BrokenPipe => return Ok(FINE),
        merged => merged.map_err(problem)?,
    };
    out.flush().map_err(cannot)?;
    out.into_inner().map_err(|e| cannot(e.into_error()))?.finish()?;
    if !options.quiet {
        let (n, files) = (merged.cases, rows.len());
        files::eprint(&format!("mavc: campaign {}: {n} flights from {files} files\n", merged.campaign));
    }
    Ok(FINE)
}
