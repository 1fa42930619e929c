//! The rooms of the library import each other in one order, and modules do not import each other in circles.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The rooms of the two crates, each after those that it may import. `cancel` is a room of one module.
const CRATES: [(&str, &[&str]); 2] = [
    ("src/core", &["base", "language", "spec", "proof"]),
    ("src", &["cancel", "physics", "planning", "flights", "documents", "answers", "front"]),
];

/// All source files below a folder, except those of a crate inside it.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true if path.join("Cargo.toml").is_file() => {}
            true => found.extend(sources(&path)),
            false if path.extension().is_some_and(|e| e == "rs") => found.push(path),
            false => {}
        }
    }
    found
}

/// A path in code, absolute in its crate: `["planning", "planner", "rows"]`.
type Names = Vec<String>;

/// The absolute paths in the code of one module. They begin with `crate`, `super` or `self`; a list in braces gives a
/// path for each of its items. Comments are none, and macros are read like other code.
fn paths(code: TokenStream, module: &[String], found: &mut Vec<Names>) {
    let tokens: Vec<TokenTree> = code.into_iter().collect();
    let name = |at: usize| match tokens.get(at) {
        Some(TokenTree::Ident(name)) => Some(name.to_string()),
        _ => None,
    };
    let mut at = 0;
    while at < tokens.len() {
        match &tokens[at] {
            TokenTree::Ident(word) if word == "mod" => {
                let (Some(inner), Some(TokenTree::Group(body))) = (name(at + 1), tokens.get(at + 2)) else {
                    at += 1;
                    continue;
                };
                paths(body.stream(), &[module, &[inner]].concat(), found);
                at += 3;
            }
            TokenTree::Ident(word) if ["crate", "super", "self"].contains(&word.to_string().as_str()) => {
                at = path(&tokens, at, module, found);
            }
            TokenTree::Group(group) => {
                paths(group.stream(), module, found);
                at += 1;
            }
            _ => at += 1,
        }
    }
}

/// Reads the path at `at` and gives the place after it.
fn path(tokens: &[TokenTree], mut at: usize, base: &[String], found: &mut Vec<Names>) -> usize {
    let mut names = base.to_vec();
    let mut is_first = true;
    loop {
        match tokens.get(at) {
            Some(TokenTree::Ident(word)) => match word.to_string().as_str() {
                "crate" if is_first => names.clear(),
                "super" => drop(names.pop()),
                "self" => {}
                word => names.push(word.to_string()),
            },
            Some(TokenTree::Group(list)) if list.delimiter() == Delimiter::Brace => {
                let items: Vec<TokenTree> = list.stream().into_iter().collect();
                for item in items.split(|t| matches!(t, TokenTree::Punct(p) if p.as_char() == ',')) {
                    if !item.is_empty() {
                        path(item, 0, &names, found);
                    }
                }
                return at + 1;
            }
            _ => break,
        }
        is_first = false;
        at += 1;
        let is_colon = |at: usize| matches!(tokens.get(at), Some(TokenTree::Punct(p)) if p.as_char() == ':');
        if !(is_colon(at) && is_colon(at + 1)) {
            break;
        }
        at += 2;
    }
    found.push(names);
    at
}

/// The paths in a text.
fn paths_of(text: &str, module: &[&str]) -> Vec<Names> {
    let module: Names = module.iter().map(ToString::to_string).collect();
    let mut found = Vec::new();
    paths(text.parse().expect("code that the compiler reads"), &module, &mut found);
    found
}

/// The room in which a name at the root of a crate is defined, from its `pub mod` and `pub use`; `None` for those of
/// the other crate.
fn homes(root: &str, rooms: &[&str]) -> BTreeMap<String, String> {
    let mut homes: BTreeMap<String, String> = rooms.iter().map(|room| (room.to_string(), room.to_string())).collect();
    let uses: Vec<Names> = uses(root);
    // `pub use spec::Spec` after `pub use spec::model`: names lead to names.
    for _ in 0..2 {
        for path in &uses {
            if let (Some(last), Some(home)) = (path.last(), homes.get(&path[0]).cloned()) {
                homes.entry(last.clone()).or_insert(home);
            }
        }
    }
    homes
}

