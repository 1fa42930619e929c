//! Temporary files: one beside each result that is being written. A run that ends leaves none behind, even if a signal
//! ends it.

use std::io::Result;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::NamedTempFile;

/// All temporary files of this run, those that are gone too. Code that creates or renames one holds the lock.
static CREATED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn created() -> MutexGuard<'static, Vec<PathBuf>> {
    // A panic cannot leave the list half changed.
    CREATED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Creates an empty file in the folder of `result`, removed when it is dropped.
///
/// # Errors
/// No file can be created in the folder.
pub fn beside(result: &Path) -> Result<NamedTempFile> {
    super::signals::watch();
    let mut builder = tempfile::Builder::new();
    builder.prefix(".mavc-").rand_bytes(8);
    // Temporary files are private by default; a result has the permissions of any new file.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut created = created();
    let file = builder.tempfile_in(folder(result))?;
    created.push(file.path().to_path_buf());
    Ok(file)
}

/// Renames a file to the result, replacing a file of that name.
pub fn persist(file: NamedTempFile, result: &Path) -> Result<()> {
    let _created = created();
    file.persist(result).map(drop).map_err(|e| e.error)
}

/// Removes all temporary files of a process that ends now. It keeps the lock, so that no more can be created.
#[cfg(unix)]
pub fn remove_all() {
    let created = created();
    for path in created.iter() {
        let _ = std::fs::remove_file(path);
    }
    std::mem::forget(created);
}

pub fn folder(path: &Path) -> &Path {
    path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."))
}
