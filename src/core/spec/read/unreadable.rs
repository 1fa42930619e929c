//! Errors for a file that a spec names and that cannot be read, with what to write instead.

use super::near_files::{List, MOST_ENTRIES, near_file};
use crate::diagnostic::Diagnostic;
use crate::input::{FileKind, Refused};
use crate::source::{Spanned, visible};
use crate::syntax::too_large;
use std::io::{Error, ErrorKind};
use std::path::Path;

/// The error for a name with the wrong ending, whose file is not opened: that it is a folder, does not exist, or has
/// the wrong ending. `None` where the ending fits.
pub(super) fn refused_by_name(
    kind: FileKind,
    target: &Path,
    path: &Spanned<String>,
    from: &str,
    list: &List,
) -> Option<Diagnostic> {
    let name = target.file_name().and_then(|name| name.to_str()).filter(|_| FileKind::of(target) != Some(kind))?;
    let siblings = list(target.parent().unwrap_or(Path::new("")));
    let report = |error: &Error| Some(unreadable(kind, target, path, from, error, list));
    if siblings.iter().any(|other| other.strip_suffix('/') == Some(name)) {
        return report(&ErrorKind::IsADirectory.into());
    }
    let is_listed = (1..MOST_ENTRIES).contains(&siblings.len()) && !name.starts_with('.');
    if is_listed && !siblings.iter().any(|other| other == name) {
        return report(&ErrorKind::NotFound.into());
    }
    report(&Refused::Ending(kind).into())
}

/// The error for a file that could not be read.
pub(super) fn unreadable(
    kind: FileKind,
    target: &Path,
    path: &Spanned<String>,
    from: &str,
    error: &Error,
    list: &List,
) -> Diagnostic {
    if path.value.is_empty() {
        return Diagnostic::error("mavc::file::missing", path.span, "the file name is empty")
            .here("empty quotes")
            .help("write the name of a file, as in `vehicles/quad.mav`");
    }
    if error.kind() == ErrorKind::FileTooLarge {
        return too_large(&target.display().to_string(), path.span, kind.most());
    }
    match error.get_ref().and_then(|inner| inner.downcast_ref::<Refused>()) {
        Some(refused) => refusal(kind, target, path, refused),
        None => missing(target, path, from, error, list),
    }
}

/// The error for a file of a kind that the statement does not take.
fn refusal(kind: FileKind, target: &Path, path: &Spanned<String>, refused: &Refused) -> Diagnostic {
    let endings = kind.endings_in_words();
    let rule = match kind {
        FileKind::Spec => format!("`use` reads only regular files whose names end in {endings}"),
        FileKind::Table => format!("a table must be a regular file whose name ends in {endings}"),
    };
    let message = format!("cannot read `{}`: {refused}", shown(target));
    let help = match refused {
        Refused::NotRegular => "copy its contents into a regular file and name that",
        Refused::Ending(FileKind::Spec) => "name a spec, as in `vehicles/quad.mav`",
        Refused::Ending(FileKind::Table) => "name a table, as in `survey.csv`",
        Refused::Elsewhere { .. } => "copy the file instead of linking to it, or rename the target of the link",
    };
    Diagnostic::error("mavc::file::kind", path.span, message).here(rule).help(help)
}

fn missing(target: &Path, path: &Spanned<String>, from: &str, error: &Error, list: &List) -> Diagnostic {
    // A path that ends in `..` is a folder, whatever error the system returned.
    let kind = if target.file_name().is_none() { ErrorKind::IsADirectory } else { error.kind() };
    let message = match kind {
        ErrorKind::NotFound => format!("file `{}` not found", shown(target)),
        ErrorKind::IsADirectory => format!("`{}` is a folder, not a file", path.value),
        ErrorKind::PermissionDenied => format!("cannot read `{}`: permission denied", shown(target)),
        _ => format!("cannot read `{}`: {error}", shown(target)),
    };
    let diagnostic = Diagnostic::error("mavc::file::missing", path.span, message).here("named here");
    match kind {
        ErrorKind::NotFound if path.value.contains("://") => {
            diagnostic.help("download the file and write its path: only files on this machine are read")
        }
        ErrorKind::NotFound if path.value.contains('\\') => diagnostic.help("write the path with `/`"),
        ErrorKind::NotFound => match near_file(from, &path.value, list) {
            Some(near) => diagnostic.help(format!("did you mean `{near}`?")).fix(path.span, format!("\"{near}\"")),
            None if target.extension().is_none() => {
                diagnostic.help(format!("write the full name, as in `{}.mav`", path.value))
            }
            None => diagnostic.help(looked_in(target, from)),
        },
        ErrorKind::IsADirectory => diagnostic.help("name a file in this folder"),
        _ => diagnostic.help("make sure that the file can be read"),
    }
}

/// A path, escaped to be shown within a line.
fn shown(path: &Path) -> String {
    visible::line(&path.display().to_string()).into_owned()
}

/// The help that says where the file was searched for, and how to name one elsewhere.
fn looked_in(target: &Path, from: &str) -> String {
    let folder = match target.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        Some(folder) => format!("the folder `{}`", shown(folder)),
        None => "this folder".to_string(),
    };
    let from = visible::line(from);
    format!("write its path relative to `{from}`, as in `../vehicles/quad.mav`; it was searched for in {folder}")
}
