//! The models of the page, from the specs of the repository.

use mavc::model::Model;
use mavc::{Compiler, Spec};
use std::path::{Path, PathBuf};

/// The repository.
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// A spec given as text, its `use` paths relative to the repository. Panics with what is wrong.
fn compiled(name: &str, text: &str) -> Spec {
    let read = |path: &Path| std::fs::read(root().join(path));
    let compiled = Compiler::new().reading(&read).text(name, text.as_bytes());
    compiled.into_result().unwrap_or_else(|error| panic!("{error}"))
}

/// A vehicle of specs/vehicles with every single and double loss as modes (`M1`, `M1_2`).
pub fn vehicle(name: &str) -> Model {
    let faults = "faults {\n    every 1 rotor lost as M\n    every 2 rotors lost as M\n}\n";
    compiled("faults.mav", &format!("use \"specs/vehicles/{name}.mav\"\n{faults}")).model().clone()
}

/// The paper's case 1, 2 or 3.
pub fn case(number: usize) -> Spec {
    paper(&format!("case{number}"))
}

/// A spec of specs/paper.
pub fn paper(name: &str) -> Spec {
    let name = format!("specs/paper/{name}.mav");
    let text = std::fs::read_to_string(root().join(&name)).unwrap_or_else(|e| panic!("{name}: {e}"));
    compiled(&name, &text)
}
