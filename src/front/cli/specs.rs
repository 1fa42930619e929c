//! Finding the specs that a command line names: files, and folders that are searched.

use super::files::reason;
use super::{CommandError, usage};
use crate::input::FileKind;
use std::io::{Error, ErrorKind};
use std::path::Path;
use walkdir::{DirEntry, WalkDir};

/// The most entries of a folder that are looked at, at any depth: a link may lead to the whole disk.
const MOST_ENTRIES: usize = 200_000;
/// Folders within folders that are searched.
const DEPTH: usize = 64;

/// The specs that names lead to.
#[derive(Default)]
pub struct Found {
    /// Every spec, each once: a file as it is named, a folder's `*.mav` in order of their paths.
    pub specs: Vec<String>,
    /// Names and entries that cannot be read.
    pub problems: Vec<CommandError>,
}

impl Found {
    /// Prints the problems to standard error and returns their exit code.
    pub fn eprint(&self) -> u8 {
        worst(self.problems.iter().map(usage))
    }
}

/// Finds every spec that the names lead to. Hidden files and folders within a folder are skipped, and so are entries
/// that cannot be read. A name without a file is kept: reading it reports the error, and under `--watch` the file may
/// yet appear.
pub fn find(names: &[String]) -> Found {
    let mut found = Found::default();
    for name in names {
        let before = (found.specs.len(), found.problems.len());
        match Path::new(name).is_dir() {
            true => found.search(name),
            false => found.specs.push(name.clone()),
        }
        if (found.specs.len(), found.problems.len()) == before {
            found.problems.push(format!("{name} holds no file whose name ends in .mav"));
        }
    }
    let mut seen = std::collections::HashSet::new();
    found.specs.retain(|name| seen.insert(name.clone()));
    found
}

impl Found {
    fn search(&mut self, folder: &str) {
        let is_hidden = |entry: &DirEntry| entry.depth() > 0 && entry.file_name().as_encoded_bytes().starts_with(b".");
        let entries = WalkDir::new(folder).follow_links(true).max_depth(DEPTH).sort_by_file_name().into_iter();
        for (count, entry) in entries.filter_entry(|entry| !is_hidden(entry)).enumerate() {
            if count >= MOST_ENTRIES {
                self.problems.push(format!("{folder} has more than {MOST_ENTRIES} entries; the rest is not searched"));
                return;
            }
            match entry {
                Ok(entry) => self.take(&entry),
                Err(error) => self.problems.extend(bad_entry(folder, &error)),
            }
        }
    }

    fn take(&mut self, entry: &DirEntry) {
        if !is_spec(entry.path()) || entry.file_type().is_dir() {
            return;
        }
        // The form in which other specs name it: `base.mav`, not `./base.mav`.
        let path = entry.path().strip_prefix(".").unwrap_or(entry.path());
        match (entry.file_type().is_file(), path.to_str()) {
            (true, Some(name)) => self.specs.push(name.into()),
            (true, None) => self.problems.push(format!("cannot read {}: its name is not UTF-8", path.display())),
            (false, _) => self.problems.push(format!("cannot read {}: it is not a regular file", path.display())),
        }
    }
}

fn is_spec(path: &Path) -> bool {
    FileKind::of(path) == Some(FileKind::Spec)
}

/// The message for an entry that cannot be read. Hidden entries have none, nor have dangling links without a spec's
/// name.
fn bad_entry(folder: &str, error: &walkdir::Error) -> Option<CommandError> {
    let path = error.path().unwrap_or(Path::new(folder));
    let name = path.file_name().unwrap_or_default();
    let is_dangling = path.symlink_metadata().is_ok_and(|there| there.is_symlink()) && !path.exists();
    if error.depth() > 0 && (name.as_encoded_bytes().starts_with(b".") || is_dangling && !is_spec(path)) {
        return None;
    }
    let why = match (error.loop_ancestor(), error.io_error()) {
        (Some(ancestor), _) => format!("it leads back to {}", ancestor.display()),
        _ if path.metadata().is_err_and(|error| error.kind() == ErrorKind::NotFound) => {
            "it is a link to a file that does not exist".into()
        }
        // A link that leads to itself, for example.
        _ if is_dangling => "it is a link that cannot be followed".into(),
        (None, Some(error)) => reason(&Error::new(error.kind(), error.to_string())),
        (None, None) => error.to_string(),
    };
    Some(format!("cannot read {}: {why}", path.display()))
}

/// The worst exit code of several specs: files that cannot be read come first, then errors, then modes that cannot
/// hover.
pub fn worst(codes: impl IntoIterator<Item = u8>) -> u8 {
    let badness = |code: &u8| match *code {
        super::USAGE => u8::MAX,
        super::SPEC_ERRORS => u8::MAX - 1,
        other => other,
    };
    codes.into_iter().max_by_key(badness).unwrap_or(super::FINE)
}