/// The paths of the `pub use` of a text.
fn uses(text: &str) -> Vec<Names> {
    let tokens: Vec<TokenTree> = text.parse::<TokenStream>().unwrap().into_iter().collect();
    let mut found = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        if matches!(token, TokenTree::Ident(word) if word == "use") {
            path(&tokens, at + 1, &[], &mut found);
        }
    }
    found
}

/// A module directly below a room: `planning::planner`.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Module {
    room: String,
    name: String,
}

/// Which modules each module of a crate imports, itself left out.
fn modules(folder: &str, rooms: &[&str]) -> BTreeMap<Module, BTreeSet<Module>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let homes = homes(&fs::read_to_string(root.join("lib.rs")).unwrap(), rooms);
    let module_of = |path: &[String]| -> Option<Module> {
        let first = path.first()?;
        let room = homes.get(first)?;
        let name = if room == first { path.get(1).unwrap_or(first) } else { first };
        Some(Module { room: room.clone(), name: name.clone() })
    };
    let mut modules: BTreeMap<Module, BTreeSet<Module>> = BTreeMap::new();
    for file in sources(&root) {
        let inside = file.strip_prefix(&root).unwrap().with_extension("");
        let module: Vec<String> = inside.iter().map(|part| part.to_string_lossy().into_owned()).collect();
        let Some(own) = module_of(&module).filter(|_| module.len() > 1) else { continue };
        let mut found = Vec::new();
        paths(fs::read_to_string(&file).unwrap().parse().unwrap(), &module, &mut found);
        let imported = found.iter().filter_map(|path| module_of(path)).filter(|module| *module != own);
        modules.entry(own.clone()).or_default().extend(imported);
    }
    let names: BTreeSet<Module> = modules.keys().cloned().collect();
    // Names of items that the root re-exports are no modules: they stand for their room.
    modules.values_mut().for_each(|imported| imported.retain(|module| names.contains(module)));
    modules
}

