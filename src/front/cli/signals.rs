//! Handling of signals that end the process: temporary files are removed, and a campaign prints how to continue. Then
//! the signal takes its default effect, so that shells and schedulers see why the process ended. On systems other than
//! Unix signals are not handled.

use super::files;
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

#[cfg(not(unix))]
pub fn watch() {}

/// Starts to watch for signals, once.
#[cfg(unix)]
pub fn watch() {
    static BEGUN: std::sync::Once = std::sync::Once::new();
    // If the system accepts no handler, signals end the process at once, as without one.
    BEGUN.call_once(|| drop(unix::begin()));
}

#[cfg(unix)]
fn say() {
    let farewell = FAREWELL.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(farewell) = farewell.as_ref() {
        // A line of progress may be on the screen.
        let above = if std::io::stderr().is_terminal() { "\n" } else { "" };
        files::eprint(&format!("{above}mavc: {}\n", farewell()));
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
    use std::sync::atomic::AtomicBool;

    pub fn begin() -> Result<()> {
        // Beyond a limit on file sizes, writing fails as on a full disk instead of ending the process.
        register(libc::SIGXFSZ, Arc::default())?;
        // A signal that is ignored, as under `nohup`, stays ignored.
        let ends = [SIGINT, SIGTERM, SIGHUP].into_iter().filter(|signal| !is_ignored(*signal));
        let ends: Vec<i32> = ends.collect();
        let again = Arc::new(AtomicBool::new(false));
        for &signal in &ends {
            // A second signal ends the process even if the message cannot be printed.
            register_conditional_default(signal, again.clone())?;
            register(signal, again.clone())?;
        }
        let mut signals = Signals::new(ends)?;
        std::thread::Builder::new().name("signals".into()).spawn(move || {
            if let Some(signal) = signals.forever().next() {
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
