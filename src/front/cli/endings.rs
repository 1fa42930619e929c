//! Formats by the ending of a file's name, where `--format` names none: what a name promises is written, or refused.

use super::{CommandError, files};
use std::path::Path;

/// Endings that a table never has, and what to write instead.
pub type Others = [(&'static [&'static str], &'static str)];

/// The format of the file at `path`, by its ending: one of `formats`, or the default for names that say nothing.
///
/// # Errors
/// The ending is one of `others`.
pub fn format_of<F: Copy + Default>(path: &Path, formats: &[(&str, F)], others: &Others) -> Result<F, CommandError> {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_ascii_lowercase();
    if let Some((_, format)) = formats.iter().find(|(of, _)| *of == ending) {
        return Ok(*format);
    }
    match others.iter().find(|(of, _)| of.contains(&ending.as_str())) {
        Some((_, help)) => Err(format!("-o {}: {help}", files::shown(path))),
        None => Ok(F::default()),
    }
}