/// A circle of imports, if there is one: the modules that remain when those that import none of the others are taken
/// away, again and again.
fn circle(mut modules: BTreeMap<Module, BTreeSet<Module>>) -> Vec<String> {
    loop {
        let done: Vec<Module> =
            modules.iter().filter(|(_, imported)| imported.is_empty()).map(|(module, _)| module.clone()).collect();
        if done.is_empty() {
            return modules.into_iter().map(|(module, imported)| format!("{module:?} -> {imported:?}")).collect();
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
fn rooms_import_only_those_before_them() {
    for (folder, rooms) in CRATES {
        let modules = modules(folder, rooms);
        assert!(modules.len() >= 2 * rooms.len(), "the imports were not read: {modules:?}");
        let place = |module: &Module| rooms.iter().position(|room| *room == module.room).unwrap();
        let wrong: Vec<String> = modules
            .iter()
            .flat_map(|(module, imported)| imported.iter().map(move |other| (module, other)))
            .filter(|(module, other)| place(module) < place(other))
            .map(|(module, other)| format!("{}::{} -> {}::{}", module.room, module.name, other.room, other.name))
            .collect();
        assert_eq!(wrong, Vec::<String>::new(), "{folder}");
    }
}

#[test]
fn no_modules_import_each_other_in_a_circle() {
    for (folder, rooms) in CRATES {
        assert_eq!(circle(modules(folder, rooms)), Vec::<String>::new(), "{folder}");
    }
}

#[test]
fn a_circle_is_found() {
    let module = |name: &str| Module { room: "room".into(), name: name.into() };
    let modules = [("a", "b"), ("b", "c"), ("c", "b"), ("d", "a")];
    let modules = modules.map(|(from, to)| (module(from), BTreeSet::from([module(to)])));
    assert_eq!(circle(modules.into()).len(), 4);
}

#[test]
fn paths_are_resolved() {
    let text = "
        use crate::{model::{Model, Limit as L}, solve};
        use super::super::flight;
        /// [`crate::report`] is a comment.
        fn f() { let a = vec![super::number::number(1.0)]; self::own(); }
        mod tests { use super::*; use super::super::near; }";
    let found: Vec<String> = paths_of(text, &["planning", "planner", "rows"]).iter().map(|p| p.join("::")).collect();
    let expected = [
        "model::Model",
        "model::Limit",
        "solve",
        "planning::flight",
        "planning::planner::number::number",
        "planning::planner::rows::own",
        "planning::planner::rows",
        "planning::planner::near",
    ];
    assert_eq!(found, expected);
    let homes =
        homes("pub mod spec; pub use spec::{model, Spec as S}; pub use model::Limit; pub use other::Thing;", &["spec"]);
    assert!(homes["model"] == "spec" && homes["Limit"] == "spec" && !homes.contains_key("Thing"), "{homes:?}");
}

/// A checker that shares code with what it checks would share its mistakes. The planner is in another crate; this is
/// about the code of the spec, which the planner uses too.
#[test]
fn the_checker_evaluates_by_itself() {
    let modules = modules(CRATES[0].0, CRATES[0].1);
    let imported = |name: &str| -> BTreeSet<&str> {
        let of = |(module, _): &(&Module, &BTreeSet<Module>)| module.room == "proof" && module.name == name;
        modules.iter().find(of).unwrap().1.iter().map(|module| module.name.as_str()).collect()
    };
    assert_eq!(imported("certificate"), BTreeSet::from(["model"]), "records only");
    let known = [
        "certificate",
        "diagnostic",
        "input",
        "model",
        "number",
        "source",
        "spec",
        "text_table",
        "tolerance",
        "verdict",
    ];
    assert_eq!(imported("verify").difference(&BTreeSet::from(known)).collect::<Vec<_>>(), Vec::<&&str>::new());
    let manifest = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/core/Cargo.toml")).unwrap();
    let names = dependencies(&manifest, "[dependencies]");
    assert!(names.len() > 5, "{names:?}");
    for forbidden in ["mavc", "mavc_solver", "clarabel", "rayon", "num_dual", "rand_distr"] {
        assert!(!names.iter().any(|name| name == forbidden), "{forbidden}");
    }
}

/// Of `src`, which is what people read; specs in tests are texts of their own width.
#[test]
fn no_line_is_wider_than_120_columns() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for file in [sources(&root), sources(&root.join("core")), sources(&root.join("solver"))].concat() {
        let text = fs::read_to_string(&file).unwrap();
        let wide = text.lines().position(|line| line.chars().count() > 120);
        assert_eq!(wide.map(|line| line + 1), None, "{}", file.display());
    }
}

/// The lines of code of a folder: without comments, empty lines, and the modules of tests.
fn lines_of_code(folder: &Path) -> usize {
    let mut lines = 0;
    for file in sources(folder) {
        let text = fs::read_to_string(&file).unwrap();
        let is_of_tests =
            file.file_stem().is_some_and(|stem| ["tests", "made_up_field", "schemas"].iter().any(|of| stem == *of));
        let code = if is_of_tests { "" } else { text.split("#[cfg(test)]\nmod tests {").next().unwrap() };
        lines += code.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("//")).count();
    }
    lines
}

/// docs/certificates.md says how much has to be trusted, to a twentieth.
#[test]
fn the_lines_that_have_to_be_trusted_are_counted() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(root.join("docs/certificates.md")).unwrap();
    let table = page.split("What has to be trusted").nth(1).unwrap();
    for (part, folders) in [("deciding", &["proof"][..]), ("reading the spec", &["base", "language", "spec"])] {
        let counted: usize = folders.iter().map(|folder| lines_of_code(&root.join("src/core").join(folder))).sum();
        let row = table.lines().find(|line| line.starts_with(&format!("| {part} |"))).unwrap();
        let written = row.rsplit(" | ").next().unwrap().trim_end_matches(" |").replace(',', "");
        let written: usize = written.parse().unwrap();
        assert!(written.abs_diff(counted) <= counted / 20, "{part}: {counted} lines, the page says {written}");
    }
}

