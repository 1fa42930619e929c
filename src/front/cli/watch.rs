//! `mavc check --watch`: checks again whenever a file that was read changes, appears or goes away.

use super::check::round;
use super::{CheckArgs, CheckFormat, CommandError, Options, files, usage};
use crate::input::FileKind;
use notify::event::{EventKind, ModifyKind};
use notify::{Event, RecommendedWatcher, RecursiveMode, Watcher};
use std::collections::HashSet;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

/// The screen, its history and the place of the cursor.
const CLEARED: &str = "\u{1b}[2J\u{1b}[3J\u{1b}[H";

/// Runs until the process ends, on Ctrl-C.
pub fn run(args: &CheckArgs, options: &Options) -> Result<u8, CommandError> {
    if args.specs.iter().any(|name| name == "-") {
        return Err("--watch is for files: standard input is read once".into());
    }
    let mut watched = Watched::new()?;
    // Before the first round, so that no change is missed.
    watched.add(&args.specs)?;
    loop {
        if args.format == CheckFormat::Human && std::io::stdout().is_terminal() {
            files::print_as_it_is(CLEARED)?;
        }
        match round(args, options) {
            Ok(round) => watched.add(&round.files)?,
            Err(problem) => drop(usage(&problem)),
        }
        if !options.quiet {
            files::eprint("Watching for changes; press Ctrl-C to stop.\n");
        }
        watched.wait()?;
    }
}

/// Editors save a file in several steps: the specs are read again once nothing has happened for this long.
const SETTLED: Duration = Duration::from_millis(100);

struct Watched {
    watcher: RecommendedWatcher,
    changes: Receiver<notify::Result<Event>>,
    folders: HashSet<PathBuf>,
    files: HashSet<PathBuf>,
}

impl Watched {
    pub fn new() -> Result<Self, CommandError> {
        let (sender, changes) = channel();
        let watcher = notify::recommended_watcher(sender).map_err(|e| format!("cannot watch files: {e}"))?;
        Ok(Watched { watcher, changes, folders: HashSet::new(), files: HashSet::new() })
    }

    /// Watches folders at any depth, and for a file its folder: editors replace the old file by a new one, and the file
    /// may not exist yet. Nothing is ever unwatched, since a file that went away may come back.
    pub fn add(&mut self, names: &[String]) -> Result<(), CommandError> {
        for name in names {
            let path = std::path::absolute(name).map_err(|e| format!("cannot watch {name}: {}", files::reason(&e)))?;
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
    pub fn wait(&self) -> Result<(), CommandError> {
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
