//! `mavc check --watch`: checks again whenever something that was read changes, appears or goes away.

use super::check::round;
use super::{CheckArgs, CheckFormat, Options, Problem, files, usage};
use crate::input::Kind;
use notify::event::{EventKind, ModifyKind};
use notify::{Event, RecommendedWatcher, RecursiveMode, Watcher};
use std::collections::HashSet;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

/// Editors save in several steps; this long nothing has to happen before the specs are read again.
const SETTLED: Duration = Duration::from_millis(100);

/// Ends with the process, on Ctrl-C.
pub fn run(args: &CheckArgs, options: &Options) -> Result<u8, Problem> {
    if args.specs.iter().any(|name| name == "-") {
        return Err("--watch is for files: standard input is read once".into());
    }
    let (sender, changes) = channel();
    let watcher = notify::recommended_watcher(sender).map_err(|e| format!("cannot watch files: {e}"))?;
    let mut watched = Watched { watcher, folders: HashSet::new(), files: HashSet::new() };
    // Before they are read, so that no change is missed.
    watched.add(&args.specs)?;
    loop {
        if args.format == CheckFormat::Human && std::io::stdout().is_terminal() {
            files::print_as_it_is("\u{1b}[2J\u{1b}[3J\u{1b}[H")?;
        }
        match round(args, options) {
            Ok(round) => watched.add(&round.files)?,
            Err(problem) => drop(usage(&problem)),
        }
        if !options.quiet {
            files::tell("Watching for changes; Ctrl-C ends.\n");
        }
        watched.wait(&changes)?;
    }
}

struct Watched {
    watcher: RecommendedWatcher,
    folders: HashSet<PathBuf>,
    files: HashSet<PathBuf>,
}

impl Watched {
    /// Folders are watched as deep as they go; of a file its folder is, because editors put a new file in the place of the
    /// old one, and because it may not be there yet. What was watched once stays so: it may come back.
    fn add(&mut self, names: &[String]) -> Result<(), Problem> {
        for name in names {
            let path = std::path::absolute(name).map_err(|e| format!("cannot watch {name}: {}", files::reason(&e)))?;
            let is_folder = path.is_dir();
            let parent = if is_folder { Some(&*path) } else { path.parent() };
            // The nearest that is there.
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

    /// Comes back when something has changed that matters, and no more changes follow at once.
    fn wait(&self, changes: &Receiver<notify::Result<Event>>) -> Result<(), Problem> {
        let gone = |_| "cannot watch files any longer".to_string();
        while !self.matters(&changes.recv().map_err(gone)?) {}
        loop {
            match changes.recv_timeout(SETTLED) {
                Ok(_) => {}
                Err(RecvTimeoutError::Timeout) => return Ok(()),
                Err(RecvTimeoutError::Disconnected) => return Err("cannot watch files any longer".into()),
            }
        }
    }

    /// Whether a change may bear on a check: to a spec, a table, or a folder that came, went or holds something watched.
    /// That files were read, by this very process, does not.
    fn matters(&self, change: &notify::Result<Event>) -> bool {
        let Ok(event) = change else { return true };
        let comes = matches!(event.kind, EventKind::Create(_) | EventKind::Modify(ModifyKind::Name(_)));
        let is_spec = |path: &Path| Kind::of(path).is_some();
        let bears = |path: &PathBuf| {
            is_spec(path) || comes && path.is_dir() || self.files.iter().any(|file| file.starts_with(path))
        };
        let is_rescan = event.need_rescan();
        is_rescan || !matches!(event.kind, EventKind::Access(_)) && event.paths.iter().any(bears)
    }
}
