//! Formats by the ending of a file's name, where `--format` names none: what a name promises is written, or refused.

use super::{CommandError, files};
use std::path::Path;

/// Endings that a table never has, and what to write instead.
pub type Others = [(&'static [&'static str], &'static str)];

/// The format that `--format` names, or else that of the file at `output` by its ending: one of `endings`, or the
/// default for names that say nothing; and, if the ending is one of `others`, why that is not meant.
pub fn chosen<F: Copy + Default>(
    name: Option<&str>,
    formats: &[(F, &str)],
    output: Option<&Path>,
    endings: &[(&str, F)],
    others: &Others,
) -> (F, Option<CommandError>) {
    if let Some((format, _)) = name.and_then(|name| formats.iter().find(|(_, known)| *known == name)) {
        return (*format, None);
    }
    let Some(path) = output else { return (F::default(), None) };
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_ascii_lowercase();
    if let Some((_, format)) = endings.iter().find(|(of, _)| *of == ending) {
        return (*format, None);
    }
    let misnamed = others.iter().find(|(of, _)| of.contains(&ending.as_str()));
    (F::default(), misnamed.map(|(_, help)| format!("-o {}: {help}", files::shown(path))))
}
