//! Temporary files: one beside each result that is being written. A run that ends leaves none behind, even if a signal
//! ends it. The files that a killed run leaves are removed by the next run that writes the same result.
//!
//! A run locks its temporary files as long as it lives, so a file without a lock has no owner. The name of a temporary
//! file tells which result it belongs to.

use sha2::{Digest, Sha256};
use std::fs::{File, TryLockError};
use std::io::{Error, Result};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::NamedTempFile;

const PREFIX: &str = ".mavc-";

/// The random letters of a name.
const LETTERS: usize = 8;

/// Attempts to create a file that no other run removes as stale.
const ATTEMPTS: usize = 16;

/// All temporary files of this run. Code that creates, renames or removes one holds the lock.
static PRESENT: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn present() -> MutexGuard<'static, Vec<PathBuf>> {
    // A panic cannot leave the list half changed.
    PRESENT.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A temporary file, removed when it is dropped unless it has become the result.
pub struct Temporary {
    /// `None` once it has become the result.
    file: Option<NamedTempFile>,
}

impl Temporary {
    /// Creates an empty file in the folder of `result`.
    ///
    /// # Errors
    /// No file can be created in the folder.
    pub fn beside(result: &Path) -> Result<Temporary> {
        super::signals::watch();
        let mut builder = tempfile::Builder::new();
        let prefix = prefix(result);
        builder.prefix(&prefix).rand_bytes(LETTERS);
        // Temporary files are private by default; a result has the permissions of any new file.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        for _ in 0..ATTEMPTS {
            let mut present = present();
            let file = builder.tempfile_in(folder(result))?;
            if is_own(file.as_file()) {
                present.push(file.path().to_path_buf());
                return Ok(Temporary { file: Some(file) });
            }
        }
        Err(Error::other("another run is cleaning its folder"))
    }

    fn inner(&self) -> &NamedTempFile {
        self.file.as_ref().expect("only `persist` and the end take it")
    }

    pub fn path(&self) -> &Path {
        self.inner().path()
    }

    pub fn file(&self) -> &File {
        self.inner().as_file()
    }

    /// Renames it to the result, replacing a file of that name.
    pub fn persist(mut self, result: &Path) -> Result<()> {
        let Some(file) = self.file.take() else { return Ok(()) };
        let mut present = present();
        let path = file.path().to_path_buf();
        let renamed = file.persist(result).map(drop).map_err(|e| e.error);
        present.retain(|other| *other != path);
        renamed
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        if let Some(file) = self.file.take() {
            let mut present = present();
            let path = file.path().to_path_buf();
            // If it cannot be removed, the next run tries again.
            let _ = file.close();
            present.retain(|other| *other != path);
        }
    }
}

/// Removes all temporary files of a process that ends now. It keeps the lock, so that no more can be created.
#[cfg(unix)]
pub fn remove_all() {
    let present = present();
    for path in present.iter() {
        let _ = std::fs::remove_file(path);
    }
    std::mem::forget(present);
}

/// Removes the temporary files of this result that killed runs have left.
pub fn remove_stale(result: &Path) {
    let prefix = prefix(result);
    let is_of_result = |name: &str| {
        let letters = name.strip_prefix(&prefix).filter(|letters| letters.len() == LETTERS);
        letters.is_some_and(|letters| letters.bytes().all(|b| b.is_ascii_alphanumeric()))
    };
    let entries = std::fs::read_dir(folder(result)).into_iter().flatten().flatten();
    for entry in entries.filter(|entry| entry.file_name().to_str().is_some_and(is_of_result)) {
        if let Some(_locked) = crate::input::open_unfollowed(&entry.path()).ok().filter(|file| file.try_lock().is_ok())
        {
            // No other run can lock it meanwhile.
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

/// `.mavc-`, a hash of the result's name, and a dash.
fn prefix(result: &Path) -> String {
    let name = result.file_name().unwrap_or_default();
    let hash = Sha256::digest(name.as_encoded_bytes());
    let digits: String = hash.iter().take(6).map(|byte| format!("{byte:02x}")).collect();
    format!("{PREFIX}{digits}-")
}

/// Locks a new file; false if another run has removed it as stale meanwhile.
fn is_own(file: &File) -> bool {
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => false,
        // A file system may have no locks; stale files are not removed there either.
        Err(TryLockError::Error(_)) => true,
        Ok(()) => is_named(file),
    }
}

#[cfg(unix)]
fn is_named(file: &File) -> bool {
    std::os::unix::fs::MetadataExt::nlink(&match file.metadata() {
        Ok(there) => there,
        Err(_) => return true,
    }) > 0
}

#[cfg(not(unix))]
fn is_named(_: &File) -> bool {
    // On these systems an open file cannot be removed.
    true
}

pub fn folder(path: &Path) -> &Path {
    path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<String> =
            std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn only_unlocked_files_of_the_result_are_stale() {
        let desk = tempfile::tempdir().unwrap();
        let (result, other) = (desk.path().join("a.csv"), desk.path().join("b.csv"));
        let alive = Temporary::beside(&result).unwrap();
        let alive_name = alive.path().file_name().unwrap().to_str().unwrap().to_string();
        let stale = format!("{}aB3dE6gH", prefix(&result));
        let of_other = format!("{}aB3dE6gH", prefix(&other));
        let longer = format!("{stale}i");
        for name in [&stale, &of_other, &longer, &".mavc-notes".to_string()] {
            std::fs::write(desk.path().join(name), "rows").unwrap();
        }
        remove_stale(&result);
        let mut left = vec![alive_name.clone(), of_other.clone(), longer.clone(), ".mavc-notes".into()];
        left.sort();
        assert_eq!(names(desk.path()), left);
        alive.persist(&result).unwrap();
        assert!(names(desk.path()).contains(&"a.csv".to_string()) && !names(desk.path()).contains(&alive_name));
    }

    #[cfg(unix)]
    #[test]
    fn links_and_pipes_of_a_stale_name_are_left_alone() {
        let desk = tempfile::tempdir().unwrap();
        let result = desk.path().join("a.csv");
        std::fs::write(desk.path().join("precious"), "kept").unwrap();
        std::os::unix::fs::symlink("precious", desk.path().join(format!("{}aB3dE6gH", prefix(&result)))).unwrap();
        let pipe = desk.path().join(format!("{}aB3dE6gI", prefix(&result)));
        assert!(std::process::Command::new("mkfifo").arg(pipe).status().unwrap().success());
        remove_stale(&result);
        assert_eq!(names(desk.path()).len(), 3);
    }

    #[test]
    fn a_file_that_is_dropped_is_gone() {
        let desk = tempfile::tempdir().unwrap();
        drop(Temporary::beside(&desk.path().join("a.csv")).unwrap());
        assert!(names(desk.path()).is_empty());
    }
}
