//! What the page shows now; threads that serve it wait for changes.

use crate::report::page;
use serde::Serialize;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// How what is shown relates to the spec.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Stage {
    /// A plan is being made: what is shown is older.
    Planning,
    /// The spec, or a file, has an error: what is shown is older.
    Error,
    /// What is shown is of this spec.
    Current,
}

/// The state that browsers are told of.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Status {
    pub stage: Stage,
    /// Counts the pages: a browser that shows another one loads it anew.
    pub page: u64,
    /// What is being tried; empty if nothing is.
    pub progress: String,
    /// Which faults the vehicle survives, in one sentence; empty if unknown.
    pub headline: String,
    /// The table of fault modes as on the terminal; empty if unknown.
    pub verdicts: String,
    /// The diagnostics as on the terminal.
    pub diagnostics: String,
}

struct Shown {
    status: Status,
    page: Arc<str>,
    /// Counts the changes of all of this.
    change: u64,
}

/// What is shown, for threads that change it and threads that wait for a change.
pub struct Board {
    shown: Mutex<Shown>,
    changed: Condvar,
}

impl Board {
    /// Before the spec was read.
    pub fn new(name: &str) -> Self {
        let status = Status {
            stage: Stage::Planning,
            page: 0,
            progress: String::new(),
            headline: String::new(),
            verdicts: String::new(),
            diagnostics: String::new(),
        };
        let page = page::live::waiting(name, 0).into();
        Board { shown: Mutex::new(Shown { status, page, change: 0 }), changed: Condvar::new() }
    }

    fn lock(&self) -> MutexGuard<'_, Shown> {
        self.shown.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn change(&self, how: impl FnOnce(&mut Status)) {
        let mut shown = self.lock();
        how(&mut shown.status);
        shown.change += 1;
        drop(shown);
        self.changed.notify_all();
    }

    /// A new text of the spec is looked at; its diagnostics are these.
    pub fn begin(&self, diagnostics: String) {
        self.change(|status| {
            status.stage = Stage::Planning;
            status.progress = String::new();
            status.diagnostics = diagnostics;
        });
    }

    /// The verdicts on the fault modes of the new text.
    pub fn judge(&self, headline: String, verdicts: String) {
        self.change(|status| (status.headline, status.verdicts) = (headline, verdicts));
    }

    /// What is being tried.
    pub fn progress(&self, what: String) {
        self.change(|status| status.progress = what);
    }

    /// Nothing can be planned, for these reasons: the last page stays.
    pub fn refuse(&self, diagnostics: String) {
        self.change(|status| {
            status.stage = Stage::Error;
            status.progress = String::new();
            status.diagnostics = diagnostics;
        });
    }

    /// The page of the new text.
    pub fn publish(&self, page: &str, diagnostics: String) {
        let mut shown = self.lock();
        let number = shown.status.page + 1;
        shown.page = page::live::live(page, number).into();
        shown.change += 1;
        let progress = String::new();
        shown.status = Status { stage: Stage::Current, page: number, progress, diagnostics, ..shown.status.clone() };
        drop(shown);
        self.changed.notify_all();
    }

    /// The page as it is now.
    pub fn page(&self) -> Arc<str> {
        self.lock().page.clone()
    }

    /// The state and the number of its change, once that is not `seen`; `None` if nothing changes within `patience`.
    pub fn after(&self, seen: Option<u64>, patience: Duration) -> Option<(u64, Status)> {
        let is_old = |shown: &mut Shown| Some(shown.change) == seen;
        let waited = self.changed.wait_timeout_while(self.lock(), patience, is_old);
        let (shown, _) = waited.unwrap_or_else(PoisonError::into_inner);
        (Some(shown.change) != seen).then(|| (shown.change, shown.status.clone()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_waits_sees_each_change_once_and_the_last_page_outlives_an_error() {
        let board = Board::new("a.mav");
        let (change, first) = board.after(None, Duration::ZERO).unwrap();
        assert_eq!((first.stage, first.page), (Stage::Planning, 0));
        assert_eq!(board.after(Some(change), Duration::ZERO), None);
        board.publish("<html><body>found</body></html>", String::new());
        let (change, found) = board.after(Some(change), Duration::ZERO).unwrap();
        assert_eq!((found.stage, found.page), (Stage::Current, 1));
        board.refuse("error: no such unit".into());
        let (_, broken) = board.after(Some(change), Duration::ZERO).unwrap();
        assert_eq!((broken.stage, broken.page), (Stage::Error, 1));
        assert!(board.page().contains("found") && broken.diagnostics.contains("no such unit"));
    }

    #[test]
    fn a_change_wakes_who_waits() {
        let board = Board::new("a.mav");
        let (change, _) = board.after(None, Duration::ZERO).unwrap();
        let told = std::thread::scope(|scope| {
            let waiting = scope.spawn(|| board.after(Some(change), Duration::from_secs(3600)));
            board.progress("RSP: trying 9.00 s".into());
            waiting.join().unwrap()
        });
        assert_eq!(told.unwrap().1.progress, "RSP: trying 9.00 s");
    }
}
