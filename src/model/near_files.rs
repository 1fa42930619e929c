//! Of files that are there, the one that a path to none probably means.

use super::load::resolve;
use crate::diagnostic::nearest;
use crate::source::visible;
use std::path::Path;

/// What a folder holds: names of files, and of folders with a `/` behind; nothing where it is none.
pub type List<'l> = dyn Fn(&Path) -> Vec<String> + 'l;

/// Entries of a folder, and folders of one, that are looked at.
pub(super) const MOST_ENTRIES: usize = 1000;
const MOST_FOLDERS: usize = 50;

/// What a folder on this machine holds, in order, what is hidden aside.
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

/// Whether a name with this character can neither be written between quotes nor be shown.
pub(crate) fn is_unfit(c: char) -> bool {
    c == '"' || visible::is_disguise(c)
}

/// A path like `path`, written in the file `from`, to a file that is there: one of the same folder whose name is alike, or
/// one of the same name below the folder of `from` or beside it.
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
    if let Some(other) = with_extension().or_else(alike) {
        return Some(format!("{folder}{other}"));
    }
    let below: Vec<String> = inside("").into_iter().filter(|entry| entry.ends_with('/')).take(MOST_FOLDERS).collect();
    let elsewhere = ["".to_string(), "../".to_string()].into_iter().chain(below);
    let found = elsewhere.filter(|other| other != folder).filter(|other| inside(other).iter().any(|n| n == name));
    found.map(|other| format!("{other}{name}")).find(|path| !is_itself(from, path))
}

/// Whether a path leads back to the file it is written in.
fn is_itself(from: &str, path: &str) -> bool {
    resolve(from, path) == resolve("", from)
}
