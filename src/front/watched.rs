//! Files that are watched for changes, with the folders in which they lie.

use crate::input::{FileKind, reason};
use notify::event::{EventKind, ModifyKind};
use notify::{Event, RecommendedWatcher, RecursiveMode, Watcher};
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

/// Editors save a file in several steps: the specs are read again once nothing has happened for this long.
const SETTLED: Duration = Duration::from_millis(100);

/// Files and folders that are watched for changes.
pub struct Watched {
    watcher: RecommendedWatcher,
    changes: Receiver<notify::Result<Event>>,
    folders: HashSet<PathBuf>,
    files: HashSet<PathBuf>,
}

impl Watched {
    /// Watches nothing yet.
    ///
    /// # Errors
    /// The system watches no files.
    pub fn new() -> Result<Self, String> {
        let (sender, changes) = channel();
        let watcher = notify::recommended_watcher(sender).map_err(|e| format!("cannot watch files: {e}"))?;
        Ok(Watched { watcher, changes, folders: HashSet::new(), files: HashSet::new() })
    }

    /// Watches folders at any depth, and for a file its folder: editors replace the old file by a new one, and the file
    /// may not exist yet. Nothing is ever unwatched, since a file that went away may come back.
    ///
    /// # Errors
    /// A folder cannot be watched.
    pub fn add(&mut self, names: &[String]) -> Result<(), String> {
        for name in names {
            let path = std::path::absolute(name).map_err(|e| format!("cannot watch {name}: {}", reason(&e)))?;
            let is_folder = path.is_dir();
            let parent = if is_folder { Some(&*path) } else { path.parent() };
            // The nearest folder that exists.
            let there = parent.and_then(|parent| parent.ancestors().find(|folder| folder.is_dir()));
            let Some(there) = there.map(Path::to_path_buf) else { continue };
            self.files.insert(path);
            let depth = if is_folder { RecursiveMode::Recursive } else { RecursiveMode::NonRecursive };
            let is_covered = there.ancestors().any(|folder| self.folders.contains(folder) && folder != there);
            if (is_folder || !is_covered) && !self.folders.contains(&there) {
                let watch = self.watcher.watch(&there, depth);
                watch.map_err(|e| format!("cannot watch {}: {e}", there.display()))?;
                self.folders.insert(there);
            }
        }
        Ok(())
    }

    /// Returns when a change has happened that matters, and no more changes follow within [`SETTLED`].
    ///
    /// # Errors
    /// Nothing can be watched any longer.
    pub fn wait(&self) -> Result<(), String> {
        let gone = |_| "cannot watch files any longer".to_string();
        while !self.matters(&self.changes.recv().map_err(gone)?) {}
        loop {
            match self.changes.recv_timeout(SETTLED) {
                Ok(_) => {}
                Err(RecvTimeoutError::Timeout) => return Ok(()),
                Err(RecvTimeoutError::Disconnected) => return Err("cannot watch files any longer".into()),
            }
        }
    }

    /// Whether a change may alter the result of a check: one to a spec, a table, or a folder that came, went or holds
    /// something watched. Reading a file, as this process does, is not such a change.
    fn matters(&self, change: &notify::Result<Event>) -> bool {
        let Ok(event) = change else { return true };
        let comes = matches!(event.kind, EventKind::Create(_) | EventKind::Modify(ModifyKind::Name(_)));
        let is_spec = |path: &Path| FileKind::of(path).is_some();
        let bears = |path: &PathBuf| {
            is_spec(path) || comes && path.is_dir() || self.files.iter().any(|file| file.starts_with(path))
        };
        let is_rescan = event.need_rescan();
        is_rescan || !matches!(event.kind, EventKind::Access(_)) && event.paths.iter().any(bears)
    }
}
