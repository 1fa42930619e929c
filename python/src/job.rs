//! Long work: on threads of its own, without the interpreter's lock, with progress, and until Ctrl-C.
//!
//! The calling thread waits for messages of the work. It calls the callback for progress, so no other thread ever needs
//! the interpreter, and looks for signals, as only Python's main thread may.

use crate::held::Held;
use crate::{Arguments, Value};
use mavc::cancel::{Cancel, NoResult};
use mavc::observer::{Observer, Stages, Trial, trial_text};
use pyo3::import_exception;
use pyo3::prelude::*;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::{Duration, Instant};

import_exception!(mavc.errors, Cancelled);
import_exception!(mavc.errors, InternalError);

/// How often the calling thread looks for signals.
const PERIOD: Duration = Duration::from_millis(50);

/// How long a cancelled run is waited for. It ends within one iteration of the solver; if it takes longer, it is left
/// alone and ends later.
const PATIENCE: Duration = Duration::from_millis(500);

/// The stack of each thread of a run, bytes: that of a main thread on Linux.
const STACK: usize = 8 << 20;

/// What a run is made with: `(threads, callback, cancel)`; 0 threads stand for one for each core.
pub struct Job {
    threads: usize,
    callback: Option<Py<PyAny>>,
    cancel: Arc<Cancel>,
}

/// What a run reports.
enum Message<T> {
    Progress(Progress),
    Done(Result<T, NoResult>),
}

/// One report, as `mavc.Progress` takes it.
struct Progress {
    text: String,
    planner: Option<String>,
    time: Option<f64>,
    done: Option<usize>,
    total: Option<usize>,
}

/// Sends reports to the calling thread. A receiver that is gone is no concern of the work.
pub struct Reports {
    send: Box<dyn Fn(Progress) + Send + Sync>,
}

impl Reports {
    pub fn flights(&self, done: usize, total: usize) {
        let text = format!("{done} of {total} flights");
        (self.send)(Progress { text, planner: None, time: None, done: Some(done), total: Some(total) });
    }
}

impl Stages for Reports {}

impl Observer for Reports {
    fn begins(&self, what: &str) {
        (self.send)(Progress { text: what.into(), planner: None, time: None, done: None, total: None });
    }

    fn tries(&self, planner: &str, trial: Trial) {
        let (text, time) = (trial_text(None, planner, trial), trial.time);
        (self.send)(Progress { text, planner: Some(planner.into()), time: Some(time), done: None, total: None });
    }
}

impl Job {
    /// The job of the three arguments from `first` on.
    pub fn of(arguments: Arguments, first: usize) -> PyResult<Job> {
        let threads = arguments.get_item(first)?.extract()?;
        let callback = Some(arguments.get_item(first + 1)?).filter(|callback| !callback.is_none());
        let cancel = Cancel::of(&arguments.get_item(first + 2)?)?;
        Ok(Job { threads, callback: callback.map(Bound::unbind), cancel })
    }

    /// Runs work to its end.
    ///
    /// # Errors
    /// A signal, an exception of the callback, a cancelled run, or a panic.
    pub fn run<T: Send + 'static>(self, py: Python, work: impl FnOnce(&Reports) -> T + Send + 'static) -> PyResult<T> {
        let (sender, receiver) = channel();
        let cancel = self.cancel.clone();
        let threads = self.threads;
        let is_heard = self.callback.is_some();
        let spawned = thread::Builder::new().name("mavc".into()).spawn(move || {
            let reports = Reports { send: reporter(sender.clone(), is_heard) };
            let result = cancel.within(threads, STACK, || work(&reports));
            let _ = sender.send(Message::Done(result));
        });
        spawned.map_err(|e| InternalError::new_err(e.to_string()))?;
        let result = self.follow(py, receiver)?;
        result.map_err(|why| match why {
            NoResult::Cancelled(cancelled) => Cancelled::new_err(cancelled.to_string()),
            NoResult::NoThreads(why) => InternalError::new_err(why),
            NoResult::Panicked(payload) => internal(&*payload),
        })
    }

    /// Waits for the end, with the interpreter's lock only while Python is called.
    fn follow<T: Send>(&self, py: Python, mut receiver: Receiver<Message<T>>) -> PyResult<Result<T, NoResult>> {
        loop {
            let message;
            (receiver, message) = py.detach(move || {
                let message = receiver.recv_timeout(PERIOD);
                (receiver, message)
            });
            let heard = match message {
                Ok(Message::Done(result)) => return Ok(result),
                Ok(Message::Progress(progress)) => self.call(py, progress),
                Err(RecvTimeoutError::Timeout) => Ok(()),
                Err(RecvTimeoutError::Disconnected) => Err(InternalError::new_err("the run ended without a result")),
            };
            if let Err(error) = heard.and_then(|()| py.check_signals()) {
                self.cancel.cancel();
                py.detach(move || wait(&receiver));
                return Err(error);
            }
        }
    }

    fn call(&self, py: Python, progress: Progress) -> PyResult<()> {
        let Some(callback) = &self.callback else { return Ok(()) };
        let Progress { text, planner, time, done, total } = progress;
        callback.call1(py, (text, planner, time, done, total)).map(drop)
    }
}

fn reporter<T: Send + 'static>(sender: Sender<Message<T>>, is_heard: bool) -> Box<dyn Fn(Progress) + Send + Sync> {
    match is_heard {
        true => Box::new(move |progress| drop(sender.send(Message::Progress(progress)))),
        false => Box::new(drop),
    }
}

/// Waits until a cancelled run has ended, for a while.
fn wait<T>(receiver: &Receiver<Message<T>>) {
    let end = Instant::now() + PATIENCE;
    while let Some(left) = end.checked_duration_since(Instant::now()) {
        match receiver.recv_timeout(left) {
            Ok(Message::Progress(_)) => {}
            Ok(Message::Done(_)) | Err(_) => return,
        }
    }
}

/// Short work without the interpreter's lock.
pub fn detached<T: Send>(py: Python, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    // Nothing that the work changed is used after a panic.
    py.detach(|| catch_unwind(AssertUnwindSafe(work))).map_err(|payload| internal(&*payload))
}

/// A panic as an exception.
pub fn internal(payload: &(dyn Any + Send)) -> PyErr {
    let text = payload.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("a panic");
    InternalError::new_err(format!("mavc has a bug: {text}"))
}

/// `new_cancel()`
pub fn new_cancel() -> Value {
    Python::attach(|py| Cancel::new().into_handle(py))
}

/// `cancel(handle)`
pub fn cancel(arguments: Arguments) -> Value {
    Cancel::of(&arguments.get_item(0)?)?.cancel();
    Ok(arguments.py().None())
}
