//! Text to model.

use std::io;
use std::path::Path;

use mavc::diagnostic::{Checked, Diagnostic};
use mavc::model::{FileSet, Model, elaborate, load};

fn read(path: &Path) -> io::Result<Vec<u8>> {
    std::fs::read(path)
}

fn load_file(name: &str) -> (FileSet, Vec<Diagnostic>) {
    load(name, &std::fs::read(name).unwrap(), &read)
}

fn check_file(name: &str) -> (FileSet, Checked<Model>) {
    let (set, mut diagnostics) = load_file(name);
    let mut checked = elaborate(&set, &[]);
    diagnostics.append(&mut checked.diagnostics);
    (
        set,
        Checked {
            value: checked.value,
            diagnostics,
        },
    )
}

#[test]
fn shipped_specs_elaborate_without_a_word() {
    for folder in ["vehicles", "paper", "missions"] {
        for entry in std::fs::read_dir(format!("specs/{folder}")).unwrap() {
            let name = entry.unwrap().path().display().to_string();
            if !name.ends_with(".mav") {
                continue;
            }
            let (_, checked) = check_file(&name);
            println!("{name}\n{:#?}", checked.diagnostics);
            println!("{}", checked.value.expect(&name));
        }
    }
}
