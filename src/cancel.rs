//! Cancelling a run from another thread.
//!
//! A run that is [`Cancel::within`] looks at points of its work, at least once for each iteration of the solver, each
//! step of a controller, each admissible set and each 256 KiB of a log, whether it is cancelled. If it is, it unwinds,
//! without the message of a panic. Nothing of a cancelled run is left: functions of this crate keep no state. A program
//! that is built with `panic = "abort"` must not cancel.

use rayon::ThreadPoolBuilder;
use std::any::Any;
use std::cell::RefCell;
use std::error::Error;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

thread_local! {
    /// What may cancel the work of this thread.
    static CURRENT: RefCell<Option<Cancel>> = const { RefCell::new(None) };
}

/// Cancels runs. Clones cancel the same runs.
#[derive(Debug, Clone, Default)]
pub struct Cancel {
    cancelled: Arc<AtomicBool>,
    enough: Arc<AtomicBool>,
}

/// A run was cancelled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cancelled;

impl fmt::Display for Cancelled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the run was cancelled")
    }
}

impl Error for Cancelled {}

/// Why a run has no result.
pub enum NoResult {
    Cancelled(Cancelled),
    /// The operating system gives no more threads.
    NoThreads(String),
    /// The run panicked, with this payload.
    Panicked(Box<dyn Any + Send>),
}

impl Cancel {
    pub fn new() -> Self {
        Cancel::default()
    }

    /// Cancels every run within this value, and those that begin later. Returns at once; the runs end soon after.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Tells searches for a plan to end with the best that they have; those that have none end without a plan. Returns
    /// at once.
    pub fn enough(&self) {
        self.enough.store(true, Ordering::Relaxed);
    }

    /// Whether searches were told to end with what they have.
    pub fn is_enough(&self) -> bool {
        self.enough.load(Ordering::Relaxed)
    }

    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    /// Runs `work` on `threads` threads of its own, with stacks of `stack` bytes; 0 stands for a thread for each core.
    /// Results do not depend on their number.
    ///
    /// # Errors
    /// The run was cancelled, panicked, or got no threads.
    ///
    /// ```
    /// use mavc::cancel::{Cancel, NoResult};
    ///
    /// let spec = mavc::compile(mavc::TEMPLATE).into_result()?;
    /// let cancel = Cancel::new();
    /// assert!(cancel.within(1, 1 << 23, || mavc::analyze(&spec)).is_ok());
    /// cancel.cancel();
    /// assert!(matches!(cancel.within(1, 1 << 23, || mavc::analyze(&spec)), Err(NoResult::Cancelled(_))));
    /// # Ok::<(), mavc::CompileError>(())
    /// ```
    pub fn within<T: Send>(
        &self,
        threads: usize,
        stack: usize,
        work: impl FnOnce() -> T + Send,
    ) -> Result<T, NoResult> {
        let own = self.clone();
        let begin = move |_| CURRENT.with_borrow_mut(|current| *current = Some(own.clone()));
        let pool = ThreadPoolBuilder::new().num_threads(threads).stack_size(stack).start_handler(begin).build();
        let pool = pool.map_err(|e| NoResult::NoThreads(e.to_string()))?;
        // Nothing that the work changed is used after it has unwound.
        catch_unwind(AssertUnwindSafe(|| pool.install(work))).map_err(|payload| match payload.downcast::<Cancelled>() {
            Ok(cancelled) => NoResult::Cancelled(*cancelled),
            Err(other) => NoResult::Panicked(other),
        })
    }
}

/// What may cancel the work of this thread.
pub(crate) fn current() -> Option<Cancel> {
    CURRENT.with_borrow(Clone::clone)
}

/// Whether searches of this thread are to end with what they have.
pub(crate) fn is_enough() -> bool {
    CURRENT.with_borrow(|current| current.as_ref().is_some_and(Cancel::is_enough))
}

/// Ends the work of this thread if it is cancelled.
pub(crate) fn checkpoint() {
    if CURRENT.with_borrow(|current| current.as_ref().is_some_and(Cancel::is_cancelled)) {
        resume_unwind(Box::new(Cancelled));
    }
}
