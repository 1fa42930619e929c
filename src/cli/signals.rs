//! What is done when somebody ends the process: temporary files go, and a campaign says how to go on. Then the signal does
//! what it does to any process, so that shells and schedulers see the truth. On other systems than Unix nothing is
//! done, and the next run removes what is left.

use super::files;
use std::io::IsTerminal;
use std::sync::{Mutex, PoisonError};

/// What to say of the work that ends.
type Farewell = Box<dyn Fn() -> String + Send>;

static FAREWELL: Mutex<Option<Farewell>> = Mutex::new(None);

fn set(farewell: Option<Farewell>) {
    *FAREWELL.lock().unwrap_or_else(PoisonError::into_inner) = farewell;
}

/// As long as this lives, a signal that ends the process has a line printed first.
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

/// Begins to watch for signals, once.
#[cfg(unix)]
pub fn watch() {
    static BEGUN: std::sync::Once = std::sync::Once::new();
    // Where the system takes no handler, signals end the process at once, as they did.
    BEGUN.call_once(|| drop(unix::begin()));
}

#[cfg(unix)]
fn say() {
    let farewell = FAREWELL.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(farewell) = farewell.as_ref() {
        // Progress may stand on the line.
        let above = if std::io::stderr().is_terminal() { "\n" } else { "" };
        files::tell(&format!("{above}mavc: {}\n", farewell()));
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
        // Past a limit on file sizes writing fails, as on a full disk, instead of ending the process.
        register(libc::SIGXFSZ, Arc::default())?;
        // What is ignored, as under `nohup`, stays so.
        let ends = [SIGINT, SIGTERM, SIGHUP].into_iter().filter(|signal| !is_ignored(*signal));
        let ends: Vec<i32> = ends.collect();
        let again = Arc::new(AtomicBool::new(false));
        for &signal in &ends {
            // A second one ends the process even where the farewell finds no way out.
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
