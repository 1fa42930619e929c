//! Suggests an existing file for a path that does not exist.

use super::load::resolve;
use crate::diagnostic::nearest;
use crate::source::visible;
use std::path::Path;

/// The contents of a folder: names of files, and names of folders followed by `/`. Empty if the path is not a folder.
pub type List<'l> = dyn Fn(&Path) -> Vec<String> + 'l;

/// How many entries of a folder are examined.
pub(super) const MOST_ENTRIES: usize = 1000;

/// The contents of a folder on this machine, sorted, without hidden files.
pub fn entries(folder: &Path) -> Vec<String> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let found = std::fs::read_dir(folder).into_iter().flatten().flatten().take(MOST_ENTRIES);
    let mut names: Vec<String> = found
        .filter_map(|entry| {
            let name = entry
                .file_name()
                .into_string()
                .ok()
                .filter(|name| !name.starts_with('.') && !name.contains(is_unfit))?;
            Some(if entry.path().is_dir() { name + "/" } else { name })
        })
        .collect();
    names.sort_unstable();
    names
}

/// Whether a name with this character cannot be written in quotes or cannot be displayed safely.
pub fn is_unfit(c: char) -> bool {
    c == '"' || visible::is_disguise(c)
}

/// A path to an existing file in the same folder whose name resembles that of `path`, as written in the file `from`.
pub(super) fn near_file(from: &str, path: &str, list: &List) -> Option<String> {
    let (folder, name) = path.rsplit_once('/').map_or(("", path), |(folder, name)| (&path[..folder.len() + 1], name));
    if name.is_empty() {
        return None;
    }
    let inside = |folder: &str| list(&resolve(from, folder));
    let siblings = inside(folder);
    let whole = format!("{name}.mav");
    let extension = Path::new(name).extension();
    let is_alike =
        |other: &&str| Path::new(other).extension() == extension && !is_itself(from, &format!("{folder}{other}"));
    let alike = || nearest(name, siblings.iter().map(String::as_str).filter(is_alike)).map(str::to_string);
    let with_extension = || siblings.iter().find(|other| **other == whole).cloned();
    with_extension().or_else(alike).map(|other| format!("{folder}{other}"))
}

/// Whether a path leads to the file in which it is written.
fn is_itself(from: &str, path: &str) -> bool {
    resolve(from, path) == resolve("", from)
}
