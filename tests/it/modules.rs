//! Dependencies between the modules of the library point one way.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// All source files below a folder.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => found.extend(sources(&path)),
            false if path.extension().is_some_and(|e| e == "rs") => found.push(path),
            false => {}
        }
    }
    found
}

/// The modules whose names follow `crate::` in code, comments left out; also those in braces, `use crate::{a, b::c}`.
fn imports(text: &str) -> BTreeSet<String> {
    let code: Vec<&str> = text.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
    let code = code.join("\n");
    let name = |text: &str| -> String { text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect() };
    let mut found = BTreeSet::new();
    for after in code.split("crate::").skip(1) {
        match after.strip_prefix('{') {
            Some(list) => {
                let list = list.split('}').next().unwrap_or_default();
                found.extend(list.split(',').map(|item| name(item.trim())));
            }
            None => {
                found.insert(name(after));
            }
        }
    }
    found
}

/// Which modules each module imports, itself left out.
fn modules() -> BTreeMap<String, BTreeSet<String>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut modules: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for file in sources(&root) {
        let inside = file.strip_prefix(&root).unwrap();
        let module = inside.iter().next().unwrap().to_string_lossy().trim_end_matches(".rs").to_string();
        let found = imports(&fs::read_to_string(&file).unwrap());
        modules.entry(module).or_default().extend(found);
    }
    let names: BTreeSet<String> = modules.keys().cloned().collect();
    for (module, imported) in &mut modules {
        imported.retain(|name| name != module && names.contains(name));
    }
    modules
}

/// A circle of imports, if there is one: the modules that remain when those that import none of the others are taken away,
/// again and again.
fn circle(mut modules: BTreeMap<String, BTreeSet<String>>) -> Vec<String> {
    loop {
        let done: Vec<String> =
            modules.iter().filter(|(_, imported)| imported.is_empty()).map(|(r, _)| r.clone()).collect();
        if done.is_empty() {
            return modules.into_iter().map(|(module, imported)| format!("{module} -> {imported:?}")).collect();
        }
        for module in &done {
            modules.remove(module);
            modules.values_mut().for_each(|imported| {
                imported.remove(module);
            });
        }
    }
}

#[test]
fn no_modules_import_each_other_in_a_circle() {
    let modules = modules();
    assert!(modules.len() > 20 && modules["planner"].contains("solve"), "the imports were not read: {modules:?}");
    assert_eq!(circle(modules), Vec::<String>::new());
}

#[test]
fn a_circle_is_found() {
    let modules = [("a", "b"), ("b", "c"), ("c", "b"), ("d", "a")];
    let modules = modules.map(|(module, imported)| (module.to_string(), BTreeSet::from([imported.to_string()])));
    assert_eq!(circle(modules.into()).len(), 4);
    let line = "use crate::{model::Model, solve};\n/// [`crate::report`]\nlet a = crate::number::number(1.0);";
    assert_eq!(imports(line), ["model", "number", "solve"].map(String::from).into());
}

/// A checker that shares code with what it checks would share its mistakes.
#[test]
fn the_checker_sees_neither_the_planner_nor_reports() {
    let modules = modules();
    let certificate: Vec<&String> = modules["certificate"].iter().collect();
    assert!(certificate.iter().all(|module| *module == "model"), "certificate holds records only: {certificate:?}");
    for forbidden in ["planner", "certify", "report", "solve", "qp", "motion", "admissible", "geometry", "flatness"] {
        assert!(!modules["verify"].contains(forbidden), "verify imports {forbidden}");
    }
}

/// The modules of `src/cli` that are a command each.
const COMMANDS: [&str; 13] = [
    "analyze", "campaign", "check", "compare", "emit", "explain", "fmt", "lsp", "new", "plan", "simulate", "verify",
    "watch",
];

/// A command reads its arguments, calls the pipeline and writes the results. What grows beyond that belongs to the pipeline,
/// to reports, or to a module of `cli` with a name of its own.
#[test]
fn commands_have_at_most_eighty_lines() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/cli");
    for command in COMMANDS {
        let text = fs::read_to_string(folder.join(command).with_extension("rs")).unwrap();
        let lines = text.lines().count();
        assert!(lines <= 80, "src/cli/{command}.rs has {lines} lines");
    }
}

/// The names below a heading of Cargo.toml such as `[dependencies]`.
fn dependencies(manifest: &str, heading: &str) -> Vec<String> {
    let lines = manifest.lines().skip_while(|line| *line != heading).skip(1).take_while(|line| !line.starts_with('['));
    let lines = lines.filter(|line| !line.starts_with('#'));
    lines.filter_map(|line| Some(line.split_once(" = ")?.0.replace('-', "_"))).collect()
}

#[test]
fn every_dependency_is_used() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let manifest = fs::read_to_string(root.join("Cargo.toml")).unwrap();
    let text = |folders: &[&str]| -> String {
        let files = folders.iter().flat_map(|folder| sources(&root.join(folder)));
        files.map(|file| fs::read_to_string(file).unwrap()).collect()
    };
    let (library, all) = (text(&["src"]), text(&["src", "tests", "benches"]));
    for (heading, least, text) in [
        ("[dependencies]", 20, &library),
        ("[target.'cfg(unix)'.dependencies]", 1, &library),
        ("[dev-dependencies]", 3, &all),
    ] {
        let names = dependencies(&manifest, heading);
        assert!(names.len() >= least, "{heading} was not read: {names:?}");
        for name in names {
            let is_used = [format!("{name}::"), format!("use {name};")].iter().any(|path| text.contains(path));
            assert!(is_used, "{heading} {name} is used nowhere");
        }
    }
}

/// Without features the library depends on what docs/library.md lists with reasons, and on nothing else.
#[test]
fn the_bare_library_needs_what_its_page_lists() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |name: &str| fs::read_to_string(root.join(name)).unwrap();
    let manifest = read("Cargo.toml");
    let is_optional = |name: &str| {
        manifest
            .lines()
            .any(|line| line.replace('-', "_").starts_with(&format!("{name} = ")) && line.contains("optional"))
    };
    let headings = ["[dependencies]", "[target.'cfg(unix)'.dependencies]"];
    let needed: BTreeSet<String> = headings
        .iter()
        .flat_map(|heading| dependencies(&manifest, heading))
        .filter(|name| !is_optional(name))
        .collect();
    let page = read("docs/library.md");
    let table = page.split("## Dependencies of the bare library").nth(1).unwrap();
    let cells = table.lines().filter_map(|line| line.strip_prefix("| `")?.split_once(" | ")).map(|(first, _)| first);
    let listed: BTreeSet<String> =
        cells.flat_map(|cell| cell.split(", ")).map(|name| name.trim_matches('`').replace('-', "_")).collect();
    assert!(needed.len() > 10, "{needed:?}");
    assert_eq!(listed, needed);
}
