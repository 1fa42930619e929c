//! Conversion of rows to Parquet, if mavc was built with the feature `parquet`.

use super::super::target::Target;
use super::CommandError;
use std::io::BufRead;
use std::path::Path;

/// Whether the name ends in `.parquet`.
pub fn is_wanted(path: &Path) -> bool {
    path.extension().is_some_and(|e| e == "parquet")
}

/// Fails before any flight if Parquet is wanted and this mavc cannot write it.
pub fn is_possible(path: &Path) -> Result<(), CommandError> {
    if is_wanted(path) && !cfg!(feature = "parquet") {
        return Err(format!("{}: {WITHOUT}", path.display()));
    }
    Ok(())
}

const WITHOUT: &str = "this mavc was built without Parquet; build it with `--features parquet`, or name a .csv file";

/// Writes finished rows, which start with their heading, as Parquet.
#[cfg(feature = "parquet")]
pub fn convert(rows: impl BufRead, target: &Target) -> Result<(), CommandError> {
    let mut pieces = target.begin()?;
    crate::campaign::parquet::convert(rows, &mut pieces).map_err(|e| format!("cannot write Parquet: {e}"))?;
    pieces.finish()
}

#[cfg(not(feature = "parquet"))]
pub fn convert(_: impl BufRead, _: &Target) -> Result<(), CommandError> {
    Err(WITHOUT.into())
}
