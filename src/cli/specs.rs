//! Several specs at once: files as named, folders searched for specs.

use super::Problem;
use std::path::Path;
use walkdir::WalkDir;

/// Every spec that the names lead to, each once: a file as it is named, a folder's `*.mav` in order of their paths. Hidden
/// folders are passed over. A name that leads nowhere is left for the reader to find, for a file may yet come.
pub fn find(names: &[String]) -> Result<Vec<String>, Problem> {
    let mut found: Vec<String> = Vec::new();
    for name in names {
        let before = found.len();
        match Path::new(name).is_dir() {
            true => in_folder(name, &mut found)?,
            false => found.push(name.clone()),
        }
        if found.len() == before {
            return Err(format!("{name} holds no file whose name ends in .mav"));
        }
    }
    let mut seen = std::collections::HashSet::new();
    found.retain(|name| seen.insert(name.clone()));
    Ok(found)
}

fn in_folder(folder: &str, found: &mut Vec<String>) -> Result<(), Problem> {
    let is_hidden = |name: &std::ffi::OsStr| name.as_encoded_bytes().starts_with(b".");
    let entries = WalkDir::new(folder).follow_links(true).sort_by_file_name();
    for entry in entries.into_iter().filter_entry(|e| e.depth() == 0 || !is_hidden(e.file_name())) {
        let entry = entry.map_err(|e| format!("cannot read {folder}: {e}"))?;
        if entry.file_type().is_file() && entry.path().extension().is_some_and(|e| e == "mav") {
            // As other specs name it: `base.mav`, not `./base.mav`.
            let path = entry.path().strip_prefix(".").unwrap_or(entry.path());
            found.push(path.display().to_string());
        }
    }
    Ok(())
}

/// Of the exit codes of several specs the worst: what could not be read, then errors, then modes that cannot hover.
pub fn worst(codes: impl IntoIterator<Item = u8>) -> u8 {
    let badness = |code: &u8| match *code {
        super::USAGE => u8::MAX,
        super::SPEC_ERRORS => u8::MAX - 1,
        other => other,
    };
    codes.into_iter().max_by_key(badness).unwrap_or(super::FINE)
}
