//! Temporary files: one beside each result that is being written. None is left behind by a run that ends, also by a
//! signal; what a killed run leaves is found and removed by the next run that writes the same result.
//!
//! A temporary file is locked as long as its run lives, so that one without a lock is nobody's. Its name says which
//! result it is for.

use sha2::{Digest, Sha256};
use std::fs::{File, TryLockError};
use std::io::{Error, Result};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::NamedTempFile;

const PREFIX: &str = ".mavc-";

/// Letters of a name that chance chooses.
const LETTERS: usize = 8;

/// Attempts at a file that no other run takes for a dead one's.
const ATTEMPTS: usize = 16;

/// The temporary files that there are. Whoever makes, renames or removes one holds the lock meanwhile.
static PRESENT: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn present() -> MutexGuard<'static, Vec<PathBuf>> {
    // Paths are whole at any time.
    PRESENT.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A temporary file that goes when it is dropped, unless it has taken its place.
pub struct Temporary {
    /// `None` once it has taken its place.
    file: Option<NamedTempFile>,
}

impl Temporary {
    /// An empty one in the folder of `result`, which follows no link.
    ///
    /// # Errors
    /// Where the folder takes no files.
    pub fn beside(result: &Path) -> Result<Temporary> {
        super::signals::watch();
        let mut builder = tempfile::Builder::new();
        let prefix = prefix(result);
        builder.prefix(&prefix).rand_bytes(LETTERS);
        // Temporary files are private; results are as any new file is.
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
        Err(Error::other("its folder is being cleaned by another run"))
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

    /// Gives it the name of the result, in the place of what has it.
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
            // Nothing more can be done about one that does not go; the next run tries again.
            let _ = file.close();
            present.retain(|other| *other != path);
        }
    }
}

/// Removes all temporary files, for a process that ends now: none can be made any more.
#[cfg(unix)]
pub fn remove_all() {
    let present = present();
    for path in present.iter() {
        let _ = std::fs::remove_file(path);
    }
    std::mem::forget(present);
}

/// Removes what killed runs have left of this result.
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
            // While it is locked no other run can take it for its own.
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

/// `.mavc-`, what tells the result from others of its folder, and a dash.
fn prefix(result: &Path) -> String {
    let name = result.file_name().unwrap_or_default();
    let hash = Sha256::digest(name.as_encoded_bytes());
    let digits: String = hash.iter().take(6).map(|byte| format!("{byte:02x}")).collect();
    format!("{PREFIX}{digits}-")
}

/// Locks a new file; false where another run has taken it for a dead one's meanwhile.
fn is_own(file: &File) -> bool {
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => false,
        // File systems that know no locks do without: there nothing stale is removed either.
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
    // Files that are open are not removed there.
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
