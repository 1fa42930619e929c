//! Plans of shipped specs that several tests look at: each is made once.

use super::{folder, mavc, text};
use serde_json::Value;
use std::collections::BTreeMap;
use std::process::Output;
use std::sync::{Arc, LazyLock, Mutex, OnceLock};

/// What `mavc plan SPEC` prints, and its report.
pub struct Planned {
    pub output: Output,
    pub report: Value,
}

type Made = BTreeMap<String, Arc<OnceLock<Planned>>>;
static MADE: LazyLock<Mutex<Made>> = LazyLock::new(Mutex::default);

/// The plan of a spec; `look` is given it.
pub fn planned<T>(spec: &str, look: impl FnOnce(&Planned) -> T) -> T {
    let made = MADE.lock().unwrap().entry(spec.to_string()).or_default().clone();
    look(made.get_or_init(|| {
        let folder = folder();
        let report = folder.path().join("report.json");
        let output = mavc(&["plan", spec, "--report", text(&report)]);
        let report = serde_json::from_slice(&std::fs::read(&report).unwrap()).unwrap();
        Planned { output, report }
    }))
}
