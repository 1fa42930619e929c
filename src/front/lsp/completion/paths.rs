//! Files that `use`, `waypoints from` and `table` may name, while their path is typed.

use super::{ItemKind, Offer};
use crate::input::FileKind;
use crate::read::is_unfit;
use crate::source::Source;
use std::ops::Range;
use std::path::Path;

/// Entries of a folder that are looked at.
const MOST_ENTRIES: usize = 1000;

/// The files and folders that continue the path at `offset`, and the bytes that they replace: those after its last `/`.
/// `None` where there is no such path.
pub fn offers(source: &Source, offset: usize) -> Option<(Vec<Offer>, Range<usize>)> {
    let line = source.text.get(..offset)?.rsplit('\n').next()?;
    let (before, typed) = line.split_once('"').filter(|(_, typed)| !typed.contains('"'))?;
    // A `;` may end another statement before.
    let before = before.rsplit([';', '{']).next()?.split_whitespace().collect::<Vec<_>>();
    let kind = match before.as_slice() {
        ["use"] => FileKind::Spec,
        ["waypoints", "from"] | ["table", "="] | ["table="] => FileKind::Table,
        _ => return None,
    };
    let (folder, begun) = typed.rsplit_once('/').map_or(("", typed), |(folder, begun)| (folder, begun));
    let file = Path::new(&source.name);
    let folder = match typed.starts_with('/') {
        true => Path::new("/").join(folder),
        // A text that is not stored has no folder.
        false => file.parent().filter(|_| file.is_absolute())?.join(folder),
    };
    let rest = &source.text[offset..];
    let end = offset + rest.find(['"', '/', '\n', '\r', ';']).unwrap_or(rest.len());
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten().take(MOST_ENTRIES);
    let offer = |entry: std::fs::DirEntry| {
        let name =
            entry.file_name().into_string().ok().filter(|name| !name.starts_with('.') && !name.contains(is_unfit))?;
        let path = entry.path();
        if path.is_dir() {
            return Some(Offer::new(&format!("{name}/"), ItemKind::Folder, 1));
        }
        let fits = FileKind::of(&path) == Some(kind) && path != file;
        fits.then(|| Offer::new(&name, ItemKind::File, 0))
    };
    Some((entries.filter_map(offer).collect(), offset - begun.len()..end))
}
