//! The algorithm listings of docs/method/exact-planner.md against the code: functions exist, and settings have the
//! values given.

use mavc::planner::scp::ScpSettings;
use std::fs;
use std::path::{Path, PathBuf};

/// The fenced blocks of the page.
fn listings() -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(root.join("docs/method/exact-planner.md")).unwrap();
    page.split("```").skip(1).step_by(2).collect()
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => sources(&path, found),
            false => found.push(path),
        }
    }
}

#[test]
fn functions_named_in_the_listings_exist() {
    let mut files = Vec::new();
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src/planning/planner"), &mut files);
    let listings = listings();
    let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == ':';
    let named: Vec<(&str, &str)> = listings.split(|c| !is_name(c)).filter_map(|word| word.split_once("::")).collect();
    assert!(named.len() > 40, "{named:?}");
    for (module, function) in named {
        let declared = [format!("fn {function}("), format!("fn {function}<")];
        let is_there = files
            .iter()
            .filter(|file| file.file_stem().is_some_and(|stem| stem == module))
            .any(|file| declared.iter().any(|line| fs::read_to_string(file).unwrap().contains(line)));
        assert!(is_there, "{module}::{function}");
    }
}

#[test]
fn settings_in_the_listings_have_their_defaults() {
    let defaults = format!("{:?}", ScpSettings::DEFAULT);
    let listings = listings();
    let settings: Vec<&str> = listings.split('[').skip(1).filter_map(|s| Some(s.split_once(']')?.0)).collect();
    let mut values = 0;
    for setting in settings {
        let (name, value) = setting.split_once(" = ").map_or((setting, None), |(name, value)| (name, Some(value)));
        let Some((group, field)) = name.split_once('.').filter(|_| !name.contains([' ', '('])) else { continue };
        let from_group = defaults.split_once(&format!(" {group}: ")).unwrap_or_else(|| panic!("{setting}")).1;
        let of_group = from_group.split("Settings {").nth(1).unwrap();
        let (_, found) = of_group.split_once(&format!(" {field}: ")).unwrap_or_else(|| panic!("{setting}"));
        if let Some(value) = value {
            let found = found.split([',', ' ']).next().unwrap();
            assert_eq!(value.parse::<f64>().unwrap(), found.parse::<f64>().unwrap(), "{setting}");
            values += 1;
        }
    }
    assert!(values > 15, "{values}");
}
