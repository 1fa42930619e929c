//! Handling of signals that end the process: temporary files are removed, and a campaign prints how to continue. Then
//! the signal takes its default effect, so that shells and schedulers see why the process ended. On systems other than
//! Unix signals are not handled.

use super::files;
use crate::cancel::Cancel;
use std::io::IsTerminal;
use std::sync::{Mutex, PoisonError};

/// The message about work that ends.
type Farewell = Box<dyn Fn() -> String + Send>;

static FAREWELL: Mutex<Option<Farewell>> = Mutex::new(None);

fn set(farewell: Option<Farewell>) {
    *FAREWELL.lock().unwrap_or_else(PoisonError::into_inner) = farewell;
}

/// While this value lives, a signal that ends the process prints a message first.
pub struct Saying;

impl Saying {
    pub fn new(farewell: impl Fn() -> String + Send + 'static) -> Saying {
        watch();
        set(Some(Box::new(farewell)));
        Saying
    }
}

impl Drop for Saying {
    fn drop(&mut self) {
        set(None);
    }
}

/// What Ctrl-C does first, while the work can end with what it has.
static ENOUGH: Mutex<Option<Cancel>> = Mutex::new(None);

/// While this value lives, the first Ctrl-C ends searches of `cancel` with the best that they have, and says so.
pub struct Enough;

impl Enough {
    pub fn new(cancel: Cancel) -> Enough {
        watch();
        *ENOUGH.lock().unwrap_or_else(PoisonError::into_inner) = Some(cancel);
        Enough
    }
}

impl Drop for Enough {
    fn drop(&mut self) {
        *ENOUGH.lock().unwrap_or_else(PoisonError::into_inner) = None;
    }
}

#[cfg(not(unix))]
pub fn watch() {}

/// Starts to watch for signals, once.
#[cfg(unix)]
pub fn watch() {
    static BEGUN: std::sync::Once = std::sync::Once::new();
    // If the system accepts no handler, signals end the process at once, as without one.
    BEGUN.call_once(|| drop(unix::begin()));
}

/// Prints a message below a line of progress that may be on the screen.
#[cfg(unix)]
fn print(message: &str) {
    let above = if std::io::stderr().is_terminal() { "\n" } else { "" };
    files::eprint(&format!("{above}mavc: {message}\n"));
}

/// Whether Ctrl-C is answered by ending searches with what they have: the first time it is pressed.
#[cfg(unix)]
fn is_enough() -> bool {
    let enough = ENOUGH.lock().unwrap_or_else(PoisonError::into_inner).take();
    if let Some(cancel) = &enough {
        cancel.enough();
        print("the search ends with the best plan that it has; Ctrl-C again ends mavc at once");
    }
    enough.is_some()
}

#[cfg(unix)]
fn say() {
    let farewell = FAREWELL.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(farewell) = farewell.as_ref() {
        print(&farewell());
    }
}

#[cfg(unix)]
mod unix {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::flag::{register, register_conditional_default};
    use signal_hook::iterator::Signals;
    use signal_hook::low_level::emulate_default_handler;
    use std::io::Result;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, Ordering};

    pub fn begin() -> Result<()> {
        // Beyond a limit on file sizes, writing fails as on a full disk instead of ending the process.
        register(libc::SIGXFSZ, Arc::default())?;
        // A signal that is ignored, as under `nohup`, stays ignored.
        let ends = [SIGINT, SIGTERM, SIGHUP].into_iter().filter(|signal| !is_ignored(*signal));
        let ends: Vec<i32> = ends.collect();
        let again = Arc::new(AtomicBool::new(false));
        for &signal in &ends {
            // A signal after the one that ends the process ends it even if the message cannot be printed.
            register_conditional_default(signal, again.clone())?;
        }
        let mut signals = Signals::new(ends)?;
        std::thread::Builder::new().name("signals".into()).spawn(move || {
            let ends = |signal: &i32| *signal != SIGINT || !super::is_enough();
            if let Some(signal) = signals.forever().find(ends) {
                again.store(true, Ordering::SeqCst);
                super::super::temporary::remove_all();
                super::say();
                let _ = emulate_default_handler(signal);
            }
        })?;
        Ok(())
    }

    fn is_ignored(signal: i32) -> bool {
        let mut action = std::mem::MaybeUninit::<libc::sigaction>::zeroed();
        // SAFETY: without a new action `sigaction` only writes the present one, and all zeros are an action too.
        unsafe {
            libc::sigaction(signal, std::ptr::null(), action.as_mut_ptr()) == 0
                && action.assume_init().sa_sigaction == libc::SIG_IGN
        }
    }
}
