//! Specs from the files of other tools.

use crate::compile::{Shown, shown};
use crate::job::detached;
use crate::{Arguments, Value, object};
use mavc::Compiler;
use mavc::import::{self, Imported, unknown};
use pyo3::prelude::*;

/// `import_vehicle(name, bytes)`: `(text or None, left_out, unknown, shown)`
pub fn vehicle(arguments: Arguments) -> Value {
    let (name, bytes): (String, Vec<u8>) = arguments.extract()?;
    answer(arguments, move || import::vehicle::import(&name, &bytes))
}

/// `import_mission(name, bytes, (vehicle, path) or None)`: as of a vehicle. `vehicle` is the path of a spec as the new
/// one names it, `path` where it is now.
pub fn mission(arguments: Arguments) -> Value {
    let (name, bytes, vehicle): (String, Vec<u8>, Option<(String, String)>) = arguments.extract()?;
    answer(arguments, move || {
        let taken = vehicle.as_ref().map_or(Vec::new(), |(_, path)| import::mission::names_in(path, &Compiler::new()));
        let used = vehicle.as_ref().map(|(used, _)| used.as_str());
        import::mission::import_beside(&name, &bytes, used, &taken)
    })
}

fn answer(arguments: Arguments, read: impl FnOnce() -> Imported + Send) -> Value {
    let found: (Option<String>, Vec<String>, Vec<String>, Shown) = detached(arguments.py(), move || {
        let Imported { text, dropped, diagnostics, sources } = read();
        let open = text.as_deref().map_or(Vec::new(), unknown::paths);
        (text, dropped, open, shown(&diagnostics, &sources))
    })?;
    object(arguments.py(), found)
}