/// The names below a heading of Cargo.toml such as `[dependencies]`.
fn dependencies(manifest: &str, heading: &str) -> Vec<String> {
    let lines = manifest.lines().skip_while(|line| *line != heading).skip(1).take_while(|line| !line.starts_with('['));
    let lines = lines.filter(|line| !line.starts_with('#'));
    lines.filter_map(|line| Some(line.split_once(" = ")?.0.trim_end_matches(".workspace").replace('-', "_"))).collect()
}

#[test]
fn every_dependency_is_used() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = |folders: &[&str]| -> String {
        let files = folders.iter().flat_map(|folder| sources(&root.join(folder)));
        files.map(|file| fs::read_to_string(file).unwrap()).collect()
    };
    let (unix, development) = ("[target.'cfg(unix)'.dependencies]", "[dev-dependencies]");
    for (manifest, heading, least, folders) in [
        ("Cargo.toml", "[dependencies]", 20, &["src"][..]),
        ("Cargo.toml", unix, 1, &["src"]),
        ("Cargo.toml", development, 3, &["src", "tests", "benches"]),
        ("src/core/Cargo.toml", "[dependencies]", 5, &["src/core"]),
        ("src/core/Cargo.toml", unix, 1, &["src/core"]),
        ("src/core/Cargo.toml", development, 2, &["src/core"]),
        ("src/solver/Cargo.toml", "[dependencies]", 1, &["src/solver"]),
    ] {
        let names = dependencies(&fs::read_to_string(root.join(manifest)).unwrap(), heading);
        assert!(names.len() >= least, "{heading} was not read: {names:?}");
        let text = text(folders);
        for name in names {
            let is_used = [format!("{name}::"), format!("use {name};")].iter().any(|path| text.contains(path));
            assert!(is_used, "{manifest} {heading} {name} is used nowhere");
        }
    }
}

/// Without features the library depends on what docs/library.md lists with reasons, and on nothing else.
#[test]
fn the_bare_library_needs_what_its_page_lists() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |name: &str| fs::read_to_string(root.join(name)).unwrap();
    let needed = |manifest: &str| -> BTreeSet<String> {
        let manifest = read(manifest).replace("-", "_");
        let is_optional = |name: &str| {
            manifest.lines().any(|line| line.starts_with(&format!("{name} = ")) && line.contains("optional"))
        };
        let headings = ["[dependencies]", "[target.'cfg(unix)'.dependencies]"];
        let names = headings.iter().flat_map(|heading| dependencies(&manifest, heading));
        names.filter(|name| !is_optional(name)).collect()
    };
    let mut needed: BTreeSet<String> =
        ["Cargo.toml", "src/core/Cargo.toml", "src/solver/Cargo.toml"].into_iter().flat_map(needed).collect();
    assert!(needed.remove("mavc_verify") && needed.remove("mavc_solver"));
    let page = read("docs/library.md");
    let table = page.split("## Dependencies of the bare library").nth(1).unwrap();
    let cells = table.lines().filter_map(|line| line.strip_prefix("| `")?.split_once(" | ")).map(|(first, _)| first);
    let listed: BTreeSet<String> =
        cells.flat_map(|cell| cell.split(", ")).map(|name| name.trim_matches('`').replace('-', "_")).collect();
    assert!(needed.len() > 10, "{needed:?}");
    assert_eq!(listed, needed);
}
